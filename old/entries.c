#include "entries.h"
#include <string.h>
#define DECLARE_MAKER(name) extern const Maker maker_##name;
#define DECLARE_CHANGE(name) extern const Change change_##name;
#define DECLARE_MEASURE(name) extern const Measure measure_##name;
#define DECLARE_CURVE(name) extern const Curve curve_##name;
#define ADDRESS_MAKER(name) &maker_##name,
#define ADDRESS_CHANGE(name) &change_##name,
#define ADDRESS_MEASURE(name) &measure_##name,
#define ADDRESS_CURVE(name) &curve_##name,
MAKERS(DECLARE_MAKER)
CHANGES(DECLARE_CHANGE)
MEASURES(DECLARE_MEASURE)
CURVES(DECLARE_CURVE)
const Maker *const entries_makers[] = {MAKERS(ADDRESS_MAKER) NULL};
const Change *const entries_changes[] = {CHANGES(ADDRESS_CHANGE) NULL};
const Measure *const entries_measures[] = {MEASURES(ADDRESS_MEASURE) NULL};
const Curve *const entries_curves[] = {CURVES(ADDRESS_CURVE) NULL};
const Entry *entries_find(const Entry *const list[], const char *name) {
while (*list && strcmp((*list)->name, name) != 0)
list++;
return *list;
}
void entries_names(const Entry *const list[], EntriesWhich which, char *names,
size_t room) {
*names = '\0';
for (; *list; list++) {
bool stage = which != ALL && ((const Change *)*list)->stage;
if (which == ALL || (which == STAGES) == stage) {
strncat(names, *names ? "|" : "", room - strlen(names) - 1);
strncat(names, (*list)->name, room - strlen(names) - 1);
}
}
}
