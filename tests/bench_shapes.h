/* tests/bench_shapes.h: the tasks of shapes, a part of bench.c. */
#include "compression.h"
#include "cover.h"
#include "overlap.h"
#include "penetrable.h"
#include "points.h"
#include "relax.h"
#include "turning.h"

/* ------------------------------------------------------------ overlap */
typedef struct {
  const char *label;
  int sides; /* of a regular polygon, or 0 */
  double aspect, m;
} Form;
static const Form forms[] = {{"pentagon", 5, 0, 0}, {"hexagon", 6, 0, 0},
                             {"1-1", 0, 1, 1}, {"1-1.5", 0, 1, 1.5}, {"1-2", 0, 1, 2}, {"1-5", 0, 1, 5}, {"1-50", 0, 1, 50},
                             {"1.5-1", 0, 1.5, 1}, {"1.5-1.5", 0, 1.5, 1.5}, {"1.5-2", 0, 1.5, 2}, {"1.5-5", 0, 1.5, 5}, {"1.5-50", 0, 1.5, 50},
                             {"5-1", 0, 5, 1}, {"5-1.5", 0, 5, 1.5}, {"5-2", 0, 5, 2}, {"5-5", 0, 5, 5}, {"5-50", 0, 5, 50}};
enum { BODIES = 400 };
static Shape *form_shape(const Form *form) {
  return form->sides ? shape_regular(form->sides)
                     : shape_superellipse(form->aspect, form->m);
}

/* Pairs that overlap, at random: bodies 2 i and 2 i + 1. */
static void draw_bodies(const Shape *shape, Body bodies[2 * BODIES]) {
  Rng rng = rng_stream(SEED, 0, RNG_TEST);
  for (size_t i = 0; i < BODIES;) {
    Body *pair = bodies + 2 * i;
    for (int k = 0; k < 2; k++) {
      double u[2], x[2];
      rng_direction(&rng, 2, u);
      rng_in_ball(&rng, 2, k * 2 * shape->outer, x);
      pair[k] = (Body){shape, 1, x[0], x[1], u[0], u[1]};
    }
    i += overlap_verdict(pair, pair + 1, NULL) == OVERLAP_CROSSING;
  }
}

typedef enum { BY_OURS, BY_MIXED, BY_POINTS, BY_LAYER } OverlapWay;
typedef struct {
  const Body *bodies;
  OverlapWay way;
  int64_t size; /* points or nodes */
  size_t next;
} OverlapJob;

static void overlap_by(OverlapWay way, int64_t size, const Body *pair,
                       Overlap *o) {
  if (way == BY_OURS)
    overlap_find(pair, pair + 1, o);
  else if (way == BY_MIXED)
    overlap_mixed(pair, pair + 1, (int)size, o);
  else
    overlap_sampled(pair, pair + 1, size, way == BY_LAYER, o);
}

static void overlap_run(void *of) {
  OverlapJob *job = of;
  Overlap o;
  overlap_by(job->way, job->size, job->bodies + 2 * job->next, &o);
  job->next = (job->next + 1) % BODIES;
}

static void verdict_run(void *of) {
  OverlapJob *job = of;
  overlap_verdict(job->bodies + 2 * job->next, job->bodies + 2 * job->next + 1,
                  NULL);
  job->next = (job->next + 1) % BODIES;
}

/* The root mean square error of the area, by that of the shape, which is pi. */
static double overlap_error(const Body bodies[], OverlapWay way, int64_t size,
                            size_t pairs) {
  double sum = 0;
  for (size_t i = 0; i < pairs; i++) {
    Overlap o, right;
    overlap_find(bodies + 2 * i, bodies + 2 * i + 1, &right);
    overlap_by(way, size, bodies + 2 * i, &o);
    sum += gsl_pow_2(o.area - right.area);
  }
  return sqrt(sum / (double)pairs) / M_PI;
}

/* The same of ours: how the area changes when both bodies are turned together
   and moved. */
