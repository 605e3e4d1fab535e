# figures/tools/pack.awk: a pack in extended XYZ, for the programs that follow it with -f: of each particle x, y, z, r, and kind, 1 for the
# species that is first in the file and 2 for others; of its box the sides X, Y, Z; head, the second line; file counts the packs.
FNR == 1 { file++; particle = 0; next }
FNR == 2 {
  head = $0
  match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), side, " "); X = side[1]; Y = side[5]; Z = side[9]
  match($0, /Properties=[^ ]*/); n = split(substr($0, RSTART + 11, RLENGTH - 11), property, ":"); at = 1
  for (i = 1; i < n; i += 3) { place[property[i]] = at; at += property[i + 2] }
  if (!place["species"]) place["species"] = place["type"]
  if (!place["species"] || !place["pos"] || !place["radius"]) { print FILENAME ": no species, pos or radius" > "/dev/stderr"; exit 1 }
  next
}
{
  particle++; x = $place["pos"]; y = $(place["pos"] + 1); z = $(place["pos"] + 2); r = $place["radius"]
  if (particle == 1) first = $place["species"]
  kind = $place["species"] == first ? 1 : 2
}
