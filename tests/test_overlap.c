/* tests/test_overlap.c: verdicts at known gaps, areas against closed forms and other methods, forces by differences, and the
   cases that break others: coincident shapes and edges, containment, eight crossings, tips, needles */
#include "elementary.h"
#include "many.h"
#include "overlap.h"
#include "rng.h"
#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>

enum { SHAPES = 21 };

static void make_shapes(Shape *shapes[SHAPES]) {
  static const double m[] = {0.5, 0.51, 0.77, 1, 1.5, 2, 5, 50};
  int n = 0;
  shapes[n++] = NULL;
  for (int sides = 3; sides <= 6; sides++)
    shapes[n++] = shape_regular(sides);
  for (int i = 0; i < 8; i++) {
    shapes[n++] = shape_superellipse(1.3, m[i]);
    shapes[n++] = shape_superellipse(5, m[i]);
  }
}

static void free_shapes(Shape *shapes[SHAPES]) {
  for (int i = 0; i < SHAPES; i++)
    shape_free(&shapes[i]);
}

static Body body(const Shape *shape, double radius, double x, double y, double angle) {
  Body b = {shape, radius, x, y, 1, 0};
  elementary_turn(angle, &b.c, &b.s);
  return b;
}

static Body any(Shape *const shapes[], Rng *rng, double least) {
  const Shape *shape = shapes[rng_below(rng, SHAPES)];
  double radius = pow(least, rng_uniform(rng)), x = 3 * rng_uniform(rng) - 1.5;
  return body(shape, radius, x, 3 * rng_uniform(rng) - 1.5, 7 * rng_uniform(rng));
}

static double gauge(const Body *b, double x, double y) {
  double u = (x - b->x) / b->radius, v = (y - b->y) / b->radius, X = b->c * u + b->s * v, Y = b->c * v - b->s * u;
  return b->shape ? shape_gauge(b->shape, X, Y) : hypot(X, Y);
}

static double width(const Body *b, double nx, double ny, double point[2]) {
  double u = b->c * nx + b->s * ny, v = b->c * ny - b->s * nx, p[2] = {u, v};
  double h = b->shape ? shape_farthest(b->shape, u, v, p) : 1;
  point[0] = b->x + b->radius * (b->c * p[0] - b->s * p[1]);
  point[1] = b->y + b->radius * (b->s * p[0] + b->c * p[1]);
  return b->radius * h;
}

static const char *name(const Body *b) {
  static char text[2][64];
  static int k = 0;
  k = !k;
  const Shape *s = b->shape;
  if (!s)
    snprintf(text[k], sizeof *text, "disc %g", b->radius);
  else if (s->kind == SHAPE_POLYGON)
    snprintf(text[k], sizeof *text, "%d sides %g", s->sides, b->radius);
  else
    snprintf(text[k], sizeof *text, "m %g a/b %g %g", s->m, s->a / s->b, b->radius);
  return text[k];
}

static void test_by_hand(void) {
  Shape *square = shape_regular(4);
  Body A = body(square, 1, 0.3, -0.2, 0.4), B = body(square, 1, 0.3, -0.2, 0.4 + M_PI / 4);
  Overlap o;
  gsl_test(!overlap_find(&A, &B, &o), "squares that cross eight times overlap");
  gsl_test_rel(o.area, 2 * (M_SQRT2 - 1) * M_PI, 1e-14, "in an octagon");
  gsl_test(!(fabs(o.fx) + fabs(o.fy) + fabs(o.torque_A) + fabs(o.torque_B) < 1e-14), "without force");
  double side = sqrt(M_PI), turn = M_PI / 4;
  A = body(square, 1, 0, 0, turn);
  B = body(square, 1, side, 0.3 * side, turn);
  bool found = overlap_find(&A, &B, &o);
  gsl_test(found && o.area > 1e-14, "squares side by side do not: %g", o.area);
  gsl_test(overlap_verdict(&A, &B, NULL) != OVERLAP_TOUCHING, "they touch");
  B.x = 0.25 * side;
  B.y = 0;
  gsl_test(!overlap_find(&A, &B, &o), "squares with two coincident sides");
  gsl_test_rel(o.area, 0.75 * M_PI, 1e-14, "three quarters");
  gsl_test_rel(o.x, 0.125 * side, 1e-13, "centroid of what they share");
  gsl_test_rel(o.fx, -side, 1e-13, "force along the sides");
  double d = 1.1384, a = 1, b = 0.7013, u = (d * d + a * a - b * b) / (2 * d);
  A = body(NULL, a, 5, 7, 0);
  B = body(NULL, b, 5, 7 + d, 0);
  double want = a * a * acos(u / a) + b * b * acos((d - u) / b) - d * sqrt(a * a - u * u);
  gsl_test(!overlap_find(&A, &B, &o), "two discs");
  gsl_test_rel(o.area, want, 1e-14, "a lens");
  gsl_test_rel(o.fy, -2 * sqrt(a * a - u * u), 1e-14, "its chord is the force");
  gsl_test(!(fabs(o.x - 5) < 1e-14 && o.y > 7 + d - b && o.y < 8), "its centroid");
  B.y = 7.1;
  gsl_test(!overlap_find(&A, &B, &o) || fabs(o.area / (M_PI * b * b) - 1) > 1e-14 || o.y != 7.1, "a disc in a disc");
  B.y = 7 + 1.7014;
  gsl_test(overlap_find(&A, &B, &o) || o.area != 0 || o.high != 0, "discs apart");
  shape_free(&square);
}

