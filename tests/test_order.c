/* tests/test_order.c: against brute force, closed forms and ideal gases */
#include "cells.h"
#include "many.h"
#include "lattice.h"
#include "order.h"
#include "outcome.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sf.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

enum { IMAGES = 4 }; /* brute force looks into so many copies each way */

static void throw(Pack * pack, Rng *rng) {
  size_t dim = (size_t)pack->box.dim;
  for (size_t i = 0; i < pack->n * dim; i++)
    pack->x[i] = rng_uniform(rng) * pack->box.side[i % dim];
}

static Pack *gas(int dim, size_t n, double radius, const double side[]) {
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Species one = {"gas", radius, n};
  return pack_alloc(&box, &one, 1, false);
}

/* Two species, one third and two thirds, or a radius for each particle. */
static Pack *mixture(int dim, size_t n, bool own, const double side[],
                     Rng *rng) {
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Species two[2] = {{"coarse", 0.217, n / 3}, {"fine", 0.093, n - n / 3}};
  Pack *pack = pack_alloc(&box, two, 2, own);
  throw(pack, rng);
  for (size_t i = 0; own && i < n; i++)
    pack->radius[i] = 0.05 + 0.2 * rng_uniform(rng);
  return pack;
}

/* Random sequential addition by brute force. */
static Pack *rsa(int dim, size_t n, double radius, const double side[],
                 Rng *rng) {
  Pack *pack = gas(dim, n, radius, side);
  size_t d = (size_t)dim;
  for (size_t i = 0; i < n; i++) {
    bool clear;
    do {
      clear = true;
      for (size_t k = 0; k < d; k++)
        pack->x[i * d + k] = rng_uniform(rng) * side[k];
      for (size_t j = 0; clear && j < i; j++) {
        double square = 0;
        for (size_t k = 0; k < d; k++)
          square += gsl_pow_2(
              box_nearest(pack->x[j * d + k] - pack->x[i * d + k], side[k]));
        clear = square >= gsl_pow_2(2 * radius);
      }
    } while (!clear);
  }
  return pack;
}

/* The separation of an image, from which the search must not differ by a bit;
   false for the point itself. */
static bool image(const Pack *pack, const double at[], size_t j, int copy,
                  double d[3], double *square) {
  size_t dim = (size_t)pack->box.dim;
  *square = 0;
  d[2] = 0;
  for (size_t k = 0; k < dim; k++, copy /= 2 * IMAGES + 1) {
    double shift = (copy % (2 * IMAGES + 1) - IMAGES) * pack->box.side[k];
    d[k] = (pack->x[j * dim + k] - at[k]) + shift;
    *square += d[k] * d[k];
  }
  return *square > 0 || at != pack->x + j * dim;
}

static int copies(const Pack *pack) {
  return (int)gsl_pow_int(2 * IMAGES + 1, pack->box.dim);
}

static size_t count(const Pack *pack, const double at[], double radius) {
  size_t inside = 0;
  double d[3], square;
  for (size_t j = 0; j < pack->n; j++)
    for (int copy = 0; copy < copies(pack); copy++)
      if (image(pack, at, j, copy, d, &square))
        inside += square < radius * radius;
  return inside;
}

/* Every measure of a pack by brute force against the module's: windows. */
static void brute_windows(const Pack *pack, double radius, const char *name) {
  size_t dim = (size_t)pack->box.dim, many = 57;
  for (int kind = WINDOWS_AROUND; kind <= WINDOWS_RANDOM; kind++) {
    Rng rng = rng_stream(71, 3, RNG_MEASURE), again = rng;
    Windows *windows = order_windows_alloc();
    order_windows(pack, radius, (WindowKind)kind, many, &rng, windows);
    size_t n = kind == WINDOWS_RANDOM ? many : pack->n;
    double *p = memory(windows->size, sizeof *p), mean = 0, square = 0;
    bool outside = false;
    for (size_t i = 0; i < n; i++) {
      double point[3];
      for (size_t k = 0; k < dim; k++)
        point[k] = kind == WINDOWS_RANDOM
                       ? rng_uniform(&again) * pack->box.side[k]
                       : 0;
      const double *at =
          kind == WINDOWS_RANDOM ? point : (const double *)pack->x + i * dim;
      size_t found = count(pack, at, radius) + (kind == WINDOWS_COUNTED);
      outside |= found >= windows->size;
      p[found < windows->size ? found : 0]++;
      mean += (double)found / (double)n;
      square += gsl_pow_2((double)found) / (double)n;
    }
    int wrong = outside;
    for (size_t k = 0; k < windows->size; k++)
      wrong += windows->p[k] != p[k] / (n ? (double)n : 1);
    gsl_test_int(wrong, 0, "%s: windows of kind %d", name, kind);
    gsl_test_int((int)windows->windows, (int)n, "%s: their number", name);
    gsl_test_abs(windows->mean, mean, 1e-12 * (1 + mean), "%s: mean", name);
    gsl_test_abs(windows->variance, square - mean * mean, 1e-10 * (1 + square),
                 "%s: variance", name);
    free(p);
    order_windows_free(&windows);
  }
}

/* Windows on the centres of another pack: on the pack's own centres each counts
   itself; on others', against brute force. */
static void windows_around(const Pack *pack, double radius, const char *name) {
  size_t dim = (size_t)pack->box.dim;
  Rng rng = rng_stream(71, 4, RNG_MEASURE);
  Windows *own = order_windows_alloc(), *same = order_windows_alloc();
  order_windows(pack, radius, WINDOWS_COUNTED, 0, &rng, own);
  order_windows_around(pack, pack, radius, same);
  int wrong = own->size != same->size;
  for (size_t n = 0; !wrong && n < own->size; n++)
    wrong += own->p[n] != same->p[n];
  gsl_test_int(wrong, 0, "%s: windows around its own centres count them", name);
  Species few = {.radius = 0.1, .count = 7};
  Pack *others = pack_alloc(&pack->box, &few, 1, false);
  double mean = 0;
  for (size_t i = 0; i < others->n; i++) {
    for (size_t k = 0; k < dim; k++)
      others->x[i * dim + k] = rng_uniform(&rng) * pack->box.side[k];
    mean += (double)count(pack, others->x + i * dim, radius) / 7;
  }
  order_windows_around(others, pack, radius, same);
  gsl_test_abs(same->mean, mean, 1e-12 * (1 + mean), "%s: and around others", name);
  gsl_test_int((int)same->windows, 7, "%s: as many as there are others", name);
  pack_free(&others);
  order_windows_free(&own);
  order_windows_free(&same);
}

