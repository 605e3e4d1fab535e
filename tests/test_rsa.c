/* Random sequential addition: overlaps, proofs of saturation, laws, edges. */
#include "cells.h"
#include "many.h"
#include "outcome.h"
#include "pack.h"
#include "rng.h"
#include "rsa.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Box cuboid(int dim, double x, double y, double z) {
  Box box = {.dim = dim, .side = {x, y, dim == 3 ? z : 0}};
  return box;
}

/* Sums for a mean and its standard error. */
typedef struct {
  double n, sum, squares;
} Mean;

static void add(Mean *m, double x) {
  m->n++;
  m->sum += x;
  m->squares += x * x;
}

static double mean(const Mean *m) {
  return m->sum / m->n;
}

static double error(const Mean *m) {
  double v = m->squares / m->n - mean(m) * mean(m);
  return sqrt(GSL_MAX(v, 0) / (m->n - 1));
}

static void test_same(const Mean *a, const Mean *b, double most,
                      const char *what) {
  double se = hypot(error(a), error(b));
  double off = fabs(mean(a) - mean(b)) / se;
  gsl_test(!(off < most), "%s: %.5f(%.5f) and %.5f(%.5f), %.1f of %.1f se",
           what, mean(a), error(a), mean(b), error(b), off, most);
}

static void test_value(const Mean *a, double value, double most,
                       const char *what) {
  double off = fabs(mean(a) - value) / error(a);
  gsl_test(!(off < most), "%s: %.6f(%.6f) and %.6f, %.1f of %.1f se", what,
           mean(a), error(a), value, off, most);
}

/* ---- an independent proof of saturation: where exclusion spheres meet ---- */

typedef struct {
  double x[3], reach;
} Ball;

typedef struct {
  int dim;
  size_t n;
  Ball *ball;
  double side[3];
} Cover;

/* All images of the exclusion balls that may cover a point of the box. */
static Cover exclusion(const Pack *pack, double a, double gap) {
  Cover c = {.dim = pack->box.dim};
  size_t room = 0;
  int far[3] = {0, 0, 0};
  for (int k = 0; k < c.dim; k++) {
    c.side[k] = pack->box.side[k];
    far[k] = (int)ceil((2 * (a + pack_largest(pack)) + gap) / c.side[k]) + 1;
  }
  for (size_t i = 0; i < pack->n; i++)
    for (int p = -far[0]; p <= far[0]; p++)
      for (int q = -far[1]; q <= far[1]; q++)
        for (int r = -far[2]; r <= far[2]; r++) {
          Ball b = {.reach = a + pack_radius(pack, i) + gap};
          int shift[3] = {p, q, r};
          int near = 1;
          for (int k = 0; k < c.dim; k++) {
            b.x[k] =
                pack->x[i * (size_t)c.dim + (size_t)k] + shift[k] * c.side[k];
            near = near && b.x[k] > -b.reach && b.x[k] < c.side[k] + b.reach;
          }
          if (!near)
            continue;
          if (c.n == room) {
            room = 2 * room + 64;
            c.ball = memory_grow(c.ball, room, sizeof *c.ball);
          }
          c.ball[c.n++] = b;
        }
  return c;
}

static double apart(const double *a, const double *b, int dim) {
  double s = 0;
  for (int k = 0; k < dim; k++)
    s += (a[k] - b[k]) * (a[k] - b[k]);
  return sqrt(s);
}

/* Is the ball's centre nearer than this? One coordinate tells it of most. */
static int meet(const double *p, const Ball *b, double reach, int dim) {
  return fabs(p[0] - b->x[0]) < reach && apart(p, b->x, dim) < reach;
}

static int is_open(const Cover *c, const double *p, size_t i, size_t j,
                   size_t l) {
  for (int k = 0; k < c->dim; k++)
    if (p[k] < 0 || p[k] >= c->side[k])
      return 0;
  for (size_t b = 0; b < c->n; b++)
    if (b != i && b != j && b != l && 
        meet(p, c->ball + b, c->ball[b].reach, c->dim))
      return 0;
  return 1;
}

