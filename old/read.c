#include "read.h"
#include "ask.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
typedef struct {
int keys, combinations;
const char *key[SCENE_KEYS_MOST];
config_setting_t *values[SCENE_KEYS_MOST];
} Sweep;
static config_setting_t *swept(const Sweep *sweep, int key, int combination) {
for (int k = sweep->keys - 1; k > key; k--)
combination /= config_setting_length(sweep->values[k]);
return config_setting_get_elem(
sweep->values[key],
(unsigned)(combination % config_setting_length(sweep->values[key])));
}
static int name_value(Reader *r, const config_setting_t *at,
char name[SCENE_VALUE]) {
const char *word = config_setting_get_string(at);
if (word)
snprintf(name, SCENE_VALUE, "%s", word);
else if (config_setting_type(at) == CONFIG_TYPE_BOOL)
snprintf(name, SCENE_VALUE, "%s",
config_setting_get_bool(at) ? "true" : "false");
else if (gsl_finite(setting_number(at)))
snprintf(name, SCENE_VALUE, "%.6g", setting_number(at));
else
return setting_bad(r, at, "numbers, words, true or false are right");
for (char *c = name; word && *c; c++)
if (!strchr("0123456789.abcdefghijklmnopqrstuvwxyz"
"ABCDEFGHIJKLMNOPQRSTUVWXYZ",
*c))
*c = '-';
return DONE;
}
static int refuse_twins(Reader *r, const config_setting_t *values) {
char name[SCENE_VALUE], other[SCENE_VALUE];
for (int i = 0; i < config_setting_length(values); i++) {
const config_setting_t *at = config_setting_get_elem(values, (unsigned)i);
if (name_value(r, at, name))
return r->out->status;
for (int j = 0; j < i; j++) {
name_value(r, config_setting_get_elem(values, (unsigned)j), other);
if (strcmp(name, other) == 0)
return setting_wrong(
r, values, "two values of the sweep have one name",
"six digits are kept; of words 40 letters, digits and dots");
}
}
return DONE;
}
static int refuse_key(Reader *r, const config_setting_t *at,
const char *const key[], int k) {
size_t length = strlen(key[k]);
if (length == 0 || length >= sizeof r->scene->swept[k].key ||
strncmp(key[k], "sweep", 5) == 0)
return setting_wrong(r, at, "this key cannot be swept",
"give one of a scene, as make.growth");
for (int j = 0; j < k; j++)
if (strcmp(key[j], key[k]) == 0)
return setting_wrong(r, at, "this key is swept twice", "give it once");
for (int i = 0; i < r->scene->sets; i++)
if (strncmp(r->scene->set[i], key[k], length) == 0 &&
r->scene->set[i][length] == '=')
return setting_wrong(r, at, "this key is swept, and set too",
"give it in one place, or --set sweep=() too");
return DONE;
}
static int read_sweep(Reader *r, config_setting_t *root, Sweep *sweep) {
static const char right[] =
"a list ( { key = \"make.growth\"; values = [1.0, 0.1]; }, ... ) of at "
"most 4 keys and 10000 combinations is right";
config_setting_t *list = config_setting_get_member(root, "sweep");
*sweep = (Sweep){.combinations = 1};
if (!list)
return DONE;
sweep->keys = config_setting_length(list);
if (!config_setting_is_list(list) || sweep->keys > SCENE_KEYS_MOST)
return setting_bad(r, list, right);
for (int k = 0; k < sweep->keys; k++) {
config_setting_t *one = config_setting_get_elem(list, (unsigned)k);
config_setting_t *values = config_setting_lookup(one, "values");
bool some = values && (config_setting_is_array(values) ||
config_setting_is_list(values));
int count = some ? config_setting_length(values) : 0;
if (!config_setting_is_group(one) || config_setting_length(one) != 2 ||
!config_setting_lookup_string(one, "key", &sweep->key[k]) ||
count < 1 ||
(double)count * sweep->combinations > SCENE_COMBINATIONS_MOST)
return setting_bad(r, one, right);
sweep->values[k] = values;
sweep->combinations *= count;
if (refuse_key(r, one, sweep->key, k) || refuse_twins(r, values))
return r->out->status;
}
return DONE;
}
static int put_values(Reader *r, config_setting_t *root, const Sweep *sweep,
int combination) {
Scene *scene = r->scene;
scene->keys = sweep->keys;
for (int k = 0; k < sweep->keys; k++) {
const config_setting_t *value = swept(sweep, k, combination);
SceneSwept *to = &scene->swept[k];
snprintf(to->key, sizeof to->key, "%s", sweep->key[k]);
if (name_value(r, value, to->value) ||
setting_replace(r, root, to->key, value,
config_setting_source_line(value)))
return r->out->status;
size_t length = strlen(scene->suffix);
snprintf(scene->suffix + length, sizeof scene->suffix - length, "@%s",
to->value);
}
return DONE;
}
static char *read_file(const char *path, Outcome *out) {
FILE *file = fopen(path, "r");
char *text = NULL;
size_t room = 0;
ssize_t length = file ? getdelim(&text, &room, EOF, file) : -1;
if (!file || ferror(file))
outcome_set(out, WRONG, "%s: cannot be read; give the name of a scene",
path);
else if (length > 0 && strlen(text) < (size_t)length)
outcome_set(out, WRONG, "%s:1: not a text; give the name of a scene", path);
else if (length <= 0)
text = memory_grow(text, 1, 1), *text = '\0';
if (file)
fclose(file);
return text;
}
static int read_combination(Reader *r, const char *text, int combination) {
Scene *scene = r->scene;
Sweep sweep = {0};
config_t config;
config_init(&config);
for (int k = 0; k < 3; k++)
scene->box[k] = 1;
if (setting_parse(r, &config, text) == DONE) {
config_setting_t *root = config_root_setting(&config);
for (int i = 0; i < scene->sets; i++)
setting_apply(r, root, scene->set[i]);
if (r->out->status == DONE && read_sweep(r, root, &sweep) == DONE &&
put_values(r, root, &sweep, combination) == DONE)
ask_scene(r, root);
}
config_destroy(&config);
return sweep.combinations;
}
static Scene *begin(const char *path, const char *const set[], int sets) {
Scene *scene = memory(1, sizeof *scene);
scene->path = path;
scene->set = set;
scene->sets = sets;
return scene->first = scene;
}
static Scene *read_all(const char *path, char *text, const char *const set[],
int sets, Outcome *out) {
Scene *first = begin(path, set, sets), *last = first;
Reader r = {first, path, out};
first->text = text;
int combinations = read_combination(&r, text, 0);
for (int c = 1; c < combinations && out->status == DONE; c++) {
r.scene = last->next = begin(path, set, sets);
r.scene->first = first;
last = r.scene;
read_combination(&r, text, c);
}
if (out->status != DONE)
scene_free(&first);
return first;
}
Scene *read_again(const char *path, const char *text, const char *const set[],
int sets, Outcome *out) {
char *copy = memory(strlen(text) + 1, 1);
strcpy(copy, text);
return read_all(path, copy, set, sets, out);
}
Scene *read_scene(const char *path, const char *const set[], int sets,
Outcome *out) {
char *text = read_file(path, out);
if (out->status == DONE)
return read_all(path, text, set, sets, out);
free(text);
return NULL;
}
