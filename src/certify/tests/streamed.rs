//! Certificates that are written while they are made.

use std::io::{self, Write};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::sphere;
use crate::certify::{CertifyError, Claim, Observer, Options, Proof, Silent, certify, prove};
use crate::construct::icosphere;
use crate::shell::Shell;
use crate::testing::Random;

/// Keeps what it is given, in pieces of its own sizes, and fails after some bytes.
struct Slow {
    bytes: Vec<u8>,
    largest: usize,
    room: usize,
}

impl Slow {
    fn new(room: usize) -> Self {
        Self { bytes: Vec::new(), largest: 0, room }
    }
}

impl Write for Slow {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.largest = self.largest.max(bytes.len());
        let taken = bytes.len().min(1000).min(self.room - self.bytes.len());
        self.bytes.extend_from_slice(&bytes[..taken]);
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A shell of 20480 prisms around its middle surface.
fn large() -> (Shell, crate::mesh::TriMesh) {
    let mesh = icosphere(5);
    let scaled = |f: f64| mesh.vertices.iter().map(|p| p.map(|x| x * f)).collect::<Vec<_>>();
    let shell =
        Shell { bottom: scaled(0.9), middle: scaled(1.0), top: scaled(1.1), faces: mesh.faces.clone() };
    (shell, mesh)
}

fn written(proof: &Proof<'_>, threads: usize, out: &mut Slow) -> Result<(), CertifyError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| proof.write(out, &Silent))
}

#[test]
fn pieces_are_the_whole_certificate() {
    let mut random = Random(21);
    let options = Options { claims: Claim::ALL.to_vec(), ..Options::default() };
    for (shell, mesh) in [large(), sphere(&mut random, 0, 0), sphere(&mut random, 200, 3)] {
        let whole = certify(&shell, Some(&mesh), &options, &Silent).unwrap();
        let proof = prove(&shell, Some(&mesh), &options, &Silent).unwrap();
        for threads in [1, 2, 5] {
            let mut out = Slow::new(usize::MAX);
            written(&proof, threads, &mut out).unwrap();
            assert!(out.bytes == whole.certificate.as_bytes(), "{threads} threads");
            // Longer ones come in several pieces.
            assert!(out.largest < 300_000, "{}", out.largest);
        }
        let verdicts = |claims: &[crate::certify::ClaimResult]| {
            claims.iter().map(|c| (c.claim, c.verdict, c.counts.clone())).collect::<Vec<_>>()
        };
        assert_eq!(verdicts(proof.claims()), verdicts(&whole.claims));
    }
}

#[test]
fn a_writer_that_fails_ends_it_at_any_byte() {
    let (shell, mesh) = large();
    let options = Options { claims: vec![Claim::Section], ..Options::default() };
    let proof = prove(&shell, Some(&mesh), &options, &Silent).unwrap();
    let mut all = Slow::new(usize::MAX);
    written(&proof, 2, &mut all).unwrap();
    let length = all.bytes.len();
    assert!(length > 400_000, "{length}");
    for room in [0, 10, 100_000, length / 2, length - 1] {
        let mut out = Slow::new(room);
        let failed = written(&proof, 2, &mut out).unwrap_err();
        assert!(matches!(failed, CertifyError::Write(_)), "{room}: {failed}");
        assert!(out.bytes == all.bytes[..room], "{room}");
    }
    written(&proof, 2, &mut Slow::new(length)).unwrap();
}

/// Stops after it was asked so often.
struct After(AtomicUsize);

impl Observer for After {
    fn cancelled(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1)).is_err()
    }
}

#[test]
fn an_interruption_ends_it_between_pieces() {
    let (shell, mesh) = large();
    let options = Options { claims: vec![Claim::Section], ..Options::default() };
    let proof = prove(&shell, Some(&mesh), &options, &Silent).unwrap();
    let mut all = Vec::new();
    proof.write(&mut all, &Silent).unwrap();
    let lengths: Vec<usize> = (0..3)
        .map(|asked| {
            let mut out = Vec::new();
            let failed = proof.write(&mut out, &After(AtomicUsize::new(asked))).unwrap_err();
            assert!(matches!(failed, CertifyError::Cancelled), "{failed}");
            assert!(all.starts_with(&out));
            out.len()
        })
        .collect();
    assert!(lengths[0] == 0 && lengths.is_sorted() && lengths[2] < all.len(), "{lengths:?}");
}