static size_t open_pairs(const Cover *c) {
  size_t open = 0;
  for (size_t i = 0; i < c->n; i++)
    for (size_t j = i + 1; j < c->n; j++) {
      const Ball *a = c->ball + i, *b = c->ball + j;
      double A = a->reach, B = b->reach;
      if (!meet(a->x, b, A + B, 2))
        continue;
      double d = apart(a->x, b->x, 2);
      if (d <= fabs(A - B))
        continue;
      double along = (d * d + A * A - B * B) / (2 * d);
      double across = sqrt(A * A - along * along);
      for (int sign = -1; sign <= 1; sign += 2) {
        double e[2] = {(b->x[0] - a->x[0]) / d, (b->x[1] - a->x[1]) / d};
        double p[3] = {a->x[0] + along * e[0] - sign * across * e[1],
                       a->x[1] + along * e[1] + sign * across * e[0], 0};
        open += (size_t)is_open(c, p, i, j, c->n);
      }
    }
  return open;
}

static void cross(const double *a, const double *b, double *c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double *a, const double *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The points where three spheres meet: |p - x_i| = R_i. */
static size_t open_triple(const Cover *c, size_t i, size_t j, size_t l) {
  const Ball *a = c->ball + i, *b = c->ball + j, *g = c->ball + l;
  double u[3], v[3], w[3], vw[3], wu[3];
  for (int k = 0; k < 3; k++) {
    u[k] = b->x[k] - a->x[k];
    v[k] = g->x[k] - a->x[k];
  }
  cross(u, v, w);
  double ww = dot(w, w);
  if (!(ww > 1e-20))
    return 0;
  double s = (dot(u, u) + a->reach * a->reach - b->reach * b->reach) / 2;
  double t = (dot(v, v) + a->reach * a->reach - g->reach * g->reach) / 2;
  cross(v, w, vw);
  cross(w, u, wu);
  double q[3];
  for (int k = 0; k < 3; k++)
    q[k] = (s * vw[k] + t * wu[k]) / ww;
  double rest = a->reach * a->reach - dot(q, q);
  if (rest < 0)
    return 0;
  size_t open = 0;
  for (int sign = -1; sign <= 1; sign += 2) {
    double p[3];
    for (int k = 0; k < 3; k++)
      p[k] = a->x[k] + q[k] + sign * sqrt(rest / ww) * w[k];
    open += (size_t)is_open(c, p, i, j, l);
  }
  return open;
}

static size_t open_triples(const Cover *c) {
  size_t open = 0;
  for (size_t i = 0; i < c->n; i++)
    for (size_t j = i + 1; j < c->n; j++) {
      const Ball *a = c->ball + i, *b = c->ball + j;
      if (!meet(a->x, b, a->reach + b->reach, 3))
        continue;
      for (size_t l = j + 1; l < c->n; l++) {
        const Ball *g = c->ball + l;
        if (meet(a->x, g, a->reach + g->reach, 3) &&
            meet(b->x, g, b->reach + g->reach, 3))
          open += open_triple(c, i, j, l);
      }
    }
  return open;
}

/* Corners of the free region of a ball of radius a: none in a saturated pack.
   (Every part of it has corners, where as many exclusion spheres meet as there
   are dimensions, unless too few of them meet at all.) */
static size_t corners(const Pack *pack, double a, double gap) {
  Cover c = exclusion(pack, a, gap);
  size_t open = c.dim == 2 ? open_pairs(&c) : open_triples(&c);
  free(c.ball);
  return open;
}

static int fits(const Pack *pack, size_t n, const double *p, double a,
                double gap) {
  int dim = pack->box.dim;
  const double *side = pack->box.side, *x = pack->x;
  for (size_t i = 0; i < n; i++, x += dim) {
    double reach = a + pack_radius(pack, i) + gap;
    double d = box_nearest(p[0] - x[0], side[0]), s = d * d;
    if (fabs(d) >= reach) /* most of them */
      continue;
    for (int k = 1; k < dim; k++) {
      d = box_nearest(p[k] - x[k], side[k]);
      s += d * d;
    }
    if (sqrt(s) < reach)
      return 0;
  }
  return 1;
}

static size_t hits(const Pack *pack, double a, double gap, Rng *rng, int n) {
  size_t free_points = 0;
  for (int i = 0; i < n; i++) {
    double p[3];
    for (int k = 0; k < pack->box.dim; k++)
      p[k] = pack->box.side[k] * rng_uniform(rng);
    free_points += (size_t)fits(pack, pack->n, p, a, gap);
  }
  return free_points;
}

/* ---- the tests ---- */

static void test_fills(void) {
  Rng rng = rng_stream(2385, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++)
    for (int kinds = 1; kinds <= 2; kinds++)
      for (int own = 0; own <= 1; own++) {
        Box box = dim == 2 ? cuboid(2, 31.7, 24.3, 0) : cuboid(3, 11, 13.1, 9);
        Species species[] = {{"coarse", 0.973, 0}, {"fine", 0.4119, 0}};
        species[0].count = dim == 2 ? 90 : 60;
        species[1].count = dim == 2 ? 200 : 300;
        Pack *pack = pack_alloc(&box, species, kinds, own);
        double sum = 0;
        for (size_t i = 0; i < pack->n; i++) {
          if (own)
            pack->radius[i] *= 0.6 + 0.5 * rng_uniform(&rng);
          sum += pack_ball(dim, pack_radius(pack, i));
        }
        Outcome out = {0};
        RsaReport report;
        double gap = 0.0137 * own;
        int status = rsa_fill(pack, gap, kinds == 2, &rng, &report, &out);
        gsl_test_int(status, DONE, "fill %d-D %d kinds: %s", dim, kinds,
                     out.text);
        gsl_test(!(pack_audit(pack) >= gap), "least gap %.17g of %g",
                 pack_audit(pack), gap);
        gsl_test_rel(pack_fraction(pack), sum / box_volume(&box), 1e-13,
                     "fraction");
        gsl_test(report.placed != pack->n || report.saturated, "report");
        gsl_test(report.attempts < (double)report.trials * (1 - 1e-12),
                 "attempts %g of %g trials", report.attempts,
                 (double)report.trials);
        pack_free(&pack);
      }
}

static void test_proofs(void) {
  Rng rng = rng_stream(58, 3, RNG_TEST);
  double boxes[][4] = {
      {2, 12.3, 17.1, 0}, {2, 2.05, 40, 0},    {2, 3.3, 3.1, 0},
      {2, 2, 2, 0},       {2, 2.9, 2.9, 0},    {3, 7.7, 8.1, 6.9},
      {3, 2.1, 2.4, 42},  {3, 3.07, 3.4, 3.2}, {3, 2.6, 2.6, 2.6},
      {2, 130, 141, 0},   {3, 18, 17, 16}};
  if (!as_many(0, 1)) /* the proof takes the square of the number, or more */
    for (size_t b = 9; b < 11; b++)
      for (int k = 1; k <= 3; k++)
        boxes[b][k] *= b == 9 ? 0.5 : 0.7;
  for (size_t b = 0; b < sizeof boxes / sizeof *boxes; b++)
    for (int kinds = 1; kinds <= 2; kinds++) {
      Box box = cuboid((int)boxes[b][0], boxes[b][1], boxes[b][2], boxes[b][3]);
      Species species[] = {{"a", 0.9973, 7}, {"b", 0.71, 0}};
      double share[] = {0.8, 0.2}, gap = b % 2 ? 0.0021 : 0;
      RsaReport report;
      Pack *pack =
          rsa_saturate(&box, species, kinds, share, gap, &rng, &report);
      double least = pack_audit(pack);
      gsl_test(!(least >= gap), "least gap %.17g of %g", least, gap);
      gsl_test(pack->n < 1 || !report.saturated || report.placed != pack->n,
               "box %zu, %d kinds: %zu placed", b, kinds, pack->n);
      for (int s = 0; s < kinds; s++) {
        double a = species[s].radius;
        gsl_test_int((int)corners(pack, a, gap), 0,
                     "box %zu, %d kinds: corners of room for %s", b, kinds,
                     species[s].name);
        gsl_test_int((int)hits(pack, a, gap, &rng, 20000), 0, "points of room");
      }
      if (pack->n > 0) { /* the proof itself sees that a ball is missing */
        pack->n--;
        gsl_test(corners(pack, species[pack_kind(pack, pack->n)].radius, gap) ==
                         0 &&
                     pack->n > 1,
                 "box %zu, %d kinds: a ball removed leaves room", b, kinds);
      }
      pack_free(&pack);
    }
}

static void test_value_of_saturation(void) {
  /* the published values stand in data/; three digits here */
  double value[] = {0.5470, 0.384}, width[] = {0.0002, 0.0006};
  for (int dim = 2; dim <= 3; dim++) {
    Mean fraction = {0};
    for (uint64_t k = 0; k < 12; k++) {
      Rng rng = rng_stream(11, k, RNG_POSITIONS);
      double ratio[] = {1, 1, 1};
      Box box = box_make(dim, ratio,
                         (dim == 2 ? 6000 : 3000) * pack_ball(dim, 0.77) /
                             value[dim - 2]);
      Species one = {"one", 0.77, 0};
      Pack *pack = rsa_saturate(&box, &one, 1, NULL, 0, &rng, NULL);
      add(&fraction, pack_fraction(pack));
      if (k == 0)
        gsl_test(!(cells_least_gap(pack) >= 0), "least gap %g",
                 cells_least_gap(pack));
      pack_free(&pack);
    }
    double off = fabs(mean(&fraction) - value[dim - 2]);
    gsl_test(!(off < width[dim - 2] + 3 * error(&fraction)),
             "saturation in %d-D: %.5f(%.5f), published %.4f", dim,
             mean(&fraction), error(&fraction), value[dim - 2]);
    gsl_test(!(error(&fraction) < 0.001), "its error");
  }
}

/* Two balls: the second is uniform outside the first's exclusion ball. */
static void test_two_balls(void) {
  for (int dim = 2; dim <= 3; dim++) {
    double side = 3.7, D = 2 * 0.61 + 0.05, d2 = D * D;
    double V = pow(side, dim), v = pack_ball(dim, D);
    double all = V * side * side * dim / 12;
    double ball = v * d2 * dim / (dim + 2.0);
    Mean square = {0}, attempts = {0};
    Species one = {"one", 0.61, 2};
    Box box = cuboid(dim, side, side, side);
    for (uint64_t k = 0; k < 20000; k++) {
      Rng rng = rng_stream(77, k, RNG_POSITIONS);
      Pack *pack = pack_alloc(&box, &one, 1, false);
      Outcome out = {0};
      RsaReport report;
      rsa_fill(pack, 0.05, false, &rng, &report, &out);
      double s = 0;
      for (int i = 0; i < dim; i++)
        s += gsl_pow_2(box_nearest(pack->x[dim + i] - pack->x[i], side));
      add(&square, s);
      add(&attempts, report.attempts);
      pack_free(&pack);
    }
    test_value(&square, (all - ball) / (V - v), 4, "square of their distance");
    test_value(&attempts, 1 + V / (V - v), 4, "attempts for two");
  }
}

/* Two discs with hardly room for the second: voxels are halved on the way. */
static void test_tight_law(void) {
  double D = 0.7, room = 0, sum = 0, four = 0, most = 0.5 - D * D;
  double window = 0.02;
  int n = 3000;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      double x = 0.5 - window * (i + 0.5) / n, y = 0.5 - window * (j + 0.5) / n;
      double over = x * x + y * y - D * D;
      room += over >= 0;
      sum += over >= 0 ? over / most : 0;
      four += over >= 0 ? fabs(x - y) : 0;
    }
  Mean square = {0}, slant = {0}, attempts = {0};
  Species one = {"one", 0.35, 2};
  Box box = cuboid(2, 1, 1, 0);
  int deepest = 0;
  for (uint64_t k = 0; k < 20000; k++) {
    Rng rng = rng_stream(78, k, RNG_POSITIONS);
    Pack *pack = pack_alloc(&box, &one, 1, false);
    Outcome out = {0};
    RsaReport report;
    gsl_test_int(rsa_fill(pack, 0, false, &rng, &report, &out), DONE, "tight");
    double x = box_nearest(pack->x[2] - pack->x[0], 1);
    double y = box_nearest(pack->x[3] - pack->x[1], 1);
    add(&square, (x * x + y * y - D * D) / most);
    add(&slant, fabs(fabs(x) - fabs(y)));
    add(&attempts, report.attempts);
    deepest = GSL_MAX(deepest, report.levels);
    pack_free(&pack);
  }
  gsl_test(deepest < 2, "halved %d times", deepest);
  test_value(&square, sum / room, 4, "tight: square of the distance");
  test_value(&slant, four / room, 4, "tight: slant");
  test_value(&attempts, 1 + gsl_pow_2(n / window) / (4 * room), 4,
             "tight: attempts");
}

