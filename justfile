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

# Long runs, each of which ends at the first disagreement (hours): fast predicates against the exact judge, everything against
# CGAL, random small shells against the definitions, certificates with one fact falsified
campaign cases="12000000" shells="1000000" lies="100000":
    cargo build --release -p homeo
    for p in orient2d orient3d incircle insphere dot_sign point_in_tet triangle_triangle segment_triangle ray_triangle; do \
        target/release/homeo fuzz $p --subject fast --cases {{cases}} || exit 1; done
    reference/cross_validate.sh --full
    HOMEO_CASES={{shells}} cargo test --release -p homeo-proptests --test verdicts --test sections -- --nocapture
    just lies {{lies}}
    @echo "campaign: no disagreement"

# Compare with CGAL (shells and meshes need the data): quick, or with --full, --cases N, --only PART; see --help
cross-validate *options:
    reference/cross_validate.sh {{options}}

# Certificates with one fact falsified, told to both checkers (needs python3)
lies count="100000" seed="1":
    HOMEO_LIES={{count}} HOMEO_SEED={{seed}} cargo test --release -p homeo-proptests --test lies -- --nocapture

# Line coverage by a crate's own tests (needs cargo-llvm-cov; HOMEO_DATA for the reader of HDF5)
coverage package="homeo-certs":
    cargo llvm-cov -p {{package}} --summary-only

# Mutants of the checker that its tests do not notice (needs cargo-mutants; hours); `file` narrows it
mutants file="certs/src/**":
    CARGO_PROFILE_DEV_DEBUG=0 cargo mutants --package homeo-certs -f '{{file}}' --timeout 30 -o target

# Audit every third-party pair, cage and tet map of the data; both checkers judge every document; writes
# benches/audit-zoo.* and benches/RESULTS.md (half an hour; each optimisation ends
# after a minute, `--time-limit` changes that)
audit-zoo *options:
    cargo build --release -p homeo -p homeo-certs
    python3 reference/audit_zoo.py target/release/homeo target/release/homeo-check ${HOMEO_DATA:-../shared/data} target/audit-zoo --results benches --time-limit 60 {{options}}
