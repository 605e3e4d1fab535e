/* Coarse fractions: turns against all pairs, numbers, radii, overlaps. */
#include "coarse.h"
#include "core.h"
#include "outcome.h"
#include "ref_gravity.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static Pack *fine_pack(int dim, size_t n, uint64_t seed) {
  Species species = {"fine", 0.5, n};
  GravityPlan plan = {.mode = GRAVITY_ADAPTIVE};
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  Outcome out = {0};
  return gravity_pack(dim, &species, 1, NULL, &plan, &rng, NULL, &out);
}

/* All turns of the second variant by sweeps over all pairs: the same places. */
static void exact(int dim) {
  enum { N = 150, Q = 4 };
  Pack *fine = fine_pack(dim, N, 5);
  Species coarse = {"coarse", 1.4, Q};
  CoarsePlan plan = {.step = 0.2, .slack = 1e-3};
  CoarseReport report;
  Outcome out = {0};
  Rng rng = rng_stream(6, 0, RNG_TEST), copy = rng;
  Pack *pack = coarse_mark(fine, &coarse, NULL, &plan, &rng, &report, &out);
  gsl_test(out.status != DONE, "%d-D: marked and grown: %s", dim, out.text);
  size_t d = (size_t)dim, all[N], n = 0;
  double x[3 * N], y[3 * N], radius[N];
  bool marked[N] = {false};
  for (size_t i = 0; i < N; i++)
    all[i] = i;
  gravity_places(fine, y);
  for (size_t c = 0; c < Q; c++) {
    size_t other = c + rng_below(&copy, N - c), one = all[other];
    all[other] = all[c];
    marked[one] = true;
    memcpy(x + (N - Q + c) * d, y + one * d, d * sizeof *x);
  }
  for (size_t i = 0; i < N; i++)
    if (!marked[i])
      memcpy(x + n++ * d, y + i * d, d * sizeof *x);
  for (size_t i = 0; i < N; i++)
    radius[i] = 0.5;
  for (int t = 0; t < 9; t++)
    for (size_t i = N - Q; i < N; i++) {
      double origin[3] = {0, 0, 0};
      radius[i] = GSL_MIN(radius[i] + 0.1, 1.4);
      memcpy(origin, x + i * d, d * sizeof *x);
      ref_gravity_sweep(dim, N, x, radius, 1, origin, 1e-3);
    }
  const double zero[3] = {0, 0, 0};
  ref_gravity_sweep(dim, N, x, radius, 1, zero, 0);
  while (ref_gravity_sweep(dim, N, x, radius, 1, zero, 0.999e-9) > 0)
    ;
  gravity_places(pack, y);
  double most = 0;
  for (size_t i = 0; i < N * d; i++)
    most = GSL_MAX(most, fabs(x[i] - y[i]));
  gsl_test_abs(most, 0, 1e-13, "%d-D: turns are those of all pairs", dim);
  gsl_test(report.turns != 9 * Q, "nine turns each (%d)", (int)report.turns);
  pack_free(&pack);
  pack_free(&fine);
}

static void sound(const char *what, const Pack *pack,
                  const CoarseReport *report, const Outcome *out) {
  gsl_test(out->status != DONE, "%s: %s", what, out->text);
  gsl_test(!(pack_audit(pack) > -1e-9), "%s: overlap %g", what,
           -pack_audit(pack));
  gsl_test(!(report->overlap < 1e-9), "%s: reported %g", what, report->overlap);
  gsl_test_rel(pack->open, report->rim, 1e-12, "%s: the rim", what);
}

/* So many of these marked and grown, and sound. */
static Pack *marked(const char *what, const Pack *fine, Species coarse,
                    const double end[], double step, CoarseReport *report) {
  CoarsePlan plan = {.step = step};
  Outcome out = {0};
  Rng rng = rng_stream(6, 0, RNG_TEST);
  Pack *pack = coarse_mark(fine, &coarse, end, &plan, &rng, report, &out);
  sound(what, pack, report, &out);
  return pack;
}

/* The least gap of a particle of the last species: 0, if they have grown as far
   as told and no farther. */
static double coarse_gap(const Pack *pack) {
  size_t dim = (size_t)pack->box.dim;
  double least = GSL_POSINF;
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = 0; j < pack->n; j++) {
      double square = 0;
      if (pack_kind(pack, i) != pack->kinds - 1 || i == j)
        continue;
      for (size_t k = 0; k < dim; k++) {
        double d = pack->x[j * dim + k] - pack->x[i * dim + k];
        square += d * d;
      }
      double gap = sqrt(square) - pack_radius(pack, i) - pack_radius(pack, j);
      least = GSL_MIN(least, gap);
    }
  return least;
}

/* Most of a pack marked. */
static void most(void) {
  Pack *fine = fine_pack(2, 30, 5);
  CoarseReport report;
  Pack *pack = marked("most are marked", fine, (Species){"coarse", 0.6, 25},
                      NULL, 0, &report);
  gsl_test(pack->n != 30 || pack->species[0].count != 5,
           "nobody is marked twice");
  pack_free(&pack);
  pack_free(&fine);
}

