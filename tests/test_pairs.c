/* Pair counts, g, K, I, rings and the range of order. */
#include "core.h"
#include "many.h"
#include "outcome.h"
#include "pairs.h"
#include "ref_pairs.h"
#include "rng.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Pack *empty(int dim, const double side[], size_t n) {
  Box box = {.dim = dim};
  for (int k = 0; k < dim; k++)
    box.side[k] = side[k];
  Species species = {.name = "a", .radius = 0.37, .count = n};
  return pack_alloc(&box, &species, 1, false);
}

static Pack *uniform(int dim, const double side[], size_t n, uint64_t seed) {
  Pack *pack = empty(dim, side, n);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t i = 0; i < n * (size_t)dim; i++)
    pack->x[i] = side[i % (size_t)dim] * rng_uniform(&rng);
  return pack;
}

/* m^3 cubic cells of side a, with this basis in units of a. */
static Pack *lattice(int m, double a, int basis, const double b[][3]) {
  double side[3] = {m * a, m * a, m * a};
  Pack *pack = empty(3, side, (size_t)(m * m * m * basis));
  double *x = pack->x;
  for (int i = 0; i < m * m * m; i++)
    for (int s = 0; s < basis; s++) {
      *x++ = (i / (m * m) + b[s][0]) * a;
      *x++ = (i / m % m + b[s][1]) * a;
      *x++ = (i % m + b[s][2]) * a;
    }
  return pack;
}

static const double SC[][3] = {{0.137, 0.2713, 0.0419}};
static const double BCC[][3] = {{.11, .27, .04}, {.61, .77, .54}};
static const double FCC[][3] = {
    {.11, .27, .04}, {.61, .77, .04}, {.61, .27, .54}, {.11, .77, .54}};

static const char *const widths[] = {"default", "avx2", "avx512f"};

/* Each width of vectors against the two slow programs, count by count. */
static void exact(const char *what, Pack *pack, double origin, double step,
                  size_t bins) {
  uint64_t *all = memory(bins, sizeof *all), *lists = memory(bins, sizeof *all);
  uint64_t *count = memory(bins, sizeof *count);
  uint64_t below = ref_pairs_all(pack, origin, step, bins, all), total = below;
  for (size_t b = 0; b < bins; b++)
    total += all[b];
  uint64_t other = ref_pairs_lists(pack, origin, step, bins, lists);
  gsl_test(other != below || memcmp(all, lists, bins * sizeof *all),
           "%s: the two slow programs agree", what);
  for (int w = 0; w < 3; w++) {
    setenv("RANDPACK_SIMD", widths[w], 1);
    memset(count, 255, bins * sizeof *count);
    other = pairs_count(pack, origin, step, bins, count);
    gsl_test(other != below || memcmp(all, count, bins * sizeof *all),
             "%s: counts equal all pairs, %s (%llu pairs)", what, widths[w],
             (unsigned long long)total);
  }
  unsetenv("RANDPACK_SIMD");
  free(all);
  free(lists);
  free(count);
  pack_free(&pack);
}

static void test_exact(void) {
  static const double boxes[][3] = {{7.31, 7.31, 7.31}, {2.917, 6.41, 9.2},
                                    {1.37, 1.37, 27.4}, {27.4, 1.37, 1.37},
                                    {1.37, 27.4, 1.37}, {5.5, 5.5, 5.5}};
  char what[80];
  for (int dim = 2; dim <= 3; dim++)
    for (int b = 0; b < 6; b++)
      for (int cells = 1; cells <= 4; cells++) {
        double least = GSL_MIN(boxes[b][0], boxes[b][1]);
        least = dim == 3 ? GSL_MIN(least, boxes[b][2]) : least;
        /* reach half the box, and thirds and more */
        double reach = least / (cells == 1 ? 2 : cells);
        snprintf(what, sizeof what, "%d-D box %d, 1/%d of the side", dim, b,
                 cells == 1 ? 2 : cells);
        exact(what, uniform(dim, boxes[b], 613, (uint64_t)(10 * b + cells)),
              0.173 * reach, 0.827 * reach / 37, 37);
      }
  double cube[3] = {23.1, 23.1, 23.1};
  exact("3-D wide box", uniform(3, cube, 4099, 5), 0, 0.0217, 97);
  exact("2-D wide box", uniform(2, cube, 4099, 6), 0.31, 0.0217, 97);
  exact("one bin", uniform(3, cube, 2011, 7), 1.1, 2.3, 1);
  exact("many bins", uniform(3, cube, 2011, 7), 0, 1e-3, 4001);
  for (size_t n = 0; n <= 3; n++) {
    snprintf(what, sizeof what, "%zu particles", n);
    exact(what, uniform(3, cube, n, 8), 0, 1.05, 11);
    exact(what, uniform(2, cube, n, 9), 0, 1.05, 11);
  }
}

