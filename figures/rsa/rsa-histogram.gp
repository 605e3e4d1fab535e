# p(n_h) of RSA packs at .30, windows of r_h = 2.5 a.
# data: rsa-histogram rsa-histogram-random points-histogram
set xrange [-0.6:16.6]; set yrange [0:0.42]
set xlabel "$n_h$, centres in the window"; set ylabel "$p(n_h)$"
set style fill solid 0.25 border
set key inside top right vertical
plot data("rsa-histogram-random", "histogram.tsv") using "n":"p":"p_err" with yerrorlines lt Added pt 8 ps 0.7 dt 2 title "windows on points", \
  data("rsa-histogram", "histogram.tsv") using "n":"p":"p_err" with yerrorlines lt Added ps 0.6 title "windows on particles", \
  data("points-histogram", "histogram.tsv") using "n":"p":"p_err" with yerrorlines lt Law pt 6 ps 0.5 title "particles without volume"
