/* tests/test_bytes.c: numbers and texts come back to the last bit, in one order of bytes; what is short is noticed */
#include "bytes.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <string.h>

static void test_there_and_back(void) {
  static const double reals[] = {0.1, -0.0, 6.02214076e23, 4.9406564584124654e-324, -1.7976931348623157e308};
  static const uint64_t nans[] = {0x7ff8000000000000u, 0xfff8000000000123u, 0x7ff0000000000000u};
  Bytes bytes = {0};
  for (size_t i = 0; i < 5; i++)
    bytes_real(&bytes, reals[i]);
  for (size_t i = 0; i < 3; i++) {
    double nan;
    memcpy(&nan, &nans[i], 8);
    bytes_real(&bytes, nan);
  }
  bytes_whole(&bytes, 0x0123456789abcdefu);
  bytes_text(&bytes, "a\0b", 3);
  bytes_text(&bytes, "", 0);
  for (size_t i = 0; i < 5; i++) {
    double real = bytes_next_real(&bytes);
    gsl_test(memcmp(&real, &reals[i], 8), "real %d comes back", (int)i);
  }
  for (size_t i = 0; i < 3; i++) {
    double real = bytes_next_real(&bytes);
    gsl_test(memcmp(&real, &nans[i], 8), "with the bits of a NaN, %d", (int)i);
  }
  gsl_test(bytes_next_whole(&bytes) != 0x0123456789abcdefu, "a whole number");
  size_t length;
  const char *text = bytes_next_text(&bytes, &length);
  gsl_test(length != 3 || memcmp(text, "a\0b", 4) != 0, "a text with a zero in it, and one behind it");
  text = bytes_next_text(&bytes, &length);
  gsl_test(length != 0 || *text || bytes.bad || bytes.next != bytes.length, "an empty text, and that is all");
  bytes_free(&bytes);
}

static void test_order(void) {
  static const unsigned char want[] = {0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01, 0, 0, 0, 0, 0, 0, 0xf0, 0xbf};
  Bytes bytes = {0};
  bytes_whole(&bytes, 0x0123456789abcdefu);
  bytes_real(&bytes, -1);
  gsl_test(bytes.length != sizeof want || memcmp(bytes.at, want, sizeof want) != 0, "the lowest byte comes first");
  gsl_test(bytes_sum("a", 1) != 0xaf63dc4c8601ec8cu || bytes_sum("foobar", 6) != 0x85944171f73967e8u,
           "the sum is FNV-1a of 64 bits");
  bytes_free(&bytes);
}

/* Whatever is cut off, nothing is read beyond the end, and it is noticed. */
static void test_short(void) {
  Bytes whole = {0};
  bytes_text(&whole, "seven77", 7);
  bytes_real(&whole, 2.385);
  int noticed = 0;
  for (size_t length = 0; length < whole.length; length++) {
    Bytes part = {0};
    bytes_add(&part, whole.at, length);
    bytes_next_text(&part, NULL);
    double real = bytes_next_real(&part);
    noticed += part.bad && real == 0;
    bytes_free(&part);
  }
  gsl_test_int(noticed, (int)whole.length, "each length that is too short is noticed");
  for (uint64_t huge = 1; huge; huge <<= 1) {
    Bytes part = {0};
    bytes_whole(&part, UINT64_MAX - huge + 1);
    bytes_add(&part, "some", 5);
    const char *text = bytes_next_text(&part, NULL);
    gsl_test(!part.bad || *text, "a length of 2^64 - %llu is refused", (unsigned long long)huge);
    bytes_free(&part);
  }
  Bytes open = {0};
  bytes_text(&open, "abc", 3);
  open.at[open.length - 1] = 'd';
  gsl_test(*bytes_next_text(&open, NULL) || !open.bad, "a text without its zero is refused");
  bytes_free(&open);
  bytes_free(&whole);
}

int main(void) {
  test_there_and_back();
  test_order();
  test_short();
  return gsl_test_summary();
}
