/* tests/test_xyz.c: what is written is read back bit for bit; errors say where */
#include "many.h"
#include "outcome.h"
#include "rng.h"
#include "same.h"
#include "files.h"
#include "xyz.h"
#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_xyz.XXXXXX";

static void write_to(const char *name, const Pack *pack, const char *note) {
  FILE *file = fopen(name, "w");
  xyz_write(file, pack, note);
  fclose(file);
}

/* Random positions, among them every kind of double that [0, L) holds. */
static Pack *make(int dim, const Species species[], int kinds, bool own) {
  Box box = {dim, {M_PI, 10 * M_SQRT2, dim == 3 ? 1e-3 * M_E : 0}};
  Pack *pack = pack_alloc(&box, species, kinds, own);
  Rng rng = rng_stream(8, (uint64_t)dim, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++) {
    double side = box.side[c % (size_t)dim];
    double odd[] = {0, DBL_TRUE_MIN, DBL_MIN, 1e-17, nextafter(side, 0), 0.1 * side, side / 3};
    pack->x[c] = c < 60 ? odd[rng_below(&rng, 7)] : side * rng_uniform(&rng);
  }
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] = rng_uniform(&rng) * pow(10, 20 * rng_uniform(&rng) - 10) + DBL_MIN;
  return pack;
}

static bool same_species(const Pack *a, const Pack *b) {
  bool same = a->kinds == b->kinds;
  for (int s = 0; same && s < a->kinds; s++)
    same = strcmp(a->species[s].name, b->species[s].name) == 0 && a->species[s].count == b->species[s].count &&
           (a->radius || a->species[s].radius == b->species[s].radius);
  return same;
}

/* Shapes of every kind, and discs between them; angles of every kind of double that [0, 2 pi) holds. */
static Pack *make_shapes(const Species species[], int kinds, bool own) {
  Pack *pack = make(2, species, kinds, own);
  Rng rng = rng_stream(9, 0, RNG_TEST);
  for (size_t i = 0; i < pack->n; i++) {
    const double odd[] = {0, DBL_TRUE_MIN, DBL_MIN, nextafter(2 * M_PI, 0), M_PI, 1e-17, 0.1};
    if (pack_shape(pack, i))
      pack->angle[i] = i % 3 ? 2 * M_PI * rng_uniform(&rng) : odd[rng_below(&rng, 7)];
  }
  return pack;
}

static bool same_array(const void *a, const void *b, size_t bytes) {
  return !a ? !b : b && memcmp(a, b, bytes) == 0;
}

static bool same_files(const char *a, const char *b) {
  FILE *first = fopen(a, "r"), *second = fopen(b, "r");
  int c;
  do
    c = fgetc(first);
  while (c == fgetc(second) && c != EOF);
  bool same = c == EOF && feof(second);
  fclose(first);
  fclose(second);
  return same;
}

static void round_trip(int dim, const Species species[], int kinds, bool own, const char *what) {
  Pack *pack = dim == 2 && species->shape ? make_shapes(species, kinds, own) : make(dim, species, kinds, own);
  Outcome out = {0};
  char again[sizeof path + 6];
  snprintf(again, sizeof again, "%s.again", path);
  write_to(path, pack, "seed=17 realization=3");
  Pack *back = files_read(path, NULL, &out);
  gsl_test(!back, "%d-D, %s: is read back (%s)", dim, what, out.text);
  if (!back)
    return;
  write_to(again, back, "seed=17 realization=3");
  size_t n = pack->n;
  gsl_test(back->n != n || !same_box(&back->box, &pack->box), "%d-D, %s: number and box", dim, what);
  gsl_test(!same_array(pack->x, back->x, n * (size_t)dim * sizeof(double)), "%d-D, %s: positions bit for bit", dim, what);
  gsl_test(!same_array(pack->radius, back->radius, n * sizeof(double)), "%d-D, %s: radii", dim, what);
  gsl_test(!same_array(pack->kind, back->kind, n * sizeof(uint16_t)), "%d-D, %s: indices", dim, what);
  gsl_test(!same_species(pack, back), "%d-D, %s: species", dim, what);
  gsl_test(!same_array(pack->angle, back->angle, n * sizeof(double)), "%d-D, %s: angles bit for bit", dim, what);
  gsl_test(!same_shapes(pack, back), "%d-D, %s: shapes field by field", dim, what);
  gsl_test(!same_files(path, again), "%d-D, %s: written again, the same file", dim, what);
  remove(again);
  pack_free(&pack);
  pack_free(&back);
}

static void test_round_trips(void) {
  static const Species one[] = {{"sphere", 0.1, 211}};
  static const Species many[] = {{"AP", 1.0 / 3, 70}, {"an-odd_name.with:31~characters!", 1e-30, 90}, {"\"7\\[=", 2e17, 40}};
  for (int dim = 2; dim <= 3; dim++) {
    round_trip(dim, one, 1, false, "one species");
    round_trip(dim, many, 3, false, "three species");
    round_trip(dim, one, 1, true, "own radii");
    round_trip(dim, many, 3, true, "three species with own radii");
  }
}

