/* tests/test_cover.c: unions of discs, polygons and superellipses: closed forms, rows against points, invariances, ties */
#include "cover.h"
#include "elementary.h"
#include "many.h"
#include "overlap.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static const Box square10 = {2, {10, 10, 0}};

static Body body(const Shape *shape, double R, double x, double y, double angle) {
  Body b = {.shape = shape, .radius = R, .x = x, .y = y};
  elementary_turn(angle, &b.c, &b.s);
  return b;
}

static double lens(double a, double b, double d) {
  double x = (d * d + a * a - b * b) / (2 * d), y = sqrt(a * a - x * x);
  return a * a * atan2(y, x) + b * b * atan2(y, d - x) - d * y;
}

/* A square of this side, axis parallel. */
static Body square_at(const Shape *four, double side, double x, double y) {
  return body(four, side / sqrt(M_PI), x, y, M_PI / 4);
}

static void check(const Body *b, size_t n, const Box *box, double area, double length, double error, const char *what) {
  double perimeter, found = cover_area(b, n, box, &perimeter);
  gsl_test_abs(found, area, error, "%s: area", what);
  gsl_test_abs(perimeter, length, error * 10, "%s: perimeter", what);
}

static void test_discs(void) {
  static const double shift[][2] = {{0, 0}, {5, 3.3}, {9.5, 0}, {9.5, 9.9}, {0.123, 9.2}, {8.9, 4}};
  for (size_t k = 0; k < sizeof shift / sizeof *shift; k++) {
    double x = shift[k][0], y = shift[k][1];
    Body two[] = {body(NULL, 1, box_wrap(x, 10), box_wrap(y, 10), 0),
                  body(NULL, 1.5, box_wrap(x + 0.9, 10), box_wrap(y + 1.2, 10), 0)};
    double X = (2.25 + 1 - 2.25) / 3, half = atan2(sqrt(1 - X * X), X), other = atan2(sqrt(1 - X * X), 1.5 - X);
    double length = 2 * (M_PI - half) + 3 * (M_PI - other);
    check(two, 2, &square10, 3.25 * M_PI - lens(1, 1.5, 1.5), length, 3e-14, "two discs");
  }
  Body ones[] = {body(NULL, 1, 0.5, 2, 0), body(NULL, 1, 2.5, 2, 0)};
  Box three = {2, {3, 3, 0}};
  check(ones, 2, &three, 2 * M_PI - (2 * M_PI / 3 - sqrt(3) / 2), 8 * M_PI / 3, 3e-14, "the example");
  Body one[] = {body(NULL, 0.6, 0.3, 0.9, 0)};
  Box unit = {2, {1, 1, 0}};
  double half = acos(0.5 / 0.6);
  check(one, 1, &unit, 0.36 * M_PI - 2 * lens(0.6, 0.6, 1), 1.2 * (M_PI - 4 * half), 1e-14, "a disc on its own images");
  one[0].radius = 0.75;
  check(one, 1, &unit, 1, 0, 1e-14, "a disc that covers the box");
  one[0].radius = 0.5;
  gsl_test_abs(cover_area(one, 1, &unit, NULL), M_PI / 4, 1e-14, "a disc that touches its images");
  Body in[] = {body(NULL, 1, 5, 5, 0), body(NULL, 2, 5.5, 5.5, 0), body(NULL, 1, 5, 6, 0)};
  check(in, 3, &square10, 4 * M_PI, 4 * M_PI, 3e-14, "discs in a disc");
  Body same[] = {in[0], in[0], in[0]};
  check(same, 3, &square10, M_PI, 2 * M_PI, 1e-14, "three discs in one place");
  Body inner[] = {body(NULL, 2, 5, 5, 0), body(NULL, 1, 6, 5, 0)};
  check(inner, 2, &square10, 4 * M_PI, 4 * M_PI, 3e-14, "touching from inside");
  check(NULL, 0, &square10, 0, 0, 0, "nothing");
}

