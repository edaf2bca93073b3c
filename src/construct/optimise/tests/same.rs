//! The number of threads and the size of batches change nothing; the seed does.

use super::*;
use crate::construct::optimise::operation::Proposal;
use std::borrow::Cow;

fn with_threads<R: Send>(threads: usize, run: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(run)
}

fn meshes() -> Vec<TriMesh> {
    vec![cube(), bumpy(3, &mut Random(21)), landscape(14, &mut Random(22))]
}

#[test]
fn any_number_of_threads_makes_the_same_shell() {
    for mesh in meshes() {
        let build = |threads: usize| {
            with_threads(threads, || {
                let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
                optimise(&mesh, &first.shell, &OptimiseOptions::default(), &Silent).unwrap()
            })
        };
        let one = build(1);
        for threads in [2, 4] {
            let other = build(threads);
            assert_eq!(one.shell, other.shell);
            assert_eq!(one.counts, other.counts);
        }
        assert_eq!(refuted(&one.shell, &mesh), Vec::<String>::new());
    }
}

#[test]
fn seeds_change_the_order_and_nothing_that_is_claimed() {
    let mesh = bumpy(3, &mut Random(23));
    let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
    let build = |seed: u64| {
        let options = OptimiseOptions { seed, polish: 4, ..OptimiseOptions::default() };
        optimise(&mesh, &first.shell, &options, &Silent).unwrap().shell
    };
    let shells = [0, 1, 2].map(build);
    assert!(shells[0] != shells[1] && shells[1] != shells[2]);
    assert_eq!(shells[1], build(1));
    for shell in &shells {
        assert_eq!(refuted(shell, &mesh), Vec::<String>::new());
    }
}

/// The definition of what [`State::is_settled`] promises: whatever changes elsewhere, a proposal at a settled key is the
/// one that was made before.
#[test]
fn proposals_at_settled_keys_stay_what_they_were() {
    let operations =
        [Operation::Flip, Operation::Smooth, Operation::Collapse, Operation::HardCollapse, Operation::Split];
    let (mut kept, mut lost) = (0, 0);
    for mesh in [bumpy(2, &mut Random(24)), landscape(7, &mut Random(25))] {
        let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
        let mut state = State::new(&first.shell, &connectivity(&first.shell));
        let rules = Rules {
            judge: Judge::new(Cow::Borrowed(&mesh), 0.0),
            limits: Limits { thickness: 0.3, energy: 30.0 },
        };
        let mut random = Random(26);
        for _ in 0..12 {
            let keys: Vec<[u32; 2]> = state.edges();
            let all = |state: &State| -> Vec<[Option<Proposal>; 5]> {
                keys.iter().map(|&k| operations.map(|o| o.propose(state, &rules, k))).collect()
            };
            let (before, since) = (all(&state), state.clock);
            for _ in 0..6 {
                random_operation(&mut state, &rules, &mut random);
            }
            for ((key, before), after) in keys.iter().zip(before).zip(all(&state)) {
                if key.iter().all(|&v| state.is_settled(v, since)) {
                    assert_eq!(before, after, "{key:?}");
                    kept += 1;
                } else if before != after {
                    lost += 1;
                }
            }
        }
    }
    assert!(kept > 1000 && lost > 100, "{kept} kept, {lost} lost");
}