/* The bodies touch in the normal n, of a side in its middle if one has sides; then B moves by e along n. */
static void test_gaps(void) {
  static const double e[] = {1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13, 2e-14};
  Shape *shapes[SHAPES];
  Rng rng = rng_stream(71, 0, RNG_TEST);
  make_shapes(shapes);
  int wrong = 0, rough = 0, told = 0, tried = 0, pairs = as_many(300, 20000);
  for (int k = 0; k < pairs; k++) {
    double phi = 2 * M_PI * rng_uniform(&rng), nx = cos(phi), ny = sin(phi), p[2], q[2];
    uint64_t side = rng_below(&rng, 3);
    Body A = any(shapes, &rng, 0.2), B = any(shapes, &rng, 0.2);
    if ((A.shape && A.shape->a > 2.2) || (B.shape && B.shape->a > 2.2))
      continue;
    A.x = A.y = B.x = B.y = 0;
    const Body *flat = A.shape && A.shape->sides ? &A : B.shape && B.shape->sides ? &B : NULL;
    if (flat) {
      double sign = flat == &A ? 1 : -1, u = flat->shape->nx[side], v = flat->shape->ny[side];
      nx = sign * (flat->c * u - flat->s * v);
      ny = sign * (flat->s * u + flat->c * v);
    }
    width(&A, nx, ny, p);
    width(&B, -nx, -ny, q);
    if (flat) {
      const Shape *s = flat->shape;
      int next = ((int)side + 1) % s->sides;
      double u = flat->radius * (s->x[side] + s->x[next]) / 2, v = flat->radius * (s->y[side] + s->y[next]) / 2;
      double *middle = flat == &A ? p : q;
      middle[0] = flat->c * u - flat->s * v;
      middle[1] = flat->s * u + flat->c * v;
    }
    for (int i = 0; i < 14; i++) {
      double gap, signed_e = i & 1 ? -e[i / 2] : e[i / 2];
      B.x = p[0] - q[0] + signed_e * nx;
      B.y = p[1] - q[1] + signed_e * ny;
      OverlapVerdict verdict = overlap_verdict(&A, &B, NULL);
      OverlapVerdict again = overlap_verdict(&B, &A, &gap);
      wrong += verdict != again || verdict == (i & 1 ? OVERLAP_APART : OVERLAP_CROSSING);
      told += verdict != OVERLAP_TOUCHING;
      rough += i & 1 ? gap < signed_e * (1 + 1e-3) - 1e-14 || gap > 1e-14 : gap > signed_e + 1e-14;
      if (!A.shape && !B.shape)
        rough += fabs(gap - signed_e) > 1e-14;
    }
    B.x = p[0] - q[0];
    B.y = p[1] - q[1];
    gsl_test(overlap_verdict(&A, &B, NULL) != OVERLAP_TOUCHING, "%s and %s touch", name(&A), name(&B));
    tried += 14;
  }
  gsl_test_int(wrong, 0, "verdicts at gaps and overlaps of 1e-3 to 2e-14");
  gsl_test_int(rough, 0, "the gap that is reported is not above the true one");
  gsl_test_int(told, tried, "all of them are certain");
  free_shapes(shapes);
}