static void test_ties(void) {
  Shape *four = shape_regular(4);
  Body b[64];
  b[0] = square_at(four, 2, 3, 3), b[1] = b[0], b[2] = b[0];
  check(b, 3, &square10, 4, 8, 1e-14, "three squares in one place");
  b[1] = square_at(four, 2, 5, 3);
  check(b, 2, &square10, 8, 12, 1e-14, "two squares side by side");
  b[1] = square_at(four, 1, 4.5, 3);
  check(b, 2, &square10, 5, 10, 1e-14, "a part of a side in common");
  b[1] = square_at(four, 1, 3.5, 3);
  check(b, 2, &square10, 4, 8, 1e-14, "a square in a square, at its side");
  b[1] = square_at(four, 1, 2.5, 2.5);
  check(b, 2, &square10, 4, 8, 1e-14, "a square in a square, at its corner");
  b[1] = square_at(four, 2, 4, 3);
  check(b, 2, &square10, 6, 10, 1e-14, "sides along sides");
  b[1] = square_at(four, 2, 5, 5);
  check(b, 2, &square10, 8, 16, 1e-14, "corner at corner");
  b[1] = body(four, 2 / sqrt(M_PI), 3, 3, 0);
  double tip = (sqrt(2) - 1) * (sqrt(2) - 1);
  check(b, 2, &square10, 4 + 4 * tip, 16 * sqrt(2) * (sqrt(2) - 1), 1e-14, "squares that cross eight times");
  for (int k = 0; k < 25; k++)
    b[k] = square_at(four, 2, 2 * (k % 5), 2 * (k / 5));
  check(b, 25, &square10, 100, 0, 3e-13, "squares tile the box");
  check(b, 20, &square10, 80, 20, 3e-13, "rows of squares");
  for (int k = 0; k < 25; k++)
    b[k].x = box_wrap(b[k].x + 1, 10);
  check(b, 24, &square10, 96, 8, 3e-13, "a hole, and edges in the line x = 0");
  b[0] = square_at(four, 4, 2, 2), b[1] = square_at(four, 4, 8, 2), b[2] = square_at(four, 12, 5, 7);
  check(b, 2, &square10, 32, 24, 1e-13, "side by side over the line");
  check(b + 2, 1, &square10, 100, 0, 1e-13, "a square larger than the box");
  Box wide = {2, {30, 10, 0}};
  check(b + 2, 1, &wide, 120, 20, 1e-13, "a square higher than the box");
  shape_free(&four);
}

/* Random bodies of all kinds. */
static void scatter(Body *b, size_t n, Shape *const shapes[], int kinds, double R, double spread, const Box *box,
                    Rng *rng) {
  for (size_t i = 0; i < n; i++) {
    int k = (int)rng_below(rng, (uint64_t)kinds + 1);
    b[i] = body(k < kinds ? shapes[k] : NULL, R * (1 + spread * rng_uniform(rng)), box->side[0] * rng_uniform(rng),
                box->side[1] * rng_uniform(rng), k < kinds ? 2 * M_PI * rng_uniform(rng) : 0);
  }
}

enum { KINDS = 9, MANY = 400 };
static void all_shapes(Shape *shapes[KINDS]) {
  static const double needle[][2] = {{0, 0}, {50, -1}, {51, 0}, {3, 1}};
  Outcome out = {0};
  shapes[0] = shape_regular(3), shapes[1] = shape_regular(4), shapes[2] = shape_regular(5);
  shapes[3] = shape_convex(4, needle, &out);
  shapes[4] = shape_superellipse(1.5, 1.5), shapes[5] = shape_superellipse(2.2837, 1);
  shapes[6] = shape_superellipse(5, 50), shapes[7] = shape_superellipse(1, 0.5);
  shapes[8] = shape_superellipse(1.2, 0.7);
}

