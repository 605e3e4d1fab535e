/* tests/test_elastic.c: bounds on conductivity and moduli by hand, by Hashin and Shtrikman, and by trial fields that are minimized here */
#include "elastic.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdbool.h>

static void test_by_hand(void) {
  Between c = elastic_conductivity(2, 0.5, 0.5, (double[]){1, 4});
  gsl_test_rel(c.upper, 2.05, 1e-15, "the example: upper");
  gsl_test_rel(c.lower, 8 / 4.1, 1e-15, "the example: lower");
  /* Composite spheres: a coated sphere of conductivity 10 in a shell of 1 is neutral in (1 + 2 phi b)/(1 - phi b), b = 9/12. */
  Between two = elastic_conductivity_two(3, 0.3, (double[]){1, 10});
  gsl_test_rel(two.lower, (1 + 0.6 * 0.75) / (1 - 0.3 * 0.75), 1e-15, "coated spheres");
  two = elastic_conductivity_two(2, 0.3, (double[]){1, 10});
  gsl_test_rel(two.lower, (1 + 0.3 * 9 / 11) / (1 - 0.3 * 9 / 11), 1e-15, "coated discs");
  /* Coated spheres under pressure: K1 + phi / (1 / (K2 - K1) + (1 - phi) / (K1 + 4 G1 / 3)). */
  Between bulk = elastic_bulk_two(3, 0.2, (double[]){2, 7}, (double[]){1, 3});
  gsl_test_rel(bulk.lower, 2 + 0.2 / (1. / 5 + 0.8 / (2 + 4. / 3)), 1e-15, "coated spheres under pressure");
  bulk = elastic_bulk_two(2, 0.2, (double[]){2, 7}, (double[]){1, 3});
  gsl_test_rel(bulk.lower, 2 + 0.2 / (1. / 5 + 0.8 / (2 + 1)), 1e-15, "coated discs under pressure");
  /* Hashin and Shtrikman on shear: G1 + phi / (1 / (G2 - G1) + 6 (1 - phi) (K1 + 2 G1) / (5 G1 (3 K1 + 4 G1))); in the plane with
     (K1 + 2 G1) / (2 G1 (K1 + G1)). */
  Between shear = elastic_shear_two(3, 0.2, (double[]){2, 7}, (double[]){1, 3});
  gsl_test_rel(shear.lower, 1 + 0.2 / (1. / 2 + 6 * 0.8 * 4 / (5 * 10)), 1e-15, "shear in space");
  shear = elastic_shear_two(2, 0.2, (double[]){2, 7}, (double[]){1, 3});
  gsl_test_rel(shear.lower, 1 + 0.2 / (1. / 2 + 0.8 * 4 / (2 * 3)), 1e-15, "shear in the plane");
  gsl_test_rel(elastic_young(3, 10. / 3, 2), 5, 1e-15, "Young's modulus in space");
  gsl_test_rel(elastic_young(2, 3, 1), 3, 1e-15, "and in the plane");
  gsl_test_rel(elastic_young(3, GSL_POSINF, 2), 6, 1e-15, "incompressible");
}

