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

# Measurements, side by side with other programs; writes benches/RESULTS.md
bench:
    benches/compare.sh

# Build, certify and check every surface of the data; writes benches/dataset.* and benches/RESULTS.md (needs the data)
dataset *meshes:
    cargo build --quiet --release --workspace
    target/release/homeo-dataset {{meshes}}

# Time and memory of building against input size; writes benches/scaling.* and benches/RESULTS.md
scaling *sizes:
    cargo build --quiet --release --workspace
    target/release/homeo-scaling {{sizes}}

# Certify every real shell and check it with both checkers (needs the data)
verify-shells:
    reference/verify_shells.sh

# Fuzz one target (needs cargo-fuzz and a nightly toolchain)
fuzz target="certificate" seconds="60":
    cargo run --quiet --manifest-path fuzz/Cargo.toml --example seeds
    cargo +nightly fuzz run {{target}} --features libfuzzer -- -max_total_time={{seconds}}

# Long runs: random small shells against the brute-force oracle, and everything against CGAL
campaign cases="50000":
    HOMEO_CASES={{cases}} cargo test --release -p homeo-proptests --test verdicts
    reference/cross_validate.sh --full

# Compare with CGAL (shells and meshes need the data): quick, or with --full, --cases N, --only PART; see --help
cross-validate *options:
    reference/cross_validate.sh {{options}}

# Audit every third-party pair, cage and tet map of the data; both checkers judge every document (hours, most in Python)
audit-zoo *options:
    cargo build --release -p homeo -p homeo-certs
    python3 reference/audit_zoo.py target/release/homeo target/release/homeo-check ${HOMEO_DATA:-../shared/data} target/audit-zoo {{options}}
