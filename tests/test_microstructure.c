/* tests/test_microstructure.c: zeta and eta against recorded lattices and packs, against quadrature of the exact field, closed forms of
   dilute packs, and what must not change them */
#include "ewald.h"
#include "lattice.h"
#include "many.h"
#include "microstructure.h"
#include "scatter.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_legendre.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

/* Particles x, y, (z,) radius in a box. */
static Microstructure measured(const Pack *pack, double error, double balance, double (*own)[2]) {
  Microstructure found;
  Outcome out = {0};
  MicrostructurePlan plan = {error, balance};
  microstructure_balls(pack, &plan, &found, own, &out);
  gsl_test(out.status, "measured: %s", out.text);
  return found;
}

/* ---- two irregular packs, to their last digit */
static const double discs8[] = {.5118, .9505, .1442, .9486, .3118, .4233, .8277, .4092, .3297, .7884, .9617, .7248, .5412, .2769, .6457, .7199};
static const double balls6[] = {.1286, .4993, .6015, .0287, .1479, .9282, .6219, .369, .5114, .8167, .5491, .9809, .3533, .5916, .2353, .1598, .9964, .4597};
static const double unit[3] = {1, 1, 1};

static Pack *eight_discs(void) {
  static const double r[8] = {.12, .12, .12, .12, .12, .12, .12, .12};
  return particles(2, unit, 8, discs8, r);
}
static Pack *six_balls(void) {
  static const double r[6] = {.2, .2, .2, .2, .2, .2};
  return particles(3, unit, 6, balls6, r);
}

static void test_irregular(void) {
  static const double zeta[] = {.119434713606, .027765116261}, eta[] = {.235564601646, .097699096096};
  for (int dim = 2; dim <= 3; dim++)
    for (double balance = 0.75; balance < 1.5; balance += 0.3) {
      Pack *pack = dim == 2 ? eight_discs() : six_balls();
      Microstructure m = measured(pack, 1e-13, balance, NULL);
      gsl_test_abs(m.zeta, zeta[dim - 2], 1.1e-12, "irregular, %d-D, zeta, balance %g", dim, balance);
      gsl_test_abs(m.eta, eta[dim - 2], 1.1e-12, "irregular, %d-D, eta, balance %g", dim, balance);
      pack_free(&pack);
    }
}

/* What is asked for is kept: the error, and its estimate, are below. */
static void test_error(void) {
  for (int dim = 2; dim <= 3; dim++) {
    Pack *pack = dim == 2 ? eight_discs() : six_balls();
    Microstructure best = measured(pack, 1e-11, 1, NULL);
    for (double error = 1e-2; error > 1e-10; error *= 0.1) {
      Microstructure m = measured(pack, error, 1, NULL);
      double off = fabs(m.eta / best.eta - 1), z = fabs(m.zeta / best.zeta - 1);
      gsl_test(off > error || z > error, "error %g, %d-D: %g and %g", error, dim, off, z);
      gsl_test(m.error < off || m.error > error, "estimated of %g, %d-D: %g, is %g", error, dim, m.error, off);
    }
    pack_free(&pack);
  }
}

/* On lattices that touch all neighbours add up, and most degrees vanish. */
static void test_error_of_lattices(void) {
  for (int kind = 0; kind < LATTICE_KINDS; kind++) {
    Species species = {.name = "P", .radius = 1};
    Pack *pack = lattice_make((LatticeKind)kind, 0, &species, 0);
    Microstructure best = measured(pack, 1e-11, 1, NULL);
    for (double error = 1e-3; error > 1e-9; error *= 0.1) {
      Microstructure m = measured(pack, error, 1, NULL);
      double off = fabs(m.eta / best.eta - 1), z = fabs(m.zeta / best.zeta - 1);
      gsl_test(off > m.error || z > m.error || m.error > error, "touching, %s, %g: %g and %g, estimated %g", lattice_name((LatticeKind)kind),
               error, off, z, m.error);
    }
    pack_free(&pack);
  }
}

