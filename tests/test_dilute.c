/* Dilution: exact fractions, exact radii, ranges, order kept and lost. */
#include "cells.h"
#include "coarse.h"
#include "core.h"
#include "dilute.h"
#include "outcome.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static Pack *dense(int dim, size_t n) {
  Species species = {"A", 0.7, n};
  GravityPlan plan = {.mode = GRAVITY_ADAPTIVE};
  Rng rng = rng_stream(2, 0, RNG_TEST);
  Outcome out = {0};
  return gravity_pack(dim, &species, 1, NULL, &plan, &rng, NULL, &out);
}

static Pack *diluted(const Pack *pack, DilutePlan plan, DiluteReport *report,
                     int status) {
  Rng rng = rng_stream(4, 0, RNG_TEST);
  Outcome out = {0};
  Pack *thin = dilute_pack(pack, &plan, &rng, report, &out);
  gsl_test(out.status != status, "status %d: %s", out.status, out.text);
  return thin;
}

static double root(int dim, double v) {
  return dim == 2 ? sqrt(v) : cbrt(v);
}

/* No moves: the same pack, wider; as many steps as 5 percent ask for. */
static void still(int dim, const Pack *pack) {
  DiluteReport report;
  DilutePlan plan = {.fraction = 0.3, .literal = true};
  Pack *thin = diluted(pack, plan, &report, DONE);
  double k = root(dim, 0.3 / report.before), most = 0;
  gsl_test(report.steps != (int)ceil((1 - k) / 0.05), "%d-D: %d steps", dim,
           report.steps);
  double *x = memory(pack->n * 3, sizeof *x),
         *y = memory(pack->n * 3, sizeof *y);
  gravity_places(pack, x);
  gravity_places(thin, y);
  for (size_t i = 0; i < pack->n * (size_t)dim; i++)
    most = GSL_MAX(most, fabs(y[i] * k - x[i]));
  gsl_test_abs(most, 0, 1e-12, "%d-D: without moves all is wider by 1/k", dim);
  gsl_test(pack_largest(thin) != 0.7 || pack_smallest(thin) != 0.7,
           "radii are the same");
  free(x);
  free(y);
  pack_free(&thin);
}

static double nearest(const Pack *pack, double *spread) {
  Neighbours *near = cells_neighbours(pack, 4);
  double sum = 0, square = 0, n = (double)pack->n;
  for (size_t i = 0; i < pack->n; i++) {
    double least = 4;
    for (size_t t = near->first[i]; t < near->first[i + 1]; t++)
      least = GSL_MIN(least, near->r[t]);
    sum += least / n;
    square += least * least / n;
  }
  cells_neighbours_free(&near);
  *spread = sqrt(GSL_MAX(square - sum * sum, 0));
  return sum;
}

static void lands(int dim, const Pack *pack) {
  double spread[2];
  for (int t = 0; t < 2; t++) {
    DilutePlan plan = {.fraction = 0.35, .part = t ? 1 : 0.3};
    DiluteReport report;
    Pack *thin = diluted(pack, plan, &report, DONE);
    double phi = core_fraction(thin, 0.6 * thin->open);
    gsl_test_rel(phi, 0.35, 1e-12, "%d-D: lands", dim);
    gsl_test_rel(report.reached, phi, 1e-15, "as reported");
    gsl_test(!(pack_audit(thin) > -1.4e-9), "%d-D: overlap %g", dim,
             -pack_audit(thin));
    nearest(thin, spread + t);
    pack_free(&thin);
  }
  gsl_test(!(spread[1] > 1.5 * spread[0]),
           "%d-D: wider moves spread the gaps: %g %g", dim, spread[0],
           spread[1]);
}

