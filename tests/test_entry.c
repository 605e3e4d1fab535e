/* tests/test_entry.c: makers keep their promises; every entry has words and an order of its own; pairs come as foretold */
#include "ask.h"
#include "entries.h"
#include "read.h"
#include "run.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_entry.XXXXXX";

static const struct {
  const char *maker, *text;
} scenes[] = {
    {"rsa", "fraction = 0.31; species = ( { radius = 1.5; number = 90; } ); make = { method = \"rsa\"; };"},
    {"rsa", "fraction = \"max\"; side = 11.0; species = ( { radius = 1.5; share = 1; }, { radius = 0.75; share = 2; } ); make = { method = \"rsa\"; };"},
    {"rsa", "fraction = 0.2; gap = 0.25; species = ( { radius = 1.0; number = 50; }, { radius = 2.0; number = 9; } ); make = { method = \"rsa\"; };"},
    {"crm", "fraction = 0.5; species = ( { radius = 1.5; number = 90; } ); make = { method = \"crm\"; growth = 0.1; };"},
    {"crm", "fraction = \"max\"; species = ( { radius = 1.0; number = 25; }, { radius = 1.7; number = 10; } ); make = { method = \"crm\"; growth = 0.5; pressure = 1e4; };"},
    {"lattice", "species = ( { radius = 1.5; } ); make = { method = \"lattice\"; lattice = \"bcc\"; n_l = 1; };"},
    {"points", "fraction = 0.4; species = ( { radius = 1.5; number = 90; } ); make = { method = \"points\"; };"},
    {"points", "dimension = 2; fraction = 0.4; species = ( { radius = 1.5; number = 90; shape = { kind = \"polygon\"; sides = 3; }; } ); make = { method = \"points\"; };"},
    {"gravity", "species = ( { radius = 1.0; number = 120; }, { radius = 2.5; number = 4; } ); make = { method = \"gravity\"; };"},
    {"gravity", "fraction = 0.3; dilute = {}; species = ( { radius = 1.0; number = 120; } ); make = { method = \"gravity\"; };"},
    {"sequential", "dimension = 2; fraction = 0.35; species = ( { radius = 1.5; number = 60; shape = { kind = \"polygon\"; sides = 5; }; }, { radius = 1.0; number = 20; } ); make = { method = \"sequential\"; };"},
    {"compression", "dimension = 2; fraction = 0.6; species = ( { radius = 1.5; number = 60; shape = { kind = \"polygon\"; sides = 5; }; }, { radius = 1.0; number = 20; } ); make = { method = \"compression\"; };"},
    {"relax", "dimension = 2; fraction = 0.75; species = ( { radius = 1.5; number = 60; shape = { kind = \"polygon\"; sides = 5; }; }, { radius = 1.0; number = 20; } ); make = { method = \"relax\"; };"},
    {"penetrable", "dimension = 2; fraction = 0.6; species = ( { radius = 1.5; number = 60; shape = { kind = \"polygon\"; sides = 5; }; }, { radius = 1.0; number = 20; } ); make = { method = \"penetrable\"; };"},
    {"homometric", "dimension = 2; fraction = 0.15; species = ( { radius = 1.5; number = 4; } ); make = { method = \"homometric\"; twin = \"second\"; };"},
};

static Scene *scene_of(const char *text) {
  Outcome out = {0};
  FILE *file = fopen(path, "w");
  if (!strstr(text, "dimension"))
    fputs("dimension = 3;", file);
  fputs("seed = 77;\n", file);
  fputs(text, file);
  fclose(file);
  Scene *scene = read_scene(path, NULL, 0, &out);
  gsl_test(!scene, "is read: %.60s (%s)", text, out.text);
  return scene;
}

