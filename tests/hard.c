/* Hard cases that the command cannot provoke: `hard NAME` prints what was
   measured and ends with 0 if it is what tests/hard promises. */
#include "cells.h"
#include "chain.h"
#include "contact.h"
#include "core.h"
#include "crm.h"
#include "dilute.h"
#include "field.h"
#include "gravity.h"
#include "order.h"
#include "outcome.h"
#include "pairs.h"
#include "py.h"
#include "rsa.h"
#include "shake.h"
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Pack *make(int dim, const double side[], size_t n, double radius,
                  const double x[]) {
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Species species = {"A", radius, n};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  if (x)
    memcpy(pack->x, x, n * (size_t)dim * sizeof *x);
  return pack;
}

static void scatter(Pack *pack, uint64_t seed) {
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  size_t dim = (size_t)pack->box.dim;
  for (size_t c = 0; c < pack->n * dim; c++)
    pack->x[c] = pack->box.side[c % dim] * rng_uniform(&rng);
}

static const double cube[3] = {8, 8, 8};

/* ------------------------------------------------------------ few particles */
static bool no_particle(void) {
  Pack *pack = make(3, cube, 0, 1, NULL);
  Windows *windows = order_windows_alloc();
  uint64_t count[4];
  double g[4], sum = (double)pairs_count(pack, 0, 1, 4, count);
  pairs_g(pack, count, 0, 1, 4, PAIRS_EXACT, g);
  for (int b = 0; b < 4; b++)
    sum += (double)count[b] + g[b];
  order_windows(pack, 2, WINDOWS_AROUND, 0, NULL, windows);
  BondRule rule = order_rule(3);
  Neighbours *list = cells_neighbours(pack, 2);
  sum += pack_fraction(pack) + order_bonds(pack, &rule, NULL).global +
         order_contacts(pack, 0.1) + windows->mean + (double)list->first[0] +
         contact_value(pack, 2, 2, 0).value;
  bool endless = cells_least_gap(pack) == GSL_POSINF;
  printf("sum %g, gap %g", sum, cells_least_gap(pack));
  cells_neighbours_free(&list);
  order_windows_free(&windows);
  pack_free(&pack);
  return sum == 0 && endless;
}

static bool two_particles(void) {
  static const double x[] = {0.5, 7.75, 3.125, 7.5, 7.75, 4.375};
  Pack *pack = make(3, cube, 2, 0.5, x); /* 1 and 1.25 apart across the side */
  double r = hypot(1, 1.25), K[2];
  uint64_t count[2], below = pairs_count(pack, r - 0.5, 0.5, 2, count);
  pairs_K(pack, below, count, 2, K);
  K[0] /= box_volume(&pack->box);
  K[1] /= box_volume(&pack->box);
  printf("K/V = %g, then %g", K[0], K[1]);
  pack_free(&pack);
  return K[0] == 0 && K[1] == 1;
}

/* ------------------------------------------------------------ boxes */
/* All images nearer than reach, of every particle, by brute force. */
static size_t images(const Pack *pack, double reach) {
  size_t found = 0, dim = (size_t)pack->box.dim;
  int most[3] = {0, 0, 0}, a[3];
  for (size_t k = 0; k < dim; k++)
    most[k] = (int)(reach / pack->box.side[k]) + 2;
  for (size_t ij = 0; ij < pack->n * pack->n; ij++)
    for (a[0] = -most[0]; a[0] <= most[0]; a[0]++)
      for (a[1] = -most[1]; a[1] <= most[1]; a[1]++)
        for (a[2] = -most[2]; a[2] <= most[2]; a[2]++) {
          const double *x = pack->x + ij / pack->n * dim;
          const double *y = pack->x + ij % pack->n * dim;
          double square = 0;
          for (size_t k = 0; k < dim; k++) {
            double d = (y[k] - x[k]) + a[k] * pack->box.side[k];
            square += d * d;
          }
          bool self = ij / pack->n == ij % pack->n && !a[0] && !a[1] && !a[2];
          found += square <= reach * reach && !self;
        }
  return found;
}

