//! One line's tokens. Syntax errors come at once; digits and ranges are judged when the line is finished.

use crate::{Res, fail, malformed};
use num_bigint::BigInt;
use num_traits::Zero;
use std::borrow::Cow;
use std::cell::Cell;

/// A tet as its four names, ascending. A shell point's name `(id, layer)` is the number `3 id + layer`.
pub(crate) type Names4 = [usize; 4];

/// A plane as written. A point is a shell point's name, or the number of all such names plus a mesh vertex.
#[derive(Clone, Copy)]
pub(crate) enum Plane {
    Through([usize; 3]),
    Line([usize; 2]),
    Normal([usize; 2]),
}

impl Plane {
    pub(crate) fn points(&self) -> &[usize] {
        match self {
            Self::Through(points) => points,
            Self::Line(points) | Self::Normal(points) => points,
        }
    }
}

/// `odd * 2^exp` with `odd` odd, or zero with `exp = 0`.
#[derive(PartialEq, Eq)]
pub(crate) struct Value {
    pub(crate) odd: BigInt,
    pub(crate) exp: i64,
}

impl Value {
    pub(crate) fn new(number: &BigInt, exp: i64) -> Self {
        let zeros = number.trailing_zeros().unwrap_or(0);
        let exp = if number.is_zero() { 0 } else { exp + zeros.cast_signed() };
        Self { odd: number >> zeros, exp }
    }
}

/// How many there are of each kind of thing.
#[derive(Clone, Copy, Default)]
pub(crate) struct Bounds {
    pub(crate) shell: usize,
    pub(crate) prisms: usize,
    pub(crate) mesh: usize,
    pub(crate) triangles: usize,
    /// `v` lines.
    pub(crate) corners: usize,
}

pub(crate) struct Line<'a> {
    pub(crate) at: usize,
    pub(crate) bounds: Bounds,
    pub(crate) text: Cow<'a, str>,
    /// Where the next token begins; behind the end when there is none.
    next: Cell<usize>,
    too_long: Cell<bool>,
    out_of_range: Cell<Option<usize>>,
}

/// `0|[1-9][0-9]*`.
fn is_number(text: &str) -> bool {
    text == "0" || (!text.starts_with('0') && !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()))
}

impl<'a> Line<'a> {
    pub(crate) fn new(text: impl Into<Cow<'a, str>>, at: usize, bounds: Bounds) -> Self {
        let (next, too_long, out_of_range) = Default::default();
        Self { at, bounds, text: text.into(), next, too_long, out_of_range }
    }

    pub(crate) fn syntax<T>(&self) -> Res<T> {
        malformed("syntax", format!("line {} does not fit the grammar", self.at))
    }

    pub(crate) fn require(&self, ok: bool) -> Res {
        if ok { Ok(()) } else { self.syntax() }
    }

    pub(crate) fn next(&self) -> Res<&str> {
        let Some(rest) = self.text.get(self.next.get()..) else { return self.syntax() };
        let token = rest.bytes().position(|b| b == b' ').map_or(rest, |end| &rest[..end]);
        self.next.set(self.next.get() + token.len() + 1);
        Ok(token)
    }

    pub(crate) fn more(&self) -> bool {
        self.next.get() <= self.text.len()
    }

    pub(crate) fn expect(&self, word: &str) -> Res {
        let token = self.next()?;
        self.require(token == word)
    }

    /// Nothing may be left; then the digits, then the ranges are judged.
    pub(crate) fn finish(&self) -> Res {
        let left = self.more();
        self.require(!left)?;
        if self.too_long.get() {
            return fail(3, "digits", format!("line {}: a number has more than 4000 digits", self.at));
        }
        match self.out_of_range.get() {
            Some(id) => malformed("range", format!("line {}: {id} is out of range", self.at)),
            None => Ok(()),
        }
    }

    pub(crate) fn id_in(&self, text: &str, bound: usize) -> Res<usize> {
        match text.parse() {
            Ok(id) if is_number(text) && text.len() <= 10 => {
                if id >= bound {
                    self.out_of_range.set(self.out_of_range.get().or(Some(id)));
                }
                Ok(id)
            }
            _ => self.syntax(),
        }
    }

