/* The engine: against the plain kernel, against closed forms and theory. */
#include "few.h"
#include "crm.h"
#include "engine.h"
#include "lattice.h"
#include "many.h"
#include "ref_motion.h"
#include "theory.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <signal.h>

static Pack *random_points(int dim, size_t n, const double ratio[], double r1,
                           size_t n2, double r2, uint64_t seed) {
  Box box = box_make(dim, ratio, 731.5);
  Species s[2] = {{.name = "A", .radius = r1, .count = n},
                  {.name = "B", .radius = r2, .count = n2}};
  Pack *pack = pack_alloc(&box, s, n2 ? 2 : 1, false);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[c % (size_t)dim];
  return pack;
}
static const double cube[3] = {1, 1, 1}, rod[3] = {1, 1, 20};

/* Bit for bit the same sequence as the table of all pairs. */
static void against_reference(int dim, size_t n, size_t n2, double ratio,
                              double target, double gamma, MotionMass mass,
                              double slack, size_t events) {
  Pack *pack = random_points(dim, n, cube, 1, n2, ratio, 11 + n);
  double v = pack_fraction(pack), f = dim == 2 ? sqrt(target / v)
                                               : cbrt(target / v);
  for (int s = 0; s < pack->kinds; s++)
    pack->species[s].radius *= f;
  Engine *engine = engine_alloc(pack, mass, slack);
  Rng rng = rng_stream(5, 0, RNG_TEST);
  Motion *motion = engine->motion;
  motion_stir(motion, engine->order, &rng);
  motion->size = 0;
  motion->growth = gamma / pack_largest(pack);
  RefMotion *ref = calloc(1, sizeof *ref);
  ref->dim = dim;
  ref->n = pack->n;
  ref->pair = calloc(pack->n * pack->n, sizeof *ref->pair);
  ref->growth = motion->growth;
  for (size_t i = 0; i < pack->n; i++) {
    const double *p = motion->hot + i * (size_t)(2 * dim + 2);
    for (int k = 0; k < dim; k++) {
      ref->x[i][k] = p[k];
      ref->v[i][k] = p[dim + k];
      ref->side[k] = motion->side[k];
    }
    ref->a[i] = p[2 * dim + 1];
    ref->mass[i] = motion->mass ? motion->mass[i] : 1;
  }
  engine_sync(engine, 0, 1);
  ref->wide = engine->near->wide;
  ref->oldest = engine->oldest;
  ref_sync(ref, 0);
  /* A pack that jams has events at one and the same time, to the last bit;
     which of them comes first is then decided otherwise here than there. */
  bool tie = false;
  size_t done = 0, agreed = 0, refreshed = 0;
  while (done < events && motion->size < 1 && !tie) {
    double stop = (1 - motion->size) / motion->growth;
    int landed = 0;
    for (size_t w = 0; w < pack->n && !landed; w++) {
      size_t i, j;
      uint64_t had = engine->collisions;
      engine_run(engine, stop, 1);
      int what, quarters = 0;
      do {
        what = ref_next(ref, stop, &i, &j);
        quarters += what == 2 ? engine->refresh : 4;
        refreshed += what == 2;
      } while (quarters < 4);
      landed = what == 0;
      done++;
      uint32_t a = engine->pair[0], b = engine->pair[1];
      int same = engine->now == ref->now && (engine->collisions > had) == (what == 1);
      if (what == 1)
        same = same && ((engine->order[i] == a && engine->order[j] == b) ||
                        (engine->order[i] == b && engine->order[j] == a));
      if (!same && agreed == done - 1 && gamma >= 0.3 &&
          engine->now == ref->now && what == 1) {
        tie = true;
        done--;
        break;
      }
      agreed += same;
    }
    if (tie)
      break;
    double cool = 1 / sqrt(motion_temperature(motion) * 3);
    engine_sync(engine, engine->now, cool);
    ref->wide = engine->near->wide;
    ref->oldest = engine->oldest;
    ref_sync(ref, ref->now);
    for (size_t i = 0; i < pack->n; i++)
      for (int k = 0; k < dim; k++)
        ref->v[i][k] *= cool;
    ref_sync(ref, 0);
    if (landed)
      break;
  }
  gsl_test(agreed != done || done < 20,
           "%d-D, N=%zu+%zu, ratio %g, leash %g (%s): %zu of %zu events "
           "(%zu refreshed, size %.4f%s) as the table has them",
           dim, n, n2, ratio, slack, engine->near->wide ? "wide" : "narrow",
           agreed, done, refreshed, motion->size, tie ? ", then a tie" : "");
  free(ref->pair);
  free(ref);
  engine_free(&engine);
  pack_free(&pack);
}