static bool counted_as_images(int dim, const double side[], size_t n,
                              double reach) {
  Pack *pack = make(dim, side, n, 0.1, NULL);
  scatter(pack, 61);
  Neighbours *list = cells_neighbours(pack, reach);
  size_t found = list->first[n], truth = images(pack, reach);
  printf("%zu of %zu images", found, truth);
  cells_neighbours_free(&list);
  pack_free(&pack);
  return found == truth;
}

static bool narrow_box(void) {
  static const double side[] = {0.31, 0.29, 0.37};
  return counted_as_images(3, side, 5, 1.13);
}

static bool flat_box(void) {
  static const double side[] = {0.02, 9.7};
  return counted_as_images(2, side, 23, 0.83);
}

/* The least gap, linear and quadratic, of a pack by random addition. */
static bool audited(Pack *pack, uint64_t seed) {
  Rng rng = rng_stream(seed, 0, RNG_POSITIONS);
  Outcome out = {0};
  rsa_fill(pack, 0, true, &rng, NULL, &out);
  double gap = cells_least_gap(pack), truth = pack_audit(pack);
  printf("gap %.6f, by brute force %.6f", gap, truth);
  return out.status == DONE && gap == truth && gap >= 0;
}

static bool long_box(void) {
  static const double side[] = {4.4, 4.4, 88};
  Pack *pack = make(3, side, 120, 1, NULL);
  bool good = audited(pack, 120);
  pack_free(&pack);
  return good;
}

static bool size_ratio(void) {
  Box box = {2, {9.1, 9.1, 0}};
  Species species[] = {{"disc", 1, 6}, {"dot", 0.01, 6000}};
  Pack *pack = pack_alloc(&box, species, 2, false);
  bool good = audited(pack, 100);
  pack_free(&pack);
  return good;
}

/* ------------------------------------------------------------ places */
static bool one_point(void) {
  static const double x[] = {3.7, 1.9, 7.1, 3.7, 1.9, 7.1};
  Pack *pack = make(3, cube, 2, 1, x);
  BondRule rule = order_rule(3);
  uint64_t count[3], below = pairs_count(pack, 2, 0.5, 3, count);
  double gap = cells_least_gap(pack), bonds = order_bonds(pack, &rule, NULL).bonds;
  Neighbours *list = cells_neighbours(pack, 1);
  printf("gap %g, %d pair below contact, %zu neighbours, %g bonds", gap,
         (int)below, list->first[2], bonds);
  bool good = gap == -2 && pack_audit(pack) == -2 && below == 1 &&
              count[0] + count[1] + count[2] == 0 && list->first[2] == 2 &&
              bonds == 0;
  cells_neighbours_free(&list);
  pack_free(&pack);
  return good;
}

static bool at_the_side(void) {
  double last = nextafter(8, 0);
  double x[] = {0, 0, 0, last, last, last, 0, last, 4, last, 0, 4};
  Pack *pack = make(3, cube, 4, 0.1, x);
  int bad = 0;
  for (double reach = 0.01; reach < 4; reach *= 1.1) {
    Neighbours *list = cells_neighbours(pack, reach);
    bad += list->first[4] != images(pack, reach);
    cells_neighbours_free(&list);
  }
  uint64_t count, below = pairs_count(pack, 0, 1e-3, 1, &count);
  double wrapped = box_wrap(8, 8), tiny = box_wrap(-1e-300, 8);
  printf("%d of 63 reaches differ, %d pairs next to each other", bad,
         (int)(below + count));
  pack_free(&pack);
  return bad == 0 && below + count == 2 && wrapped == 0 && tiny == 0;
}

static bool tangent(void) {
  double sigma = 2 * (1 - 1e-16), x[] = {1, 1, 1, 1 + sigma, 1, 1};
  Pack *pack = make(3, cube, 2, 1, x);
  uint64_t count[2], below = pairs_count(pack, 2, 0.01, 2, count);
  double contacts = order_contacts(pack, 1e-6);
  printf("first bin %d, below %d, contacts %g", (int)count[0], (int)below,
         contacts);
  pack_free(&pack);
  return sigma < 2 && count[0] == 1 && below == 0 && contacts == 1;
}

