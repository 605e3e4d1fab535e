#ifndef CALCULATE_H
#define CALCULATE_H
#include "outcome.h"
#include <stdio.h>
int calculate(const char *name, const char *phi, const char *at, FILE *file,
Outcome *out);
void calculate_help(FILE *file);
#endif
