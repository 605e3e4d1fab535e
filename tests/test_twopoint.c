/* tests/test_twopoint.c: three methods against each other, and what must hold for the functions of any pack */
#include "many.h"
#include "outcome.h"
#include "twopoint.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *some(int dim, size_t n, size_t m, Shape *shape, const double side[], Rng *rng) {
  Species species[2] = {{.name = "A", .radius = 1.1, .count = n, .shape = shape}, {.name = "B", .radius = 0.7, .count = m}};
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Pack *pack = pack_alloc(&box, species, 2, false);
  for (size_t i = 0; i < pack->n * (size_t)dim; i++)
    pack->x[i] = box.side[i % (size_t)dim] * rng_uniform(rng);
  for (size_t i = 0; pack->angle && i < pack->n; i++)
    pack->angle[i] = 2 * M_PI * rng_uniform(rng);
  shape_free(&shape);
  return pack;
}

static void expect_same(const Twopoint *exact, const Twopoint *other, double tolerance, bool species, const char *what) {
  for (size_t k = 0; k < exact->n; k++) {
    double error = gsl_isnan(other->error[k]) ? 0 : 4 * other->error[k];
    gsl_test_abs(other->S[0][k], exact->S[0][k], tolerance + error, "%s, point %d", what, (int)k);
    double one = other->S[0][k] + 2 * other->S[1][k] + other->S[2][k];
    gsl_test_rel(one, 1, 1e-12, "%s: a, m and mixed, point %d", what, (int)k);
    for (size_t p = 0; species && p < 3; p++)
      gsl_test_abs(other->pair[p * exact->n + k], exact->pair[p * exact->n + k], tolerance + error, "%s, pair %d, point %d", what,
                   (int)p, (int)k);
  }
}

/* Hard: balls and shapes set by hand, so that species share no point. */
static void test_methods(void) {
  static const double side[] = {9, 7, 6}, places[] = {1, 1, 2, 4, 4.2, 1, 7, 1.5, 4, 1.3, 4.9, 4.7};
  Rng rng = rng_stream(21, 0, RNG_TEST);
  Outcome out = {0};
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = some(dim, 2, 2, dim == 2 ? shape_regular(5) : NULL, side, &rng);
    for (int i = 0; i < 4 * dim; i++)
      pack->x[i] = places[3 * (i / dim) + i % dim];
    Twopoint *exact = twopoint_exact(pack, 0.7, 12, true, 1e-4, &out);
    Twopoint *raster = twopoint_raster(pack, 0.7, 12, true, dim == 2 ? 1e6 : 1e6);
    Twopoint *thrown = twopoint_segments(pack, 0.7, 12, true, (size_t)as_many(4000, 100000), &rng);
    expect_same(exact, raster, dim == 2 ? 3e-4 : 2e-3, true, "a raster");
    expect_same(exact, thrown, 1e-4, true, "segments");
    gsl_test_rel(raster->mean, raster->S[0][0] * raster->S[0][0], 1e-13, "the mean over all shifts");
    gsl_test_rel(exact->S[0][0], pack_fraction(pack), 1e-12, "at 0, the fraction");
    for (size_t k = 0; k < 12; k++)
      gsl_test_abs(exact->pair[k] + 2 * exact->pair[12 + k] + exact->pair[24 + k], exact->S[0][k], 2e-4, "pairs sum up");
    twopoint_free(&exact);
    twopoint_free(&raster);
    twopoint_free(&thrown);
    pack_free(&pack);
  }
}