/* Moved, turned about in order, and with the box doubled, all is the same; and the points of a fine lattice agree. */
static void test_random(void) {
  Shape *shapes[KINDS];
  all_shapes(shapes);
  Rng rng = rng_stream(71, 0, RNG_TEST);
  static Body b[4 * MANY];
  static const double radius[] = {0.2, 0.4, 0.8, 3, 7};
  for (int k = 0; k < as_many(20, 60); k++) {
    double R = radius[k % 5];
    size_t n = R > 1 ? 1 + (size_t)k / 5 % 6 : 10 + 50 * (size_t)(k / 5 % 6);
    Box box = {2, {10, 8, 0}}, twice = {2, {20, 16, 0}};
    int kinds = k % 2 ? KINDS : 3;
    scatter(b, n, shapes, kinds, R, 0.7, &box, &rng);
    double perimeter, length, area = cover_area(b, n, &box, &perimeter);
    int64_t rows = cover_rows(b, n, &box, 1000, 800);
    gsl_test_abs((double)rows / 1000 / 800, area / 80, 2e-4, "points, R %g, n %zu", R, n);
    for (size_t i = 0; i < n; i++)
      for (size_t c = 0; c < 4; c++) {
        Body *copy = &b[c * n + i];
        *copy = b[i];
        if (c == 0)
          continue;
        copy->x += c % 2 ? 10 : 0;
        copy->y += c / 2 ? 8 : 0;
      }
    gsl_test_abs(cover_area(b, 4 * n, &twice, &length), 4 * area, 2e-12, "a box of four, R %g, n %zu", R, n);
    gsl_test_abs(length, 4 * perimeter, 1e-10, "its perimeter");
    double dx = 10 * rng_uniform(&rng), dy = 8 * rng_uniform(&rng);
    for (size_t i = 0; i < n; i++) {
      size_t j = (size_t)rng_below(&rng, n);
      Body other = b[i];
      b[i] = b[j], b[j] = other;
    }
    for (size_t i = 0; i < n; i++)
      b[i].x = box_wrap(b[i].x + dx, 10), b[i].y = box_wrap(b[i].y + dy, 8);
    gsl_test_abs(cover_area(b, n, &box, &length), area, 1e-12, "moved and mixed, R %g, n %zu", R, n);
    gsl_test_abs(length, perimeter, 1e-10, "its perimeter");
  }
  for (int k = 0; k < KINDS; k++)
    shape_free(&shapes[k]);
}

static void test_counts(void) {
  Shape *shapes[KINDS];
  all_shapes(shapes);
  Rng rng = rng_stream(72, 0, RNG_TEST);
  Body b[40];
  for (int k = 0; k < 20; k++) {
    Box box = {2, {7, 9, 0}};
    size_t n = k % 4 == 3 ? 2 : 12;
    scatter(b, n, shapes, KINDS, k % 4 == 3 ? 3 : 0.6, 0.5, &box, &rng);
    int columns = 37 + 17 * k, rows = 130 - 5 * k;
    gsl_test_int((int)cover_rows(b, n, &box, columns, rows), (int)cover_lattice(b, n, &box, columns, rows),
                 "rows count as points, %d", k);
  }
  for (int k = 0; k < 25; k++)
    b[k] = square_at(shapes[1], 1 + (k % 3), 0.25 + 0.5 * k, 8.75 - k % 4);
  for (int k = 0; k < 25; k++)
    b[k].x = box_wrap(b[k].x, 10), b[k].y = box_wrap(b[k].y, 10);
  for (int k = 1; k < 25; k++)
    gsl_test_int((int)cover_rows(b, (size_t)k, &square10, 20, 20), (int)cover_lattice(b, (size_t)k, &square10, 20, 20),
                 "edges on points, %d", k);
  for (int k = 0; k < KINDS; k++)
    shape_free(&shapes[k]);
}

