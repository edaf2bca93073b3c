//! The input files: which are given, OFF and OBJ meshes, and what a shell and a mesh hash to.

use crate::{Fail, LIMIT, Res, hdf5, load, malformed};
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::path::Path;

/// A point as the bits of three finite doubles.
pub(crate) type Bits = [u64; 3];

/// A triangle mesh as read; indices are in range, coordinates finite.
#[derive(Default)]
pub(crate) struct Mesh {
    pub(crate) points: Vec<Bits>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Bottom, middle and top points, and the prisms.
pub(crate) struct Shell {
    pub(crate) layers: [Vec<Bits>; 3],
    pub(crate) prisms: Vec<[u32; 3]>,
}

/// The input files, which are read one by one.
pub(crate) enum Files<'a> {
    Memory(&'a [Vec<u8>]),
    Paths(Vec<&'a Path>),
}

impl Files<'_> {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Memory(files) => files.len(),
            Self::Paths(paths) => paths.len(),
        }
    }

    /// The bytes of a file.
    pub(crate) fn get(&self, i: usize) -> Res<Cow<'_, [u8]>> {
        let bytes = match self {
            Self::Memory(files) => Cow::Borrowed(&files[i][..]),
            Self::Paths(paths) => Cow::Owned(load(paths[i], "input")?),
        };
        if bytes.len() > LIMIT {
            return malformed("input", format!("input file {} is larger than 2^30 bytes", i + 1));
        }
        Ok(bytes)
    }
}

/// Reads the one to four files; the mesh that an HDF5 shell holds is read only when it is needed.
pub(crate) fn read(files: &Files<'_>, need_mesh: bool) -> Res<(Shell, Option<Mesh>)> {
    let wrong = |i: usize, why: String| bad("input", format!("input file {}: {why}", i + 1));
    let named = |i: usize| mesh(&files.get(i)?).map_err(|why| wrong(i, why));
    let both = match files.len() {
        1 | 2 => {
            let own = files.len() == 1 && need_mesh;
            let (shell, own) = hdf5::shell(&files.get(0)?, own).map_err(|why| wrong(0, why))?;
            (shell, if files.len() == 2 { Some(named(1)?) } else { own })
        }
        3 | 4 => {
            let b = named(0)?;
            let layer = |i: usize| {
                let mesh = named(i)?;
                match mesh.triangles == b.triangles && mesh.points.len() == b.points.len() {
                    true => Ok(mesh.points),
                    false => malformed("input", "the three layers differ in connectivity"),
                }
            };
            let (m, t) = (layer(1)?, layer(2)?);
            let shell = Shell { layers: [b.points, m, t], prisms: b.triangles };
            (shell, if files.len() == 4 { Some(named(3)?) } else { None })
        }
        n => return malformed("input", format!("{n} input files where one to four are expected")),
    };
    match both {
        (_, None) if need_mesh => malformed("input", "the claims need a mesh"),
        both => Ok(both),
    }
}

fn bad(code: &'static str, message: String) -> Fail {
    Fail { exit: 2, code, message }
}

/// SHA-256 of points and triangles in lower-case hex.
pub(crate) fn hash(layers: &[&[Bits]], triangles: &[[u32; 3]]) -> String {
    let mut sha = Sha256::new();
    for bits in layers.iter().flat_map(|points| points.iter().flatten()) {
        sha.update(bits.to_le_bytes());
    }
    for &id in triangles.iter().flatten() {
        sha.update(id.to_le_bytes());
    }
    sha.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Refuses what no mesh may have.
pub(crate) fn validate(points: &[Bits], triangles: &[[u32; 3]]) -> Result<(), String> {
    if points.is_empty() {
        return Err("no vertex".into());
    }
    if let Some(i) = points.iter().position(|p| p.iter().any(|bits| bits >> 52 & 0x7ff == 0x7ff)) {
        return Err(format!("vertex {i} has a coordinate that is not finite"));
    }
    match triangles.iter().position(|t| t.iter().any(|&v| v as usize >= points.len())) {
        Some(i) => Err(format!("triangle {i} has an index out of range")),
        None => Ok(()),
    }
}

fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\x0c' | b'\r')
}

fn tokens(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(|&b| is_space(b)).filter(|t| !t.is_empty())
}

/// An OFF or OBJ file.
pub(crate) fn mesh(text: &[u8]) -> Result<Mesh, String> {
    let first = text.split(|&b| b == b'\n').map(uncomment).find_map(|line| tokens(line).next());
    let mesh = if first.is_some_and(|t| t.starts_with(b"OFF")) { off(text)? } else { obj(text)? };
    validate(&mesh.points, &mesh.triangles)?;
    Ok(mesh)
}

