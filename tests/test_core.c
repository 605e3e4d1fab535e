/* Finite packs: lenses, and parts of a pack. */
#include "core.h"
#include "outcome.h"
#include "rng.h"
#include "same.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A ball of radius 1 at the distance x in the ball of radius R, by quadrature
   over slices; and the profile of shells adds up. */
static void lenses(int dim) {
  double side = 40, at[] = {1.7, 2.9, 3.3};
  Species species = {"A", 1, 1};
  Box box = {dim, {side, side, dim == 3 ? side : 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int c = 0; c < 3; c++) {
    double R = c == 2 ? 2.6 : 2.2, x = c == 2 ? 3.3 : at[c], sum = 0;
    enum { SLICES = 100000 };
    for (int k = 0; k < dim; k++)
      pack->x[k] = side / 2;
    pack->x[1] -= x;
    for (int s = 0; s < SLICES; s++) { /* across the line of centres */
      double z = x - 1 + (s + 0.5) * 2 / SLICES;
      double p = GSL_MAX(R * R - z * z, 0), q = 1 - (z - x) * (z - x);
      double least = GSL_MIN(p, q);
      sum += (dim == 2 ? 2 * sqrt(least) : M_PI * least) * 2 / SLICES;
    }
    double radius[] = {R / 2, R, 2 * R}, shell[3];
    gsl_test_rel(core_fraction(pack, R) * pack_ball(dim, R), sum, 1e-6,
                 "lens, %d-D, %d", dim, c);
    core_profile(pack, 3, radius, shell);
    double inner = core_fraction(pack, R / 2) * pack_ball(dim, R / 2);
    inner += shell[1] * (pack_ball(dim, R) - pack_ball(dim, R / 2));
    gsl_test_rel(inner, sum, 1e-6, "shells add up");
  }
  pack_free(&pack);
}

/* The lens of two discs to the last digits, by libm. */
static void angles(void) {
  double side = 40, R = 2, worst = 0;
  Species species = {"A", 1, 1};
  Box box = {2, {side, side, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  pack->x[1] = side / 2;
  for (int k = 1; k < 200; k++) {
    double x = 1 + k * 0.01, p = (x * x + 3) / (4 * x),
           q = (x * x - 3) / (2 * x);
    double area =
        4 * (acos(p) - p * sqrt(1 - p * p)) + acos(q) - q * sqrt(1 - q * q);
    pack->x[0] = side / 2 + x;
    worst =
        GSL_MAX(worst, fabs(core_fraction(pack, R) * M_PI * R * R - area));
  }
  gsl_test_abs(worst, 0, 1e-14, "angles by square roots");
  pack_free(&pack);
}

/* Points of two species and any radii in a box, finite or not. */
static Pack *cloud(int dim, size_t n, bool own, uint64_t seed) {
  Box box = {dim, {13, 11, dim == 3 ? 12 : 0}};
  Species two[] = {{"A", 0.3, n / 3}, {"B", 0.7, n - n / 3}};
  Pack *pack = pack_alloc(&box, two, 2, own);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t i = 0; i < n * (size_t)dim; i++)
    pack->x[i] = box.side[i % (size_t)dim] * rng_uniform(&rng);
  for (size_t i = 0; own && i < n; i++)
    pack->radius[i] = rng_uniform(&rng);
  for (size_t i = 0; i < n; i++) /* in any order, as from a file */
    pack->kind[i] = (uint16_t)(i * 7 % 3 > 0);
  pack->species[0].count = pack->species[1].count = 0;
  for (size_t i = 0; i < n; i++)
    pack->species[pack->kind[i]].count++;
  return pack;
}

static double distance(const Pack *pack, size_t i) {
  double x[3] = {0};
  for (int k = 0; k < pack->box.dim; k++)
    x[k] = pack->x[i * (size_t)pack->box.dim + (size_t)k] -
           pack->box.side[k] / 2;
  return hypot(hypot(x[0], x[1]), x[2]);
}

static void within(int dim) {
  enum { N = 500 };
  bool is[N];
  Pack *pack = cloud(dim, N, false, 3);
  size_t wrong = 0, many = 0, told = core_within(pack, 4.1, is);
  for (size_t i = 0; i < N; i++) {
    wrong += is[i] != (distance(pack, i) <= 4.1);
    many += is[i];
  }
  gsl_test(wrong || many != told || many < 20 || many > N - 20,
           "%d-D: %zu are within, %zu wrong", dim, many, wrong);
  for (int k = 0; k < dim; k++)
    pack->x[k] = pack->box.side[k] / 2 + (k == 1 ? 4 : 0);
  core_within(pack, 4, is);
  gsl_test(!is[0], "%d-D: one at the radius is within", dim);
  gsl_test(core_within(pack, 40, is) != N, "%d-D: all are", dim);
  pack_free(&pack);
}

/* A part holds what it was asked for, in the order that was. */
static void parts(int dim, bool own) {
  enum { N = 120 };
  bool is[N];
  size_t d = (size_t)dim, at = 0, wrong = 0, count[2] = {0};
  Pack *pack = cloud(dim, N, own, 5);
  pack->open = 4.5;
  for (size_t i = 0; i < N; i++)
    is[i] = i * i % 5 == 1;
  Pack *part = core_only(pack, is);
  for (size_t i = 0; i < N; i++)
    if (is[i]) {
      wrong += at >= part->n ||
               memcmp(part->x + at * d, pack->x + i * d, d * sizeof(double)) ||
               part->kind[at] != pack->kind[i] ||
               pack_radius(part, at) != pack_radius(pack, i);
      count[pack->kind[i]]++;
      at++;
    }
  gsl_test(wrong || at != part->n || at < 10, "%d-D: a part of %zu: %zu wrong",
           dim, at, wrong);
  gsl_test(part->species[0].count != count[0] ||
               part->species[1].count != count[1] || part->kinds != 2,
           "%d-D: with its counts", dim);
  gsl_test(part->open != 4.5 || !same_box(&part->box, &pack->box),
           "%d-D: in the same box, as finite", dim);
  gsl_test((part->radius != NULL) != own, "%d-D: and radii as before", dim);
  pack_free(&part);
  memset(is, 0, sizeof is);
  part = core_only(pack, is);
  gsl_test(part->n != 0 || part->kinds != 2, "%d-D: nobody", dim);
  pack_free(&part);
  pack_free(&pack);
}

/* Shapes and angles go with their particles, into a part and a cube. */
static void shapes(void) {
  enum { N = 90 };
  bool is[N];
  Box box = {2, {10, 12, 0}};
  Species species[] = {{"P", 1.5, 40, shape_regular(5)}, {"D", 0.5, 50}};
  Pack *pack = pack_alloc(&box, species, 2, false);
  for (size_t i = 0; i < N; i++) {
    pack->x[2 * i] = 10 * (double)i / N;
    pack->x[2 * i + 1] = 4 + 0.04 * (double)i;
    pack->angle[i] = i < 40 ? 0.1 * (double)i : 0;
    is[i] = i % 3 == 1;
  }
  Pack *part = core_only(pack, is), *cube = core_cube(pack, 4);
  int wrong = 0;
  for (size_t i = 0, at = 0; i < N; i++)
    if (is[i])
      wrong += part->angle[at++] != pack->angle[i];
  gsl_test(wrong || part->n != N / 3 || !same_shapes(part, pack), "a part of shapes, %d angles wrong", wrong);
  wrong = cube->n < 20;
  for (size_t c = 0, i = 0; c < cube->n; c++, i++) {
    while (fabs(pack->x[2 * i] - 3 - cube->x[2 * c]) > 1e-12)
      i++;
    wrong += cube->angle[c] != pack->angle[i];
  }
  gsl_test(wrong || !same_shapes(cube, pack), "a square of shapes, %d angles wrong", wrong);
  pack_free(&cube);
  pack_free(&part);
  pack_free(&pack);
  shape_free(&species[0].shape);
}

/* Whoever is in the cube, and at the same place from its middle. */
static void cubes(int dim) {
  enum { N = 700 };
  size_t d = (size_t)dim, at = 0, wrong = 0;
  Pack *pack = cloud(dim, N, true, 9);
  pack->x[0] = 3.5; /* on a face */
  pack->x[1] = pack->x[d - 1] = 5;
  Pack *cube = core_cube(pack, 6);
  for (size_t i = 0; i < N; i++) {
    bool in = true;
    for (size_t k = 0; k < d; k++) {
      double x = pack->x[i * d + k] - pack->box.side[k] / 2;
      in &= x >= -3 && x < 3;
    }
    for (size_t k = 0; in && k < d && at < cube->n; k++)
      wrong += !(fabs(cube->x[at * d + k] - 3 -
                      (pack->x[i * d + k] - pack->box.side[k] / 2)) < 1e-14);
    wrong += in && (at >= cube->n || cube->radius[at] != pack->radius[i]);
    at += in;
  }
  gsl_test(wrong || at != cube->n || at < 50, "%d-D: a cube of %zu, %zu wrong",
           dim, at, wrong);
  gsl_test(cube->open != 3, "%d-D: and the ball in it", dim);
  for (size_t k = 0; k < d; k++)
    gsl_test(cube->box.side[k] != 6, "%d-D: its box", dim);
  gsl_test(cube->x[0] != 0, "%d-D: the lower face belongs to it", dim);
  pack_free(&cube);
  pack_free(&pack);
}

/* The matrix of a turn: the images of unit vectors about the middle. */
static void matrix(const Pack *pack, int turn, double Q[3][3]) {
  size_t d = (size_t)pack->box.dim;
  Pack *turned = core_turned(pack, turn);
  memset(Q, 0, 9 * sizeof Q[0][0]);
  for (size_t m = 0; m < d; m++)
    for (size_t k = 0; k < d; k++)
      Q[k][m] = turned->x[m * d + k] - pack->box.side[k] / 2;
  for (size_t k = d; k < 3; k++) /* as an inversion */
    Q[k][k] = -1;
  pack_free(&turned);
}

static double det(double A[3][3]) {
  double sum = 0;
  for (int k = 0; k < 3; k++)
    sum += A[0][k] * (A[1][(k + 1) % 3] * A[2][(k + 2) % 3] -
                      A[1][(k + 2) % 3] * A[2][(k + 1) % 3]);
  return sum;
}

/* Every turn keeps lengths and angles, is none of the others, and moves all
   but the middle: Q - 1 has an inverse. In the plane it is a rotation, by .63
   of the distance at least. */
static void turns(int dim) {
  Box box = {dim, {40, 40, dim == 3 ? 40 : 0}};
  Species species = {"A", 1, (size_t)dim};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (size_t c = 0, d = (size_t)dim; c < d * d; c++)
    pack->x[c] = 20 + (c / d == c % d);
  double all[15][3][3], off = 0, same = INFINITY, fixed = INFINITY;
  for (int t = 0; t < core_turns(dim); t++) {
    double(*Q)[3] = all[t], less[3][3];
    matrix(pack, t, Q);
    for (int k = 0; k < 3; k++)
      for (int m = 0; m < 3; m++) {
        double one = Q[k][0] * Q[m][0] + Q[k][1] * Q[m][1] + Q[k][2] * Q[m][2];
        off = fmax(off, fabs(one - (k == m)));
        less[k][m] = Q[k][m] - (k == m);
      }
    fixed = fmin(fixed, fabs(det(less)));
    off = fmax(off, dim == 2 ? fabs(det(Q) + 1) : 0);
    for (int s = 0; s < t; s++) {
      double apart = 0;
      for (int c = 0; c < 9; c++)
        apart += fabs(all[s][c / 3][c % 3] - Q[c / 3][c % 3]);
      same = fmin(same, apart);
    }
  }
  gsl_test(!(off < 1e-14), "%d-D: turns keep lengths (%g)", dim, off);
  gsl_test(!(same > 0.3), "%d-D: no two turns are the same", dim);
  gsl_test(!(fixed > (dim == 2 ? 2 * 0.39 : 1.9)), "%d-D: turns leave but the middle in place (%g)", dim, fixed);
  pack_free(&pack);
}

int main(void) {
  shapes();
  for (int dim = 2; dim <= 3; dim++) {
    lenses(dim);
    within(dim);
    parts(dim, false);
    parts(dim, true);
    cubes(dim);
    turns(dim);
  }
  angles();
  return gsl_test_summary();
}
