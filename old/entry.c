#include "entry.h"
#include "core.h"
#include "touch.h"
#include "view.h"
#include <gsl/gsl_math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int query_wrong(const Query *query, const char *key, const char *what,
const char *right) {
config_setting_t *at =
query->root ? config_setting_lookup(query->root, key) : NULL;
return setting_wrong(query->reader, at ? at : query->root, what, right);
}
bool query_says(const Query *query, const char *key) {
return query->root && config_setting_lookup(query->root, key);
}
int query_say(const Query *query, const char *format, ...) {
char text[400], place[16] = "--set";
va_list arguments;
va_start(arguments, format);
vsnprintf(text, sizeof text, format, arguments);
va_end(arguments);
if (query->asked->line > 0)
snprintf(place, sizeof place, "%d", query->asked->line);
return outcome_set(query->reader->out, WRONG, "%s:%s: %s", query->scene->path,
place, text);
}
int query_bins(const Query *query, const char *group, int line, double from,
double reach, double step) {
double bins = (reach - from) / step * (1 + 1e-12);
if (bins >= 1 && bins <= 1e6 + 1)
return DONE;
return outcome_set(query->reader->out, WRONG,
"%s:%d: step and reach of %s make %.6g bins; reach "
"must be at least %g, and step such that they are at "
"most a million",
query->scene->path, line, group, fmax(0, floor(bins)),
from + step);
}
void tell(const Work *work, int t, int item, double value) {
if (work->at[t] >= 0)
work->result->number[work->at[t] + item] = value;
}
void tell_more(const Work *work, int t, double value) {
double *number = &work->result->number[work->at[t]];
*number = result_sum(*number, value);
}
void tell_error(const Work *work, int t, int item, double error) {
if (work->at[t] >= 0)
work->result->error[work->at[t] + item] = error;
}
Row *tell_curve(const Work *work, int t, int item, size_t length) {
Row *row = &work->result->curve[work->at[t] + item];
result_row(row, length);
return row;
}
void tell_pairs(const Work *work, double pairs) {
int at = layout_find(work->result->layout, "pairs");
work->result->number[at] = result_sum(work->result->number[at], pairs);
}
Rng work_stream(const Work *work, RngPurpose purpose, uint64_t stage) {
return rng_stream((uint64_t)work->scene->seed,
(uint64_t)work->k + (stage << 32), purpose);
}
bool work_alone(const Work *work) {
return work->core > 0 && work->pack->n == 1;
}
bool *work_centres(const Work *w, double R, size_t *centres) {
const Pack *pack = w->pack;
double radius = w->core - R * w->a;
bool *is = NULL;
*centres = pack->n;
if (w->core > 0) {
is = memory(pack->n, sizeof *is);
*centres = w->window ? window_within(w->window, pack, R * w->a, is)
: radius >= 0 ? core_within(pack, radius, is)
: 0;
}
if (w->core > 0 && *centres == 0)
outcome_set(&w->result->out, UNREACHED,
"the %s of the pack reaches to R = %.4g, and what is "
"measured to %.4g from its centres; give more particles, or a "
"larger %s",
w->window ? "window" : "core", w->core / w->a, R,
w->window ? "window" : "part inside");
return is;
}
bool work_sees(const Work *w, double R) {
double most = edges_limit(w->window, w->edges) / w->a;
size_t centres = 1;
if (w->edges == EDGES_MINUS)
free(work_centres(w, R, &centres));
if (centres && R > most * (1 + 1e-12))
outcome_set(&w->result->out, UNREACHED,
"the window allows R up to %.6g, and what is measured goes to "
"%.6g; give a larger window",
most, R);
return w->result->out.status == DONE;
}
Edges work_edges(const Work *w, int k, int m, double from, double step,
size_t bins) {
EdgesView view = {w->pack, w->window, w->edges, k, m};
if (!work_sees(w, from + (double)bins * step))
return (Edges){.growth = memory(2 * bins, sizeof(double))};
Edges edges = edges_count(&view, from * w->a, step * w->a, bins);
tell_pairs(w, edges.pairs);
return edges;
}
Pack *work_pack(const Work *work, const Box *box) {
const Scene *scene = work->scene;
Pack *pack =
pack_alloc(box, scene->species, scene->kinds, scene_by_law(scene));
double *radius = pack->radius;
for (int s = 0; s < scene->kinds; s++) {
size_t n = scene->species[s].count;
if (scene->sizes[s].radius && n)
memcpy(radius, scene->sizes[s].radius, n * sizeof *radius);
radius = radius ? radius + n : NULL;
}
return pack;
}
unsigned entry_walls(const Pack *pack) {
return pack->walls ? 0 : pack->open > 0 ? FACT_FINITE : FACT_PERIODIC;
}
unsigned entry_facts(const Pack *pack, double gap) {
bool one = pack_smallest(pack) == pack_largest(pack);
return (touch_hard(pack, gap) ? FACT_HARD : 0) | entry_walls(pack) |
(one ? FACT_ONE_SIZE : 0) | (pack->angle ? 0 : FACT_BALLS);
}
double entry_value(const Asked *asked, const char *name) {
for (const Key *key = asked->entry->keys; key && key->name; key++) {
const void *at = (const char *)asked->own + key->at;
if (strcmp(key->name, name) != 0)
continue;
if (key->type == REAL)
return *(const double *)at;
if (key->type == SWITCH)
return *(const bool *)at;
if (key->type == WHOLE || key->type == WORD)
return *(const int *)at;
}
return GSL_NAN;
}
void work_flown(const Work *work, const Pack *pack) {
for (const Work *one = work->all; one && one->scene; one++) {
const Measure *measure = (const Measure *)one->asked->entry;
const Told *told = measure->entry.told;
int n = 0;
bool some = false;
for (; told && told[n].name; n++)
some |= (told[n].flags & TOLD_FLOWN) != 0;
Work after = *one;
after.pack = pack;
after.result = work->result;
after.at = one->at + n;
View view = {0};
if (some && (!one->window || view_through(&view, &after) == DONE))
measure->run(&after);
if (some && one->window)
view_close(&view);
}
}
