/* tests/test_turning.c: moves and turns against a slow program with the same random numbers, against configurations
   by rejection, and against what growth may do */
#include "cells.h"
#include "elementary.h"
#include "many.h"
#include "overlap.h"
#include "touch.h"
#include "turning.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static const double cube[2] = {1, 1};

static Pack *pack_of(const Box *box, Shape *shape[], const size_t n[], const double radius[], int kinds, bool own) {
  Species s[4] = {{.name = "A"}, {.name = "B"}, {.name = "C"}, {.name = "D"}};
  for (int k = 0; k < kinds; k++) {
    s[k].shape = shape[k];
    s[k].count = n[k];
    s[k].radius = radius[k];
  }
  return pack_alloc(box, s, kinds, own);
}

/* ------------------------------------------------------------ all pairs, all images */
static bool clear(const Pack *pack, size_t i, size_t j, const double p[4], const double q[4], double size) {
  int copies = pack->box.side[0] < 12 ? 3 : 1;
  for (int a = -copies; a <= copies; a++)
    for (int b = -copies; b <= copies; b++) {
      if (i == j && a == 0 && b == 0)
        continue;
      double dx = q[0] - p[0] - pack->box.side[0] * floor((q[0] - p[0]) / pack->box.side[0] + .5);
      double dy = q[1] - p[1] - pack->box.side[1] * floor((q[1] - p[1]) / pack->box.side[1] + .5);
      Body A = {pack->species[pack_kind(pack, i)].shape, size * pack_radius(pack, i), 0, 0, p[2], p[3]};
      Body B = {pack->species[pack_kind(pack, j)].shape, size * pack_radius(pack, j), dx + a * pack->box.side[0],
                dy + b * pack->box.side[1], q[2], q[3]};
      double far = (A.shape ? A.shape->outer : 1) * A.radius + (B.shape ? B.shape->outer : 1) * B.radius;
      if (B.x * B.x + B.y * B.y <= far * far * 1.000001 && overlap_verdict(&A, &B, NULL) != OVERLAP_APART)
        return false;
    }
  return true;
}

static bool is_free(const Pack *pack, double (*at)[4], size_t i, const double p[4], double size) {
  for (size_t j = 0; j < pack->n; j++)
    if (!clear(pack, i, j, p, i == j ? p : at[j], size))
      return false;
  return true;
}

static double even(Rng *rng) { return 2 * rng_uniform(rng) - 1; }

static double (*records(const Pack *pack))[4] {
  double(*at)[4] = memory(pack->n, sizeof *at);
  for (size_t i = 0; i < pack->n; i++) {
    at[i][0] = pack->x[2 * i];
    at[i][1] = pack->x[2 * i + 1];
    elementary_turn(pack->angle ? pack->angle[i] : 0, &at[i][2], &at[i][3]);
  }
  return at;
}

/* Sweeps in the order of the cells: 64 points, then 64 turns, are drawn ahead. */
static void plain_sweep(Pack *pack, double (*at)[4], double (*gone)[2], const TurningPlan *plan, Rng *rng,
                        TurningReport *report) {
  double points[64][2], turns[64];
  Cells *cells = cells_alloc(pack, 2 * pack_largest(pack));
  double half = tan(plan->turn / 2);
  for (size_t first = 0; first < pack->n; first += 64) {
    size_t count = GSL_MIN(64, pack->n - first);
    for (size_t c = 0; c < count; c++)
      do {
        points[c][0] = even(rng);
        points[c][1] = even(rng);
      } while (gsl_hypot(points[c][0], points[c][1]) > 1);
    for (size_t c = 0; c < count; c++)
      turns[c] = 2 * atan(half * even(rng));
    for (size_t c = 0; c < count; c++) {
      size_t i = cells->particle[first + c];
      double w = plan->radius * pack_radius(pack, i), angle = atan2(at[i][3], at[i][2]) + turns[c];
      double p[4] = {at[i][0] + w * points[c][0], at[i][1] + w * points[c][1], cos(angle), sin(angle)};
      report->trials++;
      if (!is_free(pack, at, i, p, plan->size))
        continue;
      memcpy(at[i], p, sizeof p);
      gone[i][0] += w * points[c][0];
      gone[i][1] += w * points[c][1];
      report->moved++;
    }
  }
  cells_free(&cells);
}

