/* tests/test_library.c: what the header of the library promises: packs to arrays and back, makers, measures of packs that are known,
   and an answer to every argument that is wrong. */
#include "library.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static randpack_outcome out;
static const double cube[] = {10, 10, 10}, square[] = {20, 20};
static const size_t forty[] = {40};
static const double one[] = {1};

static double fraction_of(const randpack_pack *pack) {
  double fraction = GSL_NAN;
  randpack_fraction(pack, 0, &fraction, &out);
  return fraction;
}

static double gap_of(const randpack_pack *pack) {
  double gap = GSL_NAN;
  randpack_least_gap(pack, &gap, &out);
  return gap;
}

static randpack_pack *cubic(void) {
  return randpack_lattice("simple cubic", 3, 1, 0, &out);
}

/* --- arrays */
static void test_periodic(void) {
  const double side[] = {7.25, 9.5}, x[] = {0.5, 1, 6.75, 9.25, -0.25, 3, 7.25, 21, 2, 2}, radius[] = {1, 2, 1, 0.5, 2};
  const int species[] = {3, 0, 3, 7, 0}, want[] = {1, 0, 1, 2, 0};
  const double wrapped[] = {0.5, 1, 6.75, 9.25, 7, 3, 0, 2, 2, 2};
  double y[10], a[5];
  int s[5];
  randpack_facts facts;
  randpack_pack *pack = randpack_from_arrays(2, side, 5, x, 5, radius, species, &out);
  gsl_test(!pack || out.status != RANDPACK_DONE || *out.text, "a pack from arrays: %s", out.text);
  randpack_describe(pack, &facts);
  gsl_test(facts.dim != 2 || facts.species != 3 || !facts.periodic || facts.particles != 5, "its facts");
  gsl_test(facts.side[0] != 7.25 || facts.side[1] != 9.5 || facts.side[2] != 0 || facts.radius != 0, "and its box");
  randpack_to_arrays(pack, y, a, s);
  gsl_test(memcmp(y, wrapped, sizeof y) != 0, "places in the box, in the order given");
  gsl_test(memcmp(a, radius, sizeof a) != 0 || memcmp(s, want, sizeof s) != 0, "radii and species, in that order");
  randpack_pack *copy = randpack_copy(pack, NULL);
  randpack_free(pack);
  double z[10];
  randpack_to_arrays(copy, z, NULL, NULL);
  gsl_test(memcmp(y, z, sizeof y) != 0, "a copy outlives it");
  randpack_free(copy);
  randpack_free(NULL);
}

static void test_finite(void) {
  const double x[] = {100, 200, 300, 103, 204, 300, 100, 200, 312};
  double y[9], a[3];
  randpack_facts facts;
  randpack_pack *pack = randpack_from_arrays(3, NULL, 3, x, 1, one, NULL, &out);
  randpack_describe(pack, &facts);
  gsl_test(facts.periodic || facts.species != 1 || facts.side[0] != 0, "a finite pack");
  gsl_test_abs(facts.radius, 2.5, 1e-12, "half the shortest side of what just holds it");
  randpack_to_arrays(pack, y, a, NULL);
  gsl_test_abs(y[0], -1.5, 1e-12, "places from its middle");
  gsl_test_abs(y[8], 6, 1e-12, "along each axis");
  gsl_test(a[2] != 1, "one radius for all");
  gsl_test_abs(gap_of(pack), 3, 1e-12, "the least gap of a finite pack");
  randpack_free(pack);
  pack = randpack_from_arrays(3, cube, 0, NULL, 1, one, NULL, &out);
  gsl_test(!pack || fraction_of(pack) != 0, "a pack of nothing is a pack");
  randpack_free(pack);
}

