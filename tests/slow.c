/* The long tests of growth and of chains: `slow NAME`; tests/slow-*.sh run them
   all. */
#include "chain.h"
#include "crm.h"
#include "order.h"
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

/* What N particles in a periodic box have, from the fluid's Z: chapter crm. */
static double of_few(double phi, double n) {
  const double h = 1e-3;
  double Z[3], f[3], excess[3];
  for (int k = 0; k < 3; k++) {
    f[k] = phi + (k - 1) * h;
    Z[k] = theory_pressure(THEORY_SCHULTZ, f[k]);
    excess[k] = f[k] * (Z[k] - 1);
  }
  double chi = 2 * h / (f[2] * Z[2] - f[0] * Z[0]);
  double curve = (excess[0] - 2 * excess[1] + excess[2]) / (h * h);
  return Z[1] - phi * chi * curve / (2 * n);
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
  double want = of_few(phi, (double)n), off = report.Z - want;
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
    status = crm_equilibrate(pack, MOTION_EQUAL, 0, 10, 1e4, &rng, &report, &out);
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
               report.unaccounted > 1e-12 || report.drift > 1e-12 ||
               pack_audit(pack) < -2e-12 ||
               fabs(pack_fraction(pack) - .49) >= 1e-14,
           "%s growth, %.3g collisions: energy %.1e, momentum %.1e, gap %.1e %s",
           protocol == CRM_LITERAL ? "literal" : "isothermal",
           (double)report.collisions, report.unaccounted, report.drift,
           pack_audit(pack) / 2, out.text);
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
  Backbone frame = order_backbone(pack, 3e3 / Z);
  double phi = pack_fraction(pack), gap = pack_audit(pack) / 2;
  BondRule rule = order_rule(dim);
  long needed = dim * ((long)frame.particles - 1) + 1;
  gsl_test(status || labs((long)frame.contacts - needed) > 2 ||
               phi < low || phi > high || gap < -1e-12,
           "%d-D N=%zu: %zu contacts of %zu, %ld needed; phi %.4f, rattlers "
           "%.3f, Q6 %.3f, gap %.1e %s",
           dim, pack->n, frame.contacts, frame.particles, needed, phi,
           frame.rattlers, order_bonds(pack, &rule).global, gap, out.text);
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
  double off = fluid ? (report.Z - of_few(phi, (double)n)) / report.Z_error : 0;
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
