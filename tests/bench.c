/* Speed against error: each task of the chapter find-speed, in operations and
   in seconds. To add a task: a function that writes tables and says numbers,
   one that measures cases, and a line of the table `tasks` near the end.

     bench ops DIR            DIR/TABLES.tsv, then DIR/summary.tsv
     bench seconds FILE       the record of a machine, with $BENCH_MACHINE
     bench recorded FILE DIR  DIR/summary.tsv: rates and ratios of a record
     bench compare FILE       ours beside the plain programs */
#include "cells.h"
#include "chain.h"
#include "coarse.h"
#include "core.h"
#include "dilute.h"
#include "contact.h"
#include "crm.h"
#include "engine.h"
#include "field.h"
#include "gravity.h"
#include "mixture.h"
#include "outcome.h"
#include "pairs.h"
#include "partials.h"
#include "py.h"
#include "ref_crm.h"
#include "ref_gravity.h"
#include "ref_mixture.h"
#include "ref_pairs.h"
#include "ref_py.h"
#include "ref_rsa.h"
#include "rsa.h"
#include "shake.h"
#include "simd.h"
#include "sizes.h"
#include "table.h"
#include "theory.h"
#include <assert.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <malloc.h>
#include <omp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SEED = 2012 };
#define COUNT(ARRAY) (sizeof(ARRAY) / sizeof *(ARRAY))

/* ------------------------------------------------------------ the bench */
typedef struct {
  const char *directory, *code;
  Table summary, record; /* of operations, of seconds */
  const char *task;
  Outcome out;
} Bench;

static void say(Bench *bench, double value, double error, const char *format,
                ...) __attribute__((format(printf, 4, 5)));
static void say(Bench *bench, double value, double error, const char *format,
                ...) {
  va_list arguments;
  va_start(arguments, format);
  vfprintf(bench->summary.file, format, arguments);
  va_end(arguments);
  fprintf(bench->summary.file, error > 0 ? "\t%.6g\t%.2g\n" : "\t%.3g\tnan\n",
          value, error);
}

static Table begin(Bench *bench, const char *name, const char *what,
                   const char *columns) {
  Table table = {.file = NULL};
  if (table_open(&table, bench->directory, name, &bench->out)) {
    fprintf(stderr, "bench: %s\n", bench->out.text);
    exit(UNREACHED);
  }
  fprintf(table.file, "# %s\n# code: %s\n# seed: %d\n%s\n", what, bench->code,
          SEED, columns);
  return table;
}

static void end(Bench *bench, Table *table) {
  if (table_close(table, &bench->out)) {
    fprintf(stderr, "bench: %s\n", bench->out.text);
    exit(UNREACHED);
  }
}

/* ------------------------------------------------------------ seconds */
/* Of so many packs a draft takes at most two. */
#ifdef DRAFT
#define FEW(n) ((n) < 2 ? (n) : 2)
#else
#define FEW(n) (n)
#endif
enum { REPEAT = 9, CASES = 8 };
typedef struct {
  const char *method; /* "plain..." is what the others are compared with */
  void (*run)(void *of);
  void *of;
  double error; /* of the result, or NAN */
} Case;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double time_case(const Case *one, double calls) {
  double start = now();
  for (double c = 0; c < calls; c++)
    one->run(one->of);
  return (now() - start) / calls;
}

static double enough_calls(const Case *one, double first) {
  double calls = 1;
  for (double t = first; calls < 1e6 && t * calls < 0.004;)
    t = time_case(one, calls *= 2);
  return calls;
}

static void write_case(Bench *bench, const Case *one, const char *label,
                       double size, double work, double t[], size_t n) {
  gsl_sort(t, 1, n);
  double median = gsl_stats_median_from_sorted_data(t, 1, n);
  double quartiles = gsl_stats_quantile_from_sorted_data(t, 1, n, 0.75) -
                     gsl_stats_quantile_from_sorted_data(t, 1, n, 0.25);
  fprintf(bench->record.file,
          "%s\t%s\t%s\t%g\t%.6g\t%.4g\t%.2g\t%zu\t%.3g\t%s\n", bench->task,
          one->method, label, size, work, median,
          n > 2 ? quartiles / 2 : GSL_NAN, n, one->error, bench->code);
}

/* Time the cases in turn, REPEAT rounds, or 3 if these take 4 seconds: a
   ratio of two of them then sees the same neighbours on the machine. The first
   call of each sets how many make a time that can be read. */
static void measure(Bench *bench, const char *label, double size, double work,
                    const Case cases[], size_t count) {
  double t[CASES][REPEAT], calls[CASES], start = now();
  size_t rounds = 1;
  assert(count <= CASES);
  for (size_t c = 0; c < count; c++) {
    t[c][0] = time_case(cases + c, 1);
    calls[c] = enough_calls(cases + c, t[c][0]);
    if (calls[c] > 1)
      t[c][0] = time_case(cases + c, calls[c]);
  }
  for (; rounds < REPEAT && (rounds < 3 || now() - start < 4); rounds++)
    for (size_t c = 0; c < count; c++)
      t[c][rounds] = time_case(cases + c, calls[c]);
  for (size_t c = 0; c < count; c++)
    write_case(bench, cases + c, label, size, work, t[c], rounds);
  fprintf(stderr, "bench: %s %s %g: %.1f s\n", bench->task, label, size,
          now() - start);
}

/* ------------------------------------------------------------ packs */
static Pack *points(int dim, size_t n) {
  const double cube[] = {1, 1, 1};
  Species one = {"A", 0.1, n};
  Box box = box_make(dim, cube, (double)n);
  Pack *pack = pack_alloc(&box, &one, 1, false);
  Rng rng = rng_stream(SEED, n, RNG_POSITIONS);
  for (size_t i = 0; i < n; i++)
    for (int k = 0; k < dim; k++)
      pack->x[i * (size_t)dim + (size_t)k] = rng_uniform(&rng) * box.side[k];
  return pack;
}

static Pack *unit_balls(int dim, size_t n, double volume) {
  const double cube[] = {1, 1, 1};
  Species one = {"A", 1, n};
  Box box = box_make(dim, cube, volume);
  return pack_alloc(&box, &one, 1, false);
}

static Pack *rsa_pack(int dim, size_t n, double fraction, uint64_t k,
                      RsaReport *report) {
  Outcome out = {0};
  Pack *pack = unit_balls(dim, n, (double)n * pack_ball(dim, 1) / fraction);
  Rng rng = rng_stream(SEED, k, RNG_POSITIONS);
  rsa_fill(pack, 0, false, &rng, report, &out);
  assert(out.status == DONE);
  return pack;
}

/* ------------------------------------------------------------ Percus-Yevick */
static const double py_phi[] = {0.30, 0.49, 0.575};
static const double py_R[] = {2.1, 5, 15};

/* The arithmetic ends at 1e-16; what is below 1e-15 says nothing but that,
   and its last bits may depend on the processor. */
static double shown(double error) {
  return error > 1e-15 ? error : 1e-15;
}

static void py_rows(Bench *bench, Table *table, PyMethod method, double phi,
                    size_t terms, double most[]) {
  Py *py = py_alloc_by(method, phi, terms);
  for (size_t k = 0; k < COUNT(py_R); k++) {
    if (method == PY_SHELLS && terms != (size_t)(py_R[k] / 2))
      continue;
    double error = shown(ref_py_error(phi, py_R[k], py_g(py, py_R[k])));
    size_t cost = method == PY_POLES ? terms : py_cost(py, py_R[k]);
    fprintf(table->file, "%s\t%g\t%g\t%zu\t%.2g\n", py_method_name(method), phi,
            py_R[k], cost, error);
    if (most[k] == 0 && error < 1e-10)
      say(bench, most[k] = (double)cost, 0, "py_%s_%g_%g_terms",
          py_method_name(method), phi, py_R[k]);
    if (method == PY_FFT_PLAIN || method == PY_FFT)
      if (terms == 1 << 18)
        say(bench, error, 0, "py_%s_%g_%g_error", py_method_name(method), phi,
            py_R[k]);
    if (method == PY_POLES && terms == 512)
      say(bench, error, 0, "py_poles_%g_%g_error", phi, py_R[k]);
  }
  py_free(&py);
}

/* The worst error over from <= R <= 20 in quarters. */
static double py_worst(PyMethod method, double phi, size_t terms, double from) {
  Py *py = py_alloc_by(method, phi, terms);
  double worst = 0;
  for (double R = from; R <= 20; R += 0.25)
    worst = fmax(worst, ref_py_error(phi, R, py_g(py, R)));
  py_free(&py);
  return shown(worst);
}

static void py_operations(Bench *bench) {
  Table table =
      begin(bench, "py.tsv", "Percus-Yevick g(R): error against terms summed",
            "method\tphi\tR=r/a\tterms\tabsolute error");
  double worst = 0;
  for (int m = PY_AUTO; m < PY_METHODS; m++)
    for (size_t f = 0; f < COUNT(py_phi); f++) {
      size_t first = m == PY_POLES ? 1 : 1024,
             last = m == PY_POLES ? 512 : 1 << 18;
      double most[COUNT(py_R)] = {0};
      if (m == PY_AUTO)
        worst = fmax(worst, py_worst(PY_AUTO, py_phi[f], 0, 2));
      else if (m == PY_SHELLS)
        for (size_t terms = 1; terms <= 7; terms++)
          py_rows(bench, &table, PY_SHELLS, py_phi[f], terms, most);
      else
        for (size_t terms = first; terms <= last; terms *= 2)
          py_rows(bench, &table, (PyMethod)m, py_phi[f], terms, most);
    }
  say(bench, worst, 0, "py_auto_worst");
  say(bench, py_worst(PY_SHELLS, 0.575, 0, 2), 0, "py_shells_worst");
  end(bench, &table);
}

typedef struct {
  PyMethod method;
  size_t terms;
  Py *py;
  double sum;
} PyJob;
enum { VALUES = 1000 };

static void py_prepare(void *of) {
  PyJob *job = of;
  Py *py = py_alloc_by(job->method, 0.575, job->terms);
  job->sum += py_g(py, 5.1);
  py_free(&py);
}

static void py_values(void *of) {
  PyJob *job = of;
  for (int k = 0; k < VALUES; k++)
    job->sum += py_g(job->py, 3 + 17.0 / VALUES * k);
}

static void py_seconds(Bench *bench) {
  static const struct {
    PyMethod method;
    size_t terms;
  } jobs[] = {
      {PY_AUTO, 0},          {PY_SHELLS, 10},       {PY_POLES, 4},
      {PY_POLES, 16},        {PY_POLES, 64},        {PY_POLES, 256},
      {PY_FFT, 1024},        {PY_FFT, 8192},        {PY_FFT, 65536},
      {PY_FFT, 262144},      {PY_FFT_PLAIN, 1024},  {PY_FFT_PLAIN, 8192},
      {PY_FFT_PLAIN, 65536}, {PY_FFT_PLAIN, 262144}};
  for (size_t j = 0; j < COUNT(jobs); j++) {
    PyJob job = {jobs[j].method, jobs[j].terms, NULL, 0};
    job.py = py_alloc_by(job.method, 0.575, job.terms);
    const char *name = py_method_name(job.method);
    double error = py_worst(job.method, 0.575, job.terms, 3);
    Case one = {name, py_prepare, &job, error};
    Case many = {name, py_values, &job, error};
    measure(bench, "alone", (double)job.terms, 1, &one, 1);
    measure(bench, "thousand", (double)job.terms, VALUES, &many, 1);
    py_free(&job.py);
  }
}

/* ------------------------------------------------------------ contact value */
/* The curve of Percus and Yevick up to 1.25 diameters, as thin shells. */
enum { THIN = 250, SAMPLES = 200, SPARSE = 8 };
typedef struct {
  double phi, truth, step;
  double mean[THIN], share[THIN], below[THIN + 1]; /* of g; of the pairs */
  size_t window; /* shells that hold three neighbours */
} Profile;

static void profile_make(Profile *profile, double phi) {
  Py *py = py_alloc(phi);
  double sum = 0;
  profile->phi = phi;
  profile->truth = py_contact(phi);
  profile->step = 0.5 / THIN;
  profile->window = THIN;
  for (int b = 0; b < THIN; b++) {
    double r = 2 + b * profile->step;
    profile->mean[b] = py_mean(py, r, r + profile->step);
    profile->share[b] = profile->mean[b] * pairs_shell(3, r, r + profile->step);
    profile->below[b] = sum;
    sum += profile->share[b];
    if (profile->window == THIN && sum * phi / pack_ball(3, 1) >= 3)
      profile->window = (size_t)b + 1;
  }
  for (int b = 0; b < THIN; b++) {
    profile->share[b] /= sum;
    profile->below[b] /= sum;
  }
  profile->below[THIN] = 1;
  py_free(&py);
}

typedef struct {
  const char *name;
  bool fit;
  double parameter; /* width in radii, or degree */
} Estimator;
static const Estimator estimators[] = {
    {"bin", false, 0.01}, {"bin", false, 0.1}, {"bin", false, 0.5},
    {"fit", true, 1},     {"fit", true, 2},    {"fit", true, 3}};
enum { ESTIMATORS = COUNT(estimators) };

/* The estimate from shares of the pairs, and its noise if they are so many. */
static Contact estimate(const Profile *profile, const Estimator *how,
                        const double share[], double pairs) {
  double g[THIN], variance[THIN], seen = 0, all = 0, volume = 0;
  size_t bins = how->fit ? profile->window
                         : (size_t)(how->parameter / profile->step + 0.5);
  for (size_t b = 0; b < bins; b++) {
    double r = 2 + (double)b * profile->step;
    g[b] = profile->mean[b] * share[b] / profile->share[b];
    variance[b] = g[b] * profile->mean[b] / (pairs * profile->share[b]);
    seen += share[b];
    all += profile->share[b];
    volume += pairs_shell(3, r, r + profile->step);
  }
  if (how->fit)
    return contact_fit(3, g, variance, 2, profile->step, bins,
                       (int)how->parameter);
  double scale = profile->share[0] /
                 (profile->mean[0] * pairs_shell(3, 2, 2 + profile->step));
  return (Contact){.value = seen / (scale * volume),
                   .error = sqrt(all / pairs) / (scale * volume),
                   .window = (double)bins * profile->step / 2};
}

/* Shares of about so many pairs, each drawn by itself: of SPARSE times as many
   chances one in SPARSE is taken, so that their number scatters too. */
