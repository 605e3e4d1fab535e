/* The plain kernel that the engine's speed is compared with: is it right? */
#include "crm.h"
#include "engine.h"
#include "ref_crm.h"
#include "theory.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static Pack *random_points(size_t n, double fraction) {
  const double cube[3] = {1, 1, 1};
  Box box = box_make(3, cube, (double)n * pack_ball(3, 1) / fraction);
  Species one = {.name = "A", .radius = 1, .count = n};
  Pack *pack = pack_alloc(&box, &one, 1, false);
  Rng rng = rng_stream(7, n, RNG_TEST);
  for (size_t c = 0; c < 3 * n; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[0];
  return pack;
}

static Pack *grown(size_t n, double fraction) {
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = 0.3, .points = true};
  Pack *pack = random_points(n, fraction);
  Rng rng = rng_stream(8, n, RNG_TEST);
  Outcome out = {0};
  plan.fraction = fraction;
  gsl_test(crm_grow(pack, &plan, &rng, NULL, &out), "grown: %s", out.text);
  return pack;
}

/* The kernel with the places of the pack and the velocities of the engine. */
static RefCrm *same_start(const Engine *engine, const Pack *pack) {
  RefCrm *ref = ref_crm_alloc(pack->n, pack->box.side[0], 1);
  for (size_t i = 0; i < pack->n; i++)
    for (size_t k = 0; k < 3; k++) {
      size_t c = 3 * engine->order[i] + k;
      ref->x[c] = engine->motion->hot[8 * i + k];
      ref->v[c] = engine->motion->hot[8 * i + 3 + k];
    }
  return ref;
}

static double least_distance(RefCrm *ref) {
  double least = INFINITY;
  ref_crm_sync(ref);
  for (size_t i = 0; i < ref->n; i++)
    for (size_t j = 0; j < i; j++) {
      double r = 0;
      for (size_t k = 0; k < 3; k++) {
        double d = ref->x[3 * i + k] - ref->x[3 * j + k];
        r += gsl_pow_2(d - ref->side * round(d / ref->side));
      }
      least = fmin(least, sqrt(r));
    }
  return least;
}

/* Growing from points, or at rest in a dense pack: the same collisions at the
   same times, as long as chaos allows. */
static void as_the_engine(size_t n, double fraction, double growth) {
  Pack *pack = growth > 0 ? random_points(n, fraction) : grown(n, fraction);
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  Rng rng = rng_stream(9, n, RNG_TEST);
  motion_stir(engine->motion, engine->order, &rng);
  engine->motion->size = growth > 0 ? 0 : 1;
  engine->motion->growth = growth;
  RefCrm *ref = same_start(engine, pack);
  engine_sync(engine, 0, 1);
  ref_crm_start(ref, growth > 0 ? 0 : 1, growth);
  int other = 0;
  double worst = 0;
  for (int event = 0; event < 300; event++) {
    uint64_t before = engine->collisions;
    while (engine->collisions == before)
      engine_run(engine, (double)INFINITY, 1);
    ref_crm_run(ref, INFINITY, 1);
    worst = fmax(worst, fabs(engine->now - ref->now));
    other +=
        !(engine->pair[0] == ref->pair[0] && engine->pair[1] == ref->pair[1]) &&
        !(engine->pair[0] == ref->pair[1] && engine->pair[1] == ref->pair[0]);
  }
  gsl_test(other || !(worst < 1e-9),
           "%zu to %g growing at %g: %d other pairs, times differ by %.2g", n,
           fraction, growth, other, worst);
  gsl_test(!(fabs(engine->motion->virial / ref->virial - 1) < 1e-9),
           "the same virial %g, %g", engine->motion->virial, ref->virial);
  ref_crm_free(ref);
  engine_free(&engine);
  pack_free(&pack);
}

/* Z of the fluid, and no overlap, after 1e5 collisions. */
static void as_theory(size_t n, double fraction) {
  Pack *pack = grown(n, fraction);
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  Rng rng = rng_stream(10, n, RNG_TEST);
  motion_stir(engine->motion, engine->order, &rng);
  double before = motion_energy(engine->motion), after = 0;
  RefCrm *ref = same_start(engine, pack);
  ref_crm_start(ref, 1, 0);
  ref_crm_run(ref, INFINITY, 10 * n);
  ref->virial = 0;
  double start = ref->now;
  ref_crm_run(ref, INFINITY, 100000);
  double Z = 1 + ref->virial / (2 * before * (double)n / ((double)n - 1) *
                                (ref->now - start));
  double truth = theory_pressure(THEORY_CARNAHAN_STARLING, fraction);
  gsl_test(!(fabs(Z / truth - 1) < 0.01), "Z %.4f at %g, theory %.4f", Z,
           fraction, truth);
  double least = least_distance(ref);
  gsl_test(!(least > 2 - 1e-11), "nearest at %.3g of contact", least - 2);
  for (size_t c = 0; c < 3 * n; c++)
    after += ref->v[c] * ref->v[c] / 2;
  gsl_test(!(fabs(after / before - 1) < 1e-11), "energy kept to %.2g",
           after / before - 1);
  ref_crm_free(ref);
  engine_free(&engine);
  pack_free(&pack);
}

/* Growth: landed without an overlap, and the energy gained is the work. */
static void growth(size_t n, double fraction) {
  Pack *pack = random_points(n, fraction);
  RefCrm *ref = ref_crm_alloc(n, pack->box.side[0], 1);
  Rng rng = rng_stream(11, n, RNG_TEST);
  for (size_t c = 0; c < 3 * n; c++) {
    ref->x[c] = pack->x[c];
    ref->v[c] = 2 * rng_uniform(&rng) - 1;
  }
  ref_crm_start(ref, 0, 0.1);
  ref_crm_run(ref, 10, UINT64_MAX - 1);
  double least = least_distance(ref);
  gsl_test(ref->now != 10 || !(least > 2 - 1e-11),
           "grown to %g: nearest at %.3g of contact", fraction, least - 2);
  ref_crm_free(ref);
  pack_free(&pack);
}

int main(void) {
  as_the_engine(400, 0.5, 0.1);
  as_the_engine(400, 0.45, 0);
  as_theory(1000, 0.30);
  growth(500, 0.40);
  return gsl_test_summary();
}