/* ---- naive addition ---- */

static void naive_fill(Pack *pack, double *attempts, Rng *rng) {
  int dim = pack->box.dim;
  for (size_t n = 0; n < pack->n;) {
    double p[3];
    for (int k = 0; k < dim; k++)
      p[k] = pack->box.side[k] * rng_uniform(rng);
    ++*attempts;
    if (!fits(pack, n, p, pack_radius(pack, n), 0))
      continue;
    memcpy(pack->x + n++ * (size_t)dim, p, (size_t)dim * sizeof *p);
  }
}

static double near_pairs(const Pack *pack, double reach) {
  Neighbours *list = cells_neighbours(pack, reach);
  double pairs = (double)list->first[pack->n] / 2;
  cells_neighbours_free(&list);
  return pairs;
}

static void test_against_naive(void) {
  for (int dim = 2; dim <= 3; dim++) {
    double ratio[] = {1, 1.3, 0.9};
    Box box =
        box_make(dim, ratio, 60 * pack_ball(dim, 1) / (dim == 2 ? 0.47 : 0.31));
    Species one = {"one", 1, 60};
    Mean pairs[2] = {{0}}, wide[2] = {{0}}, attempts[2] = {{0}};
    for (int k = 0; k < as_many(dim == 2 ? 600 : 300, 1500); k++)
      for (int way = 0; way < 2; way++) {
        Pack *pack = pack_alloc(&box, &one, 1, false);
        Rng rng = rng_stream(5 + (uint64_t)way, (uint64_t)k, RNG_TEST);
        Outcome out = {0};
        RsaReport report = {.attempts = 0};
        if (way == 0)
          naive_fill(pack, &report.attempts, &rng);
        else
          rsa_fill(pack, 0, false, &rng, &report, &out);
        if (out.status == DONE) {
          add(pairs + way, near_pairs(pack, 2.2));
          add(wide + way, near_pairs(pack, 3.1));
          add(attempts + way, log(report.attempts));
        }
        pack_free(&pack);
      }
    test_same(pairs, pairs + 1, 3.5, "pairs within 2.2 a");
    test_same(wide, wide + 1, 3.5, "pairs within 3.1 a");
    double noise = hypot(error(attempts), error(attempts + 1));
    gsl_test(!(fabs(mean(attempts) - mean(attempts + 1)) < fmax(0.03, 3.5 * noise)),
             "attempts %g %g", exp(mean(attempts)), exp(mean(attempts + 1)));
  }
}

