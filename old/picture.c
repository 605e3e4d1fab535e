#include "picture.h"
#include "balls.h"
#include "cells.h"
#include "core.h"
#include "drawing.h"
#include "elementary.h"
#include "files.h"
#include "overlap.h"
#include "sections.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
static int read_frame(const char *text, long *frame, Outcome *out) {
char *end = NULL;
*frame = text ? strtol(text, &end, 10) : 0;
if (text && (end == text || *end || *frame < 0))
return outcome_set(out, WRONG,
"--frame %s: give a whole number, the first pack is 0",
text);
return DONE;
}
static Pack *read_pack(const char *path, const PictureView *view,
Outcome *out) {
GatherKnown known = {0};
Box box = {0};
const Scene *scene = view->scene;
PackFile file;
Pack *pack = NULL;
long frame, at = 0;
if (scene) {
known = (GatherKnown){scene->dimension, scene->species, scene->kinds,
scene->fraction};
box.dim = scene->dimension;
for (int k = 0; k < box.dim; k++)
box.side[k] =
scene->side * (scene->sides ? scene->box[k] / scene->box[0] : 1);
}
if (read_frame(view->frame, &frame, out))
return NULL;
if (files_open(&file, path, &known, box.side[0] > 0 ? &box : NULL, out))
for (pack = files_next(&file); pack && at < frame; at++) {
pack_free(&pack);
pack = files_next(&file);
}
if (!pack)
outcome_set(out, WRONG, "%s: has %ld packs; give --frame 0 to %ld", path,
at, at - 1);
files_close(&file);
return pack;
}
typedef struct {
double low[3], high[3];
double zero[3];
bool repeats[3];
} Region;
static double outer_radius(const Pack *pack, size_t i) {
const Shape *shape = pack_shape(pack, i);
return pack_radius(pack, i) * (shape ? shape->outer : 1);
}
static Region find_region(const Pack *pack) {
Region region = {{0}, {0}, {0}, {false}};
size_t dim = (size_t)pack->box.dim;
for (size_t k = 0; k < dim; k++) {
double side = pack->box.side[k], low = side, high = 0;
for (size_t i = 0; i < pack->n; i++) {
double x = pack->x[i * dim + k], r = outer_radius(pack, i);
low = fmin(low, x - r);
high = fmax(high, x + r);
}
region.repeats[k] = !(pack->open > 0) && !(pack->walls >> k & 1);
region.low[k] = region.repeats[k] ? 0 : low;
region.high[k] = region.repeats[k] ? side : high;
region.zero[k] = region.repeats[k] ? 0 : side / 2;
}
return region;
}
enum { CLASSES = 13, KINDS = 8 };
typedef struct {
char label[120];
size_t count;
BallLook ball;
unsigned char area[3], edge[3];
} Class;
typedef struct {
Class class[CLASSES];
int classes, *of;
char title[80];
} Colours;
static const unsigned char named[KINDS][6] = {
{0x14, 0x46, 0x82, 0xaa, 0xd2, 0xf5}, {0x96, 0x3c, 0x0a, 0xf0, 0xb4, 0x6e},
{0x0a, 0x5f, 0x4b, 0x82, 0xdc, 0xc3}, {0x7a, 0x2d, 0x5e, 0xea, 0xb6, 0xd6},
{0x7d, 0x62, 0x00, 0xf3, 0xdc, 0x7e}, {0x2b, 0x2b, 0x2b, 0x9a, 0x9a, 0x9a},
{0x3a, 0x2d, 0x7a, 0xbd, 0xb4, 0xf2}, {0x6e, 0x6e, 0x6e, 0xe6, 0xe6, 0xe6}};
static void name_colours(Class *class, int k) {
memcpy(class->ball.rim, named[k], 3);
memcpy(class->ball.top, named[k] + 3, 3);
memcpy(class->edge, named[k], 3);
memcpy(class->area, named[k] + 3, 3);
}
static unsigned char mixed(double a, double b, double share) {
return (unsigned char)(a + share * (b - a) + 0.5);
}
static void scale_colours(Class *class, double t) {
static const unsigned char stop[4][3] = {{0xf6, 0xea, 0xa6},
{0x7f, 0xcd, 0xbb},
{0x2c, 0x7f, 0xb8},
{0x14, 0x28, 0x6b}};
int at = GSL_MIN_INT((int)(3 * t), 2);
for (int k = 0; k < 3; k++) {
unsigned char c = mixed(stop[at][k], stop[at + 1][k], 3 * t - at);
class->area[k] = c;
class->edge[k] = mixed(c, 0, 0.5);
class->ball.rim[k] = mixed(c, 0, 0.25);
class->ball.top[k] = mixed(c, 255, 0.35);
}
}
static void write_colour(const Drawing *d, const unsigned char c[3]) {
fprintf(d->script, "rgb '#%02x%02x%02x'", c[0], c[1], c[2]);
}
static bool is_near(const Pack *pack, size_t i, size_t j, const double d[3],
double part) {
double sum = pack_radius(pack, i) + pack_radius(pack, j), gap;
double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
if (!pack->angle)
return sqrt(square) - sum <= part * sum;
Body A = pack_body(pack, i), B = pack_body(pack, j);
A.x = A.y = 0;
B.x = d[0];
B.y = d[1];
overlap_verdict(&A, &B, &gap);
return gap <= part * sum;
}
static void count_around(const Pack *pack, const Cells *cells, size_t cell,
Span span[], double part, int near[]) {
if (cells->start[cell] == cells->start[cell + 1])
return;
int spans = cells_spans(cells, cell, true, span);
for (uint32_t t = cells->start[cell]; t < cells->start[cell + 1]; t++)
for (int s = 0; s < spans; s++)
for (uint32_t j = s ? span[s].begin : t + 1; j < span[s].end; j++) {
double d[3] = {0};
for (int k = 0; k < cells->dim; k++)
d[k] = (cells->x[k][j] - cells->x[k][t]) + span[s].shift[k];
size_t a = cells->particle[t], b = cells->particle[j];
bool counts = is_near(pack, a, b, d, part);
near[a] += counts;
near[b] += counts;
}
}
static int *count_near(const Pack *pack, double part) {
int *near = memory(pack->n, sizeof *near);
double reach = 2 * pack_widest(pack) + 2 * part * pack_largest(pack);
Cells *cells = cells_alloc(pack, reach * (1 + 1e-9));
Span *span = memory((size_t)cells_spans_most(cells), sizeof *span);
for (size_t c = 0; c < cells->cells; c++)
count_around(pack, cells, c, span, part, near);
free(span);
cells_free(&cells);
return near;
}
static void by_species(const Pack *pack, Colours *c) {
double least[KINDS], most[KINDS];
c->classes = GSL_MIN_INT(pack->kinds, KINDS);
for (size_t i = 0; i < pack->n; i++) {
int k = GSL_MIN_INT(pack_kind(pack, i), KINDS - 1);
double r = pack_radius(pack, i);
bool first = c->class[k].count++ == 0;
least[k] = first ? r : fmin(least[k], r);
most[k] = first ? r : fmax(most[k], r);
c->of[i] = k;
}
for (int k = 0; k < c->classes; k++) {
Class *class = &c->class[k];
bool others = k == KINDS - 1 && pack->kinds > KINDS;
int at = snprintf(class->label, sizeof class->label, "%s: %zu",
others ? "others" : pack->species[k].name, class->count);
size_t room = sizeof class->label - (size_t)at;
name_colours(class, k);
if (class->count && most[k] - least[k] <= 1e-9 * most[k])
snprintf(class->label + at, room, ", radius %.4g", least[k]);
else if (class->count)
snprintf(class->label + at, room, ", radius %.4g to %.4g", least[k],
most[k]);
}
}
static void by_size(const Pack *pack, Colours *c) {
double least = pack_smallest(pack), most = pack_largest(pack);
bool ratios = most > 4 * least, equal = most - least <= 1e-9 * most;
strcpy(c->title, "radius");
c->classes = equal ? 1 : KINDS;
for (size_t i = 0; i < pack->n; i++) {
double r = pack_radius(pack, i);
double t = equal ? 0
: ratios ? log(r / least) / log(most / least)
: (r - least) / (most - least);
int k = GSL_MIN_INT((int)(KINDS * t), KINDS - 1);
c->class[c->of[i] = k].count++;
}
for (int k = 0; k < c->classes; k++) {
double end[2];
for (int e = 0; e < 2; e++) {
double t = (double)(k + e) / c->classes;
end[e] =
ratios ? least * pow(most / least, t) : least + t * (most - least);
}
scale_colours(&c->class[k], k / (KINDS - 1.0));
if (equal)
snprintf(c->class[k].label, 120, "%.4g: %zu", least, c->class[k].count);
else
snprintf(c->class[k].label, 120, "%.3g to %.3g: %zu", end[0], end[1],
c->class[k].count);
}
}
static void by_neighbours(const Pack *pack, double part, Colours *c) {
int *near = count_near(pack, part), most = 0;
for (size_t i = 0; i < pack->n; i++) {
int k = c->of[i] = GSL_MIN_INT(near[i], CLASSES - 1);
c->class[k].count++;
most = GSL_MAX_INT(most, k);
}
c->classes = most + 1;
snprintf(c->title, sizeof c->title, "neighbours, gap up to %g (a_i + a_j)",
part);
for (int k = 0; k <= most; k++) {
snprintf(c->class[k].label, 120, "%d%s: %zu", k,
k == CLASSES - 1 ? " or more" : "", c->class[k].count);
scale_colours(&c->class[k], most ? (double)k / most : 0);
}
free(near);
}
static int choose_colours(const Pack *pack, const char *color, Colours *c,
Outcome *out) {
const char *neighbours = "coordination=";
size_t word = strlen(neighbours) - 1;
char *end = NULL;
double part = 0.01;
color = color ? color : "species";
bool near = strncmp(color, neighbours, word) == 0;
if (near && color[word] == '=')
part = strtod(color + word + 1, &end);
if (near ? color[word] &&
!(end > color + word + 1 && !*end && part >= 0 && part <= 10)
: strcmp(color, "species") != 0 && strcmp(color, "size") != 0)
return outcome_set(out, WRONG,
"--color %s: give species, size, coordination or "
"coordination=GAP, a gap from 0 to 10 in diameters",
color);
c->of = memory(pack->n, sizeof *c->of);
if (near)
by_neighbours(pack, part, c);
else if (strcmp(color, "size") == 0)
by_size(pack, c);
else
by_species(pack, c);
return DONE;
}
static int key_lines(const Colours *c) {
int lines = *c->title ? 1 : 0;
for (int k = 0; k < c->classes; k++)
lines += c->class[k].count > 0;
return lines;
}
static double key_width(const Colours *c) {
size_t longest = strlen(c->title);
for (int k = 0; k < c->classes; k++)
longest = GSL_MAX(longest, strlen(c->class[k].label) + 4);
return 0.5 + 0.16 * (double)longest;
}
static void draw_key(const Drawing *d, const Colours *c, double x, double y,
bool balls) {
if (*c->title)
drawing_words(d, x, y -= 0.2, "left", 7, c->title);
for (int k = 0; k < c->classes; k++) {
const Class *class = &c->class[k];
const unsigned char *rim = class->ball.rim, *top = class->ball.top;
unsigned char ink[3];
char style[64];
for (int i = 0; i < 3; i++)
ink[i] = balls ? mixed(rim[i], top[i], 0.6) : class->area[i];
snprintf(style, sizeof style, "pt 7 ps %g lc rgb '#%02x%02x%02x'",
d->points, ink[0], ink[1], ink[2]);
if (class->count)
drawing_key(d, x, y -= 0.42, 0.2, "", style, class->label);
}
}
static void tell_pack(const Pack *pack, const char *more, char note[256]) {
bool repeats = !(pack->open > 0) && !pack->walls;
int at =
snprintf(note, 256, "%zu particle%s", pack->n, pack->n == 1 ? "" : "s");
if (repeats && touch_hard(pack, touch_least_gap(pack)))
at += snprintf(note + at, 256 - (size_t)at, ", fraction %.4g",
pack_fraction(pack));
for (int k = 0; k < pack->box.dim && repeats; k++)
at += snprintf(note + at, 256 - (size_t)at, "%s%.5g", k ? " x " : ", box ",
pack->box.side[k]);
snprintf(note + at, 256 - (size_t)at, "%s; lengths as in the file", more);
}
typedef struct {
Body body;
int class;
} Piece;
typedef struct {
size_t n;
Piece *piece;
double low[2], high[2], zero[2];
char axis[2];
bool overlap;
} Flat;
static void find_shifts(const Flat *f, const Region *region, int k, double x,
double outer, int shift[2]) {
double side = f->high[k] - f->low[k];
shift[0] = shift[1] = 0;
if (!region->repeats[k])
return;
shift[0] = (int)ceil((f->low[k] - outer - x) / side);
shift[1] = (int)floor((f->high[k] + outer - x) / side);
}
static bool is_beyond(const Flat *f, const Body *body, double outer) {
double x = GSL_MAX(f->low[0] - body->x, body->x - f->high[0]);
double y = GSL_MAX(f->low[1] - body->y, body->y - f->high[1]);
x = fmax(x, 0);
y = fmax(y, 0);
return x * x + y * y >= outer * outer;
}
static void add_images(Flat *f, const Region *region, Body body, double outer,
int class) {
int u[2], v[2];
double width = f->high[0] - f->low[0], height = f->high[1] - f->low[1];
Body image = body;
find_shifts(f, region, 0, body.x, outer, u);
find_shifts(f, region, 1, body.y, outer, v);
for (int i = u[0]; i <= u[1]; i++)
for (int j = v[0]; j <= v[1]; j++) {
image.x = body.x + i * width;
image.y = body.y + j * height;
if (is_beyond(f, &image, outer))
continue;
if ((f->n & (f->n - 1)) == 0)
f->piece = memory_grow(f->piece, f->n ? 2 * f->n : 1, sizeof(Piece));
f->piece[f->n++] = (Piece){image, class};
}
}
static void set_frame(Flat *f, const Region *region, int a, int b) {
const int axis[] = {a, b};
for (int k = 0; k < 2; k++) {
f->low[k] = region->low[axis[k]];
f->high[k] = region->high[axis[k]];
f->zero[k] = region->zero[axis[k]];
f->axis[k] = "xyz"[axis[k]];
}
}
static void list_flat(Flat *f, const Pack *pack, const Colours *c) {
Region region = find_region(pack);
set_frame(f, &region, 0, 1);
for (size_t i = 0; i < pack->n; i++)
add_images(f, &region, pack_body(pack, i), outer_radius(pack, i), c->of[i]);
}
static void list_cut(Flat *f, const Pack *pack, const Colours *c, int axis,
double height) {
Region region = find_region(pack), across = region;
int a = axis == 0, b = axis == 2 ? 1 : 2;
bool *is = memory(pack->n, sizeof *is);
set_frame(f, &region, a, b);
across.repeats[0] = region.repeats[a];
across.repeats[1] = region.repeats[b];
for (int k = 0; k < c->classes; k++) {
for (size_t i = 0; i < pack->n; i++)
is[i] = c->of[i] == k;
Pack *some = core_only(pack, is);
some->open = 0;
Pack *cut = sections_cut(some, axis, height);
for (size_t i = 0; i < cut->n; i++)
add_images(f, &across, pack_body(cut, i), pack_radius(cut, i), k);
pack_free(&cut);
pack_free(&some);
}
free(is);
}
static ShapeNode *list_corners(const Shape *shape, double cm, int *n) {
double needed = fmax(8, fmin(M_PI * sqrt(cm / (2 * 0.002)), 96));
*n = !shape ? (int)ceil(needed) : shape->sides ? shape->sides : 96;
ShapeNode *node = memory((size_t)*n, sizeof *node);
if (shape && !shape->sides)
shape_nodes(shape, *n, node);
for (int k = 0; shape && k < shape->sides; k++) {
node[k].x = shape->x[k];
node[k].y = shape->y[k];
}
for (int k = 0; !shape && k < *n; k++)
elementary_turn(2 * M_PI * k / *n, &node[k].x, &node[k].y);
return node;
}
static void write_polygon(FILE *file, const Flat *f, const Body *body,
double cm) {
int n;
ShapeNode *node = list_corners(body->shape, body->radius * cm, &n);
for (int k = 0; k <= n; k++) {
double x = node[k % n].x, y = node[k % n].y;
fprintf(file, "%.7g %.7g\n",
body->x - f->zero[0] + body->radius * (body->c * x - body->s * y),
body->y - f->zero[1] + body->radius * (body->s * x + body->c * y));
}
putc('\n', file);
free(node);
}
static bool write_block(FILE *file, const Flat *f, int class, double cm) {
bool begun = false;
for (size_t i = 0; i < f->n; i++) {
if (f->piece[i].class != class)
continue;
if (!begun)
fprintf(file, "$class%d << EOD\n", class);
begun = true;
write_polygon(file, f, &f->piece[i].body, cm);
}
if (begun)
fputs("EOD\n", file);
return begun;
}
static void write_pieces(const Drawing *d, const Flat *f, const Colours *c,
double cm) {
bool seen[CLASSES];
for (int k = 0; k < c->classes; k++)
seen[k] = write_block(d->script, f, k, cm);
fputs("plot NaN", d->script);
for (int k = 0; k < c->classes; k++)
if (seen[k]) {
fprintf(d->script, ", $class%d using 1:2 with filledcurves closed fc ",
k);
write_colour(d, c->class[k].area);
fprintf(d->script, " fs %s border lc ",
f->overlap ? "transparent solid 0.6" : "solid 1");
write_colour(d, c->class[k].edge);
fputs(" lw 0.5", d->script);
}
fputs("\n", d->script);
}
static void draw_flat(const Flat *f, const Colours *c, const char *note,
const char *picture, Outcome *out) {
double side[] = {f->high[0] - f->low[0], f->high[1] - f->low[1]};
double cm = 9 / fmax(side[0], side[1]);
double least = 0.42 * key_lines(c) + 0.3;
double corner[] = {1.8, 1.8, 1.8 + cm * side[0], 1.8 + cm * side[1]};
double height = fmax(corner[3], corner[1] + least) + 0.25;
Drawing d;
if (drawing_open(&d, picture, corner[2] + 0.3 + key_width(c), height, out) ==
DONE) {
drawing_axes(&d, corner);
draw_key(&d, c, corner[2] + 0.3, corner[3] + 0.2, false);
drawing_words(&d, 0.2, 0.25, "left", 5.5, note);
for (int k = 0; k < 2; k++)
fprintf(d.script, "set %crange [%.9g:%.9g]\nset %clabel '%c' offset %s\n",
'x' + k, f->low[k] - f->zero[k], f->high[k] - f->zero[k], 'x' + k,
f->axis[k], k ? "0.5" : "0,0.4");
fputs("set border 15 lw 0.6 lc rgb '#777777'\nset tics out\n", d.script);
write_pieces(&d, f, c, cm);
}
drawing_close(&d, out);
}
static const double CA = 0.8253356149, SA = 0.5646424734, CE = 0.8775825619,
SE = 0.4794255386;
static void turn(const double x[3], double to[3]) {
double depth = SA * x[0] + CA * x[1];
to[0] = CA * x[0] - SA * x[1];
to[1] = CE * x[2] - SE * depth;
to[2] = CE * depth + SE * x[2];
}
static Ball *turn_balls(const Pack *pack, const Colours *c, double frame[4]) {
Ball *ball = memory(pack->n, sizeof *ball);
for (size_t i = 0; i < pack->n; i++) {
double to[3], r = pack_radius(pack, i);
turn(pack->x + 3 * i, to);
ball[i] = (Ball){to[0], to[1], to[2], r, c->of[i]};
for (int k = 0; k < 2; k++) {
frame[k] = i ? fmin(frame[k], to[k] - r) : to[k] - r;
frame[k + 2] = i ? fmax(frame[k + 2], to[k] + r) : to[k] + r;
}
}
return ball;
}
static double choose_bar(double most) {
double bar = pow(10, floor(log10(most)));
return 5 * bar <= most ? 5 * bar : 2 * bar <= most ? 2 * bar : bar;
}
static void draw_bar(const Drawing *d, double length, double cm, double x,
double y) {
char text[32];
snprintf(text, sizeof text, "%g", length);
fprintf(d->script,
"set arrow from screen %.6f, screen %.6f to screen %.6f, screen %.6f "
"heads size screen 0.006,90 front lw 1 lc rgb '#222222'\n",
x / d->width, y / d->height, (x + cm) / d->width, y / d->height);
drawing_words(d, x + cm / 2, y + 0.25, "center", 7, text);
}
static void draw_directions(const Drawing *d, double x, double y) {
for (int k = 0; k < 3; k++) {
double unit[3] = {k == 0, k == 1, k == 2}, to[3];
char name[2] = {"xyz"[k], '\0'};
turn(unit, to);
fprintf(d->script,
"set arrow from screen %.6f, screen %.6f to screen %.6f, screen "
"%.6f size screen 0.012,20 filled front lw 0.8 lc rgb '#222222'\n",
x / d->width, y / d->height, (x + 0.7 * to[0]) / d->width,
(y + 0.7 * to[1]) / d->height);
drawing_words(d, x + 0.95 * to[0], y + 0.95 * to[1], "center", 7, name);
}
}
static void write_pixels(const Drawing *d, const Ball ball[], size_t n,
const Colours *c, const double corner[2], double pixel,
const int size[2]) {
BallLook look[CLASSES];
for (int k = 0; k < c->classes; k++)
look[k] = c->class[k].ball;
unsigned char *rgb =
balls_paint(n, ball, look, corner[0], corner[1], pixel, size[0], size[1]);
fprintf(d->script,
"set xrange [-0.5:%d-0.5]\nset yrange [-0.5:%d-0.5]\n"
"unset border\nunset tics\n"
"plot '-' binary array=(%d,%d) format='%%uchar' using 1:2:3 with "
"rgbimage notitle",
size[0], size[1], size[0], size[1]);
putc('\n', d->script);
fwrite(rgb, 3, (size_t)size[0] * (size_t)size[1], d->script);
free(rgb);
}
static void draw_space(const Pack *pack, const Colours *c, const char *note,
const char *picture, Outcome *out) {
enum { PIXELS = 1080, EACH = 120 };
double frame[4] = {0};
Ball *ball = turn_balls(pack, c, frame);
double side[] = {frame[2] - frame[0], frame[3] - frame[1]};
double pixel = fmax(side[0], side[1]) / (PIXELS - 4);
int size[2];
for (int k = 0; k < 2; k++) {
size[k] = (int)ceil(side[k] / pixel) + 2;
frame[k] -= (size[k] * pixel - side[k]) / 2;
}
double right = 0.2 + (double)size[0] / EACH, top = 2 + (double)size[1] / EACH;
double corner[] = {0.2, 2, right, top};
double height = fmax(top, 2.3 + 0.42 * key_lines(c)) + 0.2;
Drawing d;
if (drawing_open(&d, picture, right + 0.4 + key_width(c), height, out) ==
DONE) {
double bar = choose_bar(side[0] / 4);
drawing_axes(&d, corner);
draw_key(&d, c, right + 0.3, top + 0.2, true);
drawing_words(&d, 0.2, 0.2, "left", 5.5, note);
draw_directions(&d, 1.1, 1.15);
draw_bar(&d, bar, bar / pixel / EACH, 2.6, 0.9);
write_pixels(&d, ball, pack->n, c, frame, pixel, size);
}
free(ball);
drawing_close(&d, out);
}
static int read_cut(const char *text, int *axis, double *share, Outcome *out) {
char *end = NULL;
bool begins = *text >= 'x' && *text <= 'z' && text[1] == '=';
*axis = *text - 'x';
*share = begins ? strtod(text + 2, &end) : 0;
if (!begins || end == text + 2 || *end || !(*share >= 0 && *share <= 1))
return outcome_set(out, WRONG,
"--cut %s: give x=, y= or z= and a part of the side "
"from 0 to 1, as in z=0.5",
text);
return DONE;
}
static void draw_cut(const Pack *pack, const Colours *c, const char *text,
const char *picture, Outcome *out) {
Flat flat = {.overlap = false};
int axis;
double share;
char note[256], more[80];
if (read_cut(text, &axis, &share, out))
return;
Region region = find_region(pack);
double height =
region.low[axis] + share * (region.high[axis] - region.low[axis]);
list_cut(&flat, pack, c, axis, height);
snprintf(more, sizeof more, ", cut at %c = %.5g", 'x' + axis,
height - region.zero[axis]);
tell_pack(pack, more, note);
draw_flat(&flat, c, note, picture, out);
free(flat.piece);
}
static void draw_pack(const Pack *pack, const Colours *c, const char *cut,
const char *picture, Outcome *out) {
char note[256];
Flat flat = {0};
if (cut) {
draw_cut(pack, c, cut, picture, out);
return;
}
tell_pack(pack, "", note);
if (pack->box.dim == 3) {
draw_space(pack, c, note, picture, out);
return;
}
flat.overlap = !touch_hard(pack, touch_least_gap(pack));
list_flat(&flat, pack, c);
draw_flat(&flat, c, note, picture, out);
free(flat.piece);
}
int picture_view(const char *path, const PictureView *view, const char *picture,
Outcome *out) {
Colours colours = {.classes = 0};
Pack *pack = NULL;
if (drawing_format(picture, out) == DONE && drawing_possible(out) == DONE)
pack = read_pack(path, view, out);
if (pack && pack->n == 0)
outcome_set(out, WRONG, "%s: no particles; there must be one", path);
if (pack && view->cut && pack->box.dim == 2)
outcome_set(out, WRONG, "%s: a pack in the plane; leave --cut out", path);
if (out->status == DONE &&
choose_colours(pack, view->color, &colours, out) == DONE)
draw_pack(pack, &colours, view->cut, picture, out);
free(colours.of);
if (pack)
pack_free(&pack);
return out->status;
}
