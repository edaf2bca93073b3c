//! Many points at once, on rayon's threads.

use rayon::prelude::*;

use super::{FloatMeshPoint, Transfer};
use crate::projection::SectionError;

/// So many points are worth a task.
const GROUP: usize = 256;

impl Transfer<'_> {
    /// [`forward_f64`](Self::forward_f64) of many points, given as triangle and weights: answer `i` is that of point `i`, bit
    /// for bit, whatever the number of threads. Nothing is allocated for a point that doubles decide.
    #[must_use]
    pub fn forward_batch_f64(&self, points: &[(u32, [f64; 3])]) -> Vec<Result<FloatMeshPoint, SectionError>> {
        in_parallel(points, |&(face, weights)| self.forward_f64(face, weights))
    }

    /// [`backward_f64`](Self::backward_f64) of many points.
    #[must_use]
    pub fn backward_batch_f64(
        &self,
        points: &[(u32, [f64; 3])],
    ) -> Vec<Result<FloatMeshPoint, SectionError>> {
        in_parallel(points, |&(face, weights)| self.backward_f64(face, weights))
    }
}

fn in_parallel<T: Send>(
    points: &[(u32, [f64; 3])],
    map: impl Fn(&(u32, [f64; 3])) -> T + Send + Sync,
) -> Vec<T> {
    points.par_iter().with_min_len(GROUP).map(map).collect()
}
