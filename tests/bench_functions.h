/* tests/bench_functions.h: the two-point function of one pack by each way, and zeta2 and eta2 of balls and discs; a part of bench.c. */
#include "microstructure.h"
#include "share.h"
#include "twopoint.h"

enum { TWO_RADII = 61 };
static const double two_accuracy[] = {1e-3, 1e-4, 1e-5};
static const double two_points_a_side[] = {256, 512, 1024, 2048, 4096};
static const double two_segments[] = {1e3, 1e4, 1e5};
enum { TWO_EXACT, TWO_RASTER, TWO_SEGMENTS };

typedef struct {
  const Pack *pack;
  int way;
  double effort;
  double *S; /* TWO_RADII values found */
} TwoJob;

static void two_run(void *of) {
  TwoJob *job = of;
  Outcome out = {0};
  Rng rng = rng_stream(SEED, 0, RNG_TWOPOINT);
  double step = 0.1 * job->pack->species[0].radius;
  Twopoint *t =
      job->way == TWO_EXACT
          ? twopoint_exact(job->pack, step, TWO_RADII, false, job->effort, &out)
      : job->way == TWO_RASTER
          ? twopoint_raster(job->pack, step, TWO_RADII, false,
                            job->effort * job->effort)
          : twopoint_segments(job->pack, step, TWO_RADII, false,
                              (size_t)job->effort, &rng);
  if (!t)
    fprintf(stderr, "bench: %s\n", out.text);
  assert(t);
  memcpy(job->S, t->S[0], TWO_RADII * sizeof *job->S);
  twopoint_free(&t);
}

/* The root mean square difference of two curves. */
static double two_apart(const double S[], const double T[]) {
  double sum = 0;
  for (int i = 0; i < TWO_RADII; i++)
    sum += gsl_pow_2(S[i] - T[i]);
  return sqrt(sum / TWO_RADII);
}

static void two_way(Bench *bench, const Pack *pack, const double truth[],
                    const char *label, int way, const char *method,
                    const double efforts[], size_t n) {
  double S[TWO_RADII];
  for (size_t k = 0; k < n; k++) {
    TwoJob job = {pack, way, efforts[k], S};
    two_run(&job);
    Case one = {method, two_run, &job, two_apart(S, truth)};
    measure(bench, label, efforts[k], TWO_RADII, &one, 1);
  }
}

/* Pentagons without overlap at .7, as many again that may overlap, and superellipses without overlap. */
static void twopoint_seconds(Bench *bench) {
  static const struct {
    const char *label;
    Form form;
    size_t n;
    double fraction, truth;
    size_t accuracies;
  } packs[] = {{"hard", {"pentagon", 5, 0, 0}, 407, 0.7, 3e-6, COUNT(two_accuracy)},
               {"penetrable", {"pentagon", 5, 0, 0}, 819, 1.608, 2e-6, COUNT(two_accuracy)},
               {"superellipses", {"1.5-2", 0, 1.5, 2}, 407, 0.7, 1e-5, 2}};
  for (size_t k = 0; k < COUNT(packs); k++) {
    double truth[TWO_RADII];
    Rng rng = rng_stream(SEED, 0, RNG_TEST);
    Pack *pack = shaped_pack(&packs[k].form, packs[k].n, packs[k].fraction);
    CompressionPlan plan = {.start = 0.3, .each = 1, .sweeps = 1e6};
    CompressionReport report;
    if (packs[k].fraction > 1)
      penetrable_throw(pack, false, &rng);
    else
      compression_grow(pack, &plan, &rng, &report, &bench->out);
    TwoJob exactly = {pack, TWO_EXACT, packs[k].truth, truth};
    two_run(&exactly);
    two_way(bench, pack, truth, packs[k].label, TWO_EXACT, "exact", two_accuracy, packs[k].accuracies);
    two_way(bench, pack, truth, packs[k].label, TWO_RASTER, "raster", two_points_a_side, COUNT(two_points_a_side));
    two_way(bench, pack, truth, packs[k].label, TWO_SEGMENTS, "segments", two_segments, COUNT(two_segments));
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ zeta2, eta2 */
static const double micro_errors[] = {1e-2, 1e-3, 1e-5, 1e-7, 1e-9};
static const double micro_pixels[] = {5, 10, 20, 40};
static const struct {
  int dim;
  const char *label;
} micro_packs[] = {{2, "discs"}, {3, "spheres"}};

typedef struct {
  const Pack *pack;
  double effort;
  bool field;
  double eta;
} MicroJob;

static void micro_run(void *of) {
  MicroJob *job = of;
  Outcome out = {0};
  MicrostructurePlan plan = {job->effort, 1};
  Microstructure found = {.eta = 0};
  Share share = {.eta = 0};
  const Box *box = &job->pack->box;
  double volume = 1;
  for (int k = 0; k < box->dim; k++)
    volume *= box->side[k] * job->effort;
  if (job->field)
    share_find(job->pack, volume, box->dim == 2 ? 8 : 2, &share, &out);
  else
    microstructure_balls(job->pack, &plan, &found, NULL, &out);
  assert(out.status == DONE);
  job->eta = job->field ? share.eta : found.eta;
}

/* Random addition: 1000 balls of radius 1; in space few pixels, which take ten seconds. */
static void microstructure_seconds(Bench *bench) {
  RsaReport report;
  for (size_t p = 0; p < COUNT(micro_packs); p++) {
    int dim = micro_packs[p].dim;
    Pack *pack = rsa_pack(dim, 1000, dim == 2 ? 0.45 : 0.30, 0, &report);
    MicroJob truth = {pack, 1e-11, false, 0};
    micro_run(&truth);
    for (size_t k = 0; k < COUNT(micro_errors); k++) {
      MicroJob job = {pack, micro_errors[k], false, 0};
      micro_run(&job);
      Case one = {"multipoles", micro_run, &job,
                  fmax(fabs(job.eta / truth.eta - 1), 1e-15)};
      measure(bench, micro_packs[p].label, job.effort, 1000, &one, 1);
    }
    for (size_t k = 0; k < COUNT(micro_pixels) - (dim == 3 ? 2 : 0); k++) {
      MicroJob job = {pack, micro_pixels[k], true, 0};
      micro_run(&job);
      Case one = {"field", micro_run, &job, fabs(job.eta / truth.eta - 1)};
      measure(bench, micro_packs[p].label, job.effort, 1000, &one, 1);
    }
    pack_free(&pack);
  }
}
