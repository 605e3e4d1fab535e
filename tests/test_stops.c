/* tests/test_stops.c: gravity, coarse particles added and marked, dilution, relaxation, turning and compression, stopped at sync points
   and taken up from their state with all else made anew, come out as those that nobody stopped. All that comes out is compared. */
#include "coarse.h"
#include "compression.h"
#include "dilute.h"
#include "keeper.h"
#include "many.h"
#include "points.h"
#include "relax.h"
#include "same.h"
#include "shape.h"
#include "turning.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* All that comes out of a case, and of several parts in a row. */
enum { NUMBERS = 40 };
typedef struct {
  int status, numbers;
  Pack *pack;
  double number[NUMBERS];
} Result;

static void note(Result *r, double x) {
  r->number[r->numbers++] = x;
}

static void note_sweep(Result *r, FieldSweep sweep) {
  note(r, (double)sweep.turns);
  note(r, (double)sweep.pushes);
  note(r, sweep.deepest);
}

static void note_rng(Result *r, Rng *rng) {
  note(r, rng_uniform(rng));
}

static void note_gravity(Result *r, const GravityReport *g) {
  note(r, g->sweeps);
  note(r, g->passes);
  note_sweep(r, g->all);
  note(r, g->carry);
  note(r, g->overlap);
  note(r, g->start);
  note(r, g->rim);
}

/* ---- gravity */
static Pack *grown(int dim, size_t n, GravityMode mode, bool sizes, Watch *watch, Result *r, Outcome *out) {
  Species species[2] = {{"A", 1, n - n / 4}, {"B", sizes ? 0.6 : 1, n / 4}};
  GravityPlan plan = {.mode = mode, .watch = watch, .sweeps = mode == GRAVITY_LITERAL ? 12 : 0};
  GravityReport report;
  Rng rng = rng_stream(5, 0, RNG_GRAVITY);
  Pack *pack = gravity_pack(dim, species, 2, NULL, &plan, &rng, &report, out);
  note_gravity(r, &report);
  note_rng(r, &rng);
  return pack;
}

static void run_gravity(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  r->pack = grown(kind == 1 ? 2 : 3, 300, kind == 2 ? GRAVITY_LITERAL : GRAVITY_ADAPTIVE, kind == 3, watch, r, &out);
  if (kind == 4 && out.status == DONE) {
    pack_free(&r->pack);
    r->pack = grown(3, 200, GRAVITY_ADAPTIVE, false, watch, r, &out);
  }
  r->status = out.status;
}

static Pack *base(int dim) {
  Outcome out = {0};
  Species fine = {"fine", 1, 250};
  GravityPlan plan = {.mode = GRAVITY_ADAPTIVE};
  Rng rng = rng_stream(6, 0, RNG_GRAVITY);
  return gravity_pack(dim, &fine, 1, NULL, &plan, &rng, NULL, &out);
}

static void run_coarse(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  Pack *fine = base(kind == 1 ? 2 : 3);
  Species coarse = {"coarse", 2.5, kind == 2 ? 5 : 3};
  CoarsePlan plan = {.settle = {.watch = watch}};
  CoarseReport report;
  Rng rng = rng_stream(7, 0, RNG_GRAVITY);
  r->pack = kind == 2 ? coarse_mark(fine, &coarse, NULL, &plan, &rng, &report, &out)
                      : coarse_add(fine, &coarse, &plan, &rng, &report, &out);
  note(r, (double)report.destroyed);
  note(r, (double)report.turns);
  note_sweep(r, report.grown);
  note_sweep(r, report.settled);
  note(r, report.passes);
  note(r, report.room);
  note(r, report.overlap);
  note(r, report.rim);
  note_rng(r, &rng);
  r->status = out.status;
  pack_free(&fine);
}

