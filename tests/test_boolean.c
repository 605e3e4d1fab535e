/* tests/test_boolean.c: set covariances against closed forms, a table and other rules of quadrature; the laws of two and three points against a
   single grain, the exact union of bodies, and packs that were thrown; hard spheres against a table made elsewhere. */
#include "boolean.h"
#include "cover.h"
#include "many.h"
#include "outcome.h"
#include "points.h"
#include "py.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>

static void near(double got, double want, double error, const char *what, double at) {
  gsl_test(!(fabs(got - want) <= error), "%s at %g: %.12g, want %.12g", what, at, got, want);
}

static BooleanGrain of(const Shape *shape, double radius) { return (BooleanGrain){2, shape, radius, 1}; }

/* K(r) / A at r / D_eq = .1, .25, .5, .75, 1, 1.25, computed elsewhere by another program, to the digits that it gave, of superellipses fewer; kind: sides,
   or minus m. */
static const struct {
  const char *what;
  double kind, aspect, error, K[6];
} table[] = {
    {"triangle", 3, 0, 3e-7, {.8429671, .6325996, .3491388, .1496175, .0340357, .0004714}},
    {"square", 4, 0, 6e-9, {.86038315, .66615605, .38297270, .15044993, .01037817, .00000002}},
    {"pentagon", 5, 0, 3e-7, {.8660827, .6764475, .3903644, .1432311, .0056495, 0}},
    {"hexagon", 6, 0, 3e-7, {.8687040, .6807741, .3915950, .1437012, .0029326, 0}},
    {"disc", 0, 0, 6e-9, {.87288857, .68503764, .39100222, .14429361, 0, 0}},
    {"ellipse", -1, 2, 6e-9, {.86149213, .65796395, .34826441, .12606325, .03903654, .00532026}},
    {"ellipse as round as a square", -1, 2.28367, 6e-9, {.85669791, .64665445, .33126505, .12525174, .04548685, .01031260}},
    {"ellipse of 5", -1, 5, 6e-9, {.81064334, .54090688, .21795440, .11353572, .06388807, .03513638}},
    {"m = 1.5", -1.5, 1, 3e-7, {.8714020, .6822087, .3897960, .1453296, .0034460, NAN}},
    {"m = 2", -2, 1, 3e-7, {.8694904, .6786215, .3882684, .1466281, .0056993, NAN}},
    {"m = 5", -5, 1, 2e-6, {.8638943, .6697312, .3845010, .1496092, .0092251, NAN}},
    {"m = 1.5, a/b = 1.5", -1.5, 1.5, 1e-6, {.8679581, .6738168, .3744498, .1323004, .0243925, NAN}}};

static Shape *shape_of(double kind, double aspect) {
  return kind > 0 ? shape_regular((int)kind) : kind < 0 ? shape_superellipse(aspect, -kind) : NULL;
}

static void test_table(void) {
  static const double at[] = {.1, .25, .5, .75, 1, 1.25};
  for (size_t t = 0; t < sizeof table / sizeof *table; t++) {
    Shape *shape = shape_of(table[t].kind, table[t].aspect);
    BooleanGrain grain = of(shape, 2.5);
    for (int i = 0; i < 6; i++)
      if (!isnan(table[t].K[i]))
        near(boolean_common(&grain, 5 * at[i]) / (6.25 * M_PI), table[t].K[i], table[t].error, table[t].what, at[i]);
    shape_free(&shape);
  }
}

/* A square of area 1 in closed form, inside and outside its side. */
static double square(double r) {
  return r <= 1 ? 1 - 4 * r / M_PI + r * r / M_PI
         : r < M_SQRT2 ? 2 / M_PI * (asin(1 / r) - acos(1 / r) + 2 * sqrt(r * r - 1) - r * r / 2 - 1)
                       : 0;
}