static void brute_nearest(const Pack *pack, bool gap, const char *name) {
  size_t dim = (size_t)pack->box.dim;
  double *nearest = memory(pack->n, sizeof *nearest), d[3], square, sum = 0;
  double mean = order_nearest(pack, gap, nearest);
  int wrong = 0;
  for (size_t i = 0; i < pack->n; i++) {
    double least = GSL_POSINF;
    for (size_t j = 0; j < pack->n; j++)
      for (int copy = 0; copy < copies(pack); copy++)
        if (image(pack, pack->x + i * dim, j, copy, d, &square)) {
          double both = pack_radius(pack, i) + pack_radius(pack, j);
          least = GSL_MIN(least, sqrt(square) - (gap ? both : 0));
        }
    wrong += nearest[i] != least;
    sum += least;
  }
  gsl_test_int(wrong, 0, "%s: nearest %s", name, gap ? "gaps" : "distances");
  gsl_test_abs(mean, pack->n ? sum / (double)pack->n : 0, 1e-12,
               "%s: their mean", name);
  free(nearest);
}

static void brute_contacts(const Pack *pack, double tolerance,
                           const char *name) {
  size_t dim = (size_t)pack->box.dim, contacts = 0;
  double d[3], square;
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = 0; j < pack->n; j++)
      for (int copy = 0; copy < copies(pack); copy++) {
        double both = pack_radius(pack, i) + pack_radius(pack, j);
        if (image(pack, pack->x + i * dim, j, copy, d, &square))
          contacts += square <= gsl_pow_2((1 + tolerance) * both);
      }
  double each = pack->n ? (double)contacts / (double)pack->n : 0;
  gsl_test(order_contacts(pack, tolerance) != each, "%s: contacts at %g", name,
           tolerance);
}

/* Bond order by double sums of P6, or of cosines in the plane, over bonds. */
typedef struct {
  double u[3];
  size_t i, j;
} Bond;

static double kernel(int dim, const Bond *a, const Bond *b) {
  double cosine = a->u[0] * b->u[0] + a->u[1] * b->u[1] + a->u[2] * b->u[2];
  cosine = GSL_MAX(-1, GSL_MIN(1, cosine));
  return dim == 2 ? cos(6 * acos(cosine)) : gsl_sf_legendre_Pl(6, cosine);
}

static size_t gather(const Pack *pack, double cut, Bond *bond) {
  size_t dim = (size_t)pack->box.dim, bonds = 0;
  double d[3], square;
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = 0; j < pack->n; j++)
      for (int copy = 0; copy < copies(pack); copy++) {
        double both = pack_radius(pack, i) + pack_radius(pack, j);
        if (!image(pack, pack->x + i * dim, j, copy, d, &square) ||
            square > gsl_pow_2(cut * both))
          continue;
        if (bond)
          bond[bonds] = (Bond){
              {d[0] / sqrt(square), d[1] / sqrt(square), d[2] / sqrt(square)},
              i,
              j};
        bonds++;
      }
  return bonds;
}

static bool chosen(size_t i, int some) {
  return !some || i * i % 4 == 1;
}

/* Over all, and over some of them: every second, whose bonds may end anywhere. */
static void brute_bonds(const Pack *pack, BondRule rule, const char *name) {
  size_t bonds = gather(pack, rule.cut, NULL), n = pack->n;
  Bond *bond = memory(bonds, sizeof *bond);
  double *dot = memory(n * n, sizeof *dot), total[2] = {0};
  int *own = memory(n, sizeof *own), *good = memory(n, sizeof *good);
  bool *of = memory(n, sizeof *of);
  gather(pack, rule.cut, bond);
  for (size_t a = 0; a < bonds; a++)
    for (size_t b = 0; b < bonds; b++) {
      double value = kernel(pack->box.dim, bond + a, bond + b);
      dot[bond[a].i * n + bond[b].i] += value;
      for (int some = 0; some < 2; some++)
        if (chosen(bond[a].i, some) && chosen(bond[b].i, some))
          total[some] += value;
    }
  for (size_t a = 0; a < bonds; a++) {
    size_t i = bond[a].i, j = bond[a].j;
    own[i]++;
    good[i] +=
        dot[i * n + j] / sqrt(dot[i * n + i] * dot[j * n + j]) > rule.aligned;
  }
  for (int some = 0; some < 2; some++) {
    double local = 0, solid = 0, begin = 0, many = 0;
    for (size_t i = 0; i < n; i++)
      if ((of[i] = chosen(i, some))) {
        many++;
        begin += own[i];
        local += own[i] ? sqrt(dot[i * n + i]) / own[i] : 0;
        solid += good[i] >= rule.bonds;
      }
    BondOrder order = order_bonds(pack, &rule, some ? of : NULL);
    const char *whose = some ? "some" : "all";
    many = GSL_MAX(many, 1);
    gsl_test(order.bonds != begin / many, "%s: bonds of %s", name, whose);
    gsl_test_abs(order.global, begin > 0 ? sqrt(fabs(total[some])) / begin : 0,
                 1e-10, "%s: global order of %s", name, whose);
    gsl_test_abs(order.local, local / many, 1e-10, "%s: local order of %s",
                 name, whose);
    gsl_test(order.solid != solid / many, "%s: solid of %s, %g not %g", name,
             whose, order.solid, solid / many);
  }
  free(of);
  free(good);
  free(own);
  free(dot);
  free(bond);
}

/* The backbone by taking away, round after round, whoever has too few contacts
   with those that are left; and what some of the particles have of it. */
