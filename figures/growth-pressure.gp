# The measured pressure, as a deviation from Schultz's fit of the fluid, in per mille.
# data: growth-pressure growth-metastable
excess(f) = sprintf("< awk -F'\\t' '/^#/ {next} !h {h=1; for (c=NF; c>0; c--) n[$c]=c; next} \
  $n[\"Z_schultz\"] ~ /^[0-9]/ {s=$n[\"Z_schultz\"]; p=$n[\"fraction\"]; q=(1+p+p*p-p*p*p)/(1-p)^3; print p FS 1000*($n[\"Z\"]/s-1) FS 1000*$n[\"Z_err\"]/s FS $n[\"solid_fraction_after\"] FS 1000*(q/s-1)}' %s", data(f, "sweep.tsv"))
set xrange [0:0.57]; set yrange [-12:12]
set xlabel "$\\phi$"; set ylabel "$Z/Z_{\\rm Schultz}-1$ (\\textperthousand)" offset 1
set xzeroaxis lt 8
set key at graph 0.03,0.97 left top Left reverse vertical
set arrow 1 from 0.4918,graph 0 to 0.4918,graph 1 nohead lt 8
set label 1 "freezing" at 0.4918,graph 0.06 right offset -0.6,0
plot excess("growth-pressure") using 1:5 with lines lt 5 title "Carnahan--Starling", \
  excess("growth-metastable") using 1:5 with lines lt 5 notitle, \
  excess("growth-pressure") using 1:2:3 with yerrorbars lt 1 title "collisions, fluid", \
  excess("growth-metastable") using 1:2:3 with yerrorbars lt 2 title "collisions, after a long rest", \
  excess("growth-metastable") using 1:($4 > 0.02 ? $2 : NaN) with points pt 6 ps 1.6 lc rgb "#000000" title "ordering begun"
