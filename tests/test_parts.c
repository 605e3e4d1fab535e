/* tests/test_parts.c: what a job leaves comes back bit for bit; keys tell runs apart; damage is noticed */
#include "cost.h"
#include "parts.h"
#include "read.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char place[] = "/tmp/test_parts.XXXXXX";
static char start[80];

/* Two families of two, shaken with marks, in a box that is quickly filled. */
static const char text[] =
    "dimension = 3; seed = 12; realizations = 3; species = ( { name = \"A\"; radius = 1.5; number = 90; } ); fraction = 0.2;\n"
    "make = { method = \"rsa\"; }; shake = { radius = 0.2; sweeps = 3; marks = [1]; };\n"
    "measure = { rdf = { reach = 3.5; }; nearest = {}; contact = {}; };\n"
    "sweep = ( { key = \"fraction\"; values = [0.2, 0.15]; }, { key = \"shake.radius\"; values = [0.1, 0.3]; } );\n";

static Scene *scene_of(const char *name, const char *words, const char *const set[], int sets) {
  Outcome out = {0};
  Scene *scene = read_again(name, words, set, sets, &out);
  gsl_test(!scene, "is read (%s)", out.text);
  return scene;
}

static bool same_row(const Row *a, const Row *b) {
  if (!a->x || !b->x)
    return !a->x && !b->x;
  size_t bytes = a->length * sizeof(double);
  return a->length == b->length && memcmp(a->x, b->x, bytes) == 0 && memcmp(a->y, b->y, bytes) == 0;
}

static bool same_result(const Result *a, const Result *b) {
  if (!a->number || !b->number)
    return !a->number && !b->number;
  size_t bytes = (size_t)a->layout->numbers * sizeof(double);
  bool same = memcmp(a->number, b->number, bytes) == 0 && memcmp(a->error, b->error, bytes) == 0 &&
              a->out.status == b->out.status && strcmp(a->out.text, b->out.text) == 0 && a->transient == b->transient;
  for (int c = 0; c < a->layout->curves; c++)
    same &= same_row(&a->curve[c], &b->curve[c]);
  return same;
}

/* How many results of a job two runs have in common, of how many that are there. */
static int same_jobs(const Run *a, const Run *b, int *all) {
  int same = *all = 0;
  for (int e = 0; e < a->combinations; e++)
    for (int k = 0; k < a->all[e].count; k++) {
      const Result *x[] = {&a->all[e].result[k], &a->all[e].made[k], &a->all[e].look[2 * k], &a->all[e].look[2 * k + 1]};
      const Result *y[] = {&b->all[e].result[k], &b->all[e].made[k], &b->all[e].look[2 * k], &b->all[e].look[2 * k + 1]};
      for (int i = 0; i < 4; i++) {
        *all += x[i]->number != NULL;
        same += x[i]->number && same_result(x[i], y[i]);
      }
    }
  return same;
}

static void test_record(const Run *run, Run *fresh) {
  Bytes record = {0};
  int all = 0, damaged = 0;
  parts_pack(run, 1, &record);
  gsl_test_int(parts_unpack(fresh, &record), 1, "a record is of its job");
  int same = same_jobs(fresh, run, &all);
  gsl_test(same != all || all != 8, "and brings its %d results back to the last bit", all);
  record.next = 0;
  gsl_test_int(parts_unpack(fresh, &record), 1, "it may come a second time");
  for (size_t length = 0; length < record.length; length += 1 + length / 9) {
    Bytes part = {0};
    bytes_add(&part, record.at, length);
    damaged += parts_unpack(fresh, &part) >= 0;
    bytes_free(&part);
  }
  gsl_test_int(damaged, 0, "a part of a record is refused");
  same_jobs(fresh, run, &all);
  gsl_test_int(all, 0, "and leaves nothing");
  record.next = 0;
  bytes_whole(&record, 0);
  gsl_test_int(parts_unpack(fresh, &record), -1, "and so is one with more");
  bytes_free(&record);
}

