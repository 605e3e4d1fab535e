/* tests/test_pack.c: what a pack stores, its volumes, and the audit of its gaps */
#include "outcome.h"
#include "pack.h"
#include "rng.h"
#include "same.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static const Box cuboid = {3, {7.25, 9.5, 11.75}}, sheet = {2, {7.25, 9.5, 0}};
static const Species three[] = {{"AP", 1.3, 17}, {"Al", 0.41, 0}, {"HMX", 0.73, 29}};

static void test_storage(void) {
  Pack *one = pack_alloc(&cuboid, three, 1, false), *all = pack_alloc(&sheet, three, 3, false);
  Pack *own = pack_alloc(&cuboid, three, 3, true);
  gsl_test(one->kind || one->radius, "one species: no index, no radii");
  gsl_test(!all->kind || all->radius, "three: an index, no radii");
  gsl_test(!own->kind || !own->radius, "own radii: both");
  gsl_test_int((int)one->n, 17, "as many particles as the species say");
  gsl_test_int((int)all->n, 46, "the sum of three");
  int wrong = 0;
  for (size_t i = 0; i < 46; i++) {
    int s = i < 17 ? 0 : 2;
    wrong += pack_kind(all, i) != s || pack_radius(all, i) != three[s].radius;
    wrong += pack_kind(own, i) != s || own->radius[i] != three[s].radius;
  }
  gsl_test_int(wrong, 0, "species stand together, in order");
  own->radius[20] = 0.977;
  gsl_test(pack_radius(own, 20) != 0.977, "a radius of its own comes first");
  gsl_test(pack_kind(one, 5) != 0 || pack_radius(one, 5) != 1.3, "of one species, too");
  pack_free(&one);
  pack_free(&one);
  gsl_test(one != NULL, "freed is NULL, and may be freed again");
  pack_free(&all);
  pack_free(&own);
}

static void test_bytes(void) {
  static const int known[2][2][2] = {{{16, 24}, {18, 26}}, {{24, 32}, {26, 34}}};
  for (int dim = 2; dim <= 3; dim++)
    for (int kinds = 1; kinds <= 2; kinds++)
      for (int own = 0; own <= 1; own++)
        gsl_test_int((int)pack_bytes(dim, kinds, own, false), known[dim - 2][kinds - 1][own],
                     "bytes a particle: %d-D, %d species, own radii %d", dim, kinds, own);
  gsl_test_int((int)pack_bytes(2, 1, false, true), 24, "and eight for an angle");
}

/* A pentagon, discs, an ellipse of no particles: shapes are the pack's own, and only such a pack has angles. */
static void test_shapes(void) {
  Species kinds[] = {{"P", 1.3, 17, shape_regular(5)}, {"D", 0.41, 29, NULL}, {"S", 5.1, 0, shape_superellipse(1.75, 1.25)}};
  Pack *pack = pack_alloc(&sheet, kinds, 3, false), *discs = pack_alloc(&sheet, kinds + 1, 1, false);
  Pack *none = pack_alloc(&sheet, kinds + 2, 1, true);
  gsl_test(!pack->angle || !none->angle || discs->angle, "angles where a species has a shape");
  for (int s = 0; s < 3; s += 2) {
    gsl_test(pack->species[s].shape == kinds[s].shape, "shape %d is the pack's own", s);
    shape_free(&kinds[s].shape);
  }
  int wrong = 0;
  for (size_t i = 0; i < pack->n; i++) {
    wrong += pack_shape(pack, i) != (i < 17 ? pack->species[0].shape : NULL) || pack->angle[i] != 0;
    pack->angle[i] = 0.0625 * (double)i + 0.3;
  }
  gsl_test_int(wrong, 0, "shapes of particles, all at angle 0");
  gsl_test_rel(pack_narrowest(pack), 0.41, 1e-15, "the smallest disc inside is a disc's own");
  double r = sqrt(M_PI / (2.5 * sin(0.4 * M_PI)));
  gsl_test_rel(pack_widest(pack), 1.3 * r, 1e-14, "the largest disc around, that of a pentagon");
  gsl_test(pack_narrowest(discs) != 0.41 || pack_widest(discs) != 0.41, "of discs they are the radius");
  gsl_test(pack_narrowest(none) != 0 || pack_widest(none) != 0, "and 0 of no particle");
  gsl_test_rel(pack_solid(pack), M_PI * (17 * 1.69 + 29 * 0.1681), 1e-14, "an area is that of the radius, whatever the shape");
  pack->x[0] = 2.25;
  pack->x[1] = 6.5;
  Body body = pack_body(pack, 0), disc = pack_body(discs, 3);
  gsl_test(body.shape != pack->species[0].shape || body.radius != 1.3 || body.x != 2.25 || body.y != 6.5, "a particle as a body");
  gsl_test_rel(atan2(body.s, body.c), 0.3, 1e-15, "turned by its angle");
  gsl_test(disc.shape || disc.radius != 0.41 || disc.c != 1 || disc.s != 0, "a disc is not turned");
  Pack *copy = pack_copy(pack);
  gsl_test(!same_shapes(copy, pack) || copy->species[0].shape == pack->species[0].shape, "a copy has shapes of its own");
  gsl_test(!copy->angle || memcmp(copy->angle, pack->angle, pack->n * sizeof(double)) != 0, "and the angles");
  pack_free(&pack);
  gsl_test_rel(copy->species[0].shape->outer, r, 1e-14, "which outlive the pack");
  pack_free(&copy);
  pack_free(&none);
  pack_free(&discs);
}

