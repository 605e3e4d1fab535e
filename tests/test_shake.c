/* Shaking: against all pairs with the same random numbers, against exact
   densities, and against overlap. */
#include "crm.h"
#include "lattice.h"
#include "shake.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const rule_name[] = {"metropolis", "retry", "collision",
                                        "collision-longest"};
static const double cube[3] = {1, 1, 1};

static Pack *empty(int dim, size_t n, double r1, size_t n2, double r2,
                   const double ratio[], double fraction, bool own) {
  Species s[2] = {{.name = "A", .radius = r1, .count = n},
                  {.name = "B", .radius = r2, .count = n2}};
  double solid = (double)n * pack_ball(dim, r1) + (double)n2 * pack_ball(dim, r2);
  Box box = box_make(dim, ratio, solid / fraction);
  return pack_alloc(&box, s, n2 ? 2 : 1, own);
}

static Pack *grown(int dim, size_t n, double r1, size_t n2, double r2,
                   const double ratio[], double fraction, bool own) {
  Pack *pack = empty(dim, n, r1, n2, r2, ratio, fraction, own);
  Rng rng = rng_stream(17, n + n2, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = rng_uniform(&rng) * pack->box.side[c % (size_t)dim];
  for (size_t i = 0; own && i < pack->n; i++)
    pack->radius[i] *= .5 + .5 * rng_uniform(&rng);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .1, .fraction = fraction,
                  .points = true};
  CrmReport report;
  Outcome out = {0};
  if (crm_grow(pack, &plan, &rng, &report, &out))
    gsl_test(1, "a pack to shake: %s", out.text);
  return pack;
}

static Pack *copy(const Pack *pack) {
  Pack *same = pack_alloc(&pack->box, pack->species, pack->kinds, pack->radius);
  memcpy(same->x, pack->x, pack->n * (size_t)pack->box.dim * sizeof *pack->x);
  if (pack->radius)
    memcpy(same->radius, pack->radius, pack->n * sizeof *pack->radius);
  return same;
}

/* ------------------------------------------------------------ all pairs */
typedef struct {
  const Pack *pack;
  double core;          /* taken off each radius */
  double (*x)[3];
  uint64_t trials, moved;
} Plain;

static double radius(const Plain *plain, size_t i) {
  return pack_radius(plain->pack, i) - plain->core;
}

static void ball(Rng *rng, int dim, double p[3]) {
  double square;
  p[2] = 0;
  do {
    square = 0;
    for (int k = 0; k < dim; k++) {
      p[k] = 2 * rng_uniform(rng) - 1;
      square += p[k] * p[k];
    }
  } while (square > 1 || square == 0);
}

static bool clear(const Plain *plain, size_t i, const double y[3]) {
  const Pack *pack = plain->pack;
  for (size_t j = 0; j < pack->n; j++) {
    double square = 0, sum = radius(plain, i) + radius(plain, j);
    for (int k = 0; k < pack->box.dim; k++) {
      double d = box_nearest(plain->x[j][k] - y[k], pack->box.side[k]);
      square += d * d;
    }
    if (j != i && square < sum * sum)
      return false;
  }
  return true;
}

/* The way from y to the least of 3^d images of all others, 5^d of few. */
static double way(const Plain *plain, size_t i, const double y[3],
                  const double u[3]) {
  const Pack *pack = plain->pack;
  int dim = pack->box.dim, each = pack->n < 20 ? 5 : 3;
  int images = dim == 2 ? each * each : each * each * each;
  double best = INFINITY;
  for (size_t j = 0; j < pack->n; j++)
    for (int m = 0; j != i && m < images; m++) {
      double b = 0, c = 0, sum = radius(plain, i) + radius(plain, j);
      for (int k = 0, rest = m; k < dim; k++, rest /= each) {
        double side = pack->box.side[k];
        double d = box_nearest(plain->x[j][k] - y[k], side) +
                   (rest % each - each / 2) * side;
        b += d * u[k];
        c += d * d;
      }
      c -= sum * sum;
      if (b > 0 && b * b >= c)
        best = fmin(best, fmax(c, 0) / (b + sqrt(b * b - c)));
    }
  return best;
}

static double path(const Plain *plain, size_t i, const double u[3],
                   double sight) {
  const Box *box = &plain->pack->box;
  double stage = box_reach(box), y[3] = {0, 0, 0};
  for (double gone = 0; gone < sight && plain->pack->n > 1; gone += stage) {
    for (int k = 0; k < box->dim; k++)
      y[k] = box_wrap(plain->x[i][k] + u[k] * gone, box->side[k]);
    double t = way(plain, i, y, u);
    if (t <= stage)
      return fmin(gone + t, sight);
  }
  return sight;
}