/* --- files */
static void test_files(void) {
  char folder[] = "/tmp/randpack-library-XXXXXX", path[64], part[80];
  gsl_test(!mkdtemp(folder), "a folder");
  snprintf(path, sizeof path, "%s/pack.xyz", folder);
  snprintf(part, sizeof part, "%s.part", path);
  const double radius[] = {1.0 / 3, 0.7};
  const size_t number[] = {11, 7};
  double x[54], y[54], a[18], b[18];
  int s[18], t[18];
  randpack_pack *pack = randpack_points(3, cube, 2, number, radius, 7, &out);
  gsl_test_int(randpack_write(pack, path, &out), RANDPACK_DONE, "a pack is written");
  randpack_pack *same = randpack_read(path, &out);
  gsl_test(!same, "and read: %s", out.text);
  randpack_to_arrays(pack, x, a, s);
  randpack_to_arrays(same, y, b, t);
  gsl_test(memcmp(x, y, sizeof x) || memcmp(a, b, sizeof a) || memcmp(s, t, sizeof s), "the same, to the last bit");
  gsl_test(access(part, F_OK) == 0, "nothing is beside it");
  randpack_free(same);
  gsl_test_int(randpack_write(pack, "/tmp/randpack/none/pack.xyz", &out), RANDPACK_UNREACHED, "where there is no folder");
  gsl_test(!strstr(out.text, "none/pack.xyz: cannot be written"), "the line says so: %s", out.text);
  FILE *file = fopen(path, "w");
  fputs("1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=pos:R:3:radius:R:1\n1 2 three 1\n", file);
  fclose(file);
  gsl_test(randpack_read(path, &out) || out.status != RANDPACK_WRONG, "a file that is wrong");
  gsl_test(!strstr(out.text, "pack.xyz:3: three"), "names its line: %s", out.text);
  gsl_test(randpack_read("/tmp/randpack/none", &out) || out.status != RANDPACK_WRONG, "or is not there");
  remove(path);
  rmdir(folder);
  randpack_free(pack);
}

/* --- makers */
static void test_hard(const char *words, randpack_pack *pack, size_t n, double gap) {
  randpack_facts facts = {0};
  gsl_test(!pack, "%s: %s", words, out.text);
  if (!pack)
    return;
  randpack_describe(pack, &facts);
  gsl_test(n && facts.particles != n, "%s: its particles", words);
  gsl_test(!(gap_of(pack) >= gap - 1e-12), "%s: its gap, %g", words, gap_of(pack));
  randpack_free(pack);
}

static void test_makers(void) {
  const size_t number[] = {50, 9};
  const double radius[] = {0.5, 1.25}, share[] = {1, 3};
  test_hard("addition in order", randpack_rsa(3, cube, 2, number, radius, 0.0625, 3, &out), 59, 0.0625);
  test_hard("addition to saturation", randpack_saturate(2, square, 2, share, radius, 0.125, 3, &out), 0, 0.125);
  test_hard("growth", randpack_grow(3, 2, number, radius, 0.5, 0.1, 3, &out), 59, 0);
  test_hard("growth of discs", randpack_grow(2, 1, forty, one, 0.7, 0.1, 3, &out), 40, 0);
  test_hard("gravity", randpack_gravity(3, 1, forty, one, 3, &out), 40, -2e-9);
  test_hard("fcc", randpack_lattice("fcc", 3, 0.7, 0.5, &out), 108, 0.1);
  randpack_pack *pack = randpack_grow(3, 2, number, radius, 0.5, 0.1, 3, &out);
  double a[59];
  randpack_to_arrays(pack, NULL, a, NULL);
  gsl_test_abs(fraction_of(pack), 0.5, 1e-13, "growth ends at the fraction");
  gsl_test(a[0] != 0.5 || a[58] != 1.25, "and at the radii");
  randpack_free(pack);
  randpack_pack *other = randpack_points(3, cube, 2, number, radius, 4, &out), *again = randpack_points(3, cube, 2, number, radius, 3, &out);
  double x[177], y[177], z[177];
  pack = randpack_points(3, cube, 2, number, radius, 3, &out);
  randpack_to_arrays(pack, x, NULL, NULL), randpack_to_arrays(other, y, NULL, NULL), randpack_to_arrays(again, z, NULL, NULL);
  gsl_test(x[0] == y[0] || memcmp(x, z, sizeof x) != 0, "each pack has its own seed");
  randpack_free(pack), randpack_free(other), randpack_free(again);
  pack = randpack_penetrable(square, 1, forty, one, 0.25, 5, &out);
  double covered = 0;
  randpack_covered(pack, &covered, &out);
  gsl_test_abs(covered, 0.25, 2e-14, "penetrable discs cover the fraction");
  gsl_test_abs(fraction_of(pack), M_PI * 40 / 400, 1e-14, "and are more");
  randpack_free(pack);
}

