# `just` lists the recipes.
default:
    @just --list

# Make a shell, certify it, damage it
demo:
    cargo run --release -- demo

# Everything that is tested
test:
    ./test

# Formatting, lints, documentation
check:
    cargo fmt --all --check
    cargo clippy --workspace --all-targets -- -D warnings
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps

# Measurements
bench:
    cargo bench --workspace

# Fuzz one target for a minute (needs cargo-fuzz and a nightly toolchain)
fuzz target="parse":
    cd fuzz && cargo +nightly fuzz run {{target}} -- -max_total_time=60

# Compare counts with CGAL's on real shells (needs CGAL and the data)
cross-validate:
    reference/cross_validate.sh