static void test_square(void) {
  Shape *shape = shape_regular(4), *same = shape_superellipse(1, 0.5);
  BooleanGrain grain = of(shape, 1 / sqrt(M_PI)), rhombus = of(same, 1 / sqrt(M_PI));
  for (double r = 0; r < 1.6; r += 0.0637) {
    near(boolean_common(&grain, r), square(r), 1e-13, "square", r);
    near(boolean_common(&rhombus, r), square(r), 1e-13, "m = 1/2", r);
  }
  double s = M_SQRT1_2; /* its vertices are on the axes */
  near(boolean_directional(&grain, .31 * s - .17 * s, .31 * s + .17 * s), (1 - .31) * (1 - .17), 1e-13, "square along a side", .31);
  near(boolean_directional(&grain, .8 * s - 1.1 * s, .8 * s + 1.1 * s), 0, 0, "square apart", 1.1);
  shape_free(&shape);
  shape_free(&same);
}

/* Discs and balls, by an integral over chords and by hand. */
static void test_round(void) {
  BooleanGrain disc = {2, NULL, 1.7, 1}, ball = {3, NULL, 1.7, 1};
  near(boolean_common(&disc, 1.7), 2.89 * (2 * M_PI / 3 - sqrt(.75)), 1e-14, "disc at its radius", 1.7);
  near(boolean_common(&ball, 1.7), 4 * M_PI / 3 * 4.913 * 5 / 16, 1e-13, "ball at its radius", 1.7);
  near(boolean_common(&ball, 3.4), 0, 0, "ball at its diameter", 3.4);
  near(boolean_directional(&disc, 1.02, 1.36), boolean_common(&disc, 1.7), 1e-14, "disc in a direction", 1.7);
  near((1 - boolean_common(&ball, 1e-6) / boolean_common(&ball, 0)) * 1e6, 3 / (4 * 1.7), 1e-6, "slope of a ball, -S/4V", 0);
}

typedef struct {
  const BooleanGrain *grain;
  double r;
} Circle;

static double around(double angle, void *circle) {
  const Circle *c = circle;
  return boolean_directional(c->grain, c->r * cos(angle), c->r * sin(angle));
}

/* All shapes against many points at equal angles, whose error falls slowly; the slope at 0 is -P / pi; the integral over the plane is A^2. */
static void test_any(void) {
  static const double corners[][2] = {{0, 0}, {3, .2}, {2.1, 1.7}, {.4, 1.1}};
  Outcome out = {0};
  Shape *shape[] = {shape_regular(3), shape_regular(7), shape_superellipse(3, 1), shape_superellipse(.4, 2), shape_superellipse(1.5, 50),
                    shape_convex(4, corners, &out)};
  for (size_t s = 0; s < sizeof shape / sizeof *shape; s++) {
    BooleanGrain grain = of(shape[s], 1);
    double radius[] = {.02, .7, 1.9};
    for (int i = 0; i < 3; i++) {
      Circle circle = {&grain, radius[i]};
      double sum = 0;
      int n = 4000;
      for (int k = 0; k < n; k++)
        sum += around((k + 0.5) * M_PI / n, &circle) / n;
      near(boolean_common(&grain, radius[i]), sum, 1e-7, "any shape against a sum over angles", radius[i] + 10 * (double)s);
    }
    double sum = 0, far = 2 * shape[s]->outer;
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(s == 4 ? 8 : 24);
    for (size_t i = 0; i < rule->n; i++) {
      double r, weight;
      gsl_integration_glfixed_point(0, far, i, &r, &weight, rule);
      sum += weight * 2 * M_PI * r * boolean_common(&grain, r);
    }
    gsl_integration_glfixed_table_free(rule);
    near(sum / (M_PI * M_PI), 1, s == 4 ? 2e-2 : 5e-4, "integral over the plane, A^2", (double)s);
    near((M_PI - boolean_common(&grain, 1e-5)) / 1e-5, shape[s]->perimeter / M_PI, 1e-3, "slope -P/pi", (double)s);
    shape_free(&shape[s]);
  }
}

/* A needle far from itself: a rule that steps over its direction finds nothing. The stretched disc's integral by the substitution
   tan = b / a tan', which spreads the peak. */