/* Ten particles of radius 1, or one and many small ones, in a box of side L: is
   it wide, and how far may records reach back, in parts of L? */
static void how_wide(int dim, double L, size_t n2, double r2, bool wide,
                     double part) {
  Pack *pack = random_points(dim, n2 ? 1 : 10, cube, 1, n2, r2, 3);
  for (int k = 0; k < dim; k++)
    pack->box.side[k] = L;
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = box_wrap(pack->x[c], L);
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  engine->motion->size = 0;
  engine_sync(engine, 0, 1);
  gsl_test(engine->near->wide != wide || engine->oldest != part * L,
           "a box of %g radii: %s, records reach back %g of it", L,
           engine->near->wide ? "wide" : "narrow", engine->oldest / L);
  engine_free(&engine);
  pack_free(&pack);
}

static void lands(int dim, size_t n, const double ratio[], size_t n2, double r2,
                  double target, CrmProtocol protocol, double rate,
                  MotionMass mass) {
  Pack *pack = random_points(dim, n, ratio, 1, n2, r2, n + n2);
  CrmPlan plan = {.protocol = protocol, .mass = mass, .rate = rate,
                  .fraction = target, .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  gsl_test(status != DONE || fabs(pack_fraction(pack) - target) >= 1e-14 ||
               gap < -1e-12 || report.unaccounted > 1e-12 ||
               report.slip > 1e-12 || (pack->n > 1 && report.drift > 1e-12),
           "%d-D N=%zu+%zu r2=%g to %g rate %g: status %d, off by %.2g, gap "
           "%.3g, energy %.2g, drift %.2g, %.1f collisions a particle %s",
           dim, n, n2, r2, target, rate, status, pack_fraction(pack) - target,
           gap, report.unaccounted, report.drift,
           2 * (double)report.collisions / (double)pack->n, out.text);
  pack_free(&pack);
}

/* Ends UNREACHED, for this reason, at this fraction: known exactly, or between
   what any growth reaches and what no disordered pack exceeds. */
static void fails(size_t n, double target, double rate, double most,
                  const char *why, double about, double within) {
  Pack *pack = random_points(3, n, cube, 1, 0, 1, n);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = rate, .fraction = target,
                  .points = true, .pressure = most, .budget = n > 2 ? 1500 : 6000};
  Rng rng = rng_stream(4, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  gsl_test(status != UNREACHED || !strstr(out.text, why) || gap < -1e-12 ||
               fabs(report.fraction - about) > within,
           "N=%zu to %g: status %d, gap %.3g: %s", n, target, status, gap,
           out.text);
  pack_free(&pack);
}

static void pressure(double phi, size_t n, double blocks) {
  Pack *pack = random_points(3, n, cube, 1, 0, 1, 77);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .05, .fraction = phi,
                  .points = true};
  Rng rng = rng_stream(9, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  crm_grow(pack, &plan, &rng, &report, &out);
  int status = crm_equilibrate(pack, MOTION_EQUAL, 60, 20, blocks, &rng,
                               &report, &out);
  double exact = few_pressure(phi, (double)n), off = report.Z - exact;
  gsl_test(status || fabs(off) > 4 * report.Z_error ||
               report.Z_error > (n < 500 ? .005 : .0025) * exact || report.unaccounted > 1e-12 ||
               pack_audit(pack) < -2e-12,
           "phi=%g: Z=%.4f +- %.4f, theory %.4f (%.2f se)", phi, report.Z,
           report.Z_error, exact, off / report.Z_error);
  pack_free(&pack);
}

/* Two or three bodies whose flights are known. */
static Engine *bodies(Pack **pack, size_t n, const double x[][3],
                   const double v[][3], double radius, double side,
                   double growth) {
  Box box = {.dim = 3, .side = {side, side, side}};
  Species s = {.name = "A", .radius = radius, .count = n};
  *pack = pack_alloc(&box, &s, 1, false);
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < 3; k++)
      (*pack)->x[3 * i + k] = x[i][k];
  Engine *engine = engine_alloc(*pack, MOTION_EQUAL, 0);
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < 3; k++)
      engine->motion->hot[8 * i + 3 + k] = v[engine->order[i]][k];
  engine->motion->growth = growth;
  engine_sync(engine, 0, 1);
  return engine;
}

