# Discs in plane sections, and the spheres found from them.
# data: sections-one sections-law
set terminal cairolatex pdf size 12.6cm,10.5cm font ",10" fontscale 0.9
set output out
set multiplot
set tmargin screen 0.985; set bmargin screen 0.60
set lmargin screen 0.10; set rmargin screen 0.48
set xlabel "radius of a disc, by $a$" offset 0,0.4; set xrange [0:1.05]; set yrange [0:3.2]; set key at graph 0.04,0.95 left Left reverse
set label 1 "density" at graph -0.2,0.5 center rotate
plot data("sections-one", "section_discs.tsv") using "R":"f":"f_err" with yerrorbars lt 1 ps 0.4 title "discs", \
  (x < 1 ? x / sqrt(1 - x * x) : 1 / 0) with lines lt Law title "law"
set lmargin screen 0.58; set rmargin screen 0.98
set xlabel "$R=r/a$"; set xrange [0:4]; set yrange [0:4.2]; set ytics 1; set key at graph 0.98,0.98 right vertical Right noreverse
set label 1 "$g(R)$" at graph -0.24,0.5 center rotate
plot data("sections-one", "rdf.tsv") using "R":"g" with lines lt Law title "spheres", \
  data("sections-one", "section_rdf.tsv") using "R":"g":"g_err" with yerrorbars lt 1 ps 0.4 title "discs"
set tmargin screen 0.47; set bmargin screen 0.11
set lmargin screen 0.10; set rmargin screen 0.98
set ytics 0.5; set xlabel "radius of a sphere, by $a$"; set xrange [0:2.6]; set yrange [-0.4:1.9]; set key at graph 0.98,0.95 right vertical Right noreverse
set label 1 "density" at graph -0.085,0.5 center rotate; set xzeroaxis
plot data("sections-law", "section_saltykov@1.tsv") using "R":"p":"p_err" with yerrorbars lt 2 ps 0.4 title "by differences, one plane", \
  data("sections-law", "section_spheres@1.tsv") using "R":"p":"p_err" with yerrorbars lt 1 pt 6 ps 0.5 title "by likelihood, one plane", \
  data("sections-law", "section_spheres@16.tsv") using "R":"p":"p_err" with yerrorbars lt 3 ps 0.45 title "sixteen planes", \
  (x > 0 ? exp(-log(x) ** 2 / 0.18) / (x * 0.3 * sqrt(2 * pi)) : 0) with lines lt Law title "the law"
unset multiplot
