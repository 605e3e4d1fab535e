#ifndef REF_MOTION_H
#define REF_MOTION_H
#include <stddef.h>
enum { REF_MOST = 512 };
typedef struct {
  double time;
  int shift[3];
} RefPair;
typedef struct {
  int dim, wide; /* wide: places are kept in the box, images are nearest */
  size_t n;
  double side[3], x[REF_MOST][3], v[REF_MOST][3], own[REF_MOST], a[REF_MOST];
  double mass[REF_MOST], size, growth, now, oldest;
  RefPair *pair; /* n x n, the caller's */
} RefMotion;
/* All to this time, which is then 0. */
void ref_sync(RefMotion *m, double time);
/* Process the next event before until: 1 a collision of i and j, 2 a refresh
   of i, 0 none. */
int ref_next(RefMotion *m, double until, size_t *i, size_t *j);
#endif
