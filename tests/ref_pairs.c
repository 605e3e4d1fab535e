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

/* Each pair of neighbours in cells as wide as the reach, or each pair if there
   are fewer than three along an axis. Inlined, so that VISIT is no call. */
typedef void Visit(void *with, size_t i, size_t j);
static inline __attribute__((always_inline)) void
walk(const Pack *pack, double reach, Visit *visit, void *with) {
  int dim = pack->box.dim, m[3] = {1, 1, 1};
  bool narrow = false;
  for (int k = 0; k < dim; k++) {
    m[k] = (int)(pack->box.side[k] / reach);
    narrow = narrow || m[k] < 3;
  }
  for (size_t i = 0; narrow && i < pack->n; i++)
    for (size_t j = i + 1; j < pack->n; j++)
      visit(with, i, j);
  if (narrow)
    return;
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
            visit(with, i, j - 1);
        }
  free(home);
  free(next);
  free(head);
}

static void visit_ref(void *with, size_t i, size_t j) {
  ref_pair(with, i, j);
}

uint64_t ref_pairs_lists(const Pack *pack, double origin, double step,
                         size_t bins, uint64_t count[]) {
  Ref ref = ref_make(pack, origin, step, bins, count);
  walk(pack, origin + (double)bins * step, visit_ref, &ref);
  return ref.below;
}

/* ------------------------------------------------------------ by species */
typedef struct {
  double low, inverse, limit, bins;
  PartialsPair *pair;
} Look;
typedef struct {
  const Pack *pack;
  Look *look; /* kinds x kinds */
} Looks;

static void species_pair(const Looks *looks, size_t i, size_t j) {
  const Pack *pack = looks->pack;
  size_t dim = (size_t)pack->box.dim;
  const Look *look = looks->look +
                     (size_t)pack_kind(pack, i) * (size_t)pack->kinds +
                     (size_t)pack_kind(pack, j);
  double square = 0;
  for (size_t k = 0; k < dim; k++) {
    double d = box_nearest(pack->x[j * dim + k] - pack->x[i * dim + k],
                           pack->box.side[k]);
    square += d * d;
  }
  if (!(square < look->limit))
    return;
  double place = (sqrt(square) - look->low) * look->inverse;
  if (place < 1)
    look->pair->below++;
  else if (place < look->bins + 1)
    look->pair->count[(size_t)place - 1]++;
}

/* Returns the largest reach. */
static double looks_make(Looks *looks, const Pack *pack, Partials *partials) {
  int kinds = pack->kinds;
  double most = 0;
  *looks = (Looks){pack, memory((size_t)(kinds * kinds), sizeof(Look))};
  for (int k = 0; k < kinds; k++)
    for (int m = 0; m < kinds; m++) {
      PartialsPair *pair = partials_pair(partials, k, m);
      double reach = pair->origin + (double)pair->bins * pair->step;
      double lower = pair->origin - 1e-9 * pair->step;
      pair->below = 0;
      memset(pair->count, 0, pair->bins * sizeof *pair->count);
      looks->look[k * kinds + m] =
          (Look){lower - pair->step, 1 / pair->step,
                 reach * reach * (1 + 1e-12), (double)pair->bins, pair};
      most = fmax(most, reach);
    }
  return most;
}

static void visit_species(void *with, size_t i, size_t j) {
  species_pair(with, i, j);
}

void ref_pairs_species(const Pack *pack, Partials *partials) {
  Looks looks;
  double reach = looks_make(&looks, pack, partials);
  walk(pack, reach, visit_species, &looks);
  free(looks.look);
}
