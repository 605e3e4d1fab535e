#include "balls.h"
#include "outcome.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
enum { FINE = 3, STRIP = 16, TABLE = 256 };
typedef struct {
double depth;
unsigned char colour[3];
} Point;
typedef struct {
double x, y, step;
int columns, rows;
double near, far;
const float *light;
Point *point;
} Canvas;
static float light_at(double u, double v) {
const double cx = -0.33, cy = 0.36, r = 0.97, dr = 0.85;
double alpha = cx * cx + cy * cy - dr * dr;
double beta = u * cx + v * cy - r * dr, gamma = u * u + v * v - r * r;
if (gamma > 0)
return -1;
double t = (beta + sqrt(beta * beta - alpha * gamma)) / alpha;
return (float)(t < 1 ? t * t : 1);
}
static float *tabulate_light(void) {
float *light = memory(TABLE * TABLE, sizeof *light);
for (int i = 0; i < TABLE; i++)
for (int j = 0; j < TABLE; j++)
light[i * TABLE + j] =
light_at((2 * j + 1.0) / TABLE - 1, (2 * i + 1.0) / TABLE - 1);
return light;
}
static void colour_point(const Canvas *c, double u, double v, double fog,
const BallLook *look, unsigned char colour[3]) {
int i = GSL_MIN_INT((int)((v + 1) / 2 * TABLE), TABLE - 1);
int j = GSL_MIN_INT((int)((u + 1) / 2 * TABLE), TABLE - 1);
double f = c->light[i * TABLE + j];
for (int k = 0; k < 3; k++) {
double rim = look->rim[k];
double lit = f < 0 ? 0.8 * rim : rim + f * fog * (look->top[k] - rim);
colour[k] = (unsigned char)(lit + 0.5);
}
}
static void paint_ball(const Canvas *c, int row, const Ball *ball,
const BallLook *look) {
double a = ball->radius, x = (ball->x - c->x) / c->step;
double y = (ball->y - c->y) / c->step - row, r = a / c->step;
double all = c->near - c->far,
fog = all > 0 ? (ball->depth - c->far) / all : 1;
int low = (int)fmax(ceil(y - r), 0), high = (int)fmin(y + r, c->rows - 1);
for (int i = low; i <= high; i++) {
double v = (i - y) / r, w = sqrt(fmax(1 - v * v, 0));
int from = (int)fmax(ceil(x - r * w), 0);
int to = (int)fmin(floor(x + r * w), c->columns - 1);
for (int j = from; j <= to; j++) {
double u = (j - x) / r, up = sqrt(fmax(1 - u * u - v * v, 0));
Point *point = &c->point[(size_t)i * (size_t)c->columns + (size_t)j];
double depth = ball->depth + a * up;
if (depth > point->depth) {
point->depth = depth;
colour_point(c, u, v, 0.35 + 0.65 * fog, look, point->colour);
}
}
}
}
static void shrink(const Canvas *c, int width, int height,
unsigned char *pixels) {
for (int i = 0; i < height; i++)
for (int j = 0; j < width; j++)
for (int k = 0; k < 3; k++) {
int sum = 0;
for (int a = 0; a < FINE; a++)
for (int b = 0; b < FINE; b++)
sum +=
c->point[(i * FINE + a) * c->columns + j * FINE + b].colour[k];
*pixels++ = (unsigned char)((sum + FINE * FINE / 2) / (FINE * FINE));
}
}
static void clear_strip(const Canvas *c) {
size_t n = (size_t)c->columns * (size_t)c->rows;
for (size_t p = 0; p < n; p++)
c->point[p] = (Point){-INFINITY, {255, 255, 255}};
}
static void find_depths(size_t n, const Ball ball[], Canvas *c) {
c->near = -INFINITY;
c->far = INFINITY;
for (size_t i = 0; i < n; i++) {
c->near = fmax(c->near, ball[i].depth);
c->far = fmin(c->far, ball[i].depth);
}
}
unsigned char *balls_paint(size_t n, const Ball ball[], const BallLook look[],
double x, double y, double pixel, int width,
int height) {
unsigned char *pixels = memory((size_t)width * (size_t)height, 3);
double step = pixel / FINE;
float *light = tabulate_light();
Canvas c = {x + step / 2, y + step / 2, step, FINE * width, FINE * STRIP};
find_depths(n, ball, &c);
c.light = light;
c.point = memory((size_t)c.columns * (size_t)c.rows, sizeof *c.point);
for (int row = 0; row < height; row += STRIP) {
clear_strip(&c);
for (size_t i = 0; i < n; i++)
paint_ball(&c, FINE * row, &ball[i], &look[ball[i].look]);
shrink(&c, width, GSL_MIN_INT(STRIP, height - row),
pixels + (size_t)row * (size_t)width * 3);
}
free(c.point);
free(light);
return pixels;
}