/* Two sizes: so many naive attempts that on the average a fiftieth of a ball is
   missing from saturation, or until the proof above. */
static void naive_saturate(Pack *pack, const double *radius, double p0,
                           Rng *rng, int count[]) {
  size_t n = 0, most = pack->n;
  int full = 0;
  for (int tries = 1; tries <= 120000 && !full; tries++) {
    double p[3] = {0, 0, 0}, a = radius[rng_uniform(rng) < p0 ? 0 : 1];
    for (int k = 0; k < 2; k++)
      p[k] = pack->box.side[k] * rng_uniform(rng);
    if (fits(pack, n, p, a, 0)) {
      memcpy(pack->x + 2 * n, p, 2 * sizeof *p);
      pack->radius[n++] = a;
      count[a == radius[0] ? 0 : 1]++;
    }
    if (tries % 10000 == 0) {
      pack->n = n;
      full = !corners(pack, radius[0], 0) && !corners(pack, radius[1], 0);
      pack->n = most;
    }
  }
}

static void test_two_sizes_law(void) {
  Species species[] = {{"a", 1, 0}, {"b", 0.55, 0}, {"all", 0, 60}};
  double share[] = {0.7, 0.3}, radius[] = {1, 0.55};
  Box box = cuboid(2, 6.1, 5.7, 0);
  Mean count[2][2] = {{{0}}};
  for (int k = 0; k < as_many(120, 400); k++) {
    Rng rng = rng_stream(9, (uint64_t)k, RNG_TEST);
    int placed[2] = {0, 0};
    Pack *room = pack_alloc(&box, species + 2, 1, true);
    naive_saturate(room, radius, share[0], &rng, placed);
    pack_free(&room);
    Pack *pack = rsa_saturate(&box, species, 2, share, 0, &rng, NULL);
    for (int s = 0; s < 2; s++) {
      add(&count[s][0], placed[s]);
      add(&count[s][1], (double)pack->species[s].count);
    }
    for (size_t i = 0; i < pack->n; i++)
      if (pack->kind[i] != (i >= pack->species[0].count))
        gsl_test(1, "species stand together");
    pack_free(&pack);
  }
  test_same(&count[0][0], &count[0][1], 3.5, "count of the larger");
  test_same(&count[1][0], &count[1][1], 3.5, "count of the smaller");
}

