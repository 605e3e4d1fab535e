#include "ask.h"
#include "entries.h"
#include "keys.h"
#include "species.h"
#include "view.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
static void *ask(Asked *asked, const Entry *entry, const config_setting_t *at) {
unsigned line = at ? config_setting_source_line(at) : 0;
asked->entry = entry;
asked->line = line ? (int)line : -1;
return asked->own = memory(1, entry->size + 1);
}
static Asked *more(Asked **list) {
size_t n = 0;
while (*list && (*list)[n].entry)
n++;
*list = memory_grow(*list, n + 2, sizeof **list);
(*list)[n] = (*list)[n + 1] = (Asked){0};
return &(*list)[n];
}
static bool is_group(Reader *r, const config_setting_t *at) {
if (config_setting_is_group(at))
return true;
setting_bad(r, at, "a group { ... } is right");
return false;
}
static const Entry *named(Reader *r, const config_setting_t *group,
const char *key, const Entry *const list[],
EntriesWhich which) {
char names[160], right[200];
const Entry *entry = NULL;
const config_setting_t *at = config_setting_get_member(group, key);
const char *word = at ? config_setting_get_string(at) : NULL;
entries_names(list, which, names, sizeof names);
snprintf(right, sizeof right, "one of \"%s\" is right", names);
if (word && setting_place(word, names) >= 0)
entry = entries_find(list, word);
else if (at)
setting_bad(r, at, right);
else if (which == STAGES) {
snprintf(right, sizeof right, "%.*s", (int)strcspn(names, "|"), names);
entry = entries_find(list, right);
} else
setting_wrong(r, group, "method is missing in make", names);
return entry;
}
static int read_make(Reader *r, config_setting_t *at, const Key *key,
void *own) {
static const Key method[] = {
KEY_READ("method", "-", W("the name of a maker"), keys_later), {0}};
Scene *scene = own;
(void)key;
if (!is_group(r, at))
return r->out->status;
const Entry *entry = named(r, at, "method", ENTRIES(entries_makers), ALL);
if (!entry)
return r->out->status;
KeySet sets[] = {
{method, NULL}, {entry->keys, ask(&scene->make, entry, at)}, {0}};
return keys_read(r, at, "make", sets);
}
static int read_marks(Reader *r, config_setting_t *at, const Key *key,
void *own) {
double mark[SCENE_MARKS_MOST];
SceneStages *stages = own;
stages->marks = setting_list(at, mark, SCENE_MARKS_MOST, 1e9);
for (int i = 0; i < stages->marks; i++) {
stages->mark[i] = (int)mark[i];
if (stages->mark[i] != mark[i] ||
(i > 0 && stages->mark[i] <= stages->mark[i - 1]))
return setting_bad(r, at, key->right);
}
return stages->marks > 0 ? DONE : setting_bad(r, at, key->right);
}
static const Key stage_keys[] = {
KEY_READ("rule", "-", W("the name of a rule"), keys_later),
KEY_WHOLE(SceneStages, sweeps, 0, 1e9, "60",
W("M: global shakes of the pack made, from 0")),
KEY_REAL(SceneStages, every, 0, 1e9, "0",
W("collisions a particle between shakes in growth; 0: none")),
KEY_WHOLE(SceneStages, each, 1, 1e6, "1",
W("global shakes at each of these")),
KEY_WHOLE(SceneStages, samples, 1, 1e6, "1",
W("how often the shaken pack is measured")),
KEY_WHOLE(SceneStages, apart, 1, 1e6, "1",
W("global shakes from one of these to the next")),
KEY_READ("marks", "-",
W("a rising list of numbers of shakes after which to look"),
read_marks),
{0}};
static int read_shake(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
(void)key;
if (!is_group(r, at))
return r->out->status;
const Entry *entry = named(r, at, "rule", ENTRIES(entries_changes), STAGES);
if (!entry)
return r->out->status;
KeySet sets[] = {{stage_keys, &scene->stages},
{entry->keys, ask(more(&scene->change), entry, at)},
{0}};
return keys_read(r, at, "shake", sets);
}
static int read_entry(Reader *r, config_setting_t *at, const char *group,
const Entry *entry, const Key *edges, Asked *asked) {
static const Key none[] = {{0}};
char name[64];
if (!is_group(r, at))
return r->out->status;
void *own = ask(asked, entry, at);
KeySet sets[] = {
{entry->keys ? entry->keys : none, own}, {edges, asked}, {0}};
snprintf(name, sizeof name, "%s%s%s", group, *group ? "." : "", entry->name);
return keys_read(r, at, name, sets);
}
static int read_change(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
const Entry *entry = entries_find(ENTRIES(entries_changes), key->name);
return read_entry(r, at, "", entry, NULL, more(&scene->change));
}
static int read_measures(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
char names[320] = " ";
(void)key;
if (!is_group(r, at))
return r->out->status;
unsigned line = config_setting_source_line(at);
scene->measures = line ? (int)line : -1;
entries_names(ENTRIES(entries_measures), ALL, names + 1, sizeof names - 1);
for (char *c = names; *c; c++)
*c = *c == '|' ? ' ' : *c;
for (int i = 0; i < config_setting_length(at); i++) {
config_setting_t *one = config_setting_get_elem(at, (unsigned)i);
if (!entries_find(ENTRIES(entries_measures), config_setting_name(one)))
return keys_unknown(r, one, "measure", names);
}
for (const Measure *const *m = entries_measures; *m; m++) {
config_setting_t *one = config_setting_get_member(at, (*m)->entry.name);
if (one &&
read_entry(r, one, "measure", &(*m)->entry,
(*m)->edges ? view_edges : NULL, more(&scene->measure)))
return r->out->status;
}
return DONE;
}
static int read_curves(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = r->scene;
(void)own;
bool list = config_setting_is_list(at) || config_setting_is_array(at);
int count = list ? config_setting_length(at) : 0;
for (int i = 0; i < count; i++) {
const char *name = config_setting_get_string_elem(at, i);
const Entry *entry =
name ? entries_find(ENTRIES(entries_curves), name) : NULL;
if (!entry || !((const Curve *)entry)->alloc)
return setting_bad(r, at, key->right);
}
for (const Curve *const *c = entries_curves; *c; c++)
for (int i = 0; i < count; i++)
if (strcmp(config_setting_get_string_elem(at, i), (*c)->entry.name) ==
0 &&
!scene_asked(scene->curve, (*c)->entry.name))
ask(more(&scene->curve), &(*c)->entry, at);
return count > 0 ? DONE : setting_bad(r, at, key->right);
}
static int read_own_curve(Reader *r, config_setting_t *at, const Key *key,
void *own) {
(void)own;
if (config_setting_type(at) != CONFIG_TYPE_BOOL)
return setting_bad(r, at, "true or false is right");
if (config_setting_get_bool(at))
ask(more(&r->scene->curve),
entries_find(ENTRIES(entries_curves), key->name), at);
return DONE;
}
static const Key theory_keys[] = {
KEY_READ("curves", "-", W("a list of names is right, see randpack help"),
read_curves),
KEY_LIST(SceneTheory, phi, phis, SCENE_PHI_MOST, 0.74, "-",
W("a list of packing fractions, above 0 to 0.74")),
KEY_REAL(SceneTheory, step, DBL_MIN, DBL_MAX, "0.01",
W("the step in R, above 0")),
KEY_REAL(SceneTheory, reach, 2, 1e3, "6", W("the largest R, from 2")),
{0}};
static int read_theory(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
Key of_species[16] = {{0}};
int n = 0;
(void)key;
if (!is_group(r, at))
return r->out->status;
for (const Curve *const *c = entries_curves; *c && n < 15; c++)
if (!(*c)->alloc)
of_species[n++] = (Key)KEY_READ((*c)->entry.name, "-", W("true or false"),
read_own_curve);
unsigned line = config_setting_source_line(at);
scene->theory.line = line ? (int)line : -1;
KeySet sets[] = {{theory_keys, &scene->theory}, {of_species, scene}, {0}};
return keys_read(r, at, "theory", sets);
}
static int read_fraction(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
const char *word = config_setting_get_string(at);
scene->full = word && strcmp(word, "max") == 0;
if (scene->full)
return DONE;
scene->fraction = setting_number(at);
if (scene->fraction > 0 && scene->fraction < 1)
return DONE;
return setting_bad(r, at, key->right);
}
static int read_box(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
double ratio[3];
int sides = setting_list(at, ratio, 3, 1e6);
for (int k = 0; k < 3; k++)
scene->box[k] = sides >= 2 ? ratio[k < sides ? k : 0] : 0;
scene->sides = sides;
return sides >= 2 ? DONE : setting_bad(r, at, key->right);
}
static int read_window(Reader *r, config_setting_t *at, const Key *key,
void *own) {
Scene *scene = own;
(void)key;
if (!is_group(r, at))
return r->out->status;
unsigned line = config_setting_source_line(at);
scene->window.line = line ? (int)line : -1;
KeySet sets[] = {{view_keys, &scene->window}, {0}};
return keys_read(r, at, "window", sets);
}
static int read_species(Reader *r, config_setting_t *at, const Key *key,
void *own) {
(void)key, (void)own;
return species_read(r, at);
}
#define WIDE_KEY(m, from, to, otherwise, right) \
{ \
KEY_NAME(m), WIDE, MEMBER(Scene, m, int64_t), 0, from, to, NULL, \
otherwise, right, NULL \
}
static const Key scene_keys[] = {
KEY_WHOLE(Scene, dimension, 2, 3, NULL, W("2 or 3")),
WIDE_KEY(seed, 0, 0x1p53, "1", W("a whole number from 0 to 2^53")),
KEY_WHOLE(Scene, realizations, 1, 1e6, "1", W("a whole number from 1")),
KEY_READ("species", "-",
W("a list ( { name; radius; number; shape; }, ... )"),
read_species),
WIDE_KEY(number, 1, 4e9, "-",
W("the number of all particles, where species are shares")),
KEY_READ("fraction", "-", W("a number above 0 and below 1, or \"max\""),
read_fraction),
KEY_REAL(Scene, side, SETTING_LEAST, SETTING_MOST, "-",
W("the first side of the box, above 0, where no number is given")),
KEY_READ("box", "-",
W("ratios of the sides, one for each dimension, above 0 and "
"below 1e6"),
read_box),
KEY_REAL(
Scene, gap, 0, SETTING_MOST, "0",
W("a least distance between surfaces, in the unit of the radii, from "
"0")),
KEY_REAL(Scene, unit, 1e-150, 1e150, "-",
W("the unit of length of packs from files, in theirs; default the "
"radius of the first species, or its mean")),
KEY_SWITCH(Scene, save, W("true or false: the packs")),
KEY_READ("sweep", "-",
W("a list ( { key = KEY; values = [ ... ]; }, ... ); all "
"combinations"),
keys_later),
KEY_WORD(Scene, unreached, SCENE_UNREACHED, "fail",
W("what a combination that is not reached does")),
KEY_REAL(Scene, inside, 1e-3, 1, "0.6",
W("the core of a finite pack, by its radius, 0.001 to 1")),
KEY_REAL(
Scene, cube, 0, 1, "0",
W("a cube saved of it, by the largest in the core, 0 (none) to 1")),
KEY_READ("window", "-", W("through which packs are seen"), read_window),
KEY_READ("make", "-", W("how packs are made"), read_make),
KEY_READ("shake", "-", W("how packs are shaken"), read_shake),
KEY_READ("measure", "-", W("what is measured"), read_measures),
KEY_READ("theory", "-", W("what is calculated"), read_theory),
{0}};
static int read_all(Reader *r, config_setting_t *root) {
Key changes[16] = {{0}};
int n = 0;
for (const Change *const *c = entries_changes; *c && n < 15; c++)
if (!(*c)->stage)
changes[n++] =
(Key)KEY_READ((*c)->entry.name, "-", (*c)->entry.what, read_change);
KeySet sets[] = {{scene_keys, r->scene}, {changes, r->scene}, {0}};
return keys_read(r, root, "", sets);
}
void ask_help(FILE *file) {
char names[160];
Key chosen[] = {
{"method", WORD, 0, 0, 0, 0, names, NULL, W("the name of a maker"), NULL},
{0}};
keys_help(file, "", scene_keys);
species_help(file);
entries_names(ENTRIES(entries_makers), ALL, names, sizeof names);
keys_help(file, "make", chosen);
chosen[0].name = "rule";
chosen[0].otherwise = "the first";
chosen[0].right = W("the name of a change");
entries_names(ENTRIES(entries_changes), STAGES, names, sizeof names);
keys_help(file, "shake", chosen);
keys_help(file, "shake", stage_keys + 1);
keys_help(file, "window", view_keys);
keys_help(file, "theory", theory_keys);
}
static void find_sizes(Scene *scene) {
double least = GSL_POSINF,
first = scene->kinds ? scene->species[0].radius : 1;
bool law = scene_by_law(scene);
scene->own_radii |= law;
scene->alike = !scene->own_radii;
for (int s = 0; s < scene->kinds; s++) {
const Shape *shape = scene->species[s].shape;
least = fmin(least, scene->species[s].radius * (shape ? shape->inner : 1));
scene->alike = scene->alike && scene->species[s].radius == first;
}
if (scene->contact == 0)
scene->contact = law || !scene->kinds ? (law ? 0 : 2) : 2 * least / first;
}
static void find_facts(Scene *scene) {
const Maker *maker = (const Maker *)scene->make.entry;
scene->facts = maker->promises | (scene->alike ? FACT_ONE_SIZE : 0) |
(scene_shaped(scene) ? 0 : FACT_BALLS);
for (const Asked *c = scene->change; c && c->entry; c++)
scene->facts &= ((const Change *)c->entry)->keeps;
if (!(maker->promises & FACT_HARD))
scene->contact = 0;
}
static int refuse_finite(const Query *query) {
const Scene *scene = query->scene;
bool wanted = scene->cube > 0;
char what[96], right[96];
for (int s = 0; s < scene->kinds; s++)
wanted |= scene->sizes[s].grows;
for (const Asked *c = scene->change; c && c->entry; c++)
wanted |= (((const Change *)c->entry)->wants & FACT_FINITE) != 0;
for (const Maker *const *m = entries_makers; wanted && *m; m++)
if ((*m)->promises & FACT_FINITE) {
snprintf(what, sizeof what, "dilute, cube and grow are of packs by %s",
(*m)->entry.name);
snprintf(right, sizeof right, "give make = { method = \"%s\"; }",
(*m)->entry.name);
return query_wrong(query, "make", what, right);
}
return DONE;
}
static void add_name(char *names, size_t room, const char *name) {
strncat(names, *names ? "|" : "", room - strlen(names) - 1);
strncat(names, name, room - strlen(names) - 1);
}
static int refuse_maker(const Query *query, const Maker *maker) {
char what[96], right[200], names[120] = "";
for (const Maker *const *m = entries_makers; *m; m++)
if (!((*m)->promises & FACT_BALLS))
add_name(names, sizeof names, (*m)->entry.name);
snprintf(what, sizeof what, "%s makes balls, and a species has a shape",
maker->entry.name);
snprintf(right, sizeof right, "give one of \"%s\", or leave shape out",
names);
return query_wrong(query, "make", what, right);
}
static int refuse_change(const Query *all, const Asked *asked) {
char names[120] = "";
Query query = *all;
query.asked = asked;
for (const Change *const *c = entries_changes; *c; c++)
if ((*c)->stage && !((*c)->wants & FACT_BALLS))
add_name(names, sizeof names, (*c)->entry.name);
if (*names && ((const Change *)asked->entry)->stage)
return query_say(&query,
"%s moves balls, and a species has a shape; give one of "
"\"%s\", or leave shake out",
asked->entry->name, names);
return query_say(&query,
"%s moves balls, and a species has a shape; leave "
"it out",
asked->entry->name);
}
static int refuse_shapes(const Query *query) {
const Scene *scene = query->scene;
const Maker *maker = (const Maker *)scene->make.entry;
bool shaped = scene_shaped(scene);
if (shaped && maker->promises & FACT_BALLS)
return refuse_maker(query, maker);
for (const Asked *c = scene->change; shaped && c && c->entry; c++)
if (((const Change *)c->entry)->wants & FACT_BALLS)
return refuse_change(query, c);
return DONE;
}
static int refuse_gap(const Query *query, const Maker *maker) {
const Scene *scene = query->scene;
char what[96], right[200], names[120] = "";
for (const Maker *const *m = entries_makers; *m; m++)
if ((*m)->promises & FACT_GAP)
add_name(names, sizeof names, (*m)->entry.name);
snprintf(what, sizeof what, "%s keeps no gap", maker->entry.name);
snprintf(right, sizeof right, "give one of \"%s\", or leave gap out", names);
if (!(maker->promises & FACT_GAP))
return query_wrong(query, "gap", what, right);
for (const Asked *c = scene->change; c && c->entry; c++)
if (((const Change *)c->entry)->stage && scene->stages.sweeps > 0)
return query_wrong(
query, "gap", "shakes keep no gap",
"leave out shake, give sweeps = 0 for shakes in growth "
"only, or leave gap out");
return DONE;
}
static int ask_facts(const Query *all, unsigned facts) {
for (const Asked *one = all->scene->measure; one && one->entry; one++) {
const Measure *measure = (const Measure *)one->entry;
bool seen = !all->scene->make.entry &&
view_how(all->scene, one, facts) != EDGES_DEFAULT;
unsigned missing = measure->wants & ~(facts | (seen ? FACT_PERIODIC : 0));
char key[64];
Query query = *all;
query.asked = one;
snprintf(key, sizeof key, "measure.%s", measure->entry.name);
if (missing == FACT_PERIODIC)
return query_say(&query, "%s is not of %s; leave it out", key,
facts & FACT_FINITE ? "finite packs"
: "packs with walls");
if (missing & FACT_BALLS)
return query_say(
&query, "%s is of balls, and a species has a shape; leave it out",
key);
if (missing & FACT_ONE_SIZE && !all->root)
return outcome_set(all->reader->out, WRONG,
"%s: has several sizes; %s is of particles of one "
"size, leave it out of %s",
all->reader->path, measure->entry.name,
all->scene->path);
if (missing)
return query_wrong(all, key, measure->of, measure->right);
}
return DONE;
}
static bool tells_pairs(const Asked *one) {
const Entry *entry = one->entry;
for (int t = 0; entry->told && entry->told[t].name; t++)
if (entry->told[t].over == EACH_PAIR || entry->told[t].over == EACH_ORDERED)
if (!entry->tells || entry->tells(one->own, t))
return true;
return false;
}
static int ask_fits(const Query *all, unsigned facts, const Box *box) {
double most = box ? box_reach(box) / all->species[0].radius : GSL_POSINF;
for (const Asked *one = all->scene->measure; one && one->entry; one++) {
const Measure *measure = (const Measure *)one->entry;
double within = measure->within ? measure->within(one->own) : 0;
bool seen = view_how(all->scene, one, facts) != EDGES_DEFAULT;
Query query = *all;
query.asked = one;
if (query.kinds > ENTRY_KINDS_MOST && tells_pairs(one))
return query_say(&query,
"measure.%s is of pairs of species, and %d species have "
"too many; at most %d species, or leave it out",
measure->entry.name, query.kinds, ENTRY_KINDS_MOST);
if (within > most && !seen)
return query_say(&query,
"measure.%s = %g goes beyond half the box; the largest "
"reach here is %.6g",
measure->limit, within, most);
if (measure->fits && measure->fits(&query, one->own, seen ? NULL : box))
return all->reader->out->status;
}
return DONE;
}
int ask_measures(const Query *query, unsigned facts, const Box *box) {
return ask_facts(query, facts) || view_ask(query, facts, box)
? WRONG
: ask_fits(query, facts, box);
}
Box ask_box(const Scene *scene) {
return ((const Maker *)scene->make.entry)->box(scene, scene->make.own);
}
static int check_list(const Query *all, const Asked *list, const char *group) {
for (const Asked *one = list; one && one->entry; one++) {
char name[64];
Query query = *all;
snprintf(name, sizeof name, "%s%s", group, one->entry->name);
query.asked = one;
query.group = name;
if (one->entry->check && one->entry->check(&query, one->own))
return all->reader->out->status;
}
return DONE;
}
static int check_theory(const Query *all) {
const Scene *scene = all->scene;
const SceneTheory *t = &scene->theory;
bool listed = false;
if (t->line &&
query_bins(all, "theory", t->line, 2 - t->step, t->reach, t->step))
return WRONG;
if (t->line && !scene->curve)
return query_wrong(all, "theory", "curves is missing in theory",
"a list of names, see randpack help, or mixture = true");
for (const Asked *c = scene->curve; c && c->entry; c++)
listed |= ((const Curve *)c->entry)->alloc != NULL;
if (listed && !t->phis)
return query_wrong(all, "theory", "phi is missing in theory",
"a list of packing fractions, above 0 to 0.74");
return check_list(all, scene->curve, "theory.");
}
static int check_pack(const Query *all) {
Scene *scene = all->scene;
const Maker *maker = (const Maker *)scene->make.entry;
Query query = *all;
query.asked = &scene->make;
query.group = "make";
if (!scene->kinds)
return query_wrong(all, "make", "species is missing in the scene",
"a list ( { radius; number; }, ... )");
if (refuse_shapes(all))
return WRONG;
find_facts(scene);
query.species = scene->species;
query.kinds = scene->kinds;
if (ask_facts(&query, scene->facts | FACT_PERIODIC))
return WRONG;
if (scene->gap > 0 && refuse_gap(all, maker))
return WRONG;
if (maker->settle(&query, scene->make.own) ||
check_list(&query, scene->change, ""))
return WRONG;
if (!(scene->facts & FACT_FINITE) && refuse_finite(&query))
return WRONG;
Box box = ask_box(scene);
return ask_measures(&query, scene->facts,
scene->facts & FACT_FINITE ? NULL : &box);
}
static int ask_lone_keys(const Query *query) {
const Scene *scene = query->scene;
if (scene->unreached && !query_says(query, "sweep"))
return query_wrong(query, "unreached", "unreached is of a sweep",
"leave it out");
if (scene->make.entry && scene->unit > 0)
return query_wrong(query, "unit", "unit is of packs from files",
"leave it out; it is the radius of the first species");
return view_check(query);
}
int ask_scene(Reader *r, config_setting_t *root) {
Scene *scene = r->scene;
Query query = {.scene = scene, .reader = r, .root = root};
const Maker *maker;
if (read_all(r, root))
return r->out->status;
maker = (const Maker *)scene->make.entry;
if (!maker && !scene->measures && !scene->theory.line)
return setting_wrong(r, root, "nothing to do",
"give make, measure or theory");
if (ask_lone_keys(&query))
return WRONG;
query.asked = &scene->make;
query.group = "make";
if (maker && maker->begin && maker->begin(&query, scene->make.own))
return r->out->status;
if (species_laws(r, root))
return r->out->status;
find_sizes(scene);
if (maker && !(maker->promises & FACT_HARD))
scene->contact = 0;
if (check_list(&query, scene->measure, "measure.") || check_theory(&query))
return r->out->status;
return maker ? check_pack(&query) : DONE;
}