static void brute_backbone(const Pack *pack, double tolerance,
                           const char *name) {
  size_t many = gather(pack, 1 + tolerance, NULL), n = pack->n, left = 1;
  Bond *bond = memory(many, sizeof *bond);
  bool *gone = memory(n, sizeof *gone), *of = memory(n, sizeof *of);
  gather(pack, 1 + tolerance, bond);
  size_t *held = memory(n, sizeof *held);
  while (left > 0) {
    left = 0;
    memset(held, 0, n * sizeof *held);
    for (size_t c = 0; c < many; c++)
      held[bond[c].i] += !gone[bond[c].i] && !gone[bond[c].j];
    for (size_t i = 0; i < n; i++)
      if (!gone[i] && held[i] < (size_t)pack->box.dim + 1)
        left += gone[i] = true;
  }
  for (int masked = 0; masked < 2; masked++) {
    size_t all = 0, ends = 0, found = 0, stay = 0;
    for (size_t i = 0; i < n; i++) {
      of[i] = chosen(i, masked);
      all += of[i];
      ends += of[i] ? held[i] : 0;
      stay += of[i] && !gone[i];
    }
    for (size_t c = 0; c < many; c++)
      found += of[bond[c].i];
    Backbone b = order_backbone(pack, tolerance, masked ? of : NULL);
    gsl_test(b.contacts != ends / 2 || b.particles != stay ||
                 b.coordination != (all ? (double)found / (double)all : 0) ||
                 b.backbone != (stay ? (double)ends / (double)stay : 0) ||
                 b.rattlers != (all ? 1 - (double)stay / (double)all : 0),
             "%s: backbone of %s at %g: %zu of %zu", name,
             masked ? "some" : "all", tolerance, stay, all);
  }
  free(held);
  free(of);
  free(gone);
  free(bond);
}

/* Contacts against the radius, with an arc cosine. */
static void brute_radial(const Pack *pack, double tolerance, const char *name) {
  enum { BINS = 7 };
  size_t many = gather(pack, 1 + tolerance, NULL), dim = (size_t)pack->box.dim;
  Bond *bond = memory(many, sizeof *bond);
  bool *of = memory(pack->n, sizeof *of);
  gather(pack, 1 + tolerance, bond);
  for (int masked = 0; masked < 2; masked++) {
    double p[BINS], share[BINS] = {0}, sum = 0, found = 0, worst = 0;
    for (size_t i = 0; i < pack->n; i++)
      of[i] = chosen(i, masked);
    for (size_t c = 0; c < many; c++) {
      double dot = 0, square = 0;
      for (size_t k = 0; k < dim; k++) {
        double x = pack->x[bond[c].i * dim + k] - pack->box.side[k] / 2;
        dot += bond[c].u[k] * x;
        square += x * x;
      }
      double angle = acos(GSL_MIN(fabs(dot) / sqrt(square), 1));
      if (!of[bond[c].i])
        continue;
      sum += dim == 2 ? cos(2 * angle) : gsl_sf_legendre_P2(cos(angle));
      share[(int)(cos(angle) * BINS)]++;
      found++;
    }
    double P2 = order_radial(pack, tolerance, masked ? of : NULL, BINS, p);
    for (int b = 0; b < BINS && found > 0; b++) {
      double even = dim == 3 ? 1. / BINS
                             : (acos((double)b / BINS) -
                                acos(GSL_MIN((b + 1.) / BINS, 1))) /
                                   M_PI_2;
      worst = GSL_MAX(worst, fabs(p[b] - share[b] / found / even));
    }
    gsl_test(!(worst < 1e-10), "%s: contacts by their angle (%g)", name, worst);
    if (found > 0)
      gsl_test_abs(P2, sum / found, 1e-10, "%s: P2 of contacts", name);
    else
      gsl_test(!gsl_isnan(P2) || !gsl_isnan(p[0]), "%s: no contact, NaN", name);
  }
  free(of);
  free(bond);
}

static void brute_all(const Pack *pack, double scale, const char *name) {
  brute_windows(pack, 1.13 * scale, name);
  brute_windows(pack, 0.271 * scale, name);
  windows_around(pack, 0.83 * scale, name);
  brute_nearest(pack, false, name);
  brute_nearest(pack, true, name);
  brute_contacts(pack, 0, name);
  brute_contacts(pack, 0.317, name);
  brute_bonds(pack, order_rule(pack->box.dim), name);
  /* so that some are solid and some are not */
  brute_bonds(pack, (BondRule){2.3, 0.213, 4}, name);
  brute_backbone(pack, 0.05, name);
  brute_backbone(pack, 0.317, name);
  brute_radial(pack, 0, name);
  brute_radial(pack, 0.317, name);
}

static void test_brute(void) {
  const double roomy[3] = {1.93, 2.17, 1.71}, tiny[3] = {0.61, 0.83, 0.57};
  Rng rng = rng_stream(2012, 7, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++) {
    Pack *one = gas(dim, dim == 3 ? 60 : 30, 0.1931, roomy);
    throw(one, &rng);
    brute_all(one, 0.5, dim == 3 ? "gas" : "gas in the plane");
    pack_free(&one);
    Pack *two = mixture(dim, 40, false, roomy, &rng);
    brute_all(two, 0.5, dim == 3 ? "mixture" : "mixture in the plane");
    pack_free(&two);
    Pack *own = mixture(dim, 40, true, roomy, &rng);
    brute_all(own, 0.5, dim == 3 ? "own radii" : "own radii in the plane");
    pack_free(&own);
    for (size_t n = 1; n <= 5; n++) {
      Pack *few = gas(dim, n, 0.2737, tiny);
      throw(few, &rng);
      brute_all(few, 1.1, "a box full of images");
      pack_free(&few);
    }
  }
}

/* Crowds and loners: the search must widen, and must not settle for what it
   happened to see beyond its reach. */
static void test_loners(void) {
  const double side[3] = {3.1, 2.3, 2.7};
  for (uint64_t k = 0; k < 60; k++) {
    int dim = 2 + (int)(k % 2);
    Rng rng = rng_stream(101, k, RNG_TEST);
    Pack *pack = mixture(dim, 24, k % 4 < 2, side, &rng);
    for (size_t i = 0; i < pack->n * (size_t)dim; i++)
      pack->x[i] *= gsl_pow_3(pack->x[i] / side[i % (size_t)dim]);
    for (size_t i = 0; pack->radius && i < pack->n; i++)
      pack->radius[i] *= i % 8 == 0 ? 4 : 0.1;
    brute_nearest(pack, false, "loners");
    brute_nearest(pack, true, "loners");
    pack_free(&pack);
  }
}

/* The nearest surface may belong to the largest particle, out of the reach in
   which a small one was found. */