/* Random convex polygons, on an ellipse somewhere, in either order. */
static Shape *some_polygon(Rng *rng, int n) {
  double v[16][2], cx = 5 * rng_uniform(rng), a = pow(10, 4 * rng_uniform(rng) - 2);
  int turn = rng_below(rng, 2) ? 1 : -1;
  Outcome out = {0};
  for (int i = 0; i < n; i++) {
    double angle = turn * 2 * M_PI * (i + 0.7 * rng_uniform(rng)) / n;
    v[i][0] = a * (cos(angle) + cx);
    v[i][1] = sin(angle) - 3;
  }
  Shape *shape = shape_convex(n, (const double(*)[2])v, &out);
  if (!shape)
    gsl_test(1, "a polygon of %d vertices on an ellipse of aspect %g (%s)", n, a, out.text);
  return shape;
}

static void test_shapes(void) {
  Rng rng = rng_stream(12, 0, RNG_TEST);
  Species kinds[] = {{"P]\"\\", 2.5, 40, shape_regular(5)},      {"a=b\"\\", 0.1, 30, shape_superellipse(1.5, 1.5)},
                     {"a", 1.0 / 3, 50, some_polygon(&rng, 7)}, {"disc", 1e-3, 11, NULL},
                     {"rhombus", 7, 3, shape_superellipse(1.7, 0.5)}, {"needle", 1, 9, shape_superellipse(0.02, 50)}};
  round_trip(2, kinds, 1, false, "pentagons");
  round_trip(2, kinds + 1, 1, true, "superellipses with own radii");
  round_trip(2, kinds, 6, false, "six species, five with shapes");
  round_trip(2, kinds, 6, true, "six species with own radii");
  for (int s = 0; s < 6; s++)
    shape_free(&kinds[s].shape);
  int wrong[2] = {0, 0};
  for (int k = 0; k < as_many(60, 4000); k++) {
    double aspect = pow(10, 6 * rng_uniform(&rng) - 3), m = k % 10 ? 0.6 + 10 * gsl_pow_3(rng_uniform(&rng)) : 1;
    Species one = {"S", 1, 1, k % 2 ? some_polygon(&rng, 3 + (int)rng_below(&rng, 9)) : shape_superellipse(aspect, m)};
    Pack *pack = make_shapes(&one, 1, false);
    Outcome out = {0};
    write_to(path, pack, "");
    Pack *back = files_read(path, NULL, &out);
    wrong[k % 2] += !back || !same_shapes(back, pack);
    shape_free(&one.shape);
    pack_free(&pack);
    pack_free(&back);
  }
  gsl_test_int(wrong[0], 0, "random superellipses come back as they were");
  gsl_test_int(wrong[1], 0, "and random polygons");
}

/* The text as a file, read. */
static Pack *read_text(const char *text, Outcome *out) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
  *out = (Outcome){0};
  return files_read(path, NULL, out);
}

#define HEAD "Lattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1"
#define FINITE " pbc=\"F F F\""
#define FLAT HEAD ":angle:R:1 pbc=\"T T F\""
#define SHAPED FLAT " shape_A=\"polygon:5\""

/* What OVITO is told, and what is read of it. */
static void test_viewers(void) {
  static const Box box = {2, {9, 11, 0}};
  Species kinds[] = {{"S", 2.5, 1, shape_superellipse(1.5, 1.25)}, {"P", 1.5, 1, shape_regular(4)}, {"D", 1, 1, NULL}};
  Pack *pack = pack_alloc(&box, kinds, 3, false);
  pack->angle[0] = M_PI / 3;
  pack->angle[1] = 1.5 * M_PI;
  write_to(path, pack, "");
  FILE *file = fopen(path, "r");
  char line[6][600], wanted[200];
  for (int l = 0; l < 5; l++)
    gsl_test(!fgets(line[l], sizeof line[l], file), "line %d is there", l + 1);
  fclose(file);
  gsl_test(!strstr(line[1], " Properties=type:S:1:pos:R:3:radius:R:1:angle:R:1:orientation:R:4:aspherical_shape:R:3:superquadric_roundness:R:2 pbc=\"T T F\" "
                            "shape_S=\"superellipse:1.5:1.25\" shape_P=\"polygon:4\" randpack_species=\"S:2.5 P:1.5 D:1\"\n"), "columns and shapes: %s", line[1]);
  snprintf(wanted, sizeof wanted, " 0 0 0.5 0.866025404 %.9g %.9g 2.5 0.8 1\n", 2.5 * kinds[0].shape->a, 2.5 * kinds[0].shape->b);
  gsl_test(!strstr(line[2], wanted), "a superellipse turned by a third of pi: %s", line[2]);
  gsl_test(!strstr(line[3], " 0 0 0.707106781 -0.707106781 0 0 0 1 1\n"), "a square: %s", line[3]);
  gsl_test(!strstr(line[4], " 1 0 0 0 0 1 0 0 0 1 1\n"), "a disc: %s", line[4]);
  shape_free(&kinds[0].shape);
  pack_free(&pack);
  pack = pack_alloc(&box, kinds + 1, 1, false);
  write_to(path, pack, "");
  file = fopen(path, "r");
  for (int l = 0; l < 2; l++)
    gsl_test(!fgets(line[l], sizeof line[l], file), "line %d is there", l + 1);
  fclose(file);
  gsl_test(strstr(line[1], "aspherical") || !strstr(line[1], ":orientation:R:4 pbc"), "polygons have no axes: %s", line[1]);
  shape_free(&kinds[1].shape);
  pack_free(&pack);
}

