//! Exact images before they are brought to lowest terms.

use dashu_base::UnsignedAbs;
use dashu_int::{IBig, UBig};

use super::integers::Integers;
use super::{Rat, ShellPoint};

/// An image under `P`, exactly: the three weights and the height as integers over one positive denominator.
///
/// Nothing is in lowest terms, so that no greatest common divisor is computed: for most points this takes a small part
/// of the time of a [`ShellPoint`], and no memory on the heap. Equality compares values.
#[derive(Clone, Debug)]
pub struct ExactImage {
    /// The prism: an index into [`Shell::faces`](crate::shell::Shell::faces).
    pub prism: u32,
    /// Weights, height, denominator.
    numbers: Integers<5>,
}

impl ExactImage {
    pub(super) fn new(prism: u32, numbers: Integers<5>) -> Self {
        Self { prism, numbers }
    }

    /// The numerators of the weights on the prism's corners, in the order of the face: none negative, their sum the
    /// denominator.
    #[must_use]
    pub fn weight_numerators(&self) -> [IBig; 3] {
        let [a, b, c, _, _] = self.numbers.to_big();
        [a, b, c]
    }

    /// The numerator of the height.
    #[must_use]
    pub fn height_numerator(&self) -> IBig {
        let [_, _, _, height, _] = self.numbers.to_big();
        height
    }

    /// The positive denominator of all four numbers.
    #[must_use]
    pub fn denominator(&self) -> UBig {
        let [.., denominator] = self.numbers.to_big();
        denominator.unsigned_abs()
    }

    /// The same point in lowest terms: four greatest common divisors.
    #[must_use]
    pub fn to_point(&self) -> ShellPoint {
        let [a, b, c, height, denominator] = self.numbers.to_big();
        let denominator = denominator.unsigned_abs();
        let reduced = |numerator: IBig| Rat::from_parts(numerator, denominator.clone());
        ShellPoint { prism: self.prism, weights: [a, b, c].map(reduced), height: reduced(height) }
    }
}

impl From<&ExactImage> for ShellPoint {
    fn from(image: &ExactImage) -> Self {
        image.to_point()
    }
}

impl PartialEq for ExactImage {
    fn eq(&self, other: &Self) -> bool {
        let (mine, theirs) = (self.numbers.to_big(), other.numbers.to_big());
        self.prism == other.prism && (0..4).all(|k| &mine[k] * &theirs[4] == &theirs[k] * &mine[4])
    }
}

impl Eq for ExactImage {}
