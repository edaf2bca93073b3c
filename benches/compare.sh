#!/bin/sh
# Measures homeo beside its peers in one run, prints the table of ratios and writes benches/RESULTS.md.
# Usage: benches/compare.sh [ROUNDS]
set -eu
cd "$(dirname -- "$0")/.."
cargo build --quiet --release -p homeo-benches --bins
exec cargo run --quiet --release -p homeo-benches --bin homeo-compare -- "$@"
