#include "ref_rsa.h"
#include "outcome.h"
#include <assert.h>
#include <stdlib.h>

typedef struct {
  const Pack *pack;
  int m;
  double limit;
  size_t *head, *next; /* 0 ends a list */
} Lists;

static int place(const Lists *lists, const double p[], int k) {
  int c = (int)(p[k] / lists->pack->box.side[k] * lists->m);
  return c < lists->m ? c : lists->m - 1;
}

static size_t cell_at(const Lists *lists, const int c[]) {
  int m = lists->m, dim = lists->pack->box.dim;
  size_t at = 0;
  for (int k = 0; k < dim; k++)
    at = at * (size_t)m + (size_t)((c[k] + m) % m);
  return at;
}

static bool meets(const Lists *lists, size_t cell, const double p[]) {
  size_t dim = (size_t)lists->pack->box.dim;
  for (size_t j = lists->head[cell]; j > 0; j = lists->next[j - 1]) {
    double square = 0;
    for (size_t k = 0; k < dim; k++) {
      double d = box_nearest(lists->pack->x[(j - 1) * dim + k] - p[k],
                             lists->pack->box.side[k]);
      square += d * d;
    }
    if (square < lists->limit)
      return true;
  }
  return false;
}

static bool is_free(const Lists *lists, const double p[]) {
  int dim = lists->pack->box.dim, c[3] = {0, 0, 0};
  for (int k = 0; k < dim; k++)
    c[k] = place(lists, p, k);
  for (int a = -1; a <= 1; a++)
    for (int b = -1; b <= 1; b++)
      for (int e = dim == 3 ? -1 : 0; e <= (dim == 3 ? 1 : 0); e++) {
        int at[3] = {c[0] + a, c[1] + b, c[2] + e};
        if (meets(lists, cell_at(lists, at), p))
          return false;
      }
  return true;
}

uint64_t ref_rsa_fill(Pack *pack, Rng *rng, uint64_t most) {
  int dim = pack->box.dim;
  double diameter = 2 * pack_largest(pack);
  Lists lists = {pack, (int)(2 * box_reach(&pack->box) / diameter),
                 diameter * diameter, NULL, NULL};
  assert(lists.m >= 3);
  size_t cells = (size_t)lists.m * (size_t)lists.m;
  lists.head =
      memory(dim == 3 ? cells * (size_t)lists.m : cells, sizeof *lists.head);
  lists.next = memory(pack->n, sizeof *lists.next);
  uint64_t drawn = 0;
  for (size_t n = 0; n < pack->n && drawn < most; drawn++) {
    double *p = pack->x + n * (size_t)dim;
    int c[3];
    for (int k = 0; k < dim; k++)
      p[k] = rng_uniform(rng) * pack->box.side[k];
    if (!is_free(&lists, p))
      continue;
    for (int k = 0; k < dim; k++)
      c[k] = place(&lists, p, k);
    size_t cell = cell_at(&lists, c);
    lists.next[n] = lists.head[cell];
    lists.head[cell] = ++n;
  }
  free(lists.next);
  free(lists.head);
  return drawn;
}
