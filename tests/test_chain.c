/* Chains of events: against a plain kernel, closed forms, theory and
   event-driven dynamics. */
#include "few.h"
#include "many.h"
#include "chain.h"
#include "crm.h"
#include "theory.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static const double cube[3] = {1, 1, 1}, rod[3] = {1, 1, 6};

/* n of radius 1 and n2 of radius r2, grown to the fraction. */
static Pack *grown(int dim, const double ratio[], size_t n, size_t n2,
                   double r2, double phi, double rate, uint64_t seed) {
  double solid = (double)n * pack_ball(dim, 1) + (double)n2 * pack_ball(dim, r2);
  Box box = box_make(dim, ratio, solid / phi);
  Species s[2] = {{.name = "A", .radius = 1, .count = n},
                  {.name = "B", .radius = r2, .count = n2}};
  Pack *pack = pack_alloc(&box, s, n2 ? 2 : 1, false);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[c % (size_t)dim];
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = rate, .fraction = phi,
                  .points = true};
  Outcome out = {0};
  if (crm_grow(pack, &plan, &rng, NULL, &out))
    gsl_test(1, "grown to %g: %s", phi, out.text);
  return pack;
}

static Chain *open(const Pack *pack, ChainRule rule, double length) {
  ChainPlan plan = {.rule = rule, .length = length};
  Outcome out = {0};
  Chain *chain = chain_alloc(pack, &plan, &out);
  gsl_test(chain == NULL || out.status != DONE, "opened %s", out.text);
  return chain;
}

/* --------------------------------------------------- the plain kernel */
typedef struct {
  int dim, wide, astray; /* beyond 64 boxes: to be put back */
  size_t n;
  double side[3], farthest, length, jump, square;
  double (*x)[3], (*v)[3], *a;
  uint64_t lifts, chains;
} Ref;

static void ref_normal(Ref *ref, size_t i, Rng *rng) {
  double normal[4], unit = sqrt(1.0 / ref->dim);
  chain_normals(rng, normal);
  if (ref->dim == 3)
    chain_normals(rng, normal + 2);
  for (int k = 0; k < ref->dim; k++)
    ref->v[i][k] = unit * normal[k];
}

/* The way of i along u to an image of j that lies at d. */
static double ref_way(const Ref *ref, int axis, const double d[],
                      const double u[], double reach) {
  double along = 0, aside = 0;
  for (int k = 0; k < ref->dim; k++)
    along = axis < 0 ? along + d[k] * u[k] : k == axis ? d[k] : along;
  for (int k = 0; k < ref->dim; k++) {
    double rest = axis < 0 ? d[k] - along * u[k] : d[k];
    aside = k == axis ? aside : aside + rest * rest;
  }
  double inside = reach * reach - aside;
  return along > 0 && inside > 0 ? along - sqrt(inside) : INFINITY;
}

/* The first meeting of i: with whom, and his separation where it began. */
static double ref_first(const Ref *ref, size_t i, int axis, const double u[],
                        size_t *whom, double image[]) {
  double first = INFINITY;
  for (size_t j = 0; j < ref->n; j++) {
    double d[3] = {0, 0, 0}, c[3];
    int reach = ref->wide ? 0 : 3;
    for (int k = 0; k < ref->dim; k++)
      c[k] = ref->x[j][k] - ref->x[i][k];
    for (int s = 0; j != i && s < (2 * reach + 1) * (2 * reach + 1) *
                                     (ref->dim == 3 ? 2 * reach + 1 : 1);
         s++) {
      int rest = s, turn[3];
      for (int k = 0; k < ref->dim; k++, rest /= 2 * reach + 1) {
        double side = ref->side[k];
        turn[k] = rest % (2 * reach + 1) - reach -
                  (ref->wide ? 0 : (int)floor(c[k] / side + .5));
        d[k] = ref->wide ? (c[k] > .5 * side    ? c[k] - side
                            : c[k] < -.5 * side ? c[k] + side
                                                : c[k])
                         : c[k] + turn[k] * side;
      }
      double way = ref_way(ref, axis, d, u, ref->a[i] + ref->a[j]);
      if (way < first) {
        first = way;
        *whom = j;
        for (int k = 0; k < ref->dim; k++)
          image[k] = ref->wide ? 0 : turn[k];
      }
    }
  }
  return first;
}

