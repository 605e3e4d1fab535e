# Error of an overlap area against microseconds a pair.
# data: speed data/bench-seconds.tsv
forms = "pentagon 1.5-1.5 5-1 1-50"
names = "pentagons $1.5,\\;1.5$ $5,\\;1$ $1,\\;50$"
wrong(f, m, n) = known("speed", sprintf("overlap_%s_%s_%d", f, m, n))
took(f, m) = 1e6*spent(sprintf("task=overlap;method=%s;case=%s", m, f))
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [0.05:2e5]; set yrange [1e-17:1e-1]
set xlabel "microseconds a pair, one core"; set ylabel "error of the area" offset 1
set key outside right top vertical title "$a/b,\\;m$"
plot for [i=1:4] "+" using (took(word(forms, i), "ours")):(known("speed", sprintf("overlap_%s_ours", word(forms, i)))) every ::0::0 with points lt i pt 7 ps 0.8 title word(names, i), \
  for [i=1:4] "+" using (took(word(forms, i), "plain-points")):(wrong(word(forms, i), "points", 1000000)) every ::0::0 with points lt i pt 6 ps 0.8 notitle, \
  for [i=2:4] "+" using (took(word(forms, i), "mixed")):(wrong(word(forms, i), "mixed", 64)) every ::0::0 with points lt i pt 4 ps 0.8 notitle
