/* tests/test_format.c: labels by name, images by a plain search, regions that hold the particles */
#include "format.h"
#include "many.h"
#include "overlap.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static Pack *random_pack(int dim, size_t n, double side, bool shaped, Rng *rng) {
  Box box = {dim, {side, 1.3 * side, dim == 3 ? 0.8 * side : 0}};
  return two_kinds(&box, n, 0.41, 1.3, shaped, rng);
}

static void test_labels(void) {
  static const char *const name[] = {"b", "10", "nan", "9", "a", "1a", "9.0"};
  static const int want[] = {6, 3, 7, 1, 5, 4, 2};
  Species species[7] = {{.radius = 1}};
  Box box = {3, {4, 4, 4}};
  Writing w;
  int wrong = 0;
  for (int s = 0; s < 7; s++) {
    species[s].radius = 1;
    strcpy(species[s].name, name[s]);
  }
  species[4].count = 1;
  Pack *pack = pack_alloc(&box, species, 7, false);
  format_begin(&w, pack, "");
  for (int s = 0; s < 7; s++)
    wrong += w.label[s] != want[s] || strcmp(format_name(&w, want[s]), name[s]) != 0;
  gsl_test(wrong, "labels: numbers by value, then words (%d wrong)", wrong);
  gsl_test(format_label(&w, 0) != 5, "the label of a particle");
  format_end(&w);
  format_end(&w);
  pack_free(&pack);
}

typedef struct {
  size_t n, cut;
  double area; /* in the box, of shapes */
  int outside;
  const Writing *w;
  const Body *box;
} Seen;

static void see(void *of, const Image *image) {
  Seen *seen = of;
  seen->n++;
  seen->cut += image->cut;
  if (!seen->box)
    return;
  Body body = pack_body(seen->w->pack, image->particle);
  Overlap o;
  body.x = image->x[0];
  body.y = image->x[1];
  bool found = overlap_find(&body, seen->box, &o);
  seen->outside += !found;
  seen->area += found ? o.area : 0;
}

static size_t count_images(double x, double y) {
  Species one = {.name = "A", .radius = 1, .count = 1};
  Box box = {2, {4, 4, 0}};
  Pack *pack = pack_alloc(&box, &one, 1, false);
  Writing w;
  Seen seen = {0};
  pack->x[0] = x;
  pack->x[1] = y;
  format_begin(&w, pack, "");
  format_images(&w, see, &seen);
  format_end(&w);
  pack_free(&pack);
  return seen.n;
}

static void test_images_by_hand(void) {
  gsl_test(count_images(0.5, 0.8) != 4, "a disc at a corner: four images");
  gsl_test(count_images(0.8, 0.8) != 3, "a disc beside a corner: three");
  gsl_test(count_images(2.1, 3.5) != 2, "a disc across a face: two");
  gsl_test(count_images(2.1, 2.5) != 1, "a disc inside: one");
  gsl_test(count_images(1, 2) != 1, "a disc that touches a face: one");
}

/* All images from -4 to 4 boxes, each by the nearest point of the box. */
static void plain_images(const Pack *pack, size_t *n, size_t *cut) {
  int dim = pack->box.dim;
  *n = *cut = 0;
  for (size_t i = 0; i < pack->n; i++)
    for (int image = 0; image < (dim == 3 ? 729 : 81); image++) {
      int move[] = {image % 9 - 4, image / 9 % 9 - 4, image / 81 - 4};
      double square = 0, r = pack_radius(pack, i);
      bool out = false;
      for (int k = 0; k < dim; k++) {
        double L = pack->box.side[k], x = pack->x[i * (size_t)dim + (size_t)k] + move[k] * L;
        double near = x < 0 ? 0 : x > L ? L : x;
        square += (x - near) * (x - near);
        out |= x < r || x > L - r;
      }
      *n += square < r * r;
      *cut += square < r * r && out;
    }
}

