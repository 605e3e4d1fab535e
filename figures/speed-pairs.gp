# Pairs counted into 100 bins a second, at unit density up to a distance of 5.
# data: data/bench-seconds.tsv
rows(m) = sprintf("< awk -F'\\t' '$1==\"pairs\" && $2==\"%s\"' data/bench-seconds.tsv", m)
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [700:6e6]; set yrange [5e6:1e9]; set xtics 1e3,10,1e6
set xlabel "$N$"; set ylabel "pairs a second, one core" offset 1,0
unset key
last(m) = real(system(sprintf("awk -F'\\t' '$1==\"pairs\" && $2==\"%s\" {y=$5/$6} END {print y+0}' data/bench-seconds.tsv", m)))
tag(m) = last(m) > 0 ? last(m) : 1e-9
set label ink(1, "8 lanes") at graph 0.86,0.93
set label ink(3, "4 lanes") at graph 0.86,0.86
set label ink(4, "2 lanes") at graph 0.86,0.79
set label ink(5, "plain, particles in order") at 1.2e5,tag("plain_sorted")
set label ink(2, "plain, in no order") at 1.2e5,tag("plain_lists")
plot rows("avx512f") using 4:($5/$6):($5*$7/$6**2) with yerrorlines lt 1, \
  rows("avx2") using 4:($5/$6):($5*$7/$6**2) with yerrorlines lt 3, \
  rows("default") using 4:($5/$6):($5*$7/$6**2) with yerrorlines lt 4, \
  rows("plain_sorted") using 4:($5/$6):($5*$7/$6**2) with yerrorlines lt 5, \
  rows("plain_lists") using 4:($5/$6):($5*$7/$6**2) with yerrorlines lt 2
