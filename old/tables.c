#include "tables.h"
#include "header.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
static int stages_of(const Ensemble *one) {
for (const Asked *c = one->scene->change; c && c->entry; c++)
if (((const Change *)c->entry)->stage)
return 2;
return 1;
}
static Means means_of(Ensemble *one, int stage) {
bool two = stages_of(one) == 2;
return (Means){.ensemble = one,
.result = two && !stage ? one->made : one->result,
.made = stage ? one->made : NULL,
.count = one->count,
.prefix = !two ? ""
: stage ? "shaken."
: "made.",
.summary = &one->summary};
}
static Means measure_means(const Means *means, int m) {
const Scene *scene = means->ensemble->scene;
Means own = *means;
int changes = 0;
while (scene->change && scene->change[changes].entry)
changes++;
own.asked = &scene->measure[m];
own.at = means->ensemble->at[2 + changes + m];
return own;
}
static void write_curve(const Means *means, int curve, const char *directory,
Outcome *out) {
const Slot *slot = &means->ensemble->layout.curve[curve];
const Row *longest = means_longest(means, curve);
Means before = *means;
Table table;
char columns[128];
before.result = means->made;
if (means->made && means_longest(&before, curve)->length > longest->length)
longest = means_longest(&before, curve);
snprintf(columns, sizeof columns, "%s%s", slot->told->columns,
means->made ? "\tchange\tchange_err" : "");
if (means_open(means, &table, slot->name, slot->told->what, columns,
directory, out))
return;
for (size_t b = 0; b < longest->length; b++) {
double row[5] = {longest->x[b]};
means_point(means, curve, b, &row[1], &row[2]);
if (means->made)
means_change(means, curve, b, &row[3], &row[4]);
table_row(&table, row, means->made ? 5 : 3);
}
table_close(&table, out);
}
static void write_stage(Ensemble *one, int stage, const char *directory,
Outcome *out) {
const Layout *layout = &one->layout;
Means means = means_of(one, stage);
for (int c = 0; c < layout->curves; c++) {
unsigned flags = layout->curve[c].told->flags;
Means own = means;
if (flags & TOLD_APART || !*layout->curve[c].told->columns ||
(flags & TOLD_MADE && stage))
continue;
if (flags & TOLD_MADE)
own.prefix = "";
if (own.result[0].curve[c].x)
write_curve(&own, c, directory, out);
}
for (int m = 0; one->scene->measure && one->scene->measure[m].entry; m++) {
Means own = measure_means(&means, m);
const Measure *measure = (const Measure *)own.asked->entry;
if (measure->write)
measure->write(&own, directory, out);
}
}
static int seen(const Ensemble *one, int n) {
for (n++; n < one->layout.numbers; n++)
if (one->layout.number[n].told->flags & TOLD_AT_MARKS &&
!one->layout.number[n].flown && !gsl_isnan(one->look[0].number[n]))
return n;
return -1;
}
static void mean_at_mark(const Ensemble *one, int n, int mark, double *mean,
double *error) {
int looks = one->scene->stages.marks + 1;
double *column = memory((size_t)one->count, sizeof *column);
for (int k = 0; k < one->count; k++)
column[k] = one->look[k * looks + mark].number[n];
table_mean(column, (size_t)one->count, 1, 0, mean, error);
free(column);
}
static double mark_of(const Ensemble *one, int mark) {
return mark ? one->scene->stages.mark[mark - 1] : 0;
}
static void write_marks(Ensemble *one, const char *directory, Outcome *out) {
Means means = means_of(one, 0);
Table table;
char columns[512] = "M";
means.prefix = "";
for (int n = seen(one, -1); n >= 0; n = seen(one, n)) {
const char *name = one->layout.number[n].name;
size_t length = strlen(columns);
snprintf(columns + length, sizeof columns - length, "\t%s\t%s_err", name,
name);
}
if (means_open(&means, &table, "shaking",
"after M sweeps: what the marks saw, and its standard errors; "
"wandered in a^2",
columns, directory, out))
return;
for (int mark = 0; mark <= one->scene->stages.marks; mark++) {
double line[65] = {mark_of(one, mark)};
int i = 1;
for (int n = seen(one, -1); n >= 0 && i < 64; n = seen(one, n), i += 2)
mean_at_mark(one, n, mark, &line[i], &line[i + 1]);
table_row(&table, line, i);
}
table_close(&table, out);
}
static void write_theory(Ensemble *one, const char *directory, Outcome *out) {
const Scene *scene = one->scene;
const SceneTheory *t = &scene->theory;
Means means = {.ensemble = one, .prefix = ""};
void *state[16 * SCENE_PHI_MOST];
const Curve *curve[16 * SCENE_PHI_MOST];
char columns[2048] = "R";
Table table;
int n = 0;
for (const Asked *c = scene->curve; c && c->entry; c++)
for (int p = 0; ((const Curve *)c->entry)->alloc && p < t->phis; p++) {
size_t length = strlen(columns);
curve[n] = (const Curve *)c->entry;
state[n] = curve[n]->alloc(t->phi[p]);
snprintf(columns + length, sizeof columns - length, "\t%s_%g",
c->entry->name, t->phi[p]);
n++;
}
if (n && means_open(&means, &table, "theory", "analytical g(R), R = r/a",
columns, directory, out) == DONE) {
double *row = memory((size_t)n + 1, sizeof *row);
for (size_t b = 0; 2 + (double)b * t->step <= t->reach * (1 + 1e-12); b++) {
row[0] = 2 + (double)b * t->step;
for (int c = 0; c < n; c++)
row[c + 1] = curve[c]->at(state[c], row[0]);
table_row(&table, row, n + 1);
}
free(row);
table_close(&table, out);
}
for (int c = 0; c < n; c++)
curve[c]->clear(state[c]);
}
static void write_species_sizes(Table *table, const Scene *scene, int s) {
const SceneSizes *sizes = &scene->sizes[s];
size_t n = scene->species[s].count, at = 0;
double unit = scene->species[0].radius, solid = 0, sum = 0;
for (size_t i = 0; i < n; i++)
solid += pack_ball(scene->dimension, sizes->radius[i]);
for (size_t row = 1; row <= 100; row++) {
size_t end = row * n / 100;
if (end == at)
continue;
for (; at < end; at++)
sum += pack_ball(scene->dimension, sizes->radius[at]);
double a = sizes->radius[end - 1];
double line[] = {s + 1,
a / unit,
(double)end / (double)n,
result_certain(sizes_number(&sizes->law, a)),
sum / solid,
result_certain(sizes_passing(&sizes->law, a))};
table_row(table, line, 6);
}
}
static void write_sizes(Ensemble *one, const char *directory, Outcome *out) {
Means means = {.ensemble = one, .prefix = ""};
Table table;
if (means_open(&means, &table, "sizes",
"shares of number and volume in radii up to a, in those of "
"the first species, as they are and by law",
"species\ta\tnumber\tby_law\tvolume\tby_law", directory, out))
return;
for (int s = 0; s < one->scene->kinds; s++)
if (one->scene->sizes[s].radius)
write_species_sizes(&table, one->scene, s);
table_close(&table, out);
}
static void add_numbers(const Means *means, const char *prefix, int from,
int to) {
size_t count = (size_t)means->count;
double *column = memory(count, sizeof *column), value, error;
for (int n = from; n < to; n++) {
const Slot *slot = &means->ensemble->layout.number[n];
bool each = slot->told->over != ONCE;
if (!each && gsl_isnan(means->result[0].number[n]))
continue;
for (size_t k = 0; k < count; k++)
column[k] = means->result[k].number[n];
table_mean(column, count, 1, 0, &value, &error);
if (count == 1 && (each || !gsl_isnan(means->result[0].error[n])))
error = means->result[0].error[n];
if (slot->told->reduce == LEAST)
for (size_t k = error = 0; k < count; k++)
value = k == 0 || column[k] < value ? column[k] : value;
if (!each || gsl_finite(value))
summary_add(means->summary, prefix, slot->name, value, error);
}
free(column);
}
static void add_changes(const Means *means) {
size_t count = (size_t)means->count;
const Layout *layout = &means->ensemble->layout;
double *pairs = memory(2 * count, sizeof *pairs);
for (int n = layout->measured; n < layout->numbers; n++) {
if (layout->number[n].told->flags & TOLD_FIXED ||
gsl_isnan(means->made[0].number[n]) ||
gsl_isnan(means->result[0].number[n]))
continue;
for (size_t k = 0; k < count; k++) {
pairs[2 * k] = means->made[k].number[n];
pairs[2 * k + 1] = means->result[k].number[n];
}
summary_change(means->summary, layout->number[n].name, pairs, count);
}
free(pairs);
}
static void summarize_sizes(const Scene *scene, Summary *summary) {
double unit = scene->species[0].radius;
for (int s = 0; s < scene->kinds; s++) {
const SceneSizes *sizes = &scene->sizes[s];
size_t n = scene->species[s].count;
double number, volume;
if (!sizes->radius || n == 0)
continue;
sizes_compare(&sizes->law, sizes->radius, n, &number, &volume);
const struct {
const char *word;
double value;
} rows[] = {{"size_number", number},
{"size_volume", volume},
{"size_least", sizes->radius[0] / unit},
{"size_most", sizes->radius[n - 1] / unit}};
for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
char name[64];
snprintf(name, sizeof name, "%s.%s", rows[i].word,
scene->species[s].name);
summary_add(summary, "", name, result_certain(rows[i].value), 0);
}
}
}
static void conclude(const Means *means) {
const Ensemble *one = means->ensemble;
add_numbers(means, means->prefix, one->layout.measured, one->layout.numbers);
for (int m = 0; one->scene->measure && one->scene->measure[m].entry; m++) {
Means own = measure_means(means, m);
const Measure *measure = (const Measure *)own.asked->entry;
if (measure->conclude)
measure->conclude(&own);
}
}
static void conclude_marks(Ensemble *one) {
for (int n = seen(one, -1); n >= 0; n = seen(one, n))
for (int mark = 0; mark <= one->scene->stages.marks; mark++) {
double value, error;
char name[128];
mean_at_mark(one, n, mark, &value, &error);
snprintf(name, sizeof name, "%s_%.9g", one->layout.number[n].name,
mark_of(one, mark));
summary_add(&one->summary, "", name, fabs(value), error);
}
}
static void change_at_marks(Ensemble *one) {
int looks = one->scene->stages.marks + 1;
double *pairs = memory(2 * (size_t)one->count, sizeof *pairs);
for (int n = seen(one, -1); n >= 0; n = seen(one, n))
for (int mark = 1; mark < looks; mark++) {
char name[128];
for (int k = 0; k < one->count; k++) {
pairs[2 * k] = one->look[k * looks].number[n];
pairs[2 * k + 1] = one->look[k * looks + mark].number[n];
}
snprintf(name, sizeof name, "%s_%.9g", one->layout.number[n].name,
mark_of(one, mark));
summary_change(&one->summary, name, pairs, (size_t)one->count);
}
free(pairs);
}
static void conclude_change(Ensemble *one) {
Means means = means_of(one, 1);
Summary *summary = &one->summary;
conclude(&means);
add_changes(&means);
for (int m = 0; one->scene->measure && one->scene->measure[m].entry; m++) {
Means own = measure_means(&means, m);
const Measure *measure = (const Measure *)own.asked->entry;
if (measure->changed)
measure->changed(&own);
}
if (one->look)
change_at_marks(one);
summary_add(summary, "", "min_gap",
fmin(summary_find(summary, "made.min_gap")->value,
summary_find(summary, "shaken.min_gap")->value),
0);
}
static void summarize_theory(const Scene *scene, Summary *summary) {
const SceneTheory *t = &scene->theory;
for (const Asked *c = scene->curve; c && c->entry; c++)
for (int p = 0; ((const Curve *)c->entry)->alloc && p < t->phis; p++)
((const Curve *)c->entry)->conclude(t->phi[p], summary);
for (const Asked *c = scene->curve; c && c->entry; c++) {
const Curve *curve = (const Curve *)c->entry;
if (curve->possible)
curve->possible(summary);
if (curve->summarize)
curve->summarize(scene, summary);
}
}
static void summarize(Ensemble *one) {
if (one->count) {
Means means = means_of(one, 0);
summary_add(&one->summary, "", "realizations", one->count, 0);
add_numbers(&means, "", 0, one->layout.measured);
conclude(&means);
}
if (one->look && one->count)
conclude_marks(one);
if (one->made && one->count)
conclude_change(one);
if (one->count && one->scene->kinds && scene_by_law(one->scene))
summarize_sizes(one->scene, &one->summary);
summarize_theory(one->scene, &one->summary);
}
static void write_summary(const Ensemble *all, int combinations,
const char *directory, Outcome *out) {
Table table;
int packs = 0;
for (int e = 0; e < combinations; e++)
packs += all[e].count;
if (out->status != DONE || table_open(&table, directory, "summary.tsv", out))
return;
header_write(&table, all->scene, ensemble_first(all), packs,
"numbers with their standard errors over "
"realizations; min_gap in diameters");
fprintf(table.file, "quantity\tvalue\tstandard_error\n");
for (const Ensemble *one = all; one < all + combinations; one++)
for (int r = 0; r < one->summary.rows; r++) {
const SummaryRow *row = &one->summary.row[r];
fprintf(table.file, "%s%s\t%.12g\t%.12g\n", row->name, one->scene->suffix,
row->value, row->error);
}
table_close(&table, out);
}
static Summary list_columns(const Ensemble *all, int combinations) {
Summary columns = {0};
for (const Ensemble *one = all; one < all + combinations; one++)
for (int r = 0; r < one->summary.rows; r++)
if (!summary_find(&columns, one->summary.row[r].name))
summary_add(&columns, "", one->summary.row[r].name, GSL_NAN, GSL_NAN);
return columns;
}
static void write_combination(FILE *file, const Ensemble *one,
const Summary *columns) {
if (one->failed < one->count)
fprintf(file, "# %s\n", one->result[one->failed].out.text);
for (int i = 0; i < one->scene->keys; i++)
fprintf(file, "%s%s", i ? "\t" : "", one->scene->swept[i].value);
for (int c = 0; c < columns->rows; c++) {
const SummaryRow *row = summary_find(&one->summary, columns->row[c].name);
row = row ? row : &columns->row[c];
fprintf(file, "\t%.12g\t%.12g", row->value, row->error);
}
fprintf(file, "\n");
}
static void write_sweep(const Ensemble *all, int combinations,
const char *directory, Outcome *out) {
Table table;
const Scene *scene = all->scene;
if (out->status != DONE || table_open(&table, directory, "sweep.tsv", out))
return;
Summary columns = list_columns(all, combinations);
header_write(&table, scene, ensemble_first(all), all->count,
"a row a combination: the keys of the sweep, each quantity and "
"its standard error");
for (int i = 0; i < scene->keys; i++)
fprintf(table.file, "%s%s", i ? "\t" : "", scene->swept[i].key);
for (int c = 0; c < columns.rows; c++)
fprintf(table.file, "\t%s\t%s_err", columns.row[c].name,
columns.row[c].name);
fprintf(table.file, "\n");
for (const Ensemble *one = all; one < all + combinations; one++)
write_combination(table.file, one, &columns);
free(columns.row);
table_close(&table, out);
}
void tables_write(Ensemble *all, int combinations, const char *directory,
Outcome *out) {
for (Ensemble *one = all; one < all + combinations; one++) {
const Scene *scene = one->scene;
bool reached = one->failed == one->count;
for (int stage = 0; reached && one->count && stage < stages_of(one);
stage++)
write_stage(one, stage, directory, out);
if (reached && one->count && one->look)
write_marks(one, directory, out);
if (reached && one->count && scene_by_law(scene))
write_sizes(one, directory, out);
if (reached)
write_theory(one, directory, out);
if (scene->keys)
summary_add(&one->summary, "", "reached", reached, 0);
if (reached)
summarize(one);
}
if (all->scene->keys)
write_sweep(all, combinations, directory, out);
write_summary(all, combinations, directory, out);
}
void tables_plan(const Ensemble *one, FILE *file) {
const Scene *scene = one->scene;
int stages = scene->make.entry ? stages_of(one) : 1;
for (int c = 0; c < one->layout.curves; c++) {
const Slot *slot = &one->layout.curve[c];
bool made = slot->told->flags & TOLD_MADE || stages == 1;
for (int s = 0; *slot->told->columns && s < (made ? 1 : stages); s++)
fprintf(file, " %s%s%s.tsv",
made ? ""
: s ? "shaken."
: "made.",
slot->name, scene->suffix);
}
if (scene->stages.marks)
fprintf(file, " shaking%s.tsv", scene->suffix);
if (scene->make.entry && scene_by_law(scene))
fprintf(file, " sizes%s.tsv", scene->suffix);
for (const Asked *c = scene->curve; c && c->entry; c++)
if (((const Curve *)c->entry)->alloc) {
fprintf(file, " theory%s.tsv", scene->suffix);
break;
}
}
