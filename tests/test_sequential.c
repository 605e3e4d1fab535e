/* tests/test_sequential.c: shapes added one by one: apart, where excluded areas say, and to what is known of saturation */
#include "box.h"
#include "many.h"
#include "sequential.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *empty(const Box *box, const size_t n[], bool own) {
  Shape *pentagon = shape_regular(5), *egg = shape_superellipse(1.5, 1.5);
  Species s[3] = {{.name = "P", .radius = 1, .count = n[0], .shape = pentagon},
                  {.name = "E", .radius = 1.7, .count = n[1], .shape = egg},
                  {.name = "D", .radius = .4, .count = n[2]}};
  Pack *pack = pack_alloc(box, s, 3, own);
  shape_free(&pentagon);
  shape_free(&egg);
  return pack;
}

static void test_apart(void) {
  static const size_t n[3] = {60, 30, 200};
  static const double sides[][2] = {{48, 37}, {60, 60}, {300, 2.9}};
  for (int c = 0; c < 3; c++)
    for (int large = 0; large < 2; large++) {
      Box box = {2, {sides[c][0], sides[c][1], 0}};
      Pack *pack = empty(&box, n, c == 1);
      Rng rng = rng_stream(61, (uint64_t)c, RNG_TEST), again = rng;
      double attempts = 0, size = c == 2 ? .6 : 1;
      size_t placed = 0;
      Outcome out = {0};
      int status = sequential_fill(pack, size, large, 1e3 * (double)pack->n, &rng, &attempts, &placed, &out);
      gsl_test(status || placed != pack->n, "%g by %g: all placed: %s", sides[c][0], sides[c][1], out.text);
      for (int k = 0; k < 3; k++)
        pack->species[k].radius *= size;
      gsl_test(!(touch_least_gap(pack) > 0), "and apart: %g", touch_least_gap(pack));
      gsl_test(attempts < (double)pack->n, "in %g attempts", attempts);
      Pack *twin = pack_copy(pack);
      for (int k = 0; k < 3; k++)
        twin->species[k].radius /= size;
      sequential_fill(twin, size, large, 1e3 * (double)pack->n, &again, &attempts, &placed, &out);
      gsl_test(memcmp(pack->x, twin->x, 2 * pack->n * sizeof(double)) ||
                   memcmp(pack->angle, twin->angle, pack->n * sizeof(double)),
               "and again the same");
      pack_free(&pack);
      pack_free(&twin);
    }
}

/* A second convex shape has the chance 1 - (A + B + P Q / 2 pi) / V to be apart from the first, averaged over angles. */
static void test_excluded(void) {
  static const size_t n[3] = {1, 1, 0};
  Shape *p = shape_regular(5), *q = shape_superellipse(1.5, 1.5);
  Box box = {2, {6.2, 6.7, 0}};
  double out_of = p->perimeter * 1.7 * q->perimeter / (2 * M_PI) + M_PI * (1 + 1.7 * 1.7);
  double chance = 1 - out_of / box_volume(&box), sum = 0;
  Pack *pack = empty(&box, n, false);
  Rng rng = rng_stream(62, 0, RNG_TEST);
  int packs = as_many(1000, 100000);
  for (int k = 0; k < packs; k++) {
    double attempts = 0;
    size_t placed;
    Outcome out = {0};
    sequential_fill(pack, 1, false, 1e9, &rng, &attempts, &placed, &out);
    sum += attempts - 1;
  }
  double mean = sum / packs, error = sqrt(1 - chance) / chance / sqrt(packs);
  gsl_test(fabs(mean - 1 / chance) > 4 * error, "attempts of a second: %.5g +- %.2g, %.5g", mean, error, 1 / chance);
  pack_free(&pack);
  shape_free(&p);
  shape_free(&q);
}

/* A single needle in a box that is narrow: by its own images it lies within |sin| > w / L. */
static void test_images(void) {
  static const double corner[4][2] = {{2.25, .35}, {-2.25, .35}, {-2.25, -.35}, {2.25, -.35}};
  Outcome out = {0};
  Shape *rod = shape_convex(4, corner, &out);
  double least = asin(2 * GSL_MIN(rod->h[0], rod->h[1]) / 3), sum = 0;
  Species s = {.name = "R", .radius = 1, .count = 1, .shape = rod};
  Box box = {2, {3, 20, 0}};
  Pack *pack = pack_alloc(&box, &s, 1, false);
  Rng rng = rng_stream(63, 0, RNG_TEST);
  int packs = as_many(1000, 50000), outside = 0;
  for (int k = 0; k < packs; k++) {
    double attempts = 0;
    size_t placed;
    sequential_fill(pack, 1, true, 1e9, &rng, &attempts, &placed, &out);
    outside += fabs(sin(pack->angle[0])) < sin(least) * (1 - 1e-9);
    sum += attempts;
  }
  double chance = 1 - 2 * least / M_PI, error = sqrt(1 - chance) / chance / sqrt(packs);
  gsl_test_int(outside, 0, "a rod is apart from its images");
  gsl_test(fabs(sum / packs - 1 / chance) > 4 * error, "and no more is asked: %.5g +- %.2g, %.5g", sum / packs, error,
           1 / chance);
  pack_free(&pack);
  shape_free(&rod);
}

