/* tests/test_touch.c: the least gap of shapes, against all images, against distances known on paper, and of balls */
#include "cells.h"
#include "many.h"
#include "overlap.h"
#include "points.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>

/* The gap of (touch:gap) over all images up to so many boxes away, of every pair. */
static double all_images(const Pack *pack, int boxes) {
  double least = GSL_POSINF;
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i; j < pack->n; j++)
      for (int p = -boxes; p <= boxes; p++)
        for (int q = -boxes; q <= boxes; q++) {
          Body A = pack_body(pack, i), B = pack_body(pack, j);
          double x = (B.x - A.x) + p * pack->box.side[0], y = (B.y - A.y) + q * pack->box.side[1], gap;
          if (i == j && p == 0 && q == 0)
            continue;
          A.x = A.y = 0, B.x = x, B.y = y;
          overlap_verdict(&A, &B, &gap);
          double a = A.radius * (A.shape ? A.shape->outer : 1), b = B.radius * (B.shape ? B.shape->outer : 1);
          least = fmin(least, fmax(gap, sqrt(x * x + y * y) - a - b));
        }
  return least;
}

static Pack *scattered(const Species species[], int kinds, double width, double height, bool own, uint64_t seed) {
  Box box = {2, {width, height, 0}};
  Rng rng = rng_stream(seed, 1, RNG_TEST);
  Pack *pack = pack_alloc(&box, species, kinds, own);
  points_scatter(pack, &rng);
  points_turn(pack, &rng);
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] *= 0.5 + rng_uniform(&rng);
  return pack;
}

static void same_gap(const Species species[], int kinds, double width, double height, int boxes, bool own, const char *what) {
  for (uint64_t seed = 0; seed < (uint64_t)as_many(4, 40); seed++) {
    Pack *pack = scattered(species, kinds, width, height, own, seed);
    double wanted = all_images(pack, boxes), gap = touch_least_gap(pack);
    gsl_test(gap != wanted, "%s, seed %d: the gap of all images (%.17g, %.17g)", what, (int)seed, gap, wanted);
    pack_free(&pack);
  }
}

/* Two of a species at a distance along x, turned; the box is wide. */
static void known(Shape *shape, double radius, double distance, double angle, double gap, const char *what) {
  Box box = {2, {40, 40, 0}};
  Species one = {"A", radius, 2, shape};
  Pack *pack = pack_alloc(&box, &one, 1, false);
  pack->x[0] = 39;
  pack->x[1] = pack->x[3] = 17.25;
  pack->x[2] = distance - 1;
  pack->angle[0] = pack->angle[1] = angle;
  gsl_test_abs(touch_least_gap(pack), gap, 1e-14, "%s", what);
  pack_free(&pack);
  shape_free(&shape);
}

/* Uniform: the first two harmonics of N angles have sums of the error sqrt(N / 2). */
static void test_turns(void) {
  enum { N = 20000 };
  Species some[] = {{"D", 1, 7, NULL}, {"P", 1, N, shape_regular(5)}};
  Pack *pack = scattered(some, 2, 17, 13, false, 3);
  double sum[4] = {0}, discs = 0, out = 0;
  for (size_t i = 0; i < pack->n; i++) {
    double a = pack->angle[i];
    discs += pack_shape(pack, i) ? 0 : a;
    out += !(a >= 0 && a < 2 * M_PI);
    for (int k = 0; pack_shape(pack, i) && k < 4; k++)
      sum[k] += k & 1 ? sin((1 + k / 2) * a) : cos((1 + k / 2) * a);
  }
  for (int k = 0; k < 4; k++)
    gsl_test_abs(sum[k] / sqrt(N / 2), 0, 4, "random angles: harmonic %d in standard errors", k);
  gsl_test(discs != 0 || out > 0, "discs are not turned, and no angle is out of [0, 2 pi)");
  gsl_test(2 * M_PI * (1 - 0x1p-53) >= 2 * M_PI, "the largest random number gives no full turn");
  pack_free(&pack);
  shape_free(&some[1].shape);
}

