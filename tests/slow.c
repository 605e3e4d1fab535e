/* The long tests of growth and of chains: `slow NAME`; tests/slow-*.sh run them
   all. */
#include "few.h"
#include "chain.h"
#include "crm.h"
#include "order.h"
#include "py.h"
#include "theory.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

static const double cube[3] = {1, 1, 1};

static Pack *points(int dim, size_t n, size_t n2, double ratio, uint64_t seed) {
  Box box = box_make(dim, cube, 731.5);
  Species s[2] = {{.name = "A", .radius = 1, .count = n},
                  {.name = "B", .radius = ratio, .count = n2}};
  Pack *pack = pack_alloc(&box, s, n2 ? 2 : 1, false);
  Rng rng = rng_stream(seed, 0, RNG_TEST);
  for (size_t c = 0; c < pack->n * (size_t)dim; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[c % (size_t)dim];
  return pack;
}

/* Z of a fluid: blocks of 1000 collisions a particle. */
static void pressure(double phi, size_t n, int blocks) {
  Pack *pack = points(3, n, 0, 1, 40 + n);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .05, .fraction = phi,
                  .points = true};
  Rng rng = rng_stream(2, 7, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  if (!status)
    status = crm_equilibrate(pack, MOTION_EQUAL, 1000, blocks, 1000, &rng,
                             &report, &out);
  double want = few_pressure(phi, (double)n), off = report.Z - want;
  double most = 3 * report.Z_error + 2e-4 * want;
  gsl_test(status || fabs(off) > most,
           "phi=%g N=%zu: Z=%.5f +- %.5f, Schultz %.5f, with 1/N %.5f: %.2f se, "
           "%.1e", phi, n, report.Z, report.Z_error,
           theory_pressure(THEORY_SCHULTZ, phi), want, off / report.Z_error,
           off / want);
  double plain = theory_pressure(THEORY_SCHULTZ, phi);
  gsl_test(n < 1000 && fabs(plain - report.Z) < 5 * report.Z_error,
           "phi=%g N=%zu: without 1/N off by %.1f se, and that shows", phi, n,
           (report.Z - plain) / report.Z_error);
  pack_free(&pack);
}

/* The derivative of k = phi chi, of this order, at phi; and the coefficient of
   N^-2 in Z_N: chapter crm. */
static double k_of(double phi, int order) {
  const double h = phi / 50;
  if (order > 0)
    return (k_of(phi + h, order - 1) - k_of(phi - h, order - 1)) / (2 * h);
  return phi * 2 * h /
         ((phi + h) * theory_pressure(THEORY_SCHULTZ, phi + h) -
          (phi - h) * theory_pressure(THEORY_SCHULTZ, phi - h));
}
static double bracket(double phi) {
  double k1 = k_of(phi, 1);
  return phi * (k_of(phi, 2) / 8 - k1 * k1 / (12 * k_of(phi, 0)));
}
static double second(double phi) {
  const double h = phi / 50;
  return -phi * (bracket(phi + h) - bracket(phi - h)) / (2 * h);
}

/* 2e7 collisions of n in a box of sides 1, 1, length. */
static CrmReport in_box(double phi, size_t n, double length) {
  double ratio[3] = {1, 1, length};
  Box box = box_make(3, ratio, 731.5);
  Species species = {.name = "A", .radius = 1, .count = n};
  Pack *pack = pack_alloc(&box, &species, 1, false);
  Rng rng = rng_stream(3, 7, RNG_TEST);
  for (size_t c = 0; c < 3 * n; c++)
    pack->x[c] = rng_uniform(&rng) * box.side[c % 3];
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .05, .fraction = phi,
                  .points = true};
  CrmReport report = {.Z = GSL_NAN};
  Outcome out = {0};
  if (!crm_grow(pack, &plan, &rng, NULL, &out))
    crm_equilibrate(pack, MOTION_EQUAL, 1000, (int)(40000 / n), 1000, &rng,
                    &report, &out);
  pack_free(&pack);
  return report;
}

/* What is left of Z_N beyond 1/N is no power of N: it has the sign of the slope
   of g where a particle's own image is, and in a longer box it is another. */