/* ---- lattices; a fraction of 0 is touching */
static Pack *lattice_pack(LatticeKind kind, int n_l, double radius, double fraction) {
  Species species = {.name = "P", .radius = radius};
  return lattice_make(kind, n_l, &species, fraction);
}

static void test_lattices(void) {
  static const struct {
    const char *name;
    LatticeKind kind;
    double phi, zeta, eta;
  } known[] = {{"square", LATTICE_SQUARE, .2, .000611698424, .074372592314},
               {"square", LATTICE_SQUARE, .4, .013063253729, .201877822043},
               {"square", LATTICE_SQUARE, .6, .099650280394, .291050612818},
               {"hexagonal", LATTICE_TRIANGULAR, .2, .000006033774, .010957337637},
               {"hexagonal", LATTICE_TRIANGULAR, .4, .000514884175, .124087666617},
               {"hexagonal", LATTICE_TRIANGULAR, .6, .008797658604, .375359145711},
               {"cubic", LATTICE_CUBIC, .2, .004947367405, .065349124067},
               {"cubic", LATTICE_CUBIC, .4, .067808284715, .173036436741},
               {"bcc", LATTICE_BCC, .2, .000606696216, .027207427982},
               {"bcc", LATTICE_BCC, .4, .010661772971, .140684928646},
               {"bcc", LATTICE_BCC, .6, .079557280114, .289878399524},
               {"fcc", LATTICE_FCC, .2, .000397165027, .026775465034},
               {"fcc", LATTICE_FCC, .4, .007735687452, .144025026514},
               {"fcc", LATTICE_FCC, .6, .061973183419, .292827012323}};
  for (size_t k = 0; k < sizeof known / sizeof *known; k++)
    for (int n_l = 0; n_l <= (known[k].kind == LATTICE_SQUARE ? 1 : 0); n_l++) {
      Pack *pack = lattice_pack(known[k].kind, n_l, 1.37, known[k].phi);
      Microstructure m = measured(pack, 1e-13, 1, NULL);
      gsl_test_abs(m.zeta, known[k].zeta, 1.1e-12, "%s at %g, %d, zeta", known[k].name, known[k].phi, n_l);
      gsl_test_abs(m.eta, known[k].eta, 1.1e-12, "%s at %g, %d, eta", known[k].name, known[k].phi, n_l);
      pack_free(&pack);
    }
  Pack *square = lattice_pack(LATTICE_SQUARE, 0, 1, 0), *cubic = lattice_pack(LATTICE_CUBIC, 0, 1, 0);
  gsl_test_abs(measured(square, 1e-9, 1, NULL).zeta, .5513166, 6e-8, "touching discs");
  gsl_test_abs(measured(cubic, 1e-9, 1, NULL).zeta, .2135434, 6e-8, "touching spheres");
  pack_free(&square);
  pack_free(&cubic);
}

/* ---- the exact field, by a plain Ewald sum of its own at any point, and its square by quadrature over the particles. The kernels of
   degree m: in the plane Z^-2 and conj(Z) Z^-3 - (3/2) a^2 Z^-4; in space C_M / R^3 of degree 2, and of degree 4 with the factor
   1 - (7/5) a^2 / R^2. Each is H R^(-2p). */
static double complex harmonic(int dim, int m, int n, const double d[3]) {
  if (dim == 2)
    return cpow(d[0] - d[1] * I, m);
  double r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), norm = sqrt(4 * M_PI / (2 * m + 1));
  return r > 0 ? norm * pow(r, m) * gsl_sf_legendre_sphPlm(m, n, d[2] / r) * cexp(I * n * atan2(d[1], d[0])) : 0;
}

typedef struct {
  const Pack *pack;
  size_t waves;
  double (*k)[3], kappa;
  double complex *rho[2]; /* of a^d and a^(d+2) */
} Plain;

