/* tests/few.h: what a pressure measured with few particles is held to. */
#ifndef FEW_H
#define FEW_H
#include "theory.h"
/* Z of n spheres in a periodic box, from Schultz and Kofke's of the fluid, by
   the correction of chapter crm, (crm:few). */
static inline double few_pressure(double phi, double n) {
  const double h = 1e-3;
  double Z[3], f[3], excess[3];
  for (int k = 0; k < 3; k++) {
    f[k] = phi + (k - 1) * h;
    Z[k] = theory_pressure(THEORY_SCHULTZ, f[k]);
    excess[k] = f[k] * (Z[k] - 1);
  }
  double chi = 2 * h / (f[2] * Z[2] - f[0] * Z[0]);
  double curve = (excess[0] - 2 * excess[1] + excess[2]) / (h * h);
  return Z[1] - phi * chi * curve / (2 * n);
}
#endif
