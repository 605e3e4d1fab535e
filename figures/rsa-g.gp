# g(r) of random sequential addition at .30, beside Percus and Yevick's.
# data: rsa-g
set multiplot
set lmargin at screen 0.10; set rmargin at screen 0.97; set tmargin at screen 0.97; set bmargin at screen 0.15
set xrange [1.9:6]; set yrange [0.75:2.5]
set xlabel "$R=r/a$"; set ylabel "$g(R)$"
set key at graph 0.97,0.30
plot data("rsa-g", "theory.tsv") using 1:2 with lines lt 7 title "Percus--Yevick, $\\phi=.30$", \
  data("rsa-g", "rdf.tsv") using 1:2:3 with yerrorbars lt 1 pt 7 ps 0.25 title "random sequential addition"
# the difference, enlarged
set lmargin at screen 0.46; set rmargin at screen 0.95; set tmargin at screen 0.95; set bmargin at screen 0.55
set xrange [2:6]; set yrange [-0.09:0.11]; set ytics 0.05; set xtics 1
unset key; unset xlabel; set ylabel "RSA $-$ PY" offset 1,0
set xzeroaxis lt 8
plot "< awk -F'\\t' '!/^#/ && $1+0 {if (FNR==NR) t[sprintf(\"%.3f\",$1)]=$2; else {k=sprintf(\"%.3f\",$1); if (k in t) print $1\"\\t\"$2-t[k]\"\\t\"$3}}' build/data/rsa-g/theory.tsv build/data/rsa-g/rdf.tsv" \
  using 1:2:3 with yerrorbars lt 1 pt 7 ps 0.25
unset multiplot