static void collide_once(Engine *engine) {
  uint64_t had = engine->collisions;
  for (int tries = 0; tries < 100 && engine->collisions == had; tries++)
    engine_run(engine, 1e6, 1);
}

static void closed_forms(double side) {
  Pack *pack;
  /* Head on along x, growing: gap 2 - .75 - 1.5 .1 t closes at 1.1 + .15. */
  const double x[2][3] = {{1.1, 2.3, 3.7}, {3.1, 2.3, 3.7}};
  const double v[2][3] = {{.6, 0, 0}, {-.5, 0, 0}};
  Engine *engine = bodies(&pack, 2, x, v, .375, side, .2);
  collide_once(engine);
  double t = 1.25 / (1.1 + .15);
  gsl_test_abs(engine->now, t, 1e-14, "head on with growth, side %g", side);
  engine_sync(engine, engine->now, 1);
  size_t a = engine->order[0] == 0 ? 0 : 1;
  /* w = -1.1, D' = .15: w* = .3 + 1.1; J = (1/2)(1.4 + 1.1) */
  gsl_test_abs(engine->motion->hot[8 * a + 3], .6 - 1.25, 1e-14, "v of the first");
  gsl_test_abs(engine->motion->hot[8 * (1 - a) + 3], -.5 + 1.25, 1e-14, "v second");
  gsl_test_abs(engine->motion->work, 1.25 * .15, 1e-14, "growth's work");
  gsl_test_abs(engine->motion->virial, 1.25 * .75 * (1 + .2 * t), 1e-14, "virial");
  engine_free(&engine);
  pack_free(&pack);
  /* Growth below the last digit of the velocities does no work. */
  engine = bodies(&pack, 2, x, v, .375, side, 2e-17);
  collide_once(engine);
  gsl_test_rel(engine->motion->work, 1.1 * 1.5e-17, 1e-14, "work meant");
  gsl_test_rel(engine->motion->slip, -1.1 * 1.5e-17, 1e-14,
               "all of it is slip, and the slip is in the account");
  engine_free(&engine);
  pack_free(&pack);
  /* Oblique: B = .75 sin 30: impact parameter half the contact distance. */
  const double y[2][3] = {{1, 2, 3}, {3, 2.375, 3}};
  const double u[2][3] = {{1, 0, 0}, {0, 0, 0}};
  engine = bodies(&pack, 2, y, u, .375, side, 0);
  collide_once(engine);
  gsl_test_abs(engine->now, 2 - .75 * sqrt(.75), 1e-14, "oblique");
  engine_sync(engine, engine->now, 1);
  a = engine->order[0] == 0 ? 0 : 1;
  gsl_test_abs(engine->motion->hot[8 * a + 3], .25, 1e-14, "vx: 1 - cos^2 30");
  gsl_test_abs(engine->motion->hot[8 * a + 4], -.25 * sqrt(3), 1e-14, "vy");
  engine_free(&engine);
  pack_free(&pack);
  /* Receding at .14, overtaken by a growth of .15: the gap is .25 - .01 t, and
     B = .14 - .1125 > 0. On the other side it is 64 - .75 - .29 t. */
  const double far[2][3] = {{1, 2, 3}, {2, 2, 3}};
  const double slow[2][3] = {{0, 0, 0}, {.14, 0, 0}};
  engine = bodies(&pack, 2, far, slow, .375, 65, .2);
  collide_once(engine);
  gsl_test_abs(engine->now, 25, 1e-10, "overtaken by growth");
  engine_free(&engine);
  pack_free(&pack);
  /* Newton's cradle of three: the velocity is handed on. */
  const double z[3][3] = {{1, 2, 3}, {2.25, 2, 3}, {4, 2, 3}};
  const double w[3][3] = {{.8, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  engine = bodies(&pack, 3, z, w, .375, side, 0);
  collide_once(engine);
  gsl_test_abs(engine->now, .5 / .8, 1e-14, "cradle, first");
  collide_once(engine);
  gsl_test_abs(engine->now, 1.5 / .8, 1e-14, "cradle, second");
  engine_sync(engine, engine->now, 1);
  for (size_t i = 0; i < 3; i++)
    gsl_test_abs(engine->motion->hot[8 * i + 3], engine->order[i] == 2 ? .8 : 0,
                 1e-14, "cradle, %u", engine->order[i]);
  engine_free(&engine);
  pack_free(&pack);
}

/* Forward, all velocities turned, and back: the start returns. */
static void reversal(size_t n, double target, uint64_t collisions) {
  Pack *pack = random_points(3, n, cube, 1, 0, 1, 5);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .1, .fraction = target,
                  .points = true};
  Rng rng = rng_stream(6, 1, RNG_TEST);
  Outcome out = {0};
  crm_grow(pack, &plan, &rng, NULL, &out);
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  motion_stir(engine->motion, engine->order, &rng);
  engine_sync(engine, 0, 1);
  engine_run(engine, INFINITY, collisions);
  double time = engine->now * (1 + 1e-6);
  engine_sync(engine, time, -1);
  engine_run(engine, time, UINT64_MAX);
  Pack *back = random_points(3, n, cube, 1, 0, 1, 5);
  engine_store(engine, back);
  double most = 0;
  for (size_t c = 0; c < 3 * n; c++)
    most = fmax(most, fabs(box_nearest(back->x[c] - pack->x[c],
                                       pack->box.side[c % 3])));
  gsl_test(most > 1e-9 || engine->collisions < 2 * collisions - engine->refreshed,
           "N=%zu: back after %.0f collisions within %.2g", n,
           (double)engine->collisions, most);
  engine_free(&engine);
  pack_free(&back);
  pack_free(&pack);
}

/* Leashes and vectors decide nothing. */
static void same_bytes(int dim) {
  static const double slack[] = {0, .1, .35, 0, 0};
  static const char *const simd[] = {"default", "avx512f", "avx2", "avx2",
                                     "avx512f"};
  Pack *first = NULL;
  for (int v = 0; v < 5; v++) {
    setenv("RANDPACK_SIMD", simd[v], 1);
    Pack *pack = random_points(dim, (size_t)as_many(450, 900), cube, .3, 100, .1, 8);
    Engine *engine = engine_alloc(pack, MOTION_VOLUME, slack[v]);
    Rng rng = rng_stream(3, 3, RNG_TEST);
    motion_stir(engine->motion, engine->order, &rng);
    engine->motion->size = 0;
    engine->motion->growth = .05;
    for (int w = 0; w < as_many(3, 6); w++) {
      engine_sync(engine, engine->now, 1);
      engine_run(engine, (1 - engine->motion->size) / .05, 1000);
    }
    engine_store(engine, pack);
    if (first)
      gsl_test(memcmp(first->x, pack->x,
                      pack->n * (size_t)dim * sizeof *pack->x) != 0,
               "%d-D: the same bytes with leash %g and %s (%g leashes)", dim,
               slack[v], simd[v], (double)engine->leashes);
    else
      first = pack;
    if (first != pack)
      pack_free(&pack);
    engine_free(&engine);
  }
  unsetenv("RANDPACK_SIMD");
  pack_free(&first);
}

static void coincident(double rate) {
  Pack *pack = random_points(3, 60, cube, 1, 0, 1, 2);
  for (size_t c = 0; c < 30; c++)
    pack->x[c] = pack->x[c % 3];
  CrmPlan plan = {.protocol = rate > 1 ? CRM_LITERAL : CRM_ISOTHERMAL,
                  .rate = rate, .fraction = .4, .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, NULL, &out);
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  gsl_test(status || gap < -1e-12, "ten points in one, rate %g: %d, gap %.3g %s",
           rate, status, gap, out.text);
  plan.points = false;
  plan.fraction = .5;
  pack->x[0] = pack->x[3];
  pack->x[1] = pack->x[4];
  pack->x[2] = pack->x[5];
  gsl_test(crm_grow(pack, &plan, &rng, NULL, &out) != WRONG,
           "an overlapping pack is refused: %s", out.text);
  pack_free(&pack);
}

/* Slow literal growth heats as the adiabatic law says, with Carnahan and
   Starling's Z (3 per mille high or low); isothermal growth ends at its rate. */
static void heats(void) {
  size_t n = (size_t)as_many(100, 200);
  double most = .45, want = exp(2 * most * (4 - 3 * most) /
                                (3 * (1 - most) * (1 - most)));
  Pack *pack = random_points(3, n, cube, 1, 0, 1, 6);
  CrmPlan plan = {.protocol = CRM_LITERAL, .rate = .002, .fraction = most,
                  .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status || fabs(report.heating / want - 1) > .04,
           "slow growth to %g heats %.3f times; adiabatic law %.3f", most,
           report.heating, want);
  pack_free(&pack);
  pack = random_points(3, n, cube, 1, 0, 1, 6);
  plan.protocol = CRM_ISOTHERMAL;
  plan.rate = .037;
  status = crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status || fabs(report.gamma / .037 - 1) > 1e-12,
           "Gamma at the end: %.15g", report.gamma);
  pack_free(&pack);
}