/* At zeta = eta = 0 and 1 the bounds are those of Hashin and Shtrikman; between, monotone, in order, and within them. */
static void test_ends(void) {
  Rng rng = rng_stream(71, 0, RNG_TEST);
  double worst = 0;
  int unordered = 0, falling = 0, outside = 0;
  for (int t = 0; t < 2000; t++) {
    int dim = 2 + t % 2;
    double phi = rng_uniform(&rng), K[2], G[2], last[6] = {0};
    for (int i = 0; i < 2; i++) {
      K[i] = exp(6 * rng_uniform(&rng) - 3);
      G[i] = exp(6 * rng_uniform(&rng) - 3);
    }
    if ((K[1] - K[0]) * (G[1] - G[0]) < 0)
      K[0] += K[1], K[1] = K[0] - K[1], K[0] -= K[1];
    Between two[3] = {elastic_conductivity_two(dim, phi, K), elastic_bulk_two(dim, phi, K, G),
                      elastic_shear_two(dim, phi, K, G)};
    for (int z = 0; z <= 8; z++) {
      double zeta = z / 8., eta = z / 8.;
      Between three[3] = {elastic_conductivity(dim, phi, zeta, K), elastic_bulk(dim, phi, zeta, K, G),
                          elastic_shear(dim, phi, zeta, eta, K, G)};
      for (int p = 0; p < 3; p++) {
        double now[2] = {three[p].lower, three[p].upper}, sign = G[1] > G[0] ? 1 : -1;
        unordered += now[0] > now[1] * (1 + 1e-14);
        outside += now[0] < two[p].lower * (1 - 1e-14) || now[1] > two[p].upper * (1 + 1e-14);
        for (int e = 0; e < 2; e++) {
          if (z > 0)
            falling += sign * (now[e] - last[2 * p + e]) < -1e-14 * now[e];
          last[2 * p + e] = now[e];
        }
        bool most = (z == 8) == (G[1] > G[0]);
        if (z % 8 == 0)
          for (int e = 0; e < 2; e++)
            worst = GSL_MAX(worst, fabs(now[e] / (most ? two[p].upper : two[p].lower) - 1));
      }
    }
  }
  gsl_test(worst > 2e-15, "Hashin and Shtrikman at the ends, to %.1e", worst);
  gsl_test_int(unordered, 0, "upper above lower");
  gsl_test_int(falling, 0, "monotone in zeta and eta");
  gsl_test_int(outside, 0, "within Hashin and Shtrikman");
}

/* The least value of x A x under c x = 1 is 1 / (c A^-1 c); A is a sum of w r r. */
static double constrained(int n, int terms, const double w[], const double r[][2], const double c[2]) {
  double a[4] = {0}, y[2] = {0};
  if (n == 1)
    return w[0];
  for (int t = 0; t < terms; t++)
    for (int k = 0; k < 4; k++)
      a[k] += w[t] * r[t][k / 2] * r[t][k % 2];
  double det = a[0] * a[3] - a[1] * a[2];
  y[0] = (a[3] * c[0] - a[1] * c[1]) / det;
  y[1] = (a[0] * c[1] - a[2] * c[0]) / det;
  return 1 / (c[0] * y[0] + c[1] * y[1]);
}

/* B(Y) as it is usually written. */
static double usual(double phi, const double s[2], double Y) {
  return (1 - phi) * s[0] + phi * s[1] -
         phi * (1 - phi) * (s[1] - s[0]) * (s[1] - s[0]) / (phi * s[0] + (1 - phi) * s[1] + Y);
}

/* Directions n for means that are exact to degree 8: those of a product rule; E is a shear. The mean squares of the trial strains and
   stresses in their parts of degree 0, 2 and 4 are found from the tensors themselves, without the algebra of the chapter. */
typedef struct {
  double constant[2], trace[2][2], two[2][2], four[2][2]; /* of two amplitudes; forms */
} Parts;

static void trial(int kind, const double n[3], double e[2][9]) {
  static const double E[9] = {1, 0, 0, 0, -1, 0, 0, 0, 0};
  double En[3], nEn = 0, P[9], PEP[9] = {0};
  for (int i = 0; i < 3; i++)
    En[i] = E[4 * i] * n[i], nEn += n[i] * En[i];
  for (int i = 0; i < 9; i++)
    P[i] = (i / 3 == i % 3) - n[i / 3] * n[i % 3];
  for (int i = 0; i < 9; i++)
    for (int k = 0; k < 3; k++)
      PEP[i] += P[3 * (i / 3) + k] * E[4 * k] * P[3 * k + i % 3];
  for (int i = 0; i < 9; i++) {
    int a = i / 3, b = i % 3;
    double wa = En[a] - nEn * n[a], wb = En[b] - nEn * n[b];
    e[0][i] = kind ? PEP[i] : nEn * n[a] * n[b];
    e[1][i] = kind ? nEn * P[i] : n[a] * wb + wa * n[b];
  }
}

