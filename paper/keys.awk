# paper/keys.awk, after tex.awk: the keys in what `randpack help` prints, as rows of a table: the key, what is right, its default; a line of
# its own for the head of each entry.
/^Keys of a scene/ { inside = 1; print "% printed by randpack help; do not edit"; next }
/^A scene:/ { inside = 0 }
!inside || !NF { next }
match($0, /^  (make|shake|measure|theory)[.][A-Za-z0-9_-]+: /) {
  print "\\keyhead{" code(substr($0, 3, RLENGTH - 4)) "}{" tex(substr($0, RLENGTH + 1)) "}"; next
}
{
  name = $1; text = $0; sub(/^ *[^ ]+ +/, "", text); other = ""
  if (match(text, /; required$/)) { other = "required"; text = substr(text, 1, RSTART - 1) }
  else if (match(text, /; default [^;]*$/)) { other = substr(text, RSTART + 10); text = substr(text, 1, RSTART - 1) }
  print code(name) " & " tex(text) " & " tex(other) "\\\\"
}
