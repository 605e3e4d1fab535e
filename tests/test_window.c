/* Windows of observation: shares of spheres, overlaps, depths; random directions and points, exact limits, quadrature. */
#include "window.h"
#include "many.h"
#include "scatter.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>

enum { SHAPES = 8 };
static const char *const name[SHAPES] = {"rectangle", "disc", "box", "ball", "cylinder", "pipe", "slab", "endless pipe"};
static Window window_of(int shape) {
  static const Window all[SHAPES] = {
      {WINDOW_BOX, 2, {3.1, 2.2}, {4.3, 2.9}, 0, 0, 0},
      {WINDOW_BALL, 2, {3.1, 2.2}, {0}, 1.7, 0, 0},
      {WINDOW_BOX, 3, {3.1, 2.2, 4.7}, {4.3, 2.9, 3.7}, 0, 0, 0},
      {WINDOW_BALL, 3, {3.1, 2.2, 4.7}, {0}, 1.9, 0, 0},
      {WINDOW_CYLINDER, 3, {3.1, 2.2, 4.7}, {0}, 1.9, 2.6, 1},
      {WINDOW_CYLINDER, 3, {3.1, 2.2, 4.7}, {0}, 0.8, 5.3, 2},
      {WINDOW_BOX, 3, {3.1, 2.2, 4.7}, {6.2, 2.9, 9.4}, 0, 0, 0, {true, false, true}},
      {WINDOW_CYLINDER, 3, {3.1, 2.2, 4.7}, {0}, 1.9, 9.4, 2, {false, false, true}},
  };
  return all[shape];
}

/* Is the point inside? Written anew. */
static bool inside(const Window *w, const double x[]) {
  double square = 0;
  for (int k = 0; k < w->dim; k++) {
    double d = fabs(x[k] - w->middle[k]);
    if (w->wraps[k])
      continue;
    if (w->shape == WINDOW_BOX && d > w->side[k] / 2)
      return false;
    if (w->shape == WINDOW_CYLINDER && k == w->axis && d > w->height / 2)
      return false;
    if (w->shape != WINDOW_CYLINDER || k != w->axis)
      square += d * d;
  }
  return w->shape == WINDOW_BOX || square <= w->radius * w->radius;
}

/* The share of a sphere about many points, against random directions; and the overlap that belongs to each. */
static void directions(int shape) {
  Window w = window_of(shape);
  Rng rng = rng_stream(17, (uint64_t)shape, RNG_TEST);
  int points = as_many(300, 3000), tries = 3000;
  double worst = 0, sum = 0, square = 0;
  for (int p = 0; p < points; p++) {
    double x[3] = {0}, y[3] = {0}, u[3];
    window_point(&w, 0, &rng, x);
    double r = window_outer(&w) * (0.02 + 0.97 * rng_uniform(&rng));
    double share = window_share(&w, x, r);
    int in = 0;
    for (int t = 0; t < tries; t++) {
      rng_direction(&rng, w.dim, u);
      for (int k = 0; k < w.dim; k++)
        y[k] = x[k] + r * u[k];
      in += inside(&w, y);
    }
    double error = sqrt((share * (1 - share) + 1. / tries) / tries), off = (share - (double)in / tries) / error;
    worst = GSL_MAX(worst, fabs(off));
    sum += off;
    square += off * off;
  }
  gsl_test(worst > 5, "%s: shares are those of directions, worst %.1f errors", name[shape], worst);
  gsl_test(fabs(sum / sqrt(points)) > 4, "%s: shares on the average, %.2f errors", name[shape], sum / sqrt(points));
  gsl_test(square > 1.4 * points, "%s: their scatter, %.2f", name[shape], square / points);
}

