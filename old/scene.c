#include "scene.h"
#include "entry.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
const Asked *scene_asked(const Asked list[], const char *name) {
for (; list && list->entry; list++)
if (strcmp(list->entry->name, name) == 0)
return list;
return NULL;
}
bool scene_by_law(const Scene *scene) {
bool some = false;
for (int s = 0; s < scene->kinds; s++)
some |= scene->sizes[s].law.dim != 0;
return some;
}
bool scene_shaped(const Scene *scene) {
bool some = false;
for (int s = 0; s < scene->kinds; s++)
some |= scene->species[s].shape != NULL;
return some;
}
static double solid_of(const Scene *scene, int s, double more) {
size_t n = scene->species[s].count;
const double *radius = scene->sizes[s].radius;
double sum = 0, same = scene->species[s].radius + more;
for (size_t i = 0; radius && i < n; i++)
sum += pack_ball(scene->dimension, radius[i] + more);
return radius ? sum : (double)n * pack_ball(scene->dimension, same);
}
double scene_padded(const Scene *scene, double more) {
double volume = 0;
for (int s = 0; s < scene->kinds; s++)
volume += solid_of(scene, s, more);
return volume;
}
double scene_solid(const Scene *scene) {
return scene_padded(scene, 0);
}
Box scene_filled(const Scene *scene) {
return box_make(scene->dimension, scene->box,
scene_solid(scene) / scene->fraction);
}
void scene_pair_name(const Species species[], int k, int m, char name[72]) {
snprintf(name, 72, "%s-%s", species[k].name, species[m].name);
}
int scene_pair(int kinds, int k, int m) {
return k * kinds - k * (k - 1) / 2 + m - k;
}
static void free_asked(Asked list[]) {
for (Asked *one = list; one && one->entry; one++) {
if (one->entry->clear)
one->entry->clear(one->own);
free(one->own);
}
free(list);
}
void scene_free(Scene **scene) {
while (*scene) {
Scene *next = (*scene)->next;
Asked *make = memory(2, sizeof *make);
*make = (*scene)->make;
free_asked(make);
free_asked((*scene)->change);
free_asked((*scene)->measure);
free_asked((*scene)->curve);
for (int s = 0; s < (*scene)->kinds; s++) {
free((*scene)->sizes[s].list[0]);
free((*scene)->sizes[s].list[1]);
free((*scene)->sizes[s].radius);
shape_free(&(*scene)->species[s].shape);
}
free((*scene)->sizes);
free((*scene)->species);
free((*scene)->share);
free((*scene)->text);
free(*scene);
*scene = next;
}
}
