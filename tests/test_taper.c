/* tests/test_taper.c: the definition by a slow program; points of a falling density; pairs of points, whose S is known; errors */
#include "many.h"
#include "scatter.h"
#include "taper.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static const double j0_zero = 2.404825557695773;
static double mean_wave(int dim, double t) { return dim == 2 ? gsl_sf_bessel_J0(t) : t > 0 ? sin(t) / t : 1; }
static double window(int dim, double part) { return part < 1 ? mean_wave(dim, part * (dim == 3 ? M_PI : j0_zero)) : 0; }

/* A point of the ball of radius 1 about 0: uniform, or denser in the middle. */
static void in_ball(int dim, bool falling, Rng *rng, double x[3]) {
  double square;
  do {
    rng_in_ball(rng, dim, 1, x);
    square = x[0] * x[0] + x[1] * x[1] + (dim == 3 ? x[2] * x[2] : 0);
  } while (falling && rng_uniform(rng) > 1 - square);
}

/* Sums over all vectors of the cube, in one place and then another of the box. */
static void test_plain(int dim) {
  Species species[] = {{.name = "A", .radius = 0.1, .count = 7}, {.name = "B", .radius = 0.2, .count = 5}};
  Box box = {dim, {40, 50, dim == 3 ? 60 : 0}};
  Pack *pack = pack_alloc(&box, species, 2, false);
  Rng rng = rng_stream(341, (uint64_t)dim, RNG_TEST);
  double R = 3, reach = 5, worst = 0, at[12][3] = {{0}};
  for (size_t i = 0; i < 12; i++) {
    in_ball(dim, false, &rng, at[i]);
    for (int d = 0; d < dim; d++) {
      at[i][d] *= i % 4 ? R : 1.4 * R; /* some beyond */
      pack->x[i * (size_t)dim + (size_t)d] = box.side[d] / 2 + at[i][d];
    }
  }
  Tapered *t = taper_structure(pack, R, reach, 0.1, 0);
  size_t n = 0, pairs = 0;
  int end = (int)(reach * R / M_PI) + 1;
  for (int a = 0; a <= end; a++)
    for (int b = -end; b <= end; b++)
      for (int c = dim == 3 ? -end : 0; c <= (dim == 3 ? end : 0); c++) {
        const double k[] = {M_PI / R * a, M_PI / R * b, M_PI / R * c};
        double length = sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]), D[2][2] = {{0}}, M[2] = {0}, best = 1e9;
        if (a == 0 && (b < 0 || (b == 0 && c <= 0)))
          continue;
        if (a * a + b * b + c * c < 4 || length >= reach)
          continue;
        for (size_t i = 0; i < 12; i++) {
          double r = sqrt(at[i][0] * at[i][0] + at[i][1] * at[i][1] + at[i][2] * at[i][2]), h = window(dim, r / R), m = mean_wave(dim, length * r);
          double phase = k[0] * at[i][0] + k[1] * at[i][1] + k[2] * at[i][2];
          D[i > 6][0] += h * (cos(phase) - m), D[i > 6][1] += h * sin(phase), M[i > 6] += h * h * (1 - m * m);
        }
        double re = D[0][0] + D[1][0], im = D[0][1] + D[1][1], S = (re * re + im * im) / (M[0] + M[1]);
        double cross = (D[0][0] * D[1][0] + D[0][1] * D[1][1]) / sqrt(M[0] * M[1]);
        for (size_t v = 0; v < t->n; v++) /* one of the vectors of this length is it */
          if (fabs(t->k[v] - length) < 1e-9)
            best = GSL_MIN(best, GSL_MAX(fabs(t->S[v] - S), fabs(t->pair[t->n + v] - cross)));
        worst = GSL_MAX(worst, best);
        n++;
      }
  gsl_test_int((int)t->n, (int)n, "%d-D, vectors from 2 pi / R on", dim);
  gsl_test(!(worst < 1e-11), "%d-D, by the definition: %g", dim, worst);
  for (size_t v = 0; v < t->n; v++)
    pairs += !(t->pair[v] >= 0 && t->pair[2 * t->n + v] >= 0);
  gsl_test_int((int)pairs, 0, "%d-D, S of one species is no less than 0", dim);
  taper_free(&t);
  pack_free(&pack);
}

