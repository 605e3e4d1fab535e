/* test_py.c: the Percus-Yevick curve against values computed elsewhere, its
   methods against each other, and against the equation itself. */
#include "py.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>

static void near(double got, double want, double error, const char *what,
                 double phi, double R) {
  gsl_test(!(fabs(got - want) <= error),
           "%s, phi = %g, R = %.9g: %.15g, want %.15g", what, phi, R, got,
           want);
}

static double sample(PyMethod method, double phi, double R) {
  Py *py = py_alloc_by(method, phi, 0);
  double g = py_g(py, R);
  py_free(&py);
  gsl_test(py != NULL, "py_free nulls the pointer");
  return g;
}

/* computed with 60 digits by another program: absolute error 1e-11 here,
   because the distances are decimal fractions rounded to double */
static const struct {
  double R, g[3];
} table[] = {
    {2, {2.346938775510, 4.786620530565, 7.128027681661}},
    {2.1, {2.103261736265, 3.655594679584, 4.780232518877}},
    {2.2, {1.884237091658, 2.736792445719, 3.024722599330}},
    {2.4, {1.519482881190, 1.473009295175, 0.9885582810017}},
    {2.6, {1.246734870780, 0.8133436143889, 0.2831818267116}},
    {2.8, {1.055611362513, 0.5578907403858, 0.2546890194359}},
    {3.0, {0.9341845403831, 0.5422615893891, 0.4836659631077}},
    {3.2, {0.8706690163782, 0.6512076733572, 0.7583657468759}},
    {3.464, {0.8575691664292, 0.8706128119282, 1.069517147817}},
    {3.4641016151377544, {0.8575772061798, 0.8707035855802, 1.069622537629}},
    {3.6, {0.8761016564512, 0.9932604073257, 1.202734070245}},
    {4.0, {1.005662663825, 1.353934230679, 1.555057831635}},
    {4.5, {1.059197489435, 0.9430819549608, 0.5841771199950}},
    {5.0, {0.9988054205425, 0.8280070215338, 0.9252749830244}},
    {6.0, {0.9981491136415, 1.103492108415, 1.016109108766}},
    {7.0, {1.001277875205, 0.9543153730108, 1.106779010160}},
    {8.0, {0.9991263247463, 1.018418862661, 0.8975998126052}},
    {10.0, {0.9997335773120, 0.9945224724847, 0.9407357164602}},
    {20.0, {0.9999998096995, 1.000129622435, 0.9945730159093}},
};

static void test_table(void) {
  static const double phi[] = {0.30, 0.49, 0.575};
  for (int j = 0; j < 3; j++) {
    Py *py = py_alloc(phi[j]);
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
      near(py_g(py, table[i].R), table[i].g[j], 1e-11, "table", phi[j],
           table[i].R);
    py_free(&py);
  }
}

/* the same at the doubles given, 80 digits by another program, with the
   roots from its own polynomial solver; contact, both sides of the switch at
   R = 12, the first and the last fractions */
static const struct {
  double phi, R, g;
} deep[] = {
    {1e-09, 2.0625, 1.000000002360855105},
    {1e-06, 2.0, 1.000002500004000005},
    {1e-06, 3.875, 1.000000011594886212},
    {0.001, 3.0, 1.000685723687446748},
    {0.01, 5.0, 0.999992060224190730},
    {0.05, 6.875, 0.999994976399340577},
    {0.1, 11.96875, 0.999999998996951911},
    {0.2, 9.125, 1.000070452599926448},
    {0.3, 3.875, 0.954746757114382113},
    {0.3, 11.0, 1.000138211659683113},
    {0.4, 12.0, 1.001475681812580090},
    {0.4, 19.0, 0.999977849603159505},
    {0.49, 11.96875, 0.992784754167997646},
    {0.49, 12.03125, 0.991558300354719925},
    {0.575, 6.0, 1.016109108765825837},
    {0.575, 10.0, 0.940735716460168335},
    {0.575, 11.96875, 0.994985786418086218},
    {0.575, 12.0, 0.999800624313372946},
    {0.575, 12.03125, 1.004538841831262939},
    {0.575, 20.0, 0.994573015909318872},
    {0.6, 14.5, 0.982809535095928253},
    {0.6125, 2.0625, 6.510016258085984508},
    {0.6125, 11.0, 0.965698441859637335},
    {0.6125, 16.0, 0.991965018647380695},
    {0.63, 13.0, 0.937364399376610463},
    {0.7, 2.0, 14.99999999999999531},
    {0.7, 11.96875, 0.976239879423546553},
    {0.7, 19.0, 0.966212285811837997},
};

