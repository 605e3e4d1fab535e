/* Shaking: against all pairs with the same random numbers, against exact
   densities, and against overlap. */
#include "crm.h"
#include "many.h"
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
    ShakePlan plan = {(ShakeRule)rule, R, 8, false};
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
                       uint64_t sweeps, bool adapt, bool moves) {
  for (int rule = 0; rule < 4; rule++) {
    Pack *pack = copy(start);
    ShakePlan plan = {(ShakeRule)rule, R, 5, adapt};
    ShakeReport report = {0};
    Outcome out = {0};
    Rng rng = rng_stream(6, 0, RNG_TEST);
    Shake *shake = shake_alloc(pack, &plan, &out);
    shake_sweeps(shake, rule < 3 ? sweeps : sweeps / 4 + 1, &rng, &report);
    shake_store(shake, pack);
    double gap = pack_audit(pack) / (2 * pack_largest(pack));
    bool in = true;
    for (size_t c = 0; c < pack->n * (size_t)pack->box.dim; c++)
      in &= pack->x[c] >= 0 && pack->x[c] < pack->box.side[c % (size_t)pack->box.dim];
    gsl_test(gap < -1e-12 || !in || (moves && report.moved == 0),
             "%s, R=%g%s, %s: gap %.2g diameters, moved %.3g of %.3g, R to %.3g",
             what, R, adapt ? " adapted" : "", rule_name[rule], gap,
             (double)report.moved, (double)report.turns, report.radius);
    shake_free(&shake);
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ acceptance */
static void acceptance(const char *what, const Pack *start, double R) {
  enum { SHOTS = 25, POINTS = 10 };
  Pack *pack = copy(start);
  ShakePlan plan = {SHAKE_METROPOLIS, R, 0, false};
  ShakeReport report = {0}, warm = {0};
  Outcome out = {0};
  Rng rng = rng_stream(7, 0, RNG_TEST), other = rng_stream(8, 0, RNG_TEST);
  Shake *shake = shake_alloc(pack, &plan, &out);
  double hits = 0, tried = 0;
  size_t dim = (size_t)pack->box.dim;
  Plain plain = {.pack = pack, .x = calloc(pack->n, sizeof *plain.x)};
  shake_sweeps(shake, 100, &rng, &warm);
  for (int s = 0; s < SHOTS; s++) {
    shake_store(shake, pack);
    for (size_t i = 0; i < pack->n; i++)
      memcpy(plain.x[i], pack->x + i * dim, dim * sizeof *pack->x);
    for (size_t i = 0; i < pack->n; i++)
      for (int p = 0; p < POINTS; p++) {
        double point[3], y[3];
        ball(&other, (int)dim, point);
        for (size_t k = 0; k < dim; k++)
          y[k] = box_wrap(plain.x[i][k] + R * pack_radius(pack, i) * point[k],
                          pack->box.side[k]);
        hits += clear(&plain, i, y);
        tried++;
      }
    shake_sweeps(shake, 1, &rng, &report);
  }
  double free_part = hits / tried, p = (double)report.moved / (double)report.turns;
  double se = sqrt(p * (1 - p) * (1 / tried + 1 / (double)report.turns));
  gsl_test(fabs(p - free_part) > 4 * se,
           "%s, R=%g: accepted %.4f, free part of windows %.4f (%.2f se)", what,
           R, p, free_part, (p - free_part) / se);
  free(plain.x);
  shake_free(&shake);
  pack_free(&pack);
}

/* ------------------------------------------------------------ balance */
/* From places drawn uniformly, one shake: how many come to where the least gap
   is below a layer, and how many leave. The regions do not know the
   particles' names, so that a round balances as a turn does. */
static void balance(int dim, size_t n, double R, ShakeRule rule, int tries,
                    bool balanced) {
  enum { STARTS = 8000 };
  Pack *pack = empty(dim, n, 1, 0, 0, cube, dim == 2 ? .32 : .22, false);
  ShakePlan plan = {rule, R, tries, false};
  Rng rng = rng_stream(9, 0, RNG_TEST);
  double in = 0, off = 0, layer = .3 * R;
  for (int s = 0; s < STARTS; s++) {
    double had, has;
    Outcome out = {0};
    ShakeReport report = {0};
    do {
      for (size_t c = 0; c < n * (size_t)dim; c++)
        pack->x[c] = rng_uniform(&rng) * pack->box.side[c % (size_t)dim];
      had = pack_audit(pack);
    } while (had < 0);
    Shake *shake = shake_alloc(pack, &plan, &out);
    shake_sweeps(shake, 1, &rng, &report);
    shake_store(shake, pack);
    shake_free(&shake);
    has = pack_audit(pack);
    in += had > layer && has < layer;
    off += had < layer && has > layer;
  }
  double z = (in - off) / sqrt(in + off);
  gsl_test(balanced ? fabs(z) > 3 : fabs(z) < 6,
           "%d-D, %zu, R=%g, %s of %d: %g come to contact, %g leave (%.1f se)",
           dim, n, R, rule_name[rule], tries, in, off, z);
  pack_free(&pack);
}

/* ------------------------------------------------------------ densities */
/* Two discs of radius 1 in a square: only their separation counts. How often
   is it below 2 + layer? */
enum { SIDE = 5 };
static double seen_in_layer(double R, ShakeRule rule, int tries, double layer,
                            double *se) {
  enum { BLOCKS = 40 };
  const int EACH = as_many(600, 1500);
  Species s = {.name = "A", .radius = 1, .count = 2};
  Box box = {.dim = 2, .side = {SIDE, SIDE, 0}};
  Pack *pack = pack_alloc(&box, &s, 1, false);
  ShakePlan plan = {rule, R, tries, false};
  ShakeReport report = {0};
  Outcome out = {0};
  Rng rng = rng_stream(10, 0, RNG_TEST);
  pack->x[2] = pack->x[3] = 2.4;
  Shake *shake = shake_alloc(pack, &plan, &out);
  shake_sweeps(shake, 200, &rng, &report);
  double sum = 0, square = 0;
  for (int b = 0; b < BLOCKS; b++) {
    double in = 0;
    for (int e = 0; e < EACH; e++) {
      shake_sweeps(shake, 1, &rng, &report);
      shake_store(shake, pack);
      in += pack_audit(pack) < layer;
    }
    sum += in / EACH / BLOCKS;
    square += in / EACH * in / EACH / BLOCKS;
  }
  *se = sqrt((square - sum * sum) / (BLOCKS - 1));
  shake_free(&shake);
  pack_free(&pack);
  return sum;
}

/* Far enough apart? x and y from -1/2 to 3/2 sides. */
static double apart(double x, double y) {
  x = fmin(fabs(x), fabs(SIDE - fabs(x)));
  y = fmin(fabs(y), fabs(SIDE - fabs(y)));
  return x * x + y * y;
}

/* The same from the density f / (1 - (1 - f/w)^tries), by midpoints. */
static double retry_in_layer(double R, int tries, double layer) {
  enum { GRID = 160, FINE = 24 };
  double all = 0, in = 0;
  for (int a = 0; a < GRID; a++)
    for (int b = 0; b < GRID; b++) {
      double x = (a + .5) * SIDE / GRID, y = (b + .5) * SIDE / GRID;
      double w = 0, f = 0, r2 = apart(x, y);
      if (r2 < 4)
        continue;
      for (int c = 0; c < FINE; c++)
        for (int d = 0; d < FINE; d++) {
          double u = (2 * c + 1.) / FINE - 1, v = (2 * d + 1.) / FINE - 1;
          if (u * u + v * v < 1) {
            w++;
            f += apart(x + R * u, y + R * v) >= 4;
          }
        }
      double p = f / w, density = p / (1 - pow(1 - p, tries));
      all += density;
      in += r2 < (2 + layer) * (2 + layer) ? density : 0;
    }
  return in / all;
}

static void two_discs(double R, int tries, double layer) {
  double se, uniform = retry_in_layer(R, 1, layer);
  double want = retry_in_layer(R, tries, layer);
  double seen = seen_in_layer(R, SHAKE_METROPOLIS, 1, layer, &se);
  /* The midpoints of the quadrature err by some per mille. */
  gsl_test(fabs(seen - uniform) > 4 * se + .01 * uniform,
           "two discs, R=%g: Metropolis has %.4f at contact, uniform %.4f (%.2f se)",
           R, seen, uniform, (seen - uniform) / se);
  seen = seen_in_layer(R, SHAKE_RETRY, tries, layer, &se);
  gsl_test(fabs(seen - want) > 4 * se + .01 * want || want > .9 * uniform,
           "two discs, R=%g: retry of %d has %.4f, density p/(1-(1-p)^M) %.4f (%.2f se)",
           R, tries, seen, want, (seen - want) / se);
  seen = seen_in_layer(R, SHAKE_COLLISION, 1, layer, &se);
  gsl_test(seen - uniform < 8 * se, "two discs, R=%g: collision has more, %.4f", R, seen);
  seen = seen_in_layer(R, SHAKE_COLLISION_LONGEST, 50, layer, &se);
  gsl_test(uniform - seen < 8 * se, "two discs, R=%g: the longest way has fewer, %.4f", R, seen);
}

/* The closed forms on a line, against the rules themselves: the share of the
   first tenth. */
static void on_a_line(int tries) {
  enum { BLOCKS = 50 };
  const int STEPS = as_many(300000, 1000000);
  Rng rng = rng_stream(11, 0, RNG_TEST);
  double y = .3, q = pow(.5, tries), sum = 0, square = 0;
  for (int b = 0; b < BLOCKS; b++) {
    double in = 0;
    for (int s = 0; s < STEPS / BLOCKS; s++) {
      bool shorter = rng_uniform(&rng) < q, left = (y > .5) != shorter;
      y = left ? y * rng_uniform(&rng) : y + (1 - y) * rng_uniform(&rng);
      in += y < .1 ? 1. : 0;
    }
    in /= STEPS / BLOCKS;
    sum += in / BLOCKS;
    square += in * in / BLOCKS;
  }
  /* y = z^(1/(1-q)) takes the pole away */
  double all = 0, first = 0, top = pow(.5, 1 - q);
  for (int c = 0; c < 20000; c++) {
    double at = pow((c + .5) * top / 20000, 1 / (1 - q)), f = pow(1 - at, q - 1);
    all += 2 * f;
    first += at < .1 ? f : 0;
  }
  double se = sqrt((square - sum * sum) / (BLOCKS - 1)), want = first / all;
  gsl_test(fabs(sum - want) > 4 * se + 1e-4,
           "on a line, the longest of %d: first tenth %.5f, closed form %.5f (%.2f se)",
           tries, sum, want, (sum - want) / se);
  if (tries == 1)
    gsl_test(fabs(want - 2 / M_PI * asin(sqrt(.1))) > 2e-4, "which is the arcsine law");
}

/* ------------------------------------------------------------ edges */
static void same_bytes(int dim) {
  Pack *start = grown(dim, 300, 1, 100, .4, cube, dim == 2 ? .65 : .5, false);
  static const char *const simd[] = {"default", "avx2", "avx512f"};
  for (int rule = 0; rule < 4; rule++) {
    Pack *first = NULL;
    bool same = true;
    for (int v = 0; v < 3; v++) {
      setenv("RANDPACK_SIMD", simd[v], 1);
      Pack *pack = copy(start);
      ShakePlan plan = {(ShakeRule)rule, .1, 5, rule == 2};
      ShakeReport report = {0};
      Outcome out = {0};
      Rng rng = rng_stream(12, 0, RNG_TEST);
      Shake *shake = shake_alloc(pack, &plan, &out);
      shake_sweeps(shake, v == 0 ? 10 : 4, &rng, &report);
      if (v > 0)
        shake_sweeps(shake, 6, &rng, &report);
      shake_store(shake, pack);
      shake_free(&shake);
      if (first)
        same &= !memcmp(first->x, pack->x,
                        pack->n * (size_t)dim * sizeof *pack->x);
      if (first)
        pack_free(&pack);
      else
        first = pack;
    }
    unsetenv("RANDPACK_SIMD");
    gsl_test(!same, "%d-D, %s: the same bytes at every width, in one call or two",
             dim, rule_name[rule]);
    pack_free(&first);
  }
  pack_free(&start);
}

/* So dilute that nobody meets: the mean square is that of a walk. */
static void ideal(int dim, size_t n, double R, bool meets) {
  Pack *pack = empty(dim, n, 1, 0, 0, cube, 1e-6, false);
  Rng rng = rng_stream(13, n, RNG_TEST);
  for (size_t c = 0; c < n * (size_t)dim; c++)
    pack->x[c] = rng_uniform(&rng) * pack->box.side[c % (size_t)dim];
  ShakePlan plan = {SHAKE_METROPOLIS, R, 1, false};
  ShakeReport report = {0};
  Outcome out = {0};
  Shake *shake = shake_alloc(pack, &plan, &out);
  gsl_test(shake_wandered(shake) != 0, "nobody has wandered at first");
  shake_sweeps(shake, 50, &rng, &report);
  double step = R * R * dim / (dim + 2.), m = (double)n - 1;
  double want = 50 * step * m / (double)n;
  double off = shake_wandered(shake) / want - 1, se = sqrt(2 / (dim * m));
  gsl_test(fabs(off) > 4 * se || (!meets && report.moved != report.turns),
           "%zu ideal in %d-D, R=%g: wandered %.4g of a walk (%.2f se)", n, dim,
           R, 1 + off, off / se);
  shake_free(&shake);
  pack_free(&pack);
}

static void alone(int dim, double R) {
  for (int rule = 0; rule < 4; rule++) {
    Pack *pack = empty(dim, 1, 1, 0, 0, cube, dim == 2 ? .78 : .52, false);
    ShakePlan plan = {(ShakeRule)rule, R, 3, false};
    ShakeReport report = {0};
    Outcome out = {0};
    Rng rng = rng_stream(14, 0, RNG_TEST);
    Shake *shake = shake_alloc(pack, &plan, &out);
    shake_sweeps(shake, 40, &rng, &report);
    gsl_test(report.moved != 40 || report.trials != 40 || shake_wandered(shake) > 1e-20 * R * R,
             "one alone in %d-D, R=%g, %s: goes where it likes", dim, R,
             rule_name[rule]);
    shake_free(&shake);
    pack_free(&pack);
  }
}

static void stands_still(const Pack *start) {
  for (int rule = 0; rule < 4; rule++) {
    Pack *pack = copy(start);
    ShakePlan plan = {(ShakeRule)rule, 0, 3, rule % 2 == 0};
    ShakeReport report = {0};
    Outcome out = {0};
    Rng rng = rng_stream(14, 0, RNG_TEST), before = rng;
    Shake *shake = shake_alloc(pack, &plan, &out);
    shake_sweeps(shake, 3, &rng, &report);
    shake_store(shake, pack);
    gsl_test(report.moved || report.trials || report.turns != 3 * pack->n ||
                 report.radius != 0 || memcmp(&rng, &before, sizeof rng) ||
                 memcmp(pack->x, start->x, pack->n * (size_t)pack->box.dim * sizeof *pack->x),
             "R=0, %s: nothing moves", rule_name[rule]);
    shake_free(&shake);
    pack_free(&pack);
  }
}

/* Cubic cells of four: at the densest fraction all twelve neighbours touch. */
static Pack *fcc(int cells, double fraction) {
  size_t n = 4 * (size_t)(cells * cells * cells), i = 0;
  Pack *pack = empty(3, n, 1, 0, 0, cube, fraction, false);
  double a = pack->box.side[0] / cells;
  for (int c = 0; c < 8 * cells * cells * cells; c++) {
    int x = c % (2 * cells), y = c / (2 * cells) % (2 * cells),
        z = c / (4 * cells * cells);
    if ((x + y + z) % 2)
      continue;
    pack->x[3 * i] = a / 2 * x;
    pack->x[3 * i + 1] = a / 2 * y;
    pack->x[3 * i++ + 2] = a / 2 * z;
  }
  return pack;
}

static void crystal(void) {
  Pack *pack = fcc(4, .60);
  ShakePlan plan = {SHAKE_METROPOLIS, .1, 1, false};
  ShakeReport report = {0};
  Outcome out = {0};
  Rng rng = rng_stream(15, 0, RNG_TEST);
  Shake *shake = shake_alloc(pack, &plan, &out);
  shake_sweeps(shake, 1000, &rng, &report);
  double gone = sqrt(shake_wandered(shake));
  gsl_test(gone > .5 || gone < .05, "fcc at .60 stays: rms %.3f radii", gone);
  shake_free(&shake);
  pack_free(&pack);
  pack = fcc(3, M_PI / sqrt(18) * (1 - 1e-13));
  no_overlap("touching fcc", pack, 1e-3, 50, false, false);
  pack_free(&pack);
  pack = fcc(2, M_PI / sqrt(18) * (1 + 1e-10));
  against_all_pairs("fcc that overlaps", pack, .01, 2);
  pack_free(&pack);
  pack = fcc(3, M_PI / sqrt(18) * (1 + 1e-12));
  no_overlap("fcc that overlaps by 1e-13", pack, 1e-3, 50, false, false);
  pack_free(&pack);
}

/* Nobody is shaken, and nothing happens. */
static void nobody(void) {
  Pack *pack = empty(3, 1, 1, 0, 0, cube, .3, false);
  pack->n = pack->species[0].count = 0;
  ShakePlan plan = {SHAKE_METROPOLIS, .1, 1, true};
  ShakeReport report = {0};
  Outcome out = {0};
  Rng rng = rng_stream(1, 0, RNG_TEST);
  Shake *shake = shake_alloc(pack, &plan, &out);
  shake_sweeps(shake, 3, &rng, &report);
  shake_store(shake, pack);
  gsl_test(report.turns || shake_wandered(shake) != 0, "no particles");
  shake_free(&shake);
  shake_free(&shake);
  pack_free(&pack);
}

static void refuses(void) {
  Pack *pack = fcc(3, .75);
  ShakePlan plan = {SHAKE_METROPOLIS, .1, 1, false};
  Outcome out = {0};
  Shake *shake = shake_alloc(pack, &plan, &out);
  gsl_test(shake || out.status != WRONG, "overlap is refused: %s", out.text);
  pack_free(&pack);
  pack = fcc(2, .5);
  const ShakePlan wrong[] = {{SHAKE_METROPOLIS, -.1, 1, false},
                             {SHAKE_METROPOLIS, (double)NAN, 1, false},
                             {SHAKE_COLLISION, (double)INFINITY, 1, false},
                             {SHAKE_RETRY, .1, 0, false},
                             {SHAKE_COLLISION_LONGEST, .1, -3, false}};
  for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
    out = (Outcome){0};
    shake = shake_alloc(pack, wrong + w, &out);
    gsl_test(shake || out.status != WRONG, "refused: %s", out.text);
  }
  pack_free(&pack);
}

/* A window that follows rests where one half fits. */
static void adapts(const Pack *start) {
  for (int rule = 0; rule < 4; rule++)
    for (double R = .002; R < 5; R *= 1000) {
      Pack *pack = copy(start);
      ShakePlan plan = {(ShakeRule)rule, R, 1, true};
      ShakeReport report = {0}, at_rest = {0};
      Outcome out = {0};
      Rng rng = rng_stream(16, 0, RNG_TEST);
      Shake *shake = shake_alloc(pack, &plan, &out);
      shake_sweeps(shake, 60, &rng, &report);
      shake_sweeps(shake, 60, &rng, &at_rest);
      double share = (double)at_rest.moved / (double)at_rest.turns;
      gsl_test(at_rest.radius < .02 || at_rest.radius > .3 ||
                   (rule < 2 && fabs(share - .5) > .02),
               "%s: R from %g to %.3g, %.3f move", rule_name[rule], R,
               at_rest.radius, share);
      shake_free(&shake);
      pack_free(&pack);
    }
}

int main(void) {
  const double rod[3] = {1, 1.5, 9};
  Pack *pack = grown(3, 200, 1, 0, 0, cube, .55, false);
  against_all_pairs("3-D", pack, .02, 2);
  against_all_pairs("3-D", pack, .3, 1);
  against_all_pairs("3-D", pack, 1e-12, 1);
  no_overlap("3-D", pack, .05, 150, false, true);
  no_overlap("3-D", pack, .05, 40, true, true);
  no_overlap("3-D", pack, 1e-12, 20, false, true);
  no_overlap("3-D", pack, 40, 1, false, false);
  acceptance("3-D", pack, .1);
  adapts(pack);
  stands_still(pack);
  pack_free(&pack);
  pack = grown(2, 200, 1, 0, 0, cube, .70, false);
  against_all_pairs("2-D", pack, .05, 3);
  no_overlap("2-D", pack, .1, 150, false, true);
  acceptance("2-D", pack, .2);
  pack_free(&pack);
  pack = grown(3, 12, 1, 200, .1, cube, .30, false);
  against_all_pairs("ratio 10", pack, .1, 1);
  no_overlap("ratio 10", pack, .1, 40, false, true);
  acceptance("ratio 10", pack, .5);
  pack_free(&pack);
  pack = grown(2, 20, 1, 300, .2, cube, .60, false);
  against_all_pairs("ratio 5, discs", pack, .3, 1);
  no_overlap("ratio 5, discs", pack, .3, 40, false, true);
  pack_free(&pack);
  pack = grown(2, 60, 1, 60, .5, cube, .60, true);
  against_all_pairs("own radii", pack, .1, 2);
  no_overlap("own radii", pack, .1, 80, true, true);
  pack_free(&pack);
  pack = grown(3, 40, 1, 0, 0, rod, .40, false);
  against_all_pairs("a rod", pack, .2, 2);
  against_all_pairs("a rod", pack, 6, 1);
  no_overlap("a rod", pack, .2, 30, false, true);
  pack_free(&pack);
  pack = grown(3, 8, 1, 0, 0, cube, .45, false);
  against_all_pairs("8 spheres", pack, .2, 3);
  against_all_pairs("8 spheres", pack, 30, 1);
  pack_free(&pack);
  pack = grown(2, 2, 1, 0, 0, cube, .50, false);
  against_all_pairs("2 discs", pack, .5, 30);
  against_all_pairs("2 discs", pack, 50, 1);
  pack_free(&pack);
  balance(2, 3, .5, SHAKE_METROPOLIS, 1, true);
  balance(2, 3, .5, SHAKE_RETRY, 100, false);
  balance(2, 3, .5, SHAKE_COLLISION, 1, false);
  balance(3, 4, .5, SHAKE_METROPOLIS, 1, true);
  balance(3, 4, .5, SHAKE_RETRY, 100, false);
  two_discs(.5, 3, .1);
  on_a_line(1);
  on_a_line(2);
  on_a_line(50);
  same_bytes(3);
  same_bytes(2);
  ideal(3, 500, .1, false);
  ideal(3, 500, 1000, true);
  ideal(2, 300, 1e5, true);
  ideal(2, 300, 1e14, true);
  ideal(2, 5, 1, false);
  alone(2, .5);
  alone(3, 1e-12);
  alone(3, 77);
  crystal();
  refuses();
  nobody();
  return gsl_test_summary();
}
