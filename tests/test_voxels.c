/* tests/test_voxels.c: the points of the raster; a plain search without a box; slabs; bytes; the law of the error */
#include "many.h"
#include "raster.h"
#include "scatter.h"
#include "voxels.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *random_pack(int dim, size_t n, bool shaped, double wide, Rng *rng) {
  Box box = {dim, {3.1 * wide, 4.7 * wide, dim == 3 ? 2.9 * wide : 0}};
  return two_kinds(&box, n, 0.9, 1.7, shaped, rng);
}

static void begin(Writing *w, const Pack *pack, int a, int b, int c) {
  format_begin(w, pack, "");
  w->cells[0] = a;
  w->cells[1] = b;
  w->cells[2] = pack->box.dim == 3 ? c : 1;
}

static size_t voxels_of(const Writing *w) {
  return (size_t)w->cells[0] * (size_t)w->cells[1] * (size_t)w->cells[2];
}

static uint16_t *filled(const Writing *w, int64_t thick) {
  int axis = w->pack->box.dim - 1;
  size_t layer = voxels_of(w) / (size_t)w->cells[axis];
  uint16_t *cell = malloc(voxels_of(w) * sizeof *cell);
  memset(cell, 0x5a, voxels_of(w) * sizeof *cell);
  for (int64_t from = 0; from < w->cells[axis]; from += thick)
    voxels_fill(w, from, GSL_MIN(from + thick, w->cells[axis]), cell + (size_t)from * layer);
  return cell;
}

/* Points that the raster has, also of a ball that is larger than the box; and slabs of any thickness. */
static void test_points(void) {
  Rng rng = rng_stream(41, 0, RNG_TEST);
  int differ[2] = {0, 0}, slabs = 0;
  for (int k = 0; k < as_many(24, 200); k++) {
    int dim = 2 + k % 2;
    Pack *pack = random_pack(dim, 1 + (size_t)k % 7, dim == 2 && k % 3, k % 5 ? 1.4 : 0.7, &rng);
    Writing w;
    begin(&w, pack, 13 + k % 5, 17, 11 + k % 3);
    Raster *raster = raster_make(pack, w.cells);
    uint16_t *all = filled(&w, 1000), *thin = filled(&w, 1 + k % 4);
    for (size_t p = 0; p < voxels_of(&w); p++)
      differ[dim - 2] += all[p] != raster->in[p];
    slabs += memcmp(all, thin, voxels_of(&w) * sizeof *all) != 0;
    free(all);
    free(thin);
    raster_free(&raster);
    format_end(&w);
    pack_free(&pack);
  }
  gsl_test(differ[0], "voxels in the plane are the points of the raster (%d differ)", differ[0]);
  gsl_test(differ[1], "voxels in space are the points of the raster (%d differ)", differ[1]);
  gsl_test(slabs, "slabs of any thickness give the same voxels (%d differ)", slabs);
}

/* Is the centre of a voxel in the particle? Plainly, without images. */
static bool is_in(const Writing *w, size_t i, const int at[3]) {
  const Pack *pack = w->pack;
  double x[3], square = 0, d[3], r = pack_radius(pack, i);
  format_place(w, i, x);
  for (int k = 0; k < pack->box.dim; k++) {
    d[k] = w->low[k] + (at[k] + 0.5) * w->side[k] / w->cells[k] - x[k];
    square += d[k] * d[k];
  }
  const Shape *shape = pack_shape(pack, i);
  if (!shape)
    return square <= r * r;
  Body body = pack_body(pack, i);
  return shape_gauge(shape, (body.c * d[0] + body.s * d[1]) / r, (body.c * d[1] - body.s * d[0]) / r) <= 1;
}

static void test_finite(void) {
  Rng rng = rng_stream(42, 0, RNG_TEST);
  int differ = 0, inside = 0;
  for (int k = 0; k < as_many(12, 60); k++) {
    int dim = 2 + k % 2;
    Pack *pack = random_pack(dim, 12, dim == 2 && k % 4 == 0, 4, &rng);
    Writing w;
    pack->open = 5;
    begin(&w, pack, 14, 17, 19);
    uint16_t *cell = filled(&w, 5);
    for (int p = 0; p < (int)voxels_of(&w); p++) {
      int at[] = {p % w.cells[0], p / w.cells[0] % w.cells[1], p / w.cells[0] / w.cells[1]}, label = 0;
      for (size_t i = 0; i < pack->n; i++)
        if (is_in(&w, i, at) && (label == 0 || format_label(&w, i) < label))
          label = format_label(&w, i);
      differ += cell[p] != label;
      inside += label > 0;
    }
    free(cell);
    format_end(&w);
    pack_free(&pack);
  }
  gsl_test(differ || inside < 1000, "voxels without a box, by a plain search (%d of %d differ)", differ, inside);
}