/* What is not reached gives nothing back, and leaves a pack as it was. */
static void test_unreached(void) {
  const size_t many[] = {2000};
  double x[120], y[120];
  gsl_test(randpack_grow(3, 1, forty, one, 0.8, 1, 3, &out) || out.status != RANDPACK_UNREACHED, "denser than all: %s", out.text);
  gsl_test(!strstr(out.text, "jammed at fraction"), "it says how far it came: %s", out.text);
  gsl_test(randpack_rsa(3, cube, 1, many, one, 0, 3, &out) || out.status != RANDPACK_UNREACHED, "more than saturate: %s", out.text);
  randpack_pack *pack = randpack_rsa(3, cube, 1, forty, one, 0, 3, &out);
  randpack_to_arrays(pack, x, NULL, NULL);
  gsl_test_int(randpack_compress(pack, 0.8, 1, 3, &out), RANDPACK_UNREACHED, "compressed too far");
  randpack_to_arrays(pack, y, NULL, NULL);
  gsl_test(memcmp(x, y, sizeof x) != 0, "the pack is as it was");
  randpack_free(pack);
}

static void test_changes(void) {
  double before, moved = -1;
  const size_t twelve[] = {12};
  const double small[] = {11, 11};
  randpack_pack *pack = randpack_rsa(2, small, 1, twelve, one, 0, 3, &out);
  gsl_test_int(randpack_shake(pack, 0.5, 10, 4, &moved, &out), RANDPACK_DONE, "shaken: %s", out.text);
  gsl_test(!(moved > 0.3 && moved < 1) || gap_of(pack) < 0, "most trials move a disc, and none overlaps");
  gsl_test_int(randpack_compress(pack, 0.7, 0.1, 4, &out), RANDPACK_DONE, "compressed: %s", out.text);
  gsl_test_abs(fraction_of(pack), 0.7, 1e-13, "to the fraction");
  gsl_test(gap_of(pack) < -1e-12, "without overlap");
  randpack_facts facts, then;
  randpack_describe(pack, &facts);
  before = fraction_of(pack);
  gsl_test_int(randpack_jam(pack, 0.1, 4, &out), RANDPACK_DONE, "jammed: %s", out.text);
  randpack_describe(pack, &then);
  gsl_test(!(fraction_of(pack) > before + 0.05) || !(then.side[0] < facts.side[0]), "it is denser, its box smaller");
  randpack_free(pack);
}

