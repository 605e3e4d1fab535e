/* tests/test_structure.c: sums by a slow program, lattices, points, form factors in closed form */
#include "many.h"
#include "points.h"
#include "py.h"
#include "structure.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const Box slab = {3, {5.3, 4.1, 7.7}}, sheet = {2, {5.3, 4.1, 0}};

static Pack *points(const Box *box, int kinds, size_t n, bool own, uint64_t seed) {
  Species species[3] = {{.name = "A", .radius = 0.31, .count = n}, {.name = "B", .radius = 0.83, .count = n / 2 + 3},
                        {.name = "C", .radius = 0.57, .count = 0}};
  Pack *pack = pack_alloc(box, species, kinds, own);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  points_scatter(pack, &rng);
  return pack;
}

static double square(const double *rho) { return rho[0] * rho[0] + rho[1] * rho[1]; }

/* Each pair k, -k once, and all of them. */
static void test_waves(const Box *box, double reach) {
  Waves *w = structure_waves(box, reach, 0.1, 0);
  size_t all = 0;
  int bad = 0, end[3] = {0};
  for (int d = 0; d < box->dim; d++)
    end[d] = (int)(reach * box->side[d] / 6.28) + 2;
  for (int a = -end[0]; a <= end[0]; a++)
    for (int b = -end[1]; b <= end[1]; b++)
      for (int c = -end[2]; c <= end[2]; c++) {
        const int m[3] = {a, b, c};
        double k = 0;
        for (int d = 0; d < box->dim; d++)
          k = hypot(k, 2 * M_PI * m[d] / box->side[d]);
        all += k > 0 && k < reach;
      }
  gsl_test_int((int)(2 * w->n), (int)all, "vectors in %d dimensions", box->dim);
  for (size_t r = 0; r < w->rungs; r++) {
    double k = 0;
    for (int d = 0; d < box->dim; d++)
      k = hypot(k, 2 * M_PI * w->rung[r].m[d] / box->side[d]);
    bad += fabs(k - w->k[w->rung[r].at]) > 1e-13 * reach;
    bad += w->rung[r].both && w->k[w->rung[r].at + 1] != w->k[w->rung[r].at];
    for (size_t q = 0; q < r; q++) {
      bool same = true, opposite = true;
      for (int d = 0; d < box->dim; d++) {
        int x = w->rung[r].m[d], y = w->rung[q].m[d];
        same &= x == y;
        opposite &= x == (d == box->dim - 1 && w->rung[q].both ? y : -y);
      }
      bad += same || opposite;
    }
  }
  gsl_test_int(bad, 0, "none twice, of the right length");
  gsl_test_abs((double)w->n / structure_count(box, reach), 1, 0.1, "and about as many as counted");
  structure_waves_free(&w);
  gsl_test(w != NULL, "freed");
}

/* The sums by the definition, in long double. */
static void test_plain(const Box *box, int kinds, size_t n, double reach) {
  Pack *pack = points(box, kinds, n, false, 5);
  Waves *w = structure_waves(box, reach, 0.1, 0);
  double *rho = structure_amplitudes(pack, w), worst = 0;
  int dim = box->dim;
  for (size_t r = 0; r < w->rungs; r++)
    for (int back = 0; back <= w->rung[r].both; back++)
      for (int s = 0; s < kinds; s++) {
        long double re = 0, im = 0;
        for (size_t i = 0; i < pack->n; i++) {
          long double phase = 0;
          for (int d = 0; d < dim; d++)
            phase += (d == dim - 1 && back ? -1.L : 1.L) * w->rung[r].m[d] * pack->x[i * (size_t)dim + (size_t)d] /
                     box->side[d];
          re += pack_kind(pack, i) == s ? cosl(2 * 3.14159265358979323846264338327950288L * phase) : 0;
          im += pack_kind(pack, i) == s ? sinl(2 * 3.14159265358979323846264338327950288L * phase) : 0;
        }
        const double *out = rho + 2 * (w->n * (size_t)s + w->rung[r].at + (size_t)back);
        worst = GSL_MAX(worst, fabs((double)(out[0] - re)) + fabs((double)(out[1] - im)));
      }
  gsl_test(!(worst < 3e-15 * w->most[0] * sqrt((double)pack->n) + 1e-13), "sums by the definition, %d species of %zu in %d: %g",
           kinds, n, dim, worst);
  free(rho);
  structure_waves_free(&w);
  pack_free(&pack);
}