/* Any two bodies: the verdict and the area agree, the area is in its bracket, the order does not matter, the centroid is in both */
static void test_pairs(void) {
  Shape *shapes[SHAPES];
  Rng rng = rng_stream(72, 0, RNG_TEST);
  make_shapes(shapes);
  int found = 0, disagree = 0, outside = 0, order = 0, astray = 0, pairs = as_many(20000, 2000000);
  for (int k = 0; k < pairs; k++) {
    Body A = any(shapes, &rng, k & 1 ? 0.01 : 0.3), B = any(shapes, &rng, 0.3);
    Overlap o, r;
    bool overlaps = overlap_find(&A, &B, &o);
    overlap_find(&B, &A, &r);
    disagree += overlaps != (overlap_verdict(&A, &B, NULL) == OVERLAP_CROSSING);
    order += o.area != r.area || o.x != r.x || o.fx != -r.fx || o.fy != -r.fy || o.torque_A != r.torque_B ||
             o.low != r.low;
    if (!overlaps)
      continue;
    found++;
    outside += !(o.low <= o.area && o.area <= o.high);
    if (o.area > 1e-8)
      astray += !(gauge(&A, o.x, o.y) < 1 && gauge(&B, o.x, o.y) < 1);
  }
  gsl_test(!(found > pairs / 10), "%d of %d pairs overlap", found, pairs);
  gsl_test_int(disagree, 0, "verdict and area agree");
  gsl_test_int(outside, 0, "the area is inside its bracket");
  gsl_test_int(order, 0, "the order of the two bodies does not change a bit");
  gsl_test_int(astray, 0, "the centroid lies in both");
  free_shapes(shapes);
}

/* Overlaps of a tip or a corner by 1 to 1e-8 of the size, which a walk from node to node would pass by */
static void test_shallow(void) {
  Shape *shapes[SHAPES];
  Rng rng = rng_stream(75, 0, RNG_TEST);
  make_shapes(shapes);
  int disagree = 0, outside = 0, coarse = 0;
  for (int k = 0; k < as_many(6000, 400000); k++) {
    Body A = any(shapes, &rng, 0.1), B = any(shapes, &rng, 0.1);
    double phi = 7 * rng_uniform(&rng), nx = cos(phi), ny = sin(phi), e = pow(1e-8, rng_uniform(&rng)), p[2], q[2];
    e *= GSL_MIN_DBL(A.radius, B.radius);
    A.x = A.y = B.x = B.y = 0;
    width(&A, nx, ny, p);
    width(&B, -nx, -ny, q);
    B.x = p[0] - q[0] - e * nx;
    B.y = p[1] - q[1] - e * ny;
    Overlap o, fine;
    bool overlaps = overlap_find(&A, &B, &o);
    disagree += overlaps != (overlap_verdict(&A, &B, NULL) == OVERLAP_CROSSING);
    outside += !(o.low <= o.area && o.area <= o.high);
    if (k % 20 || !overlaps)
      continue;
    overlap_mixed(&A, &B, 400, &fine);
    coarse += !(fine.low - 2e-14 <= o.area && o.area <= fine.high + 2e-14);
  }
  gsl_test_int(disagree, 0, "verdict and area agree on shallow overlaps");
  gsl_test_int(outside, 0, "whose area is inside its bracket");
  gsl_test_int(coarse, 0, "and inside that of polygons of 400 corners");
  free_shapes(shapes);
}

/* A tip enters a smooth side between two nodes by 1e-4: against polygons with many more nodes */
static void test_tip(void) {
  Shape *smooth = shape_superellipse(1.2, 1.1), *tip = shape_superellipse(1, 0.51);
  for (int k = 0; k < 12; k++) {
    double phi = 0.13 + 0.511 * k, n[2] = {cos(phi), sin(phi)}, p[2];
    Body A = body(smooth, 0.5, 0, 0, 0.3), B = body(tip, 1, 0, 0, phi + M_PI);
    width(&A, n[0], n[1], p);
    B.x = p[0] + (tip->a - 1e-4) * n[0];
    B.y = p[1] + (tip->a - 1e-4) * n[1];
    Overlap o, fine;
    gsl_test(!overlap_find(&A, &B, &o) || !overlap_mixed(&A, &B, 2000, &fine), "tip %d enters", k);
    gsl_test_rel(o.area, fine.area, 0.02, "tip %d", k);
  }
  shape_free(&smooth);
  shape_free(&tip);
}

