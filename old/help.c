#include "help.h"
#include "ask.h"
#include "entries.h"
#include "keys.h"
#include "view.h"
#include <string.h>
typedef struct {
const char *group;
const Entry *const *list;
} Kind;
static int kinds(Kind kind[4]) {
kind[0] = (Kind){"make", ENTRIES(entries_makers)};
kind[1] = (Kind){"shake", ENTRIES(entries_changes)};
kind[2] = (Kind){"measure", ENTRIES(entries_measures)};
kind[3] = (Kind){"theory", ENTRIES(entries_curves)};
return 4;
}
static void group_of(const Kind *kind, const Entry *entry, char group[64]) {
bool change = strcmp(kind->group, "shake") == 0;
if (change && !((const Change *)entry)->stage)
snprintf(group, 64, "%s", entry->name);
else if (change || strcmp(kind->group, "make") == 0)
snprintf(group, 64, "%s", kind->group);
else
snprintf(group, 64, "%s.%s", kind->group, entry->name);
}
static const Key *edges_of(const Kind *kind, const Entry *entry) {
bool measure = strcmp(kind->group, "measure") == 0;
return measure && ((const Measure *)entry)->edges ? view_edges : NULL;
}
void help_keys(FILE *file) {
Kind kind[4];
ask_help(file);
for (int k = 0, n = kinds(kind); k < n; k++) {
const Key *told = NULL;
for (const Entry *const *e = kind[k].list; *e; e++) {
char group[64], full[96];
group_of(&kind[k], *e, group);
snprintf(full, sizeof full, "%s%s%s", group,
strcmp(group, "make") == 0 ? "." : "",
strcmp(group, "make") == 0 ? (*e)->name : "");
fprintf(file, "  %s.%s: %s\n", kind[k].group, (*e)->name, (*e)->what);
if ((*e)->keys != told)
keys_help(file, full, (*e)->keys);
keys_help(file, full, edges_of(&kind[k], *e));
told = (*e)->keys;
}
}
}
static void tell_rows(const Entry *entry, FILE *file) {
static const char *const over[] = {"", ".SPECIES", ".A-B", ".A-B and .B-A"};
for (const Told *t = entry->told; t && t->name; t++)
if (!t->columns)
fprintf(file, "  row %s%s: %s\n", t->name, over[t->over], t->what);
else if (*t->columns)
fprintf(file, "  table %s%s.tsv: %s\n", t->name,
t->over ? over[t->over] : "", t->what);
}
static void tell_example(const Kind *kind, const Entry *entry, FILE *file) {
const char *name = entry->name;
if (strcmp(kind->group, "make") == 0)
fprintf(file, "  make = { method = \"%s\"; };\n", name);
else if (strcmp(kind->group, "shake") == 0 && ((const Change *)entry)->stage)
fprintf(file, "  shake = { rule = \"%s\"; };\n", name);
else if (strcmp(kind->group, "shake") == 0)
fprintf(file, "  %s = {};\n", name);
else if (strcmp(kind->group, "measure") == 0)
fprintf(file, "  measure = { %s = {}; };\n", name);
else if (((const Curve *)entry)->alloc)
fprintf(file, "  theory = { curves = [\"%s\"]; phi = [0.3]; };\n", name);
else
fprintf(file, "  theory = { %s = true; };\n", name);
}
int help_entry(const char *name, FILE *file, Outcome *out) {
Kind kind[4];
for (int k = 0, n = kinds(kind); k < n; k++)
for (const Entry *const *e = kind[k].list; *e; e++) {
char full[96], group[64];
snprintf(full, sizeof full, "%s.%s", kind[k].group, (*e)->name);
if (strcmp(name, full) != 0 && strcmp(name, (*e)->name) != 0)
continue;
group_of(&kind[k], *e, group);
fprintf(file, "%s: %s\n", full, (*e)->what);
if ((*e)->keys)
fprintf(file, "Keys:\n");
keys_help(file, group, (*e)->keys);
keys_help(file, group, edges_of(&kind[k], *e));
if ((*e)->told)
fprintf(file, "What it writes:\n");
tell_rows(*e, file);
fprintf(file, "Example:\n");
tell_example(&kind[k], *e, file);
return DONE;
}
return outcome_set(out, WRONG,
"help %s: nothing of this name; see randpack "
"help",
name);
}
