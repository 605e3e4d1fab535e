/* Pairs at an edge: a slow program, independent points, and pairs of points whose K is known, cut out of a torus. */
#include "edges.h"
#include "many.h"
#include "outcome.h"
#include "pairs.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>
#include <stdlib.h>

enum { SHAPES = 6, BINS = 5 };
static const char *const name[SHAPES] = {"rectangle", "disc", "box", "ball", "cylinder", "slab"};
static const char *const how_name[] = {"default", "toroidal", "minus", "ripley", "translation"};
static Window window_of(int shape) {
  static const Window all[SHAPES] = {
      {WINDOW_BOX, 2, {5, 6}, {5.3, 4.1}, 0, 0, 0},       {WINDOW_BALL, 2, {5, 6}, {0}, 2.6, 0, 0},
      {WINDOW_BOX, 3, {5, 6, 4}, {4.3, 4.1, 3.9}, 0, 0, 0}, {WINDOW_BALL, 3, {5, 6, 4}, {0}, 2.5, 0, 0},
      {WINDOW_CYLINDER, 3, {5, 6, 4}, {0}, 2.3, 4.2, 1},
      {WINDOW_BOX, 3, {5, 6, 4}, {10, 4.1, 8}, 0, 0, 0, {true, false, true}},
  };
  return all[shape];
}
static Box torus(int dim) { return (Box){dim, {10, 12, dim == 3 ? 8 : 0}}; }

/* The estimate of one bin, pair by pair, as the equation has it. */
static double slow(const EdgesView *v, double r1, double r2, double *variance) {
  const Pack *pack = v->pack;
  const Window *w = v->window;
  size_t dim = (size_t)w->dim;
  double sum = 0, square = 0, n[2] = {0, 0}, deep[2] = {0, 0}, V = window_volume(w);
  for (size_t i = 0; i < pack->n; i++)
    for (int e = 0; e < 2; e++) {
      int kind = e ? v->m : v->k;
      bool is = v->k < 0 || pack_kind(pack, i) == kind;
      n[e] += is;
      deep[e] += is && window_depth(w, pack->x + i * dim) >= r2;
    }
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i + 1; j < pack->n; j++) {
      double h[3] = {0}, r = 0, weight = 0;
      int a = pack_kind(pack, i), b = pack_kind(pack, j);
      if (v->k >= 0 && !((a == v->k && b == v->m) || (a == v->m && b == v->k)))
        continue;
      for (size_t k = 0; k < dim; k++)
        r += gsl_pow_2(h[k] = box_nearest(pack->x[j * dim + k] - pack->x[i * dim + k], pack->box.side[k]));
      r = sqrt(r);
      if (!(r >= r1 && r < r2))
        continue;
      for (int e = 0; e < 2; e++) {
        const double *x = pack->x + (e ? j : i) * dim;
        weight += v->how == EDGES_TRANSLATION ? V / window_overlap(w, h)
                  : v->how == EDGES_RIPLEY    ? 1 / window_share(w, x, r)
                                              : window_depth(w, x) >= r2;
      }
      sum += weight;
      square += weight * weight;
    }
  bool like = v->k < 0 || v->k == v->m;
  double all = v->how == EDGES_MINUS ? (like ? deep[0] * (n[0] - 1) : deep[0] * n[1] + deep[1] * n[0])
                                     : (like ? n[0] * (n[0] - 1) : 2 * n[0] * n[1]);
  *variance = gsl_pow_2(V / all) * square;
  return V / all * sum;
}

