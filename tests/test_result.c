/* tests/test_result.c: samples of one pack, added and divided. */
#include "result.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static const Told told[] = {{.name = "mean"}, {.name = "least", .reduce = LEAST}, {.name = NULL}};

/* The mean, its error, and the least value of three samples. */
static void sum_of(const double value[3], double *mean, double *error, double *least) {
  Layout layout = {.numbers = 0};
  Result sum;
  free(layout_add(&layout, told, NULL, NULL));
  layout.measured = 0;
  result_begin(&sum, &layout);
  for (int i = 0; i < 3; i++) {
    Result sample;
    result_begin(&sample, &layout);
    sample.number[0] = sample.number[1] = sample.error[0] = value[i];
    result_add(&sum, &sample, i == 0);
  }
  result_divide(&sum, 3);
  *mean = sum.number[0];
  *error = sum.error[0];
  *least = sum.number[1];
  result_free(&sum);
  layout_free(&layout);
}

int main(void) {
  static const double whole[] = {3, 1, 5};
  double mean, error, least;
  sum_of(whole, &mean, &error, &least);
  gsl_test(!(mean == 3 && error == 3), "three samples: mean %g, its error %g", mean, error);
  gsl_test(!(least == 1), "the least of them: %g", least);
  for (int gap = 0; gap < 3; gap++) {
    double value[] = {3, 1, 5};
    value[gap] = GSL_NAN;
    sum_of(value, &mean, &error, &least);
    gsl_test(!(gsl_isnan(mean) && gsl_isnan(error)), "what sample %d lacks is missing in the mean", gap);
    gsl_test(!gsl_isnan(least), "and in the least, sample %d", gap);
  }
  return gsl_test_summary();
}