static void ref_advance(Ref *ref, size_t i, int axis, const double u[],
                        double way) {
  for (int k = 0; k < ref->dim; k++) {
    if (axis >= 0 && k != axis)
      continue;
    ref->x[i][k] += axis < 0 ? way * u[k] : way;
    if (ref->wide)
      ref->x[i][k] = box_wrap(ref->x[i][k], ref->side[k]);
    else
      ref->astray |= fabs(ref->x[i][k]) > 64 * ref->side[k];
  }
}

/* An elastic collision with the normal d; returns d . v of i before. */
static double ref_lift(Ref *ref, size_t i, size_t j, int axis,
                       const double image[]) {
  double d[3], square = 0, before = 0, both = 0;
  for (int k = 0; k < ref->dim; k++) {
    d[k] = ref->x[j][k] - ref->x[i][k];
    d[k] = ref->wide ? box_nearest(d[k], ref->side[k])
                     : d[k] + image[k] * ref->side[k];
    square += d[k] * d[k];
  }
  if (axis >= 0)
    return d[axis];
  for (int k = 0; k < ref->dim; k++) {
    before += d[k] * ref->v[i][k];
    both += d[k] * (ref->v[i][k] - ref->v[j][k]);
  }
  for (int k = 0; k < ref->dim; k++) {
    ref->v[i][k] -= both / square * d[k];
    ref->v[j][k] += both / square * d[k];
  }
  return before;
}

static void ref_chain(Ref *ref, ChainRule rule, Rng *rng) {
  for (size_t c = 0; c < ref->n * 3 && ref->astray; c++)
    ref->x[c / 3][c % 3] = box_wrap(ref->x[c / 3][c % 3], ref->side[c % 3]);
  ref->astray = 0;
  size_t i = rng_below(rng, ref->n), j = 0;
  double left = 2 * rng_uniform(rng) * ref->length;
  int axis = -1;
  if (rule == CHAIN_NEWTON)
    ref_normal(ref, i, rng);
  else
    axis = (int)rng_below(rng, (uint64_t)ref->dim);
  while (left > 0) {
    double u[3] = {0, 0, 0}, speed = 1, square = 0, image[3];
    if (axis < 0) {
      for (int k = 0; k < ref->dim; k++)
        square += ref->v[i][k] * ref->v[i][k];
      speed = sqrt(square);
      for (int k = 0; k < ref->dim; k++)
        u[k] = ref->v[i][k] / speed;
    }
    double way = ref_first(ref, i, axis, u, &j, image);
    double most = GSL_MIN(left * speed, ref->farthest);
    int met = way < most, over = !met && left * speed <= ref->farthest;
    way = met ? GSL_MAX(way, 0) : most;
    ref_advance(ref, i, axis, u, way);
    ref->square += way * speed;
    left = over ? 0 : left - way / speed;
    if (met) {
      ref->jump += ref_lift(ref, i, j, axis, image);
      i = j;
      ref->lifts++;
    }
  }
  ref->chains++;
}

static Ref *ref_alloc(const Pack *pack, int wide, double length) {
  Ref *ref = calloc(1, sizeof *ref);
  size_t dim = (size_t)pack->box.dim;
  ref->dim = pack->box.dim;
  ref->wide = wide;
  ref->n = pack->n;
  ref->length = length;
  ref->farthest = box_reach(&pack->box) / 4;
  ref->x = calloc(pack->n, sizeof *ref->x);
  ref->v = calloc(pack->n, sizeof *ref->v);
  ref->a = calloc(pack->n, sizeof *ref->a);
  memcpy(ref->side, pack->box.side, sizeof ref->side);
  for (size_t i = 0; i < pack->n; i++) {
    ref->a[i] = pack_radius(pack, i);
    for (size_t k = 0; k < dim; k++)
      ref->x[i][k] = pack->x[i * dim + k];
  }
  return ref;
}

static void ref_free(Ref *ref) {
  free(ref->x);
  free(ref->v);
  free(ref->a);
  free(ref);
}