/* The derivatives of the area by the place and the angles, by differences; the sampled area; and polygons of many nodes */
static void test_forces(void) {
  Shape *shapes[SHAPES];
  Rng rng = rng_stream(73, 0, RNG_TEST);
  make_shapes(shapes);
  for (int k = 0, pairs = as_many(60, 1000); k < pairs;) {
    Body A = any(shapes, &rng, 0.5), B = any(shapes, &rng, 0.5);
    Overlap o, low, high, other;
    if (!overlap_find(&A, &B, &o) || o.area < 1e-3)
      continue;
    k++;
    double e = 1e-6, want[] = {o.fx, o.fy, o.torque_A, o.torque_B}, c, s;
    elementary_turn(e, &c, &s);
    for (int i = 0; i < 4; i++) {
      Body A1 = A, A2 = A, B1 = B, B2 = B, *turned[] = {i == 2 ? &A1 : &B1, i == 2 ? &A2 : &B2};
      if (i == 0) {
        A1.x -= e;
        A2.x += e;
      } else if (i == 1) {
        A1.y -= e;
        A2.y += e;
      } else {
        for (int j = 0; j < 2; j++) {
          double sine = j ? s : -s, last = turned[j]->c;
          turned[j]->c = c * last - sine * turned[j]->s;
          turned[j]->s = c * turned[j]->s + sine * last;
        }
      }
      overlap_find(&A1, &B1, &low);
      overlap_find(&A2, &B2, &high);
      double got = -(high.area - low.area) / (2 * e);
      gsl_test(!(fabs(got - want[i]) < 2e-5), "%s and %s: derivative %d is %g, want %g", name(&A), name(&B), i, got,
               want[i]);
    }
    double least = M_PI * gsl_pow_2(GSL_MIN_DBL(A.radius, B.radius)), cell;
    overlap_sampled(&A, &B, 20000, false, &other);
    cell = GSL_MAX_DBL(fabs(other.area - o.area), 0);
    gsl_test(!(cell < 0.05 * sqrt(least)), "%s and %s: sampled %g, want %g", name(&A), name(&B), other.area, o.area);
    if (A.shape && A.shape->m == 0 && B.shape && B.shape->m == 0)
      continue;
    overlap_mixed(&A, &B, 160, &other);
    gsl_test(!(fabs(other.area - o.area) < 2e-3 * least && other.low <= o.area + 4e-14 && o.area <= other.high + 4e-14),
             "%s and %s: mixed %.9g, want %.9g", name(&A), name(&B), other.area, o.area);
    gsl_test(!(fabs(other.x - o.x) < 1e-2 && fabs(other.fx - o.fx) + fabs(other.fy - o.fy) < 0.05), "its centroid and force");
  }
  free_shapes(shapes);
}

/* One shape twice, shifted, turned or enlarged by e */
static void test_coincident(void) {
  static const double e[] = {0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-9, 1e-5};
  Shape *shapes[SHAPES];
  make_shapes(shapes);
  for (int k = 0; k < SHAPES; k++)
    for (int i = 0; i < 21; i++) {
      double x = i % 3 == 0 ? e[i / 3] : 0, angle = i % 3 == 1 ? e[i / 3] : 0, grown = i % 3 == 2 ? e[i / 3] : 0;
      Body A = body(shapes[k], 1, 0, 0, 0.7), B = body(shapes[k], 1 + grown, 0.6 * x, 0.8 * x, 0.7 + angle);
      Overlap o;
      bool found = overlap_find(&A, &B, &o);
      gsl_test(!found || overlap_verdict(&A, &B, NULL) != OVERLAP_CROSSING, "%s upon itself, moved by %g", name(&A), e[i / 3]);
      gsl_test(!(fabs(o.area - M_PI) <= 12 * e[i / 3] + 1e-14 && o.low <= o.area && o.area <= o.high),
               "%s upon itself, moved by %g: area %.17g", name(&A), e[i / 3], o.area);
    }
  free_shapes(shapes);
}

