/* Event-driven growth as a textbook has it, after Alder and Wainwright and
   Lubachevsky: linked-list cells with crossings of their walls as events, one
   event a particle in a binary heap. No neighbour lists, no vectors, no order
   in memory. It shares nothing with the engine. */
#include "ref_crm.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>

static const size_t NONE = SIZE_MAX; /* look again; or 1, 2, 3 less: a wall */

RefCrm *ref_crm_alloc(size_t n, double side, double radius) {
  RefCrm *c = calloc(1, sizeof *c);
  c->n = n;
  c->side = side;
  c->many = (int)(side / (2 * radius));
  assert(c->many >= 3);
  size_t cells = (size_t)c->many * (size_t)c->many * (size_t)c->many;
  c->x = calloc(3 * n, sizeof *c->x);
  c->v = calloc(3 * n, sizeof *c->v);
  c->own = calloc(n, sizeof *c->own);
  c->time = calloc(n, sizeof *c->time);
  c->partner = calloc(n, sizeof *c->partner);
  c->heap = calloc(n, sizeof *c->heap);
  c->place = calloc(n, sizeof *c->place);
  c->cell = calloc(n, sizeof *c->cell);
  c->head = calloc(cells, sizeof *c->head);
  c->next = calloc(n, sizeof *c->next);
  return c;
}

void ref_crm_free(RefCrm *c) {
  void *all[] = {c->x,    c->v,     c->own,  c->time, c->partner,
                 c->heap, c->place, c->cell, c->head, c->next};
  for (size_t k = 0; k < sizeof all / sizeof *all; k++)
    free(all[k]);
  free(c);
}

/* ------------------------------------------------------------ the heap */
static void put(RefCrm *c, size_t h, size_t i) {
  c->heap[h] = i;
  c->place[i] = h;
}

static void set_time(RefCrm *c, size_t i, double time) {
  size_t h = c->place[i];
  c->time[i] = time;
  while (h > 0 && c->time[c->heap[(h - 1) / 2]] > time) {
    put(c, h, c->heap[(h - 1) / 2]);
    h = (h - 1) / 2;
  }
  for (size_t k; (k = 2 * h + 1) < c->n; h = k) {
    if (k + 1 < c->n && c->time[c->heap[k + 1]] < c->time[c->heap[k]])
      k++;
    if (c->time[c->heap[k]] >= time)
      break;
    put(c, h, c->heap[k]);
  }
  put(c, h, i);
}

/* ------------------------------------------------------------ the cells */
static size_t *head_of(const RefCrm *c, const int at[3]) {
  size_t m = (size_t)c->many;
  return c->head + ((size_t)at[0] * m + (size_t)at[1]) * m + (size_t)at[2];
}

static void enter(RefCrm *c, size_t i) {
  size_t *head = head_of(c, c->cell[i]);
  c->next[i] = *head;
  *head = i;
}

static void leave(RefCrm *c, size_t i) {
  size_t *link = head_of(c, c->cell[i]);
  while (*link != i)
    link = c->next + *link;
  *link = c->next[i];
}

static void carry(RefCrm *c, size_t i) {
  for (size_t k = 0; k < 3; k++)
    c->x[3 * i + k] += c->v[3 * i + k] * (c->now - c->own[i]);
  c->own[i] = c->now;
}

static void cross(RefCrm *c, size_t i, size_t k) {
  int *at = c->cell[i] + k, m = c->many;
  leave(c, i);
  *at += c->v[3 * i + k] > 0 ? 1 : -1;
  if (*at < 0 || *at == m) {
    c->x[3 * i + k] += *at < 0 ? c->side : -c->side;
    *at = (*at + m) % m;
  }
  enter(c, i);
  c->crossings++;
}

/* ------------------------------------------------------------ foresight */
/* From j to i's nearest image of it, now. */
static void between(const RefCrm *c, size_t i, size_t j, double d[3]) {
  double age = c->now - c->own[j];
  for (size_t k = 0; k < 3; k++) {
    d[k] = c->x[3 * j + k] + c->v[3 * j + k] * age - c->x[3 * i + k];
    d[k] += d[k] > c->side / 2 ? -c->side : d[k] < -c->side / 2 ? c->side : 0;
  }
}

/* When i, which stands at the present time, meets j. */
static double meet(const RefCrm *c, size_t i, size_t j) {
  double D = 2 * (c->radius + c->growth * c->now), rate = 2 * c->growth;
  double d[3], uu = 0, du = 0, dd = 0;
  between(c, i, j, d);
  for (size_t k = 0; k < 3; k++) {
    double u = c->v[3 * j + k] - c->v[3 * i + k];
    uu += u * u;
    du += d[k] * u;
    dd += d[k] * d[k];
  }
  double A = uu - rate * rate, B = du - D * rate, C = dd - D * D;
  double q = B * B - A * C;
  if (B < 0 && C <= 0)
    return c->now;
  if (B < 0)
    return q < 0 ? INFINITY : c->now + C / (sqrt(q) - B);
  return A < 0 ? c->now + (B + sqrt(fmax(q, 0))) / -A : INFINITY;
}

