#include "ref_gravity.h"
#include "outcome.h"
#include "rng.h"
#include <math.h>
#include <stdlib.h>

typedef struct {
  double square;
  size_t number;
} Rank;

static int by_rank(const void *a, const void *b) {
  const Rank *p = a, *q = b;
  if (p->square != q->square)
    return p->square < q->square ? -1 : 1;
  return p->number < q->number ? -1 : p->number > q->number;
}

static void push(int dim, size_t i, size_t j, double *x, const double origin[],
                 double r, double sum) {
  double *a = x + i * (size_t)dim, *b = x + j * (size_t)dim, out = 0, u[3];
  if (r > 1e-12 * sum) {
    double by = sum / r;
    for (int k = 0; k < dim; k++)
      b[k] = a[k] + (b[k] - a[k]) * by;
    return;
  }
  Rng rng = rng_stream(i, j, RNG_POSITIONS);
  rng_direction(&rng, dim, u);
  for (int k = 0; k < dim; k++)
    out += u[k] * (a[k] - origin[k]);
  for (int k = 0; k < dim; k++)
    b[k] = a[k] + u[k] * (out < 0 ? -sum : sum);
}

size_t ref_gravity_sweep(int dim, size_t n, double *x, const double *radius,
                         double size, const double origin[], double slack) {
  Rank *rank = memory(n, sizeof *rank);
  size_t pushes = 0;
  for (size_t i = 0; i < n; i++) {
    rank[i] = (Rank){0, i};
    for (int k = 0; k < dim; k++) {
      double d = x[i * (size_t)dim + (size_t)k] - origin[k];
      rank[i].square += d * d;
    }
  }
  qsort(rank, n, sizeof *rank, by_rank);
  for (size_t s = 0; s + 1 < n; s++)
    for (size_t t = s + 1; t < n; t++) {
      size_t i = rank[s].number, j = rank[t].number;
      double square = 0,
             sum = radius ? size * (radius[i] + radius[j]) : size * 2;
      for (int k = 0; k < dim; k++) {
        double d =
            x[j * (size_t)dim + (size_t)k] - x[i * (size_t)dim + (size_t)k];
        square += d * d;
      }
      if (sum - slack <= 0 || square >= (sum - slack) * (sum - slack))
        continue;
      push(dim, i, j, x, origin, sqrt(square), sum);
      pushes++;
    }
  free(rank);
  return pushes;
}
