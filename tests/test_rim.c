/* Rims and lenses against the exact overlap of chapter overlap. */
#include "elementary.h"
#include "overlap.h"
#include "rim.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>

enum { SHAPES = 8, PAIRS = 120 };
static const char *const names[SHAPES] = {
    "triangle", "square", "pentagon", "polygon of 13", "superellipse", "m = 50", "m = 1/2, a/b = 5", "disc"};

static Shape *shape_of(int k) {
  static const int sides[4] = {3, 4, 5, 13};
  static const double curve[3][2] = {{1.5, 1.5}, {1.31, 50}, {5, 0.5}};
  return k < 4 ? shape_regular(sides[k]) : k < 7 ? shape_superellipse(curve[k - 4][0], curve[k - 4][1]) : NULL;
}

static Body body_of(const Shape *shape, Rng *rng, double range) {
  Body body = {shape, 0.6 + rng_uniform(rng), 0, 0, 1, 0};
  elementary_turn(6.2 * rng_uniform(rng), &body.c, &body.s);
  body.x = range * (rng_uniform(rng) - 0.5);
  body.y = range * (rng_uniform(rng) - 0.5);
  return body;
}

/* The example of the chapter. */
static void test_example(void) {
  Shape *square = shape_regular(4);
  Rim *rim = rim_make(square, 0.1, false);
  RimRoom *room = rim_room_alloc(rim->n);
  Body A = {square, 1, 0.31, -7.2, sqrt(0.5), sqrt(0.5)}, B = A;
  Lens lens;
  double side = sqrt(M_PI);
  B.x += 1.5;
  B.y += 0.3;
  gsl_test(!rim_lens(rim, &A, rim, &B, room, &lens), "two squares overlap");
  gsl_test_rel(lens.area, (side - 1.5) * (side - 0.3), 1e-14, "two squares: area");
  gsl_test_abs(lens.x, 0.75, 1e-14, "two squares: x of the centroid");
  gsl_test_abs(lens.y, 0.15, 1e-14, "two squares: y of the centroid");
  gsl_test_rel(lens.fx, 0.3 - side, 1e-14, "two squares: force");
  gsl_test_rel(lens.fy, 1.5 - side, 1e-14, "two squares: force across");
  gsl_test_rel(lens.torque_A, 0.0165276894566905, 1e-13, "two squares: torque");
  B.x = A.x + side * (1 + 1e-14);
  B.y = A.y;
  gsl_test(rim_lens(rim, &A, rim, &B, room, &lens), "two squares side by side are apart");
  B = A;
  gsl_test(!rim_lens(rim, &A, rim, &B, room, &lens) || fabs(lens.area - M_PI) > 1e-13,
           "a square on itself shares all: %.17g", lens.area);
  rim_room_free(&room);
  rim_free(&rim);
  shape_free(&square);
}

static void test_rims(void) {
  static const double tolerance[3] = {0.1, 0.0123, 1e-4};
  for (int k = 0; k < SHAPES; k++) {
    Shape *shape = shape_of(k);
    for (int t = 0; t < 3; t++) {
      Rim *rim = rim_make(shape, tolerance[t], false), *scaled = rim_make(shape, tolerance[t], true);
      double least = GSL_POSINF, most = 0, outer = 0, area = 0;
      for (int i = 0; i < rim->n; i++) {
        double x = rim->x[i], y = rim->y[i], r = sqrt(x * x + y * y);
        double g = shape ? shape_gauge(shape, x, y) : r, u = 0.5 * (x + rim->x[i + 1]), v = 0.5 * (y + rim->y[i + 1]);
        least = GSL_MIN(least, GSL_MIN(g, shape ? shape_gauge(shape, u, v) : sqrt(u * u + v * v)));
        most = GSL_MAX(most, r * (1 - 1 / g));
        outer = GSL_MAX(outer, r);
        area += 0.5 * (scaled->x[i] * scaled->y[i + 1] - scaled->x[i + 1] * scaled->y[i]);
      }
      gsl_test(least < 1 - 1e-12, "%s: the rim holds the shape, %g", names[k], least - 1);
      gsl_test(most > tolerance[t], "%s: the rim stands out by %g of %g", names[k], most, tolerance[t]);
      gsl_test_rel(rim->outer, outer, 1e-15, "%s: the farthest corner", names[k]);
      gsl_test_rel(area, M_PI, 1e-14, "%s: area of a scaled rim", names[k]);
      gsl_test_rel(rim->inertia, shape ? (shape->Ixx + shape->Iyy) / M_PI : 0.5, 1e-15, "%s: inertia", names[k]);
      gsl_test_int(rim->round, !shape, "%s: round or not", names[k]);
      if (k == 6)
        gsl_test_int(rim->n, 4, "%s: corners", names[k]);
      rim_free(&rim);
      rim_free(&scaled);
    }
    shape_free(&shape);
  }
}

