#ifndef HEADER_H
#define HEADER_H
#include "scene.h"
#include "table.h"
enum { HEADER_MODULES = 128 };
void header_modules(const Scene *scene, const char *used[HEADER_MODULES]);
void header_write(Table *table, const Scene *scene, const Species *first,
int packs, const char *what);
#endif