/* The same places, bit for bit, whatever the lists and leashes. */
static void against_reference(int dim, const double ratio[], size_t n,
                              size_t n2, double r2, double phi, int wide,
                              ChainRule rule, double length, uint64_t lifts) {
  Pack *pack = grown(dim, ratio, n, n2, r2, phi, .2, 3 + n);
  Chain *chain = open(pack, rule, length);
  Ref *ref = ref_alloc(pack, wide, chain_length(chain));
  Rng rng = rng_stream(5, n, RNG_TEST), same = rng;
  ChainReport report = {0};
  chain_run(chain, lifts, &rng, &report);
  chain_store(chain, pack);
  for (size_t i = 0; rule == CHAIN_NEWTON && i < ref->n; i++)
    ref_normal(ref, i, &same);
  while (ref->lifts < lifts)
    ref_chain(ref, rule, &same);
  size_t differ = 0;
  for (size_t i = 0; i < ref->n; i++)
    for (int k = 0; k < dim; k++)
      differ += box_wrap(ref->x[i][k], ref->side[k]) !=
                pack->x[i * (size_t)dim + (size_t)k];
  gsl_test(differ || report.lifts != ref->lifts ||
               report.chains != ref->chains || chain_leashes(chain) < 10,
           "%d-D N=%zu+%zu r2=%g phi=%g, %s %s: %zu coordinates differ after "
           "%.0f lifts (%.0f leashes)", dim, n, n2, r2, phi,
           wide ? "wide" : "narrow", rule ? "newton" : "straight", differ,
           (double)report.lifts, (double)chain_leashes(chain));
  gsl_test_rel(report.Z, 1 + ref->jump / ref->square, 1e-12, "and the same Z");
  ref_free(ref);
  chain_free(&chain);
  pack_free(&pack);
}

/* --------------------------------------------------- closed forms */
/* Two alone: the one is anywhere outside the other's ball of radius D, so that
   Z = 1 + b / (V - 2 b) with b half of the volume of that ball. */
static void two(int dim, double a, double b, double side, ChainRule rule,
                double length) {
  Box box = {.dim = dim, .side = {side, side, side}};
  Species s[2] = {{.name = "A", .radius = a, .count = 1},
                  {.name = "B", .radius = b, .count = 1}};
  Pack *pack = pack_alloc(&box, s, 2, false);
  pack->x[0] = .55 * side;
  double ball = pack_ball(dim, a + b);
  double exact = 1 + .5 * ball / (box_volume(&box) - ball);
  double square = 0, sum = 0, shell = 0, runs = 24, samples = 0;
  for (int run = 0; run < runs; run++) {
    Chain *chain = open(pack, rule, length);
    Rng rng = rng_stream(7, (uint64_t)run, RNG_TEST);
    ChainReport report = {0};
    for (int part = 0; part < 250; part++) {
      chain_walk(chain, 3, &rng, &report);
      chain_store(chain, pack);
      double r = 0;
      for (int k = 0; k < dim; k++)
        r += gsl_pow_2(box_nearest(pack->x[dim + k] - pack->x[k], side));
      shell += sqrt(r) < .5 * side;
      samples++;
    }
    double off = (report.Z - exact) / report.Z_error;
    square += off * off;
    sum += off;
    chain_free(&chain);
  }
  /* sum / sqrt(runs) is normal, square has the mean runs, variance 2 runs. */
  gsl_test(fabs(sum) > 3.5 * sqrt(runs) ||
               fabs(square - runs) > 4 * sqrt(2 * runs),
           "%d-D, two of %g and %g in %g, %s %g: Z is off by %.2f se, chi2 %.1f "
           "of %g", dim, a, b, side, rule ? "newton" : "straight", length,
           sum / sqrt(runs), square, runs);
  double within = (pack_ball(dim, .5 * side) - ball) / (box_volume(&box) - ball);
  double se = sqrt(within * (1 - within) / samples);
  gsl_test(fabs(shell / samples - within) > 5 * se,
           "as often near as far: %.4f of %.4f (%.2f se if independent)",
           shell / samples, within, (shell / samples - within) / se);
  pack_free(&pack);
}

