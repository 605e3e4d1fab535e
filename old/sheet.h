#ifndef SHEET_H
#define SHEET_H
#include "outcome.h"
#include <stdbool.h>
#include <stddef.h>
typedef struct {
char *what;
char *origin;
char *swept;
size_t columns, rows;
char **name, **cell;
char **text;
size_t lines;
} Sheet;
typedef struct {
size_t x, y;
size_t error;
size_t from, step;
const char *species;
bool theory;
char name[64];
char stem[32];
} SheetTrace;
Sheet *sheet_read(const char *path, Outcome *out);
void sheet_free(Sheet **sheet);
double sheet_number(const Sheet *sheet, size_t row, size_t column);
size_t sheet_places(const Sheet *sheet);
int sheet_traces(const Sheet *sheet, SheetTrace trace[], int most);
void sheet_unit(const Sheet *sheet, const char *name, bool alone,
char unit[16]);
#endif