/* ------------------------------------------------------------ saturation */
static bool room_for_one(void) {
  Box box = {2, {2.5, 2.5, 0}};
  Species species = {"disc", 1, 0};
  int ones = 0;
  for (uint64_t seed = 0; seed < 100; seed++) {
    Rng rng = rng_stream(seed, 0, RNG_POSITIONS);
    RsaReport report = {0};
    Pack *pack = rsa_saturate(&box, &species, 1, NULL, 0, &rng, &report);
    ones += pack->n == 1 && report.saturated;
    pack_free(&pack);
  }
  printf("one disc in %d of 100", ones);
  return ones == 100;
}

/* ------------------------------------------------------------ theory */
static bool py_at(double phi) {
  double worst = 0, least = 1;
  Py *py = py_alloc(phi);
  for (double R = 2; R <= 30; R += 0.0078125) {
    double g = py_g(py, R);
    least = GSL_MIN(least, g);
    if (!gsl_finite(g))
      worst = GSL_NAN;
  }
  double contact = fabs(py_g(py, 2) / py_contact(phi) - 1);
  double far = fabs(py_g(py, 1e6) - 1);
  printf("least g %.3g, g(2+) %.8g", GSL_MIN(least, 1), py_g(py, 2));
  bool good = worst == 0 && contact < 1e-13 && py_g(py, nextafter(2, 0)) == 0;
  good = good && (phi > 0.7 || far < 1e-13);
  good = good && (least < 0) == (phi > py_limit());
  py_free(&py);
  return good;
}

static bool py_dilute(void) {
  return py_at(1e-12);
}
static bool py_before(void) {
  return py_at(0.6125);
}
static bool py_dense(void) {
  return py_at(0.74);
}

static bool py_far(void) {
  Py *py = py_alloc(0.49);
  double off = fabs(py_g(py, 1e6) - 1), below = py_g(py, nextafter(2, 0));
  printf("|g(1e6) - 1| %s 1e-15, g(2-) = %g, g(2+) = %.9g",
         off < 1e-15 ? "<" : ">", below, py_g(py, 2));
  bool good = off < 1e-15 && below == 0 &&
              fabs(py_g(py, 2) / (1.245 / (0.51 * 0.51)) - 1) < 1e-14;
  py_free(&py);
  return good;
}

/* ------------------------------------------------------------ growth */
/* A pack of n and n2 points at random in a box of these ratios; radii 1, r2. */
static Pack *points(int dim, const double ratio[], size_t n, size_t n2,
                    double r2) {
  Box box = box_make(dim, ratio, 1000);
  Species species[] = {{"A", 1, n}, {"B", r2, n2}};
  Pack *pack = pack_alloc(&box, species, n2 ? 2 : 1, false);
  scatter(pack, n + n2);
  return pack;
}
static const double square[3] = {1, 1, 1};

static CrmPlan gentle(double rate, double fraction) {
  return (CrmPlan){.protocol = CRM_ISOTHERMAL, .rate = rate,
                   .fraction = fraction, .points = true};
}

/* Grow it, audit it, free it; does it end with this status? At DONE the
   fraction is exact; in any case nothing overlaps and the energy is there. */
static bool grows(Pack *pack, const CrmPlan *plan, int wanted) {
  Rng rng = rng_stream(5, 0, RNG_TEST);
  CrmReport report = {0};
  Outcome out = {0};
  int status = crm_grow(pack, plan, &rng, &report, &out);
  double off = fabs(pack_fraction(pack) - plan->fraction);
  double gap = cells_least_gap(pack) / (2 * pack_largest(pack));
  bool good = status == wanted && gap >= -1e-12 &&
              report.unaccounted < 1e-12 && report.drift < 1e-12 &&
              (status != DONE || off < 1e-14);
  if (status == DONE)
    printf("fraction %.6g, off by %s 1e-14, gap %s -1e-12, %.0f collisions a "
           "particle",
           pack_fraction(pack), off < 1e-14 ? "<" : ">",
           gap >= -1e-12 ? ">" : "<",
           2 * (double)report.collisions / (double)pack->n);
  else
    printf("status %d: %s", status, out.text);
  pack_free(&pack);
  return good;
}

