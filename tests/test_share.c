/* tests/test_share.c: shares of the field that are known: stripes, the chessboard, lattices and irregular packs by the multipole identity
   (values of a computation of its own, by Ewald sums, to all digits printed) */
#include "many.h"
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
  test_same();
  return gsl_test_summary();
}