/* So few particles meet each other so often that the rounding of the growth's
   speed stands out from all others. */
static void slips(void) {
  Pack *pack = random_points(3, 3, cube, 1, 0, 1, 6);
  CrmPlan plan = {.protocol = CRM_LITERAL, .rate = 3e-5, .fraction = .3,
                  .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status || report.slip < 1e-14 || report.slip > 1e-11 ||
               report.unaccounted > report.slip / 8,
           "after %g collisions the energy is slip: %.2g, and %.2g beyond it",
           (double)report.collisions, report.slip, report.unaccounted);
  pack_free(&pack);
}

/* A jammed pack keeps its radii and is far beyond the fluid. */
static void jams(void) {
  Pack *pack = random_points(2, 40, cube, 1.4, 40, 1, 9);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .1, .points = true,
                  .pressure = 1e5};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_jam(pack, &plan, &rng, &report, &out);
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  double phi = pack_fraction(pack);
  gsl_test(status || report.Z < 1e5 || pack_largest(pack) != 1.4 ||
               gap < -1e-12 || phi < .80 || phi > .91 ||
               report.unaccounted > 1e-12,
           "jammed discs: %d, Z %.3g, phi %.4f, gap %.2g, radius %g", status,
           report.Z, phi, gap, pack_largest(pack));
  pack_free(&pack);
}

