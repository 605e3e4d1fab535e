/* tests/test_sheet.c: tables are read again, and their columns tell what is drawn */
#include "sheet.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static Sheet *table(const char *text, Outcome *out) {
  char path[] = "/tmp/randpack-sheet-XXXXXX";
  int file = mkstemp(path);
  if (file < 0 || write(file, text, strlen(text)) != (ssize_t)strlen(text))
    exit(1);
  close(file);
  Sheet *sheet = sheet_read(path, out);
  unlink(path);
  return sheet;
}

#define HEADER "# what it is\n# scene a.scene, seed 5, packs 2\n# unit of length a = 1\n"

static void test_reading(void) {
  Outcome out = {0};
  Sheet *s = table(HEADER "# randpack 0.1.0, fingerprint 0\n# make.growth = 0.1\n# fraction = 0.6\n"
                          "R\tg\tg_err\n2.5\t1.75\t0.125\n# a remark\n3\t-nan\tnan\n",
                   &out);
  gsl_test(!s || out.status, "a table is read: %s", out.text);
  if (!s)
    return;
  gsl_test_str(s->what, "what it is", "its first line");
  gsl_test_str(s->origin, "scene a.scene, seed 5, packs 2", "what made it");
  gsl_test_str(s->swept, "growth = 0.1, fraction = 0.6", "the values of the sweep");
  gsl_test(s->columns != 3 || s->rows != 2, "three columns, two rows");
  gsl_test_rel(sheet_number(s, 0, 1), 1.75, 1e-15, "a number");
  gsl_test(!gsl_isnan(sheet_number(s, 1, 1)), "none is NaN");
  sheet_free(&s);
  gsl_test(s != NULL, "it is freed");
}

/* The traces of a table with these columns and rows, one a line: name stem x y error theory from step. */
static void test_traces(const char *name, const char *rows, const char *want) {
  char text[4000], found[4000] = "";
  Outcome out = {0};
  SheetTrace trace[64];
  snprintf(text, sizeof text, HEADER "%s", rows);
  Sheet *s = table(text, &out);
  int n = s ? sheet_traces(s, trace, 64) : -1;
  for (int t = 0; t < n; t++) {
    size_t at = strlen(found);
    snprintf(found + at, sizeof found - at, "%s/%s %zu %zu %zu %d %zu/%zu\n", trace[t].name, trace[t].stem, trace[t].x,
             trace[t].y, trace[t].error, trace[t].theory, trace[t].from, trace[t].step);
  }
  gsl_test_str(found, want, "%s", name);
  sheet_free(&s);
}

static void test_roles(void) {
  test_traces("a function", "R\tg\tg_err\n2\t1\t.1\n3\t1\t.1\n", "g/g 0 1 2 0 0/1\n");
  test_traces("what changed is not drawn", "R\tg\tg_err\tchange\tchange_err\n2\t1\t.1\t3\t4\n3\t1\t.1\t3\t4\n",
              "g/g 0 1 2 0 0/1\n");
  test_traces("theory behind the errors", "ka\tS\tS_err\tchi\tchi_err\tS_py\n1\t2\t3\t4\t5\t6\n2\t2\t3\t4\t5\t6\n",
              "S/S 0 1 2 0 0/1\nchi/chi 0 3 4 0 0/1\nS_py/S 0 5 0 1 0/1\n");
  test_traces("places between them",
              "R\tcommon\tg\tg_err\tedge\tK\tK_err\tpy\n1\t2\t3\t4\t5\t6\t7\t8\n2\t2\t3\t4\t5\t6\t7\t8\n",
              "g/g 0 2 3 0 0/1\nK/K 4 5 6 0 0/1\npy/py 0 7 0 1 0/1\n");
  test_traces("pairs of species", "R\tS2\tS2_err\tS2_A_B\tS2_A_B_err\n0\t2\t3\t4\t5\n1\t2\t3\t4\t5\n",
              "S2/S 0 1 2 0 0/1\nS2_A_B/S 0 3 4 0 0/1\n");
  test_traces("lines without errors, and an answer", "R\tI\tcomplete\n2\t6\t1\n3\t8\t0\n", "I/ 0 1 0 0 0/1\n");
  test_traces("three rows at a place",
              "step\tg\tg_err\n1\t2\t0\n1\t3\t0\n1\t4\t0\n2\t2\t0\n2\t3\t0\n2\t4\t0\n",
              "g, row 1/g 0 1 2 0 0/3\ng, row 2/g 0 1 2 0 1/3\ng, row 3/g 0 1 2 0 2/3\n");
  test_traces("by species", "species\ta\tnumber\tby_law\n1\t.5\t.2\t.3\n1\t1\t1\t1\n2\t3\t.5\t.4\n",
              "species 1, number/ 1 2 0 0 0/1\nspecies 2, number/ 1 2 0 0 0/1\n"
              "species 1, by_law/ 1 3 0 0 0/1\nspecies 2, by_law/ 1 3 0 0 0/1\n");
  test_traces("a single row", "M\tcontact\tcontact_err\n0\t2\t3\n", "contact/contact 0 1 2 0 0/1\n");
  test_traces("no row", "M\tcontact\tcontact_err\n", "contact/contact 0 1 2 0 0/1\n");
}

