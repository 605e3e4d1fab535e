#!/bin/bash
# zeta2 and eta2 of packs, a table in two columns: the plane, and space.
# data: zeta-square zeta-triangular zeta-discs-fluid zeta-discs-rsa zeta-discs-grown zeta-discs-two zeta-gravity-discs zeta-gravity-discs-diluted zeta-cubic zeta-bcc zeta-fcc zeta-spheres-fluid zeta-spheres-rsa zeta-spheres-grown zeta-spheres-two zeta-gravity zeta-gravity-diluted
set -eu -o pipefail
half() { echo '\begin{tabular}[t]{lccc}\toprule'; echo "pack & \$\\phi\$ & \$\\zeta_2\$ & \$\\eta_2\$\\\\"; awk -f figures/bounds/zeta-rows.awk "$@"; echo '\bottomrule\end{tabular}'; }
at() { echo "build/data/zeta-$1/summary.tsv"; }
echo '{\footnotesize\setlength\tabcolsep{3pt}'
half name='squares' "$(at square)" name='triangles' "$(at triangular)" name='equilibrium' "$(at discs-fluid)" name='random addition' "$(at discs-rsa)" \
  name='fast growth' only=made. pick=0.3 "$(at discs-grown)" name='and shaken' only=shaken. pick=0.3 "$(at discs-grown)" \
  name='slow growth' only=made. pick=0.01 "$(at discs-grown)" name='and shaken' only=shaken. pick=0.01 "$(at discs-grown)" \
  name='two sizes' only= pick= "$(at discs-two)" name='gravity' "$(at gravity-discs)" name='and diluted' "$(at gravity-discs-diluted)"
echo '\hfill'
half name='simple cubic' "$(at cubic)" name='bcc' "$(at bcc)" name='fcc' "$(at fcc)" name='equilibrium' "$(at spheres-fluid)" name='random addition' "$(at spheres-rsa)" \
  name='fast growth' only=made. pick=0.1 "$(at spheres-grown)" name='and shaken' only=shaken. pick=0.1 "$(at spheres-grown)" \
  name='slow growth' only=made. pick=0.01 "$(at spheres-grown)" name='and shaken' only=shaken. pick=0.01 "$(at spheres-grown)" \
  name='two sizes' only= pick= "$(at spheres-two)" name='gravity' "$(at gravity)" name='and diluted' "$(at gravity-diluted)"
echo '}'