/* Different quadrilaterals at one place and angle, in either order */
static void test_irregular(void) {
  Rng rng = rng_stream(75, 0, RNG_TEST);
  int differ = 0, unlike = 0;
  Outcome out = {0};
  for (int k = 0; k < 200; k++) {
    Shape *shape[2];
    for (int i = 0; i < 2; i++) {
      double v[4][2], turn[4] = {0, M_PI / 2, M_PI, 3 * M_PI / 2};
      for (int j = 0; j < 4; j++)
        elementary_turn(turn[j] + 0.5 * rng_uniform(&rng), &v[j][0], &v[j][1]);
      shape[i] = shape_convex(4, (const double(*)[2])v, &out);
    }
    Body A = body(shape[0], 1, 0.3, 0.4, 0.9), B = body(shape[1], 1, 0.3, 0.4, 0.9);
    Overlap o, p;
    differ += !overlap_find(&A, &B, &o) || !overlap_find(&B, &A, &p) || o.area != p.area || o.x != p.x || o.y != p.y ||
              o.fx != -p.fx || o.fy != -p.fy || o.torque_A != p.torque_B || o.torque_B != p.torque_A;
    unlike += o.area < 3.14;
    shape_free(&shape[0]);
    shape_free(&shape[1]);
  }
  gsl_test_int(differ, 0, "irregular shapes at one place, in either order");
  gsl_test_int(unlike > 180, 1, "are not one shape");
}

/* A shape wholly inside another, of any kinds, in the middle or not */
static void test_contained(void) {
  Shape *shapes[SHAPES];
  make_shapes(shapes);
  for (int i = 0; i < SHAPES; i++)
    for (int j = 0; j < SHAPES; j++) {
      double inner = shapes[i] ? shapes[i]->inner : 1, outer = shapes[j] ? shapes[j]->outer : 1;
      Body A = body(shapes[i], 1, 2, 3, 0.9), B = body(shapes[j], 0.7 * inner / outer, 2 + (j & 1) * 0.29 * inner, 3, 0.31);
      Overlap o;
      gsl_test(!overlap_find(i & 1 ? &A : &B, i & 1 ? &B : &A, &o), "%s in %s", name(&B), name(&A));
      gsl_test_rel(o.area, M_PI * B.radius * B.radius, 1e-14, "%s in %s: all of it", name(&B), name(&A));
      gsl_test(!(fabs(o.x - B.x) + fabs(o.y - B.y) + fabs(o.fx) + fabs(o.torque_A) < 1e-13), "at its centroid, without force");
    }
  free_shapes(shapes);
}

/* A pair whose best direction lies where the arc of directions must not be widened. */
static void test_arc(void) {
  static const double v[][2] = {{0, 0}, {1, 0}, {0.3, 1e-3}};
  Outcome out = {0};
  Shape *needle = shape_superellipse(100, 1.0000001), *sliver = shape_convex(3, v, &out);
  Body A = {needle, 1, 0, 0, -0.70811081999185066, -0.70610131469249426};
  Body B = {sliver, 7.908598951554211, -144.94786411972169, -284.40776079537471, -0.6865205059013596, -0.72711044207667741};
  double gap;
  gsl_test(overlap_verdict(&A, &B, &gap) != OVERLAP_APART || overlap_verdict(&A, &B, NULL) != OVERLAP_APART, "far apart, also with the gap, %g", gap);
  shape_free(&needle);
  shape_free(&sliver);
}

