/* tests/test_scene.c: defaults, settings, shares that become numbers, whole numbers of any length */
#include "ask.h"
#include "lattice.h"
#include "read.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_scene.XXXXXX";
static const char plain[] = "dimension = 3;\nspecies = ( { radius = 1.5; number = 700; } );\nfraction = 0.31;\n"
                            "make = { method = \"rsa\"; };\nmeasure = { rdf = {}; contact = {}; };\n";

static Scene *read_text(const char *text, const char *const set[], int sets, Outcome *out) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
  *out = (Outcome){0};
  return read_scene(path, set, sets, out);
}

/* The value of a key of a measure, or of the maker (what = "make"). */
static double value(const Scene *s, const char *what, const char *key) {
  const Asked *asked = strcmp(what, "make") == 0 ? &s->make : scene_asked(s->measure, what);
  return asked && asked->entry ? entry_value(asked, key) : GSL_NAN;
}

static int line_of(const Scene *s, const char *measure) {
  const Asked *asked = scene_asked(s->measure, measure);
  return asked ? asked->line : 0;
}

/* The scene of this text, which must be right. */
static Scene *scene(const char *text) {
  Outcome out;
  Scene *s = read_text(text, NULL, 0, &out);
  gsl_test(!s, "is read: %.60s (%s)", text, out.text);
  if (!s)
    exit(1);
  return s;
}

static void test_defaults(void) {
  Scene *s = scene(plain);
  gsl_test(s->dimension != 3 || s->seed != 1 || s->realizations != 1 || s->gap != 0 || s->save, "the defaults of a scene");
  gsl_test(value(s, "rdf", "step") != 0.02 || value(s, "rdf", "reach") != 6 || value(s, "rdf", "estimator") != 0, "of g(r)");
  gsl_test(value(s, "contact", "step") != 0.01 || value(s, "make", "order") != 0, "of contact and make");
  gsl_test_int(line_of(s, "rdf"), 5, "a group knows its line");
  gsl_test(line_of(s, "K") || line_of(s, "order") || s->theory.line, "what is absent has line 0");
  gsl_test_str(s->species[0].name, "1", "a species without a name has its number");
  Box box = ask_box(s);
  gsl_test_rel(700 * 4 * M_PI / 3 * 1.5 * 1.5 * 1.5 / box_volume(&box), 0.31, 1e-14, "the box follows from the fraction");
  gsl_test(box.side[0] != box.side[2], "and is a cube");
  scene_free(&s);
  scene_free(&s);
  gsl_test(s != NULL, "freed is NULL, and may be freed again");
}