static void test_places(void) {
  Outcome out = {0};
  Sheet *s = table("theta\tR1\tR2\tS3\tS3_err\n0\t0\t0\t1\t0\n", &out);
  gsl_test_int((int)sheet_places(s), 3, "three places before what was measured");
  sheet_free(&s);
  SheetTrace one[1];
  s = table("R\tg\tg_err\tK\tK_err\n2\t1\t0\t1\t0\n", &out);
  gsl_test_int(sheet_traces(s, one, 1), 2, "of two curves there is room for one");
  sheet_free(&s);
  s = table("R\tpy_0.3\n2\t1\n", &out);
  gsl_test_int((int)sheet_places(s), 0, "nothing was measured");
  sheet_free(&s);
}

static void test_units(void) {
  static const struct {
    const char *what, *name, *want;
    bool alone;
  } unit[] = {
      {"density of distances in the matrix, in 1/a", "P", "1/a", true},
      {"surface and surface, in 1/a^2", "F", "1/a^2", true},
      {"Ripley's K in units of a^d; R = r/a", "K", "a^d", true},
      {"by pair: K in a^d and n, the m around a k, at its edge", "K", "a^d", false},
      {"by pair: K in a^d and n, the m around a k, at its edge", "n", "", false},
      {"S; chi: spectral density of the solid in a^d; S_py: of Percus", "chi", "a^d", false},
      {"S; chi: spectral density of the solid in a^d; S_py: of Percus", "S", "", false},
      {"radial distribution function; R = r/a is the middle of a bin", "g", "", true},
      {"centres in a window", "p", "", true},
      {"what is in all, by and large", "g", "", true},
      {"wandered in a^2", "wandered", "a^2", false},
  };
  for (size_t k = 0; k < sizeof unit / sizeof *unit; k++) {
    char found[16];
    Sheet s = {.what = (char *)(size_t)unit[k].what};
    sheet_unit(&s, unit[k].name, unit[k].alone, found);
    gsl_test_str(found, unit[k].want, "the unit of %s: %s", unit[k].name, unit[k].what);
  }
}

static void test_wrong(void) {
  static const char *const wrong[] = {"", "# only\n# a header\n", "one\n1\n", "R\tg\n2\n", "R\tg\n2\t3\t4\n"};
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    Outcome out = {0};
    Sheet *s = table(wrong[k], &out);
    gsl_test(s || out.status != WRONG || !strchr(out.text, ';'), "no table %zu: %s", k, out.text);
  }
  Outcome out = {0};
  gsl_test(sheet_read("/nonexistent/table.tsv", &out) || out.status != WRONG, "no file: %s", out.text);
}

int main(void) {
  test_reading();
  test_roles();
  test_places();
  test_units();
  test_wrong();
  exit(gsl_test_summary());
}