static void test_giant(void) {
  const double side[3] = {10, 10, 10};
  Rng rng = rng_stream(103, 0, RNG_TEST);
  Pack *pack = mixture(3, 300, true, side, &rng);
  for (size_t i = 0; i < 900; i++)
    pack->x[i] *= 0.1;
  for (size_t i = 0; i < 300; i++)
    pack->radius[i] = 0.01;
  const double at[9] = {3.1, 5.2, 5.3, 2.1, 5.2, 5.3, 6.8, 5.2, 5.3};
  for (size_t i = 0; i < 9; i++)
    pack->x[i] = at[i];
  pack->radius[2] = 3.1;
  double *nearest = memory(300, sizeof *nearest);
  order_nearest(pack, true, nearest);
  gsl_test_abs(nearest[0], 3.7 - 3.11, 1e-14, "the giant's surface is nearer");
  gsl_test_abs(nearest[1], 1 - 0.02, 1e-14, "but not to the other");
  free(nearest);
  pack_free(&pack);
}

static void test_empty(void) {
  const double side[3] = {1.7, 1.3, 1.9};
  Windows *windows = order_windows_alloc();
  Rng rng = rng_stream(5, 0, RNG_MEASURE);
  for (int dim = 2; dim <= 3; dim++) {
    Pack *none = gas(dim, 0, 0.31, side);
    BondRule rule = order_rule(dim);
    BondOrder order = order_bonds(none, &rule, NULL);
    order_windows(none, 0.4, WINDOWS_AROUND, 0, NULL, windows);
    gsl_test(windows->windows != 0 || windows->mean != 0 ||
                 windows->variance != 0,
             "no windows on no particles");
    order_windows(none, 0.4, WINDOWS_RANDOM, 13, &rng, windows);
    gsl_test(windows->size != 1 || windows->p[0] != 1 || windows->mean != 0,
             "random windows on nothing");
    gsl_test(order_nearest(none, true, NULL) != 0, "no neighbours");
    gsl_test(order_contacts(none, 0.1) != 0, "no contacts");
    gsl_test(order.global != 0 || order.local != 0 || order.solid != 0 ||
                 order.bonds != 0,
             "no bonds");
    pack_free(&none);
    /* points without a size, two of them at one place */
    Pack *points = gas(dim, 3, 0, side);
    double nearest[3];
    points->x[2 * dim] = 0.25;
    order_nearest(points, false, nearest);
    gsl_test(nearest[0] != 0 || nearest[1] != 0 || nearest[2] != 0.25,
             "two points at one place");
    gsl_test(order_contacts(points, 0.1) != 0, "points do not touch");
    order = order_bonds(points, &rule, NULL);
    gsl_test(order.bonds != 0, "points have no bonds");
    points->species[0].radius = 0.11;
    order = order_bonds(points, &rule, NULL);
    gsl_test_rel(order.bonds, 4 / 3., 1e-15, "a bond of length 0 is none");
    gsl_test(!(order.global <= 1.000001), "and breaks nothing");
    rule.bonds = 2;
    order = order_bonds(points, &rule, NULL);
    gsl_test_rel(order.solid, 1 / 3., 1e-15, "nor is it solid");
    pack_free(&points);
  }
  order_windows_free(&windows);
  gsl_test(windows != NULL, "windows_free nulls the pointer");
  order_windows_free(&windows);
}

/* The histogram keeps its length from pack to pack, with zeros behind. */
static void test_growing(void) {
  const double side[3] = {2, 2, 2};
  Rng rng = rng_stream(8, 0, RNG_TEST);
  Windows *windows = order_windows_alloc();
  Pack *many = gas(3, 300, 0.1, side), *few = gas(3, 11, 0.1, side);
  throw(many, &rng);
  throw(few, &rng);
  order_windows(many, 0.61, WINDOWS_AROUND, 0, NULL, windows);
  size_t size = windows->size;
  gsl_test(windows->p[size - 1] == 0, "no zeros behind the largest count");
  order_windows(few, 0.61, WINDOWS_AROUND, 0, NULL, windows);
  double sum = 0;
  for (size_t n = 0; n < windows->size; n++)
    sum += windows->p[n];
  gsl_test(windows->size != size || windows->p[size - 1] != 0,
           "the length is kept, with zeros behind");
  gsl_test_rel(sum, 1, 1e-14, "the fractions add to 1");
  pack_free(&few);
  pack_free(&many);
  order_windows_free(&windows);
}

/* One random window a pack: independent, and binomial. */
static void test_binomial(int dim, double radius) {
  enum { N = 37 };
  const int PACKS = as_many(1500, 4000);
  const double side[3] = {2.3, 1.9, 2.7};
  Pack *pack = gas(dim, N, 0.1, side);
  Windows *windows = order_windows_alloc();
  double seen[N + 1] = {0}, chi = 0, rest = PACKS, rare = PACKS;
  double share = pack_ball(dim, radius) / box_volume(&pack->box);
  int bins = 0;
  for (uint64_t k = 0; k < (uint64_t)PACKS; k++) {
    Rng rng = rng_stream(31, k, RNG_TEST),
        eyes = rng_stream(31, k, RNG_MEASURE);
    throw(pack, &rng);
    order_windows(pack, radius, WINDOWS_RANDOM, 1, &eyes, windows);
    seen[(size_t)windows->mean]++;
  }
  for (unsigned n = 0; n <= N; n++) {
    double expected = PACKS * gsl_ran_binomial_pdf(n, share, N);
    if (expected < 8)
      continue;
    chi += gsl_pow_2(seen[n] - expected) / expected;
    rest -= expected;
    rare -= seen[n];
    bins++;
  }
  chi += gsl_pow_2(rare - rest) / rest;
  double q = gsl_cdf_chisq_Q(chi, bins);
  gsl_test(bins < 7 || q < 1e-3 || q > 0.9999,
           "random windows, dim = %d: chi^2 = %g of %d, Q = %g", dim, chi, bins,
           q);
  order_windows_free(&windows);
  pack_free(&pack);
}

/* Windows on particles: each p(n) within 4 standard errors over packs, whose
   windows overlap, and binomial with one particle less. */