static void test_deep(void) {
  for (size_t i = 0; i < sizeof deep / sizeof *deep; i++) {
    Py *py = py_alloc(deep[i].phi);
    near(py_g(py, deep[i].R), deep[i].g, 2e-15, "60 digits", deep[i].phi,
         deep[i].R);
    py_free(&py);
  }
}

static void test_methods(void) {
  static const double phi[] = {1e-7, 0.013, 0.185, 0.387, 0.575, 0.6125, 0.68};
  for (int j = 0; j < 7; j++) {
    Py *shells = py_alloc_by(PY_SHELLS, phi[j], 0);
    Py *poles = py_alloc_by(PY_POLES, phi[j], 0);
    Py *fft = py_alloc_by(PY_FFT, phi[j], 0), *py = py_alloc(phi[j]);
    for (double R = 9.13; R < 15; R += 0.2371)
      near(py_g(shells, R), py_g(poles, R), 2e-13, "shells, poles", phi[j], R);
    for (double R = 2; R < 60; R += 0.2371)
      near(py_g(fft, R), py_g(py, R), 3e-6, "fft, auto", phi[j], R);
    py_free(&shells);
    py_free(&poles);
    py_free(&fft);
    py_free(&py);
  }
}

/* the fault is there: the plain transform gives the mean of both sides at
   contact, and overshoots beside it on every grid */
static void test_ringing(void) {
  const double phi = 0.49, contact = py_contact(phi);
  near(sample(PY_FFT_PLAIN, phi, 2), contact / 2, 0.01, "Gibbs", phi, 2);
  double before = 0;
  for (size_t points = 16384; points <= 65536; points *= 2) {
    Py *plain = py_alloc_by(PY_FFT_PLAIN, phi, points), *py = py_alloc(phi);
    double over = 0;
    for (double R = 2.0005; R < 2.1; R += 0.0007)
      over = fmax(over, py_g(plain, R) - py_g(py, R));
    gsl_test(!(over > 0.06 * contact && over < 0.15 * contact),
             "overshoot %g stays on %zu points (before: %g)", over, points,
             before);
    before = over;
    py_free(&plain);
    py_free(&py);
  }
}

static void test_continuity(void) {
  static const double phi[] = {0.07, 0.41, 0.6};
  for (int j = 0; j < 3; j++) {
    Py *py = py_alloc(phi[j]);
    for (int n = 2; n <= 7; n++) {
      double R = 2 * n, d = 1e-7, below = nextafter(R, 0);
      near(py_g(py, below), py_g(py, R), 3e-15, "no step", phi[j], R);
      near(py_slope(py, below), py_slope(py, R), 3e-13, "no break", phi[j], R);
      near((py_g(py, R + d) - py_g(py, R - d)) / (2 * d), py_slope(py, R), 3e-6,
           "slope", phi[j], R);
    }
    double d = 1e-6, R = 2.731;
    near((py_g(py, R + d) - py_g(py, R - d)) / (2 * d), py_slope(py, R), 1e-8,
         "slope", phi[j], R);
    py_free(&py);
  }
}

static void test_edges(void) {
  static const double phi[] = {0, 1e-300, 1e-22, 1e-12, 1e-6, 0.3};
  for (int j = 0; j < 6; j++) {
    near(sample(PY_AUTO, phi[j], nextafter(2, 0)), 0, 0, "hole", phi[j], 2);
    near(sample(PY_AUTO, phi[j], 0), 0, 0, "hole", phi[j], 0);
    near(sample(PY_AUTO, phi[j], 2), py_contact(phi[j]), 1e-15, "contact",
         phi[j], 2);
  }
  near(sample(PY_AUTO, 0, 3.3), 1, 0, "no spheres", 0, 3.3);
  near((sample(PY_AUTO, 1e-12, 3) - 1) / 1e-12, 8 - 9 + 1.6875, 3e-4,
       "first order", 1e-12, 3);
  near((sample(PY_AUTO, 1e-6, 3) - 1) / 1e-6, 8 - 9 + 1.6875, 1e-5,
       "first order", 1e-6, 3);
  near(sample(PY_AUTO, nextafter(1e-9, 0), 2.9),
       sample(PY_AUTO, nextafter(1e-9, 1), 2.9), 4e-16, "seam", 1e-9, 2.9);
}

