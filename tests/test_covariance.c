/* tests/test_covariance.c: exact two-point functions against closed forms, single shifts and each other */
#include "covariance.h"
#include "cover.h"
#include "elementary.h"
#include "many.h"
#include "outcome.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

static Pack *some(int dim, size_t n, size_t m, double radius, double other, Shape *shape, const double side[], Rng *rng) {
  Species species[2] = {{.name = "A", .radius = radius, .count = n, .shape = shape}, {.name = "B", .radius = other, .count = m}};
  Box box = {dim, {side[0], side[1], dim == 3 ? side[2] : 0}};
  Pack *pack = pack_alloc(&box, species, m ? 2 : 1, false);
  for (size_t i = 0; i < pack->n * (size_t)dim; i++)
    pack->x[i] = rng ? box.side[i % (size_t)dim] * rng_uniform(rng) : 0.4 * box.side[i % (size_t)dim];
  for (size_t i = 0; pack->angle && i < pack->n; i++)
    pack->angle[i] = rng ? 2 * M_PI * rng_uniform(rng) : 0.7;
  shape_free(&shape);
  return pack;
}

static Covariance *found(const Pack *pack, double step, size_t n, bool species, double accuracy) {
  Outcome out = {0};
  Covariance *c = covariance_exact(pack, step, n, species, accuracy, &out);
  if (!c)
    gsl_test(1, "found: %s", out.text);
  return c;
}

static double disc(double r) {
  return r < 2 ? 2 * acos(r / 2) - 0.5 * r * sqrt(4 - r * r) : 0;
}

/* Of the unit square, by its side. */
static double square(double r) {
  if (r <= 1)
    return 1 - 4 * r / M_PI + r * r / M_PI;
  return r < M_SQRT2 ? 2 / M_PI * (asin(1 / r) - acos(1 / r) + 2 * sqrt(r * r - 1) - r * r / 2 - 1) : 0;
}

/* One particle in a box so wide that images are out of reach: its set covariance. The table: K / A at r / D_eq. */
static void test_single(void) {
  static const double wide[] = {11, 10, 0}, R = 1.3;
  static const double table[][6] = {{.8429671, .6325996, .3491388, .1496175, .0340357, .0004714},
                                    {.8660827, .6764475, .3903644, .1432311, .0056495, 0},
                                    {.8687040, .6807741, .3915950, .1437012, .0029326, 0},
                                    {.8679581, .6738168, .3744498, .1323004, .0243925, 0},
                                    {.8638943, .6697312, .3845010, .1496092, .0092251, 0},
                                    {.81064334, .54090688, .21795440, .11353572, .06388807, .03513638}};
  static const double at[] = {.1, .25, .5, .75, 1, 1.25};
  Pack *pack = some(2, 1, 0, R, 0, NULL, wide, NULL);
  double volume = box_volume(&pack->box);
  Covariance *c = found(pack, 0.13 * R, 17, false, 1e-9);
  for (size_t k = 0; k < 17; k++)
    gsl_test_abs(c->all[k] * volume / (R * R), disc(0.13 * (double)k), 1e-9, "a disc, r = %g", 0.13 * (double)k);
  covariance_free(&c);
  pack_free(&pack);
  pack = some(2, 1, 0, 1 / sqrt(M_PI), 0, shape_regular(4), wide, NULL);
  c = found(pack, 0.11, 14, false, 1e-6);
  for (size_t k = 0; k < 14; k++)
    gsl_test_abs(c->all[k] * volume, square(0.11 * (double)k), 3e-6, "a square, r = %g", 0.11 * (double)k);
  covariance_free(&c);
  pack_free(&pack);
  for (int s = 0; s < 6; s++) {
    Shape *shape = s == 0   ? shape_regular(3)
                   : s == 1 ? shape_regular(5)
                   : s == 2 ? shape_regular(6)
                   : s == 3 ? shape_superellipse(1.5, 1.5)
                   : s == 4 ? shape_superellipse(1, 5)
                            : shape_superellipse(5, 1);
    pack = some(2, 1, 0, R, 0, shape, wide, NULL);
    c = found(pack, 0.1 * R, 26, false, s < 3 ? 1e-6 : 4e-6);
    for (int k = 0; k < 6; k++)
      if (s < 3 || k < 5 || s == 5)
        gsl_test_abs(c->all[(size_t)(20 * at[k] + 0.5)] * volume / (M_PI * R * R), table[s][k], s < 3 ? 6e-6 : 1.6e-4,
                     "shape %d of the table, r / D = %g", s, at[k]);
    covariance_free(&c);
    pack_free(&pack);
  }
}

