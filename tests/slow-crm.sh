#!/bin/bash
# tests/slow-crm.sh: growth over a hundred million collisions, to jamming, and against the equation of state.
failed=0
for part in pressure images accounts jamming; do
  build/slow $part || failed=1
done
exit $failed