/* Penetrable, needles, nearly empty and nearly full; in space only by raster and segments. */
static void test_penetrable(void) {
  static const double side[] = {9, 7, 6};
  Rng rng = rng_stream(22, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = some(2, 9, 9, shape_superellipse(3, 1.5), side, &rng);
  Twopoint *exact = twopoint_exact(pack, 0.9, 8, false, 1e-4, &out);
  Twopoint *raster = twopoint_raster(pack, 0.9, 8, false, 1e6);
  Twopoint *thrown = twopoint_segments(pack, 0.9, 8, false, 4000, &rng);
  expect_same(exact, raster, 6e-4, false, "a raster of what overlaps");
  expect_same(exact, thrown, 1e-4, false, "segments in what overlaps");
  twopoint_free(&exact);
  twopoint_free(&raster);
  twopoint_free(&thrown);
  pack_free(&pack);
  pack = some(3, 20, 20, NULL, side, &rng);
  raster = twopoint_raster(pack, 0.9, 8, true, 3e5);
  thrown = twopoint_segments(pack, 0.9, 8, true, 4000, &rng);
  expect_same(raster, thrown, 3e-3, false, "balls that overlap");
  exact = twopoint_exact(pack, 0.9, 8, false, 1e-4, &out);
  gsl_test(exact || out.status != UNREACHED || !strstr(out.text, "fft"), "no exact way in space: %s", out.text);
  twopoint_free(&raster);
  twopoint_free(&thrown);
  pack_free(&pack);
}

static void test_slope(void) {
  static const double side[] = {9, 7, 6}, places[] = {1, 1, 2, 4, 4.2, 1, 7, 1.5, 4, 1.3, 4.9, 4.7};
  Rng rng = rng_stream(23, 0, RNG_TEST);
  Outcome out = {0};
  Pack *pack = some(3, 2, 2, NULL, side, &rng);
  memcpy(pack->x, places, sizeof places);
  Twopoint *t = twopoint_exact(pack, 1e-3, 3, false, 1e-6, &out);
  double s = 2 * 4 * M_PI * (1.1 * 1.1 + 0.7 * 0.7) / (9 * 7 * 6);
  gsl_test_rel(twopoint_surface(pack), s, 1e-12, "the surface of balls");
  gsl_test_rel(twopoint_slope(t), -s / 4, 1e-6, "the slope in space");
  twopoint_free(&t);
  pack_free(&pack);
  pack = some(2, 2, 2, shape_regular(3), side, &rng);
  for (int i = 0; i < 8; i++)
    pack->x[i] = places[3 * (i / 2) + i % 2];
  t = twopoint_exact(pack, 0.02, 3, false, 1e-3, &out);
  gsl_test_rel(twopoint_slope(t), -twopoint_surface(pack) / M_PI, 1e-4, "the slope in the plane");
  twopoint_free(&t);
  pack_free(&pack);
}

/* The law of N penetrable discs, thrown independently: E S_mm = (1 - (2A - K) / V)^N, from the mean over packs. */
static void test_law(void) {
  static const double side[] = {9, 7, 0};
  enum { N = 14, POINTS = 5 };
  int packs = as_many(60, 1000);
  double sum[POINTS] = {0}, squares[POINTS] = {0};
  Rng rng = rng_stream(24, 0, RNG_TEST);
  Species species = {.name = "A", .radius = 1.1, .count = N};
  for (int p = 0; p < packs; p++) {
    Outcome out = {0};
    Pack *pack = pack_alloc(&(Box){2, {side[0], side[1], 0}}, &species, 1, false);
    for (size_t i = 0; i < 2 * N; i++)
      pack->x[i] = side[i % 2] * rng_uniform(&rng);
    Twopoint *t = twopoint_raster(pack, 0.55, POINTS, false, 2e4);
    for (int k = 0; k < POINTS; k++) {
      sum[k] += t->S[2][k];
      squares[k] += t->S[2][k] * t->S[2][k];
    }
    twopoint_free(&t);
    pack_free(&pack);
    (void)out;
  }
  for (int k = 0; k < POINTS; k++) {
    double h = 0.25 * k, A = M_PI * 1.21, K = 1.21 * (2 * acos(h) - 2 * h * sqrt(1 - h * h));
    double law = pow(1 - (2 * A - K) / 63, N), mean = sum[k] / packs;
    double error = sqrt((squares[k] / packs - mean * mean) / (packs - 1));
    gsl_test_abs(mean, law, 3.5 * error + 1e-3, "%d penetrable discs, r = %g a (error %.2g)", N, 0.5 * k, error);
  }
}

/* Where species overlap a point is of both, by all ways. */
static void test_species(void) {
  static const double side[] = {6, 5, 5.5};
  Rng rng = rng_stream(24, 0, RNG_TEST);
  Outcome out = {0};
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = some(dim, 4, 5, dim == 2 ? shape_regular(5) : NULL, side, &rng);
    memcpy(pack->x + 4 * dim, pack->x, (size_t)dim * sizeof *pack->x); /* one upon another */
    Twopoint *raster = twopoint_raster(pack, 0.7, 6, true, 1e6);
    Twopoint *exact = dim == 2 ? twopoint_exact(pack, 0.7, 6, true, 1e-4, &out) : raster;
    Twopoint *thrown = twopoint_segments(pack, 0.7, 6, true, (size_t)as_many(20000, 200000), &rng);
    expect_same(exact, raster, 4e-4, true, "species that overlap, raster");
    expect_same(exact, thrown, dim == 2 ? 1e-4 : 2e-3, true, "species that overlap, segments");
    gsl_test(exact->pair[0] + 2 * exact->pair[6] + exact->pair[12] < exact->S[0][0] + 0.01, "species that overlap share points");
    if (dim == 2)
      twopoint_free(&exact);
    twopoint_free(&raster);
    twopoint_free(&thrown);
    pack_free(&pack);
  }
}

/* With species and without, the same segments are thrown, and asked in two ways. */
static void test_batches(void) {
  const double side[] = {9, 11, 8};
  for (int dim = 2; dim <= 3; dim++) {
    Rng rng = rng_stream(77, (uint64_t)dim, RNG_TEST), again;
    Shape *shape = dim == 2 ? shape_regular(5) : NULL;
    Pack *pack = some(dim, 12, 9, shape, side, &rng);
    again = rng;
    Twopoint *bits = twopoint_segments(pack, 0.9, 5, false, 10000, &rng), *names = twopoint_segments(pack, 0.9, 5, true, 10000, &again);
    double most = 0;
    for (size_t k = 0; k < 5; k++)
      for (int p = 0; p < 3; p++)
        most = fmax(most, fabs(bits->S[p][k] - names->S[p][k]));
    gsl_test(!(most < 1.5e-4), "%d-D: the same segments by bits and by names, %g", dim, most);
    for (size_t k = 0; k < 5; k++)
      for (size_t p = 0; p < 3; p++) {
        double S = (p == 1 ? 2 : 1) * bits->S[p][k];
        gsl_test_abs(bits->error[5 * p + k], (p == 1 ? 0.5 : 1) * sqrt(S * (1 - S) / 10000), 1e-9, "the error of function %d at point %d", (int)p, (int)k);
      }
    twopoint_free(&bits);
    twopoint_free(&names);
    pack_free(&pack);
  }
}

int main(void) {
  test_methods();
  test_species();
  test_batches();
  test_penetrable();
  test_slope();
  test_law();
  return gsl_test_summary();
}
