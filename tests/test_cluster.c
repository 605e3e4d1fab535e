/* tests/test_cluster.c: covariances of one particle, clusters by exact areas, and images that are other clusters */
#include "cluster.h"
#include "cover.h"
#include "many.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

/* Of a square with the edge 1 (r at most sqrt 2). */
static double square_covariance(double r) {
  if (r <= 1)
    return 1 - 4 * r / M_PI + r * r / M_PI;
  return 2 / M_PI * (asin(1 / r) - acos(1 / r) + 2 * sqrt(r * r - 1) - r * r / 2 - 1);
}

static void test_covariances(void) {
  Shape *four = shape_regular(4), *round = shape_superellipse(1, 1), *needle = shape_superellipse(50, 1);
  double edge = sqrt(M_PI);
  for (double r = 0; r < 1.41; r += 0.0937)
    gsl_test_abs(cluster_shape(four, r * edge), M_PI * square_covariance(r), 3e-9, "a square, r = %g edges", r);
  for (double r = 0; r < 2.2; r += 0.1731)
    gsl_test_abs(cluster_shape(round, r), cluster_ball(2, 1, r), 3e-9, "a disc as a superellipse, r = %g", r);
  /* An ellipse is a disc that is stretched: its covariance in one direction is that of a disc. */
  for (double r = 0.05; r < 14; r *= 2.1) {
    double sum = 0;
    const int M = as_many(200000, 200000);
    for (int k = 0; k < M; k++) {
      double t = M_PI * (k + 0.5) / M;
      sum += cluster_ball(2, 1, r * hypot(cos(t) / needle->a, sin(t) / needle->b)) / M;
    }
    gsl_test_abs(cluster_shape(needle, r), sum, 1e-7, "a needle, r = %g", r);
  }
  gsl_test_rel(cluster_ball(3, 2, 0), pack_ball(3, 2), 1e-15, "a sphere, r = 0");
  gsl_test_rel(cluster_ball(3, 1, 1), 4 * M_PI / 3 * 0.3125, 1e-15, "a sphere, r = a");
  gsl_test_abs(cluster_ball(3, 1, 2), 0, 0, "a sphere ends");
  shape_free(&four);
  shape_free(&round);
  shape_free(&needle);
}

/* Of a rectangle a by b: a mean over directions of (a - r cos)(b - r sin), each factor where it is positive. */
static double rectangle_covariance(double a, double b, double r) {
  double from = r > a ? acos(a / r) : 0, to = r > b ? asin(b / r) : M_PI / 2;
  if (from >= to)
    return 0;
  double s = sin(to) - sin(from), c = cos(from) - cos(to), square = 0.5 * (sin(to) * sin(to) - sin(from) * sin(from));
  return 2 / M_PI * (a * b * (to - from) - b * r * s - a * r * c + r * r * square);
}