/* Points on edges of cells, just below the side, and on top of each other. */
static void test_corners(void) {
  double side[3] = {9, 9, 9};
  Pack *pack = uniform(3, side, 1500, 11);
  for (size_t i = 0; i < 3 * 1500; i++) {
    double whole = floor(pack->x[i]);
    if (i % 7 < 4)
      pack->x[i] = i % 5 ? whole : nextafter(9, 0);
    if (i % 11 == 0)
      pack->x[i] = nextafter(whole, 9);
    if (i % 13 == 0 && whole > 0)
      pack->x[i] = nextafter(whole, 0);
  }
  memcpy(pack->x + 300, pack->x + 1200, 90 * sizeof(double));
  uint64_t count[30];
  pairs_count(pack, 0, 0.1, 30, count);
  gsl_test(count[0] < 30, "coincident points are counted");
  exact("points on edges", pack, 0, 0.1, 30);
  pack = uniform(3, side, 3, 11);
  memset(pack->x, 0, 9 * sizeof(double));
  pairs_count(pack, 0, 0.5, 3, count);
  gsl_test_int((int)count[0], 3, "three points at one place");
  pack_free(&pack);
}

/* The edge rule: a contact short by rounding is in the first bin. */
static void test_edges(void) {
  double side[3] = {11, 12, 13}, step = 0.0173;
  const double gap[] = {-1e-15, 1e-16, 0,     4e-10,     -0.4e-9,
                        -3e-9,  0.5,   0.999, 1 - 0.5e-9};
  const int bin[] = {0, 0, 0, 0, 0, -1, 0, 0, 1};
  for (int k = 0; k < 9; k++) {
    Pack *pack = empty(3, side, 2);
    pack->x[0] = 10.5, pack->x[3] = 10.5 + 2.3 * (1 + (k < 2 ? gap[k] : 0)) +
                                    (k < 2 ? 0 : gap[k] * step) - 11;
    uint64_t count[2];
    uint64_t below = pairs_count(pack, 2.3, step, 2, count);
    int found = below ? -1 : count[0] ? 0 : 1;
    gsl_test_int(found, bin[k], "a pair at 2.3 + %g steps", gap[k]);
    gsl_test_int((int)(below + count[0] + count[1]), 1, "one pair");
    pack_free(&pack);
  }
}

/* g, K and I of uniform points, over realizations. */
static void test_ideal(int dim) {
  enum { BINS = 40, P = 40 };
  const double side[3] = {13.7, 11.9, 12.3};
  double step = 5.9 / BINS, sum[BINS] = {0}, square[BINS] = {0}, K[BINS] = {0};
  double small[BINS] = {0}, K2[BINS] = {0};
  const int sevens = as_many(150, 500);
  size_t n = 900;
  for (uint64_t p = 0; p < P; p++) {
    uint64_t count[BINS];
    double g[BINS], k[BINS];
    Pack *pack = uniform(dim, side, n, 1000 + p);
    uint64_t below = pairs_count(pack, 0, step, BINS, count);
    pairs_g(pack, count, 0, step, BINS, PAIRS_EXACT, g);
    pairs_K(pack, below, count, BINS, k);
    pack_free(&pack);
    for (int b = 0; b < BINS; b++) {
      sum[b] += g[b];
      square[b] += g[b] * g[b];
      K[b] += k[b] / P;
      K2[b] += k[b] * k[b] / P;
    }
    /* seven points: N^2 for N (N - 1) would be off by a seventh */
    for (int q = 0; q < sevens; q++) {
      pack = uniform(dim, side, 7, 100000 + (uint64_t)sevens * p + (uint64_t)q);
      pairs_count(pack, 0, step, BINS, count);
      pairs_g(pack, count, 0, step, BINS, PAIRS_EXACT, g);
      pack_free(&pack);
      for (int b = 0; b < BINS; b++)
        small[b] += g[b] * pairs_shell(dim, b * step, (b + 1) * step);
    }
  }
  double chi = 0, worst = 0, few = 0, worst_K = 0;
  double volume = side[0] * side[1] * (dim == 3 ? side[2] : 1);
  for (int b = 0; b < BINS; b++) {
    double shell = pairs_shell(dim, b * step, (b + 1) * step);
    /* binomial: 1 / expected pairs, in all realizations */
    double se = sqrt(volume / shell / (0.5 * (double)(n * (n - 1)) * P));
    double z = (sum[b] / P - 1) / se;
    worst = GSL_MAX(worst, fabs(z));
    chi += z * z;
    few += small[b] / (sevens * P);
    double exact_K = pairs_shell(dim, 0, (b + 1) * step);
    double sd = sqrt((K2[b] - K[b] * K[b]) / (P - 1));
    worst_K = GSL_MAX(worst_K, fabs(K[b] - exact_K) / sd);
  }
  gsl_test(!(worst < 4), "ideal gas %d-D: g = 1 in all bins (%.2f se)", dim,
           worst);
  double q = gsl_cdf_chisq_Q(chi, BINS);
  gsl_test(!(q > 1e-3 && q < 0.999), "ideal gas %d-D: chi square, Q = %.4f",
           dim, q);
  gsl_test(!(worst_K < 4.5), "ideal gas %d-D: K = omega r^d (%.2f se)", dim,
           worst_K);
  double ball = pairs_shell(dim, 0, 5.9);
  double se = ball * sqrt(volume / ball / (21. * sevens * P));
  gsl_test(!(fabs(few - ball) < 4 * se), "seven points %d-D: %.4f se", dim,
           (few - ball) / se);
}

