/* examples/measure.c: a pack that stands in arrays, here a lattice, and the
   numbers of its neighbours and its g(r). */
#include <randpack.h>
#include <stdio.h>

int main(void) {
  double side[] = {6, 6, 6}, x[27][3], radius = 1, g[4], mean;
  size_t count[8];
  for (int i = 0; i < 27; i++)
    for (int k = 0; k < 3; k++)
      x[i][k] = 2 * (k == 0 ? i / 9 : k == 1 ? i / 3 % 3 : i % 3);
  randpack_outcome out;
  randpack_pack *pack =
      randpack_from_arrays(3, side, 27, x[0], 1, &radius, NULL, &out);
  if (!pack || randpack_neighbours(pack, 1e-9, 8, count, &mean, &out) ||
      randpack_g(pack, 2, 0.25, 4, g, &out)) {
    fprintf(stderr, "%s\n", out.text);
    return out.status;
  }
  printf("%zu particles with 6 neighbours, %.1f in the mean\n", count[6], mean);
  for (int b = 0; b < 4; b++)
    printf("%.3f %.6f\n", 2 + 0.25 * (b + 0.5), g[b]);
  randpack_free(pack);
  return 0;
}