/* The clock: how much stands after so many attempts. */
static void test_clock(void) {
  Species one = {"one", 0.5, 0}, room = {"room", 0.5, 200};
  Box box = cuboid(2, 7.3, 8.2, 0);
  Mean naive[2] = {{0}}, quick[2] = {{0}};
  double time[] = {2, 32}, unit = box_volume(&box) / pack_ball(2, 0.5);
  int packs = as_many(200, 600);
  for (int k = 0; k < packs; k++) {
    Rng rng = rng_stream(10, (uint64_t)k, RNG_TEST);
    Pack *pack = pack_alloc(&box, &room, 1, false);
    size_t n = 0;
    for (int t = 0, tries = 0; t < 2; t++) {
      for (; tries < time[t] * unit; tries++) {
        double p[2] = {7.3 * rng_uniform(&rng), 8.2 * rng_uniform(&rng)};
        if (fits(pack, n, p, 0.5, 0))
          memcpy(pack->x + 2 * n++, p, sizeof p);
      }
      add(naive + t, (double)n / unit);
    }
    pack_free(&pack);
    RsaReport report;
    pack = rsa_saturate(&box, &one, 1, NULL, 0, &rng, &report);
    for (int t = 0; t < 2; t++)
      for (int c = 0; c < report.curve_n; c++)
        if (fabs(report.curve_time[c] / time[t] - 1) < 1e-9)
          add(quick + t, report.curve_fraction[c]);
    pack_free(&pack);
  }
  gsl_test(quick[0].n != packs || quick[1].n != packs, "the times are there");
  test_same(naive, quick, 3.5, "fraction at time 2");
  test_same(naive + 1, quick + 1, 3.5, "fraction at time 32");
}

