/* The contact value: bias of the fit on exact profiles, counts drawn from a
   known g, packs of a known contact value. */
#include "contact.h"
#include "many.h"
#include "outcome.h"
#include "pairs.h"
#include "rng.h"
#include <complex.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

/* Percus-Yevick, first shell (reference a): x g = sum of residues. */
static double complex py_S(double p, double complex t) {
  return (1 - p) * (1 - p) * t * t * t + 6 * p * (1 - p) * t * t +
         18 * p * p * t - 12 * p * (1 + 2 * p);
}

static void py_roots(double p, double complex root[3]) {
  for (int i = 0; i < 3; i++)
    root[i] = cpow(0.4 + 0.9 * I, i) * (1 + 3 * p);
  for (int step = 0; step < 500; step++)
    for (int i = 0; i < 3; i++) {
      double complex d = (1 - p) * (1 - p);
      for (int j = 0; j < 3; j++)
        d *= j == i ? 1 : root[i] - root[j];
      root[i] -= py_S(p, root[i]) / d;
    }
}

static double py_g(double p, const double complex root[3], double x) {
  double complex sum = 0;
  for (int i = 0; i < 3; i++) {
    double complex t = root[i];
    sum += t * ((1 + p / 2) * t + 1 + 2 * p) * cexp(t * (x - 1)) /
           (3 * (1 - p) * (1 - p) * t * t + 12 * p * (1 - p) * t + 18 * p * p);
  }
  return creal(sum) / x;
}

/* Exact means in thin shells (Simpson); the bias against the noise of fifty
   packs of 2000. */
static void test_bias(void) {
  enum { BINS = 200 };
  const double phi[] = {0.1, 0.3, 0.49, 0.575, 0.6};
  for (int f = 0; f < 5; f++) {
    double p = phi[f], g[BINS], variance[BINS], near = 0, window = 0;
    double complex root[3];
    py_roots(p, root);
    double exact = (1 + p / 2) / ((1 - p) * (1 - p));
    gsl_test_rel(py_g(p, root, 1), exact, 1e-12, "PY at contact, %g", p);
    for (; near < 3 && window < 0.25; window += 1e-5)
      near += 24 * p * gsl_pow_2(1 + window) * py_g(p, root, 1 + window) * 1e-5;
    double step = window / BINS;
    for (int b = 0; b < BINS; b++) {
      double x = 1 + b * step, half = x + step / 2, end = x + step;
      g[b] = (py_g(p, root, x) * x * x + 4 * py_g(p, root, half) * half * half +
              py_g(p, root, end) * end * end) /
             (x * x + 4 * half * half + end * end);
      variance[b] = g[b] / (24 * p * half * half * step * 1000 * 50);
    }
    Contact c = contact_fit(3, g, variance, 1, step, BINS, CONTACT_DEGREE);
    gsl_test(!(fabs(c.value - exact) < 0.1 * c.error),
             "bias at %g: %.3f of the noise (%.2f %%)", p,
             (c.value - exact) / c.error, 100 * c.error / exact);
    gsl_test_rel(c.window, window, 1e-12, "window");
    gsl_test(!(c.error / exact < 0.02), "error is small");
  }
}

/* A polynomial times shells is reproduced to rounding, 2-D and 3-D. */
static void test_polynomial(void) {
  double g[40], variance[40] = {0};
  for (int dim = 2; dim <= 3; dim++)
    for (int degree = 0; degree < 4; degree++) {
      for (int b = 0; b < 40; b++) { /* g = sum (k + 1.7) (r - 2.3)^k */
        double r1 = 2.3 + 0.01 * b, moment = 0, volume = 0;
        for (int q = 0; q < 4000; q++) {
          double r = r1 + 0.01 * (q + 0.5) / 4000, s = dim == 2 ? r : r * r;
          double u = r - 2.3, value = 0;
          for (int k = degree; k >= 0; k--)
            value = value * u + k + 1.7;
          moment += s * value;
          volume += s;
        }
        g[b] = moment / volume;
      }
      Contact c = contact_fit(dim, g, variance, 2.3, 0.01, 40, degree);
      gsl_test_rel(c.value, 1.7, 1e-8, "degree %d in %d-D", degree, dim);
    }
}

