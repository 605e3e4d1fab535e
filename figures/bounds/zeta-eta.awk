# from: zeta-square/summary.tsv zeta-triangular/summary.tsv zeta-discs-fluid/summary.tsv zeta-discs-rsa/summary.tsv zeta-discs-grown/summary.tsv zeta-discs-two/summary.tsv zeta-gravity-discs/summary.tsv zeta-gravity-discs-diluted/summary.tsv zeta-penetrable-discs/summary.tsv zeta-polygons/summary.tsv zeta-penetrable/summary.tsv zeta-roads/summary.tsv zeta-turned/summary.tsv zeta-cubic/summary.tsv zeta-bcc/summary.tsv zeta-fcc/summary.tsv zeta-spheres-fluid/summary.tsv zeta-spheres-rsa/summary.tsv zeta-spheres-grown/summary.tsv zeta-spheres-two/summary.tsv zeta-gravity/summary.tsv zeta-gravity-diluted/summary.tsv zeta-penetrable-spheres/summary.tsv
# zeta-eta.awk: all zeta2 and eta2 of the book in one table that others can cite, zeta-eta.tsv beside the summary: a row a pack, with what its
# scene says of it and the values of its sweep. data/zeta-eta.tsv is a copy of it (lint).
function shown(x) { return x == "" || x ~ /nan/ ? "nan" : sprintf("%.6g", x) }
function read_scene(name,   line, file, n, part) {
  file = "../../figures/bounds/" name ".scene"
  what = ""; keys = 0; dimension = packs = 1
  while ((getline line < file) > 0) {
    if (what == "" && line ~ /^# /) { what = substr(line, 3); sub(/\.$/, "", what) }
    if (line ~ /^dimension/) { gsub(/[^0-9]/, "", line); dimension = line }
    else if (line ~ /^realizations/) { gsub(/[^0-9]/, "", line); packs = line }
    else while (match(line, /key *= *"[^"]*"/)) {
      split(substr(line, RSTART, RLENGTH), part, "\""); key[++keys] = part[2]
      line = substr(line, RSTART + RLENGTH)
    }
  }
  close(file)
}
function end_of_file(   i, n, part, at, stage, name) {
  for (i = 1; i <= rows; i++) {
    name = quantity[i]; stage = ""
    if (match(name, /^(made|shaken)\./)) { stage = substr(name, 1, RLENGTH - 1); name = substr(name, RLENGTH + 1) }
    if (name !~ /^eta2(@|$)/) continue
    n = split(name, part, "@"); at = ""
    for (k = 2; k <= n; k++) at = at (k > 2 ? " " : "") key[k - 1] "=" part[k]
    sub(/^eta2/, "", name)
    before = stage == "" ? "" : stage "."
    phi = (("fraction" name) in value) ? value["fraction" name] : value[before "fraction" name]
    if (("covered" name) in value) phi = value["covered" name]
    else if (phi == "" && n > 1 && key[n - 1] == "fraction" && scene != "zeta-penetrable-spheres") phi = part[n]
    if (value[before "zeta2" name] ~ /nan/) continue
    print scene, dimension, what, stage == "" ? "-" : stage, at == "" ? "-" : at, shown(phi), shown(value[before "zeta2" name]), \
      shown(error[before "zeta2" name]), shown(value[before "eta2" name]), shown(error[before "eta2" name]), packs > out
    written++
  }
}
BEGIN {
  FS = OFS = "\t"; out = dir "/zeta-eta.tsv"
  print "# zeta2 and eta2 of packs, phase 2 being the particles: means over packs, with the standard errors of the means" > out
  print "# nan: an error of one pack, whose values are exact to the digits shown; the part of space that spheres which overlap cover is 1 - exp(-fraction) in the mean" > out
  print "scene", "dimension", "what", "stage", "keys", "fraction", "zeta2", "zeta2_err", "eta2", "eta2_err", "packs" > out
}
FNR == 1 {
  if (scene != "") end_of_file()
  split(FILENAME, path, "/"); scene = path[1]; read_scene(scene); rows = 0; delete value; delete error; delete quantity
}
/^#/ || /^quantity/ { next }
{ quantity[++rows] = $1; value[$1] = $2; error[$1] = $3 }
END {
  end_of_file()
  print "# written by zeta-eta.awk\nquantity\tvalue\tstandard_error"
  printf "packs\t%d\t0\n", written
}
