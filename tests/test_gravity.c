/* Packs by gravity: known answers, overlaps, fractions of cores. */
#include "cells.h"
#include "core.h"
#include "gravity.h"
#include "outcome.h"
#include "ref_gravity.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
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
  gsl_test_rel(pack->open, 2.5, 1e-15, "one: the rim");
  gsl_test_rel(pack->box.side[dim - 1], 10, 1e-15, "one: the box");
  double x[3];
  gravity_places(pack, x);
  x[1] = 3;
  Pack *half = gravity_at(pack, x, 0.5);
  gsl_test(half->open != 4, "one: moved, it is finite still");
  pack_free(&half);
  gsl_test_rel(pack->x[0], 5, 1e-15, "one: in the middle");
  gsl_test_rel(core_fraction(pack, 2.5), 1, 1e-15, "one: fills its ball");
  gsl_test_rel(core_fraction(pack, 1.25), 1, 1e-15,
               "one: and what is within");
  gsl_test_rel(core_fraction(pack, 5), dim == 2 ? 0.25 : 0.125, 1e-15,
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
    double phi = core_fraction(pack, 0.5 * pack->open);
    sum += phi / PACKS;
    square += phi * phi / PACKS;
    pack_free(&pack);
  }
  double error = sqrt((square - sum * sum) / (PACKS - 1));
  gsl_test(!(sum - 3 * error > low && sum + 3 * error < high && error < 0.01),
           "%d-D: core fraction %.4f (%.4f)", dim, sum, error);
}

/* A literal run is that of all pairs, from the throw to the last pass; its
   steps, its largest c and its overlap are those of a second account. */
static void literal(int dim) {
  enum { N = 400 };
  const double F = 2.25, origin[3] = {0, 0, 0};
  double x[3 * N] = {0}, wrong = 0, deepest = 0;
  size_t pushes = 0, d = (size_t)dim;
  GravityReport report;
  Pack *pack =
      make(dim, N, 2.5, (GravityPlan){.mode = GRAVITY_LITERAL}, 7, &report);
  Rng rng = rng_stream(7, 0, RNG_TEST);
  double k_d = pack_ball(dim, 1),
         R = 2 / F * (dim == 2 ? sqrt(N / k_d) : cbrt(N / k_d));
  gsl_test_rel(report.start, 2.5 * R, 1e-14, "%d-D: R_0", dim);
  for (size_t i = 1; i < N; i++) {
    double square;
    do {
      square = 0;
      for (size_t k = 0; k < d; k++) {
        double u = 2 * rng_uniform(&rng) - 1;
        square += u * u;
        x[i * d + k] = u * (report.start / 2.5);
      }
    } while (square > 1);
  }
  for (int s = 0; s <= 31; s++)
    pushes += ref_gravity_sweep(dim, N, x, NULL,
                                s < 25 ? (1 + 0.05 * s) / F : 1, origin, 0);
  for (size_t i = 0; i < N * d; i++)
    wrong = GSL_MAX(wrong, fabs(x[i] * 2.5 + 2 * report.rim - pack->x[i]));
  gsl_test_abs(wrong, 0, 1e-13 * report.rim,
               "%d-D: a literal run is that of all pairs", dim);
  gsl_test(pushes != report.all.pushes, "and has its pushes");
  gsl_test(report.sweeps != 25 || report.passes != 6, "25 sweeps and 6 passes");
  deepest = -pack_audit(pack) / 5;
  gsl_test_rel(deepest > 0 ? deepest : 0, report.overlap, 1e-9, "overlap left");
  pack_free(&pack);
}

/* Any radii that grow together; two species; and the order is kept. */
static void mixed(int dim) {
  enum { N = 600 };
  Species species[] = {{"A", 0.5, 400}, {"B", 1.5, 200}};
  double radius[N];
  Rng rng = rng_stream(3, 0, RNG_TEST);
  for (size_t i = 0; i < N; i++)
    radius[i] = 0.3 * (1 + 4 * rng_uniform(&rng));
  for (int own = 0; own < 2; own++) {
    Outcome out = {0};
    GravityReport report;
    Pack *pack = gravity_pack(dim, species, 2, own ? radius : NULL, &adaptive,
                              &rng, &report, &out);
    gsl_test(out.status != DONE, "mixed, %d-D: %s", dim, out.text);
    gsl_test(!(pack_audit(pack) > -2e-9 * pack_smallest(pack)),
             "mixed: no deeper overlap");
    gsl_test(own && memcmp(radius, pack->radius, sizeof radius) != 0,
             "radii are those given");
    double solid = pack_solid(pack), R = 3 * report.start;
    gsl_test_rel(pack_ball(dim, R), solid * (dim == 2 ? 1 / M_PI_4 : 6 / M_PI),
                 1e-12, "%d-D: a mixture's R_0", dim);
    double phi = core_fraction(pack, 0.5 * report.rim);
    gsl_test(!(phi > (dim == 2 ? 0.74 : 0.5) && phi < (dim == 2 ? 0.9 : 0.72)),
             "mixed, %d-D: core %.4f", dim, phi);
    pack_free(&pack);
  }
}

