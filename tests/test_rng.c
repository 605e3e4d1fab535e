/* tests/test_rng.c: streams as pinned by another program, and what is asked of random numbers.
   Statistical tolerances are in standard errors; the seeds are fixed. */
#include "rng.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>

/* From a dozen lines of Python after the text of chapter rng. */
static const struct {
  uint64_t seed, realization;
  RngPurpose purpose;
  uint64_t first[4];
} known[] = {
    {0, 0, RNG_POSITIONS, {0xe2452d0cedf9c6c8u, 0xf13d246427698b6eu, 0x6ed76f5e99ef3404u, 0xdf59d7b3a09dfab6u}},
    {2012, 0, RNG_POSITIONS, {0xcc89151ddc977a49u, 0xcb1c5ac337e93007u, 0xf2c4a952b2088df2u, 0x6f13416ac483d789u}},
    {2012, 1, RNG_POSITIONS, {0x5879b01970abf6u, 0xa20b10bffe5b979fu, 0xd3b3619bc06f15b5u, 0xaf58f284e4c48ebbu}},
    {1ull << 53, 49, RNG_MEASURE, {0xbcabbe206fea087fu, 0x8ad7175e583bee74u, 0x28a73418a269cad3u, 0x94e440f911047cddu}},
    {UINT64_MAX, UINT64_MAX, RNG_ORDER, {0xda740258f06adab1u, 0x69611d1894ea9f24u, 0x57804b70d0a2156cu, 0x112773f4a6e8222fu}},
};

static void test_known(void) {
  for (size_t s = 0; s < sizeof known / sizeof *known; s++) {
    Rng rng = rng_stream(known[s].seed, known[s].realization, known[s].purpose);
    int wrong = 0;
    for (int i = 0; i < 4; i++)
      wrong += rng_bits(&rng) != known[s].first[i];
    gsl_test_int(wrong, 0, "the first numbers of stream %d are pinned", (int)s);
  }
}

/* Within so many standard errors of what is expected? */
static void near(double mean, double expected, double error, const char *what) {
  gsl_test(!(fabs(mean - expected) < 4.5 * error), "%s: %g is %.2f standard errors off", what, mean,
           (mean - expected) / error);
}

static double chi_square(const double count[], int bins, double expected) {
  double sum = 0;
  for (int b = 0; b < bins; b++)
    sum += (count[b] - expected) * (count[b] - expected) / expected;
  return gsl_cdf_chisq_Q(sum, bins - 1);
}

static void test_uniform(void) {
  enum { N = 1000000, BINS = 128 };
  Rng rng = rng_stream(2012, 3, RNG_TEST);
  double sum = 0, square = 0, lag = 0, last = 0.5, count[BINS] = {0}, low[BINS] = {0};
  int outside = 0, coarse = 0;
  for (int i = 0; i < N; i++) {
    double u = rng_uniform(&rng);
    outside += !(u >= 0 && u < 1);
    coarse += u * 0x1p32 == floor(u * 0x1p32);
    sum += u;
    square += u * u;
    lag += (u - 0.5) * (last - 0.5);
    count[(int)(u * BINS)]++;
    low[(int)(fmod(u * 0x1p46, 1) * BINS)]++;
    last = u;
  }
  gsl_test_int(outside, 0, "uniform numbers are in [0, 1)");
  gsl_test(coarse > 9, "and finer than 32 bits");
  near(sum / N, 0.5, sqrt(1.0 / 12 / N), "mean of uniform numbers");
  near(square / N, 1.0 / 3, sqrt(4.0 / 45 / N), "mean square of uniform numbers");
  near(lag / N, 0, 1.0 / 12 / sqrt(N), "correlation with the one before");
  gsl_test(!(chi_square(count, BINS, (double)N / BINS) > 1e-5), "chi-square of %d bins", BINS);
  gsl_test(!(chi_square(low, BINS, (double)N / BINS) > 1e-5), "chi-square of the low bits");
}

/* Streams that differ by one in one of their keys have nothing in common. */
static void test_neighbours(void) {
  enum { STREAMS = 400, N = 500 };
  static const char *const what[] = {"neighbouring seeds", "neighbouring realizations", "neighbouring purposes"};
  for (int key = 0; key < 3; key++) {
    double sum = 0;
    for (uint64_t s = 0; s < STREAMS; s++) {
      Rng a = rng_stream(s, 7, RNG_ORDER);
      Rng b = rng_stream(s + (key == 0), 7u + (key == 1), key == 2 ? RNG_POSITIONS : RNG_ORDER);
      for (int i = 0; i < N; i++)
        sum += (rng_uniform(&a) - 0.5) * (rng_uniform(&b) - 0.5);
    }
    near(sum / (STREAMS * N), 0, 1.0 / 12 / sqrt(STREAMS * N), what[key]);
  }
}