static void against_slow(int shape) {
  Window window = window_of(shape);
  Box box = torus(window.dim);
  Species two[] = {{"A", 0.3, 1100}, {"B", 0.7, 900}};
  Pack *pack = scattered(&box, two, 2, 8), *cut = window_cut(pack, &window);
  for (EdgesHow how = EDGES_MINUS; how <= EDGES_TRANSLATION; how++)
    for (int k = -1; k < 2; k++)
      for (int m = GSL_MAX(k, 0); m < (k < 0 ? 1 : 2); m++) {
        EdgesView view = {cut, &window, how, k, m};
        double reach = (how == EDGES_MINUS ? 0.5 : 0.9) * edges_limit(&window, how), origin = 0.4 * reach, step = (reach - origin) / BINS;
        Edges edges = edges_count(&view, origin, step, BINS);
        double variance, worst = fabs(edges.below / slow(&view, 0, origin, &variance) - 1), scatter = 0;
        for (size_t b = 0; b < BINS; b++) {
          double K = slow(&view, origin + (double)b * step, origin + ((double)b + 1) * step, &variance);
          worst = GSL_MAX(worst, fabs(edges.growth[b] / K - 1));
          scatter = GSL_MAX(scatter, fabs(edges.variance[b] / variance - 1));
        }
        gsl_test_abs(worst, 0, 1e-11, "%s, %s, species %d %d: as pair by pair", name[shape], how_name[how], k, m);
        gsl_test_abs(scatter, 0, 1e-11, "%s, %s, species %d %d: its variance", name[shape], how_name[how], k, m);
        edges_free(&edges);
      }
  pack_free(&pack);
  pack_free(&cut);
}

typedef struct {
  double sum, square, error; /* of values; of their own estimate of variance */
  int n;
} Mean;
static void add(Mean *mean, double value, double variance) {
  mean->sum += value;
  mean->square += value * value;
  mean->error += variance;
  mean->n++;
}
static double mean_of(const Mean *mean) { return mean->sum / mean->n; }
static double scatter_of(const Mean *mean) {
  return (mean->square / mean->n - gsl_pow_2(mean_of(mean))) * mean->n / (mean->n - 1);
}

/* So many points in the window, no more nor less: K has no bias, in no bin; of minus sampling two of the sixty. */
static void independent(int shape) {
  for (EdgesHow how = EDGES_MINUS; how <= EDGES_TRANSLATION; how++) {
    Mean K[BINS + 1] = {{0}};
    double reach = 0, step = 0;
    int packs = as_many(600, 20000);
    for (int p = 0; p < packs; p++) {
      Window window = window_of(shape);
      Rng rng = rng_stream(30, (uint64_t)(p + packs * shape), RNG_TEST);
      Box box = torus(window.dim);
      Species sixty = {"P", 0.1, 60};
      Pack *pack = pack_alloc(&box, &sixty, 1, false);
      for (size_t i = 0; i < pack->n; i++)
        window_point(&window, 0, &rng, pack->x + i * (size_t)window.dim);
      Pack *cut = window_cut(pack, &window);
      reach = (how == EDGES_MINUS ? 0.35 : 0.95) * edges_limit(&window, how);
      step = reach / (BINS + 0.5);
      EdgesView view = {cut, &window, how, -1, -1};
      Edges edges = edges_count(&view, step / 2, step, BINS);
      add(&K[0], edges.below, 0);
      for (int b = 0; b < BINS; b++)
        add(&K[b + 1], edges.growth[b], edges.variance[b]);
      edges_free(&edges);
      pack_free(&pack);
      pack_free(&cut);
    }
    int dim = window_of(shape).dim;
    double worst = 0;
    for (int b = 0; b <= BINS; b++) {
      double want = pairs_shell(dim, b ? (b - 0.5) * step : 0, (b + 0.5) * step);
      double off = fabs(mean_of(&K[b]) - want) - (how == EDGES_MINUS ? want / 30 : 0);
      worst = GSL_MAX(worst, off / sqrt(scatter_of(&K[b]) / packs));
    }
    gsl_test(worst > 4, "%s, %s: K of independent points, worst %.2f errors", name[shape], how_name[how], worst);
    if (how == EDGES_RIPLEY) /* of the others the sum about a centre depends on where it is */
      gsl_test_rel(K[1].error / packs, scatter_of(&K[1]), 0.15, "%s, %s: and its error", name[shape], how_name[how]);
  }
}

