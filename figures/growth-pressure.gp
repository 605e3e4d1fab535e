# The pressure by collisions: against Schultz's fit in the fluid; against Carnahan and Starling's beyond freezing.
# data: growth-pressure growth-metastable growth-theory
eos = "build/bin/randpack theory contact --phi "
grid(from, to, step) = system(sprintf("seq -s, %g %g %g", from, step, to))
# phi, Z of an equation over that of another
ratio(a, b, list) = "< ".eos.list." | awk '$1==\"".a."\" {z[$2] = $4} $1==\"".b."\" {y[$2] = $4; p[++n] = $2} END {for (i = 1; i <= n; i++) printf \"%s\\t%.12g\\n\", p[i], z[p[i]]/y[p[i]]}'"
# phi, Z and its error over that of an equation, from the rows of a sweep in which column c is v; solid fraction
over(b, s, f, c, v) = "< awk -F'\\t' '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) k[$i] = i; next} ".c." == ".v." {print $".f.", $k[\"Z\"], $k[\"Z_err\"], $k[\"solid_fraction_after\"]}' ".data(s, "sweep.tsv")." | while read phi z e q; do ".eos."$phi | awk -v z=$z -v e=$e -v q=$q '$1==\"".b."\" {printf \"%s\\t%.12g\\t%.12g\\t%s\\n\", $2, z/$4, e/$4, q}'; done"
# the same for Schultz's, freed of Z_N - Z = -phi q''/2N(1 + q'), q = phi (Z - 1), N = 1000
free = "< awk -F'\t' '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) k[$i] = i; next} {printf \"%s %s %s %.6f %.6f\\n\", $1, $k[\"Z\"], $k[\"Z_err\"], $1 - 1e-3, $1 + 1e-3}' ".data("growth-pressure", "sweep.tsv")." | while read phi z e l r; do ".eos."$l,$phi,$r | awk -v z=$z -v e=$e '$1==\"schultz\" {f[++n] = $2; Z[n] = $4; q[n] = $2*($4 - 1)} END {c = -f[2]*(q[3] - 2*q[2] + q[1])/1e-6/2000/(1 + (q[3] - q[1])/2e-3); printf \"%s\\t%.12g\\t%.12g\\n\", f[2], (z - c)/Z[2], e/Z[2]}'; done"
set multiplot
set lmargin screen 0.125; set rmargin screen 0.535; set tmargin screen 0.97; set bmargin screen 0.18
set xrange [0:0.51]; set xtics 0.1; set yrange [-3.3:1.7]
set xlabel "$\\phi$"; set ylabel "$Z/Z_{\\rm Schultz}-1$, per mille" offset 0.8,0
unset key
set label 1 ink(2, "Carnahan--Starling") at 0.02,-3.05
set label 2 ink(4, "Hansen-Goos, KLM") at 0.02,1.35
low = grid(0.01, 0.49, 0.01)
permille(r) = 1000*(r - 1)
plot 0 with lines lt 8, ratio("carnahan-starling", "schultz", low) using 1:(permille($2)) with lines lt 2, \
  ratio("hansen-goos", "schultz", low) using 1:(permille($2)) with lines lt 4, \
  ratio("klm", "schultz", low) using 1:(permille($2)) with lines lt 4 dt 2, \
  free using 1:(permille($2)):(1000*$3) with yerrorbars lt 1 ps 0.5
set lmargin screen 0.655; set rmargin screen 0.985
set xrange [0.485:0.57]; set xtics 0.02; set yrange [-1:10]
set ylabel "$Z/Z_{\\rm CS}-1$, per cent" offset 1,0
high = grid(0.48, 0.57, 0.002); fitted = grid(0.48, 0.55, 0.002)
unset label
set label 1 ink(1, "50") at 0.555,7.8 right; set label 2 ink(3, "800") at 0.557,2.9 right
set label 3 ink(8, "collisions a particle:") at 0.488,9.3
set label 4 ink(7, "Schultz") at 0.538,-0.45 right
percent(r) = 100*(r - 1)
plot 0 with lines lt 8, ratio("schultz", "carnahan-starling", fitted) using 1:(percent($2)) with lines lt 7, \
  for [i = 1:2] for [open = 0:1] over("carnahan-starling", "growth-metastable", 2, "$1", word("50 800", i)) \
    using 1:(($4 > 0.02) == open ? percent($2) : NaN):(100*$3) with yerrorbars lt 2*i-1 pt (i == 1 ? 7 - open : 9 - open) ps 0.6
unset multiplot
