//! Many signs at once: the filter of [`orient3d`](super::orient3d) and [`dot_sign`](super::dot_sign) on blocks of inputs with
//! the processor's vector instructions, then the exact stages for the inputs that it leaves open.
//!
//! Answers, and the stage that decides each input, are those of the single predicates, bit for bit. Vector code comes from
//! the compiler, on plain loops over blocks; the crate `pulp` chooses the widest instructions at run time. There is no
//! `unsafe` here.
//!
//! ```
//! use homeo::predicate::{Sign, batch};
//! let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let quads = [[0, 1, 2, 3], [1, 0, 2, 3], [0, 1, 2, 2]];
//! let mut signs = [Sign::Zero; 3];
//! batch::orient3d_indexed(&vertices, &quads, &mut signs)?;
//! assert_eq!(signs, [Sign::Positive, Sign::Negative, Sign::Zero]);
//! # Ok::<(), batch::BatchError>(())
//! ```

pub(crate) mod kernel;
mod level;
#[cfg(test)]
mod tests;

pub use level::Level;

use super::{Sign, StageCounts, dot_sign_staged, orient3d_staged};
use kernel::{LANES, Row, ZERO, filter3, filter3_indexed, minus};

/// One point of every input: its coordinates by axis, input `i` at index `i` of each.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a>(pub [&'a [f64]; 3]);

impl Points<'_> {
    #[inline(always)]
    fn at(&self, i: usize) -> [f64; 3] {
        self.0.map(|axis| axis[i])
    }

    /// The block that starts at `i`.
    #[inline(always)]
    fn block(&self, i: usize) -> Row {
        let mut out = ZERO;
        for (out, axis) in out.iter_mut().zip(self.0) {
            out.copy_from_slice(&axis[i..i + LANES]);
        }
        out
    }
}

/// Why a batch has no answer. The signs are as they were.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchError {
    /// An array of another length than the signs.
    #[error("point {point}, axis {axis}: {found} coordinates for {wanted} signs")]
    Length {
        /// Which of the input's points.
        point: usize,
        /// 0, 1, 2.
        axis: usize,
        /// The length of the array.
        found: usize,
        /// The number of signs.
        wanted: usize,
    },
    /// Another number of inputs than of signs.
    #[error("{inputs} inputs for {wanted} signs")]
    Count {
        /// The number of inputs.
        inputs: usize,
        /// The number of signs.
        wanted: usize,
    },
    /// An index that no vertex has.
    #[error("input {input} has the index {index}, but there are {vertices} vertices")]
    Index {
        /// The first such input.
        input: usize,
        /// Its index.
        index: u32,
        /// The number of vertices.
        vertices: usize,
    },
}

