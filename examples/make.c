/* examples/make.c: make a pack, and say how dense it is. Compile it with
   cc make.c $(pkg-config --cflags --libs randpack) */
#include <randpack.h>
#include <stdio.h>

int main(void) {
  size_t number[] = {150, 50};
  double radius[] = {1.0, 1.5}, fraction, gap;
  randpack_outcome out;
  randpack_pack *pack =
      randpack_grow(3, 2, number, radius, 0.58, 0.05, 2012, &out);
  if (!pack || randpack_fraction(pack, 0, &fraction, &out) ||
      randpack_least_gap(pack, &gap, &out) ||
      randpack_write(pack, "pack.xyz", &out)) {
    fprintf(stderr, "%s\n", out.text);
    return out.status;
  }
  printf("fraction %.6f, no overlap: %d\n", fraction, gap > -1e-12);
  randpack_free(pack);
  return 0;
}
