/* tests/test_indicator.c: every bit is that of all gauges of all images */
#include "indicator.h"
#include "many.h"
#include "outcome.h"
#include "points.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

enum { POINTS = 4096 };

/* All images of all particles, one by one. */
static bool plain(const Pack *pack, const uint64_t u[3]) {
  int dim = pack->box.dim;
  double p[3] = {0};
  for (int k = 0; k < dim; k++)
    p[k] = (double)(u[k] >> 11) * 0x1p-53 * pack->box.side[k];
  for (size_t i = 0; i < pack->n; i++)
    for (int c = dim == 3 ? -3 : 0; c <= (dim == 3 ? 3 : 0); c++)
      for (int b = -3; b <= 3; b++)
        for (int a = -3; a <= 3; a++) {
          const double *x = pack->x + i * (size_t)dim, R = pack_radius(pack, i);
          double d[3] = {p[0] - (x[0] + a * pack->box.side[0]), p[1] - (x[1] + b * pack->box.side[1]), 0};
          if (dim == 3)
            d[2] = p[2] - (x[2] + c * pack->box.side[2]);
          const Shape *shape = pack_shape(pack, i);
          if (!shape && d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= R * R)
            return true;
          if (!shape)
            continue;
          Body body = pack_body(pack, i);
          if (shape_gauge(shape, (body.c * d[0] + body.s * d[1]) / R, (body.c * d[1] - body.s * d[0]) / R) <= 1)
            return true;
        }
  return false;
}

static void expect(const Pack *pack, const char *what, uint64_t near[][2], size_t nears) {
  static uint64_t memory_of[6][POINTS];
  uint64_t *x[3], *step[3], bits[POINTS / 64 + 1];
  Rng rng = rng_stream(31, pack->n, RNG_TEST);
  Indicator *in = indicator_alloc(pack);
  size_t m = (size_t)as_many(1999, POINTS - 7), wrong = 0, inside = 0;
  for (int k = 0; k < 3; k++) {
    x[k] = memory_of[k], step[k] = memory_of[3 + k];
    for (size_t i = 0; i < m; i++) {
      step[k][i] = rng_bits(&rng);
      x[k][i] = (i < nears && k < 2 ? near[i][k] : rng_bits(&rng)) - step[k][i];
      if (i % 3 == 2) /* on the lines of the raster */
        x[k][i] = (rng_bits(&rng) & ((uint64_t)0xfff << 52)) - step[k][i];
    }
  }
  indicator_walk(in, x, step, m, bits);
  for (size_t i = 0; i < m; i++) {
    const uint64_t at[3] = {x[0][i], x[1][i], x[2][i]};
    bool bit = bits[i / 64] >> i % 64 & 1;
    wrong += bit != plain(pack, at);
    inside += bit;
  }
  gsl_test(wrong > 0, "%s: %zu of %zu points are not as by all gauges", what, wrong, m);
  gsl_test(pack->n && (inside == 0 || inside == m), "%s: %zu inside", what, inside);
  gsl_test((bits[m / 64] >> m % 64) != 0, "%s: bits beyond the points", what);
  indicator_free(&in);
}

/* Particles of five species in a box that some are wider than. */
static void test_shapes(void) {
  Species species[] = {{.name = "A", .radius = 0.83, .count = 5, .shape = shape_regular(3)},
                       {.name = "B", .radius = 1.37, .count = 3, .shape = shape_superellipse(1.5, 1.5)},
                       {.name = "C", .radius = 0.41, .count = 9},
                       {.name = "D", .radius = 0.9, .count = 2, .shape = shape_superellipse(50, 1)},
                       {.name = "E", .radius = 1.1, .count = 3, .shape = shape_superellipse(2, 50)}};
  for (int kind = 0; kind < 6; kind++) {
    Box box = {2, {kind == 5 ? 7.3 : 9.7, kind == 5 ? 3.1 : 11.3, 0}};
    Pack *pack = pack_alloc(&box, kind == 5 ? species : &species[kind], kind == 5 ? 5 : 1, false);
    uint64_t near[400][2];
    Rng rng = rng_stream(32, (uint64_t)kind, RNG_TEST);
    points_scatter(pack, &rng);
    points_turn(pack, &rng);
    /* places on boundaries but for some 1e-12 */
    for (int i = 0; i < 400; i++) {
      Body b = pack_body(pack, (size_t)i % pack->n);
      double u[2], p[2], g = 1 + 4e-12 * (rng_uniform(&rng) - 0.5);
      rng_direction(&rng, 2, u);
      p[0] = u[0], p[1] = u[1];
      if (b.shape)
        shape_farthest(b.shape, u[0], u[1], p);
      near[i][0] = indicator_fraction(b.x + g * b.radius * (b.c * p[0] - b.s * p[1]), box.side[0]);
      near[i][1] = indicator_fraction(b.y + g * b.radius * (b.s * p[0] + b.c * p[1]), box.side[1]);
    }
    static const char *const name[] = {"triangles", "superellipses", "discs", "needles", "nearly rectangles", "all kinds"};
    expect(pack, name[kind], near, 400);
    pack_free(&pack);
  }
  for (int s = 0; s < 5; s++)
    shape_free(&species[s].shape);
}

static void test_balls(void) {
  for (int size = 0; size < 3; size++) {
    Species species = {.name = "P", .radius = size ? 1.9 : 0.47, .count = size == 2 ? 0 : size ? 2 : 40};
    Box box = {3, {3.7, 5.3, 2.9}};
    Pack *pack = pack_alloc(&box, &species, 1, false);
    Rng rng = rng_stream(33, 0, RNG_TEST);
    points_scatter(pack, &rng);
    expect(pack, size == 2 ? "nothing" : size ? "balls wider than the box" : "balls", NULL, 0);
    pack_free(&pack);
  }
}

/* The example: a disc in a box of four radii, 256 x 256 cells. */
static void test_example(void) {
  Species species = {.name = "P", .radius = 1, .count = 1};
  Box box = {2, {4, 4, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  pack->x[0] = 1.503, pack->x[1] = 1.491;
  Indicator *in = indicator_alloc(pack);
  double cells = indicator_undecided(in) * 65536;
  gsl_test(cells < 506 || cells > 512, "a disc leaves %g cells undecided", cells);
  gsl_test(indicator_fraction(-1, 4) != (uint64_t)3 << 62 || indicator_fraction(9, 4) != (uint64_t)1 << 62 ||
               indicator_fraction(-1e-30, 4) != 0,
           "fractions wrap");
  indicator_free(&in);
  indicator_free(&in);
  pack_free(&pack);
}

int main(void) {
  test_shapes();
  test_balls();
  test_example();
  return gsl_test_summary();
}
