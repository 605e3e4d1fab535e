/* Random sequential addition as a textbook has it: what src/rsa.nw is timed
   against. */
#ifndef REF_RSA_H
#define REF_RSA_H
#include "pack.h"
#include "rng.h"
/* Fill the pack of one species by points uniform in the whole box, each kept if
   it overlaps nobody, seen through cells of one diameter or more; a box of at
   least three cells a side. Returns the points drawn, at most most. */
uint64_t ref_rsa_fill(Pack *pack, Rng *rng, uint64_t most);
#endif
