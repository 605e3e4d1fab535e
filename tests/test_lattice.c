/* tests/test_lattice.c: every lattice against its closed forms */
#include "cells.h"
#include "lattice.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <string.h>

static double reach_of(LatticeKind kind, int n_l, double radius,
                       double fraction) {
  Box box = lattice_box(kind, n_l, radius, fraction);
  return box_reach(&box);
}

static const struct {
  const char *name;
  int dim;
  size_t points;   /* of a cell */
  int shell[3];    /* neighbours in the first three shells */
  double far[3];   /* their squared distances in diameters */
  double touching; /* packing fraction */
} known[] = {
    {"simple cubic", 3, 1, {6, 12, 8}, {1, 2, 3}, M_PI / 6},
    {"bcc", 3, 2, {8, 6, 12}, {1, 4. / 3, 8. / 3}, M_SQRT3 *M_PI / 8},
    {"fcc", 3, 4, {12, 6, 24}, {1, 2, 3}, M_PI / (3 * M_SQRT2)},
    {"square", 2, 1, {4, 4, 4}, {1, 2, 4}, M_PI / 4},
    {"triangular", 2, 2, {6, 6, 6}, {1, 3, 4}, M_PI / (2 * M_SQRT3)},
};

/* Every particle has the known shells, and nothing between them. */
static void test_shells(const Pack *pack, int kind, int n_l, double sigma) {
  Neighbours *near =
      cells_neighbours(pack, 1.001 * sqrt(known[kind].far[2]) * sigma);
  for (int s = 0; s < 3; s++) {
    int wrong = 0;
    for (size_t i = 0; i < pack->n; i++) {
      int count = 0;
      for (size_t k = near->first[i]; k < near->first[i + 1]; k++)
        count += fabs(near->r[k] / sigma - sqrt(known[kind].far[s])) < 1e-12;
      wrong += count != known[kind].shell[s];
    }
    gsl_test_int(wrong, 0, "%s, n_l = %d: shell %d has %d", known[kind].name,
                 n_l, s + 1, known[kind].shell[s]);
  }
  size_t all = 0;
  for (int s = 0; s < 3; s++)
    all += (size_t)known[kind].shell[s] * pack->n;
  gsl_test(near->first[pack->n] != all, "%s, n_l = %d: no others",
           known[kind].name, n_l);
  cells_neighbours_free(&near);
}

static double margin(const Pack *pack) {
  double least = GSL_POSINF;
  int dim = pack->box.dim;
  for (size_t i = 0; i < pack->n; i++)
    for (int k = 0; k < dim; k++) {
      double x = pack->x[i * (size_t)dim + (size_t)k];
      least = GSL_MIN(least, GSL_MIN(x, pack->box.side[k] - x));
    }
  return least;
}

static void test_touching(int kind, int n_l) {
  Species species = {"AP", 0.7123, 999};
  LatticeKind lattice = (LatticeKind)kind;
  Pack *pack = lattice_make(lattice, n_l, &species, 0);
  const char *name = known[kind].name;
  double side = 2 * n_l + 1, cells = pow(side, known[kind].dim);
  gsl_test(pack->n != known[kind].points * (size_t)cells ||
               pack->n != lattice_points(lattice, n_l),
           "%s, n_l = %d: number", name, n_l);
  gsl_test_int(pack->box.dim, known[kind].dim, "%s: dimension", name);
  gsl_test(strcmp(pack->species[0].name, "AP") != 0 || pack->kinds != 1 ||
               pack->species[0].count != pack->n,
           "%s: species", name);
  gsl_test_rel(pack_fraction(pack), known[kind].touching, 1e-15,
               "%s, n_l = %d: fraction", name, n_l);
  gsl_test_rel(lattice_touching(lattice), known[kind].touching, 4e-16,
               "%s: touching fraction", name);
  gsl_test_abs(pack_audit(pack), 0, 1e-14, "%s, n_l = %d: least gap", name,
               n_l);
  gsl_test(margin(pack) < 0.3 * 0.7123, "%s, n_l = %d: clear of the sides",
           name, n_l);
  gsl_test_rel(reach_of(lattice, n_l, 0.7123, 0), box_reach(&pack->box), 1e-15,
               "%s, n_l = %d: reach", name, n_l);
  test_shells(pack, kind, n_l, 2 * 0.7123);
  pack_free(&pack);
}

static void test_opened(int kind, int n_l, double share) {
  Species species = {"", 1.371, 0};
  double fraction = share * known[kind].touching;
  double stretch = pow(1 / share, 1. / known[kind].dim);
  Pack *pack = lattice_make((LatticeKind)kind, n_l, &species, fraction);
  gsl_test_rel(pack_fraction(pack), fraction, 4e-15, "%s opened: fraction",
               known[kind].name);
  gsl_test_abs(pack_audit(pack), 2 * 1.371 * (stretch - 1), 2e-14,
               "%s opened: least gap", known[kind].name);
  gsl_test_rel(reach_of((LatticeKind)kind, n_l, 1.371, fraction),
               box_reach(&pack->box), 1e-15, "%s opened: reach",
               known[kind].name);
  test_shells(pack, kind, n_l, 2 * 1.371 * stretch);
  pack_free(&pack);
}

int main(void) {
  for (int kind = 0; kind < LATTICE_KINDS; kind++) {
    gsl_test_int(lattice_named(known[kind].name), kind, "%s by name",
                 known[kind].name);
    gsl_test(strcmp(lattice_name((LatticeKind)kind), known[kind].name) != 0,
             "the name of %s", known[kind].name);
    gsl_test_int(lattice_dim((LatticeKind)kind), known[kind].dim,
                 "%s: dimension by kind", known[kind].name);
    for (int n_l = 0; n_l < 4; n_l++)
      test_touching(kind, n_l);
    test_opened(kind, 2, 0.8137);
    test_opened(kind, 1, 0.0291);
    test_opened(kind, 0, 1);
  }
  gsl_test_int(lattice_named("hcp"), -1, "an unknown name");
  gsl_test_int(lattice_named(""), -1, "an empty name");
  gsl_test_rel(reach_of(LATTICE_CUBIC, 5, 1 / 11., 0), 1, 1e-15,
               "the box of B with n_l = 5 has the half side 1");
  return gsl_test_summary();
}
