# What B (10), (12), (13) and (20) give up: the sum rule, and the symmetry of g_12.
# data: theory-curves
set terminal cairolatex pdf size 12.6cm,6.8cm font ",10"
set output out
kappa = known("theory-curves", "willis_constant")
py(c) = (2 + c)/(2*(1 - c)**2) - 1
kanaun(c) = 1 - 8*c + c*py(c)/kappa
unset key
set multiplot
set tmargin screen 0.92; set bmargin screen 0.15
set lmargin screen 0.1; set rmargin screen 0.475
set xrange [0:0.64]; set yrange [-1.6:2]; set ytics 0.5; set xtics 0.2
set xlabel "$c$" offset 0,0.6; set label 1 "$S(0)$" at screen 0.013,graph 0.5 center rotate
set label 2 "(a)" at graph 0,1.07
set label 3 ink(Guide, "well-stirred (10)") at 0.335,-1.42 front
set label 4 ink(Willis, "Willis (12)") at 0.29,0.40 front
set label 5 ink(13, "Kanaun (13)") at 0.225,-0.33 front
set label 6 ink(Py, "Percus--Yevick") at 0.09,0.82
set object 1 rectangle from graph 0,graph 0 to graph 1,first 0 fc rgb "#eeeeee" fs solid noborder behind
set label 7 ink(Guide, "no pack") at 0.03,-1.42 front
marks(n) = columns(sprintf("'of=%s_*_S0' %s", n, data("theory-curves", "summary.tsv")))
plot [x=0:0.64] 1 - 8*x with lines lt Guide dt 1, 0 with lines lt Willis, kanaun(x) with lines lt 13 dt 2, (1 - x)**4/(1 + 2*x)**2 with lines lt Py, \
  marks("well-stirred") using "at":"value" with points lt Guide pt 4 dt 1 ps 0.7, marks("willis") using "at":"value" with points lt Willis pt 5 ps 0.5, \
  marks("willis-kanaun") using "at":"value" with points lt 13 pt 9 ps 0.7, marks("py") using "at":"value" with points lt Py pt 7 dt 1 ps 0.6
unset object; unset label
a1 = 1.; a2 = 0.313; c = 0.6; xi = 0.333
c1 = c/(1 + xi); c2 = c - c1; z2 = c1/(2*a1) + c2/(2*a2)
own(a) = (1 - c + 3*a*z2)/(1 - c)**2
g12 = (a2*own(a1) + a1*own(a2))/(a1 + a2)
curve(R) = 1 + (g12 - 1)*cos(pi*R)*exp(2*(2 - R))
s0 = a2/2
set lmargin screen 0.595; set rmargin screen 0.985
set xrange [1.25:2.6]; set yrange [-0.5:8]; set ytics 2; set xtics 0.5
set xlabel "$r/a_1$" offset 0,0.6; set label 1 "$g(r)$ of (20)" at screen 0.535,graph 0.5 center rotate
set label 2 "(b)" at graph 0,1.07
set label 3 ink(2, "$g_{21}$") at 1.74,3.1
set label 4 ink(1, "$g_{12}$") at 1.50,-0.05 right
set label 5 ink(Guide, "in $2r/(a_1+a_2)$") at 1.9,1.75
set label 6 sprintf("at $r=%.3f\\,a_1$:", a1 + a2 + s0) at 1.72,7.3
set label 7 ink(1, sprintf("$g_{12}=%.2f$", curve(2 + s0/a2))) at 1.72,6.45
set label 8 ink(2, sprintf("$g_{21}=%.2f$", curve(2 + s0/a1))) at 1.72,5.6
set arrow 1 from a1 + a2 + s0,curve(2 + s0/a2) to a1 + a2 + s0,curve(2 + s0/a1) heads size 0.03,20 lt Law lw 0.8
set samples 600
plot [x=a1+a2:2.6] 1 with lines lt Guide, curve((x - a1)/a2 + 1) with lines lt 1, curve((x - a2)/a1 + 1) with lines lt 2 dt 4, \
  curve(2*x/(a1 + a2)) with lines lt Guide lw 1.4
unset multiplot
