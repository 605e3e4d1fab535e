/* tests/test_shape.c: polygons and superellipses against closed forms, printed values, and integrals taken another way */
#include "shape.h"
#include "many.h"
#include "rng.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <string.h>

static const double exponents[] = {0.5, 0.5003, 0.51, 0.77, 1, 1.5, 2, 3, 5, 17.3, 50};
static const double aspects[] = {1, 1.5, 0.37, 5, 50};
enum { EXPONENTS = sizeof exponents / sizeof *exponents, ASPECTS = sizeof aspects / sizeof *aspects };

/* area and second moment by gamma functions */
static void test_moments(const Shape *s) {
  double q = 1 / (2 * s->m), a = s->a, b = s->b;
  double area = 4 * a * b * gsl_pow_2(gsl_sf_gamma(1 + q)) / gsl_sf_gamma(1 + 2 * q);
  double I = 4 * q * q * a * b * gsl_sf_gamma(3 * q) * gsl_sf_gamma(q) / gsl_sf_gamma(1 + 4 * q);
  gsl_test_rel(area, M_PI, 1e-14, "m = %g, a/b = %g: area", s->m, a / b);
  gsl_test_rel(s->Ixx, a * a * I, 1e-14, "m = %g, a/b = %g: Ixx", s->m, a / b);
  gsl_test_rel(s->Iyy, b * b * I, 1e-14, "m = %g, a/b = %g: Iyy", s->m, a / b);
  gsl_test(s->Ixy != 0, "m = %g, a/b = %g: Ixy", s->m, a / b);
}

/* all points and normals of a fine polygon */
static void test_nodes(const Shape *s) {
  enum { N = 1024 };
  ShapeNode v[N];
  double in = 0, out = 0, most = 0, least = GSL_POSINF, off = 0, beyond = 0, low = 0, high = 0;
  shape_nodes(s, N, v);
  for (int i = 0; i < N; i++) {
    const ShapeNode *p = &v[i], *q = &v[(i + 1) % N], *o = &v[(i + N - 1) % N];
    double point[2], h = shape_farthest(s, p->nx, p->ny, point);
    in += hypot(q->x - p->x, q->y - p->y);
    out += hypot(p->tx - o->tx, p->ty - o->ty);
    low += (p->x * q->y - q->x * p->y) / 2;
    high += (o->tx * p->ty - p->tx * o->ty) / 2;
    most = GSL_MAX_DBL(most, hypot(p->x, p->y));
    off = GSL_MAX_DBL(off, fabs(shape_gauge(s, p->x, p->y) - 1));
    beyond = GSL_MAX_DBL(beyond, fabs((p->nx * p->x + p->ny * p->y) / h - 1));
    beyond = GSL_MAX_DBL(beyond, fabs((p->nx * point[0] + p->ny * point[1]) / h - 1));
    beyond = GSL_MAX_DBL(beyond, fabs(shape_support(s, p->nx, p->ny) / h - 1));
  }
  for (int i = 0; i <= 4000; i++)
    least = GSL_MIN_DBL(least, shape_support(s, cos(i * M_PI_2 / 4000), sin(i * M_PI_2 / 4000)));
  double m = s->m, k = s->a / s->b;
  gsl_test(!(in * (1 - 1e-13) <= s->perimeter && s->perimeter <= out * (1 + 1e-13)),
           "m = %g, a/b = %g: %.15g <= perimeter %.15g <= %.15g", m, k, in, s->perimeter, out);
  gsl_test(!(low < M_PI && M_PI < high && high - low < 2e-3), "m = %g, a/b = %g: area of the polygons, %.9g, %.9g", m, k, low,
           high);
  gsl_test(!(off < 1e-15), "m = %g, a/b = %g: nodes off the boundary by %g", m, k, off);
  gsl_test(!(beyond < 2e-15), "m = %g, a/b = %g: support wrong by %g", m, k, beyond);
  gsl_test(!(most <= s->outer * (1 + 1e-15) && most > s->outer * (1 - 1e-4)), "m = %g, a/b = %g: outer", m, k);
  gsl_test(!(least >= s->inner * (1 - 1e-15) && least < s->inner * (1 + 1e-3)), "m = %g, a/b = %g: inner", m, k);
}

