/* Neighbour search against loops over all images. */
#include "cells.h"
#include "outcome.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Pack *uniform(int dim, const double side[], size_t n, double radius,
                     uint64_t seed, bool own_radii) {
  Box box = {.dim = dim};
  for (int k = 0; k < dim; k++)
    box.side[k] = side[k];
  Species species = {.name = "a", .radius = radius, .count = n};
  Pack *pack = pack_alloc(&box, &species, 1, own_radii);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t i = 0; i < n * (size_t)dim; i++)
    pack->x[i] = side[i % (size_t)dim] * rng_uniform(&rng);
  for (size_t i = 0; own_radii && i < n; i++)
    pack->radius[i] = radius * (0.1 + 1.9 * rng_uniform(&rng));
  return pack;
}

typedef struct {
  uint32_t i, j;
  double d[3], r;
} Link;

static int by_link(const void *a, const void *b) {
  const Link *p = a, *q = b;
  if (p->i != q->i)
    return p->i < q->i ? -1 : 1;
  if (p->j != q->j)
    return p->j < q->j ? -1 : 1;
  for (int k = 0; k < 3; k++)
    if (p->d[k] < q->d[k] || p->d[k] > q->d[k])
      return p->d[k] < q->d[k] ? -1 : 1;
  return 0;
}

typedef struct {
  size_t n, room;
  Link *link;
} Links;

static void add(Links *links, Link link) {
  if (links->n == links->room)
    links->link = memory_grow(links->link, links->room = 2 * links->room + 64,
                              sizeof link);
  for (int k = 0; k < 3; k++)
    link.d[k] += 0.0; /* no -0 */
  links->link[links->n++] = link;
}

static Links all_images(const Pack *pack, double reach) {
  Links links = {0, 0, NULL};
  int dim = pack->box.dim, far[3] = {0, 0, 0};
  for (int k = 0; k < dim; k++)
    far[k] = (int)(reach / pack->box.side[k]) + 2;
  for (uint32_t i = 0; i < pack->n; i++)
    for (uint32_t j = 0; j < pack->n; j++)
      for (int p = -far[0]; p <= far[0]; p++)
        for (int q = -far[1]; q <= far[1]; q++)
          for (int s = -far[2]; s <= far[2]; s++) {
            int image[3] = {p, q, s};
            Link link = {i, j, {0, 0, 0}, 0};
            double square = 0;
            for (int k = 0; k < dim; k++) {
              link.d[k] = (pack->x[j * (size_t)dim + (size_t)k] -
                           pack->x[i * (size_t)dim + (size_t)k]) +
                          image[k] * pack->box.side[k];
              square += link.d[k] * link.d[k];
            }
            link.r = sqrt(square);
            if (square <= reach * reach && (i != j || p || q || s))
              add(&links, link);
          }
  return links;
}

static Links found(const Pack *pack, double reach, bool turned) {
  Links links = {0, 0, NULL};
  Neighbours *list = cells_neighbours(pack, reach);
  for (size_t i = 0; i < list->n; i++)
    for (size_t k = list->first[i]; k < list->first[i + 1]; k++) {
      Link link = {(uint32_t)i, list->neighbour[k], {0, 0, 0}, list->r[k]};
      for (int m = 0; m < 3; m++)
        link.d[m] =
            turned ? -list->d[3 * k + (size_t)m] : list->d[3 * k + (size_t)m];
      if (turned) {
        link.i = list->neighbour[k];
        link.j = (uint32_t)i;
      }
      add(&links, link);
    }
  cells_neighbours_free(&list);
  gsl_test(list != NULL, "the freed list is nulled");
  return links;
}

static int differ(Links *a, Links *b) {
  if (a->n != b->n)
    return 1;
  if (a->n == 0)
    return 0;
  qsort(a->link, a->n, sizeof(Link), by_link);
  qsort(b->link, b->n, sizeof(Link), by_link);
  for (size_t k = 0; k < a->n; k++)
    if (by_link(&a->link[k], &b->link[k]) || a->link[k].r != b->link[k].r)
      return 1;
  return 0;
}

/* Each unordered pair of images once: links over half the spans. */
static size_t half_pairs(const Pack *pack, double reach, int *most) {
  Cells *cells = cells_alloc(pack, reach);
  int room = cells_spans_most(cells);
  Span *span = memory((size_t)room, sizeof *span);
  size_t pairs = 0;
  for (size_t c = 0; c < cells->cells; c++) {
    *most = *most || cells_spans(cells, c, false, span) > room;
    int spans = cells_spans(cells, c, true, span);
    for (uint32_t t = cells->start[c]; t < cells->start[c + 1]; t++)
      for (int s = 0; s < spans; s++)
        for (uint32_t j = s ? span[s].begin : t + 1; j < span[s].end; j++) {
          double square = 0;
          for (int k = 0; k < cells->dim; k++)
            square +=
                gsl_pow_2((cells->x[k][j] - cells->x[k][t]) + span[s].shift[k]);
          pairs += square <= reach * reach;
        }
  }
  free(span);
  cells_free(&cells);
  return pairs;
}

