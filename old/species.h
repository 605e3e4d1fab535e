#ifndef SPECIES_H
#define SPECIES_H
#include "entry.h"
#include <stdio.h>
int species_read(Reader *r, config_setting_t *at);
int species_laws(Reader *r, config_setting_t *root);
void species_help(FILE *file);
void species_shares(Scene *scene);
int species_counts(Reader *r, const config_setting_t *species);
int species_settle(const Query *query);
#endif
