# src/includes.awk: for each entry, and for the spine, the modules whose code can change a table: the file of the entry and all that
# it includes, directly or not. Reads the plain C of all modules; the list of entries itself counts for none.
FNR == 1 { module = FILENAME; sub(/.*\//, "", module); sub(/\.[ch]$/, "", module); if (!(module in known)) { known[module] = 1; order[++modules] = module } }
/^#include "[a-z_]*\.h"/ { other = $2; gsub(/"|\.h/, "", other); direct[module] = direct[module] " " other }
match($0, /^const (Maker|Change|Measure|Curve) [a-z]+_[A-Za-z_0-9]+ =/) { entry[++entries] = $3; from[entries] = module }
function visit(m,   part, n, i) {
  if (m in seen || m == "entries" || !(m in known)) return
  seen[m] = 1
  n = split(direct[m], part, " ")
  for (i = 1; i <= n; i++) visit(part[i])
}
function tell(name,   i) {
  printf "{\"%s\", {", name
  for (i = 1; i <= modules; i++) if (order[i] in seen) printf "\"%s\", ", order[i]
  print "NULL}},"
  for (i = 1; i <= modules; i++) delete seen[order[i]]
}
END {
  visit("run"); visit("read"); tell("spine_run")
  for (e = 1; e <= entries; e++) { visit(from[e]); tell(entry[e]) }
}
