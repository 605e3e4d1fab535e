/* test_sizes.c: the laws against closed forms and quadrature, the radii against
   the cuts of their law, and what is said of a law that is none. */
#include "sizes.h"
#include "outcome.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LAWS = 17, N = 20000 };
static const double four[] = {0.5, 1, 2, 8}, through[] = {0, 0.25, 0.25, 2},
                    atom[] = {30, 50, 120, 120}, two[] = {0.125, 1},
                    straight[] = {0, 1}, all[] = {1, 1},
                    ten[] = {0.05, 0.1, 0.25, 0.5, 1, 1.4, 2.12, 2.8, 4, 6},
                    sand[] = {2, 5, 12, 22, 37, 46, 58, 71, 88, 100};

static Sizes lognormal(int dim, double spread, double least, double most) {
  return (Sizes){.law = SIZES_LOGNORMAL,
                 .dim = dim,
                 .radius = 0.7,
                 .spread = spread,
                 .least = least,
                 .most = most};
}

static Sizes power(int dim, double exponent, double least, double most) {
  return (Sizes){.law = SIZES_POWER,
                 .dim = dim,
                 .exponent = exponent,
                 .least = least,
                 .most = most};
}

static Sizes sieve(int dim, int sieves, const double *size,
                   const double *passing) {
  return (Sizes){.law = SIZES_SIEVE,
                 .dim = dim,
                 .sieves = sieves,
                 .size = size,
                 .passing = passing};
}

/* the laws of all tests below */
static void laws(int dim, Sizes s[LAWS]) {
  int k = 0;
  s[k++] = lognormal(dim, 0.25, 0, (double)INFINITY);
  s[k++] = lognormal(dim, 1, 0, (double)INFINITY);
  s[k++] = lognormal(dim, 3, 0, (double)INFINITY);
  s[k++] = lognormal(dim, 0.5, 0.3, 2);
  s[k++] = lognormal(dim, 0.2, 1.3, 1.5); /* in the tail */
  s[k++] = lognormal(dim, 0.2, 0, 0.4);
  s[k++] = power(dim, 0.5, 0.1, 10);
  s[k++] = power(dim, -1, 0.1, 10);
  s[k++] = power(dim, dim, 0.1, 10);
  s[k++] = power(dim, 0, 2, 3);
  s[k++] = power(dim, 1e-9, 1, 100);
  s[k++] = power(dim, dim + 1e-9, 1, 100);
  s[k++] = power(dim, 6, 1, 4);
  s[k++] = sieve(dim, 4, four, through);
  s[k++] = sieve(dim, 4, four, atom);
  s[k++] = sieve(dim, 2, two, straight);
  s[k++] = sieve(dim, 10, ten, sand);
}

/* ---- the second method: densities in t = ln a, and quadrature ---- */

typedef struct {
  const Sizes *s;
  double moment; /* the density of number, up to a factor, times a^moment */
} Density;

static double density(double t, void *data) {
  const Density *of = data;
  const Sizes *s = of->s;
  double a = exp(t), f = 0;
  if (s->law == SIZES_LOGNORMAL)
    f = exp(-0.5 * gsl_pow_2(log(a / s->radius) / s->spread));
  else if (s->law == SIZES_POWER)
    f = pow(a, s->exponent - s->dim);
  for (int c = 1; s->law == SIZES_SIEVE && c < s->sieves; c++)
    if (a >= s->size[c - 1] && a < s->size[c])
      f = (s->passing[c] - s->passing[c - 1]) /
          log(s->size[c] / s->size[c - 1]) * pow(a, -s->dim);
  return f * pow(a, of->moment);
}

static void ends(const Sizes *s, double *from, double *to) {
  if (s->law == SIZES_SIEVE) {
    *from = s->size[0], *to = s->size[s->sieves - 1];
    return;
  }
  bool normal = s->law == SIZES_LOGNORMAL;
  *from = normal ? fmax(s->least, s->radius * exp(-10 * s->spread)) : s->least;
  *to = normal ? fmin(s->most,
                      s->radius * exp((10 + s->dim * s->spread) * s->spread))
               : s->most;
}

