/* tests/test_surface.c: points on surfaces, what is hidden, and surface functions against closed forms */
#include "cover.h"
#include "distance.h"
#include "many.h"
#include "surface.h"
#include "scatter.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

/* The mean of x^2 along the boundary, from many chords. */
static double mean_square(const Shape *shape) {
  enum { N = 40000 };
  double sum = 0, length = 0;
  ShapeNode *node = shape->sides ? NULL : malloc(N * sizeof *node);
  int n = node ? N : shape->sides;
  if (node)
    shape_nodes(shape, N, node);
  for (int i = 0; i < n; i++) {
    int j = (i + 1) % n;
    double x = node ? node[i].x : shape->x[i], y = node ? node[i].y : shape->y[i];
    double X = node ? node[j].x : shape->x[j], Y = node ? node[j].y : shape->y[j];
    double l = hypot(X - x, Y - y);
    length += l;
    sum += l * (x * x + x * X + X * X) / 3;
  }
  free(node);
  return sum / length;
}

static void test_boundaries(void) {
  Shape *shape[] = {shape_regular(3), shape_superellipse(50, 1), shape_superellipse(1.5, 0.7), shape_superellipse(2, 20)};
  Rng rng = rng_stream(321, 0, RNG_TEST);
  for (int s = 0; s < 4; s++) {
    Pack *pack = pack_of(2, 40, 1, 1.3, shape[s]);
    pack->x[0] = pack->x[1] = 20;
    double far = 0, sum = 0, square = 0, trials = as_many(4000, 40000);
    Surface *surface = surface_points(pack, trials, &rng);
    Body body = pack_body(pack, 0);
    for (size_t i = 0; i < surface->n; i++) {
      double x = (surface->x[2 * i] - 20) / 1.3;
      far = GSL_MAX(far, fabs(distance_body(&body, surface->x[2 * i], surface->x[2 * i + 1])));
      sum += x * x;
      square += gsl_pow_4(x);
    }
    double n = (double)surface->n, mean = sum / n, want = mean_square(shape[s]);
    gsl_test(n != trials, "shape %d: all points are exposed", s);
    gsl_test(!(far < 1e-12), "shape %d: points are on the boundary, off by %.2g", s, far);
    gsl_test_abs(mean, want, 4 * sqrt((square / n - mean * mean) / n), "shape %d: points are uniform along it", s);
    gsl_test_rel(surface->weight * trials, 1.3 * shape[s]->perimeter, 1e-13, "shape %d: the weight", s);
    surface_free(&surface);
    pack_free(&pack);
    shape_free(&shape[s]);
  }
}

/* At an end of an axis, s = 0, as near it, for exponents from a rhombus, whose power of s is nearly 0, to a rectangle. */
static void test_ends(void) {
  static const double m[] = {0.5 + 1e-11, 0.51, 1, 1.5, 50};
  for (size_t k = 0; k < sizeof m / sizeof *m; k++) {
    Shape *shape = shape_superellipse(1.7, m[k]);
    double at[2], near[2], along, beside;
    shape_slope(shape, 0, shape->b, at);
    shape_slope(shape, 1e-300, shape->b, near);
    along = hypot(at[0], at[1]);
    beside = at[1] / along;
    gsl_test(!(along > 0 && gsl_finite(along) && beside > 0.3), "m = %g: a normal at the end of an axis: %g %g, %g %g beside it", m[k], at[0], at[1], near[0],
             near[1]);
    shape_free(&shape);
  }
}

static double exposed(const Pack *pack, double trials, Rng *rng) {
  Surface *surface = surface_points(pack, trials, rng);
  double all = surface->weight * (double)surface->n;
  surface_free(&surface);
  return all;
}