/* --- measures */
static void test_lattice(void) {
  double g[4], K[3], mean = 0, value = 0, error = -1, part = 0;
  size_t count[4];
  randpack_pack *pack = cubic();
  gsl_test_abs(fraction_of(pack), M_PI / 6, 1e-14, "the fraction of a lattice");
  randpack_fraction(pack, 1, &part, &out);
  gsl_test_abs(part, 1, 1e-14, "of the ball in its middle, which is a particle");
  gsl_test_abs(gap_of(pack), 0, 1e-14, "its gap");
  gsl_test_int(randpack_g(pack, 2, 0.25, 4, g, &out), RANDPACK_DONE, "its g");
  gsl_test_rel(g[0], 6 * 216 / (26 * 4 * M_PI / 3 * (pow(2.25, 3) - 8)), 1e-13, "six neighbours in the first shell");
  gsl_test(g[1] != 0 || g[2] != 0, "and none in the next");
  gsl_test_int(randpack_K(pack, 1, 3, K, &out), RANDPACK_DONE, "its K");
  gsl_test(K[0] != 0, "is 0 below contact");
  gsl_test_rel(K[2], 216. * 18 / 26, 1e-13, "and has 18 neighbours at 3");
  gsl_test_int(randpack_neighbours(pack, 1e-9, 4, count, &mean, &out), RANDPACK_DONE, "its neighbours");
  gsl_test(count[3] != 27 || count[0] || mean != 6, "the last count has those with more");
  gsl_test_int(randpack_neighbours(pack, 0.42, 4, count, &mean, &out), RANDPACK_DONE, "and the second shell");
  gsl_test_abs(mean, 18, 1e-14, "is within 1.42 diameters");
  gsl_test_int(randpack_contact(pack, &value, &error, &out), RANDPACK_DONE, "its contact value");
  gsl_test(!(value > 1000) || !(error >= 0), "is out of all proportion: %g", value);
  randpack_free(pack);
}

static void test_waves(void) {
  double k[4], S[4], error[4], S2[3];
  randpack_pack *pack = cubic();
  gsl_test_int(randpack_structure(pack, 1, 4, k, S, error, &out), RANDPACK_DONE, "a structure factor");
  gsl_test(!gsl_isnan(S[0]) || fabs(S[1]) > 1e-12, "no vector below the first, and no power there");
  gsl_test(!(S[3] > 1) || !(k[3] > 3 && k[3] < 4), "the peak at pi is 27");
  double x[81], T[4];
  int species[27];
  for (int i = 0; i < 27; i++)
    species[i] = i % 3;
  randpack_to_arrays(pack, x, NULL, NULL);
  const double six[] = {6, 6, 6};
  randpack_pack *three = randpack_from_arrays(3, six, 27, x, 1, one, species, &out);
  randpack_structure(three, 1, 4, NULL, T, NULL, &out);
  gsl_test_rel(T[3], S[3], 1e-12, "the same of three species, which are summed");
  randpack_free(three);
  gsl_test_int(randpack_S2(pack, 2, 3, S2, &out), RANDPACK_DONE, "S2");
  gsl_test_abs(S2[0], M_PI / 6, 1e-13, "at 0 is the fraction");
  gsl_test(!(S2[1] > 0 && S2[1] < S2[0]), "and less at 2");
  randpack_free(pack);
  pack = randpack_points(3, cube, 1, forty, one, 3, &out);
  gsl_test(randpack_S2(pack, 1, 3, S2, &out) != RANDPACK_WRONG || !strstr(out.text, "spheres overlap"), "of spheres that overlap: %s", out.text);
  randpack_free(pack);
}

/* A finite pack: g of points in a ball is 1, of centres in its core. */
static void test_core(void) {
  enum { N = 4000 };
  static double x[3 * N];
  double g[2], part = 0;
  uint64_t state = 1;
  for (size_t i = 0; i < N;) {
    double square_ = 0;
    for (size_t k = 0; k < 3; k++) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      x[3 * i + k] = (double)(state >> 11) * 0x1p-52 - 1;
      square_ += x[3 * i + k] * x[3 * i + k];
    }
    i += square_ <= 1;
  }
  const double tiny[] = {1e-9};
  randpack_pack *pack = randpack_from_arrays(3, NULL, N, x, 1, tiny, NULL, &out);
  gsl_test_int(randpack_g(pack, 0, 0.25, 2, g, &out), RANDPACK_DONE, "g of a finite pack: %s", out.text);
  gsl_test_abs(g[1], 1, 0.02, "is 1 of points, away from the rim");
  gsl_test_int(randpack_fraction(pack, 0.5, &part, &out), RANDPACK_DONE, "its core has a fraction: %s", out.text);
  gsl_test_rel(part, 8e-27 * N / 8, 0.1, "that of an eighth of its particles");
  gsl_test(randpack_fraction(pack, 0, &part, &out) != RANDPACK_WRONG, "but its box has none");
  gsl_test(randpack_g(pack, 0, 0.7, 2, g, &out) != RANDPACK_WRONG, "and g ends at its radius");
  gsl_test(randpack_g(pack, 0, 0.48855, 2, g, &out) != RANDPACK_WRONG || !strstr(out.text, "no centre"), "no centre is so deep: %s", out.text);
  gsl_test_abs(g[1], 1, 0.02, "and g is as it was");
  randpack_free(pack);
}

