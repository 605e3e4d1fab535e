/* tests/bench_threepoint.h: three points on a grid of 100 x 100 pairs of arms, a part of bench.c. */
#include "threepoint.h"

static const double threepoint_sizes[] = {16384, 65536, 262144, 1048576, 4194304};
static const double threepoint_angle[] = {10};
enum { TRIANGLES_MOST = 4096, TRIANGLES_LEAST = 256 };

static const Form threepoint_square = {"square", 4, 0, 0}, threepoint_superellipse = {"1.5-2", 0, 1.5, 2};

/* S's number of shapes in a box of about a hundred. */
static Pack *threepoint_pack(Bench *bench, const Form *form) {
  Rng rng = rng_stream(SEED, 0, RNG_TEST);
  Pack *pack = shaped_pack(form, 407, 0.7);
  CompressionPlan plan = {.start = 0.3, .each = 1, .sweeps = 1e6};
  CompressionReport report;
  compression_grow(pack, &plan, &rng, &report, &bench->out);
  return pack;
}

typedef struct {
  const Pack *pack;
  double samples;
  bool triangles;
  double error;
} ThreepointJob;

static void threepoint_run(void *of) {
  ThreepointJob *job = of;
  Rng rng = rng_stream(SEED, 0, RNG_THREEPOINT);
  ThreepointPlan plan = {.arms = 100,
                         .step = 0.06 * 2.5,
                         .thetas = 1,
                         .theta = threepoint_angle,
                         .samples = job->samples};
  Threepoint *found =
      (job->triangles ? threepoint_triangles : threepoint_shared)(
          job->pack, &plan, &rng);
  job->error = found->rms;
  threepoint_free(&found);
}

/* The root mean square of the errors of all cells. */
static void threepoint_operations(Bench *bench) {
  Pack *pack = threepoint_pack(bench, &threepoint_square);
  for (size_t k = 0; k < COUNT(threepoint_sizes); k++) {
    ThreepointJob job = {pack, FEW(threepoint_sizes[k]) < 3
                                   ? threepoint_sizes[0]
                                   : threepoint_sizes[k],
                         false, 0};
    threepoint_run(&job);
    say(bench, job.error, 0, "threepoint_shared_%.0f", threepoint_sizes[k]);
  }
  for (double n = TRIANGLES_LEAST; n <= TRIANGLES_MOST; n *= 4) {
    ThreepointJob job = {pack, FEW(n) < 3 ? TRIANGLES_LEAST : n, true, 0};
    threepoint_run(&job);
    say(bench, job.error, 0, "threepoint_triangles_%.0f", n);
  }
  pack_free(&pack);
}

static void threepoint_seconds(Bench *bench) {
  Pack *pack = threepoint_pack(bench, &threepoint_square);
  for (size_t k = 0; k < COUNT(threepoint_sizes); k++) {
    ThreepointJob job = {pack, threepoint_sizes[k], false, 0};
    threepoint_run(&job);
    Case one = {"shared", threepoint_run, &job, job.error};
    measure(bench, "squares", job.samples, 1e4, &one, 1);
  }
  for (double n = TRIANGLES_LEAST; n <= TRIANGLES_MOST; n *= 4) {
    ThreepointJob job = {pack, n, true, 0};
    threepoint_run(&job);
    Case one = {"triangles", threepoint_run, &job, job.error};
    measure(bench, "squares", n, 1e4, &one, 1);
  }
  pack_free(&pack);
  pack = threepoint_pack(bench, &threepoint_superellipse);
  ThreepointJob job = {pack, threepoint_sizes[2], false, 0};
  threepoint_run(&job);
  Case one = {"shared", threepoint_run, &job, job.error};
  measure(bench, "superellipses", job.samples, 1e4, &one, 1);
  pack_free(&pack);
}
