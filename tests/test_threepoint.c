/* tests/test_threepoint.c: identities bit for bit, exact laws, errors, and two packs that only three points tell apart */
#include "cover.h"
#include "elementary.h"
#include "homometric.h"
#include "many.h"
#include "outcome.h"
#include "penetrable.h"
#include "points.h"
#include "threepoint.h"
#include "twopoint.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static Pack *discs(size_t n, double radius, double a, double b, Shape *shape) {
  Species species = {.name = "P", .radius = radius, .count = n, .shape = shape};
  Box box = {2, {a, b, 0}};
  return pack_alloc(&box, &species, 1, false);
}

/* The part of the box that a grain shares with itself shifted by r1 and r2, or that all three cover, a mean over directions. */
static double three(const Pack *pack, double r1, double r2, double theta, int turns, bool united) {
  Body first = pack_body(pack, 0);
  double sum = 0, one = cover_area(&first, 1, &pack->box, NULL);
  for (int t = 0; t < turns; t++) {
    double alpha = 2 * M_PI * (t + 0.5) / turns, c, s, area[8];
    Body body[3] = {pack_body(pack, 0), pack_body(pack, 0), pack_body(pack, 0)};
    elementary_turn(alpha, &c, &s);
    body[1].x -= r1 * c, body[1].y -= r1 * s;
    elementary_turn(alpha + theta * M_PI / 180, &c, &s);
    body[2].x -= r2 * c, body[2].y -= r2 * s;
    for (int k = 0; k < 3; k++)
      body[k].x = box_wrap(body[k].x, pack->box.side[0]), body[k].y = box_wrap(body[k].y, pack->box.side[1]);
    for (unsigned set = united ? 7 : 3; set < 8; set += set == 3 ? 2 : 1) {
      Body of[3];
      size_t n = 0;
      for (unsigned k = 0; k < 3; k++)
        if (set >> k & 1)
          of[n++] = body[k];
      area[set] = cover_area(of, n, &pack->box, NULL);
    }
    sum += united ? area[7] : 3 * one - area[3] - area[5] - area[6] + area[7];
  }
  return sum / turns / box_volume(&pack->box);
}

static double at(const Threepoint *found, int arms, int t, int i, int j) {
  return found->S3[((size_t)t * (size_t)arms + (size_t)i) * (size_t)arms + (size_t)j];
}

/* One particle: the area that three shifted copies share. Arms may be longer than the box. */
static void test_one(void) {
  Shape *square = shape_regular(4), *needle = shape_superellipse(5, 2);
  static const double theta[] = {0, 127, 180};
  const struct {
    const char *what;
    double a, b, step;
    Shape *shape;
    int turns;
  } cases[] = {{"a disc", 5.3, 4.7, 0.31, NULL, 1},
               {"a disc in a box that arms leave", 2.9, 3.1, 0.93, NULL, 150},
               {"a square", 5.3, 4.7, 0.31, square, 100},
               {"a needle wider than the box", 4.1, 3.7, 0.77, needle, 150}};
  enum { ARMS = 7, CHECKED = 8 };
  static const int checked[CHECKED][3] = {{0, 2, 6}, {1, 3, 0}, {1, 2, 3}, {1, 5, 4}, {1, 6, 6}, {2, 1, 1}, {2, 2, 3}, {2, 6, 5}};
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
    double exact[CHECKED];
    for (int method = 0; method < 2; method++) {
      Pack *pack = discs(1, 1, cases[c].a, cases[c].b, cases[c].shape);
      Rng rng = rng_stream(51, c, RNG_TEST);
      points_scatter(pack, &rng);
      ThreepointPlan plan = {ARMS, cases[c].step, 3, theta, false, as_many(1 << 15, 1 << 20), 0, 0};
      Threepoint *found = (method ? threepoint_triangles : threepoint_shared)(pack, &plan, &rng);
      double most = 0;
      for (int k = 0; k < CHECKED; k++) {
        const int *cell = checked[k];
        if (method == 0)
          exact[k] = three(pack, cell[1] * plan.step, cell[2] * plan.step, theta[cell[0]], as_many(cases[c].turns, 20 * cases[c].turns), false);
        most = GSL_MAX(most, fabs(at(found, ARMS, cell[0], cell[1], cell[2]) - exact[k]));
      }
      gsl_test(most > 5 * found->rms, "%s, %s: off by %g, errors %g", cases[c].what, method ? "triangles" : "shared", most, found->rms);
      gsl_test(found->rms > 1.2 * sqrt(0.25 / found->samples) || found->rms < 0.03 * sqrt(0.25 / found->samples), "%s: errors %g", cases[c].what, found->rms);
      threepoint_free(&found);
      pack_free(&pack);
    }
  }
  shape_free(&square);
  shape_free(&needle);
}

