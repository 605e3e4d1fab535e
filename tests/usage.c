/* tests/usage.c: run a command, and print what it took: seconds of the processor, seconds, bytes of memory at most. */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

static double seconds(struct timeval t) {
  return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

int main(int count, char *words[]) {
  struct timeval begin, end;
  struct rusage usage;
  int status;
  if (count < 2)
    return 2;
  gettimeofday(&begin, NULL);
  pid_t child = fork();
  if (child == 0) {
    execvp(words[1], words + 1);
    _exit(127);
  }
  wait4(child, &status, 0, &usage);
  gettimeofday(&end, NULL);
  printf("%.4f %.4f %.0f\n", seconds(usage.ru_utime) + seconds(usage.ru_stime), seconds(end) - seconds(begin), 1024. * (double)usage.ru_maxrss);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
