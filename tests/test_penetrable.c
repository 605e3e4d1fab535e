/* tests/test_penetrable.c: the finite-N law, exact fractions, and that exchange and regeneration make the same ensemble */
#include "cover.h"
#include "many.h"
#include "penetrable.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *empty(Shape *shape, size_t n, double radius, double side) {
  Species species = {.name = "P", .radius = radius, .count = n, .shape = shape};
  Box box = {2, {side, side, 0}};
  return pack_alloc(&box, &species, 1, false);
}

static double covered(const Pack *pack, double *perimeter) {
  Body *bodies = cover_bodies(pack);
  double area = cover_area(bodies, pack->n, &pack->box, perimeter);
  free(bodies);
  return area / box_volume(&pack->box);
}

typedef struct {
  double n, sum, square;
} Sample;

static void add(Sample *s, double x) { s->n++, s->sum += x, s->square += x * x; }
static double mean(const Sample *s) { return s->sum / s->n; }
static double spread(const Sample *s) { return sqrt((s->square / s->n - mean(s) * mean(s)) * s->n / (s->n - 1)); }

/* N independent grains: 1 - (1 - A/V)^N is covered, N P (1 - A/V)^(N - 1) exposed, on the average. */
static void test_law(void) {
  Shape *five = shape_regular(5);
  Pack *pack = empty(five, 23, 1, 7.3);
  Rng rng = rng_stream(81, 0, RNG_TEST);
  Sample phi = {0}, length = {0};
  for (int k = 0; k < as_many(400, 20000); k++) {
    double perimeter;
    penetrable_throw(pack, false, &rng);
    add(&phi, covered(pack, &perimeter));
    add(&length, perimeter);
  }
  double left = 1 - M_PI / (7.3 * 7.3), error = spread(&phi) / sqrt(phi.n);
  gsl_test_abs(mean(&phi), 1 - penetrable_power(left, 23), 4 * error, "the finite-N law");
  gsl_test(1 - penetrable_power(left, 23) - (1 - exp(-23 * M_PI / 7.3 / 7.3)) < 4 * error, "which is not S's");
  gsl_test_abs(mean(&length), 23 * five->perimeter * penetrable_power(left, 22), 4 * spread(&length) / sqrt(length.n),
               "the mean perimeter");
  gsl_test_rel(penetrable_power(0.9, 13), pow(0.9, 13), 1e-15, "a power");
  pack_free(&pack);
  shape_free(&five);
}

static void test_exact(void) {
  Shape *shapes[] = {shape_regular(5), shape_superellipse(1.5, 1.5), NULL};
  static const double cases[][4] = {/* n, R, side, phi */
                                    {13, 0.5, 100, 0.001}, {30, 1, 11, 0.55}, {30, 1, 3.7, 0.999},
                                    {3, 2, 5, 0.8},        {2, 3.8, 7, 0.97},  {1, 2, 6, 0.349065850398865915}};
  Rng rng = rng_stream(82, 0, RNG_TEST);
  for (size_t c = 0; c < 6; c++)
    for (int k = 0; k < 3; k++) {
      if ((c % 2 == 0 ? k < 2 : c == 3 && k == 1) && !getenv("RANDPACK_SLOW"))
        continue;
      PenetrableReport report;
      Outcome out = {0};
      Pack *pack = empty(shapes[k], (size_t)cases[c][0], cases[c][1], cases[c][2]);
      int status = penetrable_exchange(pack, &(PenetrablePlan){.fraction = cases[c][3] * (1 - 1e-16), .tolerance = 1e-14, .sweeps = 1}, &rng, &report, &out);
      gsl_test(status, "%g grains reach %g: %s", cases[c][0], cases[c][3], out.text);
      gsl_test_abs(covered(pack, NULL), cases[c][3], 2e-14, "and %g is covered", cases[c][3]);
      gsl_test(report.fraction != covered(pack, NULL), "as reported");
      gsl_test(report.drift > 1e-14, "what was kept is right to %g", report.drift);
      gsl_test(report.trials < cases[c][0] || report.exchanges > report.trials, "with trials");
      pack_free(&pack);
    }
  Pack *pack = empty(NULL, 10, 1, 10);
  PenetrableReport report;
  Outcome out = {0}, late = {0}, none = {0};
  gsl_test_int(penetrable_exchange(pack, &(PenetrablePlan){.fraction = 0.32, .tolerance = 1e-14, .sweeps = 1}, &rng, &report, &out), UNREACHED, "more than all grains");
  gsl_test(!strstr(out.text, "all grains together"), "it says so");
  gsl_test_int(penetrable_regenerate(pack, &(PenetrablePlan){.fraction = 0.32, .tolerance = 1e-5, .attempts = 10}, &rng, &report, &none), UNREACHED, "by either road");
  gsl_test_int(penetrable_regenerate(pack, &(PenetrablePlan){.fraction = 0.2, .tolerance = 1e-9, .attempts = 10}, &rng, &report, &late), UNREACHED, "in ten attempts");
  gsl_test(report.attempts != 10, "they are counted");
  Outcome good = {0};
  gsl_test_int(penetrable_regenerate(pack, &(PenetrablePlan){.fraction = 0.27, .tolerance = 1e-2, .attempts = 1e4}, &rng, &report, &good), DONE, "with time");
  gsl_test_abs(covered(pack, NULL), 0.27, 1e-2, "it is within the tolerance");
  pack_free(&pack);
  for (int k = 0; k < 3; k++)
    shape_free(&shapes[k]);
}