/* Among the 27 cells around: the first that i would meet before that one's
   own event; or the wall of its cell. Who loses a partner looks again when that
   event is due. */
static void foresee(RefCrm *c, size_t i) {
  size_t had = c->partner[i], partner = had;
  double first = had < c->n ? c->time[i] : INFINITY, width = c->side / c->many;
  int s[3], m = c->many;
  for (size_t k = 0; k < 3; k++) {
    double v = c->v[3 * i + k], wall = (c->cell[i][k] + (v > 0)) * width;
    double far = wall - c->x[3 * i + k], t = c->now + fmax(far / v, 0);
    if (v != 0 && t < first) {
      first = t;
      partner = NONE - 1 - k;
    }
  }
  for (s[0] = -1; s[0] <= 1; s[0]++)
    for (s[1] = -1; s[1] <= 1; s[1]++)
      for (s[2] = -1; s[2] <= 1; s[2]++) {
        int at[3];
        for (int k = 0; k < 3; k++) {
          at[k] = c->cell[i][k] + s[k];
          at[k] += at[k] < 0 ? m : at[k] >= m ? -m : 0;
        }
        for (size_t j = *head_of(c, at); j != NONE; j = c->next[j]) {
          double t = j != i ? meet(c, i, j) : INFINITY;
          if (t < first && t < c->time[j]) {
            first = t;
            partner = j;
          }
        }
      }
  if (partner == had && had < c->n)
    return;
  if (had < c->n)
    c->partner[had] = NONE;
  c->partner[i] = partner;
  set_time(c, i, first);
  if (partner < c->n) {
    if (c->partner[partner] < c->n)
      c->partner[c->partner[partner]] = NONE;
    c->partner[partner] = i;
    set_time(c, partner, first);
  }
}

/* ------------------------------------------------------------ the events */
static void collide(RefCrm *c, size_t i, size_t j) {
  double D = 2 * (c->radius + c->growth * c->now), d[3], r = 0, w = 0;
  carry(c, j);
  between(c, i, j, d);
  for (size_t k = 0; k < 3; k++)
    r += d[k] * d[k];
  r = sqrt(r);
  for (size_t k = 0; k < 3; k++)
    w += d[k] / r * (c->v[3 * j + k] - c->v[3 * i + k]);
  double J = 2 * c->growth - w;
  for (size_t k = 0; k < 3; k++) {
    c->v[3 * i + k] -= J * d[k] / r;
    c->v[3 * j + k] += J * d[k] / r;
  }
  c->virial += D * J;
  c->collisions++;
  c->pair[0] = i;
  c->pair[1] = j;
}

void ref_crm_start(RefCrm *c, double radius, double growth) {
  size_t m = (size_t)c->many;
  c->radius = radius;
  c->growth = growth;
  c->now = c->virial = 0;
  c->collisions = c->crossings = 0;
  for (size_t k = 0; k < m * m * m; k++)
    c->head[k] = NONE;
  for (size_t i = 0; i < c->n; i++) {
    for (size_t k = 0; k < 3; k++) {
      int at = (int)(c->x[3 * i + k] / c->side * c->many);
      c->cell[i][k] = at < c->many ? at : c->many - 1;
    }
    enter(c, i);
    put(c, i, i);
    c->own[i] = 0;
    c->time[i] = INFINITY;
    c->partner[i] = NONE;
  }
  for (size_t i = 0; i < c->n; i++)
    foresee(c, i);
}

void ref_crm_run(RefCrm *c, double until, uint64_t collisions) {
  uint64_t last = c->collisions + collisions;
  while (c->collisions < last) {
    size_t i = c->heap[0], what = c->partner[i];
    if (c->time[i] >= until) {
      c->now = until;
      return;
    }
    c->now = c->time[i];
    carry(c, i);
    if (what < c->n) {
      collide(c, i, what);
      c->partner[i] = c->partner[what] = NONE;
      set_time(c, i, INFINITY);
      set_time(c, what, INFINITY);
      foresee(c, what);
      foresee(c, i);
      continue;
    }
    if (what != NONE)
      cross(c, i, NONE - 1 - what);
    foresee(c, i);
  }
}

void ref_crm_sync(RefCrm *c) {
  for (size_t i = 0; i < c->n; i++)
    carry(c, i);
}