static void images(double phi) {
  static const double number[] = {24, 32, 48, 64};
  double left[4], error[4], top = 0, bottom = 0, chi = 0;
  CrmReport at32 = {0};
  Py *py = py_alloc(phi);
  for (int k = 0; k < 4; k++) {
    double n = number[k], side = cbrt(n * 4 * M_PI / (3 * phi)), h = 1e-3;
    double slope = (py_g(py, side + h) - py_g(py, side - h)) / (2 * h);
    CrmReport report = in_box(phi, (size_t)n, 1);
    at32 = k == 1 ? report : at32;
    left[k] = report.Z - few_pressure(phi, n);
    error[k] = report.Z_error;
    gsl_test(!(left[k] * slope > 0) || fabs(left[k]) < 3 * error[k] ||
                 fabs(second(phi)) / (n * n) > .5 * error[k],
             "phi=%g N=%g: %.5f +- %.5f beyond 1/N (the next order %.5f); g' at "
             "the image %.1e", phi, n, left[k], error[k], second(phi) / (n * n),
             slope);
    top += left[k] / (n * n * error[k] * error[k]);
    bottom += 1 / (n * n * n * n * error[k] * error[k]);
  }
  for (int k = 0; k < 4; k++)
    chi += gsl_pow_2((left[k] - top / bottom / gsl_pow_2(number[k])) / error[k]);
  gsl_test(chi < 100, "no multiple of N^-2 fits: the best, %.3g, has chi^2 %.0f",
           top / bottom, chi);
  CrmReport rod = in_box(phi, 32, 2);
  double apart = (rod.Z - at32.Z) / hypot(rod.Z_error, at32.Z_error);
  gsl_test(!(fabs(apart) > 5), "N=32 in a box twice as long: Z=%.5f, %.5f in a "
           "cube, %.1f se", rod.Z, at32.Z, apart);
  gsl_test(fabs(second(.01) / (-12 * 1e-4) - 1) > .2,
           "N^-2 at low density: %.3g phi^2 of -12", second(.01) / 1e-4);
  py_free(&py);
}

