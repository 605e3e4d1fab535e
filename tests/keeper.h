/* tests/keeper.h: a watch that stops a computation at the tick of some number, and keeps its state in a file; for test_watch.c and
   test_stops.c. */
#ifndef KEEPER_H
#define KEEPER_H
#include "outcome.h"
#include "watch.h"
#include <gsl/gsl_test.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Stops at the tick of this number, and writes the state; 0: never. The state at the end of a part is written, too; each part has a file
   of its own, PATH-1, PATH-2, ... */
typedef struct {
  Watch watch;
  const char *path;
  int stop, ticks, begun, loaded, ended;
  bool outside; /* were there ticks in another part's part? */
  StatePass pass;
  void *what;
  uint64_t beginning;
  WatchNews news;
} Keeper;

static void keeper_save(Keeper *keeper) {
  char path[200];
  snprintf(path, sizeof path, "%s-%d", keeper->path, keeper->begun);
  gsl_test(!state_save(path, "test", keeper->beginning, keeper->pass, keeper->what), "saved");
}

static bool begin(Watch *watch, StatePass pass, void *what) {
  Keeper *keeper = watch->who;
  char path[200];
  keeper->begun++;
  keeper->pass = pass;
  keeper->what = what;
  keeper->beginning = state_sum(pass, what);
  snprintf(path, sizeof path, "%s-%d", keeper->path, keeper->begun);
  bool loaded = state_load(path, "test", pass, what);
  keeper->loaded += loaded;
  return loaded;
}

static bool tick(Watch *watch, const WatchNews *news) {
  Keeper *keeper = watch->who;
  keeper->ticks++;
  keeper->news = *news;
  keeper->outside |= watch->depth != 1;
  bool stop = keeper->ticks == keeper->stop;
  if (stop)
    keeper_save(keeper);
  return !stop;
}

static void end(Watch *watch, bool whole) {
  Keeper *keeper = watch->who;
  keeper->ended += whole;
  if (whole && keeper->stop)
    keeper_save(keeper);
}

static Keeper *keeper_of(const char *path, int stop) {
  Keeper *keeper = memory(1, sizeof *keeper);
  keeper->watch = (Watch){begin, tick, end, keeper, 0, 0, 0};
  keeper->path = path;
  keeper->stop = stop;
  return keeper;
}

/* A folder of its own, and the path of the files in it. */
static void keeper_place(char dir[40], char path[80]) {
  snprintf(dir, 40, "%s/keeper-XXXXXX", access("/dev/shm", W_OK) ? "/tmp" : "/dev/shm");
  gsl_test(mkdtemp(dir) == NULL, "a folder");
  snprintf(path, 80, "%s/state", dir);
}

/* Remove all its files. */
static void keeper_forget(const char *of) {
  char path[200];
  for (int part = 1, gone = 0; gone == 0; part++) {
    snprintf(path, sizeof path, "%s-%d", of, part);
    gone = remove(path);
  }
}
#endif