/* Polygons have the very overlap; curves that of a rim that is a little larger. */
static void test_pair(int k, int m, Rng *rng) {
  double tolerance = 1e-3;
  Shape *a = shape_of(k), *b = shape_of(m);
  Rim *one = rim_make(a, tolerance, false), *two = rim_make(b, tolerance, false);
  RimRoom *room = rim_room_alloc(GSL_MAX(one->n, two->n));
  bool exact = (k < 4 || k == 6) && (m < 4 || m == 6);
  double off = 0, torque = 0, centre = 0, slope = 0;
  int wrong = 0, seen = 0;
  for (int p = 0; p < PAIRS; p++) {
    Body A = body_of(a, rng, 2.5), B = body_of(b, rng, 2.5);
    Overlap o;
    Lens lens;
    bool found = overlap_find(&A, &B, &o), is = rim_lens(one, &A, two, &B, room, &lens);
    double edge = tolerance * ((a ? a->perimeter : 6.3) + (b ? b->perimeter : 6.3)) * 2;
    wrong += exact ? found != is : found && !is;
    if (!is)
      continue;
    seen++;
    double more = lens.area - o.area;
    off = GSL_MAX(off, exact ? fabs(more) : more < -1e-12 ? 1 : more > edge ? 1 : 0);
    if (exact && o.area > 1e-3) {
      centre = GSL_MAX(centre, fabs(A.x + lens.x - o.x) + fabs(A.y + lens.y - o.y));
      torque = GSL_MAX(torque, fabs(lens.torque_A - o.torque_A) + fabs(lens.torque_B - o.torque_B));
    }
    /* the derivative by x of A, of this very rim */
    Lens up, down;
    Body U = A, D = A;
    U.x += 1e-6, D.x -= 1e-6;
    if (lens.area > 0.1 && rim_lens(one, &U, two, &B, room, &up) && rim_lens(one, &D, two, &B, room, &down))
      slope = GSL_MAX(slope, fabs(lens.fx + (up.area - down.area) / 2e-6));
  }
  gsl_test(seen < PAIRS / 4 || wrong, "%s and %s: found as the exact overlap is, %d of %d", names[k], names[m], wrong, seen);
  gsl_test(off > 1e-12, "%s and %s: area, off by %g", names[k], names[m], off);
  gsl_test(centre > 1e-9, "%s and %s: centroid, off by %g", names[k], names[m], centre);
  gsl_test(torque > 1e-12, "%s and %s: torques, off by %g", names[k], names[m], torque);
  gsl_test(slope > 1e-4, "%s and %s: force and difference, off by %g", names[k], names[m], slope);
  rim_room_free(&room);
  rim_free(&one);
  rim_free(&two);
  shape_free(&a);
  shape_free(&b);
}

/* Torques of rims of curves, by differences; of a disc none. */
static void test_torques(void) {
  Rng rng = rng_stream(77, 0, RNG_TEST);
  Shape *curve = shape_of(4);
  Rim *one = rim_make(curve, 0.01, false), *disc = rim_make(NULL, 0.01, false);
  RimRoom *room = rim_room_alloc(GSL_MAX(one->n, disc->n));
  double off[2] = {0, 0}, round = 0;
  for (int p = 0; p < PAIRS; p++)
    for (int turned = 0; turned < 2; turned++) {
      Body A = body_of(curve, &rng, 1.5), B = body_of(curve, &rng, 1.5), *T = turned ? &B : &A;
      Lens lens, up, down;
      double c = T->c, s = T->s, h = 1e-6;
      if (!rim_lens(one, &A, one, &B, room, &lens) || lens.area < 0.1)
        continue;
      T->c = c - h * s, T->s = s + h * c;
      rim_lens(one, &A, one, &B, room, &up);
      T->c = c + h * s, T->s = s - h * c;
      rim_lens(one, &A, one, &B, room, &down);
      off[turned] = GSL_MAX(off[turned], fabs((turned ? lens.torque_B : lens.torque_A) + (up.area - down.area) / (2 * h)));
      B.shape = NULL;
      if (rim_lens(one, &A, disc, &B, room, &lens))
        round = GSL_MAX(round, fabs(lens.torque_B));
      if (rim_lens(disc, &B, one, &A, room, &lens))
        round = GSL_MAX(round, fabs(lens.torque_A));
    }
  gsl_test(off[0] > 1e-4 || off[1] > 1e-4, "torques and differences, off by %g and %g", off[0], off[1]);
  gsl_test(round > 0, "no torque on a disc, %g", round);
  rim_room_free(&room);
  rim_free(&one);
  rim_free(&disc);
  shape_free(&curve);
}

int main(void) {
  Rng rng = rng_stream(15, 3, RNG_TEST);
  test_example();
  test_rims();
  for (int k = 0; k < SHAPES; k++)
    for (int m = 0; m < SHAPES; m++)
      test_pair(k, m, &rng);
  test_torques();
  return gsl_test_summary();
}