static void test_around(int dim, double radius) {
  enum { N = 29 };
  const int PACKS = as_many(600, 1500);
  const double side[3] = {2.3, 1.9, 2.7};
  Pack *pack = gas(dim, N, 0.1, side);
  Windows *windows = order_windows_alloc();
  double sum[N] = {0}, squares[N] = {0}, worst = 0;
  double share = pack_ball(dim, radius) / box_volume(&pack->box);
  int bins = 0;
  for (uint64_t k = 0; k < (uint64_t)PACKS; k++) {
    Rng rng = rng_stream(47, k, RNG_TEST);
    throw(pack, &rng);
    order_windows(pack, radius, WINDOWS_AROUND, 0, NULL, windows);
    for (size_t n = 0; n < N && n < windows->size; n++) {
      sum[n] += windows->p[n] / PACKS;
      squares[n] += windows->p[n] * windows->p[n] / PACKS;
    }
  }
  for (unsigned n = 0; n < N; n++) {
    double expected = gsl_ran_binomial_pdf(n, share, N - 1);
    double se = sqrt((squares[n] - sum[n] * sum[n]) / (PACKS - 1));
    if (expected < 0.01)
      continue;
    worst = GSL_MAX(worst, fabs(sum[n] - expected) / se);
    bins++;
  }
  gsl_test(bins < 7 || worst > 4, "windows on particles, dim = %d: %g se of %d",
           dim, worst, bins);
  order_windows_free(&windows);
  pack_free(&pack);
}

/* The mean distance of a gas is a beta function; over 30 packs, 4 se. */
static void test_gas_nearest(int dim, size_t n) {
  enum { BINS = 12 };
  const int PACKS = as_many(16, 30);
  const double side[3] = {13.1, 11.7, 12.3};
  Pack *pack = gas(dim, n, 0.1, side);
  double *nearest = memory(n, sizeof *nearest), sum = 0, squares = 0;
  double volume = box_volume(&pack->box), unit = pack_ball(dim, 1), worst = 0;
  double step = 0.17 * pow(volume / (double)n, 1. / dim);
  double H[BINS], total[BINS] = {0}, total2[BINS] = {0};
  double exact =
      pow(volume / unit, 1. / dim) * gsl_sf_beta(1. / dim, (double)n) / dim;
  gsl_test_rel(exact * pow((double)n / volume, 1. / dim),
               dim == 3 ? 0.554 : 0.5, 1e-3, "the limit of large N");
  for (uint64_t k = 0; k < (uint64_t)PACKS; k++) {
    Rng rng = rng_stream(61, k, RNG_TEST);
    throw(pack, &rng);
    double mean = order_nearest(pack, false, nearest);
    sum += mean / PACKS;
    squares += mean * mean / PACKS;
    order_density(nearest, n, 0, step, BINS, H);
    for (int b = 0; b < BINS; b++) {
      total[b] += H[b] / PACKS;
      total2[b] += H[b] * H[b] / PACKS;
    }
  }
  double se = sqrt((squares - sum * sum) / (PACKS - 1));
  gsl_test_abs(sum, exact, 4 * se, "nearest neighbour of a gas, dim = %d", dim);
  gsl_test(!(se < 3e-3 * exact), "whose error is small");
  for (int b = 0; b < BINS; b++) {
    double in = pack_ball(dim, b * step) / volume, more = (double)n - 1;
    double out = pack_ball(dim, (b + 1) * step) / volume;
    double bin = (pow(1 - in, more) - pow(1 - out, more)) / step;
    double error = sqrt((total2[b] - total[b] * total[b]) / (PACKS - 1));
    if (bin * step * (double)n > 20)
      worst = GSL_MAX(worst, fabs(total[b] - bin) / error);
  }
  gsl_test(!(worst < 4), "its density H(r), dim = %d: %g se", dim, worst);
  free(nearest);
  pack_free(&pack);
}

static void test_density(void) {
  const double value[7] = {-1e-17, 0.2999999999999, 0.3, 0.31, 0.6, 1.2, -0.4};
  double H[4];
  order_density(value, 7, 0, 0.3, 4, H);
  gsl_test_rel(H[0], 1 / (7 * 0.3), 1e-15, "a value that rounding put below 0");
  gsl_test_rel(H[1], 3 / (7 * 0.3), 1e-15, "values at an edge");
  gsl_test_rel(H[2], 1 / (7 * 0.3), 1e-15, "a value at the next edge");
  gsl_test(H[3] != 0, "values beyond the bins are in none");
  order_density(value, 0, 0, 0.3, 4, H);
  gsl_test(H[0] != 0 || H[1] != 0, "no values have no density");
}

/* Contacts, windows and bond order of the lattices. */
static const struct {
  LatticeKind kind;
  double cut, global, solid;
  int bonds, contacts;
} crystals[] = {
    {LATTICE_CUBIC, 1.4, 0.35355339059327376, 0, 6, 6},
    {LATTICE_CUBIC, 1.45, 0.26516504294495533, 1, 18, 6},
    {LATTICE_BCC, 1.4, 0.51068823085695094, 1, 14, 8},
    {LATTICE_BCC, 1.1, 0.62853936105470899, 1, 8, 8},
    {LATTICE_FCC, 1.4, 0.57452425971406984, 1, 12, 12},
    {LATTICE_FCC, 1.45, 0.26516504294495533, 1, 18, 12},
    {LATTICE_SQUARE, 1.4, 0, 0, 4, 4},
    {LATTICE_TRIANGULAR, 1.4, 1, 1, 6, 6},
};

static void test_crystals(void) {
  gsl_test_rel(crystals[0].global, sqrt(1. / 8), 1e-15, "closed form, sc");
  gsl_test_rel(crystals[2].global, 13 * sqrt(2) / 36, 1e-15, "bcc, 14");
  gsl_test_rel(crystals[3].global, sqrt(32) / 9, 1e-15, "bcc, 8");
  gsl_test_rel(crystals[4].global, sqrt(169. / 512), 1e-15, "fcc");
  gsl_test_rel(crystals[5].global, 3 / sqrt(128), 1e-15, "fcc, 18");
  Species one = {"", 0.5713, 0};
  for (size_t c = 0; c < sizeof crystals / sizeof crystals[0]; c++)
    for (int n_l = 0; n_l < 3; n_l++) {
      const char *name = lattice_name(crystals[c].kind);
      Pack *pack = lattice_make(crystals[c].kind, n_l, &one, 0);
      BondRule rule = order_rule(pack->box.dim);
      rule.cut = crystals[c].cut;
      BondOrder order = order_bonds(pack, &rule, NULL);
      gsl_test_abs(order.global, crystals[c].global, 1e-12, "%s: global", name);
      gsl_test_abs(order.local, crystals[c].global, 1e-12, "%s: local", name);
      gsl_test(order.solid != crystals[c].solid, "%s: solid", name);
      gsl_test(order.bonds != crystals[c].bonds, "%s: bonds", name);
      rule.bonds = 1;
      order = order_bonds(pack, &rule, NULL);
      gsl_test(order.solid != (crystals[c].global > 0),
               "%s: a zero vector is not aligned", name);
      for (double tolerance = 1e-12; tolerance < 0.14; tolerance *= 11)
        gsl_test(order_contacts(pack, tolerance) != crystals[c].contacts,
                 "%s: contacts at %g", name, tolerance);
      Windows *windows = order_windows_alloc();
      order_windows(pack, 2.01 * 0.5713, WINDOWS_COUNTED, 0, NULL, windows);
      gsl_test((int)windows->size != crystals[c].contacts + 2 ||
                   windows->p[crystals[c].contacts + 1] != 1 ||
                   windows->variance != 0,
               "%s: windows of the first shell", name);
      order_windows_free(&windows);
      pack_free(&pack);
    }
}