/* --- theory */
static void test_theory(void) {
  const double R[] = {1.5, 2, 4, 20}, share[] = {0.3, 0.7}, radius[] = {1, 1}, two[] = {1, 2.5}, all[] = {1, 0};
  double g[4], contact = 0, Z = 0, pair[4], cs, ZZ;
  gsl_test_int(randpack_py(0.575, 4, R, g, &out), RANDPACK_DONE, "Percus and Yevick");
  gsl_test(g[0] != 0, "is 0 below contact");
  gsl_test_rel(g[1], 7.12802768166, 1e-12, "7.128 at contact");
  gsl_test_rel(g[3], 0.994573015909, 1e-12, "and 0.9946 at 20");
  randpack_equation("carnahan-starling", 0.49, &cs, &ZZ, &out);
  gsl_test_rel(cs, (1 - 0.245) / pow(0.51, 3), 1e-14, "Carnahan and Starling's contact value");
  gsl_test_rel(ZZ, 1 + 4 * 0.49 * cs, 1e-14, "and its pressure");
  gsl_test_int(randpack_equation("henderson-discs", 0.6, NULL, &Z, NULL), RANDPACK_DONE, "one of the two, and no outcome");
  gsl_test_int(randpack_mixture("bmcsl", 2, share, radius, 0.49, pair, &Z, &out), RANDPACK_DONE, "a mixture");
  gsl_test_rel(pair[1], cs, 1e-13, "of equal sizes is one size");
  gsl_test_rel(Z, ZZ, 1e-13, "and has its pressure");
  randpack_mixture("py", 2, all, two, 0.3, pair, &contact, &out);
  gsl_test_rel(pair[0], (1 + 0.15) / (0.7 * 0.7), 1e-13, "a species alone");
  gsl_test(pair[1] != pair[2] || !(pair[3] > pair[0]), "a guest has its contact values too");
}

/* --- wrong arguments */
static int wrong; /* that were refused */
static void refused(int answered, const char *words) {
  gsl_test(!answered || out.status != RANDPACK_WRONG || !strstr(out.text, words) || strchr(out.text, '\n'),
           "refused with %s: %s", words, out.text);
  wrong++;
}

static void test_wrong_arrays(void) {
  const double x[] = {1, 2, 3, 4, 5, 6}, bad[] = {1, GSL_NAN, 3, 4, 5, 6}, flat[] = {10, 0, 10}, huge[] = {1e60, 1, 1};
  const double none[] = {1, 0};
  const int species[] = {0, -1}, many[] = {0, 65534};
  refused(!randpack_from_arrays(4, cube, 2, x, 1, one, NULL, &out), "dim is 4");
  refused(!randpack_from_arrays(3, flat, 2, x, 1, one, NULL, &out), "side[1] is 0");
  refused(!randpack_from_arrays(3, huge, 2, x, 1, one, NULL, &out), "side[0] is 1e+60");
  refused(!randpack_from_arrays(3, cube, (size_t)1 << 29, x, 1, one, NULL, &out), "n is 536870912");
  refused(!randpack_from_arrays(3, cube, 2, NULL, 1, one, NULL, &out), "x is NULL");
  refused(!randpack_from_arrays(3, cube, 2, x, 1, NULL, NULL, &out), "radius is NULL");
  refused(!randpack_from_arrays(3, cube, 2, x, 3, one, NULL, &out), "radii is 3");
  refused(!randpack_from_arrays(3, cube, 2, x, 2, none, NULL, &out), "particle 1: a radius");
  refused(!randpack_from_arrays(3, cube, 2, bad, 1, one, NULL, &out), "particle 0: a position");
  refused(!randpack_from_arrays(3, NULL, 2, bad, 1, one, NULL, &out), "particle 0: a position");
  refused(!randpack_from_arrays(3, cube, 2, x, 1, one, species, &out), "species[1] is -1");
  refused(!randpack_from_arrays(3, cube, 2, x, 1, one, many, &out), "species[1] is 65534");
  refused(!randpack_copy(NULL, &out), "pack is NULL");
  refused(!randpack_read(NULL, &out), "path is NULL");
}

