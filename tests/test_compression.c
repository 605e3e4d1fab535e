/* tests/test_compression.c: growth of shapes to an exact fraction, or not */
#include "compression.h"
#include "many.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *what;
  size_t n[3]; /* pentagons, superellipses, discs */
  double fraction;
  int each;
} Case;

static Pack *empty(const Case *c) {
  static const double ones[] = {1, 1};
  Shape *pentagon = shape_regular(5), *egg = shape_superellipse(1.5, 1.5);
  Species s[3] = {{.name = "P", .radius = 1, .count = c->n[0], .shape = pentagon},
                  {.name = "E", .radius = 1.2, .count = c->n[1], .shape = egg},
                  {.name = "D", .radius = .8, .count = c->n[2]}};
  double solid = 0;
  for (int k = 0; k < 3; k++)
    solid += (double)s[k].count * pack_ball(2, s[k].radius);
  Box box = box_make(2, ones, solid / c->fraction);
  Pack *pack = pack_alloc(&box, s, 3, false);
  shape_free(&pentagon);
  shape_free(&egg);
  return pack;
}

static void test_reached(void) {
  static const Case cases[] = {{"pentagons", {80, 0, 0}, .7, 1},
                               {"pentagons, five sweeps a step", {60, 0, 0}, .7, 5},
                               {"three kinds", {12, 12, 12}, .65, 1},
                               {"sparse", {20, 20, 20}, .25, 1},
                               {"one pentagon", {1, 0, 0}, .6, 1},
                               {"nothing", {0, 0, 1}, .7, 1}};
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
    Pack *pack = empty(cases + c), *twin = empty(cases + c);
    double phi = pack_fraction(pack);
    CompressionPlan plan = {.3, cases[c].each, 1e5};
    CompressionReport report, same;
    Outcome out = {0};
    Rng rng = rng_stream(51, c, RNG_TEST), again = rng;
    gsl_test(compression_grow(pack, &plan, &rng, &report, &out), "%s: %s", cases[c].what, out.text);
    gsl_test(pack_fraction(pack) != phi || report.fraction != phi || fabs(phi - cases[c].fraction) > 1e-14,
             "%s: exactly %g", cases[c].what, cases[c].fraction);
    gsl_test(!(touch_least_gap(pack) > 0), "%s: nothing overlaps: %g", cases[c].what, touch_least_gap(pack));
    gsl_test(report.trials != report.sweeps * (double)pack->n || fmod(report.sweeps, cases[c].each) != 0 ||
                 (report.sweeps > 0) != (phi > .3),
             "%s: %g sweeps, %g trials", cases[c].what, report.sweeps, report.trials);
    compression_grow(twin, &plan, &again, &same, &out);
    gsl_test(memcmp(pack->x, twin->x, 2 * pack->n * sizeof(double)) ||
                 memcmp(pack->angle, twin->angle, pack->n * sizeof(double)) || same.trials != report.trials,
             "%s: and again the same", cases[c].what);
    pack_free(&pack);
    pack_free(&twin);
  }
}

/* What was reached is said, and holds: bodies of that size do not overlap. Steps have adapted to be accepted. */
static void test_unreached(void) {
  static const Case dense = {"pentagons", {40, 0, 0}, .95, 1};
  Pack *pack = empty(&dense);
  CompressionPlan plan = {.3, 1, as_many(1500, 20000)};
  CompressionReport report;
  Outcome out = {0};
  Rng rng = rng_stream(52, 0, RNG_TEST);
  int status = compression_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status != UNREACHED || !strstr(out.text, "reached a fraction of 0."), "too dense: %s", out.text);
  gsl_test(!(report.fraction > .6 && report.fraction < .9), "reached %g", report.fraction);
  gsl_test(fabs(report.moved / report.trials - .3) > .1, "accepted: %.3g", report.moved / report.trials);
  pack->species[0].radius *= sqrt(report.fraction / pack_fraction(pack));
  gsl_test(!(touch_least_gap(pack) > 0), "that is apart: %g", touch_least_gap(pack));
  pack->species[0].radius *= 1.05;
  gsl_test(!(touch_least_gap(pack) < 0), "and not much larger");
  pack_free(&pack);
  static const Case start = {"pentagons", {40, 0, 0}, .9, 1};
  pack = empty(&start);
  plan.start = .75;
  Outcome why = {0};
  gsl_test(compression_grow(pack, &plan, &rng, &report, &why) != UNREACHED || report.sweeps != 0 ||
               !strstr(why.text, "attempts placed"),
           "a start that is too dense: %s", why.text);
  pack_free(&pack);
}

int main(void) {
  test_reached();
  test_unreached();
  return gsl_test_summary();
}