/* A hundred million collisions leave the accounts as they were. */
static void constant(void) {
  Pack *pack = points(3, 2000, 0, 1, 3);
  CrmPlan plan = {.protocol = CRM_LITERAL, .rate = .1, .fraction = .45,
                  .points = true};
  Rng rng = rng_stream(2, 8, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  if (!status)
    status = crm_equilibrate(pack, MOTION_EQUAL, 50, 10, 1.05e4, &rng, &report,
                             &out);
  gsl_test(status || report.collisions < 100000000 ||
               report.unaccounted > 1e-12 || report.drift > 1e-12 ||
               pack_audit(pack) < -2e-12,
           "constant radii, %.3g collisions: energy %.1e, momentum %.1e, gap %.1e",
           (double)report.collisions, report.unaccounted, report.drift,
           pack_audit(pack) / 2);
  pack_free(&pack);
}

static void grown(CrmProtocol protocol, double rate) {
  Pack *pack = points(3, 1000, 0, 1, 4);
  CrmPlan plan = {.protocol = protocol, .rate = rate, .fraction = .49,
                  .points = true, .budget = 1e7};
  Rng rng = rng_stream(2, 9, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_grow(pack, &plan, &rng, &report, &out);
  gsl_test(status || report.collisions < 100000000 ||
               report.unaccounted > 1e-12 || report.slip > 1e-11 ||
               report.drift > 1e-12 || pack_audit(pack) < -2e-12 ||
               fabs(pack_fraction(pack) - .49) >= 1e-14,
           "%s growth, %.3g collisions: energy %.1e beyond a slip of %.1e, "
           "momentum %.1e, gap %.1e %s",
           protocol == CRM_LITERAL ? "literal" : "isothermal",
           (double)report.collisions, report.unaccounted, report.slip,
           report.drift, pack_audit(pack) / 2, out.text);
  pack_free(&pack);
}

/* A jammed pack has as many contacts as its backbone needs; gaps of contacts and
   of others are so far apart that a tenfold tolerance finds the same. */
static void isostatic(int dim, size_t n, size_t n2, double ratio, uint64_t seed,
                      double Z, double low, double high) {
  Pack *pack = points(dim, n, n2, ratio, seed);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .01, .points = true,
                  .pressure = Z, .budget = 1e6};
  Rng rng = rng_stream(seed, 10, RNG_TEST);
  CrmReport report;
  Outcome out = {0};
  int status = crm_jam(pack, &plan, &rng, &report, &out);
  Backbone frame = order_backbone(pack, 3e3 / Z, NULL);
  double phi = pack_fraction(pack), gap = pack_audit(pack) / 2;
  BondRule rule = order_rule(dim);
  long needed = dim * ((long)frame.particles - 1) + 1;
  gsl_test(status || labs((long)frame.contacts - needed) > 2 ||
               phi < low || phi > high || gap < -1e-12,
           "%d-D N=%zu: %zu contacts of %zu, %ld needed; phi %.4f, rattlers "
           "%.3f, Q6 %.3f, gap %.1e %s",
           dim, pack->n, frame.contacts, frame.particles, needed, phi,
           frame.rattlers, order_bonds(pack, &rule, NULL).global, gap, out.text);
  pack_free(&pack);
}

/* Ten million lifts: no overlap beyond rounding, also near jamming. Where the
   fluid is in equilibrium, Z of so few within four standard errors. */
static void chains(int dim, size_t n, size_t n2, double ratio, double phi,
                   ChainRule rule, bool fluid) {
  Pack *pack = points(dim, n, n2, ratio, 17);
  CrmPlan plan = {.protocol = CRM_ISOTHERMAL, .rate = .01, .fraction = phi,
                  .points = true};
  Rng rng = rng_stream(17, 10, RNG_TEST);
  Outcome out = {0};
  crm_grow(pack, &plan, &rng, NULL, &out);
  ChainPlan straight = {.rule = rule};
  ChainReport report = {0};
  Chain *chain = chain_alloc(pack, &straight, &out);
  chain_run(chain, 3000000, &rng, &report);
  memset(&report, 0, sizeof report);
  double least = INFINITY;
  for (int part = 0; part < 20; part++) {
    chain_run(chain, 500000, &rng, &report);
    chain_store(chain, pack);
    least = fmin(least, pack_audit(pack) / (2 * pack_smallest(pack)));
  }
  double off = fluid ? (report.Z - few_pressure(phi, (double)n)) / report.Z_error : 0;
  gsl_test(out.status || least < -1e-12 || fabs(off) > 4 || report.cut,
           "%d-D N=%zu+%zu at %g, %s: gap %.2g after %.0f lifts, Z = %.4f +- "
           "%.4f, off by %.2f se",
           dim, n, n2, phi, rule ? "newton" : "straight", least,
           (double)report.lifts, report.Z, report.Z_error, off);
  chain_free(&chain);
  pack_free(&pack);
}

int main(int count, char *words[]) {
  const char *name = count == 2 ? words[1] : "";
  if (!strcmp(name, "pressure")) {
    pressure(.10, 1000, 40);
    pressure(.30, 1000, 40);
    pressure(.45, 1000, 40);
    pressure(.49, 1000, 100);
    pressure(.30, 200, 150);
    pressure(.10, 64, 400);
  } else if (!strcmp(name, "images")) {
    images(.30);
  } else if (!strcmp(name, "accounts")) {
    constant();
    grown(CRM_LITERAL, 1.8e-5);
    grown(CRM_ISOTHERMAL, 2.5e-5);
  } else if (!strcmp(name, "jamming")) {
    for (uint64_t seed = 1; seed <= 3; seed++) {
      isostatic(3, 200, 0, 1, seed, 1e10, .62, .67);
      isostatic(2, 100, 100, 1.4, seed, 1e10, .82, .87);
    }
    isostatic(3, 60, 140, .5, 4, 1e10, .64, .70);
  } else if (!strcmp(name, "chains")) {
    for (ChainRule rule = CHAIN_STRAIGHT; rule <= CHAIN_NEWTON; rule++) {
      chains(3, 500, 0, 1, .30, rule, true);
      chains(3, 500, 0, 1, .45, rule, true);
      chains(3, 500, 0, 1, .49, rule, true);
      chains(3, 500, 0, 1, .63, rule, false);
      chains(2, 200, 300, .4, .82, rule, false);
    }
  } else
    return 2;
  return gsl_test_summary();
}
