#!/bin/bash
# tests/slow-convert.sh: packs in other formats, opened by the programs that they are for, as far as these are installed; what
# they find there is the pack's fraction, and comes nearer to it as voxels and elements become smaller.
. tests/packs.sh
python=
for p in /usr/bin/python3 python3; do "$p" -c 'import sys' 2> "$tmp/err" && python=$p && break; done
has() { # has MODULE WORDS: is this module of Python there? Else a line that says what is not tested.
  [ -n "$python" ] && "$python" -c "import $1" 2> "$tmp/err" || { echo "SKIP: no $1 for Python, so $2"; return 1; }
}
found() { command -v "$1" > "$tmp/which" || { echo "SKIP: no $1, so $2"; return 1; }; }
convert() { ends 0 "$randpack" convert "$@"; }
tell 'spheres' make deep 'dimension = 3; seed = 12; fraction = 0.5; gap = 0.1; make = { method = "crm"; growth = 0.1; }; save = true;
  species = ( { name = "AP"; radius = 1.0; number = 20; }, { name = "Al"; radius = 0.7; number = 20; } );'
tell 'discs' make flat 'dimension = 2; seed = 4; fraction = 0.5; gap = 0.1; make = { method = "crm"; growth = 0.1; }; save = true;
  species = ( { name = "AP"; radius = 1.0; number = 30; }, { name = "Al"; radius = 0.5; number = 30; } );'

# --- ASE
asked() {
  convert "$tmp/deep.xyz" "$tmp/again.xyz" && "$python" - "$tmp/again.xyz" <<'END'
import sys
from math import pi
from ase.io import read
atoms = read(sys.argv[1], format='extxyz')
assert len(atoms) == 40 and all(atoms.pbc) and set(atoms.arrays['type']) == {'AP', 'Al'}
fraction = sum(4 * pi / 3 * r ** 3 for r in atoms.arrays['radius']) / atoms.get_volume()
assert abs(fraction - 0.5) < 1e-12, fraction
END
}
has ase 'it opened no extended XYZ' && tell 'ASE opens extended XYZ' asked

# --- VTK
vtu() {
  convert "$tmp/deep.xyz" "$tmp/deep.vtu" && convert "$tmp/shapes.xyz" "$tmp/shapes.vtu" && "$python" - "$tmp" <<'END'
import sys
from math import pi
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
def grid(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(sys.argv[1] + '/' + name)
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()
def names(g):
    array = g.GetFieldData().GetAbstractArray('species')
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
g = grid('deep.vtu')
radius, box, points = g.GetPointData().GetArray('radius'), g.GetFieldData().GetArray('box'), g.GetNumberOfPoints()
assert points == g.GetNumberOfCells() == 40 and names(g) == ['AP', 'Al']
volume = box.GetValue(3) * box.GetValue(4) * box.GetValue(5)
assert abs(sum(4 * pi / 3 * radius.GetValue(i) ** 3 for i in range(points)) / volume - 0.5) < 1e-12
label = g.GetPointData().GetArray('species')
assert all((label.GetValue(i) == 1) == (radius.GetValue(i) > 0.9) for i in range(points))
g = grid('shapes.vtu')
radius, box = g.GetCellData().GetArray('radius'), g.GetFieldData().GetArray('box')
assert g.GetNumberOfCells() == 60 and names(g) == ['D', 'P', 'S']
def area(cell):
    p = [cell.GetPoints().GetPoint(k) for k in range(cell.GetNumberOfPoints())]
    assert cell.GetClassName() == 'vtkPolygon' and all(v[2] == 0 for v in p)
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1])) / 2
cells = sum(area(g.GetCell(i)) for i in range(60)) / (box.GetValue(3) * box.GetValue(4))
exact = sum(pi * radius.GetValue(i) ** 2 for i in range(60)) / (box.GetValue(3) * box.GetValue(4))
assert abs(exact - 0.4) < 1e-12 and 0 < exact - cells < 0.003 * exact, (exact, cells)
END
}
vti() {
  for n in 16 64 200; do convert "$tmp/deep.xyz" "$tmp/v$n.vti" --cells $n || return 1; done
  convert "$tmp/shapes.xyz" "$tmp/s.vti" --cells 400 && "$python" - "$tmp" <<'END'
import sys
from math import pi, sqrt
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy
def image(name):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(sys.argv[1] + '/' + name)
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()
rows = [line.split() for line in open(sys.argv[1] + '/deep.xyz')][2:]
for n in 16, 64, 200:
    g = image('v%d.vti' % n)
    phase = vtk_to_numpy(g.GetCellData().GetArray('phase'))
    side, h = g.GetBounds()[1], g.GetSpacing()[0]
    assert g.GetNumberOfCells() == n ** 3 and abs(side / n - h) < 1e-12
    for label, name in (1, 'AP'), (2, 'Al'):
        surface = sum(4 * pi * float(row[4]) ** 2 for row in rows if row[0] == name)
        solid = sum(4 * pi / 3 * float(row[4]) ** 3 for row in rows if row[0] == name)
        error = sqrt(0.06665 * surface) * h * h
        off = (phase == label).sum() * h ** 3 - solid
        print(n, name, off / side ** 3, off / error)
        assert abs(off) < 3.5 * error
g = image('s.vti')
phase = vtk_to_numpy(g.GetCellData().GetArray('phase'))
assert g.GetDataDimension() == 2 and abs((phase > 0).mean() - 0.4) < 1e-3
END
}
if has vtkmodules 'it opened no VTU and no VTI'; then
  tell 'VTK opens VTU: points, polygons and their fractions' vtu
  tell 'VTK opens VTI: voxels within their error, at any number' vti