static bool grow_one(void) {
  Pack *pack = points(3, square, 1, 0, 1);
  CrmPlan plan = gentle(0.1, 0.6);
  Rng rng = rng_stream(5, 0, RNG_TEST);
  CrmReport report = {0};
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  double off = fabs(pack_fraction(pack) - M_PI / 6);
  printf("status %d, fraction %.12g, off pi/6 by %s 1e-12", status,
         pack_fraction(pack), off < 1e-12 ? "<" : ">");
  pack_free(&pack);
  return status == UNREACHED && off < 1e-12;
}

static bool grow_two_many(void) {
  Pack *pack = points(3, square, 2, 0, 1);
  CrmPlan plan = gentle(0.01, 0.69);
  Rng rng = rng_stream(5, 0, RNG_TEST);
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, NULL, &out);
  double off = fabs(pack_fraction(pack) - M_PI * sqrt(3) / 8);
  printf("status %d, off pi sqrt(3)/8 by %s 1e-8", status,
         off < 1e-8 ? "<" : ">");
  pack_free(&pack);
  return status == UNREACHED && off < 1e-8;
}
static bool grow_from_a_point(void) {
  Pack *pack = points(3, square, 60, 0, 1);
  for (size_t c = 3; c < 3 * pack->n; c++)
    pack->x[c] = pack->x[c - 3];
  CrmPlan plan = gentle(0.1, 0.4);
  return grows(pack, &plan, DONE);
}

