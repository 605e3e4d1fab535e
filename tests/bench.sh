#!/bin/bash
# tests/bench.sh: the seconds of this machine into data/bench-seconds.tsv, then
# ours beside the plain references as ratios. The record names the processor,
# its caches, the compiler and the day, and nothing else of the machine.
set -eu -o pipefail
field() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -1; }
BENCH_MACHINE="# processor: $(field 'model name'), family $(field 'cpu family'), model $(field model), $(nproc) cores
# caches: $(lscpu | sed -n 's/^L\([123]\)d* cache: */L\1 /p' | paste -sd, | sed 's/,/, /g')
# compiler: $(gcc --version | head -1)
# date: $(date -u +%Y-%m-%d), load before: $(cut -d' ' -f1 /proc/loadavg)"
export BENCH_MACHINE
trap "rm -f data/bench-seconds.tsv.part" EXIT
build/bench seconds data/bench-seconds.tsv
build/bench compare data/bench-seconds.tsv