static void test_reading_shapes(void) {
  Outcome out;
  Pack *pack = read_text("2\n" SHAPED "\nA 1 2 0 1 -0.5\nB 1 4 0 1 7\n", &out);
  gsl_test(!pack || pack->angle[0] != 2 * M_PI - 0.5 || pack->angle[1] != 7 - 2 * M_PI, "angles are wrapped into [0, 2 pi) (%s)", out.text);
  gsl_test(!pack || pack->species[1].shape || pack->species[0].shape->sides != 5, "a pentagon beside a disc");
  pack_free(&pack);
  pack = read_text("1\n" FLAT " shape_A=\"vertices:0,0,4,0,1,3\"\nA 1 2 0 1 0\n", &out);
  gsl_test(!pack || fabs(pack->species[0].shape->x[1] / pack->species[0].shape->x[0] + 1.4) > 1e-14, "a triangle in any unit");
  pack_free(&pack);
  pack = read_text("1\n" FLAT " \"shape_A=b\"=\"polygon:6\" shape_A=\"polygon:7\" shape_AA=\"polygon:8\"\nA 1 2 0 1 0\n", &out);
  gsl_test(!pack || pack->species[0].shape->sides != 7, "the name of a species ends with its quote");
  pack_free(&pack);
  pack = read_text("1\n" HEAD " pbc=\"T T F\" shape_C=\"round\"\nA 1 2 0 1\n", &out);
  gsl_test(!pack || pack->angle, "the shape of nobody is nobody's");
  pack_free(&pack);
  pack = read_text("1\n" SHAPED "\nA 1 2 0 1 0\n", &out);
  gsl_test(!pack || pack_bytes(2, 1, false, true) != 24 || pack->radius || pack->kind, "no array that is not needed");
  pack_free(&pack);
}

/* Numbers by value, then words, whatever the order of the lines. */
static void test_names(void) {
  static const char *const name[] = {"9", "10", "1a", "nan"};
  Outcome out;
  for (int turn = 0; turn < 24; turn++) {
    char text[512];
    int at = snprintf(text, sizeof text, "4\n" HEAD "\n"), from[4] = {0, 1, 2, 3}, code = turn;
    for (int k = 4; k > 0; k--) { /* the permutation of this number */
      int j = code % k, which = from[j];
      code /= k;
      from[j] = from[k - 1];
      at += snprintf(text + at, sizeof text - (size_t)at, "%s %d 2 3 %d\n", name[which], which + 1, which + 1);
    }
    Pack *pack = read_text(text, &out);
    bool good = pack && pack->kinds == 4;
    for (int s = 0; good && s < 4; s++)
      good = strcmp(pack->species[s].name, name[s]) == 0 && pack->species[s].radius == s + 1;
    gsl_test(!good, "numbers by value, then words, order %d of the lines: %s", turn, out.text);
    pack_free(&pack);
  }
}

static void test_reading(void) {
  Outcome out;
  static const Species none[] = {{"nobody", 0.3, 0}};
  Box box = {3, {2, 3, 4}};
  Pack *pack = pack_alloc(&box, none, 1, false);
  write_to(path, pack, "");
  pack_free(&pack);
  out = (Outcome){0};
  pack = files_read(path, NULL, &out);
  gsl_test(!pack || strcmp(pack->species->name, "nobody") != 0 || pack->species->radius != 0.3, "no particle: species (%s)", out.text);
  pack_free(&pack);
  pack = read_text("0\n" HEAD "\n", &out);
  gsl_test(!pack || pack->n != 0 || pack->kinds != 1 || pack->kind || pack->radius, "an empty pack has one species");
  pack_free(&pack);
  pack = read_text("3\n" HEAD "\nB 1 2 3 1\nA 1 2 4 1\nB 1 2 5 1\n", &out);
  gsl_test(!pack || pack->kinds != 2 || strcmp(pack->species[1].name, "B") != 0 || pack->species[1].count != 2 ||
               pack->kind[1] != 0 || pack->radius,
           "species are in the order of their names");
  pack_free(&pack);
  pack = read_text("3\n" HEAD "\nA 1 2 3 1\nA 1 2 4 1\nA 1 2 5 1.5\n", &out);
  gsl_test(!pack || !pack->radius || pack->radius[2] != 1.5 || pack->kind, "unequal radii are kept one by one");
  pack_free(&pack);
  pack = read_text("1\n" HEAD "\nA 8 -1e-300 -7 1\n", &out);
  gsl_test(!pack || pack->x[0] != 0 || pack->x[1] != 0 || pack->x[2] != 1, "positions are wrapped into [0, L)");
  pack_free(&pack);
}