static void test_quotients(void) {
  gsl_test_rel(pairs_shell(3, 2.3, 2.7), 4. / 3 * M_PI * (19.683 - 12.167),
               1e-14, "shell 3-D");
  gsl_test_rel(pairs_shell(2, 2.3, 2.7), M_PI * (7.29 - 5.29), 1e-14,
               "shell 2-D");
  gsl_test_rel(pairs_shell(3, 2, 2 + 1e-9), 4 * M_PI * 4e-9, 2e-7,
               "thin shell");
  double side[3] = {10.1, 10.1, 10.1}, g[3], K[3], I[3];
  uint64_t count[3] = {17, 0, 5};
  Pack *pack = empty(3, side, 83);
  double v = 2 * pow(10.1, 3) / (83. * 82);
  pairs_g(pack, count, 2.2, 0.3, 3, PAIRS_EXACT, g);
  gsl_test_rel(g[2], 5 * v / (4. / 3 * M_PI * (pow(3.1, 3) - pow(2.8, 3))),
               1e-13, "g, exact shell");
  pairs_g(pack, count, 2.2, 0.3, 3, PAIRS_RIGHT, g);
  gsl_test_rel(g[2], 5 * v * (82. / 83) / (4 * M_PI * 2.8 * 2.8 * 0.3), 1e-13,
               "g+");
  pairs_g(pack, count, 0, 0.3, 3, PAIRS_RIGHT, K);
  gsl_test(!gsl_isnan(K[0]) || !gsl_finite(K[1]), "the right quotient does not exist at r = 0");
  pairs_g(pack, count, 2.2, 0.3, 3, PAIRS_CENTRAL, g);
  gsl_test_rel(g[2], 5 * v * (82. / 83) / (4 * M_PI * 2.95 * 2.95 * 0.3), 1e-13,
               "g-");
  pairs_K(pack, 3, count, 3, K);
  gsl_test_rel(K[0], 20 * v, 1e-14, "K, first edge, with what is below");
  gsl_test_rel(K[2], 25 * v, 1e-14, "K, last edge");
  pairs_I(pack, count, 3, I);
  gsl_test_rel(I[0], 34. / 83, 1e-14, "I");
  pack_free(&pack);
  pack = empty(2, side, 83);
  v = 2 * pow(10.1, 2) / (83. * 82);
  pairs_g(pack, count, 2.2, 0.3, 3, PAIRS_EXACT, g);
  gsl_test_rel(g[0], 17 * v / (M_PI * (6.25 - 4.84)), 1e-13, "g 2-D");
  pairs_g(pack, count, 2.2, 0.3, 3, PAIRS_RIGHT, g);
  gsl_test_rel(g[0], 17 * v * (82. / 83) / (2 * M_PI * 2.2 * 0.3), 1e-13,
               "g+ 2-D");
  pack_free(&pack);
  for (size_t n = 0; n < 2; n++) {
    pack = uniform(3, side, n, 3);
    gsl_test_int((int)pairs_count(pack, 0.5, 0.1, 3, count), 0, "no pairs");
    pairs_g(pack, count, 0.5, 0.1, 3, PAIRS_EXACT, g);
    pairs_K(pack, 0, count, 3, K);
    pairs_I(pack, count, 3, I);
    gsl_test(g[1] != 0 || K[2] != 0 || I[0] != 0, "%zu particles: zeros", n);
    pack_free(&pack);
  }
}

