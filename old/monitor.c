#include "monitor.h"
#include <errno.h>
#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>
static volatile sig_atomic_t signalled;
static void hear(int number) {
signalled = number;
}
void monitor_listen(void) {
static const int heard[] = {SIGINT, SIGTERM, SIGHUP};
struct sigaction action = {.sa_handler = hear,
.sa_flags = SA_RESTART | (int)SA_RESETHAND};
for (size_t i = 0; i < sizeof heard / sizeof *heard; i++) {
struct sigaction before;
sigaction(heard[i], NULL, &before);
if (before.sa_handler != SIG_IGN)
sigaction(heard[i], &action, NULL);
}
signal(SIGPIPE, SIG_IGN);
}
int monitor_signal(void) {
return signalled;
}
void monitor_end_by_signal(void) {
signal(signalled, SIG_DFL);
raise(signalled);
}
typedef struct Job {
Watch watch;
Monitor *monitor;
struct Job *next;
const Scene *of;
int k, parts;
StatePass pass;
void *what;
uint64_t beginning;
double start, part, saved, due;
double from;
WatchNews news;
} Job;
struct Monitor {
const char *title, *directory;
uint64_t key;
double seconds;
int jobs, done, skipped;
double taken;
Job *job;
bool shown;
bool noted;
int width;
double drawn;
omp_lock_t lock;
};
enum { PATH_MOST = 4400, KEY_MOST = 300 };
static void name_state(const Job *job, int part, char path[PATH_MOST]) {
snprintf(path, PATH_MOST, "%.4000s/parts/state-%d%s-%d",
job->monitor->directory, job->k, job->of->suffix, part);
}
static void key_of_part(const Job *job, char key[KEY_MOST]) {
snprintf(key, KEY_MOST, "run %016llx\nrealization %d%s, part %d\n",
(unsigned long long)job->monitor->key, job->k, job->of->suffix,
job->parts);
}
static double part_left(const Job *job, double now) {
double gone = now - job->part, grown = job->news.share - job->from;
return job->news.share > 0 && grown > 0.04
? gone * (1 - job->news.share) / grown
: (double)NAN;
}
static double time_left(const Monitor *m, double now) {
int jobs = m->done - m->skipped, threads = 0, waiting = m->jobs - m->done;
double each = jobs > 0 ? m->taken / jobs : (double)NAN, sum = 0, most = 0;
for (const Job *job = m->job; job && jobs == 0; job = job->next)
each = fmax(each, now - job->start + part_left(job, now));
for (const Job *job = m->job; job; job = job->next, threads++, waiting--) {
double rest = each - (now - job->start);
double left = rest > 0 ? rest : fmax(part_left(job, now), 0);
sum += left;
most = fmax(most, left);
}
sum += waiting > 0 ? waiting * each : 0;
return threads > 0 && each >= 0 ? fmax(sum / threads, most) : (double)NAN;
}
static void add_time(double left, char *text, size_t room) {
size_t length = strlen(text);
text += length;
room -= length;
if (left < 100)
snprintf(text, room, "; %.0f s left", left);
else if (left < 100 * 60)
snprintf(text, room, "; %.0f min left", left / 60);
else if (left < 48 * 3600)
snprintf(text, room, "; %.0f h left", left / 3600);
else if (left >= 48 * 3600)
snprintf(text, room, "; %.0f days left", left / 86400);
}
static int digits(const WatchNews *news) {
return news->done <= 1 && news->whole <= 1 ? 4 : 0;
}
static void add_news(const Monitor *m, char *text, size_t room) {
const WatchNews *news = &m->job->news;
size_t length = strlen(text);
length += (size_t)snprintf(text + length, room - length, "; ");
if (m->jobs > 1)
length += (size_t)snprintf(text + length, room - length,
"realization %d%.60s: ", m->job->k,
m->job->of->suffix);
length += (size_t)snprintf(text + length, room - length, "%.60s", news->what);
if (news->done > 0 || news->whole > 0)
length += (size_t)snprintf(text + length, room - length, " %.*f",
digits(news), news->done);
if (news->whole > 0)
length += (size_t)snprintf(text + length, room - length, " of %.*f",
digits(news), news->whole);
if (news->events > 0)
snprintf(text + length, room - length, ", %.0f collisions a particle",
news->events);
}
static int columns(void) {
struct winsize size = {0};
return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20
? size.ws_col - 1
: 79;
}
static void draw(Monitor *m, const char *text) {
char line[1024];
int most = columns(), width = (int)strlen(text);
width = width < most ? width : most;
int blanks = m->width > width ? m->width - width : 0;
blanks = blanks < most - width ? blanks : most - width;
snprintf(line, sizeof line, "\r%.*s%*s", width, text, blanks, "");
fputs(line, stderr);
fflush(stderr);
m->width = width;
}
static void show(Monitor *m, double now) {
char text[512];
if (!m->shown)
return;
snprintf(text, sizeof text, "%.200s: %d of %d", m->title, m->done, m->jobs);
if (m->job && m->job->news.what)
add_news(m, text, sizeof text);
if (m->done < m->jobs)
add_time(time_left(m, now), text, sizeof text);
draw(m, text);
m->drawn = now;
}
static void note(Monitor *m, const char *path, int error) {
omp_set_lock(&m->lock);
if (!m->noted)
fprintf(stderr,
"%srandpack: note: %s: cannot be written: %s; the run goes on, "
"but not from here if it is interrupted\n",
m->width ? "\n" : "", path, strerror(error));
m->noted = true;
m->width = 0;
omp_unset_lock(&m->lock);
}
static void save(Job *job) {
Monitor *m = job->monitor;
char path[PATH_MOST], folder[PATH_MOST], key[KEY_MOST];
double start = omp_get_wtime();
key_of_part(job, key);
name_state(job, job->parts, path);
snprintf(folder, sizeof folder, "%.4000s/parts", m->directory);
mkdir(folder, 0777);
if (!state_save(path, key, job->beginning, job->pass, job->what))
note(m, path, errno);
job->saved = omp_get_wtime();
job->due = job->saved + fmax(m->seconds, 50 * (job->saved - start));
}
static bool begin(Watch *watch, StatePass pass, void *what) {
Job *job = watch->who;
Monitor *m = job->monitor;
char path[PATH_MOST], key[KEY_MOST];
bool loaded = false;
job->parts++;
job->pass = pass;
job->what = what;
job->part = job->saved = omp_get_wtime();
job->from = -1;
if (m->seconds > 0) {
key_of_part(job, key);
name_state(job, job->parts, path);
job->beginning = state_sum(pass, what);
loaded = state_load(path, key, pass, what);
}
return loaded;
}
static bool tick(Watch *watch, const WatchNews *news) {
Job *job = watch->who;
Monitor *m = job->monitor;
double now = omp_get_wtime();
bool inside = watch->depth == 1;
omp_set_lock(&m->lock);
job->news = *news;
if (inside && job->from < 0 && news->share > 0)
job->from = news->share;
if (now - m->drawn > 0.25)
show(m, now);
omp_unset_lock(&m->lock);
if (inside && m->seconds > 0 && (signalled || now >= job->due))
save(job);
return !signalled;
}
static void end(Watch *watch, bool whole) {
Job *job = watch->who;
Monitor *m = job->monitor;
double unsaved = omp_get_wtime() - job->saved;
if (whole && m->seconds > 0 && unsaved > m->seconds / 10)
save(job);
omp_set_lock(&m->lock);
job->news = (WatchNews){0};
omp_unset_lock(&m->lock);
}
Monitor *monitor_open(const Scene *scene, uint64_t key, const char *directory,
double seconds, int jobs) {
Monitor *m = memory(1, sizeof *m);
*m = (Monitor){.title = scene->path,
.directory = directory,
.key = key,
.seconds = seconds,
.jobs = jobs,
.shown = isatty(STDERR_FILENO),
.drawn = omp_get_wtime()};
omp_init_lock(&m->lock);
return m;
}
void monitor_close(Monitor **monitor) {
Monitor *m = *monitor;
if (!m)
return;
if (m->width)
fputs("\n", stderr);
omp_destroy_lock(&m->lock);
free(m);
*monitor = NULL;
}
Watch *monitor_begin(Monitor *m, const Scene *of, int k) {
Job *job = memory(1, sizeof *job), **last = &m->job;
double now = omp_get_wtime();
*job = (Job){.watch = {begin, tick, end, job, WATCH_EVERY, 0, 0},
.monitor = m,
.of = of,
.k = k,
.start = now,
.due = now + m->seconds};
omp_set_lock(&m->lock);
while (*last)
last = &(*last)->next;
*last = job;
omp_unset_lock(&m->lock);
return &job->watch;
}
static void remove_states(const Job *job) {
char path[PATH_MOST + 8];
for (int part = 1; part <= job->parts; part++) {
name_state(job, part, path);
remove(path);
strcat(path, ".part");
remove(path);
}
}
void monitor_end(Monitor *m, Watch **watch, bool done) {
Job *job = (*watch)->who, **at = &m->job;
double now = omp_get_wtime();
if (done && m->seconds > 0)
remove_states(job);
omp_set_lock(&m->lock);
while (*at != job)
at = &(*at)->next;
*at = job->next;
m->done += done;
m->taken += done ? now - job->start : 0;
show(m, now);
omp_unset_lock(&m->lock);
free(job);
*watch = NULL;
}
void monitor_skip(Monitor *m, int jobs) {
omp_set_lock(&m->lock);
m->done += jobs;
m->skipped += jobs;
if (jobs > 0)
show(m, omp_get_wtime());
omp_unset_lock(&m->lock);
}
int monitor_judge(const Monitor *m, Outcome *out) {
if (!signalled || m->done == m->jobs)
return DONE;
return outcome_set(out, STOPPED,
"interrupted after %d of %d realizations; run the same "
"command again to go on",
m->done, m->jobs);
}
