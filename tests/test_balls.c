/* tests/test_balls.c: which sphere is seen in a pixel, how large a disc is, where the light is, what is far */
#include "balls.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 211, HEIGHT = 163 };
static const BallLook looks[] = {{{20, 70, 130}, {170, 210, 245}}, {{150, 60, 10}, {240, 180, 110}}};

static unsigned char *paint(size_t n, const Ball ball[]) {
  return balls_paint(n, ball, looks, -1.37, 2.61, 0.1, WIDTH, HEIGHT);
}

/* The colour where a point of the plane is. */
static const unsigned char *at(const unsigned char *rgb, double x, double y) {
  int i = (int)((y - 2.61) / 0.1), j = (int)((x + 1.37) / 0.1);
  return rgb + 3 * (i * WIDTH + j);
}

static int like(const unsigned char *rgb, const unsigned char *want) {
  return abs(rgb[0] - want[0]) <= 1 && abs(rgb[1] - want[1]) <= 1 && abs(rgb[2] - want[2]) <= 1;
}

/* The ink of all pixels: of a black ball in pixels. */
static double ink(const Ball *ball) {
  const BallLook black = {{0, 0, 0}, {0, 0, 0}};
  Ball one = *ball;
  one.look = 0;
  unsigned char *rgb = balls_paint(1, &one, &black, -1.37, 2.61, 0.1, WIDTH, HEIGHT);
  double sum = 0;
  for (int p = 0; p < WIDTH * HEIGHT; p++)
    sum += 1 - rgb[3 * p] / 255.0;
  free(rgb);
  return sum;
}

static void test_area(void) {
  Ball ball = {8.413, 10.772, 3, 5.2391, 0};
  double whole = M_PI * gsl_pow_2(ball.radius / 0.1);
  gsl_test_rel(ink(&ball), whole, 2e-3, "a disc has the area of its circle");
  ball.x = -1.37;
  gsl_test_rel(ink(&ball), whole / 2, 5e-3, "the left side cuts it in half");
  ball.y = 2.61 + 0.1 * HEIGHT;
  gsl_test_rel(ink(&ball), whole / 4, 1e-2, "and the upper side again");
  ball.x = 100;
  gsl_test(ink(&ball) != 0, "beyond the picture nothing is seen");
  Ball dot = {8.413, 10.772, 3, 0.01, 0};
  gsl_test(ink(&dot) > 1, "a ball below a pixel paints a part of it");
}

static void test_light(void) {
  const Ball ball = {7.2, 10.3, -2, 4.7, 0};
  unsigned char *rgb = paint(1, &ball), far[3] = {16, 56, 104};
  gsl_test(!like(at(rgb, 7.2 - 0.33 * 4.7, 10.3 + 0.36 * 4.7), (unsigned char[]){118, 161, 205}) &&
               !like(at(rgb, 7.2 - 0.33 * 4.7, 10.3 + 0.36 * 4.7), looks[0].top),
           "the top is where the light comes from");
  gsl_test(!like(at(rgb, 7.2, 10.3 - 0.985 * 4.7), far), "the edge is four fifths of the rim");
  const unsigned char *left = at(rgb, 7.2 - 3, 10.3 + 0.2), *right = at(rgb, 7.2 + 3, 10.3 + 0.2);
  gsl_test(left[1] <= right[1], "the left is lighter than the right");
  gsl_test(at(rgb, 1, 4)[0] != 255 || at(rgb, 1, 4)[2] != 255, "around it is white");
  free(rgb);
}

static void test_depth(void) {
  /* the small one is behind by its centre, and its surface is before */
  const Ball both[] = {{6, 10, 1.00, 4, 0}, {9.4, 10, 0.9, 2.2, 1}};
  for (int order = 0; order < 2; order++) {
    const Ball list[] = {both[order], both[1 - order]};
    unsigned char *rgb = paint(2, list);
    const unsigned char *out = at(rgb, 9.6, 10.1), *in = at(rgb, 6, 10.1);
    gsl_test(out[0] <= out[2], "a small ball looks out of a large one, order %d", order);
    gsl_test(in[2] <= in[0], "which covers the rest, order %d", order);
    free(rgb);
  }
}

static void test_fog(void) {
  const Ball all[] = {{4, 10, -7, 2, 0}, {12, 10, 5, 2, 0}, {8, 10, -1, 1.9, 0}};
  unsigned char *rgb = paint(3, all);
  double light[3];
  for (int k = 0; k < 3; k++)
    light[k] = at(rgb, all[k].x - 0.33 * all[k].radius, 10 + 0.36 * all[k].radius)[1];
  gsl_test_rel(light[0], 70 + 0.35 * 140, 0.01, "the farthest is dim");
  gsl_test_rel(light[1], 210, 0.01, "the nearest is not");
  gsl_test_rel(light[2], 70 + 0.675 * 140, 0.01, "half the way between them");
  free(rgb);
}

static void test_bytes(void) {
  enum { N = 300 };
  static Ball ball[N], turned[N];
  double x = 0.31;
  for (int i = 0; i < N; i++) {
    double *to[] = {&ball[i].x, &ball[i].y, &ball[i].depth, &ball[i].radius};
    for (int k = 0; k < 4; k++)
      *to[k] = 15 * (x = 3.9 * x * (1 - x));
    ball[i].radius = 0.1 + ball[i].radius / 12;
    ball[i].look = i % 2;
    turned[N - 1 - i] = ball[i];
  }
  unsigned char *a = paint(N, ball), *b = paint(N, turned);
  gsl_test(memcmp(a, b, 3 * WIDTH * HEIGHT), "the order of the balls is of no consequence");
  free(a);
  free(b);
}

int main(void) {
  test_area();
  test_light();
  test_depth();
  test_fog();
  test_bytes();
  exit(gsl_test_summary());
}
