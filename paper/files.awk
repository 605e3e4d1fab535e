# paper/files.awk, after tex.awk: the tables and the rows of the summary in what `randpack help ENTRY` prints of all entries: \tables and \rows.
/^(make|shake|measure|theory)[.][A-Za-z0-9_-]+: / { entry = $1; sub(/:$/, "", entry); next }
/^  table / {
  open = index($0, " ("); shut = index($0, "): ")
  tables = tables "\\tablehead{" code(substr($0, 9, open - 9)) "}{" code(entry) "}" code(substr($0, open + 2, shut - open - 2)) "\\\\*\n & " tex(substr($0, shut + 3)) "\\\\\n"
}
/^  row / {
  name = $0; sub(/^  row /, "", name); what = name; sub(/: .*/, "", name); sub(/^[^:]*: /, "", what)
  rows = rows (entry != last ? "\\keyhead{" code(entry) "}{}\n" : "") code(name) " & " tex(what) "\\\\\n"; last = entry
}
END { print "% printed by randpack help ENTRY; do not edit\n\\newcommand\\tablerows{" tables "}\n\\newcommand\\summaryrows{" rows "}" }