static void run_dilution(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  Pack *dense = base(kind == 1 ? 2 : 3);
  DilutePlan plan = {.fraction = 0.2, .part = 1, .literal = kind == 2, .watch = watch};
  DiluteReport report;
  Rng rng = rng_stream(8, 0, RNG_GRAVITY);
  r->pack = dilute_pack(dense, &plan, &rng, &report, &out);
  note(r, report.steps);
  note(r, report.aims);
  note(r, report.passes);
  note_sweep(r, report.all);
  note(r, report.before);
  note(r, report.reached);
  note(r, report.range);
  note(r, report.overlap);
  note(r, report.rim);
  note_rng(r, &rng);
  r->status = out.status;
  pack_free(&dense);
}

/* ---- shapes */
static Pack *scattered(double fraction, size_t n) {
  double square[3] = {1, 1, 1};
  Species species[3] = {{"P", 1, n / 2, shape_regular(5)}, {"E", 0.8, n / 4, shape_superellipse(1.5, 3)}, {"D", 0.7, n / 4, NULL}};
  Box box = box_make(2, square, 100);
  Pack *pack = pack_alloc(&box, species, 3, false);
  for (int s = 0; s < 2; s++)
    shape_free(&species[s].shape);
  pack->box = box_make(2, square, pack_solid(pack) / fraction);
  Rng rng = rng_stream(9, 0, RNG_POSITIONS);
  points_scatter(pack, &rng);
  points_turn(pack, &rng);
  return pack;
}

static void run_relax(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  RelaxPlan plan = {.road = kind == 1 ? DYNAMICS_SPRINGS : DYNAMICS_AREA, .growth = 1e-3, .steps = kind == 3 ? 40 : 3000, .watch = watch};
  RelaxReport report;
  Rng rng = rng_stream(10, 0, RNG_RELAX);
  r->pack = scattered(kind == 3 ? 0.95 : 0.75, 60);
  if (kind == 2)
    relax_most(r->pack, 0.5, &plan, &rng, &report, &out);
  else
    relax_pack(r->pack, &plan, &rng, &report, &out);
  note(r, (double)report.steps);
  note(r, (double)report.lenses);
  note(r, report.sweeps);
  note(r, report.other);
  note(r, report.contacts);
  note(r, report.residual);
  note(r, report.reached);
  note_rng(r, &rng);
  r->status = out.status;
}

static void run_compression(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  CompressionPlan plan = {0.3, kind == 1 ? 3 : 1, 1e5, watch};
  CompressionReport report;
  Rng rng = rng_stream(11, 0, RNG_POSITIONS);
  r->pack = scattered(kind == 1 ? 0.6 : 0.74, 60);
  compression_grow(r->pack, &plan, &rng, &report, &out);
  note(r, report.attempts);
  note(r, report.trials);
  note(r, report.moved);
  note(r, report.sweeps);
  note(r, report.fraction);
  note_rng(r, &rng);
  r->status = out.status;
}

static void run_turning(int kind, Watch *watch, Result *r) {
  Outcome out = {0};
  CompressionPlan first = {0.3, 1, 1e5, NULL};
  CompressionReport unwanted;
  TurningPlan plan = {kind == 1 ? 2 : 0.2, 0.3, 1, watch};
  TurningReport report = {0};
  Rng rng = rng_stream(12, 0, RNG_SHAKING);
  r->pack = scattered(0.5, kind == 2 ? 4 : 60);
  compression_grow(r->pack, &first, &rng, &unwanted, &out);
  Turning *turning = turning_alloc(r->pack, &plan, &out);
  r->status = turning_sweeps(turning, 300, &rng, &report);
  turning_store(turning, r->pack);
  note(r, (double)report.trials);
  note(r, (double)report.moved);
  note(r, turning_wandered(turning));
  note_rng(r, &rng);
  turning_free(&turning);
}