static void test_wrong_makers(void) {
  const size_t none[] = {0}, huge[] = {SIZE_MAX};
  const double minus[] = {-1}, nan[] = {GSL_NAN}, zero[] = {0}, tiny[] = {1e-9}, wide[] = {20};
  refused(!randpack_points(3, NULL, 1, forty, one, 1, &out), "side is NULL");
  refused(!randpack_points(1, cube, 1, forty, one, 1, &out), "dim is 1");
  refused(!randpack_points(3, cube, 0, forty, one, 1, &out), "kinds is 0");
  refused(!randpack_points(3, cube, 65535, forty, one, 1, &out), "kinds is 65535");
  refused(!randpack_points(3, cube, 1, NULL, one, 1, &out), "number is NULL");
  refused(!randpack_points(3, cube, 1, none, one, 1, &out), "there is no particle");
  refused(!randpack_points(3, cube, 1, huge, one, 1, &out), "2^29");
  refused(!randpack_points(3, cube, 1, forty, NULL, 1, &out), "radius is NULL");
  refused(!randpack_points(3, cube, 1, forty, nan, 1, &out), "radius[0] is nan");
  refused(!randpack_lattice("hexagonal", 3, 1, 0, &out), "hexagonal is no lattice");
  refused(!randpack_lattice(NULL, 3, 1, 0, &out), "NULL is no lattice");
  refused(!randpack_lattice("bcc", 4, 1, 0, &out), "cells is 4");
  refused(!randpack_lattice("bcc", -1, 1, 0, &out), "cells is -1");
  refused(!randpack_lattice("bcc", 501, 1, 0, &out), "cells is 501");
  refused(!randpack_lattice("bcc", 3, 0, 0, &out), "radius is 0");
  refused(!randpack_lattice("bcc", 3, 1, 0.7, &out), "fraction is 0.7");
  refused(!randpack_lattice("bcc", 3, 1, GSL_NAN, &out), "fraction is nan");
  refused(!randpack_rsa(3, NULL, 1, forty, one, 0, 1, &out), "side is NULL");
  refused(!randpack_rsa(3, cube, 1, forty, one, -0.5, 1, &out), "gap is -0.5");
  refused(!randpack_rsa(3, cube, 1, forty, minus, 0, 1, &out), "radius[0] is -1");
  refused(!randpack_saturate(2, NULL, 1, NULL, one, 0, 1, &out), "side is NULL");
  refused(!randpack_saturate(2, square, 1, minus, one, 0, 1, &out), "a share is -1");
  refused(!randpack_saturate(2, square, 1, zero, one, 0, 1, &out), "every share is 0");
  refused(!randpack_saturate(2, square, 1, NULL, one, GSL_NAN, 1, &out), "gap is nan");
  refused(!randpack_saturate(2, square, 1, NULL, tiny, 0, 1, &out), "the box has room for");
  refused(!randpack_grow(3, 1, forty, one, 0, 0.05, 1, &out), "fraction is 0");
  refused(!randpack_grow(3, 1, forty, one, 1, 0.05, 1, &out), "fraction is 1");
  refused(!randpack_grow(3, 1, forty, one, 0.5, 0, 1, &out), "rate is 0");
  refused(!randpack_grow(5, 1, forty, one, 0.5, 0.05, 1, &out), "dim is 5");
  refused(!randpack_gravity(3, 1, none, one, 1, &out), "there is no particle");
  refused(!randpack_penetrable(NULL, 1, forty, one, 0.25, 1, &out), "side is NULL");
  refused(!randpack_penetrable(square, 1, forty, one, 1.5, 1, &out), "fraction is 1.5");
  refused(!randpack_penetrable(square, 1, forty, wide, 0.5, 1, &out), "larger than the box");
}

