/* tests/test_apart.c: the quick answer against the certain one, at random, near contact, and with wrong hints */
#include "apart.h"
#include "many.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>

enum { KINDS = 16 };
static const char *const name[KINDS] = {
    "disc", "triangle", "square", "pentagon", "octagon", "polygon of 9", "polygon of 40", "kite", "sliver",
    "diamond", "m = .501, a/b = 1.5", "m = .8", "circle", "m = 1.5, a/b = 1.5", "m = 50, a/b = 5", "needle of 50"};
static Shape *shape[KINDS];
static ApartShape *ready[KINDS];

static void open_shapes(void) {
  static const double kite[4][2] = {{1.1, -.3}, {.2, .9}, {-.9, .1}, {-.1, -2.2}};
  static const double sliver[3][2] = {{0, 0}, {7, .2}, {6.3, .35}};
  Outcome out = {0};
  static const int sides[] = {0, 3, 4, 5, 8, 9, 40};
  static const double curve[][2] = {{1.3, .5}, {1.5, .501}, {1, .8}, {1, 1}, {1.5, 1.5}, {5, 50}, {50, 3}};
  for (int k = 1; k < 7; k++)
    shape[k] = shape_regular(sides[k]);
  shape[7] = shape_convex(4, kite, &out);
  shape[8] = shape_convex(3, sliver, &out);
  for (int k = 9; k < KINDS; k++)
    shape[k] = shape_superellipse(curve[k - 9][0], curve[k - 9][1]);
  for (int k = 0; k < KINDS; k++)
    ready[k] = apart_alloc(shape[k]);
}

static void close_shapes(void) {
  for (int k = 0; k < KINDS; k++) {
    apart_free(&ready[k]);
    shape_free(&shape[k]);
  }
  ApartShape *none = NULL;
  apart_free(&none);
}

typedef struct {
  int a, b;
  double ra, rb, x, y; /* B's place from A */
  double angle[2][2];
} Pair;

static Pair random_pair(Rng *rng, int a, int b) {
  Pair pair = {.a = a, .b = b, .ra = .5 + rng_uniform(rng), .rb = .3 + 2 * rng_uniform(rng)};
  rng_direction(rng, 2, pair.angle[0]);
  rng_direction(rng, 2, pair.angle[1]);
  double u[2], reach = pair.ra * ready[a]->outer + pair.rb * ready[b]->outer;
  rng_direction(rng, 2, u);
  double far = 1.3 * reach * rng_uniform(rng);
  pair.x = u[0] * far;
  pair.y = u[1] * far;
  return pair;
}

static OverlapVerdict verdict(const Pair *p, double scale, double *gap) {
  Body A = {shape[p->a], p->ra, .3, -.7, p->angle[0][0], p->angle[0][1]};
  Body B = {shape[p->b], p->rb, .3 + scale * p->x, -.7 + scale * p->y, p->angle[1][0], p->angle[1][1]};
  return overlap_verdict(&A, &B, gap);
}

static bool quick(const Pair *p, double scale, ApartHint *hint) {
  ApartPlace A = {ready[p->a], p->ra, p->angle[0][0], p->angle[0][1]};
  ApartPlace B = {ready[p->b], p->rb, p->angle[1][0], p->angle[1][1]};
  return apart(&A, &B, scale * p->x, scale * p->y, hint);
}

/* At random places, with what a hint may hold that another pair has left. */
static void test_random(void) {
  Rng rng = rng_stream(71, 0, RNG_TEST);
  ApartHint hint = {0, 0};
  int few = as_many(60, 2000);
  for (int a = 0; a < KINDS; a++)
    for (int b = 0; b < KINDS; b++) {
      int wrong = 0, both[2] = {0, 0};
      for (int t = 0; t < few; t++) {
        Pair pair = random_pair(&rng, a, b);
        OverlapVerdict truth = verdict(&pair, 1, NULL);
        ApartHint none = {0, 0};
        bool fresh = quick(&pair, 1, &none), led = quick(&pair, 1, &hint), again = quick(&pair, 1, &hint);
        wrong += fresh != led || led != again;
        wrong += truth == OVERLAP_APART ? !fresh : truth == OVERLAP_CROSSING && fresh;
        both[fresh]++;
      }
      gsl_test_int(wrong, 0, "at random: %s and %s", name[a], name[b]);
      gsl_test(!both[0] || !both[1], "%s and %s are apart, and not", name[a], name[b]);
    }
}