fn uncomment(line: &[u8]) -> &[u8] {
    line.split(|&b| b == b'#').next().unwrap_or(line)
}

fn off(text: &[u8]) -> Result<Mesh, String> {
    let mut lines = text.split(|&b| b == b'\n').map(uncomment);
    let mut line: &[u8] = b""; // the rest of the current line
    let mut next = |skip: bool| -> Result<&[u8], String> {
        if skip {
            line = b"";
            return Ok(b"");
        }
        loop {
            if let Some(start) = line.iter().position(|&b| !is_space(b)) {
                let rest = &line[start..];
                let (word, rest) =
                    rest.split_at(rest.iter().position(|&b| is_space(b)).unwrap_or(rest.len()));
                line = rest;
                return Ok(word);
            }
            line = lines.next().ok_or("the file ends early")?;
        }
    };
    if next(false)? != b"OFF" {
        return Err("the first word is not OFF".into());
    }
    let mut counts = [0; 2];
    for count in &mut counts {
        let word = next(false)?;
        *count = index(word)? as usize;
        if word.len() > 10 || (word.len() > 1 && word.starts_with(b"0")) {
            return Err("a count has more than ten digits or leading zeros".into());
        }
    }
    if !next(false)?.iter().all(u8::is_ascii_digit) {
        return Err("the number of edges is no number".into());
    }
    let mut mesh = Mesh::default();
    // A vertex has at least six bytes, a face eight.
    mesh.points.reserve_exact(counts[0].min(text.len() / 6));
    mesh.triangles.reserve_exact(counts[1].min(text.len() / 8));
    for _ in 0..counts[0] {
        mesh.points.push([real(next(false)?)?, real(next(false)?)?, real(next(false)?)?]);
    }
    for face in 0..counts[1] {
        if next(false)? != b"3" {
            return Err(format!("face {face} is not a triangle"));
        }
        mesh.triangles.push([index(next(false)?)?, index(next(false)?)?, index(next(false)?)?]);
        next(true)?;
    }
    Ok(mesh)
}

fn obj(text: &[u8]) -> Result<Mesh, String> {
    let mut mesh = Mesh::default();
    for (number, line) in text.split(|&b| b == b'\n').enumerate() {
        let fail = |why: &str| format!("line {}: {why}", number + 1);
        let mut words = tokens(line);
        match words.next() {
            Some(b"v") => {
                let mut coordinate = || real(words.next().unwrap_or(b"")).map_err(|why| fail(&why));
                mesh.points.push([coordinate()?, coordinate()?, coordinate()?]);
            }
            Some(b"f") => {
                let mut corner = || {
                    let word = words.next().unwrap_or(b"").split(|&b| b == b'/').next().unwrap_or(b"");
                    let id = index(word).map_err(|why| fail(&why))?;
                    id.checked_sub(1).ok_or_else(|| fail("an index is not positive"))
                };
                mesh.triangles.push([corner()?, corner()?, corner()?]);
                if words.next().is_some() {
                    return Err(fail("a face is not a triangle"));
                }
            }
            _ => {}
        }
    }
    Ok(mesh)
}

fn index(word: &[u8]) -> Result<u32, String> {
    let text = std::str::from_utf8(word).unwrap_or("");
    match text.parse() {
        Ok(value) if word.iter().all(u8::is_ascii_digit) => Ok(value),
        _ => Err("a word is not an index or count, or too large".into()),
    }
}

/// `[+-]?digits[.digits][e[+-]digits]`, rounded to the nearest double.
fn real(word: &[u8]) -> Result<u64, String> {
    let digits = |part: &[u8]| part.iter().all(u8::is_ascii_digit);
    let unsigned = |part: &'_ [u8]| usize::from(matches!(part.first(), Some(b'+' | b'-')));
    let body = &word[unsigned(word)..];
    let (mantissa, exponent) = match body.iter().position(|b| matches!(b, b'e' | b'E')) {
        Some(at) => (&body[..at], Some(&body[at + 1..])),
        None => (body, None),
    };
    let (whole, part) = match mantissa.iter().position(|&b| b == b'.') {
        Some(at) => (&mantissa[..at], &mantissa[at + 1..]),
        None => (mantissa, &mantissa[..0]),
    };
    let tail = exponent.map(|e| &e[unsigned(e)..]);
    let fits = digits(whole) && digits(part) && (whole.len() + part.len() > 0);
    match std::str::from_utf8(word).unwrap_or("").parse::<f64>() {
        Ok(value) if fits && tail.is_none_or(|e| !e.is_empty() && digits(e)) => Ok(value.to_bits()),
        _ => Err("a word is not a number".into()),
    }
}