/* A pack without overlap: each where it has room, as bodies of this size. */
static void scatter(Pack *pack, double size, Rng *rng) {
  double(*at)[4] = memory(pack->n, sizeof *at);
  for (size_t i = 0; i < pack->n; i++)
    for (bool fits = false; !fits;) {
      double angle = 2 * M_PI * rng_uniform(rng);
      at[i][0] = rng_uniform(rng) * pack->box.side[0];
      at[i][1] = rng_uniform(rng) * pack->box.side[1];
      elementary_turn(angle, &at[i][2], &at[i][3]);
      fits = true;
      for (size_t j = 0; j <= i && fits; j++)
        fits = clear(pack, i, j, at[i], at[j], size);
      memcpy(pack->x + 2 * i, at[i], 2 * sizeof *pack->x);
      if (pack->angle)
        pack->angle[i] = angle;
    }
  free(at);
}

typedef struct {
  const char *what;
  int sides[3]; /* 0: the superellipse of 1.5 and 1.5; 1: a disc; 2: a needle */
  size_t n[3];
  double radius[3], fraction, move, turn;
  int sweeps;
} Case;

static Shape *shape_of(int sides) {
  return sides == 0 ? shape_superellipse(1.5, 1.5)
         : sides == 1 ? NULL
         : sides == 2 ? shape_superellipse(6, 4)
                      : shape_regular(sides);
}

static Pack *pack_for(const Case *c, bool own, Rng *rng) {
  Shape *shape[3] = {NULL, NULL, NULL};
  int kinds = c->n[2] ? 3 : c->n[1] ? 2 : 1;
  double solid = 0;
  for (int k = 0; k < kinds; k++) {
    shape[k] = shape_of(c->sides[k]);
    solid += (double)c->n[k] * pack_ball(2, c->radius[k]);
  }
  Box box = box_make(2, cube, solid / c->fraction);
  Pack *pack = pack_of(&box, shape, c->n, c->radius, kinds, own);
  for (int k = 0; k < kinds; k++)
    shape_free(&shape[k]);
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] *= .5 + .5 * rng_uniform(rng);
  scatter(pack, 1, rng);
  return pack;
}

static double farthest(const Pack *pack, double (*at)[4]) {
  double most = 0;
  for (size_t i = 0; i < pack->n; i++) {
    for (int k = 0; k < 2; k++)
      most = GSL_MAX(most, fabs(box_nearest(box_wrap(at[i][k], pack->box.side[k]) - pack->x[2 * i + (size_t)k],
                                            pack->box.side[k])));
    if (pack->angle)
      most = GSL_MAX(most, gsl_hypot(at[i][2] - cos(pack->angle[i]), at[i][3] - sin(pack->angle[i])));
  }
  return most;
}

static double spread(double (*gone)[2], size_t n) {
  double square = 0, mean[2] = {0, 0};
  for (size_t i = 0; i < n; i++)
    for (int k = 0; k < 2; k++)
      mean[k] += gone[i][k] / (double)n;
  for (size_t i = 0; i < n; i++)
    square += (gsl_pow_2(gone[i][0] - mean[0]) + gsl_pow_2(gone[i][1] - mean[1])) / (double)n;
  return square;
}

static void test_plain(const Case *c, bool own, uint64_t seed) {
  Rng rng = rng_stream(seed, 0, RNG_TEST), same;
  Pack *pack = pack_for(c, own, &rng);
  double(*at)[4] = records(pack), (*gone)[2] = memory(pack->n, sizeof *gone);
  TurningPlan plan = {c->move, c->turn, 1};
  TurningReport report = {0}, slow = {0};
  Outcome out = {0};
  Turning *turning = turning_alloc(pack, &plan, &out);
  gsl_test(!turning, "%s: readied: %s", c->what, out.text);
  same = rng;
  int sweeps = as_many(c->sweeps, 3 * c->sweeps);
  for (int s = 0; s < sweeps; s++)
    plain_sweep(pack, at, gone, &plan, &same, &slow);
  turning_sweeps(turning, (uint64_t)sweeps / 2, &rng, &report);
  turning_sweeps(turning, (uint64_t)(sweeps - sweeps / 2), &rng, &report);
  turning_store(turning, pack);
  gsl_test(report.trials != slow.trials || report.moved != slow.moved, "%s: of %lu trials %lu moved (%lu)", c->what,
           (unsigned long)report.trials, (unsigned long)report.moved, (unsigned long)slow.moved);
  gsl_test(report.moved < slow.trials / 20 || report.moved > slow.trials * 19 / 20, "%s: some are refused", c->what);
  gsl_test(farthest(pack, at) > 1e-9, "%s: as all pairs have it: %g", c->what, farthest(pack, at));
  gsl_test_rel(turning_wandered(turning), spread(gone, pack->n), 1e-9, "%s: wandered", c->what);
  gsl_test(!(touch_least_gap(pack) > 0), "%s: nothing overlaps: %g", c->what, touch_least_gap(pack));
  free(at);
  free(gone);
  turning_free(&turning);
  pack_free(&pack);
}

