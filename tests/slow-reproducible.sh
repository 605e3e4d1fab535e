#!/bin/bash
# tests/slow-reproducible.sh: the program and the library are the same bytes in another folder, and under another user, locale, time
# zone, mask and order of files: by reprotest, with the variations that this machine allows, and by a build of our own.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
made='build/bin/randpack build/lib/librandpack.a build/lib/librandpack.so'
tree() { tar cf - --exclude=./build --exclude=./.git --exclude=./data/atlas . | tar xf - -C "$1"; }
mkdir "$tmp/one" "$tmp/one/tree" && tree "$tmp/one/tree"
first() { (cd "$tmp/one/tree" && make build library > "$tmp/made" 2>&1) || { tail -5 "$tmp/made"; return 1; }; }
tell 'a build' first

# In a longer path, by another user if we may, from files that were written in the opposite order, where that decides the order in
# which a folder lists them.
other=$(mktemp -d /dev/shm/randpack-XXXXXX 2> "$tmp/err") || other=$(mktemp -d "$tmp/other-XXXXXX")
trap 'rm -rf "$tmp" "$other"' EXIT
long=$other/a/much/longer/path/to/the/same/tree
mkdir -p "$long"
(cd "$tmp/one/tree" && find . -path ./build -prune -o -type f -print | sort -r) | tar cf - -C "$tmp/one/tree" -T - | tar xf - -C "$long"
[ "$(ls -U "$tmp/one/tree/src/ground")" != "$(ls -U "$long/src/ground")" ] || echo 'SKIP: files are listed in one order here, however they were written'
as=() who='the same user'
if [ "$(id -u)" = 0 ] && command -v setpriv > "$tmp/out"; then
  as=(setpriv --reuid=65534 --regid=65534 --clear-groups) who='another user'
  chmod 755 "$other" && chown -R 65534:65534 "$other"
fi
second() {
  (cd "$long" && umask 077 && "${as[@]}" env -i PATH="$PATH" HOME=/nonexistent LANG=tr_TR.UTF-8 LC_ALL=tr_TR.UTF-8 TZ=Asia/Kathmandu \
    CC="${CC:-gcc}" make build library > "$other/made" 2>&1) || { tail -5 "$other/made"; return 1; }
}
tell "a build in another folder by $who, in another locale, time zone and mask" second
for file in $made; do tell "$file is the same" cmp "$tmp/one/tree/$file" "$long/$file"; done

if command -v reprotest > "$tmp/out"; then
  vary='-all,+build_path,+environment,+exec_path,+home,+locales,+num_cpus,+timezone,+umask'
  command -v disorderfs > "$tmp/out" && [ -e /dev/fuse ] && vary=$vary,+fileordering || echo 'SKIP: no disorderfs here, so reprotest does not vary the order of files'
  command -v faketime > "$tmp/out" && vary=$vary,+time || echo 'SKIP: no faketime here, so reprotest does not vary the time'
  mkdir "$tmp/source" && tree "$tmp/source"
  rep() { reprotest --no-diffoscope --variations="$vary" -c 'make build library' "$tmp/source" "$made" > "$tmp/reprotest" 2>&1 || { tail -20 "$tmp/reprotest"; return 1; }; }
  tell "reprotest: $vary" rep
else
  echo 'SKIP: reprotest is not installed'
fi
exit $failed