/* The close packing with layers ABAB: two rectangular cells of four. */
static void test_hcp(void) {
  const double side[3] = {2, M_SQRT3, sqrt(8. / 3)};
  const double cell[4][3] = {{0, 0, 0},
                             {0.5, M_SQRT3 / 2, 0},
                             {0.5, M_SQRT3 / 6, sqrt(2. / 3)},
                             {0, 2 * M_SQRT3 / 3, sqrt(2. / 3)}};
  Pack *pack = gas(3, 8, 0.5, side);
  for (size_t i = 0; i < 8; i++)
    for (size_t k = 0; k < 3; k++)
      pack->x[3 * i + k] =
          cell[i % 4][k] + (k == 0 ? (double)(i / 4) : 0) + 0.1;
  BondRule rule = order_rule(3);
  BondOrder order = order_bonds(pack, &rule, NULL);
  gsl_test_abs(pack_audit(pack), 0, 1e-15, "hcp touches");
  gsl_test(order.bonds != 12, "hcp: bonds");
  gsl_test_rel(order.global, 13 * sqrt(1038) / 864, 1e-12, "hcp: global");
  gsl_test_rel(order.local, 13 * sqrt(1038) / 864, 1e-12, "hcp: local");
  gsl_test(order.solid != 1, "hcp: solid");
  pack_free(&pack);
}

/* The addition theorem: what is made of products is invariant. */
static void test_harmonics(void) {
  Rng rng = rng_stream(17, 0, RNG_TEST);
  double worst[4] = {0};
  int wrong = 0;
  for (int trial = 0; trial < 3000; trial++)
    for (int dim = 2; dim <= 3; dim++) {
      double u[3] = {0}, v[3] = {0}, S[ORDER_PARTS], T[ORDER_PARTS], sum = 0;
      rng_direction(&rng, dim, u);
      rng_direction(&rng, dim, v);
      int parts = order_harmonics(dim, u, S);
      wrong += parts != (dim == 2 ? 2 : ORDER_PARTS) ||
               parts != order_harmonics(dim, v, T);
      for (int k = 0; k < parts; k++)
        sum += S[k] * T[k];
      double cosine = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
      double exact =
          dim == 2 ? cos(6 * acos(cosine)) : gsl_sf_legendre_Pl(6, cosine);
      worst[dim] = GSL_MAX(worst[dim], fabs(sum - exact));
      for (int k = 0; k < 3; k++)
        v[k] = -u[k];
      order_harmonics(dim, v, T);
      for (int k = 0; k < parts; k++)
        worst[dim - 2] = GSL_MAX(worst[dim - 2], fabs(S[k] - T[k]));
    }
  gsl_test_int(wrong, 0, "13 parts in space and 2 in the plane");
  gsl_test_abs(worst[2], 0, 1e-12, "addition theorem in the plane");
  gsl_test_abs(worst[3], 0, 1e-12, "addition theorem in space");
  gsl_test(worst[0] != 0 || worst[1] != 0, "even degree: no sign of u");
}

/* A cubic lattice turned by the angle of the triangle 3, 4, 5 has the period
   of five cells: a periodic pack that is rotated. In the plane, one layer. */
static Pack *rotated(LatticeKind kind, double u) {
  Species one = {"", 0.5713, 0};
  Pack *cell = lattice_make(kind, 0, &one, 0), *pack;
  size_t dim = (size_t)cell->box.dim, n = 0;
  double c = cell->box.side[0], side[3] = {5 * c, 5 * c, c};
  pack = gas((int)dim, 25 * cell->n, 0.5713, side);
  for (int i = -9; i <= 9; i++)
    for (int j = -9; j <= 9; j++)
      for (size_t p = 0; p < cell->n; p++) {
        double x = cell->x[p * dim] + i * c, y = cell->x[p * dim + 1] + j * c;
        double at[3] = {(3 * x - 4 * y) / 5 + u * c,
                        (4 * x + 3 * y) / 5 + u * c,
                        dim == 3 ? cell->x[p * dim + 2] : 0};
        if (at[0] < 0 || at[0] >= side[0] || at[1] < 0 || at[1] >= side[1])
          continue;
        for (size_t k = 0; k < dim && n < pack->n; k++)
          pack->x[n * dim + k] = at[k];
        n++;
      }
  gsl_test(n != pack->n, "rotated %s: number", lattice_name(kind));
  pack_free(&cell);
  return pack;
}

static void test_rotated(void) {
  for (size_t c = 0; c < 7; c++) {
    Pack *pack = rotated(crystals[c].kind, 0.1234567);
    const char *name = lattice_name(crystals[c].kind);
    BondRule rule = order_rule(pack->box.dim);
    rule.cut = crystals[c].cut;
    BondOrder order = order_bonds(pack, &rule, NULL);
    gsl_test_abs(pack_audit(pack), 0, 1e-14, "rotated %s touches", name);
    gsl_test_abs(order.global, crystals[c].global, 1e-12, "rotated %s: global",
                 name);
    gsl_test_abs(order.local, crystals[c].global, 1e-12, "rotated %s: local",
                 name);
    gsl_test(order.bonds != crystals[c].bonds, "rotated %s: bonds", name);
    gsl_test(order.solid != crystals[c].solid, "rotated %s: solid", name);
    rule.bonds = 1;
    order = order_bonds(pack, &rule, NULL);
    gsl_test(order.solid != (crystals[c].global > 0),
             "rotated %s: a sum of rounding errors is not aligned", name);
    pack_free(&pack);
  }
}