static void test_failure(const Scene *scene) {
  Run run, back;
  Bytes record = {0};
  run_open(&run, scene);
  run_open(&back, scene);
  run_job(&run, 2, place, NULL);
  outcome_set(&run.all[1].result[2].out, UNREACHED, "jammed at %g", 0.375);
  run.all[1].result[2].transient = true;
  run_note_all(&run);
  gsl_test_int(run.all[1].failed, 2, "a failure is noted");
  parts_pack(&run, 2, &record);
  gsl_test_int(parts_unpack(&back, &record), 2, "a failure is a record");
  run_note(&back, 2);
  gsl_test(back.all[1].failed != 2 || strcmp(back.all[1].result[2].out.text, "jammed at 0.375") != 0, "and comes with its words");
  gsl_test(!run_transient(&back, 2) || run_done(&back, 2, NULL), "what failed by the machine is not done");
  gsl_test(run_done(&back, 0, NULL) || !run_wanted(&back, 0), "nor is what was not begun");
  bytes_free(&record);
  run_close(&run);
  run_close(&back);
}

/* Write jobs, read them back from the file; damage it at many places. */
static void test_file(const Run *run, Run *fresh, const Bytes *key) {
  const int jobs[] = {2, 0};
  Outcome out = {0};
  Parts parts;
  Bytes record;
  int all, taken = 0;
  gsl_test(parts_write(run, key, jobs, 2, place, &out), "a file is written (%s)", out.text);
  parts_open(&parts, place);
  gsl_test(parts.count != 1 || !parts_next(&parts) || !bytes_same(&parts.key, key), "its key is read");
  while (parts_record(&parts, &record))
    taken = 10 * taken + parts_unpack(fresh, &record) + 1;
  gsl_test_int(taken, 31, "its records are read in their order");
  gsl_test(parts_next(&parts), "it is the only one");
  int same = same_jobs(fresh, run, &all);
  gsl_test(same != all || all != 16, "its results are the same");
  FILE *file = fopen(parts.name[0], "r+b");
  fseek(file, 0, SEEK_END);
  long size = ftell(file);
  int seen = 0, tried = 0;
  for (long at = 0; at < size; at += 1 + size / 97, tried++) {
    fseek(file, at, SEEK_SET);
    int old = fgetc(file);
    fseek(file, at, SEEK_SET);
    fputc(old ^ 64, file);
    fflush(file);
    parts.next = 0;
    seen += parts_next(&parts) && !parts.key.at;
    fseek(file, at, SEEK_SET);
    fputc(old, file);
  }
  gsl_test_int(seen, tried, "a file with one wrong bit is damaged");
  fclose(file);
  parts.next = 0;
  gsl_test(truncate(parts.name[0], size - 1) || !parts_next(&parts) || parts.key.at, "and one that is cut off");
  parts_close(&parts);
}

static void test_folder(void) {
  char path[200], other[200];
  snprintf(path, sizeof path, "%s/parts/0123456789abcdef-7.part", place);
  snprintf(other, sizeof other, "%s/parts/mine", place);
  fclose(fopen(path, "w"));
  fclose(fopen(other, "w"));
  parts_remove(place);
  gsl_test(access(path, F_OK) == 0 || access(other, F_OK) != 0, "what is not ours stays in the folder, what a kill left goes");
  remove(other);
  parts_remove(place);
  snprintf(path, sizeof path, "%s/parts", place);
  gsl_test(access(path, F_OK) == 0, "an empty folder goes, too");
}

static const char *differ(const Bytes *key, const char *name, const char *words, const char *const set[], int sets) {
  Scene *scene = scene_of(name, words, set, sets);
  Bytes other = parts_key(scene);
  const char *what = parts_differ(key, &other);
  bytes_free(&other);
  scene_free(&scene);
  return what ? what : "same";
}

