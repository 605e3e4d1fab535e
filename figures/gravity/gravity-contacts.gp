# Directions of contacts to the radius, and how many there are as the gap that is taken for one is widened.
# data: gravity gravity-discs gravity-contacts
set terminal cairolatex pdf size 12.6cm,6.6cm font ",10" fontscale 0.9
set output out
set multiplot
unset key
set tmargin screen 0.96; set bmargin screen 0.19
set lmargin screen 0.10; set rmargin screen 0.52
set xrange [0:1]; set xtics 0.2; set yrange [0:3.4]; set ytics 1
set xlabel "$|\\cos\\vartheta|$; 0 across, 1 along the radius"; set label 9 "contacts by isotropic ones" at screen 0.022,graph 0.5 center rotate
set arrow 1 from 0,1 to 1,1 nohead lt Guide back
set label 1 ink(Spheres, "spheres") at 0.03,1.5; set label 2 ink(Discs, "discs") at 0.66,2.6
plot data("gravity-discs", "radial@30000.tsv") using "c":"p":"p_err" with yerrorlines lt Discs lw 0.8 ps 0.5, \
  data("gravity", "radial.tsv") using "c":"p":"p_err" with yerrorlines lt Spheres lw 0.8 ps 0.5
unset label; unset arrow
set lmargin screen 0.63; set rmargin screen 0.985
set logscale x; set xrange [5e-9:0.2]; set format x "$10^{%T}$"; set xtics 100; set yrange [0:8.5]; set ytics 2
set xlabel "gap, diameters"; set label 9 "contacts of a sphere" at screen 0.568,graph 0.5 center rotate
set arrow 1 from 5e-9,6 to 0.2,6 nohead lt Guide back
set label 1 ink(Guide, "isostatic") at 1e-8,6.4
plot data("gravity-contacts", "sweep.tsv") using "measure.coordination.tolerance":"coordination":"coordination_err" with yerrorlines lt Spheres lw 0.8 ps 0.55
unset multiplot