/* Points in pairs at one distance and in all directions, in a torus: n^2 K is known of a cut-out. */
static void in_pairs(int shape) {
  double apart = 0.5, origin = 0.4, step = 0.2;
  for (EdgesHow how = EDGES_MINUS; how <= EDGES_TRANSLATION; how++) {
    Mean product = {0};
    int packs = as_many(200, 4000), dim = window_of(shape).dim;
    Box box = torus(dim);
    size_t d = (size_t)dim;
    for (int p = 0; p < packs; p++) {
      Window window = window_of(shape);
      Rng rng = rng_stream(31, (uint64_t)(p + packs * shape), RNG_TEST);
      Species one = {"A", 0.1, 400};
      Pack *pack = pack_alloc(&box, &one, 1, false);
      for (size_t i = 0; i < pack->n; i++) {
        double u[3];
        rng_direction(&rng, dim, u);
        for (size_t k = 0; k < d; k++)
          pack->x[i * d + k] = i % 2 ? box_wrap(pack->x[(i - 1) * d + k] + apart * u[k], box.side[k])
                                     : box.side[k] * rng_uniform(&rng);
      }
      Pack *cut = window_cut(pack, &window);
      EdgesView view = {cut, &window, how, -1, -1};
      Edges edges = edges_count(&view, origin, step, 1);
      double n = (double)cut->n;
      add(&product, edges.growth[0] * n * (n - 1) / gsl_pow_2(window_volume(&window)), 0);
      edges_free(&edges);
      pack_free(&pack);
      pack_free(&cut);
    }
    double n = 400 / box_volume(&box);
    double want = n * n * (1 - 2. / 400) * pairs_shell(dim, origin, origin + step) + n;
    double slip = how == EDGES_MINUS ? want / 20 : 0;
    double off = (mean_of(&product) - want) / (slip + sqrt(scatter_of(&product) / packs));
    gsl_test(fabs(off) > 4, "%s, %s: points in pairs, %.2f errors (%.4g, not %.4g)", name[shape], how_name[how], off,
             mean_of(&product), want);
  }
}

/* Nothing to see: no centre is deep enough, or there is one particle. */
static void blind(void) {
  Window window = {WINDOW_BOX, 3, {5, 5, 5}, {4, 4, 4}, 0, 0, 0}, moved = window;
  double x[] = {3.1, 5, 5, 6.9, 5, 5}, radius[] = {0.5, 0.25}, side[] = {10, 10, 10};
  Pack *pack = particles(3, side, 2, x, radius), *cut = window_cut(pack, &moved);
  EdgesView view = {cut, &moved, EDGES_MINUS, -1, -1};
  Edges edges = edges_count(&view, 0, 0.5, 4);
  gsl_test(!edges.blind, "no centre is so deep");
  gsl_test_rel(edges_fraction(cut, &moved), pack_ball(3, 1) * (0.125 + 1. / 64) / 64, 1e-14, "the fraction by centres");
  gsl_test_rel(edges_number(&view, 6.4), 0.1, 1e-14, "the number within K");
  edges_free(&edges);
  cut->n = 1;
  view.how = EDGES_RIPLEY;
  edges = edges_count(&view, 0, 0.5, 4);
  gsl_test(!edges.blind || edges.growth[3] != 0 || edges.below != 0, "one particle has no pairs");
  edges_free(&edges);
  gsl_test_rel(edges_limit(&window, EDGES_MINUS), 2, 1e-15, "limit of minus sampling");
  gsl_test_rel(edges_limit(&window, EDGES_RIPLEY), sqrt(12), 1e-15, "limit of Ripley's");
  gsl_test_rel(edges_limit(&window, EDGES_TRANSLATION), 4, 1e-15, "limit of translation");
  pack_free(&pack);
  pack_free(&cut);
}

int main(void) {
  for (int shape = 0; shape < SHAPES; shape++) {
    against_slow(shape);
    independent(shape);
    in_pairs(shape);
  }
  blind();
  return gsl_test_summary();
}