/* Poisson counts of a steep known g: mean and error of the linear fit. */
static void test_error(void) {
  enum { BINS = 64 };
  const int P = as_many(1500, 4000);
  gsl_rng *rng = rng_gsl_alloc(rng_stream(91, 0, RNG_TEST));
  double sum = 0, square = 0, error = 0;
  for (int p = 0; p < P; p++) {
    double g[BINS], variance[BINS], step = 0.06 / BINS;
    for (int b = 0; b < BINS; b++) {
      double x = 1 + (b + 0.5) * step;
      double unit = 8000 * x * x * step; /* pairs for g = 1: few a bin */
      unsigned n = gsl_ran_poisson(rng, unit * 7.1 * exp(-7 * (x - 1)));
      g[b] = n / unit;
      variance[b] = n / (unit * unit);
    }
    Contact c = contact_fit(3, g, variance, 1, step, BINS, CONTACT_DEGREE);
    sum += c.value / P;
    square += c.value * c.value / P;
    error += c.error * c.error / P;
  }
  double sd = sqrt(square - sum * sum);
  gsl_test_abs(sum, 7.1, 4 * sd / sqrt(P), "mean of fits (sd %.3f)", sd);
  gsl_test_rel(sqrt(error), sd, 4 / sqrt(2. * P), "their error");
  gsl_rng_free(rng);
}

/* A pack of m^dim pairs on a wide grid; the distance of a pair has the density
   r^(d-1) exp(-kappa (r / sigma - 1)) from sigma on, by rejection. */
static void dimers(Pack *pack, int m, double sigma, double kappa, Rng *rng) {
  size_t dim = (size_t)pack->box.dim;
  double side = pack->box.side[0], *x = pack->x;
  for (size_t c = 0; c < pack->n / 2; c++) {
    double u[3] = {0, 0, 0}, s;
    do
      s = -log(1 - rng_uniform(rng)) / (kappa - 2);
    while (rng_uniform(rng) > pow(1 + s, (double)dim - 1) * exp(-2 * s));
    rng_direction(rng, (int)dim, u);
    size_t at = c;
    for (size_t k = 0; k < dim; k++, at /= (size_t)m) {
      x[k] = ((double)(at % (size_t)m) + 0.25) * side / m;
      x[dim + k] = box_wrap(x[k] + sigma * (1 + s) * u[k], side);
    }
    x += 2 * dim;
  }
}

/* The same limit by another way: g = c exp(-kappa u) in the window, kappa by
   maximum likelihood from the pooled mean of u. Returns c / (pairs there). */
static double by_likelihood(int dim, double mean, double window) {
  double low = 1e-3, high = 1e3, norm = 1;
  for (int step = 0; step < 200; step++) {
    double kappa = 0.5 * (low + high), first = 0;
    norm = 0;
    for (int q = 0; q < 4000; q++) {
      double u = window * (q + 0.5) / 4000;
      double f = pow(1 + u, dim - 1) * exp(-kappa * u) * window / 4000;
      norm += f;
      first += u * f;
    }
    if (first / norm > mean)
      low = kappa;
    else
      high = kappa;
  }
  return 1 / norm;
}

static void test_packs(int dim) {
  enum { FINE = 400 };
  const int P = as_many(120, 400);
  int m = dim == 2 ? 30 : 10;
  double sigma = 0.731, kappa = 20, W = 0.05;
  size_t pairs = dim == 2 ? 900 : 1000;
  Species species = {.name = "a", .radius = sigma / 2, .count = 2 * pairs};
  double ratio[3] = {1, 1, 1}, norm = 0, mean = 0, square = 0, error = 0;
  Box box = box_make(dim, ratio, pow(4 * sigma * m, dim));
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int q = 0; q < 200000; q++) {
    double u = 2.0 * (q + 0.5) / 200000;
    norm += pow(1 + u, dim - 1) * exp(-kappa * u) * 2.0 / 200000;
  }
  /* pairs per unit of r / sigma at contact, over those of g = 1 */
  double unit = box_volume(&box) / ((double)pairs * (2 * (double)pairs - 1)) /
                ((dim == 2 ? 2 : 4) * M_PI * pow(sigma, dim));
  double exact = (double)pairs / norm * unit, first = 0, u_sum = 0, n_sum = 0;
  double fixed = 0;
  for (int p = 0; p < P; p++) {
    Rng rng = rng_stream(4, (uint64_t)p, RNG_TEST);
    dimers(pack, m, sigma, kappa, &rng);
    Contact c = contact_value(pack, sigma, CONTACT_DEGREE, 0.35);
    mean += c.value / P;
    square += c.value * c.value / P;
    error += c.error * c.error / P;
    gsl_test(!(c.window > 0.01 && c.window < 0.04), "window %g", c.window);
    fixed += contact_value(pack, sigma, CONTACT_DEGREE, 0).window / P;
    first += contact_first_bin(pack, sigma, 0.001 * sigma) / P;
    uint64_t count[FINE];
    pairs_count(pack, sigma, sigma * W / FINE, FINE, count);
    for (int b = 0; b < FINE; b++) {
      n_sum += (double)count[b];
      u_sum += (double)count[b] * W * (b + 0.5) / FINE;
    }
  }
  double se = sqrt((square - mean * mean) / (P - 1));
  gsl_test_abs(mean, exact, 4 * se, "%d-D: contact of drawn packs, se %.4f",
               dim, se);
  gsl_test_rel(sqrt(error / P), se, 0.2, "%d-D: error of one pack", dim);
  gsl_test_rel(fixed, 0.25, 1e-12, "%d-D: the widest window", dim);
  double second = by_likelihood(dim, u_sum / n_sum, W) * n_sum / P * unit;
  gsl_test_abs(mean, second, 4 * se, "%d-D: and by likelihood", dim);
  gsl_test_rel(second, exact, 0.02, "%d-D: likelihood", dim);
  gsl_test_rel(first, exact * (1 - 0.5 * kappa * 0.001), 0.05,
               "%d-D: first bin", dim);
  pack_free(&pack);
}

