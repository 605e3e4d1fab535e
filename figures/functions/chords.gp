# Chords of discs that may overlap and of hard discs, with the law of the first; and lineal paths.
# data: chords-discs chords-hard
set terminal cairolatex pdf size 12.6cm,10.5cm font ",10" fontscale 0.9
set output out
a = data("chords-discs", "chords.tsv"); b = data("chords-hard", "chords.tsv")
lambda = 2/pi*log(2)
set multiplot
set lmargin screen 0.13; set rmargin screen 0.98
set xrange [0:10]; set logscale y; set format y "$10^{%T}$"
set tmargin screen 0.985; set bmargin screen 0.58
set label 1 "$a\\,p(z)$" at screen 0.016,graph 0.5 center rotate
set yrange [1e-3:30]; set key at graph 0.99,0.98 right vertical
plot a using "R":"p_matrix":"p_matrix_err" every 2 with yerrorbars lt Discs pt 6 ps 0.5 title "matrix between discs that overlap", \
  lambda*exp(-lambda*x) with lines lt Law title "its law", \
  a using "R":"p_particles":"p_particles_err" every 2 with yerrorbars lt Discs pt 12 ps 0.6 title "these discs", \
  b using "R":"p_matrix":"p_matrix_err" every 2 with yerrorbars lt Discs ps 0.4 title "matrix between hard discs"
set tmargin screen 0.49; set bmargin screen 0.11
set xlabel "$z/a$"; set label 1 "$L(z)$"
set yrange [1e-3:1]; unset key
plot a using "R":"L_matrix":"L_matrix_err" every 2 with yerrorbars lt Discs pt 6 ps 0.5, \
  0.5*exp(-lambda*x) with lines lt Law, \
  a using "R":"L_particles":"L_particles_err" every 2 with yerrorbars lt Discs pt 12 ps 0.6, \
  b using "R":"L_matrix":"L_matrix_err" every 2 with yerrorbars lt Discs ps 0.4
unset multiplot