/* Overlap and volume against random points; the mean of shares is the mean of overlaps. */
static void points(int shape) {
  Window w = window_of(shape);
  Rng rng = rng_stream(18, (uint64_t)shape, RNG_TEST);
  int many = as_many(100000, 1000000);
  double extent[3], r = 0.9 * window_inner(&w), h[3] = {0}, x[3] = {0}, u[3], share = 0, overlap = 0, v = 1;
  window_extent(&w, extent);
  for (int k = 0; k < w.dim; k++) {
    v *= extent[k];
    h[k] = (k == 1 ? -0.3 : 0.2) * extent[k];
  }
  int in = 0, both = 0;
  for (int t = 0; t < many; t++) {
    for (int k = 0; k < w.dim; k++)
      x[k] = w.middle[k] + extent[k] * (rng_uniform(&rng) - 0.5);
    bool here = inside(&w, x);
    in += here;
    for (int k = 0; k < w.dim; k++)
      x[k] -= h[k];
    both += here && inside(&w, x);
    window_point(&w, 0, &rng, x);
    share += window_share(&w, x, r);
    rng_direction(&rng, w.dim, u);
    for (int k = 0; k < w.dim; k++)
      u[k] *= r;
    overlap += window_overlap(&w, u);
  }
  double e = 3 / sqrt(many);
  gsl_test_rel(v * in / many, window_volume(&w), e, "%s: volume", name[shape]);
  gsl_test_rel(v * both / many, window_overlap(&w, h), 2 * e, "%s: overlap", name[shape]);
  gsl_test_rel(share / many, overlap / many / window_volume(&w), e, "%s: the mean share is the mean overlap", name[shape]);
  double nowhere[3] = {0, 0, 0}, far[3] = {0, 1.1 * extent[1], 0};
  gsl_test_rel(window_overlap(&w, nowhere), window_volume(&w), 1e-14, "%s: all of it overlaps itself", name[shape]);
  gsl_test_abs(window_overlap(&w, far), 0, 0, "%s: nothing overlaps from afar", name[shape]);
}

/* Depths: a ball of this radius about a point is inside, and one a little larger is not. */
static void depths(int shape) {
  Window w = window_of(shape);
  Rng rng = rng_stream(19, (uint64_t)shape, RNG_TEST);
  double x[3] = {0}, deepest = 0;
  int wrong = 0, shallow = 0;
  for (int t = 0; t < 20000; t++) {
    double depth = 0.6 * window_inner(&w);
    window_point(&w, depth, &rng, x);
    shallow += !(window_depth(&w, x) >= depth * (1 - 1e-12));
    window_point(&w, 0, &rng, x);
    double d = window_depth(&w, x), out = d + 1e-9;
    deepest = GSL_MAX(deepest, d);
    wrong += window_share(&w, x, d * (1 - 1e-9)) < 1 - 1e-9;
    bool cut = false; /* towards the nearest wall */
    for (int k = 0; k < w.dim && w.shape == WINDOW_BOX; k++)
      for (int s = -1; s <= 1; s += 2) {
        if (w.wraps[k])
          continue;
        double y[3] = {x[0], x[1], x[2]};
        y[k] += s * out;
        cut |= !inside(&w, y);
      }
    wrong += w.shape == WINDOW_BOX && !cut;
  }
  gsl_test_int(shallow, 0, "%s: points that are to be deep are", name[shape]);
  gsl_test_int(wrong, 0, "%s: depths end at the wall", name[shape]);
  gsl_test(!(deepest <= window_inner(&w) && deepest > 0.9 * window_inner(&w)), "%s: the deepest point", name[shape]);
  x[1] = w.middle[1] + 1.01 * (window_across(&w) + window_outer(&w));
  gsl_test(!(window_depth(&w, x) < 0), "%s: outside the depth is negative", name[shape]);
}

