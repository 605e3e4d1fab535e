/* Relaxed packs: free by a second method, the asked fraction to the last bit, failures that say what was reached. */
#include "many.h"
#include "overlap.h"
#include "relax.h"
#include "scatter.h"
#include "touch.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <string.h>

static Shape *shape_of(int k) {
  static const double curve[4][2] = {{1.5, 1.5}, {1, 50}, {5, 1}, {50, 1}};
  return k == 0 ? NULL : k < 10 ? shape_regular(k) : shape_superellipse(curve[k - 10][0], curve[k - 10][1]);
}

enum { DISC = 0, SUPER = 10, BLUNT, NEEDLE, LONG };

static Pack *random_pack(int kinds, const int kind[], const size_t count[], double fraction, uint64_t seed) {
  Species species[4] = {{{0}, 0, 0, NULL}};
  double ratio[3] = {1, 1.3, 0}, solid = 0;
  for (int s = 0; s < kinds; s++) {
    species[s] = (Species){"A", 2.385 / (1 + s), count[s], shape_of(kind[s])};
    solid += (double)count[s] * M_PI * gsl_pow_2(species[s].radius);
  }
  Box box = box_make(2, ratio, solid > 0 ? solid / fraction : 1);
  return scattered(&box, species, kinds, seed);
}

/* The least gap over all images, by brute force. */
static double least_gap(const Pack *pack) {
  double least = GSL_POSINF;
  int far = (int)(2 * pack_widest(pack) / (2 * box_reach(&pack->box))) + 1;
  for (size_t i = 0; i < pack->n; i++)
    for (size_t j = i; j < pack->n; j++)
      for (int p = -far; p <= far; p++)
        for (int q = -far; q <= far; q++) {
          Body A = pack_body(pack, i), B = pack_body(pack, j);
          double gap;
          B.x += p * pack->box.side[0], B.y += q * pack->box.side[1];
          double outer = (A.shape ? A.shape->outer : 1) * A.radius + (B.shape ? B.shape->outer : 1) * B.radius;
          if ((i == j && p == 0 && q == 0) || hypot(B.x - A.x, B.y - A.y) > outer)
            continue;
          overlap_verdict(&A, &B, &gap);
          least = GSL_MIN(least, gap);
        }
  return least;
}

static RelaxPlan plan_of(DynamicsForce road, int steps) {
  return (RelaxPlan){.road = road, .alone = true, .growth = 1e-3, .steps = steps, .model = {.shear = 1}};
}

static const struct {
  const char *what;
  int kinds, kind[3];
  size_t count[3];
  double fraction;
} packs[] = {
    {"pentagons", 1, {5}, {24}, 0.8},
    {"triangles", 1, {3}, {20}, 0.75},
    {"superellipses", 1, {SUPER}, {20}, 0.8},
    {"blunt squares", 1, {BLUNT}, {16}, 0.8},
    {"discs", 1, {DISC}, {20}, 0.75},
    {"a mixture", 3, {4, DISC, NEEDLE}, {6, 20, 30}, 0.7},
    {"one square", 1, {4}, {1}, 0.7},
    {"two needles longer than the box", 1, {NEEDLE}, {2}, 0.5},
    {"long needles", 1, {LONG}, {8}, 0.12},
    {"few squares", 1, {4}, {5}, 0.001},
};

static void test_packs(void) {
  for (size_t k = 0; k < sizeof packs / sizeof *packs; k++)
    for (int road = 0; road < 2; road++) {
      Pack *pack = random_pack(packs[k].kinds, packs[k].kind, packs[k].count, packs[k].fraction, 4 + k);
      RelaxPlan plan = plan_of((DynamicsForce)road, 4000);
      RelaxReport report;
      Outcome out = {0};
      Rng rng = rng_stream(1, k, RNG_RELAX);
      double fraction = pack_fraction(pack);
      if (packs[k].kind[0] == LONG && road == DYNAMICS_AREA) { /* crossed needles feel no force of the area */
        plan.alone = false;
        plan.steps = 200;
      }
      int status = relax_pack(pack, &plan, &rng, &report, &out);
      gsl_test(status != DONE, "%s by road %d: %s", packs[k].what, road, out.text);
      gsl_test(!(least_gap(pack) >= 0), "%s by road %d: least gap %g", packs[k].what, road, least_gap(pack));
      gsl_test(pack_fraction(pack) != fraction || report.reached != fraction || report.residual != 0, "%s by road %d: the fraction that was asked", packs[k].what, road);
      gsl_test_rel(fraction, packs[k].fraction, 1e-14, "%s: fraction", packs[k].what);
      pack_free(&pack);
    }
}

/* Friction, damping, a constant drag and S's normal; the second road goes on where the first one ends. */
static void test_plans(void) {
  const int pentagon[] = {5};
  const size_t count[] = {20};
  for (int k = 0; k < 5; k++) {
    Pack *pack = random_pack(1, pentagon, count, 0.7, 3);
    RelaxPlan plan = plan_of(DYNAMICS_SPRINGS, 3000);
    RelaxReport report;
    Outcome out = {0};
    Rng rng = rng_stream(2, 0, RNG_RELAX);
    plan.model.centres = k == 0;
    plan.model.friction = k % 3 == 1 ? 0.5 : 0;
    plan.model.damping = k == 1 ? 0.3 : k == 4 ? 1 : 0;
    plan.drag = k == 2 ? 0.4 : 0;
    plan.literal = k >= 3; /* it ends with friction, and not without */
    plan.alone = k != 3;
    if (k == 3)
      plan.steps = 400;
    gsl_test(relax_pack(pack, &plan, &rng, &report, &out) != DONE, "plan %d: %s", k, out.text);
    gsl_test_int(report.other, k == 3, "plan %d: the other road", k);
    gsl_test(touch_least_gap(pack) < 0, "plan %d is free", k);
    gsl_test((k == 3) != (report.steps > 400), "plan %d: %d steps", k, (int)report.steps);
    pack_free(&pack);
  }
}

