#!/bin/sh
# Compares homeo with CGAL: predicates, projections, and all shells and meshes of $HOMEO_DATA, else ../shared/data. Prints
# tables; exit 1 on any difference. Says SKIPPED where the files are not at hand, exit 3 without CGAL. `--help` lists the options.
set -eu
cd "$(dirname -- "$0")/.."
# Programs that are built already (`./test`).
[ -z "${HOMEO_BIN:-}" ] || exec "$HOMEO_BIN/homeo-cross-validate" "$@"
exec cargo run --quiet --release -p homeo-benches --bin homeo-cross-validate -- "$@"
