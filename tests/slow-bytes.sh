#!/bin/bash
# tests/slow-bytes.sh: the same bytes on any number of threads and any processor, for every scene of
# figures/ as it stands.
. tests/bytes.sh
for file in figures/*/*.scene; do
  name=${file##*/}
  tell "the same bytes of ${name%.scene} with ${variants[*]}" same_bytes "$file" "${name%.scene}"
  rm -rf "$tmp"/*/"${name%.scene}"
done
exit $failed
