//! Wavefront OBJ: `v` and `f`; everything that is not geometry is skipped.

use super::TriMesh;
use super::error::{Fault, Located};
use super::text::{
    Builder, Lines, before_comment, coordinate, coordinates, integer, quote, quote_or_end, tokens,
};
use super::uv::UvMesh;
use std::borrow::Cow;

/// Statements that say nothing about where the surface is.
const IGNORED: [&str; 21] = [
    "vt",
    "vn",
    "vp",
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "vc",
    "mat",
];

/// Statements that hold geometry which would be lost.
const UNSUPPORTED: [&str; 20] = [
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
    "con", "call", "csh", "bsp", "bzp", "cdc", "cdp",
];

/// A face that names a vertex before it is defined: its line, the index as written and from 0.
struct Forward {
    line: usize,
    written: i64,
    index: u64,
}

/// Parses a file. Columns after the coordinates (weight, colour) are ignored and noted.
pub(super) fn parse(bytes: &[u8]) -> Result<(TriMesh, Vec<String>), Located> {
    Reader::default().read(bytes)?.finish()
}

/// Parses a file with a texture coordinate at every corner.
pub(super) fn parse_uv(bytes: &[u8]) -> Result<UvMesh, Located> {
    let mut reader = Reader { texture: Some(Texture::default()), ..Reader::default() }.read(bytes)?;
    let Texture { uv, builder, forward, .. } = reader.texture.take().unwrap_or_default();
    let known = u64::try_from(uv.len()).unwrap_or(u64::MAX);
    if let Some(f) = forward.iter().find(|f| f.index >= known) {
        return Err(no_texture(f.written, known).at_line(f.line));
    }
    let (mesh, notes) = reader.finish()?;
    Ok(UvMesh { mesh, uv, uv_faces: builder.mesh.faces, notes })
}

fn no_texture(written: i64, known: u64) -> Fault {
    Fault::expected(format!("one of {known} texture coordinates"), written.to_string())
}

/// Texture coordinates, where they are wanted.
#[derive(Default)]
struct Texture {
    uv: Vec<[f64; 2]>,
    /// Collects triangles as the other builder does, of indices into `uv`.
    builder: Builder,
    corners: Vec<u32>,
    forward: Vec<Forward>,
}

impl Texture {
    fn coordinate<'t>(&mut self, mut words: impl Iterator<Item = &'t [u8]>) -> Result<(), Fault> {
        let mut uv = [0.0; 2];
        for x in &mut uv {
            let word = words.next();
            *x = coordinate(word.ok_or_else(|| Fault::expected("u and v", quote_or_end(None)))?, "u and v")?;
        }
        self.uv.push(uv);
        Ok(())
    }

    fn corner(&mut self, line: usize, word: &[u8]) -> Result<(), Fault> {
        let bad = || Fault::expected("a face corner with a texture coordinate", quote(word));
        let written: i64 = integer(word.split(|&b| b == b'/').nth(1), "").map_err(|_| bad())?;
        let known = u64::try_from(self.uv.len()).unwrap_or(u64::MAX);
        let index = if written > 0 {
            written.unsigned_abs().checked_sub(1)
        } else {
            known.checked_sub(written.unsigned_abs()).filter(|_| written < 0)
        };
        let index = index.ok_or_else(|| no_texture(written, known))?;
        if index >= known {
            self.forward.push(Forward { line, written, index });
        }
        self.corners.push(u32::try_from(index).map_err(|_| no_texture(written, known))?);
        Ok(())
    }
}

/// The next line, joined with those after it while it ends in a backslash. A comment is not
/// continued: a path that ends in a backslash must not swallow the statement below.
pub(super) fn next_logical<'a>(lines: &mut Lines<'a>) -> Option<(usize, Cow<'a, [u8]>)> {
    let (number, line) = lines.next()?;
    let continued = |l: &[u8]| l.trim_ascii_end().last() == Some(&b'\\');
    if !continued(line) || line.contains(&b'#') {
        return Some((number, Cow::Borrowed(line)));
    }
    let mut joined = Vec::new();
    let mut part = line;
    loop {
        let trimmed = part.trim_ascii_end();
        let Some(body) = trimmed.strip_suffix(b"\\") else {
            joined.extend_from_slice(part);
            break;
        };
        joined.extend_from_slice(body);
        joined.push(b' ');
        match lines.next() {
            Some((_, next)) => part = next,
            None => break,
        }
    }
    Some((number, Cow::Owned(joined)))
}

