/* tests/same.h: what a test compares field by field, because bytes between the fields may be anything. */
#ifndef SAME_H
#define SAME_H
#include "pack.h"
#include <stdbool.h>
#include <string.h>
/* The same box, to the last bit of each side. */
static inline bool same_box(const Box *a, const Box *b) {
  return a->dim == b->dim && memcmp(a->side, b->side, sizeof a->side) == 0;
}
static inline bool same_numbers(const double *a, const double *b, size_t n) {
  return n == 0 || (a && b && memcmp(a, b, n * sizeof *a) == 0);
}
/* The same shape, in all that its interface names; or none. */
static inline bool same_shape(const Shape *a, const Shape *b) {
  if (!a || !b)
    return a == b;
  size_t n = (size_t)a->sides;
  const double of_a[] = {a->a, a->b, a->m, a->perimeter, a->inner, a->outer, a->Ixx, a->Iyy, a->Ixy};
  const double of_b[] = {b->a, b->b, b->m, b->perimeter, b->inner, b->outer, b->Ixx, b->Iyy, b->Ixy};
  return a->kind == b->kind && a->sides == b->sides && same_numbers(a->x, b->x, n) && same_numbers(a->y, b->y, n) &&
         same_numbers(a->nx, b->nx, n) && same_numbers(a->ny, b->ny, n) && same_numbers(a->h, b->h, n) &&
         same_numbers(of_a, of_b, 9);
}
/* The same shapes of the same species. */
static inline bool same_shapes(const Pack *a, const Pack *b) {
  bool same = a->kinds == b->kinds;
  for (int s = 0; same && s < a->kinds; s++)
    same = same_shape(a->species[s].shape, b->species[s].shape);
  return same;
}
#endif
