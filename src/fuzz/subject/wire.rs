//! The bytes of the protocol (`docs/SUBJECTS.md`).

use std::fmt::Write as _;

use crate::fuzz::{Answer, Predicate, hex};
use crate::predicate::Sign;

/// A case in text mode, without the line feed.
pub(in crate::fuzz) fn line(predicate: Predicate, case: &[f64]) -> String {
    let mut out = predicate.name().to_owned();
    for x in case {
        out.push(' ');
        hex::write(&mut out, *x);
    }
    out
}

/// All cases in text mode.
pub(super) fn text(predicate: Predicate, cases: &[f64]) -> Vec<u8> {
    let mut out = String::with_capacity(cases.len() * 24);
    for case in cases.chunks_exact(predicate.arity()) {
        let _ = writeln!(out, "{}", line(predicate, case));
    }
    out.into_bytes()
}

/// All cases in binary mode.
pub(super) fn binary(predicate: Predicate, cases: &[f64]) -> Vec<u8> {
    let mut out = format!("{predicate} {}\n", cases.len() / predicate.arity()).into_bytes();
    out.reserve(cases.len() * 8);
    for x in cases {
        out.extend(x.to_le_bytes());
    }
    out
}

/// Characters of a bad answer that are kept.
const KEPT: usize = 40;

/// An answer in text mode.
pub(super) fn answer_of_line(line: &[u8]) -> Answer {
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    match line {
        b"-1" => Answer::Sign(Sign::Negative),
        b"0" => Answer::Sign(Sign::Zero),
        b"1" => Answer::Sign(Sign::Positive),
        b"nan" => Answer::Nan,
        b"unsupported" => Answer::Unsupported,
        other => Answer::Bad(String::from_utf8_lossy(other).chars().take(KEPT).collect()),
    }
}

/// An answer in binary mode.
pub(super) fn answer_of_byte(byte: u8) -> Answer {
    match byte.cast_signed() {
        -1 => Answer::Sign(Sign::Negative),
        0 => Answer::Sign(Sign::Zero),
        1 => Answer::Sign(Sign::Positive),
        2 => Answer::Nan,
        3 => Answer::Unsupported,
        other => Answer::Bad(format!("byte {other}").into()),
    }
}
