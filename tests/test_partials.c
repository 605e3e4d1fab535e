/* Pairs by species against two loops, identities, contact values, nearest. */
#include "core.h"
#include "many.h"
#include "outcome.h"
#include "pairs.h"
#include "partials.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BINS = 40 };

/* Uniform points; species mixed up, or in the order of the list. */
static Pack *uniform(int dim, const double side[], const Species species[],
                     int kinds, bool own, uint64_t seed) {
  Box box = {.dim = dim};
  for (int k = 0; k < dim; k++)
    box.side[k] = side[k];
  Pack *pack = pack_alloc(&box, species, kinds, own);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t i = 0; i < pack->n * (size_t)dim; i++)
    pack->x[i] = side[i % (size_t)dim] * rng_uniform(&rng);
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] *= 0.5 + rng_uniform(&rng);
  for (size_t i = 0; !own && pack->kind && i + 1 < pack->n; i++) {
    size_t j = i + (size_t)(rng_uniform(&rng) * (double)(pack->n - i));
    uint16_t kind = pack->kind[i];
    pack->kind[i] = pack->kind[j];
    pack->kind[j] = kind;
  }
  return pack;
}

static double apart(const Pack *pack, size_t i, size_t j) {
  size_t dim = (size_t)pack->box.dim;
  double square = 0;
  for (size_t k = 0; k < dim; k++) {
    double d = box_nearest(pack->x[j * dim + k] - pack->x[i * dim + k],
                           pack->box.side[k]);
    square += d * d;
  }
  return sqrt(square);
}

static uint64_t loops(const Pack *pack, int k, int m, const PartialsPair *pair,
                      uint64_t count[]) {
  double low = pair->origin - 1e-9 * pair->step - pair->step;
  uint64_t below = 0;
  memset(count, 0, BINS * sizeof *count);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i + 1; j < pack->n; j++) {
      int a = pack_kind(pack, i), b = pack_kind(pack, j);
      if (!((a == k && b == m) || (a == m && b == k)))
        continue;
      double place = (apart(pack, i, j) - low) * (1 / pair->step);
      if (place < 1)
        below++;
      else if (place < BINS + 1)
        count[(int)place - 1]++;
    }
  return below;
}

static const char *const widths[] = {"default", "avx2", "avx512f"};

/* Every pair of species with a reach of its own, some to half the box. */
static void exact(const char *what, const Pack *pack) {
  Partials *p = partials_alloc(pack, BINS, 1, PARTIALS_R);
  double half = pairs_reach_limit(pack);
  for (int k = 0; k < p->kinds; k++)
    for (int m = 0; m <= k; m++) {
      PartialsPair *pair = partials_pair(p, k, m);
      double reach = half / (1 + (k + 2 * m) % 3);
      pair->origin = m == 1 ? 0 : 0.3 * reach;
      pair->step = (reach - pair->origin) / BINS;
    }
  for (int w = 0; w < 3; w++) {
    setenv("RANDPACK_SIMD", widths[w], 1);
    partials_count(p);
    for (int k = 0; k < p->kinds; k++)
      for (int m = 0; m < p->kinds; m++) {
        const PartialsPair *pair = partials_pair(p, k, m);
        uint64_t count[BINS], below = loops(pack, k, m, pair, count);
        gsl_test(
            below != pair->below || memcmp(count, pair->count, sizeof count),
            "%s: counts of %d %d equal two loops, %s", what, k, m, widths[w]);
      }
  }
  unsetenv("RANDPACK_SIMD");
  partials_free(&p);
}

