#include "header.h"
#include "entry.h"
#include <stdio.h>
#include <string.h>
static const struct {
const char *entry;
const char *includes[HEADER_MODULES];
} entries[] = {
#include "includes.inc"
};
static void add(const char *used[], const char *module) {
int n = 0;
while (used[n] && strcmp(used[n], module) != 0)
n++;
if (n + 1 < HEADER_MODULES)
used[n] = module;
}
static void add_all(const char *used[], const char *kind, const char *name) {
char entry[96];
snprintf(entry, sizeof entry, "%s_%s", kind, name);
for (char *c = entry; *c; c++)
*c = *c == '-' ? '_' : *c;
for (size_t e = 0; e < sizeof entries / sizeof *entries; e++)
if (strcmp(entries[e].entry, entry) == 0)
for (int m = 0; entries[e].includes[m]; m++)
add(used, entries[e].includes[m]);
}
static void add_list(const char *used[], const char *kind, const Asked *list) {
for (; list && list->entry; list++)
add_all(used, kind, list->entry->name);
}
void header_modules(const Scene *scene, const char *used[HEADER_MODULES]) {
memset(used, 0, HEADER_MODULES * sizeof *used);
add_all(used, "spine", "run");
for (const Scene *s = scene->first; s; s = s->next) {
if (s->make.entry)
add_all(used, "maker", s->make.entry->name);
add_list(used, "change", s->change);
add_list(used, "measure", s->measure);
add_list(used, "curve", s->curve);
}
add(used, "flags");
}
void header_write(Table *table, const Scene *scene, const Species *first,
int packs, const char *what) {
const char *used[HEADER_MODULES];
char print[17];
header_modules(scene, used);
table_fingerprint(used, print);
const char *name = strrchr(scene->path, '/');
fprintf(table->file, "# %s\n", what);
fprintf(table->file, "# scene %s, seed %lld, packs %d\n",
name ? name + 1 : scene->path, (long long)scene->seed, packs);
if (first)
fprintf(table->file, "# unit of length a = %.9g, %s%s%s\n", first->radius,
scene->unit > 0 ? "as the scene says" : "the radius of ",
scene->unit > 0 ? "" : first->name,
!first->guessed ? ""
: scene->unit > 0 ? "; radii estimated from fraction and number"
: ", estimated from fraction and number");
for (int i = 0; i < scene->sets; i++)
fprintf(table->file, "# --set %s\n", scene->set[i]);
fprintf(table->file, "# randpack %s, fingerprint %s\n", TABLE_VERSION, print);
}
