/* tests/test_workers.c: orders are done in processes of their own; one that dies is told, and the next order is done */
#include "workers.h"
#include <gsl/gsl_test.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The answer to n: n numbers; or an end, good or bad, in the middle of it. */
static void work(void *own, Bytes *order, Bytes *answer) {
  int *shared = own;
  uint64_t n = bytes_next_whole(order);
  ++*shared;
  if (n == 77)
    raise(SIGKILL);
  if (n == 78)
    _exit(3);
  if (n == 79)
    kill(getppid(), SIGKILL);
  for (uint64_t i = 0; i < n; i++)
    bytes_whole(answer, i * i + (uint64_t)*shared);
}

static void give(Workers *workers, int w, uint64_t n) {
  Bytes order = {0};
  bytes_whole(&order, n);
  gsl_test(!workers_give(workers, w, &order), "worker %d gets its order", w);
  bytes_free(&order);
}

/* Has one answered well, with so many numbers? Leaves who it was. */
static bool answered(Workers *workers, uint64_t n, int *who) {
  Bytes answer = {0};
  char lost[WORKERS_LOST];
  *who = workers_take(workers, 10000, &answer, lost);
  bool good = *who >= 0 && !*lost && answer.length == 8 * n;
  for (uint64_t i = 0; i < n && good; i++)
    good = bytes_next_whole(&answer) == i * i + 1;
  bytes_free(&answer);
  return good;
}

static void test_lost(Workers *workers, uint64_t n, const char *how) {
  Bytes answer = {0};
  char lost[WORKERS_LOST] = "";
  give(workers, 0, n);
  int w = workers_take(workers, 10000, &answer, lost);
  gsl_test(w != 0 || answer.length || !strstr(lost, how), "%s: %s", how, lost);
  bytes_free(&answer);
}

int main(void) {
  int shared = 0, who;
  Workers *workers = workers_open(2, work, &shared);
  if (!workers)
    return gsl_test(1, "workers are opened"), gsl_test_summary();
  Bytes none = {0};
  char lost[WORKERS_LOST];
  gsl_test_int(workers_take(workers, 0, &none, lost), -1, "who has no order has no answer");
  give(workers, 0, 5);
  gsl_test(!answered(workers, 5, &who) || who != 0, "an order is done");
  give(workers, 1, 300000);
  gsl_test(!answered(workers, 300000, &who) || who != 1, "a long answer comes whole");
  give(workers, 0, 0);
  gsl_test(!answered(workers, 0, &who), "an empty one, too");
  gsl_test_int(shared, 0, "and nothing is left of it here");
  test_lost(workers, 77, "signal 9");
  test_lost(workers, 78, "status 3");
  give(workers, 0, 7);
  gsl_test(!answered(workers, 7, &who) || who != 0, "after a loss the next order is done");
  test_lost(workers, 79, "gone");
  gsl_test(!workers_gone(workers, 0) || workers_give(workers, 0, &none), "who has no keeper gets no order");
  give(workers, 1, 4);
  gsl_test(!answered(workers, 4, &who) || who != 1, "the other worker goes on");
  workers_close(&workers);
  gsl_test(workers != NULL, "they are closed");
  bytes_free(&none);
  return gsl_test_summary();
}
