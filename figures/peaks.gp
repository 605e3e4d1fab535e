# B Fig. 3: the configurations behind the second and the third peak.
# data:
set terminal cairolatex pdf size 12.6cm,4.2cm font ",10"
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-1.3:13.4]; set yrange [-2.5:2.2]
set style fill solid 0.18 border lc rgb "#0072b2"
h = sqrt(3)
set object 1 circle at 0,0 size 1 fc rgb "#0072b2"
set object 2 circle at h,1 size 1 fc rgb "#999999" fs solid 0.15 border lc rgb "#777777"
set object 3 circle at h,-1 size 1 fc rgb "#999999" fs solid 0.15 border lc rgb "#777777"
set object 4 circle at 2*h,0 size 1 fc rgb "#0072b2"
set arrow 1 from 0,0 to 2*h,0 heads filled size 0.18,18 lw 1.5 front
set label 1 "$R=2\\sqrt3$" at h,0.34 center front
set label 2 "(A)" at -1.2,1.8
set object 5 circle at 7.3,0 size 1 fc rgb "#0072b2"
set object 6 circle at 9.3,0 size 1 fc rgb "#999999" fs solid 0.15 border lc rgb "#777777"
set object 7 circle at 11.3,0 size 1 fc rgb "#0072b2"
set arrow 2 from 7.3,0 to 11.3,0 heads filled size 0.18,18 lw 1.5 front
set label 3 "$R=4$" at 9.3,0.34 center front
set label 4 "(B)" at 6.1,1.8
plot NaN