/* The others: n and n2 points, radii 1 and r2, to a fraction at a rate. */
static const struct {
  const char *name;
  int dim;
  double length; /* of the box, by its width */
  size_t n, n2;
  double r2, rate, fraction;
  int wanted;
  CrmProtocol protocol;
  MotionMass mass;
  double budget;
} growths[] = {
    {"grow-none", 3, 1, 0, 0, 1, 0.1, 0.3, WRONG, CRM_ISOTHERMAL, 0, 0},
    {"grow-two", 3, 1, 2, 0, 1, 0.01, 0.67, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-three", 3, 1, 3, 0, 1, 0.01, 0.45, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-eight", 3, 1, 8, 0, 1, 0.01, 0.52, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-jam", 3, 1, 500, 0, 1, 0.1, 0.75, UNREACHED, CRM_ISOTHERMAL, 0, 0},
    {"grow-slow", 3, 1, 16, 0, 1, 1e-5, 0.01, DONE, CRM_ISOTHERMAL, 0, 1e7},
    {"grow-fast", 3, 1, 500, 0, 1, 10, 0.2, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-fast-literal", 3, 1, 500, 0, 1, 1e4, 0.5, DONE, CRM_LITERAL, 0, 0},
    {"grow-dilute", 3, 1, 500, 0, 1, 0.1, 1e-6, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-narrow", 3, 20, 20, 0, 1, 0.05, 0.4, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-long", 3, 20, 300, 0, 1, 0.05, 0.55, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-hundred", 3, 1, 2, 1000, 0.01, 0.3, 0.3, DONE, CRM_ISOTHERMAL,
     MOTION_VOLUME, 0},
    {"grow-thousand", 3, 1, 2, 1000, 0.001, 0.3, 0.2, DONE, CRM_ISOTHERMAL,
     MOTION_VOLUME, 0},
    {"grow-one-among", 3, 1, 1, 10000, 0.05, 1, 0.2, DONE, CRM_ISOTHERMAL, 0, 0},
    {"grow-dense-discs", 2, 1, 400, 0, 1, 0.01, 0.85, DONE, CRM_ISOTHERMAL, 0, 0},
};

static bool grow_of_table(size_t g) {
  const double ratio[3] = {1, 1, growths[g].length};
  CrmPlan plan = gentle(growths[g].rate, growths[g].fraction);
  plan.protocol = growths[g].protocol;
  plan.mass = growths[g].mass;
  plan.budget = growths[g].budget;
  return grows(points(growths[g].dim, ratio, growths[g].n, growths[g].n2,
                      growths[g].r2), &plan, growths[g].wanted);
}

/* Radii 1 to 4 with a density as r^-3: a radius for each particle. */
static bool grow_continuous(void) {
  Box box = box_make(2, square, 1e5);
  Species species = {"A", 1, 100000};
  Pack *pack = pack_alloc(&box, &species, 1, true);
  scatter(pack, 3);
  Rng rng = rng_stream(4, 0, RNG_TEST);
  for (size_t i = 0; i < pack->n; i++)
    pack->radius[i] = 1 / sqrt(1 - 0.9375 * rng_uniform(&rng));
  CrmPlan plan = gentle(0.5, 0.6);
  return grows(pack, &plan, DONE);
}

/* 216 spheres on a simple cubic lattice, each overlapping its neighbours by
   this share, in a box of this side: 12 is full. */
static bool touches(double overlap, double side, int wanted) {
  Box box = {3, {side, side, side}};
  Species species = {"A", 1 + overlap, 216};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (size_t i = 0; i < 216; i++) {
    pack->x[3 * i] = 2 * (double)(i / 36);
    pack->x[3 * i + 1] = 2 * (double)(i / 6 % 6);
    pack->x[3 * i + 2] = 2 * (double)(i % 6);
  }
  Rng rng = rng_stream(5, 0, RNG_TEST);
  CrmReport report = {0};
  Outcome out = {0};
  int status = crm_equilibrate(pack, MOTION_EQUAL, 20, 4, 20, &rng, &report, &out);
  double gap = cells_least_gap(pack) / 2;
  bool good = gap >= -1e-12 && (status != DONE || gsl_finite(report.Z));
  printf("status %d, gap %s -1e-12 %s", status, gap >= -1e-12 ? ">" : "<", out.text);
  pack_free(&pack);
  return good && status == wanted;
}
static bool touching(void) {
  return touches(0, 13, DONE);
}
static bool touching_full(void) {
  return touches(0, 12, UNREACHED);
}
static bool overlapping_a_bit(void) {
  return touches(1e-15, 13, DONE);
}
static bool overlapping_more(void) {
  return touches(1e-13, 13, DONE);
}

/* ------------------------------------------------------------ shakes */
/* n of radius 1 and n2 of r2, grown to a fraction; if it is 1, to a millionth
   below jamming, where Z is 3 millions in space. Radii are what was reached. */
static Pack *grown(int dim, size_t n, size_t n2, double r2, double rate,
                   double fraction) {
  Pack *pack = points(dim, square, n, n2, r2);
  CrmPlan plan = gentle(rate, fraction);
  plan.pressure = fraction < 1 ? 0 : 3e6;
  plan.fraction = GSL_MIN(fraction, 0.9);
  Rng rng = rng_stream(5, 0, RNG_TEST);
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, NULL, &out);
  if (status != (fraction < 1 ? DONE : UNREACHED))
    printf("not grown: %s ", out.text);
  return pack;
}

static ShakeReport shaken(Pack *pack, ShakeRule rule, double radius,
                          uint64_t sweeps) {
  const ShakePlan plan = {rule, radius, 4, false};
  Rng rng = rng_stream(6, rule, RNG_TEST);
  ShakeReport report = {0};
  Outcome out = {0};
  Shake *shake = shake_alloc(pack, &plan, &out);
  if (!shake)
    printf("not shaken: %s ", out.text);
  else {
    shake_sweeps(shake, sweeps, &rng, &report);
    shake_store(shake, pack);
  }
  shake_free(&shake);
  return report;
}

static ChainReport chained(Pack *pack, ChainRule rule, uint64_t lifts) {
  const ChainPlan plan = {.rule = rule};
  Rng rng = rng_stream(7, rule, RNG_TEST);
  ChainReport report = {0};
  Outcome out = {0};
  Chain *chain = chain_alloc(pack, &plan, &out);
  if (!chain)
    printf("no chains: %s ", out.text);
  else {
    chain_run(chain, lifts, &rng, &report);
    chain_store(chain, pack);
  }
  chain_free(&chain);
  return report;
}

/* Nothing overlaps, by more than this share of the smallest diameter. */
static bool clear(const Pack *pack, double share) {
  double gap = cells_least_gap(pack) / (2 * pack_smallest(pack));
  printf(", gap %s -%g", gap >= -share ? ">" : "<", share);
  return gap >= -share;
}

static bool shake_dense(void) {
  Pack *pack = grown(3, 500, 0, 1, 0.003, 0.63);
  double a = pack_largest(pack), made = contact_value(pack, 2 * a, 2, 0).value;
  ShakeReport report = shaken(pack, SHAKE_METROPOLIS, 0.02, 1000);
  double change = contact_value(pack, 2 * a, 2, 0).value / made - 1;
  printf("contact value %.4g, changed by %.2g, %.2g accepted", made, change,
         (double)report.moved / (double)report.trials);
  bool good = clear(pack, 1e-12) && fabs(change) < 0.15;
  pack_free(&pack);
  return good;
}

/* Who is held moves by a millionth, rattlers as they like. */
static bool shake_jammed(void) {
  Pack *pack = grown(3, 100, 0, 1, 0.01, 1);
  size_t most = 0;
  double wide = 0, narrow = 0;
  for (ShakeRule rule = SHAKE_METROPOLIS; rule <= SHAKE_COLLISION_LONGEST; rule++)
    most = GSL_MAX(most, shaken(pack, rule, 0.02, 100).moved);
  ShakeReport report = shaken(pack, SHAKE_METROPOLIS, 0.02, 1000);
  wide = (double)report.moved / (double)report.trials;
  report = shaken(pack, SHAKE_METROPOLIS, 1e-6, 1000);
  narrow = (double)report.moved / (double)report.trials;
  printf("accepted %.2g, and %.2g", wide, narrow);
  bool good = clear(pack, 1e-12) && wide < 0.05 && narrow > 0.1 && most > 0;
  pack_free(&pack);
  return good;
}

static bool chain_jammed(void) {
  Pack *pack = grown(3, 100, 0, 1, 0.01, 1);
  double Z[2];
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++)
    Z[rule] = chained(pack, rule, 100000).Z;
  printf("Z %.2g and %.2g", Z[0], Z[1]);
  bool good = clear(pack, 1e-12) && Z[0] > 1e5 && Z[1] > 1e5;
  pack_free(&pack);
  return good;
}

