#ifndef REF_CRM_H
#define REF_CRM_H
#include <stddef.h>
#include <stdint.h>
/* Growth of equal spheres in a periodic cube, as a textbook has it. */
typedef struct {
  size_t n, pair[2];              /* the pair that collided last */
  double side, *x, *v;            /* n x 3; the caller's to set, then start */
  double radius, growth;          /* at time 0; of the radius, by time */
  double now, virial;             /* sum of D J */
  uint64_t collisions, crossings; /* of pairs; of walls of cells */
  double *own, *time;             /* of each: time of its place; next event */
  size_t *partner, *heap, *place; /* what the event is; the heap; where in it */
  int many, (*cell)[3];           /* cells along a side; of each particle */
  size_t *head, *next;            /* linked lists of cells */
} RefCrm;
/* Cells for radii up to this. */
RefCrm *ref_crm_alloc(size_t n, double side, double radius);
void ref_crm_free(RefCrm *crm);
/* Foresee every event; the time is then 0. */
void ref_crm_start(RefCrm *crm, double radius, double growth);
/* Process events before this time, at most so many collisions. */
void ref_crm_run(RefCrm *crm, double until, uint64_t collisions);
/* All particles to the present time. */
void ref_crm_sync(RefCrm *crm);
#endif
