//! Lines, tokens and numbers of the text formats.

use super::TriMesh;
use super::error::Fault;

/// Longest piece of a file that an error repeats.
const QUOTE: usize = 32;

/// The lines of a byte string: ended by LF, CR LF or CR, counted from 1.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, number: 0 }
    }

    /// Number of the line that was returned last.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// What has not been returned yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// The next line with something other than white space after `#` comments are cut.
    pub(super) fn next_content(&mut self) -> Option<(usize, &'a [u8])> {
        for (number, line) in self.by_ref() {
            let line = before_comment(line);
            if !line.trim_ascii().is_empty() {
                return Some((number, line));
            }
        }
        None
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        self.number = self.number.saturating_add(1);
        let Some(end) = self.rest.iter().position(|&b| b == b'\n' || b == b'\r') else {
            return Some((self.number, std::mem::take(&mut self.rest)));
        };
        let (line, tail) = self.rest.split_at(end);
        self.rest = tail.strip_prefix(b"\r\n").or_else(|| tail.get(1..)).unwrap_or_default();
        Some((self.number, line))
    }
}

/// The part of a line before `#`.
pub(super) fn before_comment(line: &[u8]) -> &[u8] {
    line.split(|&b| b == b'#').next().unwrap_or(line)
}

/// White-space separated tokens.
pub(super) fn tokens(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|t| !t.is_empty())
}

/// A piece of the file in quotes, shortened and escaped so that errors stay on one line.
pub(super) fn quote(token: &[u8]) -> String {
    let shown = token.get(..QUOTE).unwrap_or(token);
    let dots = if shown.len() < token.len() { "..." } else { "" };
    format!("\"{}{dots}\"", shown.escape_ascii())
}

/// As [`quote`], and "the end of the line" for nothing.
pub(super) fn quote_or_end(token: Option<&[u8]>) -> String {
    token.map_or_else(|| "the end of the line".to_owned(), quote)
}

/// A finite number, rounded correctly to `f64`.
pub(super) fn coordinate(token: &[u8], expected: &str) -> Result<f64, Fault> {
    let value = std::str::from_utf8(token).ok().and_then(|t| t.parse::<f64>().ok());
    match value {
        None => Err(Fault::expected(expected, quote(token))),
        Some(x) if x.is_finite() => Ok(x),
        Some(_) => Err(Fault::NotFinite(quote(token))),
    }
}

/// The next three tokens as coordinates.
pub(super) fn coordinates(tokens: &mut dyn Iterator<Item = &[u8]>) -> Result<[f64; 3], Fault> {
    let mut point = [0.0; 3];
    for x in &mut point {
        let Some(token) = tokens.next() else {
            return Err(Fault::expected("3 coordinates", quote_or_end(None)));
        };
        *x = coordinate(token, "3 coordinates")?;
    }
    Ok(point)
}

/// A decimal integer.
pub(super) fn integer<T: std::str::FromStr>(token: Option<&[u8]>, expected: &str) -> Result<T, Fault> {
    token
        .and_then(|t| std::str::from_utf8(t).ok())
        .and_then(|t| t.parse().ok())
        .ok_or_else(|| Fault::expected(expected, quote_or_end(token)))
}

/// A vertex index of a format that counts from 0.
pub(super) fn index(token: Option<&[u8]>, vertices: u64) -> Result<u32, Fault> {
    let value: i128 = integer(token, "a vertex index")?;
    match u32::try_from(value) {
        Ok(i) if u64::from(i) < vertices => Ok(i),
        _ => Err(Fault::IndexOutOfRange { index: value.to_string(), vertices }),
    }
}

/// A mesh under construction, and what its reader has to tell about it.
#[derive(Default)]
pub(super) struct Builder {
    pub(super) mesh: TriMesh,
    pub(super) notes: Vec<String>,
    polygons: u64,
    extra_columns: u64,
}

impl Builder {
    /// Adds a polygon as the fan from its first corner.
    pub(super) fn polygon(&mut self, corners: &[u32]) -> Result<(), Fault> {
        let [first, rest @ ..] = corners else {
            return Err(Fault::FewCorners(0));
        };
        if rest.len() < 2 {
            return Err(Fault::FewCorners(u64::try_from(corners.len()).unwrap_or(u64::MAX)));
        }
        self.polygons += u64::from(rest.len() > 2);
        self.mesh.faces.extend(rest.windows(2).filter_map(|w| match w {
            [b, c] => Some([*first, *b, *c]),
            _ => None,
        }));
        Ok(())
    }

    /// Remembers that a vertex had more than coordinates.
    pub(super) fn extra_column(&mut self) {
        self.extra_columns += 1;
    }

    /// The mesh and its notes, each beginning with the format's name.
    pub(super) fn finish(mut self, format: &str) -> Result<(TriMesh, Vec<String>), Fault> {
        if self.mesh.vertices.is_empty() {
            return Err(Fault::NoVertices);
        }
        if self.polygons > 0 {
            self.notes.push(format!("{format}: {} polygons fan-triangulated", self.polygons));
        }
        if self.extra_columns > 0 {
            self.notes.push(format!("{format}: ignored extra columns of {} vertices", self.extra_columns));
        }
        Ok((self.mesh, self.notes))
    }
}

/// A vector with room for `count` elements, but never more than `bytes` of file can hold.
pub(super) fn with_room<T>(count: u64, bytes: usize, bytes_each: usize) -> Vec<T> {
    let fits = bytes / bytes_each.max(1);
    Vec::with_capacity(usize::try_from(count).unwrap_or(fits).min(fits))
}
