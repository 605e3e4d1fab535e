#ifndef GRAPH_H
#define GRAPH_H
#include "drawing.h"
#include "sheet.h"
enum { GRAPH_PANELS = 24, GRAPH_COLOURS = 8 };
typedef struct {
double *point;
size_t n;
int panel, sheet, colour;
bool theory, bars;
char title[160];
} GraphLine;
typedef struct {
char stem[160], label[160];
double low, high;
double left, bottom, right, top;
int lines, rows;
} GraphPanel;
typedef struct {
GraphLine *line;
int lines;
GraphPanel panel[GRAPH_PANELS];
int panels, across, left_out;
bool one_key;
double low, high;
char label[160];
const char **word;
int words;
const Sheet *first;
const char *swept;
} Graph;
GraphLine *graph_line(Graph *graph);
void graph_point(GraphLine *line, double x, double y, double error);
void graph_end(Graph *graph, GraphLine *line);
void graph_free(Graph *graph);
void graph_draw(Graph *graph, const char *picture, Outcome *out);
void graph_header(const Drawing *drawing, const Sheet *sheet, const char *swept,
int left_out);
double graph_step(double low, double high, int most);
#endif
