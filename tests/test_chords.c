/* tests/test_chords.c: single particles in closed form, lattices along an axis, points that wear balls, and spans by a slow search */
#include "chords.h"
#include "many.h"
#include "points.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BINS = 40 };

static Pack *balls(const Box *box, size_t n, double radius, uint64_t seed) {
  Species species = {.name = "A", .radius = radius, .count = n};
  return scattered(box, &species, 1, seed);
}

static Chords *find(const Pack *pack, size_t lines, double step, const double *direction, double fraction) {
  ChordPlan plan = {.lines = lines, .direction = direction, .step = step, .bins = BINS, .fraction = fraction};
  Rng rng = rng_stream(11, 0, RNG_TEST);
  return chords_find(pack, &plan, &rng);
}

/* One ball in a box: the law of its chords, and the mean chord of both phases. */
static void test_ball(int dim, double a, const Box *box) {
  Pack *pack = balls(box, 1, a, 1);
  double fraction, exact[2], step = 2 * a / BINS, far = 0, worst = 0, law = 0;
  chords_exact(pack, &fraction, exact);
  gsl_test_rel(fraction, pack_fraction(pack), 1e-14, "one ball in %d: fraction", dim);
  gsl_test_rel(exact[CHORDS_PARTICLES], dim == 3 ? 4 * a / 3 : M_PI * a / 2, 1e-14, "mean chord in it");
  Chords *c = find(pack, (size_t)as_many(6000, 60000), step, NULL, fraction);
  double error = exact[1] / sqrt(c->number[1]);
  gsl_test_abs(c->mean[1], exact[1], 3 * 0.4 * error, "as the lines have it, to 3 errors");
  gsl_test_abs(c->mean[0] / exact[0], 1, 5 / sqrt(c->number[0]), "and of the matrix");
  for (int b = 0; b < BINS; b++) { /* mean of the law over the bin, from its integral */
    double z1 = b * step, z2 = (b + 1) * step;
    double part = dim == 3 ? (z2 * z2 - z1 * z1) / (4 * a * a)
                           : sqrt(1 - z1 * z1 / (4 * a * a)) - sqrt(fmax(0, 1 - z2 * z2 / (4 * a * a)));
    double sigma = sqrt(part * (1 - part) / c->number[1]) / step;
    law += part;
    far += gsl_pow_2((c->p[1][b] - part / step) / sigma) / BINS;
    worst = fmax(worst, fabs(c->p_error[1][b] / sigma - 1));
  }
  gsl_test_rel(law, 1, 1e-7, "the law adds up to 1");
  gsl_test_abs(far, 1, 0.7, "the chords of a ball in %d follow it: squares of the differences, in errors", dim);
  gsl_test(!(worst < 1), "their errors are those of counts: %g", worst);
  gsl_test_abs(c->L[1][0], fraction * (1 - step / 2 / exact[1]), 0.02 * fraction, "the path of short pieces");
  chords_free(&c);
  gsl_test(c != NULL, "freed");
  pack_free(&pack);
}