/* of everything up to a; an end of a class is an end of a quadrature */
static double integral(const Sizes *s, double moment, double a) {
  static gsl_integration_workspace *work;
  Density of = {s, moment};
  gsl_function f = {density, &of};
  double from, to, sum = 0;
  if (!work)
    work = gsl_integration_workspace_alloc(200);
  ends(s, &from, &to);
  if (s->law == SIZES_SIEVE)
    sum = s->passing[0] * pow(from, moment - s->dim);
  for (double next; from < fmin(a, to); from = next) {
    double part = 0, error;
    next = fmin(a, to);
    for (int c = 0; s->law == SIZES_SIEVE && c < s->sieves; c++)
      if (s->size[c] > from)
        next = fmin(next, s->size[c]);
    gsl_integration_qag(&f, log(from), log(next), 0, 1e-11, 200, 6, work, &part,
                        &error);
    sum += part;
  }
  return sum;
}

static void test_law(const Sizes *s, int k) {
  double from, to, all_number, all_volume;
  Outcome out = {0};
  gsl_test_int(sizes_check(s, &out), DONE, "law %d is right", k);
  ends(s, &from, &to);
  all_number = integral(s, 0, to);
  all_volume = integral(s, s->dim, to);
  gsl_test_rel(sizes_mean_volume(s), all_volume / all_number, 1e-9,
               "law %d, %d-D: mean volume", k, s->dim);
  for (int i = 0; i <= 10; i++) {
    double a = from * pow(to / from, i / 10.);
    gsl_test_abs(sizes_number(s, a), integral(s, 0, a) / all_number, 1e-9,
                 "law %d, %d-D: number to %g", k, s->dim, a);
    gsl_test_abs(sizes_passing(s, a), integral(s, s->dim, a) / all_volume, 1e-9,
                 "law %d, %d-D: volume to %g", k, s->dim, a);
  }
  gsl_test(sizes_number(s, from * 0.99) > 1e-12 ||
               sizes_passing(s, to) < 1 - 1e-12,
           "law %d: nothing outside", k);
}

/* ---- the radii ---- */

static double volumes(const Sizes *s, const double a[], size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++)
    sum += gsl_pow_int(a[i], s->dim);
  return sum;
}

static void test_fill(const Sizes *s, int k, size_t n) {
  static double a[N];
  double number, volume, from, to;
  size_t odd = 0, falls = 0;
  ends(s, &from, &to);
  sizes_fill(s, n, a);
  gsl_test_rel(volumes(s, a, n), (double)n * sizes_mean_volume(s), 2e-7,
               "law %d, %d-D, %zu: the volume of the law", k, s->dim, n);
  for (size_t i = 0; i < n; i++) {
    int exponent;
    double mantissa = ldexp(frexp(a[i], &exponent), 24);
    falls += i > 0 && a[i] < a[i - 1];
    odd += mantissa != floor(mantissa) && a[i] != from && a[i] != to;
  }
  gsl_test(falls > 0, "law %d, %zu: ascending", k, n);
  gsl_test(odd > 0, "law %d, %zu: 24 bits", k, n);
  gsl_test(a[0] < from || a[n - 1] > to, "law %d, %zu: within its ends", k, n);
  sizes_compare(s, a, n, &number, &volume);
  gsl_test(!(number < 1. / (double)n), "law %d, %zu: one particle, %g", k, n,
           number * (double)n);
  double other[2];
  for (size_t i = 0; i < n / 2; i++) {
    double swap = a[i];
    a[i] = a[n - 1 - i];
    a[n - 1 - i] = swap;
  }
  sizes_compare(s, a, n, other, other + 1);
  gsl_test(other[0] != number || other[1] != volume, "law %d, %zu: any order",
           k, n);
  double largest = gsl_pow_int(a[0], s->dim) / volumes(s, a, n);
  gsl_test(!(volume < largest + 1e-9), "law %d, %zu: its volume, %g", k, n,
           volume / largest);
}

