# The two-point function of one pack at 61 radii, by each way: seconds of one core against error; lines: S's time of a point (Table 4), two points a segment.
# data: data/bench-seconds.tsv
set terminal cairolatex pdf size 12.6cm,6.4cm font ",10" fontscale 0.9 linewidth 1 dashlength 1.2
set output out
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [3e-7:3e-2]; set yrange [1e-3:1e5]; set xtics 100; set ytics 100
set multiplot layout 1,2
way(m, label) = recorded("task=twopoint;method=".m.";case=".label)
segments(x, second) = 61*2*0.21/x**2*second
set xlabel "error of $S_2$, root mean square"; set ylabel "seconds of one core" offset 2.2
unset key
set bmargin at screen 0.20; set lmargin at screen 0.12; set rmargin at screen 0.51; set tmargin at screen 0.96
set label 2 "S, CPU" at 2e-4,2e3 left; set label 3 "S, GPU" at 2.5e-5,3e1 right
set label 1 "a" at graph 0.06,0.93
plot way("exact", "hard") using "error":"seconds" with linespoints lt 1, \
  way("raster", "hard") using "error":"seconds" with linespoints lt 3, \
  way("segments", "hard") using "error":"seconds" with linespoints lt 2, \
  segments(x, 5.972e-7) with lines lt Source, segments(x, 4.62e-8) with lines lt Source dt 2
unset ylabel; unset label; set format y ""
set key at graph 0.99,0.99 right top vertical
set lmargin at screen 0.57; set rmargin at screen 0.96
set label 1 "b" at graph 0.06,0.93
plot way("exact", "penetrable") using "error":"seconds" with linespoints lt 1 title "exact", \
  way("raster", "penetrable") using "error":"seconds" with linespoints lt 3 title "raster", \
  way("segments", "penetrable") using "error":"seconds" with linespoints lt 2 title "segments"
unset multiplot