static void test_by_hand(void) {
  static const double x[] = {0, 0, 1.25, 0, 1.25, 1.5};
  Species species = {.name = "A", .radius = 0.1, .count = 2};
  Box box = {2, {5, 6, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  Waves *w = structure_waves(&box, 14, 0.1, 0);
  memcpy(pack->x, x, 4 * sizeof *x);
  double *rho = structure_amplitudes(pack, w);
  static const double of[] = {2, 1, 0, 1};
  int bad = 0;
  for (size_t r = 0; r < w->rungs; r++)
    for (size_t back = 0; back <= w->rung[r].both; back++)
      bad += fabs(square(rho + 2 * (w->rung[r].at + back)) / 2 - of[w->rung[r].m[0] % 4]) > 1e-12;
  gsl_test_int(bad, 0, "two particles a quarter of the side apart");
  free(rho);
  memcpy(pack->x, x + 2, 4 * sizeof *x);
  memcpy(pack->x, x, 2 * sizeof *x);
  pack->x[2] = x[4], pack->x[3] = x[5];
  rho = structure_amplitudes(pack, w);
  for (size_t r = 0; r < w->rungs; r++)
    for (int back = 0; back <= w->rung[r].both; back++) {
      int sum = w->rung[r].m[0] + (back ? -1 : 1) * w->rung[r].m[1];
      bad += fabs(square(rho + 2 * (w->rung[r].at + (size_t)back)) / 2 - of[(sum % 4 + 4) % 4]) > 1e-12;
    }
  gsl_test_int(bad, 0, "a pair on a diagonal");
  free(rho);
  structure_waves_free(&w);
  pack_free(&pack);
}

/* One particle; particles at one place; none. */
static void test_few(void) {
  for (size_t n = 0; n < 5; n++) {
    Species species = {.name = "A", .radius = 0.1, .count = n};
    Pack *pack = pack_alloc(&slab, &species, 1, false);
    for (size_t i = 0; i < 3 * n; i++)
      pack->x[i] = 1.37 + 0.71 * (double)(i % 3);
    Waves *w = structure_waves(&slab, 9, 0.1, 0);
    double *rho = structure_amplitudes(pack, w), worst = 0;
    for (size_t v = 0; v < w->n; v++)
      worst = GSL_MAX(worst, fabs(square(rho + 2 * v) - (double)(n * n)));
    gsl_test(!(worst < 1e-12), "%zu particles at one place: N^2", n);
    free(rho);
    structure_waves_free(&w);
    pack_free(&pack);
  }
}

/* A simple cubic lattice: N where all m are multiples of its cells, else nothing. */
static void test_lattice(void) {
  enum { M = 5 };
  Species species = {.name = "A", .radius = 0.5, .count = M * M * M};
  Box box = {3, {M, M, M}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int i = 0; i < M * M * M; i++) {
    pack->x[3 * i] = 0.3 + i / (M * M);
    pack->x[3 * i + 1] = 0.1 + i / M % M;
    pack->x[3 * i + 2] = 0.7 + i % M;
  }
  Waves *w = structure_waves(&box, 14, 0.1, 0);
  double *rho = structure_amplitudes(pack, w);
  int bad = 0, peaks = 0;
  for (size_t r = 0; r < w->rungs; r++)
    for (size_t back = 0; back <= w->rung[r].both; back++) {
      const int *m = w->rung[r].m;
      bool peak = m[0] % M == 0 && m[1] % M == 0 && m[2] % M == 0;
      double S = square(rho + 2 * (w->rung[r].at + back)) / pack->n;
      bad += fabs(S - (peak ? (double)pack->n : 0)) > 1e-10;
      peaks += peak;
    }
  gsl_test_int(bad, 0, "Bragg peaks of a simple cubic lattice");
  gsl_test_int(peaks, 16, "as many as points within 14 a / 2 pi"); /* 6 + 12 + 8 + 6, a half */
  free(rho);
  structure_waves_free(&w);
  pack_free(&pack);
}

/* Uniform points: mean 1 and variance 1 - 1/N of each vector. */
static void test_points(void) {
  enum { N = 6 };
  int packs = as_many(4000, 40000);
  Waves *w = structure_waves(&sheet, 3, 0.1, 0);
  double mean = 0, second = 0, fourth = 0, number = 0;
  for (int k = 0; k < packs; k++) {
    Pack *pack = points(&sheet, 1, N, false, 100 + (uint64_t)k);
    double *rho = structure_amplitudes(pack, w);
    double S = square(rho + 2 * ((size_t)k % w->n)) / N;
    mean += S, second += S * S, fourth += S * S * S * S, number++;
    free(rho);
    pack_free(&pack);
  }
  mean /= number, second /= number, fourth /= number;
  double variance = second - mean * mean;
  gsl_test_abs(mean, 1, 4 * sqrt((1 - 1. / N) / number), "points: mean, to 4 errors");
  gsl_test_abs(variance, 1 - 1. / N, 4 * sqrt((fourth - second * second) / number), "points: variance, to 4 errors");
  structure_waves_free(&w);
}

/* A part of the vectors: about as many, and the mean of all within the error. */
static void test_choice(void) {
  Pack *pack = points(&slab, 1, 40, false, 9);
  double reach = 12, step = 0.5, mean[2][24], error[2][24], number[24] = {0}, far = 0;
  int few = 0;
  for (int all = 0; all < 2; all++) {
    Waves *w = structure_waves(&slab, reach, step, all ? 0 : 100);
    double *rho = structure_amplitudes(pack, w), *S = calloc(w->n, sizeof *S);
    for (size_t v = 0; v < w->n; v++) {
      S[v] = square(rho + 2 * v) / (double)pack->n;
      number[(int)(w->k[v] / step)] += !all;
    }
    structure_bins(w, S, step, 24, mean[all], error[all]);
    free(S);
    free(rho);
    structure_waves_free(&w);
  }
  for (int b = 12; b < 24; b++) {
    few += !(fabs(number[b] - 100) < 40);
    far += (mean[0][b] - mean[1][b]) / error[0][b];
  }
  gsl_test_int(few, 0, "about 100 of each bin");
  gsl_test_abs(far / sqrt(12), 0, 3, "their mean is that of all, to 3 errors");
  pack_free(&pack);
}

static void test_bins(void) {
  double k[] = {0.1, 0.4, 0.45, 1.2, 1.3, 1.35}, value[] = {2, 5, 9, 1, 4, 2.5}, mean[4], error[4];
  Waves w = {.dim = 3, .n = 6, .k = k};
  structure_bins(&w, value, 0.35, 4, mean, error);
  gsl_test_rel(mean[0], 2, 1e-15, "a bin of one vector");
  gsl_test(!isnan(error[0]), "has no error");
  gsl_test_rel(mean[1], 7, 1e-15, "of two");
  gsl_test_rel(error[1], 2, 1e-15, "half their difference");
  gsl_test(!isnan(mean[2]), "an empty bin");
  gsl_test_rel(mean[3], 2.5, 1e-15, "of three");
  gsl_test_rel(error[3], sqrt(4.5 / 6), 1e-15, "and its error");
}

/* A parabola is found; noise by as much as the fit gives the error that is told. */
static void test_zero(void) {
  Box box = {3, {20, 22, 25}};
  Waves *w = structure_waves(&box, 3, 0.1, 0);
  double *S = calloc(w->n, sizeof *S), error, sum = 0, squares = 0, told = 0;
  for (size_t v = 0; v < w->n; v++) {
    double x = w->k[v] * w->k[v];
    S[v] = w->k[v] < 1.1 ? 0.237 - 0.11 * x + 0.31 * x * x : 99;
  }
  gsl_test_rel(structure_zero(w, S, 1.1, &error), 0.237, 1e-12, "a parabola in k^2 at 0");
  int times = as_many(400, 4000);
  Rng rng = rng_stream(3, 0, RNG_TEST);
  for (int k = 0; k < times; k++) {
    for (size_t v = 0; v < w->n; v++) {
      double x = w->k[v] * w->k[v];
      S[v] = -log1p(-rng_uniform(&rng)) * (0.237 - 0.11 * x + 0.31 * x * x);
    }
    double zero = structure_zero(w, S, 1.1, &error);
    sum += zero, squares += zero * zero, told += error;
  }
  double spread = sqrt(squares / times - sum / times * (sum / times));
  gsl_test_abs(sum / times, 0.237, 4 * spread / sqrt(times), "with noise, to 4 errors");
  gsl_test_rel(told / times, spread, 0.15, "its error is its scatter");
  gsl_test(!isnan(structure_zero(w, S, 0.4, &error)), "too few vectors: none");
  free(S);
  structure_waves_free(&w);
}

/* The curve of Percus and Yevick, fitted in boxes of two thousand spheres up to ka = 1.4, gives its own S(0) to a hundredth. */
static void test_zero_of_curves(void) {
  static const double phis[] = {0.1, 0.2, 0.3, 0.4, 0.49, 0.58};
  for (size_t i = 0; i < sizeof phis / sizeof *phis; i++) {
    double side = cbrt(2000 * 4 * M_PI / 3 / phis[i]), error, zero = py_structure(phis[i], 0);
    Box box = {3, {side, side, side}};
    Waves *w = structure_waves(&box, 1.5, 0.1, 0);
    double *S = calloc(w->n, sizeof *S);
    for (size_t v = 0; v < w->n; v++)
      S[v] = py_structure(phis[i], w->k[v]);
    gsl_test_rel(structure_zero(w, S, 1.4, &error), zero, 0.01, "S(0) of Percus and Yevick at %g", phis[i]);
    gsl_test(!(error > 0.08 * zero && error < 0.34 * zero), "and its noise: %g", error / zero);
    free(S);
    structure_waves_free(&w);
  }
}

/* Form factors: a square is two sines; an ellipse a Bessel function; curves between, by a polygon of many sides. */
static double polygon_of(const Shape *shape, const double k[2]) {
  enum { N = 4000 };
  ShapeNode *node = calloc(N, sizeof *node);
  double (*v)[2] = calloc(N, sizeof *v), form[2];
  shape_nodes(shape, N, node);
  for (int i = 0; i < N; i++)
    v[i][0] = node[i].x, v[i][1] = node[i].y;
  Outcome out = {0};
  Shape *polygon = shape_convex(N, (const double(*)[2])v, &out);
  structure_form(polygon, k, form);
  shape_free(&polygon);
  free(v);
  free(node);
  return form[0];
}

static void test_forms(void) {
  static const double ks[][2] = {{0.37, 0.93}, {5.1, -2.3}, {0.001, 0.002}, {11.9, 7.3}, {3.3, 0}, {0, 6.1}};
  double form[2], s = sqrt(M_PI);
  static const double corner[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Outcome out = {0};
  Shape *one = shape_convex(4, corner, &out), *pentagon = shape_regular(5);
  Shape *ellipse = shape_superellipse(1.7, 1), *near = shape_superellipse(1.7, 1 + 1e-9);
  Shape *rhombus = shape_superellipse(1.3, 0.5), *almost = shape_superellipse(1.3, 0.5 + 1e-7);
  Shape *curve = shape_superellipse(1.5, 1.5), *needle = shape_superellipse(50, 2), *stiff = shape_superellipse(1.2, 50);
  for (size_t i = 0; i < sizeof ks / sizeof *ks; i++) {
    const double *k = ks[i];
    double x = k[0] * s / 2, y = k[1] * s / 2, other[2];
    double u = hypot(k[0] * ellipse->a, k[1] * ellipse->b);
    structure_form(one, k, form);
    gsl_test_abs(form[0], M_PI * (x ? sin(x) / x : 1) * (y ? sin(y) / y : 1), 1e-12, "a square");
    gsl_test_abs(form[1], 0, 1e-12, "which is symmetric");
    structure_form(ellipse, k, form);
    gsl_test_abs(form[0], 2 * M_PI * gsl_sf_bessel_J1(u) / u, 1e-12, "an ellipse");
    structure_form(near, k, other);
    gsl_test_abs(other[0], form[0], 1e-7, "by nodes");
    structure_form(rhombus, k, form);
    structure_form(almost, k, other);
    gsl_test_abs(other[0], form[0], 3e-5, "a rhombus by nodes");
    structure_form(curve, k, form);
    gsl_test_abs(form[0], polygon_of(curve, k), 1e-5, "a superellipse, m = 1.5");
    structure_form(needle, k, form);
    gsl_test_abs(form[0], polygon_of(needle, k), 1e-4, "a needle of 50");
    structure_form(stiff, k, form);
    gsl_test_abs(form[0], polygon_of(stiff, k), 1e-5, "m = 50");
    structure_form(pentagon, k, form);
    const double back[] = {-k[0], -k[1]};
    structure_form(pentagon, back, other);
    gsl_test_abs(form[1], -other[1], 1e-12, "a pentagon, turned by half a turn");
  }
  Shape *all[] = {one, pentagon, ellipse, near, rhombus, almost, curve, needle, stiff};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
    const double k[] = {1e-4, 2e-4};
    structure_form(all[i], k, form);
    gsl_test_rel(form[0], M_PI - 0.5 * (1e-8 * all[i]->Ixx + 4e-8 * all[i]->Iyy + 4e-8 * all[i]->Ixy), 2e-12,
                 "shape %zu near 0: area and moments", i);
    shape_free(&all[i]);
  }
}

/* A square that is also two triangles, turned by any angle: the same solid. */
static void test_solid_of_parts(void) {
  static const double corner[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, half[][2] = {{0, 0}, {1, 0}, {1, 1}};
  Outcome out = {0};
  Species whole = {.name = "S", .radius = 0.9, .count = 1, .shape = shape_convex(4, corner, &out)};
  Species part = {.name = "T", .radius = 0.9 / sqrt(2), .count = 2, .shape = shape_convex(3, half, &out)};
  Pack *a = pack_alloc(&sheet, &whole, 1, false), *b = pack_alloc(&sheet, &part, 1, false);
  double angle = 0.77, side = 0.9 * sqrt(M_PI), c = cos(angle), s = sin(angle);
  a->x[0] = 2.2, a->x[1] = 1.9, a->angle[0] = angle;
  for (int i = 0; i < 2; i++) { /* the centroid of a half, from the middle of the square */
    double x = (i ? -1 : 1) * side / 6, y = (i ? 1 : -1) * side / 6;
    b->x[2 * i] = 2.2 + c * x - s * y;
    b->x[2 * i + 1] = 1.9 + s * x + c * y;
    b->angle[i] = angle + i * M_PI;
  }
  Waves *w = structure_waves(&sheet, 14, 0.1, 0);
  double *of_a = structure_solid(a, w, NULL), *of_b = structure_solid(b, w, NULL), worst = 0;
  for (size_t v = 0; v < 2 * w->n; v++)
    worst = GSL_MAX(worst, fabs(of_a[v] - of_b[v]));
  gsl_test(!(worst < 1e-12), "a square of two triangles: %g", worst);
  free(of_a);
  free(of_b);
  structure_waves_free(&w);
  pack_free(&a);
  pack_free(&b);
  shape_free(&whole.shape);
  shape_free(&part.shape);
}

/* The table of a superellipse against the sum over nodes; the radii as the particles' own against those of the species. */
static void test_tables(void) {
  static const double m[] = {0.7, 1.5, 3, 50}, aspect[] = {1, 1.5, 5, 50};
  for (int i = 0; i < 4; i++) {
    Species species = {.name = "E", .radius = 0.4, .count = 3, .shape = shape_superellipse(aspect[i], m[i])};
    Pack *pack = pack_alloc(&sheet, &species, 1, false);
    Rng rng = rng_stream(17, 0, RNG_TEST);
    points_scatter(pack, &rng);
    points_turn(pack, &rng);
    Waves *w = structure_waves(&sheet, 20, 0.1, 0);
    double *mu = structure_solid(pack, w, NULL), worst = 0;
    for (size_t r = 0; r < w->rungs; r += 37) {
      double re = 0, im = 0, k[2], form[2];
      for (int d = 0; d < 2; d++)
        k[d] = w->unit[d] * w->rung[r].m[d];
      for (size_t j = 0; j < 3; j++) {
        double c = cos(pack->angle[j]), s = sin(pack->angle[j]), phase = k[0] * pack->x[2 * j] + k[1] * pack->x[2 * j + 1];
        const double own[] = {0.4 * (c * k[0] + s * k[1]), 0.4 * (c * k[1] - s * k[0])};
        structure_form(species.shape, own, form);
        re += 0.16 * form[0] * cos(phase);
        im += 0.16 * form[0] * sin(phase);
      }
      worst = GSL_MAX(worst, hypot(re - mu[2 * w->rung[r].at], im - mu[2 * w->rung[r].at + 1]) / (0.16 * M_PI));
    }
    gsl_test(!(worst < 1e-7), "the table of m = %g, a/b = %g: %g of an area", m[i], aspect[i], worst);
    free(mu);
    structure_waves_free(&w);
    pack_free(&pack);
    shape_free(&species.shape);
  }
  for (int dim = 2; dim < 4; dim++) {
    const Box *box = dim == 3 ? &slab : &sheet;
    Pack *of = points(box, 2, 400, false, 2), *own = points(box, 2, 400, true, 2);
    Waves *w = structure_waves(box, 11, 0.1, 500);
    double *rho = structure_amplitudes(of, w), worst = 0;
    double *mu = structure_solid(of, w, rho), *other = structure_solid(own, w, rho);
    for (size_t v = 0; v < 2 * w->n; v++)
      worst = GSL_MAX(worst, fabs(mu[v] - other[v]));
    gsl_test(!(worst < 2e-9), "radii of particles and of species, %d: %g", dim, worst);
    double big = 0;
    for (size_t v = 0; v < w->n; v++)
      big = GSL_MAX(big, square(mu + 2 * v));
    gsl_test(!(big > 1), "and they are not nothing");
    free(rho);
    free(mu);
    free(other);
    structure_waves_free(&w);
    pack_free(&of);
    pack_free(&own);
  }
}

/* One ball: its form factor, by its volume. */
static void test_ball(void) {
  Species species = {.name = "A", .radius = 0.7, .count = 1};
  Pack *pack = pack_alloc(&slab, &species, 1, false);
  pack->x[0] = 1.1, pack->x[1] = 2.2, pack->x[2] = 3.3;
  Waves *w = structure_waves(&slab, 9, 0.1, 0);
  double *rho = structure_amplitudes(pack, w), *mu = structure_solid(pack, w, rho), worst = 0;
  for (size_t v = 0; v < w->n; v++) {
    double t = 0.7 * w->k[v], form = 4 * M_PI * (sin(t) - t * cos(t)) / pow(w->k[v], 3);
    worst = GSL_MAX(worst, fabs(hypot(mu[2 * v], mu[2 * v + 1]) - fabs(form)));
  }
  gsl_test(!(worst < 1e-12), "a ball: %g", worst);
  free(mu);
  free(rho);
  structure_waves_free(&w);
  pack_free(&pack);
}

static void test_widths(void) {
  static const char *const width[] = {"default", "avx2", "avx512f"};
  Pack *pack = points(&slab, 2, 700, false, 8);
  Waves *w = structure_waves(&slab, 6, 0.1, 0);
  double *first = NULL;
  for (int i = 0; i < 3; i++) {
    setenv("RANDPACK_SIMD", width[i], 1);
    double *rho = structure_amplitudes(pack, w);
    if (first)
      gsl_test(memcmp(rho, first, 4 * w->n * sizeof *rho) != 0, "the same bits with %s", width[i]);
    else
      first = memcpy(calloc(4 * w->n, sizeof *rho), rho, 4 * w->n * sizeof *rho);
    free(rho);
  }
  unsetenv("RANDPACK_SIMD");
  free(first);
  structure_waves_free(&w);
  pack_free(&pack);
}

int main(void) {
  test_waves(&slab, 4.3);
  test_waves(&sheet, 9.1);
  test_plain(&slab, 1, 300, 5);
  test_plain(&slab, 3, 41, 5);
  test_plain(&sheet, 2, 600, 12);
  test_by_hand();
  test_few();
  test_lattice();
  test_points();
  test_choice();
  test_bins();
  test_zero();
  test_zero_of_curves();
  test_forms();
  test_solid_of_parts();
  test_tables();
  test_ball();
  test_widths();
  exit(gsl_test_summary());
}
