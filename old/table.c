#include "table.h"
#include <assert.h>
#include <errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_statistics_double.h>
#include <stdbool.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
static int make_directory(const char *path) {
char part[4096];
size_t length = strlen(path);
if (length >= sizeof part) {
errno = ENAMETOOLONG;
return 0;
}
for (size_t i = 1; i <= length; i++)
if (path[i] == '/' || path[i] == '\0') {
memcpy(part, path, i);
part[i] = '\0';
if (mkdir(part, 0777) && errno != EEXIST)
return 0;
}
return 1;
}
int table_directory(const char *directory, Outcome *out) {
struct stat about;
bool there = make_directory(directory) && stat(directory, &about) == 0;
if (there && !S_ISDIR(about.st_mode)) {
errno = ENOTDIR;
there = false;
}
if (there && access(directory, W_OK | X_OK) == 0)
return DONE;
return outcome_set(out, UNREACHED, "%s: cannot be written: %s", directory,
strerror(errno));
}
int table_possible(const char *directory, Outcome *out) {
char path[4096];
size_t had = 0, length = strlen(directory);
snprintf(path, sizeof path, "%s", directory);
for (size_t i = 1; i <= length && length < sizeof path; i++)
if (directory[i] == '/' || directory[i] == '\0') {
path[i] = '\0';
had = access(path, F_OK) == 0 ? i : had;
path[i] = directory[i];
}
table_directory(directory, out);
for (size_t i = length; i > had && length < sizeof path; i--)
if (directory[i] == '/' || directory[i] == '\0') {
path[i] = '\0';
rmdir(path);
}
return out->status;
}
int table_open(Table *table, const char *directory, const char *name,
Outcome *out) {
snprintf(table->name, sizeof table->name, "%s/%s", directory, name);
snprintf(table->part, sizeof table->part, "%.4000s.part", table->name);
table->file = make_directory(directory) ? fopen(table->part, "w") : NULL;
if (!table->file)
return outcome_set(out, UNREACHED, "%s: cannot be written: %s", table->name,
strerror(errno));
return DONE;
}
int table_close(Table *table, Outcome *out) {
if (!table->file)
return out->status;
errno = 0;
int failed = ferror(table->file) || fflush(table->file);
int error = failed ? errno : 0;
failed |= fclose(table->file);
table->file = NULL;
if (out->status == DONE && (failed || rename(table->part, table->name)))
outcome_set(out, UNREACHED, "%s: cannot be written: %s", table->name,
strerror(error ? error : errno));
if (out->status != DONE)
remove(table->part);
return out->status;
}
void table_row(Table *table, const double value[], int count) {
for (int c = 0; c < count; c++)
fprintf(table->file, "%.12g%c", value[c], c + 1 < count ? '\t' : '\n');
}
void table_mean(const double *matrix, size_t rows, size_t columns, size_t c,
double *mean, double *error) {
assert(rows > 0 && c < columns);
*mean = gsl_stats_mean(matrix + c, columns, rows);
double spread = rows > 1 ? gsl_stats_sd(matrix + c, columns, rows) : GSL_NAN;
*error = spread / sqrt((double)rows);
}
static uint64_t join(uint64_t hash, const char *text) {
for (; *text; text++)
hash = (hash ^ (unsigned char)*text) * 0x100000001b3u;
return hash;
}
void table_fingerprint(const char *const modules[], char print[17]) {
static const struct {
const char *module, *print;
} prints[] = {
#include "prints.inc"
};
uint64_t hash = 0xcbf29ce484222325u;
for (size_t p = 0; p < sizeof prints / sizeof *prints; p++)
for (int m = 0; modules[m]; m++)
if (strcmp(prints[p].module, modules[m]) == 0)
hash = join(join(hash, prints[p].module), prints[p].print);
snprintf(print, 17, "%016llx", (unsigned long long)hash);
}
