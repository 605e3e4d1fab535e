/* Event-driven growth, plainly: a table of all pairs, all images, no lists, no
   queue. It shares nothing with the engine but the definition of a record
   (place, velocity, own time, final radius) and of a meeting. */
#include "ref_motion.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double at(const RefMotion *m, size_t i, int k, double t) {
  return m->x[i][k] + m->v[i][k] * (t - m->own[i]);
}

static double meet(const RefMotion *m, size_t i, size_t j, const int s[3]) {
  double t0 = m->own[i] > m->own[j] ? m->own[i] : m->own[j];
  double sum = m->a[i] + m->a[j], D = sum * (m->size + m->growth * t0);
  double rate = sum * m->growth, uu = 0, du = 0, dd = 0;
  for (int k = 0; k < m->dim; k++) {
    double d = at(m, j, k, t0) - at(m, i, k, t0) + s[k] * m->side[k];
    double u = m->v[j][k] - m->v[i][k];
    uu += u * u;
    du += d * u;
    dd += d * d;
  }
  double A = uu - rate * rate, B = du - D * rate, C = dd - D * D;
  double q = B * B - A * C;
  if (B < 0) {
    if (C <= 0)
      return t0;
    return q < 0 ? INFINITY : t0 + C / (sqrt(q) - B);
  }
  if (A >= 0)
    return INFINITY;
  return t0 + (B + sqrt(q > 0 ? q : 0)) / -A;
}

static void row(RefMotion *m, size_t i) {
  for (size_t j = 0; j < m->n; j++) {
    RefPair best = {INFINITY, {0, 0, 0}};
    int base[3] = {0, 0, 0}, s[3], r2 = m->dim == 3;
    double t = m->now;
    for (int k = 0; k < m->dim; k++)
      base[k] = -(int)lround((at(m, j, k, t) - at(m, i, k, t)) / m->side[k]);
    for (s[0] = base[0] - 1; s[0] <= base[0] + 1; s[0]++)
      for (s[1] = base[1] - 1; s[1] <= base[1] + 1; s[1]++)
        for (s[2] = base[2] - r2; s[2] <= base[2] + r2; s[2]++) {
          if (i == j && !s[0] && !s[1] && !s[2])
            continue;
          double time = meet(m, i, j, s);
          if (time < best.time) {
            best.time = time;
            memcpy(best.shift, s, sizeof s);
          }
        }
    m->pair[i * m->n + j] = best;
    for (int k = 0; k < 3; k++)
      best.shift[k] = -best.shift[k];
    m->pair[j * m->n + i] = best;
  }
}

void ref_sync(RefMotion *m, double time) {
  for (size_t i = 0; i < m->n; i++) {
    for (int k = 0; k < m->dim; k++) {
      double x = at(m, i, k, time);
      if (x < 0 || x >= m->side[k])
        x -= m->side[k] * floor(x / m->side[k]);
      m->x[i][k] = x;
    }
    m->own[i] = 0;
  }
  m->size += m->growth * time;
  m->now = 0;
  for (size_t i = 0; i < m->n; i++)
    row(m, i);
}

static void carry(RefMotion *m, size_t i, double t) {
  for (int k = 0; k < m->dim; k++) {
    double x = at(m, i, k, t);
    if (m->wide && (x < 0 || x >= m->side[k]))
      x -= m->side[k] * floor(x / m->side[k]);
    m->x[i][k] = x;
  }
  m->own[i] = t;
}

static void bounce(RefMotion *m, size_t i, size_t j, const int s[3]) {
  double n[3], r = 0, w = 0, sum = m->a[i] + m->a[j];
  carry(m, i, m->now);
  carry(m, j, m->now);
  for (int k = 0; k < m->dim; k++) {
    if (m->wide) {
      n[k] = m->x[j][k] - m->x[i][k];
      n[k] = n[k] > m->side[k] / 2    ? n[k] - m->side[k]
             : n[k] < -m->side[k] / 2 ? n[k] + m->side[k]
                                      : n[k];
    } else
      n[k] = at(m, j, k, m->now) - at(m, i, k, m->now) + s[k] * m->side[k];
    r += n[k] * n[k];
  }
  r = sqrt(r);
  for (int k = 0; k < m->dim; k++) {
    n[k] = r > 0 ? n[k] / r : k > 0 ? 0 : i < j ? 1 : -1;
    w += n[k] * (m->v[j][k] - m->v[i][k]);
  }
  double mi = m->mass[i], mj = m->mass[j];
  double J = 2 * (sum * m->growth - w) * (mi * mj / (mi + mj));
  for (int k = 0; k < m->dim; k++) {
    m->v[i][k] -= J / mi * n[k];
    m->v[j][k] += J / mj * n[k];
  }
}

int ref_next(RefMotion *m, double until, size_t *i, size_t *j) {
  double first = until;
  int what = 0;
  for (size_t p = 0; p < m->n; p++) {
    double v2 = 0;
    for (int k = 0; k < m->dim; k++)
      v2 += m->v[p][k] * m->v[p][k];
    double age = m->own[p] + m->oldest / sqrt(v2);
    if (age < first) {
      first = age;
      what = 2;
      *i = *j = p;
    }
    for (size_t q = 0; q < m->n; q++)
      if (m->pair[p * m->n + q].time < first) {
        first = m->pair[p * m->n + q].time;
        what = 1;
        *i = p;
        *j = q;
      }
  }
  m->now = first;
  if (what == 0)
    return 0;
  if (what == 1)
    bounce(m, *i, *j, m->pair[*i * m->n + *j].shift);
  else
    carry(m, *i, first);
  if (what == 1)
    row(m, *j);
  row(m, *i);
  return what;
}