/* With the same bins for all: sums and weighted sums give the whole pack. */
static void sums(const char *what, const Pack *pack) {
  double step = pairs_reach_limit(pack) * 0.9 / BINS, n = (double)pack->n;
  Partials *p = partials_alloc(pack, BINS, step, PARTIALS_R);
  uint64_t whole[BINS], sum[BINS + 1] = {0};
  double g[BINS], back[BINS], K[BINS], g_sum[BINS] = {0}, K_sum[BINS] = {0};
  for (int k = 0; k < p->kinds; k++)
    for (int m = 0; m <= k; m++)
      partials_pair(p, k, m)->origin = 0.1 * step;
  partials_count(p);
  for (int k = 0; k < p->kinds; k++)
    for (int m = 0; m <= k; m++) {
      sum[BINS] += partials_pair(p, k, m)->below;
      partials_g(p, k, m, g);
      partials_g(p, m, k, back);
      partials_K(p, k, m, K);
      gsl_test(memcmp(g, back, sizeof g), "%s: g_km = g_mk", what);
      for (int b = 0; b < BINS; b++) {
        sum[b] += partials_pair(p, k, m)->count[b];
        g_sum[b] += partials_pairs(p, k, m) * g[b] / (0.5 * n * (n - 1));
        K_sum[b] += partials_pairs(p, k, m) * K[b] / (0.5 * n * (n - 1));
      }
    }
  uint64_t below = pairs_count(pack, 0.1 * step, step, BINS, whole);
  gsl_test(below != sum[BINS] || memcmp(whole, sum, sizeof whole),
           "%s: species add up to the pack", what);
  pairs_g(pack, whole, 0.1 * step, step, BINS, PAIRS_EXACT, g);
  pairs_K(pack, below, whole, BINS, K);
  for (int b = 0; b < BINS; b++) {
    gsl_test_rel(g_sum[b], g[b], 1e-13, "%s: weighted g", what);
    gsl_test_rel(K_sum[b], K[b], 1e-13, "%s: weighted K", what);
  }
  partials_free(&p);
}

/* Nearest and contacts by two loops over enough images. */
static void nearest(const char *what, const Pack *pack, double tolerance) {
  Partials *p = partials_alloc(pack, 1, 1, PARTIALS_R);
  size_t dim = (size_t)pack->box.dim;
  double all = GSL_POSINF;
  for (int k = 0; k < p->kinds; k++)
    for (int m = 0; m < p->kinds; m++) {
      PartialsNear near = partials_near(p, k, m, tolerance);
      double least = GSL_POSINF, mean = 0;
      uint64_t contacts = 0, none = 0, centres = 0;
      for (size_t i = 0; i < pack->n; i++) {
        if (pack_kind(pack, i) != k)
          continue;
        double gap = GSL_POSINF;
        uint64_t touch = 0;
        for (size_t j = 0; j < pack->n; j++)
          for (int image = 0; image < (dim == 2 ? 9 : 27); image++) {
            if (pack_kind(pack, j) != m || (i == j && image == 0))
              continue;
            double square = 0;
            int shift[3] = {image % 3, image / 3 % 3, image / 9};
            for (size_t x = 0; x < dim; x++)
              square += gsl_pow_2(pack->x[j * dim + x] - pack->x[i * dim + x] +
                                  (shift[x] == 2 ? -1 : shift[x]) *
                                      pack->box.side[x]);
            double both = pack_radius(pack, i) + pack_radius(pack, j);
            gap = GSL_MIN(gap, sqrt(square) - both);
            touch += sqrt(square) - both <= tolerance * both;
          }
        least = GSL_MIN(least, gap);
        mean += gap;
        contacts += touch;
        none += touch == 0;
        centres++;
      }
      all = GSL_MIN(all, near.least);
      mean = centres ? mean / (double)centres : GSL_POSINF;
      bool found = gsl_finite(mean);
      gsl_test(found ? !(fabs(near.least - least) < 1e-12) : near.least < least,
               "%s: least gap of %d %d: %g", what, k, m, near.least);
      gsl_test(found ? !(fabs(near.nearest - mean) < 1e-12)
                     : near.nearest < mean,
               "%s: nearest gap of %d %d: %g", what, k, m, near.nearest);
      gsl_test(found && (near.contacts != contacts || near.none != none),
               "%s: contacts of %d with %d: %llu", what, k, m,
               (unsigned long long)contacts);
      gsl_test(near.contacts != partials_near(p, m, k, tolerance).contacts,
               "%s: contacts of %d %d from both ends", what, k, m);
    }
  double audit = pack_audit(pack);
  gsl_test(pack->n > 0 && !(fabs(all - audit) < 1e-12), "%s: the audit", what);
  partials_free(&p);
}

