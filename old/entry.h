#ifndef ENTRY_H
#define ENTRY_H
#include "edges.h"
#include "result.h"
#include "rng.h"
#include "setting.h"
#include "watch.h"
#include <float.h>
#include <stdio.h>
typedef enum { WHOLE, WIDE, REAL, SWITCH, WORD, LIST, READ } KeyType;
typedef struct Key {
const char *name;
KeyType type;
size_t at, count;
double least, most;
const char *words;
const char *otherwise, *right;
int (*read)(Reader *r, config_setting_t *at, const struct Key *key,
void *own);
} Key;
#define MEMBER(S, m, T) \
(offsetof(S, m) + 0 * sizeof(*(1 ? &((S *)0)->m : (T *)0)))
#define W(text) text
#define KEY_NAME(m) #m
#define KEY_WHOLE(S, m, from, to, otherwise, right) \
{ \
KEY_NAME(m), WHOLE, MEMBER(S, m, int), 0, from, to, NULL, otherwise, \
right, NULL \
}
#define KEY_REAL(S, m, from, to, otherwise, right) \
{ \
KEY_NAME(m), REAL, MEMBER(S, m, double), 0, from, to, NULL, otherwise, \
right, NULL \
}
#define KEY_SWITCH(S, m, right) \
{ KEY_NAME(m), SWITCH, MEMBER(S, m, bool), 0, 0, 1, NULL, "-", right, NULL }
#define KEY_WORD(S, m, words, otherwise, right) \
{ \
KEY_NAME(m), WORD, MEMBER(S, m, int), 0, 0, 0, words, otherwise, right, \
NULL \
}
#define KEY_LIST(S, m, n, room, limit, otherwise, right) \
{ \
KEY_NAME(m), LIST, offsetof(S, m), MEMBER(S, n, int), room, limit, NULL, \
otherwise, right, NULL \
}
#define KEY_READ(name, otherwise, right, read) \
{ name, READ, 0, 0, 0, 0, NULL, otherwise, right, read }
typedef struct {
Scene *scene;
Reader *reader;
config_setting_t *root;
const Asked *asked;
const char *group;
const Species *species;
int kinds;
} Query;
int query_wrong(const Query *query, const char *key, const char *what,
const char *right);
int query_say(const Query *query, const char *format, ...)
__attribute__((format(printf, 2, 3)));
bool query_says(const Query *query, const char *key);
int query_bins(const Query *query, const char *group, int line, double from,
double reach, double step);
typedef struct Work Work;
typedef struct Means Means;
typedef struct Summary Summary;
typedef struct Entry Entry;
enum {
FACT_HARD = 1,
FACT_PERIODIC = 2,
FACT_FINITE = 4,
FACT_ONE_SIZE = 8,
FACT_SAME = 16,
FACT_COURSE = 32,
FACT_GAP = 64,
FACT_VISITED = 128,
FACT_BALLS = 256
};
struct Entry {
const char *name, *what;
const Key *keys;
size_t size;
int (*check)(Query *query, void *own);
void (*clear)(void *own);
const Told *told;
bool (*tells)(const void *own, int t);
};
typedef struct {
Entry entry;
unsigned promises;
int (*begin)(Query *query, void *own);
int (*settle)(Query *query, void *own);
Box (*box)(const Scene *scene, const void *own);
Pack *(*make)(const Work *work, const Box *box);
bool (*same_base)(const Scene *a, const Scene *b);
void (*forget)(void *base);
} Maker;
typedef struct {
Entry entry;
unsigned wants, keeps;
bool stage;
Pack *(*replace)(const Work *work, Pack *pack);
size_t report;
void *(*open)(const Work *work, Pack *pack, Rng *rng);
int (*run)(const Work *work, void *state, uint64_t steps, void *report);
void (*look)(const Work *work, const void *state);
void (*note)(const Work *work, const void *report);
void (*sampled)(const Work *work, const void *report);
void (*add)(void *report, const void *more);
void (*close)(void *state);
void (*plan)(const void *own, FILE *file);
} Change;
typedef struct {
Entry entry;
unsigned wants;
unsigned edges;
const char *of, *right;
double (*reach)(const void *own);
double (*within)(const void *own);
const char *limit;
double (*pairs)(const void *own, const Pack *pack);
int (*fits)(Query *query, const void *own, const Box *box);
bool sorted;
void (*run)(const Work *work);
void (*conclude)(const Means *means);
void (*changed)(const Means *means);
void (*write)(const Means *means, const char *directory, Outcome *out);
} Measure;
enum { ENTRY_KINDS_MOST = 20, ENTRY_PAIRS_MOST = 210 };
typedef struct {
Entry entry;
void *(*alloc)(double phi);
double (*at)(const void *state, double R);
void (*conclude)(double phi, Summary *summary);
void (*possible)(Summary *summary);
void *(*open)(const Scene *scene, double reach);
double (*mean)(const void *state, int k, int m, double R1, double R2);
const char *column;
void (*summarize)(const Scene *scene, Summary *summary);
void (*clear)(void *state);
} Curve;
struct Work {
const Scene *scene;
const Asked *asked;
const void *own;
int k;
const Pack *pack;
double a;
double core;
const Window *window;
EdgesHow edges;
double fraction;
unsigned facts;
Result *result;
const int *at;
const struct Work *all;
void (*visit)(const struct Work *work, Pack *pack);
void (*pass)(const struct Work *work, State *state);
void *visitor;
Watch *watch;
void *
*base;
const struct Scene *base_of;
};
void tell(const Work *work, int t, int item, double value);
void tell_more(const Work *work, int t, double value);
void tell_error(const Work *work, int t, int item, double error);
Row *tell_curve(const Work *work, int t, int item, size_t length);
void tell_pairs(const Work *work, double pairs);
Rng work_stream(const Work *work, RngPurpose purpose, uint64_t stage);
bool work_alone(const Work *work);
bool *work_centres(const Work *work, double R, size_t *centres);
bool work_sees(const Work *work, double R);
Edges work_edges(const Work *work, int k, int m, double from, double step,
size_t bins);
Pack *work_pack(const Work *work, const Box *box);
void work_flown(const Work *work, const Pack *pack);
unsigned entry_facts(const Pack *pack, double gap);
unsigned entry_walls(const Pack *pack);
double entry_value(const Asked *asked, const char *key);
#endif
