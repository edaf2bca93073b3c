//! Writes the seeds of all targets to `corpus/TARGET/`, where libFuzzer starts from them.

use std::path::Path;

fn main() -> std::io::Result<()> {
    for (target, _) in homeo_fuzz_targets::TARGETS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus").join(target);
        std::fs::create_dir_all(&folder)?;
        for (i, seed) in homeo_fuzz_targets::seeds(target).iter().enumerate() {
            std::fs::write(folder.join(format!("seed-{i}")), seed)?;
        }
    }
    Ok(())
}
