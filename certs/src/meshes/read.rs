//! Input files: complex files (MESHES section 5), OFF and OBJ, and what they hash to.

use super::cells::Cells;
use super::points::Hom;
use crate::input::Files;
use crate::number::{decode, key};
use crate::{Res, input, malformed};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// An input as read.
pub(super) struct Complex {
    pub(super) sha: String,
    pub(super) space: usize,
    pub(super) points: Vec<Hom>,
    pub(super) cells: Cells,
}

const DIGITS: usize = 4000;

/// What the exponents of two of a file may add up to: a short text can stand for a long number.
const EXPONENTS: u64 = 1 << 33;

/// Reads the files of an input list.
pub(super) fn read(files: &Files<'_>, many: usize) -> Res<Vec<Complex>> {
    if files.len() != many {
        return malformed("input", format!("{} input files where {many} are expected", files.len()));
    }
    let named = |i: usize| {
        let file = files.get(i)?;
        let result = if file.starts_with(b"homeo-complex 1\n") { complex(&file) } else { mesh(&file) };
        result.or_else(|why| malformed("input", format!("input file {}: {why}", i + 1)))
    };
    (0..many).map(named).collect()
}

fn hex(sha: Sha256) -> String {
    sha.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// An OFF or OBJ file, hashed as the complex file with the same content.
fn mesh(file: &[u8]) -> Result<Complex, String> {
    let mesh = input::mesh(file)?;
    let mut sha = Sha256::new();
    sha.update(format!("homeo-complex 1\nspace 3\ncorners 3\nvertices {}\n", mesh.points.len()));
    for point in &mesh.points {
        let texts = point.map(|bits| match decode(key(bits)) {
            (mantissa, 0) => mantissa.to_string(),
            (mantissa, exponent) => odd(mantissa, exponent),
        });
        sha.update(texts.join(" "));
        sha.update("\n");
    }
    sha.update(format!("cells {}\n", mesh.triangles.len()));
    for [a, b, c] in &mesh.triangles {
        sha.update(format!("{a} {b} {c}\n"));
    }
    sha.update("end\n");
    let corners = mesh.triangles.into_iter().flatten().map(|v| v as usize).collect();
    let cells = Cells { k: 3, corners, vertices: mesh.points.len() };
    let points = mesh
        .points
        .iter()
        .map(|p| point(p.map(|bits| decode(key(bits))).map(|(m, e)| Number::Dyadic(m.into(), e))))
        .collect();
    Ok(Complex { sha: hex(sha), space: 3, points, cells })
}

fn odd(mantissa: i64, exponent: i64) -> String {
    let mut text = mantissa.to_string();
    let _ = write!(text, "*2^{exponent}"); // a string takes everything
    text
}

enum Number {
    /// An odd number or zero, times two to a power.
    Dyadic(BigInt, i64),
    Fraction(BigInt, BigInt),
}

/// A point with its smallest denominator.
fn point(numbers: [Number; 3]) -> Hom {
    let denominator = |n: &Number| match n {
        Number::Dyadic(_, e) => BigInt::one() << (-*e).max(0),
        Number::Fraction(_, denominator) => denominator.clone(),
    };
    let w = numbers.iter().map(denominator).fold(BigInt::one(), |w, d| w.lcm(&d));
    let x = numbers.map(|number| match number {
        Number::Dyadic(odd, e) if e >= 0 => (odd << e) * &w,
        Number::Dyadic(odd, e) => odd * (&w >> -e),
        Number::Fraction(numerator, denominator) => numerator * (&w / denominator),
    });
    Hom { x, w }
}

fn is_number(text: &str) -> bool {
    text == "0" || (!text.starts_with('0') && !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()))
}

fn id(text: &str) -> Result<usize, String> {
    let id = Some(text).filter(|t| is_number(t) && t.len() <= 10).and_then(|t| t.parse().ok());
    id.ok_or_else(|| "a word is no index or count".into())
}

/// A natural number above zero.
fn natural(text: &str) -> Result<BigInt, String> {
    let number =
        Some(text).filter(|t| is_number(t) && *t != "0" && t.len() <= DIGITS).and_then(|t| t.parse().ok());
    number.ok_or_else(|| "a number is not written as it must be, or longer than 4000 digits".into())
}