static void test_wrong_changes(randpack_pack *pack, randpack_pack *finite, randpack_pack *empty) {
  const size_t forty_[] = {40};
  randpack_pack *points = randpack_points(3, cube, 1, forty_, one, 1, &out);
  refused(randpack_compress(NULL, 0.5, 0.05, 1, &out), "pack is NULL");
  refused(randpack_compress(pack, 2, 0.05, 1, &out), "fraction is 2");
  refused(randpack_compress(pack, 0.6, GSL_NAN, 1, &out), "rate is nan");
  refused(randpack_compress(pack, 0.01, 0.05, 1, &out), "fills");
  refused(randpack_compress(points, 0.5, 0.05, 1, &out), "overlaps");
  refused(randpack_compress(finite, 0.5, 0.05, 1, &out), "that repeats");
  refused(randpack_compress(empty, 0.5, 0.05, 1, &out), "with a particle");
  refused(randpack_jam(points, 0.05, 1, &out), "overlaps");
  refused(randpack_jam(finite, 0.05, 1, &out), "that repeats");
  refused(randpack_jam(pack, -1, 1, &out), "rate is -1");
  refused(randpack_shake(points, 0.1, 1, 1, NULL, &out), "overlap");
  refused(randpack_shake(pack, -0.1, 1, 1, NULL, &out), "window is -0.1");
  refused(randpack_shake(finite, 0.1, 1, 1, NULL, &out), "that repeats");
  refused(randpack_shake(NULL, 0.1, 1, 1, NULL, &out), "pack is NULL");
  randpack_free(points);
}

static void test_wrong_measures(randpack_pack *pack, randpack_pack *finite, randpack_pack *empty) {
  double v[8];
  size_t count[2];
  refused(randpack_write(NULL, "none", &out), "pack is NULL");
  refused(randpack_write(pack, NULL, &out), "path is NULL");
  refused(randpack_fraction(pack, 0, NULL, &out), "fraction is NULL");
  refused(randpack_fraction(NULL, 0, v, &out), "pack is NULL");
  refused(randpack_fraction(pack, -1, v, &out), "radius is -1");
  refused(randpack_fraction(pack, 2.5, v, &out), "radius is 2.5");
  refused(randpack_fraction(pack, GSL_NAN, v, &out), "radius is nan");
  refused(randpack_covered(pack, v, &out), "in two dimensions");
  refused(randpack_covered(pack, NULL, &out), "fraction is NULL");
  refused(randpack_least_gap(NULL, v, &out), "pack is NULL");
  refused(randpack_least_gap(pack, NULL, &out), "gap is NULL");
  refused(randpack_g(pack, 0, 1, 4, v, &out), "ends at 4; give at most 3");
  refused(randpack_g(pack, -1, 1, 2, v, &out), "from is -1");
  refused(randpack_g(pack, 0, 0, 2, v, &out), "step is 0");
  refused(randpack_g(pack, 0, 0.1, 0, v, &out), "0 bins");
  refused(randpack_g(pack, 0, 1e-9, (size_t)1 << 30, v, &out), "1073741824 bins");
  refused(randpack_g(pack, 0, 1, 2, NULL, &out), "results is NULL");
  refused(randpack_g(NULL, 0, 1, 2, v, &out), "pack is NULL");
  refused(randpack_g(empty, 0, 1, 8, v, &out), "ends at 8");
  refused(randpack_K(pack, GSL_NAN, 2, v, &out), "step is nan");
  refused(randpack_K(pack, 2, 2, v, &out), "ends at 4");
  refused(randpack_K(finite, 1, 2, v, &out), "that repeats");
  refused(randpack_contact(pack, NULL, NULL, &out), "value is NULL");
  refused(randpack_contact(finite, v, NULL, &out), "that repeats");
  refused(randpack_contact(empty, v, NULL, &out), "with a particle");
  refused(randpack_neighbours(pack, -1, 2, count, NULL, &out), "tolerance is -1");
  refused(randpack_neighbours(pack, 0, 0, count, NULL, &out), "size is 0");
  refused(randpack_neighbours(pack, 0, 2, NULL, NULL, &out), "count is NULL");
  refused(randpack_structure(pack, 1, 8, NULL, NULL, NULL, &out), "results is NULL");
  refused(randpack_structure(pack, 1e6, 8, NULL, v, NULL, &out), "wave vectors");
  refused(randpack_structure(finite, 1, 8, NULL, v, NULL, &out), "that repeats");
  refused(randpack_S2(finite, 1, 8, v, &out), "that repeats");
  refused(randpack_S2(pack, 0, 8, v, &out), "step is 0");
}