/* Of a lattice with spacing 2a = 0.9. B's table has n = N / V where the exact
   g has (N - 1) / V; the table's values are of reference 3/(pi dR) and of the true
   shells. */
static void test_right_quotient(void) {
  const double dR[] = {0.1, 0.01, 0.005, 0.003};
  const double right[] = {9.5493, 95.4930, 190.9859, 318.3099};
  const double shell[] = {9.0874, 95.0171, 190.5093, 317.8329};
  for (int m = 3; m <= 11; m += m == 3 ? 2 : 6)
    for (int k = 0; k < 4; k++) {
      Pack *pack = lattice(m, 0.9, 1, SC);
      double many = (double)(m * m * m), g, step = dR[k] * 0.45, I;
      uint64_t count;
      pairs_count(pack, 0.9, step, 1, &count);
      pairs_g(pack, &count, 0.9, step, 1, PAIRS_RIGHT, &g);
      gsl_test_abs(g, right[k], 6e-5, "g+(2, %g), m = %d", dR[k], m);
      pairs_g(pack, &count, 0.9, step, 1, PAIRS_EXACT, &g);
      gsl_test_abs(g * (many - 1) / many, shell[k], 6e-5, "true shell");
      pairs_I(pack, &count, 1, &I);
      gsl_test_abs(I, 6, 0, "I(2a) = 6");
      /* the central quotient sees half a shell of nothing */
      pairs_count(pack, 0.9 - step / 2, step, 1, &count);
      double half;
      pairs_g(pack, &count, 0.9 - step / 2, step, 1, PAIRS_CENTRAL, &half);
      gsl_test_abs(half, right[k], 6e-5, "g- of a delta is not halved");
      pack_free(&pack);
    }
}

/* Points no nearer than 2: the central quotient at 2 is half the right one. */
static void test_half(void) {
  const double side[3] = {19, 19, 19};
  uint64_t right = 0, central = 0, count;
  double a, b, step = 0.1;
  Pack *pack = empty(3, side, 150);
  for (uint64_t p = 0; p < (uint64_t)as_many(80, 200); p++) {
    Rng rng = rng_stream(50, p, RNG_TEST);
    for (size_t i = 0; i < pack->n; i++) {
      double nearest = 0;
      while (nearest < 2) {
        nearest = 19;
        for (int k = 0; k < 3; k++)
          pack->x[3 * i + (size_t)k] = 19 * rng_uniform(&rng);
        for (size_t j = 0; j < i; j++) {
          double square = 0;
          for (size_t k = 0; k < 3; k++)
            square += gsl_pow_2(
                box_nearest(pack->x[3 * i + k] - pack->x[3 * j + k], 19));
          nearest = GSL_MIN(nearest, sqrt(square));
        }
      }
    }
    gsl_test(pairs_count(pack, 2, step, 1, &count) != 0, "none nearer than 2");
    right += count;
    pairs_count(pack, 2 - step / 2, step, 1, &count);
    central += count;
  }
  pairs_g(pack, &right, 2, step, 1, PAIRS_RIGHT, &a);
  pairs_g(pack, &central, 2 - step / 2, step, 1, PAIRS_CENTRAL, &b);
  /* half of the same pairs: binomial, 4 se */
  gsl_test_abs(b / a, 0.5, 4 * 0.5 / sqrt((double)right), "half of a jump");
  pack_free(&pack);
}

static void rings_are(const char *what, Pack *pack, double unit, double reach,
                      int many, const double square[], const int number[],
                      const int complete[]) {
  size_t rings;
  PairsRing *ring = pairs_rings(pack, reach, 1e-9, &rings);
  gsl_test_int((int)rings, many, "%s: rings", what);
  for (int k = 0; k < many && k < (int)rings; k++) {
    gsl_test_rel(ring[k].r, unit * sqrt(square[k]), 1e-9, "%s: ring %d", what,
                 k);
    gsl_test_abs(ring[k].number, number[k], 0, "%s: I(sqrt %g)", what,
                 square[k]);
    gsl_test_int(ring[k].complete, complete[k], "%s: complete", what);
  }
  free(ring);
  pack_free(&pack);
}

