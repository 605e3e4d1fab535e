#ifndef PARTS_H
#define PARTS_H
#include "bytes.h"
#include "run.h"
Bytes parts_key(const Scene *scene);
const char *parts_differ(const Bytes *key, const Bytes *other);
void parts_pack(const Run *run, int job, Bytes *bytes);
int parts_unpack(Run *run, Bytes *record);
int parts_write(const Run *run, const Bytes *key, const int job[], int count,
const char *directory, Outcome *out);
typedef struct {
char **name;
int count, next;
char path[4400];
Bytes file, key;
int records, read;
} Parts;
void parts_open(Parts *parts, const char *directory);
void parts_close(Parts *parts);
bool parts_next(Parts *parts);
bool parts_record(Parts *parts, Bytes *record);
void parts_remove(const char *directory);
Scene *parts_scene(Bytes *key, const char ***set, Outcome *out);
#endif