/* The radius up to which the law has the share y of number, by bisection. */
static double cut(const Sizes *s, double y) {
  double from, to;
  ends(s, &from, &to);
  for (int i = 0; i < 70; i++) {
    double middle = sqrt(from * to);
    *(sizes_number(s, middle) < y ? &from : &to) = middle;
  }
  return to;
}

static void test_strata(const Sizes *s, int k, size_t n) {
  double a[64], before = 0, share = 0;
  sizes_fill(s, n, a);
  for (size_t j = 1; j <= n; j++) {
    double end = cut(s, (double)j / (double)n);
    double upto = j < n ? sizes_passing(s, end) : 1;
    double jump = upto - sizes_passing(s, end * (1 - 1e-12));
    double volume =
        gsl_pow_int(a[j - 1], s->dim) / ((double)n * sizes_mean_volume(s));
    share += volume;
    if (jump < 1e-9) { /* else the cut is within a single size */
      gsl_test_abs(share, upto, 2e-7, "law %d, %zu: volume at cut %zu", k, n,
                   j);
      if (before >= 0)
        gsl_test_rel(volume, upto - before, 3e-7,
                     "law %d, %zu: volume of stratum %zu", k, n, j);
    }
    before = jump < 1e-9 ? upto : -1;
  }
}

/* ---- closed forms ---- */

static void test_lognormal(void) {
  for (int d = 2; d <= 3; d++)
    for (double spread = 0.1; spread < 1.5; spread *= 2) {
      Sizes s = lognormal(d, spread, 0, (double)INFINITY);
      gsl_test_rel(sizes_mean_volume(&s),
                   gsl_pow_int(0.7, d) * exp(d * d * spread * spread / 2),
                   1e-14, "mean a^%d, spread %g", d, spread);
      gsl_test_rel(sizes_number(&s, 0.7), 0.5, 1e-14, "median by number");
      gsl_test_rel(sizes_passing(&s, 0.7 * exp(d * spread * spread)), 0.5,
                   1e-14, "median by volume");
      double a[1];
      sizes_fill(&s, 1, a);
      gsl_test_rel(a[0], 0.7 * exp(d * spread * spread / 2), 6e-8,
                   "one particle has the mean volume");
    }
}

static void test_power(void) {
  double a[3], number, volume;
  Sizes s = power(3, 3, 1, 100);
  gsl_test_rel(sizes_passing(&s, 50), (125e3 - 1) / (1e6 - 1), 1e-14, "a^3");
  gsl_test_rel(sizes_number(&s, 10), 0.5, 1e-14, "number is a logarithm");
  gsl_test_rel(sizes_mean_volume(&s), (1e6 - 1) / (3 * log(100)), 1e-14,
               "its mean");
  sizes_fill(&s, 2, a);
  gsl_test_rel(gsl_pow_3(a[0]), 999 / (3 * log(10)), 2e-7, "its lower half");
  gsl_test_rel(gsl_pow_3(a[1]), (1e6 - 1e3) / (3 * log(10)), 2e-7,
               "its upper half");
  s = power(3, 0.5, 1, 100); /* the numbers of the trap */
  gsl_test_rel(sizes_number(&s, 1.32), 0.5, 2e-3, "half are small");
  double *many = malloc(1000 * sizeof *many);
  sizes_fill(&s, 1000, many);
  sizes_compare(&s, many, 1000, &number, &volume);
  gsl_test(!(number < 1e-3 && volume > 0.4 && many[999] < 35 &&
             gsl_pow_3(many[999]) > 0.5 * volumes(&s, many, 1000)),
           "a thousand do not show the coarse: %g, %g", volume, many[999]);
  free(many);
}

