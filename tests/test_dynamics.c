/* Shapes in motion: forces against sums over images, conserved quantities, laws of contact. */
#include "dynamics.h"
#include "elementary.h"
#include "overlap.h"
#include "scatter.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <string.h>

static Shape *shape_of(int k) {
  return k == 0 ? shape_regular(5) : k == 1 ? shape_regular(4) : k == 2 ? shape_superellipse(1.5, 1.5) : NULL;
}

/* Some particles of each kind at random in a box of these sides; discs if the kind has no shape. */
static Pack *random_pack(size_t n, int kinds, const int kind[], double Lx, double Ly, uint64_t seed) {
  Species species[3] = {{{0}, 0, 0, NULL}};
  Box box = {2, {Lx, Ly, 0}};
  for (int s = 0; s < kinds; s++)
    species[s] = (Species){"A", 1 + 0.37 * s, n, shape_of(kind[s])};
  return scattered(&box, species, kinds, seed);
}

static const DynamicsModel frictionless = {0};

/* The example of the chapter. */
static void test_example(void) {
  const int square[] = {1};
  Pack *pack = random_pack(2, 1, square, 20, 20, 1);
  double S = (sqrt(M_PI) - 1.5) * (sqrt(M_PI) - 0.3), f = 1.25 * sqrt(sqrt(S));
  double x[4] = {3, 19.9, 4.5, 0.2};
  memcpy(pack->x, x, sizeof x);
  pack->angle[0] = pack->angle[1] = M_PI / 4;
  Dynamics *d = dynamics_alloc(pack, &frictionless, 1);
  const DynamicsMotion *m = d->motion;
  dynamics_find_forces(d, DYNAMICS_SPRINGS);
  gsl_test_rel(sqrt(m[0].fx * m[0].fx + m[0].fy * m[0].fy), 2 * sqrt(S / M_PI), 1e-13, "S's force");
  gsl_test_rel(m[0].fy / m[0].fx, (sqrt(M_PI) - 1.5) / (sqrt(M_PI) - 0.3), 1e-12, "is across the lens");
  gsl_test_rel(d->overlap, S, 1e-13, "the overlap");
  gsl_test_int((int)d->contacts, 1, "one contact");
  gsl_test_int(d->deep, 1, "which is deep");
  dynamics_find_forces(d, DYNAMICS_AREA);
  gsl_test_rel(m[0].fx, f * (0.3 - sqrt(M_PI)), 1e-12, "the force of the area, x");
  gsl_test_rel(m[1].fy, f * (sqrt(M_PI) - 1.5), 1e-12, "the force of the area, y");
  d->model.centres = true;
  dynamics_find_forces(d, DYNAMICS_SPRINGS);
  gsl_test_rel(m[0].fy / m[0].fx, 0.2, 1e-12, "S's normal is along the centres");
  dynamics_free(&d);
  pack_free(&pack);
}

/* Forces and torques of the area against a sum over all images of all pairs, in wide, narrow and tiny boxes, at
   the start and after some steps. */
static void test_images(size_t n, int kinds, const int kind[], double Lx, double Ly) {
  Pack *pack = random_pack(n, kinds, kind, Lx, Ly, 5);
  Dynamics *d = dynamics_alloc(pack, &frictionless, 1);
  double off = 0;
  for (int steps = 0; steps < 60; steps++) {
    dynamics_find_forces(d, DYNAMICS_AREA);
    for (size_t i = 0; steps % 20 == 0 && i < pack->n; i++) {
      double fx = 0, fy = 0, torque = 0;
      for (size_t j = 0; j < pack->n; j++)
        for (int p = -4; p <= 4; p++)
          for (int q = -4; q <= 4; q++) {
            Body A = d->body[i], B = d->body[j];
            Overlap o;
            B.x += p * Lx, B.y += q * Ly;
            if ((i == j && p == 0 && q == 0) || !overlap_find(&A, &B, &o))
              continue;
            double f = 1.25 * sqrt(sqrt(o.area) / GSL_MIN(A.radius, B.radius));
            fx += f * o.fx, fy += f * o.fy, torque += f * o.torque_A;
          }
      const DynamicsMotion *m = &d->motion[i];
      off = GSL_MAX(off, fabs(m->fx - fx) + fabs(m->fy - fy) + fabs(m->torque - torque));
    }
    dynamics_move(d, 0.2, 0.1);
  }
  gsl_test(off > 1e-9, "%zu polygons in %g by %g: forces and sums over images, off by %g", pack->n, Lx, Ly, off);
  dynamics_free(&d);
  pack_free(&pack);
}