/* No window, one below the last digit, one wider than the box. */
static bool shake_windows(void) {
  static const double radius[] = {0, 1e-15, 100};
  bool good = true;
  for (size_t r = 0; r < 3; r++)
    for (ShakeRule rule = SHAKE_METROPOLIS; rule <= SHAKE_COLLISION_LONGEST; rule++) {
      Pack *pack = grown(3, 60, 0, 1, 0.1, r < 2 ? 0.5 : 0.05);
      double least = cells_least_gap(pack), x = pack->x[0];
      ShakeReport report = shaken(pack, rule, radius[r], 50);
      double off = fabs(box_nearest(pack->x[0] - x, pack->box.side[0]));
      good = good && report.turns == 3000 &&
             (r < 2 ? off < 1e-12 : off > 1e-3) &&
             (r > 0 || (report.moved == 0 && cells_least_gap(pack) == least)) &&
             cells_least_gap(pack) >= -1e-12;
      if (rule == SHAKE_METROPOLIS)
        printf("%s%.0f of 3000 moved", r ? ", " : "", (double)report.moved);
      pack_free(&pack);
    }
  return good;
}

static bool shake_one(void) {
  bool good = true;
  for (ShakeRule rule = SHAKE_METROPOLIS; rule <= SHAKE_COLLISION_LONGEST; rule++) {
    Pack *pack = make(3, cube, 1, 3.9, NULL);
    ShakeReport report = shaken(pack, rule, 0.5, 1000);
    good = good && report.moved == 1000 && pack->x[0] >= 0 && pack->x[0] < 8;
    printf("%s%.0f", rule ? ", " : "", (double)report.moved);
    pack_free(&pack);
  }
  printf(" of 1000 turns moved");
  return good;
}

static bool chain_few(void) {
  bool good = true;
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    static const double x[] = {1, 1, 1, 4, 5, 6};
    Pack *one = make(3, cube, 1, 3.9, x), *two = make(3, cube, 2, 1, x);
    ChainReport alone = chained(one, rule, 1000);
    ChainReport both = chained(two, rule, 20000);
    double ball = pack_ball(3, 2), Z = 1 + 0.5 * ball / (512 - ball);
    good = good && alone.lifts == 0 && alone.chains == 1000 && alone.Z == 1 &&
           fabs(both.Z - Z) < 4 * both.Z_error && both.Z_error < 0.01;
    printf("%s%.0f lifts, Z %.4f (%.4f)", rule ? "; " : "",
           (double)alone.lifts, both.Z, Z);
    good = clear(two, 1e-12) && good;
    pack_free(&one);
    pack_free(&two);
  }
  return good;
}

