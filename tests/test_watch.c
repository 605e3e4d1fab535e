/* tests/test_watch.c: a computation that is stopped at a sync point and taken up from its state, with all else made
   anew, comes out as one that was not. All that comes out is compared, counters too that no table has. */
#include "watch.h"
#include "crm.h"
#include "engine.h"
#include "keeper.h"
#include "many.h"
#include "sampler.h"
#include "same.h"
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What is run, and all that comes out. */
typedef struct {
  const char *name;
  int dim;
  size_t n;
  double fraction, rate, every;
  CrmProtocol protocol;
  bool jam, fly;
  int rule; /* of a sampler; -1: none */
  int sweeps;
} Case;
typedef struct {
  int status;
  Pack *pack;
  CrmReport crm;
  SamplerReport sampler;
  Rng rng;
  double shaken; /* places seen by a visitor */
  double wandered;
} Result;

static const Case cases[] = {
    {"growth in a wide box", 3, 400, 0.55, 0.3, 0, CRM_ISOTHERMAL, false, false, -1, 0},
    {"literal growth in the plane", 2, 200, 0.75, 0.2, 0, CRM_LITERAL, false, false, -1, 0},
    {"growth in a narrow box", 3, 12, 0.6, 0.2, 0, CRM_ISOTHERMAL, false, false, -1, 0},
    {"growth with visits", 3, 216, 0.5, 0.3, 9, CRM_ISOTHERMAL, false, false, -1, 0},
    {"growth to jamming", 2, 30, 0.5, 20, 0, CRM_ISOTHERMAL, true, false, -1, 0},
    {"flight", 3, 250, 0.45, 0.3, 0, CRM_ISOTHERMAL, false, true, -1, 0},
    {"metropolis", 3, 216, 0.45, 0.3, 0, CRM_ISOTHERMAL, false, false, SAMPLER_METROPOLIS, 600},
    {"windows that follow", 3, 216, 0.45, 0.3, 0, CRM_ISOTHERMAL, false, false, SAMPLER_COLLISION, 500},
    {"chains", 3, 216, 0.45, 0.3, 0, CRM_ISOTHERMAL, false, false, SAMPLER_CHAIN, 600},
    {"newton's chains in a narrow box", 2, 9, 0.45, 0.3, 0, CRM_ISOTHERMAL, false, false, SAMPLER_NEWTON, 9000},
    {"dynamics", 2, 216, 0.6, 0.3, 0, CRM_ISOTHERMAL, false, false, SAMPLER_DYNAMICS, 40},
};

static Pack *start(const Case *c) {
  double cube[3] = {1, 1, 1};
  Species species[2] = {{"A", 0.7, c->n - c->n / 3}, {"B", 0.45, c->n / 3}};
  double solid = (double)species[0].count * pack_ball(c->dim, 0.7) + (double)species[1].count * pack_ball(c->dim, 0.45);
  Box box = box_make(c->dim, cube, solid / (c->jam ? 0.05 : c->fraction));
  Pack *pack = pack_alloc(&box, species, 2, false);
  Rng rng = rng_stream(17, 0, RNG_POSITIONS);
  for (size_t i = 0; i < pack->n * (size_t)c->dim; i++)
    pack->x[i] = box.side[i % (size_t)c->dim] * rng_uniform(&rng);
  return pack;
}

/* A visitor that shakes, with a stream of its own. */
typedef struct {
  Rng rng;
  double sum;
  Watch *watch;
} Visitor;

static void visit(void *visitor, Pack *pack) {
  Visitor *v = visitor;
  Outcome out = {0};
  SamplerReport report = {0};
  SamplerPlan plan = {.rule = SAMPLER_METROPOLIS, .radius = 0.1, .tries = 1, .watch = v->watch};
  Sampler *sampler = sampler_alloc(pack, &plan, &v->rng, &out);
  sampler_run(sampler, 3, &report, &out);
  sampler_free(&sampler);
  v->sum += pack->x[5];
}

static void pass_visitor(void *visitor, State *state) {
  Visitor *v = visitor;
  STATE_PASS(state, v->rng);
  STATE_PASS(state, v->sum);
}

/* Watch the growth, or what follows it. Growth to jamming takes long after it has slowed down, and its budget ends it there. */
static void run(const Case *c, Watch *watch, Result *r) {
  bool later = c->fly || c->rule >= 0;
  Outcome out = {0};
  Visitor visitor = {rng_stream(17, 2, RNG_SHAKING), 0, watch};
  CrmPlan plan = {.protocol = c->protocol, .rate = c->rate, .fraction = c->fraction, .points = true,
                  .watch = later ? NULL : watch, .budget = c->jam ? 900 : 0};
  *r = (Result){.pack = start(c), .rng = rng_stream(17, 1, RNG_VELOCITIES)};
  if (c->every > 0) {
    plan.every = c->every;
    plan.visit = visit;
    plan.pass = pass_visitor;
    plan.visitor = &visitor;
  }
  if (c->jam) {
    crm_jam(r->pack, &plan, &r->rng, &r->crm, &out);
  } else
    crm_grow(r->pack, &plan, &r->rng, &r->crm, &out);
  CrmFlight flight = {MOTION_VOLUME, 20, 15, 4, watch};
  if (c->fly && out.status == DONE)
    crm_fly(r->pack, &flight, &r->rng, &r->crm, &out);
  SamplerPlan how = {(SamplerRule)c->rule, 0.1, 5, c->rule == SAMPLER_COLLISION, 0, MOTION_EQUAL, watch};
  if (c->rule >= 0 && out.status == DONE) {
    Sampler *sampler = sampler_alloc(r->pack, &how, &r->rng, &out);
    sampler_run(sampler, (uint64_t)c->sweeps, &r->sampler, &out);
    r->wandered = c->rule < SAMPLER_DYNAMICS ? sampler_wandered(sampler) : 0;
    sampler_free(&sampler);
  }
  r->shaken = visitor.sum;
  r->status = out.status;
}