/* N discs thrown: the matrix has (1 - A3/V)^N, the particles what follows by inclusion and exclusion. */
static void test_penetrable(void) {
  enum { ARMS = 4, N = 9, CELLS = ARMS * ARMS };
  static const double theta[] = {50};
  int packs = as_many(150, 3000);
  Pack *pack = discs(N, 1, 6.1, 5.9, NULL);
  Rng rng = rng_stream(52, 0, RNG_TEST);
  ThreepointPlan plan = {ARMS, 0.63, 1, theta, false, 2048, 0, 0};
  double sum[2][CELLS] = {{0}}, square[2][CELLS] = {{0}}, far[2] = {0};
  for (int k = 0; k < packs; k++) {
    penetrable_throw(pack, false, &rng);
    for (int m = 0; m < 2; m++) {
      plan.matrix = m;
      Threepoint *found = threepoint_shared(pack, &plan, &rng);
      for (int c = 0; c < CELLS; c++)
        sum[m][c] += found->S3[c], square[m][c] += found->S3[c] * found->S3[c];
      threepoint_free(&found);
    }
  }
  double none = pow(1 - M_PI / box_volume(&pack->box), N);
  for (int c = 0; c < CELLS; c++) {
    double r1 = c / ARMS * plan.step, r2 = c % ARMS * plan.step, two[3], exact[2];
    double r3 = sqrt(r1 * r1 + r2 * r2 - 2 * r1 * r2 * cos(theta[0] * M_PI / 180)), all = pow(1 - three(pack, r1, r2, theta[0], 1, true), N);
    const double r[3] = {r1, r2, r3};
    for (int k = 0; k < 3; k++)
      two[k] = pow(1 - three(pack, r[k], 0, 0, 1, true), N);
    exact[1] = all;
    exact[0] = 1 - 3 * none + two[0] + two[1] + two[2] - all;
    for (int m = 0; m < 2; m++) {
      double mean = sum[m][c] / packs, error = sqrt((square[m][c] / packs - mean * mean) / (packs - 1));
      far[m] = GSL_MAX(far[m], fabs(mean - exact[m]) / error);
    }
  }
  gsl_test(far[0] > 4, "penetrable discs, particles: %.2f standard errors", far[0]);
  gsl_test(far[1] > 4, "penetrable discs, matrix: %.2f standard errors", far[1]);
  pack_free(&pack);
}

