//! Checkpoints: resuming leads to the same bits, and no bytes lead to a panic.

use super::*;
use crate::construct::optimise::checkpoint::CheckpointError;

fn options() -> OptimiseOptions {
    OptimiseOptions { polish: 3, ..OptimiseOptions::default() }
}

fn started(mesh: &TriMesh) -> Optimiser<'_> {
    let first = initial(mesh, &InitialOptions::default(), &Silent).unwrap();
    Optimiser::new(mesh, &first.shell, &options()).unwrap()
}

#[test]
fn resuming_after_any_batch_leads_to_the_same_shell() {
    for mesh in [bumpy(2, &mut Random(31)), landscape(8, &mut Random(32))] {
        let mut whole = started(&mesh);
        let mut batches = 0;
        while whole.advance() {
            batches += 1;
        }
        assert!(batches > 8, "{batches} batches");
        // Interrupted and resumed after every single batch,
        let mut work = started(&mesh);
        loop {
            work = Optimiser::resume(&mesh, &options(), &work.checkpoint().unwrap()).unwrap();
            if !work.advance() {
                break;
            }
        }
        assert_eq!((work.shell().unwrap(), work.counts()), (whole.shell().unwrap(), whole.counts()));
        assert_eq!(work.checkpoint().unwrap(), whole.checkpoint().unwrap());
        // and once, after some number of them.
        let mut work = started(&mesh);
        for k in 0..=batches {
            if k % 7 == 0 {
                let mut again = Optimiser::resume(&mesh, &options(), &work.checkpoint().unwrap()).unwrap();
                while again.advance() {}
                assert_eq!(
                    (again.shell().unwrap(), again.counts()),
                    (whole.shell().unwrap(), whole.counts())
                );
            }
            work.advance();
        }
    }
}

#[test]
fn checkpoints_of_other_work_are_refused_by_name() {
    let mesh = bumpy(1, &mut Random(33));
    let bytes = started(&mesh).checkpoint().unwrap();
    let refused = |mesh: &TriMesh, options: &OptimiseOptions, bytes: &[u8]| {
        Optimiser::resume(mesh, options, bytes).unwrap_err()
    };
    let mut moved = mesh.clone();
    moved.vertices[3][1] += 1e-9;
    assert!(matches!(refused(&moved, &options(), &bytes), CheckpointError::OtherMesh));
    let base = options();
    for other in [
        OptimiseOptions { thickness: crate::construct::Thickness::Share(0.2), ..base },
        OptimiseOptions { max_energy: 31.0, ..base },
        OptimiseOptions { max_angle_degrees: 89.0, ..base },
        OptimiseOptions { polish: 4, ..base },
        OptimiseOptions { seed: 1, ..base },
    ] {
        assert!(matches!(refused(&mesh, &other, &bytes), CheckpointError::OtherOptions));
    }
    // How long it may take is no matter of the result.
    let soon = OptimiseOptions { time_limit: Some(Duration::ZERO), ..base };
    assert!(Optimiser::resume(&mesh, &soon, &bytes).is_ok());
    assert!(matches!(refused(&mesh, &base, b"solid ascii stl"), CheckpointError::Foreign));
    assert!(matches!(refused(&mesh, &base, b""), CheckpointError::Foreign));
    let mut newer = bytes.clone();
    newer[16] += 1;
    assert!(matches!(refused(&mesh, &base, &newer), CheckpointError::Version { .. }));
}

/// The checkpoint with its payload changed and the payload's hash made to fit.
fn forged(bytes: &[u8], change: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
    use sha2::{Digest as _, Sha256};
    let (header, payload) = bytes.split_at(116);
    let mut payload = payload.to_vec();
    change(&mut payload);
    [&header[..84], &Sha256::digest(&payload)[..], &payload].concat()
}

#[test]
fn damaged_checkpoints_are_refused_and_forged_ones_do_not_panic() {
    let mesh = bumpy(1, &mut Random(34));
    let mut work = started(&mesh);
    for _ in 0..5 {
        work.advance();
    }
    let bytes = work.checkpoint().unwrap();
    assert_eq!(forged(&bytes, |_| {}), bytes, "the header is what the forger takes it for");
    for cut in 0..bytes.len() {
        assert!(Optimiser::resume(&mesh, &options(), &bytes[..cut]).is_err(), "cut at {cut}");
    }
    for at in 0..bytes.len() {
        let mut bad = bytes.clone();
        bad[at] ^= 0x41;
        assert!(Optimiser::resume(&mesh, &options(), &bad).is_err(), "changed at {at}");
    }
    let mut random = Random(35);
    let mut seen = [0; 2];
    for _ in 0..250 {
        let bad = forged(&bytes, |payload| {
            for _ in 0..=random.below(2) {
                let at = random.below(payload.len());
                payload[at] =
                    [0, 1, 0x7f, 0x80, 0xff, u8::try_from(random.below(256)).unwrap()][random.below(6)];
            }
            if random.below(8) == 0 {
                payload.truncate(random.below(payload.len()));
            }
        });
        match Optimiser::resume(&mesh, &options(), &bad) {
            Err(_) => seen[0] += 1,
            Ok(mut work) => {
                for _ in 0..4 {
                    work.advance();
                }
                // What was taken for a valid shell has remained one.
                assert_eq!(refuted(&work.shell().unwrap(), &mesh), Vec::<String>::new());
                seen[1] += 1;
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 10), "one-sided: {seen:?}");
}