static void test_poles(void) {
  static const double want[][3] = {{0.3, -1.43679446, 6.058015087},
                                   {0.49, -0.5837862771, 6.904141253},
                                   {0.575, -0.3286004589, 7.298868291}};
  for (int i = 0; i < 3; i++) {
    Py *py = py_alloc(want[i][0]);
    double z[2], old[2];
    py_pole(py, 1, z);
    near(z[0], want[i][1], 1e-8, "pole, real", want[i][0], 0);
    near(z[1], want[i][2], 1e-8, "pole, imaginary", want[i][0], 0);
    for (size_t k = 2; k <= 64; k++) {
      py_pole(py, k - 1, old);
      py_pole(py, k, z);
      gsl_test(!(fabs(z[1] - old[1] - 2 * M_PI) < 0.8 && z[0] < old[0]),
               "phi = %g: pole %zu is neither skipped nor doubled", want[i][0],
               k);
    }
    py_free(&py);
  }
}

static void test_extrema(void) {
  static const struct {
    double phi, x, g;
  } want[] = {{0.49, 1.45645, .528103},   {0.49, 2.031727, 1.380969},
              {0.49, 2.409388, .79265},   {0.49, 2.915357, 1.121559},
              {0.575, 1.352729, .216012}, {0.575, 2.011221, 1.564843},
              {0.575, 2.293416, .552271}, {0.575, 2.748863, 1.2282},
              {0.593, 1.331714, .120857}, {0.593, 2.00898, 1.597818},
              {0.6, 1.323663, .079914},   {0.6, 2.008248, 1.610019},
              {0.6, 2.26363, .445457},    {0.6, 2.694169, 1.267645}};
  int k = 0;
  for (int i = 0; i < 14; i++) {
    PyExtremum e[4];
    Py *py = py_alloc(want[i].phi);
    gsl_test_int((int)py_extrema(py, 2, 6, e, 4), 4, "four extrema");
    gsl_test_int((int)py_extrema(py, 2, 6, e, 3), 3, "room for three");
    py_extrema(py, 2, 6, e, 4);
    k = i && want[i].phi == want[i - 1].phi ? k + 1 : 0;
    near(e[k].R / 2, want[i].x, 6e-7, "extremum at", want[i].phi, e[k].R);
    near(e[k].g, want[i].g, 6e-7, "extremum", want[i].phi, e[k].R);
    gsl_test_int(e[k].sign, k % 2 ? 1 : -1, "minima and maxima alternate");
    near(py_slope(py, e[k].R), 0, 1e-12, "slope there", want[i].phi, e[k].R);
    py_free(&py);
  }
}

static void test_mean(void) {
  static const double want[][3] = {{0.575, 0.01, 6.99611},
                                   {0.575, 0.015, 6.93076},
                                   {0.575, 0.005, 7.06187},
                                   {0.593, 0.01, 7.67019},
                                   {0.6, 0.01, 7.95739}};
  for (int i = 0; i < 5; i++) {
    Py *py = py_alloc(want[i][0]);
    near(py_mean(py, 2, 2 + want[i][1]), want[i][2], 6e-6, "bin", want[i][0],
         want[i][1]);
    double sum = 0, weight = 0;
    for (int j = 0; j < 20000; j++) {
      double R = 3.71 + 0.63 * (j + 0.5) / 20000;
      sum += R * R * py_g(py, R);
      weight += R * R;
    }
    near(py_mean(py, 3.71, 4.34), sum / weight, 1e-8, "mean across a kink",
         want[i][0], 4);
    py_free(&py);
  }
}

/* Baxter: r h(r) = -Q'(r) + 12 phi int_0^1 (r - t) h(|r - t|) Q(t) dt, in
   diameters; the second, independent, way to the same curve */
typedef struct {
  const Py *py;
  double phi, r;
} Baxter;

static double kernel(double t, void *data) {
  const Baxter *b = data;
  double d = 1 - b->phi, A = (1 + 2 * b->phi) / (d * d), u = b->r - t;
  double Q = A / 2 * (t * t - 1) - 3 * b->phi / (2 * d * d) * (t - 1);
  return u * (py_g(b->py, 2 * u) - 1) * Q;
}

