#ifndef ENSEMBLE_H
#define ENSEMBLE_H
#include "entry.h"
#include "table.h"
typedef struct {
char name[160];
double value, error;
} SummaryRow;
struct Summary {
int rows;
SummaryRow *row;
};
typedef struct {
const Scene *scene;
unsigned facts;
Layout layout;
int **at;
int *measured;
Result *result;
Result *made;
Result *look;
int count, failed;
int family;
int kin;
Watch **watch;
Summary summary;
} Ensemble;
struct Means {
const Ensemble *ensemble;
const Asked *asked;
const int *at;
const Result *result;
const Result *made;
int count;
const char *prefix;
Summary *summary;
};
const Species *ensemble_first(const Ensemble *ensemble);
void summary_add(Summary *summary, const char *prefix, const char *name,
double value, double error);
const SummaryRow *summary_find(const Summary *summary, const char *name);
void summary_change(Summary *summary, const char *name, double *pairs,
size_t count);
const Row *means_longest(const Means *means, int curve);
double means_value(const Means *means, const Row *row, int curve, size_t b);
void means_point(const Means *means, int curve, size_t b, double *mean,
double *error);
void means_change(const Means *means, int curve, size_t b, double *mean,
double *error);
void means_points(const Means *means, int curve, size_t most, const char *word);
void means_point_change(const Means *means, int curve, size_t from, size_t b,
const char *name);
void means_points_change(const Means *means, int curve, size_t stride,
const char *word);
int means_open(const Means *means, Table *table, const char *file,
const char *what, const char *columns, const char *directory,
Outcome *out);
#endif
