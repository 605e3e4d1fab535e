#include "calculate.h"
#include "cost.h"
#include "deal.h"
#include "drawing.h"
#include "export.h"
#include "help.h"
#include "monitor.h"
#include "picture.h"
#include "plan.h"
#include "plot.h"
#include "ranks.h"
#include "read.h"
#include "run.h"
#include "simd.h"
#include "table.h"
#include <fcntl.h>
#include <getopt.h>
#include <gsl/gsl_math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
static const char usage[] =
"randpack " TABLE_VERSION ": random packs of hard particles\n"
"\n"
"  randpack run SCENE [--out DIR] [--set KEY=VALUE]... [--threads N]\n"
"                     [--realizations 16-31] [--checkpoint SECONDS] "
"[--plot]\n"
"  randpack merge DIR... [--out DIR]\n"
"  randpack plan SCENE [--set KEY=VALUE]... [--time [--threads N]]\n"
"  randpack measure PACK.xyz... --scene SCENE [--out DIR] [--set ...]\n"
"  randpack theory NAME --phi PHI[,PHI...] [--at R,R,...]\n"
"  randpack convert PACK OUT [--format NAME] [--cells N] ...; see randpack "
"help convert\n"
"  randpack view PACK -o FILE.png|svg|pdf [--color species|size|\n"
"           coordination[=GAP]] [--cut z=0.5] [--frame K] [--scene SCENE]\n"
"  randpack plot TABLE.tsv... -o FILE.png|svg|pdf\n"
"  randpack help [make.crm|measure.rdf|...] | --help | --version\n"
"\n";
static const char verbs[] =
"run makes and measures what a scene says and writes tables into DIR "
"(else\n"
"here), with --plot or --plot=svg a picture of each. A run that is killed "
"or\n"
"interrupted (Control-C, SIGTERM) leaves in DIR/parts what it has "
"finished, "
"and\n"
"the state of what it was at, written every 60 s or as --checkpoint says "
"(0:\n"
"none); the same command goes on from there. With --realizations it makes "
"only\n"
"these, numbered from 0 as pack-K.xyz are, without tables; merge writes "
"the\n"
"tables when all are there, in one DIR or several. mpirun -n K randpack "
"run "
"...\n"
"shares the realizations among K processes, if it was built by make MPI=1 "
"build.\n";
static const char others[] =
"plan tells what run would store, make, measure and write, with --time "
"also the\n"
"time, memory and disk, from probes of a few seconds; measure takes packs "
"in\n"
"extended XYZ, dumps and data files of LAMMPS, and tables; theory prints\n"
"analytical curves; convert writes a pack for others (OVITO, ParaView, "
"LAMMPS,\n"
"Gmsh, POV-Ray, voxels, lists); view draws a pack, plot tables.\n"
"Exit status: 0 done; 1 not reached; 2 the input is wrong.\n"
"\n";
static void print_help(void) {
fputs(usage, stdout);
fputs(verbs, stdout);
fputs(others, stdout);
puts("Curves of theory (--at R, in radii; rows R g):");
calculate_help(stdout);
puts("\nKeys of a scene (R and steps in radii of the first species):");
help_keys(stdout);
puts(
"\nA scene:\n"
"  dimension = 3;\n"
"  species   = ( { name = \"A\"; radius = 1.0; number = 2000; } );\n"
"  fraction  = 0.60;\n"
"  make      = { method = \"crm\"; growth = 0.05; };\n"
"  measure   = { rdf = { reach = 6.0; }; pressure = {}; };\n"
"Shaken after it was made, and measured before and after:\n"
"  shake     = { rule = \"metropolis\"; radius = 0.02; sweeps = 60; };\n"
"A sweep of it: sweep.tsv has a row a combination, and the tables of "
"each\n"
"are named after its values, rdf@0.1@0.6.tsv:\n"
"  sweep = ( { key = \"make.growth\"; values = [0.1, 0.01]; },\n"
"            { key = \"fraction\"; values = [0.575, 0.6]; } );\n"
"If a combination is not reached the others are written, and the status\n"
"is 1, or 0 with unreached = \"keep\".");
}
typedef struct {
const char *verb, *out, *scene, *phi, *at, *realizations;
const char *plot;
PictureView view;
ConvertWords convert;
const char **set;
char **names;
int sets, threads, count;
bool asked, time;
double checkpoint;
bool kept;
} Options;
static int read_threads(Options *options, const char *text, Outcome *out) {
char *end;
long n = strtol(text, &end, 10);
if (end == text || *end || n < 1 || n > 4096)
return outcome_set(
out, WRONG, "--threads %s: give a whole number from 1 to 4096", text);
options->threads = (int)n;
return DONE;
}
static int read_checkpoint(Options *options, const char *text, Outcome *out) {
char *end;
double seconds = strtod(text, &end);
if (end == text || *end || !gsl_finite(seconds) || seconds < 0)
return outcome_set(out, WRONG,
"--checkpoint %s: give seconds, or 0 for none", text);
options->checkpoint = seconds;
options->kept = true;
return DONE;
}
static int read_options(int count, char *words[], Options *options,
Outcome *out) {
static const struct option known[] = {
{"out", 1, 0, 'o'}, {"set", 1, 0, 's'},
{"threads", 1, 0, 't'}, {"scene", 1, 0, 'c'},
{"realizations", 1, 0, 'z'}, {"checkpoint", 1, 0, 'k'},
{"time", 0, 0, 'm'}, {"phi", 1, 0, 'p'},
{"at", 1, 0, 'a'}, {"version", 0, 0, 'v'},
{"help", 0, 0, 'h'}, {"plot", 2, 0, 'l'},
{"color", 1, 0, 'r'}, {"cut", 1, 0, 'u'},
{"frame", 1, 0, 'f'}, {"format", 1, 0, 'F'},
{"cells", 1, 0, 'N'}, {"step", 1, 0, 'H'},
{"gap", 1, 0, 'G'}, {0, 0, 0, 0}};
options->set = memory((size_t)count, sizeof *options->set);
opterr = 0;
for (int c; (c = getopt_long(count, words, "o:", known, NULL)) != -1;)
switch (c) {
case 'o':
options->out = optarg;
break;
case 's':
options->set[options->sets++] = optarg;
break;
case 't':
if (read_threads(options, optarg, out))
return out->status;
break;
case 'z':
options->realizations = optarg;
break;
case 'k':
if (read_checkpoint(options, optarg, out))
return out->status;
break;
case 'm':
options->time = true;
break;
case 'c':
options->scene = optarg;
break;
case 'p':
options->phi = optarg;
break;
case 'a':
options->at = optarg;
break;
case 'v':
case 'h':
options->verb = c == 'v' ? "version" : "help";
options->asked = true;
break;
case 'l':
options->plot = optarg ? optarg : "png";
break;
case 'r':
options->view.color = optarg;
break;
case 'u':
options->view.cut = optarg;
break;
case 'f':
options->view.frame = options->convert.frame = optarg;
break;
case 'F':
options->convert.format = optarg;
break;
case 'N':
options->convert.cells = optarg;
break;
case 'H':
options->convert.step = optarg;
break;
case 'G':
options->convert.gap = optarg;
break;
default:
return outcome_set(out, WRONG,
"%s: no such option, or its value is "
"missing; see randpack help",
words[optind - 1]);
}
if (!options->verb)
options->verb = optind < count ? words[optind++] : "help";
options->names = words + optind;
options->count = count - optind;
return DONE;
}
static int draw_new(const Options *o, PlotSeen **seen, Outcome *out) {
Outcome drawn = {0};
if (*seen && out->status != STOPPED)
plot_new(seen, o->out, o->plot, &drawn);
return outcome_set(out, drawn.status, "%s", drawn.text);
}
static bool is_verb(const Options *o, const char *verb) {
return strcmp(o->verb, verb) == 0;
}
static int with_scene(const Options *o, const char *path, Outcome *out) {
PlotSeen *seen = NULL;
if (o->plot && (drawing_format(o->plot, out) || drawing_possible(out)))
return out->status;
Scene *scene = read_scene(path, o->set, o->sets, out);
DealHow how = {o->out, o->realizations, o->threads, o->checkpoint};
if (scene && o->plot)
seen = plot_look(o->out);
if (is_verb(o, "run"))
deal_run(scene, &how, out);
else if (scene && is_verb(o, "plan")) {
if (plan_scene(scene, stdout, out) == DONE && o->time)
cost_tell(scene, o->threads, stdout, out);
} else if (scene)
run_measure(scene, (const char *const *)o->names, o->count, o->out, out);
scene_free(&scene);
return draw_new(o, &seen, out);
}
static int refuse(const Options *o, Outcome *out) {
ConvertWords alone = o->convert;
alone.frame = NULL;
const struct {
const char *option, *verbs;
bool given;
} all[] = {{"--out", "run measure merge view plot", strcmp(o->out, ".") != 0},
{"--set", o->scene ? "measure convert view" : "run plan measure",
o->sets > 0},
{"--scene", "measure convert view", o->scene},
{"--phi", "theory", o->phi},
{"--at", "theory", o->at},
{"--realizations", "run", o->realizations},
{"--checkpoint", "run", o->kept},
{"--time", "plan", o->time},
{"--plot", "run measure", o->plot},
{"--color", "view", o->view.color},
{"--cut", "view", o->view.cut},
{"--frame", "convert view", o->convert.frame},
{convert_given(&alone), "convert", convert_given(&alone)}};
for (size_t i = 0; i < sizeof all / sizeof *all; i++)
if (all[i].given && !strstr(all[i].verbs, o->verb))
return outcome_set(out, WRONG, "%s is no option of %s; see randpack help",
all[i].option, o->verb);
return DONE;
}
static int with_pack(const Options *o, Outcome *out) {
Scene *scene = o->scene ? read_scene(o->scene, o->set, o->sets, out) : NULL;
PictureView how = o->view;
how.scene = scene;
if (o->threads)
omp_set_num_threads(o->threads);
if (out->status == DONE && is_verb(o, "view"))
picture_view(o->names[0], &how, o->out, out);
else if (out->status == DONE)
export_pack(o->names[0], o->names[1], &o->convert, scene, out);
scene_free(&scene);
return out->status;
}
static int draw(const Options *o, Outcome *out) {
bool view = is_verb(o, "view"), named = strcmp(o->out, ".") != 0;
if (o->count < 1 || (view && o->count > 1) || !named)
return outcome_set(out, WRONG,
view ? "view wants one PACK -o FILE.png"
: "plot wants TABLE.tsv... -o FILE.png");
return view ? with_pack(o, out)
: plot_tables((const char *const *)o->names, o->count, o->out,
out);
}
static int tell_program(const Options *o, Outcome *out) {
if (is_verb(o, "version"))
return puts("randpack " TABLE_VERSION), DONE;
bool word = is_verb(o, "help") && o->count > 0 && !o->asked;
if (word && strcmp(o->names[0], "convert") == 0)
return convert_help(stdout), DONE;
if (word)
return help_entry(o->names[0], stdout, out);
if (is_verb(o, "help"))
return print_help(), DONE;
return outcome_set(out, WRONG, "%s: no such verb; see randpack help",
o->verb);
}
static int wants(const Options *o, const char *what, Outcome *out) {
return outcome_set(out, WRONG, "%s wants %s; see randpack help", o->verb,
what);
}
static int do_verb(const Options *o, Outcome *out) {
const char *const *names = (const char *const *)o->names;
if (refuse(o, out))
return out->status;
if (is_verb(o, "run") || is_verb(o, "measure"))
monitor_listen();
if (is_verb(o, "run") || is_verb(o, "plan"))
return o->count == 1 ? with_scene(o, names[0], out)
: wants(o, "one scene", out);
if (is_verb(o, "measure"))
return o->count > 0 && o->scene ? with_scene(o, o->scene, out)
: wants(o, "PACK.xyz --scene SCENE", out);
if (is_verb(o, "merge"))
return o->count > 0 ? deal_merge(names, o->count, o->out, out)
: wants(o, "the directories of the pieces", out);
if (is_verb(o, "convert"))
return o->count == 2 ? with_pack(o, out) : wants(o, "PACK OUT", out);
if (is_verb(o, "view") || is_verb(o, "plot"))
return draw(o, out);
if (is_verb(o, "theory"))
return calculate(o->count == 1 ? names[0] : "", o->phi, o->at, stdout, out);
return tell_program(o, out);
}
static void prepare(void) {
for (int stream = 0; stream < 3; stream++)
if (fcntl(stream, F_GETFD) < 0)
open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
signal(SIGXFSZ, SIG_IGN);
}
int main(int count, char *words[]) {
Outcome out = {0};
Options options = {.out = ".", .checkpoint = 60};
prepare();
if (*simd_complaint())
outcome_set(&out, WRONG, "%s", simd_complaint());
else if (read_options(count, words, &options, &out) == DONE)
do_verb(&options, &out);
bool written = fflush(stdout) == 0 && !ferror(stdout);
if (out.status == DONE && !written)
outcome_set(&out, UNREACHED, "the standard output cannot be written");
bool told = out.status == DONE || !*out.text || !ranks_first();
if (!told)
fprintf(stderr, "randpack: %s\n", out.text);
free(options.set);
if (!told && out.status == STOPPED)
monitor_end_by_signal();
return told ? DONE : out.status;
}
