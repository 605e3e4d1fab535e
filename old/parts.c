#include "parts.h"
#include "header.h"
#include "read.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
static const char magic[] = "randpack parts 1\n";
static void add_file(Bytes *key, const char *path) {
struct stat about;
FILE *file = stat(path, &about) == 0 && S_ISREG(about.st_mode)
? fopen(path, "rb")
: NULL;
Bytes all = {0};
char some[4096];
if (!file)
return;
for (size_t n; (n = fread(some, 1, sizeof some, file)) > 0;)
bytes_add(&all, some, n);
fclose(file);
bytes_text(key, path, strlen(path));
bytes_whole(key, bytes_sum(all.at, all.length));
bytes_free(&all);
}
static void add_quoted(Bytes *key, const char *text) {
const char *from = strchr(text, '"'), *to;
for (; from && (to = strchr(from + 1, '"')); from = to) {
char path[1024];
size_t length = (size_t)(to - from) - 1;
if (length == 0 || length >= sizeof path)
continue;
memcpy(path, from + 1, length);
path[length] = '\0';
add_file(key, path);
}
}
static void add_text(Bytes *key, const char *text) {
bytes_text(key, text, strlen(text));
}
Bytes parts_key(const Scene *scene) {
const char *used[HEADER_MODULES], *slash = strrchr(scene->path, '/');
char print[17];
Bytes key = {0};
header_modules(scene, used);
table_fingerprint(used, print);
add_text(&key, TABLE_VERSION);
add_text(&key, print);
add_text(&key, slash ? slash + 1 : scene->path);
add_text(&key, scene->first->text);
bytes_whole(&key, (uint64_t)scene->sets);
for (int i = 0; i < scene->sets; i++)
add_text(&key, scene->set[i]);
add_quoted(&key, scene->first->text);
for (int i = 0; i < scene->sets; i++) {
add_quoted(&key, scene->set[i]);
add_file(&key, strchr(scene->set[i], '=') + 1);
}
return key;
}
static bool same_text(Bytes *a, Bytes *b) {
size_t n, m;
const char *x = bytes_next_text(a, &n), *y = bytes_next_text(b, &m);
return n == m && memcmp(x, y, n) == 0;
}
static bool same_sets(Bytes *a, Bytes *b) {
uint64_t sets = bytes_next_whole(a);
bool same = bytes_next_whole(b) == sets;
for (uint64_t i = 0; i < sets && same; i++)
same = same_text(a, b);
return same;
}
const char *parts_differ(const Bytes *key, const Bytes *other) {
Bytes a = *key, b = *other;
a.next = b.next = 0;
if (bytes_same(key, other))
return NULL;
bool version = same_text(&a, &b), code = same_text(&a, &b);
bool name = same_text(&a, &b), text = same_text(&a, &b);
return !name ? "a scene of another name"
: !text ? "another text of the scene"
: !same_sets(&a, &b) ? "other settings"
: !version ? "another version of randpack"
: !code ? "other code or another compiler"
: "another file that the scene names";
}
static void pack_row(const Row *row, Bytes *bytes) {
bytes_whole(bytes, row->x != NULL);
bytes_whole(bytes, row->x ? row->length : 0);
for (size_t b = 0; row->x && b < row->length; b++)
bytes_real(bytes, row->x[b]);
for (size_t b = 0; row->x && b < row->length; b++)
bytes_real(bytes, row->y[b]);
}
static void pack_result(const Result *result, Bytes *bytes) {
bytes_whole(bytes, result->number != NULL);
if (!result->number)
return;
bytes_whole(bytes, (uint64_t)result->out.status);
bytes_text(bytes, result->out.text, strlen(result->out.text));
bytes_whole(bytes, result->transient);
bytes_whole(bytes, (uint64_t)result->layout->numbers);
for (int n = 0; n < result->layout->numbers; n++) {
bytes_real(bytes, result->number[n]);
bytes_real(bytes, result->error[n]);
}
bytes_whole(bytes, (uint64_t)result->layout->curves);
for (int c = 0; c < result->layout->curves; c++)
pack_row(&result->curve[c], bytes);
}
typedef struct {
Result *at;
Ensemble *of;
} Place;
static Place *places(const Run *run, int job, int *count) {
int head, k = run_realization(run, job, &head), n = 0;
Place *place = NULL;
for (int e = head; e < run->combinations; e++) {
Ensemble *one = &run->all[e];
int looks = one->look ? one->scene->stages.marks + 1 : 0;
if (!run_has(run, head, k, e))
continue;
place = memory_grow(place, (size_t)(n + looks) + 2, sizeof *place);
place[n++] = (Place){&one->result[k], one};
if (one->made)
place[n++] = (Place){&one->made[k], one};
for (int i = 0; i < looks; i++)
place[n++] = (Place){&one->look[k * looks + i], one};
}
*count = n;
return place;
}
void parts_pack(const Run *run, int job, Bytes *bytes) {
int count;
Place *place = places(run, job, &count);
bytes_whole(bytes, (uint64_t)job);
bytes_whole(bytes, (uint64_t)count);
for (int i = 0; i < count; i++)
pack_result(place[i].at, bytes);
free(place);
}
static void unpack_row(Bytes *bytes, Row *row) {
bool told = bytes_next_whole(bytes) != 0;
uint64_t length = bytes_next_whole(bytes);
if (!told || !bytes_left(bytes, length, 16))
return;
double *y = result_row(row, (size_t)length);
for (size_t b = 0; b < length; b++)
row->x[b] = bytes_next_real(bytes);
for (size_t b = 0; b < length; b++)
y[b] = bytes_next_real(bytes);
}
static void unpack_outcome(Bytes *bytes, Outcome *out) {
uint64_t status = bytes_next_whole(bytes);
const char *text = bytes_next_text(bytes, NULL);
bytes->bad |= status > WRONG;
if (!bytes->bad && status)
outcome_set(out, (int)status, "%s", text);
}
static void unpack_result(Bytes *bytes, const Layout *layout, Result *result) {
if (bytes_next_whole(bytes) == 0)
return;
result_begin(result, layout);
unpack_outcome(bytes, &result->out);
result->transient = bytes_next_whole(bytes) != 0;
bytes->bad |= bytes_next_whole(bytes) != (uint64_t)layout->numbers;
for (int n = 0; n < layout->numbers && !bytes->bad; n++) {
result->number[n] = bytes_next_real(bytes);
result->error[n] = bytes_next_real(bytes);
}
bytes->bad |= bytes_next_whole(bytes) != (uint64_t)layout->curves;
for (int c = 0; c < layout->curves && !bytes->bad; c++)
unpack_row(bytes, &result->curve[c]);
}
int parts_unpack(Run *run, Bytes *record) {
uint64_t job = bytes_next_whole(record);
if (record->bad || job >= (uint64_t)run->jobs)
return -1;
int count;
run_drop(run, (int)job);
Place *place = places(run, (int)job, &count);
record->bad |= bytes_next_whole(record) != (uint64_t)count;
for (int i = 0; i < count && !record->bad; i++)
unpack_result(record, &place[i].of->layout, place[i].at);
free(place);
if (!record->bad && record->next == record->length)
return (int)job;
run_drop(run, (int)job);
return -1;
}
static void folder_of(const char *directory, char folder[4200]) {
snprintf(folder, 4200, "%.4000s/parts", directory);
}
int parts_write(const Run *run, const Bytes *key, const int job[], int count,
const char *directory, Outcome *out) {
Bytes file = {0}, record = {0};
Table table;
char folder[4200], name[64];
bytes_add(&file, magic, sizeof magic - 1);
bytes_text(&file, key->at, key->length);
bytes_whole(&file, (uint64_t)count);
for (int i = 0; i < count; i++) {
record.length = 0;
parts_pack(run, job[i], &record);
bytes_text(&file, record.at, record.length);
}
bytes_whole(&file, bytes_sum(file.at, file.length));
folder_of(directory, folder);
snprintf(name, sizeof name, "%016llx-%d",
(unsigned long long)bytes_sum(key->at, key->length), job[0]);
if (table_open(&table, folder, name, out) == DONE)
fwrite(file.at, 1, file.length, table.file);
table_close(&table, out);
bytes_free(&record);
bytes_free(&file);
return out->status;
}
static bool is_name(const char *name, bool part_too) {
size_t sum = strspn(name, "0123456789abcdef");
if (sum != 16 || name[16] != '-')
return false;
const char *rest = name + 17 + strspn(name + 17, "0123456789");
return rest > name + 17 &&
(*rest == '\0' || (part_too && strcmp(rest, ".part") == 0));
}
static int by_name(const void *a, const void *b) {
return strcmp(*(char *const *)a, *(char *const *)b);
}
static void list_files(Parts *parts, const char *directory, bool part_too) {
char folder[4200];
*parts = (Parts){0};
folder_of(directory, folder);
DIR *open = opendir(folder);
for (struct dirent *one; open && (one = readdir(open));)
if (is_name(one->d_name, part_too)) {
char *name = memory(1, sizeof parts->path);
snprintf(name, sizeof parts->path, "%s/%.100s", folder, one->d_name);
size_t count = (size_t)parts->count + 1;
parts->name = memory_grow(parts->name, count, sizeof *parts->name);
parts->name[parts->count++] = name;
}
if (open)
closedir(open);
if (parts->count)
qsort(parts->name, (size_t)parts->count, sizeof *parts->name, by_name);
}
void parts_open(Parts *parts, const char *directory) {
list_files(parts, directory, false);
}
void parts_close(Parts *parts) {
for (int i = 0; i < parts->count; i++)
free(parts->name[i]);
free(parts->name);
bytes_free(&parts->file);
*parts = (Parts){0};
}
void parts_remove(const char *directory) {
Parts all;
char folder[4200];
list_files(&all, directory, true);
for (int i = 0; i < all.count; i++)
remove(all.name[i]);
parts_close(&all);
folder_of(directory, folder);
rmdir(folder);
}
static void read_bytes(const char *path, Bytes *bytes) {
char some[65536];
FILE *file = fopen(path, "rb");
bytes->length = bytes->next = 0;
bytes->bad = false;
for (size_t n; file && (n = fread(some, 1, sizeof some, file)) > 0;)
bytes_add(bytes, some, n);
if (file)
fclose(file);
}
static bool is_whole(Bytes *file) {
size_t begin = sizeof magic - 1;
if (file->length < begin + 8 || memcmp(file->at, magic, begin) != 0)
return false;
file->next = file->length - 8;
bool same = bytes_next_whole(file) == bytes_sum(file->at, file->length - 8);
file->next = begin;
file->length -= 8;
return same;
}
bool parts_next(Parts *parts) {
if (parts->next == parts->count)
return false;
snprintf(parts->path, sizeof parts->path, "%s", parts->name[parts->next++]);
read_bytes(parts->path, &parts->file);
parts->key = (Bytes){0};
parts->records = parts->read = 0;
if (!is_whole(&parts->file))
return true;
size_t length;
const char *key = bytes_next_text(&parts->file, &length);
parts->records = (int)bytes_next_whole(&parts->file);
if (!parts->file.bad)
parts->key = (Bytes){.at = (unsigned char *)key, .length = length};
return true;
}
bool parts_record(Parts *parts, Bytes *record) {
if (parts->read >= parts->records || parts->file.bad)
return false;
size_t length;
const char *text = bytes_next_text(&parts->file, &length);
*record = (Bytes){.at = (unsigned char *)text, .length = length};
parts->read++;
return !parts->file.bad;
}
Scene *parts_scene(Bytes *key, const char ***set, Outcome *out) {
key->next = 0;
bytes_next_text(key, NULL);
bytes_next_text(key, NULL);
const char *name = bytes_next_text(key, NULL);
const char *text = bytes_next_text(key, NULL);
uint64_t sets = bytes_next_whole(key);
*set = memory(bytes_left(key, sets, 9) ? (size_t)sets : 1, sizeof **set);
for (uint64_t i = 0; i < sets && !key->bad; i++)
(*set)[i] = bytes_next_text(key, NULL);
if (!key->bad)
return read_again(name, text, *set, (int)sets, out);
outcome_set(out, WRONG, "a damaged key");
return NULL;
}
