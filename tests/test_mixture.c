/* test_mixture.c: contact values and pressures of mixtures against numbers of
   the source and computed elsewhere, and the curves against the curve of one
   size, each other, and the structure factors. */
#include "mixture.h"
#include "py.h"
#include "ref_mixture.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>

static void near(double got, double want, double error, const char *what,
                 double phi, double r) {
  gsl_test(!(fabs(got - want) <= error),
           "%s, phi = %g, r = %.9g: %.15g, want %.15g", what, phi, r, got,
           want);
}

/* two sizes: radii 1 and lambda, fine over coarse volume xi */
static void two(MixtureSpecies s[2], double lambda, double xi, double phi) {
  const double share[] = {1, xi};
  s[0].radius = 1;
  s[1].radius = lambda;
  mixture_fill(s, 2, share, phi);
}

/* B (21) and (22) as printed, in radii */
static double printed(const MixtureSpecies s[], size_t count, size_t i,
                      size_t j) {
  double zeta2 = 0, zeta3 = 0, ai = s[i].radius, aj = s[j].radius;
  for (size_t k = 0; k < count; k++) {
    zeta2 += M_PI * 2 / 3 * s[k].density * gsl_pow_2(s[k].radius);
    zeta3 += M_PI * 4 / 3 * s[k].density * gsl_pow_3(s[k].radius);
  }
  double gii = (1 - zeta3 + 3 * ai * zeta2) / gsl_pow_2(1 - zeta3);
  double gjj = (1 - zeta3 + 3 * aj * zeta2) / gsl_pow_2(1 - zeta3);
  return (aj * gii + ai * gjj) / (ai + aj);
}

static void test_contact(void) {
  static const struct {
    double lambda, phi, g[6]; /* PY and BMCSL of 11, 12, 22 */
  } want[] = {
      {.477, .6, {9.66571, 14.22992, 7.12836, 9.03251, 5.91804, 6.95653}},
      {.313, .3, {2.85049, 3.16500, 2.10650, 2.17799, 1.87363, 1.90444}},
      {.313, .5, {6.64493, 9.04220, 4.21457, 4.75949, 3.45386, 3.68872}},
      {.313, .6, {11.20925, 17.95155, 6.65231, 8.18491, 5.22599, 5.88653}},
      {.138, .6, {16.90238, 35.34047, 5.99302, 7.07757, 4.48753, 4.83866}},
      {1 / 6.5, .6, {15.85357, 31.70405, 6.06095, 7.18810, 4.55440, 4.92956}}};
  MixtureSpecies s[3];
  for (int row = 0; row < 6; row++) {
    two(s, want[row].lambda, 0.333, want[row].phi);
    near(mixture_fraction(s, 2), want[row].phi, 1e-15, "fraction",
         want[row].phi, 0);
    for (size_t p = 0; p < 3; p++)
      for (size_t e = 0; e < 2; e++)
        near(mixture_contact((MixtureEquation)e, s, 2, p / 2, (p + 1) / 2),
             want[row].g[2 * p + e], 6e-6, "contact", want[row].phi,
             want[row].lambda);
  }
  near(s[1].density / s[0].density, 0.333 * gsl_pow_3(6.5), 1e-10, "fill", .6,
       0);
  s[0] = (MixtureSpecies){1, 0.01};
  s[1] = (MixtureSpecies){0.7, 0.05};
  s[2] = (MixtureSpecies){0.21, 0.9};
  for (size_t i = 0; i < 3; i++)
    for (size_t j = 0; j < 3; j++)
      near(mixture_contact(MIXTURE_PY, s, 3, i, j), printed(s, 3, i, j), 1e-14,
           "B (21), (22)", mixture_fraction(s, 3), 0);
  /* B (23), a foreign sphere */
  two(s, .313, 0, .5);
  near(mixture_contact(MIXTURE_PY, s, 2, 0, 1), 3.4303122620, 1e-10, "B (23)",
       .5, 0);
}

