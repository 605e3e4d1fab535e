/* The finite sum over shells, with each residue a contour integral: the mean
   over NODES points of a circle about each zero of S, in 113 bits. Neither the
   power series of src/py.nw nor its poles are used. */
#include "ref_py.h"
#include <complex.h>

/* clang knows the type by its older name only, and the C library then does not declare its functions. */
#ifdef __clang__
__extension__ typedef __float128 Quad;
#else
__extension__ typedef _Float128 Quad;
#endif
typedef _Complex float __attribute__((mode(TC))) Complex;
Quad acosf128(Quad), cosf128(Quad), sinf128(Quad), fabsf128(Quad);
Quad powf128(Quad, Quad), crealf128(Complex), cimagf128(Complex), cabsf128(Complex);
Complex cexpf128(Complex);
enum { NODES = 128 };

static Complex cubic(Quad phi, Complex t, Complex *slope) {
  Quad d = 1 - phi, a = d * d, b = 6 * phi * d, c = 18 * phi * phi;
  *slope = (3 * a * t + 2 * b) * t + c;
  return ((a * t + b) * t + c) * t - 12 * phi * (1 + 2 * phi);
}

static Complex polish(Quad phi, Complex t) {
  Complex slope;
  for (int i = 0; i < 200; i++) {
    Complex value = cubic(phi, t, &slope);
    t -= value / slope;
  }
  return t;
}

/* Sum of the residues at one zero of S, of all shells that reach x. */
static Complex residues(Quad phi, Complex zero, Quad radius, Quad x) {
  Quad turn = 4 * acosf128((Quad)0) / NODES;
  Complex sum = 0, slope;
  for (int k = 0; k < NODES; k++) {
    Quad angle = turn * ((Quad)k + (Quad)0.5);
    Complex off = radius * (cosf128(angle) + I * sinf128(angle));
    Complex t = zero + off, S = cubic(phi, t, &slope), shells = 0, power = 1;
    Complex factor = ((1 + phi / 2) * t + 1 + 2 * phi) / S * cexpf128(-t);
    for (int n = 1; (Quad)n <= x; n++) {
      power *= factor;
      shells += power;
      power *= -12 * phi;
    }
    sum += off * t * shells * cexpf128(t * x);
  }
  return sum / NODES;
}

double ref_py_error(double phi, double R, double g) {
  Quad f = phi, d = 1 - f, x = (Quad)R / 2;
  Quad scale = powf128(12 * f * (1 + 2 * f) / (d * d), (Quad)1 / 3);
  Quad alpha = 6 * f / d;
  Complex real = polish(f, scale);
  Complex pair = polish(f, -alpha / 2 + I * scale);
  Quad gap = cabsf128(pair - real), other = 2 * fabsf128(cimagf128(pair));
  Quad radius = (gap < other ? gap : other) / 4;
  Quad sum = crealf128(residues(f, real, radius, x)) +
             2 * crealf128(residues(f, pair, radius, x));
  return (double)fabsf128(sum / x - (Quad)g);
}