/* The part of degree 4 of each component by projection on the harmonics is what is left when those of degree 0 and 2 are taken off. */
static Parts parts_of(int kind) {
  enum { M = 12 };
  Parts parts = {{0}};
  double sum[2][9] = {{0}}, quad[2][9][5] = {{{0}}}, square[2][2] = {{0}}, trace[2][2] = {{0}}, norm[5] = {0};
  static const double node[] = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175, 0.7699026741943047, 0.9041172563704749, 0.9815606342467192},
                      weight[] = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659, 0.1600783285433462, 0.1069393259953184, 0.0471753363865118};
  for (int pass = 0; pass < 2; pass++)
    for (int i = 0; i < M; i++)
      for (int j = 0; j < 2 * M; j++) {
        double c = i < 6 ? node[i] : -node[i - 6], s = sqrt(1 - c * c), w = weight[i % 6] / 2 / (2 * M), e[2][9];
        double n[3] = {s * cos(M_PI * j / M), s * sin(M_PI * j / M), c};
        double y[5] = {n[0] * n[1], n[0] * n[2], n[1] * n[2], n[0] * n[0] - n[1] * n[1], 3 * c * c - 1};
        trial(kind, n, e);
        for (int h = 0; h < 5; h++)
          norm[h] += pass ? 0 : w * y[h] * y[h];
        for (int a = 0; a < 2 && !pass; a++)
          for (int k = 0; k < 9; k++) {
            sum[a][k] += w * e[a][k];
            for (int h = 0; h < 5; h++)
              quad[a][k][h] += w * y[h] * e[a][k];
          }
        for (int a = 0; a < 2 && pass; a++)
          for (int b = 0; b < 2; b++) {
            double ta = e[a][0] + e[a][4] + e[a][8], tb = e[b][0] + e[b][4] + e[b][8];
            trace[a][b] += w * ta * tb;
            for (int k = 0; k < 9; k++)
              square[a][b] += w * e[a][k] * e[b][k];
          }
      }
  for (int a = 0; a < 2; a++) {
    parts.constant[a] = sum[a][0];
    for (int b = 0; b < 2; b++) {
      double all = square[a][b], second = 0, zero = 0;
      for (int k = 0; k < 9; k++) {
        zero += sum[a][k] * sum[b][k];
        for (int h = 0; h < 5; h++)
          second += quad[a][k][h] * quad[b][k][h] / norm[h];
      }
      parts.trace[a][b] = trace[a][b];
      parts.two[a][b] = second - trace[a][b] / 3;
      parts.four[a][b] = all - zero - second;
    }
  }
  return parts;
}

static double form(const Parts *p, double trace, double two, double four) {
  double a[2][2], c[2] = {p->constant[0], p->constant[1]};
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      a[i][j] = trace * p->trace[i][j] + two * p->two[i][j] + four * p->four[i][j];
  double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  double inverse = (c[0] * c[0] * a[1][1] - 2 * c[0] * c[1] * a[0][1] + c[1] * c[1] * a[0][0]) / det;
  return 1 / inverse;
}