static void test_exact(void) {
  static const double boxes[][3] = {
      {7.31, 7.31, 7.31}, {2.917, 6.41, 9.2}, {27.4, 1.37, 1.37}};
  static const size_t counts[][3] = {
      {300, 40, 90}, {400, 1, 0}, {1, 1, 2}, {0, 0, 250}, {0, 0, 0}};
  char what[80];
  for (int dim = 2; dim <= 3; dim++)
    for (int b = 0; b < 3; b++)
      for (int c = 0; c < 5; c++) {
        Species s[3] = {{"a", 0.01, counts[c][0]},
                        {"b", 0.02, counts[c][1]},
                        {"c", 0.1, counts[c][2]}};
        snprintf(what, sizeof what, "%d-D box %d case %d", dim, b, c);
        Pack *pack = uniform(dim, boxes[b], s, 3, c == 1, 7);
        exact(what, pack);
        if (pack->n > 3 && c != 1)
          sums(what, pack);
        if (b == 0 || c > 0)
          nearest(what, pack, 0.5);
        pack_free(&pack);
      }
}

/* Random points: g = 1 within the error of Poisson counts. */
static void test_uniform(void) {
  const int P = as_many(15, 30);
  Species s[2] = {{"a", 0.01, 30}, {"b", 0.001, 700}};
  double side[3] = {1, 1.3, 1.1}, sum[3] = {0}, expect[3] = {0};
  for (int dim = 2; dim <= 3; dim++)
    for (uint64_t r = 0; r < (uint64_t)P; r++) {
      Pack *pack = uniform(dim, side, s, 2, false, 100 + r);
      Partials *p = partials_alloc(pack, BINS, 0.012, PARTIALS_R);
      partials_count(p);
      for (int i = 0; i < 3; i++) {
        int k = i / 2, m = (i + 1) / 2;
        PartialsPair *pair = partials_pair(p, k, m);
        double g[BINS], end = pair->origin + BINS * pair->step;
        partials_g(p, k, m, g);
        for (int b = 0; b < BINS; b++) {
          double q = pair->origin + b * pair->step;
          double weight = partials_pairs(p, k, m) *
                          pairs_shell(dim, q, q + pair->step) / p->volume;
          sum[i] += weight * g[b];
        }
        expect[i] += partials_pairs(p, k, m) *
                     pairs_shell(dim, pair->origin, end) / p->volume;
      }
      partials_free(&p);
      pack_free(&pack);
    }
  for (int i = 0; i < 3; i++)
    gsl_test(!(fabs(sum[i] - expect[i]) < 4 * sqrt(expect[i])),
             "uniform points: g = 1 of pair %d, %.4f", i, sum[i] / expect[i]);
}

static void test_scales(void) {
  Species s[2] = {{"a", 1, 20}, {"b", 0.313, 60}};
  double side[3] = {9, 9, 9}, r[BINS], n[BINS], back[BINS];
  Pack *pack = uniform(3, side, s, 2, false, 3);
  Partials *p = partials_alloc(pack, BINS, 0.02, PARTIALS_COMMON);
  partials_count(p);
  double R12 = partials_scale(p, 0, 1, PARTIALS_SOURCE, 1.313 + 0.1);
  double R21 = partials_scale(p, 1, 0, PARTIALS_SOURCE, 1.313 + 0.1);
  gsl_test_rel(R12, 2 + 0.1 / 0.313, 1e-14, "R_12");
  gsl_test_rel(R21, 2 + 0.1, 1e-14, "R_21 is another");
  double e12 = cos(M_PI * R12) * exp(2 * (2 - R12));
  double e21 = cos(M_PI * R21) * exp(2 * (2 - R21));
  gsl_test(!(fabs(e12 - e21) > 0.4), "B (20) is not symmetric: %g %g", e12,
           e21);
  gsl_test_rel(partials_scale(p, 0, 1, PARTIALS_COMMON, 1.313), 1, 1e-15,
               "contact is 1");
  partials_r(p, 0, 1, PARTIALS_R, r);
  for (int b = 0; b < BINS; b++) {
    double from = 1.313 * (1 + 0.02 * b), to = from + 0.02 * 1.313;
    double mean = 0.75 * (gsl_pow_4(to) - gsl_pow_4(from)) /
                  (gsl_pow_3(to) - gsl_pow_3(from));
    gsl_test_rel(r[b], mean, 1e-12, "mean distance of a shell");
  }
  partials_number(p, 0, 1, n);
  partials_number(p, 1, 0, back);
  double K[BINS];
  partials_K(p, 0, 1, K);
  for (int b = 0; b < BINS; b++) {
    gsl_test_rel(n[b] * 20, back[b] * 60, 1e-13, "N_k n_km = N_m n_mk");
    gsl_test_rel(n[b], K[b] * 60 / 729, 1e-13, "n_km = rho_m K_km");
  }
  partials_number(p, 0, 0, n);
  partials_K(p, 0, 0, K);
  for (int b = 0; b < BINS; b++)
    gsl_test_rel(n[b], K[b] * 19 / 729, 1e-13, "n_kk");
  partials_free(&p);
  pack_free(&pack);
}