/* r n <= g(r) h(n), and the gradient by differences */
static void test_gauge(const Shape *s, Rng *rng) {
  double above = 0, wrong = 0;
  for (int i = 0; i < 200; i++) {
    double r[2], n[2], gradient[2], e = 1e-6;
    for (int k = 0; k < 2; k++) {
      r[k] = 4 * rng_uniform(rng) - 2;
      n[k] = 4 * rng_uniform(rng) - 2;
    }
    double g = shape_slope(s, r[0], r[1], gradient);
    above = GSL_MAX_DBL(above, (r[0] * n[0] + r[1] * n[1]) / (g * shape_support(s, n[0], n[1])));
    wrong = GSL_MAX_DBL(wrong, fabs(shape_gauge(s, 3.7 * r[0], 3.7 * r[1]) / (3.7 * g) - 1));
    double along = shape_gauge(s, r[0] + e * n[0], r[1] + e * n[1]) - shape_gauge(s, r[0] - e * n[0], r[1] - e * n[1]);
    double want = 2 * e * (n[0] * gradient[0] + n[1] * gradient[1]);
    /* convex: between the slopes at both ends, which differ at a corner */
    double ahead[2], behind[2];
    shape_slope(s, r[0] + e * n[0], r[1] + e * n[1], ahead);
    shape_slope(s, r[0] - e * n[0], r[1] - e * n[1], behind);
    double most = 2 * e * (n[0] * ahead[0] + n[1] * ahead[1]), least = 2 * e * (n[0] * behind[0] + n[1] * behind[1]);
    wrong = GSL_MAX_DBL(wrong, GSL_MAX_DBL(along - most, least - along) - 1e-13 * g);
    wrong = GSL_MAX_DBL(wrong, GSL_MAX_DBL(want - most, least - want) - 1e-13 * g);
    wrong = GSL_MAX_DBL(wrong, fabs((r[0] * gradient[0] + r[1] * gradient[1]) / g - 1));
  }
  gsl_test(!(above <= 1 + 4e-15), "kind %d, m = %g: r n exceeds g h by %g", s->kind, s->m, above - 1);
  gsl_test(!(wrong < 1e-13), "kind %d, m = %g: gauge or gradient wrong by %g", s->kind, s->m, wrong);
}

typedef struct {
  const Shape *shape;
  const double *p, *q;
  int moment;
} Chord;

/* of the sector over the chord from p to q: the gauge turns it into an integral along the chord */
static double over_chord(double s, void *context) {
  const Chord *c = context;
  double x = c->p[0] + s * (c->q[0] - c->p[0]), y = c->p[1] + s * (c->q[1] - c->p[1]);
  double g = shape_gauge(c->shape, x, y), twice = c->p[0] * c->q[1] - c->p[1] * c->q[0];
  return c->moment == 0 ? twice / (2 * g * g) : twice * (c->moment == 1 ? x : y) / (3 * g * g * g);
}

static void test_sector(const Shape *s, gsl_integration_cquad_workspace *work) {
  static const double angles[] = {0, 0.2318, 0.7511, 1.2903, 1.5611, 2.3339, 3.0817, 3.4173, 4.4409, 4.9271, 6.1129};
  double last[3] = {0}, first[2] = {s->a, 0}, sector[3];
  for (int i = 1; i < 11; i++) {
    double q[2] = {s->a * cos(angles[i]), s->b * sin(angles[i])};
    double g = shape_gauge(s, q[0], q[1]);
    q[0] /= g;
    q[1] /= g;
    shape_sector(s, q[0], q[1], sector);
    for (int moment = 0; moment < 3; moment++) {
      double want, error;
      Chord chord = {s, first, q, moment};
      gsl_function f = {over_chord, &chord};
      gsl_integration_cquad(&f, 0, 1, 0, 1e-11, work, &want, &error, NULL);
      gsl_test(!(fabs(sector[moment] - last[moment] - want) < 1e-11 * (1 + fabs(want))),
               "m = %g, a/b = %g: sector %d of %d: %.14g, want %.14g", s->m, s->a / s->b, i, moment,
               sector[moment] - last[moment], want);
      last[moment] = sector[moment];
    }
    memcpy(first, q, sizeof q);
  }
}