static Plain plain_make(const Pack *pack, double kappa, double cut) {
  Plain p = {.pack = pack, .kappa = kappa};
  int dim = pack->box.dim, most = 12;
  p.k = malloc(sizeof *p.k * 25 * 25 * 25);
  for (int a = -most; a <= most; a++)
    for (int b = -most; b <= most; b++)
      for (int c = dim == 3 ? -most : 0; c <= (dim == 3 ? most : 0); c++) {
        double k[3] = {2 * M_PI * a / pack->box.side[0], 2 * M_PI * b / pack->box.side[1], dim == 3 ? 2 * M_PI * c / pack->box.side[2] : 0};
        double square = k[0] * k[0] + k[1] * k[1] + k[2] * k[2];
        if (square > 0 && square < 4 * kappa * kappa * cut * cut)
          memcpy(p.k[p.waves++], k, sizeof k);
      }
  for (int r = 0; r < 2; r++) {
    p.rho[r] = calloc(p.waves, sizeof *p.rho[r]);
    for (size_t v = 0; v < p.waves; v++)
      for (size_t j = 0; j < pack->n; j++) {
        double phase = 0;
        for (int x = 0; x < dim; x++)
          phase += p.k[v][x] * pack->x[j * (size_t)dim + (size_t)x];
        p.rho[r][v] += gsl_pow_int(pack_radius(pack, j), dim + 2 * r) * cexp(I * phase);
      }
  }
  return p;
}

static void plain_free(Plain *p) {
  free(p->k);
  free(p->rho[0]);
  free(p->rho[1]);
}

/* sum of a_j^power H R^(-2p) over all but the particle `not` itself, at x; p = m + d/2 - 1, or one less. */
static double complex plain_sum(const Plain *q, const double x[], size_t not, int m, int n, int less, int second, double cut) {
  const Pack *pack = q->pack;
  int dim = pack->box.dim, images = 3;
  double p = m + 0.5 * dim - 1 - less, V = pack->box.side[0] * pack->box.side[1] * (dim == 3 ? pack->box.side[2] : 1);
  double complex sum = 0;
  for (size_t v = 0; v < q->waves; v++) {
    double square = 0, phase = 0;
    for (int c = 0; c < dim; c++) {
      square += q->k[v][c] * q->k[v][c];
      phase += q->k[v][c] * x[c];
    }
    double y = square / (4 * q->kappa * q->kappa), four = 4 / square;
    sum += q->rho[second][v] * cexp(-I * phase) * harmonic(dim, m, n, q->k[v]) * (less ? four * four * (1 + y) : four) * exp(-y);
  }
  sum *= pow(M_PI, 0.5 * dim) * cpow(-I, m) / (pow(2, m) * tgamma(p) * V);
  for (size_t j = 0; j < pack->n; j++)
    for (int a = -images; a <= images; a++)
      for (int b = -images; b <= images; b++)
        for (int c = dim == 3 ? -images : 0; c <= (dim == 3 ? images : 0); c++) {
          int at[3] = {a, b, c};
          double d[3] = {0}, square = 0;
          for (int e = 0; e < dim; e++) {
            d[e] = pack->x[j * (size_t)dim + (size_t)e] + at[e] * pack->box.side[e] - x[e];
            square += d[e] * d[e];
          }
          double y = square * q->kappa * q->kappa, share[8];
          if (y > cut * cut)
            continue;
          bool self = j == not && !a && !b && !c;
          ewald_shares(dim, 6, y, share);
          double Q = share[m - less];
          double complex h = square > 0 ? harmonic(dim, m, n, d) * pow(square, -p) : 0;
          sum += gsl_pow_int(pack_radius(pack, j), dim + 2 * second) * h * (self ? Q - 1 : Q);
        }
  return sum;
}

