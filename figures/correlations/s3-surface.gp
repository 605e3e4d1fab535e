# S Fig. 10: three points in squares at phi = .7, as seen from above, for three angles between the arms.
# data: s3-squares
set terminal cairolatex pdf size 12.6cm,5.9cm font ",10" fontscale 0.9
set output out
set size ratio -1
set lmargin screen 0.075; set rmargin screen 0.985; set bmargin screen 0.2; set tmargin screen 0.79
set xrange [-0.05:20.05]; set yrange [-0.05:6.05]
set xlabel "$R_1=r_1/a$, at the angles $0^\\circ$, $10^\\circ$ and $60^\\circ$ from left to right"
set xtics ("0" 0, "2" 2, "4" 4, "6" 6, "0" 7, "2" 9, "4" 11, "6" 13, "0" 14, "2" 16, "4" 18, "6" 20)
set ytics 2
set palette defined (0.3 "#08306b", 0.34 "#2171b5", 0.38 "#5fb8c0", 0.44 "#a6dba0", 0.52 "#fed976", 0.7 "#fffff5")
set cbrange [0.3:0.7]; set cbtics 0.1; set colorbox horizontal user origin 0.32,0.925 size 0.4,0.035; set label 1 "$S_3$" at screen 0.29,screen 0.94 right; set label 2 "$R_2=r_2/a$" at screen 0.015,graph 0.5 center rotate
unset key
map(t) = columns(sprintf("'where=theta=%g' %s", t, data("s3-squares", "S3.tsv")))
plot map(0) using "R1":"R2":"S3" with image, map(10) using (column("R1") + 7):"R2":"S3" with image, map(60) using (column("R1") + 14):"R2":"S3" with image
