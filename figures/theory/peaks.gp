# B Fig. 3: the configurations behind the second and the third peak.
# data:
set terminal cairolatex pdf size 12.6cm,4.1cm font ",10"
set output out
unset border; unset tics; unset key
set size ratio -1
set lmargin screen 0; set rmargin screen 1; set tmargin screen 1; set bmargin screen 0
set xrange [-1.6:12.9]; set yrange [-2.3:2.4]
h = sqrt(3)
$outer << END
x	y
0	0
3.4641016	0
7.3	0
11.3	0
END
$inner << END
x	y
1.7320508	1
1.7320508	-1
9.3	0
END
set arrow 1 from 0,0 to 2*h,0 heads filled size 0.18,18 lw 1.5 front
set label 1 "$R=2\\sqrt3$" at h,1 center front
set label 2 "(A)" at -1.2,1.8
set arrow 2 from 7.3,0 to 11.3,0 heads filled size 0.18,18 lw 1.5 front
set label 3 "$R=4$" at 9.3,0.45 center front
set label 4 "(B)" at 6.1,1.8
plot $outer using "x":"y":(1) with circles fs solid 0.18 border lc rgb "#0072b2" fc rgb "#0072b2", \
  $inner using "x":"y":(1) with circles fs solid 0.15 border lc rgb "#777777" fc rgb "#999999"