/* Axes exchanged and reflected. */
static void test_turned(void) {
  const double side[3] = {2.31, 1.93, 2.77}, turned[3] = {2.77, 2.31, 1.93};
  Rng rng = rng_stream(23, 0, RNG_TEST);
  Pack *pack = gas(3, 150, 0.2311, side), *other = gas(3, 150, 0.2311, turned);
  throw(pack, &rng);
  for (size_t i = 0; i < 150; i++)
    for (size_t k = 0; k < 3; k++) {
      double x = pack->x[3 * i + k], y = k == 1 ? side[1] - x : x;
      other->x[3 * i + (k + 1) % 3] = box_wrap(y, side[k]);
    }
  BondRule rule = order_rule(3);
  BondOrder a = order_bonds(pack, &rule, NULL), b = order_bonds(other, &rule, NULL);
  gsl_test_rel(b.global, a.global, 1e-12, "turned: global");
  gsl_test_rel(b.local, a.local, 1e-12, "turned: local");
  gsl_test(b.solid != a.solid || b.bonds != a.bonds, "turned: counts");
  pack_free(&other);
  pack_free(&pack);
}

/* Independent bonds are a random walk: B (B Q^2 - 1) is 0 on average, B the
   number of bonds; 4 standard errors. */
static void test_walk(int dim) {
  const int PACKS = as_many(1200, 3000);
  const double side[3] = {2.3, 2.1, 1.9};
  Pack *pack = gas(dim, 60, 0.13, side);
  BondRule rule = order_rule(dim);
  double sum = 0, squares = 0;
  for (uint64_t k = 0; k < (uint64_t)PACKS; k++) {
    Rng rng = rng_stream(83, k, RNG_TEST);
    throw(pack, &rng);
    BondOrder order = order_bonds(pack, &rule, NULL);
    double bonds = order.bonds * 30;
    double walk = bonds * bonds * order.global * order.global - bonds;
    sum += walk / PACKS;
    squares += walk * walk / PACKS;
  }
  double se = sqrt((squares - sum * sum) / (PACKS - 1));
  gsl_test_abs(sum, 0, 4 * se, "bonds of a gas walk at random, dim = %d", dim);
  gsl_test(!(se < 8), "with an error that means something: %g", se);
  pack_free(&pack);
}

/* Disorder is not solid; a crystal that is shaken a little still is. */
static void test_solid(void) {
  const double side[3] = {8.1, 8.3, 7.9};
  Rng rng = rng_stream(91, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++) {
    double radius = dim == 3 ? 0.5 : 0.15;
    size_t n = (size_t)((dim == 3 ? 0.3 : 0.48) * side[0] * side[1] *
                        (dim == 3 ? side[2] : 1) / pack_ball(dim, radius));
    Pack *pack = rsa(dim, n, radius, side, &rng);
    BondRule rule = order_rule(dim);
    BondOrder order = order_bonds(pack, &rule, NULL);
    gsl_test(order.solid > 0.02, "dim = %d: RSA is not solid, %g", dim,
             order.solid);
    gsl_test(order.global * sqrt(order.bonds * (double)n / 2) > 3,
             "dim = %d: RSA has no global order, %g", dim, order.global);
    pack_free(&pack);
    Species one = {"", 0.5, 0};
    pack = lattice_make(dim == 3 ? LATTICE_FCC : LATTICE_TRIANGULAR, 3, &one,
                        dim == 3 ? 0.6 : 0.75);
    for (size_t i = 0; i < pack->n * (size_t)dim; i++)
      pack->x[i] += 0.1 * (rng_uniform(&rng) - 0.5);
    order = order_bonds(pack, &rule, NULL);
    gsl_test(order.solid < 0.99, "dim = %d: a shaken crystal is, %g", dim,
             order.solid);
    pack_free(&pack);
  }
}

/* The backbone: a crystal, a loose one in its hole, what falls apart. */
static void backbone(void) {
  Species one = {"A", 1, 0};
  Pack *pack = lattice_make(LATTICE_FCC, 1, &one, M_PI / sqrt(18));
  Backbone b = order_backbone(pack, 1e-9, NULL);
  gsl_test(b.coordination != 12 || b.backbone != 12 || b.rattlers != 0 ||
               b.particles != pack->n || b.contacts != 6 * pack->n,
           "fcc: the backbone is all of it, %zu contacts", b.contacts);
  pack_free(&pack);
  /* 27 spheres on a cubic lattice that touch, and a small one in a hole. */
  Box box = {3, {6, 6, 6}};
  Species two[] = {{"A", 1, 27}, {"B", 0.5, 1}};
  pack = pack_alloc(&box, two, 2, false);
  for (size_t i = 0; i < 27; i++) {
    pack->x[3 * i] = 2 * (double)(i / 9);
    pack->x[3 * i + 1] = 2 * (double)(i / 3 % 3);
    pack->x[3 * i + 2] = 2 * (double)(i % 3);
  }
  pack->x[81] = pack->x[82] = pack->x[83] = 1;
  b = order_backbone(pack, 1e-9, NULL);
  gsl_test(b.contacts != 81 || b.particles != 27 || b.backbone != 6,
           "a loose sphere in a cubic lattice is no part of its backbone");
  gsl_test_abs(b.rattlers, 1. / 28, 1e-15, "one rattler of 28");
  gsl_test_abs(b.coordination, 162. / 28, 1e-14, "its coordination");
  pack_free(&pack);
  /* Nine discs in a square, alone: the corners go, then all the others. */
  Box plane = {2, {20, 20, 0}};
  one.count = 9;
  pack = pack_alloc(&plane, &one, 1, false);
  for (size_t i = 0; i < 9; i++) {
    pack->x[2 * i] = 5 + 2 * (double)(i / 3);
    pack->x[2 * i + 1] = 5 + 2 * (double)(i % 3);
  }
  b = order_backbone(pack, 1e-9, NULL);
  gsl_test(b.particles != 0 || b.contacts != 0 || b.rattlers != 1,
           "nothing holds nine discs: %zu are said to be held", b.particles);
  gsl_test_abs(b.coordination, 24. / 9, 1e-14, "their coordination");
  pack_free(&pack);
}

/* A string of balls that touch, outwards along an axis: all is radial, the one
   in the middle counting for nothing; a ring about the middle: all is across,
   but for the bend; an oblique string: radial to rounding. */
