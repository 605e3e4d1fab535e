# g(r) of random sequential addition at .30, beside Percus and Yevick's.
# data: rsa-g
g = data("rsa-g", "rdf.tsv"); t = data("rsa-g", "theory.tsv")
set multiplot
set lmargin screen 0.10; set rmargin screen 0.98; set tmargin screen 0.98; set bmargin screen 0.15
set xrange [1.95:6.05]; set yrange [0.75:2.5]
set xlabel "$R=r/a$" offset 0,0.7; set label 1 "$g(R)$" at screen 0.025,graph 0.5 center rotate
set key at graph 0.99,0.38 right vertical
plot t using "R":"py_0.3" with lines lt Py title "Percus--Yevick, $\\phi=.30$", \
  g using "R":"g":"g_err" with yerrorbars lt Added ps 0.35 title "random sequential addition"
# the difference, enlarged
set lmargin screen 0.40; set rmargin screen 0.97; set tmargin screen 0.97; set bmargin screen 0.55
set yrange [-0.15:0.11]; set ytics 0.05; set xtics 1
unset key; unset label; unset xlabel; set ylabel "RSA $-$ PY" offset 2.2
set xzeroaxis lt Guide
plot columns(g." ".t) using "R":(column("g") - column("py_0.3_2")):"g_err" with yerrorbars lt Added ps 0.3
unset multiplot
