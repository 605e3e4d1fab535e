/* tests/test_table.c: a table is whole or absent; means and errors; the fingerprint */
#include "outcome.h"
#include "table.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char place[] = "/tmp/test_table.XXXXXX";

static bool there(const char *name) {
  char full[4096];
  snprintf(full, sizeof full, "%s/%s", place, name);
  return access(full, F_OK) == 0;
}

static bool holds(const char *name, const char *text) {
  char full[4096], found[4096] = "";
  snprintf(full, sizeof full, "%s/%s", place, name);
  FILE *file = fopen(full, "r");
  if (!file)
    return false;
  found[fread(found, 1, sizeof found - 1, file)] = '\0';
  fclose(file);
  return strcmp(found, text) == 0;
}

static void test_whole(void) {
  Table table;
  Outcome out = {0};
  static const double row[] = {1. / 3, -2e-300, 6.02214076e23, 4};
  gsl_test_int(table_open(&table, place, "a.tsv", &out), DONE, "a table is opened");
  table_row(&table, row, 4);
  fflush(table.file);
  gsl_test(there("a.tsv") || !there("a.tsv.part"), "until it is closed it has another name");
  gsl_test_int(table_close(&table, &out), DONE, "it is closed");
  gsl_test(!there("a.tsv") || there("a.tsv.part"), "then it has its own");
  gsl_test(!holds("a.tsv", "0.333333333333\t-2e-300\t6.02214076e+23\t4\n"), "twelve digits, tabs");
  table_open(&table, place, "a.tsv", &out);
  table_row(&table, row, 1);
  outcome_set(&out, UNREACHED, "jammed");
  gsl_test_int(table_close(&table, &out), UNREACHED, "a failure is handed on");
  gsl_test(there("a.tsv.part") || !holds("a.tsv", "0.333333333333\t-2e-300\t6.02214076e+23\t4\n"),
           "and leaves the old table");
}

static void test_failure(void) {
  Table table;
  Outcome out = {0};
  char directory[4096], part[4096];
  snprintf(directory, sizeof directory, "%s/x/y//z/", place);
  gsl_test(table_open(&table, directory, "b.tsv", &out) || table_close(&table, &out) || !there("x/y/z/b.tsv"),
           "directories are made");
  snprintf(directory, sizeof directory, "%s/a.tsv", place);
  gsl_test_int(table_open(&table, directory, "b.tsv", &out), UNREACHED, "a file is no directory");
  gsl_test(!strstr(out.text, "a.tsv/b.tsv: cannot be written"), "and that is said: %s", out.text);
  gsl_test_int(table_close(&table, &out), UNREACHED, "closing what was not opened");
  out = (Outcome){0};
  snprintf(part, sizeof part, "%s/c.tsv.part", place);
  gsl_test(symlink("/dev/full", part), "a full disk");
  table_open(&table, place, "c.tsv", &out);
  fprintf(table.file, "1\n");
  gsl_test_int(table_close(&table, &out), UNREACHED, "a full disk is noticed");
  gsl_test(there("c.tsv") || there("c.tsv.part"), "and leaves nothing");
}

static void test_mean(void) {
  /* column 1: 2.5, -1.25, 4.75, 7: mean 3.25, squares about it 0.5625 20.25 2.25 14.0625 */
  static const double matrix[] = {9, 2.5, 1e9, 9, -1.25, 1e9, 9, 4.75, 1e9, 9, 7, 1e9};
  double mean, error;
  table_mean(matrix, 4, 3, 1, &mean, &error);
  gsl_test_rel(mean, 3.25, 1e-15, "the mean of a column");
  gsl_test_rel(error, sqrt(37.125 / 3 / 4), 1e-15, "its standard error");
  table_mean(matrix, 4, 3, 2, &mean, &error);
  gsl_test(mean != 1e9 || error != 0, "of equal numbers: no error");
  table_mean(matrix, 1, 3, 1, &mean, &error);
  gsl_test(mean != 2.5 || !gsl_isnan(error), "of one: an unknown error");
  char text[32];
  snprintf(text, sizeof text, "%.12g", error);
  gsl_test_str(text, "nan", "printed as nan, without a sign");
}

static void test_fingerprint(void) {
  static const char *const few[] = {"box", "rng", NULL}, *const turned[] = {"rng", "box", NULL};
  static const char *const more[] = {"box", "rng", "pairs", NULL}, *const other[] = {"box", "pack", NULL};
  static const char *const none[] = {NULL}, *const unknown[] = {"no such module", NULL};
  char a[17], b[17];
  table_fingerprint(few, a);
  gsl_test(strlen(a) != 16 || strspn(a, "0123456789abcdef") != 16, "sixteen hexadecimal digits");
  table_fingerprint(turned, b);
  gsl_test_str(a, b, "the order of the modules does not matter");
  table_fingerprint(more, b);
  gsl_test(strcmp(a, b) == 0, "one module more changes it");
  table_fingerprint(other, b);
  gsl_test(strcmp(a, b) == 0, "another module changes it");
  table_fingerprint(none, a);
  table_fingerprint(unknown, b);
  gsl_test_str(a, b, "an unknown name adds nothing");
}

int main(void) {
  if (!mkdtemp(place))
    return 1;
  test_whole();
  test_failure();
  test_mean();
  test_fingerprint();
  char command[64];
  snprintf(command, sizeof command, "rm -rf %s", place);
  return system(command) ? 1 : gsl_test_summary();
}