/* A pack of 40 random squares, or of balls: identities that hold to the last bit, and triangles with another corner first. */
static void test_identities(void) {
  static const double theta[] = {0, 90, 53.13010235415598};
  Shape *four = shape_regular(4);
  for (int dim = 2; dim <= 3; dim++) {
    enum { ARMS = 6 };
    Species species = {.name = "P", .radius = dim == 2 ? 0.9 : 1.2, .count = 40, .shape = dim == 2 ? four : NULL};
    Box box = {dim, {11, 12, 6 * (dim - 2)}};
    Pack *pack = pack_alloc(&box, &species, 1, false);
    Rng rng = rng_stream(53, (uint64_t)dim, RNG_TEST);
    points_scatter(pack, &rng);
    points_turn(pack, &rng);
    ThreepointPlan plan = {ARMS, 0.37, 3, theta, false, as_many(100000, 1 << 20), 0, 0};
    Threepoint *found = threepoint_shared(pack, &plan, &rng);
    int differ = 0;
    for (int i = 0; i < ARMS; i++) {
      differ += at(found, ARMS, 0, i, i) != at(found, ARMS, 0, 0, i) || at(found, ARMS, 0, i, 0) != at(found, ARMS, 0, 0, i);
      for (int t = 1; t < 3; t++)
        differ += at(found, ARMS, t, i, 0) != at(found, ARMS, 0, i, 0) || at(found, ARMS, t, 0, 0) != at(found, ARMS, 0, 0, 0);
      for (int j = 0; j < ARMS; j++)
        differ += at(found, ARMS, 0, i, j) != at(found, ARMS, 0, j, i);
    }
    gsl_test_int(differ, 0, "identities to the last bit, %d-D", dim);
    gsl_test_abs(at(found, ARMS, 1, 3, 4), at(found, ARMS, 2, 3, 5), 6 * found->rms, "3, 4, 5 from two corners, %d-D", dim);
    gsl_test_abs(at(found, ARMS, 1, 0, 4), at(found, ARMS, 1, 4, 0), 6 * found->rms, "both edges, %d-D", dim);
    gsl_test_abs(found->samples, ceil(plan.samples / 8) * 8, 0, "samples, %d-D", dim);
    threepoint_free(&found);
    pack_free(&pack);
  }
  shape_free(&four);
}

/* Where two of the three points are one, S3 is S2 of the same pack: an arm of 0, or two arms alike in one direction. With r1 = r2 = 0 it is the fraction. */
static void test_two(void) {
  enum { ARMS = 9 };
  static const double theta[] = {0, 77};
  Shape *shapes[] = {shape_superellipse(2.2, 1.5), shape_regular(5), NULL};
  for (int c = 0; c < 6; c++) {
    int dim = c < 5 ? 2 : 3;
    bool matrix = c > 2 && c < 5;
    Species species = {.name = "P", .radius = 1.1, .count = dim == 2 ? 14 : 1, .shape = shapes[c % 3]};
    Box box = {dim, {7.3, 8.1, 5.9 * (dim - 2)}};
    Pack *pack = pack_alloc(&box, &species, 1, false);
    Rng rng = rng_stream(58, (uint64_t)c, RNG_TEST);
    points_scatter(pack, &rng);
    points_turn(pack, &rng);
    ThreepointPlan plan = {ARMS, 0.47, 2, theta, matrix, as_many(1 << 17, 1 << 21), 0, 0};
    Outcome out = {0};
    Twopoint *two = twopoint_exact(pack, plan.step, ARMS, false, 1e-5, &out);
    for (int method = 0; method < 2; method++) {
      Threepoint *found = (method ? threepoint_triangles : threepoint_shared)(pack, &plan, &rng);
      double most = 0;
      for (int k = 0; k < ARMS; k++) {
        const int cell[4][3] = {{0, 0, k}, {0, k, k}, {1, k, 0}, {1, 0, k}};
        for (int i = 0; i < 4; i++) {
          double S3 = at(found, ARMS, cell[i][0], cell[i][1], cell[i][2]);
          double error = found->error[(cell[i][0] * ARMS + cell[i][1]) * ARMS + cell[i][2]];
          most = GSL_MAX(most, fabs(S3 - two->S[matrix ? 2 : 0][k]) / GSL_MAX(error, found->rms));
        }
      }
      gsl_test(!(most < 5), "two points of pack %d, %s: off by %.1f errors", c, method ? "triangles" : "shared", most);
      threepoint_free(&found);
    }
    twopoint_free(&two);
    pack_free(&pack);
  }
  shape_free(&shapes[0]);
  shape_free(&shapes[1]);
}

