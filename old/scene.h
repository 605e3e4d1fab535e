#ifndef SCENE_H
#define SCENE_H
#include "outcome.h"
#include "pack.h"
#include "sizes.h"
struct Entry;
typedef struct {
const struct Entry *entry;
int line;
void *own;
int edges;
} Asked;
typedef struct {
int line;
int shape, axis, count;
int edges;
double sides[3], side;
double radius, height;
} SceneWindow;
enum { SCENE_MARKS_MOST = 32 };
typedef struct {
int sweeps;
double every;
int each;
int samples, apart;
int marks, mark[SCENE_MARKS_MOST];
} SceneStages;
enum { SCENE_PHI_MOST = 64 };
typedef struct {
int line, phis;
double phi[SCENE_PHI_MOST], step, reach;
} SceneTheory;
enum { SCENE_KEYS_MOST = 4, SCENE_COMBINATIONS_MOST = 10000, SCENE_VALUE = 41 };
typedef struct {
char key[64], value[SCENE_VALUE];
} SceneSwept;
typedef struct {
Sizes law;
double *list[2];
double *radius;
bool grows;
int growth;
} SceneSizes;
#define SCENE_GROWTHS "add|mark|together"
enum { GROW_ADD, GROW_MARK, GROW_TOGETHER };
#define SCENE_LAWS "lognormal|power|sieve|list"
#define SCENE_UNREACHED "fail|keep"
typedef struct Scene {
const char *path;
int dimension, realizations;
int64_t seed;
double fraction;
bool full;
double side;
int sides;
double box[3];
double gap;
double unit;
double inside;
double cube;
int64_t number;
int kinds;
Species *species;
SceneSizes *sizes;
double *share;
bool counted;
bool by_volume;
bool alike;
bool own_radii;
bool save;
int keys;
int unreached;
SceneSwept swept[SCENE_KEYS_MOST];
char suffix[192];
struct Scene *first, *next;
char *text;
const char *const *set;
int sets;
Asked make;
Asked *change;
int measures;
Asked *measure;
Asked *curve;
SceneStages stages;
SceneTheory theory;
SceneWindow window;
unsigned facts;
int mass;
double contact;
} Scene;
void scene_free(Scene **scene);
const Asked *scene_asked(const Asked list[], const char *name);
bool scene_by_law(const Scene *scene);
bool scene_shaped(const Scene *scene);
double scene_solid(const Scene *scene);
double scene_padded(const Scene *scene, double more);
Box scene_filled(const Scene *scene);
void scene_pair_name(const Species species[], int k, int m, char name[72]);
int scene_pair(int kinds, int k, int m);
#endif
