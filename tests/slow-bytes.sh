#!/bin/bash
# tests/slow-bytes.sh: the same bytes on any number of threads and any processor, for every scene of
# figures/ that `make paper` runs, with the few packs of a draft: as the machine does it, on two threads of an old
# processor, and by the width between. check-bytes.sh has all that may differ, of fewer particles.
. tests/bytes.sh
case " ${variants[*]} " in
  *' avx512f '*) variants=(one old avx2) ;;
  *) variants=(one old) ;;
esac
for file in figures/*/*.scene; do
  name=${file##*/}
  grep -q '^# atlas' "$file" && continue
  # shellcheck disable=SC2046
  tell "the same bytes of ${name%.scene} with ${variants[*]}" same_bytes "$file" "${name%.scene}" $(paper/few "$file" 2)
  rm -rf "$tmp"/*/"${name%.scene}"
done
exit $failed