static double overlap_rounding(const Body bodies[]) {
  double sum = 0;
  Rng rng = rng_stream(SEED, 2, RNG_TEST);
  for (size_t i = 0; i < BODIES; i++) {
    double u[2];
    Overlap o, moved;
    Body pair[2];
    rng_direction(&rng, 2, u);
    for (int k = 0; k < 2; k++) {
      const Body *b = bodies + 2 * i + (size_t)k;
      pair[k] = *b;
      pair[k].x = u[0] * b->x - u[1] * b->y + 2.385;
      pair[k].y = u[1] * b->x + u[0] * b->y - 3.141;
      pair[k].c = u[0] * b->c - u[1] * b->s;
      pair[k].s = u[1] * b->c + u[0] * b->s;
    }
    overlap_find(bodies + 2 * i, bodies + 2 * i + 1, &o);
    overlap_find(pair, pair + 1, &moved);
    sum += gsl_pow_2(o.area - moved.area);
  }
  return sqrt(sum / BODIES) / M_PI;
}

static const struct {
  const char *name;
  OverlapWay way;
  int64_t size;
} overlap_ways[] = {{"mixed", BY_MIXED, 16},        {"mixed", BY_MIXED, 64},
                    {"mixed", BY_MIXED, 256},       {"points", BY_POINTS, 10000},
                    {"points", BY_POINTS, 100000},  {"points", BY_POINTS, 1000000},
                    {"layer", BY_LAYER, 10000},     {"layer", BY_LAYER, 1000000}};

/* How many of the pairs of unit discs that share this area a million points
   miss. */
static double missed(double area, size_t pairs) {
  Shape *disc = shape_superellipse(1, 1);
  Rng rng = rng_stream(SEED, 1, RNG_TEST);
  double d = 2 - pow(0.75 * area, 2.0 / 3), missed = 0;
  for (size_t i = 0; i < pairs; i++) {
    double u[2];
    Overlap o;
    rng_direction(&rng, 2, u);
    Body pair[2] = {{disc, 1, 0, 0, 1, 0}, {disc, 1, d * u[0], d * u[1], 1, 0}};
    missed += !overlap_sampled(pair, pair + 1, 1000000, false, &o);
  }
  shape_free(&disc);
  return missed / (double)pairs;
}

/* Two pairs as S Fig. 1 has them, to be drawn: what they share, and the force. */
static void overlap_pairs(Bench *bench) {
  static const Form shapes[] = {{"1.5-1.5", 0, 1.5, 1.5}, {"triangle", 3, 0, 0}};
  static const double place[2][4] = {{0.3, 1.65, 0.75, 2.2}, {0.35, 1.35, 0.55, 2.6}}; /* angle; x, y, angle */
  Table table = begin(bench, "overlap-pairs.tsv", "Two pairs of shapes of radius 1, and what they share; A is at the origin",
                      "shape\tsides\taspect\tm\tangle_A\tx\ty\tangle_B\tarea\tarea_x\tarea_y\tforce_x\tforce_y");
  for (size_t f = 0; f < COUNT(shapes); f++) {
    Shape *shape = form_shape(shapes + f);
    const double *p = place[f];
    Body A = {shape, 1, 0, 0, cos(p[0]), sin(p[0])}, B = {shape, 1, p[1], p[2], cos(p[3]), sin(p[3])};
    Overlap o;
    overlap_find(&A, &B, &o);
    fprintf(table.file, "%s\t%d\t%g\t%g\t%g\t%g\t%g\t%g\t%.6f\t%.6f\t%.6f\t%.6f\t%.6f\n", shapes[f].label, shapes[f].sides,
            shapes[f].aspect, shapes[f].m, p[0], p[1], p[2], p[3], o.area, o.x, o.y, o.fx, o.fy);
    shape_free(&shape);
  }
  end(bench, &table);
}

static void overlap_operations(Bench *bench) {
  Table table = begin(bench, "overlap.tsv",
                      "Overlap areas of random pairs: error by the area of one",
                      "shape\tmethod\tsize\terror");
  Body *bodies = memory(2 * BODIES, sizeof *bodies);
  for (size_t f = 0; f < COUNT(forms); f++) {
    Shape *shape = form_shape(forms + f);
    draw_bodies(shape, bodies);
    say(bench, overlap_rounding(bodies), 0, "overlap_%s_ours", forms[f].label);
    for (size_t w = 0; w < COUNT(overlap_ways); w++) {
      size_t pairs = FEW(overlap_ways[w].size > 200000 ? 10 : 100);
      double error =
          overlap_error(bodies, overlap_ways[w].way, overlap_ways[w].size, pairs);
      if (forms[f].sides && overlap_ways[w].way == BY_MIXED)
        continue;
      fprintf(table.file, "%s\t%s\t%.0f\t%.3g\n", forms[f].label,
              overlap_ways[w].name, (double)overlap_ways[w].size, error);
      say(bench, error, 0, "overlap_%s_%s_%.0f", forms[f].label,
          overlap_ways[w].name, (double)overlap_ways[w].size);
    }
    shape_free(&shape);
  }
  free(bodies);
  for (int k = 5; k <= 7; k++) {
    double pairs = FEW(100), part = missed(pow(10, -k), (size_t)pairs);
    say(bench, part, sqrt(part * (1 - part) / pairs), "overlap_missed_%d", k);
  }
  end(bench, &table);
  overlap_pairs(bench);
}