static bool chain_empty(void) {
  bool good = true;
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    Pack *pack = grown(3, 500, 0, 1, 0.1, 1e-6);
    ChainReport report = chained(pack, rule, 300);
    good = good && report.lifts >= 300 && fabs(report.Z - 1) < 1e-3;
    printf("%s%.0f lifts, |Z - 1| %s 1e-3", rule ? "; " : "",
           (double)report.lifts, fabs(report.Z - 1) < 1e-3 ? "<" : ">");
    good = clear(pack, 1e-12) && good;
    pack_free(&pack);
  }
  return good;
}

static bool shake_discs(void) {
  enum { SAMPLES = 100 };
  Pack *pack = grown(2, 500, 0, 1, 0.05, 0.70);
  double Z = chained(pack, CHAIN_NEWTON, 200000).Z, a = pack_largest(pack), g = 0;
  const ShakePlan plan = {SHAKE_METROPOLIS, 0.2, 1, false};
  Rng rng = rng_stream(6, 0, RNG_TEST);
  ShakeReport report = {0};
  Outcome out = {0};
  Shake *shake = shake_alloc(pack, &plan, &out);
  for (int s = 0; s < SAMPLES; s++) {
    shake_sweeps(shake, 20, &rng, &report);
    shake_store(shake, pack);
    g += contact_value(pack, 2 * a, 2, 0).value / SAMPLES;
  }
  double off = (1 + 2 * pack_fraction(pack) * g) / Z - 1;
  printf("%.2g accepted; Z by chains %.4g, by trials %.2g off",
         (double)report.moved / (double)report.trials, Z, off);
  bool good = clear(pack, 1e-12) && fabs(off) < 0.05;
  shake_free(&shake);
  pack_free(&pack);
  return good;
}

static bool shake_hundred(void) {
  Pack *pack = grown(3, 2, 1000, 0.01, 0.3, 0.3);
  bool good = true;
  for (ShakeRule rule = SHAKE_METROPOLIS; rule <= SHAKE_COLLISION_LONGEST; rule++) {
    ShakeReport report = shaken(pack, rule, 0.5, 50);
    good = good && report.moved > report.turns / 2;
    printf("%s%.2g", rule ? ", " : "moved in ", (double)report.moved / (double)report.turns);
  }
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++)
    good = chained(pack, rule, 5000).lifts >= 5000 && good;
  double gap = cells_least_gap(pack);
  good = clear(pack, 1e-12) && good && gap == pack_audit(pack);
  pack_free(&pack);
  return good;
}

/* A cubic lattice that touches all round its box: nobody can go anywhere. */
static Pack *held(void) {
  static const double side[] = {6, 6, 6};
  Pack *pack = make(3, side, 27, 1, NULL);
  for (size_t c = 0, three[] = {9, 3, 1}; c < 81; c++)
    pack->x[c] = 2 * (double)(c / 3 / three[c % 3] % 3);
  return pack;
}

static bool shake_held(void) {
  Pack *pack = held(), *was = held();
  size_t moved = 0;
  for (ShakeRule rule = SHAKE_METROPOLIS; rule <= SHAKE_COLLISION_LONGEST; rule++)
    moved += shaken(pack, rule, 0.02, 1000).moved;
  bool same = memcmp(pack->x, was->x, 81 * sizeof *pack->x) == 0;
  printf("%zu moved, the bytes are %sthe same", moved, same ? "" : "not ");
  bool good = clear(pack, 1e-12) && same && moved == 0;
  pack_free(&pack);
  pack_free(&was);
  return good;
}

static bool chain_held(void) {
  bool good = true;
  for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
    Pack *pack = held();
    ChainReport report = chained(pack, rule, 1000);
    good = good && report.cut > 0 && report.chains == report.cut;
    printf("%s%.0f of %.0f chains cut", rule ? "; " : "", (double)report.cut,
           (double)report.chains);
    good = clear(pack, 1e-12) && good;
    pack_free(&pack);
  }
  return good;
}