fn number(text: &str) -> Result<Number, String> {
    if text == "0" {
        return Ok(Number::Dyadic(BigInt::ZERO, 0));
    }
    let body = text.strip_prefix('-').unwrap_or(text);
    let signed = |n: BigInt| if body.len() < text.len() { -n } else { n };
    if let Some((numerator, denominator)) = body.split_once('/') {
        let (n, d) = (natural(numerator)?, natural(denominator)?);
        let power_of_two = d.trailing_zeros().is_some_and(|zeros| zeros + 1 == d.bits());
        if power_of_two || !n.gcd(&d).is_one() {
            return Err("a fraction is not in lowest terms, or its denominator is a power of two".into());
        }
        return Ok(Number::Fraction(signed(n), d));
    }
    let (odd, exponent) = match body.split_once("*2^") {
        Some((odd, exponent)) => {
            let digits = exponent.strip_prefix('-').unwrap_or(exponent);
            if !is_number(digits) || digits == "0" || digits.len() > 5 {
                return Err("an exponent is not written as it must be".into());
            }
            (odd, exponent.parse().map_err(|_| "an exponent is no number")?)
        }
        None => (body, 0),
    };
    let odd = natural(odd)?;
    if odd.is_even() {
        return Err("a number before a power of two is even".into());
    }
    Ok(Number::Dyadic(signed(odd), exponent))
}

struct Lines<'a> {
    rest: &'a str,
    at: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<&'a str, String> {
        self.at += 1;
        let (line, rest) = self.rest.split_once('\n').ok_or("the file ends early")?;
        self.rest = rest;
        Ok(line)
    }

    fn here<T>(&self, result: Result<T, String>) -> Result<T, String> {
        result.map_err(|why| format!("line {}: {why}", self.at))
    }

    /// The number of a line `word number`.
    fn stated(&mut self, word: &str) -> Result<usize, String> {
        let line = self.next()?;
        let number = line.strip_prefix(word).and_then(|rest| rest.strip_prefix(' ')).unwrap_or("");
        self.here(id(number))
    }

    /// The next line's tokens, which must be `n`.
    fn tokens(&mut self, n: usize) -> Result<impl Iterator<Item = &'a str> + use<'a>, String> {
        let line = self.next()?;
        let many = line.split(' ').count();
        self.here(if many == n { Ok(line.split(' ')) } else { Err(format!("{many} words in place of {n}")) })
    }
}

fn complex(file: &[u8]) -> Result<Complex, String> {
    let text = std::str::from_utf8(file).map_err(|_| "a byte is not ASCII")?;
    let mut lines = Lines { rest: text, at: 0 };
    lines.next()?;
    let (space, k) = (lines.stated("space")?, lines.stated("corners")?);
    if ![(2, 3), (3, 3), (3, 4)].contains(&(space, k)) {
        return Err("not triangles in the plane, triangles in space, or tets".into());
    }
    let vertices = lines.stated("vertices")?;
    if vertices == 0 {
        return Err("no vertex".into());
    }
    let (mut points, mut exponents) = (Vec::new(), 0_u64);
    for _ in 0..vertices {
        let mut numbers = [const { Number::Dyadic(BigInt::ZERO, 0) }; 3];
        for (slot, token) in numbers.iter_mut().zip(lines.tokens(space)?) {
            *slot = lines.here(number(token))?;
            if let Number::Dyadic(_, e) = slot {
                exponents += e.unsigned_abs();
            }
        }
        if exponents > EXPONENTS {
            return Err(format!("line {}: the exponents are too large together", lines.at));
        }
        points.push(point(numbers));
    }
    let mut corners = Vec::new();
    for _ in 0..lines.stated("cells")? {
        for token in lines.tokens(k)? {
            let id = lines.here(id(token))?;
            if id >= vertices {
                return Err(format!("line {}: vertex {id} is out of range", lines.at));
            }
            corners.push(id);
        }
    }
    if lines.next()? != "end" || !lines.rest.is_empty() {
        return Err(format!("line {}: not the end", lines.at));
    }
    let mut sha = Sha256::new();
    sha.update(file);
    Ok(Complex { sha: hex(sha), space, points, cells: Cells { k, corners, vertices } })
}