static double stretched(double t, void *of) {
  const double *p = of; /* a, b, r */
  double u = p[0] * cos(t), v = p[1] * sin(t), d2 = u * u + v * v, h = p[2] / sqrt(d2);
  double k = h < 2 ? 2 * acos(h / 2) - h / 2 * sqrt(4 - h * h) : 0;
  return p[0] * p[1] * k * p[0] * p[1] / d2;
}

static void test_needle(void) {
  for (int tall = 0; tall < 2; tall++) {
    Shape *needle = shape_superellipse(tall ? 1e-4 : 1e4, 1);
    BooleanGrain grain = of(needle, 1);
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(1000);
    for (double r = 1; r < 200; r *= 5) {
      double p[] = {100, .01, r}, want, error;
      gsl_function f = {stretched, p};
      gsl_integration_qag(&f, 0, M_PI / 2, 1e-13, 0, 1000, GSL_INTEG_GAUSS31, space, &want, &error);
      near(boolean_common(&grain, r) / (want / (M_PI / 2)), 1, 1e-7, tall ? "tall needle" : "needle", r);
    }
    gsl_integration_workspace_free(space);
    shape_free(&needle);
  }
}

static void test_laws(void) {
  double share, V = 50;
  Shape *hexagon = shape_regular(6);
  BooleanGrain one[] = {{2, NULL, 1.3, 1}}, two[] = {{2, NULL, 1.3, 3}, {2, hexagon, .8, 5}}, none[] = {{2, NULL, 1.3, 0}};
  double K = boolean_common(one, 1.1), A = M_PI * 1.69;
  near(boolean_matrix(one, 1, V, 1.1, &share), 1 - (2 * A - K) / V, 1e-15, "one grain", 1.1);
  near(share, K / A, 1e-15, "share of one grain", 1.1);
  near(boolean_covered(one, 1, V), A / V, 1e-15, "one grain covers", 0);
  double K2 = boolean_common(&two[1], 1.1), A2 = M_PI * .64;
  near(boolean_matrix(two, 2, V, 1.1, &share), pow(1 - (2 * A - K) / V, 3) * pow(1 - (2 * A2 - K2) / V, 5), 1e-15, "a mixture", 1.1);
  near(share, (3 * K + 5 * K2) / (3 * A + 5 * A2), 1e-15, "share of a mixture", 1.1);
  near(1 - boolean_covered(two, 2, V), pow(1 - A / V, 3) * pow(1 - A2 / V, 5), 1e-15, "a mixture covers", 0);
  near(boolean_matrix(none, 1, V, 1.1, &share), 1, 0, "no grain", 1.1);
  gsl_test(!isnan(share), "no grain has no share");
  near(boolean_covered(none, 1, V), 0, 0, "no grain covers", 0);
  near(boolean_covered(one, 1, A), 1, 0, "a grain as large as the box", 0);
  /* the limit of many: phi = .5, S_aa of the table made elsewhere, squares at D_eq / 4 */
  near(boolean_fixed(.5, .66615605), .39670983, 1e-8, "infinitely many", .25);
  BooleanGrain many[] = {{2, NULL, 1, 1e9}};
  double volume = 1e9 * M_PI / M_LN2, S_mm = boolean_matrix(many, 1, volume, .77, &share);
  near(S_mm + 2 * boolean_covered(many, 1, volume) - 1, boolean_fixed(.5, share), 1e-8, "a thousand million", .77);
  shape_free(&hexagon);
}

/* Six squares at random places and angles in a small box: of each pack the uncovered part common to it and its shift is exact. The law of parallel
   squares, and that of infinitely many, are several standard errors away. */
