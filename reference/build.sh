#!/bin/sh
# Builds the CGAL oracles into reference/build and prints that folder; `build.sh peers` also what `just peers` takes times
# with. Installs what is missing where it may; exit 3, with the reason, where it cannot.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
build="$here/build/cgal"
log="$here/build/cgal.log"
mkdir -p "$build"

build() {
    command -v cmake >/dev/null && command -v c++ >/dev/null &&
        cmake -S "$here/cgal" -B "$build" -DCMAKE_BUILD_TYPE=Release && cmake --build "$build" --parallel 2 --target all "$@"
}

if ! build "$@" >"$log" 2>&1; then
    if command -v apt-get >/dev/null && [ "$(id -u)" = 0 ]; then
        { apt-get update -qq && apt-get install -y -qq --no-install-recommends cmake g++ libcgal-dev; } >&2 || true
    fi
    if ! build "$@" >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        echo "CGAL oracles not built (needs cmake, g++ and libcgal-dev); log: reference/build/cgal.log" >&2
        exit 3
    fi
fi
echo "$build"
