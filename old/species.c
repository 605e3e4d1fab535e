#include "species.h"
#include "fields.h"
#include "keys.h"
#include "lines.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
static int say_why(Reader *r, const config_setting_t *at, Outcome *why,
const char *otherwise) {
char *right = strstr(why->text, "; ");
if (right)
*right = '\0';
return setting_wrong(r, at, why->text, right ? right + 2 : otherwise);
}
static const struct {
const char *name, *right;
size_t at;
double least, most;
unsigned laws;
} size_keys[] = {
{"spread", "0 to 5", offsetof(Sizes, spread), 0, 5, 1},
{"exponent", "-20 to 20", offsetof(Sizes, exponent), -20, 20, 2},
{"least", "a radius", offsetof(Sizes, least), 0, SETTING_MOST, 3},
{"most", "a radius above 0", offsetof(Sizes, most), SETTING_LEAST,
SETTING_MOST, 3},
};
enum { SIZE_KEYS = sizeof size_keys / sizeof *size_keys };
static int read_sieve(Reader *r, config_setting_t *at, SceneSizes *sizes) {
static const char *const names[] = {"radii", "passing"};
int count[2];
for (int l = 0; l < 2; l++) {
config_setting_t *list = config_setting_lookup(at, names[l]);
count[l] = list ? config_setting_length(list) : 0;
free(sizes->list[l]);
sizes->list[l] = memory((size_t)count[l], sizeof(double));
for (int i = 0; i < count[l]; i++)
sizes->list[l][i] =
setting_number(config_setting_get_elem(list, (unsigned)i));
}
if (count[0] < 1 || count[0] != count[1])
return setting_wrong(r, at,
"a sieve needs radii and what passes, equally many",
"give radii = [ ... ]; passing = [ ... ];");
sizes->law.sieves = count[0];
sizes->law.size = sizes->list[0];
sizes->law.passing = sizes->list[1];
return DONE;
}
typedef struct {
double radius, count;
} Listed;
static int by_radius(const void *a, const void *b) {
double u = ((const Listed *)a)->radius, v = ((const Listed *)b)->radius;
return (u > v) - (u < v);
}
static int keep_list(SceneSizes *sizes, Listed *row, int rows) {
int n = 0;
qsort(row, (size_t)rows, sizeof *row, by_radius);
for (int i = 1; i < rows; i++)
if (row[i].radius == row[n].radius)
row[n].count += row[i].count;
else
row[++n] = row[i];
n = rows ? n + 1 : 0;
for (int l = 0; l < 2; l++) {
free(sizes->list[l]);
sizes->list[l] = memory((size_t)n, sizeof(double));
for (int i = 0; i < n; i++)
sizes->list[l][i] = l ? row[i].count : row[i].radius;
}
sizes->law.sieves = n;
sizes->law.size = sizes->list[0];
sizes->law.passing = sizes->list[1];
free(row);
return DONE;
}
static bool is_heading(const char *line) {
return !strpbrk(line, "0123456789") && !strstr(line, "adi");
}
static int read_listed(Lines *lines, Listed **row, int *rows) {
bool headed = false;
while (lines_next(lines)) {
double v[2] = {0, 1};
char *line = lines->line;
line[strcspn(line, "#")] = '\0';
for (char *c = line; *c; c++)
*c = *c == ';' ? ' ' : *c;
int n = fields_numbers(line, v, 2);
bool heading = n < 0 && !headed && *rows == 0 && is_heading(line);
headed |= heading;
if (n == 0 || heading)
continue;
if (n < 1 || n > 2 || !(v[0] >= SETTING_LEAST && v[0] <= SETTING_MOST) ||
!(v[1] >= 0 && v[1] <= 4e9 && v[1] == floor(v[1])))
return lines_wrong(lines, "not a diameter and a number of particles",
"a number above 0, and a whole one from 0 or nothing");
if ((*rows & (*rows - 1)) == 0)
*row = memory_grow(*row, 2 * (size_t)*rows + 1, sizeof **row);
(*row)[(*rows)++] = (Listed){v[0] / 2, v[1]};
}
return lines->out->status;
}
static int read_list_file(Reader *r, const config_setting_t *at,
const char *path, SceneSizes *sizes) {
Outcome why = {0};
Lines lines;
Listed *row = NULL;
int rows = 0;
char what[320];
if (lines_open(&lines, path, &why))
read_listed(&lines, &row, &rows);
lines_close(&lines);
if (why.status == DONE && rows > 0)
return keep_list(sizes, row, rows);
free(row);
snprintf(what, sizeof what, "sizes: %.300s",
why.status ? why.text : "the file is empty");
return setting_wrong(r, at, what,
"give a diameter and a number in each line");
}
static int read_list(Reader *r, config_setting_t *at, SceneSizes *sizes) {
const char *path = NULL;
config_setting_t *radii = config_setting_lookup(at, "radii"),
*counts = config_setting_lookup(at, "counts");
int rows = radii ? config_setting_length(radii) : 0;
config_setting_lookup_string(at, "file", &path);
if (path && !radii && !counts)
return read_list_file(r, at, path, sizes);
if (path || rows < 1 || (counts && config_setting_length(counts) != rows))
return setting_wrong(r, at,
"a list needs radii, and counts, equally many, or a "
"file",
"give radii = [ ... ]; counts = [ ... ];");
Listed *row = memory((size_t)rows, sizeof *row);
for (int i = 0; i < rows; i++) {
unsigned place = (unsigned)i;
row[i].radius = setting_number(config_setting_get_elem(radii, place));
row[i].count =
counts ? setting_number(config_setting_get_elem(counts, place)) : 1;
}
return keep_list(sizes, row, rows);
}
static int read_size(Reader *r, config_setting_t *part, Sizes *law) {
const char *name = config_setting_name(part);
static const char *const tables[] = {NULL, NULL, "radii|passing",
"radii|counts|file"};
const char *table = tables[law->law];
if (strcmp(name, "law") == 0 || (table && setting_place(name, table) >= 0))
return DONE;
for (int k = 0; k < SIZE_KEYS; k++)
if (strcmp(name, size_keys[k].name) == 0 &&
(size_keys[k].laws >> law->law & 1)) {
double v = setting_number(part);
if (!(v >= size_keys[k].least && v <= size_keys[k].most))
return setting_bad(r, part, size_keys[k].right);
*(double *)(void *)((char *)law + size_keys[k].at) = v;
return DONE;
}
return setting_wrong(
r, part, "this law of sizes has no such key",
"lognormal: spread least most; power: exponent least most; "
"sieve: radii passing; list: radii counts, or file");
}
static int read_sizes(Reader *r, config_setting_t *at, SceneSizes *sizes) {
Sizes *law = &sizes->law;
const char *word = NULL;
bool group = config_setting_is_group(at);
int which = group && config_setting_lookup_string(at, "law", &word)
? setting_place(word, SCENE_LAWS)
: -1;
if (which < 0)
return setting_wrong(r, at, "sizes have no law",
"give sizes = { law = \"" SCENE_LAWS "\"; ... }");
*law = (Sizes){.law = (SizesLaw)which, .dim = 3, .most = INFINITY};
for (int i = 0; i < config_setting_length(at); i++) {
config_setting_t *part = config_setting_get_elem(at, (unsigned)i);
if (read_size(r, part, law))
return r->out->status;
}
return which == SIZES_SIEVE ? read_sieve(r, at, sizes)
: which == SIZES_LIST ? read_list(r, at, sizes)
: DONE;
}
static int read_grow(Reader *r, const config_setting_t *at, SceneSizes *sizes) {
const char *word = config_setting_get_string(at);
sizes->growth = word ? setting_place(word, SCENE_GROWTHS) : -1;
sizes->grows = true;
return sizes->growth < 0
? setting_bad(r, at, "one of \"" SCENE_GROWTHS "\" is right")
: DONE;
}
enum { VERTICES_MOST = 1000 };
typedef struct {
int kind, sides, vertices;
double aspect, m, vertex[VERTICES_MOST][2];
} ShapeSettings;
static int read_vertices(Reader *r, config_setting_t *at, const Key *key,
void *own) {
ShapeSettings *s = own;
s->vertices = config_setting_length(at);
if (!config_setting_is_list(at) || s->vertices < 3 ||
s->vertices > VERTICES_MOST)
return setting_bad(r, at, key->right);
for (int i = 0; i < s->vertices; i++) {
config_setting_t *point = config_setting_get_elem(at, (unsigned)i);
bool pair =
(config_setting_is_array(point) || config_setting_is_list(point)) &&
config_setting_length(point) == 2;
for (unsigned k = 0; pair && k < 2; k++) {
double v = setting_number(config_setting_get_elem(point, k));
s->vertex[i][k] = v;
pair = fabs(v) <= SETTING_MOST;
}
if (!pair)
return setting_bad(r, at, key->right);
}
return DONE;
}
static const Key shape_keys[] = {
KEY_WORD(ShapeSettings, kind, "polygon|superellipse", NULL,
W("\"polygon\" or \"superellipse\"")),
KEY_WHOLE(ShapeSettings, sides, 3, VERTICES_MOST, "-",
W("of a regular polygon, 3 to 1000")),
KEY_READ("vertices", "-",
W("of a convex polygon, in order, ([x, y], [x, y], [x, y], ...), "
"3 to 1000"),
read_vertices),
KEY_REAL(ShapeSettings, aspect, 1e-3, 1e3, "-",
W("a/b of the superellipse |x/a|^2m + |y/b|^2m = 1, 0.001 to "
"1000")),
KEY_REAL(ShapeSettings, m, 0.5, 100, "-",
W("its m, from 0.5 (a rhombus) over 1 (an ellipse) to 100")),
{0}};
void species_help(FILE *file) {
keys_help(file, "species.shape", shape_keys);
}
static int check_shape(Reader *r, const config_setting_t *at,
const ShapeSettings *s) {
bool polygon = s->kind == SHAPE_POLYGON;
if (polygon && (s->aspect != 0 || s->m != 0))
return setting_wrong(r, at, "aspect and m are of a superellipse",
"give a polygon sides or vertices");
if (polygon && !s->sides == !s->vertices)
return setting_wrong(r, at,
s->sides ? "sides and vertices are too much"
: "a polygon without sides or vertices",
"give sides of a regular polygon, or the vertices of "
"another");
if (!polygon && (s->sides || s->vertices))
return setting_wrong(r, at, "sides and vertices are of a polygon",
"give a superellipse aspect and m");
if (!polygon && (s->aspect == 0 || s->m == 0))
return setting_wrong(r, at, "a superellipse without aspect or m",
"give aspect = ...; m = ...;");
if (s->m > 0.5 && s->m < 0.5 + 1e-9)
return setting_wrong(r, at, "m is all but 0.5", "give 0.5, a rhombus");
return DONE;
}
static int read_shape(Reader *r, config_setting_t *at, Shape **shape) {
ShapeSettings *s = memory(1, sizeof *s);
KeySet sets[] = {{shape_keys, s}, {0}};
Outcome why = {0};
if (!config_setting_is_group(at))
setting_bad(r, at, "a group { kind = \"polygon\"; sides = 5; } is right");
else if (keys_read(r, at, "shape", sets) == DONE &&
check_shape(r, at, s) == DONE) {
const double(*v)[2] = (const double(*)[2])s->vertex;
*shape = s->m > 0 ? shape_superellipse(s->aspect, s->m)
: s->sides ? shape_regular(s->sides)
: shape_convex(s->vertices, v, &why);
if (!*shape)
say_why(r, at, &why, "give the corners of a convex polygon in order");
}
free(s);
return r->out->status;
}
static int read_one(Reader *r, config_setting_t *at, Species *species,
SceneSizes *sizes, double *share, int *way) {
static const char *const names[] = {"name", "radius", "number", "share",
"volume", "mass", "density"};
double value[7] = {0};
sizes->law.dim = 0;
sizes->grows = false;
for (int i = 0; i < config_setting_length(at); i++) {
config_setting_t *part = config_setting_get_elem(at, (unsigned)i);
const char *name = config_setting_name(part);
int which = 0;
if (strcmp(name, "sizes") == 0 || strcmp(name, "grow") == 0) {
if (*name == 's' ? read_sizes(r, part, sizes) : read_grow(r, part, sizes))
return r->out->status;
continue;
}
if (strcmp(name, "shape") == 0) {
if (read_shape(r, part, &species->shape))
return r->out->status;
continue;
}
while (which < 7 && strcmp(name, names[which]) != 0)
which++;
if (which == 7) {
char what[128];
snprintf(what, sizeof what, "%.60s is not a key of a species", name);
return setting_wrong(
r, part, what,
"known here: name radius number share volume mass density "
"sizes grow shape");
}
const char *word = config_setting_get_string(part);
if (which == 0 && word && strlen(word) < sizeof species->name && *word &&
!strpbrk(word, " \t\n\"")) {
strcpy(species->name, word);
continue;
}
value[which] = which == 0 ? NAN : setting_number(part);
double least = which == 2 ? 0 : SETTING_LEAST,
most = which == 2 ? 4e9 : SETTING_MOST;
if (!(value[which] >= least && value[which] <= most) ||
(which == 2 && !setting_whole(part)))
return setting_bad(r, part,
which == 0 ? "a word of at most 31 letters is right"
: which == 2
? "a whole number from 0 to 4e9 is right"
: "a number above 0 (and from 1e-50 to 1e50) "
"is right");
}
bool own = sizes->law.dim && sizes->law.law != SIZES_LOGNORMAL;
if (own == (value[1] > 0))
return setting_wrong(r, at,
own ? "the radii follow from this law of sizes"
: "a species without a radius",
own ? "leave radius out" : "give radius = ...");
sizes->law.radius = value[1];
bool has[7];
for (int k = 2; k < 7; k++)
has[k] = config_setting_get_member(at, names[k]) != NULL;
int told = has[2] + 2 * has[3] + 4 * has[4] + 8 * has[5];
if (told == 0 && sizes->law.dim && sizes->law.law == SIZES_LIST) {
told = 1;
for (int k = 0; k < sizes->law.sieves; k++)
value[2] += sizes->law.passing[k];
}
if ((told & (told - 1)) || has[5] != has[6] || (*way >= 0 && told != *way))
return setting_wrong(
r, at, "the amount of a species is not clear",
"give each its number, or share, or volume, or mass and "
"density");
*way = told;
species->radius = value[1];
species->count = (size_t)value[2];
*share = has[5] ? value[5] / value[6] : has[4] ? value[4] : value[3];
return DONE;
}
static int by_name(const void *a, const void *b) {
return strcmp(((const Species *)a)->name, ((const Species *)b)->name);
}
static int compare_names(Reader *r, const config_setting_t *at) {
const Scene *scene = r->scene;
size_t kinds = (size_t)scene->kinds, twice = 1;
Species *sorted = memory(kinds, sizeof *sorted);
char what[96];
memcpy(sorted, scene->species, kinds * sizeof *sorted);
qsort(sorted, kinds, sizeof *sorted, by_name);
while (twice < kinds && by_name(&sorted[twice - 1], &sorted[twice]) != 0)
twice++;
if (twice < kinds) {
snprintf(what, sizeof what, "two species have the name %s",
sorted[twice].name);
setting_wrong(r, at, what, "give each a name of its own");
}
free(sorted);
return r->out->status;
}
int species_read(Reader *r, config_setting_t *at) {
Scene *scene = r->scene;
int kinds = config_setting_length(at), way = -1;
if (kinds > 60000)
return setting_wrong(r, at, "too many species", "at most 60000");
if (!config_setting_is_list(at) || kinds < 1)
return setting_bad(r, at,
"a list ( { name = \"A\"; radius = 1.0; number = "
"2000; } ) is right");
scene->kinds = kinds;
scene->species = memory((size_t)kinds, sizeof(Species));
scene->share = memory((size_t)kinds, sizeof(double));
scene->sizes = memory((size_t)kinds, sizeof(SceneSizes));
for (int s = 0; s < kinds; s++) {
config_setting_t *one = config_setting_get_elem(at, (unsigned)s);
snprintf(scene->species[s].name, sizeof(char[32]), "%d", s + 1);
if (!config_setting_is_group(one))
return setting_bad(r, at, "each species is a group { ... }");
if (read_one(r, one, &scene->species[s], &scene->sizes[s], &scene->share[s],
&way))
return r->out->status;
}
if (kinds > 1 && way == 0)
return setting_wrong(r, at, "the amounts of the species are missing",
"give each its number, or share, or volume, or mass "
"and density");
scene->by_volume = way > 2;
scene->counted = way == 1;
return compare_names(r, at);
}
int species_laws(Reader *r, config_setting_t *root) {
Scene *scene = r->scene;
for (int s = 0; s < scene->kinds; s++) {
Sizes *law = &scene->sizes[s].law;
config_setting_t *list = config_setting_get_member(root, "species");
config_setting_t *at =
list ? config_setting_get_elem(list, (unsigned)s) : root;
Outcome why = {0};
if (scene->species[s].shape && scene->dimension != 2)
return setting_wrong(r, config_setting_get_member(at, "shape"),
"shapes are of two dimensions",
"give dimension = 2, or leave shape out");
if (law->dim == 0)
continue;
law->dim = scene->dimension;
if (sizes_check(law, &why))
return say_why(r, at, &why, "");
if (law->law != SIZES_LOGNORMAL)
sizes_fill(law, 1, &scene->species[s].radius);
}
return DONE;
}
static double mean_ball(const Scene *scene, int s) {
const Sizes *law = &scene->sizes[s].law;
double unit = pack_ball(scene->dimension, 1);
return law->dim ? unit * (float)sizes_mean_volume(law)
: pack_ball(scene->dimension, scene->species[s].radius);
}
void species_shares(Scene *scene) {
double sum = 0;
for (int s = 0; s < scene->kinds; s++) {
if (scene->by_volume)
scene->share[s] /= mean_ball(scene, s);
if (!(scene->share[s] > 0))
scene->share[s] = 1;
sum += scene->share[s];
}
for (int s = 0; s < scene->kinds; s++)
scene->share[s] /= sum;
}
static void round_counts(Scene *scene) {
int64_t left = scene->number;
double n = (double)scene->number;
for (int s = 0; s < scene->kinds; s++)
left -= (int64_t)(scene->species[s].count = (size_t)(n * scene->share[s]));
for (; left > 0; left--) {
int most = 0;
for (int s = 1; s < scene->kinds; s++)
if (n * scene->share[s] - (double)scene->species[s].count >
n * scene->share[most] - (double)scene->species[most].count)
most = s;
scene->species[most].count++;
}
}
int species_counts(Reader *r, const config_setting_t *species) {
Scene *scene = r->scene;
size_t total = 0;
if (!scene->counted) {
species_shares(scene);
round_counts(scene);
}
for (int s = 0; s < scene->kinds; s++)
total += scene->species[s].count;
if (total == 0 || total > 4000000000u)
return setting_wrong(r, species, "no particles, or more than 4e9",
"give a number from 1");
for (int s = 0; s < scene->kinds; s++)
if (scene->sizes[s].law.dim) {
size_t n = scene->species[s].count;
scene->sizes[s].radius = memory(n, sizeof(double));
if (n)
sizes_fill(&scene->sizes[s].law, n, scene->sizes[s].radius);
}
return DONE;
}
static int number_by_side(const Query *query, const config_setting_t *species) {
Scene *scene = query->reader->scene;
double volume = 1, mean = 0;
if (scene->full)
return query_wrong(query, "side", "side and fraction are too much",
"leave side out: it follows from the particles");
if (scene->counted || scene->number)
return query_wrong(query, "side", "side, fraction and number are too much",
"leave one out: it follows from the others");
for (int k = 0; k < scene->dimension; k++)
volume *= scene->side * scene->box[k] / scene->box[0];
species_shares(scene);
for (int s = 0; s < scene->kinds; s++)
mean += scene->share[s] * mean_ball(scene, s);
double number = floor(scene->fraction * volume / mean + 0.5);
if (!(number >= 1 && number <= 4e9))
return query_wrong(query, "side",
"no particle fits into this box, or more than 4e9",
"give a larger side, or a smaller one");
scene->number = (int64_t)number;
scene->by_volume = false;
if (species_counts(query->reader, species))
return WRONG;
scene->fraction = scene_solid(scene) / volume;
return scene->fraction < 1
? DONE
: query_wrong(query, "side", "the particles do not fit",
"give a larger side");
}
int species_settle(const Query *query) {
const Scene *scene = query->scene;
if (!scene->fraction && !scene->full)
return query_wrong(query, "make", "fraction is missing in the scene",
"a number above 0 and below 1, or \"max\"");
if (scene->sides && scene->sides != scene->dimension)
return query_wrong(query, "box",
"box does not suit the dimension or the lattice",
"a ratio for each dimension; none for a lattice");
const config_setting_t *species =
config_setting_lookup(query->root, "species");
if (query_says(query, "side"))
return number_by_side(query, species);
if (scene->counted == (scene->number > 0))
return query_wrong(query, "species", "the number of particles is not clear",
"give each species its number, or shares and one "
"number, or the side");
return species_counts(query->reader, species);
}
