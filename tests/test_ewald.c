/* tests/test_ewald.c: the far sums against the same series term by term, a lattice sum with a closed form, and the shares */
#include "ewald.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_legendre.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static void test_shares(void) {
  for (double x = 0.013; x < 40; x *= 2.7) {
    double two[21], three[21];
    ewald_shares(2, 20, x, two);
    ewald_shares(3, 20, x, three);
    for (int m = 1; m <= 20; m++) {
      gsl_test_rel(two[m], gsl_sf_gamma_inc_Q(m, x), 1e-12, "share in the plane, %d at %g", m, x);
      gsl_test_rel(three[m], gsl_sf_gamma_inc_Q(m + 0.5, x), 1e-12, "share in space, %d at %g", m, x);
    }
  }
}

/* One disc in a square of side 1: the sum of Z^-4 over Gauss's integers is Gamma(1/4)^8 / (960 pi^2), that of Z^-2 is 0. */
static void test_gauss(void) {
  static const double x[] = {.31, .77}, r[] = {1}, side[] = {1, 1, 0};
  enum { M = 8 };
  double tau[M + 1], upsilon[M + 1];
  for (int m = 0; m <= M; m++) {
    tau[m] = 1;
    upsilon[m] = 0;
  }
  Pack *pack = particles(2, side, 1, x, r);
  EwaldPlan plan = {.kappa = 2.1, .cut = 6, .degree = M, .tau = tau, .upsilon = upsilon};
  double complex S[M + 1], A[M + 1];
  const size_t host[] = {0};
  ewald_far(pack, &plan, host, 1, S, A);
  for (int a = -4; a <= 4; a++)
    for (int b = -4; b <= 4; b++) {
      double share[M + 1], square = a * a + b * b;
      ewald_shares(2, M, gsl_pow_2(plan.kappa) * square, share);
      for (int m = 2; m <= M && square > 0; m++)
        S[m] += share[m] * cpow(a + b * I, -m);
    }
  gsl_test_abs(creal(S[4]), gsl_pow_8(tgamma(0.25)) / (960 * gsl_pow_2(M_PI)), 1e-12, "Z^-4 over Gauss's integers");
  gsl_test_abs(cabs(S[2]), 0, 1e-12, "Z^-2");
  gsl_test_abs(cabs(S[6]), 0, 1e-12, "Z^-6");
  pack_free(&pack);
}

/* Term by term. */
static double complex far_sum(const Pack *pack, const EwaldPlan *plan, size_t i, int m, int n, bool second) {
  int dim = pack->box.dim, most = 9;
  double p = m + 0.5 * dim - 1, V = box_volume(&pack->box);
  double complex sum = 0;
  for (int a = -most; a <= most; a++)
    for (int b = -most; b <= most; b++)
      for (int c = dim == 3 ? -most : 0; c <= (dim == 3 ? most : 0); c++) {
        double k[3] = {2 * M_PI * a / pack->box.side[0], 2 * M_PI * b / pack->box.side[1], dim == 3 ? 2 * M_PI * c / pack->box.side[2] : 0};
        double square = k[0] * k[0] + k[1] * k[1] + k[2] * k[2], x = square / (4 * plan->kappa * plan->kappa);
        if (square == 0 || x > plan->cut * plan->cut)
          continue;
        double complex rho = 0, more = 0, H;
        for (size_t j = 0; j < pack->n; j++) {
          double phase = 0;
          for (int e = 0; e < dim; e++)
            phase += k[e] * (pack->x[j * (size_t)dim + (size_t)e] - pack->x[i * (size_t)dim + (size_t)e]);
          rho += gsl_pow_int(pack_radius(pack, j), dim) * cexp(I * phase);
          more += gsl_pow_int(pack_radius(pack, j), dim + 2) * cexp(I * phase);
        }
        double length = sqrt(square), sign = n % 2 ? -1 : 1; /* of the phase of Condon and Shortley, which the chapter has not */
        H = dim == 2 ? cpow(k[0] - k[1] * I, m)
                     : sign * sqrt(4 * M_PI / (2 * m + 1)) * pow(length, m) * gsl_sf_legendre_sphPlm(m, n, k[2] / length) * cexp(I * n * atan2(k[1], k[0]));
        double complex S = 4 / square * exp(-x) / tgamma(p) * H, T = 16 / (square * square) * (1 + x) * exp(-x) / tgamma(p - 1) * H;
        sum += second ? plan->tau[m] * T * rho + plan->upsilon[m] * S * more : S * rho;
      }
  return sum * pow(M_PI, 0.5 * dim) * cpow(-I, m) / (pow(2, m) * V);
}

static void test_far(void) {
  static const double x[] = {.31, .22, .4, .805, .51, .43, .3, .63, .81, .83, .105, .9}, r[] = {.17, .24, .12, .09};
  static const double side[] = {1.13, .87, .95};
  enum { M = 7 };
  double tau[M + 1], upsilon[M + 1], flat[12];
  for (int m = 0; m <= M; m++) {
    tau[m] = 0.3 + 0.1 * m;
    upsilon[m] = 1.7 - 0.2 * m;
  }
  for (int dim = 2; dim <= 3; dim++) {
    for (int i = 0; i < 4; i++)
      for (int k = 0; k < dim; k++)
        flat[i * dim + k] = x[i * 3 + k];
    Pack *pack = particles(dim, side, 4, flat, r);
    EwaldPlan plan = {.kappa = 4.3, .cut = 5.1, .degree = M, .tau = tau, .upsilon = upsilon};
    size_t row = ewald_at(dim, M + 1);
    const size_t host[] = {3, 1};
    double complex *S = malloc(2 * row * sizeof *S), *A = malloc(2 * row * sizeof *A);
    ewald_far(pack, &plan, host, 2, S, A);
    for (size_t h = 0; h < 2; h++)
      for (int m = 2; m <= M; m++)
        for (int n = 0; n < ewald_orders(dim, m); n++) {
          size_t at = h * row + ewald_at(dim, m) + (size_t)n;
          double complex s = far_sum(pack, &plan, host[h], m, n, false), a = far_sum(pack, &plan, host[h], m, n, true);
          gsl_test_abs(cabs(S[at] - s), 0, 1e-10 * pow(plan.kappa, m - 2), "%d-D, S of degree %d, order %d", dim, m, n);
          gsl_test_abs(cabs(A[at] - a), 0, 1e-10 * pow(plan.kappa, m - 2), "%d-D, A of degree %d, order %d", dim, m, n);
        }
    free(S);
    free(A);
    pack_free(&pack);
  }
}

int main(void) {
  test_shares();
  test_gauss();
  test_far();
  return gsl_test_summary();
}
