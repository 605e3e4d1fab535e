/* tests/test_files.c: dumps, tables and compressed files as packs; the kind of a file is told by its first line */
#include "files.h"
#include "xyz.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

static char path[] = "/tmp/test_files.XXXXXX";
static const Species ball = {.name = "A", .radius = 0.5};
static const GatherKnown space = {3, NULL, 0}, plane = {2, NULL, 0}, balls = {3, &ball, 1}, discs = {2, &ball, 1};

static void put(const char *text) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
}

static Pack *get(const char *text, const GatherKnown *known, Outcome *out) {
  put(text);
  *out = (Outcome){0};
  return files_read(path, known, out);
}

#define DUMP "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS "
#define HEADER "written by hand\n\n3 atoms\n2 atom types # two\n\n-5 5 xlo xhi\n-5 5 ylo yhi\n-5 5 zlo zhi\n"
#define CUBE "pp pp pp\n-5 5\n-5 5\n-5 5\n"

static void test_dumps(void) {
  static const char *const same[] = {
      DUMP CUBE "ITEM: ATOMS id type x y z radius\n1 1 0 0 0 1\n2 2 3 0 4.5 0.5\n",
      DUMP CUBE "ITEM: ATOMS type radius xs ys zs id\n2 0.5 0.8 .5 0.95 9\n1 1 0.5 0.5 0.5 8\n\n",
      DUMP CUBE "ITEM: ATOMS xu yu zu diameter type\n13 0 -5.5 1 2\n-20 10 0 2 1\n",
      DUMP "xy xz yz pp pp pp\n-5 5 0\n-5 5 0.0\n-5 5 0\nITEM: ATOMS x y z radius type\n3 0 4.5 0.5 2\n0 0 0 1 1\n"};
  Outcome out;
  for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
    Pack *pack = get(same[k], &space, &out);
    gsl_test(!pack || pack->n != 2 || pack->kinds != 2 || pack->open > 0 || pack->box.side[2] != 10 || pack->species[0].radius != 1,
             "dump %zu: %s", k, out.text);
    size_t i = pack && pack_kind(pack, 0) == 1 ? 0 : 1;
    gsl_test(!pack || fabs(pack->x[3 * i] - 8) > 1e-14 || fabs(pack->x[3 * i + 2] - 9.5) > 1e-14 || pack_radius(pack, i) != 0.5,
             "dump %zu: places are kept from the corner", k);
    pack_free(&pack);
  }
  Pack *pack = get(DUMP "ff ff ff\n-5 5\n-5 5\n-5 5\nITEM: ATOMS x y z radius\n0 0 0 1\n2 2 2 1\n", &space, &out);
  gsl_test(!pack || pack->open != 5, "a finite dump (%s)", out.text);
  pack_free(&pack);
  pack = get(DUMP "pp pp pp\n0 8\n0 9\n-.5 .5\nITEM: ATOMS x y z radius\n1 1 0 1\n5 5 0 1\n", &plane, &out);
  gsl_test(!pack || pack->box.dim != 2 || pack->box.side[1] != 9 || pack->x[2] != 5, "discs (%s)", out.text);
  pack_free(&pack);
  pack = get(DUMP CUBE "ITEM: ATOMS id x y z\n1 0 0 0\n2 3 0 4.5\n", &balls, &out);
  gsl_test(!pack || pack->species->radius != 0.5, "a radius that is known (%s)", out.text);
  pack_free(&pack);
  put(DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n2 2 2 1\n" DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 1 1\n3 2 2 1\n");
  PackFile file;
  int packs = 0;
  out = (Outcome){0};
  files_open(&file, path, &space, NULL, &out);
  for (; (pack = files_next(&file)); packs++)
    pack_free(&pack);
  files_close(&file);
  gsl_test(packs != 2 || out.status != DONE, "two times of a dump are two packs (%d, %s)", packs, out.text);
}