/* zeta and eta from the squares of the fields at a point, (microstructure:squares), times f1 f2. */
static void squares_at(const Plain *q, const double x[], size_t i, double *zeta, double *theta) {
  int dim = q->pack->box.dim;
  double cut = 5.2;
  *zeta = *theta = 0;
  if (dim == 2) {
    *zeta = gsl_pow_2(cabs(plain_sum(q, x, i, 2, 0, 0, 0, cut)));
    *theta = 4 * gsl_pow_2(cabs(plain_sum(q, x, i, 4, 0, 1, 0, cut) - 1.5 * plain_sum(q, x, i, 4, 0, 0, 1, cut)));
    return;
  }
  for (int n = 0; n <= 2; n++)
    *zeta += (n ? 2 : 1) * gsl_pow_2(cabs(plain_sum(q, x, i, 2, n, 0, 0, cut)));
  for (int n = 0; n <= 4; n++) /* C_4/R^3 = H R^-7, C_4/R^5 = H R^-9 */
    *theta += (n ? 2 : 1) * gsl_pow_2(cabs(plain_sum(q, x, i, 4, n, 1, 0, cut) - 1.4 * plain_sum(q, x, i, 4, n, 0, 1, cut)));
  *theta *= 75 / 28.0 * 16 / 9;
}

static void by_quadrature(const Pack *pack, int radial, int polar, int around, double *zeta, double *eta) {
  int dim = pack->box.dim;
  Plain q = plain_make(pack, dim == 2 ? 3.7 : 4.1, 5.2);
  gsl_integration_glfixed_table *r = gsl_integration_glfixed_table_alloc((size_t)radial), *c = gsl_integration_glfixed_table_alloc((size_t)polar);
  double z = 0, t = 0, solid = 0, V = pack->box.side[0] * pack->box.side[1] * (dim == 3 ? pack->box.side[2] : 1);
  for (size_t i = 0; i < pack->n; i++)
    for (int u = 0; u < radial; u++)
      for (int v = 0; v < (dim == 3 ? polar : 1); v++)
        for (int w = 0; w < around; w++) {
          double rho, weight, cosine = 0, more = 2, a = pack_radius(pack, i), x[3] = {0}, phi = 2 * M_PI * w / around, one, two;
          gsl_integration_glfixed_point(0, a, (size_t)u, &rho, &weight, r);
          if (dim == 3)
            gsl_integration_glfixed_point(-1, 1, (size_t)v, &cosine, &more, c);
          weight *= dim == 3 ? rho * rho * more * 2 * M_PI / around : rho * 2 * M_PI / around;
          double flat = rho * sqrt(1 - cosine * cosine), d[3] = {flat * cos(phi), flat * sin(phi), rho * cosine};
          for (int e = 0; e < dim; e++)
            x[e] = pack->x[i * (size_t)dim + (size_t)e] + d[e];
          squares_at(&q, x, i, &one, &two);
          z += weight * one;
          t += weight * two;
          solid += weight;
        }
  /* g = pi (or 4 pi / 3) times the sums */
  double f = solid / V;
  *zeta = z / V / (f * (1 - f));
  *eta = t / V / (f * (1 - f)) + (dim == 3 ? 5 * *zeta / 21 : 0);
  gsl_integration_glfixed_table_free(r);
  gsl_integration_glfixed_table_free(c);
  plain_free(&q);
}

