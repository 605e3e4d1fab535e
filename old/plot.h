#ifndef PLOT_H
#define PLOT_H
#include "outcome.h"
typedef struct PlotSeen PlotSeen;
PlotSeen *plot_look(const char *directory);
int plot_new(PlotSeen **seen, const char *directory, const char *format,
Outcome *out);
enum { PLOT_MOST = 8 };
int plot_tables(const char *const path[], int n, const char *picture,
Outcome *out);
#endif
