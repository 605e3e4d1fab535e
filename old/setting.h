#ifndef SETTING_H
#define SETTING_H
#include "scene.h"
#include <libconfig.h>
#define SETTING_LEAST 1e-50
#define SETTING_MOST 1e50
typedef struct {
Scene *scene;
const char *path;
Outcome *out;
} Reader;
int setting_wrong(Reader *r, const config_setting_t *at, const char *what,
const char *right);
int setting_bad(Reader *r, const config_setting_t *at, const char *right);
bool setting_whole(const config_setting_t *at);
double setting_number(const config_setting_t *at);
int setting_place(const char *word, const char *words);
int setting_list(const config_setting_t *at, double value[], int most,
double limit);
int setting_parse(Reader *r, config_t *config, const char *text);
int setting_replace(Reader *r, config_setting_t *root, const char *path,
const config_setting_t *value, unsigned line);
int setting_apply(Reader *r, config_setting_t *root, const char *setting);
#endif
