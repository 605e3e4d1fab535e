#include "graph.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
void graph_free(Graph *g) {
for (int l = 0; l < g->lines; l++)
free(g->line[l].point);
free(g->line);
free(g->word);
}
GraphLine *graph_line(Graph *g) {
g->line = memory_grow(g->line, (size_t)g->lines + 1, sizeof *g->line);
g->line[g->lines] = (GraphLine){0};
return &g->line[g->lines++];
}
void graph_point(GraphLine *line, double x, double y, double error) {
if (!gsl_finite(x) || !gsl_finite(y))
return;
line->point = memory_grow(line->point, 3 * (line->n + 1), sizeof(double));
double *point = line->point + 3 * line->n++;
point[0] = x;
point[1] = y;
point[2] = gsl_finite(error) ? error : 0;
line->bars |= point[2] > 0;
}
void graph_end(Graph *g, GraphLine *line) {
GraphPanel *panel = &g->panel[line->panel];
if (line->n == 0) {
g->lines--;
return;
}
bool first = g->lines == 1;
for (size_t p = 0; p < line->n; p++) {
const double *at = line->point + 3 * p;
g->low = first && p == 0 ? at[0] : fmin(g->low, at[0]);
g->high = first && p == 0 ? at[0] : fmax(g->high, at[0]);
bool begin = panel->lines == 0 && p == 0;
panel->low = begin ? at[1] - at[2] : fmin(panel->low, at[1] - at[2]);
panel->high = begin ? at[1] + at[2] : fmax(panel->high, at[1] + at[2]);
}
panel->lines++;
}
enum { LETTERS = 70 };
static bool has_key(const Graph *g, int p) {
return g->panel[p].lines > 1 && (p == 0 || !g->one_key);
}
static int key_columns(const Graph *g, int p, double *widest) {
double wide = g->across > 1 ? 15 : 10.5;
*widest = 0;
for (int l = 0; l < g->lines; l++)
if (g->line[l].panel == p)
*widest = fmax(*widest, 1.1 + 0.165 * (double)strlen(g->line[l].title));
return GSL_MAX_INT((int)(wide / *widest), 1);
}
static int key_rows(const Graph *g, int p) {
double widest;
int columns = key_columns(g, p, &widest);
return has_key(g, p) ? (g->panel[p].lines + columns - 1) / columns : 0;
}
static int break_line(const char *text) {
size_t length = strlen(text), at = LETTERS;
if (length <= LETTERS)
return (int)length;
while (at > 0 && text[at] != ' ')
at--;
return at > 0 ? (int)at : LETTERS;
}
static int count_lines(const char *text) {
int lines = 0;
while (*text && lines < 3) {
text += break_line(text);
text += *text == ' ';
lines++;
}
return lines;
}
static double lay_out(Graph *g, double width) {
static const double high[] = {5.6, 4.2, 3.2};
bool grid = g->across > 1;
double h = grid ? 2.2 : high[GSL_MIN_INT(g->panels, 3) - 1];
double y = -0.3 - 0.36 * count_lines(g->first->what);
double step = (width - 0.4) / g->across, top = y;
for (int p = 0; p < g->panels; p++) {
GraphPanel *panel = &g->panel[p];
int column = p % g->across;
panel->rows = key_rows(g, p);
if (column == 0)
top = y -= 0.15 + 0.4 * panel->rows + (grid ? 0.45 : 0);
panel->left = column * step + (grid ? 1.3 : 1.8);
panel->right = grid ? (column + 1) * step : width - 0.4;
panel->top = top;
panel->bottom = top - h;
y = top - h - (grid ? 0.3 : 0.1);
}
double height = -y + 1.6;
for (int p = 0; p < g->panels; p++) {
g->panel[p].top += height;
g->panel[p].bottom += height;
}
return height;
}
static void widen(double *low, double *high, double zero) {
double more = 0.04 * (*high - *low);
if (!(more > 1e-12 * fmax(fabs(*low), fabs(*high))))
more = *low != 0 ? 0.1 * fabs(*low) : 1;
bool floor = *low >= 0 && *low < zero * *high;
*low = floor ? 0 : *low - more;
*high += more;
}
double graph_step(double low, double high, int most) {
double step = pow(10, floor(log10((high - low) / most)));
if (step * most < high - low)
step *= 2;
if (step * most < high - low)
step *= 2.5;
return step * most < high - low ? 2 * step : step;
}
static void write_data(FILE *file, const Graph *g) {
for (int l = 0; l < g->lines; l++) {
const GraphLine *line = &g->line[l];
fprintf(file, "$line%d << EOD\n", l);
for (size_t p = 0; p < line->n; p++)
fprintf(file, "%.9g %.9g %.9g\n", line->point[3 * p],
line->point[3 * p + 1], line->point[3 * p + 2]);
fputs("EOD\n", file);
}
}
static void write_axes(const Drawing *d, const Graph *g, int p) {
const GraphPanel *panel = &g->panel[p];
double corner[] = {panel->left, panel->bottom, panel->right, panel->top};
double x[] = {g->low, g->high}, y[] = {panel->low, panel->high};
bool grid = g->across > 1, last = p + g->across >= g->panels;
FILE *file = d->script;
drawing_axes(d, corner);
widen(&x[0], &x[1], 0.1);
widen(&y[0], &y[1], 0.35);
if (g->word)
x[0] = -0.5, x[1] = g->words - 0.5;
fprintf(file, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", x[0], x[1],
y[0], y[1]);
fprintf(file, "set xtics %.9g\nset ytics %.9g\n",
graph_step(x[0], x[1], grid ? 5 : 8),
graph_step(y[0], y[1], grid || g->panels > 2 ? 5 : 7));
fprintf(file, "set format x '%s'\nset xlabel ", last ? "%h" : "");
drawing_text(d, last ? g->label : "");
fputs(" offset 0,0.3\nset ylabel ", file);
drawing_text(d, grid ? "" : panel->label);
fputs(" offset 0.5\n", file);
if (grid)
fputs("set ytics font ',6'\nset xtics font ',6'\n", file);
if (g->word) {
fputs("set xtics rotate by 25 right (", file);
for (int w = 0; w < g->words; w++) {
fputs(w ? "," : "", file);
drawing_text(d, last ? g->word[w] : "");
fprintf(file, " %d", w);
}
fputs(")\n", file);
}
if (grid)
drawing_words(d, panel->left, panel->top + 0.25, "left", 6.5, panel->label);
}
static bool is_dashed(const GraphLine *line) {
return line->theory && (line->sheet > 0 || line->colour < 7);
}
static void write_line(const Drawing *d, const Graph *g, int l) {
const GraphLine *line = &g->line[l];
double size = line->n > 250 ? 0.12 : line->n > 100 ? 0.18 : 0.28;
size *= d->points;
FILE *file = d->script;
if (line->theory) {
fprintf(file, "$line%d using 1:2 with lines lt %d lw 1%s", l, line->colour,
is_dashed(line) ? " dt 2" : "");
} else if (line->bars) {
fprintf(file, "$line%d using 1:2 with lines lt %d lw 0.6, ", l,
line->colour);
fprintf(file, "$line%d using 1:2:3 with yerrorbars lt %d lw 0.6 ps %g", l,
line->colour, size);
} else if (line->n > 60)
fprintf(file, "$line%d using 1:2 with lines lt %d lw 0.8", l, line->colour);
else
fprintf(file, "$line%d using 1:2 with linespoints lt %d lw 0.8 ps %g", l,
line->colour, size);
}
static void write_key(const Drawing *d, const Graph *g, int p) {
double widest, left = g->panel[p].left + 0.1;
double top = g->panel[p].top + (g->across > 1 ? 0.75 : 0.3);
int columns = key_columns(g, p, &widest), rows = key_rows(g, p), at = 0;
for (int l = 0; l < g->lines; l++) {
const GraphLine *line = &g->line[l];
char style[32], point[48] = "";
if (line->panel != p)
continue;
snprintf(style, sizeof style, "lt %d%s", line->colour,
is_dashed(line) ? " dt 2" : "");
if (!line->theory)
snprintf(point, sizeof point, "lt %d ps %g", line->colour,
0.3 * d->points);
drawing_key(d, left + at % columns * widest,
top + 0.4 * (rows - 1 - at / columns), 0.55, style, point,
line->title);
at++;
}
}
static void write_panel(const Drawing *d, const Graph *g, int p) {
bool begun = false;
write_axes(d, g, p);
if (has_key(g, p))
write_key(d, g, p);
for (int l = 0; l < g->lines; l++)
if (g->line[l].panel == p) {
fputs(begun ? ", " : "plot ", d->script);
write_line(d, g, l);
begun = true;
}
fputs("\nunset label\nunset arrow\n", d->script);
}
void graph_header(const Drawing *d, const Sheet *s, const char *swept,
int left_out) {
const char *text = s->what, *origin = s->origin;
double y = d->height - 0.3;
for (int lines = count_lines(text); lines > 0; lines--, y -= 0.36) {
char line[LETTERS + 1];
int length = break_line(text);
snprintf(line, sizeof line, "%.*s", length, text);
drawing_words(d, 0.3, y, "left", 7, line);
text += length + (text[length] == ' ');
}
char note[400];
if (strncmp(origin, "scene ", 6) == 0)
origin += 6;
snprintf(note, sizeof note, "%.300s%s", origin,
*swept || left_out ? "; " : "");
size_t at = strlen(note);
if (left_out)
snprintf(note + at, sizeof note - at, "%d more in the table", left_out);
else
snprintf(note + at, sizeof note - at, "%.90s", swept);
drawing_words(d, d->width - 0.2, 0.2, "right", 5, note);
}
void graph_draw(Graph *g, const char *picture, Outcome *out) {
Drawing d;
double width = g->across > 1 ? 17 : 12.6, height = lay_out(g, width);
if (drawing_open(&d, picture, width, height, out) == DONE) {
write_data(d.script, g);
fputs("set multiplot\n", d.script);
graph_header(&d, g->first, g->swept, g->left_out);
for (int p = 0; p < g->panels; p++)
write_panel(&d, g, p);
fputs("unset multiplot\n", d.script);
}
drawing_close(&d, out);
}