fi

# --- NRRD, by its definition
nrrd() {
  convert "$tmp/deep.xyz" "$tmp/n.nrrd" --cells 60 && convert "$tmp/deep.xyz" "$tmp/r.raw" --cells 60 && "$python" - "$tmp/n.nrrd" "$tmp/r.nhdr" <<'END'
import os, sys
import numpy
def read(path):
    with open(path, 'rb') as file:
        assert file.readline().strip() in (b'NRRD0001', b'NRRD0002', b'NRRD0003', b'NRRD0004', b'NRRD0005')
        fields, keys = {}, {}
        while (line := file.readline().decode()).strip():
            if line.startswith('#'):
                continue
            if ':=' in line:
                key, value = line.rstrip('\n').split(':=', 1)
                assert key not in keys
                keys[key] = value
            else:
                key, value = line.rstrip('\n').split(': ', 1)
                assert key not in fields
                # per-axis fields after the dimension, orientation after that of space
                assert 'dimension' in fields or key in ('type', 'dimension')
                assert 'space dimension' in fields or key not in ('space directions', 'space origin')
                fields[key] = value
        if 'data file' in fields:
            file = open(os.path.join(os.path.dirname(path), fields['data file']), 'rb')
        sizes = [int(n) for n in fields['sizes'].split()]
        assert fields['encoding'] == 'raw' and len(sizes) == int(fields['dimension'])
        kind = {'uint8': 'u1', 'uint16': {'little': '<u2', 'big': '>u2'}[fields['endian']]}[fields['type']]
        data = numpy.frombuffer(file.read(), kind)
        assert data.size == numpy.prod(sizes)
        directions = [[float(x) for x in v.strip('()').split(',')] for v in fields['space directions'].split(' ')]
        assert len(directions) == len(sizes) and all(len(v) == int(fields['space dimension']) for v in directions)
        assert len(fields['centers'].split()) == len(sizes) and set(fields['centers'].split()) <= {'cell', 'node'}
        return data.reshape(sizes[::-1]), directions, keys
one, directions, keys = read(sys.argv[1])
two = read(sys.argv[2])[0]
assert (one == two).all() and keys == {'label 0': 'matrix', 'label 1': 'AP', 'label 2': 'Al'}
assert abs((one > 0).mean() - 0.5) < 0.002, (one > 0).mean()
# the first axis is x: the voxel around the place of the first particle has its label
row = open(os.path.dirname(sys.argv[1]) + '/deep.xyz').read().split('\n')[2].split()
at = [int(float(row[k + 1]) / directions[k][k]) for k in range(3)]
assert one[at[2], at[1], at[0]] == {'AP': 1, 'Al': 2}[row[0]]
END
}
has numpy 'no NRRD was read' && tell 'NRRD, attached and detached, by its definition' nrrd

