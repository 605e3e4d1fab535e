/* The Percus-Yevick mixture as a textbook has it: Perram's march with the
   trapezoidal rule on an even grid, by Baxter's factors. */
#ifndef REF_MIXTURE_H
#define REF_MIXTURE_H
#include "mixture.h"
/* r g_ij at the gap r - a_i - a_j = p h, p < ref_mixture_n, stored at
   (p count + i) count + j; h is the smallest diameter over points, and all
   diameters are multiples of it. To be freed. */
double *ref_mixture(const MixtureSpecies species[], size_t count, double reach,
                    size_t points);
size_t ref_mixture_n(const MixtureSpecies species[], size_t count, double reach,
                     size_t points);
#endif