/// The signs of [`orient3d`](super::orient3d) of the points `a, b, c, d` of every input. Linear; one thread.
///
/// # Errors
/// [`BatchError::Length`].
pub fn orient3d(points: [Points<'_>; 4], signs: &mut [Sign]) -> Result<StageCounts, BatchError> {
    orient3d_at(Level::widest(), points, signs)
}

/// [`orient3d`] with instructions of a level.
///
/// # Errors
/// [`BatchError::Length`].
pub fn orient3d_at(
    level: Level,
    points: [Points<'_>; 4],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    check_lengths(&points, signs.len())?;
    let [a, b, c, d] = points;
    let exact = |i: usize| orient3d_staged(&a.at(i), &b.at(i), &c.at(i), &d.at(i));
    Ok(decided(
        level,
        signs,
        #[inline(always)]
        |i: usize| {
            let from = a.block(i);
            filter3(&minus(&b.block(i), &from), &minus(&c.block(i), &from), &minus(&d.block(i), &from))
        },
        exact,
    ))
}

/// The signs of [`dot_sign`](super::dot_sign) of the points `a, b, c, s, t` of every input. Linear; one thread.
///
/// # Errors
/// [`BatchError::Length`].
pub fn dot_sign(points: [Points<'_>; 5], signs: &mut [Sign]) -> Result<StageCounts, BatchError> {
    dot_sign_at(Level::widest(), points, signs)
}

/// [`dot_sign`] with instructions of a level.
///
/// # Errors
/// [`BatchError::Length`].
pub fn dot_sign_at(
    level: Level,
    points: [Points<'_>; 5],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    check_lengths(&points, signs.len())?;
    let [a, b, c, s, t] = points;
    let exact = |i: usize| dot_sign_staged(&a.at(i), &b.at(i), &c.at(i), &s.at(i), &t.at(i));
    Ok(decided(
        level,
        signs,
        #[inline(always)]
        |i: usize| {
            let from = a.block(i);
            filter3(&minus(&b.block(i), &from), &minus(&c.block(i), &from), &minus(&t.block(i), &s.block(i)))
        },
        exact,
    ))
}

/// [`orient3d`] of inputs that are four indices of vertices.
///
/// # Errors
/// [`BatchError::Count`], [`BatchError::Index`].
pub fn orient3d_indexed(
    vertices: &[[f64; 3]],
    inputs: &[[u32; 4]],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    orient3d_indexed_at(Level::widest(), vertices, inputs, signs)
}

/// [`orient3d_indexed`] with instructions of a level.
///
/// # Errors
/// [`BatchError::Count`], [`BatchError::Index`].
pub fn orient3d_indexed_at(
    level: Level,
    vertices: &[[f64; 3]],
    inputs: &[[u32; 4]],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    check_indices(vertices.len(), inputs, signs.len())?;
    let exact = |i: usize| {
        let [a, b, c, d] = inputs[i].map(|v| &vertices[v as usize]);
        orient3d_staged(a, b, c, d)
    };
    Ok(decided(
        level,
        signs,
        #[inline(always)]
        |i: usize| filter3_indexed(vertices, &inputs[i..i + LANES], [(0, 1), (0, 2), (0, 3)]),
        exact,
    ))
}

/// [`dot_sign`] of inputs that are five indices of vertices.
///
/// # Errors
/// [`BatchError::Count`], [`BatchError::Index`].
pub fn dot_sign_indexed(
    vertices: &[[f64; 3]],
    inputs: &[[u32; 5]],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    dot_sign_indexed_at(Level::widest(), vertices, inputs, signs)
}

/// [`dot_sign_indexed`] with instructions of a level.
///
/// # Errors
/// [`BatchError::Count`], [`BatchError::Index`].
pub fn dot_sign_indexed_at(
    level: Level,
    vertices: &[[f64; 3]],
    inputs: &[[u32; 5]],
    signs: &mut [Sign],
) -> Result<StageCounts, BatchError> {
    check_indices(vertices.len(), inputs, signs.len())?;
    let exact = |i: usize| {
        let [a, b, c, s, t] = inputs[i].map(|v| &vertices[v as usize]);
        dot_sign_staged(a, b, c, s, t)
    };
    Ok(decided(
        level,
        signs,
        #[inline(always)]
        |i: usize| filter3_indexed(vertices, &inputs[i..i + LANES], [(0, 1), (0, 2), (3, 4)]),
        exact,
    ))
}

fn check_lengths(points: &[Points<'_>], wanted: usize) -> Result<(), BatchError> {
    for (point, axes) in points.iter().enumerate() {
        for (axis, found) in axes.0.iter().map(|x| x.len()).enumerate() {
            if found != wanted {
                return Err(BatchError::Length { point, axis, found, wanted });
            }
        }
    }
    Ok(())
}

fn check_indices<const N: usize>(
    vertices: usize,
    inputs: &[[u32; N]],
    wanted: usize,
) -> Result<(), BatchError> {
    if inputs.len() != wanted {
        return Err(BatchError::Count { inputs: inputs.len(), wanted });
    }
    // One pass without branches, as it runs on every batch: the place is only looked for where there is one.
    let largest = inputs.as_flattened().iter().fold(0, |a, &b| a.max(b));
    if inputs.is_empty() || (largest as usize) < vertices {
        return Ok(());
    }
    let first = |(input, ids): (usize, &[u32; N])| {
        ids.iter().find(|&&i| i as usize >= vertices).map(|&index| BatchError::Index {
            input,
            index,
            vertices,
        })
    };
    inputs.iter().enumerate().find_map(first).map_or(Ok(()), Err)
}

/// All signs, with the instructions of a level. Filters have to be inlined, too: code that is called is compiled for what every
/// processor has, so that the level would be without effect.
#[inline(always)]
fn decided(
    level: Level,
    signs: &mut [Sign],
    filter: impl Fn(usize) -> [i8; LANES],
    exact: impl Fn(usize) -> (Sign, super::Stage),
) -> StageCounts {
    level.run(
        #[inline(always)]
        || all(signs, filter, exact),
    )
}

/// All signs: blocks through the filter, then one by one what it left open, and the tail.
#[inline(always)]
fn all(
    signs: &mut [Sign],
    filter: impl Fn(usize) -> [i8; LANES],
    exact: impl Fn(usize) -> (Sign, super::Stage),
) -> StageCounts {
    let mut counts = StageCounts::default();
    let (blocks, tail) = signs.as_chunks_mut::<LANES>();
    let whole = blocks.len() * LANES;
    for (b, block) in blocks.iter_mut().enumerate() {
        let found = filter(b * LANES);
        let mut open = 0;
        for (sign, x) in block.iter_mut().zip(found) {
            *sign = if x > 0 {
                Sign::Positive
            } else if x < 0 {
                Sign::Negative
            } else {
                Sign::Zero
            };
            open += u64::from(x == 0);
        }
        counts.filter += LANES as u64 - open;
        if open > 0 {
            finish(block, b * LANES, &found, &exact, &mut counts);
        }
    }
    for (i, sign) in tail.iter_mut().enumerate() {
        *sign = counts.note(exact(whole + i));
    }
    counts
}

/// The inputs of a block that the filter left open.
#[cold]
#[inline(never)]
fn finish(
    block: &mut [Sign; LANES],
    start: usize,
    found: &[i8; LANES],
    exact: &impl Fn(usize) -> (Sign, super::Stage),
    counts: &mut StageCounts,
) {
    for (l, sign) in block.iter_mut().enumerate() {
        if found[l] == 0 {
            *sign = counts.note(exact(start + l));
        }
    }
}