/* A crystal in contact is jammed before any time has passed. */
static void jammed_before(void) {
  Species one = {.name = "A", .radius = 1};
  for (int k = 0; k < 2; k++) {
    Pack *pack = lattice_make(k ? LATTICE_FCC : LATTICE_CUBIC, 1 - k, &one, 0);
    CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .1, .budget = 100};
    Rng rng = rng_stream(3, 1, RNG_TEST);
    CrmReport report;
    Outcome out = {0};
    int status = crm_jam(pack, &plan, &rng, &report, &out);
    gsl_test(status || !(report.Z >= 1e9), "%d spheres of a crystal in contact: %d, Z %g, %s", (int)pack->n, status, report.Z, out.text);
    pack_free(&pack);
  }
}

static void in_two_steps(void) {
  Pack *pack = random_points(3, (size_t)as_many(250, 500), cube, 1, 0, 1, 2);
  CrmPlan plan = {.protocol = CRM_LITERAL, .rate = .2, .fraction = .4,
                  .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(report.heating <= 1, "a pack heats: %g times", report.heating);
  plan.points = false;
  plan.fraction = .53;
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status || fabs(pack_fraction(pack) - .53) >= 1e-14 ||
               pack_audit(pack) < -2e-12,
           "from .4 to .53: %d %s", status, out.text);
  plan.fraction = .3;
  gsl_test(crm_grow(pack, &plan, &rng, &report, &out) != WRONG, "denser: %s",
           out.text);
  pack_free(&pack);
}

