/* tests/test_box.c: sides from volumes, nearest images, and coordinates that stay in the box */
#include "box.h"
#include "rng.h"
#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <string.h>

static void test_sides(void) {
  static const double ratio[] = {1.37, 0.0825, 23.4};
  static const double volumes[] = {1e-150, 3.3e-7, 0.71, 1, 2.385, 27, 6.02e23, 1e150};
  for (int dim = 2; dim <= 3; dim++)
    for (size_t v = 0; v < sizeof volumes / sizeof *volumes; v++) {
      Box box = box_make(dim, ratio, volumes[v]);
      gsl_test_rel(box_volume(&box), volumes[v], 3e-15, "%d-D: volume %g", dim, volumes[v]);
      for (int k = 1; k < dim; k++)
        gsl_test_rel(box.side[k] / box.side[0], ratio[k] / ratio[0], 1e-15, "%d-D: ratio %d at %g", dim, k,
                     volumes[v]);
      gsl_test_rel(box_reach(&box), box.side[1] / 2, 0, "%d-D: reach at %g", dim, volumes[v]);
      gsl_test(dim == 2 && box.side[2] != 0, "%d-D: no third side at %g", dim, volumes[v]);
    }
  static const double ones[] = {1, 1, 1};
  Box cube = box_make(3, ones, 2.25 * 2.25 * 2.25), square = box_make(2, ones, 1.75 * 1.75);
  gsl_test(cube.side[0] != 2.25 || cube.side[2] != 2.25, "an exact cube has its exact root");
  gsl_test(square.side[1] != 1.75, "and an exact square");
}

/* The smallest of all images, and the same number for (i, j) as for (j, i). */
static void test_nearest(void) {
  Rng rng = rng_stream(41, 0, RNG_TEST);
  int longer = 0, uneven = 0, other = 0;
  double side = 7.2391;
  for (int i = 0; i < 100000; i++) {
    double x = side * rng_uniform(&rng), y = side * rng_uniform(&rng), least = GSL_POSINF;
    double d = box_nearest(y - x, side);
    for (int a = -2; a <= 2; a++)
      least = GSL_MIN(least, fabs((y - x) + a * side));
    longer += fabs(d) != least;
    uneven += box_nearest(x - y, side) != -d;
    other += d != y - x && d != (y - x) + side && d != (y - x) - side;
  }
  gsl_test_int(longer, 0, "the nearest image is the nearest");
  gsl_test_int(uneven, 0, "from i to j as from j to i");
  gsl_test_int(other, 0, "it is (x_j - x_i) + alpha L");
  gsl_test(box_nearest(3.5, 7) != 3.5 || box_nearest(-3.5, 7) != -3.5, "half a side stays");
  gsl_test(box_nearest(nextafter(3.5, 4), 7) >= 0, "more than half goes round");
}

static void test_wrap(void) {
  Rng rng = rng_stream(42, 0, RNG_TEST);
  double side = 3.1873;
  int moved = 0, outside = 0, far = 0;
  for (int i = 0; i < 100000; i++) {
    double x = side * rng_uniform(&rng), shift = side * (double)(int64_t)(rng_below(&rng, 2001) - 1000);
    double wrapped = box_wrap(x, side), back = box_wrap(x + shift, side);
    moved += memcmp(&wrapped, &x, sizeof x) != 0;
    outside += !(back >= 0 && back < side);
    far += fabs(box_nearest(back - x, side)) > 1e-12;
  }
  gsl_test_int(moved, 0, "inside, not a bit changes");
  gsl_test_int(outside, 0, "wrapped is inside");
  gsl_test_int(far, 0, "and the same point");
  const double edges[] = {-DBL_TRUE_MIN, -1e-300, -1e-17, side, nextafter(side, 4), nextafter(-side, 0), 1e300, -1e300};
  for (size_t e = 0; e < sizeof edges / sizeof *edges; e++) {
    double x = box_wrap(edges[e], side);
    gsl_test(!(x >= 0 && x < side), "%g is wrapped into the box", edges[e]);
  }
  gsl_test(box_wrap(side, side) != 0 || box_wrap(-1e-300, side) != 0, "the upper side is the lower one");
  gsl_test(box_wrap(nextafter(side, 0), side) != nextafter(side, 0), "just below it stays");
}

int main(void) {
  test_sides();
  test_nearest();
  test_wrap();
  return gsl_test_summary();
}