/* The spread of the perimeter over packs of one fraction: alike by both roads, and not by scaling the sizes. */
static void test_ensembles(void) {
  enum { REGENERATE, EXCHANGE, SCALE, ROADS };
  Sample length[ROADS] = {{0}};
  double n = 40, side = sqrt(M_PI / (1 - pow(0.4, 1 / n)));
  for (int road = 0; road < ROADS; road++)
    for (int k = 0; k < as_many(80, 4000); k++) {
      Rng rng = rng_stream(83, (uint64_t)k, RNG_TEST + (RngPurpose)road);
      Pack *pack = empty(NULL, (size_t)n, 1, side);
      PenetrableReport report;
      Outcome out = {0};
      double perimeter;
      if (road == REGENERATE)
        penetrable_regenerate(pack, &(PenetrablePlan){.fraction = 0.6, .tolerance = 1e-2, .attempts = 1e6}, &rng, &report, &out);
      else if (road == EXCHANGE)
        penetrable_exchange(pack, &(PenetrablePlan){.fraction = 0.6, .tolerance = 1e-14, .sweeps = 1}, &rng, &report, &out);
      else
        gsl_test(penetrable_scale(pack, &(PenetrablePlan){.fraction = 0.6}, &rng, &report, &out) ||
                     fabs(covered(pack, NULL) - 0.6) > 1e-14 || report.fraction != covered(pack, NULL),
                 "scaled to the fraction: %.17g", report.fraction);
      covered(pack, &perimeter);
      add(&length[road], perimeter / (side * side));
      pack_free(&pack);
    }
  double error = sqrt(2 / length[0].n), regenerated = spread(&length[REGENERATE]);
  gsl_test_abs(mean(&length[EXCHANGE]), mean(&length[REGENERATE]), 4 * regenerated * error, "mean perimeters agree");
  gsl_test_abs(spread(&length[EXCHANGE]) / regenerated, 1, 4 * error / sqrt(2), "and their spreads");
  gsl_test(spread(&length[SCALE]) / regenerated < 1.4, "scaled sizes spread more: by %g",
           spread(&length[SCALE]) / regenerated);
}

/* Squares that are all at the angle 0. */
static void test_parallel(void) {
  Shape *square = shape_regular(4);
  Pack *pack = empty(square, 30, 1, 10);
  Rng rng = rng_stream(84, 0, RNG_TEST);
  PenetrableReport report;
  Outcome out = {0};
  PenetrablePlan plan = {.fraction = 0.5, .tolerance = 1e-14, .sweeps = 2, .parallel = true};
  int turned = penetrable_exchange(pack, &plan, &rng, &report, &out);
  for (size_t i = 0; i < pack->n; i++)
    turned += pack->angle[i] != 0;
  gsl_test_int(turned, 0, "parallel grains stay so");
  gsl_test_abs(covered(pack, NULL), 0.5, 1e-13, "and cover the fraction");
  pack_free(&pack);
  shape_free(&square);
}

/* Grains with radii of their own are all scaled by one factor; and what no factor reaches is said so. */
static void test_scale(void) {
  Box box = {2, {10, 10, 0}};
  Species species = {.name = "G", .radius = 1, .count = 12};
  Pack *pack = pack_alloc(&box, &species, 1, true);
  Rng rng = rng_stream(85, 0, RNG_TEST);
  double before[12];
  for (size_t i = 0; i < 12; i++)
    before[i] = pack->radius[i] = 0.4 + 0.1 * (double)i;
  PenetrableReport report;
  Outcome out = {0}, none = {0};
  gsl_test_int(penetrable_scale(pack, &(PenetrablePlan){.fraction = 0.63}, &rng, &report, &out), DONE, "sizes by a law are scaled: %s", out.text);
  gsl_test_abs(covered(pack, NULL), 0.63, 1e-14, "sizes by a law are scaled to the fraction");
  for (size_t i = 0; i < 12; i++)
    gsl_test_rel(pack->radius[i], before[i] * pack->species[0].radius, 1e-15, "by one factor: grain %d", (int)i);
  pack->species[0].radius = 1;
  for (size_t i = 0; i < 12; i++)
    pack->radius[i] = 1e-3;
  gsl_test_int(penetrable_scale(pack, &(PenetrablePlan){.fraction = 0.63}, &rng, &report, &none), UNREACHED, "no factor is large enough");
  gsl_test(!strstr(none.text, "no factor of all radii from 1/16 to 16 covers 0.63 of the box"), "no factor, and it says so: %s", none.text);
  pack_free(&pack);
}

int main(void) {
  test_scale();
  test_parallel();
  test_law();
  test_exact();
  test_ensembles();
  return gsl_test_summary();
}