static void test_images(void) {
  Rng rng = rng_stream(31, 0, RNG_TEST);
  int differ = 0, outside = 0;
  double worst = 0;
  for (int k = 0; k < as_many(20, 200); k++) {
    int dim = 2 + k % 2;
    Pack *pack = random_pack(dim, 40, k % 3 ? 5.3 : 0.9, false, &rng);
    Writing w;
    Seen seen = {0};
    size_t n, cut;
    format_begin(&w, pack, "");
    format_images(&w, see, &seen);
    plain_images(pack, &n, &cut);
    differ += seen.n != n || seen.cut != cut;
    format_end(&w);
    pack_free(&pack);
  }
  gsl_test(differ, "images of balls, in narrow boxes too (%d differ)", differ);
  for (int k = 0; k < as_many(10, 100); k++) {
    Pack *pack = random_pack(2, 20, k % 2 ? 4 : 2.1, true, &rng);
    double L[] = {pack->box.side[0], pack->box.side[1]};
    const double corner[4][2] = {{0, 0}, {L[0], 0}, {L[0], L[1]}, {0, L[1]}};
    Outcome out = {0};
    Shape *shape = shape_convex(4, corner, &out);
    Body box = {shape, sqrt(L[0] * L[1] / M_PI), L[0] / 2, L[1] / 2, 1, 0};
    Writing w;
    format_begin(&w, pack, "");
    Seen seen = {.w = &w, .box = &box};
    format_images(&w, see, &seen);
    worst = fmax(worst, fabs(seen.area / pack_solid(pack) - 1));
    outside += seen.outside;
    format_end(&w);
    shape_free(&shape);
    pack_free(&pack);
  }
  gsl_test(!(worst < 1e-12), "the images of shapes have all of their area in the box (%g)", worst);
  gsl_test(outside, "and no image of a shape is outside (%d are)", outside);
}

/* Outlines: inscribed in the particle, and as far as it reaches. */
static void test_outlines(void) {
  Rng rng = rng_stream(32, 0, RNG_TEST);
  Pack *pack = random_pack(2, 30, 7, true, &rng);
  Writing w;
  double off = 0, reach = 0;
  format_begin(&w, pack, "");
  for (size_t i = 0; i < pack->n; i++) {
    const Outline *outline = &w.outline[pack_kind(pack, i)];
    Body body = pack_body(pack, i);
    double low[3], high[3], most[4] = {0}, area = 0, p[2], q[2];
    format_extent(pack, i, low, high);
    for (int k = 0; k < outline->n; k++) {
      format_corner(outline, &body, k, p);
      format_corner(outline, &body, (k + 1) % outline->n, q);
      area += (p[0] * q[1] - p[1] * q[0]) / 2;
      for (int j = 0; j < 2; j++) {
        most[j] = fmax(most[j], p[j]);
        most[2 + j] = fmin(most[2 + j], p[j]);
      }
    }
    double share = area / (M_PI * body.radius * body.radius);
    off = fmax(off, pack_kind(pack, i) ? fabs(share - 1) : share > 1 ? 1 : 1 - share - 0.01);
    for (int j = 0; j < 2; j++)
      reach = fmax(reach, fmax(fabs(most[j] - high[j]), fabs(most[2 + j] - low[j])) - (pack_kind(pack, i) ? 0 : 0.02));
  }
  gsl_test(!(off < 1e-12), "outlines have the area of their shapes, curves a little less (%g)", off);
  gsl_test(!(reach < 1e-12), "and reach as far (%g)", reach);
  format_end(&w);
  pack_free(&pack);
}

/* A finite pack is written about its middle, and its region just holds it. */
static void test_region(void) {
  Rng rng = rng_stream(33, 0, RNG_TEST);
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = random_pack(dim, 50, 20, dim == 2, &rng);
    Writing w;
    double x[3], low[3], high[3], bound[2][3] = {{9e9, 9e9, 9e9}, {-9e9, -9e9, -9e9}}, off = 0, moved = 0;
    pack->open = 3;
    format_begin(&w, pack, "");
    for (size_t i = 0; i < pack->n; i++) {
      format_place(&w, i, x);
      format_extent(pack, i, low, high);
      for (int k = 0; k < dim; k++) {
        bound[0][k] = fmin(bound[0][k], x[k] + low[k]);
        bound[1][k] = fmax(bound[1][k], x[k] + high[k]);
        moved = fmax(moved, fabs(pack->x[i * (size_t)dim + (size_t)k] - pack->box.side[k] / 2 - x[k]));
      }
    }
    for (int k = 0; k < dim; k++)
      off = fmax(off, fmax(fabs(w.low[k] - bound[0][k]), fabs(w.low[k] + w.side[k] - bound[1][k])));
    gsl_test(!(off < 1e-12), "%d-D: the region of a finite pack just holds it (%g)", dim, off);
    gsl_test(moved != 0, "and its middle is at 0");
    Seen seen = {0};
    format_images(&w, see, &seen);
    gsl_test(seen.n != pack->n || seen.cut != 0, "it has no images");
    format_end(&w);
    pack_free(&pack);
  }
}

int main(void) {
  test_labels();
  test_images_by_hand();
  test_images();
  test_outlines();
  test_region();
  return gsl_test_summary();
}