static void draw(const Profile *profile, double pairs, Rng *rng,
                 double share[]) {
  memset(share, 0, THIN * sizeof *share);
  for (double c = 0; c < SPARSE * pairs; c++) {
    double u = rng_uniform(rng) * SPARSE;
    if (u >= 1)
      continue;
    size_t low = 0, high = THIN;
    while (high - low > 1) {
      size_t middle = (low + high) / 2;
      if (profile->below[middle] <= u)
        low = middle;
      else
        high = middle;
    }
    share[low] += 1 / pairs;
  }
}

static void sample(const Profile *profile, double pairs, double rms[],
                   double rms_error[]) {
  double share[THIN], square[ESTIMATORS][SAMPLES];
  Rng rng =
      rng_stream(SEED, (uint64_t)(pairs + 1000 * profile->phi), RNG_MEASURE);
  for (size_t s = 0; s < SAMPLES; s++) {
    draw(profile, pairs, &rng, share);
    for (size_t e = 0; e < ESTIMATORS; e++) {
      Contact seen = estimate(profile, estimators + e, share, pairs);
      square[e][s] = gsl_pow_2(seen.value - profile->truth);
    }
  }
  for (size_t e = 0; e < ESTIMATORS; e++) {
    rms[e] = sqrt(gsl_stats_mean(square[e], 1, SAMPLES));
    rms_error[e] =
        gsl_stats_sd(square[e], 1, SAMPLES) / (2 * rms[e] * sqrt(SAMPLES));
  }
}

/* Bias is exact, from the curve itself; noise that of independent pairs. */
static void contact_rows(Bench *bench, Table *table, const Profile *profile,
                         const Estimator *how, const double drawn[],
                         double rms[][ESTIMATORS], double error[][ESTIMATORS],
                         size_t draws) {
  size_t e = (size_t)(how - estimators);
  Contact one = estimate(profile, how, profile->share, 1);
  double truth = profile->truth, bias = (one.value - truth) / truth;
  double noise = one.error / truth;
  for (int k = 6; k <= 16; k++) {
    double pairs = pow(10, 0.5 * k),
           both = gsl_hypot(bias, noise / sqrt(pairs));
    fprintf(table->file, "%s\t%g\t%g\t%.4g\t%.3g\t%.3g\t%.3g", how->name,
            how->parameter, profile->phi, pairs, bias, noise / sqrt(pairs),
            both);
    for (size_t d = 0; d <= draws; d++)
      if (d == draws)
        fputs("\tnan\tnan\n", table->file);
      else if (fabs(drawn[d] / pairs - 1) < 1e-6) {
        fprintf(table->file, "\t%.3g\t%.2g\n", rms[d][e] / truth,
                error[d][e] / truth);
        break;
      }
  }
  say(bench, 100 * bias, 0, "contact_%s_%g_%g_bias", how->name, how->parameter,
      profile->phi);
  for (double percent = 1; percent > 0.05; percent /= 10) {
    double room = gsl_pow_2(0.01 * percent) - bias * bias;
    if (room > 0)
      say(bench, noise * noise / room, 0, "contact_%s_%g_%g_pairs_%g",
          how->name, how->parameter, profile->phi, percent);
  }
}

/* Real packs: is the scatter that of independent pairs, is there a bias that
   the cubic would see, what does a bin lose? */
static void contact_packs(Bench *bench) {
  enum { PACKS = 200 };
  double row[PACKS][4];
  RsaReport report;
  for (size_t k = 0; k < PACKS; k++) {
    Pack *pack = rsa_pack(3, 1000, 0.30, k, &report);
    Contact two = contact_value(pack, 2, 2, 0),
            three = contact_value(pack, 2, 3, 0);
    row[k][0] = two.value;
    row[k][1] = two.error;
    row[k][2] = 100 * (two.value - three.value) / two.value;
    row[k][3] = contact_first_bin(pack, 2, 0.1) - two.value;
    pack_free(&pack);
  }
  double mean[4], error[4];
  for (size_t c = 0; c < 4; c++)
    table_mean(row[0], PACKS, 4, c, mean + c, error + c);
  double ratio = error[0] * sqrt(PACKS) / mean[1];
  say(bench, mean[0], error[0], "contact_packs_value");
  say(bench, ratio, ratio / sqrt(2.0 * PACKS), "contact_packs_noise_ratio");
  say(bench, mean[2], error[2], "contact_packs_cubic_percent");
  say(bench, 100 * mean[3] / mean[0], 100 * error[3] / mean[0],
      "contact_packs_bin_percent");
}

static void contact_operations(Bench *bench) {
  static const double phi[] = {0.30, 0.575}, drawn[] = {1e3, 1e4, 1e5};
  double rms[COUNT(drawn)][ESTIMATORS], error[COUNT(drawn)][ESTIMATORS];
  Table table = begin(
      bench, "contact.tsv",
      "The contact value of the Percus-Yevick curve, relative errors",
      "method\twidth (R) or degree\tphi\tpairs nearer than 1.25 diameters\tbias"
      "\tnoise\trms\trms of 200 samples\tits error");
  Profile profile;
  for (size_t f = 0; f < COUNT(phi); f++) {
    profile_make(&profile, phi[f]);
    for (size_t d = 0; d < COUNT(drawn); d++)
      sample(&profile, drawn[d], rms[d], error[d]);
    for (size_t e = 0; e < ESTIMATORS; e++)
      contact_rows(bench, &table, &profile, estimators + e, drawn, rms, error,
                   COUNT(drawn));
    say(bench, (double)profile.window * profile.step / 2, 0,
        "contact_%g_window", phi[f]);
  }
  end(bench, &table);
  contact_packs(bench);
}

static void contact_bin(void *of) {
  contact_first_bin(of, 2, 0.1);
}

static void contact_fitted(void *of) {
  contact_value(of, 2, 2, 0);
}