static void strings(int dim) {
  enum { N = 9, BINS = 5 };
  const double side[3] = {64, 64, 64};
  double p[BINS];
  Pack *pack = gas(dim, N, 0.5, side);
  for (size_t i = 0; i < N; i++)
    for (size_t k = 0; k < (size_t)dim; k++)
      pack->x[i * (size_t)dim + k] = 32 + (k == 1 ? (double)i : 0);
  double P2 = order_radial(pack, 1e-9, NULL, BINS, p);
  gsl_test(P2 != 1, "%d-D: a radial string has P2 = 1, not %.17g", dim, P2);
  double last = dim == 3 ? BINS : M_PI_2 / acos(0.8);
  gsl_test_rel(p[BINS - 1], last, 1e-14, "%d-D: all in the last bin", dim);
  gsl_test(p[0] != 0 || p[BINS - 2] != 0, "%d-D: none in the others", dim);
  for (size_t i = 0; i < N; i++)
    for (size_t k = 0; k < (size_t)dim; k++)
      pack->x[i * (size_t)dim + k] =
          32 + (i + 1.) * (k == 2 ? 0 : k == 1 ? 0.6 : -0.8);
  P2 = order_radial(pack, 1e-9, NULL, BINS, p);
  gsl_test_abs(P2, 1, 1e-14, "%d-D: an oblique string", dim);
  gsl_test_rel(p[BINS - 1], last, 1e-14, "%d-D: and all in the last bin", dim);
  for (size_t i = 0; i < N; i++) { /* a regular polygon */
    double t = 2 * M_PI * (double)i / N, R = 0.5 / sin(M_PI / N);
    for (size_t k = 0; k < (size_t)dim; k++)
      pack->x[i * (size_t)dim + k] =
          32 + R * (k == 2 ? 0 : k == 1 ? sin(t) : cos(t));
  }
  double c2 = gsl_pow_2(sin(M_PI / N));
  P2 = order_radial(pack, 1e-9, NULL, BINS, p);
  gsl_test_abs(P2, dim == 2 ? 2 * c2 - 1 : (3 * c2 - 1) / 2, 1e-12,
               "%d-D: a ring is across", dim);
  bool of[N] = {false};
  P2 = order_radial(pack, 1e-9, of, BINS, p);
  gsl_test(!gsl_isnan(P2) || !gsl_isnan(p[0]), "%d-D: nobody, NaN", dim);
  pack_free(&pack);
}

/* Bonds of the cubic lattice with six neighbours to the radius of a particle at
   (1, 2, 3): c = 1, 2, 3 over the root of 14, twice each. */
static void radial_lattice(void) {
  enum { BINS = 10 };
  Species one = {"", 0.5, 0};
  Pack *pack = lattice_make(LATTICE_CUBIC, 3, &one, 0);
  double p[BINS], least = pack->box.side[0];
  bool *of = memory(pack->n, sizeof *of);
  size_t who = 0;
  for (size_t i = 0; i < pack->n; i++) {
    double off = 0;
    for (size_t k = 0; k < 3; k++) /* from the one in the middle */
      off += gsl_pow_2(pack->x[3 * i + k] - pack->box.side[k] / 2);
    if (off < least) {
      least = off;
      who = i;
    }
  }
  double at[3];
  for (size_t k = 0; k < 3; k++)
    at[k] = pack->x[3 * who + k];
  for (size_t i = 0; i < pack->n * 3; i++) /* so that it is there exactly */
    pack->x[i] = box_wrap(pack->x[i] - at[i % 3] + pack->box.side[i % 3] / 2,
                          pack->box.side[i % 3]);
  for (size_t i = 0; i < pack->n; i++) {
    double x[3];
    for (size_t k = 0; k < 3; k++)
      x[k] = pack->x[3 * i + k] - pack->box.side[k] / 2 - (double)k - 1;
    of[i] = fabs(x[0]) + fabs(x[1]) + fabs(x[2]) < 1e-9;
  }
  double P2 = order_radial(pack, 1e-9, of, BINS, p);
  gsl_test_abs(P2, 0, 1e-12, "cubic: P2 is 0 at each place");
  gsl_test_rel(p[2], BINS / 3., 1e-12, "cubic: 1 over the root of 14");
  gsl_test_rel(p[5], BINS / 3., 1e-12, "cubic: 2 over the root of 14");
  gsl_test_rel(p[8], BINS / 3., 1e-12, "cubic: 3 over the root of 14");
  of[who] = true;
  gsl_test(order_radial(pack, 1e-9, of, BINS, p) != P2,
           "cubic: the one in the middle has no radius");
  free(of);
  pack_free(&pack);
}

/* Isotropic packs: the mean of P2 is 0 and p is 1, over packs, 4 se. */
static void isotropy(int dim) {
  enum { PACKS = 40, BINS = 4 };
  const double side[3] = {7.1, 7.1, 7.1};
  double sum[BINS + 1] = {0}, square[BINS + 1] = {0}, worst = 0;
  size_t n = dim == 3 ? 150 : 34;
  for (uint64_t s = 0; s < PACKS; s++) {
    double p[BINS + 1];
    Rng rng = rng_stream(47, s, RNG_TEST);
    Pack *pack = rsa(dim, n, dim == 3 ? 0.5 : 0.45, side, &rng);
    p[BINS] = order_radial(pack, 0.2, NULL, BINS, p);
    for (int b = 0; b <= BINS; b++) {
      sum[b] += p[b] / PACKS;
      square[b] += p[b] * p[b] / PACKS;
    }
    pack_free(&pack);
  }
  for (int b = 0; b <= BINS; b++) {
    double se = sqrt((square[b] - sum[b] * sum[b]) / (PACKS - 1));
    worst = GSL_MAX(worst, fabs(sum[b] - (b < BINS)) / se);
  }
  double error = sqrt(square[BINS] / PACKS);
  gsl_test(!(worst < 4 && error < 0.02),
           "%d-D: no preferred direction (%.2f se; P2 = %.4f(%.4f))", dim, worst,
           sum[BINS], error);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    strings(dim);
    isotropy(dim);
  }
  radial_lattice();
  backbone();
  test_brute();
  test_loners();
  test_giant();
  test_empty();
  test_growing();
  test_binomial(3, 0.831);
  test_binomial(2, 0.713);
  test_around(3, 0.831);
  test_around(2, 0.713);
  test_gas_nearest(3, 4000);
  test_gas_nearest(2, 4000);
  test_density();
  test_crystals();
  test_hcp();
  test_harmonics();
  test_rotated();
  test_turned();
  test_walk(3);
  test_walk(2);
  test_solid();
  return gsl_test_summary();
}