static void ranges(int dim, const Pack *pack) {
  double k_d = pack_ball(dim, 1), half = root(dim, k_d / 0.4) / 2;
  DiluteReport report;
  DilutePlan plan = {
      .fraction = 0.4, .part = 0, .literal = true, .range = DILUTE_CENTRES};
  Pack *thin = diluted(pack, plan, &report, DONE);
  gsl_test_rel(report.range, half, 1e-12, "%d-D: R_phi of centres", dim);
  pack_free(&thin);
  plan.range = DILUTE_SURFACES;
  thin = diluted(pack, plan, &report, DONE);
  gsl_test_rel(report.range, half - 1, 1e-12, "%d-D: R_phi of surfaces", dim);
  pack_free(&thin);
  plan = (DilutePlan){
      .fraction = dim == 2 ? 0.8 : 0.57, .part = 1, .range = DILUTE_CENTRES};
  thin = diluted(pack, plan, &report, UNREACHED);
  gsl_test(!thin || !(report.reached < plan.fraction),
           "too wide moves do not land");
  pack_free(&thin);
  plan.fraction = 0.95;
  gsl_test(diluted(pack, plan, &report, WRONG) != NULL,
           "nothing becomes denser");
  plan.fraction = 0.3, plan.part = -1;
  gsl_test(diluted(pack, plan, &report, WRONG) != NULL, "moves below 0");
  Rng rng = rng_stream(1, 0, RNG_TEST);
  Outcome out = {0};
  Pack *repeats = pack_copy(pack);
  repeats->open = 0;
  plan.part = 1;
  gsl_test(dilute_pack(repeats, &plan, &rng, &report, &out) ||
               !strstr(out.text, "is periodic"),
           "a pack that repeats is not diluted: %s", out.text);
  pack_free(&repeats);
}

/* Two fractions: the range counts distances among the fine only. */
static void two(void) {
  Pack *fine = dense(3, 900), *pack;
  Species coarse = {"B", 2.1, 12};
  CoarsePlan plan = {.step = 0};
  Rng rng = rng_stream(4, 0, RNG_TEST);
  Outcome out = {0};
  pack = coarse_add(fine, &coarse, &plan, &rng, NULL, &out);
  DiluteReport report;
  DilutePlan thin = {
      .fraction = 0.4, .part = 0, .literal = true, .range = DILUTE_CENTRES};
  Pack *end = diluted(pack, thin, &report, DONE);
  double k = cbrt(0.4 / report.before), V_q = 12 * pack_ball(3, 2.1 * k);
  double V_p = V_q + (double)(pack->n - 12) * pack_ball(3, 0.7 * k);
  double R = cbrt((V_p / 0.4 - V_q) / (double)(pack->n - 12)) / 2;
  gsl_test_rel(report.range, R / (0.7 * k), 1e-12, "R_phi of two fractions");
  gsl_test(end->n != pack->n || pack_kind(end, end->n - 1) != 1,
           "species stay");
  pack_free(&end);
  thin = (DilutePlan){.fraction = 0.4, .part = 1};
  end = diluted(pack, thin, &report, DONE);
  Pack *again = diluted(pack, thin, &report, DONE);
  gsl_test(memcmp(end->x, again->x, 3 * end->n * sizeof *end->x) != 0,
           "the same bytes again");
  gsl_test_rel(core_fraction(end, 0.6 * end->open), 0.4, 1e-12,
               "two fractions land");
  gsl_test(!(pack_audit(end) > -1.4e-9), "and do not overlap");
  pack_free(&again);
  pack_free(&end);
  pack_free(&pack);
  pack_free(&fine);
}

/* One particle, two, three: an answer, not an endless search. */
static void few(int dim) {
  for (size_t n = 1; n <= 3; n++) {
    Pack *pack = dense(dim, n);
    DiluteReport report;
    DilutePlan plan = {.fraction = 0.2};
    Pack *thin = diluted(pack, plan, &report, n == 1 ? UNREACHED : DONE);
    gsl_test(!thin || thin->n != n || (n > 1 && !(pack_audit(thin) > 0)),
             "%zu particles diluted: %g", n, report.reached);
    pack_free(&thin);
    pack_free(&pack);
  }
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = dense(dim, 800);
    still(dim, pack);
    lands(dim, pack);
    ranges(dim, pack);
    pack_free(&pack);
    few(dim);
  }
  two();
  return gsl_test_summary();
}