static void contact_seconds(Bench *bench) {
  RsaReport report;
  for (size_t n = 1000; n <= 100000; n *= 10) {
    Pack *pack = rsa_pack(3, n, 0.30, 0, &report);
    uint64_t count, all = pairs_count(pack, 2, 0.5, 1, &count);
    const Case cases[] = {{"bin", contact_bin, pack, GSL_NAN},
                          {"fit", contact_fitted, pack, GSL_NAN}};
    measure(bench, "rsa", (double)n, (double)(all + count), cases, 2);
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ neighbours */
static const double NEAR = 1.5; /* at unit density: 14 neighbours */

/* Distances that the half stencil of src/cells.nw looks at. */
static double cells_distances(const Pack *pack, double reach) {
  Cells *cells = cells_alloc(pack, reach);
  Span *span = memory((size_t)cells_spans_most(cells), sizeof *span);
  double sum = 0;
  for (size_t c = 0; c < cells->cells; c++) {
    double own = cells->start[c + 1] - cells->start[c], seen = 0;
    int spans = own > 0 ? cells_spans(cells, c, true, span) : 0;
    for (int s = 0; s < spans; s++)
      seen += span[s].end - span[s].begin;
    sum += own * seen - own * (own + 1) / 2;
  }
  free(span);
  cells_free(&cells);
  return sum;
}

/* The same for the textbook's cells, as wide as the reach or wider. */
static double textbook_distances(const Pack *pack, double reach) {
  int m = (int)(2 * box_reach(&pack->box) / reach);
  double n = (double)pack->n, sum = 0;
  if (m < 3)
    return n * (n - 1) / 2;
  size_t M = (size_t)m, cells = M * M * M;
  double *count = memory(cells, sizeof *count);
  for (size_t i = 0; i < pack->n; i++) {
    size_t c = 0;
    for (int k = 0; k < 3; k++) {
      int at = (int)(pack->x[3 * i + (size_t)k] / pack->box.side[k] * m);
      c = c * M + (size_t)(at < m ? at : m - 1);
    }
    count[c]++;
  }
  for (size_t c = 0; c < cells; c++) {
    size_t x = c / (M * M), y = c / M % M, z = c % M;
    double seen = -1;
    for (size_t q = 0; q < 27; q++)
      seen +=
          count[((x + q / 9 + M - 1) % M * M + (y + q / 3 % 3 + M - 1) % M) *
                    M +
                (z + q % 3 + M - 1) % M];
    sum += count[c] * seen / 2;
  }
  free(count);
  return sum;
}

/* Bins in which our count and that of two plain loops differ. */
static double differences(const Pack *pack) {
  enum { BINS = 20 };
  uint64_t ours[BINS], plain[BINS];
  double differ = 0, step = NEAR / BINS;
  differ += pairs_count(pack, 0, step, BINS, ours) !=
            ref_pairs_all(pack, 0, step, BINS, plain);
  for (int b = 0; b < BINS; b++)
    differ += ours[b] != plain[b];
  return differ;
}

static void neighbours_operations(Bench *bench) {
  Table table =
      begin(bench, "neighbours.tsv",
            "All pairs nearer than 1.5 at unit density: distances computed",
            "N\tall pairs\tcells as wide as the reach\tours\tpairs found");
  double differ = 0, cross[2] = {0, 0}, old[3] = {0, 0, 0};
  /* from 32 points on half the box is more than the reach */
  for (double size = 32; size < 1.1e6; size *= M_SQRT2) {
    size_t n = (size_t)(size + 0.5), at = 0;
    Pack *pack = points(3, n);
    uint64_t found;
    at = pairs_count(pack, 0, NEAR, 1, &found);
    double row[] = {(double)n, (double)n * ((double)n - 1) / 2,
                    textbook_distances(pack, NEAR), cells_distances(pack, NEAR),
                    (double)(found + at)};
    table_row(&table, row, 5);
    for (int m = 0; m < 2; m++)
      if (old[m] > 0 && row[2 + m] < row[1] && cross[m] == 0)
        cross[m] = row[0];
    old[0] = old[1] = 1;
    if (n <= 6000)
      differ += differences(pack);
    if (size * M_SQRT2 > 1.1e6) {
      say(bench, row[1] / row[3], 0, "neighbours_gain");
      say(bench, row[3] / row[2], 0, "neighbours_of_textbook");
      say(bench, row[3] / row[4], 0, "neighbours_per_pair");
    }
    pack_free(&pack);
  }
  say(bench, cross[0], 0, "neighbours_cross_textbook");
  say(bench, cross[1], 0, "neighbours_cross_ours");
  say(bench, differ, 0, "neighbours_differences");
  end(bench, &table);
}

typedef struct {
  const Pack *pack;
  double reach;
  const char *simd;
} PairJob;
enum { PAIR_BINS = 100 };

static void count_ours(void *of) {
  PairJob *job = of;
  uint64_t count[PAIR_BINS];
  if (job->simd)
    setenv("RANDPACK_SIMD", job->simd, 1);
  pairs_count(job->pack, 0, job->reach / PAIR_BINS, PAIR_BINS, count);
  unsetenv("RANDPACK_SIMD");
}

static void count_lists(void *of) {
  PairJob *job = of;
  uint64_t count[PAIR_BINS];
  ref_pairs_lists(job->pack, 0, job->reach / PAIR_BINS, PAIR_BINS, count);
}

static void count_all(void *of) {
  PairJob *job = of;
  uint64_t count[PAIR_BINS];
  ref_pairs_all(job->pack, 0, job->reach / PAIR_BINS, PAIR_BINS, count);
}

static double pairs_within(const Pack *pack, double reach) {
  uint64_t count, below = pairs_count(pack, 0, reach, 1, &count);
  return (double)(below + count);
}

static void neighbours_seconds(Bench *bench) {
  for (size_t n = 32; n <= 1 << 17; n *= 2) {
    Pack *pack = points(3, n);
    PairJob job = {pack, NEAR, NULL};
    const Case cases[] = {{"ours", count_ours, &job, 0},
                          {"plain_lists", count_lists, &job, 0},
                          {"plain_all", count_all, &job, 0}};
    measure(bench, "1.5", (double)n, pairs_within(pack, NEAR), cases,
            n <= 1 << 14 ? 3 : 2);
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ pairs */
static const double FAR = 5; /* at unit density: 524 neighbours */

/* Bins in which any width that this processor has and the plain lists differ. */
static double widths_differ(void) {
  static const char *const width[] = {"default", "avx2", "avx512f"};
  uint64_t ours[PAIR_BINS], plain[PAIR_BINS];
  Pack *pack = points(3, 10000);
  double differ = 0, step = FAR / PAIR_BINS;
  ref_pairs_lists(pack, 0, step, PAIR_BINS, plain);
  for (size_t w = 0; w < COUNT(width); w++) {
    setenv("RANDPACK_SIMD", width[w], 1);
    if (*simd_complaint())
      continue;
    pairs_count(pack, 0, step, PAIR_BINS, ours);
    for (size_t b = 0; b < PAIR_BINS; b++)
      differ += ours[b] != plain[b];
  }
  unsetenv("RANDPACK_SIMD");
  pack_free(&pack);
  return differ;
}

static void pairs_operations(Bench *bench) {
  Pack *pack = points(3, 100000);
  double pairs = pairs_within(pack, FAR);
  say(bench, widths_differ(), 0, "pairs_differences");
  say(bench, cells_distances(pack, FAR) / pairs, 0, "pairs_candidates_ours");
  say(bench, textbook_distances(pack, FAR) / pairs, 0,
      "pairs_candidates_textbook");
  pack_free(&pack);
}

/* The same points in the order of their cells. */
static Pack *in_order(const Pack *pack, double reach) {
  Pack *sorted = points(3, pack->n);
  Cells *cells = cells_alloc(pack, reach);
  for (size_t t = 0; t < pack->n; t++)
    memcpy(sorted->x + 3 * t, pack->x + 3 * (size_t)cells->particle[t],
           3 * sizeof(double));
  cells_free(&cells);
  return sorted;
}

static void pairs_seconds(Bench *bench) {
  static const char *const width[] = {"default", "avx2", "avx512f"};
  for (size_t n = 1000; n <= 1000000; n *= 10) {
    Pack *pack = points(3, n);
    double reach = GSL_MIN(FAR, pairs_reach_limit(pack));
    Pack *sorted = in_order(pack, reach);
    PairJob job[] = {{pack, reach, NULL},
                     {pack, reach, NULL},
                     {pack, reach, NULL},
                     {pack, reach, NULL},
                     {sorted, reach, NULL}};
    Case cases[CASES];
    size_t count = 0;
    for (size_t w = 0; w < 3; w++) {
      setenv("RANDPACK_SIMD", job[w].simd = width[w], 1);
      if (!*simd_complaint())
        cases[count++] = (Case){width[w], count_ours, job + w, 0};
    }
    unsetenv("RANDPACK_SIMD");
    /* through a million particles in no order the lists take minutes */
    if (n < 1000000) {
      cases[count++] = (Case){"plain_lists", count_lists, job + 3, 0};
      cases[count++] = (Case){"plain_sorted", count_lists, job + 4, 0};
    }
    measure(bench, "5", (double)n, pairs_within(pack, reach), cases, count);
    pack_free(&sorted);
    pack_free(&pack);
  }
}

/* ------------------------------------------------------------ two sizes */
/* Three parts of the volume coarse, one fine; the large radius is 1. */
enum { PARTIAL_BINS = 25, COARSE = 3 };
static const double FILLED = 0.3;
static const double TWICE = 2; /* pairs up to so many times a_k + a_m */
static const double partial_lambda[] = {1, 0.5, 0.313, 0.1};

/* Points with labels, in the volume that such spheres would fill by FILLED. */
static Pack *two_points(size_t n, double lambda) {
  const double cube[] = {1, 1, 1};
  double coarse = COARSE * lambda * lambda * lambda;
  size_t large = (size_t)((double)n * coarse / (1 + coarse) + 0.5);
  Species two[] = {{"A", 1, large}, {"B", lambda, n - large}};
  double solid = (double)large * pack_ball(3, 1) +
                 (double)(n - large) * pack_ball(3, lambda);
  Box box = box_make(3, cube, solid / FILLED);
  Pack *pack = pack_alloc(&box, two, 2, false);
  Rng rng = rng_stream(SEED, n, RNG_POSITIONS);
  for (size_t i = 0; i < n; i++)
    for (int k = 0; k < 3; k++)
      pack->x[3 * i + (size_t)k] = rng_uniform(&rng) * box.side[k];
  return pack;
}

static double two_reach(const Pack *pack, int k, int m) {
  return TWICE * (pack->species[k].radius + pack->species[m].radius);
}

static bool two_fit(const Pack *pack) {
  return two_reach(pack, 0, 0) <= pairs_reach_limit(pack);
}

static Partials *two_partials(const Pack *pack) {
  return partials_alloc(pack, PARTIAL_BINS, (TWICE - 1) / PARTIAL_BINS,
                        PARTIALS_COMMON);
}

/* Distances from guests to the hosts in the spans around them. */
static double guests_distances(const Pack *few, const Pack *many,
                               double reach) {
  Cells *cells = cells_alloc(many, reach);
  Span *span = memory((size_t)cells_spans_most(cells), sizeof *span);
  double sum = 0;
  for (size_t i = 0; i < few->n; i++) {
    int spans =
        cells_spans(cells, cells_at(cells, few->x + 3 * i), false, span);
    for (int s = 0; s < spans; s++)
      sum += span[s].end - span[s].begin;
  }
  free(span);
  cells_free(&cells);
  return sum;
}

static double partials_distances(const Pack *pack, const Partials *partials) {
  const Pack *large = partials->only[0], *small = partials->only[1];
  const Pack *few = large->n < small->n ? large : small;
  return cells_distances(large, two_reach(pack, 0, 0)) +
         cells_distances(small, two_reach(pack, 1, 1)) +
         guests_distances(few, few == large ? small : large,
                          two_reach(pack, 0, 1));
}

static double partials_counted(const Partials *partials) {
  double sum = 0;
  for (int k = 0; k < 2; k++)
    for (int m = 0; m <= k; m++) {
      const PartialsPair *pair = partials_pair(partials, k, m);
      sum += (double)pair->below;
      for (size_t b = 0; b < pair->bins; b++)
        sum += (double)pair->count[b];
    }
  return sum;
}

/* Counts in which ours and those of the plain program differ. */
static double partials_differ(const Pack *pack) {
  Partials *ours = two_partials(pack), *plain = two_partials(pack);
  double differ = 0;
  partials_count(ours);
  ref_pairs_species(pack, plain);
  for (int k = 0; k < 2; k++)
    for (int m = 0; m <= k; m++) {
      const PartialsPair *a = partials_pair(ours, k, m);
      const PartialsPair *b = partials_pair(plain, k, m);
      differ += a->below != b->below;
      for (size_t bin = 0; bin < a->bins; bin++)
        differ += a->count[bin] != b->count[bin];
    }
  partials_free(&ours);
  partials_free(&plain);
  return differ;
}

static void partials_operations(Bench *bench) {
  static const double lambda[] = {1, 0.7, 0.5, 0.4, 0.313, 0.2, 0.1};
  Table table = begin(
      bench, "partials.tsv", "Candidates a pair counted, two sizes, N = 100000",
      "lambda\tours\tone reach for all\tpairs of species counted");
  double differ = 0;
  for (size_t l = 0; l < COUNT(lambda); l++) {
    Pack *pack = two_points(100000, lambda[l]);
    Partials *partials = two_partials(pack);
    partials_count(partials);
    double counted = partials_counted(partials);
    double ours = partials_distances(pack, partials) / counted;
    double plain = textbook_distances(pack, two_reach(pack, 0, 0)) / counted;
    table_row(&table, (double[]){lambda[l], ours, plain, counted}, 4);
    say(bench, ours, 0, "partials_%g_ours", lambda[l]);
    say(bench, plain, 0, "partials_%g_plain", lambda[l]);
    partials_free(&partials);
    pack_free(&pack);
    pack = two_points(10000, lambda[l]);
    differ += two_fit(pack) ? partials_differ(pack) : 0;
    pack_free(&pack);
  }
  say(bench, differ, 0, "partials_differences");
  end(bench, &table);
}

typedef struct {
  const Pack *pack;
  Partials *partials;
  const char *simd;
} PartialJob;

static void species_ours(void *of) {
  PartialJob *job = of;
  if (job->simd)
    setenv("RANDPACK_SIMD", job->simd, 1);
  Partials *partials = two_partials(job->pack);
  partials_count(partials);
  partials_free(&partials);
  unsetenv("RANDPACK_SIMD");
}

static void species_plain(void *of) {
  PartialJob *job = of;
  ref_pairs_species(job->pack, job->partials);
}

/* The kernel for one species, which asks nobody for a name. */
static void species_none(void *of) {
  PartialJob *job = of;
  uint64_t count[PARTIAL_BINS];
  pairs_count(job->pack, 2, 2 * (TWICE - 1) / PARTIAL_BINS, PARTIAL_BINS,
              count);
}

/* The same points, with their labels, in the order of their cells. */
static Pack *two_in_order(const Pack *pack) {
  Pack *sorted = pack_copy(pack);
  Cells *cells = cells_alloc(pack, two_reach(pack, 0, 0));
  for (size_t t = 0; t < pack->n; t++) {
    size_t i = cells->particle[t];
    memcpy(sorted->x + 3 * t, pack->x + 3 * i, 3 * sizeof(double));
    sorted->kind[t] = pack->kind[i];
  }
  cells_free(&cells);
  return sorted;
}

static void partials_case(Bench *bench, size_t n, double lambda) {
  char label[16];
  Pack *pack = two_points(n, lambda);
  if (two_fit(pack)) {
    Pack *sorted = two_in_order(pack);
    Partials *partials = two_partials(pack);
    partials_count(partials);
    double counted = partials_counted(partials);
    PartialJob ours = {pack, NULL, NULL}, narrow = {pack, NULL, "default"},
               plain = {sorted, partials, NULL};
    const Case cases[] = {{"ours", species_ours, &ours, 0},
                          {"default", species_ours, &narrow, 0},
                          {"plain_sorted", species_plain, &plain, 0},
                          {"one", species_none, &ours, 0}};
    snprintf(label, sizeof label, "%g", lambda);
    measure(bench, label, (double)n, counted, cases, lambda < 1 ? 3 : 4);
    partials_free(&partials);
    pack_free(&sorted);
  }
  pack_free(&pack);
}

static void partials_seconds(Bench *bench) {
  static const size_t size[] = {125, 250, 500, 2000, 10000, 100000};
  for (size_t l = 0; l < COUNT(partial_lambda); l++)
    for (size_t s = 0; s < COUNT(size); s++)
      if (partial_lambda[l] > 0.2 || size[s] < 100000)
        partials_case(bench, size[s], partial_lambda[l]);
}

/* ------------------------------------------------------------ their curves */
static void two_species(MixtureSpecies two[2], double lambda, double phi) {
  const double share[] = {COARSE, 1};
  two[0].radius = 1;
  two[1].radius = lambda;
  mixture_fill(two, 2, share, phi);
}

/* The largest distance in R = 2r/(a_k + a_m) beyond contact of the window of
   src/partials.nw, or of that for one size. */
static double two_widest(const MixtureSpecies two[2], size_t k, size_t m,
                         bool one_size) {
  double up = 0, down = 0;
  for (size_t s = 0; s < 2; s++) {
    up += two[s].density * gsl_pow_3(two[s].radius);
    down += two[s].density * gsl_pow_2(two[s].radius);
  }
  double a = two[k].radius, b = two[m].radius;
  double least = GSL_MIN(GSL_MIN(a, b), up / down);
  return one_size ? 0.5 : least / (a + b);
}

/* The m that the window about a k must hold. */
static double two_wanted(const MixtureSpecies two[2], size_t k, size_t m,
                         bool one_size) {
  double S = 0, half = 0.5 * (two[k].radius + two[m].radius);
  for (size_t s = 0; s < 2; s++)
    S += two[s].density * gsl_pow_2(two[s].radius);
  return one_size ? 3 : 3 * two[m].density * gsl_pow_2(half) / S;
}

/* g_km as a Profile, in R, with the window of partials_contact. */
static void two_profile(Profile *profile, const MixtureSpecies two[2],
                        const Mixture *mixture, size_t k, size_t m,
                        bool one_size) {
  double half = 0.5 * (two[k].radius + two[m].radius), sum = 0;
  profile->truth = mixture_contact(MIXTURE_PY, two, 2, k, m);
  profile->step = 0.5 / THIN;
  profile->window =
      (size_t)(two_widest(two, k, m, one_size) / profile->step + 0.5);
  for (int b = 0; b < THIN; b++) {
    double r = 2 + b * profile->step, next = r + profile->step;
    profile->mean[b] = mixture_mean(mixture, k, m, half * r, half * next);
    profile->share[b] = profile->mean[b] * pairs_shell(3, r, next);
    profile->below[b] = sum;
    sum += profile->share[b];
    if ((size_t)b + 1 < profile->window &&
        sum * gsl_pow_3(half) * two[m].density >=
            two_wanted(two, k, m, one_size))
      profile->window = (size_t)b + 1;
  }
  for (int b = 0; b < THIN; b++)
    profile->share[b] /= sum;
}

/* A method's bias, the pairs that it takes for one percent, and its error
   against pairs of these species nearer than 1.25 (a_k + a_m). */
static void two_rows(Bench *bench, Table *table, const Profile *profile,
                     const char *name, const char *method,
                     const Estimator *how) {
  Contact one = estimate(profile, how, profile->share, 1);
  double bias = one.value / profile->truth - 1;
  double noise = one.error / profile->truth;
  say(bench, 100 * bias, 0, "mixture_%s_%g_%s_%g_bias", name, profile->phi,
      method, how->parameter);
  if (fabs(bias) < 0.01)
    say(bench, noise * noise / (1e-4 - bias * bias), 0,
        "mixture_%s_%g_%s_%g_pairs", name, profile->phi, method,
        how->parameter);
  for (int p = 4; p <= 18; p++) {
    double pairs = pow(10, 0.5 * p), random = noise / sqrt(pairs);
    fprintf(table->file, "%s\t%g\t%s\t%g\t%.4g\t%.3g\t%.3g\t%.3g\n", name,
            profile->phi, method, how->parameter, pairs, bias, random,
            gsl_hypot(bias, random));
  }
}

/* "wide" is the parabola over the window of one size. */
static void two_contact(Bench *bench, Table *table, const Mixture *mixture,
                        const MixtureSpecies two[2], double phi, size_t k,
                        size_t m) {
  static const Estimator parabola = {"fit", true, 2};
  Profile profile = {.phi = phi};
  char name[8];
  snprintf(name, sizeof name, "%c%c", '1' + (char)k, '1' + (char)m);
  two_profile(&profile, two, mixture, k, m, true);
  two_rows(bench, table, &profile, name, "wide", &parabola);
  say(bench, (double)profile.window * profile.step / 2, 0,
      "mixture_%s_%g_widest", name, phi);
  two_profile(&profile, two, mixture, k, m, false);
  say(bench, (double)profile.window * profile.step / 2, 0,
      "mixture_%s_%g_window", name, phi);
  for (size_t e = 0; e < ESTIMATORS; e++)
    two_rows(bench, table, &profile, name, estimators[e].name, estimators + e);
}

static void two_contacts(Bench *bench) {
  static const double phi[] = {0.3, 0.5};
  Table table = begin(
      bench, "mixture-contact.tsv",
      "Contact values of the Percus-Yevick mixture, lambda = .313, relative",
      "pair\tphi\tmethod\twidth (R) or degree\tpairs nearer than 1.25 contact "
      "distances\tbias\tnoise\trms");
  MixtureSpecies two[2];
  for (size_t f = 0; f < COUNT(phi); f++) {
    two_species(two, 0.313, phi[f]);
    Mixture *mixture = mixture_alloc(two, 2, 2.6, 0);
    for (size_t k = 0; k < 2; k++)
      for (size_t m = k; m < 2; m++)
        two_contact(bench, &table, mixture, two, phi[f], k, m);
    mixture_free(&mixture);
  }
  end(bench, &table);
}

enum {
  FAR_OUT = 8,
  LOOKS = 400,
  FEW_LOOKS = 20,
  FINEST = 16,
  MOST_POINTS = 128
};
static const double DENSE = 0.575;
static const size_t fineness[] = {1, 2, 4, 8};

/* Two sizes, the truth about them, and the errors of a program; of g, over the
   largest contact value. */
typedef struct {
  double lambda, reach;
  MixtureSpecies two[2];
  Mixture *finest; /* NULL: one size, whose curve is known in 113 bits */
} Curves;

static Curves curves_make(double lambda) {
  Curves curves = {.lambda = lambda, .reach = FAR_OUT};
  two_species(curves.two, lambda, DENSE);
  if (lambda < 1)
    curves.finest = mixture_alloc(curves.two, 2, FAR_OUT, FINEST);
  return curves;
}

static void curves_free(Curves *curves) {
  if (curves->finest)
    mixture_free(&curves->finest);
}

static double curves_off(const Curves *curves, size_t i, size_t j, double r,
                         double g) {
  double largest = mixture_contact(MIXTURE_PY, curves->two, 2, 0, 0);
  return (curves->finest ? fabs(g - mixture_g(curves->finest, i, j, r))
                         : ref_py_error(DENSE, r, g)) /
         largest;
}

/* The arithmetic ends, after so many sums, near 1e-14. */
static double curves_shown(double error) {
  return error > 1e-14 ? error : 1e-14;
}

static double curves_ours(const Curves *curves, const Mixture *mixture) {
  int looks = curves->finest ? LOOKS : FEW_LOOKS;
  double worst = 0;
  for (size_t i = 0; i < 2; i++)
    for (size_t j = i; j < 2; j++)
      for (int q = 0; q < looks; q++) {
        double from = curves->two[i].radius + curves->two[j].radius;
        double r = from + (curves->reach - from) * (q + 0.5) / looks;
        worst = fmax(worst,
                     curves_off(curves, i, j, r, mixture_g(mixture, i, j, r)));
      }
  return curves_shown(worst);
}

static double curves_plain(const Curves *curves, size_t points) {
  double *f = ref_mixture(curves->two, 2, FAR_OUT, points), worst = 0;
  size_t n = ref_mixture_n(curves->two, 2, FAR_OUT, points);
  double h = 2 * curves->lambda / (double)points;
  size_t every = curves->finest ? 1 : n / FEW_LOOKS + 1;
  for (size_t p = 1; p < n; p += every)
    for (size_t q = 0; q < 4; q++) {
      size_t i = q / 2, j = q % 2;
      double r = curves->two[i].radius + curves->two[j].radius + h * (double)p;
      if (r <= FAR_OUT)
        worst = fmax(worst, curves_off(curves, i, j, r, f[4 * p + q] / r));
    }
  free(f);
  return worst;
}

/* The plain grid wants diameters that are multiples of the smaller one. */
static bool curves_even(double lambda) {
  return fabs(1 / lambda - floor(1 / lambda + 0.5)) < 1e-9;
}

/* What the default is for: mostly fine, a hundred times smaller. */
static void fine_errors(Bench *bench) {
  const double share[] = {0.1, 1}, reach = 2.6;
  MixtureSpecies two[] = {{1, 0}, {0.01, 0}};
  mixture_fill(two, 2, share, 0.6);
  Curves curves = {.lambda = 0.01,
                   .two = {two[0], two[1]},
                   .reach = reach,
                   .finest = mixture_alloc(two, 2, reach, 8)};
  for (size_t fine = 2; fine <= 4; fine *= 2) {
    Mixture *mixture = mixture_alloc(two, 2, reach, fine);
    say(bench, curves_ours(&curves, mixture), 0, "mixture_fine_%zu_error",
        fine);
    mixture_free(&mixture);
  }
  curves_free(&curves);
}

static void mixture_operations(Bench *bench) {
  Table table =
      begin(bench, "mixture.tsv", "The Percus-Yevick mixture: worst error",
            "method\tlambda\telements, or points, to the smallest diameter\t"
            "error of g over the largest contact value");
  two_contacts(bench);
  for (size_t l = 0; l < COUNT(partial_lambda); l++) {
    Curves curves = curves_make(partial_lambda[l]);
    for (size_t f = 0; f < COUNT(fineness); f++) {
      Mixture *mixture = mixture_alloc(curves.two, 2, FAR_OUT, fineness[f]);
      double error = curves_ours(&curves, mixture);
      fprintf(table.file, "ours\t%g\t%zu\t%.2g\n", curves.lambda, fineness[f],
              error);
      say(bench, error, 0, "mixture_%g_%zu_error", curves.lambda, fineness[f]);
      mixture_free(&mixture);
    }
    for (size_t points = 8; curves_even(curves.lambda) && points <= MOST_POINTS;
         points *= 2) {
      double error = curves_plain(&curves, points);
      fprintf(table.file, "plain\t%g\t%zu\t%.2g\n", curves.lambda, points,
              error);
      say(bench, error, 0, "mixture_%g_plain_%zu_error", curves.lambda, points);
    }
    curves_free(&curves);
  }
  fine_errors(bench);
  end(bench, &table);
}

typedef struct {
  const Curves *curves;
  size_t fine;
  Mixture *mixture;
  double sum;
} CurveJob;

static void curves_prepare(void *of) {
  CurveJob *job = of;
  Mixture *mixture = mixture_alloc(job->curves->two, 2, FAR_OUT, job->fine);
  job->sum += mixture_g(mixture, 0, 1, 3);
  mixture_free(&mixture);
}

static void curves_values(void *of) {
  CurveJob *job = of;
  for (int k = 0; k < VALUES; k++)
    job->sum += mixture_g(job->mixture, 0, 1, 2 + 6.0 / VALUES * k);
}

static void curves_trapezoid(void *of) {
  CurveJob *job = of;
  double *f = ref_mixture(job->curves->two, 2, FAR_OUT, job->fine);
  job->sum += f[0];
  free(f);
}

/* The plain program has labels of its own: its points are no elements. */
static void curves_seconds(Bench *bench, const Curves *curves) {
  char label[32];
  for (size_t f = 0; f < COUNT(fineness); f++) {
    CurveJob job = {curves, fineness[f], NULL, 0};
    job.mixture = mixture_alloc(curves->two, 2, FAR_OUT, job.fine);
    double error = curves_ours(curves, job.mixture);
    const Case one = {"ours", curves_prepare, &job, error},
               many = {"ours", curves_values, &job, error};
    snprintf(label, sizeof label, "%g", curves->lambda);
    measure(bench, label, (double)job.fine, 1, &one, 1);
    snprintf(label, sizeof label, "values-%g", curves->lambda);
    if (job.fine == 4)
      measure(bench, label, (double)job.fine, VALUES, &many, 1);
    mixture_free(&job.mixture);
  }
  for (size_t points = 8; curves_even(curves->lambda) && points <= MOST_POINTS;
       points *= 2) {
    CurveJob job = {curves, points, NULL, 0};
    const Case plain = {"plain_trapezoid", curves_trapezoid, &job,
                        curves_plain(curves, points)};
    snprintf(label, sizeof label, "points-%g", curves->lambda);
    measure(bench, label, (double)points, 1, &plain, 1);
  }
}

static void mixture_seconds(Bench *bench) {
  for (size_t l = 0; l < COUNT(partial_lambda); l++) {
    Curves curves = curves_make(partial_lambda[l]);
    curves_seconds(bench, &curves);
    curves_free(&curves);
  }
}

/* ------------------------------------------------------------ laws of sizes */
typedef struct {
  Sizes law;
  size_t n;
  double *radius;
} SizesJob;

static void sizes_radii(void *of) {
  SizesJob *job = of;
  sizes_fill(&job->law, job->n, job->radius);
}

static void sizes_seconds(Bench *bench) {
  static const double size[] = {0.1, 0.2, 0.5, 1, 2},
                      passing[] = {0, 10, 40, 90, 100};
  const Sizes law[] = {
      {SIZES_LOGNORMAL, 3, 1, 0.3, 0, 0, INFINITY, 0, NULL, NULL},
      {SIZES_POWER, 3, 0, 0, 0.5, 0.1, 1, 0, NULL, NULL},
      {SIZES_SIEVE, 3, 0, 0, 0, 0, 0, 5, size, passing}};
  static const char *const name[] = {"lognormal", "power", "sieve"};
  for (size_t l = 0; l < COUNT(law); l++) {
    SizesJob job = {law[l], 10000, memory(10000, sizeof(double))};
    Outcome out = {0};
    assert(sizes_check(&job.law, &out) == DONE);
    const Case one = {"ours", sizes_radii, &job, GSL_NAN};
    measure(bench, name[l], (double)job.n, (double)job.n, &one, 1);
    free(job.radius);
  }
}

/* ------------------------------------------------------------ rsa */
static const double rsa_deficit[] = {0.2, 0.1, 0.05, 0.02, 0.01, 0.005};
enum { RSA_BALLS = 10000 };

/* Saturation from this many balls' volume of box, and that of all of them. */
static double saturate(int dim, size_t n, uint64_t k, RsaReport *report) {
  const double cube[] = {1, 1, 1};
  Species one = {"A", 1, 0};
  double near = dim == 2 ? 0.547 : 0.384; /* sets the size of the box only */
  Box box = box_make(dim, cube, (double)n * pack_ball(dim, 1) / near);
  Rng rng = rng_stream(SEED + n, k, RNG_POSITIONS);
  Pack *pack = rsa_saturate(&box, &one, 1, NULL, 0, &rng, report);
  double fraction = pack_fraction(pack);
  assert(report->saturated);
  pack_free(&pack);
  return fraction;
}

/* What is missing from saturation after so much work, one by one and ours. */
static void rsa_approach(Bench *bench, Table *table, int dim, size_t packs) {
  double sum[RSA_CURVE] = {0}, limit = 0, work = 0, attempts = 0, trials = 0;
  int curve = RSA_CURVE;
  RsaReport report;
  for (size_t k = 0; k < packs; k++) {
    double fraction = saturate(dim, RSA_BALLS, k, &report);
    limit += fraction / (double)packs;
    work += (double)(report.trials + report.tests) / (double)report.placed;
    trials += (double)report.trials / (double)report.placed;
    attempts += report.attempts / (double)report.placed;
    curve = GSL_MIN(curve, report.curve_n);
    for (int c = 0; c < curve; c++)
      sum[c] += fraction - report.curve_fraction[c];
  }
  for (int c = 0; c < curve; c++) {
    double missing = sum[c] / (double)packs, time = report.curve_time[c];
    if (missing > 1e-4)
      fprintf(table->file, "naive\t%d\t%.4g\t%.4g\n", dim,
              time / (limit - missing), missing);
  }
  for (size_t d = 0; d < COUNT(rsa_deficit); d++) {
    size_t n = (size_t)(RSA_BALLS * (1 - rsa_deficit[d] / limit));
    Pack *pack = rsa_pack(dim, n, limit - rsa_deficit[d], 7, &report);
    fprintf(table->file, "ours\t%d\t%.4g\t%.4g\n", dim,
            (double)(report.trials + report.tests) / (double)n, rsa_deficit[d]);
    pack_free(&pack);
  }
  fprintf(table->file, "ours\t%d\t%.4g\t0\n", dim, work / (double)packs);
  say(bench, work / (double)packs, 0, "rsa_%d_work", dim);
  say(bench, trials / (double)packs, 0, "rsa_%d_trials", dim);
  say(bench, attempts / (double)packs, 0, "rsa_%d_attempts", dim);
}

/* Do the attempts that our trials stand for agree with those of a program that
   makes them? */
static void rsa_honest(Bench *bench, int dim, double fraction) {
  enum { PACKS = 40 };
  double row[PACKS][2], mean[2], error[2];
  RsaReport report;
  for (size_t k = 0; k < PACKS; k++) {
    Pack *pack = rsa_pack(dim, 1000, fraction, k, &report);
    Rng rng = rng_stream(SEED, k, RNG_TEST);
    row[k][0] = report.attempts / 1000;
    row[k][1] = (double)ref_rsa_fill(pack, &rng, UINT64_MAX) / 1000;
    pack_free(&pack);
  }
  for (size_t c = 0; c < 2; c++)
    table_mean(row[0], PACKS, 2, c, mean + c, error + c);
  say(bench, mean[0], error[0], "rsa_%d_attempts_ours", dim);
  say(bench, mean[1], error[1], "rsa_%d_attempts_plain", dim);
}

/* The error of the mean saturation fraction from several packs of one size. */
static void rsa_limit(Bench *bench, Table *table, int dim, size_t total) {
  static const size_t size[] = {100, 1000, 10000};
  double *fraction[3], truth = 0, trials = 0, placed = 0;
  RsaReport report;
  for (size_t s = 3; s-- > 0;) {
    size_t packs = total / size[s];
    double mean, error;
    fraction[s] = memory(packs, sizeof(double));
    for (size_t k = 0; k < packs; k++) {
      fraction[s][k] = saturate(dim, size[s], k, &report);
      trials += (double)report.trials;
      placed += (double)report.placed;
    }
    table_mean(fraction[s], packs, 1, 0, &mean, &error);
    say(bench, mean, error, "rsa_%d_limit_%zu", dim, size[s]);
    double spread = error * sqrt((double)total);
    say(bench, spread, spread / sqrt(2.0 * (double)packs), "rsa_%d_spread_%zu",
        dim, size[s]);
    truth += mean / 3;
  }
  for (size_t s = 0; s < 3; s++) {
    for (size_t block = 1; total / size[s] / block >= 8; block *= 4) {
      size_t blocks = total / size[s] / block;
      double square = 0;
      for (size_t b = 0; b < blocks; b++) {
        double mean = gsl_stats_mean(fraction[s] + b * block, 1, block);
        square += gsl_pow_2(mean - truth) / (double)blocks;
      }
      fprintf(table->file, "%d\t%zu\t%zu\t%.4g\t%.3g\t%.2g\n", dim, size[s],
              size[s] * block, (double)(size[s] * block) * trials / placed,
              sqrt(square), sqrt(square / (2 * (double)blocks)));
    }
    free(fraction[s]);
  }
}

static void rsa_operations(Bench *bench) {
  Table table = begin(bench, "rsa.tsv",
                      "RSA: what is missing from saturation against work",
                      "method\tdimension\tattempts, or trials and tests, a "
                      "particle\tmissing fraction");
  rsa_approach(bench, &table, 2, 16);
  rsa_approach(bench, &table, 3, 4);
  end(bench, &table);
  rsa_honest(bench, 2, 0.45);
  rsa_honest(bench, 3, 0.30);
  table = begin(
      bench, "saturation.tsv", "RSA: rms error of the mean saturation fraction",
      "dimension\tparticles a pack, about\tparticles in all\ttrials in "
      "all\trms error\tits error");
  rsa_limit(bench, &table, 2, 400000);
  rsa_limit(bench, &table, 3, 100000);
  end(bench, &table);
}

typedef struct {
  int dim;
  size_t n;
  double fraction;
} RsaJob;

static void rsa_ours(void *of) {
  RsaJob *job = of;
  RsaReport report;
  Pack *pack = rsa_pack(job->dim, job->n, job->fraction, 7, &report);
  pack_free(&pack);
}

static void rsa_plain(void *of) {
  RsaJob *job = of;
  Rng rng = rng_stream(SEED, 7, RNG_POSITIONS);
  Pack *pack =
      unit_balls(job->dim, job->n,
                 (double)job->n * pack_ball(job->dim, 1) / job->fraction);
  ref_rsa_fill(pack, &rng, UINT64_MAX);
  pack_free(&pack);
}

static void rsa_full(void *of) {
  RsaJob *job = of;
  RsaReport report;
  saturate(job->dim, job->n, 7, &report);
}

static void rsa_seconds(Bench *bench) {
  static const char *const name[] = {"discs", "spheres"};
  for (int dim = 2; dim <= 3; dim++) {
    double limit = dim == 2 ? 0.547 : 0.384; /* which deficits to time */
    for (size_t d = 0; d < COUNT(rsa_deficit); d++) {
      RsaJob job = {dim, RSA_BALLS, limit - rsa_deficit[d]};
      const Case cases[] = {{"ours", rsa_ours, &job, rsa_deficit[d]},
                            {"plain_trials", rsa_plain, &job, rsa_deficit[d]}};
      char label[32];
      snprintf(label, sizeof label, "%s-%g", name[dim - 2], rsa_deficit[d]);
      /* one by one, the last tenths of a percent take minutes */
      measure(bench, label, RSA_BALLS, RSA_BALLS, cases,
              rsa_deficit[d] > (dim == 2 ? 0.006 : 0.015) ? 2 : 1);
    }
    for (size_t n = 1000; n <= 100000; n *= 10) {
      RsaJob job = {dim, n, 0};
      const Case cases[] = {{"ours", rsa_full, &job, 0}};
      char label[32];
      snprintf(label, sizeof label, "%s-saturated", name[dim - 2]);
      measure(bench, label, (double)n, (double)n, cases, 1);
    }
  }
}

/* ------------------------------------------------------------ growth */
/* A pack grown from random points; of two sizes if so many are of the other,
   of this ratio. */
static Pack *crm_try(size_t n, size_t other, double ratio, double fraction,
                     double gamma, uint64_t k, CrmReport *report,
                     Outcome *out) {
  const double cube[] = {1, 1, 1};
  Species kind[] = {{"A", 1, n - other}, {"B", ratio, other}};
  double solid = (double)(n - other) * pack_ball(3, 1) +
                 (double)other * pack_ball(3, ratio);
  Box box = box_make(3, cube, solid / fraction);
  Pack *pack = pack_alloc(&box, kind, other ? 2 : 1, false);
  Rng rng = rng_stream(SEED, n * 1000 + k, RNG_POSITIONS);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL,
                  .rate = gamma,
                  .fraction = fraction,
                  .points = true};
  for (size_t c = 0; c < 3 * n; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[c % 3];
  crm_grow(pack, &plan, &rng, report, out);
  return pack;
}

/* One that is known to arrive. */
static Pack *crm_pack(size_t n, double fraction, double gamma, uint64_t k,
                      CrmReport *report) {
  Outcome out = {0};
  Pack *pack = crm_try(n, 0, 1, fraction, gamma, k, report, &out);
  assert(out.status == DONE);
  return pack;
}

/* The same at rest from growth for so many collisions a particle. */
static Engine *crm_engine(const Pack *pack, uint64_t k) {
  Engine *engine = engine_alloc(pack, MOTION_EQUAL, 0);
  Rng rng = rng_stream(SEED, k, RNG_VELOCITIES);
  motion_stir(engine->motion, engine->order, &rng);
  engine->motion->size = 1;
  engine_sync(engine, 0, 1);
  return engine;
}

/* Collisions, with a sync after every N; the time that they took. */
static double crm_run(Engine *engine, double collisions) {
  double time = 0;
  for (uint64_t left = (uint64_t)(collisions + 0.5); left > 0;) {
    uint64_t part = GSL_MIN(left, engine->motion->n);
    engine_run(engine, GSL_POSINF, part);
    time += engine->now;
    engine_sync(engine, engine->now, 1);
    left -= part;
  }
  return time;
}

static const double CRM_PHI = 0.49, CRM_FAST = 0.5;
enum { CRM_N = 1000, CRM_BLOCKS = 128, CRM_EACH = 8, CRM_CHAINS = FEW(16) };

/* The contact value from the collisions of so long a time. */
static double crm_contact(const Engine *engine, double virial, double time) {
  const Motion *motion = engine->motion;
  double scale = 3 * (double)motion->n * motion_temperature(motion) * time;
  return virial / scale / (4 * CRM_PHI);
}

static const char *const crm_method[] = {"wide", "thin", "fit", "rate"};
enum { CRM_METHODS = COUNT(crm_method) };

/* Estimates from the first 1, 2, 4 ... blocks of a run in equilibrium; a block
   ends with a look at the places. */
static void crm_chain(uint64_t k, double seen[][CRM_METHODS]) {
  CrmReport report;
  Pack *pack = crm_pack(CRM_N, CRM_PHI, 0.3, k, &report);
  Engine *engine = crm_engine(pack, k);
  crm_run(engine, 100.0 / 2 * CRM_N);
  double sum[3] = {0, 0, 0}, time = 0;
  engine->motion->virial = 0;
  for (int b = 1, row = 0; b <= CRM_BLOCKS; b++) {
    time += crm_run(engine, CRM_EACH / 2.0 * CRM_N);
    engine_store(engine, pack);
    double a = pack_largest(pack);
    sum[0] += contact_first_bin(pack, 2 * a, 0.1 * a);
    sum[1] += contact_first_bin(pack, 2 * a, 0.01 * a);
    sum[2] += contact_value(pack, 2 * a, 2, 0).value;
    if ((b & (b - 1)) != 0)
      continue;
    for (int m = 0; m < 3; m++)
      seen[row][m] = sum[m] / b;
    seen[row++][3] = crm_contact(engine, engine->motion->virial, time);
  }
  engine_free(&engine);
  pack_free(&pack);
}

/* Relative to the truth, in percent: the bias of so many values, its error. */
static void crm_bias(const double value[], size_t n, size_t stride,
                     double *bias, double *error) {
  double truth = theory_contact(THEORY_SCHULTZ, CRM_PHI);
  table_mean(value, n, stride, 0, bias, error);
  *bias = 100 * (*bias / truth - 1);
  *error *= 100 / truth;
}

static void crm_estimators(Bench *bench) {
  enum { ROWS_SEEN = 8 };
  static double seen[CRM_CHAINS][ROWS_SEEN][CRM_METHODS];
  Table table = begin(bench, "crm-contact.tsv",
                      "The contact value at .49 from one run at rest, percent",
                      "method\tcollisions a particle\tbias\tits "
                      "error\tscatter\tits error\trms");
  for (size_t k = 0; k < CRM_CHAINS; k++)
    crm_chain(k, seen[k]);
  for (size_t m = 0; m < CRM_METHODS; m++) {
    double bias, error, scatter = 0, best = 0;
    for (int row = 0; row < ROWS_SEEN; row++) {
      double spent = CRM_EACH * (double)(1 << row);
      crm_bias(seen[0][row] + m, CRM_CHAINS, ROWS_SEEN * CRM_METHODS, &bias,
               &error);
      scatter = error * sqrt(CRM_CHAINS);
      double rms = gsl_hypot(bias, scatter);
      fprintf(table.file, "%s\t%g\t%.3g\t%.2g\t%.3g\t%.2g\t%.3g\n",
              crm_method[m], spent, bias, error, scatter,
              scatter / sqrt(2.0 * CRM_CHAINS), rms);
      if (row == 0)
        say(bench, scatter, scatter / sqrt(2.0 * CRM_CHAINS),
            "crm_%s_scatter_short", crm_method[m]);
      if (best == 0 && rms < 1)
        say(bench, best = spent, 0, "crm_%s_percent", crm_method[m]);
    }
    say(bench, bias, error, "crm_%s_bias", crm_method[m]);
    say(bench, scatter, scatter / sqrt(2.0 * CRM_CHAINS), "crm_%s_scatter",
        crm_method[m]);
  }
  end(bench, &table);
}

/* The contact value by extrapolation: right after landing at a rate of growth,
   and of the fastest after a rest. */
enum { CRM_PACKS = FEW(48), CRM_RESTS = 7 };

static void crm_row(Bench *bench, const Table *table, const char *how,
                    double parameter, double spent, const double value[],
                    size_t packs, size_t stride) {
  double bias, error;
  crm_bias(value, packs, stride, &bias, &error);
  fprintf(table->file, "%s\t%g\t%.4g\t%.3g\t%.2g\n", how, parameter, spent,
          bias, error);
  say(bench, bias, error, "crm_%s_%g_bias", how, parameter);
  say(bench, spent, 0, "crm_%s_%g_spent", how, parameter);
}

static double crm_fit(const Pack *pack) {
  return contact_value(pack, 2 * pack_largest(pack), 2, 0).value;
}

static void crm_rests(Bench *bench, const Table *table) {
  static double value[CRM_PACKS][CRM_RESTS];
  CrmReport report;
  double grown = 0;
  for (size_t k = 0; k < CRM_PACKS; k++) {
    Pack *pack = crm_pack(CRM_N, CRM_PHI, CRM_FAST, k, &report);
    Engine *engine = crm_engine(pack, k);
    grown += 2 * (double)report.collisions / CRM_N / CRM_PACKS;
    for (int r = 0; r < CRM_RESTS; r++) {
      crm_run(engine, (r ? 1 << (r - 1) : 1) * CRM_N / 2.0);
      engine_store(engine, pack);
      value[k][r] = crm_fit(pack);
    }
    engine_free(&engine);
    pack_free(&pack);
  }
  for (int r = 0; r < CRM_RESTS; r++)
    crm_row(bench, table, "rest", 1 << r, grown + (1 << r), value[0] + r,
            CRM_PACKS, CRM_RESTS);
}

static void crm_rates(Bench *bench) {
  static const struct {
    double gamma;
    size_t packs;
  } job[] = {{0.5, FEW(48)},  {0.2, FEW(48)},  {0.1, FEW(48)},
             {0.03, FEW(24)}, {0.01, FEW(12)}, {0.003, FEW(4)}};
  Table table = begin(bench, "crm-rate.tsv",
                      "The contact value at .49 after growth, percent off",
                      "method\trate, or collisions of rest\tcollisions a "
                      "particle\tbias\tits error");
  for (size_t j = 0; j < COUNT(job); j++) {
    double value[CRM_PACKS], spent = 0;
    for (size_t k = 0; k < job[j].packs; k++) {
      CrmReport report;
      Pack *pack = crm_pack(CRM_N, CRM_PHI, job[j].gamma, k, &report);
      value[k] = crm_fit(pack);
      spent += 2 * (double)report.collisions / CRM_N / (double)job[j].packs;
      pack_free(&pack);
    }
    crm_row(bench, &table, "grown", job[j].gamma, spent, value, job[j].packs,
            1);
  }
  crm_rests(bench, &table);
  end(bench, &table);
  double row[CRM_PACKS];
  for (size_t k = 0; k < CRM_PACKS; k++) {
    CrmReport report;
    Outcome out = {0};
    Pack *pack = crm_try(CRM_N, 0, 1, 0.6, 1, k, &report, &out);
    row[k] = report.fraction;
    pack_free(&pack);
  }
  double mean, error;
  table_mean(row, CRM_PACKS, 1, 0, &mean, &error);
  say(bench, mean, error, "crm_jams_at");
}

/* The same work as many small packs or few large ones. */
static void crm_sizes(Bench *bench) {
  enum { ALL = 16000, REST = 160, RUN = 64 };
  static const size_t size[] = {32, 64, 128, 500, 2000};
  Table table = begin(bench, "crm-size.tsv",
                      "The contact value at .49 of as much work in packs of N, "
                      "percent off",
                      "method\tparticles a pack\tpacks\tbias\tits error");
  for (size_t s = 0; s < COUNT(size); s++) {
    size_t n = size[s], packs = ALL / n;
    double *value = memory(2 * packs, sizeof *value), bias, error;
    for (size_t k = 0; k < packs; k++) {
      CrmReport report;
      Pack *pack = crm_pack(n, CRM_PHI, 0.3, k, &report);
      Engine *engine = crm_engine(pack, k);
      crm_run(engine, REST / 2.0 * (double)n);
      engine->motion->virial = 0;
      double time = crm_run(engine, RUN / 2.0 * (double)n);
      value[2 * k] = crm_contact(engine, engine->motion->virial, time);
      engine_store(engine, pack);
      value[2 * k + 1] = crm_fit(pack);
      engine_free(&engine);
      pack_free(&pack);
    }
    for (size_t m = 0; m < 2; m++) {
      const char *name = crm_method[3 - m];
      crm_bias(value + m, packs, 2, &bias, &error);
      fprintf(table.file, "%s\t%zu\t%zu\t%.3g\t%.2g\n", name, n, packs, bias,
              error);
      say(bench, bias, error, "crm_size_%s_%zu", name, n);
    }
    free(value);
  }
  end(bench, &table);
}

/* Bytes that the engine holds for a particle, lists and all. */
static void crm_bytes(Bench *bench) {
  CrmReport report;
  Pack *pack = crm_pack(16000, 0.54, 0.5, 0, &report);
  struct mallinfo2 before = mallinfo2();
  Engine *engine = crm_engine(pack, 0);
  struct mallinfo2 after = mallinfo2();
  double bytes = (double)(after.uordblks + after.hblkhd) -
                 (double)(before.uordblks + before.hblkhd);
  say(bench, bytes / 16000, 0, "crm_bytes");
  engine_free(&engine);
  pack_free(&pack);
}

static void crm_operations(Bench *bench) {
  say(bench, theory_contact(THEORY_SCHULTZ, CRM_PHI), 0, "crm_truth");
  crm_estimators(bench);
  crm_rates(bench);
  crm_sizes(bench);
  crm_bytes(bench);
}

typedef struct {
  Engine *engine;
  RefCrm *plain;
  double collisions; /* a call */
} CrmJob;

static void crm_ours(void *of) {
  CrmJob *job = of;
  crm_run(job->engine, job->collisions);
}

static void crm_plain(void *of) {
  CrmJob *job = of;
  ref_crm_run(job->plain, GSL_POSINF, (uint64_t)job->collisions);
}

/* The plain kernel where the engine stands, but in the pack's order. */
static RefCrm *crm_plain_of(const Engine *engine, const Pack *pack) {
  RefCrm *plain = ref_crm_alloc(pack->n, pack->box.side[0], pack_largest(pack));
  for (size_t i = 0; i < pack->n; i++)
    for (size_t k = 0; k < 3; k++) {
      const double *record = engine->motion->hot + 8 * i;
      plain->x[3 * engine->order[i] + k] =
          box_wrap(record[k], pack->box.side[k]);
      plain->v[3 * engine->order[i] + k] = record[3 + k];
    }
  ref_crm_start(plain, pack_largest(pack), 0);
  return plain;
}

/* Collisions at constant radius. Grown fast, then rested for 20 collisions a
   particle, neither timed. */
static void crm_fixed(Bench *bench, const char *label, size_t n, size_t other,
                      double fraction) {
  CrmReport report;
  double gamma = fraction < 0.6 ? 0.5 : 0.05;
  Outcome out = {0};
  Pack *pack = crm_try(n, other, 0.313, fraction, gamma, 0, &report, &out);
  assert(out.status == DONE);
  CrmJob job = {crm_engine(pack, 0), NULL,
                (double)n * GSL_MAX(1, 32000 / (double)n)};
  crm_run(job.engine, 10 * (double)n);
  if (!other)
    job.plain = crm_plain_of(job.engine, pack);
  const Case cases[] = {{"ours", crm_ours, &job, GSL_NAN},
                        {"plain_cells", crm_plain, &job, GSL_NAN}};
  measure(bench, label, (double)n, job.collisions, cases, other ? 1 : 2);
  if (job.plain)
    ref_crm_free(job.plain);
  engine_free(&job.engine);
  pack_free(&pack);
}

static void crm_growing(void *of) {
  CrmReport report;
  Pack *pack = crm_pack(*(size_t *)of, 0.6, 0.05, 0, &report);
  pack_free(&pack);
}

static void crm_seconds(Bench *bench) {
  static const size_t size[] = {500, 2000, 16000, 128000};
  for (size_t s = 0; s < COUNT(size); s++) {
    crm_fixed(bench, "0.54", size[s], 0, 0.54);
    crm_fixed(bench, "0.30", size[s], 0, 0.30);
  }
  crm_fixed(bench, "one-0.60", 100, 0, 0.60);
  crm_fixed(bench, "one-0.60", 2000, 0, 0.60);
  crm_fixed(bench, "two-0.60", 2000, 1832, 0.60);
  for (size_t n = 2000; n <= 16000; n *= 8) {
    Case one = {"ours", crm_growing, &n, GSL_NAN};
    measure(bench, "grow-0.60", (double)n, (double)n, &one, 1);
  }
}

/* ------------------------------------------------------------ shakes */
/* Metropolis' rule as a textbook has it: cells as wide as a diameter and the
   window, and in each a linked list. */
enum { PLAIN_MOST = 64 };
typedef struct {
  size_t n, m, head[PLAIN_MOST * PLAIN_MOST * PLAIN_MOST], *next, *cell;
  double side, window, *x;
  Rng rng;
} PlainShake;

static size_t plain_cell(const PlainShake *plain, const double x[3]) {
  size_t cell = 0;
  for (int k = 0; k < 3; k++)
    cell = cell * plain->m +
           (size_t)(x[k] / plain->side * (double)plain->m) % plain->m;
  return cell;
}

static void plain_enter(PlainShake *plain, size_t i) {
  size_t c = plain->cell[i] = plain_cell(plain, plain->x + 3 * i);
  plain->next[i] = plain->head[c];
  plain->head[c] = i;
}

static void plain_leave(PlainShake *plain, size_t i) {
  size_t *at = &plain->head[plain->cell[i]];
  while (*at != i)
    at = &plain->next[*at];
  *at = plain->next[i];
}

static PlainShake *plain_shake(const Pack *pack, double radius) {
  PlainShake *plain = memory(1, sizeof *plain);
  plain->n = pack->n;
  plain->side = pack->box.side[0];
  plain->window = radius;
  plain->m = (size_t)GSL_MIN(plain->side / 2, PLAIN_MOST);
  plain->next = memory(pack->n, sizeof *plain->next);
  plain->cell = memory(pack->n, sizeof *plain->cell);
  plain->x = memory(3 * pack->n, sizeof *plain->x);
  memcpy(plain->x, pack->x, 3 * pack->n * sizeof *plain->x);
  plain->rng = rng_stream(SEED, 0, RNG_TEST);
  for (size_t c = 0; c < COUNT(plain->head); c++)
    plain->head[c] = SIZE_MAX;
  for (size_t i = 0; i < pack->n; i++)
    plain_enter(plain, i);
  return plain;
}

static bool plain_free(const PlainShake *plain, size_t i, const double y[3]) {
  size_t c = plain_cell(plain, y), m = plain->m;
  size_t at[3] = {c / (m * m), c / m % m, c % m};
  for (int s = 0; s < 27; s++) {
    size_t a = (at[0] + (size_t)(s / 9) + m - 1) % m,
           b = (at[1] + (size_t)(s / 3 % 3) + m - 1) % m,
           d = (at[2] + (size_t)(s % 3) + m - 1) % m;
    for (size_t j = plain->head[(a * m + b) * m + d]; j != SIZE_MAX;
         j = plain->next[j]) {
      double square = 0;
      for (int k = 0; k < 3; k++)
        square += gsl_pow_2(
            box_nearest(plain->x[3 * j + (size_t)k] - y[k], plain->side));
      if (square < 4 && j != i)
        return false;
    }
  }
  return true;
}

static void plain_sweep(PlainShake *plain) {
  for (size_t i = 0; i < plain->n; i++) {
    double p[3], y[3];
    do
      for (int k = 0; k < 3; k++)
        p[k] = 2 * rng_uniform(&plain->rng) - 1;
    while (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] > 1);
    for (int k = 0; k < 3; k++)
      y[k] = box_wrap(plain->x[3 * i + (size_t)k] + plain->window * p[k],
                      plain->side);
    if (!plain_free(plain, i, y))
      continue;
    plain_leave(plain, i);
    memcpy(plain->x + 3 * i, y, sizeof y);
    plain_enter(plain, i);
  }
}

typedef struct {
  Shake *shake;
  PlainShake *plain;
  uint64_t sweeps;
  Rng rng;
  ShakeReport report;
} ShakeJob;

static void shake_ours(void *of) {
  ShakeJob *job = of;
  shake_sweeps(job->shake, job->sweeps, &job->rng, &job->report);
}

static void shake_plain(void *of) {
  ShakeJob *job = of;
  for (uint64_t s = 0; s < job->sweeps; s++)
    plain_sweep(job->plain);
}

static const struct {
  const char *name;
  ShakePlan plan;
} shakes[] = {{"metropolis", {SHAKE_METROPOLIS, .02, 1, false}},
              {"retry", {SHAKE_RETRY, .02, 150, false}},
              {"collision", {SHAKE_COLLISION, .02, 1, false}},
              {"longest", {SHAKE_COLLISION_LONGEST, .02, 150, false}},
              {"wide-window", {SHAKE_METROPOLIS, .1, 1, false}}};

static ShakeJob shake_job(const Pack *pack, const ShakePlan *plan) {
  Outcome out = {0};
  ShakeJob job = {.shake = shake_alloc(pack, plan, &out),
                  .sweeps = 1,
                  .rng = rng_stream(SEED, 0, RNG_TEST)};
  shake_sweeps(job.shake, 10, &job.rng, &job.report);
  job.report = (ShakeReport){0};
  return job;
}

/* What a turn costs in trials, and how many of those succeed. */
static void shake_operations(Bench *bench) {
  CrmReport grown;
  Pack *pack = crm_pack(2000, 0.575, 0.05, 0, &grown);
  for (size_t s = 0; s < COUNT(shakes); s++) {
    ShakeJob job = shake_job(pack, &shakes[s].plan);
    job.sweeps = 5;
    shake_ours(&job);
    double trials = (double)job.report.trials;
    say(bench, trials / (double)job.report.turns, 0, "shake_%s_trials",
        shakes[s].name);
    say(bench, (double)job.report.moved / trials, 0, "shake_%s_accepted",
        shakes[s].name);
    shake_free(&job.shake);
  }
  pack_free(&pack);
}

/* A row's work is one particle's turn. */
static void shake_case(Bench *bench, size_t n, size_t s) {
  CrmReport grown;
  Pack *pack = crm_pack(n, 0.575, 0.05, 0, &grown);
  ShakeJob job = shake_job(pack, &shakes[s].plan);
  bool metropolis = shakes[s].plan.rule == SHAKE_METROPOLIS;
  job.plain = metropolis ? plain_shake(pack, shakes[s].plan.radius) : NULL;
  const Case cases[] = {{"ours", shake_ours, &job, GSL_NAN},
                        {"plain_cells", shake_plain, &job, GSL_NAN}};
  measure(bench, shakes[s].name, (double)n, (double)n, cases,
          metropolis ? 2 : 1);
  if (job.plain) {
    free(job.plain->next);
    free(job.plain->cell);
    free(job.plain->x);
    free(job.plain);
  }
  shake_free(&job.shake);
  pack_free(&pack);
}

typedef struct {
  Chain *chain;
  uint64_t lifts; /* a call, or a few more: chains are not broken off */
  Rng rng;
  ChainReport report;
} ChainJob;

static void chain_ours(void *of) {
  ChainJob *job = of;
  chain_run(job->chain, job->lifts, &job->rng, &job->report);
}

/* A row's work is one lift, as counted in some calls before. */
static void chain_case(Bench *bench, const Pack *pack, ChainRule rule) {
  enum { BEFORE = 10 };
  const ChainPlan plan = {.rule = rule};
  Outcome out = {0};
  ChainJob job = {.chain = chain_alloc(pack, &plan, &out),
                  .lifts = 10 * pack->n,
                  .rng = rng_stream(SEED, 0, RNG_TEST)};
  for (int c = 0; c < BEFORE; c++)
    chain_ours(&job);
  const Case ours = {"ours", chain_ours, &job, GSL_NAN};
  measure(bench, rule == CHAIN_NEWTON ? "newton" : "chain", (double)pack->n,
          (double)job.report.lifts / BEFORE, &ours, 1);
  chain_free(&job.chain);
}

/* A row's work is one collision. */
static void dynamics_case(Bench *bench, const Pack *pack) {
  CrmJob job = {crm_engine(pack, 0), NULL, 10 * (double)pack->n};
  crm_run(job.engine, job.collisions);
  const Case ours = {"ours", crm_ours, &job, GSL_NAN};
  measure(bench, "dynamics", (double)pack->n, job.collisions, &ours, 1);
  engine_free(&job.engine);
}

static void shake_seconds(Bench *bench) {
  CrmReport grown;
  Pack *pack = crm_pack(2000, 0.575, 0.05, 0, &grown);
  for (size_t s = 0; s < COUNT(shakes); s++)
    shake_case(bench, 2000, s);
  shake_case(bench, 16000, 0);
  chain_case(bench, pack, CHAIN_STRAIGHT);
  chain_case(bench, pack, CHAIN_NEWTON);
  dynamics_case(bench, pack);
  pack_free(&pack);
}

/* ------------------------------------------------------------ gravity */
typedef enum { MADE_LITERAL, MADE_ADAPTIVE, MADE } Making;
static const char *const making[MADE] = {"literal", "adaptive"};
enum { GRAVITY_PACKS = FEW(8), GRAVITY_SIZES = 5 };
static const size_t gravity_sizes[MADE][GRAVITY_SIZES + 1] = {
    {1000, 3000, 10000, 30000, 100000}, {1000, 3000, 10000, 30000, 0}};

static Pack *gravity_make(Making how, int dim, size_t n, uint64_t k,
                          GravityReport *report) {
  Species one = {"A", 1, n};
  GravityPlan plan = {.mode = how == MADE_LITERAL ? GRAVITY_LITERAL
                                                  : GRAVITY_ADAPTIVE};
  Outcome out = {0};
  Rng rng = rng_stream(SEED, n * 1000 + k, RNG_POSITIONS);
  Pack *pack = gravity_pack(dim, &one, 1, NULL, &plan, &rng, report, &out);
  assert(out.status == DONE);
  return pack;
}

/* The literal growth over all pairs: places from the middle. */
static double *gravity_all_pairs(int dim, size_t n, uint64_t k) {
  const double F = 1 + 25 * 0.05, origin[3] = {0, 0, 0};
  double R = 2 / F * gravity_length(dim, (double)n / pack_ball(dim, 1));
  double *x = memory(n * (size_t)dim, sizeof *x);
  Rng rng = rng_stream(SEED, n * 1000 + k, RNG_POSITIONS);
  for (size_t i = 1; i < n; i++)
    rng_in_ball(&rng, dim, R, x + i * (size_t)dim);
  for (int s = 0; s < 25 + 1 + 6; s++)
    ref_gravity_sweep(dim, n, x, NULL, s < 25 ? (1 + s * 0.05) / F : 1, origin,
                      0);
  return x;
}

/* Coordinates in which the two differ at all. */
static size_t gravity_differences(int dim, size_t n) {
  GravityReport report;
  Pack *pack = gravity_make(MADE_LITERAL, dim, n, 0, &report);
  double *x = gravity_all_pairs(dim, n, 0);
  size_t differ = 0;
  for (size_t i = 0; i < n * (size_t)dim; i++)
    differ += x[i] + 2 * report.rim != pack->x[i];
  free(x);
  pack_free(&pack);
  return differ;
}

enum {
  G_SWEEPS,
  G_PASSES,
  G_TURNS,
  G_PUSHES,
  G_WORK,
  G_OVERLAP,
  G_CARRY,
  G_CORE,
  G_COLUMNS
};
static const char *const gravity_column[G_COLUMNS] = {
    "sweeps", "passes", "turns", "pushes", "work", "overlap", "carry", "core"};

static void gravity_row(Making how, int dim, size_t n, uint64_t k,
                        double row[G_COLUMNS]) {
  GravityReport r;
  Pack *pack = gravity_make(how, dim, n, k, &r);
  row[G_SWEEPS] = r.sweeps;
  row[G_PASSES] = r.passes;
  row[G_TURNS] = (double)r.all.turns / (double)n;
  row[G_PUSHES] = (double)r.all.pushes / (double)n;
  row[G_WORK] = row[G_TURNS] + row[G_PUSHES];
  row[G_OVERLAP] = r.overlap;
  row[G_CARRY] = r.carry;
  row[G_CORE] = core_fraction(pack, pack->open / 2);
  pack_free(&pack);
}

typedef struct {
  double n, value, error;
} Point;

/* Of two sizes: n is less than that of the other, by at most a decade. */
static bool in_decade(double n, double most) {
  return n < most && n > 0.099 * most;
}

/* The power of n by which the value grows. */
static double power(const Point *p, const Point *q, double *error) {
  double apart = log(q->n / p->n);
  *error = gsl_hypot(p->error / p->value, q->error / q->value) / apart;
  return log(q->value / p->value) / apart;
}

static void say_power(Bench *bench, const Point *p, const Point *q, double own,
                      const char *name) {
  double error, slope = power(p, q, &error);
  say(bench, own + slope, error, "%s_power", name);
}

/* One large pack is taken to scatter as the several next to it in size do. */
static Point gravity_size(Bench *bench, Table *table, Making how, int dim,
                          size_t n, double *scatter, double *worst) {
  double row[GRAVITY_PACKS][G_COLUMNS], mean[G_COLUMNS], error[G_COLUMNS];
  size_t packs = n < 3000    ? GRAVITY_PACKS
                 : n < 10000 ? 4
                             : n == 10000 ? 3 : 1;
  for (size_t k = 0; k < packs; k++)
    gravity_row(how, dim, n, k, row[k]);
  for (size_t k = 0; k < packs; k++)
    *worst = fmax(*worst, row[k][G_OVERLAP]);
  fprintf(table->file, "%s\t%d\t%zu\t%zu", making[how], dim, n, packs);
  for (size_t c = 0; c < G_COLUMNS; c++) {
    mean[c] = row[0][c];
    error[c] = GSL_NAN;
    if (packs > 1)
      table_mean(row[0], packs, G_COLUMNS, c, mean + c, error + c);
    if (error[c] < 1e-12 * mean[c])
      error[c] = 0; /* it is the same in all */
    fprintf(table->file, "\t%.4g\t%.2g", mean[c], error[c]);
    say(bench, mean[c], error[c], "gravity_%s_%d_%zu_%s", making[how], dim, n,
        gravity_column[c]);
  }
  fputs("\n", table->file);
  if (packs > 1)
    *scatter = error[G_WORK] * sqrt((double)packs) / mean[G_WORK];
  return (Point){(double)n, mean[G_WORK],
                 mean[G_WORK] * *scatter / sqrt((double)packs)};
}

static void gravity_growths(Bench *bench) {
  Table table =
      begin(bench, "gravity.tsv",
            "Packs by gravity: operations a particle, deepest overlap left "
            "in diameters, fraction in half the rim",
            "mode\tdimension\tP\tpacks\tsweeps\tsweeps_err\tpasses\t"
            "passes_err\tturns\tturns_err\tpushes\tpushes_err\twork\t"
            "work_err\toverlap\toverlap_err\tlargest_c\tlargest_c_err"
            "\tinner_fraction\tinner_fraction_err");
  double worst[MADE] = {0, 0};
  for (int how = 0; how < MADE; how++)
    for (int dim = 2; dim <= 3; dim++) {
      double scatter = GSL_NAN;
      char name[64];
      Point all[GRAVITY_SIZES], *p = all, *q = all;
      for (const size_t *n = gravity_sizes[how]; *n; n++, q++)
        *q = gravity_size(bench, &table, (Making)how, dim, *n, &scatter,
                          worst + how);
      q--;
      while (!in_decade(p->n, q->n))
        p++;
      snprintf(name, sizeof name, "gravity_%s_%d", making[how], dim);
      say_power(bench, p, q, 1, name);
    }
  say(bench, worst[MADE_ADAPTIVE], 0, "gravity_adaptive_worst");
  end(bench, &table);
}

/* ---- the turns of coarse balls in a fine pack, as src/coarse.nw has them */
static const struct {
  double ratio;
  size_t of; /* a coarse one to so many */
} turnings[] = {{3, 500}, {10, 2500}};
static const size_t turning_sizes[] = {3000, 10000};
enum { TURNINGS = COUNT(turnings), TURNING_PACKS = 2 };

typedef struct {
  const Pack *fine;
  double ratio;
  size_t coarse;
  FieldSweep sum;
  uint64_t turns;
  double *x; /* the places in the end, or NULL */
} TurningJob;

static TurningJob turning_job(const Pack *fine, size_t t, double *x) {
  return (TurningJob){.fine = fine,
                   .ratio = turnings[t].ratio,
                   .coarse = fine->n / turnings[t].of,
                   .x = x};
}

static Field *turning_field(const Pack *fine) {
  double *x = memory(3 * fine->n, sizeof *x);
  double *radius = memory(fine->n, sizeof *radius);
  gravity_places(fine, x);
  for (size_t i = 0; i < fine->n; i++)
    radius[i] = 1;
  Field *field = field_alloc(3, fine->n, x, radius);
  free(x);
  free(radius);
  return field;
}

/* The first particles after that in the middle lie anywhere. */
static void turning_run(TurningJob *job, FieldSweep sweep(Field *, double)) {
  const double step = 0.15, slack = 2 * 1e-2;
  Field *field = turning_field(job->fine);
  sweep(field, slack);
  job->sum = (FieldSweep){0};
  job->turns = 0;
  for (double a = 1; a < job->ratio;) {
    a = fmin(a + step, job->ratio);
    field_file(field);
    for (size_t c = 1; c <= job->coarse; c++, job->turns++) {
      field_radius(field, c, a);
      memcpy(field->origin, field_place(field, c), sizeof field->origin);
      field_add(&job->sum, sweep(field, slack));
    }
  }
  if (job->x)
    field_places(field, job->x);
  field_free(&field);
}

static void turning_follow(void *of) {
  turning_run(of, field_follow);
}

static void turning_all(void *of) {
  turning_run(of, field_sweep);
}

/* Coordinates in which the two differ at all, and pushes. */
static size_t turning_differences(const Pack *fine, size_t t) {
  double *x = memory(6 * fine->n, sizeof *x);
  TurningJob follow = turning_job(fine, t, x);
  TurningJob all = turning_job(fine, t, x + 3 * fine->n);
  turning_follow(&follow);
  turning_all(&all);
  size_t differ = follow.sum.pushes != all.sum.pushes;
  for (size_t i = 0; i < 3 * fine->n; i++)
    differ += follow.x[i] != all.x[i];
  free(x);
  return differ;
}

/* A whole pack of ratio 3 by the main variant. */
static Pack *gravity_add(const Pack *fine, CoarseReport *report) {
  Species coarse = {"B", 3, fine->n / 50};
  const CoarsePlan plan = {.step = 0};
  Outcome out = {0};
  Rng rng = rng_stream(SEED, fine->n, RNG_TEST);
  Pack *pack = coarse_add(fine, &coarse, &plan, &rng, report, &out);
  assert(out.status == DONE);
  return pack;
}

static double adding_work(const Pack *fine) {
  CoarseReport r;
  Pack *pack = gravity_add(fine, &r);
  pack_free(&pack);
  return (double)(r.grown.turns + r.grown.pushes + r.settled.turns +
                  r.settled.pushes) /
         (double)fine->n;
}

static Point turning_say(Bench *bench, const char *name, size_t n,
                         const double value[]) {
  double mean, error;
  table_mean(value, TURNING_PACKS, 1, 0, &mean, &error);
  say(bench, mean, error, "gravity_%s_%zu_work", name, n);
  return (Point){(double)n, mean, error};
}

/* Turns of a sweep for each ratio; then the work of a whole pack a particle. */
static void turning_size(Bench *bench, size_t n, Point point[TURNINGS + 1]) {
  double work[TURNINGS + 1][TURNING_PACKS], differ = 0;
  for (size_t k = 0; k < TURNING_PACKS; k++) {
    GravityReport report;
    Pack *fine = gravity_make(MADE_ADAPTIVE, 3, n, k, &report);
    for (size_t t = 0; t < TURNINGS; t++) {
      TurningJob job = turning_job(fine, t, NULL);
      turning_follow(&job);
      work[t][k] = (double)job.sum.turns / (double)job.turns;
      if (k == 0 && n == turning_sizes[0])
        differ += (double)turning_differences(fine, t);
    }
    work[TURNINGS][k] = adding_work(fine);
    pack_free(&fine);
  }
  point[0] = turning_say(bench, "turn_3", n, work[0]);
  point[1] = turning_say(bench, "turn_10", n, work[1]);
  point[2] = turning_say(bench, "add_3", n, work[2]);
  if (n == turning_sizes[0])
    say(bench, differ, 0, "gravity_turn_differences");
}

static void gravity_turns(Bench *bench) {
  Point small[TURNINGS + 1], large[TURNINGS + 1];
  turning_size(bench, turning_sizes[0], small);
  turning_size(bench, turning_sizes[1], large);
  say_power(bench, small, large, 0, "gravity_turn_3");
  say_power(bench, small + 1, large + 1, 0, "gravity_turn_10");
  say_power(bench, small + 2, large + 2, 1, "gravity_add_3");
}

static void gravity_operations(Bench *bench) {
  gravity_growths(bench);
  say(bench,
      (double)(gravity_differences(2, 1000) + gravity_differences(3, 1000)), 0,
      "gravity_differences");
  gravity_turns(bench);
}

typedef struct {
  Making how;
  int dim;
  size_t n;
  uint64_t k;
  bool same; /* the same pack at every call */
} GravityJob;

static void gravity_ours(void *of) {
  GravityJob *job = of;
  GravityReport report;
  Pack *pack = gravity_make(job->how, job->dim, job->n, job->k, &report);
  job->k += !job->same;
  pack_free(&pack);
}

static void gravity_plain(void *of) {
  GravityJob *job = of;
  free(gravity_all_pairs(job->dim, job->n, job->k));
}

static void adding_ours(void *of) {
  CoarseReport report;
  Pack *pack = gravity_add(of, &report);
  pack_free(&pack);
}

/* A row's work is a particle. Adaptive packs differ from call to call, so that
   the spread is that of the packs too. */
static void growth_case(Bench *bench, Making how, int dim, size_t n) {
  GravityJob job = {how, dim, n, 0, how == MADE_LITERAL};
  GravityJob plain = job;
  const Case cases[] = {{"ours", gravity_ours, &job, GSL_NAN},
                        {"plain_all", gravity_plain, &plain, GSL_NAN}};
  char label[32];
  snprintf(label, sizeof label, "%s-%d", making[how], dim);
  measure(bench, label, (double)n, (double)n, cases,
          how == MADE_LITERAL && dim == 3 && n <= 10000 ? 2 : 1);
}

/* Here it is a turn of a coarse ball. */
static void turning_case(Bench *bench, const Pack *fine, size_t t) {
  TurningJob job = turning_job(fine, t, NULL);
  const Case cases[] = {{"ours", turning_follow, &job, GSL_NAN},
                        {"plain_sweep", turning_all, &job, GSL_NAN}};
  char label[32];
  turning_follow(&job);
  snprintf(label, sizeof label, "turn-%g", job.ratio);
  measure(bench, label, (double)fine->n, (double)job.turns, cases, 2);
}

static void gravity_seconds(Bench *bench) {
  for (int how = 0; how < MADE; how++)
    for (int dim = 2; dim <= 3; dim++)
      for (const size_t *n = gravity_sizes[how]; *n; n++)
        if (how == MADE_ADAPTIVE || *n != 30000)
          growth_case(bench, (Making)how, dim, *n);
  for (size_t s = 0; s < COUNT(turning_sizes); s++) {
    GravityReport report;
    Pack *fine = gravity_make(MADE_ADAPTIVE, 3, turning_sizes[s], 0, &report);
    const Case add = {"ours", adding_ours, fine, GSL_NAN};
    for (size_t t = 0; fine->n >= 10000 && t < TURNINGS; t++)
      turning_case(bench, fine, t);
    measure(bench, "add-3", (double)fine->n, (double)fine->n, &add, 1);
    pack_free(&fine);
  }
}

/* ------------------------------------------------------------ side by side */
enum { SIDE = 10000 };
static const double side_thin = 0.38, side_dense = 0.59;

static void side_added(void *of) {
  RsaJob job = {3, SIDE, side_thin};
  (void)of;
  rsa_ours(&job);
}

static void side_grown(void *of) {
  CrmReport report;
  Pack *pack = crm_pack(SIDE, *(double *)of, 0.05, 0, &report);
  pack_free(&pack);
}

static void side_fallen(void *of) {
  GravityReport report;
  (void)of;
  Pack *pack = gravity_make(MADE_ADAPTIVE, 3, SIDE, 0, &report);
  pack_free(&pack);
}

static void side_diluted(void *of) {
  DilutePlan plan = {.fraction = side_thin, .part = 1};
  Rng rng = rng_stream(SEED, 0, RNG_GRAVITY);
  Outcome out = {0};
  Pack *pack = dilute_pack(of, &plan, &rng, NULL, &out);
  assert(out.status == DONE);
  pack_free(&pack);
}

/* Seconds for one pack of spheres of one size by each maker. A row's work is a
   particle; dilution and shakes are of a pack that is there. */
static void side_seconds(Bench *bench) {
  GravityReport fallen;
  CrmReport grown;
  Pack *loose = gravity_make(MADE_ADAPTIVE, 3, SIDE, 0, &fallen);
  Pack *dense = crm_pack(SIDE, side_dense, 0.05, 0, &grown);
  double thin = side_thin, close = side_dense;
  ShakeJob shaken = shake_job(dense, &shakes[0].plan);
  shaken.sweeps = 60;
  const struct {
    const char *label;
    Case one;
  } all[] = {{"added", {"ours", side_added, NULL, GSL_NAN}},
             {"grown-thin", {"ours", side_grown, &thin, GSL_NAN}},
             {"grown-dense", {"ours", side_grown, &close, GSL_NAN}},
             {"shaken", {"ours", shake_ours, &shaken, GSL_NAN}},
             {"fallen", {"ours", side_fallen, NULL, GSL_NAN}},
             {"diluted", {"ours", side_diluted, loose, GSL_NAN}}};
  for (size_t i = 0; i < COUNT(all); i++)
    measure(bench, all[i].label, SIDE, SIDE, &all[i].one, 1);
  shake_free(&shaken.shake);
  pack_free(&loose);
  pack_free(&dense);
}

#include "bench_shapes.h"
#include "bench_threepoint.h"
#include "bench_functions.h"

/* ------------------------------------------------------------ the tasks */
typedef struct {
  const char *name;
  const char *modules[12];     /* whose code it measures */
  void (*operations)(Bench *); /* or NULL */
  void (*seconds)(Bench *);
} Task;
static const Task tasks[] = {
    {"py", {"py", "flags"}, py_operations, py_seconds},
    {"contact",
     {"contact", "pairs", "cells", "rsa", "box", "rng", "flags"},
     contact_operations,
     contact_seconds},
    {"neighbours",
     {"pairs", "cells", "box", "rng", "flags"},
     neighbours_operations,
     neighbours_seconds},
    {"pairs",
     {"pairs", "cells", "box", "rng", "flags"},
     pairs_operations,
     pairs_seconds},
    {"partials",
     {"partials", "pairs", "cells", "box", "rng", "simd", "flags"},
     partials_operations,
     partials_seconds},
    {"mixture",
     {"mixture", "contact", "pairs", "py", "flags"},
     mixture_operations,
     mixture_seconds},
    {"sizes", {"sizes", "flags"}, NULL, sizes_seconds},
    {"rsa", {"rsa", "box", "rng", "flags"}, rsa_operations, rsa_seconds},
    {"crm",
     {"crm", "engine", "motion", "near", "events", "contact", "pairs", "box",
      "rng", "simd", "flags"},
     crm_operations,
     crm_seconds},
    {"shake",
     {"shake", "chain", "near", "crm", "engine", "motion", "events", "box",
      "rng", "simd", "flags"},
     shake_operations,
     shake_seconds},
    {"gravity",
     {"field", "gravity", "coarse", "pack", "box", "rng", "flags"},
     gravity_operations,
     gravity_seconds},
    {"side",
     {"rsa", "crm", "engine", "motion", "near", "events", "shake", "field",
      "gravity", "dilute", "flags"},
     NULL,
     side_seconds},
    {"overlap",
     {"overlap", "shape", "elementary", "flags"},
     overlap_operations,
     overlap_seconds},
    {"covered",
     {"cover", "overlap", "shape", "elementary", "pack", "flags"},
     NULL,
     covered_seconds},
    {"turning",
     {"turning", "compression", "apart", "overlap", "shape", "near", "simd",
      "flags"},
     NULL,
     turning_seconds},
    {"penetrable",
     {"penetrable", "cover", "overlap", "shape", "elementary", "rng", "flags"},
     NULL,
     penetrable_seconds},
    {"relax",
     {"relax", "dynamics", "rim", "overlap", "touch", "shape", "elementary",
      "points", "rng", "flags"},
     NULL,
     relax_seconds},
    {"threepoint",
     {"threepoint", "indicator", "shape", "elementary", "simd", "rng", "flags"},
     threepoint_operations,
     threepoint_seconds},
    {"twopoint",
     {"twopoint", "covariance", "raster", "cover", "shape", "elementary",
      "simd", "rng", "flags"},
     NULL,
     twopoint_seconds},
    {"microstructure",
     {"microstructure", "ewald", "share", "raster", "rng", "flags"},
     NULL,
     microstructure_seconds}};

static void operations(Bench *bench) {
  char print[COUNT(tasks)][17];
  bench->code = "of each task, in its table";
  bench->summary =
      begin(bench, "summary.tsv", "Speed against error: operations",
            "quantity\tvalue\tstandard_error");
  for (size_t t = 0; t < COUNT(tasks); t++) {
    table_fingerprint(tasks[t].modules, print[t]);
    bench->code = print[t];
    bench->task = tasks[t].name;
    double start = now();
    if (tasks[t].operations)
      tasks[t].operations(bench);
    if (getenv("BENCH_TIMES"))
      fprintf(stderr, "bench: %s: %.1f s\n", bench->task, now() - start);
  }
  end(bench, &bench->summary);
}

static void seconds(Bench *bench, const char *file, const char *only) {
  const char *machine = getenv("BENCH_MACHINE"), *slash = strrchr(file, '/');
  char directory[512] = ".", print[17];
  if (slash)
    snprintf(directory, sizeof directory, "%.*s", (int)(slash - file), file);
  if (table_open(&bench->record, directory, slash ? slash + 1 : file,
                 &bench->out))
    return;
  fprintf(
      bench->record.file,
      "# Seconds of one core, recorded by make bench, the median over so "
      "many\n# repetitions, half the distance of their quartiles\n%s\n"
      "task\tmethod\tcase\tsize\twork\tseconds\tspread\trepetitions\terror\t"
      "code\n",
      machine ? machine : "# machine: not described");
  for (size_t t = 0; t < COUNT(tasks); t++) {
    if (only && strcmp(only, tasks[t].name))
      continue;
    table_fingerprint(tasks[t].modules, print);
    bench->code = print;
    bench->task = tasks[t].name;
    tasks[t].seconds(bench);
  }
  table_close(&bench->record, &bench->out);
}

/* ------------------------------------------------------------ the record */
enum { ROWS = 1000 };
typedef struct {
  char task[32], method[32], label[32], code[32];
  double size, work, seconds, spread;
} Row;

static size_t read_record(FILE *file, Row row[]) {
  char line[512];
  size_t n = 0;
  while (n < ROWS && fgets(line, sizeof line, file)) {
    Row *r = row + n;
    n += sscanf(line, "%31s %31s %31s %lf %lf %lf %lf %*s %*s %31s", r->task,
                r->method, r->label, &r->size, &r->work, &r->seconds,
                &r->spread, r->code) == 8;
  }
  return n;
}

static bool is_plain(const Row *row) {
  return strncmp(row->method, "plain", 5) == 0;
}

/* The fastest plain program for the same case. */
static const Row *plain_of(const Row row[], size_t n, const Row *of) {
  const Row *plain = NULL;
  for (size_t r = 0; r < n; r++)
    if (is_plain(row + r) && row[r].size == of->size &&
        !strcmp(row[r].task, of->task) && !strcmp(row[r].label, of->label) &&
        (!plain || row[r].seconds < plain->seconds))
      plain = row + r;
  return plain;
}

/* How many tasks were recorded with other code, or by another compiler. */
static size_t stale_tasks(const Row row[], size_t n) {
  size_t stale = 0;
  char print[17];
  for (size_t t = 0; t < COUNT(tasks); t++) {
    bool fresh = false, old = false;
    table_fingerprint(tasks[t].modules, print);
    for (size_t r = 0; r < n; r++)
      if (strcmp(row[r].task, tasks[t].name) == 0) {
        fresh = true;
        old = old || strcmp(row[r].code, print);
      }
    stale += !fresh || old;
  }
  return stale;
}

/* Millions and thousands of units a second, microseconds a unit, and how many times faster
   than the fastest plain program. */
static void say_row(Bench *bench, const char *method, const Row *r,
                    const Row *plain) {
  double rate = 1e-6 * r->work / r->seconds, spread = r->spread / r->seconds;
  char name[160];
  snprintf(name, sizeof name, "%.31s_%.31s_%.31s_%.0f", r->task, method,
           r->label, r->size);
  say(bench, rate, rate * spread, "%s_rate", name);
  say(bench, 1 / rate, spread / rate, "%s_each", name);
  say(bench, 1000 * rate, 1000 * rate * spread, "%s_thousands", name);
  say(bench, r->seconds, r->spread, "%s_seconds", name);
  say(bench, 1000 * r->seconds, 1000 * r->spread, "%s_milliseconds", name);
  if (plain && !is_plain(r)) {
    double ratio = plain->seconds / r->seconds;
    double both = gsl_hypot(spread, plain->spread / plain->seconds);
    say(bench, ratio, ratio * both, "%s_ratio", name);
  }
}

/* Widths of vectors come in rising order; which is the last, the machine knows. */
static bool is_widest(const Row *r, const Row *end) {
  return !strcmp(r->task, "pairs") && !is_plain(r) &&
         (r + 1 == end || is_plain(r + 1) || r[1].size != r->size);
}

/* Where N particles begin to pay for cells: the last N at which all pairs win,
   and the last at which plain cells do. */
static void say_crossings(Bench *bench, const Row row[], size_t n) {
  double all = 0, lists = 0;
  for (size_t r = 0; r < n; r++)
    for (size_t q = 0; q < n; q++)
      if (!strcmp(row[r].task, "neighbours") &&
          !strcmp(row[q].task, "neighbours") &&
          !strcmp(row[r].method, "ours") && row[r].size == row[q].size &&
          row[q].seconds < row[r].seconds) {
        if (!strcmp(row[q].method, "plain_all"))
          all = fmax(all, row[r].size);
        if (!strcmp(row[q].method, "plain_lists"))
          lists = fmax(lists, row[r].size);
      }
  say(bench, all, 0, "neighbours_all_until");
  say(bench, lists, 0, "neighbours_lists_until");
}

/* What the names of two equal sizes cost, and up to which N the plain program
   counts two sizes faster. */
static void say_partials(Bench *bench, const Row row[], size_t n) {
  double until = 0;
  for (size_t r = 0; r < n; r++)
    for (size_t q = 0; q < n; q++) {
      if (strcmp(row[r].task, "partials") || strcmp(row[q].task, "partials") ||
          strcmp(row[r].method, "ours") || strcmp(row[r].label, row[q].label) ||
          row[r].size != row[q].size)
        continue;
      double ratio = row[r].seconds / row[q].seconds;
      double both = gsl_hypot(row[r].spread / row[r].seconds,
                              row[q].spread / row[q].seconds);
      if (!strcmp(row[q].method, "one"))
        say(bench, ratio, ratio * both, "partials_price_%g", row[r].size);
      if (is_plain(row + q) && ratio > 1)
        until = fmax(until, row[r].size);
    }
  say(bench, until, 0, "partials_plain_until");
}

static void say_growth(Bench *bench, const Row *p, const Row *q) {
  const Point from = {p->size, p->seconds, p->spread},
              to = {q->size, q->seconds, q->spread};
  double error, slope = power(&from, &to, &error);
  double far = log(1e6 / q->size), apart = log(q->size / p->size);
  double minutes = q->seconds / 60 * exp(far * slope);
  double both = gsl_hypot(far / apart * p->spread / p->seconds,
                          (1 + far / apart) * q->spread / q->seconds);
  say(bench, slope, error, "gravity_%s_%s_power", q->method, q->label);
  say(bench, minutes, minutes * both, "gravity_%s_%s_million_minutes",
      q->method, q->label);
  say(bench, minutes / 60, minutes / 60 * both, "gravity_%s_%s_million_hours",
      q->method, q->label);
}

/* The power of P by which the seconds of a case grow over the last decade of its
   sizes, and the time of a million that it foretells. */
static void say_gravity(Bench *bench, const Row row[], size_t n) {
  for (const Row *q = row + 1; q < row + n; q++) {
    const Row *p = NULL;
    bool last = !strcmp(q->task, "gravity");
    for (const Row *r = row; last && r < row + n; r++) {
      if (strcmp(r->task, q->task) || strcmp(r->method, q->method) ||
          strcmp(r->label, q->label))
        continue;
      last = r->size <= q->size;
      if (in_decade(r->size, q->size) && (!p || r->size < p->size))
        p = r;
    }
    if (last && p)
      say_growth(bench, p, q);
  }
}

/* The lines that describe the machine, for the page. */
static void write_machine(Bench *bench, FILE *record) {
  Table table = {.file = NULL};
  char line[512];
  bool first = true;
  if (table_open(&table, bench->directory, "machine.tex", &bench->out))
    return;
  while (fgets(line, sizeof line, record) && line[0] == '#') {
    line[strcspn(line, "\n")] = 0;
    if (!strchr(line, ':'))
      continue;
    fputs(first ? "" : "; ", table.file);
    for (const char *c = line + 2; *c; c++)
      fprintf(table.file, strchr("#$%&_{}", *c) ? "\\%c" : "%c", *c);
    first = false;
  }
  fputs("%\n", table.file);
  end(bench, &table);
  rewind(record);
}

static void recorded(Bench *bench, const char *file) {
  FILE *record = fopen(file, "r");
  if (!record) {
    outcome_set(&bench->out, WRONG, "%s: no record; make bench writes it",
                file);
    return;
  }
  write_machine(bench, record);
  Row *row = memory(ROWS, sizeof *row);
  size_t n = read_record(record, row);
  fclose(record);
  bench->code = "as recorded";
  bench->summary = begin(bench, "summary.tsv", "Speed against error: seconds",
                         "quantity\tvalue\tstandard_error");
  say(bench, (double)stale_tasks(row, n), 0, "other_code");
  for (const Row *r = row; r < row + n; r++) {
    const Row *plain = plain_of(row, n, r);
    say_row(bench, r->method, r, plain);
    if (is_widest(r, row + n))
      say_row(bench, "widest", r, plain);
  }
  say_crossings(bench, row, n);
  say_partials(bench, row, n);
  say_gravity(bench, row, n);
  end(bench, &bench->summary);
  free(row);
}

/* Ours beside the plain reference. */
static void compare(const char *file) {
  Row *row = memory(ROWS, sizeof *row);
  FILE *record = fopen(file, "r");
  size_t n = record ? read_record(record, row) : 0;
  if (record)
    fclose(record);
  printf("%-11s%-18s%10s  %-9s%13s%13s%8s\n", "task", "case", "size", "method",
         "units/s", "plain", "ratio");
  for (const Row *r = row; r < row + n; r++) {
    const Row *plain = plain_of(row, n, r);
    if (plain && !is_plain(r))
      printf("%-11s%-18s%10g  %-9s%13.4g%13.4g%8.2f\n", r->task, r->label,
             r->size, r->method, r->work / r->seconds,
             plain->work / plain->seconds, plain->seconds / r->seconds);
    else if (!is_plain(r) && !strcmp(r->task, "crm"))
      printf("%-11s%-18s%10g  %-9s%13.4g%13s%8s %.3g s\n", r->task, r->label,
             r->size, r->method, r->work / r->seconds, "-", "-", r->seconds);
  }
  free(row);
}

int main(int count, char *words[]) {
  Bench bench = {.directory = words[count - 1]};
  const char *verb = count > 2 ? words[1] : "";
  omp_set_num_threads(1);
  if (strcmp(verb, "ops") == 0)
    operations(&bench);
  else if (strcmp(verb, "seconds") == 0)
    seconds(&bench, words[2], count > 3 ? words[3] : NULL);
  else if (strcmp(verb, "recorded") == 0 && count == 4)
    recorded(&bench, words[2]);
  else if (strcmp(verb, "compare") == 0)
    compare(words[2]);
  else
    outcome_set(&bench.out, WRONG,
                "ops DIR | seconds FILE [TASK] | recorded FILE DIR | "
                "compare FILE");
  if (bench.out.status != DONE)
    fprintf(stderr, "bench: %s\n", bench.out.text);
  return bench.out.status;
}
