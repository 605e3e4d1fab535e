/* tests/test_state.c: what is saved is loaded, and what is not whole, or of another computation, is not. */
#include "state.h"
#include "outcome.h"
#include <errno.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
  double place[7];
  uint64_t count;
  bool deep;
  size_t many;
  uint32_t *list;
} Thing;

static void pass_thing(void *what, State *state) {
  Thing *thing = what;
  STATE_PASS(state, thing->place);
  STATE_PASS(state, thing->count);
  STATE_PASS(state, thing->deep);
  if (state->way != STATE_SUM)
    thing->list = state_array(state, thing->list, &thing->many, sizeof *thing->list);
}

static Thing begin(void) {
  Thing thing = {.place = {0.125, -2.5e300, 3.7e-310}, .count = 12345678901234567u};
  return thing;
}

static Thing go_on(void) {
  Thing thing = begin();
  thing.place[6] = 2.385;
  thing.count++;
  thing.deep = true;
  thing.many = 1003;
  thing.list = memory(thing.many, sizeof *thing.list);
  for (size_t i = 0; i < thing.many; i++)
    thing.list[i] = (uint32_t)(i * 2654435761u);
  return thing;
}

static bool same(const Thing *a, const Thing *b) {
  return memcmp(a->place, b->place, sizeof a->place) == 0 && a->count == b->count && a->deep == b->deep &&
         a->many == b->many && (a->many == 0 || memcmp(a->list, b->list, a->many * sizeof *a->list) == 0);
}

static long length_of(const char *path) {
  struct stat about;
  return stat(path, &about) ? -1 : (long)about.st_size;
}

static unsigned char *slurp(const char *path, size_t *length) {
  FILE *file = fopen(path, "rb");
  *length = (size_t)length_of(path);
  unsigned char *text = memory(*length, 1);
  gsl_test(fread(text, 1, *length, file) != *length, "read back");
  fclose(file);
  return text;
}

static void put(const char *path, const unsigned char *text, size_t length) {
  FILE *file = fopen(path, "wb");
  fwrite(text, 1, length, file);
  fclose(file);
}

/* Is it refused, and left as at its beginning? */
static bool refused(const char *path, const char *key) {
  Thing first = begin(), thing = begin();
  bool loaded = state_load(path, key, pass_thing, &thing);
  bool kept = same(&thing, &first);
  free(thing.list);
  return !loaded && kept;
}

static void test_there_and_back(const char *path) {
  Thing first = begin(), was = go_on(), is = begin(), twice = begin();
  uint64_t sum = state_sum(pass_thing, &first);
  gsl_test(!state_save(path, "key", sum, pass_thing, &was), "a state is saved");
  gsl_test(!state_load(path, "key", pass_thing, &is), "and loaded");
  gsl_test(!same(&was, &is), "all of it");
  gsl_test((uintptr_t)is.list % 64 != 0, "an array begins a line of the cache");
  size_t length, again;
  unsigned char *text = slurp(path, &length);
  gsl_test(!state_save(path, "key", sum, pass_thing, &is), "it is saved again");
  unsigned char *other = slurp(path, &again);
  gsl_test(length != again || memcmp(text, other, length) != 0, "in the same bytes");
  gsl_test(!refused(path, "kez") || !refused(path, "ke") || !refused(path, "key "), "another key is refused");
  twice.place[0] += 1e-16;
  gsl_test(state_load(path, "key", pass_thing, &twice), "another beginning is refused");
  free(text);
  free(other);
  free(was.list);
  free(is.list);
}

/* Each byte altered in each of its bits; each length; a byte more. */
static void test_damage(const char *path) {
  size_t length;
  unsigned char *text = slurp(path, &length);
  text = memory_grow(text, length + 1, 1);
  text[length] = 0;
  int taken = 0;
  text[length - 100] ^= 4;
  put(path, text, length);
  gsl_test(!refused(path, "key"), "an altered number is seen");
  text[length - 100] ^= 4;
  for (size_t i = 0; i < length; i += i < 400 ? 1 : 37) {
    text[i] ^= (unsigned char)(1 << i % 8);
    put(path, text, length);
    taken += !refused(path, "key");
    text[i] ^= (unsigned char)(1 << i % 8);
  }
  gsl_test_int(taken, 0, "an altered byte is seen");
  for (size_t cut = 0; cut < length; cut += cut < 400 ? 1 : 41) {
    put(path, text, cut);
    taken += !refused(path, "key");
  }
  gsl_test_int(taken, 0, "a file that is cut off is seen");
  put(path, text, length + 1);
  gsl_test(!refused(path, "key"), "a byte more is seen");
  remove(path);
  gsl_test(!refused(path, "key"), "no file is no state");
  free(text);
}

static void test_unwritable(const char *dir, const char *path) {
  char part[120], deep[120];
  Thing was = go_on();
  put(path, (const unsigned char *)"old", 3);
  snprintf(part, sizeof part, "%s.part", path);
  gsl_test(symlink("/dev/full", part), "a full disk");
  gsl_test(state_save(path, "key", 1, pass_thing, &was), "is told");
  gsl_test_int(errno, ENOSPC, "by its number");
  gsl_test_int((int)length_of(path), 3, "the old file is as it was");
  gsl_test_int((int)length_of(part), -1, "and nothing is left beside it");
  snprintf(deep, sizeof deep, "%s/none/state", dir);
  gsl_test(state_save(deep, "key", 1, pass_thing, &was), "a folder that is not there");
  gsl_test_int(errno, ENOENT, "is told, too");
  free(was.list);
  remove(path);
}

/* The sum sees the order and the lengths of parts, and a bit anywhere. */
static void pass_two(void *what, State *state) {
  size_t *cut = what;
  char text[24] = "abcdefghijklmnopqrstuvw";
  state_pass(state, text, *cut);
  state_pass(state, text + *cut, sizeof text - *cut);
}

static void test_sum(void) {
  uint64_t sum[25];
  int twins = 0;
  for (size_t cut = 0; cut <= 24; cut++) {
    sum[cut] = state_sum(pass_two, &cut);
    for (size_t c = 0; c < cut; c++)
      twins += sum[c] == sum[cut];
  }
  gsl_test_int(twins, 0, "where parts end is in the sum");
}

int main(void) {
  char dir[40], path[80];
  snprintf(dir, sizeof dir, "%s/state-XXXXXX", access("/dev/shm", W_OK) ? "/tmp" : "/dev/shm");
  gsl_test(mkdtemp(dir) == NULL, "a folder");
  snprintf(path, sizeof path, "%s/state", dir);
  test_there_and_back(path);
  test_damage(path);
  test_unwritable(dir, path);
  test_sum();
  rmdir(dir);
  return gsl_test_summary();
}
