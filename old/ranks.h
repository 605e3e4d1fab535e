#ifndef RANKS_H
#define RANKS_H
#include "bytes.h"
#include "run.h"
typedef struct {
Run *run;
const char *directory;
int workers;
double seconds;
const Bytes *key;
void *own;
int (*next)(void *own);
void (*take)(void *own, int job, Bytes *record);
} Ranks;
int ranks_started(void);
int ranks_number(void);
bool ranks_share(void);
int ranks_refuse(Outcome *out);
bool ranks_first(void);
bool ranks_run(const Ranks *ranks, Outcome *out);
#endif