static void test_wrong_theory(void) {
  const double R[] = {2, -1}, share[] = {1, 1}, none[] = {0, 0}, radius[] = {1, 2};
  double v[4];
  refused(randpack_py(0.75, 2, R, v, &out), "phi is 0.75");
  refused(randpack_py(GSL_NAN, 2, R, v, &out), "phi is nan");
  refused(randpack_py(0.5, 2, R, v, &out), "R is -1");
  refused(randpack_py(0.5, 2, NULL, v, &out), "R is NULL");
  refused(randpack_py(0.5, 1, R, NULL, &out), "g is NULL");
  refused(randpack_equation("van der waals", 0.5, v, v, &out), "van der waals is no equation");
  refused(randpack_equation("py", -0.1, v, v, &out), "phi is -0.1");
  refused(randpack_mixture("cs", 2, share, radius, 0.5, v, NULL, &out), "cs is no equation of mixtures");
  refused(randpack_mixture("py", 2, none, radius, 0.5, v, NULL, &out), "every share is 0");
  refused(randpack_mixture("py", 2, NULL, radius, 0.5, v, NULL, &out), "share is NULL");
  refused(randpack_mixture("py", 2, share, none, 0.5, v, NULL, &out), "radius[0] is 0");
  refused(randpack_mixture("py", 2, share, radius, 1, v, NULL, &out), "phi is 1");
}

static void test_wrong(void) {
  const size_t number[] = {1, 1};
  const double x[] = {1, 2, 3, 4, 5, 6}, radius[] = {0.5, 1};
  double v[2];
  randpack_pack *pack = cubic(), *finite = randpack_from_arrays(3, NULL, 2, x, 1, one, NULL, &out);
  randpack_pack *empty = randpack_from_arrays(3, cube, 0, NULL, 1, one, NULL, &out);
  randpack_pack *two = randpack_rsa(3, cube, 2, number, radius, 0, 1, &out);
  test_wrong_arrays();
  test_wrong_makers();
  test_wrong_changes(pack, finite, empty);
  test_wrong_measures(pack, finite, empty);
  test_wrong_theory();
  refused(randpack_contact(two, v, NULL, &out), "several sizes");
  gsl_test(fraction_of(pack) != M_PI / 6 && fabs(fraction_of(pack) - M_PI / 6) > 1e-14, "what was refused has changed nothing");
  gsl_test_int(wrong, 107, "wrong arguments");
  randpack_free(pack);
  randpack_free(finite);
  randpack_free(empty);
  randpack_free(two);
}

int main(void) {
  test_periodic();
  test_finite();
  test_files();
  test_makers();
  test_unreached();
  test_changes();
  test_lattice();
  test_waves();
  test_core();
  test_theory();
  test_wrong();
  gsl_test_str(randpack_version(), RANDPACK_VERSION, "the version");
  return gsl_test_summary();
}
