# The first peak of packs grown to .575, .60 and .63: against the rate of growth, and against the work.
# data: growth-isothermal growth-literal growth-rest growth-theory
set terminal cairolatex pdf size 12.6cm,15.5cm font ",10" fontscale 0.9
set output out
# the combinations of a fraction that stand in column c and were reached; guard 1: too solid, 0: not
rows(s, c, phi, guard) = sprintf("< awk -F'\\t' '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) k[$i] = i; print; next} $%d==%g && $k[\"reached\"]>0 && ($k[\"solid_fraction\"]>0.02)==%d' %s", c, phi, guard, data("growth-".s, "sweep.tsv"))
py(phi) = real(system(sprintf("awk -F'\\t' '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) if ($i==\"py_%g\") c = i; next} $1<2.01005 {w = $1*$1*($1<2.00001 || $1>2.00995 ? 0.5 : 1); s += w*$c; n += w} END {print s/n}' %s", phi, data("growth-theory", "theory.tsv"))))
cs(phi) = real(system(sprintf("build/bin/randpack theory contact --phi %g | awk '$1==\"carnahan-starling\" {print $3}'", phi)))
bin = "contact_first_bin"; err = "contact_first_bin_err"
work(n) = 2*n/1000.
set logscale xy
set ytics nomirror; unset mytics; set mxtics 1
unset key
set multiplot layout 3,2 margins 0.125,0.985,0.09,0.99 spacing 0.035,0.03
do for [j = 1:3] {
  phi = real(word("0.575 0.6 0.63", j)); low = real(word("5.2 6 10", j)); high = real(word("130 60 130", j))
  set yrange [low:high]; set ytics (5, 7, 10, 15, 20, 30, 50, 70, 100, 150)
  do for [k = 1:2] {
    unset label; unset arrow
    if (k == 1) { set label "first peak" at screen 0.022,graph 0.5 center rotate by 90; set format y "%g"; set xrange [6e-4:16]; set xtics 1e-3,10,10
    } else { set format y ""; set xrange [40:3e4]; set xtics 100,10 }
    if (j == 3) { set format x (k == 1 ? "$10^{%T}$" : "$10^{%T}$")
      set xlabel (k == 1 ? "$\\Gamma$ (isothermal), $a_0$ (literal)" : "collisions a particle") offset 0,0.5
    } else { set format x ""; unset xlabel }
    x0 = k == 1 ? 6e-4 : 40; x1 = k == 1 ? 16 : 3e4
    if (k == 1) { set label sprintf("$\\phi=%s$", word(".575 .60 .63", j)) at graph 0.06,0.92 }
    if (j < 3) { set arrow from x0,py(phi) to x1,py(phi) nohead lt 8 dt 3 }
    set arrow from x0,cs(phi) to x1,cs(phi) nohead lt 8
    if (k == 2 && j == 1) {
      set label ink(1, "isothermal") at graph 0.95,0.92 right; set label ink(2, "literal") at graph 0.95,0.83 right
      set label ink(3, "$a_0=1$, then at rest") at graph 0.95,0.74 right
      set label ink(8, "lines: $g(2^+)$, extrapolated") at graph 0.95,0.65 right
    }
    if (k == 2) { set label ink(8, "Carnahan--Starling") at graph 0.03,first cs(phi)/1.14 }
    if (k == 2 && j < 3) { set label ink(8, "Percus--Yevick") at graph 0.03,first py(phi)/1.14 }
    if (k == 1) {
      plot for [g = 0:1] rows("isothermal", 2, phi, g) using 1:bin:err with yerrorbars lt 1 pt (g ? 6 : 7) ps 0.5, \
        for [g = 0:1] rows("literal", 2, phi, g) using 1:bin:err with yerrorbars lt 2 pt (g ? 4 : 5) ps 0.5, \
        rows("isothermal", 2, phi, 0) using 1:"contact" with lines lt 1 lw 0.7, \
        rows("literal", 2, phi, 0) using 1:"contact" with lines lt 2 lw 0.7
    } else {
      plot for [g = 0:1] rows("isothermal", 2, phi, g) using (work(column("collisions"))):bin:err with yerrorbars lt 1 pt (g ? 6 : 7) ps 0.5, \
        for [g = 0:1] rows("literal", 2, phi, g) using (work(column("collisions"))):bin:err with yerrorbars lt 2 pt (g ? 4 : 5) ps 0.5, \
        for [g = 0:1] rows("rest", 1, phi, g) using (work(column("collisions"))):bin:err with yerrorbars lt 3 pt (g ? 8 : 9) ps 0.6
    }
  }
}
unset multiplot
