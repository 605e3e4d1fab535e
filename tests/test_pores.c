/* tests/test_pores.c: exclusion probabilities against closed forms, exact against sampled ones, and pores that are hard to measure */
#include "many.h"
#include "pores.h"
#include "scatter.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

/* One disc of radius .7 in a square of side 2: the matrix beyond .7 + r, and its boundary. */
static double one_disc(double r, void *H) {
  double R = 0.7 + r, area = M_PI * R * R, length = 2 * M_PI * R;
  if (R > 1 && R < M_SQRT2) {
    double half = acos(1 / R);
    area -= 4 * (R * R * half - sqrt(R * R - 1));
    length -= 8 * R * half;
  }
  *(double *)H = R < M_SQRT2 ? length / 4 : 0;
  return R < M_SQRT2 ? 1 - area / 4 : 0;
}
static double weighted(double r, void *unused) {
  (void)unused;
  double H;
  return 2 * r * one_disc(r, &H);
}
static double plain(double r, void *unused) {
  double H;
  (void)unused;
  return one_disc(r, &H);
}

static void test_one(void) {
  Pack *pack = pack_of(2, 2, 1, 0.7, NULL);
  pack->x[0] = 1.9;
  pack->x[1] = 0.3;
  for (double r = -0.65; r < 0.9; r += 0.1037) {
    double H, want_H, E = pores_exact(pack, r, &H), want = one_disc(r, &want_H);
    gsl_test_abs(E, want, 1e-14, "one disc, E at %g", r);
    gsl_test_abs(H, want_H, 1e-13, "one disc, H at %g", r);
  }
  gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
  double mean, second, error, end = M_SQRT2 - 0.7, free_part = 1 - 0.49 * M_PI / 4, at[] = {0, 0.3, end};
  gsl_function f = {plain, NULL}, g = {weighted, NULL};
  gsl_integration_qagp(&f, at, 3, 0, 1e-10, 1000, w, &mean, &error);
  gsl_integration_qagp(&g, at, 3, 0, 1e-10, 1000, w, &second, &error);
  gsl_integration_workspace_free(w);
  PoresMoments m = pores_moments_exact(pack);
  gsl_test_rel(m.mean, mean / free_part, 1e-5, "one disc, the mean pore");
  gsl_test_rel(m.second, second / free_part, 1e-5, "one disc, the mean square");
  gsl_test(!(fabs(m.mean - mean / free_part) < m.mean_error && m.mean_error < 3e-5 * m.mean), "one disc, the error told of the mean, %g for %g",
           m.mean_error, m.mean - mean / free_part);
  gsl_test(!(fabs(m.second - second / free_part) < m.second_error && m.second_error < 1e-4 * m.second), "one disc, that of the mean square, %g for %g",
           m.second_error, m.second - second / free_part);
  Rng rng = rng_stream(311, 0, RNG_TEST);
  size_t n;
  double *x = pores_points(&pack->box, 20000, &rng, &n), *d = malloc(n * sizeof *d);
  pores_distances(pack, n, x, d);
  PoresMoments s = pores_moments(d, n);
  gsl_test_abs(s.mean, m.mean, 4 * s.mean_error, "one disc, the mean by points");
  gsl_test_abs(s.second, m.second, 4 * s.second_error, "one disc, the mean square by points");
  gsl_test(n < 20000 || n > 20600, "%zu points", n);
  free(x);
  free(d);
  pack_free(&pack);
}

/* Steiner's formula: a convex body made larger by r has the area A + P r + pi r^2; a square made smaller is a square. */
static void test_shapes(void) {
  Shape *shape[] = {shape_regular(4), shape_superellipse(50, 1), shape_superellipse(1.5, 5), shape_regular(3)};
  Rng rng = rng_stream(312, 0, RNG_TEST);
  for (int k = 0; k < 4; k++) {
    Pack *pack = pack_of(2, 18, 1, 0.9, shape[k]);
    scatter(pack, &rng);
    size_t n;
    double *x = pores_points(&pack->box, as_many(40000, 400000), &rng, &n), *d = malloc(n * sizeof *d), E[12];
    pores_distances(pack, n, x, d);
    pores_exclusion(d, n, -0.4, 0.2, 11, E);
    for (int b = 2; b < 12; b++) {
      double r = -0.4 + 0.2 * b, want = 1 - (M_PI * 0.81 + 0.9 * shape[k]->perimeter * r + M_PI * r * r) / 324;
      gsl_test_abs(E[b], want, 4 * sqrt(want * (1 - want) / (double)n), "shape %d, larger by %g", k, r);
    }
    for (int b = 0; b < 2 && k == 0; b++) {
      double edge = 0.9 * sqrt(M_PI) - 2 * (0.4 - 0.2 * b), want = 1 - edge * edge / 324;
      gsl_test_abs(E[b], want, 4 * sqrt(want * (1 - want) / (double)n), "a square, smaller by %g", 0.4 - 0.2 * b);
    }
    free(x);
    free(d);
    pack_free(&pack);
    shape_free(&shape[k]);
  }
}