/* Finite: what we wrote comes back, in whichever dimension. */
static void finite_trip(int dim, size_t n, bool own) {
  Box box = {dim, {12, 12, dim == 3 ? 12 : 0}};
  Species species[] = {{"AP", 1.0 / 3, n}, {"B", 0.1, n}};
  Pack *pack = pack_alloc(&box, species, 2, own);
  Rng rng = rng_stream(4, (uint64_t)dim, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = 3 + 6 * (c < 2 ? (double)c : rng_uniform(&rng)); /* a half, exactly */
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] = rng_uniform(&rng);
  pack->open = M_PI;
  write_to(path, pack, "seed=17");
  Outcome out = {0};
  Pack *back = files_read(path, NULL, &out);
  gsl_test(!back, "%d-D, finite: is read back (%s)", dim, out.text);
  if (!back)
    return;
  gsl_test(back->n != pack->n || back->open != M_PI || !same_box(&back->box, &box),
           "%d-D, finite: radius and box", dim);
  gsl_test(n > 0 && (!same_array(pack->x, back->x, pack->n * (size_t)dim * sizeof(double)) ||
                     !same_array(pack->radius, back->radius, pack->n * sizeof(double)) || !same_species(pack, back)),
           "%d-D, finite: bit for bit", dim);
  pack_free(&back);
  pack_free(&pack);
}

/* Somebody's sample: the same separations about the same middle, in a box where no image is near; and that again. */
static void sample(int dim, const char *open, double told, const double origin[]) {
  const double at[3][3] = {{-2.5, 0.25, 2}, {7.75, 3.5, 0.5}, {4, 0.125, 5.875}}, middle[3] = {4 + origin[0], 2 + origin[1], 3 + origin[2]};
  char text[512];
  Outcome out;
  snprintf(text, sizeof text,
           "3\nLattice=\"8 0 0 0 4 0 0 0 6\" Properties=species:S:1:pos:R:3:radius:R:1" FINITE "%s%s\n"
           "A -2.5 0.25 %s 1\nA 7.75 3.5 %s 1\nB 4 0.125 %s 2\n", open, dim == 2 ? " dimension=2" : "",
           dim == 2 ? "0" : "2", dim == 2 ? "0" : "0.5", dim == 2 ? "0" : "5.875");
  Pack *pack = read_text(text, &out);
  gsl_test(!pack || pack->box.dim != dim, "%d-D, a sample is read: %s", dim, out.text);
  if (!pack)
    return;
  gsl_test(pack->open != told, "%d-D, a sample%s: its radius is %g", dim, open, pack->open);
  double wrong = 0, far = 4;
  for (size_t i = 0; i < 3; i++)
    for (size_t k = 0; k < (size_t)dim; k++) {
      far = fmax(far, fabs(at[i][k] - middle[k]));
      wrong += fabs(pack->x[i * (size_t)dim + k] - pack->box.side[k] / 2 - (at[i][k] - middle[k]));
    }
  gsl_test(!(wrong < 1e-14), "%d-D, a sample: about its middle (%g)", dim, wrong);
  for (int k = 0; k < dim; k++)
    gsl_test(!(pack->box.side[k] >= 4 * far), "%d-D, a sample: a wide box", dim);
  write_to(path, pack, "");
  Pack *back = files_read(path, NULL, &out);
  gsl_test(!back || back->open != told || !same_box(&back->box, &pack->box) ||
               !same_array(pack->x, back->x, 3 * (size_t)dim * sizeof(double)),
           "%d-D, a sample: once placed it stays", dim);
  pack_free(&back);
  pack_free(&pack);
}

