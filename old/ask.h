#ifndef ASK_H
#define ASK_H
#include "entry.h"
#include <stdio.h>
int ask_scene(Reader *r, config_setting_t *root);
int ask_measures(const Query *query, unsigned facts, const Box *box);
Box ask_box(const Scene *scene);
void ask_help(FILE *file);
#endif
