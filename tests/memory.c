/* tests/memory.c: each function of the library without memory. The first request fails, then only the second, and so on until a
   call asks no more often (of more than 64 those that are an eighth farther each time, unless EVERY is set): always an outcome, the pack as it was, and as many blocks as before. Linked with the static library,
   it has malloc and its kin of its own, which GSL, zlib and stdio use too; with -DWRAP and -Wl,--wrap=malloc,--wrap=calloc,
   --wrap=realloc,--wrap=aligned_alloc,--wrap=free only those of the library, so that valgrind can look on. */
#include <errno.h>
#include <randpack.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long asked, failing, live; /* requests; which one fails, 0: none; blocks */
static bool fails(void) {
  if (++asked != failing)
    return false;
  errno = ENOMEM;
  return true;
}

#ifdef WRAP
#define MINE(name) __wrap_##name
#define THEIR(name) __real_##name
#else
#define MINE(name) name
#define THEIR(name) __libc_##name
#define __libc_aligned_alloc __libc_memalign
#endif
void *THEIR(malloc)(size_t size);
void *THEIR(calloc)(size_t n, size_t size);
void *THEIR(realloc)(void *old, size_t size);
void *THEIR(aligned_alloc)(size_t unit, size_t size);
void THEIR(free)(void *block);
void *MINE(malloc)(size_t size);
void *MINE(calloc)(size_t n, size_t size);
void *MINE(realloc)(void *old, size_t size);
void *MINE(aligned_alloc)(size_t unit, size_t size);
void MINE(free)(void *block);

void *MINE(malloc)(size_t size) {
  void *fresh = fails() ? NULL : THEIR(malloc)(size);
  live += fresh != NULL;
  return fresh;
}
void *MINE(calloc)(size_t n, size_t size) {
  void *fresh = fails() ? NULL : THEIR(calloc)(n, size);
  live += fresh != NULL;
  return fresh;
}
void *MINE(realloc)(void *old, size_t size) {
  void *grown = fails() ? NULL : THEIR(realloc)(old, size);
  live += grown && !old;
  return grown;
}
void *MINE(aligned_alloc)(size_t unit, size_t size) {
  void *fresh = fails() ? NULL : THEIR(aligned_alloc)(unit, size);
  live += fresh != NULL;
  return fresh;
}
void MINE(free)(void *block) {
  live -= block != NULL;
  THEIR(free)(block);
}

/* --- the calls, each a pack that it makes, or a status */
static randpack_outcome out;
static randpack_pack *pack, *finite; /* to be measured and changed */
static const double box[] = {9, 9, 9}, side[] = {20, 20}, radius[] = {0.5, 0.8};
static const size_t number[] = {40, 20};
static double numbers[400];
static size_t counts[8];
static const char *path, *shapes;

typedef struct {
  const char *name;
  randpack_pack *(*makes)(void);
  int (*does)(void);
} Case;

static randpack_pack *from_arrays(void) {
  static const int species[] = {5, 1, 5};
  return randpack_from_arrays(3, box, 3, numbers, 1, radius, species, &out);
}
static randpack_pack *from_sample(void) {
  return randpack_from_arrays(3, NULL, 30, numbers, 1, radius, NULL, &out);
}
static randpack_pack *copy(void) { return randpack_copy(pack, &out); }
static randpack_pack *reading(void) { return randpack_read(path, &out); }
static randpack_pack *reading_shapes(void) { return randpack_read(shapes, &out); }
static randpack_pack *points(void) { return randpack_points(3, box, 2, number, radius, 1, &out); }
static randpack_pack *lattice(void) { return randpack_lattice("fcc", 3, 1, 0.5, &out); }
static randpack_pack *rsa(void) { return randpack_rsa(3, box, 2, number, radius, 0, 1, &out); }
static randpack_pack *saturate(void) { return randpack_saturate(2, side, 2, NULL, radius, 0, 1, &out); }
static randpack_pack *grow(void) { return randpack_grow(3, 2, number, radius, 0.5, 0.2, 1, &out); }
static randpack_pack *gravity(void) { return randpack_gravity(3, 2, number, radius, 1, &out); }
static randpack_pack *penetrable(void) { return randpack_penetrable(side, 2, number, radius, 0.15, 1, &out); }
static int writing(void) { return randpack_write(pack, path, &out); }
static int compress(void) { return randpack_compress(pack, 0.5, 0.2, 1, &out); }
static int shake(void) { return randpack_shake(pack, 0.3, 3, 1, NULL, &out); }
static int fraction(void) { return randpack_fraction(pack, 0, numbers, &out); }
static int fraction_finite(void) { return randpack_fraction(finite, 1, numbers, &out); }
static int gap(void) { return randpack_least_gap(pack, numbers, &out); }
static int g(void) { return randpack_g(pack, 0, 0.1, 30, numbers, &out); }
static int g_finite(void) { return randpack_g(finite, 0, 0.1, 20, numbers, &out); }
static int K(void) { return randpack_K(pack, 0.1, 30, numbers, &out); }
static int neighbours(void) { return randpack_neighbours(pack, 0.2, 8, counts, numbers, &out); }
static int structure(void) { return randpack_structure(pack, 0.5, 10, numbers, numbers + 10, numbers + 20, &out); }
static int S2(void) { return randpack_S2(pack, 0.1, 20, numbers, &out); }
static int py(void) {
  static const double R[] = {2, 4, 20};
  return randpack_py(0.5, 3, R, numbers, &out);
}
static int equation(void) { return randpack_equation("klm", 0.5, numbers, numbers + 1, &out); }
static int mixture(void) { return randpack_mixture("bmcsl", 2, radius, radius, 0.5, numbers, numbers + 4, &out); }
static randpack_pack *discs;
static int covered(void) { return randpack_covered(discs, numbers, &out); }
static randpack_pack *crossing; /* a few discs that overlap */
static int S2_of_discs(void) { return randpack_S2(crossing, 0.5, 2, numbers, &out); }
static randpack_pack *equal, *few;
/* Of a copy, since it takes long to jam a pack of many. */
static int jam(void) {
  randpack_pack *copied = randpack_copy(few, &out);
  int status = copied ? randpack_jam(copied, 0.1, 1, &out) : out.status;
  randpack_free(copied);
  return status;
}
static int contact(void) { return randpack_contact(equal, numbers, numbers + 1, &out); }

