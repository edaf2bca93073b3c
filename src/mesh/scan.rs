//! A file of which some parts are text and others binary numbers: VTK and Gmsh.

use super::error::{Fault, Located, Place};
use super::text::{quote, quote_or_end};

/// How numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// As decimal text.
    Text,
    /// Binary, least significant byte first.
    Little,
    /// Binary, most significant byte first.
    Big,
}

/// A binary number type; text may hold any number for any of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    F32,
    F64,
    /// Integers by size in bytes.
    Signed(u8),
    Unsigned(u8),
}

impl Kind {
    pub(super) const I32: Self = Self::Signed(4);
    pub(super) const U64: Self = Self::Unsigned(8);

    pub(super) fn bytes(self) -> usize {
        match self {
            Self::F32 => 4,
            Self::F64 => 8,
            Self::Signed(n) | Self::Unsigned(n) => usize::from(n),
        }
    }

    /// Fewest bytes of one number in a file.
    pub(super) fn fewest_bytes(self, mode: Mode) -> usize {
        // A digit and a space.
        if mode == Mode::Text { 2 } else { self.bytes() }
    }

    pub(super) fn integer(self, raw: &[u8], mode: Mode) -> Option<i128> {
        let mut value: u64 = 0;
        let push = |value: u64, byte: &u8| (value << 8) | u64::from(*byte);
        if mode == Mode::Big {
            value = raw.iter().fold(value, push);
        } else {
            value = raw.iter().rev().fold(value, push);
        }
        match self {
            Self::Unsigned(_) => Some(value.into()),
            Self::Signed(n) => {
                let unused = 64_u32.checked_sub(u32::from(n) * 8)?;
                Some(i128::from((value << unused).cast_signed() >> unused))
            }
            _ => None,
        }
    }

    pub(super) fn float(self, raw: &[u8], mode: Mode) -> Option<f64> {
        let bits = Self::Unsigned(8).integer(raw, mode)?;
        match self {
            Self::F32 => Some(f32::from_bits(u32::try_from(bits).ok()?).into()),
            Self::F64 => Some(f64::from_bits(u64::try_from(bits).ok()?)),
            _ => {
                let value = self.integer(raw, mode)?;
                // Every integer below 2^53 is a float; others would be rounded.
                (value.unsigned_abs() <= 1 << 53).then_some(value as f64)
            }
        }
    }
}

/// Reads lines, words and binary numbers from the front.
pub(super) struct Scan<'a> {
    rest: &'a [u8],
    line: usize,
    mode: Mode,
    element: (&'static str, u64),
}

impl<'a> Scan<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, line: 1, mode: Mode::Text, element: ("", 0) }
    }

    pub(super) fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    pub(super) fn mode(&self) -> Mode {
        self.mode
    }

    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// What is being read; errors in binary data name it.
    pub(super) fn at(&mut self, kind: &'static str, index: u64) {
        self.element = (kind, index);
    }

    /// The fault with its place: the line in text, the element in binary data.
    pub(super) fn fault(&self, fault: Fault) -> Located {
        match (self.mode, self.element) {
            (Mode::Text, _) => fault.at_line(self.line),
            (_, ("", _)) => fault.into(),
            (_, (kind, index)) => Located { place: Place::Element { kind: kind.to_owned(), index }, fault },
        }
    }

    fn advance(&mut self, n: usize) -> &'a [u8] {
        let (taken, rest) = self.rest.split_at(n.min(self.rest.len()));
        self.rest = rest;
        self.line = self.line.saturating_add(taken.iter().filter(|&&b| b == b'\n').count());
        taken
    }

    /// The rest of this line, without its end.
    pub(super) fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|&b| b == b'\n').map_or(self.rest.len(), |i| i + 1);
        let line = self.advance(end);
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// Steps over white space.
    pub(super) fn skip_space(&mut self) {
        let space = self.rest.len() - self.rest.trim_ascii_start().len();
        self.advance(space);
    }

    /// The next word, wherever it is, or nothing at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_space();
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        (end > 0).then(|| self.advance(end))
    }

    /// The next word without taking it.
    pub(super) fn peek(&self) -> Option<&'a [u8]> {
        let rest = self.rest.trim_ascii_start();
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        rest.get(..end).filter(|w| !w.is_empty())
    }

    /// A word of text that must be a count, also in files with binary data.
    pub(super) fn count(&mut self, what: &str) -> Result<u64, Located> {
        let word = self.word();
        let value = word.and_then(|w| std::str::from_utf8(w).ok()).and_then(|w| w.parse().ok());
        value.ok_or_else(|| self.wanted(what, word))
    }

    /// The error that something else was wanted than this word.
    pub(super) fn wanted(&self, what: &str, found: Option<&[u8]>) -> Located {
        let found = found.map_or_else(|| "the end of the file".to_owned(), |w| quote_or_end(Some(w)));
        self.fault(Fault::expected(what, found))
    }

    /// Exactly `n` bytes.
    pub(super) fn take(&mut self, n: usize, what: &str) -> Result<&'a [u8], Located> {
        if self.rest.len() < n {
            return Err(self.wanted(what, None));
        }
        Ok(self.advance(n))
    }

    /// The next number, which must be an integer.
    pub(super) fn integer(&mut self, kind: Kind, what: &str) -> Result<i128, Located> {
        if self.mode == Mode::Text {
            let word = self.word();
            let value = word.and_then(|w| std::str::from_utf8(w).ok()).and_then(|w| w.parse().ok());
            return value.ok_or_else(|| self.wanted(what, word));
        }
        let raw = self.take(kind.bytes(), what)?;
        kind.integer(raw, self.mode).ok_or_else(|| self.wanted(what, Some(b"a float")))
    }

    /// The next number, which must not be negative.
    pub(super) fn unsigned(&mut self, kind: Kind, what: &str) -> Result<u64, Located> {
        let value = self.integer(kind, what)?;
        u64::try_from(value).map_err(|_| self.wanted(what, Some(value.to_string().as_bytes())))
    }

    /// The next number as a finite coordinate; text is rounded once.
    pub(super) fn coordinate(&mut self, kind: Kind) -> Result<f64, Located> {
        let what = "a coordinate";
        let value = if self.mode == Mode::Text {
            let word = self.word();
            let value = word.and_then(|w| std::str::from_utf8(w).ok()).and_then(|w| w.parse::<f64>().ok());
            value.ok_or_else(|| self.wanted(what, word))?
        } else {
            let raw = self.take(kind.bytes(), what)?;
            let integer =
                || self.fault(Fault::Unsupported("a coordinate beyond 2^53 in an integer type".to_owned()));
            kind.float(raw, self.mode).ok_or_else(integer)?
        };
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.fault(Fault::NotFinite(quote(value.to_string().as_bytes()))))
        }
    }

    /// The next `count` numbers are of no interest.
    pub(super) fn skip(&mut self, kind: Kind, count: u64, what: &str) -> Result<(), Located> {
        if self.mode == Mode::Text {
            for _ in 0..count {
                if self.word().is_none() {
                    return Err(self.wanted(what, None));
                }
            }
            return Ok(());
        }
        let bytes = usize::try_from(count).ok().and_then(|n| n.checked_mul(kind.bytes()));
        self.take(bytes.unwrap_or(usize::MAX), what).map(|_| ())
    }
}
