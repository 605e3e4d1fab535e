#!/bin/bash
# tests/bench.sh: the seconds of this machine into data/bench-seconds.tsv, then
# ours beside the plain references as ratios. The record names the processor,
# its caches, the compiler and the day, and nothing else of the machine.
set -eu -o pipefail
# What else runs would be measured, too; and the load of the last minute falls slowly after a build.
load() { cut -d' ' -f1 /proc/loadavg; }
busy() { awk '{ exit !($1 >= 0.5) }' /proc/loadavg; }
if busy; then
  echo "  the load is $(load): bench waits until it is below 0.5, five minutes at most"
  for ((waited = 0; waited < 300; waited += 5)); do busy || break; sleep 5; done
  ! busy || echo "bench: the load is still $(load); the seconds will be those of a busy machine" >&2
fi
field() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -1; }
BENCH_MACHINE="# processor: $(field 'model name'), family $(field 'cpu family'), model $(field model), $(nproc) cores
# caches: $(lscpu | sed -n 's/^L\([123]\)d* cache: */L\1 /p' | paste -sd, | sed 's/,/, /g')
# compiler: $(gcc --version | head -1)
# date: $(date -u +%Y-%m-%d), load before: $(load)"
export BENCH_MACHINE
trap "rm -f data/bench-seconds.tsv.part" EXIT
build/bench seconds data/bench-seconds.tsv
build/bench compare data/bench-seconds.tsv
