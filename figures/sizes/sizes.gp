# Sizes by a law: the pack's passing curve and the law's; and the fraction at which lognormal spheres jam.
# data: sizes-fuller sizes-jammed
set terminal cairolatex pdf size 12.6cm,6.4cm font ",10" fontscale 0.9
set output out
# radius, share of the number and of the volume up to it: of some of the small, of all the large
shares = "< awk -f figures/tools/pack.awk -f figures/tools/shares.awk ".data("sizes-fuller", "pack-0.xyz")
unset key
set multiplot
set lmargin screen 0.095; set rmargin screen 0.47; set tmargin screen 0.97; set bmargin screen 0.18
set logscale x; set xrange [1:10]; set xtics (1, 2, 3, 5, 10); set yrange [0:1.03]; set ytics 0.2; set mytics 2
set xlabel "radius, by the least" offset 0,0.4; set label 9 "share of what is smaller" at screen 0.012,graph 0.5 center rotate
set label 1 ink(1, "$\\bullet$ number") at 1.15,0.96
set label 2 ink(2, "$\\scriptstyle\\blacksquare$ volume") at 4.6,0.38
set label 3 ink(Guide, "lines: the law") at 3.9,0.12
set samples 200
plot (x**-2.5 - 1)/(10**-2.5 - 1) with lines lt Guide lw 1.2 dt 1, (sqrt(x) - 1)/(sqrt(10) - 1) with lines lt Guide lw 1.2 dt 1, \
  shares using "radius":"number" with points lt 1 pt 7 ps 0.4, shares using "radius":"volume" with points lt 2 pt 5 ps 0.35
unset label; unset logscale x
set lmargin screen 0.605; set rmargin screen 0.985
set xrange [-0.02:0.54]; set xtics 0.1; set mxtics 2; set yrange [0.63:0.71]; set ytics 0.02; set mytics 2; set format y "%.2f"
set xlabel "spread of $\\ln a$" offset 0,0.4; set ylabel "$\\phi$ at jamming" offset 1.6
plot data("sizes-jammed", "sweep.tsv") using "species.[0].sizes.spread":"fraction":"fraction_err" with yerrorlines lt Jammed ps 0.5
unset multiplot
