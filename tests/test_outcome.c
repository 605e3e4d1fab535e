/* tests/test_outcome.c: the first failure is kept, and memory is there or the program ends with 1 */
#include "outcome.h"
#include <gsl/gsl_test.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* So that the sanitizer lets an impossible request fail as libc does. */
const char *__asan_default_options(void);
const char *__asan_default_options(void) {
  return "allocator_may_return_null=1";
}

static void test_first(void) {
  Outcome out = {0};
  gsl_test_int(out.status, DONE, "an outcome begins as done");
  gsl_test_int(outcome_set(&out, UNREACHED, "%d of %s", 17, "23"), UNREACHED, "the status is returned");
  gsl_test_str(out.text, "17 of 23", "the text is printed");
  gsl_test_int(outcome_set(&out, WRONG, "later"), UNREACHED, "a later failure returns the first status");
  gsl_test_str(out.text, "17 of 23", "and leaves the first text");
  gsl_test(DONE != 0 || UNREACHED != 1 || WRONG != 2, "the statuses are 0, 1, 2");
}

static void test_long(void) {
  Outcome line = {0}, out = {0};
  outcome_set(&line, WRONG, "a\nname\r\t; is one");
  gsl_test_str(line.text, "a?name??; is one", "one line");
  char text[4000];
  memset(text, 'x', sizeof text - 1);
  text[sizeof text - 1] = '\0';
  outcome_set(&out, WRONG, "%s", text);
  gsl_test_int((int)strlen(out.text), (int)sizeof out.text - 1, "a long text is cut to its room");
}

static void test_memory(void) {
  unsigned char *p = memory(1237, 7), any = 0;
  for (size_t i = 0; i < 1237 * 7; i++)
    any |= p[i];
  gsl_test(any != 0, "memory is zero");
  memset(p, 0x5a, 1237 * 7);
  p = memory_grow(p, 100003, 3);
  int kept = 1;
  for (size_t i = 0; i < 1237 * 7; i++)
    kept = kept && p[i] == 0x5a;
  gsl_test(!kept, "growing keeps what was there");
  free(p);
  void *nothing = memory(0, 8), *grown = memory_grow(NULL, 0, 8);
  gsl_test(!nothing || !grown, "a request for nothing has an address");
  free(nothing);
  free(grown);
}

/* The status of a child that asks for too much, and its line. */
static int too_much(bool grow, size_t count, size_t size, char line[], size_t room) {
  int ends[2];
  if (pipe(ends))
    abort();
  pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    void *p = grow ? memory_grow(NULL, count, size) : memory(count, size);
    _exit(p ? 77 : 78);
  }
  close(ends[1]);
  size_t length = 0;
  for (ssize_t n; length + 1 < room && (n = read(ends[0], line + length, room - length - 1)) > 0;)
    length += (size_t)n;
  line[length] = '\0';
  close(ends[0]);
  int status;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int main(void) {
  char line[4096];
  test_first();
  test_long();
  test_memory();
  gsl_test_int(too_much(false, SIZE_MAX / 3, 2, line, sizeof line), UNREACHED, "too much memory: status 1");
  gsl_test(!strstr(line, "out of memory"), "and a line that says so");
  gsl_test_int(too_much(false, SIZE_MAX / 8 + 3, 8, line, sizeof line), UNREACHED, "a product beyond size_t: status 1");
  gsl_test_int(too_much(true, SIZE_MAX / 8 + 3, 8, line, sizeof line), UNREACHED, "and when growing");
  gsl_test(!strstr(line, "out of memory"), "with its line");
  return gsl_test_summary();
}