/* Draw again whoever overlaps one before him. */
static void thin(Pack *pack, uint64_t seed) {
  size_t dim = (size_t)pack->box.dim;
  Rng rng = rng_stream(seed, 1, RNG_TEST);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = 0; j < i; j++)
      if (apart(pack, i, j) < pack_radius(pack, i) + pack_radius(pack, j)) {
        for (size_t k = 0; k < dim; k++)
          pack->x[i * dim + k] = pack->box.side[k] * rng_uniform(&rng);
        j = (size_t)-1;
      }
}

/* One species: contact_value. Dilute packs of two: 1 each. */
static void test_contact(int dim) {
  double side[3] = {21, 20, 23};
  Species s[2] = {{"a", 0.25, 3000}, {"b", 0.25, 1000}};
  s[0].count = dim == 2 ? 600 : 6000;
  Pack *pack = uniform(dim, side, s, 1, false, 5);
  Partials *p = partials_alloc(pack, 1, 1, PARTIALS_COMMON);
  Contact one = contact_value(pack, 0.5, CONTACT_DEGREE, 0);
  Contact same = partials_contact(p, 0, 0, CONTACT_DEGREE);
  gsl_test(!(one.value > 0), "%d-D contact %g", dim, one.value);
  gsl_test_rel(same.value, one.value, 1e-11, "%d-D: that of one species", dim);
  gsl_test_rel(same.error, one.error, 1e-11, "%d-D: its error", dim);
  gsl_test(same.window != one.window || same.pairs != one.pairs,
           "%d-D: window %g and pairs of one species", dim, one.window);
  partials_free(&p);
  pack_free(&pack);
  double mean[3] = {0}, square[3] = {0}, error[3] = {0}, P = as_many(dim == 2 ? 40 : 20, 40);
  s[0].radius = s[1].radius = dim == 2 ? 0.05 : 0.15;
  s[0].count = dim == 2 ? 300 : 900, s[1].count = dim == 2 ? 200 : 500;
  for (uint64_t r = 0; r < (uint64_t)P; r++) {
    pack = uniform(dim, side, s, 2, false, 900 + r);
    thin(pack, 900 + r);
    p = partials_alloc(pack, 1, 1, PARTIALS_COMMON);
    for (int i = 0; i < 3; i++) {
      Contact c = partials_contact(p, i / 2, (i + 1) / 2, CONTACT_DEGREE);
      mean[i] += c.value / P;
      square[i] += c.value * c.value / P;
      error[i] += c.error * c.error / P;
    }
    partials_free(&p);
    pack_free(&pack);
  }
  for (int i = 0; i < 3; i++) {
    double se = sqrt((square[i] - mean[i] * mean[i]) / (P - 1));
    gsl_test_abs(mean[i], 1, 4 * se, "%d-D: contact of points, se %g", dim, se);
    gsl_test_rel(sqrt(error[i] / P), se, 0.4, "%d-D: its error", dim);
  }
}

