# The contact value: rms error against the pairs at hand; above, seconds to count and fit them.
# data: build/data/speed/summary.tsv data/bench-seconds.tsv
rows(m, p, phi) = columns(sprintf("'where=method=%s;width (R) or degree=%g;phi=%s' build/data/speed/contact.tsv", m, p, phi))
pairs = "pairs nearer than 1.25 diameters"
pair = spent("task=contact;method=fit;size=100000")
set logscale xyx2
set format x "$10^{%T}$"; set format y "$10^{%T}$"; set format x2 "$10^{%T}$"
set border 7; set xtics nomirror 1e3,10,1e7; set x2tics 1e-5,10,1e3
set mxtics 1; set mx2tics 1
set xrange [7e2:1.5e8]; set x2range [7e2*pair:1.5e8*pair]; set yrange [1e-4:2]
unset key
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.84 spacing 0.035
do for [k = 1:2] {
  phi = word("0.3 0.575", k)
  set xlabel "pairs nearer than $1.25\\,\\sigma$"; set x2label "seconds" offset 0,-0.6
  if (k == 1) { set ylabel "relative error (rms)" offset 2.2,0 } else { unset ylabel; set format y "" }
  unset label
  set label (k == 1 ? "$\\phi=.30$" : "$\\phi=.575$") at 1.5e3,2.5e-4
  if (k == 1) {
    set label ink(2, "bin $.5a$") at 2e6,0.36; set label ink(5, "bin $.1a$") at 2e6,0.08
    set label ink(4, "bin $.01a$") at 1.4e8,0.0038 right
    set label ink(6, "degree 1") at 5e6,0.021; set label ink(1, "2") at 2.5e7,3.2e-4; set label ink(3, "3") at 6e7,1.2e-3
  }
  plot rows("bin", 0.5, phi) using pairs:"rms" with lines lt 2, rows("bin", 0.1, phi) using pairs:"rms" with lines lt 5, \
    rows("bin", 0.01, phi) using pairs:"rms" with lines lt 4, rows("fit", 1, phi) using pairs:"rms" with lines lt 6, \
    rows("fit", 2, phi) using pairs:"rms" with lines lt 1, rows("fit", 3, phi) using pairs:"rms" with lines lt 3, \
    rows("bin", 0.5, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 2, rows("bin", 0.1, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 5, \
    rows("bin", 0.01, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 4, rows("fit", 1, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 6, \
    rows("fit", 2, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 1, rows("fit", 3, phi) using pairs:"rms of 200 samples":"its error" with yerrorbars lt 3
}
unset multiplot