#[derive(Default)]
struct Reader {
    builder: Builder,
    corners: Vec<u32>,
    forward: Vec<Forward>,
    lines_and_points: u64,
    texture: Option<Texture>,
}

impl Reader {
    fn read(mut self, bytes: &[u8]) -> Result<Self, Located> {
        let mut lines = Lines::new(bytes);
        while let Some((number, line)) = next_logical(&mut lines) {
            self.statement(number, before_comment(&line)).map_err(|f| f.at_line(number))?;
        }
        Ok(self)
    }

    fn statement(&mut self, number: usize, line: &[u8]) -> Result<(), Fault> {
        let mut words = tokens(line);
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        match keyword {
            b"v" => {
                self.builder.mesh.vertices.push(coordinates(&mut words)?);
                if words.next().is_some() {
                    self.builder.extra_column();
                }
            }
            b"f" | b"fo" => {
                self.corners.clear();
                for word in words {
                    let corner = self.corner(number, word)?;
                    self.corners.push(corner);
                    if let Some(texture) = &mut self.texture {
                        texture.corner(number, word)?;
                    }
                }
                self.builder.polygon(&self.corners)?;
                if let Some(texture) = &mut self.texture {
                    texture.builder.polygon(&std::mem::take(&mut texture.corners))?;
                }
            }
            b"vt" if self.texture.is_some() => {
                self.texture.iter_mut().try_for_each(|t| t.coordinate(&mut words))?;
            }
            b"l" | b"p" => self.lines_and_points += 1,
            other => match std::str::from_utf8(other) {
                Ok(word) if IGNORED.contains(&word) => {}
                Ok(word) if UNSUPPORTED.contains(&word) => {
                    return Err(Fault::Unsupported(format!("the statement {}", quote(other))));
                }
                _ => return Err(Fault::expected("an OBJ statement", quote(other))),
            },
        }
        Ok(())
    }

    /// Reads `v`, `v/vt`, `v//vn` or `v/vt/vn`; negative numbers count back from the last vertex.
    fn corner(&mut self, line: usize, word: &[u8]) -> Result<u32, Fault> {
        let bad = || Fault::expected("a face corner", quote(word));
        let mut parts = word.split(|&b| b == b'/');
        let written: i64 = integer(parts.next(), "").map_err(|_| bad())?;
        for other in parts.by_ref().take(2).filter(|p| !p.is_empty()) {
            integer::<i64>(Some(other), "").map_err(|_| bad())?;
        }
        if parts.next().is_some() {
            return Err(bad());
        }
        let known = u64::try_from(self.builder.mesh.vertices.len()).unwrap_or(u64::MAX);
        let out = || Fault::IndexOutOfRange { index: written.to_string(), vertices: known };
        let index = match written {
            0 => None,
            1.. => written.unsigned_abs().checked_sub(1),
            _ => known.checked_sub(written.unsigned_abs()),
        };
        let index = index.ok_or_else(out)?;
        if index >= known {
            self.forward.push(Forward { line, written, index });
        }
        u32::try_from(index).map_err(|_| out())
    }

    fn finish(mut self) -> Result<(TriMesh, Vec<String>), Located> {
        let vertices = u64::try_from(self.builder.mesh.vertices.len()).unwrap_or(u64::MAX);
        if vertices > u64::from(u32::MAX) {
            return Err(Fault::TooMany { what: "vertices".to_owned(), count: vertices }.into());
        }
        if let Some(f) = self.forward.iter().find(|f| f.index >= vertices) {
            return Err(Fault::IndexOutOfRange { index: f.written.to_string(), vertices }.at_line(f.line));
        }
        if self.lines_and_points > 0 {
            let note = format!("OBJ: ignored {} lines and points", self.lines_and_points);
            self.builder.notes.push(note);
        }
        Ok(self.builder.finish("OBJ")?)
    }
}