/* A thousand to one, also turned, and as curves: a mean that misses the few directions in which the needle meets itself is 0. */
static void test_needles(void) {
  static const double turns[] = {0, 0.123, 1.2, M_PI / 2, 2.9};
  Outcome out = {0};
  Shape *curve = shape_superellipse(1000, 1), *other = shape_superellipse(0.001, 1), *sharp = shape_superellipse(1000, 0.6);
  for (size_t k = 0; k < sizeof turns / sizeof *turns; k++)
    for (int blunt = 0; blunt < 2; blunt++) { /* 4 sides, or 44 */
      enum { CAP = 20 };
      double v[2 * CAP + 4][2], a = sqrt(1000 * M_PI), b = a / 1000;
      int n = 0;
      for (int end = 0; end < 2; end++)
        for (int i = 0; i <= (blunt ? CAP + 1 : 1); i++) { /* a cap so flat that it adds nothing */
          double t = -1 + 2. * i / (blunt ? CAP + 1 : 1), x = a / 2 + (1 - t * t) * 1e-9 * a, y = t * b / 2, sign = end ? -1 : 1;
          v[n][0] = sign * (x * cos(turns[k]) - y * sin(turns[k]));
          v[n++][1] = sign * (x * sin(turns[k]) + y * cos(turns[k]));
        }
      Shape *needle = shape_convex(n, (const double(*)[2])v, &out);
      for (double r = 0.01; r < a * 1.01; r *= 1.31)
        gsl_test_abs(cluster_shape(needle, r), rectangle_covariance(a, b, r), blunt ? 1e-6 : 1e-8, "a needle of %d sides turned by %g, r = %g of %g", n,
                     turns[k], r, a);
      gsl_test(!(cluster_shape(needle, 0.9 * a) > 1e-6), "and not 0");
      shape_free(&needle);
    }
  for (double r = 0.01; r < 64; r *= 1.31) { /* a stretched disc: by the angle in which it is one */
    double sum = 0;
    const int M = as_many(100000, 100000);
    for (int i = 0; i < M; i++) {
      double t = M_PI / 2 * (i + 0.5) / M, s = gsl_pow_2(sin(t)), f = M_PI / 2 * gsl_pow_3(sin(t)); /* crowded at 0 */
      double c = hypot(cos(f) * curve->a, sin(f) * curve->b);
      sum += 3 * M_PI / 2 * s * cos(t) * cluster_ball(2, 1, r / c) / (c * c) / M;
    }
    gsl_test_abs(cluster_shape(curve, r), sum, 1e-6, "an ellipse, a thousand to one, r = %g", r);
    gsl_test_abs(cluster_shape(other, r), cluster_shape(curve, r), 2e-9, "and upright, r = %g", r);
  }
  double most = 2 * sharp->a, last = M_PI;
  for (double r = 0.05; r < 0.99; r += 0.05) {
    double now = cluster_shape(sharp, r * most);
    gsl_test(!(now > 0 && now < last), "a sharp needle: %g after %g at %g of its length", now, last, r);
    last = now;
  }
  shape_free(&curve);
  shape_free(&other);
  shape_free(&sharp);
}

/* |U and (U + r)|, a mean over directions, from the areas of unions. */
static double covariance(const Pack *pack, const Box *box, double r) {
  const int M = as_many(720, 720);
  size_t n = pack->n;
  Body *one = cover_bodies(pack), *two = malloc(2 * n * sizeof *two);
  for (size_t i = 0; !box && i < n; i++) { /* about the origin */
    one[i].x -= one[i].x > 0.5 * pack->box.side[0] ? pack->box.side[0] : 0;
    one[i].y -= one[i].y > 0.5 * pack->box.side[1] ? pack->box.side[1] : 0;
  }
  double sum = 0, area = cover_area(one, n, box, NULL);
  for (int k = 0; k < M; k++) {
    double t = 2 * M_PI * (k + 0.31) / M;
    memcpy(two, one, n * sizeof *two);
    memcpy(two + n, one, n * sizeof *two);
    for (size_t i = 0; i < n; i++) {
      two[n + i].x += r * cos(t);
      two[n + i].y += r * sin(t);
      two[n + i].x = box ? box_wrap(two[n + i].x, box->side[0]) : two[n + i].x;
      two[n + i].y = box ? box_wrap(two[n + i].y, box->side[1]) : two[n + i].y;
    }
    sum += 2 * area - cover_area(two, 2 * n, box, NULL);
  }
  free(one);
  free(two);
  return sum / M;
}

