/* tests/many.h: how much a test does. `make check-slow` asks for more where that takes long (RANDPACK_SLOW). */
#ifndef MANY_H
#define MANY_H
#include <stdlib.h>
static inline int as_many(int few, int more) { return getenv("RANDPACK_SLOW") ? more : few; }
#endif
