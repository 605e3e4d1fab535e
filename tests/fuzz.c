/* tests/fuzz.c: any bytes as a file with packs, for libFuzzer. What is read is in order, and the same when it is written and read
   again, and written once more the same bytes; what is not read is refused in one line. tests/slow-fuzz.sh runs it. */
#define _GNU_SOURCE
#include "files.h"
#include "same.h"
#include "xyz.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define must(what) ((what) ? (void)0 : (fprintf(stderr, "must be: %s\n", #what), abort()))

static int in = -1, out = -1;
static char in_path[40], out_path[40];

static void fill(int file, const void *bytes, size_t size) {
  must(ftruncate(file, 0) == 0 && pwrite(file, bytes, size, 0) == (ssize_t)size);
}

/* The pack as a file in memory, to be freed. */
static char *text_of(const Pack *pack, size_t *size) {
  char *text = NULL;
  FILE *file = open_memstream(&text, size);
  xyz_write(file, pack, "seed=1");
  fclose(file);
  return text;
}

static void judge(const Pack *pack) {
  size_t n = 0, dim = (size_t)pack->box.dim;
  must(pack->kinds >= 1 && (dim == 2 || dim == 3) && pack->open >= 0 && isfinite(pack->open));
  for (int s = 0; s < pack->kinds; s++)
    n += pack->species[s].count;
  must(n == pack->n);
  for (size_t k = 0; k < dim; k++)
    must(pack->box.side[k] > 0 && isfinite(pack->box.side[k]));
  for (size_t c = 0; c < n * dim; c++)
    must(pack->x[c] >= 0 && pack->x[c] < pack->box.side[c % dim]);
  for (size_t i = 0; i < n; i++) {
    must(pack_kind(pack, i) < pack->kinds && pack_radius(pack, i) > 0 && isfinite(pack_radius(pack, i)));
    must(!pack->angle || (pack->angle[i] >= 0 && pack->angle[i] < 2 * 3.1415926535897933));
  }
}

static void compare(const Pack *a, const Pack *b) {
  must(b->n == a->n && same_box(&a->box, &b->box) && a->open == b->open && a->kinds == b->kinds && same_shapes(a, b));
  for (int s = 0; s < a->kinds; s++)
    must(strcmp(a->species[s].name, b->species[s].name) == 0 && a->species[s].count == b->species[s].count &&
         (a->n == 0 || a->species[s].radius == b->species[s].radius));
  for (size_t i = 0; i < a->n; i++) {
    must(pack_kind(a, i) == pack_kind(b, i) && pack_radius(a, i) == pack_radius(b, i));
    must(!a->angle == !b->angle && (!a->angle || a->angle[i] == b->angle[i]));
    for (size_t k = 0; k < (size_t)a->box.dim; k++)
      must(a->x[i * (size_t)a->box.dim + k] == b->x[i * (size_t)a->box.dim + k]);
  }
}

static void again(const Pack *pack) {
  Outcome why = {0};
  size_t size, size_again;
  char *text = text_of(pack, &size);
  fill(out, text, size);
  Pack *back = files_read(out_path, NULL, &why);
  if (!back)
    fprintf(stderr, "%s\n%.*s", why.text, (int)(size < 2000 ? size : 2000), text);
  must(back);
  compare(pack, back);
  char *text_again = text_of(back, &size_again);
  must(size == size_again && memcmp(text, text_again, size) == 0);
  free(text);
  free(text_again);
  pack_free(&back);
}

static void read_all(const GatherKnown *known, const Box *box) {
  Outcome why = {0};
  PackFile file;
  int packs = 0;
  Pack *pack = NULL;
  if (files_open(&file, in_path, known, box, &why))
    for (; packs < 20 && (pack = files_next(&file)); packs++) {
      judge(pack);
      if (pack->n < 2000 && !pack->walls) /* which are not written */
        again(pack);
      pack_free(&pack);
    }
  files_close(&file);
  must(packs > 0 || why.status == WRONG);
  must(!why.status || (why.status == WRONG && !strchr(why.text, '\n') && strstr(why.text, in_path) && strchr(why.text, ';')));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const Species ball = {.name = "A", .radius = 0.5}, two[] = {{.name = "1", .radius = 2}, {.name = "B", .radius = 1e-3}};
  static const GatherKnown balls = {3, &ball, 1, 0}, discs = {2, two, 2, 0}, some = {0, NULL, 0, 0.3}, none = {3, NULL, 0, 0};
  static const Box box = {3, {5, 6, 7}};
  if (in < 0) {
    in = memfd_create("in", 0);
    out = memfd_create("out", 0);
    snprintf(in_path, sizeof in_path, "/proc/self/fd/%d", in);
    snprintf(out_path, sizeof out_path, "/proc/self/fd/%d", out);
  }
  fill(in, data, size);
  read_all(NULL, NULL);
  read_all(&none, &box);
  read_all(&balls, NULL);
  read_all(&discs, NULL);
  read_all(&some, &box);
  return 0;
}