static void test_superellipses(void) {
  Rng rng = rng_stream(61, 0, RNG_TEST);
  gsl_integration_cquad_workspace *work = gsl_integration_cquad_workspace_alloc(200);
  for (int i = 0; i < EXPONENTS; i++)
    for (int j = 0; j < ASPECTS; j++) {
      Shape *s = shape_superellipse(aspects[j], exponents[i]);
      gsl_test_rel(s->a / s->b, aspects[j], 3e-16, "m = %g: aspect %g", s->m, aspects[j]);
      test_moments(s);
      test_gauge(s, &rng);
      if (!s->sides) {
        test_nodes(s);
        if (s->m > 0.505 && j < 4)
          test_sector(s, work);
      }
      shape_free(&s);
    }
  gsl_integration_cquad_workspace_free(work);
}

/* perimeters for a = b = 1, and one for a = 1.5 */
static void test_perimeters(void) {
  static const double m[] = {1, 1.5, 2, 3, 5, 10, 50};
  static const double want[] = {6.28318530718, 6.74499314013, 7.01769794356, 7.3177263586,
                                7.57740831726, 7.78371005412, 7.95593765583};
  for (int i = 0; i < 7; i++) {
    Shape *s = shape_superellipse(1, m[i]);
    gsl_test_rel(s->perimeter / s->a, want[i], 2e-12, "perimeter, m = %g", m[i]);
    shape_free(&s);
  }
  Shape *s = shape_superellipse(1.5, 1.5);
  gsl_test_rel(s->perimeter / s->b, 8.48286676738, 2e-12, "perimeter, a/b = 1.5, m = 1.5");
  gsl_test_rel(M_PI / (s->b * s->b), 5.29991625086, 2e-12, "area, a/b = 1.5, m = 1.5");
  shape_free(&s);
}

static double excess(double aspect, void *wanted) {
  Shape *s = shape_superellipse(aspect, 1);
  double roundness = shape_roundness(s);
  shape_free(&s);
  return roundness - *(double *)wanted;
}

/* S, Table 6, to every digit that is printed: triangle, square, pentagon, hexagon, circle, whose columns run together */
static void test_table(void) {
  static const char *const round[] = {"0.777560", "0.886227", "0.929950", "0.952313", "1.000000"};
  static const char *const kappa[] = {"3.417562", "2.283670", "1.883470", "1.675994"};
  gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  for (int i = 0; i < 5; i++) {
    char text[32];
    Shape *s = i < 4 ? shape_regular(3 + i) : shape_superellipse(1, 1);
    double wanted = shape_roundness(s);
    snprintf(text, sizeof text, "%.6f", wanted);
    gsl_test(strcmp(text, round[i]) != 0, "roundness of %d: %s, S prints %s", i, text, round[i]);
    shape_free(&s);
    if (i == 4)
      break;
    gsl_function f = {excess, &wanted};
    gsl_root_fsolver_set(solver, &f, 1.01, 5);
    int status;
    do {
      gsl_root_fsolver_iterate(solver);
      status = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0, 1e-11);
    } while (status == GSL_CONTINUE);
    snprintf(text, sizeof text, "%.6f", gsl_root_fsolver_root(solver));
    gsl_test(strcmp(text, kappa[i]) != 0, "ellipse as round as %d: %s, S prints %s", i, text, kappa[i]);
  }
  gsl_root_fsolver_free(solver);
}

