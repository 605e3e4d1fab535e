#!/bin/bash
# tests/slow-dist.sh: what make dist leaves builds, passes its tests and installs where there is no git and nothing of this tree.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
version=$("$randpack" --version) version=${version#randpack }
dist() { make -s dist > "$tmp/made" 2>&1 && tar xf "build/randpack-$version.tar.gz" -C "$tmp"; }
tell 'make dist' dist
# A git that fails stands before any other.
mkdir "$tmp/no" && printf '#!/bin/sh\nexit 127\n' > "$tmp/no/git" && chmod +x "$tmp/no/git"
export PATH=$tmp/no:$PATH
unset RANDPACK
cd "$tmp/randpack-$version" || exit 1
makes() { make "$@" > "$tmp/made" 2>&1 || { grep -B20 '^FAIL\|Error' "$tmp/made" | tail -40; return 1; }; }
tell 'it builds' makes build
tell 'its tests pass' makes check
tell 'as many as here' test "$(sed -n 's/ passed, 0 failed$//p' "$tmp/made")" -gt 1000
tell 'it installs' makes install DESTDIR="$tmp/dest"
exit $failed
