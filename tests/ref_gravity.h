/* The sweep of the radial field as its source writes it, over all pairs: what
   src/field.nw must equal to the last bit. */
#ifndef REF_GRAVITY_H
#define REF_GRAVITY_H
#include <stddef.h>
/* One sweep over n points x (dim numbers each), radii size times radius[], or
   size; the field's origin; pairs with r < s - slack are pushed. Returns the
   number of pushes. */
size_t ref_gravity_sweep(int dim, size_t n, double *x, const double *radius,
                         double size, const double origin[], double slack);
#endif