static void test_regular(void) {
  Rng rng = rng_stream(62, 0, RNG_TEST);
  static const int sides[] = {3, 4, 5, 6, 7, 12, 101};
  for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
    int n = sides[k];
    Shape *s = shape_regular(n);
    double t = tan(M_PI / n), area = 0, I = M_PI * M_PI * (3 + t * t) / (6 * n * t) / 2;
    for (int i = 0; i < n; i++)
      area += (s->x[i] * s->y[(i + 1) % n] - s->x[(i + 1) % n] * s->y[i]) / 2;
    gsl_test_rel(area, M_PI, 1e-14, "%d sides: area", n);
    gsl_test_rel(s->perimeter, 2 * sqrt(M_PI * n * t), 1e-14, "%d sides: perimeter", n);
    gsl_test_rel(s->inner, sqrt(M_PI / (n * t)), 1e-14, "%d sides: inner", n);
    gsl_test_rel(s->outer, sqrt(2 * M_PI / (n * sin(2 * M_PI / n))), 1e-14, "%d sides: outer", n);
    gsl_test_rel(s->Ixx, I, 1e-13, "%d sides: Ixx", n);
    gsl_test_rel(s->Iyy, I, 1e-13, "%d sides: Iyy", n);
    gsl_test(!(fabs(s->Ixy) < 1e-14), "%d sides: Ixy", n);
    gsl_test(s->y[0] != 0 || !(s->x[0] > s->outer * (1 - 1e-15)), "%d sides: a vertex on the +x axis", n);
    test_gauge(s, &rng);
    shape_free(&s);
  }
}

/* A quadrilateral far from the origin: its own frame is kept, its centroid and area are not; and its moments by the theorem of
   the parallel axes from two triangles. */
static void test_convex(void) {
  static const double v[4][2] = {{101.3, -7.1}, {103.9, -6.7}, {104.4, -3.9}, {101.8, -4.4}};
  double back[4][2], far[4][2];
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 2; k++) {
      back[i][k] = v[(4 - i) % 4][k];
      far[i][k] = 3.25 * v[i][k] - 512;
    }
  Outcome out = {0};
  Shape *s = shape_convex(4, v, &out), *t = shape_convex(4, (const double(*)[2])back, &out);
  Shape *u = shape_convex(4, (const double(*)[2])far, &out);
  gsl_test(!s || !t || !u || out.status, "a convex quadrilateral");
  double Ixx = 0, Ixy = 0, mx = 0, my = 0;
  for (int i = 0; i < 2; i++) {
    double x[3] = {s->x[0], s->x[i + 1], s->x[i + 2]}, y[3] = {s->y[0], s->y[i + 1], s->y[i + 2]};
    double area = ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 2;
    double X = (x[0] + x[1] + x[2]) / 3, Y = (y[0] + y[1] + y[2]) / 3;
    mx += area * X;
    my += area * Y;
    Ixx += area * X * X;
    Ixy += area * X * Y;
    for (int k = 0; k < 3; k++) {
      Ixx += area / 12 * gsl_pow_2(x[k] - X);
      Ixy += area / 12 * (x[k] - X) * (y[k] - Y);
    }
  }
  gsl_test(!(fabs(mx) < 1e-14 && fabs(my) < 1e-14), "the centroid is at the origin: %g %g", mx, my);
  gsl_test_rel(s->Ixx, Ixx, 1e-13, "Ixx of a quadrilateral");
  gsl_test_rel(s->Ixy, Ixy, 1e-13, "Ixy of a quadrilateral");
  for (int i = 0; i < 4; i++) {
    int j = (i + 1) % 4;
    gsl_test(s->x[i] != t->x[i] || s->y[i] != t->y[i], "vertex %d in the other order", i);
    gsl_test(!(fabs(s->x[i] - u->x[i]) + fabs(s->y[i] - u->y[i]) < 1e-12), "vertex %d of a larger one", i);
    gsl_test_rel((s->x[j] - s->x[i]) / (s->y[j] - s->y[i]), (v[j][0] - v[i][0]) / (v[j][1] - v[i][1]), 1e-12,
                 "side %d is not turned", i);
  }
  shape_free(&s);
  shape_free(&t);
  shape_free(&u);
  gsl_test(s != NULL, "freed");
}

