/* tests/test_sections.c: discs cut from spheres, and spheres from discs */
#include "scatter.h"
#include "sections.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

/* A ball at (.5, 2, 3.9) of radius .5 and one wider than its box, across each axis. */
static void test_cut(void) {
  double side[3] = {4, 5, 6}, x[3] = {0.5, 2, 3.9}, small = 0.5, wide = 7;
  for (int axis = 0; axis < 3; axis++) {
    Pack *pack = particles(3, side, 1, x, &small);
    Pack *cut = sections_cut(pack, axis, x[axis] + 0.3);
    gsl_test(cut->n != 1 || cut->box.dim != 2, "one disc across axis %d", axis);
    gsl_test_abs(cut->radius[0], 0.4, 1e-15, "its radius");
    int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    gsl_test(cut->x[0] != x[first] || cut->x[1] != x[second], "its place");
    gsl_test(cut->box.side[0] != side[first] || cut->box.side[1] != side[second], "its box");
    pack_free(&cut);
    cut = sections_cut(pack, axis, x[axis] + 0.5);
    gsl_test(cut->n != 0, "a tangent plane cuts nothing");
    pack_free(&cut);
    cut = sections_cut(pack, axis, x[axis] - 0.3 + side[axis]);
    gsl_test(cut->n != 1, "an image across axis %d", axis);
    pack_free(&cut);
    pack_free(&pack);
    pack = particles(3, side, 1, x, &wide);
    cut = sections_cut(pack, axis, x[axis] + 0.25);
    size_t want = 0;
    for (int m = -9; m < 10; m++)
      want += fabs(m * side[axis] - 0.25) < wide;
    gsl_test(cut->n != want || want < 2, "a wide ball across axis %d: %zu discs for %zu", axis, cut->n, want);
    pack_free(&cut);
    pack_free(&pack);
  }
}

/* The mean area fraction over many planes is the packing fraction, and N_A = 2 N_V <R>. */
static void test_delesse(void) {
  double side[3] = {10, 12, 9}, x[300], radius[100], sum = 0;
  Rng rng = rng_stream(5, 0, RNG_TEST);
  for (int i = 0; i < 100; i++) {
    radius[i] = 0.2 + rng_uniform(&rng);
    sum += radius[i];
    for (int k = 0; k < 3; k++)
      x[3 * i + k] = side[k] * rng_uniform(&rng);
  }
  Pack *pack = particles(3, side, 100, x, radius);
  double area = 0, discs = 0, planes = 4000;
  for (double p = 0; p < planes; p++) {
    Pack *cut = sections_cut(pack, 1, (p + 0.5) / planes * side[1]);
    area += pack_solid(cut) / planes;
    discs += (double)cut->n / planes;
    pack_free(&cut);
  }
  gsl_test_rel(area / (side[0] * side[2]), pack_fraction(pack), 1e-5, "area fraction");
  gsl_test_rel(discs, 2 * sum / side[1], 3e-3, "discs per area");
  pack_free(&pack);
}

/* Spheres give discs, and the discs give the spheres again. */
static void test_unfold(void) {
  enum { N = 12 };
  double width = 0.25, want[N] = {0}, discs[N] = {0}, got[N], all = 0;
  want[3] = 2;
  want[7] = 0.5;
  want[11] = 0.1;
  for (int i = 0; i < N; i++)
    for (int j = i; j < N; j++)
      discs[i] += want[j] * sections_discs((j + 1) * width, i * width, (i + 1) * width);
  sections_saltykov(N, width, discs, got);
  for (int j = 0; j < N; j++)
    gsl_test_abs(got[j], want[j], 1e-12, "class %d by differences", j);
  gsl_test_rel(sections_moment(N, width, got, 2), 2 + 0.5 * 4 + 0.1 * 9, 1e-12, "their second moment");
  for (int i = 0; i < N; i++)
    all += discs[i];
  gsl_test_rel(all, 2 * sections_moment(N, width, want, 1), 1e-13, "all discs");
  for (int j = 0; j < N; j++)
    for (int i = 0; i <= j; i++)
      discs[i] += sections_discs((j + 1) * width, i * width, (i + 1) * width);
  sections_likelihood(N, width, discs, 20000, got);
  for (int j = 0; j < N; j++)
    gsl_test_rel(got[j], want[j] + 1, 2e-3, "class %d by likelihood", j);
  sections_likelihood(N, width, discs, 1, got);
  double given = 0, found = 0;
  for (int i = 0; i < N; i++)
    given += discs[i];
  found = 2 * sections_moment(N, width, got, 1);
  gsl_test_rel(found, given, 1e-13, "after one step already there are as many discs");
}

/* The number of discs is that of all spheres for any step; counts of 0 and empty packs are no trouble. */
static void test_hard(void) {
  double discs[3] = {0, 4, 0}, got[3], none[3] = {0};
  sections_likelihood(3, 1, discs, 50, got);
  gsl_test(!(got[0] >= 0 && got[1] > 0 && got[2] >= 0), "a class without discs");
  sections_likelihood(3, 1, none, 50, got);
  gsl_test(got[0] + got[1] + got[2] != 0, "no discs, no spheres");
  Pack *pack = pack_of(3, 4, 0, 1, NULL), *cut = sections_cut(pack, 0, 1);
  gsl_test(cut->n != 0, "an empty pack");
  pack_free(&cut);
  pack_free(&pack);
  gsl_test_rel(sections_discs(1e6, 1, 2), 3e-6, 1e-11, "small discs of a large sphere");
  gsl_test(sections_discs(1, 1, 2) != 0 || sections_discs(1, 0, 2) != 2, "discs larger than the sphere");
}

int main(void) {
  test_cut();
  test_delesse();
  test_unfold();
  test_hard();
  return gsl_test_summary();
}