# --- LAMMPS
lammps() { # lammps FILE STYLE DIMENSION: atoms and the sum of d^dimension, by its own computes
  cat > "$tmp/in.lmp" <<END
units lj
atom_style $2
dimension $3
boundary p p p
comm_modify mode single cutoff 3.0 vel yes
read_data $1
compute r all property/atom $4
variable v atom $5
compute s all reduce sum v_v
thermo_style custom step atoms c_s vol lx ly lz
thermo_modify norm no format float %.15g
run 0
END
  (cd "$tmp" && lmp -in in.lmp -log none) > "$tmp/lmp" 2>&1 || { tail -5 "$tmp/lmp"; return 1; }
  awk '/^ *Step/ { getline; print $2, $3, $4; exit }' "$tmp/lmp"
}
spheres() {
  convert "$tmp/deep.xyz" "$tmp/deep.data" && read -r n sum volume <<< "$(lammps deep.data sphere 3 diameter 'c_r^3')" && [ "$n" = 40 ] &&
    awk -v s="$sum" -v v="$volume" 'BEGIN { f = 3.14159265358979 / 6 * s / v; print f; exit !((f - 0.5) ^ 2 < 1e-20) }' > "$tmp/told" || { cat "$tmp/told"; return 1; }
}
discs() {
  convert "$tmp/flat.xyz" "$tmp/flat.data" && lammps flat.data sphere 2 diameter 'c_r^2' > "$tmp/told" && awk '/^ *Step/ { getline; f = 3.14159265358979 / 4 * $3 / ($5 * $6); exit !($2 == 60 && (f - 0.5) ^ 2 < 1e-20) }' "$tmp/lmp" || { cat "$tmp/told"; return 1; }
}
ellipses() {
  convert "$tmp/ellipses.xyz" "$tmp/ellipses.data" && lammps ellipses.data ellipsoid 2 'shapex shapey' 'c_r[1]*c_r[2]' > "$tmp/told" && awk '/^ *Step/ { getline; f = 3.14159265358979 / 4 * $3 / ($5 * $6); print f; exit !($2 == 40 && (f - 0.3) ^ 2 < 1e-20) }' "$tmp/lmp" || { cat "$tmp/told" "$tmp/lmp"; return 1; }
}
if found lmp 'LAMMPS read no data'; then
  tell 'LAMMPS reads spheres: number, volume and box' spheres
  tell 'and discs' discs
  tell 'and ellipses' ellipses
fi

