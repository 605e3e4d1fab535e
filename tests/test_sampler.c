/* tests/test_sampler.c: every rule behind one interface. */
#include "cells.h"
#include "many.h"
#include "sampler.h"
#include "theory.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <string.h>

enum { N = 216 };

static Pack *fluid(double fraction, uint64_t seed) {
  double cube[3] = {1, 1, 1};
  Species species = {"A", 0.7, N};
  Box box = box_make(3, cube, N * pack_ball(3, 0.7) / fraction);
  Pack *pack = pack_alloc(&box, &species, 1, false);
  Rng rng = rng_stream(seed, 0, RNG_POSITIONS);
  Outcome out = {0};
  for (size_t i = 0; i < 3 * pack->n; i++)
    pack->x[i] = box.side[0] * rng_uniform(&rng);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL,
                  .rate = 0.1,
                  .fraction = fraction,
                  .points = true};
  gsl_test(crm_grow(pack, &plan, &rng, NULL, &out), "a pack at %g", fraction);
  return pack;
}

static SamplerPlan plan_of(int rule) {
  return (SamplerPlan){.rule = (SamplerRule)rule, .radius = 0.1, .tries = 5};
}

/* Each moves the particles and keeps the pack; its counts add up; two runs
   are one run, or (dynamics, which begins anew) the stream goes on. */
static void test_rule(int rule) {
  Pack *pack = fluid(0.4, 7), *again = fluid(0.4, 7);
  size_t bytes = 3 * pack->n * sizeof *pack->x;
  SamplerPlan plan = plan_of(rule);
  Rng rng = rng_stream(3, 1, RNG_SHAKING), same = rng;
  Outcome out = {0};
  SamplerReport report = {0}, other = {0};
  Sampler *one = sampler_alloc(pack, &plan, &rng, &out);
  Sampler *two = sampler_alloc(again, &plan, &same, &out);
  gsl_test(sampler_run(one, 0, &report, &out), "no sweep");
  gsl_test(memcmp(pack->x, again->x, bytes) != 0, "moves nothing");
  sampler_run(one, 3, &report, &out);
  gsl_test(memcmp(pack->x, again->x, bytes) == 0, "three sweeps move");
  sampler_run(one, 4, &report, &out);
  sampler_run(two, 3, &other, &out);
  sampler_run(two, 4, &other, &out);
  gsl_test(memcmp(pack->x, again->x, bytes) != 0 ||
               memcmp(&rng, &same, sizeof rng) != 0,
           "rule %d: twice the same", rule);
  gsl_test(out.status, "rule %d goes well: %s", rule, out.text);
  gsl_test(cells_least_gap(pack) < -1e-12, "no overlap");
  gsl_test(!(report.trials >= 7.0 * N), "trials are counted: %g",
           report.trials);
  if (rule < SAMPLER_CHAIN) {
    gsl_test_abs(report.turns, 7 * N, 0, "turns");
    gsl_test(!(report.moved > 0 && report.moved <= report.turns), "moved");
    gsl_test_abs(report.weight, 0, 0, "no pressure");
  } else {
    gsl_test(!(report.weight > 0 && report.Z > 2), "a pressure");
  }
  if (rule < SAMPLER_DYNAMICS)
    gsl_test(!(sampler_wandered(one) > 0), "they wander");
  else
    gsl_test(!gsl_isnan(sampler_wandered(one)), "that is not followed");
  sampler_free(&one);
  sampler_free(&two);
  gsl_test(one != NULL, "free leaves NULL");
  sampler_free(&one);
  pack_free(&pack);
  pack_free(&again);
}

/* The weighted mean of many short runs is the fluid's Z: four standard errors
   from the scatter of runs, and the 1/N of so few. */
static void test_pressure(int rule) {
  Pack *pack = fluid(0.3, 11);
  SamplerPlan plan = plan_of(rule);
  Rng rng = rng_stream(5, 1, RNG_SHAKING);
  Outcome out = {0};
  SamplerReport report = {0}, warm = {0};
  Sampler *sampler = sampler_alloc(pack, &plan, &rng, &out);
  sampler_run(sampler, 100, &warm, &out);
  double sum = 0, square = 0, runs = as_many(20, 40);
  for (int i = 0; i < runs; i++) {
    SamplerReport one = {0};
    sampler_run(sampler, 10, &one, &out);
    sampler_run(sampler, 5, &report, &out);
    sum += one.Z, square += one.Z * one.Z;
  }
  double mean = sum / runs, error = sqrt((square / runs - mean * mean) / runs);
  double Z = theory_pressure(THEORY_SCHULTZ, 0.3);
  gsl_test(fabs(mean - Z) > 4 * error + 0.01 * Z, "rule %d: Z = %.3f(%.3f), %.3f",
           rule, mean, error, Z);
  gsl_test(fabs(report.Z - Z) > 6 * error + 0.01 * Z, "carried along: %.3f",
           report.Z);
  sampler_free(&sampler);
  pack_free(&pack);
}

/* What two runs add up to is the mean of both, weighted by how long they were. */
static void test_weights(int rule) {
  SamplerPlan plan = plan_of(rule);
  SamplerReport part[2] = {0}, whole = {0};
  for (int again = 0; again < 2; again++) {
    Pack *pack = fluid(0.3, 11);
    Rng rng = rng_stream(5, 1, RNG_SHAKING);
    Outcome out = {0};
    Sampler *sampler = sampler_alloc(pack, &plan, &rng, &out);
    for (int run = 0; run < 2; run++)
      sampler_run(sampler, run ? 30 : 3, again ? &whole : &part[run], &out);
    sampler_free(&sampler);
    pack_free(&pack);
  }
  double sum = part[0].weight + part[1].weight;
  double mean = (part[0].weight * part[0].Z + part[1].weight * part[1].Z) / sum;
  gsl_test_rel(whole.Z, mean, 1e-13, "rule %d: a weighted mean", rule);
  gsl_test_rel(whole.weight, sum, 1e-13, "of this weight");
  gsl_test_rel(part[1].weight, 10 * part[0].weight, 0.5,
               "a run ten times as long weighs ten times as much");
}

static void test_wrong(void) {
  Pack *pack = fluid(0.3, 11);
  memcpy(pack->x, pack->x + 3, 3 * sizeof *pack->x);
  for (int rule = 0; rule < SAMPLER_DYNAMICS; rule++) {
    Outcome out = {0};
    SamplerPlan plan = plan_of(rule);
    Rng rng = rng_stream(5, 1, RNG_SHAKING);
    Sampler *sampler = sampler_alloc(pack, &plan, &rng, &out);
    gsl_test(sampler != NULL || out.status != WRONG, "rule %d: an overlap",
             rule);
  }
  pack_free(&pack);
}

int main(void) {
  for (int rule = SAMPLER_METROPOLIS; rule <= SAMPLER_DYNAMICS; rule++)
    test_rule(rule);
  for (int rule = SAMPLER_CHAIN; rule <= SAMPLER_DYNAMICS; rule++)
    test_pressure(rule);
  for (int rule = SAMPLER_CHAIN; rule <= SAMPLER_DYNAMICS; rule++)
    test_weights(rule);
  test_wrong();
  return gsl_test_summary();
}
