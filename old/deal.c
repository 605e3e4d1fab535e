#include "deal.h"
#include "monitor.h"
#include "parts.h"
#include "ranks.h"
#include "tables.h"
#include <ctype.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
enum { OPEN, GIVEN, FRESH, KEPT, ASIDE };
typedef struct {
Run run;
const DealHow *how;
Bytes key;
char *state;
int first;
int done, total;
double start;
double written;
Monitor *monitor;
} Deal;
static const double DEAL_SECONDS = 2;
static void open_deal(Deal *deal, const Scene *scene, const DealHow *how) {
*deal = (Deal){.how = how, .start = omp_get_wtime()};
deal->written = deal->start;
run_open(&deal->run, scene);
deal->key = parts_key(scene);
deal->state = memory((size_t)deal->run.jobs, 1);
deal->total = deal->run.jobs;
}
static void close_deal(Deal *deal) {
run_close(&deal->run);
bytes_free(&deal->key);
free(deal->state);
}
static long read_number(const char **text) {
char *end;
if (!isdigit((unsigned char)**text))
return -1;
long n = strtol(*text, &end, 10);
*text = end;
return n;
}
static bool mark_list(const char *list, bool *marked, int count, bool *beyond) {
for (const char *at = list;; at++) {
long from = read_number(&at), to = from;
if (*at == '-' && from >= 0) {
at++;
to = read_number(&at);
}
if (from < 0 || to < from || (*at && *at != ','))
return false;
*beyond |= to >= count;
for (long k = from; k <= to && k < count; k++)
marked[k] = true;
if (!*at)
return true;
}
}
static int count_realizations(const Run *run) {
int count = 0;
for (int e = 0; e < run->combinations; e++)
count = count > run->all[e].count ? count : run->all[e].count;
return count;
}
static int choose_pieces(Deal *deal, Outcome *out) {
const char *pieces = deal->how->pieces;
const Scene *scene = deal->run.scene;
int count = count_realizations(&deal->run), head;
bool *marked = memory((size_t)count, sizeof *marked), beyond = false;
if (count == 0)
outcome_set(out, WRONG,
"--realizations %s: %s makes none; leave the option out",
pieces, scene->path);
else if (!mark_list(pieces, marked, count, &beyond))
outcome_set(out, WRONG,
"--realizations %s: give numbers from 0, as 16-31 or 3,7-9",
pieces);
else if (beyond)
outcome_set(out, WRONG,
"--realizations %s: %s has %d, numbered from 0; give some of "
"0-%d",
pieces, scene->path, count, count - 1);
for (int job = 0; job < deal->run.jobs && out->status == DONE; job++)
if (!marked[run_realization(&deal->run, job, &head)]) {
deal->state[job] = ASIDE;
deal->total--;
}
free(marked);
return out->status;
}
static void take_file(Deal *deal, Parts *parts) {
Bytes record;
while (parts_record(parts, &record)) {
int job = parts_unpack(&deal->run, &record);
if (job >= 0)
deal->state[job] = deal->state[job] == ASIDE ? ASIDE : KEPT;
}
}
static void take_done(Deal *deal) {
Parts parts;
parts_open(&parts, deal->how->directory);
while (parts_next(&parts))
if (bytes_same(&parts.key, &deal->key))
take_file(deal, &parts);
parts_close(&parts);
run_note_all(&deal->run);
for (int job = 0; job < deal->run.jobs; job++) {
if (deal->state[job] != KEPT)
continue;
if (run_done(&deal->run, job, deal->how->directory)) {
deal->done++;
} else {
run_drop(&deal->run, job);
deal->state[job] = OPEN;
}
}
run_note_all(&deal->run);
}
static int write_fresh(Deal *deal, Outcome *out) {
int *job = memory((size_t)deal->run.jobs, sizeof *job), count = 0;
for (int j = 0; j < deal->run.jobs; j++)
if (deal->state[j] == FRESH && !run_transient(&deal->run, j))
job[count++] = j;
if (count > 0)
parts_write(&deal->run, &deal->key, job, count, deal->how->directory, out);
for (int i = 0; i < count && out->status == DONE; i++)
deal->state[job[i]] = KEPT;
free(job);
deal->written = omp_get_wtime();
return out->status;
}
static void write_now(Deal *deal) {
Outcome none = {0};
write_fresh(deal, &none);
}
static void write_if_due(Deal *deal) {
double now = omp_get_wtime(), due = 0.01 * (now - deal->start);
due = due > DEAL_SECONDS ? due : DEAL_SECONDS;
if (now - deal->written >= due)
write_now(deal);
}
static void job_done(Deal *deal, int job) {
deal->state[job] = FRESH;
deal->done++;
write_if_due(deal);
}
static void watch_job(Deal *deal, int job) {
Run *run = &deal->run;
int head, k = run_realization(run, job, &head);
double start = omp_get_wtime();
Watch *watch = monitor_begin(deal->monitor, run->all[head].scene, k);
bool done = run_job(run, job, deal->how->directory, watch);
#pragma omp critical
{
if (done)
job_done(deal, job);
else
run_drop(run, job);
if (done && omp_get_wtime() - start >= DEAL_SECONDS)
write_now(deal);
}
monitor_end(deal->monitor, &watch, done);
}
static void by_threads(Deal *deal) {
int threads = deal->how->threads;
threads = threads ? threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
for (int job = 0; job < deal->run.jobs; job++) {
if (deal->state[job] == OPEN && !monitor_signal())
watch_job(deal, job);
}
}
static int next_job(void *of) {
Deal *deal = of;
for (; deal->first < deal->run.jobs && !monitor_signal(); deal->first++) {
int job = deal->first;
if (deal->state[job] != OPEN)
continue;
if (run_wanted(&deal->run, job)) {
deal->state[job] = GIVEN;
return job;
}
job_done(deal, job);
}
return -1;
}
static void take_record(void *of, int job, Bytes *record) {
Deal *deal = of;
bool taken = record && parts_unpack(&deal->run, record) == job;
if (taken && !run_stopped(&deal->run, job)) {
run_note(&deal->run, job);
monitor_skip(deal->monitor, 1);
job_done(deal, job);
} else {
run_drop(&deal->run, job);
deal->state[job] = OPEN;
deal->first = job < deal->first ? job : deal->first;
}
}
static bool any_transient(const Deal *deal) {
bool some = false;
for (int job = 0; job < deal->run.jobs; job++)
some |= run_transient(&deal->run, job);
return some;
}
static void finish_whole(Deal *deal, Outcome *out) {
const char *directory = deal->how->directory;
Run *run = &deal->run;
bool failed = run_judge(run, out) != DONE;
if (!failed)
tables_write(run->all, run->combinations, directory, out);
if ((out->status == DONE || failed) && !any_transient(deal))
parts_remove(directory);
else
write_if_due(deal);
run_tell_unreached(run, out);
}
static void finish_pieces(Deal *deal, Outcome *out) {
write_fresh(deal, out);
if (run_judge(&deal->run, out) == DONE)
run_tell_unreached(&deal->run, out);
}
static int begin_deal(Deal *deal, const Scene *scene, const DealHow *how,
Outcome *out) {
if (!scene || (!ranks_share() && !how->pieces && ranks_refuse(out)))
return out->status;
open_deal(deal, scene, how);
if (!scene->make.entry && !scene->theory.line)
return outcome_set(out, WRONG, "%s: nothing to make; give make or theory",
scene->path);
if (how->pieces && choose_pieces(deal, out))
return out->status;
if (table_directory(how->directory, out))
return out->status;
if (ranks_first())
take_done(deal);
deal->monitor = monitor_open(scene, bytes_sum(deal->key.at, deal->key.length),
how->directory, how->seconds, deal->total);
monitor_skip(deal->monitor, deal->done);
return out->status;
}
static bool do_rest(Deal *deal, const DealHow *how, Outcome *out) {
Ranks ranks = {.run = deal->run.all ? &deal->run : NULL,
.directory = how->directory,
.workers = how->threads,
.seconds = how->seconds,
.key = &deal->key,
.own = deal,
.next = next_job,
.take = take_record};
if (ranks_share())
return ranks_run(&ranks, out);
if (out->status == DONE)
by_threads(deal);
return true;
}
int deal_run(const Scene *scene, const DealHow *how, Outcome *out) {
Deal deal = {.how = how};
Outcome kept = {0};
begin_deal(&deal, scene, how, out);
bool first = do_rest(&deal, how, out);
if (first && deal.monitor)
monitor_judge(deal.monitor, out);
monitor_close(&deal.monitor);
if (first && out->status != DONE && deal.done > 0)
write_fresh(&deal, &kept);
else if (first && out->status == DONE && how->pieces)
finish_pieces(&deal, out);
else if (first && out->status == DONE)
finish_whole(&deal, out);
close_deal(&deal);
return out->status;
}
typedef struct {
Deal deal;
Scene *scene;
const char **set;
Bytes key;
int *from;
} Merge;
static int begin_merge(Merge *merge, const Parts *parts, const DealHow *how,
Outcome *out) {
bytes_add(&merge->key, parts->key.at, parts->key.length);
merge->scene = parts_scene(&merge->key, &merge->set, out);
if (!merge->scene)
return out->status;
open_deal(&merge->deal, merge->scene, how);
merge->from = memory((size_t)merge->deal.run.jobs, sizeof *merge->from);
const char *differs = parts_differ(&merge->key, &merge->deal.key);
if (differs)
return outcome_set(out, WRONG,
"%s: was made with %s; merge with the program and in "
"the place that made it",
parts->path, differs);
return DONE;
}
static int refuse_file(const Merge *merge, const Parts *parts, Outcome *out) {
if (!parts->key.at)
return outcome_set(out, WRONG,
"%s: no finished realizations, or damaged; make them "
"again",
parts->path);
const char *differs =
merge->scene ? parts_differ(&merge->key, &parts->key) : NULL;
if (differs)
return outcome_set(out, WRONG,
"%s: differs from the first, %s; merge them apart",
parts->path, differs);
return DONE;
}
static int merge_record(Merge *merge, const Parts *parts, Bytes *record,
int from, const char *const name[], Outcome *out) {
Run *run = &merge->deal.run;
Bytes old = {0};
int head, job = (int)bytes_next_whole(record);
bool known = job >= 0 && job < run->jobs && merge->deal.state[job] == KEPT;
record->next = 0;
if (known)
parts_pack(run, job, &old);
bool same = bytes_same(&old, record);
bytes_free(&old);
if (known && !same)
return outcome_set(out, WRONG,
"realization %d is in %s and, with other results, in "
"%s; one of them is wrong: make it again",
run_realization(run, job, &head), name[merge->from[job]],
name[from]);
if (!known && parts_unpack(run, record) < 0)
return outcome_set(out, WRONG, "%s: damaged; make it again", parts->path);
if (!known) {
merge->deal.state[job] = KEPT;
merge->from[job] = from;
}
return DONE;
}
static int merge_directory(Merge *merge, const char *const name[], int from,
const DealHow *how, Outcome *out) {
Parts parts;
Bytes record;
parts_open(&parts, name[from]);
if (parts.count == 0)
outcome_set(out, WRONG,
"%s: holds no finished realizations; give directories of run "
"--realizations",
name[from]);
while (out->status == DONE && parts_next(&parts)) {
if (refuse_file(merge, &parts, out) ||
(!merge->scene && begin_merge(merge, &parts, how, out)))
break;
while (out->status == DONE && parts_record(&parts, &record))
merge_record(merge, &parts, &record, from, name, out);
}
parts_close(&parts);
return out->status;
}
static void add_range(char list[], size_t room, int from, int to) {
size_t length = strlen(list);
snprintf(list + length, room - length, from < to ? "%s%d-%d" : "%s%d",
*list ? "," : "", from, to);
}
static int refuse_missing(const Deal *deal, Outcome *out) {
int most = count_realizations(&deal->run), head, from = -1;
bool *missing = memory((size_t)most + 1, sizeof *missing);
char list[200] = "";
for (int job = 0; job < deal->run.jobs; job++)
if (!run_done(&deal->run, job, NULL))
missing[run_realization(&deal->run, job, &head)] = true;
for (int k = 0; k <= most; k++) {
if (missing[k] && from < 0)
from = k;
if (!missing[k] && from >= 0) {
add_range(list, sizeof list, from, k - 1);
from = -1;
}
}
free(missing);
return *list ? outcome_set(out, WRONG,
"realizations are missing; make them with "
"--realizations %s",
list)
: DONE;
}
int deal_merge(const char *const from[], int count, const char *directory,
Outcome *out) {
Merge merge = {0};
DealHow how = {.directory = directory};
for (int d = 0; d < count && out->status == DONE; d++)
merge_directory(&merge, from, d, &how, out);
if (out->status == DONE)
run_note_all(&merge.deal.run);
if (out->status == DONE && refuse_missing(&merge.deal, out) == DONE)
finish_whole(&merge.deal, out);
if (merge.scene)
close_deal(&merge.deal);
scene_free(&merge.scene);
bytes_free(&merge.key);
free(merge.set);
free(merge.from);
return out->status;
}
