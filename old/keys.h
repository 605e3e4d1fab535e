#ifndef KEYS_H
#define KEYS_H
#include "entry.h"
#include <stdio.h>
typedef struct {
const Key *keys;
void *own;
} KeySet;
int keys_read(Reader *r, config_setting_t *group, const char *name,
const KeySet sets[]);
int keys_later(Reader *r, config_setting_t *at, const Key *key, void *own);
int keys_unknown(Reader *r, const config_setting_t *at, const char *group,
const char *known);
void keys_help(FILE *file, const char *group, const Key keys[]);
#endif