/* Side by side at any angle: rounding alone decides what a boundary does in the other body. */
static void test_touching(void) {
  Shape *four = shape_regular(4), *round = shape_superellipse(1, 50), *long_one = shape_superellipse(5, 50);
  const Shape *kinds[] = {four, NULL, round, long_one};
  Rng rng = rng_stream(75, 0, RNG_TEST);
  double worst[4] = {0}, longest = 0, corner = 0, hidden = 0, tipped = 0;
  for (int k = 0; k < as_many(100, 5000); k++)
    for (int c = 0; c < 4; c++) {
      const Shape *shape = kinds[c];
      double angle = 2 * M_PI * rng_uniform(&rng), u, v;
      double R = 0.7 + rng_uniform(&rng), r = k % 2 ? R : 0.7 + rng_uniform(&rng);
      double d = c == 0 ? four->inner : c == 1 ? 1 : shape->b, along = k % 4 == 3 ? 0.3 * rng_uniform(&rng) : 0;
      elementary_turn(angle, &u, &v);
      d *= R + r;
      double x = 3 + 4 * rng_uniform(&rng), y = 3 + 4 * rng_uniform(&rng), turned = c ? angle - M_PI / 2 : angle + M_PI / 4;
      Body b[2] = {body(shape, R, x, y, turned), body(shape, r, x + d * u - along * v, y + d * v + along * u, turned)};
      double perimeter, area = cover_area(b, 2, NULL, &perimeter), all = M_PI * (R * R + r * r);
      worst[c] = GSL_MAX(worst[c], fabs(area - all));
      if (c == 0 && k % 2 && !along)
        longest = GSL_MAX(longest, fabs(perimeter - 6 * R * sqrt(M_PI)));
      if (c == 0 && k % 4 == 0) {
        double left = (k % 8 ? 1 : -1) * (GSL_MIN(R, r) - GSL_MAX(R, r)) * four->inner;
        Body in[2] = {b[R > r ? 0 : 1], b[R > r ? 1 : 0]};
        in[1].x = in[0].x + left * u, in[1].y = in[0].y + left * v;
        hidden = GSL_MAX(hidden, fabs(cover_area(in, 2, NULL, &perimeter) - M_PI * in[0].radius * in[0].radius));
        hidden = GSL_MAX(hidden, fabs(perimeter - 4 * in[0].radius * sqrt(M_PI)));
      }
      for (int inside = 0; inside < 2; inside++) {
        double small = 0.2 * r, way = R * four->inner + (inside ? -small : small) * four->outer;
        Body t[2] = {body(four, R, x, y, angle + M_PI / 4), body(four, small, x, y, inside ? angle : angle + M_PI)};
        t[1].x += way * u - 0.1 * along * v, t[1].y += way * v + 0.1 * along * u;
        Body back[2] = {t[1], t[0]};
        double want = M_PI * (R * R + (inside ? 0 : small * small)), sides = 4 * sqrt(M_PI) * (R + (inside ? 0 : small));
        tipped = GSL_MAX(tipped, fabs(cover_area(t, 2, NULL, &perimeter) - want));
        tipped = GSL_MAX(tipped, fabs(perimeter - sides));
        tipped = GSL_MAX(tipped, fabs(cover_area(back, 2, NULL, &perimeter) - want));
        tipped = GSL_MAX(tipped, fabs(perimeter - sides));
      }
      double edge = (k % 2 ? 10 : 0) + (k % 4 < 2 ? 1 : -1) * R * four->outer;
      Body tip = body(four, R, nextafter(box_wrap(edge, 10), k % 3 ? 20 * (k % 3 - 1) : edge), y, 0);
      corner = GSL_MAX(corner, fabs(cover_area(&tip, 1, &square10, &perimeter) - M_PI * R * R));
      corner = GSL_MAX(corner, fabs(perimeter - 4 * R * sqrt(M_PI)));
      Body tips[2] = {tip, tip};
      tips[1].x += k % 8 < 4 ? 0.3 : -0.3;
      tips[1].y += 0.8 * R;
      double tips_area = cover_area(tips, 2, NULL, NULL);
      tips[1].x = box_wrap(tips[1].x, 10);
      corner = GSL_MAX(corner, fabs(cover_area(tips, 2, &square10, NULL) - tips_area));
    }
  static const char *const name[] = {"squares", "discs", "rounded squares", "long ones"};
  for (int c = 0; c < 4; c++)
    gsl_test_abs(worst[c], 0, c < 2 ? 3e-14 : 3e-13, "%s side by side", name[c]);
  gsl_test_abs(longest, 0, 1e-13, "no common side is exposed");
  gsl_test_abs(hidden, 0, 1e-13, "a square at the side of one around it");
  gsl_test_abs(tipped, 0, 1e-13, "a corner on a side, from without and within");
  gsl_test_abs(corner, 0, 1e-13, "a corner on the line x = 0");
  shape_free(&four);
  shape_free(&round);
  shape_free(&long_one);
}

/* Two tips on sides, as found by a search: the ends of the arc that is hidden come out in the wrong order. */
static void test_tips(void) {
  Shape *four = shape_regular(4);
  Body one[] = {{four, 0x1.1c75cd3fe77fbp-2, 0x1.ec04a0337cbdp+0, 0x1.482feb272786ep+2, 0x1.61c3832bca09bp-1, -0x1.7220f054209aep-1},
                {four, 0x1.5e2215c9b0d48p+0, 3, 4, -0x1.ffde84f011998p-1, 0x1.724be5e76123bp-6}};
  Body two[] = {{four, 0x1.42821bf8b2f1dp-2, 0x1.116b839f60a2dp+2, 0x1.6424b5e705bccp+1, -0x1.71e209c284e54p-1, 0x1.620546eeb3607p-1},
                {four, 0x1.8aaa10a447208p+0, 3, 4, 0x1.ffe08b621acc5p-1, 0x1.66ec88927af2p-6}};
  double R = one[0].radius, r = one[1].radius, S = two[0].radius, s = two[1].radius;
  check(one, 2, NULL, M_PI * (R * R + r * r), 4 * sqrt(M_PI) * (R + r), 1e-14, "a tip on a side");
  check(two, 2, NULL, M_PI * (S * S + s * s), 4 * sqrt(M_PI) * (S + s), 1e-14, "another");
  shape_free(&four);
}

