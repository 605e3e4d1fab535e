# The first peak of packs grown to .575, .60 and .63: against the rate of growth, and against the work.
# data: growth-isothermal growth-literal growth-rest growth-theory
set terminal cairolatex pdf size 12.6cm,15.5cm font ",10" fontscale 0.9
set output out
# the combinations of a fraction that were reached; those that are too solid are open
rows(s, phi) = columns(sprintf("'where=fraction=%g;reached>0' %s", phi, data("growth-".s, "sweep.tsv")))
fluid(s, phi) = columns(sprintf("'where=fraction=%g;reached>0;solid_fraction<0.02' %s", phi, data("growth-".s, "sweep.tsv")))
mark(full, open) = column("solid_fraction") > 0.02 ? open : full
# Percus and Yevick's mean over the first bin
weight(R) = R > 2.01005 ? 0 : R**2*(R < 2.00001 || R > 2.00995 ? 0.5 : 1)
array py[2]
do for [j = 1:2] {
  stats data("growth-theory", "theory.tsv") using (weight(column("R"))):(weight(column("R"))*column("py_".word("0.575 0.6", j))) nooutput
  py[j] = STATS_sum_y/STATS_sum_x
}
cs(phi) = equation("carnahan-starling", phi, "g(2+)")
# isothermal growth, literal, and at rest afterwards, which is dynamics
way(i) = i == 1 ? Isothermal : i == 2 ? Grown : Dynamics
full(i) = int(word("11 7 5", i))
bin = "contact_first_bin"; err = "contact_first_bin_err"
work(particles) = 2*column("collisions")/particles
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
    if (j < 3) { set arrow from x0,py[j] to x1,py[j] nohead lt Guide dt 3 }
    set arrow from x0,cs(phi) to x1,cs(phi) nohead lt Guide
    if (k == 2 && j == 1) {
      set label ink(Isothermal, "$\\scriptstyle\\blacktriangledown$ isothermal") at graph 0.95,0.92 right; set label ink(Grown, "$\\bullet$ literal") at graph 0.95,0.83 right
      set label ink(Dynamics, "$\\scriptstyle\\blacksquare$ $a_0=1$, then at rest") at graph 0.95,0.74 right
      set label ink(Guide, "lines: $g(2^+)$, extrapolated") at graph 0.95,0.65 right
    }
    if (k == 2) { set label ink(Guide, "Carnahan--Starling") at graph 0.04,first cs(phi)/1.15 }
    if (k == 2 && j < 3) { set label ink(Guide, "Percus--Yevick") at graph 0.04,first py[j]/1.15 }
    if (k == 1) {
      plot for [i = 1:2] rows(word("isothermal literal", i), phi) using "make.growth":bin:err with yerrorbars lt way(i) pt 0, \
        for [i = 1:2] rows(word("isothermal literal", i), phi) using "make.growth":bin:(mark(full(i), full(i) - 1)) with points lt way(i) pt variable ps 0.5, \
        for [i = 1:2] fluid(word("isothermal literal", i), phi) using "make.growth":"contact" with lines lt way(i) lw 0.7
    } else {
      plot for [i = 1:3] rows(word("isothermal literal rest", i), phi) using (work(1000.)):bin:err with yerrorbars lt way(i) pt 0, \
        for [i = 1:3] rows(word("isothermal literal rest", i), phi) using (work(1000.)):bin:(mark(full(i), full(i) - 1)) with points lt way(i) pt variable ps 0.5
    }
  }
}
unset multiplot