/* Two balls by hand; a ball in a ball's reach at all distances against a sum over directions. */
static void test_balls(void) {
  static const double wide[] = {20, 21, 22};
  Rng rng = rng_stream(5, 0, RNG_TEST);
  Pack *pack = some(3, 2, 0, 1, 0, NULL, wide, NULL);
  pack->x[3] += 3;
  Covariance *c = found(pack, 0.5, 9, false, 1e-6);
  double volume = box_volume(&pack->box);
  gsl_test_rel(c->all[4] * volume, 2 * 11 * M_PI / 720, 1e-12, "two balls, r = 2");
  gsl_test_rel(c->all[2] * volume, 2 * M_PI * 5 / 12, 1e-12, "two balls, r = 1: each alone");
  covariance_free(&c);
  pack_free(&pack);
  pack = some(3, 3, 2, 1.1, 0.4, NULL, (const double[]){3.5, 4.1, 7}, NULL);
  static const double places[] = {1, 1, 1, 2.7, 3, 2, 1, 2, 4.5, 2.8, 1, 1, 3.2, 2, 5.5};
  for (int i = 0; i < 15; i++)
    pack->x[i] = places[i];
  c = found(pack, 0.75, 7, true, 1e-6);
  for (size_t k = 0; k < 7; k++) {
    double sum = 0, u[3];
    int M = as_many(3000, 100000);
    for (int m = 0; m < M; m++) {
      rng_direction(&rng, 3, u);
      for (int j = 0; j < 3; j++)
        u[j] *= 0.75 * (double)k;
      sum += covariance_at(pack, u) / M;
    }
    gsl_test_abs(c->all[k], sum, 3 * 0.05 / sqrt(M) + 1e-12, "balls in a small box, beyond half of it, r = %g", 0.75 * (double)k);
    gsl_test_rel(c->pair[k] + 2 * c->pair[7 + k] + c->pair[14 + k], c->all[k], 1e-12, "pairs of species sum up");
  }
  covariance_free(&c);
  pack->x[3] = 1;
  pack->x[4] = 1.5;
  pack->x[5] = 1;
  Outcome out = {0};
  c = covariance_exact(pack, 0.75, 7, true, 1e-6, &out);
  gsl_test(c || out.status != UNREACHED, "balls that overlap are refused");
  pack_free(&pack);
}

/* A small ball is carried into a large one: the mean as a sum over the distance u. */
static void test_inside(void) {
  Pack *pack = some(3, 1, 1, 1.3, 0.4, NULL, (const double[]){30, 30, 30}, NULL);
  double D = 1.9, r = 1.7, a = 1.3, b = 0.4, sum = 0;
  enum { M = 20000 };
  pack->x[3] += D;
  for (int k = 0; k < M; k++) {
    double u = D - r + 2 * r * (k + 0.5) / M, s = a + b, d = a - b;
    double w = u >= s ? 0 : u <= d ? 4 * M_PI / 3 * b * b * b : M_PI * (s - u) * (s - u) * (u * u + 2 * u * s - 3 * d * d) / (12 * u);
    sum += w * u / (2 * D * r) * (2 * r / M);
  }
  Covariance *c = found(pack, r, 2, true, 1e-6);
  gsl_test_rel(c->pair[3] * 27000, sum, 1e-6, "a small ball in a large one");
  covariance_free(&c);
  pack_free(&pack);
}

static void expect_angles(const Pack *pack, double step, int M, double tolerance, const char *what) {
  Covariance *c = found(pack, step, 8, false, 1e-4);
  for (size_t k = 0; c && k < 8; k++) {
    double sum = 0, x, y;
    for (int m = 0; m < M; m++) {
      elementary_turn(M_PI * (m + 0.31) / M, &x, &y);
      sum += covariance_at(pack, (const double[]){x * step * (double)k, y * step * (double)k}) / M;
    }
    gsl_test_abs(c->all[k], sum, k ? tolerance : 1e-12, "%s, r = %g", what, step * (double)k);
  }
  covariance_free(&c);
}