/* One alone never meets anybody, not even itself, and all ends. */
static void alone(double radius, ChainRule rule) {
  Box box = {.dim = 3, .side = {2.1, 2.2, 2.3}};
  Species s = {.name = "A", .radius = radius, .count = 1};
  Pack *pack = pack_alloc(&box, &s, 1, false);
  Chain *chain = open(pack, rule, 3);
  Rng rng = rng_stream(7, 7, RNG_TEST);
  ChainReport report = {0};
  chain_run(chain, 100, &rng, &report);
  gsl_test(report.lifts != 0 || report.chains != 1000 || report.Z != 1 ||
               chain_wandered(chain) > 1e-20,
           "one of %g: %.0f chains, Z = %g", radius, (double)report.chains,
           report.Z);
  chain_store(chain, pack);
  gsl_test(!(pack->x[0] >= 0 && pack->x[0] < 2.1), "and stays in the box");
  chain_free(&chain);
  pack_free(&pack);
}

static void normals(void) {
  Rng rng = rng_stream(8, 8, RNG_TEST);
  double n = 200000, power[7] = {0}, cross = 0, squares = 0;
  for (int c = 0; c < n / 2; c++) {
    double pair[2];
    chain_normals(&rng, pair);
    cross += pair[0] * pair[1];
    squares += pair[0] * pair[0] * pair[1] * pair[1];
    for (int l = 0; l < 2; l++)
      for (int k = 1; k <= 6; k++)
        power[k] += gsl_pow_int(pair[l], k);
  }
  const double mean[7] = {1, 0, 1, 0, 3, 0, 15};
  const double variance[7] = {0, 1, 2, 15, 96, 945, 10170};
  for (int k = 1; k <= 6; k++)
    gsl_test(fabs(power[k] / n - mean[k]) > 4 * sqrt(variance[k] / n),
             "normal deviates: moment %d is %.4f (%.2f se)", k, power[k] / n,
             (power[k] / n - mean[k]) / sqrt(variance[k] / n));
  gsl_test(fabs(2 * cross / n) > 4 * sqrt(2 / n) ||
               fabs(2 * squares / n - 1) > 4 * sqrt(16 / n),
           "and independent: %.4f, %.4f", 2 * cross / n, 2 * squares / n);
}

/* --------------------------------------------------- pressure */
/* From packs that dynamics has brought to equilibrium. Blocks are shorter than
   the memory of straight chains, which get twice as many lifts. */
static void pressure(double phi, uint64_t lifts) {
  Pack *pack = grown(3, cube, 500, 0, 1, phi, .2, 77);
  Rng rng = rng_stream(9, 1, RNG_TEST);
  Outcome out = {0};
  crm_equilibrate(pack, MOTION_EQUAL, 60, 2, 1, &rng, NULL, &out);
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    Chain *chain = open(pack, rule, 0);
    ChainReport report = {0};
    chain_run(chain, lifts / 4, &rng, &report);
    memset(&report, 0, sizeof report);
    chain_run(chain, rule ? lifts : 2 * lifts, &rng, &report);
    double exact = few_pressure(phi, 500), off = report.Z - exact;
    chain_store(chain, pack);
    gsl_test(fabs(off) > 3.5 * report.Z_error || fabs(off) > .01 * exact ||
                 report.Z_error > .005 * exact || report.cut ||
                 pack_audit(pack) < -2e-12,
             "phi=%g, %s: Z=%.4f +- %.4f, theory %.4f (%.2f se), gap %.2g", phi,
             rule ? "newton" : "straight", report.Z, report.Z_error, exact,
             off / report.Z_error, pack_audit(pack));
    chain_free(&chain);
  }
  pack_free(&pack);
}