static void test_rings(void) {
  const double sq[] = {1, 2, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14};
  const int n[] = {6, 12, 8, 6, 24, 24, 12, 30, 24, 24, 8, 24, 48};
  const int all[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  rings_are("sc 11", lattice(11, 0.83, 1, SC), 0.83, 0.83 * 3.8, 13, sq, n,
            all);
  const int one[] = {1, 1, 0};
  rings_are("sc 3", lattice(3, 0.83, 1, SC), 0.83, 9, 3, sq, n, one);
  const double two[] = {1, 2, 3, 4, 5, 6, 8, 9, 12};
  const int n2[] = {6, 12, 8, 6, 24, 24, 12, 24, 8};
  const int c2[] = {1, 1, 1, 1, 1, 1, 0, 0, 0};
  rings_are("sc 5", lattice(5, 0.83, 1, SC), 0.83, 9, 9, two, n2, c2);
  /* an even box: at half the side a nearest image hides another */
  const double four[] = {1, 2, 3, 4};
  const int n4[] = {6, 12, 8, 3}, c4[] = {1, 1, 1, 0};
  rings_are("sc 4", lattice(4, 1, 1, SC), 1, 2, 4, four, n4, c4);
  const double fcc[] = {1, 2, 3, 4, 5, 6};
  const int nf[] = {12, 6, 24, 12, 24, 8};
  rings_are("fcc", lattice(5, sqrt(2) * 1.1, 4, FCC), 1.1, 1.1 * 2.5, 6, fcc,
            nf, all);
  const double bcc[] = {0.75, 1, 2, 2.75, 3, 4};
  const int nb[] = {8, 6, 12, 24, 8, 6};
  rings_are("bcc", lattice(5, 1.3, 2, BCC), 1.3, 1.3 * 2.05, 6, bcc, nb, all);
  double side[3] = {5, 5, 5};
  size_t rings;
  for (size_t many = 0; many < 2; many++) {
    Pack *pack = uniform(3, side, many, 2);
    PairsRing *ring = pairs_rings(pack, 12, 1e-6, &rings);
    gsl_test_int((int)rings, 0, "%zu particles have no ring", many);
    free(ring);
    pack_free(&pack);
  }
  /* every other particle once, however far */
  Pack *pack = uniform(2, side, 40, 31);
  double sum = 0;
  PairsRing *ring = pairs_rings(pack, 100, 1e-12, &rings);
  for (size_t k = 0; k < rings; k++)
    sum += ring[k].number;
  gsl_test_rel(sum, 39, 1e-12, "39 others in all");
  free(ring);
  pack_free(&pack);
}

/* K of lattices, and that counting stops at no edge. */
static void test_lattice_K(void) {
  Pack *pack = lattice(7, 1.07, 1, SC);
  uint64_t count[9];
  double K[9];
  uint64_t below = pairs_count(pack, 1.07, 1.07 * 0.25, 9, count);
  pairs_K(pack, below, count, 9, K);
  double unit = pow(7 * 1.07, 3) / 342;
  const double sum[] = {6, 18, 26, 26, 56, 80, 80, 92, 146};
  for (int b = 0; b < 9; b++)
    gsl_test_rel(K[b], sum[b] * unit, 1e-13, "K of sc at %g", 1.25 + b * 0.25);
  pack_free(&pack);
}

static void test_range(void) {
  enum { BINS = 200, P = 30 };
  const int TRIES = as_many(150, 400);
  double R[BINS], g[BINS], se[BINS];
  gsl_rng *rng = rng_gsl_alloc(rng_stream(77, 0, RNG_TEST));
  for (int kind = 0; kind < 3; kind++) {
    int late = 0, infinite = 0;
    double mean = 0;
    for (int t = 0; t < TRIES; t++) {
      for (int b = 0; b < BINS; b++) {
        R[b] = 2 + 0.05 * b;
        double sum = 0, square = 0, true_g = 1, noise = 0.01;
        if (kind == 1) /* ends at 4 */
          true_g = R[b] < 4 - 1e-9 ? 1.2 : 1;
        if (kind == 2) /* a slow wave no bin shows, to 8 */
          true_g = R[b] < 8 ? 1 + 0.004 * cos(M_PI * R[b]) : 1;
        for (int p = 0; p < P; p++) {
          double x = true_g + gsl_ran_gaussian(rng, noise);
          sum += x / P;
          square += x * x / P;
        }
        g[b] = sum;
        se[b] = sqrt((square - sum * sum) / (P - 1));
      }
      double r = pairs_range(BINS, R, g, se, P, 0.05);
      late += r > (kind == 1 ? 4 + 1e-9 : 2);
      infinite += r == GSL_POSINF;
      mean += r / TRIES;
    }
    if (kind < 2) /* at most 20 of 400, + 4 se of 4.4 */
      gsl_test(late > .05 * TRIES + 4 * sqrt(.05 * .95 * TRIES), "false alarms of r_g: %d of %d", late, TRIES);
    if (kind == 1)
      gsl_test_abs(mean, 4, 0.1, "r_g of a step at 4");
    if (kind == 2)
      gsl_test(!(mean > 6.5 && mean < 8), "r_g of a slow wave: %.2f", mean);
    gsl_test(infinite > 10, "r_g is finite");
  }
  for (int b = 0; b < BINS; b++)
    g[b] = 1, se[b] = 0.01;
  gsl_test_abs(pairs_range(BINS, R, g, se, P, 0.05), 2, 0,
               "flat from the start");
  g[BINS - 1] = 1.5;
  gsl_test(pairs_range(BINS, R, g, se, P, 0.05) != GSL_POSINF,
           "the last bin deviates");
  g[BINS - 1] = 1, g[0] = 0, se[0] = 0;
  gsl_test_abs(pairs_range(BINS, R, g, se, P, 0.05), R[1], 0,
               "a bin of nothing with no error");
  for (int b = 0; b < BINS; b++)
    g[b] = b < BINS / 2 ? 1.5 : 1, se[b] = 0.001;
  gsl_test(!gsl_isnan(pairs_range(BINS, R, g, se, 9, 0.05)),
           "no range of nine packs");
  gsl_test_abs(pairs_range(BINS, R, g, se, 10, 0.05), R[BINS / 2], 0,
               "a range of ten");
  gsl_rng_free(rng);
}

/* A parabola is found exactly, on whatever side of a bin its vertex lies; a
   smooth peak without bias under noise, where the highest bin has some. */
static void test_extrema(void) {
  enum { BINS = 200 };
  const int REPEATS = as_many(200, 400);
  double R[BINS], g[BINS], place = 0, height = 0, highest = 0, square = 0;
  for (int b = 0; b < BINS; b++)
    R[b] = 2.005 + 0.01 * b;
  for (int sign = -1; sign <= 1; sign += 2)
    for (double top = 3.201; top < 3.3; top += 0.0173) {
      for (int b = 0; b < BINS; b++)
        g[b] = 1.37 - sign * 2.9 * gsl_pow_2(R[b] - top);
      PairsExtremum e = pairs_extremum(BINS, R, g, 3.1, 3.4, sign);
      gsl_test_abs(e.R, top, 1e-10, "the vertex at %.4f", top);
      gsl_test_abs(e.g, 1.37, 1e-12, "its height");
    }
  PairsExtremum side = pairs_extremum(BINS, R, g, 2.5, 3.0, 1);
  gsl_test_abs(side.R, 2.995, 0.006, "on a slope: the end of the interval");
  for (int b = 0; b < BINS; b++)
    g[b] = 1 + 3 * gsl_pow_2(R[b] - 3);
  side = pairs_extremum(BINS, R, g, 2.96, 2.99, 1);
  gsl_test_abs(side.R, 2.965, 1e-12, "a trough is no peak");
  gsl_test_abs(side.g, 1 + 3 * gsl_pow_2(0.035), 1e-12, "nor is it as low");
  gsl_test(!gsl_isnan(pairs_extremum(BINS, R, g, 2, 2.01, 1).R),
           "no bin with a parabola");
  gsl_test(!gsl_isnan(pairs_extremum(BINS, R, g, 2, 2.01, 1).g), "and then no height");
  gsl_rng *rng = rng_gsl_alloc(rng_stream(3, 5, RNG_TEST));
  for (int k = 0; k < REPEATS; k++) {
    double top = -1;
    for (int b = 0; b < BINS; b++) {
      double d = R[b] - 3.2371;
      g[b] = 1 + 0.5 * exp(-20 * d * d) + gsl_ran_gaussian(rng, 0.05);
      top = fmax(top, g[b]);
    }
    PairsExtremum e = pairs_extremum(BINS, R, g, 3.1, 3.4, 1);
    place += e.R / REPEATS, square += e.R * e.R / REPEATS;
    height += e.g / REPEATS, highest += top / REPEATS;
  }
  double se = sqrt((square - place * place) / REPEATS);
  gsl_test(fabs(place - 3.2371) > 3 * se + 1e-3, "the place %.4f(%.4f)", place,
           se);
  gsl_test(fabs(height - 1.5) > 0.03, "the height %.4f", height);
  gsl_test(highest < 1.56, "the highest bin is too high: %.4f", highest);
  gsl_rng_free(rng);
}

/* Ordered pairs from some to any, nearest images; the edges as pairs_count's. */
static uint64_t slow_around(const Pack *pack, const bool of[], double origin,
                            double step, size_t bins, uint64_t count[]) {
  uint64_t below = 0;
  size_t dim = (size_t)pack->box.dim;
  memset(count, 0, bins * sizeof *count);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = 0; of[i] && j < pack->n; j++) {
      double square = 0;
      for (size_t k = 0; k < dim; k++)
        square += gsl_pow_2(
            box_nearest(pack->x[j * dim + k] - pack->x[i * dim + k],
                        pack->box.side[k]));
      double place = (sqrt(square) - origin) / step + 1e-9;
      if (i != j && place < 0)
        below++;
      if (i != j && place >= 0 && place < (double)bins)
        count[(size_t)place]++;
    }
  return below;
}