static void test_all_pairs(void) {
  static const Case cases[] = {
      {"pentagons", {5}, {170}, {1}, .42, .3, .4, 12},
      {"pentagons of all sizes", {5}, {170}, {1}, .25, .4, .4, 8},
      {"squares and discs", {4, 1}, {100, 60}, {1, .7}, .4, .4, .6, 8},
      {"superellipses", {0}, {150}, {1.3}, .42, .3, .3, 6},
      {"three kinds", {0, 5, 1}, {60, 60, 60}, {1, 1, .8}, .42, .3, 1, 6},
      {"few of three kinds", {3, 0, 1}, {2, 2, 2}, {1, 1, .8}, .3, .6, 2, 60},
      {"two pentagons", {5}, {2}, {1}, .3, 1.5, 2.9, 200},
      {"one square", {4}, {1}, {1}, .7, .4, .3, 200},
      {"a needle in a narrow box", {2}, {1}, {1}, .5, .4, .3, 200},
      {"discs", {1}, {150}, {1}, .4, .3, 0, 16}};
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
    test_plain(cases + c, c == 1, 80 + c);
}

/* ------------------------------------------------------------ two shapes in a box, by rejection */
enum { BINS = 6, CELLS_2 = BINS * BINS };

static int bin_of(const double x[4], const double angle[2], double side, double symmetry) {
  double dx = box_nearest(x[2] - x[0], side), dy = box_nearest(x[3] - x[1], side);
  double r = (dx * dx + dy * dy) / (side * side / 2);
  double turn = (angle[1] - angle[0]) / symmetry, part = turn - floor(turn);
  return GSL_MIN(BINS - 1, (int)(BINS * r)) * BINS + GSL_MIN(BINS - 1, (int)(BINS * part));
}

static void test_two(int sides, double side, double symmetry) {
  Rng rng = rng_stream(91, (uint64_t)sides, RNG_TEST);
  Shape *shape = shape_of(sides);
  Box box = {2, {side, side, 0}};
  size_t n = 2;
  double radius = 1, count[2][CELLS_2] = {{0}}, total[2] = {0, 0}, square = 0;
  Pack *pack = pack_of(&box, &shape, &n, &radius, 1, false);
  int samples = as_many(3000, 100000), filled = 0;
  for (int s = 0; s < samples; s++) {
    for (bool fits = false; !fits;) {
      double at[2][4], angle[2];
      for (int i = 0; i < 2; i++) {
        angle[i] = 2 * M_PI * rng_uniform(&rng);
        for (int k = 0; k < 2; k++)
          at[i][k] = side * rng_uniform(&rng);
        elementary_turn(angle[i], &at[i][2], &at[i][3]);
      }
      fits = clear(pack, 0, 1, at[0], at[1], 1);
      double x[4] = {at[0][0], at[0][1], at[1][0], at[1][1]};
      count[0][bin_of(x, angle, side, symmetry)] += fits;
    }
    total[0]++;
  }
  scatter(pack, 1, &rng);
  Outcome out = {0};
  TurningPlan plan = {1.2, 1.2, 1};
  TurningReport report = {0};
  Turning *turning = turning_alloc(pack, &plan, &out);
  for (int s = 0; s < samples; s++, total[1]++) {
    turning_sweeps(turning, 25, &rng, &report);
    turning_store(turning, pack);
    count[1][bin_of(pack->x, pack->angle, side, symmetry)]++;
  }
  for (int c = 0; c < CELLS_2; c++) {
    filled += count[0][c] + count[1][c] > 0;
    if (count[0][c] + count[1][c] > 0)
      square += gsl_pow_2(count[0][c] - count[1][c]) / (count[0][c] + count[1][c]);
  }
  double errors = (square - (filled - 1)) / sqrt(2. * (filled - 1));
  gsl_test(filled < 15 || fabs(errors) > 4, "two of shape %d as by rejection: chi^2 %.4g of %d, %.2g errors off", sides,
           square, filled - 1, errors);
  turning_free(&turning);
  pack_free(&pack);
  shape_free(&shape);
}