/* phi(inf) - phi(t) falls as t^(-1/d): by 2^(6/d) from t = 2^7 to 2^13. */
static void test_approach(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Mean slope = {0};
    for (int k = 0; k < as_many(3, 8); k++) {
      Rng rng = rng_stream(12, (uint64_t)k, RNG_POSITIONS);
      Box box = dim == 2 ? cuboid(2, 120, 120, 0) : cuboid(3, 24, 24, 24);
      Species one = {"one", 0.5, 0};
      RsaReport report;
      Pack *pack = rsa_saturate(&box, &one, 1, NULL, 0, &rng, &report);
      double end = pack_fraction(pack), early = 0, late = 0;
      for (int c = 0; c < report.curve_n; c++) {
        if (fabs(report.curve_time[c] - 0x1p7) < 1e-6)
          early = end - report.curve_fraction[c];
        if (fabs(report.curve_time[c] - 0x1p13) < 1e-6)
          late = end - report.curve_fraction[c];
      }
      add(&slope, log(early / late) / log(2) / 6);
      pack_free(&pack);
    }
    gsl_test(!(fabs(mean(&slope) - 1.0 / dim) < 0.02 + 3 * error(&slope)),
             "approach in %d-D: exponent %.4f(%.4f)", dim, mean(&slope),
             error(&slope));
  }
}

static void test_ratio_100(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Box box = dim == 2 ? cuboid(2, 7, 8, 0) : cuboid(3, 2.9, 3, 3.1);
    Species species[] = {{"large", 1, 0}, {"small", 0.01, 4000}};
    species[0].count = dim == 2 ? 6 : 1;
    for (int first = 0; first <= 1; first++) {
      Rng rng = rng_stream(100, (uint64_t)dim, RNG_TEST);
      Pack *pack = pack_alloc(&box, species, 2, false);
      Outcome out = {0};
      RsaReport report;
      int status = rsa_fill(pack, 0.001, first, &rng, &report, &out);
      gsl_test(status != (first ? DONE : UNREACHED), "ratio 100: %s", out.text);
      if (first) {
        double least = pack_audit(pack);
        gsl_test(!(least >= 0.001), "least gap %g", least);
      }
      pack_free(&pack);
    }
  }
  Box box = cuboid(2, 3.1, 2.9, 0);
  Species species[] = {{"small", 0.01, 0}, {"large", 1, 0}};
  double share[] = {0.02, 0.98};
  Rng rng = rng_stream(101, 0, RNG_TEST);
  Pack *pack = rsa_saturate(&box, species, 2, share, 0, &rng, NULL);
  gsl_test(!(pack_audit(pack) >= 0), "ratio 100 saturated: gap");
  gsl_test_int((int)hits(pack, 0.01, 0, &rng, 20000), 0, "and full");
  gsl_test(pack->species[0].count < 4000 || pack->species[1].count < 1,
           "with %zu and %zu", pack->species[0].count, pack->species[1].count);
  pack_free(&pack);
}

