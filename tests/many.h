/* tests/many.h: how much a test does. `make check-slow` asks for more of what takes long (RANDPACK_SLOW). */
#ifndef MANY_H
#define MANY_H
#include <stdbool.h>
#include <stdlib.h>
static inline bool slow(void) { return getenv("RANDPACK_SLOW") != NULL; }
static inline int many(int few, int more) { return slow() ? more : few; }
#endif