/* Z from the contact values, and one size */
static void test_pressure(void) {
  MixtureSpecies s[3] = {{1, 0.01}, {0.7, 0.05}, {0.21, 0.9}};
  double phi = mixture_fraction(s, 3), n = 0.96, step = 1e-4, P[2];
  for (size_t e = 0; e < 2; e++) {
    double Z = 1;
    for (size_t i = 0; i < 3; i++)
      for (size_t j = 0; j < 3; j++)
        Z += 2 * M_PI / 3 / n * s[i].density * s[j].density *
             gsl_pow_3(s[i].radius + s[j].radius) *
             mixture_contact((MixtureEquation)e, s, 3, i, j);
    near(mixture_pressure((MixtureEquation)e, s, 3), Z, 1e-13 * Z, "virial",
         phi, (double)e);
  }
  /* 1 / S of all, from S_ij(0), is d(n Z)/dn */
  double S[9], slope = 0;
  mixture_structure(s, 3, 0, S);
  double x = 0, inverse[9] = {0};
  for (int i = 0; i < 3; i++) { /* Cramer: the inverse of S */
    int a = (i + 1) % 3, b = (i + 2) % 3;
    for (int j = 0; j < 3; j++) {
      int c = (j + 1) % 3, d = (j + 2) % 3;
      inverse[3 * j + i] =
          S[3 * a + c] * S[3 * b + d] - S[3 * a + d] * S[3 * b + c];
    }
  }
  double det = S[0] * inverse[0] + S[1] * inverse[3] + S[2] * inverse[6];
  for (int i = 0; i < 9; i++)
    x += inverse[i] / det * sqrt(s[i / 3].density * s[i % 3].density) / n;
  for (int side = 0; side < 2; side++) {
    MixtureSpecies t[3];
    double scale = 1 + (side ? step : -step);
    for (int i = 0; i < 3; i++)
      t[i] = (MixtureSpecies){s[i].radius, s[i].density * scale};
    P[side] = scale * mixture_pressure(MIXTURE_PY_COMPRESSIBILITY, t, 3);
  }
  slope = (P[1] - P[0]) / (2 * step);
  near(x / slope, 1, 1e-6, "compressibility", phi, 0);
  for (double f = 0; f < 0.6; f += 0.11) {
    two(s, 1, 0.4, f);
    near(mixture_pressure(MIXTURE_BMCSL, s, 2),
         (1 + f + f * f - f * f * f) / gsl_pow_3(1 - f), 1e-12, "CS", f, 0);
    near(mixture_pressure(MIXTURE_PY, s, 2),
         (1 + 2 * f + 3 * f * f) / gsl_pow_2(1 - f), 1e-12, "virial", f, 0);
    near(mixture_pressure(MIXTURE_PY_COMPRESSIBILITY, s, 2),
         (1 + f + f * f) / gsl_pow_3(1 - f), 1e-12, "compressibility", f, 0);
  }
}

/* three names for one size */
static void test_one_size(void) {
  static const double phi[] = {0.05, 0.3, 0.49, 0.575, 0.6};
  for (int i = 0; i < 5; i++) {
    MixtureSpecies s[3] = {{2, 0}, {2, 0}, {2, 0}};
    const double share[] = {1, 2.5, 0};
    double S[9];
    mixture_fill(s, 3, share, phi[i]);
    Mixture *m = mixture_alloc(s, 3, 24, 0);
    Py *py = py_alloc(phi[i]);
    for (double r = 4; r < 24; r += 0.0913)
      for (size_t p = 0; p < 9; p++)
        near(mixture_g(m, p / 3, p % 3, r), py_g(py, r / 2), 1e-11, "one size",
             phi[i], r);
    near(mixture_mean(m, 0, 1, 3.1, 4.3),
         py_mean(py, 2, 2.15) * (gsl_pow_3(4.3) - 64) /
             (gsl_pow_3(4.3) - gsl_pow_3(3.1)),
         1e-10, "mean with core", phi[i], 0);
    near(mixture_mean(m, 1, 2, 7.42, 8.68), py_mean(py, 3.71, 4.34), 1e-10,
         "mean", phi[i], 0);
    for (double k = 0; k < 9; k += 0.7) {
      mixture_structure(s, 3, k / 2, S);
      near(S[0] / 3.5 + S[4] * 2.5 / 3.5 + 2 * S[1] * sqrt(2.5) / 3.5,
           py_structure(phi[i], k), 1e-13, "S of one size", phi[i], k);
      near(S[8], 1, 0, "S of none", phi[i], k);
    }
    py_free(&py);
    mixture_free(&m);
    gsl_test(m != NULL, "mixture_free nulls the pointer");
  }
}

/* core, contact, symmetry, and the grid of half the step */
static void check_curves(const MixtureSpecies s[], size_t count, double reach,
                         size_t fineness, double error) {
  double phi = mixture_fraction(s, count);
  Mixture *m = mixture_alloc(s, count, reach, fineness);
  for (size_t i = 0; i < count; i++)
    for (size_t j = 0; j < count; j++) {
      double R = s[i].radius + s[j].radius;
      near(mixture_g(m, i, j, R * (1 - 1e-15)), 0, 0, "core", phi, R);
      near(mixture_g(m, i, j, R), mixture_contact(MIXTURE_PY, s, count, i, j),
           error, "contact of the curve", phi, R);
      for (double r = R; j < i && r < reach; r += (reach - R) / 2003)
        near(mixture_g(m, i, j, r), mixture_g(m, j, i, r), error, "symmetry",
             phi, r);
    }
  mixture_free(&m);
}