/* Along the line of centres to contact, and a little to either side of it. */
static void test_contact(void) {
  Rng rng = rng_stream(72, 0, RNG_TEST);
  int few = as_many(1, 40);
  static const double off[] = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
  for (int a = 0; a < KINDS; a++)
    for (int b = 0; b <= a; b++) {
      int wrong = 0;
      for (int t = 0; t < few; t++) {
        Pair pair = random_pair(&rng, a, b);
        double r = sqrt(pair.x * pair.x + pair.y * pair.y), low = 0, high = 4;
        pair.x *= (pair.ra * ready[a]->outer + pair.rb * ready[b]->outer) / r;
        pair.y *= (pair.ra * ready[a]->outer + pair.rb * ready[b]->outer) / r;
        for (int halving = 0; halving < 52; halving++) {
          double middle = (low + high) / 2;
          *(verdict(&pair, middle, NULL) == OVERLAP_APART ? &high : &low) = middle;
        }
        ApartHint hint = {0, 0};
        for (size_t o = 0; o < sizeof off / sizeof *off; o++)
          wrong += !quick(&pair, high * (1 + off[o]), &hint) || quick(&pair, high * (1 - off[o]), &hint);
      }
      gsl_test_int(wrong, 0, "near contact: %s and %s", name[a], name[b]);
    }
}

/* The polygons of a curve: one has its corners on it, the sides of the other touch it, and they differ little. */
static void test_polygons(void) {
  for (int k = 10; k < KINDS; k++) {
    const ApartShape *r = ready[k];
    double off = 0, inside = 0, area[2] = {0, 0}, cut = 0, out = 0, n = r->corners;
    for (int i = 0; i < r->corners; i++) {
      int j = (i + 1) % r->corners;
      off = GSL_MAX(off, fabs(shape_gauge(shape[k], r->in[i][0], r->in[i][1]) - 1));
      inside = GSL_MAX(inside, 1 - shape_gauge(shape[k], r->around[i][0], r->around[i][1]));
      double u = r->around[j][1] - r->around[i][1], v = r->around[i][0] - r->around[j][0], l = sqrt(u * u + v * v);
      double x = r->in[j][0] - r->in[i][0], y = r->in[j][1] - r->in[i][1];
      out = GSL_MAX(out, ((r->around[i][0] - r->in[i][0]) * y - (r->around[i][1] - r->in[i][1]) * x) / gsl_hypot(x, y));
      if (l > 1e-3)
        cut = GSL_MAX(cut, shape_support(shape[k], u / l, v / l) - (u * r->around[i][0] + v * r->around[i][1]) / l);
      area[0] += (r->in[i][0] * r->in[j][1] - r->in[i][1] * r->in[j][0]) / 2;
      area[1] += (r->around[i][0] * r->around[j][1] - r->around[i][1] * r->around[j][0]) / 2;
    }
    gsl_test(off > 4e-15, "%s: the points are on the curve: %g", name[k], off);
    gsl_test(inside > 4e-15, "%s: the corners are not inside: %g", name[k], inside);
    gsl_test(cut > 1e-13, "%s: no side of tangents cuts it: %g", name[k], cut);
    gsl_test(!(area[0] < M_PI && area[1] > M_PI), "%s: areas %.9g < pi < %.9g", name[k], area[0], area[1]);
    gsl_test(out > 2 * M_PI * shape[k]->perimeter / (n * n), "%s: corners are near the chords: %g", name[k], out);
  }
  gsl_test(ready[9]->few != 4 || ready[1]->few != 3 || ready[5]->few != 0, "who has few sides");
}

/* The example of the chapter: two squares, half a diagonal 1, parted by a side and not by the line of centres. */
static void test_example(void) {
  double s = sqrt(2 / M_PI), gap;
  Pair pair = {.a = 2, .b = 2, .ra = s, .rb = s, .x = 1.5, .y = .6, .angle = {{1, 0}, {1, 0}}};
  ApartHint hint = {0, 0};
  gsl_test(!quick(&pair, 1, &hint) || hint.x != 1, "two squares are apart by the first side");
  pair.y = .4;
  verdict(&pair, 1, &gap);
  gsl_test(quick(&pair, 1, &hint) || gap > 0, "and nearer they are not");
}

int main(void) {
  open_shapes();
  test_random();
  test_contact();
  test_polygons();
  test_example();
  close_shapes();
  return gsl_test_summary();
}
