//! Many points at once.

use rayon::prelude::*;

use super::boxes::Walk;
use super::rounded::signs;
use super::{FloatPoint, Projection};
use crate::predicate::Sign;

/// So many points are sorted at a time: their numbers must leave room for a place in space in 64 bits, and they fit into a
/// cache.
const BLOCK: usize = 1 << 20;
/// So many neighbours go down the tree together.
const GROUP: usize = 1 << 10;
/// Cells on each axis, a power of two: 30 bits for a place.
const CELLS: f64 = 1024.0;

/// What a thread needs again and again.
#[derive(Default)]
struct Scratch {
    points: Vec<[f64; 3]>,
    best: Vec<Option<(u32, u32, [Sign; 4])>>,
    walk: Walk,
}

impl Projection<'_> {
    /// [`project_f64`](Self::project_f64) of many points, on rayon's threads: answer `i` is that of point `i`, bit for bit,
    /// whatever the other points and the number of threads.
    ///
    /// Points are sorted along a space-filling curve, and neighbours searched for together; nothing is allocated for a
    /// single point. `O(n log n)`, and 72 bytes a point beside the answers for at most a million points at a time.
    #[must_use]
    pub fn project_batch_f64(&self, points: &[[f64; 3]]) -> Vec<Option<FloatPoint>> {
        let mut out = vec![None; points.len()];
        for (points, out) in points.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            let order = self.sorted(points);
            let mut answers = vec![None; points.len()];
            order.par_chunks(GROUP).zip(answers.par_chunks_mut(GROUP)).for_each_init(
                Scratch::default,
                |scratch, (order, answers)| {
                    self.group(points, order, scratch, answers);
                },
            );
            for (i, answer) in order.into_iter().zip(answers) {
                out[i as usize] = answer;
            }
        }
        out
    }

    /// The numbers of the points in the order of their cells along a Z-curve, then in their own.
    fn sorted(&self, points: &[[f64; 3]]) -> Vec<u32> {
        let key = |(p, number): (&[f64; 3], u32)| {
            let place = self.tree().local(p);
            // Whatever the rounding does, it moves points in the order and changes no answer; a cell out of range is the
            // nearest, that of no number the first.
            let cell = |i: usize| {
                let cell = ((place[i] / 4.0 + 0.5) * CELLS).clamp(0.0, CELLS - 1.0);
                (cell as i64).cast_unsigned()
            };
            (spread(cell(0)) << 2 | spread(cell(1)) << 1 | spread(cell(2))) << 32 | u64::from(number)
        };
        let mut keys: Vec<u64> = points.iter().zip(0..).map(key).collect();
        keys.par_sort_unstable();
        keys.into_iter().map(|key| key as u32).collect()
    }

    fn group(
        &self,
        points: &[[f64; 3]],
        order: &[u32],
        scratch: &mut Scratch,
        answers: &mut [Option<FloatPoint>],
    ) {
        scratch.points.clear();
        scratch.points.extend(order.iter().map(|&i| points[i as usize]));
        scratch.best.clear();
        scratch.best.resize(order.len(), None);
        let Scratch { points, best, walk } = scratch;
        self.tree().pairs(points, walk, &mut |near, tet| {
            let corners = self.points(&self.tets()[tet as usize]);
            for &i in near {
                if let Some(signs) = signs(corners, &points[i as usize]) {
                    self.keep_first(&mut best[i as usize], (tet, signs));
                }
            }
        });
        for ((answer, best), p) in answers.iter_mut().zip(best).zip(points) {
            *answer = best.map(|found| self.float_at(found, p));
        }
    }
}

/// Ten bits, two zeros between each two of them.
fn spread(x: u64) -> u64 {
    let x = (x | x << 16) & 0x0300_00ff;
    let x = (x | x << 8) & 0x0300_f00f;
    let x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}
