/* tests/test_fields.c: keys and values of a line by the rules of extended XYZ, and what people write besides */
#include "fields.h"
#include "rng.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_test.h>
#include <stdlib.h>
#include <string.h>

/* The fields as "key|value;..." into text. */
static const char *flat(const char *line, char *text) {
  Fields fields;
  const char *wrong = fields_read(&fields, line);
  *text = '\0';
  for (size_t f = 0; f < fields.count; f++) {
    strcat(strcat(text, fields.field[f].key ? fields.field[f].key : "?"), fields.field[f].value ? "|" : "");
    strcat(strcat(text, fields.field[f].value ? fields.field[f].value : ""), ";");
  }
  fields_clear(&fields);
  return wrong;
}

static void test_lines(void) {
  static const char *const cases[][2] = {
      {"", ""},
      {" \t ", ""},
      {"a=1", "a|1;"},
      {"a=1 b = 2\tc =3 d= 4", "a|1;b|2;c|3;d|4;"},
      {"flag a=1 other", "flag;a|1;other;"},
      {"a=\"1 2 3\" b='x \"y\" z'", "a|1 2 3;b|x \"y\" z;"},
      {"a=\"say \\\"b=2\\\" \\\\ twice\" b=3", "a|say \"b=2\" \\ twice;b|3;"},
      {"\"a key\"=1 'b'='2'", "a key|1;b|2;"},
      {"a=[[1, 2], [3, 4]] b={x y}", "a|[[1, 2], [3, 4]];b|{x y};"},
      {"a=[\"x]\", \"y z\"] b=1", "a|[\"x]\", \"y z\"];b|1;"},
      {"a= b=1", "a|b=1;"},
      {"a=", "a|;"},
      {"===", "|==;"},
      {"a\"b c\"", "a\"b;c\";"},
      {"a=b=\"c\"", "a|b=\"c\";"}};
  char text[200];
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    const char *wrong = flat(cases[k][0], text);
    gsl_test(wrong || strcmp(text, cases[k][1]) != 0, "%s: %s", cases[k][0], text);
  }
  gsl_test(!flat("a=\"b", text) || !flat("\"a", text) || !flat("a='b\"", text), "a quote must end");
  gsl_test(!flat("a=[1, 2", text) || !flat("a=1]", text) || !flat("a=] b=2 c=[", text), "a bracket must end");
}

/* Whatever the line holds, no byte beyond: the sanitizer looks on. Written with quotes, the fields come back. */
static void test_random(void) {
  static const char letters[] = "ab= \t\"'\\[]{},\r";
  char line[64], text[400];
  Rng rng = rng_stream(5, 0, RNG_TEST);
  for (int k = 0; k < 20000; k++) {
    int length = (int)rng_below(&rng, 40);
    for (int i = 0; i < length; i++)
      line[i] = letters[rng_below(&rng, sizeof letters - 1)];
    line[length] = '\0';
    flat(line, text);
  }
  int wrong = 0;
  for (int k = 0; k < 2000; k++) {
    char value[40], quoted[100] = "key=\"";
    int length = (int)rng_below(&rng, 30), n = 5;
    for (int i = 0; i < length; i++) {
      value[i] = letters[rng_below(&rng, sizeof letters - 1)];
      if (value[i] == '"' || value[i] == '\\')
        quoted[n++] = '\\';
      quoted[n++] = value[i];
    }
    value[length] = '\0';
    strcpy(quoted + n, "\" more=1");
    Fields fields;
    bool twice;
    bool bad = fields_read(&fields, quoted) != NULL;
    const char *key = fields_find(&fields, "KEY", false, &twice), *more = fields_find(&fields, "more", true, &twice);
    wrong += bad || !key || strcmp(key, value) != 0 || twice || !more || strcmp(more, "1") != 0;
    fields_clear(&fields);
  }
  gsl_test_int(wrong, 0, "any value in quotes comes back");
}

static void test_find(void) {
  Fields fields;
  bool twice;
  fields_read(&fields, "Lattice=1 lattice=1 pbc=T PBC=F flag");
  gsl_test(strcmp(fields_find(&fields, "LATTICE", false, &twice), "1") != 0 || twice, "the same value twice is one");
  gsl_test(strcmp(fields_find(&fields, "pbc", false, &twice), "T") != 0 || !twice, "two values are two");
  gsl_test(strcmp(fields_find(&fields, "PBC", true, &twice), "F") != 0 || twice, "capitals count where they should");
  gsl_test(strcmp(fields_find(&fields, "flag", false, &twice), "") != 0, "a key alone");
  gsl_test(fields_find(&fields, "flags", false, &twice) != NULL, "a key that is not there");
  fields_clear(&fields);
}

static void test_values(void) {
  static const struct {
    const char *word;
    double value;
  } good[] = {{"1", 1}, {"-1.5", -1.5}, {".5", 0.5}, {"1e3", 1000}, {"1.5D+02", 150}, {"2d0", 2}, {"-3.D-1", -0.3}, {"0x10", 16}, {"inf", INFINITY},
      {"0000000000000000000000000000000000000000000000000000000000000000000001.5D3", 1500}};
  static const char *const bad[] = {"", " 1", "\f1", "x", "1x", "1,5", "1d", "1D+", "1 2", "--1", "d3", "1e5d3"};
  double v[4], x;
  bool t[3];
  for (size_t k = 0; k < sizeof good / sizeof *good; k++) {
    bool is = fields_number(good[k].word, &x);
    gsl_test(!is || x != good[k].value, "number %s: %g", good[k].word, x);
  }
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    gsl_test(fields_number(bad[k], &x), "no number: %s", bad[k]);
  gsl_test(fields_numbers("[[1, 2],[3 , 4.5]]", v, 4) != 4 || v[0] != 1 || v[3] != 4.5, "a matrix");
  gsl_test(fields_numbers("0.00000000000000000000000000000000000000000000000000000000000000000025e3 7", v, 4) != 2 || v[0] != 2.5e-64 || v[1] != 7,
           "a number of more than sixty letters, with its exponent");
  gsl_test(fields_numbers(" 1 2 ", v, 4) != 2 || v[1] != 2, "a row");
  gsl_test(fields_numbers("1 2 3 4 5", v, 4) != 5, "more than there is room for");
  gsl_test(fields_numbers("1 b", v, 4) != -1 || fields_numbers("", v, 4) != 0, "no row, and an empty one");
  gsl_test(fields_truths("T,false, TRUE", t, 3) != 3 || !t[0] || t[1] || !t[2], "truths");
  gsl_test(fields_truths("1 0 f", t, 3) != 3 || !t[0] || t[1] || t[2], "and in numbers");
  gsl_test(fields_truths("T yes T", t, 3) != -1, "none");
}

int main(void) {
  test_lines();
  test_random();
  test_find();
  test_values();
  return gsl_test_summary();
}