# --- Gmsh
mesh() { # mesh NAME DIMENSION H: the volumes of the groups, from a mesh of this size, and of how many nodes are periodic
  gmsh "-$2" "$tmp/$1.geo" -setnumber h "$3" -format msh22 -o "$tmp/$1.msh" -v 2 > "$tmp/gmsh" 2>&1 && ! grep -q Error "$tmp/gmsh" || { grep -v Progress "$tmp/gmsh" | head -5 >&2; return 1; }
  awk -v dim="$2" '/^\$PhysicalNames/ { getline n; for (k = 0; k < n; k++) { getline; name[$1, $2] = $3 } }
    /^\$Nodes/ { getline n; for (k = 0; k < n; k++) { getline; x[$1] = $2; y[$1] = $3; z[$1] = $4 } }
    /^\$Elements/ { getline n; for (k = 0; k < n; k++) { getline; a = $6; b = $7; c = $8; d = $9
      ux = x[b] - x[a]; uy = y[b] - y[a]; uz = z[b] - z[a]; vx = x[c] - x[a]; vy = y[c] - y[a]; vz = z[c] - z[a]; wx = x[d] - x[a]; wy = y[d] - y[a]; wz = z[d] - z[a]
      if (dim == 3 && $2 == 4) v = (ux * (vy * wz - vz * wy) - uy * (vx * wz - vz * wx) + uz * (vx * wy - vy * wx)) / 6
      else if (dim == 2 && $2 == 2) v = (ux * vy - uy * vx) / 2
      else continue
      sum[name[dim, $4]] += v < 0 ? -v : v } }
    /^\$Periodic/ { getline; getline # of each pair of nodes, the one is the other, moved
      while ($0 !~ /^\$EndPeriodic/) { if (/^Affine/) { t[1] = $5; t[2] = $9; t[3] = $13; getline n; for (k = 0; k < n; k++) { getline; pairs++
          off = (x[$1] - x[$2] - t[1]) ^ 2 + (y[$1] - y[$2] - t[2]) ^ 2 + (z[$1] - z[$2] - t[3]) ^ 2; if (off > 1e-16) wrong++ } } if ((getline) <= 0) break } }
    END { for (s in sum) printf "%s %.15g\n", s, sum[s]; print "pairs", pairs + 0; print "wrong", wrong + 0 }' "$tmp/$1.msh"
}
converges() { # converges NAME DIMENSION H: with elements half as large, a fourth of what the volume lacks
  local h=$3 s
  convert "$tmp/$1.xyz" "$tmp/$1.geo" || return 1
  for s in 1 2; do mesh "$1" "$2" "$(awk -v h="$h" -v s=$s 'BEGIN { print h / s }')" > "$tmp/volumes$s" || return 1; done
  awk -v dim="$2" -F'[{},]' '/^(Sphere|Disk)/ { next } /^Box/ { printf "box %.15g\n", $5 * $6 * $7 } /^Rectangle/ { printf "box %.15g\n", $5 * $6 }' "$tmp/$1.geo" > "$tmp/box"
  awk -v dim="$2" -v h="$h" 'FILENAME ~ /xyz$/ { if (FNR > 2) solid["\"" $1 "\""] += dim == 3 ? 4 * 3.14159265358979 / 3 * $5 ^ 3 : 3.14159265358979 * $5 ^ 2; next }
    $1 == "box" { box = $2; next } FILENAME ~ /1$/ { coarse[$1] = $2 } FILENAME ~ /2$/ { fine[$1] = $2 }
    END { for (s in solid) { all[1] += coarse[s]; all[2] += fine[s]; a = 1 - coarse[s] / solid[s]; b = 1 - fine[s] / solid[s]; n++
        printf "%s lacks %.5f with elements of %s, and %.5f with half, ratio %.2f\n", s, a, h, b, a / b; bad += !(b > 0 && a < 0.12 && a / b > 3 && a / b < 5.2) }
      for (k = 1; k <= 2; k++) { m = k == 1 ? coarse["\"matrix\""] : fine["\"matrix\""]; bad += ((all[k] + m) / box - 1) ^ 2 > 1e-18 } print "pairs", coarse["pairs"], fine["pairs"]
      bad += !(coarse["pairs"] > 20 && fine["pairs"] > coarse["pairs"] && coarse["wrong"] + fine["wrong"] == 0); exit bad || n < 2 }' "$tmp/$1.xyz" "$tmp/box" "$tmp/volumes1" "$tmp/volumes2" > "$tmp/told"
  local status=$?
  sed "s/^/  /" "$tmp/told"
  return $status
}
periodic() { # periodic NAME DIMENSION: each node on a side of the last mesh has its image on the other, and all of them are matched
  awk -v dim="$2" 'FILENAME ~ /geo$/ { if (/^(Box|Rectangle)/) { split($0, w, /[{},]/); L[1] = w[5]; L[2] = w[6]; L[3] = w[7] } next }
    /^\$Nodes/ { getline n; for (k = 0; k < n; k++) { getline; for (a = 1; a <= dim; a++) p[k, a] = $(a + 1) } }
    END { for (a = 1; a <= dim; a++) for (side = 0; side < 2; side++) for (k = 0; k < n; k++) { d = p[k, a] - side * L[a]; if (d * d > 1e-16) continue
        key = ""; for (b = 1; b <= dim; b++) if (b != a) key = key sprintf(" %.5f", p[k, b] + 1e-7); if (!side) low[a, key] = 1; else if ((a, key) in low) both++; else alone++
        if (!side) lows++ } print both, lows, alone + 0; exit !(both == lows && !alone && lows > 20) }' "$tmp/$1.geo" "$tmp/$1.msh"
}
if found gmsh 'no geometry was meshed'; then
  tell 'Gmsh meshes spheres of two sizes, and volumes converge' converges deep 3 0.4
  tell 'and its nodes match on opposite sides' periodic deep 3
  folded() { # a cap that another algorithm folds
    sed 's/seed = 12/seed = 3/' "$tmp/deep.scene" > "$tmp/made.scene" && ends 0 "$randpack" run "$tmp/made.scene" --out "$tmp/made" && mv "$tmp/made/pack-0.xyz" "$tmp/cap.xyz" &&
      convert "$tmp/cap.xyz" "$tmp/cap.geo" && mesh cap 3 0.2 > "$tmp/volumes" && periodic cap 3
  }
  tell 'and another pack of them' folded
  tell 'Gmsh meshes discs' converges flat 2 0.25
  tell 'whose nodes match' periodic flat 2
  outlines() { # pentagons exactly
    convert "$tmp/shapes.xyz" "$tmp/shapes.geo" --gap 0.02 && mesh shapes 2 0.2 > "$tmp/volumes" && awk '/made smaller/ { print $8, $NF }' "$tmp/shapes.geo" > "$tmp/told"
    awk -F'[{},]' '/^Rectangle/ { printf "%.15g\n", $5 * $6 }' "$tmp/shapes.geo" > "$tmp/area"
    awk -v area="$(cat "$tmp/area")" -v want="$(awk '{ print $2 }' "$tmp/told")" '/^"/ { all += $2; if ($1 != "\"matrix\"") solid += $2; n++ } END { print solid / area, want, all / area; exit !((all / area - 1) ^ 2 < 1e-18 && solid / area < want && solid / area > want * 0.985 && n == 4) }' "$tmp/volumes" || return 1
  }
  tell 'and shapes' outlines
