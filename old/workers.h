#ifndef WORKERS_H
#define WORKERS_H
#include "bytes.h"
typedef struct Workers Workers;
typedef void (*WorkersDo)(void *own, Bytes *order, Bytes *answer);
enum { WORKERS_LOST = 64 };
Workers *workers_open(int count, WorkersDo work, void *own);
void workers_close(Workers **workers);
bool workers_give(Workers *workers, int w, const Bytes *order);
int workers_take(Workers *workers, int milliseconds, Bytes *answer,
char lost[WORKERS_LOST]);
bool workers_gone(const Workers *workers, int w);
#endif
