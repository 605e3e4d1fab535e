/* tests/test_guard.c: a body without memory returns, with nothing left behind; what stands for GSL's objects computes what they compute. */
#include "guard.h"
#include <errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* So that the sanitizer lets an impossible request fail as libc does. */
const char *__asan_default_options(void);
const char *__asan_default_options(void) {
  return "allocator_may_return_null=1";
}

typedef struct {
  size_t count, size; /* of the request that fails */
  int how, steps;
  double *kept;
} Body;

/* Take a few blocks, in each of the ways, then one that there is not. */
static void take(void *call) {
  Body *b = call;
  double *first = guard_memory(1237, sizeof *first), *lined = guard_memory_lined(7, 24);
  char *grown = guard_memory_grow(NULL, 3, 1);
  strcpy(grown, "ab");
  guard_free(first);
  grown = guard_memory_grow(grown, 100003, 7);
  b->steps = strcmp(grown, "ab") == 0 && (uintptr_t)lined % 64 == 0 && lined[20] == 0;
  if (b->how == 0)
    guard_memory(b->count, b->size);
  else if (b->how == 1)
    guard_memory_grow(grown, b->count, b->size);
  else
    guard_memory_lined(b->count, b->size);
  b->steps++;
}

static void test_lack(void) {
  const char *const way[] = {"memory", "memory_grow", "memory_lined"};
  for (int how = 0; how < 3; how++) {
    Body b = {.count = SIZE_MAX / 3, .size = 2, .how = how}, product = b;
    gsl_test(guard_run(take, &b), "%s: what there is not ends the body", way[how]);
    gsl_test_int(b.steps, 1, "%s: where it was asked for", way[how]);
    product.count = SIZE_MAX / 8 + 3;
    product.size = 8;
    gsl_test(guard_run(take, &product), "%s: and a product beyond size_t", way[how]);
  }
}

static void keep(void *call) {
  Body *b = call;
  void *none = guard_memory(0, 8), *nothing = guard_memory_grow(NULL, 0, 8);
  b->steps = none && nothing && none != nothing;
  guard_free(none);
  guard_free(nothing);
  guard_free(NULL);
  b->kept = guard_memory_lined(3000001, sizeof *b->kept);
  b->kept[3000000] = 2.385;
}

static void test_kept(void) {
  Body b = {0}, lack = {.count = SIZE_MAX / 3, .size = 2};
  gsl_test(!guard_run(keep, &b), "a body that has its memory is done");
  gsl_test_int(b.steps, 1, "a request for nothing has an address");
  gsl_test(guard_run(take, &lack), "a body after it lacks memory");
  gsl_test(b.kept[3000000] != 2.385 || b.kept[1] != 0, "what the first one kept is there, and was zero");
  guard_free(b.kept);
}

typedef struct {
  const char *path;
  char text[64];
  int got, why;
  bool lack;
} Reading;

static void read_file(void *call) {
  Reading *r = call;
  int status;
  gzFile file = guard_gzopen(r->path, "rb");
  r->why = errno;
  if (!file)
    return;
  r->got = guard_gzread(file, r->text, sizeof r->text - 1);
  guard_gzerror(file, &status);
  r->why = status;
  if (r->lack)
    guard_memory(SIZE_MAX / 3, 2);
  guard_gzclose(file);
}

/* The descriptors in use: what is left open would take the next one. */
static int next_descriptor(void) {
  int next = dup(0);
  close(next);
  return next;
}

static void test_files(void) {
  char path[] = "/tmp/randpack-guard-XXXXXX";
  int at = mkstemp(path), free_one;
  gsl_test(at < 0 || write(at, "12 21\n", 6) != 6 || close(at), "a file");
  free_one = next_descriptor();
  Reading r = {.path = path}, lack = {.path = path, .lack = true}, none = {.path = "/tmp/randpack/none"};
  gsl_test(!guard_run(read_file, &r), "a file is read");
  gsl_test_str(r.text, "12 21\n", "to its end");
  gsl_test_int(r.why, Z_OK, "without an error");
  gsl_test(guard_run(read_file, &lack), "without memory it is not read on");
  gsl_test_int(next_descriptor(), free_one, "and is closed");
  gsl_test(!guard_run(read_file, &none), "a file that is not there is no lack of memory");
  gsl_test_int(none.why, ENOENT, "and the reason is told");
  remove(path);
}

enum { DATA = 9, TERMS = 3 };
static void fill(gsl_matrix *X, gsl_vector *w, gsl_vector *y) {
  for (size_t i = 0; i < DATA; i++) {
    double u = 0.37 * (double)i + 0.0123;
    gsl_matrix_set(X, i, 0, 1);
    gsl_matrix_set(X, i, 1, u);
    gsl_matrix_set(X, i, 2, u * u);
    gsl_vector_set(w, i, 1 + u);
    gsl_vector_set(y, i, 2.385 - 0.7 * u + 0.31 * u * u * u);
  }
}