static void overlap_seconds(Bench *bench) {
  Body *bodies = memory(2 * BODIES, sizeof *bodies);
  for (size_t f = 0; f < COUNT(forms); f++) {
    Shape *shape = form_shape(forms + f);
    draw_bodies(shape, bodies);
    OverlapJob ours = {bodies, BY_OURS, 0, 0}, verdict = ours;
    OverlapJob points[] = {{bodies, BY_POINTS, 1000000, 0}, {bodies, BY_POINTS, 100000, 0}, {bodies, BY_POINTS, 10000, 0}};
    OverlapJob mixed[] = {{bodies, BY_MIXED, 64, 0}, {bodies, BY_MIXED, 16, 0}, {bodies, BY_MIXED, 256, 0}};
    Case cases[] = {{"ours", overlap_run, &ours, GSL_NAN},
                    {"verdict", verdict_run, &verdict, 0},
                    {"plain-points", overlap_run, points, GSL_NAN},
                    {"points-100000", overlap_run, points + 1, GSL_NAN},
                    {"points-10000", overlap_run, points + 2, GSL_NAN},
                    {"mixed", overlap_run, mixed, GSL_NAN},
                    {"mixed-16", overlap_run, mixed + 1, GSL_NAN},
                    {"mixed-256", overlap_run, mixed + 2, GSL_NAN}};
    measure(bench, forms[f].label, 1, 1, cases, forms[f].sides ? 5 : 8);
    shape_free(&shape);
  }
  free(bodies);
}

/* ------------------------------------------------------------ packs */
/* N = 407 of radius 2.5 at this fraction, S's pack, without shapes yet. */
static Pack *shaped_pack(const Form *form, size_t n, double fraction) {
  Shape *shape = form_shape(form);
  double cube[3] = {1, 1, 1};
  Species one = {"P", 2.5, n, shape};
  Box box = box_make(2, cube, (double)n * pack_ball(2, 2.5) / fraction);
  Pack *pack = pack_alloc(&box, &one, 1, false);
  shape_free(&shape);
  return pack;
}

typedef struct {
  Pack *pack;
  Body *bodies;
  int side; /* points along a side of the box, or 0: exactly */
  bool rows;
} CoverJob;

static void cover_run(void *of) {
  CoverJob *job = of;
  const Box *box = &job->pack->box;
  if (!job->side)
    cover_area(job->bodies, job->pack->n, box, NULL);
  else if (job->rows)
    cover_rows(job->bodies, job->pack->n, box, job->side, job->side);
  else
    cover_lattice(job->bodies, job->pack->n, box, job->side, job->side);
}

/* S Table 4: 254 pentagons that fill half of the box. */
static void covered_seconds(Bench *bench) {
  static const int side[] = {0, 316, 1000, 3162};
  Rng rng = rng_stream(SEED, 0, RNG_TEST);
  Pack *pack = shaped_pack(forms, 254, 0.4987278);
  CompressionPlan plan = {.start = 0.3, .each = 1, .sweeps = 1e6};
  CompressionReport report;
  compression_grow(pack, &plan, &rng, &report, &bench->out);
  Body *bodies = cover_bodies(pack);
  for (size_t k = 0; k < COUNT(side); k++) {
    CoverJob ours = {pack, bodies, side[k], true}, plain = ours;
    plain.rows = false;
    Case cases[] = {{k ? "rows" : "exact", cover_run, &ours, GSL_NAN},
                    {"plain-points", cover_run, &plain, GSL_NAN}};
    measure(bench, "pentagons", (double)side[k] * side[k], 1, cases,
            k == 1 ? 2 : 1);
  }
  free(bodies);
  pack_free(&pack);
}