/* One row of small spheres on a large one, at a known distance each. */
static void test_ratio(void) {
  Species s[3] = {{"L", 10, 12}, {"S", 0.1, 900}, {"none", 3, 0}};
  double side[3] = {60, 60, 60};
  Pack *pack = uniform(3, side, s, 3, false, 12);
  exact("ratio 100", pack);
  nearest("ratio 100", pack, 0.1);
  Partials *p = partials_alloc(pack, 1, 1, PARTIALS_COMMON);
  Contact none = partials_contact(p, 0, 2, CONTACT_DEGREE);
  gsl_test(none.value != 0 || none.error != 0, "no contact value of nobody");
  gsl_test(!(partials_contact(p, 0, 1, CONTACT_DEGREE).window <= 0.5 * .1 / 10),
           "the window is of the small");
  partials_free(&p);
  /* the small in a cluster that is seen at once, but for a nearer one */
  const double clump[] = {30, 30, 54}, near[] = {19.9, 19.9, 30.1};
  size_t first[2] = {pack->n, pack->n};
  for (size_t i = pack->n; i-- > 0;) {
    first[pack_kind(pack, i)] = i;
    for (size_t k = 0; k < 3 && pack_kind(pack, i) == 1; k++)
      pack->x[3 * i + k] = clump[k] + pack->x[3 * i + k] / 12;
  }
  for (size_t k = 0; k < 3; k++) {
    pack->x[3 * first[0] + k] = 30.1;
    pack->x[3 * first[1] + k] = near[k];
  }
  nearest("a cluster", pack, 0.1);
  pack_free(&pack);
}

enum { WIDE = 17 };

static double from_middle(const Pack *pack, size_t i) {
  double square = 0;
  size_t dim = (size_t)pack->box.dim;
  for (size_t k = 0; k < dim; k++)
    square += gsl_pow_2(pack->x[i * dim + k] - WIDE / 2.);
  return sqrt(square);
}

/* A finite cloud: points of a ball of radius 4, denser in the middle if falls
   is above 0, and species the more so the later they come in the list. */
static Pack *cloud(int dim, const Species species[], int kinds, bool own,
                   double falls, uint64_t seed) {
  static const double side[3] = {WIDE, WIDE, WIDE};
  Pack *pack = uniform(dim, side, species, kinds, own, seed);
  Rng rng = rng_stream(seed, 2, RNG_TEST);
  for (size_t i = 0; i < pack->n; i++)
    do
      for (size_t k = 0; k < (size_t)dim; k++)
        pack->x[i * (size_t)dim + k] =
            WIDE / 2. + 4 * (2 * rng_uniform(&rng) - 1);
    while (from_middle(pack, i) > 4 ||
           rng_uniform(&rng) <
               falls * from_middle(pack, i) / 4 / (1 + pack_kind(pack, i)));
  pack->open = 4;
  return pack;
}

/* Ordered pairs from those of k at most core from the middle to those of m in
   another pack, which may be the same: place 0 for what is below. */
static size_t slow_end(const Pack *pack, const Pack *other, int k, int m,
                       double core, const PartialsPair *pair, double weight,
                       double found[]) {
  size_t dim = (size_t)pack->box.dim, centres = 0;
  for (size_t i = 0; i < pack->n; i++) {
    bool centre = pack_kind(pack, i) == k && from_middle(pack, i) <= core;
    centres += centre;
    for (size_t j = 0; centre && j < other->n; j++) {
      double square = 0;
      for (size_t x = 0; x < dim; x++)
        square += gsl_pow_2(other->x[j * dim + x] - pack->x[i * dim + x]);
      double place = (sqrt(square) - pair->origin) / pair->step + 1e-9;
      if (pack_kind(other, j) == m && (other != pack || i != j) &&
          place < (double)pair->bins)
        found[place < 0 ? 0 : 1 + (int)place] += weight;
    }
  }
  return centres;
}