static void test_refused(void) {
  static const struct {
    int n;
    double v[5][2];
    const char *what;
  } bad[] = {{2, {{0, 0}, {1, 1}}, "two vertices"},
             {3, {{0, 0}, {1, 1}, {2, 2}}, "three on a line"},
             {4, {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, "a dent"},
             {4, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "a bow"},
             {4, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "a vertex twice"},
             {5, {{0, 1}, {-0.59, -0.81}, {0.95, 0.31}, {-0.95, 0.31}, {0.59, -0.81}}, "a star"},
             {3, {{0, 0}, {1, 0}, {NAN, 1}}, "no number"},
             {3, {{0, 0}, {1, 0}, {0, INFINITY}}, "infinite"}};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    Outcome out = {0};
    Shape *s = shape_convex(bad[i].n, bad[i].v, &out);
    gsl_test(s || out.status != WRONG || !out.text[0], "%s is refused", bad[i].what);
    shape_free(&s);
  }
}

static void test_copy(void) {
  Shape *all[] = {shape_regular(7), shape_superellipse(1.7, 3.1), shape_superellipse(2, 0.5)};
  for (int i = 0; i < 3; i++) {
    Shape *copy = shape_copy(all[i]);
    double a[3] = {0}, b[3] = {0};
    for (double angle = 0.1; angle < 6; angle += 0.7) {
      a[0] = shape_support(all[i], cos(angle), sin(angle));
      b[0] = shape_support(copy, cos(angle), sin(angle));
      gsl_test(a[0] != b[0], "the support of copy %d at %g", i, angle);
    }
    if (!copy->sides) {
      shape_sector(all[i], 0, all[i]->b, a);
      shape_sector(copy, 0, copy->b, b);
      gsl_test(a[0] != b[0] || all[i]->node[9].tx != copy->node[9].tx, "the arcs of copy %d", i);
    }
    shape_free(&all[i]);
    gsl_test(copy->perimeter <= 0 || (copy->sides && copy->h[2] <= 0), "copy %d stands alone", i);
    shape_free(&copy);
  }
  gsl_test(shape_copy(NULL) != NULL, "a copy of nothing");
  Shape *disc = shape_superellipse(1, 1), *rhombus = shape_superellipse(1, 0.5), *square = shape_regular(4);
  gsl_test(disc->a != 1 || disc->b != 1, "the disc has the radius 1: %a", disc->a);
  gsl_test_rel(rhombus->outer, square->outer, 1e-15, "the rhombus of a/b = 1 is a square");
  shape_free(&disc);
  shape_free(&rhombus);
  shape_free(&square);
}

/* An exponent next to 1/2 is one half. */
static void test_nearly_rhombus(void) {
  Shape *near = shape_superellipse(1.3, 0.5 * (1 + 0x1p-52)), *far = shape_superellipse(1.3, 0.5 + 1e-9);
  gsl_test(near->sides != 4 || near->m != 0.5, "m one unit above 1/2 is a rhombus");
  gsl_test(far->sides != 0 || fabs(shape_support(far, 0.6, 0.8) - shape_support(near, 0.6, 0.8)) > 2e-9,
           "m = 1/2 + 1e-9 is not, and as large");
  shape_free(&near);
  shape_free(&far);
  for (int k = -1; k <= 1; k++) {
    Shape *ellipse = shape_superellipse(2, 1 + k * 0x1p-52);
    gsl_test_rel(ellipse->outer, ellipse->a, 1e-11, "the long radius of an ellipse, and of its neighbours");
    gsl_test_rel(ellipse->inner, ellipse->b, 1e-11, "and the short one");
    shape_free(&ellipse);
  }
}

int main(void) {
  test_nearly_rhombus();
  test_superellipses();
  test_perimeters();
  test_table();
  test_regular();
  test_convex();
  test_refused();
  test_copy();
  return gsl_test_summary();
}
