#include "export.h"
#include "table.h"
#include "voxels.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <sys/statvfs.h>
typedef struct {
char directory[2048], name[1024];
} Place;
static int cut_path(const char *path, const char *ending, Place *place,
Outcome *out) {
const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
const char *dot = strrchr(base, '.');
size_t before = slash ? (size_t)(slash - path) : 0;
size_t kept = ending && dot ? (size_t)(dot - base) : strlen(base);
if (before >= sizeof place->directory || kept + 16 > sizeof place->name ||
!*base)
return outcome_set(out, WRONG, "%s: give the name of a file", path);
snprintf(place->directory, sizeof place->directory, "%.*s",
slash == path ? 1 : (int)before, slash ? path : ".");
if (!slash)
strcpy(place->directory, ".");
snprintf(place->name, sizeof place->name, "%.*s%s", (int)kept, base,
ending ? ending : "");
return DONE;
}
static int ask_disk(const Writing *w, const Format *format, const char *to,
const char *directory, Outcome *out) {
struct statvfs disk;
double bytes = format->holds & FORMAT_CELLS ? voxels_bytes(w) : 0;
if (bytes == 0 || statvfs(directory, &disk) != 0)
return DONE;
double room = (double)disk.f_bavail * (double)disk.f_frsize;
if (bytes <= room)
return DONE;
return outcome_set(out, UNREACHED,
"%s: %.3g voxels take %.3g bytes, and the disk has %.3g; "
"give fewer --cells",
to, (double)w->cells[0] * w->cells[1] * w->cells[2], bytes,
room);
}
static int write_beside(const Writing *w, const Format *format, const char *to,
const Place *first, Outcome *out) {
Table table;
Place place;
if (cut_path(to, format->beside, &place, out))
return out->status;
if (table_open(&table, place.directory, place.name, out) == DONE)
format->describe(w, first->name, table.file);
return table_close(&table, out);
}
static int write_files(const Writing *w, const Format *format, const char *to,
Outcome *out) {
Table table;
Place place, beside;
if (cut_path(to, NULL, &place, out) ||
ask_disk(w, format, to, place.directory, out))
return out->status;
if (format->beside && !cut_path(to, format->beside, &beside, out) &&
strcmp(place.name, beside.name) == 0)
return outcome_set(out, WRONG,
"%s: its description would have the same name; give "
"another ending",
to);
if (table_open(&table, place.directory, place.name, out) == DONE)
format->write(w, table.file);
if (table_close(&table, out) == DONE && format->beside)
write_beside(w, format, to, &place, out);
return out->status;
}
static void write_note(const char *from, char note[256]) {
const char *slash = strrchr(from, '/');
snprintf(note, 256, "randpack " TABLE_VERSION ", from %.200s",
slash ? slash + 1 : from);
for (char *c = note; *c; c++)
if (iscntrl((unsigned char)*c))
*c = '?';
}
static const Box *told_box(const Scene *scene, Box *box) {
if (!scene || !(scene->side > 0))
return NULL;
box->dim = scene->dimension;
for (int k = 0; k < box->dim; k++)
box->side[k] =
scene->side * (scene->sides ? scene->box[k] / scene->box[0] : 1);
return box;
}
int export_pack(const char *from, const char *to, const ConvertWords *words,
const Scene *scene, Outcome *out) {
const Format *format = convert_format(to, words, out);
GatherKnown known = {0};
Box box = {0};
Writing w;
char note[256];
if (!format)
return out->status;
if (scene)
known = (GatherKnown){scene->dimension, scene->species, scene->kinds,
scene->fraction};
Pack *pack = convert_read(from, words, scene ? &known : NULL,
told_box(scene, &box), out);
if (!pack)
return out->status;
write_note(from, note);
if (convert_begin(&w, pack, format, from, note, words, out) == DONE)
write_files(&w, format, to, out);
format_end(&w);
pack_free(&pack);
return out->status;
}