/* Means over penetrable packs against the law of finite N. */
static void test_penetrable(void) {
  enum { BINS = 8 };
  for (int dim = 2; dim <= 3; dim++) {
    Rng rng = rng_stream(313, (uint64_t)dim, RNG_TEST);
    int packs = as_many(60, 1000), N = 30;
    double sum[2][BINS + 1] = {{0}}, square[2][BINS + 1] = {{0}}, side = dim == 2 ? 9 : 6;
    for (int k = 0; k < packs; k++) {
      Pack *pack = pack_of(dim, side, (size_t)N, 1, NULL);
      double E[2][BINS + 1], H, *d, *x;
      size_t n;
      scatter(pack, &rng);
      x = pores_points(&pack->box, 2000, &rng, &n);
      d = malloc(GSL_MAX(n, (size_t)N) * sizeof *d);
      pores_distances(pack, n, x, d);
      pores_exclusion(d, n, -0.6, 0.2, BINS, E[0]);
      for (int b = 0; dim == 2 && b <= BINS; b++)
        E[0][b] = pores_exact(pack, -0.6 + 0.2 * b, &H);
      pores_centres(pack, d);
      pores_exclusion(d, (size_t)N, -0.6, 0.2, BINS, E[1]);
      for (int b = 0; b < 2 * (BINS + 1); b++) {
        sum[b % 2][b / 2] += E[b % 2][b / 2];
        square[b % 2][b / 2] += E[b % 2][b / 2] * E[b % 2][b / 2];
      }
      free(x);
      free(d);
      pack_free(&pack);
    }
    for (int c = 0; c < 2; c++)
      for (int b = 0; b <= BINS; b++) {
        double r = 0.4 + 0.2 * b, v = pack_ball(dim, r) / pow(side, dim), want = gsl_pow_int(1 - v, N - c);
        double mean = sum[c][b] / packs, error = sqrt((square[c][b] / packs - mean * mean) / (packs - 1));
        gsl_test(!(fabs(mean - want) < 4 * error + 1e-4), "%d-D, %s at %.1f: %.5f(%.5f), law %.5f", dim,
                 c ? "E_P" : "E_V", r - 1, mean, error, want);
      }
  }
}

/* Discs of three sizes: by points as exactly, also where discs meet their own images. */
static void test_exact_and_points(void) {
  Species species[] = {{"A", 1.5, 3}, {"B", 0.5, 12}, {"C", 0.13, 30}};
  Rng rng = rng_stream(314, 0, RNG_TEST);
  for (int k = 0; k < 4; k++) {
    double side = k < 2 ? 9 : 3.5;
    Box box = {2, {side, 1.2 * side, 0}};
    Pack *pack = pack_alloc(&box, species + k % 2, 3 - k % 2, false);
    scatter(pack, &rng);
    size_t n;
    double *x = pores_points(&box, 30000, &rng, &n), *d = malloc(n * sizeof *d), E[13];
    pores_distances(pack, n, x, d);
    pores_exclusion(d, n, -0.2, 0.1, 12, E);
    for (int b = 0; b <= 12; b++) {
      double H, want = pores_exact(pack, -0.2 + 0.1 * b, &H);
      gsl_test_abs(E[b], want, 4 * sqrt(want * (1 - want) / (double)n) + 1e-12, "pack %d, by points at %g", k, -0.2 + 0.1 * b);
    }
    PoresMoments m = pores_moments_exact(pack), s = pores_moments(d, n);
    if (E[2] > 0)
      gsl_test_abs(s.mean, m.mean, 4 * s.mean_error, "pack %d, the mean pore", k);
    free(x);
    free(d);
    pack_free(&pack);
  }
}

static void test_hard(void) {
  Pack *none = pack_of(2, 4, 0, 1, NULL), *twins = pack_of(3, 5, 2, 1, NULL), *full = pack_of(2, 2, 1, 1.5, NULL);
  Pack *lattice = pack_of(2, 6, 9, 0.5, NULL);
  double x[] = {1, 1, 3, 3.5}, d[9], E[3], H;
  pores_distances(none, 2, x, d);
  gsl_test(d[0] != GSL_POSINF || d[1] != GSL_POSINF, "no particle is near");
  gsl_test_abs(pores_exact(none, 1, &H), 1, 0, "no particle: all is free");
  gsl_test(!gsl_isnan(pores_moments_exact(none).mean), "no particle: no mean");
  gsl_test(!gsl_isnan(pores_moments(d, 2).mean) || !gsl_isnan(pores_moments(d, 2).mean_error), "nor an error");
  gsl_test(!gsl_isnan(pores_moments_exact(full).mean), "no matrix: no mean");
  gsl_test_abs(pores_exact(full, 0, &H), 0, 1e-15, "no matrix");
  pores_centres(twins, d);
  gsl_test_abs(d[0], -1, 1e-15, "coincident spheres");
  pores_centres(full, d);
  gsl_test_abs(d[0], 0.5, 1e-15, "a disc and its image");
  for (size_t i = 0; i < 18; i++)
    lattice->x[i] = (double)(i % 2 ? i / 2 / 3 : i / 2 % 3) * 2;
  pores_centres(lattice, d);
  pores_exclusion(d, 9, 1.4, 0.1, 2, E);
  gsl_test(E[0] != 1 || E[1] != 1 || E[2] != 0, "a lattice: %g %g %g, one step at 1.5", E[0], E[1], E[2]);
  pores_exclusion(d, 0, 0, 1, 2, E);
  gsl_test_abs(E[0], 0, 0, "no values");
  pack_free(&none);
  pack_free(&twins);
  pack_free(&full);
  pack_free(&lattice);
}

int main(void) {
  test_one();
  test_shapes();
  test_penetrable();
  test_exact_and_points();
  test_hard();
  return gsl_test_summary();
}