static void test_thrown(void) {
  enum { N = 6 };
  Species species = {.name = "S", .radius = 1, .count = N, .shape = shape_regular(4)};
  Box box = {2, {6, 6, 0}};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  BooleanGrain grain = {2, species.shape, 1, N};
  Rng rng = rng_stream(16, 0, RNG_TEST);
  double r = 1.6, sum = 0, square_sum = 0, covered = 0, share;
  int packs = as_many(6000, 100000);
  for (int k = 0; k < packs; k++) {
    points_scatter(pack, &rng);
    points_turn(pack, &rng);
    Body *bodies = cover_bodies(pack), both[2 * N];
    for (int i = 0; i < N; i++) {
      both[i] = both[N + i] = bodies[i];
      both[N + i].x += both[N + i].x + r < 6 ? r : r - 6;
    }
    double S_mm = 1 - cover_area(both, 2 * N, &box, NULL) / 36;
    covered += cover_area(bodies, N, &box, NULL) / 36 / packs;
    sum += S_mm;
    square_sum += S_mm * S_mm;
    free(bodies);
  }
  double mean = sum / packs, error = sqrt((square_sum / packs - mean * mean) / packs);
  double law = boolean_matrix(&grain, 1, 36, r, &share);
  gsl_test(fabs(mean - law) > 4 * error, "thrown squares: S_mm %.6g +- %.2g, law %.6g", mean, error, law);
  near(covered, boolean_covered(&grain, 1, 36), 4 * error, "thrown squares cover", r);
  double infinite = boolean_fixed(boolean_covered(&grain, 1, 36), share) + 1 - 2 * boolean_covered(&grain, 1, 36);
  gsl_test(fabs(mean - infinite) < 6 * error, "thrown squares: few are not infinitely many, %.6g", infinite);
  pack_free(&pack);
  shape_free(&species.shape);
}

static void test_union(void) {
  Rng rng = rng_stream(17, 0, RNG_TEST);
  double worst = 0;
  for (int k = 0; k < 2000; k++) {
    double p[3][2];
    Body bodies[3];
    double a = 0.4 + rng_uniform(&rng);
    for (int i = 0; i < 3; i++) {
      for (int c = 0; c < 2; c++)
        p[i][c] = 3 * rng_uniform(&rng) + 40;
      bodies[i] = (Body){NULL, a, p[i][0], p[i][1], 1, 0};
    }
    worst = fmax(worst, fabs(boolean_union(a, (const double(*)[2])p) - cover_area(bodies, 3, NULL, NULL)));
  }
  gsl_test(!(worst < 1e-12), "unions of three discs against the exact cover: %.2g", worst);
  const double same[3][2] = {{1, 2}, {1, 2}, {1, 2}}, pair[3][2] = {{1, 2}, {2.3, 2}, {1, 2}}, apart[3][2] = {{0, 0}, {5, 0}, {0, 5}};
  BooleanGrain disc = of(NULL, 1.3);
  near(boolean_union(1.3, same), M_PI * 1.69, 1e-14, "three in one place", 0);
  near(boolean_union(1.3, pair), 2 * M_PI * 1.69 - boolean_common(&disc, 1.3), 1e-13, "two in one place", 1.3);
  near(boolean_union(1.3, apart), 3 * M_PI * 1.69, 1e-13, "apart", 5);
}

/* One disc: the phase function is the area common to three, over the box. Many: the limits. */
static void test_three(void) {
  BooleanGrain one = of(NULL, 1.3), many = {2, NULL, 1.3, 40};
  const double p[3][2] = {{0, 0}, {.9, .1}, {.3, 1.2}}, same[3][2] = {{0, 0}, {0, 0}, {0, 0}}, pair[3][2] = {{0, 0}, {.9, .1}, {.9, .1}};
  double d[3] = {hypot(.9, .1), hypot(.6, 1.1), hypot(.3, 1.2)}, lens = 0, A = M_PI * 1.69;
  for (int i = 0; i < 3; i++)
    lens += boolean_common(&one, d[i]);
  near(boolean_phase3(&one, 1, 80, p) * 80, boolean_union(1.3, p) - 3 * A + lens, 1e-12, "one disc, three points", 0);
  near(boolean_phase3(&one, 1, 80, same), A / 80, 1e-15, "one disc, one point", 0);
  near(boolean_phase3(&many, 1, 200, same), boolean_covered(&many, 1, 200), 1e-14, "S1", 0);
  double S_aa = 2 * boolean_covered(&many, 1, 200) - 1 + boolean_matrix(&many, 1, 200, d[0], NULL);
  near(boolean_phase3(&many, 1, 200, pair), S_aa, 1e-14, "S2", d[0]);
  near(boolean_matrix3(&many, 1, 200, p), pow(1 - boolean_union(1.3, p) / 200, 40), 1e-14, "S_mmm", 0);
}