/* All at one place and one angle. */
static void test_coincident(void) {
  const int kind[] = {5, DISC};
  const size_t count[] = {4, 4};
  Pack *pack = random_pack(2, kind, count, 0.3, 3);
  RelaxPlan plan = plan_of(DYNAMICS_SPRINGS, 4000);
  RelaxReport report;
  Outcome out = {0};
  Rng rng = rng_stream(2, 0, RNG_RELAX);
  memset(pack->x, 0, 2 * pack->n * sizeof *pack->x);
  memset(pack->angle, 0, pack->n * sizeof *pack->angle);
  gsl_test(relax_pack(pack, &plan, &rng, &report, &out) != DONE, "all at one place: %s", out.text);
  gsl_test(!(least_gap(pack) >= 0), "all at one place: least gap %g", least_gap(pack));
  pack_free(&pack);
}

/* Too dense: the fraction reached is free, and a little more is not. */
static void test_unreached(void) {
  const int kind[] = {5};
  const size_t count[] = {13};
  Pack *pack = random_pack(1, kind, count, 0.95, 3);
  RelaxPlan plan = plan_of(DYNAMICS_SPRINGS, 300);
  RelaxReport report;
  Outcome out = {0};
  Rng rng = rng_stream(2, 0, RNG_RELAX);
  plan.alone = false;
  gsl_test_int(relax_pack(pack, &plan, &rng, &report, &out), UNREACHED, "pentagons at .95");
  gsl_test_int(report.sweeps, 4, "pentagons at .95: two sweeps each");
  gsl_test_int((int)report.steps, 600, "pentagons at .95: both roads to the end");
  gsl_test(!(report.residual > 1e-4 && report.residual < 0.1), "residual %g", report.residual);
  gsl_test(!(report.reached > 0.5 && report.reached < 0.92), "reached %g", report.reached);
  char text[32];
  snprintf(text, sizeof text, "%.6g", report.reached);
  gsl_test(!strstr(out.text, text), "%s says %s", out.text, text);
  double factor = sqrt(report.reached / pack_fraction(pack)), radius = pack->species[0].radius;
  pack->species[0].radius = radius * factor * (1 - 1e-11);
  gsl_test(!(least_gap(pack) >= 0), "free at the fraction reached, %g", least_gap(pack));
  pack->species[0].radius = radius * factor * (1 + 1e-9);
  gsl_test(!(least_gap(pack) < 0), "and not at a higher one, %g", least_gap(pack));
  pack_free(&pack);
}

/* The largest fraction: of one square in a square box, 1; of others it touches. */
static void test_most(void) {
  const int kind[] = {4, DISC};
  for (int k = 0; k < 2; k++) {
    const size_t count[] = {k == 0 ? 1 : 5, 3};
    Pack *pack = random_pack(k + 1, kind, count, 1, 3);
    RelaxPlan plan = plan_of(DYNAMICS_AREA, k == 0 ? 300 : 600);
    RelaxReport report;
    Outcome out = {0};
    Rng rng = rng_stream(2, 0, RNG_RELAX);
    double radius = pack->species[0].radius;
    gsl_test(relax_most(pack, 0.4, &plan, &rng, &report, &out) != DONE, "largest fraction %d: %s", k, out.text);
    double gap = least_gap(pack);
    gsl_test(!(gap >= 0 && gap < 1e-9), "largest fraction %d: a pair touches, gap %g", k, gap);
    gsl_test(pack->species[0].radius != radius || pack->box.side[1] / pack->box.side[0] - 1.3 > 1e-13, "largest fraction %d: radii and ratio of the scene", k);
    gsl_test_rel(report.reached, pack_fraction(pack), 1e-15, "largest fraction %d: as reported", k);
    gsl_test(report.reached < 0.6, "largest fraction %d: %g", k, report.reached);
    pack_free(&pack);
  }
  Pack *pack = random_pack(1, kind, (size_t[]){5}, 1, 3);
  RelaxPlan plan = plan_of(DYNAMICS_SPRINGS, 10);
  RelaxReport report;
  Outcome out = {0};
  Rng rng = rng_stream(2, 0, RNG_RELAX);
  gsl_test_int(relax_most(pack, 0.9, &plan, &rng, &report, &out), UNREACHED, "a first fraction that is too large");
  pack_free(&pack);
}

static void test_none(void) {
  const int kind[] = {5};
  Pack *pack = random_pack(1, kind, (size_t[]){0}, 0.5, 3);
  RelaxPlan plan = plan_of(DYNAMICS_SPRINGS, 10);
  RelaxReport report;
  Outcome out = {0};
  Rng rng = rng_stream(2, 0, RNG_RELAX);
  gsl_test_int(relax_pack(pack, &plan, &rng, &report, &out), DONE, "no particle is free");
  pack_free(&pack);
}

int main(void) {
  test_packs();
  test_plans();
  test_coincident();
  test_unreached();
  test_most();
  test_none();
  return gsl_test_summary();
}