static void test_sieve(void) {
  static double a[N];
  Sizes s = sieve(3, 10, ten, sand);
  for (int c = 0; c < 10; c++)
    gsl_test_rel(sizes_passing(&s, ten[c]), sand[c] / 100, 1e-15,
                 "through its own point %d", c);
  gsl_test_rel(sizes_passing(&s, sqrt(0.5)), 0.295, 1e-14, "and between");
  s = sieve(3, 4, four, atom);
  gsl_test(sizes_passing(&s, nextafter(0.5, 0)) != 0, "nothing is smaller");
  gsl_test_rel(sizes_passing(&s, 0.5), 0.25, 1e-15, "a jump");
  gsl_test_rel(sizes_passing(&s, 5), 1, 1e-15, "an empty class at the end");
  s = sieve(3, 4, four, through);
  gsl_test_rel(sizes_passing(&s, 1.7), 0.125, 1e-15, "an empty class");
  sizes_fill(&s, N, a);
  int gap = 0;
  double number, volume;
  for (int i = 0; i < N; i++)
    gap += a[i] > 1.0001 && a[i] < 1.9999;
  gsl_test(gap > 1, "one particle may straddle: %d", gap);
  const double within[] = {0, 0, 1, 1};
  s = sieve(3, 4, four, within);
  gsl_test(sizes_passing(&s, 0.7) != 0 || sizes_number(&s, 1) != 0,
           "nothing in an empty class at the beginning");
  gsl_test_rel(sizes_passing(&s, sqrt(2)), 0.5, 1e-15, "between empty ones");
  gsl_test(sizes_number(&s, 2) != 1, "nothing in one at the end");
  sizes_fill(&s, 3, a);
  sizes_compare(&s, a, 3, &number, &volume);
  gsl_test(!(a[0] > 1 && a[2] < 2 && number < 1. / 3), "between its ends: %g",
           number);
}

static void test_one_size(void) {
  double a[9], number, volume;
  const double size[] = {0.1, 0.2};
  Sizes s[] = {lognormal(3, 0, 0, (double)INFINITY), sieve(2, 1, size, all),
               sieve(2, 2, size, all)};
  for (int k = 0; k < 3; k++) {
    Outcome out = {0};
    double want = k == 0 ? 0.7 : 0.1;
    gsl_test_int(sizes_check(s + k, &out), DONE, "one size is a law");
    sizes_fill(s + k, 9, a);
    gsl_test(a[0] != want || a[8] != want, "one size, as given: %.17g", a[8]);
    sizes_compare(s + k, a, 9, &number, &volume);
    gsl_test(number > 0 || volume > 0, "and exactly: %g, %g", number, volume);
  }
  a[1] = 1.4, a[0] = 2.8;
  sizes_compare(s, a, 2, &number, &volume);
  gsl_test_rel(number, 1, 1e-15, "no radius is right");
  a[0] = 0.7;
  sizes_compare(s, a, 2, &number, &volume);
  gsl_test_rel(number, 0.5, 1e-15, "half the number is wrong");
  gsl_test_rel(volume, 8. / 9, 1e-15, "and most of the volume");
  a[1] = 0.35, a[0] = 0.7;
  sizes_compare(s, a, 2, &number, &volume);
  gsl_test_rel(volume, 1. / 9, 1e-15, "too small");
}

/* ---- what is no law ---- */

static void refused(const Sizes *s, const char *part) {
  Outcome out = {0};
  gsl_test_int(sizes_check(s, &out), WRONG, "refused: %s", part);
  gsl_test(!strstr(out.text, part), "'%s' says '%s'", out.text, part);
}

