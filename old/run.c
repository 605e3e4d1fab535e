#include "run.h"
#include "ask.h"
#include "core.h"
#include "monitor.h"
#include "tables.h"
#include "touch.h"
#include "files.h"
#include "view.h"
#include "xyz.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
enum { FRACTION, REDUCED, NUMBER, REACH };
static const Told told_pack[] = {
[FRACTION] = {"fraction", NULL, W("packing fraction"), MEAN, ONCE, 0},
[REDUCED] = {"reduced_density", NULL,
W("all particles' volumes by that of the box"), MEAN, ONCE, 0},
[NUMBER] = {"number", NULL, W("particles"), MEAN, ONCE, 0},
[REACH] = {"reach", NULL, W("of nearest images, or of the core, R"), MEAN,
ONCE, 0},
{0}};
enum { MIN_GAP, PAIRS, CENTRES, OF_SPECIES, IN_CORE };
static const Told told_measured[] = {
[MIN_GAP] = {"min_gap", NULL, W("in diameters"), LEAST, ONCE, TOLD_FIXED},
[PAIRS] = {"pairs", NULL, W("looked at"), MEAN, ONCE, TOLD_FIXED},
[CENTRES] = {"centres", NULL, W("in the core"), MEAN, ONCE, 0},
[OF_SPECIES] = {"number", NULL, W("particles"), MEAN, EACH_SPECIES, 0},
[IN_CORE] = {"core", NULL, W("share of the core's solid"), MEAN,
EACH_SPECIES, 0},
{0}};
static bool tells_pack(const void *own, int t) {
bool hard = *(const unsigned *)own & FACT_HARD;
return t == FRACTION ? hard : t == REDUCED ? !hard : true;
}
static int count_asked(const Asked *list) {
int n = 0;
while (list && list[n].entry)
n++;
return n;
}
static int *add_entry(Layout *layout, const Asked *asked) {
return layout_add(layout, asked->entry->told, asked->entry->tells,
asked->own);
}
Ensemble run_ensemble(const Scene *scene, unsigned facts,
const Species species[], int kinds) {
int changes = count_asked(scene->change);
int measures = count_asked(scene->measure), n = 2 + changes + measures;
Ensemble one = {.scene = scene, .facts = facts};
Layout *layout = &one.layout;
int **at = one.at = memory((size_t)n + 1, sizeof *at);
layout->kinds = kinds;
layout->species = species;
*at++ = layout_add(layout, told_pack, tells_pack, &facts);
*at++ = scene->make.entry ? add_entry(layout, &scene->make)
: layout_add(layout, NULL, NULL, NULL);
for (int c = 0; c < changes; c++)
*at++ = add_entry(layout, &scene->change[c]);
layout->measured = layout->numbers;
one.measured = layout_add(layout, told_measured, NULL, NULL);
for (int m = 0; m < measures; m++)
*at++ = add_entry(layout, &scene->measure[m]);
for (int c = 0; c < changes; c++)
layout_measured(layout, scene->change[c].entry->told, one.at[2 + c]);
return one;
}
static void free_results(Result *result, int count) {
for (int k = 0; result && k < count; k++)
result_free(&result[k]);
free(result);
}
void run_forget(Ensemble *one) {
free_results(one->made, one->count);
free_results(one->look, one->count * (one->scene->stages.marks + 1));
free_results(one->result, one->count);
for (int e = 0; one->at && one->at[e]; e++)
free(one->at[e]);
free(one->at);
free(one->measured);
free(one->watch);
layout_free(&one->layout);
free(one->summary.row);
}
static Work work_of(const Ensemble *one, const Pack *pack, int k,
Result *result) {
const Scene *scene = one->scene;
Work work = {.scene = scene, .k = k, .pack = pack, .result = result};
work.watch = one->watch ? one->watch[k] : NULL;
if (!pack)
return work;
work.a = pack->species[0].radius;
work.core = scene->inside * pack->open;
work.facts = one->facts;
work.fraction =
work.core > 0 ? core_fraction(pack, work.core) : pack_fraction(pack);
return work;
}
static Work entry_work(const Work *work, const Ensemble *one,
const Asked *asked, int place) {
Work own = *work;
own.asked = asked;
own.own = asked->own;
own.at = one->at[place];
return own;
}
static bool go_on(const Work *work, const Asked *next) {
WatchNews news = {.what = next->entry->name};
bool on = watch_tick(work->watch, &news);
if (!on)
outcome_set(&work->result->out, STOPPED, "stopped before %s", news.what);
return on;
}
static void tell_core(const Work *work) {
const Pack *pack = work->pack;
size_t centres;
bool *is = work_centres(work, 0, &centres);
double *solid = memory((size_t)pack->kinds, sizeof *solid), all = 0;
tell(work, CENTRES, 0, (double)centres);
for (size_t i = 0; i < pack->n; i++) {
double ball = pack_ball(pack->box.dim, pack_radius(pack, i));
solid[pack_kind(pack, i)] += is[i] ? ball : 0;
all += is[i] ? ball : 0;
}
for (int s = 0; s < pack->kinds && pack->kinds > 1; s++) {
tell(work, OF_SPECIES, s, (double)pack->species[s].count);
tell(work, IN_CORE, s, solid[s] / all);
}
free(solid);
free(is);
}
static Work measure_work(const Ensemble *one, const Work *work, int m,
View *view) {
const Asked *asked = one->scene->measure;
int first = 2 + count_asked(one->scene->change);
Work own = entry_work(work, one, &asked[m], first + m);
own.edges = view_how(one->scene, &asked[m], entry_walls(own.pack));
if (own.edges)
view_through(view, &own);
return own;
}
typedef struct {
double at[6];
size_t particle;
} Placed;
static int by_place(const void *a, const void *b) {
const Placed *A = a, *B = b;
for (int k = 0; k < 6; k++)
if (A->at[k] != B->at[k])
return A->at[k] < B->at[k] ? -1 : 1;
return 0;
}
static Placed *place_all(const Pack *pack) {
Placed *placed = memory(pack->n, sizeof *placed);
size_t dim = (size_t)pack->box.dim;
for (size_t i = 0; i < pack->n; i++) {
double *at = placed[i].at;
placed[i].particle = i;
at[0] = pack_kind(pack, i);
memcpy(at + 1, pack->x + i * dim, dim * sizeof *at);
at[4] = pack_radius(pack, i);
at[5] = pack->angle ? pack->angle[i] : 0;
}
qsort(placed, pack->n, sizeof *placed, by_place);
return placed;
}
static Pack *sorted_copy(const Pack *pack) {
Placed *placed = place_all(pack);
Pack *sorted = pack_copy(pack);
size_t dim = (size_t)pack->box.dim;
for (size_t i = 0; i < pack->n; i++) {
const double *at = placed[i].at;
memcpy(sorted->x + i * dim, at + 1, dim * sizeof *at);
if (pack->kind)
sorted->kind[i] = (uint16_t)at[0];
if (pack->radius)
sorted->radius[i] = at[4];
if (pack->angle)
sorted->angle[i] = at[5];
}
free(placed);
return sorted;
}
static void measure(const Ensemble *one, const Work *work, unsigned only) {
const Asked *asked = one->scene->measure;
int n = count_asked(asked);
Work *all = memory((size_t)n + 1, sizeof *all);
View view = {0};
Pack *sorted = NULL;
for (int m = 0; m < n; m++) {
const Measure *measure = (const Measure *)asked[m].entry;
all[m] = measure_work(one, work, m, &view);
all[m].all = all;
if (measure->sorted && !sorted)
sorted = sorted_copy(work->pack);
if (measure->sorted)
all[m].pack = sorted;
}
for (int m = 0; m < n && go_on(work, &asked[m]); m++) {
unsigned flags = 0;
for (const Told *t = asked[m].entry->told; t && t->name; t++)
flags |= t->flags;
bool blind = all[m].edges && !all[m].window;
if (!blind && (!only || flags & only))
((const Measure *)asked[m].entry)->run(&all[m]);
}
view_close(&view);
pack_free(&sorted);
free(all);
}
static void measure_pack(const Ensemble *one, const Pack *pack, double gap,
int k, Result *result) {
Work work = work_of(one, pack, k, result), seen = work;
View view = {0};
if (one->scene->window.line || pack->walls)
view_through(&view, &seen);
seen.at = one->at[0];
tell(&seen, FRACTION, 0, seen.fraction);
tell(&seen, REDUCED, 0, seen.fraction);
tell(&seen, NUMBER, 0, (double)pack->n);
tell(&seen, REACH, 0,
(seen.core > 0 ? seen.core : box_reach(&pack->box)) / work.a);
seen.at = work.at = one->measured;
tell(&work, MIN_GAP, 0, work_alone(&work) ? GSL_POSINF : gap / (2 * work.a));
if (seen.core > 0)
tell_core(&seen);
measure(one, &work, 0);
view_close(&view);
}
static const Asked *stage_of(const Scene *scene, int *place) {
int c = 0;
const Asked *one = scene->change;
while (one && one[c].entry && !((const Change *)one[c].entry)->stage)
c++;
*place = 2 + c;
return one && one[c].entry ? &one[c] : NULL;
}
typedef struct {
const Ensemble *one;
Rng rng;
void *report;
} Visitor;
static void visit(const Work *growing, Pack *pack) {
Visitor *visitor = growing->visitor;
int place;
const Asked *asked = stage_of(growing->scene, &place);
const Change *change = (const Change *)asked->entry;
Work work = work_of(visitor->one, pack, growing->k, growing->result);
work = entry_work(&work, visitor->one, asked, place);
void *state = change->open(&work, pack, &visitor->rng);
if (state) {
change->run(&work, state, (uint64_t)growing->scene->stages.each,
visitor->report);
change->close(state);
}
}
static void pass_visitor(const Work *growing, State *state) {
Visitor *visitor = growing->visitor;
int place;
const Change *stage = (const Change *)stage_of(growing->scene, &place)->entry;
STATE_PASS(state, visitor->rng);
state_pass(state, visitor->report, stage->report);
}
typedef struct {
const Scene *of;
void *base;
} Kept;
static Pack *make_pack(const Ensemble *one, int k, Kept *kept, Result *result) {
const Scene *scene = one->scene;
const Maker *maker = (const Maker *)scene->make.entry;
Work work = work_of(one, NULL, k, result);
Box box = ask_box(scene);
int place;
const Asked *stage = stage_of(scene, &place);
size_t room = stage ? ((const Change *)stage->entry)->report : 0;
Visitor visitor = {one, work_stream(&work, RNG_SHAKING, 0),
memory(1, room + 1)};
work = entry_work(&work, one, &scene->make, 1);
work.visit = visit;
work.pass = pass_visitor;
work.visitor = &visitor;
work.base = &kept->base;
work.base_of = kept->of;
Pack *pack = go_on(&work, &scene->make) ? maker->make(&work, &box) : NULL;
kept->of = scene;
if (stage && pack) {
Work done = work_of(one, pack, k, result);
done = entry_work(&done, one, stage, place);
((const Change *)stage->entry)->note(&done, visitor.report);
}
free(visitor.report);
for (int c = 0; pack && result->out.status == DONE && 2 + c < place; c++) {
const Change *change = (const Change *)scene->change[c].entry;
work = entry_work(&work, one, &scene->change[c], 2 + c);
if (go_on(&work, &scene->change[c]))
pack = change->replace(&work, pack);
}
if (result->out.status != DONE)
pack_free(&pack);
return pack;
}
static void measure_samples(const Ensemble *one, const Work *work,
const Change *change, void *state, void *report,
Result *result) {
const SceneStages *s = &one->scene->stages;
void *between = memory(1, change->report + 1);
Outcome *out = &result->out;
for (int i = 0; i < s->samples && out->status == DONE; i++) {
Result sample = {0};
if (i > 0 && change->run(work, state, (uint64_t)s->apart, between))
break;
result_begin(&sample, &one->layout);
measure_pack(one, work->pack, touch_least_gap(work->pack), work->k,
&sample);
if (sample.out.status != DONE)
*out = sample.out;
result_add(result, &sample);
}
result_divide(result, s->samples);
Work last = *work;
last.result = result;
change->sampled(&last, between);
change->add(report, between);
free(between);
}
static void look(const Ensemble *one, const Work *work, const Change *change,
const void *state, Result *at) {
Work now = *work;
result_begin(at, &one->layout);
now.result = at;
change->look(&now, state);
measure(one, &now, TOLD_AT_MARKS);
}
static void run_stage(const Ensemble *one, Pack *pack, int k, Result *made,
Result *result) {
const SceneStages *s = &one->scene->stages;
int place, done = 0;
const Asked *asked = stage_of(one->scene, &place);
const Change *change = (const Change *)asked->entry;
Work work = work_of(one, pack, k, made);
work = entry_work(&work, one, asked, place);
Rng rng = work_stream(&work, RNG_SHAKING, 1);
void *report = memory(1, change->report + 1);
void *state = change->open(&work, pack, &rng);
Outcome *out = &made->out;
for (int i = 0; state && i <= s->marks && out->status == DONE; i++) {
if (s->marks)
look(one, &work, change, state, &one->look[k * (s->marks + 1) + i]);
int next = i < s->marks ? s->mark[i] : s->sweeps;
change->run(&work, state, (uint64_t)(next - done), report);
done = next;
}
if (state && out->status == DONE) {
change->look(&work, state);
measure_samples(one, &work, change, state, report, result);
}
change->note(&work, report);
if (state)
change->close(state);
free(report);
if (out->status != DONE)
result->out = *out;
}
static void name_pack(const Scene *scene, const char *prefix, int k,
char name[224]) {
snprintf(name, 224, "%s-%d%s.xyz", prefix, k, scene->suffix);
}
static void save_pack(const Scene *scene, const char *prefix, const Pack *pack,
int k, const char *directory, Outcome *out) {
Table table;
char name[224], note[64];
name_pack(scene, prefix, k, name);
snprintf(note, sizeof note, "seed=%lld realization=%d",
(long long)scene->seed, k);
if (table_open(&table, directory, name, out) == DONE)
xyz_write(table.file, pack, note);
table_close(&table, out);
}
static void save_last(const Scene *scene, const Pack *pack, int k,
const char *directory, Outcome *out) {
save_pack(scene, "pack", pack, k, directory, out);
if (scene->cube == 0)
return;
double largest = 2 * scene->inside * pack->open / sqrt(pack->box.dim);
Pack *cube = core_cube(pack, scene->cube * largest);
save_pack(scene, "cube", cube, k, directory, out);
pack_free(&cube);
}
static bool is_there(const Scene *scene, const char *prefix, int k,
const char *directory) {
char name[224], path[4400];
name_pack(scene, prefix, k, name);
snprintf(path, sizeof path, "%.4000s/%s", directory, name);
return access(path, F_OK) == 0;
}
static bool is_saved(const Ensemble *one, int k, const char *directory) {
const Scene *scene = one->scene;
return is_there(scene, "pack", k, directory) &&
(!one->made || is_there(scene, "made.pack", k, directory)) &&
(scene->cube == 0 || is_there(scene, "cube", k, directory));
}
static bool same_but(const char *part, const Scene *a, const Scene *b) {
for (int i = 0; i < a->keys; i++)
if (strncmp(a->swept[i].key, part, strlen(part)) != 0 &&
strcmp(a->swept[i].value, b->swept[i].value) != 0)
return false;
return true;
}
static bool same_making(const Scene *a, const Scene *b) {
for (int i = 0; i < a->keys; i++) {
const char *key = a->swept[i].key;
bool after = strncmp(key, "measure.", 8) == 0 ||
strncmp(key, "window.", 7) == 0 ||
(strncmp(key, "shake.", 6) == 0 && a->stages.every == 0 &&
b->stages.every == 0);
if (!after && strcmp(a->swept[i].value, b->swept[i].value) != 0)
return false;
}
return true;
}
typedef struct {
const Scene *scene;
Result made;
Result noted;
Pack *changed;
} Before;
static void forget(Before *before) {
if (before->made.number)
result_free(&before->made);
if (before->noted.number)
result_free(&before->noted);
pack_free(&before->changed);
}
static void keep(const Ensemble *one, const Result *from, Result *to) {
if (to->number)
result_free(to);
result_begin(to, &one->layout);
result_clone(from, to);
}
static void measure_made(const Ensemble *one, const Pack *pack,
const Result *first, int k, Before *before,
Result *made) {
if (before->scene && same_but("shake.", before->scene, one->scene)) {
result_clone(&before->made, made);
return;
}
result_copy(first, made);
if (pack)
measure_pack(one, pack, touch_least_gap(pack), k, made);
if (one->made && one->scene->keys)
keep(one, made, &before->made);
}
static void measure_changed(const Ensemble *one, const Pack *pack, int k,
Before *before, Result *made, Result *result) {
const SceneStages *s = &one->scene->stages;
if (before->scene && s->samples == 1 && !s->marks &&
same_but("measure.", before->scene, one->scene)) {
for (int n = 0; n < one->layout.measured; n++)
made->number[n] = before->noted.number[n];
measure_pack(one, before->changed, touch_least_gap(before->changed), k,
result);
return;
}
pack_free(&before->changed);
before->changed = pack_copy(pack);
run_stage(one, before->changed, k, made, result);
if (one->scene->keys)
keep(one, made, &before->noted);
}
static void one_combination(const Ensemble *one, int k, const Pack *pack,
const Result *first, Before *before,
const char *directory) {
const Scene *scene = one->scene;
Result *result = &one->result[k], *made = one->made ? &one->made[k] : result;
result_begin(result, &one->layout);
if (one->made)
result_begin(made, &one->layout);
measure_made(one, pack, first, k, before, made);
result->out = made->out;
if (one->made && result->out.status == DONE)
measure_changed(one, pack, k, before, made, result);
bool whole = pack && result->out.status == DONE;
if (whole && one->made && scene->save)
save_pack(scene, "made.pack", pack, k, directory, &result->out);
if (whole && scene->save)
save_last(scene, one->made ? before->changed : pack, k, directory,
&result->out);
result->transient = whole && result->out.status != DONE;
before->scene = whole ? scene : NULL;
}
static bool same_base(const Scene *a, const Scene *b) {
const Maker *maker = (const Maker *)a->make.entry;
return maker && maker->same_base && a->make.entry == b->make.entry &&
maker->same_base(a, b);
}
static void set_family(Ensemble *all, int e) {
Ensemble *one = &all[e];
while (one->family < e && !same_making(all[one->family].scene, one->scene))
one->family++;
while (one->kin < one->family && !same_base(all[one->kin].scene, one->scene))
one->kin++;
}
static bool wanted(const Ensemble *one, int k) {
return k < one->count && k <= __atomic_load_n(&one->failed, __ATOMIC_RELAXED);
}
static void one_family(Ensemble *all, int combinations, int head, int k,
Kept *kept, const char *directory) {
Result first = {0};
Before before = {0};
Pack *pack = NULL;
bool begun = false;
for (int e = head; e < combinations; e++) {
Ensemble *one = &all[e];
if (one->family != head || !wanted(one, k))
continue;
if (!begun) {
result_begin(&first, &one->layout);
pack = make_pack(one, k, kept, &first);
begun = true;
}
one_combination(one, k, pack, &first, &before, directory);
#pragma omp critical
if (one->result[k].out.status != DONE && k < one->failed)
__atomic_store_n(&one->failed, k, __ATOMIC_RELAXED);
}
if (begun)
result_free(&first);
forget(&before);
pack_free(&pack);
}
bool run_has(const Run *run, int head, int k, int e) {
return run->all[run->all[e].family].kin == head && k < run->all[e].count;
}
int run_realization(const Run *run, int job, int *head) {
const Ensemble *all = run->all;
int k = job;
for (*head = 0; all[*head].kin != *head || k >= all[*head].count; ++*head)
k -= all[*head].kin == *head ? all[*head].count : 0;
return k;
}
static void set_watch(Run *run, int head, int k, Watch *watch) {
for (int e = head; e < run->combinations; e++)
if (run_has(run, head, k, e))
run->all[e].watch[k] = watch;
}
bool run_stopped(const Run *run, int job) {
bool stopped = false;
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++)
stopped |=
run_has(run, head, k, e) && run->all[e].result[k].out.status == STOPPED;
return stopped;
}
bool run_job(Run *run, int job, const char *directory, Watch *watch) {
Kept kept = {0};
int head, k = run_realization(run, job, &head);
set_watch(run, head, k, watch);
const Maker *maker = (const Maker *)run->all[head].scene->make.entry;
for (int e = head; e < run->combinations; e++)
if (run->all[e].kin == head && run->all[e].family == e)
one_family(run->all, run->combinations, e, k, &kept, directory);
if (maker->forget)
maker->forget(kept.base);
set_watch(run, head, k, NULL);
return !run_stopped(run, job);
}
bool run_wanted(const Run *run, int job) {
bool some = false;
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++)
some |= run_has(run, head, k, e) && wanted(&run->all[e], k);
return some;
}
bool run_transient(const Run *run, int job) {
bool some = false;
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++)
some |=
run_has(run, head, k, e) && (run->all[e].result[k].transient ||
run->all[e].result[k].out.status > WRONG);
return some;
}
bool run_done(const Run *run, int job, const char *directory) {
bool whole = true;
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++) {
const Ensemble *one = &run->all[e];
const Result *result = &one->result[k];
if (!run_has(run, head, k, e) || !wanted(one, k))
continue;
whole &= result->number && !result->transient;
if (whole && directory && one->scene->save && result->out.status == DONE)
whole &= is_saved(one, k, directory);
}
return whole;
}
void run_drop(Run *run, int job) {
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++) {
Ensemble *one = &run->all[e];
int looks = one->look ? one->scene->stages.marks + 1 : 0;
if (!run_has(run, head, k, e))
continue;
result_free(&one->result[k]);
if (one->made)
result_free(&one->made[k]);
for (int i = 0; i < looks; i++)
result_free(&one->look[k * looks + i]);
}
}
void run_note(Run *run, int job) {
int head, k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++) {
Ensemble *one = &run->all[e];
if (run_has(run, head, k, e) && one->result[k].out.status != DONE &&
k < one->failed)
one->failed = k;
}
}
void run_note_all(Run *run) {
for (Ensemble *one = run->all; one < run->all + run->combinations; one++)
one->failed = one->count;
for (int job = 0; job < run->jobs; job++)
run_note(run, job);
}
void run_open(Run *run, const Scene *scene) {
int place;
*run = (Run){.scene = scene};
for (const Scene *s = scene; s; s = s->next)
run->combinations++;
Ensemble *all = memory((size_t)run->combinations, sizeof *all), *one = all;
run->all = all;
for (const Scene *s = scene; s; s = s->next, one++) {
*one = run_ensemble(s, s->facts, s->species, s->kinds);
one->count = one->failed = s->make.entry ? s->realizations : 0;
one->result = memory((size_t)one->count, sizeof *one->result);
one->watch = memory((size_t)one->count, sizeof *one->watch);
if (s->make.entry && stage_of(s, &place))
one->made = memory((size_t)one->count, sizeof *one->made);
if (one->made && s->stages.marks)
one->look = memory((size_t)(one->count * (s->stages.marks + 1)),
sizeof *one->look);
set_family(all, (int)(one - all));
run->jobs += one->kin == one - all ? one->count : 0;
}
}
static void free_ensembles(Ensemble *all, int combinations) {
for (Ensemble *one = all; one < all + combinations; one++)
run_forget(one);
free(all);
}
void run_close(Run *run) {
free_ensembles(run->all, run->combinations);
*run = (Run){0};
}
static const Outcome *outcome_of(const Ensemble *one) {
static const Outcome well;
return one->failed < one->count ? &one->result[one->failed].out : &well;
}
static bool is_transient(const Ensemble *one) {
return one->failed < one->count && one->result[one->failed].transient;
}
int run_judge(const Run *run, Outcome *out) {
for (int e = 0; e < run->combinations && out->status == DONE; e++) {
const Outcome *one = outcome_of(&run->all[e]);
if (one->status == WRONG || !run->scene->keys || is_transient(&run->all[e]))
*out = *one;
}
return out->status;
}
void run_tell_unreached(const Run *run, Outcome *out) {
int unreached = 0;
const Ensemble *first = NULL;
if (!run->scene->keys || run->scene->unreached != 0)
return;
for (int e = run->combinations - 1; e >= 0; e--)
if (outcome_of(&run->all[e])->status != DONE) {
first = &run->all[e];
unreached++;
}
if (first)
outcome_set(out, UNREACHED,
"%s: %d of %d combinations not reached; the first, %s: %s",
run->scene->path, unreached, run->combinations,
first->scene->suffix, outcome_of(first)->text);
}
static bool is_flat(const Pack *pack) {
bool flat = pack->box.dim == 3 && pack->walls >> 2 & 1;
for (size_t i = 1; flat && i < pack->n; i++)
flat = pack->x[3 * i + 2] == pack->x[2];
return flat;
}
static int refuse_overlap(const Scene *scene, const char *path,
const Pack *pack, Outcome *out) {
size_t pair[2];
const Measure *measure = NULL;
for (const Asked *one = scene->measure; one && one->entry && !measure; one++)
if (((const Measure *)one->entry)->wants & FACT_HARD)
measure = (const Measure *)one->entry;
if (!measure)
return DONE;
double gap = touch_deepest(pack, pair);
return outcome_set(
out, WRONG,
"%s: particles %zu and %zu overlap by %.3g of the smallest "
"radius, and measure.%s is of hard particles; relax them, "
"or leave it out of %s",
path, pair[0] + 1, pair[1] + 1, -gap / pack_smallest(pack),
measure->entry.name, scene->path);
}
static int judge_file(const Scene *scene, const char *path, const Pack *pack,
unsigned facts, Outcome *out) {
Reader reader = {(Scene *)(uintptr_t)scene, path, out};
Query query = {.scene = reader.scene,
.reader = &reader,
.species = pack->species,
.kinds = pack->kinds};
int dim = is_flat(pack) ? 2 : pack->box.dim;
if (dim != scene->dimension)
return outcome_set(out, WRONG, "%s: has dimension %d; the scene says %d",
path, dim, scene->dimension);
if (pack->n == 0)
return outcome_set(out, WRONG, "%s: no particles; there must be one", path);
if (pack->angle && (pack->open > 0 || pack->walls))
return outcome_set(
out, WRONG, "%s: a finite pack with shapes; give a periodic one", path);
if (!(facts & FACT_HARD) && refuse_overlap(scene, path, pack, out))
return out->status;
return ask_measures(&query, facts,
pack->open > 0 || pack->walls ? NULL : &pack->box);
}
static int place_of(const char *name, const Species among[], int n, int s) {
if (s < n && strcmp(name, among[s].name) == 0)
return s;
for (s = 0; s < n && strcmp(name, among[s].name) != 0; s++)
;
return s;
}
static const char *unknown(const Species of[], int n, const Species others[],
int m) {
for (int s = 0; s < n; s++)
if (place_of(of[s].name, others, m, s) == m)
return of[s].name;
return NULL;
}
static void arrange(Pack *pack, const Species order[]) {
size_t kinds = (size_t)pack->kinds;
uint16_t *to = memory(kinds, sizeof *to);
Species *sorted = memory(kinds, sizeof *sorted);
for (int s = 0; s < pack->kinds; s++)
to[s] = (uint16_t)place_of(pack->species[s].name, order, pack->kinds, s);
for (size_t s = 0; s < kinds; s++)
sorted[to[s]] = pack->species[s];
for (size_t i = 0; pack->kind && i < pack->n; i++)
pack->kind[i] = to[pack->kind[i]];
free(pack->species);
free(to);
pack->species = sorted;
}
static void set_unit(Pack *pack, double unit) {
double *radius = memory(pack->n, sizeof *radius);
for (size_t i = 0; i < pack->n; i++)
radius[i] = pack_radius(pack, i);
free(pack->radius);
pack->radius = radius;
pack->species[0].radius = unit;
}
typedef struct {
Ensemble *one;
const char *path, *first;
Watch *watch;
Species *species;
bool hard;
} Measured;
static unsigned find_facts(Measured *m, const Pack *pack, double gap) {
const Scene *scene = m->one->scene;
unsigned facts = entry_facts(pack, gap);
bool made_hard = !scene->make.entry || scene->facts & FACT_HARD;
if (m->one->count == 0)
m->hard = made_hard && facts & FACT_HARD;
return m->hard ? facts : facts & ~(unsigned)FACT_HARD;
}
static int match(const Measured *m, Pack *pack, Outcome *out) {
const Layout *layout = &m->one->layout;
const char *missing = unknown(layout->species, layout->kinds, pack->species,
pack->kinds),
*surplus = unknown(pack->species, pack->kinds, layout->species,
layout->kinds);
if (missing || surplus)
return outcome_set(
out, WRONG, "%s: has other species than %s, %s %s; measure them apart",
m->path, m->first, missing ? "no" : "also",
missing ? missing : surplus);
arrange(pack, layout->species);
return DONE;
}
static int measure_next(Measured *m, const Pack *pack, double gap,
Outcome *out) {
Ensemble *one = m->one;
int k = one->count;
one->result = memory_grow(one->result, (size_t)k + 1, sizeof *one->result);
one->watch = memory_grow(one->watch, (size_t)k + 1, sizeof *one->watch);
one->watch[k] = m->watch;
one->count = one->failed = k + 1;
result_begin(&one->result[k], &one->layout);
measure_pack(one, pack, gap, k, &one->result[k]);
if (one->result[k].out.status == STOPPED)
return outcome_set(out, STOPPED, "interrupted at %s; no table was written",
m->path);
if (one->result[k].out.status != DONE)
outcome_set(out, WRONG, "%s: %s", m->path, one->result[k].out.text);
return out->status;
}
static int measure_one(Measured *m, Pack *pack, Outcome *out) {
Ensemble *one = m->one;
int k = one->count;
if (one->scene->unit > 0)
set_unit(pack, one->scene->unit);
double gap = touch_least_gap(pack);
one->facts = find_facts(m, pack, gap);
if (judge_file(one->scene, m->path, pack, one->facts, out))
return out->status;
if (m->hard && !(one->facts & FACT_HARD))
return outcome_set(out, WRONG,
"%s: particles overlap, and none do in %s; measure them "
"apart",
m->path, m->first);
if (k == 0) {
size_t kinds = (size_t)pack->kinds;
m->species = memory(kinds, sizeof *m->species);
memcpy(m->species, pack->species, kinds * sizeof *m->species);
for (size_t s = 0; s < kinds; s++)
m->species[s].shape = NULL;
*one = run_ensemble(one->scene, one->facts, m->species, pack->kinds);
one->count = one->failed = 0;
}
if (match(m, pack, out))
return out->status;
return measure_next(m, pack, gap, out);
}
static bool told_box(const Scene *scene, Box *box) {
box->dim = scene->dimension;
for (int k = 0; k < box->dim; k++)
box->side[k] =
scene->side * (scene->sides ? scene->box[k] / scene->box[0] : 1);
return scene->side > 0;
}
static void measure_file(Measured *m, Outcome *out) {
const Scene *scene = m->one->scene;
GatherKnown known = {scene->dimension, scene->species, scene->kinds,
scene->fraction};
PackFile file;
Box box = {0};
bool told = told_box(scene, &box);
if (files_open(&file, m->path, &known, told ? &box : NULL, out))
for (Pack *pack; out->status == DONE && (pack = files_next(&file));
pack_free(&pack))
measure_one(m, pack, out);
files_close(&file);
}
int run_measure(const Scene *scene, const char *const packs[], int count,
const char *directory, Outcome *out) {
if (!scene->measures)
return outcome_set(out, WRONG, "%s: nothing to measure; give measure",
scene->path);
if (scene->keys)
return outcome_set(out, WRONG,
"%s: a sweep makes its packs; give --set sweep=()",
scene->path);
if (table_possible(directory, out))
return out->status;
Ensemble *one = memory(1, sizeof *one);
Measured m = {.one = one, .first = packs[0]};
Monitor *monitor = monitor_open(scene, 0, directory, 0, count);
one->scene = scene;
for (int k = 0; k < count && out->status == DONE; k++) {
m.path = packs[k];
m.watch = monitor_begin(monitor, scene, k);
measure_file(&m, out);
monitor_end(monitor, &m.watch, out->status == DONE);
}
monitor_close(&monitor);
if (out->status == DONE)
tables_write(one, 1, directory, out);
free_ensembles(one, 1);
free(m.species);
return out->status;
}