static void test_many_radii(void) {
  for (int dim = 2; dim <= 3; dim++)
    for (uint64_t k = 0; k < 3; k++) {
      Rng rng = rng_stream(55, k, RNG_TEST);
      Box box = dim == 2 ? cuboid(2, 9, 10, 0) : cuboid(3, 5, 5.5, 4.7);
      Species one = {"any", 0.5, 500};
      Pack *pack = pack_alloc(&box, &one, 1, true);
      for (size_t i = 0; i < pack->n; i++)
        pack->radius[i] = 0.2 + 0.6 * rng_uniform(&rng);
      Outcome out = {0};
      RsaReport report;
      int status = rsa_fill(pack, 0.003, false, &rng, &report, &out);
      gsl_test(status != UNREACHED || !report.saturated, "radii: %s", out.text);
      gsl_test(report.placed < 20 || report.placed > 300, "placed %zu",
               report.placed);
      double a = 0;
      const char *radius = strstr(out.text, "radius");
      gsl_test(!radius || sscanf(radius, "radius %lf", &a) != 1, "says which");
      /* keep those that stand: the rest was never moved from 0 */
      size_t n = 0, d = (size_t)dim;
      for (size_t i = 0; i < pack->n; i++)
        if (pack->x[i * d] > 0) {
          memmove(pack->x + n * d, pack->x + i * d, d * sizeof(double));
          pack->radius[n++] = pack->radius[i];
        }
      pack->n = n;
      gsl_test_int((int)n, (int)report.placed, "placed");
      gsl_test(!(pack_audit(pack) >= 0.003), "their gap %g", pack_audit(pack));
      gsl_test_int((int)corners(pack, a * (1 + 1e-4), 0.003), 0,
                   "no room for %g", a);
      pack_free(&pack);
    }
}

/* Radii of one class: the second has hardly room where the least has much, and
   gets voxels of its own. */
static void test_alone(void) {
  double side = 1.682, D = 0.599 + 0.585, room = 0, sum = 0;
  double most = side * side / 2 - D * D;
  int n = 3000;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      double x = side / 2 - 0.03 * (i + 0.5) / n;
      double y = side / 2 - 0.03 * (j + 0.5) / n;
      double over = x * x + y * y - D * D;
      room += over >= 0;
      sum += over >= 0 ? over / most : 0;
    }
  Box box = cuboid(2, side, side, 0);
  Species any = {"any", 0.5, 17};
  Mean depth = {0};
  for (int k = 0; k < as_many(800, 2000); k++) {
    Rng rng = rng_stream(79, (uint64_t)k, RNG_TEST);
    Pack *pack = pack_alloc(&box, &any, 1, true);
    for (size_t i = 0; i < pack->n; i++)
      pack->radius[i] =
          i < 2 ? 0.599 - 0.014 * (double)i : 0.5 + 0.003 * (double)i;
    Outcome out = {0};
    RsaReport report;
    rsa_fill(pack, 0, true, &rng, &report, &out);
    gsl_test(report.placed != 2, "alone: %zu placed", report.placed);
    double x = box_nearest(pack->x[2] - pack->x[0], side);
    double y = box_nearest(pack->x[3] - pack->x[1], side);
    add(&depth, (x * x + y * y - D * D) / most);
    pack_free(&pack);
  }
  test_value(&depth, sum / room, 4, "alone: distance");
}

/* The order of a random fill, seen from where it stops: the two species are
   placed in proportion, and large first places the large. */
static void test_order(void) {
  Species species[] = {{"a", 1, 300}, {"b", 0.999, 300}};
  Box box = cuboid(2, 30, 30, 0);
  Mean first = {0};
  for (uint64_t k = 0; k < 40; k++) {
    Rng rng = rng_stream(66, k, RNG_TEST);
    Pack *pack = pack_alloc(&box, species, 2, false);
    Outcome out = {0};
    RsaReport report;
    rsa_fill(pack, 0, k % 2, &rng, &report, &out);
    double a = 0;
    for (size_t i = 0; i < 300; i++)
      a += pack->x[2 * i] > 0;
    if (k % 2)
      gsl_test(a != (double)report.placed, "large first: %g of %zu", a,
               report.placed);
    else
      add(&first, a / (double)report.placed);
    pack_free(&pack);
  }
  test_value(&first, 0.5, 4, "share of the first species");
}

