#include "sheet.h"
#include "fields.h"
#include "lines.h"
#include <ctype.h>
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static char *copy_text(const char *text) {
char *copy = memory(strlen(text) + 1, 1);
return strcpy(copy, text);
}
static char *keep_line(Sheet *s, const char *line) {
s->text = memory_grow(s->text, s->lines + 1, sizeof *s->text);
return s->text[s->lines++] = copy_text(line);
}
static size_t cut(char *line, char ***list, size_t n) {
size_t words = 0;
for (char *at = line; at; words++) {
char *tab = strchr(at, '\t');
if (tab)
*tab = '\0';
*list = memory_grow(*list, n + words + 1, sizeof **list);
(*list)[n + words] = at;
at = tab ? tab + 1 : NULL;
}
return words;
}
static void add_swept(Sheet *s, const char *line) {
const char *equal = strstr(line, " = "), *key = line;
for (const char *c = line; equal && c < equal; c++)
if (*c == '.')
key = c + 1;
if (!equal)
return;
size_t had = strlen(s->swept), more = strlen(key);
s->swept = memory_grow(s->swept, had + more + 3, 1);
sprintf(s->swept + had, "%s%s", had ? ", " : "", key);
}
static void take_header(Sheet *s, const char *line, size_t number, bool *made) {
line += strspn(line, "# ");
if (number == 1) {
free(s->what);
s->what = copy_text(line);
} else if (number == 2) {
free(s->origin);
s->origin = copy_text(line);
} else if (strncmp(line, "randpack ", 9) == 0)
*made = true;
else if (*made)
add_swept(s, line);
}
static int take_line(Sheet *s, Lines *lines) {
size_t n = s->rows * s->columns;
char *line = keep_line(s, lines->line);
if (!s->columns) {
s->columns = cut(line, &s->name, 0);
return s->columns > 1 ? DONE
: lines_wrong(lines, "no names of columns",
"give a table that randpack wrote");
}
if (cut(line, &s->cell, n) != s->columns)
return lines_wrong(lines, "a row that is not as long as the names",
"give a table that randpack wrote");
s->rows++;
return DONE;
}
Sheet *sheet_read(const char *path, Outcome *out) {
Lines lines;
Sheet *s = memory(1, sizeof *s);
bool made = false;
s->what = copy_text("");
s->origin = copy_text("");
s->swept = copy_text("");
if (lines_open(&lines, path, out))
while (lines_next(&lines)) {
if (*lines.line == '#' && !s->columns)
take_header(s, lines.line, lines.number, &made);
else if (*lines.line && *lines.line != '#' && take_line(s, &lines))
break;
}
if (out->status == DONE && !s->columns)
lines_wrong(&lines, "no names of columns",
"give a table that randpack wrote");
lines_close(&lines);
if (out->status != DONE)
sheet_free(&s);
return s;
}
void sheet_free(Sheet **sheet) {
Sheet *s = *sheet;
if (!s)
return;
for (size_t l = 0; l < s->lines; l++)
free(s->text[l]);
free(s->text);
free(s->name);
free(s->cell);
free(s->what);
free(s->origin);
free(s->swept);
free(s);
*sheet = NULL;
}
double sheet_number(const Sheet *sheet, size_t row, size_t column) {
double value;
const char *cell = sheet->cell[row * sheet->columns + column];
return fields_number(cell, &value) ? value : GSL_NAN;
}
static bool ends_in(const char *name, const char *end) {
size_t n = strlen(name), m = strlen(end);
return n > m && strcmp(name + n - m, end) == 0;
}
static bool is_error(const Sheet *s, size_t c) {
size_t n = strlen(s->name[c]);
return c > 0 && ends_in(s->name[c], "_err") &&
strncmp(s->name[c - 1], s->name[c], n - 4) == 0 &&
strlen(s->name[c - 1]) == n - 4;
}
static bool has_error(const Sheet *s, size_t c) {
return c + 1 < s->columns && is_error(s, c + 1);
}
size_t sheet_places(const Sheet *sheet) {
size_t c = 0;
while (c < sheet->columns && !has_error(sheet, c))
c++;
return c < sheet->columns ? c : 0;
}
static size_t last_error(const Sheet *s) {
size_t last = 0;
for (size_t c = 1; c < s->columns; c++)
if (is_error(s, c))
last = c;
return last;
}
static bool is_answer(const Sheet *s, size_t c) {
for (size_t r = 0; r < s->rows; r++) {
double value = sheet_number(s, r, c);
if (value != 0 && value != 1)
return false;
}
return true;
}
static bool same(const Sheet *s, size_t c, size_t row, size_t other) {
return strcmp(s->cell[row * s->columns + c],
s->cell[other * s->columns + c]) == 0;
}
static size_t repeats(const Sheet *s) {
size_t m = 1;
while (m < s->rows && same(s, 0, m, 0))
m++;
for (size_t r = 0; r < s->rows; r++)
if (!same(s, 0, r, r / m * m))
return 1;
return s->rows > m && s->rows % m == 0 ? m : 1;
}
static void name_trace(const Sheet *s, SheetTrace *t, bool one_panel) {
const char *name = s->name[t->y];
int n = 0;
while (isalpha((unsigned char)name[n]))
n++;
snprintf(t->stem, sizeof t->stem, "%.*s", one_panel ? 0 : n, name);
if (t->species)
snprintf(t->name, sizeof t->name, "%s %s, %s", s->name[0], t->species,
name);
else if (t->step > 1)
snprintf(t->name, sizeof t->name, "%s, row %zu", name, t->from + 1);
else
snprintf(t->name, sizeof t->name, "%s", name);
}
typedef struct {
const Sheet *sheet;
SheetTrace *trace;
int count, most;
bool one_panel;
} List;
static void add_trace(List *list, const SheetTrace *trace) {
const Sheet *s = list->sheet;
bool species = strcmp(s->name[0], "species") == 0;
size_t m = species ? s->rows : repeats(s);
for (size_t k = 0; k < m && list->count < list->most; k++) {
SheetTrace *t = &list->trace[list->count];
*t = *trace;
t->step = species ? 1 : m;
t->from = species ? 0 : k;
if (species && k > 0 && same(s, 0, k, k - 1))
continue;
t->species = species ? s->cell[k * s->columns] : NULL;
name_trace(s, t, list->one_panel);
list->count++;
}
}
int sheet_traces(const Sheet *sheet, SheetTrace trace[], int most) {
size_t last = last_error(sheet), place = 0;
List list = {sheet, trace, 0, most, last == 0};
if (strcmp(sheet->name[0], "species") == 0)
place = 1;
for (size_t c = place + 1; c < sheet->columns; c++) {
bool measured = has_error(sheet, c), theory = last > 0 && c > last;
SheetTrace t = {place, c, measured ? c + 1 : 0, 0, 1};
if (is_error(sheet, c) || strcmp(sheet->name[c], "change") == 0)
continue;
if (last > 0 && c < last && !measured) {
place = list.count ? c : place;
continue;
}
if (!last && is_answer(sheet, c))
continue;
t.theory = theory;
t.x = theory ? 0 : t.x;
add_trace(&list, &t);
}
return list.count;
}
static size_t unit_at(const char *text) {
const char *at = text;
if (strncmp(at, "1/", 2) == 0)
at += 2;
if (*at++ != 'a')
return 0;
bool article = *at == ' ';
if (*at == '^')
at += isalnum((unsigned char)at[1]) ? 2 : 0;
if (article && *text == 'a')
return 0;
return isalnum((unsigned char)*at) ? 0 : (size_t)(at - text);
}
static bool find_unit(const char *text, const char *end, char unit[16]) {
static const char *const words[] = {"in units of ", "in ", "by "};
for (const char *at = text; at < end && *at; at++)
for (size_t w = 0; w < sizeof words / sizeof *words; w++) {
size_t length = strlen(words[w]);
bool begins = at == text || at[-1] == ' ';
if (!begins || strncmp(at, words[w], length) != 0)
continue;
size_t n = unit_at(at + length);
if (n > 0 && n < 16) {
snprintf(unit, 16, "%.*s", (int)n, at + length);
return true;
}
}
return false;
}
void sheet_unit(const Sheet *sheet, const char *name, bool alone,
char unit[16]) {
const char *what = sheet->what, *all = what + strlen(what);
size_t length = strlen(name);
*unit = '\0';
for (const char *at = strstr(what, name); at && length;
at = strstr(at + 1, name)) {
const char *behind = at + length, *end = strchr(behind, ';');
bool word = at == what || strchr(" ;", at[-1]);
if (word && *behind == ':' && find_unit(behind, end ? end : all, unit))
return;
if (word && *behind == ' ' && find_unit(behind + 1, behind + 2, unit))
return;
}
if (alone)
find_unit(what, all, unit);
}
