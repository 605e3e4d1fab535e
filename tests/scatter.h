/* tests/scatter.h: packs to test on, at random places and angles or at given ones. */
#ifndef SCATTER_H
#define SCATTER_H
#include "points.h"
#include <gsl/gsl_math.h>
#include <string.h>
/* All at random places, and shapes at random angles. */
static inline void scatter(Pack *pack, Rng *rng) {
  points_scatter(pack, rng);
  points_turn(pack, rng);
}
/* n of one species in a cube or square, at 0; the shape stays the caller's. */
static inline Pack *pack_of(int dim, double side, size_t n, double radius, const Shape *shape) {
  Species species = {.name = "P", .radius = radius, .count = n, .shape = (Shape *)shape};
  Box box = {dim, {side, side, dim == 3 ? side : 0}};
  return pack_alloc(&box, &species, 1, false);
}
/* Balls with radii of their own at these places. */
static inline Pack *particles(int dim, const double side[3], size_t n, const double *x, const double *radius) {
  Species species = {.name = "P", .radius = radius[0], .count = n};
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Pack *pack = pack_alloc(&box, &species, 1, true);
  memcpy(pack->x, x, n * (size_t)dim * sizeof *x);
  memcpy(pack->radius, radius, n * sizeof *radius);
  return pack;
}
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
/* Half of n particles A, half B, of these radii, at random places; shaped: superellipses and pentagons, at random angles. */
static inline Pack *two_kinds(const Box *box, size_t n, double a, double b, bool shaped, Rng *rng) {
  Species species[2] = {{.name = "A", .radius = a, .count = n / 2}, {.name = "B", .radius = b, .count = n - n / 2}};
  if (shaped) {
    species[0].shape = shape_superellipse(2.5, 3.2);
    species[1].shape = shape_regular(5);
  }
  Pack *pack = pack_alloc(box, species, 2, false);
  for (size_t c = 0; c < n * (size_t)box->dim; c++)
    pack->x[c] = box->side[c % (size_t)box->dim] * rng_uniform(rng);
  for (size_t i = 0; pack->angle && i < n; i++)
    pack->angle[i] = 2 * M_PI * rng_uniform(rng);
  for (int s = 0; s < 2; s++)
    shape_free(&species[s].shape);
  return pack;
}
#endif
