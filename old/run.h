#ifndef RUN_H
#define RUN_H
#include "ensemble.h"
#include "scene.h"
typedef struct {
const Scene *scene;
Ensemble *all;
int combinations, jobs;
} Run;
void run_open(Run *run, const Scene *scene);
void run_close(Run *run);
int run_realization(const Run *run, int job, int *head);
bool run_job(Run *run, int job, const char *directory, Watch *watch);
bool run_has(const Run *run, int head, int k, int e);
bool run_wanted(const Run *run, int job);
bool run_stopped(const Run *run, int job);
bool run_done(const Run *run, int job, const char *directory);
bool run_transient(const Run *run, int job);
void run_drop(Run *run, int job);
void run_note(Run *run, int job);
void run_note_all(Run *run);
int run_judge(const Run *run, Outcome *out);
void run_tell_unreached(const Run *run, Outcome *out);
int run_measure(const Scene *scene, const char *const packs[], int count,
const char *directory, Outcome *out);
Ensemble run_ensemble(const Scene *scene, unsigned facts,
const Species species[], int kinds);
void run_forget(Ensemble *ensemble);
#endif