static void check_grid(const MixtureSpecies s[], size_t count, double reach,
                       double error) {
  double phi = mixture_fraction(s, count);
  Mixture *m = mixture_alloc(s, count, reach, 0);
  Mixture *finer = mixture_alloc(s, count, reach, 7);
  for (size_t i = 0; i < count; i++)
    for (size_t j = 0; j < count; j++)
      for (double r = s[i].radius + s[j].radius; r < reach; r += 0.00731)
        near(mixture_g(m, i, j, r), mixture_g(finer, i, j, r), error,
             "finer grid", phi, r);
  mixture_free(&m);
  mixture_free(&finer);
}

/* The march by trapezoids, on two grids: what is left of their error of second
   order when it is taken out is of fourth. */
static void check_trapezoids(const MixtureSpecies s[], size_t count,
                             double error) {
  const double reach = 6, h = 2 * s[count - 1].radius / 32;
  size_t n = ref_mixture_n(s, count, reach, 32);
  double *wide = ref_mixture(s, count, reach, 32),
         *thin = ref_mixture(s, count, reach, 64);
  Mixture *m = mixture_alloc(s, count, reach, 0);
  for (size_t p = 1; p < n; p++)
    for (size_t i = 0; i < count; i++)
      for (size_t j = 0; j < count; j++) {
        double r = s[i].radius + s[j].radius + h * (double)p;
        double a = wide[(p * count + i) * count + j],
               b = thin[(2 * p * count + i) * count + j];
        if (r < reach)
          near(mixture_g(m, i, j, r), (4 * b - a) / (3 * r), error,
               "trapezoids", mixture_fraction(s, count), r);
      }
  mixture_free(&m);
  free(wide);
  free(thin);
}

static void test_trapezoids(void) {
  MixtureSpecies s[3] = {{1, 0}, {0.75, 0}, {0.25, 0}};
  const double share[] = {2, 1, 1};
  two(s, .5, .333, .5);
  check_trapezoids(s, 2, 5e-6);
  s[1].radius = 0.75;
  mixture_fill(s, 3, share, .5);
  check_trapezoids(s, 3, 5e-6);
}

static void test_curves(void) {
  MixtureSpecies s[5];
  two(s, .313, .333, .6);
  check_curves(s, 2, 8, 0, 1e-11);
  check_grid(s, 2, 8, 1e-11);
  two(s, .138, .333, .6);
  check_curves(s, 2, 6, 0, 1e-11);
  check_grid(s, 2, 4, 1e-11);
  two(s, 0.9, 2, .55);
  check_curves(s, 2, 12, 0, 1e-11);
  two(s, .313, 0, .5); /* none of the small */
  check_curves(s, 2, 8, 0, 1e-11);
  two(s, .0313, 1e9, .4); /* nearly none of the large */
  check_curves(s, 2, 2.2, 0, 1e-11);
  for (int i = 0; i < 5; i++)
    s[i] = (MixtureSpecies){1 - 0.17 * i, i == 3 ? 0 : 0.03 + 0.01 * i};
  check_curves(s, 5, 6, 0, 1e-11);
}

/* beyond the first kink of the large species, at ratio 100 */
static void test_ratio(void) {
  MixtureSpecies s[2];
  two(s, 0.01, 0.2, .5);
  check_curves(s, 2, 2.1, 0, 1e-11);
  two(s, 0.02, 1e4, .6); /* large contact values: relative to them */
  check_grid(s, 2, 2.2, 1e-8);
}

/* the first order in density is a lens of two spheres: the volume in which
   the centre of a third excludes neither */
static double lens(double A, double B, double r) {
  if (r >= A + B)
    return 0;
  if (r <= fabs(A - B))
    return 4 * M_PI / 3 * gsl_pow_3(fmin(A, B));
  return M_PI * gsl_pow_2(A + B - r) *
         (r * r + 2 * r * (A + B) - 3 * gsl_pow_2(A - B)) / (12 * r);
}

static void test_dilute(void) {
  MixtureSpecies s[3] = {{1, 1e-6}, {0.4, 3e-6}, {0.15, 2e-6}};
  Mixture *m = mixture_alloc(s, 3, 4.5, 0);
  for (size_t p = 0; p < 9; p++)
    for (double r = s[p / 3].radius + s[p % 3].radius; r < 4.5; r += 0.0371) {
      double sum = 0;
      for (size_t k = 0; k < 3; k++)
        sum += s[k].density * lens(s[p / 3].radius + s[k].radius,
                                   s[p % 3].radius + s[k].radius, r);
      near(mixture_g(m, p / 3, p % 3, r), 1 + sum, 1e-9, "dilute",
           mixture_fraction(s, 3), r);
      near((mixture_g(m, p / 3, p % 3, r) - 1) / 1e-5, sum / 1e-5, 1e-4,
           "first order", mixture_fraction(s, 3), r);
    }
  mixture_free(&m);
  for (int k = 0; k < 3; k++)
    s[k].density = 0;
  m = mixture_alloc(s, 3, 4.5, 0);
  for (double r = 2; r < 4.5; r += 0.1)
    near(mixture_g(m, 0, 0, r), 1, 1e-14, "no spheres", 0, r);
  near(mixture_pressure(MIXTURE_BMCSL, s, 3), 1, 0, "no spheres", 0, 0);
  mixture_free(&m);
}

