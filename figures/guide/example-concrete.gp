# The example of a concrete: the grains of a pack and the sieve curve that was wanted; how far the paste is from a grain.
# data: concrete-example
set terminal cairolatex pdf size 12.6cm,5.9cm font ",10" fontscale 0.9
set output out
shares = "< awk -f figures/tools/pack.awk -f figures/tools/shares.awk ".data("concrete-example", "pack-0.xyz")
$sieves << END
opening	passing
4	0
8	30
16	60
32	100
END
unset key
set multiplot
set lmargin screen 0.115; set rmargin screen 0.48; set tmargin screen 0.97; set bmargin screen 0.19
set logscale x; set xrange [3.6:36]; set xtics (4, 8, 16, 32); set yrange [0:105]; set ytics 20; set mytics 2
set xlabel "opening of the sieve, mm" offset 0,0.4; set ylabel "passing, \\%" offset 0.8
set label 1 ink(8, "line: wanted") at 4.1,92
set label 2 ink(1, "points: the pack") at 4.1,80
plot $sieves using "opening":"passing" with lines lt 8 lw 1.2 dt 1, shares using (2*column("radius")):(100*column("volume")) with points lt 1 pt 7 ps 0.4
unset label; unset logscale x
set lmargin screen 0.605; set rmargin screen 0.985
set xrange [0:3]; set xtics 1; set mxtics 2; set yrange [0:0.6]; set ytics 0.2
# The unit of the table is the radius of the grain of mean volume.
unit = real(system("sed -n 's/^# unit of length a = \\([0-9.]*\\).*/\\1/p' ".data("concrete-example", "E_V.tsv")))
set xlabel "distance from the grains, mm" offset 0,0.4; set ylabel "part of the cube" offset 1.2
plot data("concrete-example", "E_V.tsv") using (unit*column("R")):"E" with lines lt 2
unset multiplot