/* A rod longer than the box is wide: it is apart from its images where w < L |sin|. */
static void test_rod(void) {
  static const double corner[4][2] = {{2.25, .35}, {-2.25, .35}, {-2.25, -.35}, {2.25, -.35}};
  Outcome out = {0};
  Shape *rod = shape_convex(4, corner, &out);
  Box box = {2, {3, 20, 0}};
  size_t n = 1;
  double radius = 1, least = asin(2 * rod->h[0] / 3), in[8] = {0}, square = 0;
  for (int k = 1; k < 4; k++)
    least = GSL_MIN(least, asin(GSL_MIN(1, 2 * rod->h[k] / 3)));
  Pack *pack = pack_of(&box, &rod, &n, &radius, 1, false);
  pack->angle[0] = 1;
  TurningPlan plan = {.5, 1.5, 1};
  TurningReport report = {0};
  Rng rng = rng_stream(92, 0, RNG_TEST);
  Turning *turning = turning_alloc(pack, &plan, &out);
  int samples = as_many(2000, 40000), outside = 0;
  for (int s = 0; s < samples; s++) {
    turning_sweeps(turning, 12, &rng, &report);
    turning_store(turning, pack);
    double angle = fmod(pack->angle[0], M_PI), part = (angle - least) / (M_PI - 2 * least);
    outside += part < 0 || part >= 1;
    in[GSL_MAX(0, GSL_MIN(7, (int)floor(8 * part)))]++;
  }
  for (int b = 0; b < 8; b++)
    square += gsl_pow_2(in[b] - samples / 8.) / (samples / 8.);
  gsl_test_int(outside, 0, "a rod does not meet its images");
  gsl_test(fabs(square - 7) > 4 * sqrt(14), "and has all other angles equally often: chi^2 %.4g of 7", square);
  turning_free(&turning);
  pack_free(&pack);
  shape_free(&rod);
}

/* ------------------------------------------------------------ growth */
static void test_growth(void) {
  static const Case cases[] = {{"pentagons", {5}, {14}, {1}, .6, 0, 0, 0},
                               {"three kinds", {3, 0, 1}, {4, 4, 4}, {1, 1.2, .8}, .6, 0, 0, 0},
                               {"superellipses", {0}, {9}, {1}, .6, 0, 0, 0},
                               {"a needle", {2}, {1}, {1}, .9, 0, 0, 0}};
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
    for (uint64_t seed = 0; seed < 2; seed++) {
      Rng rng = rng_stream(93 + seed, c, RNG_TEST);
      Case sparse = cases[c];
      sparse.fraction = .03;
      Pack *pack = pack_for(&sparse, false, &rng);
      double shrink = sqrt(sparse.fraction / cases[c].fraction), low = .2, high = 1;
      for (int k = 0; k < 2; k++)
        pack->box.side[k] *= shrink;
      for (size_t i = 0; i < 2 * pack->n; i++)
        pack->x[i] *= shrink;
      scatter(pack, low, &rng);
      double(*at)[4] = records(pack);
      TurningPlan plan = {.1, .1, low};
      Outcome out = {0};
      Turning *turning = turning_alloc(pack, &plan, &out);
      double size = turning_grow(turning);
      for (int halving = 0; halving < 45; halving++) {
        double middle = (low + high) / 2;
        bool fits = true;
        for (size_t i = 0; i < pack->n && fits; i++)
          fits = is_free(pack, at, i, at[i], middle);
        *(fits ? &low : &high) = middle;
      }
      double part = (size - plan.size) / (low - plan.size);
      gsl_test(!(part <= 1 + 1e-9 && part > 63. / 64 - 1e-9), "%s grow to %.6g of what is possible, %.6g",
               cases[c].what, part, low);
      free(at);
      turning_free(&turning);
      pack_free(&pack);
    }
}

/* The mean growth that is possible in a fluid of discs follows from its pressure, (compression:step). */
static void test_pressure(void) {
  Case fluid = {"discs", {1}, {100}, {1}, .3, 0, 0, 0};
  Rng rng = rng_stream(97, 0, RNG_TEST);
  Pack *pack = pack_for(&fluid, false, &rng);
  double sum = 0, Z = (1 + .3 * .3 / 8) / gsl_pow_2(.7), n = (double)pack->n;
  pack->species[0].radius /= .9;
  TurningPlan plan = {.8, 0, .9};
  TurningReport report = {0};
  Outcome out = {0};
  int samples = as_many(400, 6000);
  for (int s = -10; s < samples; s++) {
    Turning *turning = turning_alloc(pack, &plan, &out);
    turning_sweeps(turning, 3, &rng, &report);
    turning_store(turning, pack);
    if (s >= 0)
      sum += log(turning_grow(turning) / plan.size);
    turning_free(&turning);
  }
  double mean = 2 * n * (Z - 1) * sum / samples;
  gsl_test(fabs(mean - 1) > 4 / sqrt(samples), "growth of a fluid of discs: %.4g of 1/2N(Z - 1)", mean);
  pack_free(&pack);
}

