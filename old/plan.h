#ifndef PLAN_H
#define PLAN_H
#include "scene.h"
#include <stdio.h>
int plan_scene(const Scene *scene, FILE *file, Outcome *out);
#endif
