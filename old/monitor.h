#ifndef MONITOR_H
#define MONITOR_H
#include "scene.h"
#include "watch.h"
void monitor_listen(void);
int monitor_signal(void);
void monitor_end_by_signal(void);
typedef struct Monitor Monitor;
Monitor *monitor_open(const Scene *scene, uint64_t key, const char *directory,
double seconds, int jobs);
void monitor_close(Monitor **monitor);
Watch *monitor_begin(Monitor *monitor, const Scene *of, int k);
void monitor_end(Monitor *monitor, Watch **watch, bool done);
void monitor_skip(Monitor *monitor, int jobs);
int monitor_judge(const Monitor *monitor, Outcome *out);
#endif