/* On a face, an edge and a corner; in the middle; beyond all walls. */
static void limits(void) {
  for (int shape = 0; shape < SHAPES; shape++) {
    Window w = window_of(shape);
    double x[3] = {w.middle[0], w.middle[1], w.middle[2]}, far = window_outer(&w) * (1 + 1e-9);
    if (w.wraps[2]) { /* a side of 9.4; of the slab's sphere at half another side a band is inside, 2.9 of 6.2 wide */
      gsl_test_rel(window_outer(&w), shape == 6 ? 3.1 : 4.7, 1e-15, "%s: images end it", name[shape]);
      gsl_test_rel(window_share(&w, x, 3.1), shape == 6 ? 2.9 / 6.2 : 1 - sqrt(1 - gsl_pow_2(1.9 / 3.1)), 1e-6, "%s: some is inside", name[shape]);
      continue;
    }
    gsl_test_rel(window_share(&w, x, 1e-12), 1, 1e-14, "%s: small spheres are whole", name[shape]);
    gsl_test_abs(window_share(&w, x, far), 0, 1e-12, "%s: beyond all walls is nothing", name[shape]);
    if (w.shape != WINDOW_BOX)
      continue;
    double part = 1;
    for (int k = 0; k < w.dim; k++) {
      x[k] += (k == 1 ? -1 : 1) * w.side[k] / 2;
      part /= 2;
      gsl_test_rel(window_share(&w, x, 0.7), part, 1e-14, "%s: on %d walls", name[shape], k + 1);
    }
    gsl_test(!(window_share(&w, x, 2 * window_outer(&w) * (1 - 1e-6)) > 0), "%s: the far corner is seen", name[shape]);
  }
}

/* Digits that have been worked out by hand: a wedge and a corner of the sphere, from their planes. */
static void digits(void) {
  Window w = {WINDOW_BOX, 3, {5, 5, 5}, {10, 10, 10}, 0, 0, 0};
  double a = 0.3, b = 0.5, c = 0.6, r = 1;
  double at[3] = {10 - a, 10 - b, 5}, cornered[3] = {10 - a, 10 - b, 10 - c};
  /* By integration over u_1: circles of radius q, of which the part beyond b (and c) is an arc. */
  double wedge = 0, corner = 0;
  enum { N = 400000 };
  for (int i = 0; i < N; i++) {
    double u = a + (1 - a) * (i + 0.5) / N, q = sqrt(1 - u * u);
    wedge += q > b ? acos(b / q) / (2 * M_PI) * (1 - a) / N : 0;
    if (q * q > b * b + c * c)
      corner += (acos(b / q) - asin(c / q)) / (4 * M_PI) * (1 - a) / N;
  }
  gsl_test_rel(window_share(&w, at, r), 1 - (1 - a) / 2 - (1 - b) / 2 + wedge, 1e-8, "a wedge by integration");
  double planes = 1 - (3 - a - b - c) / 2, pairs = wedge; /* the other two wedges by shares of two walls */
  double second[3] = {10 - a, 5, 10 - c}, third[3] = {5, 10 - b, 10 - c};
  pairs += window_share(&w, second, r) - 1 + (1 - a) / 2 + (1 - c) / 2;
  pairs += window_share(&w, third, r) - 1 + (1 - b) / 2 + (1 - c) / 2;
  gsl_test_rel(window_share(&w, cornered, r), planes + pairs - corner, 1e-8, "a corner by integration");
}

/* The quadrature of the cylinder against an adaptive one. */
typedef struct {
  double R, t, r;
} Cut;
static double slice(double z, void *p) {
  const Cut *q = p;
  double rho = sqrt(GSL_MAX(0, q->r * q->r - z * z)), c = (q->R * q->R - q->t * q->t - rho * rho) / (2 * q->t * rho);
  return rho <= q->R - q->t ? 1 : rho >= q->R + q->t ? 0 : 1 - acos(c) / M_PI;
}
static void cylinders(void) {
  gsl_integration_workspace *space = gsl_integration_workspace_alloc(2000);
  Rng rng = rng_stream(20, 0, RNG_TEST);
  double worst = 0;
  for (int n = 0; n < as_many(300, 5000); n++) {
    Window w = window_of(4 + n % 2);
    double x[3], d[3], sum = 0, part, error, square = 0;
    window_point(&w, 0, &rng, x);
    for (int k = 0; k < 3; k++)
      square += k == w.axis ? 0 : gsl_pow_2(d[k] = x[k] - w.middle[k]);
    Cut q = {w.radius, sqrt(square), window_outer(&w) * (0.02 + 0.97 * rng_uniform(&rng))};
    gsl_function f = {slice, &q};
    double low = GSL_MAX(-q.r, w.middle[w.axis] - w.height / 2 - x[w.axis]);
    double high = GSL_MIN(q.r, w.middle[w.axis] + w.height / 2 - x[w.axis]);
    double whole = sqrt(GSL_MAX(0, q.r * q.r - gsl_pow_2(q.R - q.t))), none = sqrt(GSL_MAX(0, q.r * q.r - gsl_pow_2(q.R + q.t)));
    double edge[6] = {low, -whole, -none, none, whole, high};
    for (int k = 0; k < 5; k++) {
      double from = GSL_MIN(high, GSL_MAX(low, edge[k])), to = GSL_MIN(high, GSL_MAX(low, edge[k + 1]));
      if (to > from && !gsl_integration_qags(&f, from, to, 1e-10, 1e-10, 2000, space, &part, &error))
        sum += part;
    }
    worst = GSL_MAX(worst, fabs(sum / (2 * q.r) - window_share(&w, x, q.r)));
  }
  gsl_test_abs(worst, 0, 1e-6, "a cylinder by quadrature (%.1e)", worst);
  gsl_integration_workspace_free(space);
}