/* Energy 2W: strain K tr^2 + 2 G dev^2, stress tr^2 / 9 K + dev^2 / 2 G; E : E = 2. */
static void test_trial_fields(void) {
  Parts strain = parts_of(0), stress = parts_of(1);
  Rng rng = rng_stream(72, 0, RNG_TEST);
  double worst[4] = {0};
  for (int t = 0; t < 500; t++) {
    double phi = rng_uniform(&rng), zeta = rng_uniform(&rng), theta = rng_uniform(&rng), K[2], G[2], q[2], r[2];
    for (int i = 0; i < 2; i++) {
      K[i] = exp(4 * rng_uniform(&rng) - 2);
      G[i] = exp(4 * rng_uniform(&rng) - 2);
      q[i] = 1 / K[i], r[i] = 1 / G[i];
    }
    double Kz = (1 - zeta) * K[0] + zeta * K[1], Gz = (1 - zeta) * G[0] + zeta * G[1], Gt = (1 - theta) * G[0] + theta * G[1];
    double kz = (1 - zeta) * q[0] + zeta * q[1], gz = (1 - zeta) * r[0] + zeta * r[1], gt = (1 - theta) * r[0] + theta * r[1];
    Between found = elastic_shear(3, phi, zeta, (5 * zeta + 16 * theta) / 21, K, G);
    double upper = usual(phi, G, form(&strain, Kz / 4, Gz / 2, Gt / 2));
    double lower = 1 / usual(phi, r, form(&stress, kz / 9, gz / 2, gt / 2));
    worst[0] = GSL_MAX(worst[0], fabs(found.upper / upper - 1));
    worst[1] = GSL_MAX(worst[1], fabs(found.lower / lower - 1));
    /* In the plane: amplitudes p, q; u = (p + q) / 4. */
    double w[2] = {Gt / 16, Kz / 8}, c[2] = {0.25, 0.25};
    static const double rows[][2] = {{1, -1}, {1, 0}};
    found = elastic_shear(2, phi, zeta, theta, K, G);
    worst[2] = GSL_MAX(worst[2], fabs(found.upper / usual(phi, G, constrained(2, 2, w, rows, c)) - 1));
    worst[3] = GSL_MAX(worst[3], fabs(found.lower * usual(phi, r, 2 * kz + gt) - 1));
  }
  gsl_test(worst[0] > 1e-12, "trial strains in space, to %.1e", worst[0]);
  gsl_test(worst[1] > 1e-12, "trial stresses in space, to %.1e", worst[1]);
  gsl_test(worst[2] > 1e-12, "trial strains in the plane, to %.1e", worst[2]);
  gsl_test(worst[3] > 1e-12, "trial stresses in the plane, to %.1e", worst[3]);
}

static void test_limits(void) {
  const double inf = GSL_POSINF, one[2] = {1, 1}, far = 1e13;
  for (int dim = 2; dim <= 3; dim++) {
    gsl_test_rel(elastic_shear(dim, 0.3, 0.2, 0.4, one, one).upper, 1, 1e-15, "both phases equal, %d-D: shear", dim);
    gsl_test_rel(elastic_bulk(dim, 0.3, 0.2, one, one).lower, 1, 1e-15, "bulk");
    gsl_test_rel(elastic_conductivity(dim, 0.3, 0.2, one).lower, 1, 1e-15, "conductivity");
    for (int empty = 0; empty < 2; empty++)
      for (int holes = 0; holes < 2; holes++) {
        double K[2] = {2, holes ? 0 : inf}, G[2] = {1, holes ? 0 : inf}, zeta = empty ? 0 : 0.2, eta = empty ? 0 : 0.4;
        double near[2][2] = {{2, holes ? 1 / far : far}, {1, holes ? 1 / far : far}};
        Between limit[3] = {elastic_conductivity(dim, 0.3, zeta, K), elastic_bulk(dim, 0.3, zeta, K, G),
                            elastic_shear(dim, 0.3, zeta, eta, K, G)};
        Between at[3] = {elastic_conductivity(dim, 0.3, zeta, near[0]), elastic_bulk(dim, 0.3, zeta, near[0], near[1]),
                         elastic_shear(dim, 0.3, zeta, eta, near[0], near[1])};
        for (int p = 0; p < 3; p++) {
          const char *what = holes ? "holes" : "rigid";
          if (holes && !empty)
            gsl_test_abs(limit[p].lower, 0, 0, "%d-D, %s: property %d, lower", dim, what, p);
          else
            gsl_test_rel(limit[p].lower, at[p].lower, 1e-11, "%d-D, %s: property %d, lower", dim, what, p);
          if (holes || empty)
            gsl_test_rel(limit[p].upper, at[p].upper, 1e-11, "%d-D, %s: property %d, upper", dim, what, p);
          else
            gsl_test(limit[p].upper != inf, "%d-D, %s: property %d, upper", dim, what, p);
        }
      }
    double K[2] = {inf, 5}, G[2] = {1, 4}, near[2] = {far, 5};
    gsl_test_rel(elastic_shear(dim, 0.3, 0.2, 0.4, K, G).upper, elastic_shear(dim, 0.3, 0.2, 0.4, near, G).upper, 1e-11, "incompressible matrix, %d-D: upper", dim);
    gsl_test_rel(elastic_shear(dim, 0.3, 0.2, 0.4, K, G).lower, elastic_shear(dim, 0.3, 0.2, 0.4, near, G).lower, 1e-11, "lower");
    gsl_test_rel(elastic_bulk(dim, 0.3, 0.2, K, G).lower, elastic_bulk(dim, 0.3, 0.2, near, G).lower, 1e-11, "bulk");
    gsl_test_rel(elastic_shear(dim, 0, 0, 0, K, G).lower, 1, 0, "no particles");
    gsl_test_rel(elastic_shear(dim, 1, 0.2, 0.4, K, G).lower, 4, 0, "no matrix");
  }
}