/* Points in independent directions, their density falling to nothing at the rim: S is 1 and between species 0, at each k; the error is
   the scatter of packs. */
static void test_points(int dim, bool falling) {
  enum { BINS = 6 };
  Species species[] = {{.name = "A", .radius = 0.1, .count = falling ? 1500 : 60}, {.name = "B", .radius = 0.2, .count = falling ? 700 : 30}};
  Box box = {dim, {40, 40, dim == 3 ? 40 : 0}};
  Rng rng = rng_stream(342, (uint64_t)(2 * dim + falling), RNG_TEST);
  int packs = as_many(60, 1500);
  double R = 3, reach = 14, from = 2 * M_PI / R, step = (reach - from) / BINS, sum[2][BINS] = {{0}}, square[2][BINS] = {{0}}, all = 0, all2 = 0;
  size_t n = 0;
  for (int p = 0; p < packs; p++) {
    Pack *pack = pack_alloc(&box, species, 2, false);
    double mean[2][BINS] = {{0}}, count[BINS] = {0}, whole = 0;
    for (size_t i = 0; i < pack->n; i++) {
      double x[3] = {0};
      in_ball(dim, falling, &rng, x);
      for (int d = 0; d < dim; d++)
        pack->x[i * (size_t)dim + (size_t)d] = 20 + R * x[d];
    }
    Tapered *t = taper_structure(pack, R, reach, 0.1, 0);
    for (size_t v = 0; v < t->n; v++) {
      int b = GSL_MIN((int)((t->k[v] - from) / step), BINS - 1);
      mean[0][b] += t->S[v], mean[1][b] += t->pair[t->n + v], count[b]++;
      whole += t->S[v] / (double)t->n;
    }
    n = t->n;
    all += whole, all2 += whole * whole;
    for (int b = 0; b < BINS; b++)
      for (int q = 0; q < 2; q++) {
        double one = mean[q][b] / count[b];
        sum[q][b] += one, square[q][b] += one * one;
      }
    taper_free(&t);
    pack_free(&pack);
  }
  for (int b = 0; b < BINS; b++)
    for (int q = 0; q < 2; q++) {
      double mean = sum[q][b] / packs, error = sqrt((square[q][b] / packs - mean * mean) / (packs - 1));
      gsl_test_abs(mean, q ? 0 : 1, 4 * error, "%d-D, %s points, %s in bin %d", dim, falling ? "falling" : "uniform", q ? "S of two species" : "S", b);
    }
  /* The mean of all vectors has the scatter that is told, and less than a few points make: one part in their number. */
  double spread = sqrt((all2 / packs - gsl_pow_2(all / packs)) * (double)n), most = taper_excess(dim);
  if (!falling)
    gsl_test(!(spread < 1.25 * most && spread > 0.6 * most), "%d-D, scatter of a mean, in errors of independent vectors: %g, at most %g", dim, spread, most);
}

/* c(b): the mean over the ball of h(x) h(x + b), by that of h^2, from many points. */
static double seen(int dim, double b, double *excess) {
  enum { M = 500 };
  double both = 0, own = 0, fourth = 0;
  for (int i = 0; i < M; i++)
    for (int j = 0; j < M; j++) {
      double r = (i + 0.5) / M, angle = M_PI * (j + 0.5) / M, weight = dim == 3 ? r * r * sin(angle) : r, h = window(dim, r);
      both += weight * h * window(dim, sqrt(r * r + b * b + 2 * r * b * cos(angle)));
      own += weight * h * h;
      fourth += weight * h * h * h * h;
    }
  double by = (dim == 3 ? 2 * M_PI : 2) * M_PI / ((double)M * M); /* of an integral over the ball */
  *excess = sqrt((dim == 3 ? 8 : 4) * fourth * by / gsl_pow_2(own * by));
  return both / own;
}

