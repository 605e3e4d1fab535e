#ifndef PEAKS_H
#define PEAKS_H
#include "ensemble.h"
typedef struct {
int curve;
double zero, unit;
const double *within;
bool gap;
const char *word, *pair;
} Peak;
void peaks_add(const Means *means, const Peak *peak);
#endif