static void fit(void *call) {
  double *found = call, chi;
  gsl_matrix *X = guard_gsl_matrix_alloc(DATA, TERMS), *A = guard_gsl_matrix_alloc(TERMS, TERMS);
  gsl_vector *w = guard_gsl_vector_alloc(DATA), *y = guard_gsl_vector_alloc(DATA), *c = guard_gsl_vector_alloc(TERMS);
  gsl_multifit_linear_workspace *work = guard_gsl_multifit_linear_alloc(DATA, TERMS);
  fill(X, w, y);
  guard_gsl_multifit_wlinear(X, w, y, c, A, &chi, work);
  for (size_t k = 0; k < TERMS; k++)
    found[k] = gsl_vector_get(c, k);
  for (size_t k = 0; k < TERMS * TERMS; k++)
    found[TERMS + k] = gsl_matrix_get(A, k / TERMS, k % TERMS);
  found[TERMS + TERMS * TERMS] = chi;
  guard_gsl_multifit_linear_free(work);
  guard_gsl_matrix_free(X), guard_gsl_matrix_free(A);
  guard_gsl_vector_free(w), guard_gsl_vector_free(y), guard_gsl_vector_free(c);
}

static void test_fit(void) {
  double found[TERMS + TERMS * TERMS + 1] = {0}, chi;
  gsl_matrix *X = gsl_matrix_alloc(DATA, TERMS), *A = gsl_matrix_alloc(TERMS, TERMS);
  gsl_vector *w = gsl_vector_alloc(DATA), *y = gsl_vector_alloc(DATA), *c = gsl_vector_alloc(TERMS);
  gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc(DATA, TERMS);
  guard_run(fit, found);
  fill(X, w, y);
  gsl_multifit_wlinear(X, w, y, c, A, &chi, work);
  for (size_t k = 0; k < TERMS; k++)
    gsl_test_rel(found[k], gsl_vector_get(c, k), 1e-13, "coefficient %zu of a fit", k);
  for (size_t k = 0; k < TERMS * TERMS; k++)
    gsl_test_rel(found[TERMS + k], gsl_matrix_get(A, k / TERMS, k % TERMS), 1e-13, "number %zu of its covariance", k);
  gsl_test_rel(found[TERMS + TERMS * TERMS], chi, 1e-13, "and what is left");
  gsl_multifit_linear_free(work);
  gsl_matrix_free(X), gsl_matrix_free(A);
  gsl_vector_free(w), gsl_vector_free(y), gsl_vector_free(c);
}

static double curve(double x, void *unused) {
  (void)unused;
  return x * x * x - 2.385;
}

/* Rules of Gauss with 1 to 20 points; the root of the curve; its Chebyshev series. */
typedef struct {
  double x[21][20], w[21][20], root, series[6];
} Found;

static void find(void *call) {
  Found *found = call;
  gsl_function f = {curve, NULL};
  for (size_t n = 1; n <= 20; n++) {
    gsl_integration_glfixed_table *t = guard_gsl_integration_glfixed_table_alloc(n);
    for (size_t i = 0; i < n; i++)
      gsl_integration_glfixed_point(-1, 1, i, &found->x[n][i], &found->w[n][i], t);
    guard_gsl_integration_glfixed_table_free(t);
  }
  gsl_root_fsolver *s = guard_gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  gsl_root_fsolver_set(s, &f, 0, 4);
  for (int k = 0; k < 60; k++)
    gsl_root_fsolver_iterate(s);
  found->root = gsl_root_fsolver_root(s);
  guard_gsl_root_fsolver_free(s);
  gsl_cheb_series *series = guard_gsl_cheb_alloc(5);
  gsl_cheb_init(series, &f, 0, 1);
  memcpy(found->series, gsl_cheb_coeffs(series), sizeof found->series);
  guard_gsl_cheb_free(series);
}

static void test_rules(void) {
  static Found found;
  gsl_function f = {curve, NULL};
  double worst = 0;
  gsl_test(!guard_run(find, &found), "rules, a root, a series");
  for (size_t n = 1; n <= 20; n++) {
    gsl_integration_glfixed_table *t = gsl_integration_glfixed_table_alloc(n);
    for (size_t i = 0; i < n; i++) {
      double x, w;
      gsl_integration_glfixed_point(-1, 1, i, &x, &w, t);
      worst = GSL_MAX(worst, GSL_MAX(fabs(x - found.x[n][i]), fabs(w / found.w[n][i] - 1)));
    }
    gsl_integration_glfixed_table_free(t);
  }
  gsl_test(!(worst <= 2.3e-16), "Gauss's rules differ by %.2g, a last bit", worst);
  gsl_test_abs(found.root, cbrt(2.385), 1e-15, "a root by Brent's method");
  gsl_cheb_series *series = gsl_cheb_alloc(5);
  gsl_cheb_init(series, &f, 0, 1);
  gsl_test(memcmp(gsl_cheb_coeffs(series), found.series, sizeof found.series) != 0, "a Chebyshev series");
  gsl_cheb_free(series);
}

int main(void) {
  test_lack();
  test_kept();
  test_files();
  test_fit();
  test_rules();
  return gsl_test_summary();
}