/* What the scene's packs promise holds of one that is made. */
static void test_promises(size_t s) {
  Scene *scene = scene_of(scenes[s].text);
  if (!scene)
    return;
  const Maker *maker = (const Maker *)scene->make.entry;
  Ensemble one = run_ensemble(scene, scene->facts, scene->species, scene->kinds);
  Result result;
  result_begin(&result, &one.layout);
  Work work = {.scene = scene, .asked = &scene->make, .own = scene->make.own, .k = 3, .result = &result, .at = one.at[1]};
  Box box = ask_box(scene);
  Pack *pack = maker->make(&work, &box);
  gsl_test(!pack, "%s makes a pack of scene %d (%s)", scenes[s].maker, (int)s, result.out.text);
  unsigned facts = pack ? entry_facts(pack, touch_least_gap(pack)) : 0, kinds = FACT_PERIODIC | FACT_FINITE;
  gsl_test_str(maker->entry.name, scenes[s].maker, "the maker is found by its name");
  gsl_test_int((int)(facts & kinds), (int)(scene->facts & kinds), "%s: in a box or finite, as promised", scenes[s].maker);
  gsl_test((scene->facts & FACT_ONE_SIZE) != (facts & FACT_ONE_SIZE), "%s: of one size or several", scenes[s].maker);
  gsl_test((scene->facts & FACT_BALLS) != (facts & FACT_BALLS), "%s: of balls or of shapes", scenes[s].maker);
  gsl_test(pack && (scene->facts & FACT_HARD) && touch_least_gap(pack) < -2e-9 * pack_smallest(pack), "%s: no overlap",
           scenes[s].maker);
  pack_free(&pack);
  result_free(&result);
  run_forget(&one);
  scene_free(&scene);
}

/* Names are words, none comes twice in its list, and each entry says what it is. */
static void test_list(const Entry *const list[], const char *what) {
  for (const Entry *const *e = list; *e; e++) {
    gsl_test(entries_find(list, (*e)->name) != *e, "%s %s comes once", what, (*e)->name);
    gsl_test(!(*e)->what || strlen((*e)->what) < 4, "%s %s has a line for people", what, (*e)->name);
    for (const Key *key = (*e)->keys; key && key->name; key++) {
      bool inside = key->type == READ || key->at < (*e)->size;
      gsl_test(!key->right || !*key->right || !inside, "%s %s: key %s has its words and its place", what, (*e)->name, key->name);
    }
    for (const Told *t = (*e)->told; t && t->name; t++)
      gsl_test(!t->what, "%s %s: %s is explained", what, (*e)->name, t->name);
  }
}

/* A measure that foretells its pairs counts about as many. */
static void test_pairs(void) {
  static const char text[] =
      "fraction = 0.35; realizations = 1; species = ( { radius = 0.75; number = 1500; } ); make = { method = \"rsa\"; };\n"
      "measure = { rdf = { reach = 5.5; }; K = { reach = 5.25; }; I = { reach = 4.0; }; };";
  Scene *scene = scene_of(text);
  if (!scene)
    return;
  Ensemble one = run_ensemble(scene, scene->facts, scene->species, scene->kinds);
  const Maker *maker = (const Maker *)scene->make.entry;
  Result made;
  result_begin(&made, &one.layout);
  Work work = {.scene = scene, .asked = &scene->make, .own = scene->make.own, .result = &made, .at = one.at[1]};
  Box box = ask_box(scene);
  Pack *pack = maker->make(&work, &box);
  int foretold = 0;
  for (int m = 0; scene->measure[m].entry; m++) {
    const Measure *measure = (const Measure *)scene->measure[m].entry;
    Result result;
    result_begin(&result, &one.layout);
    Work own = {.scene = scene, .asked = &scene->measure[m], .own = scene->measure[m].own, .pack = pack, .facts = scene->facts,
                .a = 0.75, .result = &result, .at = one.at[2 + m]};
    measure->run(&own);
    double pairs = result.number[layout_find(&one.layout, "pairs")], about = measure->pairs(own.own, pack);
    foretold++;
    gsl_test(!(pairs > 0.8 * about && pairs < 1.25 * about), "%s: %g pairs, foretold %g", measure->entry.name, pairs, about);
    result_free(&result);
  }
  gsl_test_int(foretold, 3, "three measures foretell their pairs");
  pack_free(&pack);
  result_free(&made);
  run_forget(&one);
  scene_free(&scene);
}

int main(void) {
  close(mkstemp(path));
  for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++)
    test_promises(s);
  for (const Maker *const *m = entries_makers; *m; m++) {
    bool made = false;
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++)
      made |= strcmp(scenes[s].maker, (*m)->entry.name) == 0;
    gsl_test(!made, "%s is held to its promise", (*m)->entry.name);
  }
  test_list(ENTRIES(entries_makers), "maker");
  test_list(ENTRIES(entries_changes), "change");
  test_list(ENTRIES(entries_measures), "measure");
  test_list(ENTRIES(entries_curves), "curve");
  test_pairs();
  remove(path);
  return gsl_test_summary();
}
