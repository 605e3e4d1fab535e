#include "ref_pairs.h"
#include "outcome.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const Pack *pack;
  double low, inverse, limit;
  size_t bins;
  uint64_t below, *count;
} Ref;

static Ref ref_make(const Pack *pack, double origin, double step, size_t bins,
                    uint64_t count[]) {
  double reach = origin + (double)bins * step, lower = origin - 1e-9 * step;
  memset(count, 0, bins * sizeof *count);
  return (Ref){pack, lower - step, 1 / step, reach * reach * (1 + 1e-12), bins,
               0,    count};
}

static void ref_pair(Ref *ref, size_t i, size_t j) {
  size_t dim = (size_t)ref->pack->box.dim;
  const double *xi = ref->pack->x + i * dim, *xj = ref->pack->x + j * dim;
  double square = 0;
  for (size_t k = 0; k < dim; k++) {
    double d = box_nearest(xj[k] - xi[k], ref->pack->box.side[k]);
    square += d * d;
  }
  if (!(square < ref->limit))
    return;
  double place = (sqrt(square) - ref->low) * ref->inverse;
  if (place < 1)
    ref->below++;
  else if (place < (double)ref->bins + 1)
    ref->count[(size_t)place - 1]++;
}

uint64_t ref_pairs_all(const Pack *pack, double origin, double step,
                       size_t bins, uint64_t count[]) {
  Ref ref = ref_make(pack, origin, step, bins, count);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i + 1; j < pack->n; j++)
      ref_pair(&ref, i, j);
  return ref.below;
}

static int wrap(int a, int m) {
  return (a + m) % m;
}

uint64_t ref_pairs_lists(const Pack *pack, double origin, double step,
                         size_t bins, uint64_t count[]) {
  int dim = pack->box.dim, m[3] = {1, 1, 1};
  double reach = origin + (double)bins * step;
  for (int k = 0; k < dim; k++) {
    m[k] = (int)(pack->box.side[k] / reach);
    if (m[k] < 3)
      return ref_pairs_all(pack, origin, step, bins, count);
  }
  Ref ref = ref_make(pack, origin, step, bins, count);
  size_t cells = (size_t)m[0] * (size_t)m[1] * (size_t)m[2];
  size_t *head = memory(cells, sizeof *head);
  size_t *next = memory(pack->n, sizeof *next); /* 0 ends a list */
  int(*home)[3] = memory(pack->n, sizeof *home);
  for (size_t i = 0; i < pack->n; i++) {
    for (int k = 0; k < dim; k++) {
      double x = pack->x[i * (size_t)dim + (size_t)k];
      int c = (int)(x / pack->box.side[k] * m[k]);
      home[i][k] = c < m[k] ? c : m[k] - 1;
    }
    size_t c = (size_t)((home[i][0] * m[1] + home[i][1]) * m[2] + home[i][2]);
    next[i] = head[c];
    head[c] = i + 1;
  }
  for (size_t i = 0; i < pack->n; i++)
    for (int p = -1; p <= 1; p++)
      for (int q = -1; q <= 1; q++)
        for (int s = dim == 3 ? -1 : 0; s <= (dim == 3 ? 1 : 0); s++) {
          int a = wrap(home[i][0] + p, m[0]), b = wrap(home[i][1] + q, m[1]);
          int c = wrap(home[i][2] + s, m[2]);
          if (p * 9 + q * 3 + s < 0)
            continue;
          size_t first = head[(a * m[1] + b) * m[2] + c];
          for (size_t j = p || q || s ? first : next[i]; j > 0; j = next[j - 1])
            ref_pair(&ref, i, j - 1);
        }
  free(home);
  free(next);
  free(head);
  return ref.below;
}