/* Shapes of each kind; what does not depend on them, and what does. */
static void test_shapes(void) {
  static const char shaped[] =
      "species = ( { name = \"P\"; radius = 2.5; volume = 3; shape = { kind = \"polygon\"; sides = 5; }; },\n"
      "  { name = \"Q\"; radius = 1.5; volume = 1; shape = { kind = \"polygon\"; vertices = ([9, 1], (9, 4), [7.5, 1.0]); }; },\n"
      "  { name = \"D\"; radius = 2.0; volume = 1; },\n"
      "  { name = \"S\"; volume = 1; sizes = { law = \"power\"; exponent = 0.5; least = 1.0; most = 2.0; };\n"
      "    shape = { kind = \"superellipse\"; aspect = 1.5; m = 1.25; }; } );\n"
      "number = 500; fraction = 0.3; make = { method = \"points\"; }; dimension = 2;";
  Scene *s = scene(shaped);
  const Shape *P = s->species[0].shape, *Q = s->species[1].shape, *S = s->species[3].shape;
  gsl_test(!P || P->sides != 5 || !(fabs(P->y[0]) < 1e-15) || !(P->x[0] > 1), "a pentagon with a vertex on the x-axis");
  gsl_test(!Q || Q->sides != 3 || !(fabs(Q->x[0] - Q->x[1]) < 1e-15) || !(Q->x[2] < Q->x[0]), "a triangle as it was given");
  gsl_test(!S || S->sides || fabs(S->a / S->b - 1.5) > 1e-15 || S->m != 1.25, "a superellipse with its axis a along x");
  gsl_test(s->species[2].shape || s->facts & FACT_BALLS || scene_shaped(s) != true, "discs among them");
  Scene *discs = scene("dimension = 2; species = ( { radius = 2.5; volume = 3; }, { radius = 1.5; volume = 1; },\n"
                       "  { radius = 2.0; volume = 1; }, { volume = 1; sizes = { law = \"power\"; exponent = 0.5; least = 1.0; most = 2.0; }; } );\n"
                       "number = 500; fraction = 0.3; make = { method = \"points\"; };");
  Box box = ask_box(s), same = ask_box(discs);
  gsl_test(!(discs->facts & FACT_BALLS) || scene_shaped(discs), "discs have no shape");
  gsl_test(box.side[0] != same.side[0] || s->species[1].count != discs->species[1].count, "areas, so shares and box, are those of discs");
  scene_free(&discs);
  scene_free(&s);
  static const char *const set[] = {"make.method=lattice", "species={shape}", "species.[0].shape.m=1e3"};
  Outcome out;
  s = read_text("dimension = 2; species = ( { radius = 2.0; number = 9; shape = { kind = \"superellipse\"; aspect = 0.5; m = 1; }; } );\n"
                "fraction = 0.3; make = { method = \"points\"; }; sweep = ( { key = \"species.[0].shape.m\"; values = [0.5, 2.0]; } );",
                NULL, 0, &out);
  gsl_test(!s || s->species[0].shape->m != 0.5 || s->next->species[0].shape->m != 2, "a sweep of m (%s)", out.text);
  gsl_test(!s || s->contact != 0, "points that overlap have no contact");
  scene_free(&s);
  for (int k = 0; k < 3; k++)
    gsl_test(read_text(shaped, &set[k], 1, &out) != NULL, "refused: %s (%s)", set[k], out.text);
  s = read_text("dimension = 2; species = ( { radius = 2.0; number = 9; }, { radius = 2.5; number = 9; shape = { kind = \"polygon\"; sides = 3; }; } );"
                "measure = { rdf = { peaks = [1.945, 2.1]; }; };", NULL, 0, &out);
  gsl_test(!s || fabs(s->contact - 2.5 * sqrt(M_PI / (3 * sqrt(3)))) > 1e-14, "of shapes, twice the radius of the smallest disc inside (%s)", out.text);
  scene_free(&s);
}

static void test_boxes(void) {
  Scene *s = scene("dimension = 2; box = [3.0, 0.75]; side = 40.0; fraction = \"max\";\n"
                   "species = ( { radius = 1.0; } ); make = { method = \"rsa\"; };");
  Box box = ask_box(s);
  gsl_test_rel(box.side[0], 40, 1e-14, "the side of a saturated box");
  gsl_test_rel(box.side[1], 10, 1e-14, "and its second");
  gsl_test_rel(s->share[0], 1, 1e-15, "one species has all attempts");
  scene_free(&s);
  s = scene("dimension = 3; fraction = 0.2; species = ( { radius = 0.5; } );\n"
            "make = { method = \"lattice\"; lattice = \"bcc\"; n_l = 2; };");
  box = ask_box(s);
  gsl_test_int((int)s->species[0].count, 250, "a lattice knows its number");
  gsl_test_rel(250 * M_PI / 6 / box_volume(&box), 0.2, 1e-14, "and is opened to its fraction");
  gsl_test_int((int)value(s, "make", "lattice"), LATTICE_BCC, "its words are those of the lattices");
  scene_free(&s);
}

/* The counts of a scene whose species are these, and what they must be. */
static void counts(const char *species, int number, int dim, const double want[], int kinds, const char *what) {
  char text[1024];
  snprintf(text, sizeof text,
           "dimension = %d; number = %d; fraction = 0.1; species = ( %s ); make = { method = \"rsa\"; };", dim, number,
           species);
  Scene *s = scene(text);
  double sum = 0, total = 0;
  for (int k = 0; k < kinds; k++)
    sum += want[k];
  for (int k = 0; k < kinds; k++) {
    total += (double)s->species[k].count;
    gsl_test(!(fabs((double)s->species[k].count - number * want[k] / sum) < 1), "%s: species %d has %d of %.3f", what, k,
             (int)s->species[k].count, number * want[k] / sum);
  }
  gsl_test_int((int)total, number, "%s: their sum", what);
  scene_free(&s);
}

