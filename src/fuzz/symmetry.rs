//! Orders of a case's points that change the answer in a known way.

use std::fmt;

use super::Predicate;
use super::random::Random;

/// A permutation of the points and what it does to the answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// Point `i` of the image is point `order[i]` of the case.
    pub order: Vec<u8>,
    /// Does the answer change its sign?
    pub negates: bool,
}

impl Symmetry {
    /// The image of a case with points of `dimension` coordinates; missing points are left out.
    #[must_use]
    pub fn image(&self, case: &[f64], dimension: usize) -> Vec<f64> {
        let point = |&i: &u8| case.get(usize::from(i) * dimension..(usize::from(i) + 1) * dimension);
        self.order.iter().filter_map(point).flatten().copied().collect()
    }
}

/// Shuffles a part of `order`; is the permutation odd?
fn shuffle(part: &mut [u8], random: &mut Random) -> bool {
    let mut odd = false;
    for i in (1..part.len()).rev() {
        let j = random.below(i + 1);
        part.swap(i, j);
        odd ^= i != j;
    }
    odd
}

/// Turns three entries by a random number of places, which is even.
fn rotate(part: &mut [u8], random: &mut Random) {
    part.rotate_left(random.below(part.len()));
}

/// A random symmetry of the predicate.
pub(super) fn random(predicate: Predicate, random: &mut Random) -> Symmetry {
    let mut order: Vec<u8> = (0_u8..).take(predicate.points()).collect();
    let negates = match predicate {
        // Determinants that change their sign with every exchange of two points.
        Predicate::Orient2d | Predicate::Orient3d | Predicate::Incircle | Predicate::Insphere => {
            shuffle(&mut order, random)
        }
        Predicate::DotSign => {
            let (triangle, direction) = order.split_at_mut(3);
            shuffle(triangle, random) ^ shuffle(direction, random)
        }
        Predicate::PointInTet => {
            shuffle(&mut order[..4], random);
            false
        }
        Predicate::TriangleTriangle => {
            let (one, two) = order.split_at_mut(3);
            shuffle(one, random);
            shuffle(two, random);
            if random.below(2) == 1 {
                order.rotate_left(3);
            }
            false
        }
        Predicate::SegmentTriangle => {
            let (segment, triangle) = order.split_at_mut(2);
            shuffle(segment, random);
            shuffle(triangle, random);
            false
        }
        Predicate::RayTriangle => {
            shuffle(&mut order[2..], random);
            false
        }
        Predicate::PrismPositivity => {
            order = prism(random);
            false
        }
        Predicate::SectionDot => {
            let (triangle, pillars) = order.split_at_mut(3);
            rotate(triangle, random);
            let mut corners = [0_u8, 1, 2];
            shuffle(&mut corners, random);
            let (lo, hi) = pillars.split_at_mut(3);
            for ((lo, hi), corner) in lo.iter_mut().zip(hi).zip(corners) {
                (*lo, *hi) = (3 + corner, 6 + corner);
            }
            false
        }
    };
    Symmetry { order, negates }
}

/// The corners turned, or the prism turned upside down with two corners exchanged: the same 12 tets.
fn prism(random: &mut Random) -> Vec<u8> {
    let mut corners = [0_u8, 1, 2];
    rotate(&mut corners, random);
    let lower = corners.into_iter();
    let upper = corners.into_iter().map(|c| c + 3);
    if random.below(2) == 0 {
        return lower.chain(upper).collect();
    }
    corners.swap(0, 1);
    corners.into_iter().map(|c| c + 3).chain(corners).collect()
}

impl fmt::Display for Symmetry {
    /// `1 0 2 3 -`: the points of the image, and a minus where the answer changes its sign.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, point) in self.order.iter().enumerate() {
            let space = if i == 0 { "" } else { " " };
            write!(f, "{space}{point}")?;
        }
        f.write_str(if self.negates { " -" } else { "" })
    }
}

impl Symmetry {
    /// Reads what is displayed; `None` unless it permutes the predicate's points.
    pub(super) fn parse(text: &str, predicate: Predicate) -> Option<Self> {
        let (points, negates) = match text.trim().strip_suffix('-') {
            Some(points) => (points, true),
            None => (text, false),
        };
        let order: Vec<u8> = points.split_whitespace().map(|p| p.parse().ok()).collect::<Option<_>>()?;
        let mut sorted = order.clone();
        sorted.sort_unstable();
        sorted.into_iter().eq((0..).take(predicate.points())).then_some(Self { order, negates })
    }
}