/* A square lattice of discs, lines along x: half are free, the others have the chords of the example. */
static void test_lattice(void) {
  enum { M = 6 };
  static const double along[] = {1, 0, 0}, up[] = {0, 1, 0};
  Species species = {.name = "A", .radius = 1, .count = M * M};
  Box box = {2, {4 * M, 4 * M, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  for (int i = 0; i < M * M; i++)
    pack->x[2 * i] = 0.7 + 4 * (i / M), pack->x[2 * i + 1] = 0.4 + 4 * (i % M);
  for (int axis = 0; axis < 2; axis++) {
    Chords *c = find(pack, (size_t)as_many(4000, 40000), 0.25, axis ? up : along, M_PI / 16);
    double N = as_many(4000, 40000);
    gsl_test_abs(c->free[0], 0.5, 3 * 0.5 / sqrt(N), "a lattice: lines that are free");
    gsl_test_abs(c->free[1], 0, 0, "none is in particles");
    gsl_test_abs(c->mean[1], M_PI / 2, 3 * 0.45 / sqrt(N / 2), "chords in discs");
    gsl_test_abs(c->mean[0] + c->mean[1], 4, 5e-3, "and between them");
    gsl_test_abs(c->p[0][7], 0, 0, "no gap shorter than 2");
    gsl_test(!(c->p[0][8] > 0), "gaps of 2 and more");
    double z = 7.5 * 0.25; /* all gaps are longer: half of the lines, (4 - chord - z) / 4 of the places */
    gsl_test_abs(c->L[0][7], 0.5 + 0.5 * (4 - M_PI / 2 - z) / 4, 0.012, "pieces of the matrix");
    gsl_test_abs(c->L[0][BINS - 1], 0.5, 0.03, "long ones are free");
    gsl_test_abs(c->cut[0] + c->cut[1], 0, 0, "no chord is cut");
    chords_free(&c);
  }
  pack_free(&pack);
}

/* Points that wear balls: L of the matrix by the law of N points; the mean of a few packs. */
static void test_points(int dim) {
  Box box = {dim, {9, 11, dim == 3 ? 10 : 0}};
  size_t n = dim == 3 ? 60 : 25;
  int packs = as_many(24, 240);
  double sum[BINS] = {0}, square[BINS] = {0}, matrix = 0, covered = 0, bad = 0, step = 0.1;
  for (int k = 0; k < packs; k++) {
    Pack *pack = balls(&box, n, 1, 40 + (uint64_t)k);
    double fraction, exact[2];
    chords_exact(pack, &fraction, exact);
    gsl_test(dim == 2 ? gsl_isnan(fraction) : !gsl_isnan(fraction), "exact means in the plane only");
    Chords *c = find(pack, 800, step, NULL, fraction);
    for (int b = 0; b < BINS; b++)
      sum[b] += c->L[0][b], square[b] += c->L[0][b] * c->L[0][b];
    matrix += c->mean[0] / exact[0] / packs, covered += c->mean[1] / exact[1] / packs;
    chords_free(&c);
    pack_free(&pack);
  }
  for (int b = 0; b < BINS; b++) {
    double z = (b + 0.5) * step, v = dim == 3 ? M_PI * (4. / 3 + z) : M_PI + 2 * z;
    double law = pow(1 - v / box_volume(&box), (double)n), mean = sum[b] / packs;
    double error = sqrt((square[b] / packs - mean * mean) / (packs - 1));
    bad += fabs(mean - law) > 3.5 * error;
  }
  gsl_test_abs(bad, 0, 0.5, "pieces between points that wear balls, in %d", dim);
  if (dim == 2) {
    gsl_test_abs(matrix, 1, 0.01, "mean chords of the matrix are the exact ones");
    gsl_test_abs(covered, 1, 0.01, "and those of unions of discs");
  }
}

/* Spans of shapes: points of the line at and beside their ends; and of all directions the longest. */
static void test_spans(void) {
  static const double corner[][2] = {{0, 0}, {2, 0}, {1.3, 1.7}};
  Outcome out = {0};
  Shape *shape[] = {shape_regular(5), shape_convex(3, corner, &out), shape_superellipse(1.5, 1.5), shape_superellipse(1, 0.7),
                    shape_superellipse(50, 1), shape_superellipse(5, 50), shape_superellipse(1.2, 1)};
  Box box = {2, {30, 30, 0}};
  Rng rng = rng_stream(4, 0, RNG_TEST);
  for (size_t s = 0; s < sizeof shape / sizeof *shape; s++) {
    Species species = {.name = "A", .radius = 0.8, .count = 1, .shape = shape[s]};
    Pack *pack = pack_alloc(&box, &species, 1, false);
    double width = 2 * 0.8 * shape[s]->outer, worst = 0;
    int wrong = 0, hits = 0, tries = as_many(3000, 30000);
    for (int k = 0; k < tries; k++) {
      double u[2], x[2], c[] = {13, 17}, span[2];
      pack->angle[0] = 2 * M_PI * rng_uniform(&rng);
      rng_direction(&rng, 2, u);
      for (int d = 0; d < 2; d++)
        x[d] = c[d] + width * (rng_uniform(&rng) - 0.5) - 3 * u[d];
      bool hit = chords_span(pack, 0, c, x, u, span);
      double C = cos(pack->angle[0]), S = sin(pack->angle[0]);
      for (int e = 0; hit && e < 2; e++) {
        double dx = x[0] + span[e] * u[0] - c[0], dy = x[1] + span[e] * u[1] - c[1];
        worst = fmax(worst, fabs(shape_gauge(shape[s], (C * dx + S * dy) / 0.8, (C * dy - S * dx) / 0.8) - 1));
      }
      hits += hit;
      for (double t = -2; t < 2 * width + 4; t += 0.01 * width) { /* inside is within the span */
        double dx = x[0] + t * u[0] - c[0], dy = x[1] + t * u[1] - c[1];
        bool in = shape_gauge(shape[s], (C * dx + S * dy) / 0.8, (C * dy - S * dx) / 0.8) < 1 - 1e-9;
        wrong += in && !(hit && t > span[0] && t < span[1]);
      }
    }
    gsl_test(!(worst < 1e-12), "shape %zu: spans end on the boundary: %g", s, worst);
    gsl_test_int(wrong, 0, "and hold all that is inside");
    gsl_test(hits < tries / 20, "they are hit");
    pack_free(&pack);
    shape_free(&shape[s]);
  }
}

/* The covered length of lines against trying every image of every particle; mean chords of shapes that overlap, exactly. */
static void test_shapes(void) {
  Box box = {2, {7, 5, 0}};
  for (int k = 0; k < 3; k++) {
    Species species[] = {{.name = "P", .radius = 0.5, .count = 9, .shape = shape_regular(5)},
                         {.name = "D", .radius = 0.6, .count = 4},
                         {.name = "E", .radius = 0.4, .count = 6, .shape = shape_superellipse(k ? 50 : 1.5, k > 1 ? 2 : 1.5)}};
    Pack *pack = scattered(&box, species, 3, 60 + (uint64_t)k);
    double fraction, exact[2];
    chords_exact(pack, &fraction, exact);
    Chords *c = find(pack, (size_t)as_many(3000, 30000), 0.1, NULL, GSL_NAN);
    double error = 3 / sqrt(c->number[0]);
    gsl_test_rel(c->mean[0], exact[0], error, "shapes that overlap: mean chord of the matrix");
    gsl_test_rel(c->mean[1], exact[1], error, "of particles");
    gsl_test_abs(c->L[1][0] + 0.05 * fraction / exact[1], fraction, 0.02, "and their fraction");
    chords_free(&c);
    pack_free(&pack);
  }
}

/* Every chord of a line by trying all images: no grid, no runs; a narrow box, coincident and large particles. */
static void test_plain(const Box *box, size_t n, double radius, const char *what) {
  Pack *pack = balls(box, n, radius, 7);
  int dim = box->dim;
  memcpy(pack->x + dim, pack->x, (size_t)dim * sizeof(double)); /* two at one place */
  double far = 60, in = 0, u[3] = {0.48, 0.6, 0.64}, pieces = 0;
  if (dim == 2)
    u[0] = 0.6, u[1] = 0.8;
  ChordPlan plan = {.lines = 16, .length = far, .direction = u, .step = 0.1, .bins = BINS, .fraction = GSL_NAN};
  Rng rng = rng_stream(5, 0, RNG_TEST), same = rng;
  Chords *c = chords_find(pack, &plan, &rng);
  for (int line = 0; line < 16; line++) {
    double x[3] = {0}, begin[9000], end[9000], reach = 0;
    int spans = 0, m[3], most[3] = {0};
    for (int k = 0; k < dim; k++)
      x[k] = box->side[k] * rng_uniform(&same), most[k] = (int)((far + 20 + radius) * u[k] / box->side[k] + radius / box->side[k]) + 2;
    for (size_t i = 0; i < n; i++)
      for (m[0] = -3; m[0] <= most[0]; m[0]++)
        for (m[1] = -3; m[1] <= most[1]; m[1]++)
          for (m[2] = dim == 3 ? -3 : 0; m[2] <= (dim == 3 ? most[2] : 0); m[2]++) {
            double at[3] = {0}, span[2];
            for (int k = 0; k < dim; k++)
              at[k] = pack->x[i * (size_t)dim + (size_t)k] + m[k] * box->side[k];
            if (chords_span(pack, i, at, x, u, span) && span[1] > 0 && span[0] < far + 20 && spans < 9000)
              begin[spans] = span[0], end[spans++] = span[1];
          }
    for (;;) { /* runs from the left: what begins first among those that end beyond the reach so far */
      int next = -1;
      for (int s = 0; s < spans; s++)
        if (end[s] > reach && (next < 0 || begin[s] < begin[next]))
          next = s;
      if (next < 0 || begin[next] >= far)
        break;
      double from = begin[next], to = end[next];
      for (int grown = 1; grown;)
        for (int s = grown = 0; s < spans; s++)
          if (begin[s] <= to && end[s] > to)
            to = end[s], grown = 1;
      if (from > 0) {
        pieces++;
        in += to - from;
      }
      reach = to;
    }
  }
  gsl_test_abs(c->number[1], pieces, 0, "%s: chords by all images", what);
  gsl_test_rel(c->mean[1] * c->number[1], in, 1e-10, "and their lengths");
  chords_free(&c);
  pack_free(&pack);
}

/* Spheres of a lattice: the exact means, and those of the lines. No particle; a box that is covered. */
static void test_hard(void) {
  Box box = {3, {6, 9, 6}}, small = {2, {1.2, 1.1, 0}};
  Species species = {.name = "A", .radius = 1.4, .count = 12};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  double fraction, exact[2];
  for (int i = 0; i < 12; i++)
    pack->x[3 * i] = 3 * (i % 2) + 0.2, pack->x[3 * i + 1] = 3 * (i / 2 % 3) + 0.4, pack->x[3 * i + 2] = 3 * (i / 6) + 1.9;
  chords_exact(pack, &fraction, exact);
  gsl_test_rel(fraction, 12 * pack_ball(3, 1.4) / 324, 1e-14, "hard spheres: fraction");
  gsl_test_rel(exact[0], 4 * (1 - fraction) * 324 / (12 * 4 * M_PI * 1.96), 1e-14, "mean chord between them");
  Chords *c = find(pack, (size_t)as_many(3000, 30000), 0.1, NULL, fraction);
  gsl_test_rel(c->mean[0], exact[0], 4 / sqrt(c->number[0]), "as the lines have it");
  gsl_test_rel(c->mean[1], exact[1], 2 / sqrt(c->number[1]), "and in them");
  chords_free(&c);
  pack->x[3] = 1.9; /* now two overlap */
  chords_exact(pack, &fraction, exact);
  gsl_test(!gsl_isnan(exact[0]), "of spheres that overlap nothing is told");
  pack_free(&pack);
  pack = balls(&box, 0, 1, 1);
  c = find(pack, 100, 0.1, NULL, 0);
  gsl_test(c != NULL, "no particle, no chords");
  pack_free(&pack);
  pack = balls(&small, 1, 3, 1);
  c = find(pack, 100, 0.1, NULL, 1);
  gsl_test_abs(c->free[1], 1, 0, "a covered box: all lines are free");
  gsl_test_abs(c->L[1][BINS - 1], 1, 0, "and all pieces are in particles");
  gsl_test_abs(c->L[0][0], 0, 0, "and none in the matrix");
  gsl_test(!gsl_isnan(c->p[0][0]) || !gsl_isnan(c->mean[1]), "and there are no chords");
  chords_free(&c);
  pack_free(&pack);
}

/* The length of lines follows the exact means, and has an end as the last of the matrix is covered; with it the time. */
static void test_length(void) {
  Box box = {2, {9, 9, 0}};
  double fraction, exact[2];
  static const size_t many[] = {3, 60, 230};
  for (int k = 0; k < 3; k++) {
    Pack *pack = balls(&box, many[k], 1, 3);
    double ten = 10 * M_PI * 81 / ((double)many[k] * 2 * M_PI), length;
    chords_exact(pack, &fraction, exact);
    length = chords_length(pack, exact);
    gsl_test(!(length <= 100 * ten * (1 + 1e-12)), "%zu discs: lines are %g long, a hundred times %g at most", many[k], length, ten);
    if (k < 2)
      gsl_test_rel(length, 10 * (exact[0] + exact[1]), 1e-14, "%zu discs: as long as ten chords of each phase", many[k]);
    else
      gsl_test(!(fraction == 1 || exact[0] + exact[1] > 10 * ten), "few places are left: %g, chords %g", 1 - fraction, exact[1]);
    pack_free(&pack);
  }
  Pack *full = balls(&box, 900, 1, 3), *none = balls(&box, 0, 1, 3);
  chords_exact(full, &fraction, exact);
  gsl_test_abs(fraction, 1, 1e-14, "a covered box");
  gsl_test(!gsl_isnan(exact[0]) || !gsl_isnan(exact[1]), "a covered box has no mean chords: %g %g", exact[0], exact[1]);
  gsl_test(!(chords_length(full, exact) <= 100 * 10 * M_PI * 81 / (900 * 2 * M_PI)), "and lines of a length");
  chords_exact(none, &fraction, exact);
  gsl_test(!gsl_isnan(exact[0]) || !gsl_isnan(exact[1]), "nor has an empty one: %g %g", exact[0], exact[1]);
  pack_free(&full);
  pack_free(&none);
}

int main(void) {
  test_length();
  static const Box square = {2, {4.7, 3.9, 0}}, cube = {3, {3.1, 3.7, 4.1}}, narrow = {2, {1.1, 40, 0}};
  static const Box wide = {2, {15, 9, 0}}, slab = {3, {7, 5, 9}};
  test_ball(2, 0.9, &square);
  test_ball(3, 1.1, &cube);
  test_lattice();
  test_points(2);
  test_points(3);
  test_spans();
  test_shapes();
  test_plain(&wide, 20, 0.8, "discs");
  test_plain(&narrow, 12, 0.9, "a narrow box");
  test_plain(&slab, 30, 0.9, "balls");
  test_plain(&cube, 3, 0.2, "few");
  test_hard();
  exit(gsl_test_summary());
}
