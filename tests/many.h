/* tests/many.h: how much a test does. `make check-slow` asks for more where that takes long (RANDPACK_SLOW), and for less under valgrind, which looks
   at bytes and not at numbers (RANDPACK_MEMORY). */
#ifndef MANY_H
#define MANY_H
#include <stdlib.h>
static inline int as_many(int few, int more) {
  if (getenv("RANDPACK_MEMORY"))
    return few > 12 ? few / 6 : few > 2 ? 2 : few;
  return getenv("RANDPACK_SLOW") ? more : few;
}
#endif
