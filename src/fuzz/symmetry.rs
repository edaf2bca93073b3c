//! Orders of a case's points that change the answer in a known way.

use std::fmt;
use std::ops::Range;

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

impl Symmetry {
    /// Does every right answer to a case and to its image agree with this? What is none would make right answers contradict
    /// each other.
    pub(super) fn is_of(&self, predicate: Predicate) -> bool {
        let order = self.order.as_slice();
        let keeps = |part: Range<u8>| {
            let places = usize::from(part.start)..usize::from(part.end);
            order.get(places).is_some_and(|images| images.iter().all(|i| part.contains(i)))
        };
        match predicate {
            Predicate::Orient2d | Predicate::Orient3d | Predicate::Incircle | Predicate::Insphere => {
                self.negates == is_odd(order)
            }
            Predicate::DotSign => keeps(0..3) && self.negates == is_odd(order),
            _ if self.negates => false,
            Predicate::PointInTet => keeps(0..4),
            Predicate::TriangleTriangle => keeps(0..3) || order.iter().take(3).all(|i| *i >= 3),
            Predicate::SegmentTriangle => keeps(0..2),
            Predicate::RayTriangle => keeps(0..1) && keeps(1..2),
            // An odd order of the corners turns all tets inside out, and so does an exchange of the two ends.
            Predicate::PrismPositivity => {
                let (lo, hi) = order.split_at(order.len().min(3));
                let turned = lo.first() >= Some(&3);
                pillars(lo, hi) && lo.iter().all(|i| (*i >= 3) == turned) && is_odd(lo) == turned
            }
            // An odd order of the triangle turns its normal, and an exchange of the two ends all pillars.
            Predicate::SectionDot => {
                let (triangle, rest) = order.split_at(order.len().min(3));
                let (lo, hi) = rest.split_at(rest.len().min(3));
                let swapped = lo.first() >= Some(&6);
                pillars(lo, hi)
                    && keeps(0..3)
                    && lo.iter().all(|i| (*i >= 6) == swapped)
                    && is_odd(triangle) == swapped
            }
        }
    }
}

/// Does the permutation take an odd number of exchanges?
fn is_odd(order: &[u8]) -> bool {
    let greater = |(i, x): (usize, &u8)| order.iter().skip(i).filter(|y| *y < x).count();
    order.iter().enumerate().map(greater).sum::<usize>() % 2 == 1
}

/// Are the points of the one list and of the other those of the same pillars?
fn pillars(lo: &[u8], hi: &[u8]) -> bool {
    lo.iter().zip(hi).all(|(lo, hi)| lo.abs_diff(*hi) == 3)
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
