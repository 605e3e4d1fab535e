#include "microstructure.h"
#include "lattice.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdio.h>
static const double A2[][2] = {{.5118, .9505}, {.1442, .9486}, {.3118, .4233}, {.8277, .4092}, {.3297, .7884}, {.9617, .7248}, {.5412, .2769}, {.6457, .7199}};
static const double A3[][3] = {{.1286, .4993, .6015}, {.0287, .1479, .9282}, {.6219, .369, .5114}, {.8167, .5491, .9809}, {.3533, .5916, .2353}, {.1598, .9964, .4597}};
int main(void) {
  for (int dim = 2; dim <= 3; dim++)
    for (double err = 1e-3; err > 1e-12; err *= 1e-2)
    for (double bal = 0.7; bal < 1.6; bal *= 1.4) {
      Species sp = {.name = "P", .radius = dim == 2 ? .12 : .2, .count = dim == 2 ? 8 : 6};
      Box box = {dim, {1, 1, dim == 3}};
      Pack *p = pack_alloc(&box, &sp, 1, false);
      for (size_t i = 0; i < p->n * (size_t)dim; i++)
        p->x[i] = dim == 2 ? A2[i / 2][i % 2] : A3[i / 3][i % 3];
      Microstructure m;
      Outcome out = {0};
      MicrostructurePlan plan = {err, bal};
      microstructure_balls(p, &plan, &m, NULL, &out);
      double z = dim == 2 ? .119434713606 : .027765116261, e = dim == 2 ? .235564601646 : .097699096096;
      printf("%d %g %.2f: %.13f %.13f  rel %.2g %.2g est %.2g deg %d %d pairs %g %s\n", dim, err, bal, m.zeta, m.eta, m.zeta / z - 1, m.eta / e - 1, m.error, m.degree, m.far_degree, m.pairs, out.text);
      pack_free(&p);
    }
  return 0;
}
