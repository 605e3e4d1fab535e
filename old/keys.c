#include "keys.h"
#include <assert.h>
#include <math.h>
#include <string.h>
static int read_word(Reader *r, const config_setting_t *at, const Key *key,
int *value) {
char right[160];
const char *word = config_setting_get_string(at);
*value = word ? setting_place(word, key->words) : -1;
if (*value >= 0)
return DONE;
snprintf(right, sizeof right, "one of \"%s\" is right", key->words);
return setting_bad(r, at, right);
}
static int is_bad(Reader *r, const config_setting_t *at, const Key *key) {
char right[160];
snprintf(right, sizeof right, "%s is right", key->right);
return setting_bad(r, at, right);
}
static int read_number(Reader *r, const config_setting_t *at, const Key *key,
char *target) {
double v = setting_number(at);
bool whole = key->type != REAL;
bool fits = whole ? setting_whole(at) &&
config_setting_get_int64(at) <= (long long)key->most
: v <= key->most;
if (!(v >= key->least && fits))
return is_bad(r, at, key);
if (key->type == REAL)
*(double *)(void *)target = v;
else if (key->type == WIDE)
*(int64_t *)(void *)target = config_setting_get_int64(at);
else
*(int *)(void *)target = (int)v;
return DONE;
}
static int read_value(Reader *r, config_setting_t *at, const Key *key,
void *own) {
char *target = own ? (char *)own + key->at : NULL;
switch (key->type) {
case READ:
return key->read(r, at, key, own);
case WORD:
return read_word(r, at, key, (int *)(void *)target);
case SWITCH:
if (config_setting_type(at) != CONFIG_TYPE_BOOL)
return setting_bad(r, at, "true or false is right");
*(bool *)target = config_setting_get_bool(at);
return DONE;
case LIST: {
int *count = (int *)(void *)((char *)own + key->count);
*count =
setting_list(at, (double *)(void *)target, (int)key->least, key->most);
return *count > 0 ? DONE : setting_bad(r, at, key->right);
}
default:
return read_number(r, at, key, target);
}
}
static int read_default(Reader *r, const Key *key, void *own) {
char text[64];
config_t config;
config_init(&config);
bool quote = key->type == WORD;
snprintf(text, sizeof text, "%s = %s%s%s;", key->name, quote ? "\"" : "",
key->otherwise, quote ? "\"" : "");
int good = config_read_string(&config, text);
assert(good);
int status = read_value(r, config_lookup(&config, key->name), key, own);
config_destroy(&config);
return good ? status : WRONG;
}
int keys_later(Reader *r, config_setting_t *at, const Key *key, void *own) {
(void)r, (void)at, (void)key, (void)own;
return DONE;
}
int keys_unknown(Reader *r, const config_setting_t *at, const char *group,
const char *known) {
char what[160], right[320];
snprintf(what, sizeof what, "%.60s is not a key of %s",
config_setting_name(at), *group ? group : "a scene");
snprintf(right, sizeof right, "known here:%.300s", known);
return setting_wrong(r, at, what, right);
}
static int unknown(Reader *r, const config_setting_t *at, const char *group,
const KeySet sets[]) {
char known[320] = "";
for (const KeySet *set = sets; set->keys; set++)
for (const Key *key = set->keys; key->name; key++) {
strncat(known, " ", sizeof known - strlen(known) - 1);
strncat(known, key->name, sizeof known - strlen(known) - 1);
}
return keys_unknown(r, at, group, known);
}
static int fill_in(Reader *r, config_setting_t *group, const char *name,
const KeySet *set) {
for (const Key *key = set->keys; key->name; key++) {
bool absent = !config_setting_get_member(group, key->name);
if (absent && !key->otherwise) {
char what[96];
snprintf(what, sizeof what, "%s is missing in %s", key->name,
*name ? name : "the scene");
return setting_wrong(r, group, what, key->right);
}
if (absent && strcmp(key->otherwise, "-") != 0 &&
read_default(r, key, set->own))
return r->out->status;
}
return DONE;
}
int keys_read(Reader *r, config_setting_t *group, const char *name,
const KeySet sets[]) {
for (int i = 0; i < config_setting_length(group); i++) {
config_setting_t *at = config_setting_get_elem(group, (unsigned)i);
const Key *found = NULL;
void *own = NULL;
for (const KeySet *set = sets; set->keys && !found; set++)
for (const Key *key = set->keys; key->name && !found; key++)
if (strcmp(key->name, config_setting_name(at)) == 0)
found = key, own = set->own;
if (!found ? unknown(r, at, name, sets) : read_value(r, at, found, own))
return r->out->status;
}
for (const KeySet *set = sets; set->keys; set++)
if (fill_in(r, group, name, set))
return r->out->status;
return DONE;
}
void keys_help(FILE *file, const char *group, const Key keys[]) {
for (const Key *key = keys; key && key->name; key++) {
char name[64];
bool default_is_told = key->otherwise && *key->otherwise != '-';
snprintf(name, sizeof name, "%s%s%s", group, *group ? "." : "", key->name);
fprintf(file, "  %-28s %s%s%s%s%s\n", name, key->right,
key->words ? ": " : "", key->words ? key->words : "",
default_is_told ? "; default "
: key->otherwise ? ""
: "; required",
default_is_told ? key->otherwise : "");
}
}
