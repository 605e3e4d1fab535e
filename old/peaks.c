#include "peaks.h"
#include "pairs.h"
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
typedef struct {
int split, side;
} Half;
static bool is_in(int k, Half half) {
return __builtin_parity((unsigned)(k & half.split)) == half.side;
}
static int packs_in(const Means *means, Half half) {
int packs = 0;
for (int k = 0; k < means->count; k++)
packs += is_in(k, half);
return packs;
}
static PairsExtremum extremum_of(const Means *means, const Peak *peak,
const Result *result, Half half) {
const Row *row = &result[0].curve[peak->curve];
double *g = memory(2 * row->length, sizeof *g), *R = g + row->length;
int packs = packs_in(means, half);
for (size_t b = 0; b < row->length; b++)
R[b] = (row->x[b] - peak->zero) / peak->unit;
for (int k = 0; k < means->count; k++)
for (size_t b = 0; is_in(k, half) && b < row->length; b++)
g[b] += result[k].curve[peak->curve].y[b] / packs;
PairsExtremum e = pairs_extremum(row->length, R, g, peak->within[0],
peak->within[1], peak->gap ? -1 : 1);
free(g);
return e;
}
typedef struct {
double R, g, change;
} Extremum;
static Extremum find(const Means *means, const Peak *peak, Half half) {
PairsExtremum e = extremum_of(means, peak, means->result, half), f = e;
if (means->made)
f = extremum_of(means, peak, means->made, half);
return (Extremum){e.R, e.g, e.g / f.g - 1};
}
static Extremum errors(const Means *means, const Peak *peak) {
Extremum square = {0};
int splits = 1;
while (splits < means->count)
splits *= 2;
for (int h = 1; h < splits; h++) {
Extremum one = find(means, peak, (Half){h, 0});
Extremum other = find(means, peak, (Half){h, 1});
double in = packs_in(means, (Half){h, 0}) / (double)means->count;
double share = in * (1 - in) / (splits - 1);
square.R += share * gsl_pow_2(one.R - other.R);
square.g += share * gsl_pow_2(one.g - other.g);
square.change += share * gsl_pow_2(one.change - other.change);
}
return (Extremum){sqrt(square.R), sqrt(square.g), sqrt(square.change)};
}
void peaks_add(const Means *means, const Peak *peak) {
Extremum whole = find(means, peak, (Half){0, 0}), error = errors(means, peak);
char name[128];
snprintf(name, sizeof name, "%s_R%s", peak->word, peak->pair);
summary_add(means->summary, means->prefix, name, whole.R, error.R);
snprintf(name, sizeof name, "%s_g%s", peak->word, peak->pair);
summary_add(means->summary, means->prefix, name, whole.g, error.g);
if (means->made && gsl_finite(whole.change))
summary_add(means->summary, "change.", name, whole.change, error.change);
}
