# figures/tools/inside.awk: has each element a point inside its axes? Of the tables that gnuplot makes of the plots of a figure, in which a
# point ends in i (inside), o (outside) or u (undefined). The first element of a plot begins a panel.
function close_element() {
  if (panel && !inside) { printf "%s: panel %d, element %d has no point inside its axes: %s\n", figure, panel, element, title; bad = 1 }
}
/^# Curve [0-9]+ of/ { close_element(); element = $3 + 1; panel += element == 1; inside = 0; title = "" }
/^# Curve title: / { title = substr($0, 16) }
/ i$/ { inside++ }
END {
  close_element()
  if (!panel) { print figure ": plots nothing"; bad = 1 }
  exit bad
}