static void plain_turn(Plain *plain, const ShakePlan *plan, double R, size_t i,
                       Rng *rng) {
  const Box *box = &plain->pack->box;
  double window = R * radius(plain, i), p[3], y[3] = {0}, go[3] = {0};
  bool places = plan->rule <= SHAKE_RETRY, made = false;
  bool once = plan->rule == SHAKE_METROPOLIS || plan->rule == SHAKE_COLLISION;
  double sight = plan->rule == SHAKE_COLLISION_LONGEST
                     ? fmax(1, R) * radius(plain, i) : window;
  double longest = -1, share = 0, u[3], most[3] = {0};
  for (int t = 0; t < (once ? 1 : plan->tries); t++) {
    double square = 0;
    ball(rng, box->dim, p);
    plain->trials++;
    for (int k = 0; k < box->dim; k++)
      square += p[k] * p[k];
    for (int k = 0; k < box->dim; k++)
      u[k] = p[k] / sqrt(square);
    if (places) {
      for (int k = 0; k < box->dim; k++)
        y[k] = box_wrap(plain->x[i][k] + window * p[k], box->side[k]);
      if ((made = clear(plain, i, y)))
        break;
    } else {
      double far = path(plain, i, u, sight);
      if (far > longest) {
        longest = far;
        share = box->dim == 2 ? square : square * sqrt(square);
        memcpy(most, u, sizeof u);
      }
      if (longest >= sight)
        break;
    }
  }
  if (!places) {
    made = longest > 0;
    for (int k = 0; k < box->dim; k++) {
      go[k] = share * fmin(longest, window) * most[k];
      y[k] = box_wrap(plain->x[i][k] + go[k], box->side[k]);
    }
  }
  plain->moved += made;
  for (int k = 0; made && k < box->dim; k++)
    plain->x[i][k] = y[k];
}

static void against_all_pairs(const char *what, const Pack *start, double R,
                              int sweeps) {
  for (int rule = 0; rule < 4; rule++) {
    Pack *pack = copy(start);
    ShakePlan plan = {(ShakeRule)rule, R, 20, false};
    ShakeReport report = {0};
    Outcome out = {0};
    Shake *shake = shake_alloc(pack, &plan, &out);
    Rng rng = rng_stream(5, 0, RNG_TEST), same = rng;
    shake_sweeps(shake, (uint64_t)sweeps, &rng, &report);
    double depth = pack_audit(pack);
    Plain plain = {.pack = start, .core = fmax(0, -depth) / 2,
                   .x = calloc(pack->n, sizeof *plain.x)};
    size_t dim = (size_t)pack->box.dim;
    for (size_t i = 0; i < pack->n; i++)
      memcpy(plain.x[i], pack->x + i * dim, dim * sizeof *pack->x);
    for (int s = 0; s < sweeps; s++)
      for (size_t t = 0; t < pack->n; t++)
        plain_turn(&plain, &plan, R, shake_order(shake)[t], &same);
    shake_store(shake, pack);
    size_t differ = 0;
    for (size_t c = 0; c < pack->n * dim; c++)
      differ += pack->x[c] != plain.x[c / dim][c % dim];
    gsl_test(differ || plain.trials != report.trials ||
                 plain.moved != report.moved ||
                 report.turns != (uint64_t)sweeps * pack->n ||
                 memcmp(&rng, &same, sizeof rng),
             "%s, R=%g, %s: as all pairs have it, %zu differ, moved %g of %g", what, R,
             rule_name[rule], differ, (double)report.moved, (double)report.turns);
    free(plain.x);
    shake_free(&shake);
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ no overlap */
static void no_overlap(const char *what, const Pack *start, double R,
                       uint64_t sweeps, bool adapt) {
  for (int rule = 0; rule < 4; rule++) {
    Pack *pack = copy(start);
    ShakePlan plan = {(ShakeRule)rule, R, 10, adapt};
    ShakeReport report = {0};
    Outcome out = {0};
    Rng rng = rng_stream(6, 0, RNG_TEST);
    Shake *shake = shake_alloc(pack, &plan, &out);
    shake_sweeps(shake, sweeps, &rng, &report);
    shake_store(shake, pack);
    double gap = pack_audit(pack) / (2 * pack_largest(pack));
    bool in = true;
    for (size_t c = 0; c < pack->n * (size_t)pack->box.dim; c++)
      in &= pack->x[c] >= 0 && pack->x[c] < pack->box.side[c % (size_t)pack->box.dim];
    gsl_test(gap < -1e-12 || !in || report.moved == 0,
             "%s, R=%g%s, %s: gap %.2g diameters, moved %.3g of %.3g, R to %.3g",
             what, R, adapt ? " adapted" : "", rule_name[rule], gap,
             (double)report.moved, (double)report.turns, report.radius);
    shake_free(&shake);
    pack_free(&pack);
  }
}

int main(void) {
  Pack *pack = grown(3, 200, 1, 0, 0, cube, .55, false);
  against_all_pairs("3-D", pack, .02, 3);
  against_all_pairs("3-D", pack, .3, 3);
  no_overlap("3-D", pack, .05, 300, false);
  no_overlap("3-D", pack, .05, 100, true);
  pack_free(&pack);
  pack = grown(2, 200, 1, 0, 0, cube, .70, false);
  against_all_pairs("2-D", pack, .05, 5);
  no_overlap("2-D", pack, .1, 300, false);
  pack_free(&pack);
  pack = grown(3, 12, 1, 200, .1, cube, .30, false);
  against_all_pairs("ratio 10", pack, .1, 2);
  no_overlap("ratio 10", pack, .1, 100, false);
  pack_free(&pack);
  pack = grown(3, 8, 1, 0, 0, cube, .45, false);
  against_all_pairs("8 spheres", pack, .2, 10);
  against_all_pairs("8 spheres", pack, 30, 1);
  pack_free(&pack);
  return gsl_test_summary();
}
