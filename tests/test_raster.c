/* tests/test_raster.c: points by a plain search, counts by plain sums, means of what is linear */
#include "cover.h"
#include "many.h"
#include "raster.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static Pack *few(int dim, size_t n, double a, double b, double c, Rng *rng) {
  Box box = {dim, {a, b, dim == 3 ? c : 0}};
  return two_kinds(&box, n, 0.9, 1.7, dim == 2, rng);
}

static void test_by_hand(void) {
  Species species = {.name = "P", .radius = 1, .count = 1};
  Box box = {2, {4, 4, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  pack->x[0] = pack->x[1] = 2;
  Raster *raster = raster_make(pack, (const int[]){4, 4});
  double *count = raster_correlate(raster, RASTER_PARTICLES, RASTER_PARTICLES), sum = 0;
  for (int k = 0; k < 16; k++)
    sum += count[k];
  gsl_test(count[0] != 4 || count[1] != 2 || count[4] != 2 || count[5] != 1 || count[2] != 0 || sum != 16,
           "a disc on four points: its counts");
  free(count);
  raster_free(&raster);
  raster_free(&raster);
  gsl_test(raster != NULL, "freed twice");
  pack_free(&pack);
}

/* In the plane against cover_lattice; in space against all images of all balls. */
static void test_points(void) {
  Rng rng = rng_stream(16, 0, RNG_TEST);
  int bad = 0, differ = 0;
  for (int k = 0; k < as_many(20, 200); k++) {
    Pack *pack = few(2, 1 + (size_t)k % 9, 5 + 4 * rng_uniform(&rng), 3 + 4 * rng_uniform(&rng), 0, &rng);
    int n[] = {37 + k, 52 - k % 3};
    Raster *raster = raster_make(pack, n);
    Body *bodies = cover_bodies(pack);
    bad += raster_count(raster, RASTER_PARTICLES) != cover_lattice(bodies, pack->n, &pack->box, n[0], n[1]);
    bad += raster_count(raster, RASTER_PARTICLES) + raster_count(raster, 0) != n[0] * n[1];
    bad += raster_count(raster, 1) != cover_lattice(bodies, pack->species[0].count, &pack->box, n[0], n[1]);
    free(bodies);
    raster_free(&raster);
    pack_free(&pack);
  }
  gsl_test(bad, "points in the plane: as many as of a lattice (%d differ)", bad);
  for (int k = 0; k < as_many(8, 50); k++) {
    Pack *pack = few(3, 3 + (size_t)k % 5, 3 + rng_uniform(&rng), 4, 2.9, &rng);
    int n[] = {13, 11 + k % 4, 9};
    Raster *raster = raster_make(pack, n);
    for (int p = 0; p < n[0] * n[1] * n[2]; p++) {
      int at[] = {p % n[0], p / n[0] % n[1], p / n[0] / n[1]}, in = 0;
      for (int i = (int)pack->n - 1; i >= 0; i--)
        for (int image = 0; image < 125; image++) {
          double square = 0, R = pack_radius(pack, (size_t)i);
          int move[] = {image % 5 - 2, image / 5 % 5 - 2, image / 25 - 2};
          for (int j = 0; j < 3; j++) {
            double side = pack->box.side[j];
            double d = (at[j] + 0.5) * side / n[j] - pack->x[3 * i + j] + move[j] * side;
            square += d * d;
          }
          in = square <= R * R ? pack_kind(pack, (size_t)i) + 1 : in;
        }
      differ += raster->in[p] != in;
    }
    raster_free(&raster);
    pack_free(&pack);
  }
  gsl_test(differ, "points in balls: as of all images (%d differ)", differ);
}

static double plain(const Raster *raster, int a, int b, const int shift[3]) {
  const int *n = raster->n;
  double count = 0;
  for (int z = 0; z < n[2]; z++)
    for (int y = 0; y < n[1]; y++)
      for (int x = 0; x < n[0]; x++) {
        int from = raster->in[(z * n[1] + y) * n[0] + x];
        int to = raster->in[((z + shift[2]) % n[2] * n[1] + (y + shift[1]) % n[1]) * n[0] + (x + shift[0]) % n[0]];
        count += (a < 0 ? from > 0 : from == a) && (b < 0 ? to > 0 : to == b);
      }
  return count;
}

static void test_counts(void) {
  static const int pairs[][2] = {{-1, -1}, {0, 0}, {1, 2}, {2, 1}, {1, 1}, {-1, 0}};
  Rng rng = rng_stream(17, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = few(dim, 6, 7, 8, 6.5, &rng);
    Raster *raster = raster_make(pack, dim == 2 ? (const int[]){21, 30} : (const int[]){10, 12, 9});
    int differ = 0;
    for (int p = 0; p < 6; p++) {
      double *count = raster_correlate(raster, pairs[p][0], pairs[p][1]);
      for (int k = 0; k < (int)raster_points(raster); k++) {
        int shift[] = {k % raster->n[0], k / raster->n[0] % raster->n[1], k / raster->n[0] / raster->n[1]};
        differ += count[k] != plain(raster, pairs[p][0], pairs[p][1], shift);
      }
      free(count);
    }
    gsl_test(differ, "%d-D: counts as of plain sums (%d differ)", dim, differ);
    raster_free(&raster);
    pack_free(&pack);
  }
}

/* A plane wave is what a mean over circles is known of: J0(k r), and sin(k r) / k r over spheres. */
static void test_means(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Box box = {dim, {10, 8, dim == 3 ? 6 : 0}};
    Raster raster = {.box = box, .dim = dim, .n = {dim == 2 ? 500 : 100, dim == 2 ? 400 : 80, dim == 2 ? 1 : 60}};
    double *wave = memory(raster_points(&raster), sizeof *wave), k = 2 * M_PI / 10, h = 10.0 / raster.n[0];
    for (size_t p = 0; p < raster_points(&raster); p++)
      wave[p] = cos(k * h * (double)(p % (size_t)raster.n[0]));
    for (double r = 0; r < 12; r += 1.37) {
      double x = k * r, law = dim == 2 ? gsl_sf_bessel_J0(x) : x > 0 ? sin(x) / x : 1;
      gsl_test_abs(raster_mean(&raster, wave, r), law, k * k * h * h / 8, "%d-D: the mean of a wave at %g", dim, r);
    }
    for (size_t p = 0; p < raster_points(&raster); p++) {
      size_t n = (size_t)raster.n[0], m = (size_t)raster.n[1];
      wave[p] = 3 + 2 * (double)(p % n) + 5 * (double)(p / n % m) + 7 * (double)(p / n / m);
    }
    double place[] = {2.5 * h + 10, 4.25 * h - 8, 3.75 * h}, law = 3 + 2 * 2.5 + 5 * 4.25 + (dim == 3 ? 7 * 3.75 : 0);
    gsl_test_rel(raster_at(&raster, wave, place), law, 1e-12, "%d-D: between points", dim);
    free(wave);
  }
}

static void test_choose(void) {
  int n[3];
  raster_choose(&(Box){2, {100, 100, 0}}, 2048.0 * 2048, n);
  gsl_test(n[0] != 2048 || n[1] != 2048 || n[2] != 1, "points of a square");
  raster_choose(&(Box){3, {30, 11, 0.01}}, 1e6, n);
  gsl_test(n[0] < n[1] || n[1] < n[2] || n[2] != 2, "points of a slab: %d %d %d", n[0], n[1], n[2]);
}

int main(void) {
  test_by_hand();
  test_points();
  test_counts();
  test_means();
  test_choose();
  return gsl_test_summary();
}
