#ifndef TABLES_H
#define TABLES_H
#include "ensemble.h"
void tables_write(Ensemble *all, int combinations, const char *directory,
Outcome *out);
void tables_plan(const Ensemble *one, FILE *file);
#endif