static void test_shares(void) {
  static const double number[] = {0.2, 0.3, 1.7};
  counts("{ radius = 2.0; share = 0.2; }, { radius = 1.0; share = 0.3; }, { radius = 0.5; share = 1.7; }", 1237, 3, number,
         3, "shares of the number");
  const double spheres[] = {0.6 / gsl_pow_3(2.1), 0.4 / gsl_pow_3(0.7)}, discs[] = {0.6 / 4.41, 0.4 / 0.49};
  static const char volume[] = "{ radius = 2.1; volume = 0.6; }, { radius = 0.7; volume = 0.4; }";
  counts(volume, 1999, 3, spheres, 2, "shares of the volume of spheres");
  counts(volume, 1999, 2, discs, 2, "shares of the area of discs");
  const double mass[] = {0.8 / 1.95 / gsl_pow_3(1.2), 0.2 / 2.7 / gsl_pow_3(0.35)};
  counts("{ radius = 1.2; mass = 0.8; density = 1.95; }, { radius = 0.35; mass = 0.2; density = 2.7; }", 4001, 3, mass, 2,
         "shares of the mass");
  static const double third[] = {1, 1, 1};
  counts("{ radius = 1.0; share = 1; }, { radius = 2.0; share = 1; }, { radius = 3.0; share = 1; }", 100, 3, third, 3,
         "thirds of a hundred");
}

static void test_settings(void) {
  static const char *const set[] = {"measure.rdf.step=0.05", "seed=9007199254740991", "species.[0].number=1300",
                                    "make.order=large first", "measure.K={reach=2.5;}", "save=true",
                                    "measure.rdf.step=0.125"};
  Outcome out;
  Scene *s = read_text(plain, set, 7, &out);
  gsl_test(!s, "settings are read (%s)", out.text);
  if (!s)
    return;
  gsl_test(value(s, "rdf", "step") != 0.125, "the last of two settings holds");
  gsl_test(s->seed != 9007199254740991, "a long seed");
  gsl_test_int((int)s->species[0].count, 1300, "an element of a list");
  gsl_test_int((int)value(s, "make", "order"), 1, "a word without quotes");
  gsl_test(line_of(s, "K") != -1 || value(s, "K", "reach") != 2.5 || value(s, "K", "step") != 0.02, "a new group, with defaults");
  gsl_test(!s->save || value(s, "rdf", "reach") != 6, "the others stay");
  scene_free(&s);
}

/* libconfig by itself keeps the low 32 bits of such numbers. */
static void test_long_numbers(void) {
  static const struct {
    const char *text;
    int64_t seed;
  } seeds[] = {{"2147483647", 2147483647},   {"2147483648", 2147483648},   {"4294967297", 4294967297},
               {"4294967297L", 4294967297},  {"9007199254740992", 9007199254740992},
               {"0x1fffffffffff", 0x1fffffffffff}, {"0x7B", 123}};
  char text[1024];
  Outcome out;
  for (size_t k = 0; k < sizeof seeds / sizeof *seeds; k++) {
    snprintf(text, sizeof text, "%sseed = %s;\n", plain, seeds[k].text);
    Scene *s = read_text(text, NULL, 0, &out);
    gsl_test(!s || s->seed != seeds[k].seed, "seed = %s is read to its last digit (%s)", seeds[k].text, out.text);
    scene_free(&s);
  }
  snprintf(text, sizeof text, "%s/* 12345678901234 */ # 12345678901234\n// \"12345678901234\n"
           "gap = 0.12345678901234e-1;\n", plain);
  Scene *s = scene(text);
  gsl_test(s->gap != 0.12345678901234e-1, "reals and comments are left alone");
  scene_free(&s);
  s = scene("dimension = 3; species = ( { name = \"12345678901234\"; radius = 1.0; number = 7; } );\n"
            "fraction = 0.1; make = { method = \"points\"; };");
  gsl_test_str(s->species[0].name, "12345678901234", "strings are left alone");
  scene_free(&s);
  snprintf(text, sizeof text, "%sseed = 99999999999999999999999;\n", plain);
  gsl_test(read_text(text, NULL, 0, &out) || out.status != WRONG, "a number beyond 64 bits is refused");
  snprintf(text, sizeof text, "%sseed = 9007199254740994;\n", plain);
  gsl_test(read_text(text, NULL, 0, &out) || out.status != WRONG, "a seed beyond 2^53 is refused");
}

