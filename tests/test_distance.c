/* tests/test_distance.c: signed distances to bodies against their definition, and in packs against all images */
#include "distance.h"
#include "many.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

/* The largest n . r - h(n) over many directions, refined about the best. */
static double by_support(const Shape *shape, double x, double y) {
  double best = GSL_NEGINF, at = 0;
  for (int k = 0; k < 20000; k++) {
    double t = 2 * M_PI * k / 20000, d = cos(t) * x + sin(t) * y - (shape ? shape_support(shape, cos(t), sin(t)) : 1);
    if (d > best)
      best = d, at = t;
  }
  double step = 2 * M_PI / 20000;
  for (int k = 0; k < 60; k++, step *= 0.8)
    for (int sign = -1; sign <= 1; sign += 2) {
      double t = at + sign * step, d = cos(t) * x + sin(t) * y - (shape ? shape_support(shape, cos(t), sin(t)) : 1);
      if (d > best)
        best = d, at = t;
    }
  return best;
}

static void test_bodies(void) {
  enum { SHAPES = 9 };
  Shape *shape[SHAPES] = {NULL, shape_regular(3), shape_regular(5), shape_superellipse(1, 1), shape_superellipse(2.5, 1),
                          shape_superellipse(1, 50), shape_superellipse(50, 1), shape_superellipse(1.5, 0.6), shape_superellipse(3, 2)};
  Rng rng = rng_stream(301, 0, RNG_TEST);
  for (int s = 0; s < SHAPES; s++) {
    double worst = 0, worst_inside = 0, outer = shape[s] ? shape[s]->outer : 1;
    for (int k = 0; k < as_many(60, 2000); k++) {
      double x = 1.7 * outer * (2 * rng_uniform(&rng) - 1), y = 1.7 * outer * (2 * rng_uniform(&rng) - 1);
      if (k % 2)
        x *= 0.3, y *= 0.3 * (shape[s] ? shape[s]->inner / outer : 1);
      if (k == 0)
        x = y = 0;
      if (k == 2)
        y = 0;
      Body body = {shape[s], 1.7, 0.3, -0.4, 0.8, -0.6};
      double px = 0.3 + 1.7 * (0.8 * x + 0.6 * y), py = -0.4 + 1.7 * (-0.6 * x + 0.8 * y);
      double d = distance_body(&body, px, py) / 1.7, want = by_support(shape[s], x, y);
      double *w = want > 0 ? &worst : &worst_inside;
      *w = GSL_MAX(*w, fabs(d - want));
    }
    gsl_test(!(worst < 2e-9), "shape %d: outside as by the support function, off by %.2g", s, worst);
    gsl_test(!(worst_inside < 2e-9), "shape %d: inside as by the support function, off by %.2g", s, worst_inside);
  }
  for (int s = 0; s < SHAPES; s++)
    shape_free(&shape[s]);
}

static void test_by_hand(void) {
  Body disc = {.radius = 1, .c = 1};
  Shape *four = shape_regular(4);
  double h = sqrt(0.5);
  Body square = {.shape = four, .radius = 2 / sqrt(M_PI), .c = h, .s = h};
  gsl_test_rel(distance_body(&disc, 3, 4), 4, 1e-15, "a disc from outside");
  gsl_test_rel(distance_body(&disc, 0.3, 0.4), -0.5, 1e-15, "a disc from inside");
  gsl_test_rel(distance_body(&square, 2, 2), M_SQRT2, 1e-14, "a corner");
  gsl_test_rel(distance_body(&square, 0, 0), -1, 1e-14, "the middle of a square");
  gsl_test_rel(distance_body(&square, 0.25, -3.5), 2.5, 1e-14, "an edge");
  shape_free(&four);
}

/* All images within three boxes, one by one. */
static double plain(const Pack *pack, const double x[], int64_t without) {
  double least = GSL_POSINF;
  int dim = pack->box.dim, m = 3;
  for (size_t i = 0; i < pack->n; i++)
    for (int a = -m; a <= m; a++)
      for (int b = -m; b <= m; b++)
        for (int c = dim == 3 ? -m : 0; c <= (dim == 3 ? m : 0); c++) {
          double d[3] = {0}, square = 0;
          int n[3] = {a, b, c};
          if (without == (int64_t)i && !a && !b && !c)
            continue;
          for (int k = 0; k < dim; k++) {
            d[k] = x[k] - (pack->x[i * (size_t)dim + (size_t)k] + n[k] * pack->box.side[k]);
            square += d[k] * d[k];
          }
          Body body = {.radius = pack_radius(pack, i)};
          if (dim == 2) {
            body = pack_body(pack, i);
            body.x = body.y = 0;
          }
          double found = dim == 2 ? distance_body(&body, d[0], d[1]) : sqrt(square) - body.radius;
          least = GSL_MIN(least, found);
        }
  return least;
}

static void test_packs(void) {
  Shape *needle = shape_superellipse(20, 2), *five = shape_regular(5);
  Rng rng = rng_stream(302, 0, RNG_TEST);
  for (int kind = 0; kind < 3; kind++) {
    int differ = 0, beyond = 0;
    for (int k = 0; k < as_many(20, 200); k++) {
      int dim = kind == 2 ? 3 : 2;
      Species species[2] = {{"A", 0.9, 3 + (size_t)k % 3, kind == 1 ? needle : NULL}, {"B", 0.2, 9, kind == 1 ? five : NULL}};
      Box box = {dim, {4, 3.5, dim == 3 ? 3.1 : 0}};
      Pack *pack = pack_alloc(&box, species, 2, false);
      for (size_t i = 0; i < pack->n * (size_t)dim; i++)
        pack->x[i] = box.side[i % (size_t)dim] * rng_uniform(&rng);
      for (size_t i = 0; pack->angle && i < pack->n; i++)
        pack->angle[i] = 6.28 * rng_uniform(&rng);
      double reach = k % 2 ? 0.3 : 2.5;
      Distance *distance = distance_alloc(pack, reach);
      for (int p = 0; p < 30; p++) {
        double x[3];
        for (int j = 0; j < dim; j++)
          x[j] = box.side[j] * (p < 25 ? rng_uniform(&rng) : 1.4 * rng_uniform(&rng) - 0.2);
        int64_t without = p % 3 ? DISTANCE_ALL : p % (int)pack->n;
        double want = plain(pack, x, without), found = distance_nearest(distance, x, without);
        beyond += want > reach;
        differ += want > reach ? found < GSL_POSINF : !(fabs(found - want) < 1e-12);
      }
      distance_free(&distance);
      pack_free(&pack);
    }
    gsl_test_int(differ, 0, "kind %d: the nearest surface of all images", kind);
    gsl_test(beyond == 0, "kind %d: some beyond the reach", kind);
  }
  Species none = {"A", 1, 0};
  Box box = {2, {4, 4, 0}};
  Pack *pack = pack_alloc(&box, &none, 1, false);
  Distance *distance = distance_alloc(pack, 1);
  double x[2] = {1, 1};
  gsl_test(distance_nearest(distance, x, DISTANCE_ALL) != GSL_POSINF, "no particle");
  distance_free(&distance);
  pack_free(&pack);
  shape_free(&needle);
  shape_free(&five);
}

int main(void) {
  test_by_hand();
  test_bodies();
  test_packs();
  return gsl_test_summary();
}
