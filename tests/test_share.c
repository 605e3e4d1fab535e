/* tests/test_share.c: shares of the field that are known: stripes, the chessboard, lattices and irregular packs by the multipole identity
   (values of a computation of its own, by Ewald sums, to all digits printed) */
#include "many.h"
#include "microstructure.h"
#include "rng.h"
#include "share.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>

static Pack *balls(int dim, const double side[3], double radius, size_t n, const double x[]) {
  Species species = {.name = "P", .radius = radius, .count = n};
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (size_t i = 0; i < n * (size_t)dim; i++)
    pack->x[i] = x[i];
  return pack;
}

static Pack *of_shape(const double side[2], Shape *shape, double radius, size_t n, const double x[], double angle) {
  Species species = {.name = "P", .radius = radius, .count = n, .shape = shape};
  Box box = {2, {side[0], side[1], 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (size_t i = 0; i < 2 * n; i++)
    pack->x[i] = x[i];
  for (size_t i = 0; i < n; i++)
    pack->angle[i] = angle;
  return pack;
}

static const double unit[3] = {1, 1, 1};

/* Within the tolerance, and within so many times the error that is told. */
static void expect(Pack *pack, double pixels, int per, double zeta, double eta, double tolerance, const char *what) {
  Share share;
  Outcome out = {0};
  gsl_test_int(share_find(pack, pixels, per, &share, &out), DONE, "%s", what);
  gsl_test_abs(share.zeta, zeta, tolerance, "%s: zeta", what);
  gsl_test_abs(share.eta, eta, 3 * tolerance, "%s: eta", what);
  gsl_test(fabs(share.zeta - zeta) > 2 * share.zeta_error, "%s: the error of zeta, %.1e", what, share.zeta_error);
  gsl_test(fabs(share.eta - eta) > 2 * share.eta_error, "%s: the error of eta, %.1e", what, share.eta_error);
  gsl_test(share.zeta_error > 30 * tolerance, "%s: is not too large", what);
  gsl_test(share.zeta != rint(share.zeta * 1e10) / 1e10, "%s: rounded", what);
  if (pack->box.dim == 3)
    gsl_test(share.eta < 5 * share.zeta / 21 || share.eta > (5 * share.zeta + 16) / 21, "%s: eta by zeta", what);
  pack_free(&pack);
}

static void test_planes(void) {
  Outcome out = {0};
  static const double middle[] = {0.5, 0.5};
  double w = 1. / 7, bar[][2] = {{-2, -w}, {2, -w}, {2, w}, {-2, w}};
  Shape *shape = shape_convex(4, (const double(*)[2])bar, &out), *square = shape_regular(4);
  /* Stripes whose edges are edges of pixels, 28 to 112 along each axis: then the rule is exact. */
  for (int across = 0; across < 2; across++) {
    Pack *pack = of_shape(unit, shape, sqrt(8 * w / M_PI), 1, middle, across * M_PI / 2);
    Share share;
    gsl_test_int(share_find(pack, 1e4, 4, &share, &out), DONE, "a stripe");
    gsl_test_abs(share.zeta, 5. / 7, 1e-9, "a stripe, across %d: zeta", across);
    gsl_test_abs(share.eta, 5. / 7, 1e-9, "a stripe, across %d: eta", across);
    pack_free(&pack);
  }
  static const double two[] = {0.25, 0.25, 0.75, 0.75};
  expect(of_shape(unit, square, 0.5 / sqrt(M_PI), 2, two, M_PI / 4), 3e4, 4, 0.5, 0.5, 1e-3, "a chessboard");
  static const double nine[] = {0.2, 0.2, 0.3, 0.2, 0.2, 0.3, 0.3, 0.3, 0.7, 0.7, 0.8, 0.7, 0.7, 0.8, 0.8, 0.8};
  expect(of_shape(unit, square, 0.4 / sqrt(M_PI), 8, nine, M_PI / 4), 3e4, 4, 0.5, 0.5, 1e-3, "a chessboard of squares that overlap");
  shape_free(&shape);
  shape_free(&square);
}

static void test_discs(void) {
  const double side[3] = {1, sqrt(3), 0}, two[] = {0.3137, 0.2713, 0.8137, 0.2713 + sqrt(3) / 2};
  static const double phi[] = {0.2, 0.4, 0.6}, square[][2] = {{0.000611698424, 0.074372592314}, {0.013063253729, 0.201877822043}, {0.099650280394, 0.291050612818}},
                      hex[][2] = {{0.000006033774, 0.010957337637}, {0.000514884175, 0.124087666617}, {0.008797658604, 0.375359145711}};
  double pixels = as_many(1 << 16, 1 << 20), tolerance = as_many(50, 15) * 1e-5;
  for (int i = 0; i < 3; i++) {
    char what[40];
    sprintf(what, "square lattice, %g", phi[i]);
    expect(balls(2, unit, sqrt(phi[i] / M_PI), 1, two), pixels, 8, square[i][0], square[i][1], tolerance, what);
    sprintf(what, "hexagonal lattice, %g", phi[i]);
    expect(balls(2, side, sqrt(phi[i] * sqrt(3) / 2 / M_PI), 2, two), pixels, 8, hex[i][0], hex[i][1], tolerance, what);
  }
  static const double eight[] = {0.5118, 0.9505, 0.1442, 0.9486, 0.3118, 0.4233, 0.8277, 0.4092,
                                 0.3297, 0.7884, 0.9617, 0.7248, 0.5412, 0.2769, 0.6457, 0.7199};
  expect(balls(2, unit, 0.12, 8, eight), 4 * pixels, 8, 0.119434713606, 0.235564601646, tolerance, "eight discs");
}

static void test_spheres(void) {
  static const double lattice[] = {0.13, 0.2, 0.3, 0.63, 0.7, 0.8};
  static const double six[] = {0.1286, 0.4993, 0.6015, 0.0287, 0.1479, 0.9282, 0.6219, 0.369, 0.5114,
                               0.8167, 0.5491, 0.9809, 0.3533, 0.5916, 0.2353, 0.1598, 0.9964, 0.4597};
  double pixels = pow(as_many(64, 128), 3), tolerance = as_many(12, 3) * 2e-4;
  expect(balls(3, unit, cbrt(0.3 / M_PI), 1, lattice), pixels, 2, 0.067808284715, 0.173036436741, tolerance, "simple cubic, .4");
  expect(balls(3, unit, cbrt(0.45 / 2 / M_PI), 2, lattice), pixels, 2, 0.079557280114, 0.289878399524, tolerance, "body-centred, .6");
  expect(balls(3, unit, 0.2, 6, six), pixels, 2, 0.027765116261, 0.097699096096, tolerance, "six spheres");
}

/* One disc at ten places of the lattice, and three: the error that is told is not short, and not long. */
static void test_shifted(void) {
  static const double at[] = {0.13, 0.21, 0.63, 0.27, 0.31, 0.74};
  Rng rng = rng_stream(91, 0, RNG_TEST);
  for (int discs = 1; discs <= 3; discs += 2)
    for (int radius = 6; radius <= 20; radius += 7) { /* pixels to it */
      double r = sqrt((discs == 1 ? 0.4 : 0.3) / discs / M_PI), pixels = gsl_pow_2(radius / r), beyond[2] = {0}, told[2] = {0}, off[2] = {0};
      Pack *pack = balls(2, unit, r, (size_t)discs, at);
      Microstructure exact;
      Share share;
      Outcome out = {0};
      gsl_test_int(microstructure_balls(pack, &(MicrostructurePlan){1e-9, 1}, &exact, NULL, &out), DONE, "%d discs, exactly", discs);
      for (int place = 0; place < 10; place++) {
        double shift[2] = {rng_uniform(&rng), rng_uniform(&rng)};
        for (size_t i = 0; i < 2 * pack->n; i++)
          pack->x[i] = fmod(at[i] + shift[i % 2], 1);
        gsl_test_int(share_find(pack, pixels, 8, &share, &out), DONE, "%d discs, place %d", discs, place);
        double error[] = {share.zeta_error, share.eta_error}, wrong[] = {fabs(share.zeta - exact.zeta), fabs(share.eta - exact.eta)};
        for (int k = 0; k < 2; k++) {
          beyond[k] += wrong[k] > 2 * error[k];
          told[k] += error[k] / 10;
          off[k] += wrong[k] / 10;
        }
      }
      for (int k = 0; k < 2; k++) {
        gsl_test(beyond[k] > 0, "%d discs, %d pixels: %g of 10 places beyond twice the error of %s", discs, radius, beyond[k], k ? "eta" : "zeta");
        gsl_test(told[k] > 10 * off[k], "%d discs, %d pixels: the error of %s is %g, and told %g", discs, radius, k ? "eta" : "zeta", off[k], told[k]);
      }
      pack_free(&pack);
    }
}

/* A hundred spheres with five pixels to the radius: there a parabola is not enough. */
static void test_coarse(void) {
  enum { N = 100 };
  double x[3 * N], beyond = 0;
  Rng rng = rng_stream(92, 0, RNG_TEST);
  for (int c = 0; c < 3 * N; c++)
    x[c] = rng_uniform(&rng);
  Pack *pack = balls(3, unit, cbrt(0.1 / N * 0.75 / M_PI), N, x);
  for (size_t i = 0; i < N; i++) /* each again until it overlaps none */
    for (size_t j = 0; j < i; j++) {
      double square = 0;
      for (size_t k = 0; k < 3; k++)
        square += gsl_pow_2(box_nearest(pack->x[3 * i + k] - pack->x[3 * j + k], 1));
      if (square >= 4 * gsl_pow_2(pack->species[0].radius))
        continue;
      for (size_t k = 0; k < 3; k++)
        x[3 * i + k] = pack->x[3 * i + k] = rng_uniform(&rng);
      j = (size_t)-1;
    }
  Microstructure exact;
  Share share;
  Outcome out = {0};
  gsl_test_int(microstructure_balls(pack, &(MicrostructurePlan){1e-7, 1}, &exact, NULL, &out), DONE, "spheres, exactly: %s", out.text);
  for (int place = 0; place < 10; place++) {
    double shift[3] = {rng_uniform(&rng), rng_uniform(&rng), rng_uniform(&rng)};
    for (size_t i = 0; i < 3 * N; i++)
      pack->x[i] = fmod(x[i] + shift[i % 3], 1);
    share_find(pack, gsl_pow_3(5 / pack->species[0].radius), 2, &share, &out);
    beyond += fabs(share.eta - exact.eta) > 2 * share.eta_error;
  }
  gsl_test(beyond > 2, "spheres, 5 pixels: %g of 10 places beyond twice the error of eta", beyond);
  pack_free(&pack);
}

/* A square parallel to the lattice, of which each side is the same in all its pixels; and the stripe of the chapter. */
static void test_parallel(void) {
  static const double middle[] = {0.5, 0.5};
  Outcome out = {0};
  Shape *square = shape_regular(4);
  Pack *pack = of_shape(unit, square, sqrt(0.3 / M_PI), 1, middle, M_PI / 4);
  Rng rng = rng_stream(93, 0, RNG_TEST);
  Share fine, share;
  double zeta = 0, eta = 0, off[2] = {0};
  for (int k = 0; k < 40; k++) { /* the mean over places has the line's error alone */
    pack->x[0] = rng_uniform(&rng), pack->x[1] = rng_uniform(&rng);
    share_find(pack, 4e4, 4, &fine, &out);
    zeta += fine.zeta / 40, eta += fine.eta / 40;
  }
  for (int k = 0; k < 20; k++) {
    pack->x[0] = rng_uniform(&rng), pack->x[1] = rng_uniform(&rng);
    gsl_test_int(share_find(pack, gsl_pow_2(44), 8, &share, &out), DONE, "a parallel square");
    off[0] += fabs(share.zeta - zeta) > 2 * share.zeta_error;
    off[1] += fabs(share.eta - eta) > 2 * share.eta_error;
  }
  gsl_test(off[0] + off[1] > 0, "a parallel square: %g and %g of 20 beyond twice the error", off[0], off[1]);
  pack_free(&pack);
  double bar[][2] = {{-2, -0.15}, {2, -0.15}, {2, 0.15}, {-2, 0.15}};
  Shape *shape = shape_convex(4, (const double(*)[2])bar, &out);
  for (int k = 0; k < 10; k++) {
    double at[] = {0.5, rng_uniform(&rng)};
    pack = of_shape(unit, shape, sqrt(1.2 / M_PI), 1, at, 0);
    gsl_test_int(share_find(pack, 1e4, 8, &share, &out), DONE, "a stripe between pixels");
    gsl_test(fabs(share.zeta - 0.7) > 2 * share.zeta_error, "a stripe between pixels: %g +- %g", share.zeta, share.zeta_error);
    pack_free(&pack);
  }
  shape_free(&square);
  shape_free(&shape);
}

/* The same pack at another scale has the same bits; moved, the same within its errors; and one phase has no field. */
static void test_same(void) {
  static const double three[] = {0.2, 0.3, 0.7, 0.4, 0.5, 0.8};
  static const double moved[] = {0.2617, 0.3391, 0.7617, 0.4391, 0.5617, 0.8391};
  double large[6], side[3] = {4, 4, 0};
  for (int i = 0; i < 6; i++)
    large[i] = 4 * three[i];
  Pack *pack[3] = {balls(2, unit, 0.15, 3, three), balls(2, side, 0.6, 3, large), balls(2, unit, 0.15, 3, moved)};
  Share share[3];
  Outcome out = {0};
  for (int p = 0; p < 3; p++)
    gsl_test_int(share_find(pack[p], 3e4, 4, &share[p], &out), DONE, "pack %d", p);
  gsl_test(share[0].zeta != share[1].zeta || share[0].eta != share[1].eta, "scaled");
  gsl_test_abs(share[2].zeta, share[0].zeta, 3 * share[0].zeta_error, "moved");
  for (int p = 0; p < 3; p++)
    pack_free(&pack[p]);
  pack[0] = balls(2, unit, 0.8, 3, three);
  gsl_test_int(share_find(pack[0], 1e3, 4, &share[0], &out), UNREACHED, "all is covered: %s", out.text);
  pack_free(&pack[0]);
  pack[0] = balls(3, unit, 1e-5, 2, three);
  out = (Outcome){0};
  gsl_test_int(share_find(pack[0], 1e3, 2, &share[0], &out), UNREACHED, "no point is covered: %s", out.text);
  pack_free(&pack[0]);
}

int main(void) {
  test_planes();
  test_discs();
  test_spheres();
  test_shifted();
  test_parallel();
  test_coarse();
  test_same();
  return gsl_test_summary();
}
