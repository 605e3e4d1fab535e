#!/bin/bash
# examples/centres.sh PROGRAM DIR: make the pack of examples/beads.scene in DIR, and print what a tomograph would have told of a cube
# of 7 mm in its middle: places and diameters, to a thousandth of a millimetre. It is how examples/centres.txt was made.
set -eu -o pipefail
"$1" run examples/beads.scene --out "$2"
awk 'NR == 1 { print "x y z diameter" }
  NR == 2 { match($0, /"[0-9.]+/); middle = substr($0, RSTART + 1, RLENGTH - 1) / 2 }
  function inside(x) { return x > middle - 3.5 && x < middle + 3.5 }
  NR > 2 && inside($2) && inside($3) && inside($4) {
    printf "%.3f %.3f %.3f %.3f\n", $2 - middle + 3.5, $3 - middle + 3.5, $4 - middle + 3.5, 2 * $5
  }' "$2/pack-0.xyz"
