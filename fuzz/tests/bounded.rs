//! Regressions, and a bounded number of random mutations of seeds, on a stable toolchain.

use std::fs;
use std::path::Path;

/// A small generator: the same mutations on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % bound.max(1)
    }
}

/// One to four random edits: a bit flip, a byte, a removal, a copied run, a cut.
fn mutated(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut out = seed.to_vec();
    for _ in 0..=random.next(4) {
        let at = random.next(out.len());
        match random.next(5) {
            _ if out.is_empty() => out.push(0),
            0 => out[at] ^= 1 << random.next(8),
            1 => out[at] = u8::try_from(random.next(256)).unwrap_or(0),
            2 => drop(out.drain(at..(at + 1 + random.next(16)).min(out.len()))),
            3 => {
                let run: Vec<u8> = out[at..(at + 1 + random.next(32)).min(out.len())].to_vec();
                let to = random.next(out.len());
                out.splice(to..to, run);
            }
            _ => out.truncate(at),
        }
    }
    out
}

fn run(name: &str, target: fn(&[u8]), seeds: &[Vec<u8>], rounds: usize) {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("regressions").join(name);
    for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
        target(&fs::read(entry.path()).unwrap());
    }
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for round in 0..rounds {
        target(&mutated(&seeds[round % seeds.len()], &mut random));
    }
}

fn corpus(case: &str, file: &str) -> Vec<u8> {
    fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("../certs/corpus").join(case).join(file)).unwrap()
}

#[test]
fn meshes() {
    let off = corpus("patch", "mesh.off");
    let mesh = homeo::mesh::parse(&off, homeo::mesh::Format::Off, "seed").unwrap().mesh;
    let formats = [
        homeo::mesh::Format::Obj,
        homeo::mesh::Format::PlyAscii,
        homeo::mesh::Format::PlyBinaryLe,
        homeo::mesh::Format::StlAscii,
        homeo::mesh::Format::StlBinary,
    ];
    let mut seeds = vec![off];
    seeds.extend(formats.iter().map(|f| homeo::mesh::encode(&mesh, *f, "seed").unwrap()));
    run("mesh", homeo_fuzz::mesh, &seeds, 20_000);
}

#[test]
fn shells() {
    let part = |f| homeo::mesh::parse(&corpus("patch", f), homeo::mesh::Format::Off, f).unwrap().mesh;
    let shell = homeo::shell::three::from_meshes(part("bottom.off"), part("middle.off"), part("top.off")).unwrap();
    let file = homeo::shell::hdf5::ShellFile {
        shell,
        mesh: Some(part("mesh.off")),
        tracks: None,
        meta_edges: None,
        metadata: None,
        notes: Vec::new(),
    };
    run("shell", homeo_fuzz::shell, &[homeo::shell::hdf5::to_bytes(&file).unwrap()], 20_000);
}

#[test]
fn certificates() {
    let seeds = ["patch", "patch-order", "ball", "monodromy", "closed-tet"].map(|c| corpus(c, "control.cert"));
    run("certificate", homeo_fuzz::certificate, &seeds, 5_000);
}