/* Packs between walls: wrapped along them, in the middle of a wide side across; and what only looks like one. */
static void test_walls(void) {
  Outcome out = {0};
  Pack *pack = read_text("2\n" HEAD " pbc=\"T F T\" Origin=\"5 -1 5\"\nA -1 2 9 1\nA 1 6 7 1\n", &out);
  gsl_test(!pack || pack->walls != 2 || pack->open != 0, "walls across y");
  if (pack) {
    gsl_test(pack->x[0] != 7 || pack->x[2] != 1 || pack->box.side[0] != 8 || pack->box.side[2] != 8, "wrapped along them");
    gsl_test_rel(pack->x[1] - pack->box.side[1] / 2, -1, 1e-14, "the middle at 3");
    gsl_test(!(pack->box.side[1] >= 16) || pack->sample[1] != 8 || pack->sample[0] != 8, "a wide side across");
    Pack *copy = pack_copy(pack);
    gsl_test(copy->walls != 2 || copy->sample[1] != 8, "a copy has the walls");
    pack_free(&copy);
    pack_free(&pack);
  }
  pack = read_text("1\n" HEAD " pbc=\"F F T\"\nA 1 2 3 1\n", &out);
  gsl_test(!pack || pack->walls != 3, "a pipe");
  if (pack)
    pack_free(&pack);
  pack = read_text("1\n" HEAD " pbc=\"T T F\"\nA 1 2 3 1\n", &out);
  gsl_test(!pack || pack->walls || pack->box.dim != 2, "discs have no walls");
  if (pack)
    pack_free(&pack);
}

static void test_finite(void) {
  Outcome out;
  for (int dim = 2; dim <= 3; dim++) {
    finite_trip(dim, 40, false);
    finite_trip(dim, 40, true);
    finite_trip(dim, 0, false);
    const double corner[] = {0, 0, 0}, other[] = {-1.5, 0.5, 2}, small[] = {0.5, 0, 0};
    sample(dim, "", 2, corner);
    sample(dim, " open=1.75", 1.75, corner);
    sample(dim, " Origin=\"-1.5 0.5 2\"", 2, other);
    sample(dim, " open=1.75 Origin=\"0.5 0 0\"", 1.75, small);
  }
  Pack *pack = read_text("1\n" HEAD " open=5 dimension=2\nA 1 2 3 1\n", &out);
  gsl_test(!pack || pack->open != 0 || pack->box.dim != 3, "a pack that repeats has no radius");
  pack_free(&pack);
  pack = read_text("2\n" HEAD FINITE " open=2 Origin=\"1 0 0\"\nA 1 2 3 1\nA 4 6 7 1\n", &out);
  gsl_test(!pack || pack->x[0] - pack->box.side[0] / 2 != -4, "a wide box that does not begin at 0");
  pack_free(&pack);
  pack = read_text("2\n" HEAD FINITE " open=2\nA 1 2 3 1\nA 4 6 7 1\n", &out);
  gsl_test(!pack || pack->box.side[0] != 8 || pack->x[5] != 7, "places over half of the box: it is wide");
  pack_free(&pack);
  pack = read_text("2\n" HEAD FINITE " open=2\nA 1 2 3 1\nA 4 6.5 7 1\n", &out);
  gsl_test(!pack || pack->box.side[0] < 16, "over more than half of it: it is not");
  pack_free(&pack);
  pack = read_text("2\n" HEAD FINITE " open=2\nA 1 2 4 1\nA 4 6 8 1\n", &out);
  gsl_test(!pack || pack->box.side[0] < 16, "one on the far face: it is not");
  pack_free(&pack);
}

