#ifndef READ_H
#define READ_H
#include "scene.h"
Scene *read_scene(const char *path, const char *const set[], int sets,
Outcome *out);
Scene *read_again(const char *path, const char *text, const char *const set[],
int sets, Outcome *out);
#endif