static void right(const char *what, Pack *pack, double reach) {
  Links all = all_images(pack, reach), here = found(pack, reach, false);
  Links turned = found(pack, reach, true);
  int too_many = 0;
  size_t half = half_pairs(pack, reach, &too_many);
  gsl_test(differ(&all, &here), "%s: neighbours are all images (%zu)", what,
           all.n);
  gsl_test(differ(&here, &turned), "%s: symmetric", what);
  gsl_test(2 * half != all.n, "%s: half spans hold half the links", what);
  gsl_test(too_many, "%s: spans fit", what);
  free(all.link);
  free(here.link);
  free(turned.link);
  pack_free(&pack);
}

static void test_images(void) {
  static const double boxes[][3] = {
      {3.17, 3.17, 3.17}, {1, 1, 20}, {20, 1, 1}, {1, 20, 1}, {2.3, 3.1, 4.7}};
  static const double part[] = {0.11, 0.34, 0.5, 0.97, 1, 1.43, 2.61};
  char what[80];
  for (int dim = 2; dim <= 3; dim++)
    for (int b = 0; b < 5; b++)
      for (int p = 0; p < 7; p++) {
        const double *side = boxes[b];
        double least = GSL_MIN(side[0], side[1]);
        least = dim == 3 ? GSL_MIN(least, side[2]) : least;
        size_t n = part[p] > 1 ? 23 : 157;
        snprintf(what, sizeof what, "%d-D box %d reach %g", dim, b, part[p]);
        right(what, uniform(dim, side, n, 0.1, (uint64_t)(100 * b + p), false),
              part[p] * least);
      }
  for (size_t n = 0; n <= 3; n++)
    for (int p = 0; p < 7; p++) {
      snprintf(what, sizeof what, "%zu particles reach %g", n, part[p]);
      right(what, uniform(3, boxes[4], n, 0.1, 5, false), part[p] * 2.3);
      right(what, uniform(2, boxes[4], n, 0.1, 5, false), part[p] * 2.3);
    }
}

/* Points on the edges of cells of every width, below the side, coincident. */
static void test_edges(void) {
  const double side[3] = {6, 6, 6};
  for (int m = 1; m <= 12; m++) {
    Pack *pack = uniform(3, side, 120, 0.1, (uint64_t)m, false);
    for (size_t i = 0; i < 360; i++) {
      double edge = floor(pack->x[i]) * (6.0 / 12);
      if (i % 3 == 0)
        pack->x[i] = edge;
      if (i % 5 == 0)
        pack->x[i] = edge > 0 ? nextafter(edge, 0) : nextafter(6, 0);
      if (i % 7 == 0)
        pack->x[i] = nextafter(edge, 6);
    }
    memcpy(pack->x + 30, pack->x + 330, 15 * sizeof(double));
    right("points on edges", pack, 3.0 * 6 / (3.0 * m));
  }
  /* a lattice, every neighbour at the reach but for rounding */
  Pack *pack = uniform(3, side, 216, 0.1, 3, false);
  for (size_t i = 0; i < 216; i++)
    for (size_t k = 0; k < 3; k++)
      pack->x[3 * i + k] = (double)(i / (k == 0 ? 36 : k == 1 ? 6 : 1) % 6);
  Neighbours *list = cells_neighbours(pack, 1);
  gsl_test_int((int)list->first[216], 6 * 216, "neighbours at the reach");
  cells_neighbours_free(&list);
  right("lattice", pack, 2);
}

static void test_sizes(void) {
  const double side[3] = {100, 100, 100}, thin[3] = {0.5, 300, 40};
  for (int dim = 2; dim <= 3; dim++)
    for (int b = 0; b < 2; b++) {
      Pack *pack = uniform(dim, b ? thin : side, 50, 0.1, 3, false);
      Cells *cells = cells_alloc(pack, 0.01);
      gsl_test(cells->cells > 13, "cells of a dilute pack: %zu", cells->cells);
      double corner[3] = {0, 0, 0};
      for (int k = 0; k < dim; k++)
        corner[k] = nextafter(b ? thin[k] : side[k], 0);
      gsl_test(cells_at(cells, corner) != cells->cells - 1, "the last corner");
      memset(corner, 0, sizeof corner);
      gsl_test(cells_at(cells, corner) != 0, "the first corner");
      gsl_test_int((int)cells->start[cells->cells], 50, "all are filed");
      cells_free(&cells);
      gsl_test(cells != NULL, "freed cells are nulled");
      cells_free(&cells);
      pack_free(&pack);
    }
}