/* The same of the pack and of the pack turned. */
static size_t slow_ends(const Pack *pack, int k, int m, double core,
                        const PartialsPair *pair, double found[],
                        double expect[]) {
  double within = core - (pair->origin + (double)pair->bins * pair->step);
  int turns = core_turns(pack->box.dim);
  memset(found, 0, (BINS + 1) * sizeof *found);
  memset(expect, 0, (BINS + 1) * sizeof *expect);
  for (int t = 0; t < turns; t++) {
    Pack *turned = core_turned(pack, t);
    slow_end(pack, turned, k, m, within, pair, 1. / turns, expect);
    pack_free(&turned);
  }
  return slow_end(pack, pack, k, m, within, pair, 1, found);
}

static double off(double a, double b) {
  return fabs(a - b) / (1 + fabs(b));
}

/* g of both ends, K its sum over volumes, numbers of one end. */
static void core_curves(const char *what, const Pack *pack, Partials *p, int k,
                        int m) {
  PartialsPair *pair = partials_pair(p, k, m);
  double one[BINS + 1], two[BINS + 1], e_one[BINS + 1], e_two[BINS + 1];
  double g[BINS], K[BINS], n[BINS], worst[3] = {0}, sum = 0, within = 0, r = 0;
  size_t centres = slow_ends(pack, k, m, p->core, pair, one, e_one);
  slow_ends(pack, m, k, p->core, pair, two, e_two);
  partials_g(p, k, m, g);
  partials_K(p, k, m, K);
  partials_number(p, k, m, n);
  for (size_t b = 0; b <= pair->bins; b++) {
    double found = one[b] + two[b], expect = e_one[b] + e_two[b];
    double ratio = expect > 1e-9 ? found / expect : 0;
    double to = pair->origin + (double)b * pair->step;
    sum += ratio * pairs_shell(p->dim, r, to);
    within += centres ? one[b] / (double)centres : 0;
    r = to;
    if (b == 0)
      continue;
    worst[0] = GSL_MAX(worst[0], off(g[b - 1], ratio));
    worst[1] = GSL_MAX(worst[1], off(K[b - 1], sum));
    worst[2] = GSL_MAX(worst[2], off(n[b - 1], within));
  }
  gsl_test(pair->end[k > m].centres != centres, "%s: %zu centres of %d for %d",
           what, centres, k, m);
  gsl_test(!(worst[0] < 1e-12), "%s: g of a core, %d %d: two loops", what, k,
           m);
  gsl_test(!(worst[1] < 1e-12), "%s: K of a core, %d %d", what, k, m);
  gsl_test(!(worst[2] < 1e-12), "%s: numbers of a core, %d about %d", what, m,
           k);
}

/* Contacts and nearest of those who see enough, in a pack without images. */
static void core_near(const char *what, const Pack *pack, const Partials *p,
                      int k, int m) {
  enum { TOLERANCE = 1 };
  const PartialsPair *pair = partials_pair(p, k, m);
  PartialsNear near = partials_near(p, k, m, TOLERANCE);
  double reach = pair->origin + (double)pair->bins * pair->step;
  double wide = (1 + TOLERANCE) * 2 * pack_largest(pack), nearest = 0;
  double touch = 0, least = GSL_POSINF;
  size_t toucher = 0, seer = 0, dim = (size_t)pack->box.dim;
  for (size_t i = 0; i < pack->n; i++) {
    double gap = GSL_POSINF, touches = 0;
    for (size_t j = 0; pack_kind(pack, i) == k && j < pack->n; j++) {
      double both = pack_radius(pack, i) + pack_radius(pack, j), square = 0;
      for (size_t x = 0; x < dim; x++)
        square += gsl_pow_2(pack->x[j * dim + x] - pack->x[i * dim + x]);
      if (pack_kind(pack, j) != m || i == j)
        continue;
      gap = GSL_MIN(gap, sqrt(square) - both);
      touches += sqrt(square) - both <= TOLERANCE * both;
    }
    bool own = pack_kind(pack, i) == k;
    bool sees = own && from_middle(pack, i) <= p->core - reach;
    bool contact = own && from_middle(pack, i) <= p->core - wide;
    least = GSL_MIN(least, gap);
    touch += contact ? touches : 0;
    toucher += contact;
    nearest += sees ? gap : 0;
    seer += sees;
  }
  if (!gsl_finite(least)) {
    gsl_test(near.nearest < least || near.mean != 0, "%s: none near %d", what,
             k);
    return;
  }
  gsl_test(!(off(near.least, least) < 1e-12), "%s: least gap of a core", what);
  gsl_test(near.centres != toucher || (double)near.contacts != touch ||
               !(off(near.mean * (double)toucher, touch) < 1e-12),
           "%s: %g contacts of a core, %d with %d", what, touch, k, m);
  gsl_test(!(off(near.nearest * (double)seer, nearest) < 1e-12) ||
               (seer == 0 && near.nearest != 0),
           "%s: nearest of a core, %d to %d", what, k, m);
}

