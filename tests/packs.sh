# shellcheck shell=bash
# tests/packs.sh: sourced; packs in files, of shapes too, which check-convert.sh and slow-convert.sh convert.
. tests/tell.sh
make() { # make NAME TEXT: a pack $tmp/NAME.xyz
  printf '%s\n' "$2" > "$tmp/$1.scene" && cp "$tmp/$1.scene" "$tmp/made.scene"
  ends 0 "$randpack" run "$tmp/made.scene" --out "$tmp/made" && mv "$tmp/made/pack-0.xyz" "$tmp/$1.xyz" && rm -rf "$tmp/made"
}
tell 'shapes' make shapes 'dimension = 2; seed = 7; fraction = 0.4; save = true; make = { method = "sequential"; };
  species = ( { name = "P"; radius = 1.0; number = 20; shape = { kind = "polygon"; sides = 5; }; },
              { name = "D"; radius = 0.5; number = 20; },
              { name = "S"; radius = 0.8; number = 20; shape = { kind = "superellipse"; aspect = 1.7; m = 2.5; }; } );'
tell 'ellipses' make ellipses 'dimension = 2; seed = 8; fraction = 0.3; save = true; make = { method = "sequential"; };
  species = ( { name = "E"; radius = 1.0; number = 30; shape = { kind = "superellipse"; aspect = 2.0; m = 1.0; }; }, { name = "D"; radius = 0.5; number = 10; } );'