/* The contact value of event-driven dynamics. */
static void against_dynamics(int dim, size_t n, size_t n2, double r2,
                             double phi, uint64_t lifts) {
  Pack *pack = grown(dim, cube, n, n2, r2, phi, .2, 79);
  Rng rng = rng_stream(9, 2, RNG_TEST);
  CrmReport flown;
  Outcome out = {0};
  crm_equilibrate(pack, MOTION_EQUAL, 60, 20, (double)lifts / (30 * (double)n),
                  &rng, &flown, &out);
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    Chain *chain = open(pack, rule, 0);
    ChainReport report = {0};
    chain_run(chain, lifts, &rng, &report);
    double error = gsl_hypot(report.Z_error, flown.Z_error);
    gsl_test(fabs(report.Z - flown.Z) > 3.5 * error || error > .02 * flown.Z,
             "%d-D, %zu and %zu of %g at %g, %s: Z=%.4f +- %.4f, dynamics %.4f "
             "+- %.4f (%.2f se)", dim, n, n2, r2, phi,
             rule ? "newton" : "straight", report.Z, report.Z_error, flown.Z,
             flown.Z_error, (report.Z - flown.Z) / error);
    chain_free(&chain);
  }
  pack_free(&pack);
}

/* --------------------------------------------------- overlaps, hard cases */
static void audit(int dim, size_t n, size_t n2, double r2, double phi,
                  uint64_t lifts) {
  Pack *pack = grown(dim, cube, n, n2, r2, phi, .01, 81);
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    Chain *chain = open(pack, rule, 0);
    Rng rng = rng_stream(9, 3, RNG_TEST);
    ChainReport report = {0};
    double least = INFINITY;
    for (int part = 0; part < 5; part++) {
      chain_run(chain, lifts / 5, &rng, &report);
      chain_store(chain, pack);
      least = GSL_MIN(least, pack_audit(pack) / (2 * pack_smallest(pack)));
    }
    gsl_test(least < -1e-12 || report.lifts < lifts || report.cut,
             "%d-D N=%zu+%zu at %g, %s: gap %.3g diameters after %.0f lifts, "
             "Z=%.4g", dim, n, n2, phi, rule ? "newton" : "straight", least,
             (double)report.lifts, report.Z);
    chain_free(&chain);
  }
  pack_free(&pack);
}

/* The displacement is that of the places, added up chain by chain. */
static void wander(int dim, size_t n, double phi, ChainRule rule) {
  Pack *pack = grown(dim, cube, n, 0, 1, phi, .2, 83);
  double *last = malloc(n * 3 * sizeof *last), *moved = calloc(n, 3 * sizeof *moved);
  size_t many = n * (size_t)dim;
  memcpy(last, pack->x, many * sizeof *last);
  Chain *chain = open(pack, rule, box_reach(&pack->box) / 12);
  Rng rng = rng_stream(9, 5, RNG_TEST);
  ChainReport report = {0};
  for (size_t part = 0; part < (size_t)as_many(300, 1000) * n; part++) {
    chain_walk(chain, 1, &rng, &report);
    chain_store(chain, pack);
    for (size_t c = 0; c < many; c++)
      moved[c] += box_nearest(pack->x[c] - last[c], pack->box.side[c % (size_t)dim]);
    memcpy(last, pack->x, many * sizeof *last);
  }
  double mean = 0;
  for (size_t k = 0; k < (size_t)dim; k++) {
    double sum = 0, square = 0;
    for (size_t i = 0; i < n; i++) {
      sum += moved[i * (size_t)dim + k] / (double)n;
      square += gsl_pow_2(moved[i * (size_t)dim + k]) / (double)n;
    }
    mean += square - sum * sum;
  }
  gsl_test_rel(chain_wandered(chain), mean, 1e-6,
               "%d-D N=%zu at %g, %s: the way that was wandered", dim, n, phi,
               rule ? "newton" : "straight");
  free(last);
  free(moved);
  chain_free(&chain);
  pack_free(&pack);
}

/* Rows of spheres that touch all round the box. */
static void full_rows(ChainRule rule) {
  Box box = {.dim = 3, .side = {6, 6, 6}};
  Species s = {.name = "A", .radius = 1, .count = 27};
  Pack *pack = pack_alloc(&box, &s, 1, false);
  for (size_t i = 0; i < 27; i++)
    for (size_t k = 0, rest = i; k < 3; k++, rest /= 3)
      pack->x[3 * i + k] = 2 * (double)(rest % 3);
  Chain *chain = open(pack, rule, 1);
  Rng rng = rng_stream(9, 4, RNG_TEST);
  ChainReport report = {0};
  chain_run(chain, 1000, &rng, &report);
  chain_store(chain, pack);
  gsl_test(report.lifts < 1000 || pack_audit(pack) < -1e-12,
           "rows that touch all round, %s: %.0f lifts, %.0f cut, gap %.3g",
           rule ? "newton" : "straight", (double)report.lifts,
           (double)report.cut, pack_audit(pack));
  chain_free(&chain);
  pack_free(&pack);
}