/* One ball at many places, of many radii, on a lattice of spacing 1: mean and mean square of the error of its volume. */
static void test_error(int dim) {
  Rng rng = rng_stream(43, (uint64_t)dim, RNG_TEST);
  const int n = 16, times = as_many(4000, 40000);
  Species one = {.name = "A", .radius = 1, .count = 1};
  Box box = {dim, {n, n, dim == 3 ? n : 0}};
  Pack *pack = pack_alloc(&box, &one, 1, true);
  Writing w;
  double sum = 0, squares = 0, fourth = 0;
  begin(&w, pack, n, n, n);
  uint16_t *cell = malloc(voxels_of(&w) * sizeof *cell);
  for (int t = 0; t < times; t++) {
    double r = pack->radius[0] = 3 + 3 * rng_uniform(&rng), count = 0;
    for (int k = 0; k < dim; k++)
      pack->x[k] = n * rng_uniform(&rng);
    voxels_fill(&w, 0, n, cell);
    for (size_t p = 0; p < voxels_of(&w); p++)
      count += cell[p];
    double surface = dim == 3 ? 4 * M_PI * r * r : 2 * M_PI * r;
    double e = (count - pack_ball(dim, r)) / sqrt((dim == 3 ? 0.06665 : 0.07284) * surface);
    sum += e;
    squares += e * e;
    fourth += e * e * e * e;
  }
  double mean = sum / times, square = squares / times;
  double error = sqrt((fourth / times - square * square) / times);
  gsl_test(!(fabs(mean) < 4 * sqrt(square / times)), "%d-D: voxels have no bias (%g of the error)", dim, mean);
  gsl_test(!(fabs(square - 1) < 4 * error), "%d-D: and the error of the law (%.4f +- %.4f)", dim, square, error);
  free(cell);
  format_end(&w);
  pack_free(&pack);
}

/* More than 255 species take two bytes, the lower first. */
static void test_bytes(void) {
  enum { KINDS = 300 };
  Species *species = calloc(KINDS, sizeof *species);
  Box box = {3, {KINDS, 1, 1}};
  for (int s = 0; s < KINDS; s++) {
    species[s] = (Species){.radius = 0.3, .count = 1};
    sprintf(species[s].name, "%d", s);
  }
  for (int kinds = 255; kinds <= KINDS; kinds += KINDS - 255) {
    Pack *pack = pack_alloc(&box, species, kinds, false);
    Writing w;
    FILE *file = tmpfile();
    for (int i = 0; i < kinds; i++) {
      pack->x[3 * i] = i + 0.5;
      pack->x[3 * i + 1] = pack->x[3 * i + 2] = 0.5;
    }
    begin(&w, pack, KINDS, 1, 1);
    format_raw.write(&w, file);
    long length = ftell(file), want = kinds == KINDS ? 2 * KINDS : KINDS;
    int wrong = length != want || voxels_bytes(&w) != (double)want;
    rewind(file);
    for (int i = 0; i < KINDS; i++) {
      int low = fgetc(file), high = kinds == KINDS ? fgetc(file) : 0;
      wrong += low + 256 * high != (i < kinds ? i + 1 : 0);
    }
    gsl_test(wrong, "%d species in %ld bytes (%d wrong)", kinds, length, wrong);
    fclose(file);
    format_end(&w);
    pack_free(&pack);
  }
  free(species);
}

static void test_choose(void) {
  Rng rng = rng_stream(44, 0, RNG_TEST);
  Pack *pack = random_pack(3, 2, false, 1, &rng);
  Writing w;
  Outcome out = {0};
  format_begin(&w, pack, "");
  gsl_test(voxels_choose(&w, 47, 0, &out) || w.cells[0] != 31 || w.cells[1] != 47 || w.cells[2] != 29, "47 along the longest side");
  gsl_test(voxels_choose(&w, 1, 0.19, &out) || w.cells[0] != 16 || w.cells[1] != 25 || w.cells[2] != 15, "a step of 0.19");
  gsl_test(voxels_choose(&w, 1, 1000, &out) || w.cells[0] != 1 || w.cells[2] != 1, "at least one voxel");
  gsl_test(voxels_choose(&w, 1, 1e-5, &out) != WRONG || !strstr(out.text, "at most 32768"), "too many");
  format_end(&w);
  pack_free(&pack);
}

int main(void) {
  test_points();
  test_finite();
  test_error(2);
  test_error(3);
  test_bytes();
  test_choose();
  return gsl_test_summary();
}
