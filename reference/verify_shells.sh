#!/usr/bin/env bash
# Certifies every real shell of the test data, checks each certificate with both checkers, and compares the verdicts
# with those that INDEX.md states. Usage: reference/verify_shells.sh [DATA]; DATA defaults to $HOMEO_DATA or ../shared/data.
# Exit code 1 on any difference; without the data it says so and ends with 0.
set -u
cd "$(dirname -- "$0")/.." || exit 2
data="${1:-${HOMEO_DATA:-../shared/data}}/thirdparty/shells"
if [ ! -d "$data" ]; then
    echo "SKIPPED: no shells at $data (20 files not verified)"
    exit 0
fi
bin="${HOMEO_BIN:-target/release}"
[ -n "${HOMEO_BIN:-}" ] || cargo build --quiet --release --workspace || exit 2
out="$(mktemp -d)" || exit 2
trap 'rm -rf "$out"' EXIT
bad=0
printf '%-42s %-58s %-8s %-8s %s\n' shell "refuted claims" Rust Python verdict
for file in "$data"/*.h5 "$data"/*.h5.init; do
    name="$(basename "$file")"
    "$bin/homeo" certify "$file" --no-check --quiet -o "$out/cert" >/dev/null 2>"$out/err"
    code=$?
    refuted="$(sed -n 's/^claim \(.*\) refuted$/\1/p' "$out/cert" | tr '\n' ' ')"
    case "$name" in
    decimated-knight.off.h5.extract.h5) expected="positivity section bijection section-all-orders i2 " ;;
    bunny.off.h5.extract.h5) expected="positivity section-all-orders i2 " ;;
    bunny.off.allowint.h5) expected="section bijection section-all-orders disjoint-bottom disjoint-top i2 " ;;
    *) expected="" ;;
    esac
    rust="$("$bin/homeo-check" "$out/cert" "$file" | sed -n 1p)"
    python="$(python3 reference/check.py "$out/cert" "$file" | sed -n 1p)"
    verdict="as stated"
    want=1
    [ -z "$expected" ] && want=0
    if [ "$refuted" != "$expected" ] || [ "$rust" != valid ] || [ "$python" != valid ] || [ $code != $want ]; then
        verdict="DIFFERENT (exit $code)"
        bad=$((bad + 1))
    fi
    printf '%-42s %-58s %-8s %-8s %s\n' "$name" "${refuted:--}" "$rust" "$python" "$verdict"
done
echo "$bad different"
[ "$bad" = 0 ]
