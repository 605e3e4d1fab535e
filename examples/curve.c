/* examples/curve.c: the radial distribution function of Percus and Yevick. */
#include <randpack.h>
#include <stdio.h>

int main(void) {
  double R[33], g[33];
  for (int i = 0; i < 33; i++)
    R[i] = 2 + 0.125 * i;
  randpack_outcome out;
  if (randpack_py(0.575, 33, R, g, &out)) {
    fprintf(stderr, "%s\n", out.text);
    return out.status;
  }
  for (int i = 0; i < 33; i++)
    printf("%.3f %.9f\n", R[i], g[i]);
  return 0;
}
