#include "curves.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
static int panel_of(Graph *g, const SheetTrace *t) {
for (int p = 0; p < g->panels; p++)
if (strcmp(g->panel[p].stem, t->stem) == 0)
return p;
if (t->theory && g->panels > 0)
return 0;
if (g->panels == 6)
return g->left_out++, -1;
GraphPanel *panel = &g->panel[g->panels];
snprintf(panel->stem, sizeof panel->stem, "%s", t->stem);
snprintf(panel->label, sizeof panel->label, "%s", t->name);
return g->panels++;
}
static bool has_line(const Graph *g, int panel, int sheet) {
for (int l = 0; l < g->lines; l++)
if (g->line[l].panel == panel && g->line[l].sheet == sheet)
return true;
return false;
}
static void add_trace(Graph *g, const Sheet *s, const SheetTrace *t, int sheet,
const char *label, bool one) {
int panel = panel_of(g, t);
if (panel < 0 || (one && has_line(g, panel, sheet)))
return;
GraphLine *line = graph_line(g);
line->panel = panel;
line->sheet = sheet;
line->theory = t->theory;
snprintf(line->title, sizeof line->title, "%s%s%s", label, *label ? " " : "",
t->name);
for (size_t r = t->from; r < s->rows; r += t->step)
if (!t->species || strcmp(s->cell[r * s->columns], t->species) == 0)
graph_point(line, sheet_number(s, r, t->x), sheet_number(s, r, t->y),
t->error ? sheet_number(s, r, t->error) : GSL_NAN);
graph_end(g, line);
if (g->panel[panel].lines == 0)
g->panels--;
}
static bool one_name(const Graph *g, int panel) {
const GraphLine *first = NULL;
for (int l = 0; l < g->lines; l++) {
if (g->line[l].panel != panel || g->line[l].theory)
continue;
if (first && g->line[l].sheet == first->sheet)
return false;
first = first ? first : &g->line[l];
}
return true;
}
static void label_panel(Graph *g, int p, const char *place) {
char unit[16], name[160];
GraphPanel *panel = &g->panel[p];
snprintf(name, sizeof name, "%s",
one_name(g, p) ? panel->label : panel->stem);
sheet_unit(g->first, name, g->panels == 1, unit);
int size = (int)sizeof panel->label - 48;
snprintf(panel->label, sizeof panel->label, "%.*s%s%.16s%s%s%s", size, name,
strlen(name) < 4 && *name ? "(" : "",
strlen(name) < 4 && *name ? place : "",
strlen(name) < 4 && *name ? ")" : "", *unit ? "  in " : "", unit);
}
static void label_place(Graph *g, const char *place) {
const char *at =
strcmp(place, "R") == 0 ? strstr(g->first->what, "R = ") : NULL;
int length = at ? (int)strcspn(at + 4, " ;,") : 0;
snprintf(g->label, sizeof g->label, "%s%s%.*s", place,
strcmp(place, "R") ? "" : " = ", length ? length : 3,
length ? at + 4
: strcmp(place, "R") == 0 ? "r/a"
: "");
}
static void shorten_titles(Graph *g, const char *const label[]) {
for (int l = 0; l < g->lines; l++) {
GraphLine *line = &g->line[l];
if (!line->theory && *label[line->sheet] && one_name(g, line->panel))
snprintf(line->title, sizeof line->title, "%s", label[line->sheet]);
}
}
void curves_of_tables(Graph *g, Sheet *const sheet[], const char *const label[],
int n) {
enum { TRACES = 64 };
SheetTrace trace[TRACES];
const char *place = "";
g->first = sheet[0];
g->swept = sheet[0]->swept;
g->across = 1;
for (int s = 0; s < n; s++) {
int traces = sheet_traces(sheet[s], trace, TRACES);
for (int t = 0; t < traces; t++)
add_trace(g, sheet[s], &trace[t], s, label[s], n > 2);
place = s == 0 && traces ? sheet[0]->name[trace[0].x] : place;
g->swept = strcmp(sheet[s]->swept, g->swept) == 0 ? g->swept : "";
}
g->one_key = n > 1;
for (int p = 0; p < g->panels; p++) {
g->one_key &= one_name(g, p) && g->panel[p].lines == g->panel[0].lines;
label_panel(g, p, place);
}
label_place(g, place);
shorten_titles(g, label);
for (int p = 0; p < g->panels; p++) {
int measured = 0, theory = 0;
for (int l = 0; l < g->lines; l++) {
GraphLine *line = &g->line[l];
if (line->panel == p && line->theory)
line->colour = n > 1 ? line->sheet + 1 : 7 + theory++;
else if (line->panel == p)
line->colour = n > 1 && one_name(g, p) ? line->sheet + 1 : ++measured;
}
}
}
static bool is_number(const Sheet *s, size_t c) {
for (size_t r = 0; r < s->rows; r++)
if (!gsl_finite(sheet_number(s, r, c)))
return false;
return true;
}
static size_t first_row(const Sheet *s, size_t row, size_t c) {
size_t r = 0;
while (strcmp(s->cell[r * s->columns + c], s->cell[row * s->columns + c]))
r++;
return r;
}
static size_t different(const Sheet *s, size_t c) {
size_t count = 0;
for (size_t r = 0; r < s->rows; r++)
count += first_row(s, r, c) == r;
return count;
}
static size_t choose_axis(const Sheet *s, size_t keys) {
size_t best = keys;
for (size_t c = 0; c < keys; c++)
if (is_number(s, c) &&
(best == keys || different(s, c) > different(s, best)))
best = c;
return best < keys ? best : 0;
}
static void list_words(Graph *g, const Sheet *s, size_t axis) {
if (is_number(s, axis))
return;
g->word = memory(s->rows, sizeof *g->word);
for (size_t r = 0; r < s->rows; r++)
if (first_row(s, r, axis) == r)
g->word[g->words++] = s->cell[r * s->columns + axis];
}
static double place_on(const Graph *g, const Sheet *s, size_t row,
size_t axis) {
int w = 0;
if (!g->word)
return sheet_number(s, row, axis);
while (strcmp(g->word[w], s->cell[row * s->columns + axis]) != 0)
w++;
return w;
}
static bool of_curve(const Sheet *s, size_t row, size_t other, size_t axis,
size_t keys) {
for (size_t c = 0; c < keys; c++)
if (c != axis && strcmp(s->cell[row * s->columns + c],
s->cell[other * s->columns + c]) != 0)
return false;
return true;
}
static bool changes(const Sheet *s, size_t c) {
double low = GSL_POSINF, high = GSL_NEGINF;
for (size_t r = 0; r < s->rows; r++) {
double value = sheet_number(s, r, c);
low = gsl_finite(value) ? fmin(low, value) : low;
high = gsl_finite(value) ? fmax(high, value) : high;
}
return high - low > 1e-9 * fmax(fabs(low), fabs(high));
}
static bool is_before(const Sheet *s, size_t c) {
const char *name = s->name[c];
for (size_t k = c; strncmp(name, "made.", 5) == 0 && k < s->columns; k++)
if (strncmp(s->name[k], "shaken.", 7) == 0 &&
strcmp(s->name[k] + 7, name + 5) == 0)
return true;
return false;
}
static void name_curve(const Sheet *s, size_t row, size_t axis, size_t keys,
char title[160]) {
*title = '\0';
for (size_t c = 0; c < keys; c++) {
size_t length = strlen(title);
const char *dot = strrchr(s->name[c], '.');
if (c != axis)
snprintf(title + length, 160 - length, "%s%s = %s", length ? ", " : "",
dot ? dot + 1 : s->name[c], s->cell[row * s->columns + c]);
}
}
static void add_quantity(Graph *g, const Sheet *s, size_t c, size_t axis,
size_t keys) {
GraphPanel *panel = &g->panel[g->panels];
int curves = 0;
snprintf(panel->label, sizeof panel->label, "%s", s->name[c]);
for (size_t r = 0; r < s->rows && curves < GRAPH_COLOURS; r++) {
size_t before = 0;
while (before < r && !of_curve(s, before, r, axis, keys))
before++;
if (before < r)
continue;
GraphLine *line = graph_line(g);
line->panel = g->panels;
line->colour = ++curves;
name_curve(s, r, axis, keys, line->title);
for (size_t q = r; q < s->rows; q++)
if (of_curve(s, r, q, axis, keys))
graph_point(line, place_on(g, s, q, axis), sheet_number(s, q, c),
sheet_number(s, q, c + 1));
graph_end(g, line);
}
g->panels += panel->lines > 0;
}
void curves_of_sweep(Graph *g, const Sheet *s) {
size_t keys = sheet_places(s), axis = choose_axis(s, keys);
g->first = s;
g->swept = "";
g->across = 4;
g->one_key = true;
snprintf(g->label, sizeof g->label, "%s", s->name[axis]);
list_words(g, s, axis);
for (size_t c = keys; keys && c + 1 < s->columns; c += 2)
if (!changes(s, c) || is_before(s, c) ||
strcmp(s->name[c], s->name[axis]) == 0)
continue;
else if (g->panels < GRAPH_PANELS)
add_quantity(g, s, c, axis, keys);
else
g->left_out++;
}
enum { MAPS = 6 };
typedef struct {
size_t from[MAPS + 1];
int maps, left_out;
} Maps;
static Maps find_maps(const Sheet *s) {
Maps m = {{0}, 0, 0};
for (size_t r = 0; r < s->rows; r++)
if (r == 0 ||
strcmp(s->cell[r * s->columns], s->cell[(r - 1) * s->columns]) != 0) {
if (m.maps < MAPS)
m.from[m.maps++] = r;
else if (m.left_out++ == 0)
m.from[MAPS] = r;
}
if (!m.left_out)
m.from[m.maps] = s->rows;
return m;
}
static bool find_span(const Sheet *s, size_t c, double span[3]) {
span[0] = span[1] = GSL_POSINF;
span[2] = GSL_NEGINF;
for (size_t r = 0; r < s->rows; r++) {
span[0] = fmin(span[0], sheet_number(s, r, c));
span[2] = fmax(span[2], sheet_number(s, r, c));
}
for (size_t r = 0; r < s->rows; r++)
if (sheet_number(s, r, c) > span[0])
span[1] = fmin(span[1], sheet_number(s, r, c));
return span[1] < GSL_POSINF;
}
static void write_map(const Drawing *d, const Sheet *s, const Maps *m, int k,
const double span[2][3]) {
FILE *file = d->script;
double x = 1.8 + 4.7 * (k % 3), top = d->height - 1.4 - 5.2 * (k / 3);
double corner[] = {x, top - 3.7, x + 3.7, top};
char title[160];
fprintf(file, "$map << EOD\n");
for (size_t r = m->from[k]; r < m->from[k + 1]; r++)
fprintf(file, "%.9g %.9g %.9g\n", sheet_number(s, r, 1),
sheet_number(s, r, 2), sheet_number(s, r, 3));
fputs("EOD\n", file);
drawing_axes(d, corner);
for (int c = 0; c < 2; c++) {
double half = (span[c][1] - span[c][0]) / 2;
fprintf(file, "set %crange [%.9g:%.9g]\nset %ctics %.9g\nset %clabel ",
'x' + c, span[c][0] - half, span[c][2] + half, 'x' + c,
graph_step(span[c][0], span[c][2], 4), 'x' + c);
drawing_text(d, c && k % 3 ? "" : s->name[1 + c]);
fputs(c ? " offset 1.5\n" : " offset 0,0.4\n", file);
}
snprintf(title, sizeof title, "%s = %s", s->name[0],
s->cell[m->from[k] * s->columns]);
drawing_words(d, x, top + 0.3, "left", 7, title);
fputs("plot $map using 1:2:3 with image notitle\nunset label\n"
"unset colorbox\n",
file);
}
bool curves_surface(const Sheet *s, const char *picture, Outcome *out) {
Maps m = find_maps(s);
double span[2][3], values[3];
bool good = find_span(s, 1, span[0]) & find_span(s, 2, span[1]) &
find_span(s, 3, values);
int rows = (m.maps + 2) / 3, columns = GSL_MIN_INT(m.maps, 3);
double width = fmax(2.6 + 4.7 * columns, 12.6), height = 1.6 + 5.2 * rows;
Drawing d;
if (!good)
return false;
if (drawing_open(&d, picture, width, height, out) == DONE) {
fprintf(d.script,
"set palette defined (0 '#f4f8fb', 0.35 '#8cc0e0', 0.7 '#2171b5', "
"1 '#08306b')\nset border 15\nset cbrange [%.9g:%.9g]\n"
"set colorbox user origin screen %.6f, screen %.6f size screen "
"%.6f, screen %.6f\nset cbtics font ',6'\nset cblabel offset -1 ",
values[0], values[2], (1.1 + 4.7 * columns) / width,
(height - 5.1) / height, 0.25 / width, 3.7 / height);
drawing_text(&d, s->name[3]);
fputs("\nset multiplot\n", d.script);
graph_header(&d, s, s->swept, m.left_out);
for (int k = 0; k < m.maps; k++)
write_map(&d, s, &m, k, (const double(*)[3])span);
fputs("unset multiplot\n", d.script);
}
drawing_close(&d, out);
return true;
}