/* ------------------------------------------------------------ what is let in */
static Pack *tiles(double gap) {
  Shape *square = shape_regular(4);
  size_t n = 16;
  double radius = 1, side = sqrt(M_PI);
  Box box = {2, {4 * side * (1 + gap), 4 * side * (1 + gap), 0}};
  Pack *pack = pack_of(&box, &square, &n, &radius, 1, false);
  for (size_t i = 0; i < n; i++) {
    pack->x[2 * i] = (double)(i % 4) * side * (1 + gap);
    pack->x[2 * i + 1] = (double)(i / 4) * side * (1 + gap);
    pack->angle[i] = M_PI / 4;
  }
  shape_free(&square);
  return pack;
}

static void test_let_in(void) {
  static const double gap[] = {1e-3, 0, -1e-12, -3e-10, -1e-8, -.1};
  for (int g = 0; g < 6; g++) {
    Pack *pack = tiles(gap[g]);
    TurningPlan plan = {1e-9, 1e-9, 1};
    TurningReport report = {0};
    Outcome out = {0};
    Rng rng = rng_stream(98, 0, RNG_TEST);
    Turning *turning = turning_alloc(pack, &plan, &out);
    gsl_test(turning ? g >= 4 : g < 4 || out.status != WRONG, "tiles with a gap of %g of a side", gap[g]);
    if (turning) {
      turning_sweeps(turning, 50, &rng, &report);
      turning_store(turning, pack);
      gsl_test(touch_least_gap(pack) < GSL_MIN(0, 8 * gap[g]) - 1e-11, "and they stay as near: %g",
               touch_least_gap(pack));
    }
    turning_free(&turning);
    pack_free(&pack);
  }
  Shape *none = NULL;
  size_t n = 0;
  double radius = 1;
  Box box = box_make(2, cube, 3);
  Pack *pack = pack_of(&box, &none, &n, &radius, 1, false);
  TurningPlan plan = {.1, .1, 1};
  TurningReport report = {0};
  Outcome out = {0};
  Rng rng = rng_stream(99, 0, RNG_TEST);
  Turning *turning = turning_alloc(pack, &plan, &out);
  turning_sweeps(turning, 3, &rng, &report);
  turning_store(turning, pack);
  gsl_test(report.trials != 0 || turning_grow(turning) != 1 || turning_wandered(turning) != 0, "nothing to turn");
  turning_free(&turning);
  turning_free(&turning);
  pack_free(&pack);
}

/* Shorter steps are those of a plan with shorter steps. */
static void test_steps(void) {
  Case c = {"pentagons", {5}, {170}, {1}, .42, 1, .8, 0};
  Rng rng = rng_stream(100, 0, RNG_TEST);
  Pack *pack = pack_for(&c, false, &rng), *twin = pack_copy(pack);
  TurningPlan plan = {1, 1, 1}, less = {.25, .25, 1};
  TurningReport report[2] = {{0}, {0}};
  Outcome out = {0};
  Turning *a = turning_alloc(pack, &plan, &out), *b = turning_alloc(twin, &less, &out);
  turning_steps(a, .6);
  turning_steps(a, .25);
  Rng one = rng, two = rng;
  turning_sweeps(a, 20, &one, report);
  turning_sweeps(b, 20, &two, report + 1);
  turning_store(a, pack);
  turning_store(b, twin);
  gsl_test(report[0].moved != report[1].moved || memcmp(pack->x, twin->x, 340 * sizeof(double)) != 0,
           "a part of the steps");
  turning_free(&a);
  turning_free(&b);
  pack_free(&pack);
  pack_free(&twin);
}

int main(void) {
  test_all_pairs();
  test_two(5, 4, 2 * M_PI / 5);
  test_two(0, 4.2, M_PI);
  test_rod();
  test_growth();
  test_pressure();
  test_let_in();
  test_steps();
  return gsl_test_summary();
}
