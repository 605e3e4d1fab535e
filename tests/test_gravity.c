/* Packs by gravity: known answers, overlaps, fractions of cores. */
#include "cells.h"
#include "gravity.h"
#include "outcome.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *make(int dim, size_t n, double a, GravityPlan plan, uint64_t seed,
                  GravityReport *report) {
  Species species = {"A", a, n};
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = gravity_pack(dim, &species, 1, NULL, &plan, &rng, report, &out);
  gsl_test(out.status != DONE, "%zu particles, %d-D, are packed: %s", n, dim,
           out.text);
  return pack;
}

static const GravityPlan adaptive = {.mode = GRAVITY_ADAPTIVE};

/* One in the middle; two that touch; three that touch. */
static void few(int dim) {
  GravityReport report;
  Pack *pack = make(dim, 1, 2.5, adaptive, 1, &report);
  gsl_test_rel(gravity_rim(pack), 2.5, 1e-15, "one: the rim");
  gsl_test_rel(pack->box.side[dim - 1], 10, 1e-15, "one: the box");
  gsl_test_rel(pack->x[0], 5, 1e-15, "one: in the middle");
  gsl_test_rel(gravity_fraction(pack, 2.5), 1, 1e-15, "one: fills its ball");
  gsl_test_rel(gravity_fraction(pack, 1.25), 1, 1e-15,
               "one: and what is within");
  gsl_test_rel(gravity_fraction(pack, 5), dim == 2 ? 0.25 : 0.125, 1e-15,
               "one: and a part of more");
  pack_free(&pack);
  pack = make(dim, 2, 2.5, adaptive, 1, &report);
  gsl_test_abs(pack_audit(pack), 0, 1e-14, "two touch");
  gsl_test_rel(report.rim, 7.5, 1e-14, "two: the rim");
  pack_free(&pack);
  pack = make(dim, 3, 2.5, adaptive, 1, &report);
  gsl_test_abs(pack_audit(pack), 0, 1e-8, "three touch");
  pack_free(&pack);
}

/* A ball of radius 1 at the distance x in the ball of radius R, by quadrature
   over slices; and the profile of shells adds up. */
static void lenses(int dim) {
  double side = 40, at[] = {1.7, 2.9, 3.3};
  Species species = {"A", 1, 1};
  Box box = {dim, {side, side, dim == 3 ? side : 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int c = 0; c < 3; c++) {
    double R = c == 2 ? 2.6 : 2.2, x = c == 2 ? 3.3 : at[c], sum = 0;
    enum { SLICES = 100000 };
    for (int k = 0; k < dim; k++)
      pack->x[k] = side / 2;
    pack->x[1] -= x;
    for (int s = 0; s < SLICES; s++) { /* across the line of centres */
      double z = x - 1 + (s + 0.5) * 2 / SLICES;
      double p = GSL_MAX(R * R - z * z, 0), q = 1 - (z - x) * (z - x);
      double least = GSL_MIN(p, q);
      sum += (dim == 2 ? 2 * sqrt(least) : M_PI * least) * 2 / SLICES;
    }
    double radius[] = {R / 2, R, 2 * R}, shell[3];
    gsl_test_rel(gravity_fraction(pack, R) * pack_ball(dim, R), sum, 1e-6,
                 "lens, %d-D, %d", dim, c);
    gravity_profile(pack, 3, radius, shell);
    double inner = gravity_fraction(pack, R / 2) * pack_ball(dim, R / 2);
    inner += shell[1] * (pack_ball(dim, R) - pack_ball(dim, R / 2));
    gsl_test_rel(inner, sum, 1e-6, "shells add up");
  }
  pack_free(&pack);
}

static void rests(int dim, double low, double high) {
  enum { PACKS = 4 };
  double sum = 0, square = 0;
  for (uint64_t seed = 1; seed <= PACKS; seed++) {
    GravityReport report;
    Pack *pack = make(dim, 2000, 0.7, adaptive, seed, &report);
    double gap = seed == 1 ? pack_audit(pack) : cells_least_gap(pack);
    gsl_test(!(gap > -1.4e-9), "%d-D: no deeper overlap than told (%g)", dim,
             gap);
    gsl_test(!(report.overlap < 1e-9), "%d-D: and the report agrees (%g)", dim,
             report.overlap);
    double phi = gravity_fraction(pack, 0.5 * gravity_rim(pack));
    sum += phi / PACKS;
    square += phi * phi / PACKS;
    pack_free(&pack);
  }
  double error = sqrt((square - sum * sum) / (PACKS - 1));
  gsl_test(!(sum - 3 * error > low && sum + 3 * error < high && error < 0.01),
           "%d-D: core fraction %.4f (%.4f)", dim, sum, error);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    few(dim);
    lenses(dim);
  }
  rests(2, 0.8, 0.88);
  rests(3, 0.58, 0.63);
  return gsl_test_summary();
}