/* the curves, transformed, are the structure factors; k = 0 is the sum rule */
typedef struct {
  const Mixture *m;
  size_t i, j;
  double k;
} Wave;

static double tail(double r, void *data) {
  const Wave *w = data;
  double h = mixture_g(w->m, w->i, w->j, r) - 1;
  return 4 * M_PI * h * r * (w->k > 0 ? sin(w->k * r) / w->k : r);
}

/* steps of which both diameters are multiples: no kink inside one */
static double transform(Wave *w, double R, double reach) {
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(20);
  gsl_function f = {tail, w};
  double k = w->k, sum = -4 * M_PI / 3 * R * R * R;
  if (k > 0)
    sum = -4 * M_PI * (sin(k * R) - k * R * cos(k * R)) / gsl_pow_3(k);
  for (double r = R; r < reach - 0.05; r += 0.05)
    sum += gsl_integration_glfixed(&f, r, fmin(r + 0.05, reach), rule);
  gsl_integration_glfixed_table_free(rule);
  return sum;
}

static void check_structure(double lambda, double xi, double phi, double reach,
                            double error) {
  static const double wave[] = {0, 0.9, 3.3, 7.1};
  MixtureSpecies s[2];
  two(s, lambda, xi, phi);
  Mixture *m = mixture_alloc(s, 2, reach, 0);
  for (int q = 0; q < 4; q++) {
    double S[4];
    mixture_structure(s, 2, wave[q], S);
    for (size_t p = 0; p < 4; p++) {
      Wave w = {m, p / 2, p % 2, wave[q]};
      double R = s[w.i].radius + s[w.j].radius;
      double n = sqrt(s[w.i].density * s[w.j].density);
      near((w.i == w.j) + n * transform(&w, R, reach), S[p], error, "S_ij", phi,
           wave[q]);
    }
  }
  mixture_free(&m);
}

static void test_structure(void) {
  check_structure(0.45, 0.5, 0.25, 30, 1e-9);
  check_structure(0.3, 0.333, 0.5, 80, 1e-9);
}

/* where the least value passes zero */
static void test_least(void) {
  MixtureSpecies s[3];
  two(s, 1, 0.6, .3);
  near(mixture_limit(s, 2), py_limit(), 2e-8, "limit of one size", .3, 0);
  two(s, .313, .333, .5);
  s[2] = (MixtureSpecies){2, 0}; /* absent: not asked */
  double limit = mixture_limit(s, 2);
  near(mixture_limit(s, 3), limit, 2e-9, "limit beside none", limit, 0);
  for (int side = -1; side <= 1; side += 2) {
    two(s, .313, .333, limit + 1e-6 * side);
    Mixture *m = mixture_alloc(s, 2, 6, 0);
    gsl_test(!(side * mixture_least(m).g < 0), "least at %.9f: %g",
             limit + 1e-6 * side, mixture_least(m).g);
    mixture_free(&m);
  }
  two(s, .313, .333, .6);
  Mixture *m = mixture_alloc(s, 2, 6, 0);
  MixtureLeast least = mixture_least(m);
  double scan = 1;
  for (size_t p = 0; p < 4; p++)
    for (double r = s[p / 2].radius + s[p % 2].radius; r < 6; r += 1e-4)
      scan = fmin(scan, mixture_g(m, p / 2, p % 2, r));
  near(least.g, scan, 1e-6, "least", .6, least.r);
  gsl_test(!(least.g <= scan), "least below the scan: %.9g, %.9g", least.g,
           scan);
  gsl_test(!(scan < -0.1), "impossible at 0.6: %g", scan);
  mixture_free(&m);
  two(s, .313, .333, 0);
  m = mixture_alloc(s, 2, 6, 0);
  near(mixture_least(m).g, 1, 0, "least of none", 0, 0);
  mixture_free(&m);
}

int main(void) {
  test_least();
  test_contact();
  test_pressure();
  test_one_size();
  test_curves();
  test_trapezoids();
  test_ratio();
  test_dilute();
  test_structure();
  return gsl_test_summary();
}
