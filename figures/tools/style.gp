# figures/tools/style.gp: the look of all figures. `out`, the file, comes from figures/tools/draw.
set terminal cairolatex pdf size 12.6cm,7.4cm font ",10" fontscale 0.9 linewidth 1 dashlength 1.2
set output out
# Tables have a line of names, and columns are read by name: R, g, and g_err for its error. Rows that are picked or put together
# come from columns.awk; known is a quantity's value in a summary, known_err its error.
data(scene, file) = sprintf("build/data/%s/%s", scene, file)
columns(options) = "< awk -f figures/tools/columns.awk ".options
picked(scene, q, c) = real(system(sprintf("awk -f figures/tools/columns.awk 'get=%s' 'where=quantity=%s' %s", c, q, data(scene, "summary.tsv"))))
known(scene, q) = picked(scene, q, "value")
known_err(scene, q) = picked(scene, q, "standard_error")
low(name) = column(name) - column(name."_err")
high(name) = column(name) + column(name."_err")
# of two tables: the first's over the second's
over(name) = column(name)/column(name."_2")
over_err(name) = over(name)*sqrt((column(name."_err")/column(name))**2 + (column(name."_err_2")/column(name."_2"))**2)
rise(name) = 100*over(name) - 100
rise_err(name) = 100*over_err(name)
# and the first less the second, in standard errors
apart(name) = (column(name) - column(name."_2"))/sqrt(column(name."_err")**2 + column(name."_err_2")**2)
# The theory of one size: the column Z or g(2+) of an equation of state; all of them at the fractions of a list, in a file.
theory(list) = sprintf("build/bin/randpack theory contact --phi %s | sed 's/^# //'", list)
equation(name, phi, c) = real(system(sprintf("%s | awk -f figures/tools/columns.awk 'get=%s' 'where=equation=%s' -", theory(sprintf("%.12g", phi)), c, name)))
set encoding utf8
set datafile separator tab
set datafile columnheaders
set datafile missing "nan"
set datafile commentschars "#"
set border 3 linewidth 0.8
set tics nomirror scale 0.6
set key outside top center horizontal samplen 2 spacing 1.15
set pointsize 0.45
set bars 0.5
# Off the canvas a label is dropped, or runs into the caption.
set xlabel offset 0,0.5
set x2label offset 0,-0.4
# Okabe and Ito's colours, told apart by everyone, and in grey by their lightness.
set linetype 1 lc rgb "#0072b2" lw 1.6 pt 7
set linetype 2 lc rgb "#d55e00" lw 1.6 pt 5
set linetype 3 lc rgb "#009e73" lw 1.6 pt 9
set linetype 4 lc rgb "#cc79a7" lw 1.6 pt 13
set linetype 5 lc rgb "#e69f00" lw 1.6 pt 11
set linetype 6 lc rgb "#56b4e9" lw 1.6 pt 7
set linetype 7 lc rgb "#000000" lw 1.2 pt 4
set linetype 8 lc rgb "#777777" lw 0.8 dt 2 pt 1
set linetype 9 lc rgb "#882255" lw 1.6 pt 9
set linetype 10 lc rgb "#5e3c99" lw 1.6 pt 13
set linetype 11 lc rgb "#6b6b00" lw 1.6 pt 11
set linetype 12 lc rgb "#000000" lw 1.2 pt 5
set linetype 13 lc rgb "#8a4b08" lw 1.6 pt 11
set linetype 14 lc rgb "#000000" lw 1.2 dt 4 pt 2
set linetype 15 lc rgb "#999999" lw 2.2 pt 4
# What has a name has one colour and one symbol throughout the book, and is known in grey by its symbol or its dashes. How a pack was made
# and shaken: as grown to the letter, added at random, by gravity, jammed as isothermal growth does; and by the rules, of which Retry is B's. Symbol NAME - 1 of `pt` is the open one.
Grown = 1; Added = 10; Gravity = 9; Jammed = 11; Isothermal = 11
Retry = 2; Metropolis = 3; Chain = 4; Collision = 5; Newton = 6; Dynamics = 12; Longest = 13
# Theories and guides, black and grey: a law, Percus and Yevick's curve, Willis's, what guides the eye; what a source printed is black, too.
Law = 7; Py = 14; Willis = 15; Guide = 8; Source = 7
# Where there are no rules: the coarse and the fine, and a pair of both; discs and spheres, with open symbols if they may overlap; who computed it.
Coarse = 2; Mixed = 3; Fine = 1; Discs = 1; Spheres = 2; Ours = 1; Plain = 2
# The record of seconds: some of its rows; f times their seconds for a piece of work, and these seconds' spread; one value.
recorded(where) = columns("'where=".where."' data/bench-seconds.tsv")
each(f) = f*column("seconds")/column("work")
each_err(f) = f*column("spread")/column("work")
record(where, c) = real(system(sprintf("awk -f figures/tools/columns.awk get=%s 'where=%s' data/bench-seconds.tsv", c, where)))
spent(where) = record(where, "seconds")/record(where, "work")
# Words in the colour of a line.
ink(n, s) = "\\textcolor[HTML]{".word("0072B2 D55E00 009E73 CC79A7 B57B00 3A94C8 000000 777777 882255 5E3C99 6B6B00 000000 8A4B08 000000 777777", n)."}{".s."}"