static void test_hidden(void) {
  Rng rng = rng_stream(322, 0, RNG_TEST);
  Shape *four = shape_regular(4), *curve = shape_superellipse(3, 2);
  double edge = sqrt(M_PI);
  Pack *twins[] = {pack_of(2, 9, 2, 1, NULL), pack_of(2, 9, 2, 1, four), pack_of(2, 9, 2, 1, curve), pack_of(3, 9, 2, 1, NULL)};
  for (int k = 0; k < 4; k++) {
    for (size_t i = 0; i < twins[k]->n * (size_t)twins[k]->box.dim; i++)
      twins[k]->x[i] = i % (size_t)twins[k]->box.dim ? 8.7 : 0.1;
    gsl_test_rel(exposed(twins[k], 2000, &rng), 0.5 * surface_total(twins[k]), 1e-12, "coincident particles %d: one surface", k);
    pack_free(&twins[k]);
  }
  Pack *pair = pack_of(2, 20, 2, 1, four);
  double inside = 0;
  pair->angle[0] = pair->angle[1] = M_PI / 4;
  pair->x[0] = pair->x[1] = pair->x[3] = 10;
  pair->x[2] = 10 + edge;
  gsl_test_abs(exposed(pair, 20000, &rng), 6 * edge, 4 * 8 * edge * sqrt(0.25 * 0.75 / 20000), "two squares side by side: not the common edge");
  Surface *surface = surface_points(pair, 2000, &rng);
  for (size_t i = 0; i < surface->n; i++)
    inside += fabs(surface->x[2 * i] - 10 - edge / 2) < 1e-9;
  gsl_test_abs(inside, 0, 0, "no point on the common edge");
  surface_free(&surface);
  pack_free(&pair);
  /* The exposed perimeter of a pack that overlaps, exactly. */
  Species species[] = {{"A", 1, 20, four}, {"B", 0.8, 30, curve}, {"C", 0.3, 40, NULL}};
  Box box = {2, {12, 11, 0}};
  Pack *mixed = pack_alloc(&box, species, 3, false);
  scatter(mixed, &rng);
  Body *bodies = cover_bodies(mixed);
  double length, trials = as_many(20000, 200000), total = surface_total(mixed);
  cover_area(bodies, mixed->n, &box, &length);
  double part = length / total;
  gsl_test_abs(exposed(mixed, trials, &rng), length, 4 * total * sqrt(part * (1 - part) / trials), "as the exact perimeter");
  gsl_test_abs(surface_trials(mixed, 5000, &rng), 5000 / part, 4 * 5000 / part * sqrt((1 - part) / part / 1000), "trials for so many points");
  free(bodies);
  pack_free(&mixed);
  shape_free(&four);
  shape_free(&curve);
}

/* ------------------------------------------------------------ closed forms */
typedef struct {
  int dim, N;
  double V;
} Law;
static double outside(int dim, double r) {
  return r >= 2 ? 1 : dim == 2 ? 1 - acos(r / 2) / M_PI : 0.5 + r / 4;
}
static double own(int dim, double r) {
  return r >= 2 ? 0 : dim == 2 ? 1 / (M_PI * r * sqrt(1 - r * r / 4)) : 1 / (2 * r);
}
static double both(int dim, double r) {
  double h = r / 2, shared = r >= 2 ? 0 : dim == 2 ? 2 * (acos(h) - h * sqrt(1 - h * h)) : 4 * M_PI / 3 * (1 - h) * (1 - h) * (1 + h / 2);
  return 2 * pack_ball(dim, 1) - shared;
}
static double law_sv(const Law *l, double r) {
  double s1 = l->dim == 2 ? 2 * M_PI : 4 * M_PI;
  return l->N * s1 / l->V * outside(l->dim, r) * pow(1 - both(l->dim, r) / l->V, l->N - 1);
}
/* F_ss times r^(dim - 1); the variable t with r = 2 - t^2 takes away the pole at 2 in the plane. */
static double law_ss(double r, void *params) {
  const Law *l = params;
  double s1 = l->dim == 2 ? 2 * M_PI : 4 * M_PI, left = 1 - both(l->dim, r) / l->V, p = outside(l->dim, r);
  double pairs = l->N > 1 ? l->N * (l->N - 1) * gsl_pow_2(s1 * p / l->V) * pow(left, l->N - 2) : 0;
  return (pairs + l->N * s1 / l->V * own(l->dim, r) * pow(left, l->N - 1)) * gsl_pow_int(r, l->dim - 1);
}
static double bent_ss(double t, void *params) {
  return law_ss(2 - t * t, params) * 2 * t;
}
static double mean_ss(const Law *law, double from, double to) {
  gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
  gsl_function f = {law_ss, (void *)law}, g = {bent_ss, (void *)law};
  double value, error;
  if (to <= 2)
    gsl_integration_qag(&g, sqrt(2 - to), sqrt(2 - from), 0, 1e-8, 1000, 3, w, &value, &error);
  else
    gsl_integration_qag(&f, from, to, 0, 1e-8, 1000, 3, w, &value, &error);
  gsl_integration_workspace_free(w);
  return law->dim * value / (gsl_pow_int(to, law->dim) - gsl_pow_int(from, law->dim));
}