/* Each pair with a reach of its own; some leave no centre. */
static void test_core(int dim) {
  static const size_t counts[][3] = {{250, 30, 80}, {300, 1, 0}, {1, 0, 120}};
  char what[80];
  for (int c = 0; c < 6; c++) {
    Species s[3] = {{"a", 0.1, counts[c / 2][0]},
                    {"b", 0.2, counts[c / 2][1]},
                    {"c", 0.4, counts[c / 2][2]}};
    snprintf(what, sizeof what, "%d-D cloud %d", dim, c);
    Pack *pack = cloud(dim, s, 3, c % 2, 0.9, 50 + (uint64_t)c);
    Partials *p = partials_alloc(pack, BINS, 1, PARTIALS_R);
    p->core = 3.7;
    for (int k = 0; k < 3; k++)
      for (int m = 0; m <= k; m++) {
        PartialsPair *pair = partials_pair(p, k, m);
        pair->bins = 15 + (size_t)m;
        pair->step = k + m == 3 ? 0.25 : 0.04 + 0.03 * k;
      }
    for (int turn = 0; turn < 2; turn++)
      partials_count(p); /* anew, not in addition */
    for (int k = 0; k < 3; k++)
      for (int m = 0; m < 3; m++) {
        core_curves(what, pack, p, k, m);
        core_near(what, pack, p, k, m);
      }
    partials_free(&p);
    pack_free(&pack);
  }
}

/* With the same bins for all: all numbers about all centres are those of the
   pack, and one species alone is the pack, to the last pair. */
static void test_core_sums(int dim) {
  Species s[3] = {{"a", 0.1, 350}, {"b", 0.1, 40}, {"c", 0.1, 90}};
  double expect[BINS], n[BINS], sum[BINS] = {0}, step = 0.045, worst[3] = {0};
  Pack *pack = cloud(dim, s, 3, false, 0.9, 71), *one = pack_copy(pack);
  bool *of = memory(pack->n, sizeof *of);
  uint64_t count[BINS];
  Partials *p = partials_alloc(pack, BINS, step, PARTIALS_R);
  p->core = 3.9;
  partials_count(p);
  core_within(pack, 3.9 - (0.2 + BINS * step), of);
  double below =
      (double)pairs_count_around(pack, of, 0.2, step, BINS, count);
  pairs_expect_around(pack, of, 0.2, step, BINS, expect);
  for (int k = 0; k < 3; k++)
    for (int m = 0; m < 3; m++) {
      partials_number(p, k, m, n);
      for (int b = 0; b < BINS; b++)
        sum[b] += n[b] * (double)partials_pair(p, k, m)->end[k > m].centres;
    }
  memset(one->kind, 0, one->n * sizeof *one->kind);
  Partials *q = partials_alloc(one, BINS, step, PARTIALS_R);
  q->core = 3.9;
  partials_count(q);
  const PartialsEnd *end = &partials_pair(q, 0, 0)->end[0];
  for (int b = 0; b < BINS; b++) {
    below += (double)count[b];
    worst[0] = GSL_MAX(worst[0], off(sum[b], below));
    worst[1] = GSL_MAX(worst[1], fabs(end->found[b + 1] - (double)count[b]));
    worst[2] = GSL_MAX(worst[2], fabs(end->expect[b + 1] - expect[b]));
  }
  gsl_test(!(worst[0] < 1e-12 && below > 500),
           "%d-D: numbers about all species add up to the pack", dim);
  gsl_test(worst[1] != 0, "%d-D: one species is counted as the pack", dim);
  gsl_test(worst[2] != 0, "%d-D: and expected as the pack (%g)", dim,
           worst[2]);
  partials_free(&p);
  partials_free(&q);
  pack_free(&one);
  pack_free(&pack);
  free(of);
}

