#ifndef DRAWING_H
#define DRAWING_H
#include "table.h"
typedef struct {
FILE *script;
double width, height;
double points;
int format;
Table table;
} Drawing;
int drawing_possible(Outcome *out);
int drawing_format(const char *name, Outcome *out);
int drawing_open(Drawing *drawing, const char *path, double width,
double height, Outcome *out);
int drawing_close(Drawing *drawing, Outcome *out);
void drawing_text(const Drawing *drawing, const char *text);
void drawing_axes(const Drawing *drawing, const double corner[4]);
void drawing_words(const Drawing *drawing, double x, double y, const char *how,
double points, const char *text);
void drawing_key(const Drawing *drawing, double x, double y, double wide,
const char *line, const char *point, const char *text);
#endif
