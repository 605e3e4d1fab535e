# paper/unwrap.awk: what the program's help breaks into lines of 80 columns, in one line again: a line that begins with six blanks or more goes
# on with the line before; behind a bar between two words there is no blank.
NR > 1 && /^      / { sub(/^ +/, ""); line = line (line ~ /[|]$/ ? "" : " ") $0; next }
NR > 1 { print line }
{ line = $0 }
END { print line }