static void test_edges(void) {
  Box box = cuboid(3, 3, 3.5, 60);
  for (size_t n = 0; n <= 2; n++) {
    Species one = {"one", 1.4999, n};
    Pack *pack = pack_alloc(&box, &one, 1, false);
    Rng rng = rng_stream(1, n, RNG_TEST);
    Outcome out = {0};
    gsl_test_int(rsa_fill(pack, 0, n == 1, &rng, NULL, &out), DONE, "%zu", n);
    gsl_test(!(pack_audit(pack) >= 0), "gap of %zu", n);
    pack_free(&pack);
  }
  {
    Species one = {"one", 1.4999, 3};
    Pack *pack = pack_alloc(&box, &one, 1, false);
    Rng rng = rng_stream(1, 3, RNG_TEST);
    Outcome out = {0};
    RsaReport report;
    int status = rsa_fill(pack, 0.001, false, &rng, &report, &out);
    gsl_test_int(status, UNREACHED, "larger than the box: %s", out.text);
    gsl_test(!strstr(out.text, "own image"), "says so");
    gsl_test_int((int)report.placed, 0, "none");
    pack_free(&pack);
    Species two[] = {{"wide", 1.6, 0}, {"fits", 1, 0}};
    pack = rsa_saturate(&box, two, 2, NULL, 0, &rng, &report);
    gsl_test(pack->species[0].count != 0 || pack->species[1].count < 10,
             "only what fits: %zu", pack->species[1].count);
    pack_free(&pack);
  }
  {
    Species one = {"one", 1, 1000};
    Box flat = cuboid(2, 12, 300, 0);
    Pack *pack = pack_alloc(&flat, &one, 1, false);
    Rng rng = rng_stream(1, 4, RNG_TEST);
    Outcome out = {0};
    RsaReport report;
    gsl_test_int(rsa_fill(pack, 0, false, &rng, &report, &out), UNREACHED,
                 "jammed: %s", out.text);
    size_t placed = 0;
    double fraction = 0;
    const char *radius = strstr(out.text, "): ");
    gsl_test(!radius || sscanf(radius, "): %zu of 1000 placed, fraction %lf",
                               &placed, &fraction) != 2,
             "says how many");
    gsl_test(placed != report.placed, "the same");
    gsl_test_rel(fraction, (double)placed * M_PI / 3600, 1e-5, "fraction");
    gsl_test(fraction < 0.52 || fraction > 0.575, "near saturation");
    pack_free(&pack);
  }
  /* no second disc fits a square whose half diagonal is below 2a */
  for (uint64_t k = 0; k < 20; k++) {
    Box square = cuboid(2, 2.8, 2.8, 0);
    Species one = {"one", 1, 0};
    Rng rng = rng_stream(1, k, RNG_TEST);
    Pack *pack = rsa_saturate(&square, &one, 1, NULL, 0, &rng, NULL);
    gsl_test_int((int)pack->n, 1, "one and no more");
    pack_free(&pack);
    square = cuboid(2, 2 * M_SQRT2, 2 * M_SQRT2, 0);
    pack = rsa_saturate(&square, &one, 1, NULL, 0, &rng, NULL);
    gsl_test(pack->n < 1 || pack->n > 2, "ends where one point may be left");
    gsl_test(!(pack_audit(pack) >= 0), "its gap %g", pack_audit(pack));
    pack_free(&pack);
  }
}

static void test_seeds(void) {
  Species species[] = {{"a", 1, 100}, {"b", 0.5, 200}};
  Box box = cuboid(3, 12, 11, 13);
  double *kept = NULL;
  for (int k = 0; k < 3; k++) {
    Rng rng = rng_stream(k == 2 ? 4 : 3, 0, RNG_POSITIONS);
    Pack *pack = pack_alloc(&box, species, 2, false);
    size_t bytes = 3 * pack->n * sizeof(double);
    Outcome out = {0};
    rsa_fill(pack, 0, false, &rng, NULL, &out);
    if (k == 0) {
      kept = memory(3 * pack->n, sizeof(double));
      memcpy(kept, pack->x, bytes);
    } else
      gsl_test((memcmp(kept, pack->x, bytes) == 0) != (k == 1),
               "seeds and bytes, fill");
    pack_free(&pack);
  }
  free(kept);
  Pack *pack[3];
  for (int k = 0; k < 3; k++) {
    Rng rng = rng_stream(k == 2 ? 4 : 3, 0, RNG_POSITIONS);
    pack[k] = rsa_saturate(&box, species, 2, NULL, 0, &rng, NULL);
  }
  gsl_test(
      pack[0]->n != pack[1]->n ||
          memcmp(pack[0]->x, pack[1]->x, 3 * pack[0]->n * sizeof(double)) != 0,
      "seeds and bytes, saturate");
  gsl_test(pack[0]->x[0] == pack[2]->x[0], "another seed, another pack");
  for (int k = 0; k < 3; k++)
    pack_free(pack + k);
}

int main(void) {
  test_fills();
  test_proofs();
  test_value_of_saturation();
  test_two_balls();
  test_tight_law();
  test_against_naive();
  test_two_sizes_law();
  test_clock();
  test_approach();
  test_ratio_100();
  test_many_radii();
  test_alone();
  test_order();
  test_edges();
  test_seeds();
  return gsl_test_summary();
}