static void test_keys(const Scene *scene, const Bytes *key) {
  const char *one[] = {"seed=13"}, *two[] = {"seed=13", "realizations=2"}, *swap[] = {"realizations=2", "seed=13"};
  char other[sizeof text + 20];
  snprintf(other, sizeof other, "%s# word\n", text);
  gsl_test_str(differ(key, "else/where/parts.scene", text, NULL, 0), "same", "the directory of a scene does not count");
  gsl_test(!strstr(differ(key, "part.scene", text, NULL, 0), "name"), "its name does");
  gsl_test(!strstr(differ(key, "parts.scene", other, NULL, 0), "text"), "and its text");
  gsl_test(!strstr(differ(key, "parts.scene", text, one, 1), "settings"), "and its settings");
  Scene *set = scene_of("parts.scene", text, two, 2);
  Bytes with = parts_key(set);
  gsl_test(!strstr(differ(&with, "parts.scene", text, swap, 2), "settings"), "and their order");
  Bytes code = {0};
  bytes_add(&code, key->at, key->length);
  code.at[30] ^= 1;
  gsl_test(!strstr(parts_differ(key, &code), "code"), "and the code: %s", parts_differ(key, &code));
  const char **sets;
  Outcome out = {0};
  Scene *back = parts_scene(&with, &sets, &out);
  Bytes again = back ? parts_key(back) : (Bytes){0};
  gsl_test(!back || back->sets != 2 || back->realizations != 2 || !bytes_same(&with, &again), "a scene comes back from its key");
  bytes_free(&again);
  scene_free(&back);
  free(sets);
  bytes_free(&code);
  bytes_free(&with);
  scene_free(&set);
  (void)scene;
}

/* A scene that grows from a pack: the file counts, wherever its name stands. */
static void test_files(void) {
  static const char grown[] = "# \"a remark\ndimension = 2; species = ( { radius = 1.0; number = 9; } ); fraction = 0.1;\n"
                              "make = { method = \"rsa\"; }; measure = { nearest = {}; };\n";
  char words[400], set[100];
  const char *sets[] = {set};
  snprintf(start, sizeof start, "%s/start", place);
  snprintf(words, sizeof words, "%s# \"%s\"\n", grown, start);
  snprintf(set, sizeof set, "seed=%d", 4);
  FILE *file = fopen(start, "w");
  fputs("one", file);
  fclose(file);
  Scene *scene = scene_of("s", words, NULL, 0);
  Bytes key = parts_key(scene);
  gsl_test_str(differ(&key, "s", words, NULL, 0), "same", "the same file");
  file = fopen(start, "w");
  fputs("two", file);
  fclose(file);
  gsl_test(!strstr(differ(&key, "s", words, NULL, 0), "file"), "a file that the scene names counts with what is in it");
  (void)sets;
  remove(start);
  bytes_free(&key);
  scene_free(&scene);
}

static void test_cost(void) {
  const double n[] = {1000, 4000}, linear[] = {3, 9}, steep[] = {2, 16}, flat[] = {5, 4}, none[] = {0, 4000};
  double power;
  gsl_test_rel(cost_straight(n, linear, 10000), 21, 1e-14, "a straight line goes on");
  gsl_test_rel(cost_grown(n, linear, 10000, &power), 21, 1e-14, "time that has a fixed part goes on straight");
  gsl_test_rel(cost_grown(n, steep, 16000, &power), 128, 1e-13, "a power of more than one goes on as one");
  gsl_test_rel(power, 1.5, 1e-14, "and is told");
  gsl_test_rel(cost_straight(n, flat, 16000), 4, 1e-14, "what has not grown does not grow");
  gsl_test_rel(cost_grown(none, steep, 8000, &power), 32, 1e-14, "one probe alone: in proportion");
  gsl_test_rel(cost_grown(n, steep, 4000, &power), 16, 1e-14, "nothing is changed where nothing is to be foretold");
}

int main(void) {
  if (!mkdtemp(place))
    return gsl_test(1, "a place"), gsl_test_summary();
  Scene *scene = scene_of("some/parts.scene", text, NULL, 0);
  if (scene) {
    Run run, fresh;
    Bytes key = parts_key(scene);
    run_open(&run, scene);
    run_open(&fresh, scene);
    gsl_test_int(run.jobs, 6, "two families of three realizations are six jobs");
    for (int job = 0; job < run.jobs; job++)
      run_job(&run, job, place, NULL);
    test_record(&run, &fresh);
    test_file(&run, &fresh, &key);
    test_folder();
    test_failure(scene);
    test_keys(scene, &key);
    run_close(&run);
    run_close(&fresh);
    bytes_free(&key);
    scene_free(&scene);
  }
  test_files();
  test_cost();
  rmdir(place);
  return gsl_test_summary();
}