enum { BINS = 8 };
/* Means of C_2 times the volume over repeated samples, with errors. */
static void sample(const Pack *pack, const double r[], double mean[], double error[]) {
  int times = as_many(40, 400);
  double C[BINS], sum[BINS] = {0}, square[BINS] = {0}, V = box_volume(&pack->box);
  Rng rng = rng_stream(331, 0, RNG_TEST);
  for (int k = 0; k < times; k++) {
    cluster_function(pack, BINS, r, 300, &rng, C);
    for (int b = 0; b < BINS; b++) {
      sum[b] += C[b] * V;
      square[b] += gsl_pow_2(C[b] * V);
    }
  }
  for (int b = 0; b < BINS; b++) {
    mean[b] = sum[b] / times;
    error[b] = sqrt(GSL_MAX(square[b] / times - mean[b] * mean[b], 0) / (times - 1)) + 1e-13;
  }
}

/* All particles are one cluster, in the plane or in the endless box. */
static void expect(Pack *pack, bool endless, const double r[], const char *what) {
  double mean[BINS], error[BINS];
  sample(pack, r, mean, error);
  for (int b = 0; b < BINS; b++) {
    double want = covariance(pack, endless ? &pack->box : NULL, r[b]);
    gsl_test(!(fabs(mean[b] - want) <= 4 * error[b]), "%s, r = %g: %.4f(%.4f), exactly %.4f", what, r[b], mean[b], error[b], want);
  }
  pack_free(&pack);
}

static void test_clusters(void) {
  static const double r[BINS] = {0, 0.3, 0.9, 1.6, 2.2, 2.7, 3.05, 6.5};
  Shape *needle = shape_superellipse(20, 1), *three = shape_regular(3);
  Pack *two = pack_of(2, 7, 2, 1, NULL), *cross = pack_of(2, 4, 5, 1, NULL), *crossed = pack_of(2, 30, 2, 1, needle), *fan = pack_of(2, 12, 3, 1, three);
  static const double at[] = {2, 2, 0.6, 2, 3.4, 2, 2, 0.6, 2, 3.4};
  two->x[0] = 6.8;
  two->x[2] = 0.8;
  memcpy(cross->x, at, sizeof at);
  crossed->angle[1] = 1;
  fan->x[2] = 0.7;
  fan->x[4] = 11.5;
  fan->angle[1] = 0.5;
  fan->angle[2] = 2;
  expect(two, false, r, "two discs over the side of the box");
  expect(cross, true, r, "one cluster along both axes is S_2");
  expect(crossed, false, r, "crossed needles");
  expect(fan, false, r, "three triangles");
  shape_free(&needle);
  shape_free(&three);
}

/* Hard packs: the sum over particles, and 0 at the distance of the images. */
static void test_alone(void) {
  static const double r[BINS] = {0, 0.5, 1.1, 1.7, 2.1, 2.5, 5, 50};
  double C[BINS];
  Rng rng = rng_stream(332, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++) {
    Pack *one = pack_of(dim, 2.5, 1, 1, NULL);
    ClusterShare share = cluster_function(one, BINS, r, 100, &rng, C);
    gsl_test(share.alone != 1 || share.solid != 0, "%d-D, one particle is alone", dim);
    for (int b = 0; b < BINS; b++)
      gsl_test_abs(C[b], cluster_ball(dim, 1, r[b]) / pow(2.5, dim), 1e-15, "%d-D, one particle, r = %g", dim, r[b]);
    pack_free(&one);
  }
  Species species[] = {{"A", 1, 1, shape_regular(5)}, {"B", 0.5, 2, NULL}};
  Box box = {2, {6, 6, 0}};
  Pack *mixed = pack_alloc(&box, species, 2, false);
  mixed->x[0] = mixed->x[1] = 2;
  mixed->x[2] = mixed->x[5] = 5;
  cluster_function(mixed, BINS, r, 100, &rng, C);
  for (int b = 0; b < BINS; b++)
    gsl_test_abs(36 * C[b], cluster_shape(species[0].shape, r[b]) + 2 * cluster_ball(2, 0.5, r[b]), 1e-13, "two species, r = %g", r[b]);
  pack_free(&mixed);
  /* A shape with a radius of its own is sampled. */
  mixed = pack_alloc(&box, species, 1, true);
  double mean[BINS], error[BINS];
  mixed->radius[0] = 0.7;
  sample(mixed, r, mean, error);
  for (int b = 0; b < BINS; b++)
    gsl_test_abs(mean[b], 0.49 * cluster_shape(species[0].shape, r[b] / 0.7), 4 * error[b], "a radius of its own, r = %g", r[b]);
  pack_free(&mixed);
  shape_free(&species[0].shape);
}

