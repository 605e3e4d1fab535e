#ifndef COST_H
#define COST_H
#include "scene.h"
#include <stdio.h>
int cost_tell(const Scene *scene, int threads, FILE *file, Outcome *out);
double cost_grown(const double n[2], const double value[2], double to,
double *power);
double cost_straight(const double n[2], const double value[2], double to);
#endif