    /// A SHA-256 in lower-case hex.
    pub(crate) fn sha(&self) -> Res<String> {
        let sha = self.next()?;
        self.require(sha.len() == 64 && sha.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f')))?;
        Ok(sha.to_owned())
    }

    /// An id that must be below `bound`.
    pub(crate) fn id(&self, bound: usize) -> Res<usize> {
        let token = self.next()?;
        self.id_in(token, bound)
    }

    /// Adds all ids that are left, at least one, none twice; how many they are.
    pub(crate) fn distinct_ids(&self, bound: usize, list: &mut Vec<usize>) -> Res<usize> {
        let start = list.len();
        list.push(self.id(bound)?);
        while self.more() {
            list.push(self.id(bound)?);
        }
        let ids = &list[start..];
        let few = ids.len() < 9;
        let once = few && (1..ids.len()).all(|i| !ids[..i].contains(&ids[i]));
        self.require(once || !few && crate::complex::distinct(ids.iter().copied()).len() == ids.len())?;
        Ok(ids.len())
    }

    /// Adds what a token has between commas, which must be ascending; how many they are.
    fn ascending(&self, list: &mut Vec<usize>, read: impl Fn(&str) -> Res<usize>) -> Res<usize> {
        let (mut token, start) = (self.next()?, list.len());
        while let Some(end) = token.bytes().position(|b| b == b',') {
            list.push(read(&token[..end])?);
            token = &token[end + 1..];
        }
        list.push(read(token)?);
        self.require(list[start..].is_sorted_by(|a, b| a < b))?;
        Ok(list.len() - start)
    }

    /// Adds one to three mesh vertices, ascending.
    pub(crate) fn mesh_ids(&self, list: &mut Vec<usize>) -> Res {
        let many = self.ascending(list, |text| self.id_in(text, self.bounds.mesh))?;
        self.require(many <= 3)
    }

    fn name(&self, text: &str) -> Res<usize> {
        let layer = match text.as_bytes().first() {
            Some(b'b') => 0,
            Some(b'm') => 1,
            Some(b't') => 2,
            _ => return self.syntax(),
        };
        Ok(3 * self.id_in(&text[1..], self.bounds.shell)? + layer)
    }

    /// Adds one or more names, ascending.
    pub(crate) fn add_names(&self, list: &mut Vec<usize>) -> Res {
        self.ascending(list, |text| self.name(text)).map(drop)
    }

    /// One or more names, ascending.
    pub(crate) fn names(&self) -> Res<Vec<usize>> {
        let mut names = Vec::new();
        self.add_names(&mut names)?;
        Ok(names)
    }

    pub(crate) fn tet(&self) -> Res<Names4> {
        let names = self.names()?;
        names.try_into().or_else(|_| self.syntax())
    }

    fn big(&self, text: &str) -> Res<BigInt> {
        self.require(is_number(text))?;
        if text.len() > 4000 {
            self.too_long.set(true);
            return Ok(BigInt::from(1));
        }
        text.parse().or_else(|_| self.syntax())
    }

    pub(crate) fn value(&self) -> Res<Value> {
        let token = self.next()?;
        if token == "0" {
            return Ok(Value { odd: BigInt::zero(), exp: 0 });
        }
        let (body, exp) = match token.split_once("*2^") {
            Some((body, exp)) => {
                let digits = exp.strip_prefix('-').unwrap_or(exp);
                self.require(is_number(digits) && digits != "0" && digits.len() <= 5)?;
                (body, exp.parse().or_else(|_| self.syntax())?)
            }
            None => (token, 0),
        };
        let digits = body.strip_prefix('-').unwrap_or(body);
        let odd = self.big(digits)?;
        self.require(digits.ends_with(['1', '3', '5', '7', '9']))?;
        Ok(Value { odd: if digits.len() < body.len() { -odd } else { odd }, exp })
    }

    /// An `ID` (`INT` if `negative` is allowed) of the `topology` line.
    pub(crate) fn signed(&self, negative: bool) -> Res<i128> {
        let token = self.next()?;
        let digits = if negative { token.strip_prefix('-').unwrap_or(token) } else { token };
        self.require(is_number(digits) && digits.len() <= 10 && (digits != "0" || token == "0"))?;
        token.parse().or_else(|_| self.syntax())
    }

    pub(crate) fn plane(&self) -> Res<Plane> {
        let token = self.next()?;
        let Some((kind, points)) = token.split_once(':') else { return self.syntax() };
        let points = points.split(',').map(|t| self.point(t)).collect::<Res<Vec<_>>>()?;
        match (kind, points.as_slice()) {
            ("p", &[a, b, c]) => Ok(Plane::Through([a, b, c])),
            ("l", &[a, b]) => Ok(Plane::Line([a, b])),
            ("n", &[a, b]) => Ok(Plane::Normal([a, b])),
            _ => self.syntax(),
        }
    }

    fn point(&self, text: &str) -> Res<usize> {
        match text.strip_prefix('g') {
            Some(id) => Ok(3 * self.bounds.shell + self.id_in(id, self.bounds.mesh)?),
            None => self.name(text),
        }
    }
}

/// `n` weights, not all zero.
pub(crate) fn weights(line: &Line<'_>, n: usize) -> Res<Vec<BigInt>> {
    let mut out = Vec::new();
    for _ in 0..n {
        let token = line.next()?;
        out.push(line.big(token)?);
    }
    line.require(out.iter().any(|w| !w.is_zero()))?;
    Ok(out)
}