/* Momentum, and angular momentum of a cluster far from the sides, with all of S's terms. */
static void test_conserved(void) {
  const int kinds[] = {0, 2};
  Pack *pack = random_pack(6, 2, kinds, 100, 100, 9);
  DynamicsModel model = {false, 0.7, 0.3, 0.4};
  for (size_t k = 0; k < 2 * pack->n; k++)
    pack->x[k] = 45 + pack->x[k] / 14;
  Dynamics *d = dynamics_alloc(pack, &model, 1);
  Rng rng = rng_stream(3, 0, RNG_TEST);
  dynamics_kick(d, 0.3, &rng);
  double before[3] = {0}, after[3] = {0}, pushed = 0;
  for (int stage = 0; stage < 2; stage++) {
    double *sum = stage ? after : before;
    for (int t = 0; stage && t < 40; t++) {
      dynamics_find_forces(d, DYNAMICS_SPRINGS);
      for (size_t i = 0; i < pack->n; i++)
        pushed += fabs(d->motion[i].torque);
      dynamics_move(d, 0.05, 0);
    }
    for (size_t i = 0; i < pack->n; i++) {
      const DynamicsMotion *m = &d->motion[i];
      sum[0] += m->vx;
      sum[1] += m->vy;
      sum[2] += d->body[i].x * m->vy - d->body[i].y * m->vx + m->w / m->weight;
    }
  }
  for (int k = 0; k < 3; k++)
    gsl_test(fabs(after[k] - before[k]) > 1e-10, "%s is kept: %g", k < 2 ? "momentum" : "angular momentum", after[k] - before[k]);
  gsl_test(pushed < 1, "and there were torques, %g", pushed);
  dynamics_free(&d);
  pack_free(&pack);
}

/* The energy of areas, equation (energy), and that of motion: their sum drifts as the square of the step. */
static double energy_drift(double dt) {
  const int pentagon[] = {0};
  Pack *pack = random_pack(2, 1, pentagon, 30, 30, 2);
  double x[4] = {10, 10, 11.9, 10.3}, most = 0, first = 0;
  memcpy(pack->x, x, sizeof x);
  pack->angle[0] = 0.3, pack->angle[1] = 1.9;
  Dynamics *d = dynamics_alloc(pack, &frictionless, 1);
  d->motion[0].vx = 0.3, d->motion[1].vx = -0.4, d->motion[1].w = 0.2;
  for (int t = 0; t < (int)(1.5 / dt + 0.5); t++) {
    DynamicsMotion old[2];
    double kinetic = 0;
    Overlap o;
    dynamics_find_forces(d, DYNAMICS_AREA);
    overlap_find(&d->body[0], &d->body[1], &o);
    memcpy(old, d->motion, sizeof old);
    dynamics_move(d, dt, 0);
    for (int i = 0; i < 2; i++) { /* velocities at the time of the places */
      double vx = (old[i].vx + d->motion[i].vx) / 2, vy = (old[i].vy + d->motion[i].vy) / 2;
      double w = (old[i].w + d->motion[i].w) / 2;
      kinetic += (vx * vx + vy * vy + w * w / d->motion[i].weight) / 2;
    }
    double E = kinetic + o.area * sqrt(sqrt(o.area));
    first = t == 0 ? E : first;
    most = GSL_MAX(most, fabs(E - first));
  }
  dynamics_free(&d);
  pack_free(&pack);
  return most;
}