static bool same(const Result *a, const Result *b) {
  size_t n = a->pack->n * (size_t)a->pack->box.dim;
  return a->status == b->status && same_numbers(a->pack->x, b->pack->x, n) && same_box(&a->pack->box, &b->pack->box) &&
         a->pack->species[0].radius == b->pack->species[0].radius && memcmp(&a->crm, &b->crm, sizeof a->crm) == 0 &&
         memcmp(&a->sampler, &b->sampler, sizeof a->sampler) == 0 && a->rng.counter == b->rng.counter &&
         a->shaken == b->shaken && a->wandered == b->wandered;
}

/* Stop after so many ticks, take it up and stop again, to the end. */
static void test_stops(const Case *c, const Result *undisturbed, const char *path, int stop) {
  int stops = 0, status = STOPPED;
  Result r = {0};
  while (status == STOPPED && stops < 99) {
    Keeper *keeper = keeper_of(path, stop);
    pack_free(&r.pack);
    run(c, &keeper->watch, &r);
    status = r.status;
    gsl_test(keeper->loaded != (stops > 0), "%s: taken up", c->name);
    gsl_test(keeper->watch.depth != 0 || keeper->ended != (status == DONE), "%s: its end is told", c->name);
    stops += status == STOPPED;
    free(keeper);
  }
  gsl_test(!same(&r, undisturbed), "%s, stopped %d times, every %d ticks: the same", c->name, stops, stop);
  gsl_test(stops == 0, "%s: it was stopped", c->name);
  pack_free(&r.pack);
  keeper_forget(path);
}

static void test_case(const Case *c, const char *path) {
  Result undisturbed, watched;
  run(c, NULL, &undisturbed);
  gsl_test_int(undisturbed.status, c->jam ? UNREACHED : DONE, "%s", c->name);
  Keeper *keeper = keeper_of(path, 0);
  run(c, &keeper->watch, &watched);
  gsl_test(!same(&watched, &undisturbed), "%s: watched and not", c->name);
  gsl_test(keeper->outside, "%s: only the outermost part is heard", c->name);
  gsl_test(keeper->begun != 1 || keeper->ended != !c->jam, "%s: a part begins and ends", c->name);
  gsl_test(keeper->ticks < 4, "%s: there are %d ticks", c->name, keeper->ticks);
  gsl_test(!(c->jam || (keeper->news.share > 0.8 && keeper->news.share <= 1)), "%s: the work was foreseen, %g at the end", c->name,
           keeper->news.share);
  int few = keeper->ticks / as_many(3, 40);
  test_stops(c, &undisturbed, path, few < 1 ? 1 : few);
  test_stops(c, &undisturbed, path, 1 + keeper->ticks / 2);
  pack_free(&undisturbed.pack);
  pack_free(&watched.pack);
  free(keeper);
}

/* A state is of one computation: another rate of growth begins anew. */
static void test_other(const char *path) {
  Case c = cases[0];
  Keeper *keeper = keeper_of(path, 3);
  Result r;
  run(&c, &keeper->watch, &r);
  gsl_test_int(r.status, STOPPED, "a growth is stopped");
  pack_free(&r.pack);
  c.rate *= 1.001;
  keeper->stop = 0;
  run(&c, &keeper->watch, &r);
  gsl_test_int(keeper->loaded, 0, "another does not take its state");
  gsl_test_int(r.status, DONE, "and is done");
  pack_free(&r.pack);
  free(keeper);
  keeper_forget(path);
}

static void pass_nothing(void *what, State *state) {
  (void)what, (void)state;
}

/* Nobody watches, and parts within parts. */
static void test_depth(const char *path) {
  Keeper *keeper = keeper_of(path, 0);
  WatchNews news = {.what = "nothing"};
  gsl_test(watch_begin(NULL, NULL, NULL) || !watch_tick(NULL, &news) || watch_due(NULL, 1 << 30), "nobody watches");
  watch_end(NULL, true);
  keeper->watch.depth = 1;
  gsl_test(watch_begin(&keeper->watch, pass_nothing, NULL) || keeper->begun, "a part in a part is not heard");
  gsl_test(watch_due(&keeper->watch, 1 << 30), "is never due");
  gsl_test(!watch_tick(&keeper->watch, &news) || keeper->ticks, "and cannot be stopped");
  watch_end(&keeper->watch, true);
  gsl_test_int(keeper->ended, 0, "nor ends");
  keeper->watch.every = 100;
  gsl_test(watch_due(&keeper->watch, 99) || !watch_due(&keeper->watch, 1), "due after enough work");
  free(keeper);
}

int main(void) {
  char dir[40], path[80];
  keeper_place(dir, path);
  test_depth(path);
  test_other(path);
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
    test_case(&cases[c], path);
  gsl_test(rmdir(dir), "nothing is left in it");
  return gsl_test_summary();
}
