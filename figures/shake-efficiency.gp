# The relative error of the contact value after a second of one core: by rule against the fraction; of Metropolis' against the window.
# data: efficiency efficiency-step data/bench-seconds.tsv
key(s, k) = real(system(sprintf("sed -n 's/#.*//; s/.*\\b%s *= \\([0-9.]*\\);.*/\\1/p' figures/%s.scene", k, s)))
# a row: the keys of the sweep, the error of a mean over P realizations after a million operations in all
# between the samples, as a part of the value, times f; the error of that error
rows(s, q, select, f) = "< awk -F'\\t' -v P=".sprintf("%d", key(s, "realizations"))." -v f=".sprintf("%.12g", f)." -v part=".sprintf("%.12g", share(s))." '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) if (!($i in k)) k[$i] = i; next} ".select." {y = f*$k[\"".q."_err\"]/$k[\"".q."\"]*sqrt(P*part*$k[\"shake_trials\"]/1e6); print $1 \"\\t\" $2 \"\\t\" y \"\\t\" y/sqrt(2*(P - 1))}' ".data(s, "sweep.tsv")
share(s) = between(s)/(key(s, "sweeps") + between(s))
between(s) = (key(s, "samples") - 1)*key(s, "apart")
q = "shaken.contact"; exact = "shaken.contact_collision"
# with an operation's seconds, the error after a second by that after a million operations
second(l) = sqrt(1e6*real(system(sprintf("awk -F'\\t' '$1==\"shake\" && $2==\"ours\" && $3==\"%s\" && $4==2000 {print $6/$5}' data/bench-seconds.tsv", l))))
rule(r) = sprintf("$2 == \"%s\"", r)
best = rows("efficiency-step", q, "1", second("wide-window"))." | awk '!($1 in y) || $3 < y[$1] {y[$1] = $3; e[$1] = $4; w[$1] = $2} END {for (p in y) print p \"\\t\" w[p] \"\\t\" y[p] \"\\t\" e[p]}' | sort -g"
set logscale y
set yrange [2e-4:1e-2]
set ytics ("$.0002$" 2e-4, "$.0005$" 5e-4, "$.001$" 1e-3, "$.002$" 2e-3, "$.005$" 5e-3, "$.01$" 1e-2); set mytics 1
unset key
set multiplot
set tmargin screen 0.97; set bmargin screen 0.17; set lmargin screen 0.125; set rmargin screen 0.6
set xrange [0.17:0.605]; set xtics (".30" 0.3, ".45" 0.45, ".49" 0.49, ".575" 0.575)
set xlabel "$\\phi$"; set label 9 "relative error after one second" at screen 0.02,graph 0.5 center rotate
set label 1 ink(1, "metropolis, best $R_{\\rm sh}$") at 0.3,0.0042
set label 2 ink(3, "chain") at 0.29,0.00056 right; set label 3 ink(4, "newton") at 0.29,0.00029 right
set label 4 ink(2, "dynamics") at 0.29,0.00086 right; set label 5 ink(8, "open: from the virial") at 0.595,2.4e-4 right
d = 0.003
plot best using ($1-2*d):3:4 with yerrorlines lt 1 lw 0.8 ps 0.5, \
  best using ($1-2*d):($3*1.5):(sprintf("$%s$", sprintf("%g", $2)[2:])) with labels textcolor rgb "#0072b2", \
  rows("efficiency", q, rule("chain"), second("chain")) using ($1-d):3:4 with yerrorlines lt 3 lw 0.8 ps 0.6, \
  rows("efficiency", q, rule("newton"), second("newton")) using 1:3:4 with yerrorlines lt 4 lw 0.8 ps 0.6, \
  rows("efficiency", q, rule("dynamics"), second("dynamics")) using ($1+d):3:4 with yerrorlines lt 2 lw 0.8 ps 0.5, \
  rows("efficiency", exact, rule("chain"), second("chain")) using ($1-d):3:4 with yerrorlines lt 3 dt 2 pt 8 lw 0.8 ps 0.6, \
  rows("efficiency", exact, rule("newton"), second("newton")) using 1:3:4 with yerrorlines lt 4 dt 2 pt 12 lw 0.8 ps 0.6, \
  rows("efficiency", exact, rule("dynamics"), second("dynamics")) using ($1+d):3:4 with yerrorlines lt 2 dt 2 pt 4 lw 0.8 ps 0.5
set lmargin screen 0.635; set rmargin screen 0.985
unset label
set label 1 ink(1, "$\\phi=.575$") at 0.1,0.0052; set label 2 ink(7, "$.49$") at 0.62,0.0027
set label 3 ink(5, "$.45$") at 0.84,0.00164; set label 4 ink(6, "$.30$") at 0.84,0.0010
set logscale x; set xrange [0.04:1.1]; set xtics (".05" 0.05, ".1" 0.1, ".2" 0.2, ".3" 0.3, ".5" 0.5, ".8" 0.8); set format y ""
set ytics ("" 2e-4, "" 5e-4, "" 1e-3, "" 2e-3, "" 5e-3, "" 1e-2); set mxtics 1
set xlabel "$R_{\\rm sh}$"
plot for [i = 1:4] rows("efficiency-step", q, "$1 == ".word("0.3 0.45 0.49 0.575", i), second("wide-window")) using ($2*(1 + 0.02*(i - 2.5))):3:4 with yerrorlines lt word("6 5 7 1", i)+0 lw 0.8 ps 0.5
unset multiplot