static void test_errors(void) {
  static const struct {
    const char *text, *where, *what;
  } wrong[] = {
      {"", ":1:", "ends here"},
      {"x\n", ":1:", "not a pack"},
      {"1\n" HEAD "\n", ":3:", "ends here"},
      {"1\n" HEAD "\nA 1 2 x 1\n", ":3:", "not a number"},
      {"1\n" HEAD "\nA 1 2 inf 1\n", ":3:", "not finite"},
      {"1\n" HEAD "\nA 1 2 3 0\n", ":3:", "not above 0"},
      {"1\n" HEAD "\nA 1 2 3 1\nA 1 2 3 1\n", ":4:", "more lines"},
      {"1\n" HEAD "\nA 1 2 3 1\n\n1\n" HEAD "\nA 1 2 3 1\n", ":7:", "second pack"},
      {"1\n" HEAD "\nA 1 2 3 1 4\n", ":3:", "6 words"},
      {"1\n" HEAD "\nA 1 2 3\n", ":3:", "4 words"},
      {"1\n" HEAD "\nA 1 2,5 3 1\n", ":3:", "a decimal point"},
      {"1\n" HEAD " pbc=\"T T\"\nA 1 2 3 1\n", ":2:", "three times T or F"},
      {"1\n" HEAD " pbc=\"T T maybe\"\nA 1 2 3 1\n", ":2:", "three times T or F"},
      {"1\n" HEAD " pbc=\"T T T\" pbc=\"F F F\"\nA 1 2 3 1\n", ":2:", "two values of pbc"},
      {"2\n" HEAD " pbc=\"T T F\"\nA 1 2 3 1\nA 1 2 4 1\n", ":4:", "z is not constant"},
      {"1\nLattice=\"8 0 0 0 8 0 4 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "63.43 degrees between its first and third"},
      {"1\nLattice=\"8 0 0 4 6.928 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "60 degrees between its first two"},
      {"1\nLattice=\"8 -8 0 8 8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "turned"},
      {"1\nLattice=\"8 0 0 0 -8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "not above 0"},
      {"1\nLattice=\"8 0 0 0 8 0 0 0\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "nine numbers"},
      {"1\nLattice=\"8 0 0 0 8 0 0 0 8 Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", ":2:", "a quote that does not end"},
      {"1\nProperties=species:S:1:pos:R:3:radius:R:1 pbc=\"T T T\"\nA 1 2 3 1\n", ":2:", "no box"},
      {"1\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3\nA 1 2 3\n", ":2:", "no radii"},
      {"1\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:radius:R:1\nA 1\n", ":2:", "no positions"},
      {"1\n" HEAD ":Radius:R:1\nA 1 2 3 1 1\n", ":2:", "two columns"},
      {"1\n" HEAD " randpack_species=\"A\"\nA 1 2 3 1\n", ":2:", "randpack_species does not"},
      {"1\n" HEAD " randpack_species=\"A:0\"\nA 1 2 3 1\n", ":2:", "randpack_species does not"},
      {"1\n" HEAD FINITE " open=0\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=-1\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=nan\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=inf\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=wide\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " open=3,5\nA 1 2 3 1\n", ":2:", "open is not"},
      {"1\n" HEAD FINITE " Origin=\"1 2\"\nA 1 2 3 1\n", ":2:", "not a point"},
      {"1\n" HEAD FINITE " Origin=\"1 2 inf\"\nA 1 2 3 1\n", ":2:", "not a point"},
      {"1\n" HEAD FINITE " dimension=4\nA 1 2 3 1\n", ":2:", "neither 2 nor 3"},
      {"1\n" HEAD FINITE " dimension=two\nA 1 2 3 1\n", ":2:", "neither 2 nor 3"},
      {"1\n" HEAD FINITE "\nA 1 2 1e308 1\n", ":3:", "a position is beyond 1e50"},
      {"1\n" HEAD "\nA 1 2 1e11 1\n", ":3:", "1e9 boxes away"},
      {"1\n" HEAD "\nA 1 2 3 1e60\n", ":3:", "a radius is not from"},
      {"1\n" HEAD "\nA 1 2 3 1e-60\n", ":3:", "a radius is not from"},
      {"1\nLattice=\"1e60 0 0 0 1e60 0 0 0 1e60\" Properties=pos:R:3:radius:R:1\n1 2 3 1\n", ":2:", "a side of the box is not from"},
      {"1\nProperties=pos:R:3:radius:R:1\n1e30 2 3 1\n", ":3:", "too far from 0, for"},
      {"2\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n1 1 1e50 1\n", ":4:", "too far from 0, for"},
      {"3\n" HEAD " pbc=\"T T F\"\nA 1 2 6e-7 1\nA 1 4 0 1\nA 1 6 -6e-7 1\n", ":5:", "z is not constant"},
      {"3\n" HEAD " pbc=\"T T F\"\nA 1 4 0 1\nA 1 2 6e-7 1\nA 1 6 -6e-7 1\n", ":5:", "z is not constant"},
      {"1\n" HEAD ":v:R\nA 1 2 3 1\n", ":2:", "without a number of columns"},
      {"1\n" HEAD ":v:R:2x\nA 1 2 3 1\n", ":2:", "without a number of columns"},
      {"1\n" HEAD ":v:R:9223372036854775807\nA 1 2 3 1\n", ":2:", "without a number of columns"},
      {"1\n" HEAD ":v:R:9996\nA 1 2 3 1\n", ":2:", "without a number of columns"},
      {"1\n" HEAD " randpack_species=\"A:1 A:2\"\nA 1 2 3 1\n", ":2:", "given twice"},
      {"1\na=] " HEAD " b=[\nA 1 2 3 1\n", ":2:", "a bracket without its partner"},
      {"1\n" SHAPED "\nA 1 2 0 1 inf\n", ":3:", "an angle is not finite"},
      {"1\n" SHAPED "\nA 1 2 0 1 x\n", ":3:", "not a number"},
      {"2\n" FLAT "\nA 1 2 0 1 0\nA 1 2 0 1 0\n", ":2:", "angles without a shape"},
      {"2\n" HEAD " pbc=\"T T F\" shape_B=\"polygon:5\"\nA 1 2 0 1\nB 1 2 0 1\n", ":2:", "without angles"},
      {"1\n" HEAD ":angle:R:1 shape_A=\"polygon:5\"\nA 1 2 0 1 0\n", ":2:", "three dimensions"},
      {"1\n" FLAT " shape_A=\"polygon:2\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"polygon:5.5\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"polygon:5000\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"polygon:5:6\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"polygon:5 \"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"polygon:\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"pentagon:5\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"superellipse:1.5\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"superellipse:-1.5:1\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"superellipse:1.5:0.49\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"superellipse:1.5:0.5000009\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"superellipse:1.5:nan\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"vertices:0,0,1,0\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"vertices:0,0,1,0,0\"\nA 1 2 0 1 0\n", ":2:", "shape that is none"},
      {"1\n" FLAT " shape_A=\"vertices:0,0,1,0,0,1,1,1\"\nA 1 2 0 1 0\n", ":2:", "not strictly convex"},
  };
  Outcome out;
  for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
    Pack *pack = read_text(wrong[w].text, &out);
    gsl_test(pack || out.status != WRONG || !strstr(out.text, path) || !strstr(out.text, wrong[w].where) ||
                 !strstr(out.text, wrong[w].what) || !strchr(out.text, ';'),
             "refused: %s (%s)", wrong[w].what, out.text);
    pack_free(&pack);
  }
  out = (Outcome){0};
  gsl_test(files_read("/nonexistent/pack.xyz", NULL, &out) || out.status != WRONG, "a file that is not there");
}

/* One particle at (1, 2, 3) of radius 0.5 and name N, in a box of 8, in the ways that people and programs write it. */
static void test_dialects(void) {
  static const char *const same[] = {
      "1\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"T T T\"\nN 1 2 3 .5\n",
      "\357\273\2771\r\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\r\nN 1 2 3 .5\r\n",
      " 1 \nLATTICE = '8\t0 0 0 8 0 0 0 8'\tproperties = Species:S:1:POS:R:3:Radius:R:1\nN\t1\t2\t3\t0.5",
      "1\nLattice=[[8,0,0],[0,8,0],[0,0,8]] Properties=species:S:1:pos:R:3:diameter:R:1 pbc=[T, true, True]\nN 1 2 3 1\n\n\n",
      "1\nLattice=\"[[8.0D+00, 0, 0], [0, 8, 0], [0, 0, 8]]\" Properties=radius:R:1:type:S:1:positions:R:3 PBC=\"1 TRUE t\"\n5.d-1 N 1D0 2d0 .3E1\n",
      "1\nLattice={8 0 0 0 8 0 0 0 8} Properties=element:S:1:id:I:1:pos:R:3:radius:R:1:type:I:1\nM 7 1 2 3 0.5 N\n",
      "1\ncomment=\"was Lattice=\\\"3 0 0 0 3 0 0 0 3\\\" pbc=F\" Lattice=\"8 1e-12 0 0 8 0 -1e-12 0 8\" Properties=species:S:1:pos:R:3:radius:R:1 Origin=\"1 1 1\" flag\nN 9 -6 3 0.5\n"};
  Outcome out;
  for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
    Pack *pack = read_text(same[k], &out);
    gsl_test(!pack || pack->n != 1 || pack->open > 0 || pack->box.dim != 3 || pack->box.side[0] != 8 || pack->box.side[2] != 8 ||
                 pack->x[0] != 1 || pack->x[1] != 2 || pack->x[2] != 3 || pack_radius(pack, 0) != 0.5 ||
                 strcmp(pack->species->name, "N") != 0,
             "dialect %zu: %s", k, out.text);
    pack_free(&pack);
  }
  Pack *pack = read_text("1\nProperties=species:S:1:pos:R:3:radius:R:1\nN 1 2 3 0.5\n", &out);
  gsl_test(!pack || pack->open != 0.5 || pack->box.dim != 3, "without a box: a finite pack, as large as its particle (%s)", out.text);
  pack_free(&pack);
  pack = read_text("2\nLattice=\"8 0 0 0 8 0 0 0 0\" Properties=type:I:1:radius:R:1:pos:R:2\n10 .5 1 2\n9 .5 3 4\n", &out);
  gsl_test(!pack || pack->box.dim != 2 || strcmp(pack->species[0].name, "9") != 0 || pack->x[2] != 3, "two columns are discs; numbers as names have values (%s)", out.text);
  pack_free(&pack);
}

/* What the caller knows: discs in a deep box, radii by name. */
static void test_known(void) {
  static const char *const bare = "2\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3\nB 1 2 3 \nA 1 4 3\n";
  Outcome out;
  Species species[] = {{.name = "A", .radius = 0.5}, {.name = "B", .radius = 0.25}};
  GatherKnown known = {2, species, 2};
  pack_free(&(Pack *){read_text(bare, &out)});
  out = (Outcome){0};
  Pack *pack = files_read(path, &known, &out);
  gsl_test(!pack || pack->box.dim != 2 || pack->species[0].radius != 0.5 || pack->species[1].radius != 0.25 || pack->radius,
           "discs with known radii (%s)", out.text);
  pack_free(&pack);
  known.kinds = 1;
  pack = files_read(path, &known, &out);
  gsl_test(!pack || pack->species[1].radius != 0.5, "a species that has the name of none is of all (%s)", out.text);
  pack_free(&pack);
  strcpy(species[1].name, "C");
  known = (GatherKnown){3, species + 1, 1};
  pack = files_read(path, &known, &out);
  gsl_test(pack || !strstr(out.text, ":3: no radius of B"), "a radius that nobody knows (%s)", out.text);
  pack_free(&pack);
  strcpy(species[1].name, "B");
  pack_free(&(Pack *){read_text("2\nplain XYZ has a comment, say a = \"b\nB 1 2 3 .1 .2\nA 1 4 3\n", &out)});
  gsl_test(!strstr(out.text, "quote"), "a comment with half a quote and an equals sign may be anything (%s)", out.text);
  pack_free(&(Pack *){read_text("2\nplain XYZ has a comment\nB 1 2 3 .1 .2\nA 1 4 3\n", &out)});
  gsl_test(!strstr(out.text, "no radii"), "plain XYZ has no radii (%s)", out.text);
  out = (Outcome){0};
  known = (GatherKnown){3, species, 2};
  pack = files_read(path, &known, &out);
  gsl_test(!pack || !(pack->open > 0) || pack->n != 2, "plain XYZ with known radii is a finite pack (%s)", out.text);
  pack_free(&pack);
}

/* Whatever the order of lines: the species, their nominal radii, and what is told of them when the pack is written. */
static void test_order(void) {
  static const char *const line[] = {"B 1 2 3 0.3\n", "A 4 5 6 1\n", "B 7 1 2 0.1\n", "B 3 3 3 0.7\n", "A 2 6 6 1\n"};
  double mean = (0.1 + 0.3 + 0.7) / 3;
  Outcome out;
  for (int turn = 0; turn < 5; turn++) {
    char text[400] = "5\n" HEAD "\n";
    for (int k = 0; k < 5; k++)
      strcat(text, line[(k * (turn % 4 + 1) + turn) % 5]);
    Pack *pack = read_text(text, &out);
    gsl_test(!pack || strcmp(pack->species[0].name, "A") != 0 || pack->species[0].count != 2 || pack->species[0].radius != 1 ||
                 pack->species[1].count != 3 || pack->species[1].radius != mean,
             "lines in order %d: the same species (%s)", turn, out.text);
    for (size_t i = 0; pack && i < 5; i++)
      gsl_test((pack->radius[i] == 1) != (pack_kind(pack, i) == 0), "and each particle is of its own");
    pack_free(&pack);
  }
  Pack *pack = read_text("2\n" HEAD " randpack_species=\"small:0.1 none:7 a:b:2\"\na:b 1 2 3 1\nsmall 1 2 6 .1\n", &out);
  gsl_test(!pack || pack->kinds != 3 || strcmp(pack->species[2].name, "a:b") != 0 || pack->species[1].count || pack->species[2].radius != 2 ||
               pack->radius[0] != 1, "species that are told keep their order and radius (%s)", out.text);
  if (pack) {
    write_to(path, pack, "");
    Pack *back = files_read(path, NULL, &out);
    gsl_test(!back || !same_species(pack, back), "and when they are written again");
    pack_free(&back);
  }
  pack_free(&pack);
}

static void test_frames(void) {
  static const char text[] = "1\n" HEAD "\nA 1 2 3 1\n2\n" HEAD FINITE " open=3\nB 1 2 3 2\nB 1 2 4 2\n\n1\n" HEAD "\nC 1 2 3 1\n \n";
  Outcome out;
  pack_free(&(Pack *){read_text(text, &out)});
  gsl_test(!strstr(out.text, "a second pack"), "one pack is wanted, and there are more (%s)", out.text);
  out = (Outcome){0};
  PackFile file;
  int packs = 0;
  files_open(&file, path, NULL, NULL, &out);
  for (Pack *pack; (pack = files_next(&file)); packs++) {
    gsl_test(pack->n != (packs == 1 ? 2 : 1) || *pack->species->name != 'A' + packs || (pack->open > 0) != (packs == 1), "pack %d of three", packs);
    pack_free(&pack);
  }
  gsl_test(packs != 3 || out.status != DONE, "three packs in a file (%d, %s)", packs, out.text);
  files_close(&file);
}

int main(void) {
  test_walls();
  int file = mkstemp(path);
  close(file);
  test_round_trips();
  test_shapes();
  test_viewers();
  test_names();
  test_reading();
  test_dialects();
  test_known();
  test_order();
  test_frames();
  test_reading_shapes();
  test_finite();
  test_errors();
  remove(path);
  return gsl_test_summary();
}
