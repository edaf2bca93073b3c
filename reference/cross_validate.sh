#!/bin/sh
# Compares homeo's counts with CGAL's on all real shell files ($HOMEO_DATA, else ../shared/data): prints a table,
# exit 1 on any difference. Says SKIPPED, with exit 0, where the files or CGAL are not at hand.
set -eu
cd "$(dirname -- "$0")/.."
exec cargo run --quiet --release -p homeo-benches --bin homeo-cross-validate
