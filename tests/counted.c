/* tests/counted.c: the command, linked so that it tells what it asked for. With
   -Wl,--wrap=pairs_count,--wrap=memory it writes to the file COUNTED at its end:
   calls of pairs_count, the largest R/a they reached for radius 1, the pairs
   they counted, and the bytes asked of memory(). */
#include "pack.h"
#include <stdio.h>
#include <stdlib.h>

static struct {
  double calls, reach, pairs, bytes;
} sum;

uint64_t __real_pairs_count(const Pack *pack, double origin, double step,
                            size_t bins, uint64_t count[]);
uint64_t __wrap_pairs_count(const Pack *pack, double origin, double step,
                            size_t bins, uint64_t count[]);
void *__real_memory(size_t count, size_t size);
void *__wrap_memory(size_t count, size_t size);

static void tell(void) {
  FILE *file = fopen(getenv("COUNTED"), "w");
  fprintf(file, "calls=%.0f reach=%.12g pairs=%.0f bytes=%.0f\n", sum.calls,
          sum.reach, sum.pairs, sum.bytes);
  fclose(file);
}

uint64_t __wrap_pairs_count(const Pack *pack, double origin, double step,
                            size_t bins, uint64_t count[]) {
  uint64_t below = __real_pairs_count(pack, origin, step, bins, count);
  double reach = origin + (double)bins * step, pairs = (double)below;
  for (size_t b = 0; b < bins; b++)
    pairs += (double)count[b];
  sum.calls++;
  sum.reach = reach > sum.reach ? reach : sum.reach;
  sum.pairs += pairs;
  return below;
}

void *__wrap_memory(size_t count, size_t size) {
  if (sum.bytes == 0)
    atexit(tell);
  sum.bytes += (double)count * (double)size;
  return __real_memory(count, size);
}
