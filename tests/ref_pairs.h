/* Plain scalar pair counts: what the kernel of src/pairs.nw is tested and
   timed against. The binning is that of pairs_count, operation by operation. */
#ifndef REF_PAIRS_H
#define REF_PAIRS_H
#include "partials.h"
/* All pairs of nearest images, two loops. Returns pairs below origin. */
uint64_t ref_pairs_all(const Pack *pack, double origin, double step,
                       size_t bins, uint64_t count[]);
/* The textbook's way: linked lists of cells as wide as the reach, each with
   the half of its 26 (8) neighbours; falls back to all pairs in narrow boxes. */
uint64_t ref_pairs_lists(const Pack *pack, double origin, double step,
                         size_t bins, uint64_t count[]);
/* Counts by species into the bins of these partials, which must be of this
   pack: the same lists, as wide as the largest reach of any two species, and a
   look at both species for each pair. */
void ref_pairs_species(const Pack *pack, Partials *partials);
#endif
