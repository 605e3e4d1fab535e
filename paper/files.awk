# paper/files.awk, after tex.awk: the tables and the rows of the summary in what `randpack help ENTRY` prints of all entries: \tables and \rows.
/^(make|shake|measure|theory)[.][A-Za-z0-9_-]+: / { entry = $1; sub(/:$/, "", entry); next }
/^  table / {
  open = index($0, " ("); shut = index($0, "): ")
  tables = tables code(substr($0, 9, open - 9)) " & " code(substr($0, open + 2, shut - open - 2)) "\\\\*\n\\quad by " code(entry) " & " tex(substr($0, shut + 3)) "\\\\[3pt]\n"
}
/^  row / {
  name = $0; sub(/^  row /, "", name); what = name; sub(/: .*/, "", name); sub(/^[^:]*: /, "", what)
  block[entry] = block[entry] code(name) " & " tex(what) "\\\\\n"
  if (entry != last) { order[++n] = entry; last = entry }
}
# Entries with the same rows, one after the other, have one head.
END {
  for (i = 1; i <= n; i = j) {
    head = code(order[i])
    for (j = i + 1; j <= n && block[order[j]] == block[order[i]]; j++) head = head ", " code(order[j])
    rows = rows "\\rowhead{" head "}\n" block[order[i]]
  }
  print "% printed by randpack help ENTRY; do not edit\n\\newcommand\\tablerows{" tables "}\n\\newcommand\\summaryrows{" rows "}"
}