static const Case cases[] = {
    {"from_arrays", from_arrays, NULL}, {"from_arrays, finite", from_sample, NULL}, {"copy", copy, NULL},
    {"points", points, NULL}, {"lattice", lattice, NULL}, {"rsa", rsa, NULL}, {"saturate", saturate, NULL},
    {"grow", grow, NULL}, {"gravity", gravity, NULL}, {"penetrable", penetrable, NULL},
    {"write", NULL, writing}, {"read", reading, NULL}, {"read, shapes", reading_shapes, NULL},
    {"compress", NULL, compress}, {"jam", NULL, jam}, {"shake", NULL, shake}, {"fraction", NULL, fraction}, {"fraction, finite", NULL, fraction_finite},
    {"covered", NULL, covered}, {"least_gap", NULL, gap}, {"g", NULL, g}, {"g, finite", NULL, g_finite}, {"K", NULL, K},
    {"contact", NULL, contact}, {"neighbours", NULL, neighbours}, {"structure", NULL, structure}, {"S2", NULL, S2},
    {"S2 of discs", NULL, S2_of_discs}, {"py", NULL, py}, {"equation", NULL, equation}, {"mixture", NULL, mixture}};

/* --- without the k-th block */
static double places[180], then[180];
static bool is_changed(void) {
  randpack_to_arrays(pack, then, NULL, NULL);
  return memcmp(places, then, sizeof then) != 0;
}

static const char *judge(const Case *c, long k, long before) {
  randpack_pack *made = NULL, *keep = NULL;
  asked = failing = 0;
  keep = randpack_copy(pack, NULL);
  double kept[sizeof numbers / sizeof *numbers], blank[sizeof numbers / sizeof *numbers];
  memcpy(kept, numbers, sizeof numbers);
  memset(blank, 0x5a, sizeof blank);
  if (c->does)
    memcpy(numbers, blank, sizeof numbers);
  asked = 0;
  failing = k;
  int status = c->makes ? 0 : c->does();
  if (c->makes && !(made = c->makes()))
    status = out.status;
  failing = 0;
  bool lacked = asked >= k, changed = is_changed(), written = c->does && memcmp(numbers, blank, sizeof numbers);
  memcpy(numbers, kept, sizeof numbers);
  randpack_free(made);
  if (changed) { /* as it was, for the next case */
    randpack_free(pack);
    pack = keep;
  } else
    randpack_free(keep);
  if (live != before)
    return "blocks are left, or freed twice";
  if (status == RANDPACK_DONE)
    return NULL; /* nothing failed, or stdio has done without a buffer */
  if (!lacked)
    return out.text;
  if (written)
    return "numbers are written, though it failed";
  return status != RANDPACK_UNREACHED || !strstr(out.text, "memory") || changed ? "no outcome, or a changed pack" : NULL;
}

static int try_case(const Case *c) {
  long before = live, k = 0, tried = 0;
  const char *why = NULL;
  do {
    k += k < 64 || getenv("EVERY") ? 1 : k / 8;
    why = judge(c, k, before);
  } while (!why && asked >= k && ++tried);
  if (why)
    printf("FAIL: %s without request %ld: %s\n", c->name, k, why);
  else
    printf("PASS: %s without one request: each of %ld, of %ld\n", c->name, tried, asked);
  return why != NULL;
}

/* memory PACK.xyz SHAPES.xyz: the first is written and read, the second read. */
int main(int count, char *words[]) {
  static char buffer[1 << 16];
  int failed = 0;
  long at_start = live;
  if (count != 3)
    return 2;
  path = words[1];
  shapes = words[2];
  setvbuf(stdout, buffer, _IOLBF, sizeof buffer);
  pack = randpack_rsa(3, box, 2, number, radius, 0, 2, &out);
  finite = randpack_gravity(3, 2, number, radius, 2, &out);
  discs = randpack_penetrable(side, 2, number, radius, 0.15, 2, &out);
  crossing = randpack_from_arrays(2, box, 3, (double[]){4, 4, 4.5, 4, 4, 5}, 1, radius + 1, NULL, &out);
  equal = randpack_rsa(3, box, 1, number, radius, 0, 2, &out);
  few = randpack_grow(2, 1, (size_t[]){8}, radius, 0.5, 0.2, 2, &out);
  randpack_to_arrays(pack, places, NULL, NULL);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    failed |= try_case(&cases[i]);
  randpack_free(pack);
  randpack_free(finite);
  randpack_free(discs);
  randpack_free(crossing);
  randpack_free(equal);
  randpack_free(few);
  printf("%s: all is freed\n", live != at_start ? "FAIL" : "PASS");
  return failed || live != at_start;
}
