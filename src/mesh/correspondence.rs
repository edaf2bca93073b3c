//! A file that places every vertex of one surface in a triangle of another.

use std::path::Path;

use super::error::{Fault, Located, MeshError};
use super::format::load;
use super::rational::number;
use super::text::{Lines, coordinate, integer, quote, quote_or_end, tokens, with_room};
use crate::number::{Rat, Rational};

/// A point of a surface: a triangle, and weights on its corners that are not negative and have the sum one.
pub type Place = (u32, [Rat; 3]);

/// Reads `TRIANGLE W0 W1 W2` a line, one line a vertex, in order: the triangle's index from 0, and weights on its
/// corners, each a decimal number (taken as the nearest `f64`) or `NUM/DEN`. Weights are divided by their sum exactly.
///
/// # Errors
/// [`MeshError::Read`] with file, line and reason: a triangle that is not below `triangles`, a negative weight, a sum of zero.
pub fn read_correspondence(path: &Path, triangles: usize) -> Result<Vec<Place>, MeshError> {
    let name = path.to_string_lossy();
    let bytes = load(path).map_err(|fault| Located::from(fault).reading(&name))?;
    parse(&bytes, triangles).map_err(|located| located.reading(&name))
}

pub(super) fn parse(bytes: &[u8], triangles: usize) -> Result<Vec<Place>, Located> {
    let mut lines = Lines::new(bytes);
    let mut out = with_room(0, 0, 1);
    while let Some((number, line)) = lines.next_content() {
        out.push(place(line, triangles).map_err(|f| f.at_line(number))?);
    }
    Ok(out)
}

fn place(line: &[u8], triangles: usize) -> Result<Place, Fault> {
    let mut words = tokens(line);
    let triangle: u32 = integer(words.next(), "a triangle")?;
    if triangle as usize >= triangles {
        return Err(Fault::expected(format!("a triangle below {triangles}"), triangle.to_string()));
    }
    let mut weights = [Rat::ZERO, Rat::ZERO, Rat::ZERO];
    for weight in &mut weights {
        let word = words.next();
        *weight = self::weight(word.ok_or_else(|| Fault::expected("3 weights", quote_or_end(None)))?)?;
    }
    if let Some(more) = words.next() {
        return Err(Fault::expected("a triangle and 3 weights", quote(more)));
    }
    let sum = weights.iter().fold(Rat::ZERO, |sum, w| sum.plus(w));
    if sum.is_zero() {
        return Err(Fault::expected("weights that are not all zero", "0 0 0"));
    }
    Ok((triangle, weights.map(|w| w / &sum)))
}

fn weight(word: &[u8]) -> Result<Rat, Fault> {
    let value = if word.contains(&b'/') {
        number(word)?
    } else {
        let x = coordinate(word, "a weight")?;
        Rational::from_f64(x).ok_or_else(|| Fault::NotFinite(quote(word)))?
    };
    if Rational::sign(&value).is_negative() {
        Err(Fault::expected("a weight >= 0", quote(word)))
    } else {
        Ok(value)
    }
}