/* Two squares that face each other: small circles see the middle of an edge. */
static void test_facing(void) {
  Pack *pack = some(2, 2, 0, 1, 0, shape_regular(4), (const double[]){9, 7}, NULL);
  pack->angle[0] = pack->angle[1] = M_PI / 4;
  pack->x[2] += sqrt(M_PI) + 0.3;
  expect_angles(pack, 0.17, 800, 5e-5, "facing squares");
  pack_free(&pack);
}

/* Means over directions of exact areas, with images and holes, up to the whole diagonal of the box. */
static void test_angles(void) {
  static const double side[] = {9, 7, 0};
  Rng rng = rng_stream(6, 0, RNG_TEST);
  Pack *pack = some(2, 5, 4, 1.1, 0.8, shape_regular(5), side, &rng);
  expect_angles(pack, 1.63, as_many(48, 1000), 6e-4, "pentagons and discs that overlap");
  expect_angles(pack, 0.31, as_many(48, 1000), 6e-4, "pentagons and discs, nearer");
  pack_free(&pack);
  pack = some(2, 1, 0, 1.1, 0, shape_regular(5), (const double[]){3.1, 4.2}, &rng);
  expect_angles(pack, 0.73, as_many(48, 1000), 6e-4, "a pentagon and its images");
  pack_free(&pack);
  pack = some(2, 4, 0, 1.1, 0, shape_superellipse(50, 1), side, &rng);
  expect_angles(pack, 1.63, as_many(48, 1000), 2e-3, "needles");
  pack_free(&pack);
  pack = some(2, 6, 3, 1.1, 0.6, NULL, side, &rng);
  expect_angles(pack, 1.63, as_many(48, 1000), 6e-4, "discs that overlap");
  pack_free(&pack);
  pack = some(2, 40, 0, 1.5, 0, NULL, side, &rng);
  expect_angles(pack, 1.63, as_many(48, 1000), 6e-4, "nearly all covered");
  pack_free(&pack);
}

/* Discs by lenses and by their boundary; species that share no point and some that do. */
static void test_roads(void) {
  static const double side[] = {8, 6, 0};
  Pack *pack = some(2, 2, 1, 1.2, 0.7, NULL, side, NULL);
  static const double places[] = {1, 1, 4, 2, 6.2, 4.4};
  for (int i = 0; i < 6; i++)
    pack->x[i] = places[i];
  Pack *own = pack_alloc(&pack->box, pack->species, 2, true);
  for (int i = 0; i < 6; i++)
    own->x[i] = places[i] + (i == 4 ? -1.2 : 0);
  pack->x[4] = own->x[4];
  Covariance *c = found(pack, 0.4, 20, true, 1e-6);
  own->kind[0] = own->kind[1] = 0;
  Shape *round = shape_superellipse(1, 1);
  pack->species[0].shape = round;
  pack->angle = memory(3, sizeof *pack->angle);
  Covariance *d = found(pack, 0.4, 20, true, 1e-4);
  for (size_t k = 0; k < 20; k++) {
    gsl_test_abs(d->all[k], c->all[k], 1e-4, "lenses and boundaries, r = %g", 0.4 * (double)k);
    for (size_t p = 0; p < 3; p++)
      gsl_test_abs(d->pair[20 * p + k], c->pair[20 * p + k], 1e-4, "lenses and boundaries, pair %d, r = %g", (int)p, 0.4 * (double)k);
  }
  covariance_free(&c);
  covariance_free(&d);
  pack_free(&own);
  pack_free(&pack);
}

/* The mean over all shifts of the box is the square of the fraction; by a lattice of shifts. */
static void test_torus(void) {
  static const double side[] = {5, 4, 0};
  Rng rng = rng_stream(8, 0, RNG_TEST);
  Pack *pack = some(2, 2, 2, 0.9, 0.6, shape_superellipse(1.4, 2.2), side, &rng);
  double sum = 0, phi = covariance_at(pack, (const double[]){0, 0});
  enum { N = 24 };
  for (int i = 0; i < N * N; i++)
    sum += covariance_at(pack, (const double[]){side[0] * (i % N) / N, side[1] * (i / N) / N}) / (N * N);
  gsl_test_abs(sum, phi * phi, 2e-4, "the mean over all shifts");
  pack_free(&pack);
}