/* Velocities whose squares have no digits: the run ends, and nothing has moved
   through anything. An engine that turns round one event for ever is shot. */
static void shot(int number) {
  static const char words[] = "FAIL: a run with slow velocities did not end\n";
  (void)number;
  _exit(write(STDOUT_FILENO, words, sizeof words - 1) > 0);
}

static void slow_ones(double factor, bool moves) {
  Pack *pack = random_points(3, 100, cube, 1, 0, 1, 4);
  CrmPlan plan = {.protocol = CRM_LITERAL, .rate = 1, .fraction = .3,
                  .points = true};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  Outcome out = {0};
  crm_grow(pack, &plan, &rng, NULL, &out);
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  motion_stir(engine->motion, engine->order, &rng);
  signal(SIGALRM, shot);
  alarm(20);
  engine_sync(engine, 0, factor);
  engine_run(engine, 1e308, 3000);
  alarm(0);
  engine_store(engine, pack);
  gsl_test((engine->collisions > 2000) != moves || pack_audit(pack) < -2e-12,
           "velocities times %g: %g collisions, gap %.2g", factor,
           (double)engine->collisions, pack_audit(pack) / 2);
  engine_free(&engine);
  pack_free(&pack);
}

/* Who calls on a growing pack, and what he does there. */
typedef struct {
  enum { LOOKS, SHIFTS, SHAKES } does;
  size_t calls, moved;
  double least, last; /* gap by diameter; fraction at the last call */
  bool grew;
  double at[3]; /* where he left particle 0 */
  Rng rng;
} Guest;

static void shift_all(Pack *pack, Rng *rng) {
  size_t dim = (size_t)pack->box.dim;
  for (size_t k = 0; k < dim; k++) {
    double by = rng_uniform(rng) * pack->box.side[k];
    for (size_t i = 0; i < pack->n; i++)
      pack->x[i * dim + k] =
          box_wrap(pack->x[i * dim + k] + by, pack->box.side[k]);
  }
}

/* Particle i anywhere within half a radius, if nobody is there. */
static bool shake(Pack *pack, size_t i, Rng *rng) {
  size_t dim = (size_t)pack->box.dim;
  double *x = pack->x + i * dim, had[3];
  memcpy(had, x, dim * sizeof *x);
  for (size_t k = 0; k < dim; k++)
    x[k] = box_wrap(x[k] + (rng_uniform(rng) - .5) * pack_radius(pack, i),
                    pack->box.side[k]);
  for (size_t j = 0; j < pack->n; j++) {
    double square = 0, sum = pack_radius(pack, i) + pack_radius(pack, j);
    for (size_t k = 0; k < dim; k++) {
      double d = box_nearest(pack->x[j * dim + k] - x[k], pack->box.side[k]);
      square += d * d;
    }
    if (j != i && square < sum * sum) {
      memcpy(x, had, dim * sizeof *x);
      return false;
    }
  }
  return true;
}

static void call(void *visitor, Pack *pack) {
  Guest *guest = visitor;
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  double phi = pack_fraction(pack);
  guest->least = guest->calls ? fmin(guest->least, gap) : gap;
  guest->grew = (!guest->calls || guest->grew) && phi > guest->last;
  guest->last = phi;
  guest->calls++;
  if (guest->does == SHIFTS)
    shift_all(pack, &guest->rng);
  for (size_t i = 0; guest->does == SHAKES && i < pack->n; i++)
    guest->moved += shake(pack, i, &guest->rng);
  memcpy(guest->at, pack->x, (size_t)pack->box.dim * sizeof *pack->x);
}