/* A cloud in the middle of a wide box, and one that fills its box; some at
   random, those of a core, nobody, all. */
static void test_around(int dim, bool full) {
  enum { N = 600, BINS = 25 };
  const double side[3] = {20, 21, 19};
  static const char *const which[] = {"some", "a core", "nobody", "all"};
  Pack *pack = uniform(dim, side, N, 21);
  uint64_t count[BINS], slow[BINS];
  bool of[N];
  for (size_t c = 0; !full && c < N * (size_t)dim; c++)
    pack->x[c] = side[c % (size_t)dim] / 2 + 0.37 * (pack->x[c] - side[c % (size_t)dim] / 2);
  for (int set = 0; set < 4; set++) {
    for (size_t i = 0; i < N; i++) {
      double square = 0;
      for (size_t k = 0; k < (size_t)dim; k++)
        square += gsl_pow_2(pack->x[i * (size_t)dim + k] - side[k] / 2);
      of[i] = set == 0 ? i * i % 7 == 2 : set == 1 ? square < (full ? 70 : 12) : set == 3;
    }
    uint64_t below = pairs_count_around(pack, of, 0.31, 0.113, BINS, count);
    uint64_t other = slow_around(pack, of, 0.31, 0.113, BINS, slow), sum = 0;
    for (int b = 0; b < BINS; b++)
      sum += slow[b];
    gsl_test(below != other || memcmp(count, slow, sizeof slow) ||
                 (sum < 12) != (set == 2),
             "%d-D: ordered pairs around %s, %s (%d)", dim, which[set],
             full ? "in a full box" : "finite", (int)sum);
  }
  /* around all, that is the g of the pack */
  double worst = 0;
  uint64_t half[BINS];
  pairs_count(pack, 0.31, 0.113, BINS, half);
  for (int b = 0; b < BINS; b++)
    worst = GSL_MAX(worst, fabs((double)count[b] - 2 * (double)half[b]));
  gsl_test(worst != 0, "%d-D: around all they are all, twice (%g)", dim, worst);
  pack_free(&pack);
}

