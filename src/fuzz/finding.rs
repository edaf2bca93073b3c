//! Mismatches: what is kept of them, and which of them count as one.

use serde::Serialize;

use super::bits::{magnitude, spread};
use super::generate::Origin;
use super::subject::wire_line;
use super::symmetry::Symmetry;
use super::{Answer, Class, Predicate};
use crate::predicate::Sign;

/// Exponents of one band.
const BAND: i32 = 128;

/// The band of a case's largest exponent, size one in the middle of band 0; `None` if all coordinates are zero.
pub(super) fn band(case: &[f64]) -> Option<i32> {
    magnitude(case).map(|e| (e + BAND / 2).div_euclid(BAND))
}

/// A case with a wrong answer.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    pub(super) class: Class,
    pub(super) origin: Origin,
    pub(super) case: Vec<f64>,
    pub(super) answer: Answer,
    pub(super) expected: Sign,
    /// For [`Class::Inconsistent`]: the order that gets another answer.
    pub(super) symmetry: Option<Symmetry>,
}

/// Failures with the same key are one finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Key {
    pub(super) class: Class,
    pub(super) origin: Origin,
    band: Option<i32>,
}

impl Failure {
    pub(super) fn key(&self) -> Key {
        Key { class: self.class, origin: self.origin.row(), band: band(&self.case) }
    }
}

impl Symmetry {
    /// Are these answers to a case and to its image in contradiction?
    pub(super) fn contradicts(&self, case: &Answer, image: &Answer) -> bool {
        match (case, image) {
            (Answer::Sign(one), Answer::Sign(other)) => *other != if self.negates { -*one } else { *one },
            _ => false,
        }
    }
}

/// Mismatches of one class, generator and band of magnitudes, with one case that shows them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// How the answer is wrong.
    pub class: Class,
    /// The generator, `generator/base` where it changed another one's case.
    pub origin: String,
    /// How many mismatches are like this one.
    pub count: u64,
    /// The case, as in the protocol's text mode.
    pub case: String,
    /// The right answer.
    pub expected: i8,
    /// The subject's answer.
    pub answer: String,
    /// For `inconsistent`: the order of the points with the contradicting answer, and a final `-` where the sign
    /// should change.
    pub order: Option<String>,
    /// The largest exponent of the case; `None` if all coordinates are zero.
    pub exponent: Option<i32>,
    /// The difference of its largest and least exponents.
    pub spread: i32,
    /// Can no single step of the search make it smaller?
    pub minimal: bool,
}

impl Finding {
    pub(super) fn new(predicate: Predicate, failure: &Failure, count: u64, minimal: bool) -> Self {
        Self {
            class: failure.class,
            origin: failure.origin.to_string(),
            count,
            case: wire_line(predicate, &failure.case),
            expected: failure.expected.as_i8(),
            answer: failure.answer.to_string(),
            order: failure.symmetry.as_ref().map(Symmetry::to_string),
            exponent: magnitude(&failure.case),
            spread: spread(&failure.case),
            minimal,
        }
    }
}