static void test_quadrature(void) {
  static const double side2[3] = {1.13, .87, 0}, x2[] = {.31, .22, .805, .51, .32, .63, .83, .105}, r2[] = {.17, .24, .12, .09};
  static const double side3[3] = {1.21, .93, 1.07}, x3[] = {.33, .41, .52, .87, .36, .31}, r3[] = {.24, .15};
  double zeta, eta;
  Pack *plane = particles(2, side2, 4, x2, r2), *space = particles(3, side3, 2, x3, r3);
  by_quadrature(plane, as_many(9, 24), 1, as_many(24, 64), &zeta, &eta);
  Microstructure m = measured(plane, 1e-11, 1, NULL);
  gsl_test_abs(m.zeta, zeta, as_many(3, 1) * 1e-8, "quadrature in the plane, zeta");
  gsl_test_abs(m.eta, eta, as_many(30, 1) * 1e-8, "quadrature in the plane, eta");
  by_quadrature(space, as_many(3, 12), as_many(5, 14), as_many(9, 26), &zeta, &eta);
  m = measured(space, 1e-11, 1, NULL);
  gsl_test_rel(m.zeta, zeta, as_many(10000, 1) * 1e-7, "quadrature in space, zeta");
  gsl_test_rel(m.eta, eta, as_many(10000, 1) * 1e-7, "quadrature in space, eta");
  pack_free(&plane);
  pack_free(&space);
}

/* ---- two particles far from their images at all distances: the dilute limit, in closed form */
static double closed_Z(int dim, double nu) {
  if (dim == 2)
    return 1 / (1 + 2 * nu);
  return 3 / (16 * gsl_pow_3(nu)) * (2 * nu * (1 + nu) * (1 + 2 * nu + 2 * nu * nu) / gsl_pow_2(1 + 2 * nu) - log1p(2 * nu));
}
static double closed_E(int dim, double nu) {
  if (dim == 2)
    return (((46 * nu + 74) * nu + 39) * nu * nu + 8 * nu + 1) / gsl_pow_5(1 + 2 * nu);
  double top = (((((464 * nu + 1392) * nu + 2136) * nu + 1952) * nu + 994) * nu + 250) * nu + 25;
  return 5 * closed_Z(3, nu) / 21 + (1 + nu) * top / (14 * nu * nu * gsl_pow_6(1 + 2 * nu)) - 25 / (28 * gsl_pow_3(nu)) * log1p(2 * nu);
}

static void test_dilute(void) {
  enum { POINTS = 12 };
  gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(POINTS);
  for (int dim = 2; dim <= 3; dim++)
    for (int ratio = 1; ratio <= 3; ratio += 2) {
      double radius[2] = {ratio, 1}, touch = ratio + 1, L = dim == 2 ? 3e5 : 3e3, side[3] = {L, L, L}, sum[2][2] = {{0}};
      for (size_t k = 0; k < POINTS; k++) {
        double u, weight, own[2][2], x[6] = {.31 * L, .22 * L, .47 * L, 0};
        gsl_integration_glfixed_point(0, 1 / touch, k, &u, &weight, table); /* R = 1/u, dR = -R^2 du */
        double R = 1 / u, d[3] = {R * .48, R * .6, R * .64};
        if (dim == 2)
          d[0] = R * .6, d[1] = R * .8;
        for (int e = 0; e < dim; e++)
          x[dim + e] = fmod(x[e] + d[e], L);
        Pack *pack = particles(dim, side, 2, x, radius);
        if (R < L / 3)
          measured(pack, 1e-9, 1, own);
        else
          memset(own, 0, sizeof own);
        for (int h = 0; h < 2; h++)
          for (int w = 0; w < 2; w++)
            sum[h][w] += weight * R * R * (dim == 2 ? 2 * M_PI * R : 4 * M_PI * R * R) * own[h][w] / pack_ball(dim, radius[1 - h]);
        pack_free(&pack);
      }
      for (int h = 0; h < 2; h++) {
        double nu = radius[h] / radius[1 - h];
        gsl_test_rel(sum[h][0], closed_Z(dim, nu), 2e-5, "dilute, %d-D, a_i/a_j = %g, zeta", dim, nu);
        gsl_test_rel(sum[h][1], closed_E(dim, nu), 2e-5, "dilute, %d-D, a_i/a_j = %g, eta", dim, nu);
      }
    }
  gsl_integration_glfixed_table_free(table);
}