/* The fraction after so many attempts in the mean of a few packs. */
static double reached(int sides, size_t n, double time, int packs, double *error) {
  Shape *shape = shape_regular(sides);
  Species s = {.name = "S", .radius = 1, .count = n, .shape = shape};
  static const double ones[] = {1, 1};
  Box box = box_make(2, ones, (double)n * M_PI / .6);
  double sum = 0, square = 0;
  for (int k = 0; k < packs; k++) {
    Pack *pack = pack_alloc(&box, &s, 1, false);
    Rng rng = rng_stream(64, (uint64_t)k, RNG_TEST);
    double attempts = 0;
    size_t placed;
    Outcome out = {0};
    double most = time * box_volume(&box) / M_PI;
    int status = sequential_fill(pack, 1, false, most, &rng, &attempts, &placed, &out);
    double phi = (double)placed * M_PI / box_volume(&box);
    gsl_test(k == 0 && (status != UNREACHED || attempts != ceil(most) || !strstr(out.text, "need not be the most")),
             "not reached: %s", out.text);
    for (size_t i = 0, still = 0; k == 0 && i <= n; i++) {
      still += i < n && pack->x[2 * i] == 0;
      gsl_test(i == n && still != n - placed, "those without a place are left: %zu of %zu", still, n);
    }
    sum += phi / packs;
    square += phi * phi / packs;
    pack_free(&pack);
  }
  *error = sqrt((square - sum * sum) / (packs - 1));
  shape_free(&shape);
  return sum;
}

/* Saturated pentagons have .54132; what is missing falls as t^(-1/3). Eight times the attempts halve it. */
static void test_approach(void) {
  double e[3], phi[3];
  size_t n = (size_t)as_many(120, 2000);
  double late = as_many(100, 800);
  for (int k = 0; k < 3; k++)
    phi[k] = reached(5, n, late / (k == 0 ? 64 : k == 1 ? 8 : 1), 6, e + k);
  double limit = 2 * phi[2] - phi[1], error = sqrt(4 * e[2] * e[2] + e[1] * e[1]);
  gsl_test(!(phi[0] < phi[1] && phi[1] < phi[2] && phi[2] < .54132), "pentagons fill up: %.4f %.4f %.4f", phi[0],
           phi[1], phi[2]);
  gsl_test(fabs(limit - .54132) > 4 * error, "towards %.4f +- %.4f", limit, error);
}

/* By falling radius, the large come first: a box that is full of them has no room. */
static void test_order(void) {
  static const size_t n[3] = {3, 40, 300};
  Box box = {2, {18, 18, 0}};
  double attempts = 0;
  for (int large = 0; large < 2; large++) {
    Pack *pack = empty(&box, n, false);
    size_t placed, first[2] = {0, 0};
    Rng rng = rng_stream(65, 0, RNG_TEST);
    Outcome out = {0};
    sequential_fill(pack, 1, large, 400, &rng, &attempts, &placed, &out);
    for (size_t i = 0; i < pack->n; i++)
      first[i < 43 && i >= 3] += pack->x[2 * i] != 0;
    gsl_test(large ? first[0] != 0 || first[1] == 0 : first[0] == 0 || first[1] == 0,
             "order %d: placed %zu large, %zu others", large, first[1], first[0]);
    pack_free(&pack);
  }
  static const size_t none[3] = {0, 0, 0};
  Pack *pack = empty(&box, none, false);
  Rng rng = rng_stream(66, 0, RNG_TEST);
  size_t placed;
  Outcome out = {0};
  gsl_test(sequential_fill(pack, 1, false, 10, &rng, &attempts, &placed, &out) || placed, "nothing to add");
  pack_free(&pack);
}

int main(void) {
  test_apart();
  test_excluded();
  test_images();
  test_approach();
  test_order();
  return gsl_test_summary();
}