/* Centres that are deep, and random points that are. */
static void deep(int shape) {
  Window w = window_of(shape);
  Box box = {w.dim, {6.2, 4.4, w.dim == 3 ? 9.4 : 0}};
  Species one[] = {{"A", 0.3, 2000}};
  Pack *pack = scattered(&box, one, 1, 5);
  bool is[2000];
  double depth = 0.4 * window_inner(&w);
  size_t many = window_within(&w, pack, depth, is), wrong = 0, seen = 0;
  for (size_t i = 0; i < pack->n; i++) {
    bool so = window_depth(&w, pack->x + i * (size_t)w.dim) >= depth;
    wrong += so != is[i];
    seen += so;
  }
  gsl_test(wrong > 0 || seen != many || many == 0, "%s: %zu centres are deep", name[shape], many);
  Rng rng = rng_stream(6, 0, RNG_TEST);
  Pack *points = window_points(&w, pack, depth, 500, &rng);
  for (size_t i = 0; i < points->n; i++)
    wrong += !(window_depth(&w, points->x + i * (size_t)w.dim) >= depth * (1 - 1e-12));
  gsl_test(wrong > 0 || points->n != 500, "%s: random points are deep", name[shape]);
  pack_free(&points);
  pack_free(&pack);
}

/* A cut-out has the particles that are inside, their species, and their distances; no image is nearer. */
static void cuts(int shape) {
  Window w = window_of(shape), moved = w;
  Box box = {w.dim, {6.2, 4.4, w.dim == 3 ? 9.4 : 0}};
  Species two[] = {{"A", 0.3, 400}, {"B", 0.7, 700}};
  Pack *pack = scattered(&box, two, 2, 4);
  Pack *cut = window_cut(pack, &moved);
  size_t dim = (size_t)w.dim, n = 0, first = 0, off = 0, near = 0;
  for (size_t i = 0; i < pack->n; i++) {
    if (!inside(&w, pack->x + i * dim))
      continue;
    if (n < cut->n)
      for (size_t k = 0; k < dim; k++) {
        double there = cut->x[n * dim + k] - moved.middle[k];
        off += fabs(there - (pack->x[i * dim + k] - w.middle[k])) > 1e-12;
        near += w.wraps[k] ? cut->box.side[k] != box.side[k] : !(fabs(there) * 4 < cut->box.side[k]);
      }
    first += pack->kind[i] == 0;
    n++;
  }
  gsl_test(n != cut->n || n == 0 || n == pack->n, "%s: %zu of %zu are cut out", name[shape], cut->n, pack->n);
  gsl_test(first != cut->species[0].count || n - first != cut->species[1].count, "%s: with their species", name[shape]);
  gsl_test(off > 0 || near > 0, "%s: in their places, without images", name[shape]);
  gsl_test_rel(cut->open, window_inner(&w), 1e-15, "%s: a finite pack", name[shape]);
  pack_free(&pack);
  pack_free(&cut);
}

int main(void) {
  for (int shape = 0; shape < SHAPES; shape++) {
    directions(shape);
    points(shape);
    depths(shape);
    cuts(shape);
    deep(shape);
  }
  limits();
  digits();
  cylinders();
  return gsl_test_summary();
}