/* ---- what changes nothing */
static void test_invariance(void) {
  for (int dim = 2; dim <= 3; dim++) {
    static const double side[3] = {1.13, .87, .95};
    static const double x[] = {.31, .22, .4, .805, .51, .43, .3, .63, .81, .83, .105, .9}, r[] = {.17, .24, .12, .09};
    double y[8 * 3], s[8], wide[3] = {2 * side[0], side[1], side[2]}, turned[3] = {0}, large[3];
    double flat[12];
    for (int i = 0; i < 4; i++)
      for (int k = 0; k < dim; k++)
        flat[i * dim + k] = x[i * 3 + k];
    Pack *pack = particles(dim, side, 4, flat, r);
    Microstructure m = measured(pack, 1e-10, 1, NULL);
    for (int i = 0; i < 8; i++) {
      s[i] = r[i % 4];
      for (int k = 0; k < dim; k++)
        y[i * dim + k] = flat[i % 4 * dim + k] + (k == 0 && i >= 4 ? side[0] : 0);
    }
    Pack *twice = particles(dim, wide, 8, y, s);
    for (int i = 0; i < 4; i++)
      for (int k = 0; k < dim; k++) {
        turned[(k + 1) % dim] = side[k];
        y[i * dim + (k + 1) % dim] = k == 0 ? flat[i * dim] : side[k] - flat[i * dim + k];
      }
    Pack *quarter = particles(dim, turned, 4, y, r);
    for (int i = 0; i < 4; i++)
      s[i] = 1e3 * r[i];
    for (int k = 0; k < 3; k++)
      large[k] = 1e3 * side[k];
    for (int k = 0; k < 4 * dim; k++)
      y[k] = 1e3 * flat[k];
    Pack *scaled = particles(dim, large, 4, y, s);
    Pack *other[] = {twice, quarter, scaled};
    static const char *what[] = {"two copies of the box", "turned by a right angle", "a thousand times larger"};
    for (int k = 0; k < 3; k++) {
      Microstructure n = measured(other[k], 1e-10, 1, NULL);
      gsl_test_rel(n.zeta, m.zeta, 1e-10, "%d-D, %s, zeta", dim, what[k]);
      gsl_test_rel(n.eta, m.eta, 1e-10, "%d-D, %s, eta", dim, what[k]);
      pack_free(&other[k]);
    }
    pack_free(&pack);
  }
}

/* ---- sizes */
static void test_unequal(void) {
  enum { SMALL = 24 };
  double x[2 * (SMALL + 1)], r[SMALL + 1], own[SMALL + 1][2], side[3] = {400, 400, 0};
  x[0] = x[1] = 200;
  r[0] = 1;
  for (int i = 1; i <= SMALL; i++) { /* each almost touches the large one, unevenly spaced */
    double at = 0.02 + 0.2 * i + 0.04 * i * (i % 3) / SMALL, R = 1.0101 + 0.002 * (i % 4);
    x[2 * i] = 200 + R * cos(at);
    x[2 * i + 1] = 200 + R * sin(at);
    r[i] = 0.01;
  }
  Pack *pack = particles(2, side, SMALL + 1, x, r);
  Microstructure m = measured(pack, 1e-9, 1, own);
  double complex sum = 0;
  for (int j = 1; j <= SMALL; j++)
    for (int k = 1; k <= SMALL; k++) {
      double complex Z = x[2 * j] - 200 + (x[2 * j + 1] - 200) * I, W = x[2 * k] - 200 + (x[2 * k + 1] - 200) * I;
      sum += 1e-8 / cpow(Z * conj(W) - 1, 2);
    }
  gsl_test_rel(own[0][0], creal(sum), 1e-6, "100:1 in the plane, without a series");
  gsl_test(m.degree < 500, "100:1 takes many degrees: %d", m.degree);
  pack_free(&pack);
  static const double y[] = {.5, .5, .5, .941, .5, .5, .2, .22, .205}, s[] = {.4, .04, .1}, cube[3] = {1, 1, 1};
  Pack *space = particles(3, cube, 3, y, s);
  double share[2][3][2];
  Microstructure one = measured(space, 1e-6, 0.8, share[0]), two = measured(space, 1e-10, 1.3, share[1]), three = measured(space, 1e-4, 1, NULL);
  gsl_test_rel(share[0][1][1], share[1][1][1], 1e-6, "10:1 in space, the share of the small one");
  gsl_test_rel(one.eta, two.eta, 1e-6, "10:1 in space, two balances");
  gsl_test_rel(three.eta, two.eta, 1e-4, "10:1 in space, two errors");
  gsl_test_rel(three.zeta, two.zeta, 1e-4, "10:1 in space, two errors, zeta");
  pack_free(&space);
}