static void test_gap(void) {
  static const double boxes[][3] = {{4, 5, 6}, {1, 1, 20}, {9, 9, 9}};
  static const double radius[] = {0.2, 1e-3, 0.6, 0, 3.7};
  for (int dim = 2; dim <= 3; dim++)
    for (int b = 0; b < 3; b++)
      for (int k = 0; k < 5; k++)
        for (size_t n = 0; n < 70; n = 3 * n + 1)
          for (int own = 0; own < 2; own++) {
            Pack *pack = uniform(dim, boxes[b], n, radius[k],
                                 (uint64_t)(7 * b + k), own);
            double slow = pack_audit(pack), fast = cells_least_gap(pack);
            gsl_test(!(fast == slow),
                     "least gap %.17g, audit %.17g (%d-D, n = %zu, a = %g)",
                     fast, slow, dim, n, radius[k]);
            pack_free(&pack);
          }
  /* small ones near each other, two large ones nearer still, but farther
     between centres than the first search looks */
  const double side[3] = {60, 60, 60};
  Pack *pack = uniform(3, side, 4, 1, 1, true);
  const double x[] = {1, 1, 1, 1, 1, 3.8, 30, 30, 30, 30, 30, 33.2};
  const double a[] = {0.01, 0.01, 1, 1};
  memcpy(pack->x, x, sizeof x);
  memcpy(pack->radius, a, sizeof a);
  gsl_test_rel(cells_least_gap(pack), 1.2, 1e-14, "the gap of the large ones");
  pack_free(&pack);
  /* the same among so many small ones that the cells are narrow, and the two are four apart */
  const double flat[3] = {7.2, 7.2, 0};
  pack = uniform(2, flat, 800, 0.001, 1, true);
  pack->n = 2;
  for (size_t c = 0; c < 24 * 24; c++) {
    double X = 0.3 * (double)(c % 24) + 0.1, Y = 0.3 * (double)(c / 24), *at = pack->x + 2 * pack->n;
    at[0] = X, at[1] = Y;
    pack->n += hypot(box_nearest(X - 0.7, 7.2), Y - 3.6) > 1.251 && hypot(X - 2.9, Y - 3.6) > 1.251;
  }
  const double two[] = {0.7, 3.6, 2.9, 3.6};
  memcpy(pack->x, two, sizeof two);
  pack->radius[0] = pack->radius[1] = 1;
  gsl_test(cells_least_gap(pack) != pack_audit(pack) || !(pack_audit(pack) < 0.2001),
           "and among many: %g, audit %g", cells_least_gap(pack), pack_audit(pack));
  pack_free(&pack);
}

/* Points at the reach of each other, filed one cell too high by rounding. */
static void test_rounding(void) {
  Rng rng = rng_stream(17, 0, RNG_TEST);
  int high = 0, corners = 0;
  for (int m = 5; m < 60; m++) {
    double side[2] = {1 + 9 * rng_uniform(&rng), 0};
    double reach = 3 * (side[0] / m);
    side[1] = 0.55 * reach; /* one cell wide */
    Pack *pack = uniform(2, side, (size_t)(4 * m), 0.1, 1, false);
    Cells *probe = cells_alloc(pack, reach);
    double corner[3] = {nextafter(side[0], 0), 0, 0};
    corners += corner[0] / probe->width[0] >= probe->m[0];
    gsl_test(cells_at(probe, corner) !=
                 (size_t)((probe->m[0] - 1) * probe->m[1]),
             "corner, m = %d", m);
    double width = probe->width[0];
    size_t cells = (size_t)probe->m[0];
    for (size_t i = 0; i < pack->n; i++) {
      double edge = (double)(i % cells) * width;
      for (int low = (int)(i / cells); low > 0 && edge > 0; low--)
        edge = nextafter(edge, 0);
      high += edge < (double)(i % cells) * width &&
              (int)(edge / width) == (int)(i % cells);
      pack->x[2 * i] = edge;
      pack->x[2 * i + 1] = 0;
    }
    cells_free(&probe);
    Links all = all_images(pack, reach), here = found(pack, reach, false);
    gsl_test(differ(&all, &here), "at the reach, m = %d (%zu)", m, all.n);
    free(all.link);
    free(here.link);
    pack_free(&pack);
  }
  gsl_test(high == 0 || corners == 0, "%d were filed high, %d corners", high,
           corners);
}

int main(void) {
  test_rounding();
  test_images();
  test_edges();
  test_sizes();
  test_gap();
  return gsl_test_summary();
}