static void test_check(void) {
  const double inf = (double)INFINITY, nan = (double)NAN;
  const double down[] = {1, 2, 2, 3}, falls[] = {0, 2, 1, 3}, none[] = {0, 0};
  Sizes s[] = {lognormal(3, nan, 0, inf),  lognormal(3, -0.1, 0, inf),
               lognormal(3, 5.1, 0, inf),  lognormal(3, 0.1, -1, inf),
               lognormal(3, 0.1, 1, 1),    lognormal(3, 0.1, 3, 4),
               lognormal(2, 0, 1, 2),      lognormal(3, 0.1, 0, 1),
               power(3, 0.5, 0, 1),        power(3, 0.5, 1, inf),
               power(3, 0.5, 2, 1),        power(3, nan, 1, 2),
               power(3, 200, 1, 100),      sieve(3, 0, four, through),
               sieve(3, 4, down, through), sieve(3, 4, four, falls),
               sieve(3, 2, four, none)};
  const char *part[] = {"spread is nan",      "spread is -0.1",
                        "spread is 5.1",      "least is -1",
                        "most is 1",          "between least, 3",
                        "between least",      "radius is -1",
                        "least is 0",         "most is inf",
                        "least is 2",         "exponent is nan",
                        "exponent is 200",    "no sieves",
                        "sieve 3 has radius", "sieve 3 passes 1 after 2",
                        "nothing passes"};
  s[7].radius = -1;
  for (size_t k = 0; k < sizeof s / sizeof *s; k++)
    refused(s + k, part[k]);
}

/* A list: these radii, as many as it counts; twice as many; and a law of others. */
static void test_list(void) {
  static const double size[] = {0.1, 0.3, 0.7, 1.9}, count[] = {3, 0, 5, 2};
  double radius[20], number, volume;
  for (int dim = 2; dim <= 3; dim++) {
    Sizes list = {.law = SIZES_LIST, .dim = dim, .sieves = 4, .size = size, .passing = count};
    Outcome out = {0};
    double sum = 0;
    int wrong = 0;
    gsl_test_int(sizes_check(&list, &out), DONE, "%d-D, a list is a law (%s)", dim, out.text);
    sizes_fill(&list, 10, radius);
    for (int i = 0; i < 10; i++) {
      wrong += radius[i] != (i < 3 ? 0.1 : i < 8 ? 0.7 : 1.9);
      sum += pow(radius[i], dim);
    }
    gsl_test_int(wrong, 0, "%d-D, a list of ten is these ten", dim);
    gsl_test_rel(sizes_mean_volume(&list), sum / 10, 1e-15, "%d-D, a list: mean volume", dim);
    sizes_compare(&list, radius, 10, &number, &volume);
    gsl_test(number > 1e-15 || volume > 1e-15, "%d-D, a list: shares %g %g", dim, number, volume);
    gsl_test_rel(sizes_passing(&list, 0.5), 3 * pow(0.1, dim) / sum, 1e-14, "%d-D, a list: share of the volume", dim);
    sizes_fill(&list, 20, radius);
    gsl_test(radius[5] != 0.1 || radius[6] != 0.7 || radius[15] != 0.7 || radius[16] != 1.9, "%d-D, a list: twice as many", dim);
    sizes_fill(&list, 3, radius);
    gsl_test(radius[0] != 0.1 || radius[1] != 0.7 || radius[2] != 1.9, "%d-D, a list: three of its parts", dim);
  }
  Sizes none = {.law = SIZES_LIST, .dim = 3, .sieves = 2, .size = size + 1, .passing = count + 1};
  Outcome out = {0};
  none.sieves = 1;
  gsl_test(sizes_check(&none, &out) != WRONG || !strstr(out.text, "no particle; "), "a list of nobody: %s", out.text);
}

int main(void) {
  static const size_t counts[] = {1, 2, 7, 1000, N};
  for (int dim = 2; dim <= 3; dim++) {
    Sizes s[LAWS];
    laws(dim, s);
    for (int k = 0; k < LAWS; k++) {
      test_law(s + k, k);
      for (int c = 0; c < 5; c++)
        test_fill(s + k, k, counts[c]);
      test_strata(s + k, k, 7);
      test_strata(s + k, k, 50);
    }
  }
  test_lognormal();
  test_power();
  test_sieve();
  test_list();
  test_one_size();
  test_check();
  return gsl_test_summary();
}
