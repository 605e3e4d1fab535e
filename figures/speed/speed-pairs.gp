# Pairs counted into 100 bins a second, at unit density up to a distance of 5.
# data: data/bench-seconds.tsv
rows(m) = recorded("task=pairs;method=".m)
# what the machine of the record could do
methods = system("awk -f figures/tools/columns.awk get=method 'where=task=pairs;size=1000' data/bench-seconds.tsv")
colour(m) = m eq "avx512f" ? Ours : m eq "avx2" ? 3 : m eq "default" ? 4 : m eq "plain_sorted" ? 5 : Plain
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [700:6e6]; set yrange [5e6:1e9]; set xtics 1e3,10,1e6
set xlabel "$N$"; set ylabel "pairs a second, one core" offset 1,0
unset key
plain(m, size) = 1/spent(sprintf("task=pairs;method=%s;size=%g", m, size))
# those of ours at their last points
if (strstrt(methods, "avx512f")) { set label ink(Ours, "8 lanes") at 1.15e6,1.16*plain("avx512f", 1e6) }
if (strstrt(methods, "avx2")) { set label ink(3, "4 lanes") at 1.15e6,1.04*plain("avx2", 1e6) }
set label ink(4, "2 lanes") at 1.15e6,0.87*plain("default", 1e6)
set label ink(5, "plain, particles in order") at 1.2e5,plain("plain_sorted", 1e5)
set label ink(Plain, "plain, in no order") at 1.2e5,plain("plain_lists", 1e5)
plot for [m in methods] rows(m) using "size":(1/each(1)):(each_err(1)/each(1)**2) with yerrorlines lt colour(m)