static void visited(int dim, size_t n, size_t n2, double r2, double target,
                    CrmProtocol protocol, int does, double every, bool own) {
  Pack *pack = random_points(dim, n, cube, 1, n2, r2, n + n2);
  if (own) {
    pack->radius = malloc(pack->n * sizeof *pack->radius);
    for (size_t i = 0; i < pack->n; i++)
      pack->radius[i] = 1 + .5 * (double)i / (double)pack->n;
  }
  Guest guest = {.does = does, .rng = rng_stream(6, 2, RNG_TEST)};
  CrmPlan plan = {.protocol = protocol, .rate = .1, .fraction = target,
                  .points = true, .every = every, .visit = call,
                  .visitor = &guest};
  Rng rng = rng_stream(3, 1, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  double gap = pack_audit(pack) / (2 * pack_largest(pack));
  double met = 2 * (double)report.collisions / (double)pack->n, away = 0;
  for (int k = 0; k < dim; k++)
    away = fmax(away, fabs(box_nearest(pack->x[k] - guest.at[k],
                                       pack->box.side[k])));
  gsl_test(status || fabs(pack_fraction(pack) - target) >= 1e-14 ||
               gap < -1e-12 || away > 2 * pack_largest(pack) || guest.least < -1e-12 || !guest.grew ||
               guest.last >= target || report.visits != guest.calls ||
               guest.calls < 5 || report.unaccounted > 1e-12 ||
               report.drift > 1e-12 ||
               fabs((double)guest.calls - floor(met / every)) > 1 ||
               (does == SHAKES && guest.moved < 30),
           "%d-D N=%zu+%zu%s: %zu visits in %.1f collisions a particle, %s "
           "(%zu moved): gap %.1e, then %.1e, gone %.2f since, energy %.1e %s",
           dim, n, n2, own ? " of all sizes" : "", guest.calls, met,
           does == LOOKS ? "looks" : does == SHIFTS ? "shifts" : "shakes",
           guest.moved, guest.least, gap, away, report.unaccounted, out.text);
  pack_free(&pack);
}

/* Who looks where the engine has a sync point anyway changes no byte. */
static void looked_at(int dim, double low, double high) {
  Pack *pack[2];
  CrmReport report;
  Guest guest = {.does = LOOKS};
  for (int v = 0; v < 2; v++) {
    pack[v] = random_points(dim, 300, cube, 1, 0, 1, 2);
    CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .2, .fraction = low,
                    .points = true};
    Rng rng = rng_stream(3, 1, RNG_TEST);
    Outcome out = {0};
    crm_grow(pack[v], &plan, &rng, NULL, &out);
    plan.points = false;
    plan.fraction = high;
    plan.every = 2;
    plan.visit = v ? call : NULL;
    plan.visitor = &guest;
    crm_grow(pack[v], &plan, &rng, &report, &out);
  }
  gsl_test(guest.calls < 5 || report.refreshed ||
               memcmp(pack[0]->x, pack[1]->x,
                      300 * (size_t)dim * sizeof *pack[0]->x) != 0,
           "%d-D: the same bytes after %zu visitors who only looked", dim,
           guest.calls);
  pack_free(&pack[0]);
  pack_free(&pack[1]);
}

static void visits(void) {
  looked_at(3, .4, .55);
  looked_at(2, .6, .75);
  visited(3, 200, 0, 1, .5, CRM_ISOTHERMAL, LOOKS, .3, false);
  visited(3, 200, 0, 1, .55, CRM_LITERAL, SHIFTS, 1, false);
  visited(2, 200, 0, 1, .7, CRM_ISOTHERMAL, SHIFTS, 3, false);
  visited(3, 300, 0, 1, .55, CRM_ISOTHERMAL, SHAKES, 1, false);
  visited(3, 300, 0, 1, .5, CRM_LITERAL, SHAKES, 2, true);
  visited(2, 200, 0, 1, .75, CRM_LITERAL, SHAKES, 1, false);
  visited(3, 20, 200, .3, .5, CRM_ISOTHERMAL, SHAKES, 1, false);
  visited(3, 8, 0, 1, .4, CRM_ISOTHERMAL, SHIFTS, 1, false);
  visited(3, 12, 0, 1, .4, CRM_ISOTHERMAL, SHAKES, 1, false);
  visited(2, 6, 0, 1, .5, CRM_LITERAL, SHAKES, 1, false);
}