/* The main variant, and a third fraction upon the second. */
static void added(int dim) {
  Pack *fine = fine_pack(dim, 1500, 5), *two, *three;
  Species coarse = {"coarse", 1.5, 30}, large = {"large", 2.5, 4};
  CoarsePlan plan = {.step = 0};
  CoarseReport report, again;
  Outcome out = {0};
  Rng rng = rng_stream(6, 0, RNG_TEST);
  two = coarse_add(fine, &coarse, &plan, &rng, &report, &out);
  sound("added", two, &report, &out);
  gsl_test(two->n + report.destroyed != 1530, "destroyed and left are all");
  gsl_test(two->species[0].count + report.destroyed != 1500 ||
               two->species[1].count != 30,
           "by species");
  gsl_test(two->species[1].radius != 1.5 || pack_largest(two) != 1.5,
           "the radius wanted");
  gsl_test_abs(coarse_gap(two), 0, 2e-9, "%d-D: a coarse one is touched", dim);
  gsl_test(report.turns != 30 * 5, "five turns each: 2/3 by 0.15");
  gsl_test(report.destroyed < 100 || report.destroyed > 1000,
           "%d-D: destroyed %zu", dim, report.destroyed);
  double base = core_fraction(fine, 0.6 * fine->open);
  double phi = core_fraction(two, 0.6 * two->open);
  gsl_test(!(phi > base - 0.03 && phi < base + 0.08),
           "%d-D: fraction %.4f of two, %.4f of one", dim, phi, base);
  three = coarse_add(two, &large, &plan, &rng, &again, &out);
  sound("a third", three, &again, &out);
  gsl_test(three->kinds != 3 || three->n + again.destroyed != two->n + 4,
           "three species");
  pack_free(&fine);
  pack_free(&two);
  pack_free(&three);
}

/* Each of the marked to a radius of its own. */
static void own(void) {
  Pack *fine = fine_pack(3, 800, 5);
  double end[10];
  for (int c = 0; c < 10; c++)
    end[c] = 0.6 + 0.1 * c;
  CoarseReport report;
  Pack *pack = marked("own radii", fine, (Species){"coarse", 1.5, 10}, end, 0,
                      &report);
  gsl_test(pack->n != 800 || memcmp(pack->radius + 790, end, sizeof end) != 0,
           "own radii at the end");
  gsl_test(pack->radius[789] != 0.5 || pack_kind(pack, 789) != 0,
           "and the fine before");
  pack_free(&pack);
  pack_free(&fine);
}

/* All marked, each to its own: a continuous law of sizes. One, to a hundred
   times the others. */
static void hard(void) {
  Pack *fine = fine_pack(3, 400, 5);
  double end[400];
  for (int c = 0; c < 400; c++)
    end[c] = 0.5 + 0.0025 * (c * 171 % 400);
  CoarseReport report;
  Pack *pack = marked("all marked", fine, (Species){"coarse", 1.5, 400}, end, 0,
                      &report);
  double phi = core_fraction(pack, 0.5 * report.rim);
  gsl_test(pack->species[0].count != 0 || !(phi > 0.55 && phi < 0.75),
           "all have grown: %.4f", phi);
  pack_free(&pack);
  pack = marked("a ratio of 100", fine, (Species){"coarse", 50, 1}, NULL, 2,
                &report);
  pack_free(&pack);
  pack_free(&fine);
}

static void refused(const char *what, const Pack *fine, size_t count,
                    double radius, bool mark, CoarsePlan plan, int status) {
  Species coarse = {"coarse", radius, count};
  Outcome out = {0};
  Rng rng = rng_stream(6, 0, RNG_TEST);
  Pack *pack = mark ? coarse_mark(fine, &coarse, NULL, &plan, &rng, NULL, &out)
                    : coarse_add(fine, &coarse, &plan, &rng, NULL, &out);
  gsl_test(out.status != status || (pack != NULL) != (status != WRONG),
           "%s: %s", what, out.text);
  pack_free(&pack);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    exact(dim);
    added(dim);
  }
  own();
  most();
  hard();
  Pack *fine = fine_pack(3, 300, 5);
  CoarsePlan plan = {.step = 0};
  refused("too many", fine, 200, 1.5, false, plan, WRONG);
  refused("none", fine, 0, 1.5, false, plan, WRONG);
  refused("finer than fine", fine, 2, 0.4, false, plan, WRONG);
  refused("more than there are", fine, 301, 1.5, true, plan, WRONG);
  double rim = fine->open;
  fine->open = 0;
  refused("a pack that repeats", fine, 2, 1.5, true, plan, WRONG);
  fine->open = rim;
  refused("a slack of 1", fine, 2, 1.5, true, (CoarsePlan){.slack = 1}, WRONG);
  refused("one pass", fine, 9, 1.5, true, (CoarsePlan){.settle.passes = 1},
          UNREACHED);
  pack_free(&fine);
  return gsl_test_summary();
}
