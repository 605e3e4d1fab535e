#include "drawing.h"
#include <errno.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>
static const struct {
const char *ending, *terminal;
double units;
double points;
const char *last;
} formats[] = {
{"png", "pngcairo font 'Sans,8'", 120, 120 * 2.54 / 72, "IEND"},
{"svg", "svg font 'sans-serif,8'", 96 / 2.54, 96.0 / 72, "</svg>"},
{"pdf", "pdfcairo font 'Sans,8'", 1 / 2.54, 1, "%%EOF"}};
enum { FORMATS = sizeof formats / sizeof *formats };
static int find_format(const char *name) {
const char *dot = strrchr(name, '.'), *slash = strrchr(name, '/');
const char *ending = dot && !(slash && slash > dot) ? dot + 1 : name;
int f = 0;
while (f < FORMATS && strcasecmp(formats[f].ending, ending) != 0)
f++;
return f;
}
int drawing_format(const char *name, Outcome *out) {
if (find_format(name) < FORMATS)
return DONE;
return outcome_set(
out, WRONG, "%s: not a format of pictures; give png, svg or pdf", name);
}
extern char **environ;
static char **clean_environment(void) {
size_t n = 0, kept = 0;
while (environ[n])
n++;
char **copy = memory(n + 1, sizeof *copy);
for (size_t i = 0; i < n; i++)
if (strncmp(environ[i], "GNU", 3) != 0)
copy[kept++] = environ[i];
return copy;
}
static int start(char *option, int in, int to, int err) {
char name[] = "gnuplot", *words[] = {name, option, NULL};
char **environment = clean_environment();
posix_spawn_file_actions_t actions;
pid_t child;
int status = 0;
posix_spawn_file_actions_init(&actions);
posix_spawn_file_actions_adddup2(&actions, in, 0);
posix_spawn_file_actions_adddup2(&actions, to, 1);
posix_spawn_file_actions_adddup2(&actions, err, 2);
int missing = posix_spawnp(&child, name, &actions, NULL, words, environment);
posix_spawn_file_actions_destroy(&actions);
free(environment);
while (!missing && waitpid(child, &status, 0) < 0)
if (errno != EINTR)
return -1;
return missing ? 127 : WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
static int complain_missing(Outcome *out) {
return outcome_set(out, UNREACHED,
"gnuplot is needed for pictures; apt-get install "
"gnuplot-nox");
}
int drawing_possible(Outcome *out) {
char option[] = "--version";
FILE *nothing = tmpfile();
int status = 127;
if (!nothing)
return outcome_set(out, UNREACHED, "a temporary file cannot be made: %s",
strerror(errno));
status = start(option, fileno(nothing), fileno(nothing), fileno(nothing));
fclose(nothing);
return status == 0 ? DONE : complain_missing(out);
}
static void hear(FILE *said, char reason[256]) {
char line[256];
*reason = '\0';
rewind(said);
while (fgets(line, sizeof line, said)) {
char *text = line + strspn(line, " \t\r\n^");
text[strcspn(text, "\r\n")] = '\0';
bool numbered = strncmp(text, "line ", 5) == 0;
if (*text && strncmp(text, "Fontconfig", 10) != 0 && (numbered || !*reason))
snprintf(reason, 256, "%s", text);
if (numbered)
return;
}
}
static int follow(const unsigned char *text) {
int more = *text < 0x80 ? 0
: *text < 0xc2 ? -1
: *text < 0xe0 ? 1
: *text < 0xf0 ? 2
: *text < 0xf5 ? 3
: -1;
for (int k = 1; k <= more; k++)
if (text[k] >> 6 != 2)
return -1;
return more;
}
void drawing_text(const Drawing *drawing, const char *text) {
const unsigned char *at = (const unsigned char *)text;
putc('\'', drawing->script);
for (; *at; at++) {
int more = follow(at);
if (more < 0 || *at < ' ' || *at == 127)
putc('?', drawing->script);
else if (*at == '\'')
fputs("''", drawing->script);
else
for (putc(*at, drawing->script); more > 0; more--)
putc(*++at, drawing->script);
}
putc('\'', drawing->script);
}
void drawing_axes(const Drawing *drawing, const double corner[4]) {
static const char *const margin[] = {"lmargin", "bmargin", "rmargin",
"tmargin"};
for (int k = 0; k < 4; k++)
fprintf(drawing->script, "set %s at screen %.6f\n", margin[k],
corner[k] / (k % 2 ? drawing->height : drawing->width));
}
void drawing_words(const Drawing *drawing, double x, double y, const char *how,
double points, const char *text) {
fputs("set label ", drawing->script);
drawing_text(drawing, text);
fprintf(drawing->script,
" at screen %.6f, screen %.6f %s noenhanced font ',%g' front "
"textcolor rgb '#444444'\n",
x / drawing->width, y / drawing->height, how, points);
}
void drawing_key(const Drawing *drawing, double x, double y, double wide,
const char *line, const char *point, const char *text) {
FILE *file = drawing->script;
double left = x / drawing->width, up = y / drawing->height;
double right = (x + wide) / drawing->width;
if (*line)
fprintf(file,
"set arrow from screen %.6f, screen %.6f to screen %.6f, screen "
"%.6f nohead front %s\n",
left, up, right, up, line);
if (*point)
fprintf(file, "set label '' at screen %.6f, screen %.6f front point %s\n",
(left + right) / 2, up, point);
drawing_words(drawing, x + wide + 0.15, y, "left", 7, text);
}
static const char style[] =
"set encoding utf8\n"
"set border 3 lw 0.8 lc rgb '#444444'\n"
"set tics nomirror scale 0.6 textcolor rgb '#222222'\n"
"set errorbars 0.4\n"
"unset key\n"
"set linetype 1 lc rgb '#0072b2' lw 1.2 pt 7\n"
"set linetype 2 lc rgb '#d55e00' lw 1.2 pt 5\n"
"set linetype 3 lc rgb '#009e73' lw 1.2 pt 9\n"
"set linetype 4 lc rgb '#cc79a7' lw 1.2 pt 13\n"
"set linetype 5 lc rgb '#e69f00' lw 1.2 pt 11\n"
"set linetype 6 lc rgb '#56b4e9' lw 1.2 pt 6\n"
"set linetype 7 lc rgb '#000000' lw 1.2 pt 4\n"
"set linetype 8 lc rgb '#777777' lw 1.2 pt 12\n"
"set linetype cycle 8\n";
int drawing_open(Drawing *drawing, const char *path, double width,
double height, Outcome *out) {
const char *slash = strrchr(path, '/');
char directory[4096] = ".";
*drawing = (Drawing){.width = width, .height = height};
if (drawing_format(path, out))
return out->status;
if (slash)
snprintf(directory, sizeof directory, "%.*s",
slash > path ? (int)(slash - path) : 1, path);
drawing->format = find_format(path);
drawing->script = tmpfile();
if (!drawing->script)
return outcome_set(out, UNREACHED, "a temporary file cannot be made: %s",
strerror(errno));
if (table_open(&drawing->table, directory, slash ? slash + 1 : path, out))
return out->status;
double units = formats[drawing->format].units;
double points = drawing->points = formats[drawing->format].points;
fprintf(drawing->script,
"set terminal %s noenhanced background rgb '#ffffff' fontscale %g "
"linewidth %g size %.6g%s,%.6g%s\n%s",
formats[drawing->format].terminal, points, points, width * units,
units < 1 ? "in" : "", height * units, units < 1 ? "in" : "", style);
return DONE;
}
static bool is_whole(const Drawing *drawing) {
char end[64];
size_t length = 0;
const char *last = formats[drawing->format].last;
FILE *file = fopen(drawing->table.part, "r");
if (file && (fseek(file, -(long)sizeof end, SEEK_END) == 0))
length = fread(end, 1, sizeof end, file);
if (file)
fclose(file);
for (size_t at = 0; at + strlen(last) <= length; at++)
if (memcmp(end + at, last, strlen(last)) == 0)
return true;
return false;
}
static void draw(const Drawing *drawing, Outcome *out) {
char option[] = "-d", reason[256] = "";
FILE *script = drawing->script, *said = tmpfile();
int status = -1;
bool written = said && fflush(script) == 0 && !ferror(script);
if (written) {
rewind(script);
status = start(option, fileno(script), fileno(drawing->table.file),
fileno(said));
hear(said, reason);
}
if (said)
fclose(said);
if (!written)
outcome_set(out, UNREACHED, "a temporary file cannot be written: %s",
strerror(errno));
else if (status == 127)
complain_missing(out);
else if (*reason || status != 0)
outcome_set(out, UNREACHED, "%s: gnuplot cannot draw it: %s",
drawing->table.name, *reason ? reason : "it was stopped");
else if (!is_whole(drawing))
outcome_set(out, UNREACHED, "%s: cannot be written: gnuplot wrote a part",
drawing->table.name);
}
int drawing_close(Drawing *drawing, Outcome *out) {
if (drawing->script && out->status == DONE)
draw(drawing, out);
if (drawing->script)
fclose(drawing->script);
drawing->script = NULL;
return table_close(&drawing->table, out);
}
