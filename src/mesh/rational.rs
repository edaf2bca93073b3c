//! Positions as rational numbers in text: string properties of OpenVolumeMesh, and the `_rational.txt` of GalaxyMaps.

use std::path::Path;

use super::error::{Fault, Located, MeshError};
use super::format::load;
use super::text::{Lines, quote, quote_or_end, tokens, with_room};
use crate::number::{Rat, Rational as _};

/// Longest number in a file, in bytes: reading takes more than linear time in it.
const LONGEST: usize = 100_000;

/// One rational number, `-?[0-9]+(/[0-9]+)?`.
pub(super) fn number(token: &[u8]) -> Result<Rat, Fault> {
    if token.len() > LONGEST {
        return Err(Fault::Unsupported(format!("a number of {} digits", token.len())));
    }
    let text = std::str::from_utf8(token).unwrap_or_default();
    Rat::parse(text).map_err(|_| Fault::expected("a rational number", quote(token)))
}

/// A position from the pieces of a line: two or three numbers, of which a missing third is zero.
pub(super) fn position<'t>(mut pieces: impl Iterator<Item = &'t [u8]>) -> Result<[Rat; 3], Fault> {
    let mut next = || -> Result<Option<Rat>, Fault> { pieces.next().map(number).transpose() };
    let missing = || Fault::expected("2 or 3 rational coordinates", quote_or_end(None));
    let x = next()?.ok_or_else(missing)?;
    let y = next()?.ok_or_else(missing)?;
    let z = next()?.unwrap_or(Rat::ZERO);
    match pieces.next() {
        Some(more) => Err(Fault::expected("2 or 3 rational coordinates", quote(more))),
        None => Ok([x, y, z]),
    }
}

/// Reads positions, one vertex a line of two or three rational numbers; the cells are in another file.
///
/// # Errors
/// [`MeshError::Read`] with file, line and reason.
pub fn read_rational(path: &Path) -> Result<Vec<[Rat; 3]>, MeshError> {
    let name = path.to_string_lossy();
    let bytes = load(path).map_err(|fault| Located::from(fault).reading(&name))?;
    parse(&bytes).map_err(|located| located.reading(&name))
}

/// Parses such a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Vec<[Rat; 3]>, Located> {
    let mut lines = Lines::new(bytes);
    let mut out = with_room(u64::MAX, bytes.len() / 16, 4);
    while let Some((number, line)) = lines.next_content() {
        out.push(position(tokens(line)).map_err(|f| f.at_line(number))?);
    }
    if out.is_empty() {
        return Err(Fault::NoVertices.into());
    }
    Ok(out)
}