/* ------------------------------------------------------------ gravity */
/* The deepest overlap of discs or spheres of radius 1, of all pairs. */
static double deepest(int dim, size_t n, const double *x) {
  double least = INFINITY;
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < i; j++) {
      double r2 = 0;
      for (size_t c = 0; c < (size_t)dim; c++)
        r2 += gsl_pow_2(x[i * (size_t)dim + c] - x[j * (size_t)dim + c]);
      least = fmin(least, r2);
    }
  return fmax(2 - sqrt(least), 0);
}

static bool field_from_a_point(void) {
  bool good = true;
  for (int dim = 2; dim <= 3; dim++) {
    size_t n = 1000;
    double *x = memory(n * (size_t)dim, sizeof *x);
    memset(x, 0, n * (size_t)dim * sizeof *x);
    Field *field = field_alloc(dim, n, x, NULL);
    FieldSweep sum = {0};
    int passes = 0;
    bool rests = field_settle(field, 1e-9, 20000, &sum, &passes, NULL) == DONE;
    field_places(field, x);
    double left = deepest(dim, n, x);
    printf("%s%dD: %d passes, overlap %s 1e-9, rim %.4g", dim > 2 ? "; " : "",
           dim, passes, left < 1e-9 ? "<" : ">", field_rim(field));
    good = good && rests && left < 1e-9 && fabs(left - field_overlap(field)) < 1e-14;
    field_free(&field);
    free(x);
  }
  return good;
}

static bool dilute_to_itself(void) {
  Species species = {"A", 1, 1000};
  GravityPlan plan = {.mode = GRAVITY_ADAPTIVE};
  Rng rng = rng_stream(8, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = gravity_pack(3, &species, 1, NULL, &plan, &rng, NULL, &out);
  DilutePlan to = {.fraction = core_fraction(pack, 0.6 * pack->open), .inside = 0.6, .part = 1};
  Pack *same = dilute_pack(pack, &to, &rng, NULL, &out);
  double off = same ? fabs(core_fraction(same, 0.6 * same->open) - to.fraction) : 1;
  printf("status %d, fraction %.6g, off by %s 1e-12", out.status, to.fraction,
         off < 1e-12 ? "<" : ">");
  bool good = out.status == DONE && off < 1e-12 && clear(same, 1.00001e-9);
  pack_free(&pack);
  pack_free(&same);
  return good;
}

static const struct {
  const char *name;
  bool (*run)(void);
} cases[] = {
    {"field-from-a-point", field_from_a_point},
    {"dilute-to-itself", dilute_to_itself},
    {"shake-dense", shake_dense},
    {"shake-jammed", shake_jammed},
    {"shake-windows", shake_windows},
    {"shake-one", shake_one},
    {"shake-discs", shake_discs},
    {"shake-hundred", shake_hundred},
    {"shake-held", shake_held},
    {"chain-jammed", chain_jammed},
    {"chain-few", chain_few},
    {"chain-empty", chain_empty},
    {"chain-held", chain_held},
    {"grow-one", grow_one},
    {"grow-two-many", grow_two_many},
    {"grow-from-a-point", grow_from_a_point},
    {"grow-continuous", grow_continuous},
    {"touching", touching},
    {"touching-full", touching_full},
    {"overlapping-a-bit", overlapping_a_bit},
    {"overlapping-more", overlapping_more},
    {"no-particle", no_particle}, {"two-particles", two_particles},
    {"narrow-box", narrow_box},   {"flat-box", flat_box},
    {"long-box", long_box},       {"size-ratio", size_ratio},
    {"one-point", one_point},     {"at-the-side", at_the_side},
    {"tangent", tangent},         {"room-for-one", room_for_one},
    {"py-dilute", py_dilute},     {"py-before", py_before},
    {"py-dense", py_dense},       {"py-far", py_far},
};

int main(int count, char *words[]) {
  for (size_t g = 0; count == 2 && g < sizeof growths / sizeof *growths; g++)
    if (strcmp(words[1], growths[g].name) == 0)
      return !grow_of_table(g);
  for (size_t c = 0; count == 2 && c < sizeof cases / sizeof *cases; c++)
    if (strcmp(words[1], cases[c].name) == 0)
      return !cases[c].run();
  fprintf(stderr, "hard: no such case\n");
  return 2;
}
