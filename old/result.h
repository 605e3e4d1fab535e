#ifndef RESULT_H
#define RESULT_H
#include "outcome.h"
#include "pack.h"
#include <stddef.h>
typedef enum { MEAN, LEAST, LAST } Reduce;
typedef enum { ONCE, EACH_SPECIES, EACH_PAIR, EACH_ORDERED } Over;
enum {
TOLD_AT_MARKS = 1,
TOLD_FLOWN = 2,
TOLD_FIXED = 4,
TOLD_APART = 8,
TOLD_MEASURED = 32,
TOLD_MADE = 16
};
typedef struct {
const char *name;
const char *columns;
const char *what;
Reduce reduce;
Over over;
unsigned flags;
} Told;
typedef struct {
char name[96];
const Told *told;
bool flown;
} Slot;
typedef struct {
int kinds;
const Species *species;
int numbers, measured;
Slot *number;
int curves;
Slot *curve;
} Layout;
typedef struct {
size_t length;
double *x, *y;
} Row;
typedef struct {
const Layout *layout;
double *number, *error;
Row *curve;
Outcome out;
bool transient;
} Result;
int result_items(Over over, int kinds);
int *layout_add(Layout *layout, const Told told[],
bool (*tells)(const void *own, int t), const void *own);
void layout_measured(Layout *layout, const Told told[], int at[]);
void layout_free(Layout *layout);
int layout_find(const Layout *layout, const char *name);
Row *result_curve(const Result *result, const char *name);
void result_begin(Result *result, const Layout *layout);
void result_copy(const Result *from, Result *to);
void result_clone(const Result *from, Result *to);
void result_free(Result *result);
double *result_row(Row *row, size_t length);
void result_add(Result *sum, Result *sample);
void result_divide(Result *sum, double samples);
double result_sum(double sum, double more);
double result_certain(double value);
#endif