/* x = r / 2a; computed elsewhere with the structure factor in 60 digits, to the digits that it gave. */
static void test_hard(void) {
  static const double x[] = {.1, .25, .5, .75, 1, 1.25, 1.5, 2};
  static const struct {
    double phi, S2[8];
  } known[] = {{.30, {.25543492, .19360264, .11577661, .07781858, .08081882, .09397559, .09276430, .08884063}},
               {.49, {.41820335, .32758306, .24078085, .22065289, .24192096, .24943618, .23640282, .24296008}},
               {.575, {.49189189, .39577341, .32274397, .31596624, .33824723, .33568579, .32397059, .33520940}}};
  for (int k = 0; k < 3; k++) {
    BooleanHard *hard = boolean_hard_alloc(known[k].phi, 4);
    for (int i = 0; i < 8; i++)
      near(boolean_hard_at(hard, 2 * x[i]), known[k].S2[i], 6e-9, "hard spheres", x[i]);
    near(boolean_hard_at(hard, 0), known[k].phi, 3e-9, "hard spheres at 0", 0);
    near((boolean_hard_at(hard, 1e-3) - known[k].phi) / 1e-3, -3 * known[k].phi / 4, 1e-3, "hard spheres, slope", 0);
    boolean_hard_free(&hard);
  }
}

/* A second road, in space: S_aa - phi^2 - rho K = 2 pi rho^2 / R times the integral over s of s K(s) [H(R + s) - H(|R - s|)], H that of t h(t). */
typedef struct {
  const Py *py;
  double R;
} Space;

static double tail(double t, void *py) { return t * (py_g(py, t) - 1); }

static double total(const Py *py, double u) {
  gsl_function f = {tail, (void *)py};
  double part = 0, sum, error;
  size_t n;
  if (u > 2)
    gsl_integration_qng(&f, 2, u < 4 ? u : 4, 1e-11, 0, &part, &error, &n);
  sum = part;
  if (u > 4)
    gsl_integration_qng(&f, 4, u, 1e-11, 0, &part, &error, &n), sum += part;
  return u < 2 ? -u * u / 2 : -2 + sum;
}

static double lens(double s, void *of) {
  const Space *space = of;
  BooleanGrain ball = {3, NULL, 1, 1};
  return s * boolean_common(&ball, s) * (total(space->py, space->R + s) - total(space->py, fabs(space->R - s)));
}

static void test_space(void) {
  double phi = .575, rho = 3 * phi / (4 * M_PI), radius[] = {.2, 1, 2, 3.1};
  Py *py = py_alloc(phi);
  BooleanHard *hard = boolean_hard_alloc(phi, 4);
  BooleanGrain ball = {3, NULL, 1, 1};
  gsl_integration_workspace *work = gsl_integration_workspace_alloc(1000);
  for (int i = 0; i < 4; i++) {
    Space space = {py, radius[i]};
    double part, error, sum = 0, bends[] = {0, fmin(2, fabs(2 - radius[i])), 2};
    gsl_function f = {lens, &space};
    for (int k = 0; k < 2; k++)
      if (bends[k + 1] > bends[k])
        gsl_integration_qag(&f, bends[k], bends[k + 1], 1e-9, 0, 1000, GSL_INTEG_GAUSS21, work, &part, &error), sum += part;
    near(boolean_hard_at(hard, radius[i]), phi * phi + rho * boolean_common(&ball, radius[i]) + 2 * M_PI * rho * rho / radius[i] * sum, 4e-9,
         "hard spheres in space", radius[i]);
  }
  gsl_integration_workspace_free(work);
  boolean_hard_free(&hard);
  py_free(&py);
}

int main(void) {
  test_table();
  test_square();
  test_round();
  test_any();
  test_needle();
  test_laws();
  test_thrown();
  test_union();
  test_three();
  test_hard();
  test_space();
  return gsl_test_summary();
}
