# paper/recorded.awk: which figures are drawn from recorded runs, and how much of the book is recorded, as LaTeX macros.
# -v recorded="SCENE SCENE ...", -v runs=N, how many runs these are; -v other=1: the seconds were recorded with other code.
# -v draft=1: this is a draft. Reads the drawings of figures/, whose line `# data: ...` names what a figure reads, and the chapters and the first
# pages, paper/front.tex, for their \val{SCENE}{...}.
BEGIN { many = split(recorded, name, " "); for (i = 1; i <= many; i++) sign[name[i]] = 1; sign["data/bench-seconds.tsv"] = 1 }
FNR == 1 { figure = FILENAME; sub(/.*\//, "", figure); drawn = sub(/\.(gp|sh)$/, "", figure); plots += drawn }
drawn && /^# data:/ {
  for (i = 3; i <= NF; i++) if ($i in sign) { mark = $i ~ /bench-seconds/ && other ? "\\othercode" : "\\recorded"; from[figure] = mark }
}
!drawn {
  rest = $0
  while (match(rest, /\\val[a-z]*\{[^}]*\}/)) {
    scene = substr(rest, RSTART, RLENGTH); sub(/.*\{/, "", scene); sub(/\}/, "", scene)
    numbers++; kept += scene in sign; rest = substr(rest, RSTART + RLENGTH)
  }
}
END {
  for (figure in from) { figures++; print "\\expandafter\\def\\csname plot@" figure "\\endcsname{" from[figure] "}" | "sort" }
  close("sort")
  printf "\\def\\recordedruns{%d}\\def\\recordednumbers{%d}\\def\\numbers{%d}\\def\\recordedplots{%d}\\def\\plots{%d}\n", runs, kept, numbers, figures, plots
  if (other) print "\\otherseconds"
  if (draft) print "\\draft"
}
