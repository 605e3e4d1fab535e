#include "plot.h"
#include "curves.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
static bool is_sweep(const char *path) {
const char *slash = strrchr(path, '/');
return strcmp(slash ? slash + 1 : path, "sweep.tsv") == 0;
}
static bool draw_tables(const char *const path[], const char *const label[],
int n, const char *picture, Outcome *out) {
Sheet *sheet[PLOT_MOST] = {0};
const char *name[PLOT_MOST];
Graph g = {0};
bool drawn = false;
for (int s = 0; s < n && out->status == DONE; s++) {
sheet[s] = sheet_read(path[s], out);
name[s] = label[s] || !sheet[s] ? label[s] : sheet[s]->swept;
}
bool sweep = n == 1 && is_sweep(path[0]);
if (out->status == DONE && sheet_places(sheet[0]) == 3 && !sweep)
drawn = n == 1 && curves_surface(sheet[0], picture, out);
else if (out->status == DONE) {
if (sweep)
curves_of_sweep(&g, sheet[0]);
else
curves_of_tables(&g, sheet, name, n);
drawn = g.lines > 0;
if (drawn)
graph_draw(&g, picture, out);
}
graph_free(&g);
for (int s = 0; s < n; s++)
sheet_free(&sheet[s]);
return drawn;
}
int plot_tables(const char *const path[], int n, const char *picture,
Outcome *out) {
const char *label[PLOT_MOST];
if (n > PLOT_MOST)
return outcome_set(out, WRONG,
"%d tables are too many for one picture; "
"give %d at most",
n, PLOT_MOST);
for (int s = 0; s < n; s++)
label[s] = n > 1 ? path[s] : "";
if (!draw_tables(path, label, n, picture, out))
outcome_set(out, UNREACHED, "%s: nothing to draw", path[0]);
return out->status;
}
typedef struct {
char name[256];
ino_t number;
struct timespec time;
} Written;
struct PlotSeen {
Written *file;
size_t n;
};
static int by_name(const void *a, const void *b) {
return strcmp(((const Written *)a)->name, ((const Written *)b)->name);
}
PlotSeen *plot_look(const char *directory) {
PlotSeen *seen = memory(1, sizeof *seen);
DIR *open = opendir(directory);
struct dirent *entry;
struct stat of;
while (open && (entry = readdir(open))) {
size_t length = strlen(entry->d_name);
if (length < 5 || length > 255 ||
strcmp(entry->d_name + length - 4, ".tsv") != 0 ||
fstatat(dirfd(open), entry->d_name, &of, 0) != 0)
continue;
seen->file = memory_grow(seen->file, seen->n + 1, sizeof *seen->file);
Written *file = &seen->file[seen->n++];
memcpy(file->name, entry->d_name, length + 1);
file->number = of.st_ino;
file->time = of.st_mtim;
}
if (open)
closedir(open);
if (seen->n)
qsort(seen->file, seen->n, sizeof *seen->file, by_name);
return seen;
}
static bool is_old(const Written *file, const PlotSeen *seen) {
const Written *old =
seen->n ? bsearch(file, seen->file, seen->n, sizeof *file, by_name)
: NULL;
return old && old->number == file->number &&
old->time.tv_sec == file->time.tv_sec &&
old->time.tv_nsec == file->time.tv_nsec;
}
static void forget(PlotSeen **seen) {
free((*seen)->file);
free(*seen);
*seen = NULL;
}
static PlotSeen *look_again(const PlotSeen *seen, const char *directory) {
PlotSeen *now = plot_look(directory);
size_t n = 0;
for (size_t i = 0; i < now->n; i++)
if (!is_old(&now->file[i], seen))
now->file[n++] = now->file[i];
now->n = n;
return now;
}
typedef struct {
char key[256];
size_t stem, pair;
enum { PLAIN, MADE, SHAKEN } stage;
} Name;
static Name read_name(const char *file) {
Name name = {.stage = PLAIN};
if (strncmp(file, "made.", 5) == 0)
name.stage = MADE;
else if (strncmp(file, "shaken.", 7) == 0)
name.stage = SHAKEN;
file += name.stage == MADE ? 5 : name.stage == SHAKEN ? 7 : 0;
size_t length = strlen(file) > 4 ? strlen(file) - 4 : 0;
memcpy(name.key, file, length);
name.key[length] = '\0';
name.pair = strcspn(name.key, "@");
name.stem = strcspn(name.key, ".@");
return name;
}
static bool same_text(const char *a, size_t n, const char *b, size_t m) {
return n == m && strncmp(a, b, n) == 0;
}
static bool related(const Name *a, const Name *b, bool pairs) {
const char *values = a->key + a->pair, *others = b->key + b->pair;
if (a->stage != b->stage || !same_text(a->key, a->stem, b->key, b->stem))
return false;
if (pairs)
return a->pair > a->stem && b->pair > b->stem && !strcmp(values, others);
return *values && *others && same_text(a->key, a->pair, b->key, b->pair);
}
typedef struct {
const char *directory, *format;
const PlotSeen *now;
Name *name;
Outcome *out;
} Plots;
static bool draw_some(const Plots *plots, const size_t table[],
const char *const label[], int n, const char *key) {
char *path[PLOT_MOST] = {0}, picture[4096];
for (int k = 0; k < n; k++) {
const char *file = plots->now->file[table[k]].name;
size_t room = strlen(plots->directory) + strlen(file) + 2;
path[k] = memory(room, 1);
snprintf(path[k], room, "%s/%s", plots->directory, file);
}
snprintf(picture, sizeof picture, "%s/%s.%s", plots->directory, key,
plots->format);
bool drawn =
draw_tables((const char *const *)path, label, n, picture, plots->out);
if (!drawn && n == 1 && plots->out->status == DONE)
fprintf(stderr, "randpack: note: %s: nothing to draw\n", path[0]);
for (int k = 0; k < n; k++)
free(path[k]);
return drawn || plots->out->status != DONE;
}
static size_t find(const Plots *plots, const char *key, int stage) {
size_t i = 0;
while (i < plots->now->n && ((int)plots->name[i].stage != stage ||
strcmp(plots->name[i].key, key) != 0))
i++;
return i;
}
static void draw_single(const Plots *plots, size_t i) {
const Name *name = &plots->name[i];
size_t both[] = {find(plots, name->key, MADE), i};
const char *const labels[] = {"made", "shaken"}, *const none[] = {""};
bool shaken = find(plots, name->key, SHAKEN) < plots->now->n;
char alone[300];
if (name->stage == MADE && shaken)
return;
if (name->stage == SHAKEN && both[0] < plots->now->n) {
if (draw_some(plots, both, labels, 2, name->key))
return;
snprintf(alone, sizeof alone, "made.%s", name->key);
draw_some(plots, both, none, 1, alone);
snprintf(alone, sizeof alone, "shaken.%s", name->key);
draw_some(plots, &i, none, 1, alone);
} else
draw_some(plots, &i, none, 1, name->key);
}
static void draw_family(const Plots *plots, size_t i, bool pairs) {
const Name *name = &plots->name[i];
size_t table[PLOT_MOST];
char text[PLOT_MOST][256], key[512];
const char *label[PLOT_MOST];
int n = 0;
for (size_t j = 0; name->stage != MADE && j < plots->now->n; j++) {
const Name *other = &plots->name[j];
if (!related(name, other, pairs))
continue;
if (j < i || n == PLOT_MOST)
return;
table[n] = j;
snprintf(text[n], sizeof text[n], "%.*s",
pairs ? (int)(other->pair - other->stem) - 1 : 0,
other->key + other->stem + 1);
label[n] = pairs ? text[n] : NULL;
n++;
}
snprintf(key, sizeof key, "%.*s%s", (int)(pairs ? name->stem : name->pair),
name->key, pairs ? name->key + name->pair : "");
if (n > 1)
draw_some(plots, table, label, n, key);
}
int plot_new(PlotSeen **seen, const char *directory, const char *format,
Outcome *out) {
PlotSeen *now = look_again(*seen, directory);
Plots plots = {directory, format, now, memory(now->n, sizeof(Name)), out};
for (size_t i = 0; i < now->n; i++)
plots.name[i] = read_name(now->file[i].name);
for (size_t i = 0; i < now->n && out->status == DONE; i++) {
if (strcmp(plots.name[i].key, "summary") == 0)
continue;
draw_single(&plots, i);
draw_family(&plots, i, true);
draw_family(&plots, i, false);
}
free(plots.name);
forget(&now);
forget(seen);
return out->status;
}