/* Needles across each other, and along */
static void test_needles(void) {
  static const double m[] = {0.5, 0.6, 1, 2, 50};
  for (int i = 0; i < 5; i++) {
    Shape *needle = shape_superellipse(50, m[i]);
    Body A = body(needle, 1, 0, 0, 0.2), B = body(needle, 1, 0.4, 0.1, 0.2 + M_PI / 2);
    Overlap o;
    gsl_test(!overlap_find(&A, &B, &o), "needles across, m = %g", m[i]);
    gsl_test(!(o.area > 0.6 * 4 * needle->b * needle->b * pow(0.5, 1 / m[i]) && o.area < 4.1 * needle->b * needle->b),
             "their overlap, m = %g: %g", m[i], o.area);
    B = body(needle, 1, 2 * needle->a * cos(0.2), 2 * needle->a * sin(0.2), 0.2);
    double gap;
    bool crossing = overlap_verdict(&A, &B, &gap) == OVERLAP_CROSSING;
    gsl_test(crossing && gap < -1e-13, "needles tip to tip, m = %g: %g", m[i], gap);
    B.x *= 1 + 1e-12;
    B.y *= 1 + 1e-12;
    gsl_test(overlap_verdict(&A, &B, NULL) != OVERLAP_APART, "and a little apart, m = %g", m[i]);
    shape_free(&needle);
  }
}

/* What the lattice misses: an overlap between its points, which the layer sees; and the points that it counts */
static void test_sampled(void) {
  Shape *square = shape_regular(4);
  double side = sqrt(M_PI);
  Body A = body(square, 1, 0, 0, M_PI / 4), B = body(square, 1, side * (1 - 1e-9), 0, M_PI / 4);
  Overlap o;
  gsl_test(overlap_sampled(&A, &B, 1000000, false, &o), "an overlap of 1e-9 is between 1e6 points");
  gsl_test(!overlap_sampled(&A, &B, 20000, true, &o), "their layer finds it");
  gsl_test(!overlap_find(&A, &B, &o), "and so do we");
  gsl_test_rel(o.area, 1e-9 * M_PI, 1e-6, "exactly");
  B.x = 0.5 * side;
  gsl_test(!overlap_sampled(&A, &B, 1350, false, &o), "45 by 30 points");
  gsl_test_rel(o.area, 15. / 45 * 1.5 * M_PI, 1e-12, "15 in a row count");
  gsl_test_rel(o.x, 0.25 * side, 1e-12, "their mean");
  shape_free(&square);
}

static void test_potential(void) {
  Shape *shapes[SHAPES];
  Rng rng = rng_stream(74, 0, RNG_TEST);
  make_shapes(shapes);
  int wrong = 0, off = 0, higher = 0;
  double a[2], b[2];
  for (int k = 0; k < as_many(1500, 10000); k++) {
    Body A = any(shapes, &rng, 0.3), B = any(shapes, &rng, 0.3);
    double point[2], gap;
    if ((A.shape && A.shape->sides) || (B.shape && B.shape->sides))
      continue;
    OverlapVerdict verdict = overlap_verdict(&A, &B, &gap);
    bool deep = hypot(A.x - B.x, A.y - B.y) < A.radius + 0.5 * B.radius; /* one may lie in the other */
    bool inside = overlap_potential(&A, &B, a, b);
    wrong += inside && verdict != OVERLAP_CROSSING;
    if (!deep && (!A.shape || A.shape->a <= 2) && (!B.shape || B.shape->a <= 2))
      wrong += inside != (verdict == OVERLAP_CROSSING);
    off += !(fabs(gauge(&A, a[0], a[1]) - 1) < 1e-13 && fabs(gauge(&B, b[0], b[1]) - 1) < 1e-13);
    for (int i = 0; i < 40; i++) {
      width(&A, cos(0.157 * i), sin(0.157 * i), point);
      higher += gauge(&B, point[0], point[1]) < gauge(&B, a[0], a[1]) - 1e-12;
    }
  }
  gsl_test_int(wrong, 0, "the potential says the same");
  gsl_test_int(off, 0, "its points are on the boundaries");
  gsl_test_int(higher, 0, "no point of the boundary is deeper");
  Body A = body(NULL, 1, 0, 0, 0), B = body(NULL, 0.7, 1.2, 0.9, 0);
  overlap_potential(&A, &B, a, b);
  gsl_test(!(hypot(a[0] - 0.8, a[1] - 0.6) < 1e-12 && hypot(b[0] - 0.64, b[1] - 0.48) < 1e-12), "of two discs");
  free_shapes(shapes);
}

int main(void) {
  test_by_hand();
  test_gaps();
  test_pairs();
  test_shallow();
  test_tip();
  test_forces();
  test_coincident();
  test_irregular();
  test_contained();
  test_needles();
  test_arc();
  test_sampled();
  test_potential();
  return gsl_test_summary();
}