/* Exchange of the phases in the plane: the conductivity becomes the product by itself, and the lower bound that of the upper one. */
static void test_keller(void) {
  Rng rng = rng_stream(73, 0, RNG_TEST);
  double worst = 0;
  for (int t = 0; t < 500; t++) {
    double phi = rng_uniform(&rng), zeta = rng_uniform(&rng), s[2] = {1, exp(8 * rng_uniform(&rng) - 4)}, r[2] = {s[1], s[0]};
    Between a = elastic_conductivity(2, phi, zeta, s), b = elastic_conductivity(2, phi, zeta, r);
    worst = GSL_MAX(worst, fabs(a.lower * b.upper / (s[0] * s[1]) - 1));
  }
  gsl_test(worst > 1e-14, "Keller's exchange, to %.1e", worst);
}

/* At the ends of what moduli may be nothing is too large for a double. */
static void test_extremes(void) {
  double ends[] = {0, ELASTIC_LEAST, 1, ELASTIC_MOST, GSL_POSINF};
  int bad = 0;
  for (int code = 0; code < 625; code++) {
    double K[] = {ends[code % 5], ends[code / 5 % 5]}, G[] = {ends[code / 25 % 5], ends[code / 125]};
    for (int dim = 2; dim <= 3; dim++) {
      Between all[] = {elastic_conductivity(dim, 0.3, 0.2, K), elastic_bulk(dim, 0.3, 0.2, K, G), elastic_shear(dim, 0.3, 0.2, 0.4, K, G),
                       elastic_bulk_two(dim, 0.3, K, G), elastic_shear_two(dim, 0.3, K, G)};
      for (int b = 0; b < 5; b++) {
        const double *s = b == 2 || b == 4 ? G : K;
        double least = GSL_MIN_DBL(s[0], s[1]), most = GSL_MAX_DBL(s[0], s[1]), slack = 1 + 1e-12;
        bad += !(all[b].lower >= least / slack && all[b].lower <= all[b].upper * slack && all[b].upper <= most * slack);
      }
    }
  }
  gsl_test(bad, "moduli at their ends: %d of 6250 bounds are none", bad);
}

int main(void) {
  test_extremes();
  test_by_hand();
  test_ends();
  test_trial_fields();
  test_limits();
  test_keller();
  return gsl_test_summary();
}