/* ---- refused */
static void test_refused(void) {
  static const double x[] = {.1, .1, .1, .5, .5, .5}, over[] = {.4, .3}, tiny[] = {.4, 1e-5};
  static const double y[] = {.5, .5, .5, .90001, .5, .5};
  Microstructure m;
  MicrostructurePlan plan = {1e-7, 1};
  Pack *pack[] = {particles(3, unit, 2, x, over), particles(3, unit, 2, y, tiny), particles(3, unit, 0, x, over)};
  static const char *words[] = {"overlap by 0.0239", "more than 1024 degrees", "without particles"};
  for (int k = 0; k < 3; k++) {
    Outcome out = {0};
    int status = microstructure_balls(pack[k], &plan, &m, NULL, &out);
    gsl_test(status != UNREACHED || !strstr(out.text, words[k]), "refused: %s", out.text);
    pack_free(&pack[k]);
  }
}

/* ---- blocks: shares that are given, error by hand */
static void test_blocks(void) {
  enum { N = 256 };
  double x[2 * N], r[N], own[N][2], error[2], side[3] = {4, 4, 0};
  for (int i = 0; i < N; i++) {
    x[2 * i] = (i % 16 + 0.5) / 4;
    x[2 * i + 1] = (i / 16 + 0.5) / 4;
    r[i] = 0.1;
    int block = i % 16 / 4 * 4 + i / 64;
    own[i][0] = block; /* the variance of 0..15 is 340/15; of their mean 340/15/16 */
    own[i][1] = i % 2;
  }
  Pack *pack = particles(2, side, N, x, r);
  MicrostructurePlan plan = {1e-6, 1};
  microstructure_blocks(pack, &plan, (const double(*)[2])own, error);
  gsl_test_rel(error[0], sqrt(340 / 240.0) / (1 - pack_fraction(pack)), 1e-12, "blocks");
  gsl_test_abs(error[1], 0, 1e-12, "blocks, all alike");
  pack_free(&pack);
}

/* ---- finite packs. The hosts of a box once with five copies of it along each axis around them, as a finite pack, and once by Ewald's
   sums: shaken cells of a lattice, of two sizes. */
static Pack *cells_at(int dim, const Pack *box, int copies, bool host[]) {
  double wide = 2.0 * copies * box->box.side[0], side[3] = {wide, wide, wide}, *x, *r;
  size_t all = (size_t)gsl_pow_int(copies, dim), n = box->n * all;
  x = malloc(n * (size_t)dim * sizeof *x);
  r = malloc(n * sizeof *r);
  for (size_t c = 0, p = 0; c < all; c++) {
    size_t at[3] = {c % (size_t)copies, c / (size_t)copies % (size_t)copies, c / (size_t)(copies * copies)};
    bool middle = true;
    for (int k = 0; k < dim; k++)
      middle &= at[k] == (size_t)copies / 2;
    for (size_t i = 0; i < box->n; i++, p++) {
      for (int k = 0; k < dim; k++)
        x[p * (size_t)dim + (size_t)k] = wide / 4 + (double)at[k] * box->box.side[0] + box->x[i * (size_t)dim + (size_t)k];
      r[p] = pack_radius(box, i);
      host[p] = middle;
    }
  }
  Pack *pack = particles(dim, side, n, x, r);
  pack->open = wide / 4;
  free(x);
  free(r);
  return pack;
}

