/* tests/test_simd.c: the environment chooses no wider vectors than there are, and nonsense is named */
#include "simd.h"
#include <gsl/gsl_test.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

int main(void) {
  static const char *const names[] = {"default", "avx2", "avx512f"};
  static const char *const wrong[] = {"nonsense", "", "AVX2", "avx", "avx512", "default "};
  unsetenv("RANDPACK_SIMD");
  Simd widest = simd_choose();
  gsl_test_str(simd_complaint(), "", "unset: nothing to complain about");
  gsl_test(widest > SIMD_AVX512F, "unset: one of the three");
  for (int level = SIMD_DEFAULT; level <= SIMD_AVX512F; level++) {
    setenv("RANDPACK_SIMD", names[level], 1);
    bool there = level <= (int)widest;
    gsl_test_int((int)simd_choose(), there ? level : (int)widest, "%s is taken, if it is there", names[level]);
    gsl_test((*simd_complaint() == '\0') != there, "%s is refused, if it is not", names[level]);
  }
  for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
    setenv("RANDPACK_SIMD", wrong[w], 1);
    gsl_test(!strstr(simd_complaint(), "default, avx2 or avx512f"), "\"%s\" is refused", wrong[w]);
    gsl_test_int((int)simd_choose(), (int)widest, "\"%s\" changes nothing", wrong[w]);
  }
  return gsl_test_summary();
}
