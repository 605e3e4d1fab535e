#ifndef EXPORT_H
#define EXPORT_H
#include "convert.h"
#include "scene.h"
int export_pack(const char *from, const char *to, const ConvertWords *words,
const Scene *scene, Outcome *out);
#endif