/* The volume that three balls of radius 1 share at such places: discs in slices. */
static double three_balls(double r1, double r2, double theta) {
  double sum = 0, z, weight;
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(60);
  for (size_t k = 0; k < 60; k++) {
    gsl_integration_glfixed_point(-1, 1, k, &z, &weight, rule);
    Pack *slice = discs(1, sqrt(1 - z * z), 9, 9, NULL);
    slice->x[0] = slice->x[1] = 4;
    sum += weight * 81 * three(slice, r1, r2, theta, 1, false);
    pack_free(&slice);
  }
  gsl_integration_glfixed_table_free(rule);
  return sum;
}

/* One ball: along a line the outer two points decide, and they share a lens; a triangle with another corner first. */
static void test_ball(void) {
  enum { ARMS = 6 };
  static const double theta[] = {180, 0, 90, 53.13010235415598};
  Species species = {.name = "P", .radius = 1, .count = 1};
  Box box = {3, {5.1, 5.3, 5.7}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  Rng rng = rng_stream(54, 0, RNG_TEST);
  ThreepointPlan plan = {ARMS, 0.3, 4, theta, false, as_many(1 << 19, 1 << 21), 0, 0};
  Threepoint *found = threepoint_shared(pack, &plan, &rng);
  double most = 0;
  for (int t = 0; t < 2; t++)
    for (int i = 0; i < ARMS; i++)
      for (int j = 0; j < ARMS; j++) {
        double r = (t ? GSL_MAX(i, j) : i + j) * plan.step;
        double lens = r < 2 ? M_PI / 12 * (4 + r) * (2 - r) * (2 - r) / box_volume(&box) : 0;
        double error = GSL_MAX(found->rms, found->error[(t * ARMS + i) * ARMS + j]);
        most = GSL_MAX(most, fabs(at(found, ARMS, t, i, j) - lens) / error);
      }
  gsl_test(most > 6, "a ball: off by %g errors", most);
  double exact = three_balls(3 * plan.step, 4 * plan.step, 90) / box_volume(&box);
  gsl_test_abs(at(found, ARMS, 2, 3, 4), exact, 4 * found->rms, "a ball: 3, 4 at right angles");
  gsl_test_abs(at(found, ARMS, 3, 3, 5), exact, 4 * found->rms, "a ball: 3, 5 from another corner");
  threepoint_free(&found);
  pack_free(&pack);
}

/* Errors: what one run says is how runs differ; as many samples as an error needs; neighbours. */
static void test_errors(void) {
  enum { ARMS = 5, RUNS = 24, CELLS = ARMS * ARMS };
  static const double theta[] = {60};
  Pack *pack = discs(30, 1, 12, 11, NULL);
  Rng rng = rng_stream(55, 0, RNG_TEST);
  points_scatter(pack, &rng);
  ThreepointPlan plan = {ARMS, 0.5, 1, theta, false, 8192, 0, 0};
  for (int method = 0; method < 2; method++) {
    double sum[CELLS] = {0}, square[CELLS] = {0}, told = 0, seen = 0, neighbours = 0;
    for (int k = 0; k < RUNS; k++) {
      Threepoint *found = (method ? threepoint_triangles : threepoint_shared)(pack, &plan, &rng);
      for (int c = 0; c < CELLS; c++)
        sum[c] += found->S3[c], square[c] += found->S3[c] * found->S3[c];
      told += found->rms * found->rms / RUNS;
      neighbours += found->neighbours / RUNS;
      threepoint_free(&found);
    }
    for (int c = 0; c < CELLS; c++)
      seen += (square[c] - sum[c] * sum[c] / RUNS) / (RUNS - 1) / CELLS;
    gsl_test(!(told / seen > 0.5 && told / seen < 2), "errors told %g, seen %g", sqrt(told), sqrt(seen));
    gsl_test(method ? fabs(neighbours) > 0.1 : neighbours < 0.5 || neighbours > 1, "neighbours %g", neighbours);
    gsl_test(told > 1.2 * 0.25 / plan.samples, "not above the binomial error: %g", sqrt(told));
  }
  plan.error = 0.002, plan.most = 1e9;
  Threepoint *found = threepoint_shared(pack, &plan, &rng);
  gsl_test(found->rms > 0.002 || found->samples < 8192 || found->samples > 262144, "an error asked for: %g by %g samples", found->rms, found->samples);
  threepoint_free(&found);
  plan.error = 1e-9, plan.most = 12000;
  found = threepoint_shared(pack, &plan, &rng);
  gsl_test_abs(found->samples, 12000, 0, "and no more samples than the most");
  threepoint_free(&found);
  pack_free(&pack);
}

/* Four discs on either of two sets of places have the same differences, so the same S2 in every direction; S3 is another. */
static void test_homometric(void) {
  enum { ARMS = 17, CELLS = ARMS * ARMS };
  static const double theta[] = {90};
  int times[2][16] = {{0}}, differ = 0;
  Threepoint *found[2];
  for (int twin = 0; twin < 2; twin++) {
    Pack *pack = discs(4, 0.49, 4, 4, NULL);
    homometric_place(pack, twin);
    for (int i = 0; i < 16; i++)
      times[twin][4 * (((int)pack->x[i / 4 * 2] - (int)pack->x[i % 4 * 2] + 4) % 4) + ((int)pack->x[i / 4 * 2 + 1] - (int)pack->x[i % 4 * 2 + 1] + 4) % 4]++;
    gsl_test_abs(pack_audit(pack), 0.02, 1e-12, "homometric discs, %d: gap", twin);
    Rng rng = rng_stream(56, 0, RNG_TEST);
    ThreepointPlan plan = {ARMS, 0.1, 1, theta, false, as_many(1 << 16, 1 << 20), 0, 0};
    found[twin] = threepoint_shared(pack, &plan, &rng);
    pack_free(&pack);
  }
  for (int d = 0; d < 16; d++)
    differ += times[0][d] != times[1][d];
  gsl_test_int(differ, 0, "the same differences");
  double edge = 0, most = 0, rms = M_SQRT2 * GSL_MAX(found[0]->rms, found[1]->rms);
  for (int c = 0; c < ARMS; c++)
    edge = GSL_MAX(edge, fabs(found[0]->S3[c] - found[1]->S3[c]) / rms);
  most = (at(found[0], ARMS, 0, 10, 10) - at(found[1], ARMS, 0, 10, 10)) / rms;
  gsl_test(edge > 5, "two points do not tell them apart: %.1f", edge);
  gsl_test(most < 8, "three points do, at the corners of P's triangle: %.1f", most);
  threepoint_free(&found[0]);
  threepoint_free(&found[1]);
}

/* The widths count alike; a pack of nothing. */
static void test_widths(void) {
  static const double theta[] = {33};
  Pack *pack = discs(5, 1, 6, 7, NULL), *empty = discs(0, 1, 6, 7, NULL);
  ThreepointPlan plan = {5, 0.5, 1, theta, false, 5000, 0, 0};
  Threepoint *found[2];
  for (int k = 0; k < 2; k++) {
    Rng rng = rng_stream(57, 0, RNG_TEST);
    points_scatter(pack, &rng);
    if (k)
      setenv("RANDPACK_SIMD", "default", 1);
    found[k] = threepoint_shared(pack, &plan, &rng);
    unsetenv("RANDPACK_SIMD");
  }
  int differ = 0;
  for (int c = 0; c < 25; c++)
    differ += found[0]->S3[c] != found[1]->S3[c];
  gsl_test_int(differ, 0, "all widths count alike");
  for (int matrix = 0; matrix < 2; matrix++) {
    Rng rng = rng_stream(57, 0, RNG_TEST);
    plan.matrix = matrix;
    Threepoint *none = threepoint_shared(empty, &plan, &rng);
    gsl_test_abs(none->S3[7], matrix, 0, "an empty pack");
    threepoint_free(&none);
  }
  threepoint_free(&found[0]);
  threepoint_free(&found[1]);
  pack_free(&pack);
  pack_free(&empty);
}

int main(void) {
  test_one();
  test_penetrable();
  test_identities();
  test_two();
  test_ball();
  test_errors();
  test_homometric();
  test_widths();
  return gsl_test_summary();
}