static void test_tables(void) {
  static const char *const same[] = {"1 2 3 .5\n4 5 6 1\n",
                                     "# x y z r\n\n1\t2\t3\t.5\n4\t5\t6\t1\n! end\n",
                                     "x,y,z,radius\n1,2,3,0.5\n4,5,6,1\n",
                                     "# a pack\r# radius; x; y; z\r# in mm\r.5 1 2 3\r\r1 4 5 6",
                                     "!x,z,y,D\r\n1\t3\t2\t1.0\n4\t6\t5\t2\n",
                                     "\"Z [mm]\"; \"X [mm]\"; \"Y [mm]\"; \"Diameter [mm]\"; Type\r\n3;1;2;1;A\r\n6;4;5;2;A\r\n",
                                     "// of a spreadsheet\nid, Radius , X,Y,Z , note\n7, .5 , 1,2,3, a b\n8,1,4,5,6,\n"};
  static const Box box = {3, {10, 11, 12}};
  Outcome out;
  for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
    Pack *pack = get(same[k], &space, &out);
    gsl_test(!pack || pack->n != 2 || !pack->radius || pack->radius[0] != 0.5 || pack->radius[1] != 1 || !(pack->open > 0) ||
                 fabs(pack->x[3] - pack->x[0] - 3) > 1e-14 || fabs(pack->x[5] - pack->x[2] - 3) > 1e-14 || pack->kinds != 1,
             "table %zu: %s", k, out.text);
    pack_free(&pack);
    PackFile file;
    files_open(&file, path, &space, &box, &out);
    pack = files_next(&file);
    gsl_test(!pack || pack->open > 0 || pack->box.side[2] != 12 || pack->x[4] != 5 || files_next(&file) || out.status, "table %zu in a box", k);
    pack_free(&pack);
    files_close(&file);
  }
  Pack *pack = get("1 2 3\n4 5 6\n", &plane, &out);
  gsl_test(!pack || pack->box.dim != 2 || !pack->radius || pack->radius[1] != 6, "x, y and a radius in the plane (%s)", out.text);
  pack_free(&pack);
  pack = get("1 2 3\n4 5 6\n", &balls, &out);
  gsl_test(!pack || pack->box.dim != 3 || pack->species->radius != 0.5, "x, y, z in space, with a known radius (%s)", out.text);
  pack_free(&pack);
  static const Species unnamed = {.name = "1", .radius = 0.25};
  static const GatherKnown one = {3, &unnamed, 1};
  pack = get("x y z name\n1 2 3 Al\n4 5 6 Si\n", &one, &out);
  gsl_test(!pack || pack->kinds != 2 || pack->species[1].radius != 0.25, "a radius without a name is of all (%s)", out.text);
  pack_free(&pack);
  pack = get("2\n\n1.5 2 3 4\n5.5 6 7 8\n", &balls, &out);
  gsl_test(pack || !strstr(out.text, ":3: the species is a number with decimals"), "a table below its number of lines (%s)", out.text);
  pack_free(&pack);
  pack = get("2\n\n6 2 3 4\n14 6 7 8\n", &balls, &out);
  gsl_test(!pack || pack->kinds != 2 || strcmp(pack->species[1].name, "14") != 0, "elements by their number (%s)", out.text);
  pack_free(&pack);
  pack = get("1 2\n4 5\n", &discs, &out);
  gsl_test(!pack || pack->n != 2 || pack->species->radius != 0.5, "x, y in the plane (%s)", out.text);
  pack_free(&pack);
}

