#define _DEFAULT_SOURCE
#include "cost.h"
#include "parts.h"
#include "read.h"
#include "tables.h"
#include <dirent.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
double cost_straight(const double n[2], const double value[2], double to) {
double slope = (value[1] - value[0]) / (n[1] - n[0]);
if (n[0] == 0)
return value[1] * to / n[1];
return value[1] + (slope > 0 ? slope : 0) * (to - n[1]);
}
double cost_grown(const double n[2], const double value[2], double to,
double *power) {
*power = log(value[1] / value[0]) / log(n[1] / n[0]);
if (n[0] == 0)
*power = 1;
if (to == n[1])
return value[1];
return *power >= 1 ? value[1] * pow(to / n[1], *power)
: cost_straight(n, value, to);
}
typedef struct {
double particles;
double jobs, seconds, after;
double least, most;
double program;
double record;
double packs, tables;
Outcome out;
} Probe;
static double processor(void) {
struct timespec now;
clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
static double resident(void) {
struct rusage usage;
getrusage(RUSAGE_SELF, &usage);
return 1024.0 * (double)usage.ru_maxrss;
}
static void run_first(Scene *scene, const char *directory, Probe *probe) {
Run run;
Bytes record = {0};
for (Scene *s = scene; s; s = s->next)
s->realizations = 1;
omp_set_num_threads(1);
probe->least = resident();
run_open(&run, scene);
double start = processor();
for (int job = 0; job < run.jobs; job++) {
run_job(&run, job, directory, NULL);
parts_pack(&run, job, &record);
}
double made = processor();
if (run_judge(&run, &probe->out) == DONE)
tables_write(run.all, run.combinations, directory, &probe->out);
probe->jobs = run.jobs;
probe->seconds = made - start;
probe->after = processor() - made;
probe->record = (double)record.length / fmax(run.jobs, 1);
probe->most = resident();
}
static void probe_apart(Scene *scene, const char *directory, Probe *probe) {
int ends[2];
ssize_t got = 0;
if (pipe(ends)) {
outcome_set(&probe->out, UNREACHED, "no process for a probe");
return;
}
fflush(NULL);
pid_t child = fork();
if (child == 0) {
run_first(scene, directory, probe);
got = write(ends[1], probe, sizeof *probe);
_exit(got == (ssize_t)sizeof *probe ? 0 : 1);
}
close(ends[1]);
if (child > 0) {
got = read(ends[0], probe, sizeof *probe);
waitpid(child, NULL, 0);
}
close(ends[0]);
if (got != (ssize_t)sizeof *probe)
outcome_set(&probe->out, UNREACHED, "a probe did not come to its end");
}
static double on_disk(double bytes) {
return 4096 * ceil(bytes / 4096);
}
static void weigh_files(const char *directory, Probe *probe) {
DIR *open = opendir(directory);
for (struct dirent *one; open && (one = readdir(open));) {
char path[4400];
struct stat about;
const char *end = strrchr(one->d_name, '.');
snprintf(path, sizeof path, "%s/%.300s", directory, one->d_name);
if (stat(path, &about) || !S_ISREG(about.st_mode))
continue;
if (end && strcmp(end, ".xyz") == 0)
probe->packs += (double)about.st_size;
else
probe->tables += on_disk((double)about.st_size);
remove(path);
}
if (open)
closedir(open);
rmdir(directory);
}
enum { SETS_MORE = 64 };
typedef struct {
const char *set[SETS_MORE + 1];
char text[SETS_MORE][64];
int sets;
} Sets;
static double count_all(const Scene *scene) {
double sum = 0;
for (int s = 0; s < scene->kinds; s++)
sum += (double)scene->species[s].count;
return sum;
}
static void add_set(Sets *sets, const char *key, double value, bool whole) {
char *text = sets->text[sets->sets];
if (whole)
snprintf(text, 64, "%.32s=%lld", key, (long long)value);
else
snprintf(text, 64, "%.32s=%.17g", key, value);
sets->set[sets->sets++] = text;
}
static bool part_sets(const Scene *scene, double part, Sets *sets) {
char key[64];
sets->sets = 0;
if (scene->side > 0)
add_set(sets, "side", scene->side * pow(part, 1. / scene->dimension),
false);
else if (scene->number > 0)
add_set(sets, "number", ceil(part * (double)scene->number), true);
else if (scene->kinds <= SETS_MORE)
for (int s = 0; s < scene->kinds; s++) {
snprintf(key, sizeof key, "species.[%d].number", s);
add_set(sets, key, ceil(part * (double)scene->species[s].count), true);
}
return sets->sets > 0;
}
static Scene *smaller(const Scene *scene, double part, Sets *sets,
const char *all[]) {
Outcome none = {0};
int count = scene->sets;
if (!part_sets(scene, part, sets))
return NULL;
for (int i = 0; i < count; i++)
all[i] = scene->set[i];
for (int i = 0; i < sets->sets; i++)
all[count + i] = sets->set[i];
return read_again(scene->path, scene->first->text, all, count + sets->sets,
&none);
}
enum { PROBES_MOST = 24 };
typedef struct {
Probe probe[PROBES_MOST];
int count;
} Probes;
static const double ENOUGH = 1.5;
static bool probe_part(const Scene *scene, double part, Probe *probe) {
char directory[] = "/tmp/randpack-plan-XXXXXX";
Sets *sets = memory(1, sizeof *sets);
const char **all = memory((size_t)scene->sets + SETS_MORE + 1, sizeof *all);
Outcome none = {0};
Scene *less = part < 1 ? smaller(scene, part, sets, all)
: read_again(scene->path, scene->first->text,
scene->set, scene->sets, &none);
bool made = less && mkdtemp(directory);
*probe =
(Probe){.particles = less ? count_all(less) : 0, .program = resident()};
if (made) {
probe_apart(less, directory, probe);
weigh_files(directory, probe);
}
scene_free(&less);
free(all);
free(sets);
return made;
}
static void probe_all(const Scene *scene, Probes *probes) {
double whole = count_all(scene), spent = 0;
double part = whole > 100 ? 100 / whole : whole > 0 ? 1 : 1. / 64;
while (probes->count < PROBES_MOST) {
Probe next;
bool made = probe_part(scene, part, &next);
if (whole == 0)
next.particles = part;
if (made && (next.out.status == DONE || part >= 1))
probes->probe[probes->count++] = next;
double took = made ? next.seconds + next.after : 0;
spent += took;
if (part >= 1 || took > ENOUGH || spent > 3 * ENOUGH)
break;
double more = took > 0 ? 1.2 * ENOUGH / took : 2;
more = more > 4 ? 4 : more < 2 ? 2 : more;
part = part * more > 0.7 ? 1 : part * more;
}
}
static const Probe *lower_probe(const Probes *probes) {
const Probe *last = &probes->probe[probes->count - 1], *lower = NULL;
for (const Probe *p = probes->probe; p < last; p++)
if (!lower || p->particles <= 0.26 * last->particles)
lower = p;
return lower;
}
static void tell_bytes(FILE *file, double bytes) {
static const char *const unit[] = {"bytes", "kB", "MB", "GB", "TB"};
int u = 0;
for (; bytes >= 999.5 && u < 4; u++)
bytes /= 1000;
fprintf(file, "%.3g %s", bytes, unit[u]);
}
typedef struct {
const Probe *lower, *last;
double jobs, whole;
int threads;
} Foretold;
static void tell_time(const Scene *scene, const Foretold *f, FILE *file) {
double n[2] = {f->lower ? f->lower->particles : 0, f->last->particles};
double value[2] = {f->lower ? f->lower->seconds : 0, f->last->seconds};
double power = 1, each = cost_grown(n, value, f->whole, &power);
double one = each / fmax(f->last->jobs, 1), after = f->last->after;
double rounds = ceil(f->jobs / f->threads);
fprintf(file, "time\t%.3g s a realization%s, %d of them: %.3g s", each,
scene->keys ? " of all combinations" : "", scene->realizations,
f->jobs * one + after);
fprintf(file, " of the processor, %.3g s on %d threads\n",
rounds * one + after, f->threads);
if (n[1] < f->whole)
fprintf(file,
"probed\tup to %.3g of the particles; time grows as N^%.2f%s\n",
n[1] / f->whole, power, f->lower ? "" : ", it is assumed");
}
static void tell_space(const Scene *scene, const Foretold *f, FILE *file) {
double n[2] = {f->lower ? f->lower->particles : 0, f->last->particles};
double value[2] = {f->lower ? f->lower->most : 0, f->last->most};
double most = n[0] > 0 ? cost_straight(n, value, f->whole) : f->last->most;
double results = f->jobs * f->last->record, least = f->last->least;
double program = fmax(f->last->program, least);
double packs = n[1] > 0 ? f->last->packs * f->whole / n[1] : 0;
fprintf(file, "memory\t");
tell_bytes(file,
program + fmin(f->threads, f->jobs) * (most - least) + results);
fprintf(file, "\ndisk\t");
tell_bytes(file,
4096 + f->last->tables + scene->realizations * on_disk(packs));
fprintf(file, "; while it runs, results of up to ");
tell_bytes(file, results);
fprintf(file, "\n");
}
int cost_tell(const Scene *scene, int threads, FILE *file, Outcome *out) {
Probes *probes = memory(1, sizeof *probes);
Run run;
run_open(&run, scene);
Foretold f = {.jobs = run.jobs,
.whole = count_all(scene),
.threads = threads ? threads : omp_get_max_threads()};
run_close(&run);
fflush(file);
probe_all(scene, probes);
f.whole = f.whole > 0 ? f.whole : 1;
if (probes->count > 0) {
f.last = &probes->probe[probes->count - 1];
f.lower = lower_probe(probes);
}
if (!f.last || f.last->out.status != DONE) {
const char *why = f.last ? f.last->out.text : "";
outcome_set(out, UNREACHED, "no probe of the scene came to its end%s%s",
*why ? ": " : "", why);
} else {
tell_time(scene, &f, file);
tell_space(scene, &f, file);
}
free(probes);
return out->status;
}