int main(void) {
  closed_forms(6.5);
  closed_forms(65);
  against_reference(3, 32, 0, 1, .50, .1, MOTION_EQUAL, 0, 4000);
  against_reference(3, 32, 0, 1, .54, .03, MOTION_EQUAL, .2, 5000);
  against_reference(2, 32, 0, 1, .70, .1, MOTION_EQUAL, 0, 4000);
  against_reference(2, 150, 0, 1, .70, .1, MOTION_EQUAL, .2, 3000);
  against_reference(3, 16, 60, .313, .50, .1, MOTION_VOLUME, 0, 3000);
  against_reference(2, 2, 0, 1, .5, .1, MOTION_EQUAL, 0, 200);
  against_reference(3, 30, 0, 1, .50, .3, MOTION_EQUAL, 0, 4000);
  against_reference(3, 33, 0, 1, .50, 1, MOTION_EQUAL, 0, 4000);
  against_reference(3, 3, 0, 1, .45, .001, MOTION_EQUAL, .15, 3000);
  against_reference(2, 3, 0, 1, .60, .001, MOTION_EQUAL, .15, 3000);
  slow_ones(1e-140, true);
  slow_ones(1e-161, false);
  slow_ones(1e-200, false);
  visits();
  slips();
  how_wide(3, 5.4, 0, 0, false, 1. / 8);
  how_wide(3, 5.6, 0, 0, true, 1. / 32);
  how_wide(3, 9.8, 0, 0, true, 1. / 32);
  how_wide(2, 4.3, 9000, .02, false, 1. / 8);
  how_wide(3, 16, 0, 0, true, 1. / 8);
  lands(3, 22, cube, 0, 1, .55, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, 40, cube, 0, 1, .3, CRM_LITERAL, .1, MOTION_EQUAL);
  size_t small = (size_t)as_many(300, 400), all = (size_t)as_many(400, 1000);
  lands(3, 5, cube, small, .2, .6, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(2, 12, cube, 0, 1, .6, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, all, cube, 0, 1, .60, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, all, cube, 0, 1, .575, CRM_LITERAL, 1, MOTION_EQUAL);
  lands(2, all, cube, 0, 1, .80, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, all / 20, cube, all / 2, .313, .60, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, 3, cube, 300, .1, .55, CRM_ISOTHERMAL, .1, MOTION_EQUAL);
  lands(3, 3, cube, 300, .1, .55, CRM_LITERAL, .1, MOTION_VOLUME);
  lands(2, 20, cube, all, .1, .75, CRM_ISOTHERMAL, .1, MOTION_EQUAL);
  lands(3, 300, rod, 0, 1, .55, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, 20, rod, 0, 1, .4, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, 1, cube, 0, 1, .5235, CRM_ISOTHERMAL, .05, MOTION_EQUAL);
  lands(3, 2, cube, 0, 1, .6, CRM_ISOTHERMAL, .01, MOTION_EQUAL);
  lands(3, 3, cube, 0, 1, .4, CRM_LITERAL, .05, MOTION_EQUAL);
  lands(3, 8, cube, 0, 1, .5, CRM_ISOTHERMAL, .01, MOTION_EQUAL);
  lands(2, 1, cube, 0, 1, .785, CRM_LITERAL, 1, MOTION_EQUAL);
  lands(2, 3, cube, 0, 1, .5, CRM_LITERAL, 1, MOTION_EQUAL);
  lands(3, 500, cube, 0, 1, 1e-6, CRM_LITERAL, 1, MOTION_EQUAL);
  lands(3, 500, cube, 0, 1, .4, CRM_LITERAL, 10, MOTION_EQUAL);
  fails(1, .6, .1, 0, "own image", M_PI / 6, 1e-9);
  fails(2, .69, .01, 0, "jammed", M_PI * sqrt(3) / 8, 1e-6);
  fails((size_t)as_many(200, 500), .75, .1, 1e6, "jammed", .64, .06);
  fails(100, .70, .003, 0, "budget", .40, .30);
  fails(32, .70, 3, 1e300, "jammed", .40, .30);
  size_t fluid = (size_t)as_many(200, 500);
  pressure(.10, fluid, as_many(15, 40));
  if (fluid == 500)
    pressure(.30, fluid, 40);
  pressure(.45, fluid, as_many(40, 80));
  reversal(5, .2, 20);
  reversal(8, .3, 20);
  same_bytes(3);
  same_bytes(2);
  coincident(.1);
  coincident(5);
  in_two_steps();
  heats();
  jams();
  jammed_before();
  return gsl_test_summary();
}