/* One radius for all by the fraction: of balls, of discs, of a finite sample; not of some particles. */
static void test_estimate(void) {
  static const GatherKnown third = {3, NULL, 0, 1. / 3}, flat = {2, NULL, 0, 0.25};
  static const Box box = {3, {2, 3, 4}};
  const char *sample = "2\nLattice=\"2 0 0 0 3 0 0 0 4\" pbc=\"F F F\" Properties=pos:R:3\n1 1 1\n1 2 3\n";
  double radius = cbrt(24. / 3 / 2 / (4 * M_PI / 3));
  Outcome out;
  Pack *pack = get(sample, &third, &out);
  gsl_test(!pack || pack->radius || fabs(pack->species->radius - radius) > 1e-15 || !pack->species->guessed || !(pack->open > 0), "of a finite sample (%s)", out.text);
  pack_free(&pack);
  put("1 1 1\n1 2 3\n");
  PackFile file;
  files_open(&file, path, &third, &box, &out);
  pack = files_next(&file);
  gsl_test(!pack || fabs(pack->species->radius - radius) > 1e-15 || fabs(pack_fraction(pack) - 1. / 3) > 1e-15, "of a table in a box (%s)", out.text);
  pack_free(&pack);
  files_close(&file);
  pack = get(DUMP CUBE "ITEM: ATOMS type x y\n1 0 0\n2 2 2\n", &flat, &out);
  gsl_test(!pack || pack->kinds != 2 || fabs(pack->species[1].radius - sqrt(25 / M_PI / 2)) > 1e-15, "of discs in a dump (%s)", out.text);
  pack_free(&pack);
  pack = get(DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n2 2 2 1\n", &third, &out);
  gsl_test(!pack || pack->species->radius != 1 || pack->species->guessed, "a radius that is told is not estimated (%s)", out.text);
  pack_free(&pack);
  pack = get("1 1 1\n1 2 3\n", &third, &out);
  gsl_test(pack || !strstr(out.text, "no box to estimate them from; "), "no box: %s", out.text);
  pack = get(HEADER "\nAtoms # ellipsoid\n\n3 1 0 1 0 0 0\n1 2 1 1 3 0 4.5\n2 1 1 1 3 4 1\n\nEllipsoids\n\n1 1 1 1 1 0 0 0\n2 1 1 1 1 0 0 0\n", &third, &out);
  gsl_test(pack || !strstr(out.text, "radii of some particles only; "), "some radii: %s", out.text);
}

/* The same bytes, by gzip; and cut short. */
static void test_compressed(void) {
  static const char text[] = "2\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\nB 4 5 6 1\n";
  char packed[400];
  Outcome out = {0};
  gzFile gz = gzopen(path, "wb");
  gzputs(gz, text);
  gzclose(gz);
  Pack *pack = files_read(path, NULL, &out);
  gsl_test(!pack || pack->n != 2 || pack->kinds != 2, "a compressed file (%s)", out.text);
  pack_free(&pack);
  FILE *file = fopen(path, "rb");
  size_t length = fread(packed, 1, sizeof packed, file);
  fclose(file);
  for (size_t cut = 12; cut < length; cut++) {
    file = fopen(path, "wb");
    fwrite(packed, 1, cut, file);
    fclose(file);
    out = (Outcome){0};
    pack = files_read(path, NULL, &out);
    gsl_test(pack || out.status != WRONG || !strstr(out.text, "pack it again"), "cut after %zu bytes: %s", cut, out.text);
    pack_free(&pack);
  }
  out = (Outcome){0};
  gsl_test(files_read("/tmp", NULL, &out) || out.status != WRONG, "a directory (%s)", out.text);
}

/* Lines of any length, given back, without their ends. */
static void test_lines(void) {
  Outcome out = {0};
  Lines lines;
  FILE *file = fopen(path, "w");
  for (int k = 0; k < 300000; k++)
    fputc('a' + k % 26, file);
  fputs("\r\n\nend", file);
  fclose(file);
  gsl_test(!lines_open(&lines, path, &out) || !lines_next(&lines) || strlen(lines.line) != 300000 || lines.line[299999] != 'a' + 299999 % 26, "a long line");
  lines_again(&lines);
  gsl_test(!lines_next(&lines) || strlen(lines.line) != 300000 || lines.number != 1, "and once more");
  gsl_test(!lines_next(&lines) || *lines.line || !lines_next(&lines) || strcmp(lines.line, "end") != 0, "an empty one, and one without an end");
  gsl_test(lines_next(&lines) || lines_next(&lines) || lines.number != 4 || out.status, "the end, and the end");
  lines_close(&lines);
  static const char odd[] = "\r\r\n\na\rb\r";
  char flat[16] = "";
  put(odd);
  lines_open(&lines, path, &out);
  for (int k = 0; k < 2; k++) {
    lines_keep(&lines);
    while (lines_next(&lines))
      strcat(strcat(flat, lines.line), ";");
    lines_back(&lines);
  }
  gsl_test(strcmp(flat, ";;;a;b;;;;a;b;") != 0 || out.status, "the ends of lines of every system, twice: %s", flat);
  lines_close(&lines);
}

/* Ends of lines where a part of the file ends, and bytes of zero. */
static void test_bytes(void) {
  int wrong = 0;
  for (int n = 65533; n < 65540; n++) {
    Outcome out = {0};
    Lines lines;
    FILE *file = fopen(path, "w");
    for (int k = 0; k < n; k++)
      fputc('x', file);
    fputs("\r\ny\n", file);
    fclose(file);
    lines_open(&lines, path, &out);
    wrong += !lines_next(&lines) || strlen(lines.line) != (size_t)n || !lines_next(&lines) || strcmp(lines.line, "y") != 0 || lines_next(&lines);
    lines_close(&lines);
  }
  gsl_test_int(wrong, 0, "a return and a newline in two parts of a file");
  for (int at = 0; at < 12; at++) {
    char text[] = "1 2 3 1\n4 5 6 1\n";
    Outcome out = {0};
    FILE *file = fopen(path, "w");
    text[at] = '\0';
    fwrite(text, 1, sizeof text - 1, file);
    fclose(file);
    Pack *pack = files_read(path, &space, &out);
    gsl_test(pack || !strstr(out.text, at < 8 ? ":1: a byte of zero; " : ":2: a byte of zero; "), "a byte of zero at %d: %s", at, out.text);
    pack_free(&pack);
  }
}

/* Data files of LAMMPS: the same three balls in every style that tells sizes. */
static void test_data(void) {
  static const char *const same[] = {
      HEADER "\nMasses\n\n1 1\n2 1 # Atoms\n\nAtoms # sphere\n\n3 1 2 1 0 0 0\n1 2 1.0 1 3 0 4.5 1 0 -1 # far\n2 1 2 1 13 -6 1d0\n\nVelocities\n\n1 0 0 0 0 0 0\n",
      HEADER "0 0 0.0 xy xz yz\n\nAtoms  # bpm/sphere\n\n3 7 1 2 1 0 0 0 0 0 0\n2 7 1 2 1 3 4 1 0 0 0\n1 7 2 1 1 3 0 4.5 0 0 0\n",
      HEADER "2 ellipsoids\n1 angles\n3 s\n0 triangles\n\nAtoms # ellipsoid\n\n3 1 1 1 0 0 0\n1 2 1 1 3 0 4.5\n2 1 1 1 3 4 1\n\n\nEllipsoids\n\n1 1 1 1 1 0 0 0\n2 2 2 2 1 0 0 0\n3 2 2 2 1 0 0 0\n\n"};
  Outcome out;
  for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
    Pack *pack = get(same[k], &space, &out);
    gsl_test(!pack || pack->n != 3 || pack->kinds != 2 || pack->open > 0 || pack->box.side[2] != 10 || pack->radius, "data file %zu: %s", k, out.text);
    gsl_test(!pack || pack->species[0].radius != 1 || pack->species[0].count != 2 || pack->species[1].radius != 0.5 || strcmp(pack->species[1].name, "2") != 0,
             "data file %zu: radii of the types", k);
    double at[3] = {0, 0, 0};
    for (size_t i = 0; pack && i < 3; i++)
      for (int c = 0; c < 3; c++)
        at[c] += (double)(pack_kind(pack, i) + 1) * pack->x[3 * i + (size_t)c];
    gsl_test(fabs(at[0] - 29) + fabs(at[1] - 24) + fabs(at[2] - 30) > 1e-13, "data file %zu: places from the corner (%g %g %g)", k, at[0], at[1], at[2]);
    pack_free(&pack);
  }
  Pack *pack = get(HEADER "\nAtoms\n\n1 1 0 0 0\n2 1 3 0 0\n3 1 0 3 0\n", &balls, &out);
  gsl_test(!pack || pack->kinds != 1 || pack->species->radius != 0.5, "points with a known radius (%s)", out.text);
  pack_free(&pack);
  pack = get(HEADER "\nAtoms\n\n1 1 1 1 0 0 0\n2 1 1 1 3 0 0\n3 1 1 1 0 3 0\n", &balls, &out);
  gsl_test(pack || !strstr(out.text, ":12: the section Atoms names no style"), "seven words could be a sphere or an ellipsoid (%s)", out.text);
  pack = get("of discs\n\n1 atoms\n0 8 xlo xhi\n0 9 ylo yhi\nAtoms # charge\n\n1 1 -1 7 8 0.0\n", &discs, &out);
  gsl_test(!pack || pack->box.dim != 2 || pack->box.side[1] != 9 || pack->x[1] != 8, "discs, where z may be left out (%s)", out.text);
  pack_free(&pack);
}

