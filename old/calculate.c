#include "calculate.h"
#include <stdbool.h>
#include "theory.h"
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>
static int next_number(const char **list, double *value) {
char *end;
if (!*list || !**list)
return 0;
*value = strtod(*list, &end);
if (end == *list || (*end && *end != ',') || !gsl_finite(*value))
return -1;
*list = *end ? end + 1 : end;
return 1;
}
static int each_number(const char *list, const char *option, double least,
double most, Outcome *out) {
double value;
const char *rest = list;
int more = 0;
while ((more = next_number(&rest, &value)) == 1)
if (!(value >= least && value <= most))
break;
if (more == 0 && list && *list)
return DONE;
return outcome_set(out, WRONG,
"%s %s: give numbers from %g to %g, with "
"commas",
option, list ? list : "(missing)", least, most);
}
static void print_equations(double phi, FILE *file) {
for (int e = 0; e < THEORY_EQUATIONS; e++) {
TheoryEquation equation = (TheoryEquation)e;
fprintf(file, "%s\t%g\t%.12g\t%.12g%s\n", theory_equation_name(equation),
phi, theory_contact(equation, phi), theory_pressure(equation, phi),
phi > theory_range(equation) ? "\tbeyond its range" : "");
}
}
static void print_structure(double phi, FILE *file) {
for (int c = 0; c < THEORY_CURVES; c++) {
TheoryCurve curve = (TheoryCurve)c;
fprintf(file, "%s\t%g\t%.9f\t%.9f\t%.9f\n", theory_curve_name(curve), phi,
theory_structure(curve, phi, 0), theory_least_structure(curve, phi),
theory_least_g(curve, phi));
}
}
static void print_curve(int curve, double phi, const char *at, FILE *file) {
double R;
Theory *theory = theory_alloc((TheoryCurve)curve, phi);
double possible[2];
theory_possible((TheoryCurve)curve, possible);
if (phi < possible[0] || phi > possible[1])
fprintf(stderr,
"randpack: note: no pack has this curve at %g: it is below "
"0, or its structure factor is\n",
phi);
while (next_number(&at, &R) == 1)
fprintf(file, "%.12g %.12g\n", R, theory_at(theory, R));
theory_free(&theory);
}
int calculate(const char *name, const char *phi, const char *at, FILE *file,
Outcome *out) {
int curve = theory_curve_find(name);
bool contact = strcmp(name, "contact") == 0;
bool structure = strcmp(name, "structure") == 0;
double value;
if (curve < 0 && !contact && !structure)
return outcome_set(out, WRONG,
"theory %s: no such curve; see randpack help", name);
if (each_number(phi, "--phi", 1e-300, 0.74, out) ||
(!contact && !structure && each_number(at, "--at", 0, 1e6, out)))
return out->status;
if (contact || structure)
fprintf(file, "# %s\n",
contact ? "equation\tphi\tg(2+)\tZ"
: "curve\tphi\tS(0)\tleast S(k)\tleast g");
while (next_number(&phi, &value) == 1)
if (contact)
print_equations(value, file);
else if (structure)
print_structure(value, file);
else
print_curve(curve, value, at, file);
return DONE;
}
void calculate_help(FILE *file) {
for (int c = 0; c < THEORY_CURVES; c++)
fprintf(file, "  %s\n", theory_curve_name((TheoryCurve)c));
fprintf(file, "  contact: g(2+) and Z by");
for (int e = 0; e < THEORY_EQUATIONS; e++)
fprintf(file, " %s", theory_equation_name((TheoryEquation)e));
fprintf(file, "\n  structure: S(0), the least S(k) and the least g of each "
"curve\n");
}
