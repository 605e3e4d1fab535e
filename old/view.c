#include "view.h"
#include <gsl/gsl_math.h>
#include <stdio.h>
const Key view_keys[] = {
KEY_WORD(SceneWindow, shape, "box|ball|cylinder", "box",
W("a box, a ball (a disc) or a cylinder")),
KEY_REAL(SceneWindow, side, SETTING_LEAST, SETTING_MOST, "-",
W("of a cube (square), above 0; default as large as the pack "
"allows")),
KEY_LIST(SceneWindow, sides, count, 3, SETTING_MOST, "-",
W("of a box: a list, one for each dimension")),
KEY_REAL(SceneWindow, radius, SETTING_LEAST, SETTING_MOST, "-",
W("of a ball or a cylinder, above 0")),
KEY_REAL(SceneWindow, height, SETTING_LEAST, SETTING_MOST, "-",
W("of a cylinder, above 0")),
KEY_WORD(SceneWindow, axis, "x|y|z", "z", W("of a cylinder")),
KEY_WORD(SceneWindow, edges, "default|minus|ripley|translation", "default",
W("for measures that do not say it; by default minus sampling")),
{0}};
const Key view_edges[] = {
KEY_WORD(Asked, edges, EDGES_WORDS, "-", W("how the wall is treated")),
{0}};
static bool room_of(const Pack *pack, double room[]) {
bool known = true;
for (int k = 0; k < pack->box.dim; k++) {
bool seen = pack->open > 0 || pack->walls;
room[k] = seen ? pack->sample[k] : pack->box.side[k];
known &= room[k] > 0;
}
for (int k = 0; k < pack->box.dim && !known; k++)
room[k] = 2 * pack->open;
return known;
}
static bool lies_within(const Window *w, const Pack *pack) {
double room[3], extent[3], hair = 1 + 1e-9;
if (!room_of(pack, room))
return window_outer(w) <= pack->open * hair;
window_extent(w, extent);
for (int k = 0; k < w->dim; k++)
if (extent[k] > room[k] * hair)
return false;
return true;
}
static Window window_of(const Scene *scene, const Pack *pack) {
const SceneWindow *s = &scene->window;
Window w = {.dim = pack->box.dim, .axis = s->axis};
double room[3] = {0}, least = GSL_POSINF;
bool finite = pack->open > 0;
room_of(pack, room);
w.shape = s->line || !finite ? (WindowShape)s->shape : WINDOW_BALL;
for (int k = 0; k < w.dim; k++) {
w.middle[k] = pack->box.side[k] / 2;
w.side[k] = s->count ? s->sides[k] : s->side > 0 ? s->side : room[k];
if (w.shape != WINDOW_CYLINDER || k != w.axis)
least = GSL_MIN(least, room[k]);
bool whole = w.shape == WINDOW_BOX ? !s->count && !(s->side > 0)
: w.shape == WINDOW_CYLINDER &&
k == w.axis && !(s->height > 0);
w.wraps[k] = whole && pack->walls && !(pack->walls >> k & 1);
}
w.height = s->height > 0 ? s->height : room[w.axis];
w.radius = s->radius > 0 ? s->radius
: finite && w.shape == WINDOW_BALL ? scene->inside * pack->open
: least / 2;
return w;
}
static const EdgesHow window_edges[] = {EDGES_DEFAULT, EDGES_MINUS,
EDGES_RIPLEY, EDGES_TRANSLATION};
EdgesHow view_how(const Scene *scene, const Asked *asked, unsigned facts) {
const Measure *measure = (const Measure *)asked->entry;
EdgesHow how = (EdgesHow)asked->edges;
EdgesHow common = window_edges[scene->window.edges];
bool walls = !(facts & (FACT_PERIODIC | FACT_FINITE));
bool window = scene->window.line || walls;
if (how == EDGES_DEFAULT && window && measure->edges)
return common && measure->edges >> common & 1 ? common : EDGES_MINUS;
if (how == EDGES_DEFAULT)
return how;
if (how == EDGES_TOROIDAL ||
(how == EDGES_MINUS && !window && !(facts & FACT_PERIODIC)))
return EDGES_DEFAULT;
return how;
}
int view_check(const Query *query) {
const SceneWindow *w = &query->scene->window;
int dim = query->scene->dimension;
bool box = w->shape == WINDOW_BOX, jar = w->shape == WINDOW_CYLINDER;
if (jar && dim == 2)
return query_wrong(query, "window.shape", "a cylinder is of 3 dimensions",
"give \"box\" or \"ball\", a disc");
if ((w->side > 0 || w->count) && !box)
return query_wrong(query, w->count ? "window.sides" : "window.side",
"only a box has sides", "give radius");
if (w->radius > 0 && box)
return query_wrong(query, "window.radius", "a box has no radius",
"give side or sides, or another shape");
if (w->height > 0 && !jar)
return query_wrong(query, "window.height", "only a cylinder has a height",
"leave it out, or give shape = \"cylinder\"");
if (w->count && (w->side > 0 || w->count != dim))
return query_wrong(query, "window.sides",
"sides is a list, one for each dimension",
"give side for a cube or a square");
return DONE;
}
static const char *const treatment[] = {"default", "toroidal", "minus",
"ripley", "translation"};
static void name_treatments(unsigned edges, char *names, size_t room) {
size_t length = 0;
*names = '\0';
for (int how = EDGES_TOROIDAL; how <= EDGES_TRANSLATION; how++)
if (edges >> how & 1)
length += (size_t)snprintf(names + length, room - length, "%s%s",
length ? "|" : "", treatment[how]);
}
static int ask_edges(const Query *query, unsigned facts) {
const Measure *measure = (const Measure *)query->asked->entry;
const char *key = measure->entry.name;
int how = query->asked->edges;
bool window = query->scene->window.line != 0;
bool walls = !(facts & (FACT_PERIODIC | FACT_FINITE));
char names[64];
if (walls && !measure->edges)
return query_say(
query, "measure.%s is not of packs with walls; leave it out", key);
if (window && !measure->edges)
return query_say(query,
"measure.%s sees no window; leave it out, or window", key);
if (how == EDGES_TOROIDAL && (window || !(facts & FACT_PERIODIC)))
return query_say(query,
"edges of measure.%s are toroidal, and %s is no torus; "
"give \"minus\"",
key,
window ? "a window"
: walls ? "a pack with walls"
: "a finite pack");
name_treatments(measure->edges, names, sizeof names);
if (how == EDGES_DEFAULT || measure->edges >> how & 1)
return DONE;
return query_say(query, "edges of measure.%s are %s; one of \"%s\" is right",
key, treatment[how], names);
}
static int ask_reach(const Query *query, EdgesHow how, const Window *window) {
const Measure *measure = (const Measure *)query->asked->entry;
double most = edges_limit(window, how) / query->species[0].radius;
double (*looks)(const void *) =
measure->within ? measure->within : measure->reach;
double R = looks ? looks(query->asked->own) : 0;
if (R <= most * (1 + 1e-12))
return DONE;
return query_say(query,
"measure.%s%s %g goes beyond what its edges allow in this "
"window; the largest reach here is %.6g",
measure->limit ? measure->limit : measure->entry.name,
measure->limit ? " =" : " looking to", R, most);
}
int view_ask(const Query *all, unsigned facts, const Box *box) {
const Scene *scene = all->scene;
Query query = *all;
Pack room = {.box = box ? *box : (Box){.dim = scene->dimension}};
Window window = window_of(scene, &room);
if (scene->window.line && box && !lies_within(&window, &room))
return query_wrong(all, "window", "the window is larger than the box",
"give a smaller one, or leave its lengths out");
for (const Asked *one = scene->measure; one && one->entry; one++) {
EdgesHow how = view_how(scene, one, facts);
query.asked = one;
if (ask_edges(&query, facts) ||
(box && how && ask_reach(&query, how, &window)))
return WRONG;
}
return DONE;
}
static size_t outside(const Pack *pack) {
size_t many = 0, dim = (size_t)pack->box.dim;
for (size_t i = 0; i < pack->n; i++) {
bool out = false;
for (size_t k = 0; k < dim; k++)
out |= (pack->open > 0 || pack->walls >> k & 1) && pack->sample[k] > 0 &&
fabs(pack->x[i * dim + k] - pack->box.side[k] / 2) >
pack->sample[k] / 2 + pack_radius(pack, i);
many += out;
}
return many;
}
static int cut_out(View *view, const Work *work) {
const Pack *pack = work->pack;
Outcome *out = &work->result->out;
view->window = window_of(work->scene, pack);
if (outside(pack))
return outcome_set(out, UNREACHED,
"%zu of %zu centres lie outside the box of the file; "
"give its Origin, or a Lattice that holds them",
outside(pack), pack->n);
if (!lies_within(&view->window, pack))
return outcome_set(out, UNREACHED,
"the window does not lie within the pack; give a "
"smaller one");
view->cut = window_cut(pack, &view->window);
if (view->cut->n > 0)
return DONE;
pack_free(&view->cut);
return outcome_set(out, UNREACHED,
"no particle is in the window; give a larger one");
}
int view_through(View *view, Work *work) {
if (!view->cut && cut_out(view, work))
return work->result->out.status;
work->pack = view->cut;
work->window = &view->window;
work->core = window_inner(&view->window);
work->fraction = edges_fraction(view->cut, &view->window);
return DONE;
}
void view_close(View *view) {
if (view->cut)
pack_free(&view->cut);
}
