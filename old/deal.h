#ifndef DEAL_H
#define DEAL_H
#include "scene.h"
typedef struct {
const char *directory;
const char
*pieces;
int threads;
double seconds;
} DealHow;
int deal_run(const Scene *scene, const DealHow *how, Outcome *out);
int deal_merge(const char *const from[], int count, const char *directory,
Outcome *out);
#endif