/* contact_value is contact_fit on the counts of pairs_count. */
static void test_same(void) {
  enum { BINS = 512 };
  double ratio[3] = {1, 1, 1}, g[BINS], variance[BINS], step = 0.25 / BINS;
  Species species = {.name = "a", .radius = 0.5, .count = 2000};
  Box box = box_make(3, ratio, pow(4 * 10, 3));
  Pack *pack = pack_alloc(&box, &species, 1, false);
  Rng rng = rng_stream(6, 0, RNG_TEST);
  dimers(pack, 10, 1, 9, &rng);
  uint64_t count[BINS];
  pairs_count(pack, 1, step, BINS, count);
  for (int b = 0; b < BINS; b++) {
    double unit = 2 * box_volume(&box) / (2000. * 1999) /
                  pairs_shell(3, 1 + b * step, 1 + (b + 1) * step);
    g[b] = unit * (double)count[b];
    variance[b] = unit * unit * (double)count[b];
  }
  Contact c = contact_value(pack, 1, CONTACT_DEGREE, 0);
  Contact d = contact_fit(3, g, variance, 1, step, BINS, CONTACT_DEGREE);
  gsl_test_rel(c.value, d.value, 1e-10, "value by hand");
  gsl_test_rel(c.error, d.error, 1e-10, "error by hand");
  pack_free(&pack);
}

/* A jammed peak, ten thousand times narrower: the window follows. */
static void test_narrow(void) {
  double ratio[3] = {1, 1, 1}, sigma = 1.3;
  Species species = {.name = "a", .radius = 0.65, .count = 2000};
  Box box = box_make(3, ratio, pow(4 * sigma * 10, 3));
  Pack *pack = pack_alloc(&box, &species, 1, false);
  double kappa = 2e5, exact = box_volume(&box) / (1000. * 1999) * 1000 * kappa /
                              (4 * M_PI * gsl_pow_3(sigma));
  double mean = 0, square = 0;
  for (uint64_t p = 0; p < 40; p++) {
    Rng rng = rng_stream(5, p, RNG_TEST);
    dimers(pack, 10, sigma, kappa, &rng);
    Contact c = contact_value(pack, sigma, CONTACT_DEGREE, 0.35);
    gsl_test(!(c.window > 1e-6 && c.window < 4e-6), "window %g", c.window);
    mean += c.value / 40;
    square += c.value * c.value / 40;
  }
  double se = sqrt((square - mean * mean) / 39);
  gsl_test_abs(mean, exact, 4 * se, "narrow peak, se %.3g", se);
  pack_free(&pack);
}

static void test_small(void) {
  double ratio[3] = {1, 1, 1};
  for (size_t n = 0; n < 4; n++) {
    Species species = {.name = "a", .radius = 0.5, .count = n};
    Box box = box_make(3, ratio, 1000);
    Pack *pack = pack_alloc(&box, &species, 1, false);
    for (size_t i = 0; i < n; i++)
      pack->x[3 * i] = 3.0 * (double)i;
    Contact c = contact_value(pack, 1, CONTACT_DEGREE, 0);
    gsl_test(c.value != 0 || c.error != 0, "%zu far particles", n);
    gsl_test(contact_first_bin(pack, 1, 0.1) != 0, "no first bin");
    c = contact_value(pack, 6, CONTACT_DEGREE, 0);
    gsl_test(c.value != 0 || c.window != 0, "contact beyond half the box");
    /* all in contact, to rounding: a delta, found and finite */
    for (size_t i = 0; i < n; i++)
      pack->x[3 * i] = (double)i * (1 - 1e-15);
    double g = contact_first_bin(pack, 1, 0.2);
    gsl_test_rel(g,
                 n < 2
                     ? 0
                     : (double)(n - 1) * 1000 / (0.5 * (double)(n * (n - 1))) /
                           (4. / 3 * M_PI * (1.728 - 1)),
                 1e-13, "first bin, %zu in a row", n);
    c = contact_value(pack, 1, CONTACT_DEGREE, 0);
    gsl_test(n > 1 ? !(c.value > 1 && gsl_finite(c.value)) : c.value != 0,
             "%zu in a row: %g", n, c.value);
    for (size_t i = 0; i < n; i++) /* an overlap wider than the edge rule's */
      pack->x[3 * i] = (double)i * (1 - 1e-9);
    Contact d = contact_value(pack, 1, CONTACT_DEGREE, 0);
    gsl_test_rel(d.value, c.value, 1e-9, "%zu overlap a little", n);
    gsl_test_rel(contact_first_bin(pack, 1, 0.2), g, 1e-9, "first bin too");
    pack_free(&pack);
  }
}

