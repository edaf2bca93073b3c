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

# Measure side by side with CGAL and others (installs CGAL where it may); writes benches/peers.* and benches/RESULTS.md; try --quick
peers *options:
    benches/peers.sh {{options}}

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
    cargo run --quiet -p homeo-fuzz-targets --example seeds
    cargo +nightly fuzz run {{target}} --features libfuzzer -- -max_total_time={{seconds}}

# Fast predicates against the exact judge, everything against CGAL, small shells against the definitions (some 300 a second
# and core), sections by construction, arithmetic on all backends, certificates with one fact falsified.

# Long comparisons (hours); ends at the first disagreement
campaign cases="12000000" shells="1000000" sections="10000" lies="100000":
    cargo build --release -p homeo
    for p in orient2d orient3d incircle insphere dot_sign point_in_tet triangle_triangle segment_triangle ray_triangle; do \
        target/release/homeo fuzz $p --subject fast --cases {{cases}} || exit 1; done
    reference/cross_validate.sh --full
    HOMEO_CASES={{shells}} cargo test --release -p homeo-proptests --test verdicts -- --exact verdicts_agree_with_the_definitions --nocapture
    HOMEO_CASES={{sections}} cargo test --release -p homeo-proptests --test sections -- --nocapture
    just numbers
    just lies {{lies}}
    @echo "campaign: no disagreement"

# Compare with CGAL (shells and meshes need the data): quick, or with --full, --cases N, --only PART; see --help
cross-validate *options:
    reference/cross_validate.sh {{options}}

# Certificates with one fact falsified, told to both checkers (needs python3)
lies count="100000" seed="1":
    HOMEO_LIES={{count}} HOMEO_SEED={{seed}} cargo test --release -p homeo-proptests --test lies -- --nocapture

# The laws of arithmetic on all four number backends (needs m4 and make)
numbers cases="1000000":
    HOMEO_CASES={{cases}} cargo test --release --features rug,malachite,num-rational --lib number::tests::quick

# Line coverage by a package's own tests against the goals; exit 1 below one (needs cargo-llvm-cov, python3, and HOMEO_DATA for HDF5)
coverage:
    cargo llvm-cov -p homeo-certs --json --summary-only --output-path target/coverage-certs.json
    cargo llvm-cov -p homeo --json --summary-only --output-path target/coverage-homeo.json
    python3 -B reference/coverage.py target/coverage-certs.json certs/src=95 target/coverage-homeo.json src/predicate=90 src/certify=90

# Mutants of the checker that its tests do not notice (needs cargo-mutants; hours); `file` narrows it
mutants file="certs/src/**":
    CARGO_PROFILE_DEV_DEBUG=0 cargo mutants --package homeo-certs -f '{{file}}' --timeout 30 -o target

# `--time-limit S` changes how long each optimisation may take.

# Audit every third-party pair, cage and tet map of the data; both checkers judge every document (half an hour; benches/audit-zoo.*)
audit-zoo *options:
    cargo build --release -p homeo -p homeo-certs
    python3 reference/audit_zoo.py target/release/homeo target/release/homeo-check ${HOMEO_DATA:-../shared/data} target/audit-zoo --results benches --time-limit 60 {{options}}
