# paper/tex.awk, before others: text of the program as TeX. Words that stand between bars may be broken after a bar.
function tex(s,   i, c, out) {
  for (i = 1; i <= length(s); i++) {
    c = substr(s, i, 1)
    out = out (c == "\\" ? "\\textbackslash{}" : c == "^" ? "\\textasciicircum{}" : c == "~" ? "\\textasciitilde{}" : c == "\"" ? "\\textquotedbl{}" : \
      c == "'" ? "\\textquotesingle{}" : c == "|" ? "\\textbar\\allowbreak{}" : c == "<" ? "\\textless{}" : c == ">" ? "\\textgreater{}" : \
      c ~ /[{}#$%&_]/ ? "\\" c : c)
  }
  return out
}
# The same in the letters of code, broken after a point too.
function code(s) { s = tex(s); gsub(/[.]/, ".\\allowbreak{}", s); return "\\texttt{" s "}" }
