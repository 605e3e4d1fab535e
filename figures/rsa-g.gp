# g(r) of random sequential addition at .30, beside Percus and Yevick's.
# data: rsa-g
g = data("rsa-g", "rdf.tsv"); t = data("rsa-g", "theory.tsv")
set multiplot
set lmargin screen 0.10; set rmargin screen 0.98; set tmargin screen 0.98; set bmargin screen 0.15
set xrange [1.95:6.05]; set yrange [0.75:2.5]
set xlabel "$R=r/a$" offset 0,0.7; set label 1 "$g(R)$" at screen 0.025,graph 0.5 center rotate
set key at graph 0.99,0.36 right vertical
plot t using 1:2 with lines lt 7 title "Percus--Yevick, $\\phi=.30$", \
  g using 1:2:3 with yerrorbars lt 1 pt 7 ps 0.3 title "random sequential addition"
# the difference, enlarged
set lmargin screen 0.40; set rmargin screen 0.97; set tmargin screen 0.97; set bmargin screen 0.55
set yrange [-0.15:0.11]; set ytics 0.05; set xtics 1
unset key; unset label; unset xlabel; set ylabel "RSA $-$ PY" offset 1
set xzeroaxis lt 8
plot "< awk -F'\\t' '/^#/ || !($1+0) {next} FNR==NR {t[sprintf(\"%.3f\",$1)]=$2; next} {k=sprintf(\"%.3f\",$1); if (k in t) print $1 FS $2-t[k] FS $3}' ".t." ".g \
  using 1:2:3 with yerrorbars lt 1 pt 7 ps 0.25
unset multiplot