/* One particle or many that may overlap; means over packs, tolerances from their spread. */
static void test_laws(void) {
  enum { BINS = 8 };
  for (int c = 0; c < 4; c++) {
    Law law = {2 + c / 2, c % 2 ? 20 : 1, 0};
    double side = law.dim == 2 ? 10 : 7, step = 0.5, r[BINS], sum[2][BINS] = {{0}}, square[2][BINS] = {{0}};
    int packs = as_many(40, 1500);
    Rng rng = rng_stream(323, (uint64_t)c, RNG_TEST);
    law.V = pow(side, law.dim);
    for (int b = 0; b < BINS; b++)
      r[b] = step * (b + 1);
    for (int k = 0; k < packs; k++) {
      Pack *pack = pack_of(law.dim, side, (size_t)law.N, 1, NULL);
      double F[2][BINS];
      scatter(pack, &rng);
      Surface *A = surface_points(pack, 300, &rng), *B = surface_points(pack, 350, &rng);
      surface_void(pack, A, BINS, r, &rng, F[0]);
      surface_pairs(&pack->box, A, B, step, BINS, F[1]);
      for (int b = 0; b < 2 * BINS; b++) {
        sum[b % 2][b / 2] += F[b % 2][b / 2];
        square[b % 2][b / 2] += gsl_pow_2(F[b % 2][b / 2]);
      }
      surface_free(&A);
      surface_free(&B);
      pack_free(&pack);
    }
    for (int f = 0; f < 2; f++)
      for (int b = 0; b < BINS; b++) {
        double want = f ? mean_ss(&law, b * step, r[b]) : law_sv(&law, r[b]), mean = sum[f][b] / packs;
        double error = sqrt(GSL_MAX(square[f][b] / packs - mean * mean, 0) / (packs - 1));
        gsl_test(!(fabs(mean - want) <= 4 * error + 1e-12), "%d-D, %d particles, %s at %g: %.5f(%.5f), law %.5f", law.dim, law.N,
                 f ? "F_ss" : "F_sv", r[b], mean, error, want);
      }
  }
}

/* Half of all directions lead into the matrix, for either sign one. */
static void test_limit(void) {
  Pack *pack = pack_of(2, 10, 1, 1, NULL);
  Rng rng = rng_stream(324, 0, RNG_TEST);
  Surface *surface = surface_points(pack, 1000, &rng);
  double r[] = {1e-6}, F[1];
  surface_void(pack, surface, 1, r, &rng, F);
  gsl_test_rel(F[0], M_PI / 100, 1e-12, "F_sv near the surface is s / 2");
  surface_free(&surface);
  pack_free(&pack);
}

/* A disc of radius 1 in a box of side 2.4 and its images, by angles. */
static void test_images(void) {
  enum { BINS = 6, M = 400 };
  double want[BINS] = {0}, step = 0.7, L = 2.4, sum[BINS] = {0}, square[BINS] = {0};
  for (int i = 0; i < M; i++)
    for (int j = 0; j < M; j++) {
      double s = 2 * M_PI * (i + 0.25) / M, t = 2 * M_PI * (j + 0.5113) / M;
      for (int a = -2; a <= 2; a++)
        for (int b = -2; b <= 2; b++) {
          double d = hypot(cos(s) - cos(t) + a * L, sin(s) - sin(t) + b * L);
          if (d < BINS * step)
            want[(int)(d / step)] += gsl_pow_2(2 * M_PI / M) / (L * L);
        }
    }
  Pack *pack = pack_of(2, L, 1, 1, NULL);
  Rng rng = rng_stream(325, 0, RNG_TEST);
  int sets = as_many(30, 300);
  for (int k = 0; k < sets; k++) {
    double F[BINS];
    Surface *A = surface_points(pack, 120, &rng), *B = surface_points(pack, 120, &rng);
    surface_pairs(&pack->box, A, B, step, BINS, F);
    for (int b = 0; b < BINS; b++) {
      sum[b] += F[b];
      square[b] += F[b] * F[b];
    }
    surface_free(&A);
    surface_free(&B);
  }
  for (int b = 0; b < BINS; b++) {
    double shell = M_PI * step * step * (2 * b + 1), mean = sum[b] / sets;
    double error = sqrt((square[b] / sets - mean * mean) / (sets - 1));
    gsl_test_abs(mean, want[b] / shell, 4 * error + 0.003 * want[b] / shell, "images in a narrow box, bin %d", b);
  }
  pack_free(&pack);
}

static void test_none(void) {
  Pack *none = pack_of(3, 4, 0, 1, NULL), *full = pack_of(2, 2, 1, 1.5, NULL);
  Rng rng = rng_stream(326, 0, RNG_TEST);
  double r[] = {1}, F[2] = {1, 1};
  Surface *surface = surface_points(none, 100, &rng);
  surface_void(none, surface, 1, r, &rng, F);
  gsl_test(surface->n != 0 || F[0] != 0, "no particle, no surface");
  surface_pairs(&none->box, surface, surface, 1, 2, F);
  gsl_test(F[0] != 0 || F[1] != 0, "and no pairs");
  surface_free(&surface);
  surface = surface_points(full, 100, &rng);
  gsl_test(surface->n != 0, "no matrix, no surface");
  gsl_test_abs(surface_trials(full, 50, &rng), 5000, 0, "at most a hundred times the points");
  surface_free(&surface);
  pack_free(&none);
  pack_free(&full);
}

int main(void) {
  test_boundaries();
  test_ends();
  test_hidden();
  test_laws();
  test_limit();
  test_images();
  test_none();
  return gsl_test_summary();
}