/* Two large ones 0.2 apart, farther than the first search looks, among small ones that are 0.25 from all. */
static void test_search(void) {
  Box box = {2, {7.2, 7.2, 0}};
  Species all[] = {{"L", 1, 2, NULL}, {"S", 1e-3, 0, shape_regular(4)}};
  double x[2000] = {0.7, 3.6, 2.9, 3.6};
  size_t n = 2;
  for (int c = 0; c < 24 * 24; c++) {
    double *at = x + 2 * n, outer = 1.25 + 1e-3 * all[1].shape->outer;
    at[0] = 0.3 * (c % 24) + 0.1;
    at[1] = 0.3 * (c / 24);
    n += hypot(box_nearest(at[0] - 0.7, 7.2), at[1] - 3.6) > outer && hypot(at[0] - 2.9, at[1] - 3.6) > outer;
  }
  all[1].count = n - 2;
  Pack *pack = pack_alloc(&box, all, 2, false);
  for (size_t c = 0; c < 2 * n; c++)
    pack->x[c] = x[c];
  gsl_test(n < 400, "so many that cells are narrow: %d", (int)n);
  gsl_test_abs(touch_least_gap(pack), 0.2, 1e-14, "beyond the first search");
  pack_free(&pack);
  shape_free(&all[1].shape);
}

/* The pair that overlaps most, against the gaps of all pairs taken alone; and what is hard. */
static void test_deepest(int dim, const Species species[], int kinds, const char *what) {
  Box box = {dim, {9, 8, dim == 3 ? 7 : 0}};
  Rng rng = rng_stream(11, (uint64_t)dim, RNG_TEST);
  Pack *pack = pack_alloc(&box, species, kinds, false);
  points_scatter(pack, &rng);
  points_turn(pack, &rng);
  size_t pair[2], wanted[2] = {0};
  double least = GSL_POSINF, gap = touch_deepest(pack, pair);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i + 1; j < pack->n; j++) {
      double square = 0, g;
      for (size_t k = 0, d = (size_t)dim; k < d; k++)
        square += pow(box_nearest(pack->x[j * d + k] - pack->x[i * d + k], box.side[k]), 2);
      g = sqrt(square) - pack_radius(pack, i) - pack_radius(pack, j);
      if (pack->angle) {
        Body A = pack_body(pack, i), B = pack_body(pack, j);
        B.x = A.x + box_nearest(B.x - A.x, box.side[0]), B.y = A.y + box_nearest(B.y - A.y, box.side[1]);
        overlap_verdict(&A, &B, &g);
      }
      if (g < least)
        least = g, wanted[0] = i, wanted[1] = j;
    }
  gsl_test(!(least < 0) || pair[0] != wanted[0] || pair[1] != wanted[1], "%s: the deepest pair is %d %d, found %d %d", what,
           (int)wanted[0], (int)wanted[1], (int)pair[0], (int)pair[1]);
  gsl_test_abs(gap, least, 1e-13, "%s: its gap", what);
  gsl_test(gap != touch_least_gap(pack), "%s: it is the least gap", what);
  gsl_test(touch_hard(pack, gap), "%s: is not hard", what);
  pack_free(&pack);
}

static void test_hard(void) {
  Box box = {3, {10, 10, 10}};
  Species two[] = {{"L", 2, 1}, {"S", 0.5, 1}};
  Pack *pack = pack_alloc(&box, two, 2, false);
  size_t pair[2];
  gsl_test(!touch_hard(pack, -0.499e-4) || touch_hard(pack, -0.501e-4), "hard by a part of the smallest radius");
  pack->x[0] = pack->x[1] = pack->x[2] = 9.5;
  pack->x[3] = 1.9, pack->x[4] = pack->x[5] = 9.5;
  gsl_test_abs(touch_deepest(pack, pair), -0.1, 1e-14, "across the box");
  gsl_test(!touch_hard(pack, GSL_POSINF), "nothing overlaps if there is one particle");
  pack_free(&pack);
  Species wide = {"W", 6, 1};
  pack = pack_alloc(&box, &wide, 1, false);
  gsl_test_abs(touch_deepest(pack, pair), -2, 1e-14, "a ball and its own image");
  gsl_test(pair[0] != 0 || pair[1] != 0, "are one particle");
  pack_free(&pack);
}

