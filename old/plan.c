#include "plan.h"
#include "ask.h"
#include "header.h"
#include "run.h"
#include "tables.h"
static void tell_box(const Scene *scene, FILE *file) {
Box box = ask_box(scene);
fprintf(file, "box\t");
if (scene->facts & FACT_FINITE) {
fprintf(file,
"none: a finite pack, its radius above %.6g, its core %g of "
"that\n",
box.side[0] / 4 / scene->species[0].radius, scene->inside);
return;
}
for (int k = 0; k < box.dim; k++)
fprintf(file, "%s%.6g", k ? " x " : "", box.side[k]);
fprintf(file, ", largest reach %.6g\n",
box_reach(&box) / scene->species[0].radius);
}
static void tell_made(const Scene *scene, FILE *file) {
size_t n = 0;
for (int s = 0; s < scene->kinds; s++)
n += scene->species[s].count;
fprintf(file, "store\t%zu bytes a particle\n",
pack_bytes(scene->dimension, scene->kinds, scene->own_radii,
scene_shaped(scene)));
fprintf(file, "make\t%s, %d realizations", scene->make.entry->name,
scene->realizations);
if (n)
fprintf(file, ", %zu particles", n);
fprintf(file, "\n");
tell_box(scene, file);
}
static void tell_changes(const Scene *scene, FILE *file) {
const SceneStages *s = &scene->stages;
for (const Asked *c = scene->change; c && c->entry; c++) {
const Change *change = (const Change *)c->entry;
if (!change->stage) {
fprintf(file, "change\t%s\n", c->entry->name);
continue;
}
fprintf(file, "shake\t%s", c->entry->name);
if (change->plan)
change->plan(c->own, file);
if (s->every > 0)
fprintf(file, ", %d after every %g collisions a particle", s->each,
s->every);
fprintf(file, ", %d after that", s->sweeps);
if (s->samples > 1)
fprintf(file, ", %d samples %d apart", s->samples, s->apart);
fprintf(file, "\n");
}
}
static Pack numbers_of(const Scene *scene) {
Pack pack = {
.box = ask_box(scene), .kinds = scene->kinds, .species = scene->species};
for (int s = 0; s < scene->kinds; s++)
pack.n += scene->species[s].count;
return pack;
}
static void tell_measures(const Scene *scene, FILE *file) {
fprintf(file, "measure\t");
for (const Asked *m = scene->measure; m && m->entry; m++) {
const Measure *measure = (const Measure *)m->entry;
double pairs = 0;
if (measure->pairs && scene->make.entry && !(scene->facts & FACT_FINITE)) {
Pack pack = numbers_of(scene);
pairs = measure->pairs(m->own, &pack);
}
fprintf(file, " %s", m->entry->name);
if (measure->reach)
fprintf(file, " (R < %g", measure->reach(m->own));
if (pairs > 0)
fprintf(file, ", about %.3g pairs", pairs);
if (measure->reach)
fprintf(file, ")");
}
fprintf(file, "\n");
}
static void tell_files(const Scene *scene, FILE *file) {
Ensemble one =
run_ensemble(scene, scene->facts, scene->species, scene->kinds);
bool stage = false;
for (const Asked *c = scene->change; c && c->entry; c++)
stage |= ((const Change *)c->entry)->stage;
fprintf(file, "write\t%s",
scene != scene->first ? ""
: scene->keys ? " summary.tsv sweep.tsv"
: " summary.tsv");
tables_plan(&one, file);
if (scene->save && stage)
fprintf(file, " made.pack-K%s.xyz", scene->suffix);
if (scene->save)
fprintf(file, " pack-K%s.xyz", scene->suffix);
if (scene->save && scene->cube > 0)
fprintf(file, " cube-K%s.xyz", scene->suffix);
fprintf(file, "\n");
run_forget(&one);
}
static void plan_one(const Scene *scene, FILE *file) {
if (scene->keys)
fprintf(file, "sweep\t");
for (int i = 0; i < scene->keys; i++)
fprintf(file, " %s=%s", scene->swept[i].key, scene->swept[i].value);
if (scene->keys)
fprintf(file, "\n");
if (scene->make.entry)
tell_made(scene, file);
tell_changes(scene, file);
tell_measures(scene, file);
tell_files(scene, file);
}
int plan_scene(const Scene *scene, FILE *file, Outcome *out) {
const char *used[HEADER_MODULES];
char print[17];
fprintf(file, "scene\t%s\n", scene->path);
for (const Scene *s = scene; s; s = s->next)
plan_one(s, file);
header_modules(scene, used);
fprintf(file, "modules\t");
for (int i = 0; used[i]; i++)
fprintf(file, " %s", used[i]);
table_fingerprint(used, print);
fprintf(file, "\nfingerprint\t%s\n", print);
return out->status;
}