typedef struct {
  Turning *turning;
  Rng rng;
} TurnJob;

static void turn_run(void *of) {
  TurnJob *job = of;
  TurningReport report = {0};
  turning_sweeps(job->turning, 1, &job->rng, &report);
}

static void turning_seconds(Bench *bench) {
  static const Form shapes[] = {{"pentagon", 5, 0, 0},
                                {"square", 4, 0, 0},
                                {"1.5-1.5", 0, 1.5, 1.5}};
  for (size_t f = 0; f < COUNT(shapes); f++) {
    TurnJob job = {.rng = rng_stream(SEED, 0, RNG_TEST)};
    Pack *pack = shaped_pack(shapes + f, 1000, 0.7);
    CompressionPlan plan = {.start = 0.3, .each = 1, .sweeps = 1e6};
    CompressionReport report;
    TurningPlan moves = {.radius = 0.1, .turn = 0.1, .size = 1};
    compression_grow(pack, &plan, &job.rng, &report, &bench->out);
    job.turning = turning_alloc(pack, &moves, &bench->out);
    Case one = {"ours", turn_run, &job, GSL_NAN};
    measure(bench, shapes[f].label, 1000, 1000, &one, 1);
    turning_free(&job.turning);
    pack_free(&pack);
  }
}

typedef struct {
  const Form *form;
  double tolerance; /* 0: exchange */
  uint64_t k;
} GrainJob;

static void grain_run(void *of) {
  GrainJob *job = of;
  Outcome out = {0};
  PenetrableReport report;
  Rng rng = rng_stream(SEED, job->k++, RNG_PENETRABLE);
  Pack *pack = shaped_pack(job->form, 819, 0.8);
  pack->box.side[0] = pack->box.side[1] = 100;
  PenetrablePlan plan = {.fraction = 0.8, .tolerance = 1e-14, .sweeps = 1, .attempts = 1e6};
  if (job->tolerance > 0)
    plan.tolerance = job->tolerance;
  if (job->tolerance > 0)
    penetrable_regenerate(pack, &plan, &rng, &report, &out);
  else
    penetrable_exchange(pack, &plan, &rng, &report, &out);
  pack_free(&pack);
}

/* S Table 5: 819 grains that cover .8 of the box. */
static void penetrable_seconds(Bench *bench) {
  static const Form shapes[] = {{"square", 4, 0, 0}, {"1.5-1.5", 0, 1.5, 1.5}};
  for (size_t f = 0; f < COUNT(shapes); f++) {
    GrainJob exchange = {shapes + f, 0, 0}, two = {shapes + f, 1e-2, 0};
    Case cases[] = {{"exchange", grain_run, &exchange, 1e-14},
                    {"regenerate-2", grain_run, &two, 1e-2}};
    measure(bench, shapes[f].label, 819, 1, cases, COUNT(cases));
  }
}

typedef struct {
  const Form *form;
  DynamicsForce road;
  uint64_t k;
} RelaxJob;

static void relax_run(void *of) {
  RelaxJob *job = of;
  Outcome out = {0};
  RelaxReport report;
  RelaxPlan plan = {.road = job->road, .growth = 1e-3, .steps = 20000, .model = {.shear = 1}};
  Rng rng = rng_stream(SEED, job->k++, RNG_RELAX);
  Pack *pack = shaped_pack(job->form, 407, 0.8);
  points_scatter(pack, &rng);
  points_turn(pack, &rng);
  relax_pack(pack, &plan, &rng, &report, &out);
  assert(out.status == DONE);
  pack_free(&pack);
}

/* S Fig. 4: 407 shapes freed of overlap at .8, by either road first. */
static void relax_seconds(Bench *bench) {
  static const Form shapes[] = {{"pentagon", 5, 0, 0}, {"1.5-1.5", 0, 1.5, 1.5}};
  for (size_t f = 0; f < COUNT(shapes); f++) {
    RelaxJob springs = {shapes + f, DYNAMICS_SPRINGS, 0}, areas = {shapes + f, DYNAMICS_AREA, 0};
    Case cases[] = {{"springs", relax_run, &springs, 0}, {"areas", relax_run, &areas, 0}};
    measure(bench, shapes[f].label, 407, 1, cases, COUNT(cases));
  }
}