/* Whole and real numbers in one array, which a comment or a word does not make. */
static void test_mixed(void) {
  Outcome out;
  Scene *s = read_text("dimension = 3; species = ( { radius = 1; number = 50; } ); fraction = 0.2;\n"
                       "box = [1, /* ] 2.5 */ 2, 2.5e0]; make = { method = \"rsa\"; };\n", NULL, 0, &out);
  gsl_test(!s || s->box[0] != 1 || s->box[1] != 2 || s->box[2] != 2.5, "a mixed array is one of reals (%s)", out.text);
  scene_free(&s);
  s = read_text("dimension = 3; species = ( { radius = 1; number = 50; } ); fraction = 0.2; make = { method = \"rsa\"; };\n"
                "sweep = ( { key = \"seed\"; values = [12345678901, 7 /* 1.5 */]; } );\n", NULL, 0, &out);
  gsl_test(!s || s->seed != 12345678901 || s->next->seed != 7, "whole numbers stay whole (%s)", out.text);
  scene_free(&s);
  s = read_text("dimension = 2; species = ( { radius = 1; number = 5; } ); fraction = 0.2; make = { method = \"rsa\"; };\n"
                "sweep = ( { key = \"make.order\"; values = [\"random\", \"large first\"]; }, { key = \"fraction\"; values = [.1, 0.25]; } );\n", NULL, 0, &out);
  gsl_test(!s || s->fraction != 0.1 || s->next->fraction != 0.25, "words and reals (%s)", out.text);
  scene_free(&s);
}

static void test_fits(void) {
  Scene *s = scene(plain);
  Box box = {3, {24, 24.5, 23}};
  Outcome out = {0};
  Reader reader = {s, path, &out};
  Species one = {.radius = 1.5, .count = 1}, two = {.radius = 2, .count = 1};
  Query query = {.scene = s, .reader = &reader, .species = &one, .kinds = 1};
  gsl_test_int(ask_measures(&query, s->facts, &box), DONE, "a reach of 6 a fits into a box of 23 with a = 1.5");
  query.species = &two;
  gsl_test_int(ask_measures(&query, s->facts, &box), WRONG, "but not with a = 2");
  gsl_test(!strstr(out.text, "the largest reach here is 5.75"), "which is said: %s", out.text);
  scene_free(&s);
}

static void test_growth(void) {
  static const char *const set[] = {"make={method=\"crm\";}", "fraction=max"};
  Outcome out;
  Scene *s = read_text(plain, set, 1, &out);
  gsl_test(!s, "growth is read (%s)", out.text);
  if (!s)
    return;
  gsl_test(value(s, "make", "protocol") != 1 || value(s, "make", "mass") || s->mass, "isothermal, equal masses");
  gsl_test(value(s, "make", "growth") != 0.05 || value(s, "make", "interval") != 2 || value(s, "make", "pressure") != 0 ||
           value(s, "make", "budget") != 2e5 || value(s, "make", "rest"), "its numbers");
  scene_free(&s);
  s = read_text(plain, set, 2, &out);
  gsl_test(!s, "to jamming (%s)", out.text);
  if (!s)
    return;
  Box box = ask_box(s);
  gsl_test_rel(700 * 4 * M_PI / 3 * 1.5 * 1.5 * 1.5 / box_volume(&box), M_PI / sqrt(18), 1e-14, "its least box");
  scene_free(&s);
}

static void test_sweep(void) {
  static const char *const names[] = {"@large-first@0.1@true", "@large-first@0.1@false", "@large-first@0.25@true",
                                      "@large-first@0.25@false", "@random@0.1@true", "@random@0.1@false",
                                      "@random@0.25@true", "@random@0.25@false"};
  char text[1024];
  int c = 0;
  snprintf(text, sizeof text, "%ssweep = ( { key = \"make.order\"; values = (\"large first\", \"random\"); },\n"
           "{ key = \"fraction\"; values = [1e-1, 0.25]; }, { key = \"save\"; values = [true, false]; } );", plain);
  Scene *s = scene(text);
  for (const Scene *one = s; one && c < 8; one = one->next, c++) {
    gsl_test_str(one->suffix, names[c], "combination %d", c);
    gsl_test(one->first != s || one->keys != 3 || strcmp(one->swept[1].key, "fraction"), "knows its place");
    gsl_test(value(one, "make", "order") != (c < 4) || one->fraction != (c & 2 ? 0.25 : 0.1) || one->save != !(c & 1), "has its values");
    gsl_test(one->species[0].count != 700 || line_of(one, "rdf") != 5, "and the rest of the scene");
  }
  gsl_test_int(c, 8, "all combinations");
  scene_free(&s);
  s = scene(plain);
  gsl_test(s->keys || s->next || s->first != s || *s->suffix, "a scene without a sweep is one");
  scene_free(&s);
}

int main(void) {
  close(mkstemp(path));
  test_defaults();
  test_boxes();
  test_shapes();
  test_shares();
  test_settings();
  test_long_numbers();
  test_mixed();
  test_fits();
  test_growth();
  test_sweep();
  remove(path);
  return gsl_test_summary();
}