static int by_size(const void *a, const void *b) {
  uint64_t left = *(const uint64_t *)a, right = *(const uint64_t *)b;
  return (left > right) - (left < right);
}

static void test_steps(void) {
  enum { STREAMS = 60000 };
  static uint64_t first[STREAMS];
  int even = 0, plain = 0, same = 0;
  for (uint64_t s = 0; s < STREAMS; s++) {
    Rng rng = rng_stream(s % 200, s / 200, RNG_TEST);
    even += rng.step % 2 == 0;
    plain += __builtin_popcountll(rng.step ^ (rng.step >> 1)) < 24;
    first[s] = rng_bits(&rng);
  }
  qsort(first, STREAMS, sizeof *first, by_size);
  for (int s = 1; s < STREAMS; s++)
    same += first[s] == first[s - 1];
  gsl_test_int(even, 0, "every step is odd");
  gsl_test_int(plain, 0, "and changes many bits");
  gsl_test_int(same, 0, "no two streams of %d begin alike", STREAMS);
}

static void test_below(void) {
  enum { N = 300000 };
  Rng rng = rng_stream(77, 0, RNG_TEST);
  double count[7] = {0}, low = 0;
  int outside = 0;
  for (int i = 0; i < N; i++)
    count[rng_below(&rng, 7)]++;
  gsl_test(!(chi_square(count, 7, N / 7.0) > 1e-5), "integers below 7 are equally likely");
  uint64_t wide = 3ull << 62; /* a remainder would favour its lowest third */
  for (int i = 0; i < N; i++) {
    uint64_t k = rng_below(&rng, wide);
    outside += k >= wide;
    low += k < 1ull << 62;
  }
  near(low / N, 1.0 / 3, sqrt(2.0 / 9 / N), "the lowest third of a wide range");
  gsl_test_int(outside, 0, "integers are below");
  gsl_test(rng_below(&rng, 1) != 0, "below 1 there is only 0");
}

static void test_direction(int dim) {
  enum { N = 200000 };
  Rng rng = rng_stream(19, (uint64_t)dim, RNG_TEST);
  double first[3] = {0}, square[3] = {0}, fourth = 0, cross = 0, worst = 0;
  for (int i = 0; i < N; i++) {
    double u[3] = {0, 0, 0}, norm = 0;
    rng_direction(&rng, dim, u);
    for (int k = 0; k < dim; k++) {
      norm += u[k] * u[k];
      first[k] += u[k];
      square[k] += u[k] * u[k];
    }
    fourth += gsl_pow_4(u[0]);
    cross += u[0] * u[1];
    worst = GSL_MAX(worst, fabs(norm - 1));
  }
  /* moments: <u^2> = 1/d, <u^4> = 3/(d(d+2)), <u^8> = 105/(d(d+2)(d+4)(d+6)) */
  double d = dim, m4 = 3 / (d * (d + 2)), m8 = 105 / (d * (d + 2) * (d + 4) * (d + 6));
  gsl_test(!(worst < 1e-15), "%d-D: directions have length 1", dim);
  for (int k = 0; k < dim; k++) {
    near(first[k] / N, 0, sqrt(1 / d / N), "mean of a direction");
    near(square[k] / N, 1 / d, sqrt((m4 - 1 / (d * d)) / N), "mean square of a direction");
  }
  near(fourth / N, m4, sqrt((m8 - m4 * m4) / N), "fourth moment of a direction");
  near(cross / N, 0, sqrt(1 / (d * (d + 2)) / N), "product of two components");
}

static void test_gsl(void) {
  enum { N = 100000 };
  Rng rng = rng_stream(5, 6, RNG_TEST), same = rng;
  gsl_rng *wrapped = rng_gsl_alloc(rng);
  int wrong = 0;
  double sum = 0;
  for (int i = 0; i < 100; i++) {
    wrong += gsl_rng_uniform(wrapped) != rng_uniform(&same);
    wrong += gsl_rng_get(wrapped) != rng_bits(&same);
  }
  gsl_test_int(wrong, 0, "the wrapped stream is the stream");
  for (int i = 0; i < N; i++)
    sum += gsl_ran_gaussian(wrapped, 1.5);
  near(sum / N, 0, 1.5 / sqrt(N), "GSL's distributions work on it");
  gsl_rng_set(wrapped, 1ul << 32);
  double high = gsl_rng_uniform(wrapped);
  gsl_rng_set(wrapped, 0);
  gsl_test(high == gsl_rng_uniform(wrapped), "seeds that differ by 2^32 differ");
  gsl_rng_free(wrapped);
}

int main(void) {
  test_known();
  test_uniform();
  test_neighbours();
  test_steps();
  test_below();
  test_direction(2);
  test_direction(3);
  test_gsl();
  return gsl_test_summary();
}
