/* tests/test_percolation.c: clusters by hand, all pairs of images by a plain search, and the known thresholds */
#include "many.h"
#include "penetrable.h"
#include "percolation.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static Pack *discs(size_t n, const double x[][2], double radius, double a, double b) {
  Species species = {.name = "P", .radius = radius, .count = n};
  Box box = {2, {a, b, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (size_t i = 0; i < 2 * n; i++)
    pack->x[i] = x[i / 2][i % 2];
  return pack;
}

static void expect(Pack *pack, double scale, int x, int y, size_t clusters, size_t largest, const char *what) {
  Percolation p = percolation_find(pack, scale);
  gsl_test(p.along[0] != x || p.along[1] != y || p.along[2], "%s: along", what);
  gsl_test_int((int)p.clusters, (int)clusters, "%s: clusters", what);
  gsl_test_int((int)p.largest, (int)largest, "%s: largest", what);
  pack_free(&pack);
}

static void test_by_hand(void) {
  static const double row[][2] = {{0, 1}, {1.8, 1}, {3.6, 1}}, ends[][2] = {{0, 1}, {3.6, 1}};
  static const double stair[][2] = {{0.5, 0.5}, {1.5, 1.5}, {2.5, 2.5}, {3.5, 3.5}};
  expect(discs(3, row, 1, 5, 9), 1, 1, 0, 1, 3, "a row");
  expect(discs(2, ends, 1, 5, 9), 1, 0, 0, 1, 2, "without the middle");
  expect(discs(2, ends, 0.5, 5, 9), 1, 0, 0, 2, 1, "smaller");
  expect(discs(2, ends, 0.5, 5, 9), 2, 0, 0, 1, 2, "and scaled");
  expect(discs(2, ends, 0.5, 5, 9), 3.7, 1, 0, 1, 2, "and more");
  expect(discs(1, row, 2.6, 5, 9), 1, 1, 0, 1, 1, "one that overlaps its image");
  expect(discs(1, row, 4.6, 5, 9), 1, 1, 1, 1, 1, "both its images");
  expect(discs(4, stair, 0.8, 4, 4), 1, 1, 1, 1, 4, "a stair closes along both");
  expect(discs(0, row, 1, 5, 9), 1, 0, 0, 0, 0, "nothing");
}

/* The same by spreading from each particle through all images of a few boxes, without a tree. */
static void test_plain(void) {
  enum { N = 12, M = 2, SIDE = 2 * M + 1 };
  Rng rng = rng_stream(91, 0, RNG_TEST);
  int differ = 0, wrapped = 0, labels_differ = 0, images_differ = 0;
  for (int k = 0; k < as_many(150, 1000); k++) {
    double x[N][2], R = 0.25 + 0.6 * rng_uniform(&rng);
    for (int i = 0; i < 2 * N; i++)
      x[i / 2][i % 2] = 3 * rng_uniform(&rng);
    Pack *pack = discs(N, (const double(*)[2])x, R, 3, 3);
    Percolation p = percolation_find(pack, 1);
    PercolationLabels *labels = percolation_labels(pack, 1);
    bool along[2] = {false};
    size_t largest = 0;
    for (int start = 0; start < N; start++) {
      bool seen[SIDE][SIDE][N] = {{{false}}}, one[N] = {false};
      int stack[SIDE * SIDE * N][3], top = 0;
      size_t size = 0;
      stack[top][0] = stack[top][1] = M, stack[top++][2] = start;
      seen[M][M][start] = true;
      while (top) {
        top--;
        int a = stack[top][0], b = stack[top][1], i = stack[top][2];
        size += !one[i];
        one[i] = true;
        along[0] |= i == start && a != M;
        along[1] |= i == start && b != M;
        for (int c = 0; c < SIDE * SIDE * N; c++) {
          int e = c / N / SIDE, f = c / N % SIDE, j = c % N;
          double dx = x[j][0] - x[i][0] + 3 * (e - a), dy = x[j][1] - x[i][1] + 3 * (f - b);
          if (seen[e][f][j] || dx * dx + dy * dy >= 4 * R * R)
            continue;
          seen[e][f][j] = true;
          stack[top][0] = e, stack[top][1] = f, stack[top++][2] = j;
        }
      }
      largest = GSL_MAX(largest, size);
      labels_differ += labels->size[labels->of[start]] != size;
      for (int c = 0; c < SIDE * SIDE * N; c++) {
        int e = c / N / SIDE, f = c / N % SIDE, j = c % N, n[3] = {e - M, f - M, 0};
        bool near = abs(n[0]) < M && abs(n[1]) < M;
        images_differ += near && seen[e][f][j] != percolation_joined(labels, (size_t)start, (size_t)j, n);
      }
    }
    percolation_labels_free(&labels);
    wrapped += along[0] + along[1];
    differ += along[0] != p.along[0] || along[1] != p.along[1] || largest != p.largest;
    pack_free(&pack);
  }
  gsl_test_int(differ, 0, "as by spreading through images");
  gsl_test_int(labels_differ, 0, "labels have the size of their cluster");
  gsl_test_int(images_differ, 0, "images are joined as by spreading");
  gsl_test(wrapped < 50 || wrapped > as_many(250, 1900), "%d axes", wrapped);
}

/* At the threshold a pack percolates along any axis with the probability .6905, along all with .3517; well below never, above always. */
static void test_thresholds(void) {
  Shape *four = shape_regular(4);
  static const double threshold[] = {0.6763, 0.6666, 0.6254};
  static const char *const name[] = {"discs", "parallel squares", "squares at any angle"};
  Rng rng = rng_stream(92, 0, RNG_TEST);
  for (int c = 0; c < 3; c++)
    for (int level = -1; level <= 1; level++) {
      int packs = as_many(level ? 20 : 160, level ? 200 : 4000), any = 0, all = 0;
      double density = -log(1 - threshold[c]) * (1 + 0.4 * level), n = as_many(100, 1000);
      Species species = {.name = "P", .radius = 1, .count = (size_t)n, .shape = c ? four : NULL};
      double side = sqrt(n * M_PI / density);
      Box box = {2, {side, side, 0}};
      for (int k = 0; k < packs; k++) {
        Pack *pack = pack_alloc(&box, &species, 1, false);
        penetrable_throw(pack, false, &rng);
        for (size_t i = 0; c == 1 && i < pack->n; i++)
          pack->angle[i] = M_PI / 4;
        Percolation p = percolation_find(pack, 1);
        any += p.along[0] || p.along[1];
        all += p.along[0] && p.along[1];
        pack_free(&pack);
      }
      double want[2] = {level < 0 ? 0 : level ? 1 : 0.690473725, level < 0 ? 0 : level ? 1 : 0.351642855};
      double error = level ? 0.25 : 4 * sqrt(0.25 / packs);
      gsl_test_abs((double)any / packs, want[0], error, "%s, level %d: along any axis", name[c], level);
      gsl_test_abs((double)all / packs, want[1], error, "%s, level %d: along all", name[c], level);
    }
  shape_free(&four);
}

/* Closed ways that are sums of others, and one that goes twice round before it closes. */
static void test_ways(void) {
  static const double stair[][2] = {{0.5, 0.5}, {1.5, 1.5}, {2.5, 2.5}, {3.5, 3.5}};
  static const double row[][2] = {{0.5, 1}, {1.5, 1.5}, {2.5, 2}, {3.5, 2.5}, {0.5, 3}, {1.5, 3.5}, {2.5, 4}, {3.5, 4.5}};
  static const double screw[][2] = {{0.5, 1}, {1.5, 1.5}, {2.5, 2}, {3.5, 2.5}, {0.5, 3}, {1.5, 3.5}, {2.5, 0}, {3.5, 0.5}};
  static const int n[][4] = {{1, 1, 0, 1}, {1, 0, 0, 0}, {-2, -2, 0, 1}, {0, 0, 0, 1}, {2, 1, 0, 0}};
  static const int m[][4] = {{1, 0, 0, 0}, {2, 0, 0, 0}, {0, 0, 0, 1}};
  Pack *pack = discs(4, stair, 0.8, 4, 4);
  PercolationLabels *labels = percolation_labels(pack, 1);
  for (int k = 0; k < 5; k++)
    gsl_test_int(percolation_joined(labels, 0, 0, n[k]), n[k][3], "a stair and its image %d %d", n[k][0], n[k][1]);
  percolation_labels_free(&labels);
  pack_free(&pack);
  pack = discs(8, row, 0.56, 4, 9);
  labels = percolation_labels(pack, 1);
  gsl_test_int((int)labels->clusters, 1, "a row that rises");
  for (int k = 0; k < 3; k++)
    gsl_test_int(percolation_joined(labels, 0, 0, m[k]), m[k][3], "a row that rises and its image %d", m[k][0]);
  percolation_labels_free(&labels);
  pack_free(&pack);
  pack = discs(8, screw, 0.56, 4, 4); /* closed after two turns along x and one along y */
  labels = percolation_labels(pack, 1);
  static const int t[][4] = {{2, 1, 0, 1}, {1, 0, 0, 0}, {4, 2, 0, 1}, {2, 0, 0, 0}, {-2, -1, 0, 1}};
  for (int k = 0; k < 5; k++)
    gsl_test_int(percolation_joined(labels, 0, 0, t[k]), t[k][3], "a screw and its image %d %d", t[k][0], t[k][1]);
  percolation_labels_free(&labels);
  pack_free(&pack);
}

/* Which images of a particle are joined to it does not depend on where the box begins. In a narrow box small clusters close, and
   are joined to others later. */
static void test_moved(void) {
  enum { N = 25 };
  Rng rng = rng_stream(93, 0, RNG_TEST);
  int differ = 0, closed = 0;
  for (int k = 0; k < as_many(100, 1000); k++) {
    double x[2][N][2], R = 0.45 + 0.2 * rng_uniform(&rng), move[2] = {20 * rng_uniform(&rng), 2 * rng_uniform(&rng)};
    PercolationLabels *labels[2];
    for (int i = 0; i < 2 * N; i++) {
      double side = i % 2 ? 2 : 20;
      x[0][i / 2][i % 2] = side * rng_uniform(&rng);
      x[1][i / 2][i % 2] = box_wrap(x[0][i / 2][i % 2] + move[i % 2], side);
    }
    for (int m = 0; m < 2; m++) {
      Pack *pack = discs(N, (const double(*)[2])x[m], R, 20, 2);
      labels[m] = percolation_labels(pack, 1);
      pack_free(&pack);
    }
    for (size_t i = 0; i < N; i++) {
      static const int n[3] = {0, 1, 0};
      bool joined = percolation_joined(labels[0], i, i, n);
      closed += joined;
      differ += joined != percolation_joined(labels[1], i, i, n);
    }
    for (int m = 0; m < 2; m++)
      percolation_labels_free(&labels[m]);
  }
  gsl_test_int(differ, 0, "the same images are joined in a box that begins elsewhere");
  gsl_test(closed < as_many(100, 1000), "%d closed", closed);
}

static void test_spheres(void) {
  Species species = {.name = "P", .radius = 0.6, .count = 5};
  Box box = {3, {5, 6, 7}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int i = 0; i < 5; i++)
    pack->x[3 * i] = i;
  Percolation p = percolation_find(pack, 1);
  gsl_test(!p.along[0] || p.along[1] || p.along[2] || p.clusters != 1, "a row of spheres");
  pack_free(&pack);
}

/* Lattices of particles that touch: rounding makes pairs overlap, and none may be joined. A little larger, all are. */
static void test_touching(void) {
  static const double cell[4][3] = {{2, 2, 2}, {2, 2 * M_SQRT3, 2}, {2 * M_SQRT2, 2 * M_SQRT2, 2 * M_SQRT2}, {4 / M_SQRT3, 4 / M_SQRT3, 4 / M_SQRT3}};
  static const double basis[4][4][3] = {{{0, 0, 0}}, {{0, 0, 0}, {0.5, 0.5, 0}}, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, {{0, 0, 0}, {0.5, 0.5, 0.5}}};
  static const char *const name[] = {"square", "triangular", "face-centred", "body-centred"};
  static const size_t of_cell[] = {1, 2, 4, 2};
  static const double radii[] = {0.1, 0.3, 1 / 3., 0.7, 1, 1.1, M_PI, 17.3};
  Shape *round = shape_superellipse(1, 1), *four = shape_regular(4);
  int rounded = 0;
  for (int l = 0; l < 6; l++)
    for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
      int of = l < 4 ? l : 0, dim = of < 2 ? 2 : 3, m = 5;
      double R = radii[k], edge = l == 5 ? sqrt(M_PI) / 2 : 1; /* the square of radius 1 */
      Species species = {.name = "P", .radius = R, .shape = l == 4 ? round : l == 5 ? four : NULL};
      Box box = {dim, {0}};
      size_t cells = 1, at = 0;
      for (int d = 0; d < dim; d++) {
        box.side[d] = m * R * edge * cell[of][d];
        cells *= (size_t)m;
      }
      species.count = cells * of_cell[of];
      Pack *pack = pack_alloc(&box, &species, 1, false);
      for (size_t c = 0; c < cells; c++)
        for (size_t b = 0; b < of_cell[of]; b++, at++)
          for (int d = 0; d < dim; d++) {
            size_t i = d == 0 ? c % 5 : d == 1 ? c / 5 % 5 : c / 25;
            pack->x[at * (size_t)dim + (size_t)d] = box_wrap((0.37 + (double)i + basis[of][b][d]) * R * edge * cell[of][d], box.side[d]);
          }
      for (size_t i = 0; l == 5 && i < pack->n; i++)
        pack->angle[i] = M_PI / 4;
      rounded += touch_least_gap(pack) < 0;
      Percolation p = percolation_find(pack, 1), larger = percolation_find(pack, 1 + 1e-6);
      gsl_test(p.clusters != pack->n || p.largest != 1 || p.along[0] || p.along[1] || p.along[2], "%s lattice %d, touching at radius %g: %zu of %zu alone",
               name[of], l, R, p.clusters, pack->n);
      gsl_test(larger.clusters != 1 || !larger.along[0] || !larger.along[1], "%s lattice %d, radius %g, larger: %zu clusters", name[of], l, R, larger.clusters);
      for (size_t i = 0; i < pack->n * (size_t)dim; i++)
        pack->x[i] *= 3;
      for (int d = 0; d < dim; d++)
        pack->box.side[d] *= 3;
      p = percolation_find(pack, 3);
      gsl_test_int((int)p.clusters, (int)pack->n, "%s lattice %d, radius %g, touching when scaled", name[of], l, R);
      pack_free(&pack);
    }
  gsl_test(rounded < 8, "rounding made particles overlap in %d lattices", rounded);
  /* Far from the origin of a wide box. */
  for (int s = 0; s < 3; s++)
    for (int k = 0; k < 50; k++) {
      double edge = s == 2 ? sqrt(M_PI) : 2;
      Pack *pack = discs(2, (const double[][2]){{0, 3}, {0, 3}}, 1, 3e5, 7);
      if (s) {
        Species species = {.name = "P", .radius = 1, .count = 2, .shape = s == 1 ? round : four};
        Box box = pack->box;
        pack_free(&pack);
        pack = pack_alloc(&box, &species, 1, false);
        pack->angle[0] = pack->angle[1] = s == 2 ? M_PI / 4 : 0;
      }
      pack->x[1] = pack->x[3] = 3;
      pack->x[0] = 2e5 + 0.1 * k;
      pack->x[2] = pack->x[0] + edge;
      gsl_test_int((int)percolation_find(pack, 1).clusters, 2, "two that touch in a wide box, shape %d, at %.17g", s, pack->x[0]);
      pack_free(&pack);
    }
  shape_free(&round);
  shape_free(&four);
}

int main(void) {
  test_touching();
  test_by_hand();
  test_plain();
  test_ways();
  test_moved();
  test_thresholds();
  test_spheres();
  return gsl_test_summary();
}
