/* The truth that the Percus-Yevick curve of src/py.nw is held against. */
#ifndef REF_PY_H
#define REF_PY_H
/* |g - g_PY(phi, R)|, R >= 2, the curve taken in arithmetic of 113 bits. */
double ref_py_error(double phi, double R, double g);
#endif