/* 64 couples of centres far from one another, each at a distance uniform in the shell: the window
   that ends at the 20th of them must not count it as if it had come by chance. */
static void test_last_pair(void) {
  enum { COUPLES = 64 };
  const int TRIALS = as_many(1000, 1500);
  Box box = {3, {20, 20, 20}};
  Species species = {"A", 0.5, 2 * COUPLES};
  Rng rng = rng_stream(20, 0, RNG_TEST);
  double sum = 0, square = 0, shell = 4 * M_PI / 3 * (gsl_pow_3(1.25) - 1);
  double g = 8000 / shell * COUPLES / (COUPLES * (2 * COUPLES - 1.0));
  for (int t = 0; t < TRIALS; t++) {
    Pack *pack = pack_alloc(&box, &species, 1, false);
    for (size_t c = 0; c < COUPLES; c++) {
      double *x = pack->x + 6 * c, u[3], far = 2;
      while (far > 1 || far == 0) {
        for (int k = 0; k < 3; k++)
          u[k] = 2 * rng_uniform(&rng) - 1;
        far = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
      }
      double r = cbrt(1 + (gsl_pow_3(1.25) - 1) * rng_uniform(&rng));
      for (size_t k = 0, place = c; k < 3; k++, place /= 4) {
        x[k] = 2.5 + 5 * (double)(place % 4);
        x[3 + k] = x[k] + r * u[k] / far;
      }
    }
    double value = contact_value(pack, 1, CONTACT_DEGREE, 0.3125).value / g;
    sum += value / TRIALS;
    square += value * value / TRIALS;
    pack_free(&pack);
  }
  double error = sqrt((square - sum * sum) / TRIALS);
  gsl_test(fabs(sum - 1) > 4 * error || error > 0.03, "the last pair of the window, %.4f +- %.4f", sum, error);
}

/* Points deep in a window have the weight one: the two fits are then the same, but for the volume. */
static void test_through(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Window ball = {WINDOW_BALL, dim, {30, 30, 30}, {0}, 14, 0, 0}, inner = ball;
    Box box = {dim, {60, 60, dim == 3 ? 60 : 0}};
    Species one = {"A", 0.5, dim == 2 ? 60 : 500};
    Pack *pack = pack_alloc(&box, &one, 1, false);
    Rng rng = rng_stream(77, 0, RNG_TEST);
    inner.radius = 6;
    for (size_t i = 0, d = (size_t)dim; i < pack->n; i++) {
      bool free = false;
      while (!free) {
        window_point(&inner, 0, &rng, pack->x + i * d);
        free = true;
        for (size_t j = 0; j < i; j++) {
          double square = 0;
          for (size_t k = 0; k < d; k++)
            square += gsl_pow_2(pack->x[i * d + k] - pack->x[j * d + k]);
          free &= square > 1 - 2e-2; /* a few too near */
        }
      }
    }
    double unit = box_volume(&pack->box) / window_volume(&ball);
    Contact whole = contact_value(pack, 1, 2, 0);
    double bin = contact_first_bin(pack, 1, 0.1);
    for (EdgesHow how = EDGES_MINUS; how <= EDGES_RIPLEY; how++) {
      EdgesView view = {pack, &ball, how, -1, -1};
      Contact seen = contact_through(&view, 1, 0.25, 2, 0);
      gsl_test_rel(unit * seen.value, whole.value, 1e-10, "%d-D: the value through a window", dim);
      gsl_test_rel(unit * seen.error, whole.error, 1e-10, "%d-D: its error through a window", dim);
      gsl_test_rel(seen.window, whole.window, 1e-12, "%d-D: the window of the fit", dim);
      gsl_test_rel(unit * contact_first_through(&view, 1, 0.1), bin, 1e-10, "%d-D: the first bin through a window", dim);
    }
    pack_free(&pack);
  }
}

int main(void) {
  test_through();
  test_last_pair();
  test_bias();
  test_polynomial();
  test_error();
  test_packs(2);
  test_packs(3);
  test_same();
  test_narrow();
  test_small();
  return gsl_test_summary();
}
