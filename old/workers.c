#include "workers.h"
#include "outcome.h"
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
struct Workers {
int count;
struct pollfd *socket;
pid_t *keeper;
};
static bool send_all(int socket, const Bytes *bytes) {
Bytes all = {0};
bytes_text(&all, bytes->at, bytes->length);
size_t done = 0;
for (ssize_t n = 1; done < all.length && n > 0;
done += (size_t)(n > 0) * (size_t)n)
n = send(socket, all.at + done, all.length - done, MSG_NOSIGNAL);
bool sent = done == all.length;
bytes_free(&all);
return sent;
}
static bool receive(int from, Bytes *bytes, size_t count) {
char some[65536];
while (count > 0) {
ssize_t n = read(from, some, count < sizeof some ? count : sizeof some);
if (n <= 0)
return false;
bytes_add(bytes, some, (size_t)n);
count -= (size_t)n;
}
return true;
}
static bool receive_all(int socket, Bytes *bytes) {
Bytes length = {0};
bytes->length = bytes->next = 0;
bytes->bad = false;
bool there = receive(socket, &length, 8) &&
receive(socket, bytes, (size_t)bytes_next_whole(&length) + 1);
bytes->length -= there;
bytes_free(&length);
return there;
}
static void die_with(pid_t parent) {
#ifdef __linux__
prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
if (getppid() != parent)
_exit(1);
}
static void be_worker(int to, pid_t parent, WorkersDo work, void *own,
Bytes *order) {
Bytes answer = {0};
die_with(parent);
work(own, order, &answer);
size_t done = 0;
while (done < answer.length) {
ssize_t n = write(to, answer.at + done, answer.length - done);
if (n <= 0)
_exit(1);
done += (size_t)n;
}
_exit(0);
}
static int have_done(WorkersDo work, void *own, Bytes *order, Bytes *answer) {
int ends[2], status = 1 << 8;
pid_t self = getpid();
answer->length = 0;
if (pipe(ends))
return status;
pid_t worker = fork();
if (worker == 0) {
close(ends[0]);
be_worker(ends[1], self, work, own, order);
}
close(ends[1]);
if (worker > 0) {
receive(ends[0], answer, SIZE_MAX);
waitpid(worker, &status, 0);
}
close(ends[0]);
return status;
}
static void be_keeper(int socket, pid_t parent, WorkersDo work, void *own) {
Bytes order = {0}, answer = {0}, told = {0};
die_with(parent);
while (receive_all(socket, &order)) {
int status = have_done(work, own, &order, &answer);
told.length = 0;
bytes_whole(&told, (uint64_t)status);
bytes_text(&told, answer.at, status ? 0 : answer.length);
if (!send_all(socket, &told))
break;
}
_exit(0);
}
static bool open_keeper(Workers *workers, WorkersDo work, void *own) {
int ends[2], w = workers->count;
pid_t self = getpid();
if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends))
return false;
fflush(NULL);
pid_t keeper = fork();
if (keeper == 0) {
for (int other = 0; other < w; other++)
close(workers->socket[other].fd);
close(ends[0]);
be_keeper(ends[1], self, work, own);
}
close(ends[1]);
if (keeper < 0)
close(ends[0]);
workers->socket[w] = (struct pollfd){.fd = ends[0], .events = POLLIN};
workers->keeper[w] = keeper;
workers->count += keeper > 0;
return keeper > 0;
}
Workers *workers_open(int count, WorkersDo work, void *own) {
Workers *workers = memory(1, sizeof *workers);
workers->socket = memory((size_t)count, sizeof *workers->socket);
workers->keeper = memory((size_t)count, sizeof *workers->keeper);
for (int w = 0; w < count && workers; w++)
if (!open_keeper(workers, work, own))
workers_close(&workers);
return workers;
}
void workers_close(Workers **workers) {
Workers *all = *workers;
for (int w = 0; all && w < all->count; w++) {
if (all->socket[w].fd >= 0)
close(all->socket[w].fd);
waitpid(all->keeper[w], NULL, 0);
}
if (all) {
free(all->socket);
free(all->keeper);
}
free(all);
*workers = NULL;
}
bool workers_gone(const Workers *workers, int w) {
return workers->socket[w].fd < 0;
}
bool workers_give(Workers *workers, int w, const Bytes *order) {
return !workers_gone(workers, w) && send_all(workers->socket[w].fd, order);
}
static void tell_end(int status, char lost[WORKERS_LOST]) {
*lost = '\0';
if (WIFSIGNALED(status))
snprintf(lost, WORKERS_LOST, "was ended by signal %d", WTERMSIG(status));
else if (WEXITSTATUS(status))
snprintf(lost, WORKERS_LOST, "ended with status %d", WEXITSTATUS(status));
}
int workers_take(Workers *workers, int milliseconds, Bytes *answer,
char lost[WORKERS_LOST]) {
Bytes told = {0};
int w = 0;
if (poll(workers->socket, (nfds_t)workers->count, milliseconds) <= 0)
return -1;
while (w < workers->count && !workers->socket[w].revents)
w++;
if (w == workers->count)
return -1;
answer->length = answer->next = 0;
if (receive_all(workers->socket[w].fd, &told)) {
size_t length;
tell_end((int)bytes_next_whole(&told), lost);
const char *text = bytes_next_text(&told, &length);
bytes_add(answer, text, length);
} else {
snprintf(lost, WORKERS_LOST, "and its keeper are gone");
close(workers->socket[w].fd);
workers->socket[w].fd = -1;
}
bytes_free(&told);
return w;
}
