/* tests/scatter.h: particles at random places and angles. */
#ifndef SCATTER_H
#define SCATTER_H
#include "points.h"
/* A pack of these species in this box; their shapes are freed. */
static inline Pack *scattered(const Box *box, Species species[], int kinds, uint64_t seed) {
  Pack *pack = pack_alloc(box, species, kinds, false);
  Rng rng = rng_stream(seed, 0, RNG_POSITIONS), turns = rng_stream(seed, 0, RNG_ANGLES);
  points_scatter(pack, &rng);
  points_turn(pack, &turns);
  for (int s = 0; s < kinds; s++)
    shape_free(&species[s].shape);
  return pack;
}
#endif
