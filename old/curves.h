#ifndef CURVES_H
#define CURVES_H
#include "graph.h"
void curves_of_tables(Graph *graph, Sheet *const sheet[],
const char *const label[], int n);
void curves_of_sweep(Graph *graph, const Sheet *sheet);
bool curves_surface(const Sheet *sheet, const char *picture, Outcome *out);
#endif