fi

# --- POV-Ray
render() { povray "+I$tmp/$1.pov" "+O$tmp/$1.ppm" +FP "+W$2" "+H$3" -D -A -GA > "$tmp/pov" 2>&1 || { tail -5 "$tmp/pov"; return 1; }; }
cat > "$tmp/picture.py" <<'END'
def picture(path):
    """Width, height and the pixels, row by row, of a PPM."""
    data = open(path, 'rb').read()
    words, at = [], 0
    while len(words) < 4:
        end = data.index(b'\n', at)
        words += data[at:end].split(b'#')[0].split()
        at = end + 1
    width, height, deep = int(words[1]), int(words[2]), 2 if int(words[3]) > 255 else 1
    assert words[0] == b'P6' and len(data) == at + 3 * deep * width * height
    return width, height, [tuple(data[at + deep * (3 * k + j)] for j in range(3)) for k in range(width * height)]
END
shares() { # the colours of the picture in the plane are the phases
  convert "$tmp/$1.xyz" "$tmp/$1.pov" && render "$1" 400 400 && PYTHONPATH=$tmp "$python" - "$tmp/$1.ppm" "$2" <<'END'
import sys
from picture import picture
width, height, pixels = picture(sys.argv[1])
count = {}
for colour in pixels:
    count[colour] = count.get(colour, 0) + 1
white = max(count, key=lambda c: min(c))
inside = {c: n for c, n in count.items() if c != white}
ground = max((c for c in inside if c[0] == c[1] == c[2]), key=lambda c: inside[c])
solid = sum(n for c, n in inside.items() if c != ground)
fraction = solid / (solid + inside[ground])
print(fraction, len(count))
assert abs(fraction - float(sys.argv[2])) < 0.006 and 3 <= len(count) <= 8, count
END
}
handed() { # two spheres, the first at larger x: it is to the right; one above is above
  printf '3\nLattice="10 0 0 0 10 0 0 0 10" Properties=type:S:1:pos:R:3:radius:R:1\nA 8 2 2 1\nB 2 2 2 1\nC 5 2 8 1\n' > "$tmp/h.xyz"
  convert "$tmp/h.xyz" "$tmp/h.pov" && render h 160 120 && PYTHONPATH=$tmp "$python" - "$tmp/h.ppm" <<'END'
import sys
from picture import picture
width, height, pixels = picture(sys.argv[1])
place = {'A': [], 'B': [], 'C': []}
for k in range(width * height):
    r, g, b = pixels[k]
    name = 'A' if r > g + 30 > b + 60 else 'B' if b > r + 60 else 'C' if g > r + 60 and g > b + 15 else None
    if name:
        place[name].append((k % width, k // width))
middle = {n: [sum(p[j] for p in v) / len(v) for j in range(2)] for n, v in place.items() if v}
print(middle)
assert len(middle) == 3 and middle['A'][0] > middle['C'][0] > middle['B'][0] and middle['C'][1] < min(middle['A'][1], middle['B'][1]) - 10
END
}
full() { # the pack fills a good part of the picture, with many colours
  convert "$tmp/deep.xyz" "$tmp/deep.pov" && render deep 160 120 && PYTHONPATH=$tmp "$python" - "$tmp/deep.ppm" <<'END'
import sys
from picture import picture
width, height, pixels = picture(sys.argv[1])
drawn = sum(min(p) < 250 for p in pixels) / len(pixels)
print(drawn, len(set(pixels)))
assert 0.15 < drawn < 0.9 and len(set(pixels)) > 500
edge = [pixels[k] for k in range(width * height) if k % width in (0, width - 1) or k // width in (0, height - 1)]
assert all(min(p) > 250 for p in edge)
END
}
if found povray 'no picture was drawn' && has sys 'no picture was looked at'; then
  tell 'POV-Ray draws discs, with their share of the pixels' shares flat 0.5
  tell 'and shapes' shares shapes 0.4
  tell 'and a pack in space, whole and not empty' full
  tell 'not in a mirror' handed
fi
exit $failed
