#include "ensemble.h"
#include "header.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
void summary_add(Summary *summary, const char *prefix, const char *name,
double value, double error) {
size_t rows = (size_t)summary->rows + 1;
summary->row = memory_grow(summary->row, rows, sizeof *summary->row);
SummaryRow *row = &summary->row[summary->rows++];
snprintf(row->name, sizeof row->name, "%s%s", prefix, name);
row->value = value;
row->error = error;
}
const SummaryRow *summary_find(const Summary *summary, const char *name) {
for (int r = 0; r < summary->rows; r++)
if (strcmp(summary->row[r].name, name) == 0)
return &summary->row[r];
return NULL;
}
double means_value(const Means *means, const Row *row, int curve, size_t b) {
if (b < row->length)
return row->y[b];
bool last =
means->ensemble->layout.curve[curve].told->reduce == LAST && row->length;
return last ? row->y[row->length - 1] : 0;
}
const Row *means_longest(const Means *means, int curve) {
const Row *longest = &means->result[0].curve[curve];
for (int k = 1; k < means->count; k++)
if (means->result[k].curve[curve].length > longest->length)
longest = &means->result[k].curve[curve];
return longest;
}
void summary_change(Summary *summary, const char *name, double *pairs,
size_t count) {
double mean[2], error;
for (size_t c = 0; c < 2; c++)
table_mean(pairs, count, 2, c, &mean[c], &error);
double ratio = mean[1] / mean[0];
for (size_t k = 0; k < count; k++)
pairs[2 * k] = (pairs[2 * k + 1] - ratio * pairs[2 * k]) / mean[0];
table_mean(pairs, count, 2, 0, &mean[1], &error);
if (mean[0] > 0 && gsl_finite(ratio))
summary_add(summary, "change.", name, ratio - 1, error);
}
static void mean_of(const Means *means, bool change, int curve, size_t b,
double *mean, double *error) {
double *column = memory((size_t)means->count, sizeof *column);
for (int k = 0; k < means->count; k++) {
column[k] = means_value(means, &means->result[k].curve[curve], curve, b);
if (change)
column[k] -= means_value(means, &means->made[k].curve[curve], curve, b);
}
table_mean(column, (size_t)means->count, 1, 0, mean, error);
free(column);
}
void means_point(const Means *means, int curve, size_t b, double *mean,
double *error) {
mean_of(means, false, curve, b, mean, error);
}
void means_change(const Means *means, int curve, size_t b, double *mean,
double *error) {
mean_of(means, true, curve, b, mean, error);
}
void means_points(const Means *means, int curve, size_t most,
const char *word) {
const Row *row = &means->result[0].curve[curve];
for (size_t b = 0; b < row->length && b < most; b++) {
double value, error;
char name[64];
means_point(means, curve, b, &value, &error);
snprintf(name, sizeof name, "%s_%.5g", word, row->x[b]);
summary_add(means->summary, means->prefix, name, fabs(value), error);
}
}
void means_point_change(const Means *means, int curve, size_t from, size_t b,
const char *name) {
size_t count = (size_t)means->count;
double *pairs = memory(2 * count, sizeof *pairs);
for (size_t k = 0; k < count; k++) {
pairs[2 * k] =
means_value(means, &means->made[k].curve[curve], curve, from);
pairs[2 * k + 1] =
means_value(means, &means->result[k].curve[curve], curve, b);
}
summary_change(means->summary, name, pairs, count);
free(pairs);
}
void means_points_change(const Means *means, int curve, size_t stride,
const char *word) {
const Row *row = &means->made[0].curve[curve];
for (size_t b = 0; row->x && b < row->length; b += stride) {
char name[64];
snprintf(name, sizeof name, "%s_%.7g", word, row->x[b]);
means_point_change(means, curve, b, b, name);
}
}
const Species *ensemble_first(const Ensemble *ensemble) {
return ensemble->layout.kinds > 0 ? ensemble->layout.species : NULL;
}
int means_open(const Means *means, Table *table, const char *file,
const char *what, const char *columns, const char *directory,
Outcome *out) {
const Scene *scene = means->ensemble->scene;
char name[256];
snprintf(name, sizeof name, "%s%s%s.tsv", means->prefix, file, scene->suffix);
if (table_open(table, directory, name, out))
return out->status;
header_write(table, scene, ensemble_first(means->ensemble), means->count,
what);
for (int i = 0; i < scene->keys; i++)
fprintf(table->file, "# %s = %s\n", scene->swept[i].key,
scene->swept[i].value);
fprintf(table->file, "%s\n", columns);
return DONE;
}