/* Drag alone: v falls as exp(-drag t); angles advance by w t; a disc is not turned. */
static void test_flight(void) {
  const int kinds[] = {0, 3};
  Pack *pack = random_pack(1, 2, kinds, 50, 50, 2);
  double x[4] = {10, 10, 30, 30}, c, s;
  memcpy(pack->x, x, sizeof x);
  pack->angle[0] = 5;
  Dynamics *d = dynamics_alloc(pack, &frictionless, 1);
  Rng rng = rng_stream(8, 0, RNG_TEST);
  dynamics_kick(d, 0.5, &rng);
  gsl_test(d->motion[1].w != 0 || d->motion[1].vx == 0, "a disc is kicked, not turned");
  d->motion[0].vx = 1.7, d->motion[0].vy = -60, d->motion[0].w = 0.11;
  for (int t = 0; t < 500; t++) {
    dynamics_find_forces(d, DYNAMICS_SPRINGS);
    dynamics_move(d, 0.01, 0.7);
  }
  double left = exp(-0.7 * 5), way = (1 - left) / 0.7;
  gsl_test_rel(d->motion[0].vx, 1.7 * left, 1e-4, "velocity under drag");
  gsl_test_abs(d->body[0].x, 10 + 1.7 * way, 1e-2, "way under drag");
  dynamics_store(d);
  elementary_turn(5 + 0.11 * way, &c, &s);
  gsl_test_abs(d->body[0].c, c, 1e-3, "turn under drag, cosine");
  gsl_test_abs(d->body[0].s, s, 1e-3, "turn under drag, sine");
  gsl_test_abs(pack->angle[0], 5 + 0.11 * way, 1e-3, "angle in a turn");
  gsl_test_abs(pack->x[1], box_wrap(10 - 60 * way + 100, 50), 0.5, "place in the box");
  dynamics_stop(d);
  gsl_test(d->motion[0].vx != 0 || d->motion[0].w != 0 || d->motion[1].vy != 0, "stopped");
  dynamics_free(&d);
  pack_free(&pack);
}

/* Two squares side by side that slide: the shear is gamma u, or mu times the normal force; damping along it. */
static void test_contact(void) {
  const int square[] = {1};
  Pack *pack = random_pack(2, 1, square, 20, 20, 1);
  double S = (sqrt(M_PI) - 1.5) * (sqrt(M_PI) - 0.3), x[4] = {3, 5, 4.5, 5.3};
  memcpy(pack->x, x, sizeof x);
  pack->angle[0] = pack->angle[1] = M_PI / 4;
  DynamicsModel model = {true, 0.5, 0, 0.1};
  double n[2] = {-1.5 / sqrt(2.34), -0.3 / sqrt(2.34)}, delta = 2 * sqrt(S / M_PI);
  for (int k = 0; k < 3; k++) {
    model.damping = k == 2 ? 0.8 : 0;
    Dynamics *d = dynamics_alloc(pack, &model, 1);
    double u = k == 1 ? 50 : 0.9, along = 0.2;
    d->motion[0].vx = -n[1] * u + n[0] * along, d->motion[0].vy = n[0] * u + n[1] * along;
    dynamics_find_forces(d, DYNAMICS_SPRINGS);
    const DynamicsMotion *m = d->motion;
    double F = m[0].fx * n[0] + m[0].fy * n[1], T = -m[0].fx * n[1] + m[0].fy * n[0];
    gsl_test_rel(F, delta - (k == 2 ? 0.8 * along : 0), 1e-12, "contact %d: normal force", k);
    gsl_test_rel(T, k == 1 ? -0.5 * delta : -0.09, 1e-12, "contact %d: shear", k);
    dynamics_free(&d);
  }
  pack_free(&pack);
}

/* Particles at one place part. */
static void test_coincident(void) {
  const int disc[] = {3};
  Pack *pack = random_pack(2, 1, disc, 20, 20, 1);
  memset(pack->x, 0, 4 * sizeof *pack->x);
  DynamicsModel model = {true, 0, 0, 0};
  Dynamics *d = dynamics_alloc(pack, &model, 1);
  dynamics_find_forces(d, DYNAMICS_SPRINGS);
  gsl_test(!(fabs(d->motion[0].fx) > 1) || d->motion[1].fx != -d->motion[0].fx, "two discs at one place part: %g", d->motion[0].fx);
  dynamics_free(&d);
  pack_free(&pack);
}

int main(void) {
  const int mixed[] = {0, 1}, squares[] = {1};
  test_example();
  test_images(12, 2, mixed, 11, 9);
  test_images(3, 2, mixed, 3.1, 4.3);
  test_images(1, 1, squares, 1.6, 2.1);
  test_conserved();
  double coarse = energy_drift(0.02), fine = energy_drift(0.005);
  gsl_test(coarse > 3e-3 || fine > coarse / 5, "energy of areas and of motion: off by %g and %g", coarse, fine);
  test_flight();
  test_contact();
  test_coincident();
  return gsl_test_summary();
}