/* Two of all kinds share what they are not the union of; whoever comes first. */
static void test_pairs(void) {
  Shape *shapes[KINDS];
  all_shapes(shapes);
  Rng rng = rng_stream(73, 0, RNG_TEST);
  Box box = {2, {3, 3, 0}};
  double worst = 0, other = 0;
  int overlapping = 0;
  for (int k = 0; k < as_many(600, 20000); k++) {
    Body b[2];
    Overlap o;
    scatter(b, 2, shapes, KINDS, k % 3 ? 1 : 0.3, 1, &box, &rng);
    double perimeter, length, sum = M_PI * (b[0].radius * b[0].radius + b[1].radius * b[1].radius);
    double area = cover_area(b, 2, NULL, &perimeter);
    overlapping += overlap_find(&b[0], &b[1], &o);
    worst = GSL_MAX(worst, fabs(sum - o.area - area));
    Body swapped[] = {b[1], b[0]};
    other = GSL_MAX(other, fabs(cover_area(swapped, 2, NULL, &length) - area));
    other = GSL_MAX(other, fabs(length - perimeter));
    worst = GSL_MAX(worst, fabs(cover_exclusive(b, 2) - (M_PI * b[0].radius * b[0].radius - o.area)));
  }
  gsl_test(overlapping < 250, "%d pairs overlap", overlapping);
  gsl_test_abs(worst, 0, 1e-12, "a union is a sum less what is shared");
  gsl_test_abs(other, 0, 1e-12, "and does not depend on the order");
  for (int k = 0; k < KINDS; k++)
    shape_free(&shapes[k]);
}

/* Cases known to break libraries for polygons and ellipses. */
static void test_hard(void) {
  Shape *three = shape_regular(3), *five = shape_regular(5), *ellipse = shape_superellipse(50, 1);
  double side = sqrt(4 * M_PI / sqrt(3)), h = three->inner, little = 2e-8;
  Body b[2] = {body(three, 1, 4, 5, M_PI), body(three, 1, 4 + 2 * h + little, 5, 0)};
  check(b, 2, &square10, 2 * M_PI, 6 * side, 1e-13, "two triangles apart");
  b[1].x = 4 + 2 * h - little;
  check(b, 2, &square10, 2 * M_PI - side * little, 4 * side, 1e-7, "two triangles in one another");
  gsl_test_abs(cover_area(b, 2, &square10, NULL), 2 * M_PI - side * little, 1e-14, "their area");
  Body cross[2] = {body(ellipse, 1, 9.9, 5, 0), body(ellipse, 1, 9.9, 5, M_PI / 2)};
  double a = sqrt(50), t = 1 / a, shared = 4 * a * t * atan(t / a);
  gsl_test_abs(cover_area(cross, 2, NULL, NULL), 2 * M_PI - shared, 2e-14, "crossed needles");
  static Body many[5000];
  Box box = {2, {60, 60, 0}};
  Rng rng = rng_stream(74, 0, RNG_TEST);
  scatter(many, 5000, &five, 1, 0.5, 0.5, &box, &rng);
  double area = cover_area(many, 5000, &box, NULL);
  int64_t rows = cover_rows(many, 5000, &box, 1000, 1000);
  gsl_test_abs((double)rows / 1000 / 1000, area / 3600, 1e-4, "thousands");
  for (int k = 0; k < 5000; k++)
    many[k].x = box_wrap(many[k].x + 31.17, 60);
  gsl_test_rel(cover_area(many, 5000, &box, NULL), area, 2e-15, "thousands, moved");
  for (int k = 0; k < 256; k++)
    many[k] = body(five, 2.5, 6.25 * (k % 16), 6.25 * (k / 16), k);
  Box hundred = {2, {100, 100, 0}};
  gsl_test_rel(cover_area(many, 254, &hundred, NULL), 254 * M_PI * 6.25, 1e-15, "254 pentagons apart");
  shape_free(&three);
  shape_free(&five);
  shape_free(&ellipse);
}

int main(void) {
  test_discs();
  test_ties();
  test_random();
  test_counts();
  test_touching();
  test_tips();
  test_pairs();
  test_hard();
  return gsl_test_summary();
}
