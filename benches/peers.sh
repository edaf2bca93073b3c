#!/bin/sh
# Measures homeo beside its peers in one run; options as of homeo-peers (--help). Builds everything first, with rational numbers
# in C where their tools are at hand.
set -eu
cd "$(dirname -- "$0")/.."
features=num-rational,malachite
command -v m4 >/dev/null && command -v make >/dev/null && command -v cc >/dev/null && features="$features,rug"
# homeo-profile and homeo-check are what growth and a long certificate run.
cargo build --release -p homeo-certs
cargo build --release -p homeo-benches --features "$features" --bin homeo-peers --bin homeo-profile
exec target/release/homeo-peers "$@"
