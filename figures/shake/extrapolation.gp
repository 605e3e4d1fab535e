# B (17): g at .55 and .60 from g at .575, scaled by the excess at contact that Willis or Percus and Yevick give.
# data: first-peak
set terminal cairolatex pdf size 12.6cm,13.2cm font ",10"
set output out
file(r, c) = data("first-peak", sprintf("shaken.rdf@%s@%g.tsv", r, c))
c1 = 0.575
willis(c) = 0.8006*(8*c - 1)/c
py(c) = (2 + c)/(2*(1 - c)**2) - 1
mean(r, c, q) = known("first-peak", sprintf("%s@%s@%g", q, r, c))
slip(r, c, q) = known_err("first-peak", sprintf("%s@%s@%g", q, r, c))
# measured, and at c1; from that, scaled by f, g and what is measured less it, in standard errors
pair(r, c) = columns(file(r, c)." ".file(r, c1))
scaled(f) = 1 + f*(column("g_2") - 1)
miss(f) = (column("g") - scaled(f))/sqrt(column("g_err")**2 + (f*column("g_err_2"))**2)
ratio(r, c) = (mean(r, c, q) - 1)/(mean(r, c1, q) - 1)
off(r, c) = ratio(r, c)*sqrt((slip(r, c, q)/(mean(r, c, q) - 1))**2 + (slip(r, c1, q)/(mean(r, c1, q) - 1))**2)
says(x) = x < 1 ? sprintf("%.3f", x)[2:] : sprintf("%.3f", x)
found(r, c) = sprintf("$%s\\pm%s$", says(ratio(r, c)), says(off(r, c)))
q = "shaken.contact"
unset key
set xrange [2:4.5]; set xtics 0.5; set mxtics 1
set multiplot
do for [j = 1:2] {
  c = real(word("0.55 0.6", j))
  fw = willis(c)/willis(c1); fp = py(c)/py(c1)
  set lmargin screen (j == 1 ? 0.115 : 0.58); set rmargin screen (j == 1 ? 0.52 : 0.985)
  unset label
  set tmargin screen 0.99; set bmargin screen 0.535
  set format x ""; unset xlabel; set logscale y; set yrange [0.4:24]
  set ytics (0.5, 1, 2, 5, 10, 20)
  if (j == 1) { set label 9 "$g(R)$ after retry" at screen 0.022,graph 0.5 center rotate; set format y "%g" } else { set format y "" }
  set label 1 sprintf("$c_1=.575$, $c_2=%s$", word(".55 .60", j)) at graph 0.98,0.94 right
  set label 2 "$g_c(c_2)/g_c(c_1)$:" at graph 0.98,0.85 right
  set label 3 ink(Willis, "Willis $".says(fw)."$") at graph 0.98,0.77 right
  set label 4 ink(Py, "Percus--Yevick $".says(fp)."$") at graph 0.98,0.69 right
  set label 5 ink(Retry, "measured ".found("retry", c)) at graph 0.98,0.61 right
  plot pair("retry", c) using "R":(scaled(fw)) with lines lt Willis, pair("retry", c) using "R":(scaled(fp)) with lines lt Py, \
    pair("retry", c) using "R":"g" with points lt Retry ps 0.22
  unset label; unset logscale y
  set yrange [-48:48]; set ytics 20
  do for [i = 1:2] {
    rule = word("retry metropolis", i)
    set tmargin screen (i == 1 ? 0.51 : 0.29); set bmargin screen (i == 1 ? 0.315 : 0.095)
    if (i == 2) { set format x "%g"; set xlabel "$R=r/a$" offset 0,0.5 }
    if (j == 1) { set format y "$%g$" } else { set format y "" }
    if (i == 1 && j == 1) { set label 9 "measured $-$ (17), in standard errors" at screen 0.022,first -50 center rotate }
    set label 1 ink(i == 1 ? Retry : Metropolis, i == 1 ? "retry" : "Metropolis") at graph 0.98,0.87 right
    if (i == 2) { set label 2 ink(Metropolis, "measured ".found(rule, c)) at graph 0.98,0.11 right }
    plot 0 with lines lt Guide lw 0.5 dt 1, pair(rule, c) using "R":(miss(fw)) with lines lt Willis, \
      pair(rule, c) using "R":(miss(fp)) with lines lt Py
    unset label
  }
}
unset multiplot
