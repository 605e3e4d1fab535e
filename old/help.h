#ifndef HELP_H
#define HELP_H
#include "outcome.h"
#include <stdio.h>
void help_keys(FILE *file);
int help_entry(const char *name, FILE *file, Outcome *out);
#endif