/* Pairs between some and the turned pack, by a double loop: the mean over turns. own: of each with its own image;
   these alone unless all. */
static void slow_expect(const Pack *pack, const bool of[], double origin,
                        double step, size_t bins, bool all, double expect[],
                        double own[]) {
  size_t dim = (size_t)pack->box.dim;
  int turns = core_turns(pack->box.dim);
  memset(expect, 0, bins * sizeof *expect);
  memset(own, 0, bins * sizeof *own);
  for (int t = 0; t < turns; t++) {
    Pack *turned = core_turned(pack, t);
    for (size_t i = 0; i < pack->n; i++)
      for (size_t j = all ? 0 : i; of[i] && j < (all ? pack->n : i + 1); j++) {
        double square = 0;
        for (size_t k = 0; k < dim; k++)
          square += gsl_pow_2(turned->x[j * dim + k] - pack->x[i * dim + k]);
        double place = (sqrt(square) - origin) / step + 1e-9;
        if (place >= 0 && place < (double)bins) {
          expect[(size_t)place]++;
          own[(size_t)place] += i == j;
        }
      }
    pack_free(&turned);
  }
  for (size_t b = 0; b < bins; b++) {
    expect[b] /= turns;
    own[b] /= turns;
  }
}

/* Points of a Poisson process in a ball: with centres whose window lies in it g
   is 1, at any distance; with all for centres it falls off. */