/* Pairs of points, thrown over more than the core: S = 1 + c(b) m(kb). */
static void test_pairs(int dim) {
  enum { BINS = 10 };
  double R = dim == 3 ? 2.5 : 4, b = 0.5, wide = 2 * R + 4 * b, density = dim == 3 ? 3 : 4, excess, c = seen(dim, b / R, &excess);
  size_t n = (size_t)(density * pow(wide, dim) / 2);
  Species species = {.name = "A", .radius = 0.1, .count = 2 * n};
  Box box = {dim, {40, 40, dim == 3 ? 40 : 0}};
  Rng rng = rng_stream(343, (uint64_t)dim, RNG_TEST);
  int packs = as_many(60, 1500);
  double reach = 16, from = 2 * M_PI / R, step = (reach - from) / BINS, sum[BINS] = {0}, square[BINS] = {0}, want[BINS] = {0}, far = 0, plain = 0;
  gsl_test_rel(taper_excess(dim), excess, 1e-4, "%d-D, the excess of the error", dim);
  gsl_test_abs(c, 1 - b * b / (2 * dim) * gsl_pow_2((dim == 3 ? M_PI : j0_zero) / R), 0.1 * (1 - c), "%d-D, the bias to leading order", dim);
  for (int p = 0; p < packs; p++) {
    Pack *pack = pack_alloc(&box, &species, 1, false);
    double mean[BINS] = {0}, count[BINS] = {0}, law[BINS] = {0};
    for (size_t i = 0; i < n; i++) {
      double u[3];
      rng_direction(&rng, dim, u);
      for (int d = 0; d < dim; d++) {
        double x = 20 + wide * (rng_uniform(&rng) - 0.5);
        pack->x[2 * i * (size_t)dim + (size_t)d] = x - 0.5 * b * u[d];
        pack->x[(2 * i + 1) * (size_t)dim + (size_t)d] = x + 0.5 * b * u[d];
      }
    }
    Tapered *t = taper_structure(pack, R, reach, step, 0);
    for (size_t v = 0; v < t->n; v++) {
      int at = GSL_MIN((int)((t->k[v] - from) / step), BINS - 1);
      mean[at] += t->S[v], count[at]++, law[at] += 1 + c * mean_wave(dim, t->k[v] * b);
    }
    for (int at = 0; at < BINS; at++) {
      sum[at] += mean[at] / count[at], square[at] += gsl_pow_2(mean[at] / count[at]);
      want[at] = law[at] / count[at];
    }
    taper_free(&t);
    pack_free(&pack);
  }
  for (int at = 0; at < BINS; at++) {
    double mean = sum[at] / packs, error = sqrt((square[at] / packs - mean * mean) / (packs - 1));
    gsl_test_abs(mean, want[at], 4 * error, "%d-D, pairs of points, bin %d, error %g", dim, at, error);
    far += gsl_pow_2((mean - want[at]) / error) / BINS;
    plain = GSL_MAX(plain, fabs(want[at] - 1));
  }
  gsl_test(!(far < 3.2 && plain > 0.2), "%d-D, all of them: %g", dim, far);
}

static void test_few(void) {
  Box box = {3, {40, 40, 40}};
  Species species[] = {{.name = "A", .radius = 1, .count = 1}, {.name = "B", .radius = 1, .count = 0}};
  Pack *pack = pack_alloc(&box, species, 2, false);
  for (int d = 0; d < 3; d++)
    pack->x[d] = 20;
  Tapered *t = taper_structure(pack, 5, 3, 0.1, 0);
  gsl_test(!(t->n > 10 && gsl_isnan(t->S[0]) && gsl_isnan(t->pair[2 * t->n])), "one particle in the middle has no S, nor has a species of none");
  taper_free(&t);
  gsl_test(t != NULL, "freed");
  gsl_test_abs(taper_at(3, 1), 0, 0, "the window ends");
  gsl_test_abs(taper_at(2, 0), 1, 0, "and begins");
  gsl_test_abs(taper_at(2, 1 - 1e-9), 0, 1e-8, "and meets its end");
  gsl_test_abs(taper_at(3, 0.5), 2 / M_PI, 1e-15, "half way");
  pack_free(&pack);
}

int main(void) {
  test_few();
  for (int dim = 2; dim <= 3; dim++) {
    test_plain(dim);
    test_points(dim, false);
    test_points(dim, true);
    test_pairs(dim);
  }
  return gsl_test_summary();
}