static void test_finite(void) {
  enum { SIDE = 4, COPIES = 5 };
  for (int dim = 2; dim <= 3; dim++) {
    double x[64 * 3], r[64], side[3] = {SIDE, SIDE, SIDE};
    size_t n = (size_t)gsl_pow_int(SIDE, dim);
    bool *host = malloc(n * 125 * sizeof *host);
    Rng rng = rng_stream(16, (uint64_t)dim, RNG_POSITIONS);
    for (size_t i = 0; i < n; i++) {
      size_t at[3] = {i % SIDE, i / SIDE % SIDE, i / (SIDE * SIDE)};
      r[i] = i % 2 ? .3 : .2;
      for (int k = 0; k < dim; k++)
        x[i * (size_t)dim + (size_t)k] = (double)at[k] + .3 + .4 * rng_uniform(&rng);
    }
    Pack *box = particles(dim, side, n, x, r), *finite = cells_at(dim, box, COPIES, host);
    Microstructure exact = measured(box, 1e-8, 1, NULL), found;
    double(*own)[2] = malloc(finite->n * sizeof *own), error[2], last = GSL_POSINF;
    for (double reach = 2; reach <= 8; reach *= 2) {
      Outcome out = {0};
      MicrostructurePlan plan = {1e-6, 1, host, reach, pack_fraction(box)};
      gsl_test_int(microstructure_balls(finite, &plan, &found, own, &out), DONE, "finite, %d-D, to %g: %s", dim, reach, out.text);
      double off = GSL_MAX(fabs(found.zeta / exact.zeta - 1), fabs(found.eta / exact.eta - 1));
      gsl_test(off > last / 2, "finite, %d-D, to %g: off by %.2g, before %.2g", dim, reach, off, last);
      last = off;
      microstructure_blocks(finite, &plan, (const double(*)[2])own, error);
    }
    gsl_test(last > 2e-3, "finite, %d-D: the same hosts, off by %.2g", dim, last);
    gsl_test(!(error[0] > 0 && error[0] < 0.5 * found.zeta) && n > 40, "finite, %d-D: error of blocks, %g of %g", dim, error[0], found.zeta);
    pack_free(&box);
    pack_free(&finite);
    free(own);
    free(host);
  }
}

/* Two discs alone, whose shares are a geometric series. */
static void test_pair_alone(void) {
  static const double x[] = {18, 20, 20.5, 20}, r[] = {1, 1}, side[3] = {40, 40, 0};
  bool host[] = {true, false};
  double own[2][2];
  Microstructure found;
  Outcome out = {0};
  Pack *pack = particles(2, side, 2, x, r);
  MicrostructurePlan plan = {1e-11, 1, host, 5, 0.25};
  pack->open = 9;
  microstructure_balls(pack, &plan, &found, own, &out);
  gsl_test_rel(own[0][0], 1 / 27.5625, 1e-10, "a pair alone, z");
  gsl_test_rel(found.zeta, 1 / (27.5625 * 0.75), 1e-10, "a pair alone, zeta by f1");
  plan.reach = 2.4;
  microstructure_balls(pack, &plan, &found, own, &out);
  gsl_test_abs(found.zeta, 0, 0, "a pair alone, beyond the reach");
  pack_free(&pack);
}

int main(void) {
  test_finite();
  test_pair_alone();
  test_irregular();
  test_error();
  test_error_of_lattices();
  test_lattices();
  test_quadrature();
  test_dilute();
  test_invariance();
  test_unequal();
  test_refused();
  test_blocks();
  return gsl_test_summary();
}