static void test_errors(void) {
  static const struct {
    const char *text, *where, *what;
  } wrong[] = {
      {DUMP "xy xz yz pp pp pp\n-5 5 1\n-5 5 0\n-5 5 0\nITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1 1\n", ":8:", "84.29 degrees between its first two"},
      {DUMP CUBE "ITEM: ATOMS x y z\n0 0 0\n1 1 1\n", ":9:", "no radii"},
      {DUMP CUBE "ITEM: ATOMS x z radius\n0 0 1\n1 1 1\n", ":9:", "no positions"},
      {DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n", ":11:", "ends here"},
      {DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1\n", ":11:", "3 words, but ITEM: ATOMS names 4 columns"},
      {DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n1 1 q 1\n", ":11:", "q is not a number"},
      {DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1 0\n", ":11:", "not above 0"},
      {DUMP CUBE, ":9:", "particles are missing"},
      {DUMP CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1 1\n2 2 2 1\n", ":12:", "more lines than particles"},
      {DUMP "\n-5 5\n-5 5\n-5 5\nITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1 1\n", ":5:", "does not say whether it is periodic"},
      {DUMP "xy xz yz pp pp pp\n-5 5 0\n-5 6 2\n-5 5 1\nITEM: ATOMS x y z radius\n0 0 0 1\n1 1 1 1\n", ":8:", "78.74 degrees between its first and third"},
      {DUMP "abc origin pp pp pp\n-1 10 0 0\n0 10 0 0\n0 0 10 0\n", ":6:", "no bounds"},
      {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1.5\n", ":4:", "no number"},
      {"ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS " CUBE "ITEM: ATOMS x y z radius\n0 0 0 1\n", ":7:", "no number of particles before"},
      {DUMP "pp pp pp\n5 -5\n", ":6:", "no bounds"},
      {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\nx\n", ":4:", "no number"},
      {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z radius\n0 0 0 1\n", ":5:", "no box before"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n", ":14:", "the file ends here"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n3 1 1 1 1 1 x\n", ":14:", "x is not a number"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n3 1 0 1 1 1 2\n", ":14:", "not above 0"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n3 1 -1 1 1 1 2\n", ":14:", "not above 0"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1 0\n", ":13:", "8 words, and the style has 7"},
      {HEADER "\nAtoms # sphere\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n3 1 1 1 1 1 2\n\n4 1 1 1 2 2 2\n", ":16:", "more lines than particles"},
      {HEADER "\nAtoms\n\n1 1 1 1 0 0 0\n2 1 1 1 1 1 1\n3 1 1 1 1 1 2\n", ":10:", "no radii"},
      {HEADER "\nAtoms # dipole\n\n", ":10:", "particles of the style dipole"},
      {HEADER "\nAtoms # atomic\n\n", ":10:", "no radii"},
      {HEADER "\nMasses\n\n1 1\n", ":13:", "the section Atoms is missing"},
      {HEADER "5 0 0 xy xz yz\n\nAtoms # sphere\n", ":9:", "63.43 degrees between its first two"},
      {HEADER "10 0 0 avec\n", ":9:", "any three vectors"},
      {HEADER "3 bodies\n", ":9:", "no balls"},
      {HEADER "2 1 xlo xhi\n", ":9:", "no bounds"},
      {"LAMMPS\n1e30 atoms\n", ":2:", "no number of particles"},
      {"LAMMPS\n1 atoms\n0 1 xlo xhi\n\nAtoms # sphere\n\n", ":4:", "ends without a box"},
      {HEADER "\nAtoms # ellipsoid\n\n3 1 1 1 0 0 0\n1 2 1 1 3 0 4.5\n2 1 1 1 3 4 1\n\nEllipsoids\n\n1 1 2 1 1 0 0 0\n", ":18:", "an ellipsoid with unequal axes"},
      {HEADER "\nAtoms # ellipsoid\n\n3 1 1 1 0 0 0\n1 2 1 1 3 0 4.5\n2 1 1 1 3 4 1\n\nEllipsoids\n\n1 1 1 1 1 0 0 0\n", ":14:", "an ellipsoid without axes"},
      {HEADER "\nAtoms # ellipsoid\n\n3 1 0 1 0 0 0\n1 2 1 1 3 0 4.5\n2 1 1 1 3 4 1\n\nEllipsoids\n\n3 1 1 1 1 0 0 0\n", ":18:", "no ellipsoid"},
      {HEADER "\nAtoms # ellipsoid\n\n3 1 1 1 0 0 0\n1 2 1 1 3 0 4.5\n1 1 1 1 3 4 1\n\nEllipsoids\n\n", ":16:", "two particles have the same number"},
      {"of nothing\n0 atoms\n-5 5 xlo xhi\n-5 5 ylo yhi\n-5 5 zlo zhi\nEllipsoids\n\n1 1 1 1 1 0 0 0\n", ":8:", "no ellipsoid"},
      {"1 2 3\n4 5 6\n", ":1:", "not a pack"},
      {"1 2 3 1\n4 5 6\n", ":2:", "3 words in this line, and 4 in the first"},
      {"1 2 3 1\n4 5 6,5 1\n", ":2:", "a decimal point"},
      {"x y z r\n1 2 3 q\n", ":2:", "q is not a number"},
      {"x y z r\n1 2 3 -1\n", ":2:", "not above 0"},
      {"x y z r\n1 2 nan 1\n", ":2:", "not finite"},
      {"x y z\n1 2 3\n", ":1:", "no radii"},
      {"hello\n", ":1:", "not a pack"},
      {"# radius x y z of balls\n1 2 3 1\n", ":2:", "4 words in this line, and 6 in the comment"},
      {"1,5 2,5 3,5 0,5\n", ":1:", "a decimal point"},
      {"1,5\t2,5\t3,5\t0,5\n", ":1:", "a decimal point"},
      {"1,5;2,5;3,5;0,5\n", ":1:", "a decimal point"},
      {"1, 2, 3\n", ":1:", "not a pack"},
      {"x,y,z,r,name\n1,2,3,1,\n", ":2:", "not a name"}};
  Outcome out;
  for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
    Pack *pack = get(wrong[w].text, &space, &out);
    gsl_test(pack || out.status != WRONG || !strstr(out.text, wrong[w].where) || !strstr(out.text, wrong[w].what) || !strchr(out.text, ';'),
             "refused: %s (%s)", wrong[w].what, out.text);
    pack_free(&pack);
  }
}

int main(void) {
  close(mkstemp(path));
  test_dumps();
  test_tables();
  test_data();
  test_estimate();
  test_compressed();
  test_lines();
  test_bytes();
  test_errors();
  remove(path);
  return gsl_test_summary();
}
