#include "result.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int result_items(Over over, int kinds) {
switch (over) {
case EACH_SPECIES:
return kinds;
case EACH_PAIR:
return kinds * (kinds + 1) / 2;
case EACH_ORDERED:
return kinds * kinds;
default:
return 1;
}
}
static void name_item(const Layout *layout, const Told *told, int item,
char name[96]) {
const Species *s = layout->species;
int k = item, m = 0, kinds = layout->kinds;
if (told->over == EACH_PAIR)
for (k = 0, m = item; m >= kinds - k; k++)
m -= kinds - k;
if (told->over == EACH_PAIR)
m += k;
if (told->over == EACH_ORDERED)
k = item / kinds, m = item % kinds;
if (told->over == ONCE)
snprintf(name, 96, "%s", told->name);
else if (told->over == EACH_SPECIES)
snprintf(name, 96, "%s.%s", told->name, s[k].name);
else
snprintf(name, 96, "%s.%s-%s", told->name, s[k].name, s[m].name);
}
static int find(const Slot slot[], int from, int to, const char *name) {
while (from < to && strcmp(slot[from].name, name) != 0)
from++;
return from < to ? from : -1;
}
int layout_find(const Layout *layout, const char *name) {
return find(layout->number, 0, layout->numbers, name);
}
static int place(Layout *layout, const Told *told, bool flown) {
bool number = !told->columns;
Slot **slot = number ? &layout->number : &layout->curve;
int *count = number ? &layout->numbers : &layout->curves, first = *count;
int items = result_items(told->over, layout->kinds);
for (int i = 0; i < items; i++) {
Slot one = {.told = told, .flown = flown};
name_item(layout, told, i, one.name);
if (flown)
strncat(one.name, "_after", sizeof one.name - strlen(one.name) - 1);
int old = -1;
if (i == 0)
old = find(*slot, number ? layout->measured : 0, *count, one.name);
if (old >= 0)
return old;
*slot = memory_grow(*slot, (size_t)*count + 1, sizeof **slot);
(*slot)[(*count)++] = one;
}
return first;
}
int *layout_add(Layout *layout, const Told told[],
bool (*tells)(const void *own, int t), const void *own) {
int n = 0;
while (told && told[n].name)
n++;
int *at = memory(2 * (size_t)n + 1, sizeof *at);
for (int t = 0; t < n; t++)
at[t] = told[t].flags & TOLD_MEASURED || (tells && !tells(own, t))
? -1
: place(layout, &told[t], false);
for (int t = 0; t < n; t++)
at[n + t] = told[t].flags & TOLD_FLOWN ? place(layout, &told[t], true) : -1;
return at;
}
void layout_measured(Layout *layout, const Told told[], int at[]) {
for (int t = 0; told && told[t].name; t++)
if (told[t].flags & TOLD_MEASURED)
at[t] = place(layout, &told[t], false);
}
void layout_free(Layout *layout) {
free(layout->number);
free(layout->curve);
}
void result_begin(Result *result, const Layout *layout) {
size_t n = (size_t)layout->numbers;
*result = (Result){.layout = layout};
result->number = memory(n, sizeof(double));
result->error = memory(n, sizeof(double));
result->curve = memory((size_t)layout->curves, sizeof(Row));
for (size_t i = 0; i < n; i++)
result->number[i] = result->error[i] = GSL_NAN;
}
double *result_row(Row *row, size_t length) {
free(row->x);
free(row->y);
row->length = length;
row->x = memory(length, sizeof(double));
return row->y = memory(length, sizeof(double));
}
Row *result_curve(const Result *result, const char *name) {
int at = find(result->layout->curve, 0, result->layout->curves, name);
return at < 0 ? NULL : &result->curve[at];
}
void result_free(Result *result) {
for (int c = 0; result->curve && c < result->layout->curves; c++) {
free(result->curve[c].x);
free(result->curve[c].y);
}
free(result->curve);
free(result->number);
free(result->error);
*result = (Result){0};
}
static void copy_row(const Row *from, Row *to) {
if (!from->x)
return;
memcpy(result_row(to, from->length), from->y, from->length * sizeof(double));
memcpy(to->x, from->x, from->length * sizeof(double));
}
static void copy_numbers(const Result *from, Result *to, int numbers) {
memcpy(to->number, from->number, (size_t)numbers * sizeof(double));
memcpy(to->error, from->error, (size_t)numbers * sizeof(double));
to->out = from->out;
}
void result_copy(const Result *from, Result *to) {
copy_numbers(from, to, from->layout->measured);
for (int c = 0; c < from->layout->curves; c++) {
Row *copy = result_curve(to, from->layout->curve[c].name);
if (copy)
copy_row(&from->curve[c], copy);
}
}
void result_clone(const Result *from, Result *to) {
copy_numbers(from, to, from->layout->numbers);
for (int c = 0; c < from->layout->curves; c++)
copy_row(&from->curve[c], &to->curve[c]);
}
static void add_row(Row *sum, Row *sample) {
if (sample->length > sum->length || !sum->x) {
Row longer = *sample;
*sample = *sum;
*sum = longer;
}
for (size_t b = 0; b < sample->length; b++)
sum->y[b] += sample->y[b];
}
void result_add(Result *sum, Result *sample) {
const Layout *layout = sum->layout;
for (int n = layout->measured; n < layout->numbers; n++)
sum->number[n] = layout->number[n].told->reduce == LEAST
? fmin(sum->number[n], sample->number[n])
: result_sum(sum->number[n], sample->number[n]);
for (int n = layout->measured; n < layout->numbers; n++)
sum->error[n] = result_sum(sum->error[n], sample->error[n]);
for (int c = 0; c < layout->curves; c++)
add_row(&sum->curve[c], &sample->curve[c]);
result_free(sample);
}
void result_divide(Result *sum, double samples) {
const Layout *layout = sum->layout;
for (int n = layout->measured; n < layout->numbers; n++)
if (layout->number[n].told->reduce != LEAST)
sum->number[n] /= samples;
for (int n = layout->measured; n < layout->numbers; n++)
sum->error[n] /= samples;
for (int c = 0; c < layout->curves; c++)
for (size_t b = 0; b < sum->curve[c].length; b++)
sum->curve[c].y[b] /= samples;
}
double result_sum(double sum, double more) {
return (gsl_isnan(sum) ? 0 : sum) + more;
}
double result_certain(double value) {
return floor(1e6 * value + 0.5) / 1e6;
}
