#ifndef BALLS_H
#define BALLS_H
#include <stddef.h>
typedef struct {
double x, y, depth, radius;
int look;
} Ball;
typedef struct {
unsigned char rim[3], top[3];
} BallLook;
unsigned char *balls_paint(size_t n, const Ball ball[], const BallLook look[],
double x, double y, double pixel, int width,
int height);
#endif