static void test_minus(int dim) {
  enum { BINS = 8 };
  const int PACKS = as_many(150, 400);
  const double R = 4, step = 0.25, density = dim == 2 ? 5 : 1.5;
  const double side[3] = {17, 17, 17};
  double sum[2][BINS] = {{0}}, square[2][BINS] = {{0}}, worst = 0;
  double core = pairs_shell(dim, 0, R - BINS * step), ball = pairs_shell(dim, 0, R);
  gsl_rng *rng = rng_gsl_alloc(rng_stream(31, (uint64_t)dim, RNG_TEST));
  for (int p = 0; p < PACKS; p++) {
    size_t n = gsl_ran_poisson(rng, density * ball), d = (size_t)dim;
    Pack *pack = empty(dim, side, n);
    bool *of = memory(n, sizeof *of), *all = memory(n, sizeof *all);
    for (size_t i = 0; i < n; i++) {
      double x[3] = {0}, r;
      do
        for (size_t k = 0; k < d; k++)
          x[k] = R * (2 * gsl_rng_uniform(rng) - 1);
      while ((r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])) > R);
      for (size_t k = 0; k < d; k++)
        pack->x[i * d + k] = side[k] / 2 + x[k];
      of[i] = r <= R - BINS * step;
      all[i] = true;
    }
    for (int edge = 0; edge < 2; edge++) {
      uint64_t count[BINS];
      pairs_count_around(pack, edge ? all : of, 0, step, BINS, count);
      /* the centres that are expected: a mean without bias at any number */
      for (int b = 0; b < BINS; b++) {
        double g = (double)count[b] / (density * density * (edge ? ball : core) *
                                       pairs_shell(dim, b * step, (b + 1) * step));
        sum[edge][b] += g / PACKS;
        square[edge][b] += g * g / PACKS;
      }
    }
    pack_free(&pack);
    free(all);
    free(of);
  }
  double z[2], last = 0;
  for (int b = 0; b < BINS; b++)
    for (int edge = 0; edge < 2; edge++) {
      double mean = sum[edge][b];
      last = sqrt((square[edge][b] - mean * mean) / (PACKS - 1));
      z[edge] = (mean - 1) / last;
      worst = edge ? worst : GSL_MAX(worst, fabs(z[0]));
    }
  gsl_test(!(worst < 3.5), "%d-D: g of Poisson points in a ball (%.2f se)", dim,
           worst);
  gsl_test(!(z[1] < -10), "%d-D: without minus sampling it is not (%.1f se)",
           dim, z[1]);
  gsl_rng_free(rng);
}

/* Points of a Poisson process whose density falls from the middle outwards: what
   is expected is what is found, but for the images of the centres themselves; and
   it is what a double loop counts. */
static void test_expect(int dim) {
  enum { BINS = 6, N = 300 };
  const int PACKS = as_many(60, 200);
  const double R = 4, step = 0.25, side[3] = {17, 17, 17};
  double sum[BINS] = {0}, square[BINS] = {0}, worst = 0, differ = 0, found = 0;
  gsl_rng *rng = rng_gsl_alloc(rng_stream(37, (uint64_t)dim, RNG_TEST));
  for (int p = 0; p < PACKS; p++) {
    size_t n = gsl_ran_poisson(rng, N), d = (size_t)dim;
    Pack *pack = empty(dim, side, n);
    bool *of = memory(n, sizeof *of);
    for (size_t i = 0; i < n; i++) {
      double x[3] = {0}, r;
      do
        for (size_t k = 0; k < d; k++)
          x[k] = R * (2 * gsl_rng_uniform(rng) - 1);
      while ((r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])) > R ||
             gsl_rng_uniform(rng) < r / R * 0.8);
      for (size_t k = 0; k < d; k++)
        pack->x[i * d + k] = side[k] / 2 + x[k];
      of[i] = r <= R - BINS * step;
    }
    uint64_t count[BINS];
    double expect[BINS], slow[BINS], own[BINS];
    pairs_count_around(pack, of, 0, step, BINS, count);
    pairs_expect_around(pack, of, 0, step, BINS, expect);
    slow_expect(pack, of, 0, step, BINS, p < 3, slow, own);
    for (int b = 0; b < BINS; b++) {
      double more = (double)count[b] - (expect[b] - own[b]);
      differ = GSL_MAX(differ, p < 3 ? fabs(expect[b] - slow[b]) : 0);
      sum[b] += more / PACKS;
      square[b] += more * more / PACKS;
      found += expect[b];
    }
    pack_free(&pack);
    free(of);
  }
  for (int b = 0; b < BINS; b++)
    worst = GSL_MAX(worst, fabs(sum[b]) / sqrt((square[b] - sum[b] * sum[b]) / (PACKS - 1)));
  gsl_test(!(differ < 1e-9 && found > 1000), "%d-D: what is expected, by a double loop (%g)", dim, differ);
  gsl_test(!(worst < 3.5), "%d-D: it is what is found where nothing is correlated (%.2f se)", dim, worst);
  gsl_rng_free(rng);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    test_around(dim, false);
    test_around(dim, true);
    test_minus(dim);
    test_expect(dim);
  }
  test_extrema();
  test_exact();
  test_corners();
  test_edges();
  test_ideal(2);
  test_ideal(3);
  test_quotients();
  test_right_quotient();
  test_half();
  test_rings();
  test_lattice_K();
  test_range();
  return gsl_test_summary();
}