typedef struct {
  const char *name;
  void (*run)(int kind, Watch *watch, Result *r);
  int kind, status, parts;
} Case;
static const Case cases[] = {
    {"gravity in space", run_gravity, 0, DONE, 1},
    {"gravity in the plane", run_gravity, 1, DONE, 1},
    {"literal gravity", run_gravity, 2, DONE, 1},
    {"gravity of two sizes", run_gravity, 3, DONE, 1},
    {"gravity after gravity", run_gravity, 4, DONE, 2},
    {"coarse spheres added", run_coarse, 0, DONE, 2},
    {"coarse discs added", run_coarse, 1, DONE, 2},
    {"coarse spheres marked", run_coarse, 2, DONE, 1},
    {"dilution in space", run_dilution, 0, DONE, 1},
    {"dilution in the plane", run_dilution, 1, DONE, 1},
    {"literal dilution", run_dilution, 2, DONE, 1},
    {"relaxation by areas", run_relax, 0, DONE, 1},
    {"relaxation by springs", run_relax, 1, DONE, 1},
    {"relaxation to the largest fraction", run_relax, 2, DONE, 0},
    {"relaxation that fails", run_relax, 3, UNREACHED, 1},
    {"compression", run_compression, 0, DONE, 1},
    {"compression by three sweeps", run_compression, 1, DONE, 1},
    {"turning", run_turning, 0, DONE, 1},
    {"turning by wide moves", run_turning, 1, DONE, 1},
    {"turning in a narrow box", run_turning, 2, DONE, 1},
};

static bool same(const Result *a, const Result *b) {
  if (a->status != b->status || a->numbers != b->numbers || !same_numbers(a->number, b->number, (size_t)a->numbers))
    return false;
  size_t n = a->pack->n;
  return b->pack->n == n && same_numbers(a->pack->x, b->pack->x, n * (size_t)a->pack->box.dim) && same_box(&a->pack->box, &b->pack->box) &&
         a->pack->open == b->pack->open && (!a->pack->angle || same_numbers(a->pack->angle, b->pack->angle, n));
}

static void forget(Result *r) {
  pack_free(&r->pack);
  *r = (Result){0};
}

/* Stop after so many ticks, take it up and stop again, to the end. Each part has a file of its own. */
static void test_stops(const Case *c, const Result *undisturbed, const char *path, int stop) {
  int stops = 0, loaded = 0;
  Result r = {0};
  do {
    forget(&r);
    Keeper *keeper = keeper_of(path, stop);
    c->run(c->kind, &keeper->watch, &r);
    loaded += keeper->loaded;
    gsl_test(keeper->watch.depth != 0, "%s: its parts are ended", c->name);
    gsl_test(r.status == STOPPED && r.pack && c->run != run_relax && c->run != run_compression && c->run != run_turning,
             "%s: what was stopped leaves no pack", c->name);
    stops += r.status == STOPPED;
    free(keeper);
  } while (r.status == STOPPED && stops < 400);
  gsl_test(!same(&r, undisturbed), "%s, stopped %d times, every %d ticks: the same", c->name, stops, stop);
  gsl_test(stops == 0 || loaded < stops, "%s: it was stopped and taken up", c->name);
  forget(&r);
  keeper_forget(path);
}

static void test_case(const Case *c, const char *path) {
  Result undisturbed = {0}, watched = {0};
  c->run(c->kind, NULL, &undisturbed);
  gsl_test_int(undisturbed.status, c->status, "%s", c->name);
  Keeper *keeper = keeper_of(path, 0);
  c->run(c->kind, &keeper->watch, &watched);
  gsl_test(!same(&watched, &undisturbed), "%s: watched and not", c->name);
  gsl_test(keeper->outside, "%s: only the outermost part is heard", c->name);
  gsl_test(c->parts && keeper->begun != c->parts, "%s: %d parts", c->name, keeper->begun);
  gsl_test(keeper->ticks < 4, "%s: there are %d ticks", c->name, keeper->ticks);
  int few = keeper->ticks / as_many(4, 40);
  test_stops(c, &undisturbed, path, few < 1 ? 1 : few);
  test_stops(c, &undisturbed, path, 1 + keeper->ticks / 2);
  forget(&undisturbed);
  forget(&watched);
  free(keeper);
}

int main(void) {
  char dir[40], path[80];
  keeper_place(dir, path);
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
    test_case(&cases[c], path);
  gsl_test(rmdir(dir), "nothing is left in it");
  return gsl_test_summary();
}