static void test_hard(void) {
  static const double r[BINS] = {0, 0.5, 1.1, 1.7, 2.1, 2.5, 5, 50};
  Pack *twins = pack_of(3, 6, 2, 1, NULL), *none = pack_of(2, 6, 0, 1, NULL), *wide = pack_of(2, 2, 1, 1.1, NULL), *full = pack_of(2, 2, 1, 1.5, NULL);
  double C[BINS], mean[BINS], error[BINS];
  Rng rng = rng_stream(333, 0, RNG_TEST);
  gsl_test_abs(cluster_function(none, BINS, r, 100, &rng, C).alone, 0, 0, "no particle");
  gsl_test_abs(C[0], 0, 0, "no particle, no cluster");
  cluster_function(twins, 1, r, 1.01, &rng, C);
  gsl_test_rel(C[0] * 216, pack_ball(3, 1), 1e-12, "two points stand for the whole, as of 1.01");
  sample(twins, r, mean, error);
  gsl_test_rel(mean[0], pack_ball(3, 1), 1e-12, "coincident spheres count once");
  for (int b = 1; b < BINS; b++)
    gsl_test_abs(mean[b], cluster_ball(3, 1, r[b]), 4 * error[b], "coincident spheres, r = %g", r[b]);
  gsl_test_abs(cluster_function(full, BINS, r, 100, &rng, C).alone, 0, 0, "a disc that meets its images is not alone");
  for (int b = 0; b < BINS; b++)
    gsl_test_abs(C[b], 1, 0.2, "no matrix, r = %g", r[b]);
  sample(wide, r, mean, error);
  for (int b = 0; b < BINS; b++)
    gsl_test_abs(mean[b], covariance(wide, &wide->box, r[b]), 4 * error[b], "a disc that meets its images, r = %g", r[b]);
  pack_free(&twins);
  pack_free(&none);
  pack_free(&wide);
  pack_free(&full);
}

/* A lattice of balls that touch: all are alone, and two points of one cluster are nearer than a diameter. */
static void test_touching(void) {
  static const double r[BINS] = {0, 0.5, 1, 1.9, 2, 2.1, 4, 6};
  static const double radii[] = {0.1, 0.3, 0.7, 1.1, M_PI};
  double C[BINS], at[BINS];
  Rng rng = rng_stream(334, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++)
    for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
      double R = radii[k];
      Pack *pack = pack_of(dim, 8 * R, dim == 2 ? 16 : 64, R, NULL);
      for (size_t i = 0; i < pack->n; i++)
        for (int d = 0; d < dim; d++)
          pack->x[i * (size_t)dim + (size_t)d] = (0.77 + 2 * (double)(d == 0 ? i % 4 : d == 1 ? i / 4 % 4 : i / 16)) * R;
      for (int b = 0; b < BINS; b++)
        at[b] = r[b] * R;
      gsl_test_abs(cluster_function(pack, BINS, at, 1000, &rng, C).alone, 1, 0, "%d-D, balls of radius %g that touch are alone", dim, R);
      for (int b = 0; b < BINS; b++)
        gsl_test_abs(C[b], cluster_ball(dim, 1, r[b]) / pow(2, dim), 1e-14, "%d-D, balls of radius %g that touch, r = %g", dim, R, r[b]);
      pack_free(&pack);
    }
}

int main(void) {
  test_covariances();
  test_needles();
  test_touching();
  test_clusters();
  test_alone();
  test_hard();
  return gsl_test_summary();
}