/* Of the pieces of one body, and of two that cross: vectors add up, of points and of halves; points have the area of what they bound,
   and a chord stands where the points stand in the mean. */
static void test_pieces(void) {
  Shape *shape[] = {shape_superellipse(1.7, 3), shape_superellipse(1, 0.6), shape_superellipse(2, 0.8), shape_superellipse(1.3, 40)};
  for (int c = 0; c < 8; c++) {
    Body bodies[2] = {{shape[c % 4], 1.2, 5, 5, 0.8, 0.6}, {NULL, 0.9, 6, 5.3, 1, 0}};
    size_t n = 1 + (size_t)c / 4;
    for (double bulge = 1e-2; bulge > 1e-4; bulge /= 16) {
      size_t pieces, parts = 0;
      double area = 0, x = 0, y = 0, off = 0, out = 0;
      CoverArc *arc = cover_arcs(bodies, n, NULL, bulge, &pieces);
      for (size_t i = 0; i < pieces; i++) {
        const CoverArc *e = &arc[i], *f = e + 1, *g = f + e->all / 2;
        CoverPoint sum = {0};
        double across = 0, square = e->ex * e->ex + e->ey * e->ey;
        for (int k = 0; k < COVER_POINTS; k++) {
          const CoverPoint *p = &e->point[k];
          area += e->all > 1 ? 0 : 0.5 * ((e->x + p->x) * p->ey - (e->y + p->y) * p->ex);
          across += (e->ex * p->y - e->ey * p->x) * (e->ex * p->ex + e->ey * p->ey) / square;
          sum.ex += p->ex, sum.ey += p->ey;
        }
        out = GSL_MAX(out, fabs(across));
        off = GSL_MAX(off, fabs(sum.ex - e->ex) + fabs(sum.ey - e->ey));
        if (e->all > 1)
          off = GSL_MAX(off, fabs(f->ex + g->ex - e->ex) + fabs(f->ey + g->ey - e->ey) + fabs((double)(f->all + g->all + 1 - e->all)));
        else
          x += e->ex, y += e->ey, parts++;
      }
      double exact = cover_area(bodies, n, NULL, NULL);
      gsl_test_abs(fabs(x) + fabs(y), 0, 1e-12, "pieces are closed, %d", c);
      gsl_test_abs(off, 0, 1e-13, "points and halves make up an arc, %d", c);
      gsl_test_abs(out, 0, bulge < 1e-3 ? 1e-7 : 1e-4, "a chord stands where the points do, %d", c);
      gsl_test_rel(area, exact, bulge < 1e-3 ? 1e-8 : 1e-4, "points have the area, %d", c);
      gsl_test_abs((double)pieces, 15. / 8 * (double)parts, 0, "an arc is halved three times, %d", c);
      free(arc);
    }
  }
  for (int k = 0; k < 4; k++)
    shape_free(&shape[k]);
}

static void test_edges(void) {
  Pack *pack = some(2, 1, 0, 1, 0, shape_regular(3), (const double[]){5, 5, 0}, NULL);
  Covariance *c = found(pack, 0.1, 1, false, 1e-3);
  gsl_test_rel(c->all[0], M_PI / 25, 1e-12, "r = 0 alone");
  covariance_free(&c);
  gsl_test(c != NULL, "freed");
  pack_free(&pack);
  Species none = {.name = "A", .radius = 1};
  pack = pack_alloc(&(Box){2, {5, 5, 0}}, &none, 1, false);
  c = found(pack, 0.1, 5, false, 1e-3);
  gsl_test(c->all[0] != 0 || c->all[4] != 0, "no particle");
  covariance_free(&c);
  pack_free(&pack);
}

int main(void) {
  test_single();
  test_balls();
  test_inside();
  test_facing();
  test_angles();
  test_roads();
  test_torus();
  test_pieces();
  test_edges();
  return gsl_test_summary();
}