static double from_middle(const Pack *pack, int kind) {
  double sum = 0, n = 0;
  for (size_t i = 0; i < pack->n; i++) {
    double square = 0;
    for (int k = 0; k < pack->box.dim; k++) {
      double d = pack->x[i * (size_t)pack->box.dim + (size_t)k] -
                 2 * pack->open;
      square += d * d;
    }
    if (pack_kind(pack, i) == kind) {
      sum += sqrt(square);
      n++;
    }
  }
  return sum / n / pack->open;
}

/* Grown together, the large are driven outwards and the small stay. */
static void apart(int dim) {
  Species species[] = {{"A", 1, 1200}, {"B", 3, dim == 2 ? 150 : 600}};
  Rng rng = rng_stream(8, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = gravity_pack(dim, species, 2, NULL, &adaptive, &rng, NULL, &out);
  double fine = from_middle(pack, 0), coarse = from_middle(pack, 1);
  gsl_test(!(coarse > fine + 0.1), "%d-D: the large are outside: %.3f, %.3f",
           dim, fine, coarse);
  pack_free(&pack);
}

/* Half a radius a sweep; a ratio of a hundred; far too many steps at once. */
static void hard(int dim) {
  GravityReport report;
  Pack *pack = make(dim, 4000, 1,
                    (GravityPlan){GRAVITY_LITERAL, .step = 0.5, .sweeps = 4}, 3,
                    &report);
  gsl_test(report.collapsed != (report.overlap > 0.5) ||
               !(report.overlap > 0.3),
           "%d-D: half a radius a sweep collapses (%.3g)", dim, report.overlap);
  gsl_test(!(report.carry > 2), "c is %.3g", report.carry);
  pack_free(&pack);
  pack = make(dim, 500, 1, (GravityPlan){GRAVITY_ADAPTIVE, .step = 50}, 3,
              &report);
  gsl_test(!(pack_audit(pack) > -2e-9) || report.collapsed,
           "at any step passes bring rest (%d)", report.passes);
  pack_free(&pack);
  Species species[] = {{"A", 0.01, 1500}, {"B", 1, 2}};
  Rng rng = rng_stream(8, 0, RNG_TEST);
  Outcome out = {0};
  pack = gravity_pack(dim, species, 2, NULL, &adaptive, &rng, &report, &out);
  gsl_test(out.status != DONE, "a ratio of 100: %s", out.text);
  gsl_test(!(pack_audit(pack) > -2e-11), "a ratio of 100: overlap %g",
           -pack_audit(pack));
  pack_free(&pack);
}

static void same_bytes(void) {
  GravityReport report[2];
  Pack *a = make(3, 500, 1, adaptive, 9, report),
       *b = make(3, 500, 1, adaptive, 9, report + 1);
  gsl_test(memcmp(a->x, b->x, 1500 * sizeof *a->x) != 0,
           "the same bytes again");
  pack_free(&b);
  b = make(3, 500, 1, adaptive, 10, report);
  gsl_test(memcmp(a->x, b->x, 1500 * sizeof *a->x) == 0,
           "and others of another seed");
  pack_free(&a);
  pack_free(&b);
}

/* The step is how far the rim goes: c as told, and more sweeps for a smaller. */
static void steps(void) {
  GravityReport fine, coarse;
  GravityPlan plan = {.mode = GRAVITY_ADAPTIVE, .step = 0.15};
  Pack *pack = make(3, 1000, 1, plan, 4, &fine);
  pack_free(&pack);
  plan.step = 0.45;
  pack = make(3, 1000, 1, plan, 4, &coarse);
  pack_free(&pack);
  gsl_test_rel(fine.carry, 0.15, 1e-12, "the rim goes as far as told");
  gsl_test_rel(coarse.carry, 0.45, 1e-12, "and farther");
  gsl_test_rel((double)fine.sweeps / coarse.sweeps, 3, 0.2,
               "in a third of the sweeps");
}

static void one_wrong(const char *what, size_t n, double a, GravityPlan plan,
                      int status) {
  Species species = {"A", a, n};
  Rng rng = rng_stream(1, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = gravity_pack(3, &species, 1, NULL, &plan, &rng, NULL, &out);
  gsl_test(out.status != status || !*out.text, "%s: %s", what, out.text);
  gsl_test((pack != NULL) != (status != WRONG), "%s: a pack or none", what);
  pack_free(&pack);
}

static void wrong(void) {
  one_wrong("nobody", 0, 1, adaptive, WRONG);
  one_wrong("no radius", 5, 0, adaptive, WRONG);
  one_wrong("radius no number", 5, GSL_NAN, adaptive, WRONG);
  one_wrong("step below 0", 5, 1, (GravityPlan){.step = -1}, WRONG);
  one_wrong("shrinking", 5, 1, (GravityPlan){GRAVITY_ADAPTIVE, .factor = 0.5},
            WRONG);
  one_wrong("passes below 0", 5, 1, (GravityPlan){.passes = -1}, WRONG);
  one_wrong("tolerance 1", 5, 1,
            (GravityPlan){GRAVITY_ADAPTIVE, .tolerance = 1}, WRONG);
  one_wrong("one pass", 500, 1, (GravityPlan){GRAVITY_ADAPTIVE, .passes = 1},
            UNREACHED);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    few(dim);
    literal(dim);
    mixed(dim);
    apart(dim);
    hard(dim);
  }
  same_bytes();
  steps();
  wrong();
  rests(2, 0.8, 0.88);
  rests(3, 0.59, 0.63);
  return gsl_test_summary();
}