static void refused(void) {
  Box box = {.dim = 2, .side = {9, 9}};
  Species s = {.name = "A", .radius = 1, .count = 2};
  Pack *pack = pack_alloc(&box, &s, 1, false);
  ChainPlan plan = {0};
  for (int k = 0; k < 2; k++) {
    pack->x[0] = 2 - (k ? 3e-9 : 1e-9);
    Outcome out = {0};
    Chain *chain = chain_alloc(pack, &plan, &out);
    gsl_test(out.status != (k ? WRONG : DONE) || (chain == NULL) != k,
             "an overlap of %g diameters: %d %s", k ? 1.5e-9 : 5e-10,
             out.status, out.text);
    chain_free(&chain);
  }
  pack->n = 0;
  Outcome out = {0};
  gsl_test(chain_alloc(pack, &plan, &out) != NULL || out.status != WRONG,
           "no particle: %s", out.text);
  pack_free(&pack);
}

static void same_bytes(int dim, ChainRule rule) {
  static const char *const simd[] = {"default", "avx2", "avx512f"};
  Pack *first = NULL;
  for (int v = 0; v < 3; v++) {
    setenv("RANDPACK_SIMD", simd[v], 1);
    Pack *pack = grown(dim, cube, 150, 100, .4, .45, .3, 8);
    Chain *chain = open(pack, rule, 0);
    Rng rng = rng_stream(3, 3, RNG_TEST);
    ChainReport report = {0};
    chain_run(chain, 5000, &rng, &report);
    chain_store(chain, pack);
    if (first)
      gsl_test(memcmp(first->x, pack->x,
                      pack->n * (size_t)dim * sizeof *pack->x) != 0,
               "%d-D, %s: the same bytes with %s", dim,
               rule ? "newton" : "straight", simd[v]);
    else
      first = pack;
    if (first != pack)
      pack_free(&pack);
    chain_free(&chain);
  }
  unsetenv("RANDPACK_SIMD");
  pack_free(&first);
}

int main(void) {
  normals();
  refused();
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    against_reference(3, cube, 250, 0, 1, .45, 1, rule, 20, 4000);
    against_reference(2, cube, 90, 40, .5, .6, 1, rule, 30, 4000);
    against_reference(3, cube, 200, 300, .3, .5, 1, rule, 0, 2000);
    against_reference(3, cube, 12, 0, 1, .45, 0, rule, 5, 700);
    against_reference(2, rod, 8, 5, .3, .5, 0, rule, 8, 4000);
    against_reference(3, cube, 2, 0, 1, .3, 0, rule, 40, 2000);
    against_reference(3, cube, 60, 0, 1, .002, 1, rule, 300, 1000);
    two(2, .5, .5, 2.5, rule, 1.7);
    two(3, .5, .3, 1.9, rule, 2.9);
    two(3, .5, .5, 3, rule, 7);
    alone(.3, rule);
    alone(1.05, rule);
    full_rows(rule);
    wander(2, 5, .3, rule);
    wander(3, 60, .01, rule);
    same_bytes(2, rule);
    same_bytes(3, rule);
  }
  if (as_many(0, 1))
    pressure(.30, 80000);
  pressure(.45, 120000);
  if (as_many(0, 1))
    pressure(.49, 120000);
  audit(3, 108, 0, 1, .63, 80000);
  audit(2, 60, 40, .6, .80, 80000);
  if (as_many(0, 1))
    against_dynamics(2, 200, 0, 1, .5, 80000);
  against_dynamics(2, 100, 150, .4, .6, 80000);
  against_dynamics(3, 100, 200, .4, .45, 80000);
  return gsl_test_summary();
}