/* Pairs of centres with their own images in the turned pack. */
static void own_images(const Pack *pack, int k, const PartialsPair *pair,
                       double core, double own[]) {
  size_t dim = (size_t)pack->box.dim;
  int turns = core_turns(pack->box.dim);
  double reach = pair->origin + (double)pair->bins * pair->step;
  for (int t = 0; t < turns; t++) {
    Pack *turned = core_turned(pack, t);
    for (size_t i = 0; i < pack->n; i++) {
      double square = 0;
      for (size_t x = 0; x < dim; x++)
        square += gsl_pow_2(turned->x[i * dim + x] - pack->x[i * dim + x]);
      double place = (sqrt(square) - pair->origin) / pair->step;
      if (pack_kind(pack, i) == k && from_middle(pack, i) <= core - reach &&
          place >= 0 && place < (double)pair->bins)
        own[(size_t)place] += 1. / turns;
    }
    pack_free(&turned);
  }
}

/* Points of two Poisson processes whose densities fall outwards, each in its own
   way: g is 1 but for the images of the centres themselves. */
static void test_core_points(int dim) {
  enum { FEW = 6 };
  const int P = as_many(40, 80);
  double g[3][FEW] = {{0}}, more[3][FEW] = {{0}}, square[3][FEW] = {{0}};
  double due[3][FEW] = {{0}};
  gsl_rng *rng = rng_gsl_alloc(rng_stream(47, (uint64_t)dim, RNG_TEST));
  for (uint64_t r = 0; r < (uint64_t)P; r++) {
    Species s[2] = {{"a", 0.01, gsl_ran_poisson(rng, 250)},
                    {"b", 0.02, gsl_ran_poisson(rng, 120)}};
    Pack *pack = cloud(dim, s, 2, false, 0.9, 300 + r);
    Partials *p = partials_alloc(pack, FEW, 0.25, PARTIALS_R);
    p->core = 4;
    partials_count(p);
    for (int i = 0; i < 3; i++) {
      int k = i / 2, m = (i + 1) / 2;
      const PartialsPair *pair = partials_pair(p, k, m);
      double own[FEW] = {0};
      if (k == m)
        own_images(pack, k, pair, 4, own);
      for (int b = 0; b < FEW; b++) {
        double found = 0, expect = -own[b];
        for (int e = 0; e < (k == m ? 1 : 2); e++) {
          found += pair->end[e].found[b + 1];
          expect += pair->end[e].expect[b + 1];
        }
        more[i][b] += (found - expect) / P;
        square[i][b] += gsl_pow_2(found - expect) / P;
        due[i][b] += expect / P;
      }
    }
    partials_free(&p);
    pack_free(&pack);
  }
  for (int i = 0; i < 3; i++) {
    double worst = 0, least = GSL_POSINF;
    for (int b = 0; b < FEW; b++) {
      double se = sqrt((square[i][b] - gsl_pow_2(more[i][b])) / (P - 1));
      g[i][b] = 1 + more[i][b] / due[i][b];
      worst = GSL_MAX(worst, fabs(more[i][b]) / se);
      least = GSL_MIN(least, due[i][b] * P);
    }
    gsl_test(!(worst < 3.5 && least > 1.25 * P),
             "%d-D: g = 1 of points in a ball, pair %d (%.2f se, g %.3f)", dim,
             i, worst, g[i][FEW - 1]);
  }
  gsl_rng_free(rng);
}

int main(void) {
  for (int dim = 2; dim <= 3; dim++) {
    test_core(dim);
    test_core_sums(dim);
    test_core_points(dim);
  }
  test_exact();
  test_uniform();
  test_scales();
  test_contact(2);
  test_contact(3);
  test_ratio();
  return gsl_test_summary();
}
