#include "ranks.h"
#include "monitor.h"
#include "parts.h"
#include "workers.h"
#include <limits.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef RANDPACK_MPI
#include <mpi.h>
#endif
static const struct {
const char *copies, *number;
int least;
} starters[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", 1},
{"PMI_SIZE", "PMI_RANK", 1},
{"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK", 1},
{"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", 2}};
static int number_of(const char *name) {
const char *text = getenv(name);
return text ? atoi(text) : 0;
}
static int starter(void) {
int count = (int)(sizeof starters / sizeof *starters);
for (int s = 0; s < count; s++)
if (number_of(starters[s].copies) >= starters[s].least)
return s;
return -1;
}
int ranks_started(void) {
int s = starter();
return s < 0 ? 0 : number_of(starters[s].copies);
}
int ranks_number(void) {
int s = starter();
return s < 0 ? 0 : number_of(starters[s].number);
}
int ranks_refuse(Outcome *out) {
int copies = ranks_started();
if (copies <= 1)
return DONE;
if (ranks_number() > 0)
return outcome_set(out, WRONG, "%s", "");
return outcome_set(out, WRONG,
"started as %d copies, but built without MPI, so that "
"each would do everything; build it by make MPI=1 build, "
"or give each copy its --realizations, or unset %s if "
"each has its own scene",
copies, starters[starter()].copies);
}
#ifdef RANDPACK_MPI
static void write_order(const Run *run, int job, Bytes *order) {
int head, k = run_realization(run, job, &head);
bytes_whole(order, (uint64_t)job);
for (int e = head; e < run->combinations; e++)
if (run_has(run, head, k, e))
bytes_whole(order, (uint64_t)run->all[e].failed);
}
static void work(void *own, Bytes *order, Bytes *answer) {
const Ranks *ranks = own;
Run *run = ranks->run;
int head, job = (int)bytes_next_whole(order);
int k = run_realization(run, job, &head);
for (int e = head; e < run->combinations; e++)
if (run_has(run, head, k, e))
run->all[e].failed = (int)bytes_next_whole(order);
omp_set_num_threads(1);
const Scene *scene = run->all[head].scene;
uint64_t sum = bytes_sum(ranks->key->at, ranks->key->length);
Monitor *monitor =
monitor_open(scene, sum, ranks->directory, ranks->seconds, 1);
Watch *watch = monitor_begin(monitor, scene, k);
bool done = run_job(run, job, ranks->directory, watch);
monitor_end(monitor, &watch, done);
monitor_close(&monitor);
parts_pack(run, job, answer);
}
enum { ORDER = 1, ANSWER = 2 };
enum { FREE, DID, LOST, GONE };
static void send_bytes(const Bytes *bytes, int rank, int tag) {
MPI_Send(bytes->at, (int)bytes->length, MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}
static int hear(int tag, Bytes *bytes) {
MPI_Status status;
int there, length;
MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &there, &status);
if (!there)
return -1;
MPI_Get_count(&status, MPI_BYTE, &length);
*bytes = (Bytes){.at = memory_grow(bytes->at, (size_t)length, 1),
.length = (size_t)length,
.room = (size_t)length};
MPI_Recv(bytes->at, length, MPI_BYTE, status.MPI_SOURCE, tag, MPI_COMM_WORLD,
MPI_STATUS_IGNORE);
return status.MPI_SOURCE;
}
static void send_answer(int w, int with, const char *lost,
const Bytes *record) {
Bytes all = {0};
bool fits = record->length < INT_MAX / 2;
bytes_whole(&all, (uint64_t)w);
bytes_whole(&all, (uint64_t)(fits ? with : LOST));
lost = fits ? lost : "has more results than a message holds";
bytes_text(&all, lost, strlen(lost));
bytes_text(&all, record->at, fits ? record->length : 0);
send_bytes(&all, 0, ANSWER);
bytes_free(&all);
}
static void send_order(int rank, int w, const Bytes *order) {
Bytes all = {0};
bytes_whole(&all, (uint64_t)w);
bytes_text(&all, order->at, order->length);
send_bytes(&all, rank, ORDER);
bytes_free(&all);
}
static int longer(int pause, bool heard) {
return heard ? 0 : pause < 5 ? pause + 1 : 5;
}
static int answer_of(const Workers *own, int w, const char *lost) {
return workers_gone(own, w) ? GONE : *lost ? LOST : DID;
}
enum { TRIES = 3 };
static const char gone[] = "is gone";
typedef struct {
const Ranks *ranks;
Workers *own;
int workers, slots;
int *job;
int *idle, idles;
int given, known;
int *losses;
Outcome *out;
} Dealer;
static void tell_loss(Dealer *dealer, int job, const char *lost) {
const Run *run = dealer->ranks->run;
long long seed = (long long)run->scene->seed;
int head, k = run_realization(run, job, &head);
const char *suffix = run->all[head].scene->suffix;
bool again = ++dealer->losses[job] < TRIES;
fprintf(stderr,
"randpack: realization %d%s (seed %lld) is lost: its worker %s%s\n",
k, suffix, seed, lost, again ? "; it is done again" : "");
if (!again)
outcome_set(dealer->out, UNREACHED,
"realization %d%s (seed %lld) was lost %d times; the last time "
"its worker %s",
k, suffix, seed, TRIES, lost);
}
static void take_answer(Dealer *dealer, int slot, int with, const char *lost,
Bytes *record) {
int job = dealer->job[slot];
dealer->known += with == FREE;
dealer->job[slot] = -1;
if (job >= 0) {
dealer->given--;
if (with != DID)
tell_loss(dealer, job, lost);
dealer->ranks->take(dealer->ranks->own, job, with == DID ? record : NULL);
}
if (with != GONE)
dealer->idle[dealer->idles++] = slot;
}
static void give_job(Dealer *dealer, int slot, int job) {
int rank = slot / dealer->workers, w = slot % dealer->workers;
Bytes order = {0};
write_order(dealer->ranks->run, job, &order);
dealer->job[slot] = job;
dealer->given++;
if (rank > 0)
send_order(rank, w, &order);
else if (!workers_give(dealer->own, w, &order))
take_answer(dealer, slot, GONE, gone, NULL);
bytes_free(&order);
}
static bool hear_own(Dealer *dealer, int pause) {
Bytes record = {0};
char lost[WORKERS_LOST];
int w = workers_take(dealer->own, pause, &record, lost);
if (w >= 0)
take_answer(dealer, w, answer_of(dealer->own, w, lost), lost, &record);
bytes_free(&record);
return w >= 0;
}
static bool hear_others(Dealer *dealer) {
bool heard = false;
Bytes all = {0};
for (int rank; (rank = hear(ANSWER, &all)) > 0; heard = true) {
size_t length;
int w = (int)bytes_next_whole(&all), with = (int)bytes_next_whole(&all);
const char *lost = bytes_next_text(&all, NULL);
const char *text = bytes_next_text(&all, &length);
Bytes record = {.at = (unsigned char *)text, .length = length};
take_answer(dealer, rank * dealer->workers + w, with, lost, &record);
}
bytes_free(&all);
return heard;
}
static void deal_jobs(Dealer *dealer) {
const Ranks *ranks = dealer->ranks;
int pause = 0, job = 0;
for (;;) {
while (dealer->idles > 0 && dealer->out->status == DONE &&
(job = ranks->next(ranks->own)) >= 0)
give_job(dealer, dealer->idle[--dealer->idles], job);
if (dealer->given == 0 && dealer->known == dealer->slots)
break;
bool heard = hear_others(dealer);
heard |= hear_own(dealer, heard ? 0 : pause);
pause = longer(pause, heard);
}
if (job >= 0)
outcome_set(dealer->out, UNREACHED, "no worker is left to do the rest");
}
static void deal_out(const Ranks *ranks, Workers *own, int workers, int size,
Outcome *out) {
size_t slots = (size_t)workers * (size_t)size;
size_t jobs = (size_t)ranks->run->jobs;
Dealer dealer = {ranks, own, .workers = workers, .slots = (int)slots,
.out = out};
Bytes farewell = {0};
dealer.job = memory(slots, sizeof *dealer.job);
dealer.idle = memory(slots, sizeof *dealer.idle);
dealer.losses = memory(jobs, sizeof *dealer.losses);
for (int slot = 0; slot < dealer.slots; slot++)
dealer.job[slot] = -1;
for (int w = 0; w < workers; w++)
take_answer(&dealer, w, FREE, "", NULL);
deal_jobs(&dealer);
for (int slot = workers; slot < dealer.slots; slot++)
send_order(slot / workers, slot % workers, &farewell);
free(dealer.job);
free(dealer.idle);
free(dealer.losses);
}
static int take_orders(Workers *own, bool *heard) {
Bytes all = {0}, none = {0};
int farewells = 0;
for (; hear(ORDER, &all) >= 0; *heard = true) {
size_t length;
int w = (int)bytes_next_whole(&all);
const char *text = bytes_next_text(&all, &length);
Bytes order = {.at = (unsigned char *)text, .length = length};
if (length == 0)
farewells++;
else if (!workers_give(own, w, &order))
send_answer(w, GONE, "is gone", &none);
}
bytes_free(&all);
return farewells;
}
static void serve(Workers *own, int workers) {
Bytes record = {0};
char lost[WORKERS_LOST];
for (int w = 0; w < workers; w++)
send_answer(w, FREE, "", &record);
for (int pause = 0, left = workers; left > 0;) {
int w = workers_take(own, pause, &record, lost);
bool heard = w >= 0;
if (heard)
send_answer(w, answer_of(own, w, lost), lost, &record);
left -= take_orders(own, &heard);
pause = longer(pause, heard);
}
bytes_free(&record);
}
typedef struct {
Outcome out;
uint64_t sum;
} Standing;
static int judge_all(const Standing all[], int size, Outcome *out) {
*out = all[0].out;
for (int r = 1; r < size; r++)
if (all[r].out.status != DONE)
outcome_set(out, all[r].out.status, "rank %d: %s", r, all[r].out.text);
else if (all[r].sum != all[0].sum)
outcome_set(out, WRONG,
"rank %d has another scene or another program than rank 0",
r);
return out->status;
}
static bool agree(const Ranks *ranks, int rank, int size, Outcome *out) {
Standing own = {*out, 0}, *all = NULL;
int go = 0;
if (ranks->run)
own.sum = bytes_sum(ranks->key->at, ranks->key->length);
if (rank == 0)
all = memory((size_t)size, sizeof *all);
MPI_Gather(&own, sizeof own, MPI_BYTE, all, sizeof own, MPI_BYTE, 0,
MPI_COMM_WORLD);
if (rank == 0)
go = judge_all(all, size, out) == DONE;
MPI_Bcast(&go, 1, MPI_INT, 0, MPI_COMM_WORLD);
free(all);
return go;
}
bool ranks_first(void) {
return ranks_number() == 0;
}
bool ranks_share(void) {
return ranks_started() > 0;
}
bool ranks_run(const Ranks *ranks, Outcome *out) {
int workers = ranks->workers ? ranks->workers : 1, rank, size;
Workers *own = NULL;
if (out->status == DONE &&
!(own = workers_open(workers, work, (void *)ranks)))
outcome_set(out, UNREACHED, "the system has no room for more processes");
MPI_Init(NULL, NULL);
MPI_Comm_rank(MPI_COMM_WORLD, &rank);
MPI_Comm_size(MPI_COMM_WORLD, &size);
if (size != ranks_started())
outcome_set(out, WRONG,
"started as %d copies of which MPI sees %d: start it by the "
"mpirun that belongs to its MPI",
ranks_started(), size);
bool go = agree(ranks, rank, size, out);
if (go && rank == 0)
deal_out(ranks, own, workers, size, out);
else if (go)
serve(own, workers);
workers_close(&own);
MPI_Finalize();
if (rank > 0)
*out = (Outcome){0};
return rank == 0;
}
#else
bool ranks_first(void) {
return true;
}
bool ranks_share(void) {
return false;
}
bool ranks_run(const Ranks *ranks, Outcome *out) {
(void)ranks;
(void)out;
return true;
}
#endif