static void test_volumes(void) {
  gsl_test_rel(pack_ball(2, 2.385), 17.8700858719658, 1e-14, "area of a disc");
  gsl_test_rel(pack_ball(3, 2.385), 56.82687307285123, 1e-14, "volume of a sphere");
  Pack *pack = pack_alloc(&cuboid, three, 3, false), *own = pack_alloc(&cuboid, three, 3, true);
  double solid = 4 * M_PI / 3 * (17 * gsl_pow_3(1.3) + 29 * gsl_pow_3(0.73));
  gsl_test_rel(pack_solid(pack), solid, 1e-14, "volume of all, by species");
  gsl_test_rel(pack_solid(own), solid, 1e-14, "volume of all, one by one");
  gsl_test_rel(pack_fraction(pack), solid / (7.25 * 9.5 * 11.75), 1e-14, "packing fraction");
  gsl_test(pack_smallest(pack) != 0.73 || pack_largest(pack) != 1.3, "a species of none has no size");
  own->radius[3] = 0.05;
  own->radius[45] = 2.75;
  gsl_test(pack_smallest(own) != 0.05 || pack_largest(own) != 2.75, "own radii count");
  pack_free(&pack);
  pack_free(&own);
}

static Pack *pair(const Box *box, double radius, const double x[], size_t n) {
  Species species = {"A", radius, n};
  Pack *pack = pack_alloc(box, &species, 1, false);
  if (n)
    memcpy(pack->x, x, n * (size_t)box->dim * sizeof *x);
  return pack;
}

static void audit(const Box *box, double radius, const double x[], size_t n, double gap, const char *what) {
  Pack *pack = pair(box, radius, x, n);
  gsl_test_abs(pack_audit(pack), gap, 1e-14, "least gap: %s", what);
  pack_free(&pack);
}

static void test_audit(void) {
  static const double x[] = {0.25, 0.5, 11.5, 7, 9.25, 0.5};
  audit(&cuboid, 0.3, x, 2, sqrt(0.25 + 0.5625 + 0.5625) - 0.6, "a pair across three sides");
  static const double flat[] = {1.5, 2.25, 4.5, 6.25};
  audit(&sheet, 1.25, flat, 2, 5 - 2.5, "a pair of discs");
  audit(&cuboid, 4.1, x, 1, 7.25 - 8.2, "one sphere and its image");
  static const double same[] = {3.3, 4.4, 3.3, 4.4};
  audit(&sheet, 0.7, same, 2, -1.4, "two at one place");
  Pack *none = pair(&sheet, 1, x, 0);
  gsl_test(pack_audit(none) != GSL_POSINF, "least gap: infinite of none");
  gsl_test(pack_smallest(none) != 0 || pack_largest(none) != 0 || pack_fraction(none) != 0, "and no sizes");
  pack_free(&none);
  Pack *sizes = pack_alloc(&cuboid, three, 3, true);
  Rng rng = rng_stream(3, 0, RNG_TEST);
  for (size_t c = 0; c < 3 * sizes->n; c++)
    sizes->x[c] = cuboid.side[c % 3] * rng_uniform(&rng);
  double before = pack_audit(sizes);
  for (size_t i = 0; i < sizes->n; i++)
    sizes->radius[i] += 0.25;
  gsl_test_abs(pack_audit(sizes), before - 0.5, 1e-13, "larger radii, smaller gap");
  pack_free(&sizes);
}

/* A pack repeats unless told, and a copy is as finite as its pack. */
static void test_finite(void) {
  Box box = {2, {9, 9, 0}};
  Species one = {"A", 0.5, 3};
  Pack *pack = pack_alloc(&box, &one, 1, false);
  gsl_test(pack->open != 0, "a new pack repeats");
  pack->open = 2.25;
  Pack *copy = pack_copy(pack);
  gsl_test(copy->open != 2.25, "a copy of a finite pack is finite");
  pack_free(&copy);
  pack_free(&pack);
}

int main(void) {
  test_finite();
  test_storage();
  test_bytes();
  test_shapes();
  test_volumes();
  test_audit();
  return gsl_test_summary();
}
