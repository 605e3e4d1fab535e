#include "setting.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
int setting_wrong(Reader *r, const config_setting_t *at, const char *what,
const char *right) {
unsigned line = at ? config_setting_source_line(at) : 0;
char place[32];
if (at && config_setting_is_root(at))
line = 1;
snprintf(place, sizeof place, "%u", line);
if (line == 0)
snprintf(place, sizeof place, "%s", "--set");
return outcome_set(r->out, WRONG, "%s:%s: %s; %s", r->path, place, what,
right);
}
int setting_bad(Reader *r, const config_setting_t *at, const char *right) {
char what[96];
const char *name = config_setting_name(at);
snprintf(what, sizeof what, "%.60s has a wrong value",
name ? name : "an element of the list");
return setting_wrong(r, at, what, right);
}
bool setting_whole(const config_setting_t *at) {
int type = config_setting_type(at);
return type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64;
}
double setting_number(const config_setting_t *at) {
if (setting_whole(at))
return (double)config_setting_get_int64(at);
return config_setting_type(at) == CONFIG_TYPE_FLOAT
? config_setting_get_float(at)
: NAN;
}
int setting_place(const char *word, const char *words) {
size_t length = strlen(word);
for (int place = 0; words; place++) {
const char *bar = strchr(words, '|');
if (length == (bar ? (size_t)(bar - words) : strlen(words)) &&
strncmp(word, words, length) == 0)
return place;
words = bar ? bar + 1 : NULL;
}
return -1;
}
int setting_list(const config_setting_t *at, double value[], int most,
double limit) {
int count = config_setting_length(at);
if (!(config_setting_is_array(at) || config_setting_is_list(at)) ||
count < 1 || count > most)
return -1;
for (int i = 0; i < count; i++) {
value[i] = setting_number(config_setting_get_elem(at, (unsigned)i));
if (!(value[i] > 0 && value[i] <= limit))
return -1;
}
return count;
}
static const char *skip(const char *at) {
if (*at == '#' || (at[0] == '/' && at[1] == '/'))
return at + strcspn(at, "\n");
if (at[0] == '/' && at[1] == '*') {
const char *end = strstr(at + 2, "*/");
return end ? end + 2 : at + strlen(at);
}
if (*at != '"')
return at;
for (at++; *at && *at != '"';)
at += *at == '\\' && at[1] ? 2 : 1;
return *at ? at + 1 : at;
}
typedef struct {
size_t length;
bool whole, real, hex;
} Word;
static Word word_at(const char *text) {
static const char digits[] = "0123456789";
Word word = {.length = (size_t)(skip(text) - text)};
if (word.length)
return word;
size_t sign = strspn(text, "+-"), left;
size_t n = sign + strspn(text + sign, digits);
word.length = strspn(text, "+-.*_abcdefghijklmnopqrstuvwxyz"
"ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789");
bool hex = text[sign] == '0' && (text[sign + 1] | 32) == 'x';
left = word.length - n;
word.hex = hex && strspn(text + sign + 2, "0123456789abcdefABCDEF") ==
word.length - sign - 2;
word.whole = n > sign && left == 0;
word.real = !word.whole && !hex && n + (text[n] == '.') > sign &&
strspn(text + n, ".eE+-0123456789") == left && left > 0;
word.length = word.length ? word.length : 1;
return word;
}
static bool is_long(Word word) {
return (word.whole || word.hex) && word.length >= 10;
}
static const char *mark_of(const char *text) {
const char *mark = "";
while (*text && *text != ']') {
Word word = word_at(text);
if (word.real)
return ".0";
if (is_long(word))
mark = "L";
text += word.length;
}
return mark;
}
static char *widen(const char *text) {
char *wide = memory(2 * strlen(text) + 3, 1), *to = wide;
const char *mark = "";
while (*text) {
Word word = word_at(text);
mark = *text == '[' ? mark_of(text + 1) : *text == ']' ? "" : mark;
memcpy(to, text, word.length);
to += word.length;
text += word.length;
if (word.whole && *mark)
to = stpcpy(to, mark);
else if (is_long(word))
*to++ = 'L';
}
return wide;
}
static bool decimal_comma(const char *text, int line) {
while (line > 1 && (text = strchr(text, '\n')))
text++, line--;
const char *end = text ? text + strcspn(text, "\n") : NULL;
for (const char *at = text; text && (at = strchr(at, '=')) && at < end;) {
at += 1 + strspn(at + 1, " \t+-");
size_t digits = strspn(at, "0123456789");
if (digits && at[digits] == ',' && strspn(at + digits + 1, "0123456789"))
return true;
}
return false;
}
static int complain_of_text(Reader *r, const config_t *config,
const char *text) {
int line = config_error_line(config);
const char *what = config_error_text(config);
bool comma = decimal_comma(text, line);
if (strcmp(what, "memory exhausted") == 0)
what = "too many brackets within brackets";
return outcome_set(r->out, WRONG, "%s:%d: %s; %s", r->path, line,
comma ? "a comma in a number" : what,
comma ? "write a decimal point, not a comma"
: "settings are KEY = VALUE;");
}
int setting_parse(Reader *r, config_t *config, const char *text) {
char *wide = widen(text);
if (strstr(text, "@include"))
outcome_set(r->out, WRONG,
"%s:1: @include; a scene is a single file, copy it in",
r->path);
else if (!config_read_string(config, wide))
complain_of_text(r, config, wide);
free(wide);
return r->out->status;
}
static void copy(config_setting_t *to, const config_setting_t *from) {
switch (config_setting_type(from)) {
case CONFIG_TYPE_INT:
config_setting_set_int(to, config_setting_get_int(from));
break;
case CONFIG_TYPE_INT64:
config_setting_set_int64(to, config_setting_get_int64(from));
break;
case CONFIG_TYPE_FLOAT:
config_setting_set_float(to, config_setting_get_float(from));
break;
case CONFIG_TYPE_BOOL:
config_setting_set_bool(to, config_setting_get_bool(from));
break;
case CONFIG_TYPE_STRING:
config_setting_set_string(to, config_setting_get_string(from));
break;
default:
for (int i = 0; i < config_setting_length(from); i++) {
config_setting_t *part = config_setting_get_elem(from, (unsigned)i);
config_setting_t *fresh = config_setting_add(
to, config_setting_name(part), config_setting_type(part));
if (fresh)
copy(fresh, part);
}
}
}
int setting_replace(Reader *r, config_setting_t *root, const char *path,
const config_setting_t *value, unsigned line) {
char parts[128], *rest = parts, *name, *next;
snprintf(parts, sizeof parts, "%s", path);
config_setting_t *at = root;
name = strtok_r(rest, ".", &rest);
while (name && (next = strtok_r(rest, ".", &rest))) {
config_setting_t *inner = config_setting_lookup(at, name);
at = inner ? inner : config_setting_add(at, name, CONFIG_TYPE_GROUP);
if (!at || !(config_setting_is_group(at) || config_setting_is_list(at)))
break;
name = next;
}
if (at && name && config_setting_is_group(at)) {
if (config_setting_get_member(at, name))
config_setting_remove(at, name);
at = config_setting_add(at, name, config_setting_type(value));
if (at)
return at->line = line, copy(at, value), DONE;
}
if (line)
return setting_wrong(r, value, "a sweep of a key that has no place",
"give one as measure.rdf.step");
return outcome_set(r->out, WRONG,
"--set %s: no such place in %s; give "
"KEY=VALUE, as measure.rdf.step=0.01",
path, r->path);
}
int setting_apply(Reader *r, config_setting_t *root, const char *setting) {
const char *equal = strchr(setting, '=');
char path[128], text[1024];
if (!equal || equal == setting || equal - setting >= (long)sizeof path)
return outcome_set(r->out, WRONG, "--set %s: not a setting; give KEY=VALUE",
setting);
snprintf(path, sizeof path, "%.*s", (int)(equal - setting), setting);
config_t config;
config_init(&config);
snprintf(text, sizeof text, "v = %s;", equal + 1);
char *wide = widen(text);
int good = config_read_string(&config, wide) &&
config_setting_length(config_root_setting(&config)) == 1;
free(wide);
if (!good) {
snprintf(text, sizeof text, "v = \"%s\";", equal + 1);
good = config_read_string(&config, text);
}
if (good)
setting_replace(r, root, path, config_lookup(&config, "v"), 0);
else
outcome_set(r->out, WRONG,
"--set %s: the value cannot be read; give it "
"as it would stand in a scene",
setting);
config_destroy(&config);
return r->out->status;
}
