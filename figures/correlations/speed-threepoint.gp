# Three points on a grid of 100 x 100: error against seconds; lines: S's time of a point (Table 4, 10^7 points), three points a triangle.
# data: data/bench-seconds.tsv
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [1e-4:5e-2]; set yrange [2e-2:2e4]
set xlabel "error of $S_3$, root mean square over cells"; set ylabel "seconds of one core" offset 1
set key at graph 0.99,0.99 right vertical
set label 1 "S, CPU" at 6e-3,400; set label 2 "S, GPU" at 3e-4,5e2 right
triangles(x, second) = 3e4*0.25/x**2*second
plot recorded("task=threepoint;method=shared;case=squares") using "error":"seconds" with linespoints lt Ours title "shared", \
  recorded("task=threepoint;method=triangles;case=squares") using "error":"seconds" with linespoints lt Plain title "triangles", \
  triangles(x, 5.972e-7) with lines lt Source notitle, triangles(x, 4.62e-8) with lines lt Source dt 2 notitle
