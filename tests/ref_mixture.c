#include "ref_mixture.h"
#include "outcome.h"
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

static double smallest(const MixtureSpecies species[], size_t count) {
  double least = INFINITY;
  for (size_t i = 0; i < count; i++)
    least = fmin(least, 2 * species[i].radius);
  return least;
}

size_t ref_mixture_n(const MixtureSpecies species[], size_t count, double reach,
                     size_t points) {
  double least = smallest(species, count);
  return (size_t)((reach - least) / least * (double)points) + 1;
}

typedef struct {
  double a, b; /* q_ik(t) = a (t^2 - R^2) / 2 + b (t - R) */
} Factor;

static Factor factor_of(const MixtureSpecies species[], size_t count,
                        size_t i) {
  double xi2 = 0, y = 1, d = 2 * species[i].radius;
  for (size_t k = 0; k < count; k++) {
    double n = M_PI / 6 * species[k].density, dk = 2 * species[k].radius;
    xi2 += n * dk * dk;
    y -= n * dk * dk * dk;
  }
  return (Factor){(y + 3 * d * xi2) / (y * y), -1.5 * d * d * xi2 / (y * y)};
}

/* The part of r g_ij(r) that no g enters. */
static double source(const MixtureSpecies species[], size_t count, size_t i,
                     Factor q, double r) {
  double sum = r;
  for (size_t k = 0; k < count; k++) {
    double d = 2 * species[k].radius, R = species[i].radius + species[k].radius;
    double whole = q.a / 2 * (d / 3 - R) * d * d - q.b * d * d / 2;
    double below =
        q.a / 2 * (d / 4 - 2 * R / 3) * d * d * d - q.b * d * d * d / 3;
    sum -= 2 * M_PI * species[k].density * ((r - R) * whole + below);
  }
  return sum;
}

/* 2 pi n_k h q_ik at the place c of so many to a diameter of k. */
static double *weights(const MixtureSpecies species[], size_t i, size_t k,
                       Factor q, double h, size_t cells) {
  double *w = memory(cells + 1, sizeof *w);
  for (size_t c = 0; c <= cells; c++) {
    double R = species[i].radius + species[k].radius;
    double t = species[i].radius - species[k].radius + h * (double)c;
    w[c] = 2 * M_PI * species[k].density * h *
           (q.a / 2 * (t * t - R * R) + q.b * (t - R));
  }
  return w;
}

/* Add what the earlier gaps give to the rows of i at the gap p. */
static void add_earlier(size_t count, size_t k, const double *w, size_t cells,
                        size_t p, const double f[], double row[]) {
  for (size_t u = p > cells ? p - cells : 0; u < p; u++) {
    double weight = u == 0 ? w[p - u] / 2 : w[p - u];
    for (size_t j = 0; j < count; j++)
      row[j] += weight * f[(u * count + k) * count + j];
  }
}

double *ref_mixture(const MixtureSpecies species[], size_t count, double reach,
                    size_t points) {
  size_t n = ref_mixture_n(species, count, reach, points);
  double h = smallest(species, count) / (double)points;
  double *f = memory(n * count * count, sizeof *f);
  double **w = memory(count * count, sizeof *w);
  size_t *cells = memory(count, sizeof *cells);
  gsl_matrix *same = gsl_matrix_alloc(count, count);
  gsl_permutation *order = gsl_permutation_alloc(count);
  int sign;
  gsl_matrix_set_identity(same);
  for (size_t k = 0; k < count; k++) {
    cells[k] = (size_t)(2 * species[k].radius / h + 0.5);
    for (size_t i = 0; i < count; i++) {
      double *own = w[i * count + k] =
          weights(species, i, k, factor_of(species, count, i), h, cells[k]);
      *gsl_matrix_ptr(same, i, k) -= own[0] / 2;
    }
  }
  gsl_linalg_LU_decomp(same, order, &sign);
  for (size_t p = 0; p < n; p++) {
    double *at = f + p * count * count;
    for (size_t i = 0; i < count; i++) {
      for (size_t j = 0; j < count; j++)
        at[i * count + j] =
            source(species, count, i, factor_of(species, count, i),
                   species[i].radius + species[j].radius + h * (double)p);
      for (size_t k = 0; k < count; k++)
        add_earlier(count, k, w[i * count + k], cells[k], p, f, at + i * count);
    }
    for (size_t j = 0; p > 0 && j < count; j++) {
      gsl_vector_view column =
          gsl_vector_view_array_with_stride(at + j, count, count);
      gsl_linalg_LU_svx(same, order, &column.vector);
    }
  }
  for (size_t q = 0; q < count * count; q++)
    free(w[q]);
  free(w);
  free(cells);
  gsl_matrix_free(same);
  gsl_permutation_free(order);
  return f;
}