static void test_balls(void) {
  Species discs[] = {{"A", 1, 30}, {"B", 0.25, 40}};
  Pack *pack = scattered(discs, 2, 17, 13, false, 5);
  gsl_test(touch_least_gap(pack) != cells_least_gap(pack), "of discs it is that of chapter cells");
  pack_free(&pack);
  Species few[] = {{"A", 1, 3}, {"B", 0.25, 4}, {"P", 1, 0, shape_regular(3)}};
  pack = scattered(few, 3, 17, 13, false, 5);
  gsl_test_rel(touch_least_gap(pack), pack_audit(&(Pack){.box = pack->box, .n = 7, .x = pack->x, .kinds = 2, .species = few, .kind = pack->kind}),
               1e-13, "discs beside a species of shapes without particles");
  pack_free(&pack);
  pack = scattered(few + 2, 1, 17, 13, false, 5);
  gsl_test(touch_least_gap(pack) != GSL_POSINF, "infinite of none");
  pack_free(&pack);
  shape_free(&few[2].shape);
}

int main(void) {
  double side = sqrt(M_PI), half = sqrt(M_PI / 2);
  known(shape_regular(4), 1, 3, 0, 3 - 2 * half, "two squares, corner to corner across the box");
  known(shape_regular(4), 1, 3, M_PI / 4, 3 - 2 * half, "side to side, by the discs around them");
  known(shape_regular(4), 1, 2, M_PI / 4, 2 - side, "side to side, within their discs");
  known(shape_regular(4), 1.5, 2.5, M_PI / 4, 2.5 - 1.5 * side, "and overlapping");
  known(shape_superellipse(1.7, 1), 1, 4, 0, 4 - 2 * sqrt(1.7), "two ellipses, tip to tip");
  known(shape_regular(4), 1, 20, M_PI / 4, 20 - 2 * half, "half the box apart");
  known(shape_regular(4), 11.5, 20, M_PI / 4, 20 - 11.5 * side, "as wide as half of it");
  test_balls();
  test_hard();
  Species plain[] = {{"A", 1, 7}, {"B", 0.25, 9}}, shaped[] = {{"P", 1, 5, shape_regular(5)}, {"D", 0.7, 4, NULL}, {"E", 0.5, 5, shape_superellipse(1.7, 1)}};
  test_deepest(2, plain, 2, "discs");
  test_deepest(3, plain, 2, "spheres");
  test_deepest(2, shaped, 3, "shapes");
  shape_free(&shaped[0].shape);
  shape_free(&shaped[2].shape);
  test_turns();
  test_search();
  Species some[] = {{"P", 1, 9, shape_regular(5)},      {"T", 0.5, 8, shape_regular(3)}, {"D", 0.7, 7, NULL},
                    {"S", 1.2, 6, shape_superellipse(2.5, 1.5)}, {"E", 0.1, 3, shape_superellipse(0.3, 1)}};
  same_gap(some, 5, 40, 60, 1, false, "a few of many kinds");
  same_gap(some, 5, 400, 300, 1, true, "in a wide box");
  same_gap(some, 5, 4, 3.5, 3, true, "in one narrower than some");
  Species lone = {"N", 1, 1, shape_superellipse(64, 1)}, pair = {"N", 1, 2, lone.shape};
  same_gap(&lone, 1, 8, 8, 4, false, "a needle twice as long as the box");
  same_gap(&pair, 1, 8, 9, 4, false, "two of them");
  same_gap(&lone, 1, 50, 6, 6, false, "one in a slit");
  for (int s = 0; s < 5; s++)
    shape_free(&some[s].shape);
  shape_free(&lone.shape);
  return gsl_test_summary();
}
