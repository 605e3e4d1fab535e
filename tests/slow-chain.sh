#!/bin/bash
# tests/slow-chain.sh: ten million lifts without an overlap, and the pressure that they tell.
exec build/slow chains
