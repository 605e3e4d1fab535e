#ifndef ENTRIES_H
#define ENTRIES_H
#include "entry.h"
#define MAKERS(X) \
X(rsa) X(crm) X(lattice) X(points) X(gravity) \
X(sequential) X(compression) X(relax) X(penetrable) X(homometric)
#define CHANGES(X) \
X(dilute) \
X(metropolis) X(retry) X(collision) X(collision_longest) X(chain) X(newton) X(dynamics) \
X(turning)
#define MEASURES(X) \
X(rdf) X(partials) X(shells) X(quotients) X(contact) X(pressure) X(coordination) X(order) \
X(histogram) X(nearest) X(K) X(I) X(profile) X(radial) X(approach) \
X(covered) X(percolation) X(shapes) X(S2) X(boolean) X(S3) X(structure) X(chords) \
X(pores) X(surface) X(cluster) X(bounds) X(sections)
#define CURVES(X) X(py) X(well_stirred) X(willis) X(willis_kanaun) X(mixture)
extern const Maker *const entries_makers[];
extern const Change *const entries_changes[];
extern const Measure *const entries_measures[];
extern const Curve *const entries_curves[];
typedef enum { ALL, STAGES, NO_STAGES } EntriesWhich;
void entries_names(const Entry *const list[], EntriesWhich which, char *names,
size_t room);
const Entry *entries_find(const Entry *const list[], const char *name);
#define ENTRIES(list) ((const Entry *const *)(const void *)(list))
#endif
