#ifndef TABLE_H
#define TABLE_H
#include "outcome.h"
#include <stdint.h>
#include <stdio.h>
typedef struct {
FILE *file;
char part[4096], name[4096];
} Table;
int table_directory(const char *directory, Outcome *out);
int table_possible(const char *directory, Outcome *out);
int table_open(Table *table, const char *directory, const char *name,
Outcome *out);
int table_close(Table *table, Outcome *out);
void table_row(Table *table, const double value[], int count);
void table_mean(const double *matrix, size_t rows, size_t columns, size_t c,
double *mean, double *error);
#define TABLE_VERSION "0.1.0"
void table_fingerprint(const char *const modules[], char print[17]);
#endif
