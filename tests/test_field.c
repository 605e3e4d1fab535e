/* Sweeps of the radial field against all pairs, bit for bit; few particles. */
#include "field.h"
#include "outcome.h"
#include "ref_gravity.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double zero[3] = {0, 0, 0};

/* Points uniform in a cube about 0, and radii between 1 / ratio and 1. */
static void throw_points(int dim, size_t n, double half, double ratio,
                         uint64_t seed, double *x, double *radius) {
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t i = 0; i < n * (size_t)dim; i++)
    x[i] = half * (2 * rng_uniform(&rng) - 1);
  for (size_t i = 0; i < n; i++)
    radius[i] = 1 / (1 + (ratio - 1) * rng_uniform(&rng));
}

/* Grow, then pass with slack, then make one larger about itself: each sweep
   equals all pairs. how: 0 all, 1 follow, 2 whichever. */
static void exact(const char *what, int dim, size_t n, double half,
                  double ratio, double first, int how) {
  double *x = memory(n * (size_t)dim, sizeof *x),
         *radius = memory(n, sizeof *x);
  double *y = memory(n * (size_t)dim, sizeof *x);
  throw_points(dim, n, half, ratio, 3, x, radius);
  const double *own = ratio > 1 ? radius : NULL;
  Field *field = field_alloc(dim, n, x, own);
  double origin[3] = {0, 0, 0}, slack = 0;
  size_t wrong = 0, pushes = 0, counts = 0;
  for (int s = 0; s < 40; s++) {
    double size = s < 10 ? first + (1 - first) * s / 9 : 1;
    slack = s < 14 ? 0 : 1e-3;
    if (own && s >= 25) { /* one larger, in the centre of the field */
      size_t i = (size_t)(s * 7) % n;
      memcpy(origin, field_place(field, i), (size_t)dim * sizeof *origin);
      radius[i] *= 1.3;
      field_radius(field, i, radius[i]);
    }
    field->size = size;
    memcpy(field->origin, origin, sizeof origin);
    FieldSweep sweep = s < 15 || how == 0 ? field_sweep(field, slack)
                       : how == 1         ? field_follow(field, slack)
                                          : field_pass(field, slack);
    size_t ref = ref_gravity_sweep(dim, n, x, own, size, origin, slack);
    field_places(field, y);
    wrong += memcmp(x, y, n * (size_t)dim * sizeof *x) != 0;
    counts += ref != sweep.pushes;
    pushes += ref;
  }
  gsl_test(wrong > 0 || counts > 0,
           "%s, %d-D: %zu sweeps of 40 differ from all pairs, %zu counts", what,
           dim, wrong, counts);
  gsl_test(pushes < n, "%s, %d-D: enough pushes (%zu)", what, dim, pushes);
  field_free(&field);
  free(x);
  free(y);
  free(radius);
}

/* Radii at 0, two and three on a line: known places. */
static void few(void) {
  double x[] = {0, 0, 0, 1, 0, 0, 3, 0, 0};
  Field *field = field_alloc(3, 1, x, NULL);
  FieldSweep sweep = field_sweep(field, 0);
  gsl_test(sweep.pushes != 0 || field_rim(field) != 1, "one particle rests");
  field_free(&field);
  field = field_alloc(3, 3, x, NULL);
  sweep = field_sweep(field, 0);
  gsl_test_rel(field_place(field, 1)[0], 2, 0, "two: the outer is pushed to 2");
  gsl_test_rel(field_place(field, 2)[0], 4, 0, "three: and pushes the next");
  sweep = field_sweep(field, 0);
  gsl_test(sweep.pushes != 0, "then they rest");
  field_free(&field);
  double y[] = {0, 0, 0.1, 0, 3.9, 0}, a[] = {1, 0.5, 2};
  field = field_alloc(2, 3, y, a);
  field->size = 2;
  sweep = field_sweep(field, 0);
  gsl_test_rel(field_place(field, 1)[0], 3, 1e-15, "radii a: 2 (1 + 0.5)");
  gsl_test_rel(field_place(field, 2)[0], 8, 1e-15, "and then by 2 (0.5 + 2)");
  gsl_test(sweep.pushes != 3, "in three pushes");
  gsl_test_rel(sweep.deepest, 2.9, 1e-15, "the deepest");
  gsl_test(field_overlap(field) != 0, "no overlap is left");
  field_free(&field);
}

/* All at one place: parted to all sides, the same in both ways. */
static void coincident(int dim) {
  enum { N = 300 };
  double x[3 * N] = {0}, y[3 * N], span[3] = {0, 0, 0};
  Field *field = field_alloc(dim, N, x, NULL);
  size_t wrong = 0;
  for (int s = 0; s < 60; s++) {
    ref_gravity_sweep(dim, N, x, NULL, 1, zero, 0);
    if (s % 2)
      field_follow(field, 0);
    else
      field_sweep(field, 0);
    field_places(field, y);
    wrong += memcmp(x, y, N * (size_t)dim * sizeof *x) != 0;
  }
  gsl_test(wrong > 0, "coincident, %d-D: %zu sweeps differ", dim, wrong);
  for (size_t i = 0; i < N * (size_t)dim; i++)
    span[i % (size_t)dim] = GSL_MAX(span[i % (size_t)dim], fabs(y[i]));
  gsl_test(!(span[dim - 1] > 3 && span[dim - 1] < 60), "to all sides (%g)",
           span[dim - 1]);
  gsl_test(!(field_overlap(field) < 0.5), "%d-D: and come to rest (%g)", dim,
           field_overlap(field));
  gsl_test(field_place(field, 0)[0] != 0, "the first stays");
  field_free(&field);
}

/* Of two at one distance the lower number is the inner one, whatever the cells.
 */
static void tie(bool follow) {
  double x[] = {0, 0, 2.5, 0.5, 2.5, -0.5, 0, -20};
  Field *field = field_alloc(2, 4, x, NULL);
  FieldSweep sweep = follow ? field_follow(field, 0) : field_sweep(field, 0);
  gsl_test(sweep.pushes != 1 || field_place(field, 1)[1] != 0.5,
           "two at one distance: the lower number stays");
  gsl_test_rel(field_place(field, 2)[1], -1.5, 1e-15, "the other goes");
  field_free(&field);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    double half = dim == 2 ? 14 : 5;
    exact("one size, all", dim, 300, half, 1, 0.3, 0);
    exact("one size, follow", dim, 300, half, 1, 0.3, 1);
    exact("one size, whichever", dim, 300, half, 1, 0.3, 2);
    exact("mixed, all", dim, 300, half * 0.6, 3, 0.3, 0);
    exact("mixed, follow", dim, 300, half * 0.6, 3, 0.3, 1);
    exact("ratio 100, whichever", dim, 300, half * 0.1, 100, 0.3, 2);
    exact("half the radius a step", dim, 200, half, 1, 0.05, 1);
    coincident(dim);
  }
  few();
  tie(false);
  tie(true);
  return gsl_test_summary();
}
