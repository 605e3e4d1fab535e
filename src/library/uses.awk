# src/library/uses.awk: the modules of the library: those that the chapter library includes, directly or not. Reads the chapters; what
# an entry includes, in the last section of a chapter, is of the scenes and does not count.
FNR == 1 { module = FILENAME; gsub(/.*\/|\.nw$/, "", module); entry = 0 }
/^<<.*>>=$/ { entry = entry || /_entry\.c\]\]>>=$/; if (/^<<\[\[[a-z_]*\.[ch]\]\]>>=$/) entry = /_entry/ }
!entry && /^#include "[a-z_]*\.h"/ { other = $2; gsub(/"|\.h/, "", other); uses[module] = uses[module] " " other }
function visit(m,   part, n, i) {
  if (m in seen) return
  seen[m] = 1
  n = split(uses[m], part, " ")
  for (i = 1; i <= n; i++) visit(part[i])
  print m
}
END { visit("library") }
