# from: field-exact/summary.tsv field-pixels/sweep.tsv
# field-error.awk: how far zeta2 and eta2 of the field are from those of multipoles, of the same packs, over the pixels to a radius: zeta_off@PIXELS,
# eta_off@PIXELS, and the error that is told, told@PIXELS, all relative.
BEGIN { FS = "\t"; print "# written by field-error.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { head = 0; exact = FILENAME ~ /exact/ }
/^#/ { next }
exact { value[$1] = $2; next }
!head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{
  key = $at["measure.bounds.pixels"]
  off("zeta", $at["zeta2"] / value["zeta2"] - 1); off("eta", $at["eta2"] / value["eta2"] - 1)
  printf "told@%s\t%.12g\t0\n", key, $at["bounds_error"]
}
function off(what, x) { printf "%s_off@%s\t%.12g\t0\n", what, key, x < 0 ? -x : x }