static void test_baxter(void) {
  static const double phi[] = {0.004, 0.3, 0.49, 0.575, 0.61};
  static const double r[] = {1.2, 1.732, 2.5, 3.3, 4.25, 5.9, 6.4, 7.3};
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(32);
  for (int i = 0; i < 5; i++) {
    Py *py = py_alloc(phi[i]);
    for (int j = 0; j < 8; j++) {
      Baxter b = {py, phi[i], r[j]};
      gsl_function f = {kernel, &b};
      double kink = r[j] - floor(r[j]); /* r - t an integer */
      double sum = gsl_integration_glfixed(&f, 0, kink, rule) +
                   gsl_integration_glfixed(&f, kink, 1, rule);
      near(12 * phi[i] * sum, r[j] * (py_g(py, 2 * r[j]) - 1), 2e-13, "Baxter",
           phi[i], 2 * r[j]);
    }
    py_free(&py);
  }
  gsl_integration_glfixed_table_free(rule);
}

/* 1 + 4 pi n int h(R) R sin(kR)/k dR against the closed S(k); k = 0 is the
   sum rule */
static double tail(double R, void *data) {
  const Baxter *b = data;
  double k = b->r;
  return (py_g(b->py, R) - 1) * R * (k > 0 ? sin(k * R) / k : R);
}

static void test_structure(void) {
  static const double phi[] = {0.02, 0.3, 0.49, 0.575};
  static const double wave[] = {0, 0.37, 1.9, 3.53, 7.7};
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(20);
  for (int i = 0; i < 4; i++) {
    Py *py = py_alloc(phi[i]);
    for (int j = 0; j < 5; j++) {
      Baxter b = {py, phi[i], wave[j]};
      gsl_function f = {tail, &b};
      double k = wave[j],
             sum = k > 0 ? -(sin(2 * k) - 2 * k * cos(2 * k)) / gsl_pow_3(k)
                         : -8 / 3.;
      for (double R = 2; R < 240; R += 1)
        sum += gsl_integration_glfixed(&f, R, R + 1, rule);
      near(1 + 3 * phi[i] * sum, py_structure(phi[i], k), 1e-10, "S(k)", phi[i],
           k);
    }
    near(py_structure(phi[i], 0),
         gsl_pow_4(1 - phi[i]) / gsl_pow_2(1 + 2 * phi[i]), 1e-15, "S(0)",
         phi[i], 0);
    near(py_structure(phi[i], 1 - 1e-9), py_structure(phi[i], 1 + 1e-9), 3e-8,
         "S(k), series and closed form", phi[i], 1);
    py_free(&py);
  }
  gsl_integration_glfixed_table_free(rule);
}

static void test_limit(void) {
  PyExtremum least;
  double limit = py_limit();
  near(limit, 0.6125745, 6e-8, "limit", limit, 0);
  for (int i = 0; i < 3; i++) {
    double phi = i < 2 ? limit + (i ? 1e-5 : -1e-5) : 0.63;
    Py *py = py_alloc(phi);
    py_extrema(py, 2, 4, &least, 1);
    gsl_test((least.g < 0) != (i > 0), "phi = %.7f: least g is %g", phi,
             least.g);
    if (i == 2) {
      near(least.g, -0.1263, 6e-5, "negative", phi, least.R);
      near(least.R / 2, 1.289, 0.03, "negative at", phi, least.R);
    }
    py_free(&py);
  }
}

static void test_cost(void) {
  Py *py = py_alloc(0.5), *few = py_alloc_by(PY_POLES, 0.5, 5);
  gsl_test_int((int)py_cost(py, 1.5), 0, "no terms in the hole");
  gsl_test_int((int)py_cost(py, 3.9), 2, "terms of one shell");
  gsl_test_int((int)py_cost(py, 11.9), 30, "terms of five shells");
  gsl_test(!(py_cost(py, 40) < py_cost(py, 16) && py_cost(py, 16) < 40),
           "fewer poles further out");
  gsl_test_int((int)py_cost(few, 5), 5, "as many poles as asked for");
  double coarse = fabs(py_g(few, 5) - py_g(py, 5));
  gsl_test(!(coarse > 1e-7 && coarse < 1e-2), "five pairs err by %g", coarse);
  py_free(&py);
  py_free(&few);
  gsl_test_int(py_method_find("poles"), PY_POLES, "method by name");
  gsl_test_int(py_method_find("fft-plain"), PY_FFT_PLAIN, "method by name");
  gsl_test_int(py_method_find("series"), -1, "no such method");
  for (int i = 0; i < PY_METHODS; i++)
    gsl_test_int(py_method_find(py_method_name(i)), i, "names round trip");
}

int main(void) {
  test_table();
  test_deep();
  test_methods();
  test_ringing();
  test_continuity();
  test_edges();
  test_poles();
  test_extrema();
  test_mean();
  test_baxter();
  test_structure();
  test_limit();
  test_cost();
  return gsl_test_summary();
}
