/* tests/test_elementary.c: cosine, sine, angle and power against long doubles, at their edges, and bit for bit against
   recorded values */
#include "elementary.h"
#include "many.h"
#include "rng.h"
#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <math.h>

/* valgrind has long doubles that are no longer than doubles; then nothing can be said of the last bits */
static double worse(double most, long double got, long double want, long double unit) {
  volatile long double one = 1;
  double error = (double)(fabsl(got - want) / unit);
  return one + LDBL_EPSILON == one ? most : GSL_MAX_DBL(most, error);
}

static void test_turn(void) {
  Rng rng = rng_stream(51, 0, RNG_TEST);
  double absolute = 0, relative = 0;
  for (int i = 0; i < as_many(40000, 2000000); i++) {
    static const double scales[] = {1e-9, 1e-3, 7, 1e5};
    double angle = scales[i & 3] * (2 * rng_uniform(&rng) - 1), c, s;
    elementary_turn(angle, &c, &s);
    absolute = worse(worse(absolute, c, cosl(angle), 1), s, sinl(angle), 1);
    relative = worse(worse(relative, c, cosl(angle), fabsl(cosl(angle))), s, sinl(angle), fabsl(sinl(angle)));
  }
  gsl_test(!(absolute < 1.3e-16), "cosine and sine: error %.3g", absolute);
  gsl_test(!(relative < 2e-16), "cosine and sine: relative error %.3g", relative);
  for (int k = -63000; k < 63000; k += 4999) {
    double angle = k * M_PI_2, c, s;
    elementary_turn(angle, &c, &s);
    gsl_test_rel(k & 1 ? c : s, (double)(k & 1 ? cosl(angle) : sinl(angle)), 3e-16, "the small one at %d quarters", k);
  }
  double c, s;
  elementary_turn(0, &c, &s);
  gsl_test(c != 1 || s != 0, "no turn");
  elementary_turn(2.5739, &c, &s);
  gsl_test(c != -0x1.afb08d0430aedp-1 || s != 0x1.134bd956dd31bp-1, "recorded: %a %a", c, s);
}

static void test_angle(void) {
  Rng rng = rng_stream(52, 0, RNG_TEST);
  double relative = 0;
  for (int i = 0; i < as_many(40000, 2000000); i++) {
    double x = 2 * rng_uniform(&rng) - 1, y = 2 * rng_uniform(&rng) - 1;
    y *= i & 1 ? 1 : 1e-6;
    x *= i & 2 ? 1 : 1e-5;
    relative = worse(relative, elementary_angle(y, x), atan2l(y, x), fabsl(atan2l(y, x)));
  }
  gsl_test(!(relative < 3e-16), "angle: relative error %.3g", relative);
  static const double axes[][3] = {{0, 2.5, 0},         {3.1, 0, M_PI_2}, {0, -0.3, M_PI}, {-7, 0, -M_PI_2}, {0, 0, 0},
                                   {1.3, 1.3, M_PI_4}, {-1.3, -1.3, -3 * M_PI_4}};
  for (int i = 0; i < 7; i++)
    gsl_test_rel(elementary_angle(axes[i][0], axes[i][1]), axes[i][2], DBL_EPSILON, "angle of axis %d", i);
  double got = elementary_angle(0.7311, -2.1907);
  gsl_test(got != 0x1.68e4eb93ef51ep+1, "recorded: %a", got);
}

static void test_power(void) {
  Rng rng = rng_stream(53, 0, RNG_TEST);
  double small = 0, large = 0;
  for (int i = 0; i < as_many(40000, 2000000); i++) {
    double x = i & 1 ? rng_uniform(&rng) : 1 + 40 * rng_uniform(&rng), p = 180 * (2 * rng_uniform(&rng) - 1);
    p *= i & 2 ? 1 : 0.02;
    long double want = powl(x, p);
    if (want > 1e-300L && want < 1e300L)
      small = worse(small, elementary_power(x, p), want, want);
    x = 0.95 + 0.1 * rng_uniform(&rng);
    p = 8000 * (2 * rng_uniform(&rng) - 1);
    want = expl(p * logl(x));
    large = worse(large, elementary_power(x, p), want, want);
  }
  gsl_test(!(small < 2e-16), "power: relative error %.3g", small);
  gsl_test(!(large < 1e-15), "power to exponents of thousands: relative error %.3g", large);
  double short_way = 0;
  for (int i = 0; i < as_many(40000, 2000000); i++) {
    static const double exponents[] = {3, 4, 0.25};
    double x = (i & 1 ? 1 : 900) * rng_uniform(&rng), p = exponents[i % 3];
    short_way = worse(short_way, elementary_power(x, p), powl(x, p), powl(x, p));
  }
  gsl_test(!(short_way < 1.7e-16), "the powers of m = 2: relative error %.3g", short_way);
  static const struct {
    double x, p, want;
  } edges[] = {{0, 2.5, 0},        {0, 0, 1},         {0, -1.5, INFINITY}, {1, 87.3, 1}, {7.25, 0, 1},
               {7.25, 1, 7.25},    {2, 1000, 0x1p1000}, {2, 1100, INFINITY}, {2, -1100, 0}, {0x1p-1060, 0.5, 0x1p-530},
               {0.5, 1e12, 0},     {0x1p-1074, -0.5, 0x1p537}, {0x1p-205, 4, 0x1p-820}, {0x1.8p199, 4, 0x1.44p798},
                   {0x1p-270, 4, 0}, {0x1p260, 4, INFINITY}, {0x1p-1074, 0.25, 0x1.6a09e667f3bcdp-269}};
  for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
    double got = elementary_power(edges[i].x, edges[i].p);
    gsl_test(!(got == edges[i].want || fabs(got / edges[i].want - 1) < 3e-16), "%g to the %g: %g", edges[i].x,
             edges[i].p, got);
  }
  double got = elementary_power(0.7361, 97.31);
  gsl_test(got != 0x1.fb33e06a071adp-44, "recorded: %a", got);
}

int main(void) {
  test_turn();
  test_angle();
  test_power();
  return gsl_test_summary();
}
