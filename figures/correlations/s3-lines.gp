# Lines on the surfaces of S Fig. 10: the diagonal, and a cut across it.
# data: s3-squares
set xrange [0:6]; set yrange [0.29:0.76]
set xlabel "$R=r/a$"; set ylabel "$S_3$" offset 1
set key at graph 0.98,0.97 right vertical
of(rows) = columns("'where=".rows."' ".data("s3-squares", "S3.tsv"))
same = " | awk -F'\\t' 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR == 1 || $at[\"R1\"] == $at[\"R2\"]'"
diagonal(t) = of(sprintf("theta=%g", t)).same
edge = of("theta=60;R1=0")
cut(t) = of(sprintf("theta=%g;R1=3", t))
plot edge using "R2":"S3" with lines lt Law title "$S_3(0,R)$", \
  diagonal(0) using "R1":"S3":"S3_err" with yerrorbars lt 1 title "$S_3(R,R,0)$", \
  diagonal(10) using "R1":"S3":"S3_err" with yerrorlines lt 2 title "$S_3(R,R,10^\\circ)$", \
  diagonal(60) using "R1":"S3":"S3_err" with yerrorlines lt 3 title "$S_3(R,R,60^\\circ)$", \
  cut(0) using "R2":"S3":"S3_err" with yerrorlines lt 4 title "$S_3(3,R,0)$"
