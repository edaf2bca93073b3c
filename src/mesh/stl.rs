//! STL, text and binary: a soup of triangles. Corners whose coordinates are equal as numbers (so
//! +0 and -0 are equal) become one vertex; vertices are numbered by first occurrence and keep the
//! bits of that occurrence. Stored normals are ignored.

use super::TriMesh;
use super::error::{Fault, Located};
use super::text::{Lines, coordinates, quote, quote_or_end, tokens, with_room};
use std::collections::HashMap;

const HEADER: usize = 84;
const RECORD: usize = 50;

/// Whether the length is exactly what a binary file's own count asks for.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    count(bytes).is_some_and(|n| u64::try_from(bytes.len()).is_ok_and(|len| len == file_size(n)))
}

fn count(bytes: &[u8]) -> Option<u32> {
    bytes.get(80..HEADER)?.try_into().ok().map(u32::from_le_bytes)
}

fn file_size(facets: u32) -> u64 {
    HEADER as u64 + RECORD as u64 * u64::from(facets)
}

/// Parses a binary file, whose size must be exactly what its count says.
pub(super) fn parse_binary(bytes: &[u8]) -> Result<(TriMesh, Vec<String>), Located> {
    let size = format!("{} bytes", bytes.len());
    let Some(facets) = count(bytes) else {
        return Err(Fault::expected("a binary STL of 84 bytes or more, or the word solid", size).into());
    };
    if !is_binary(bytes) {
        let expected = format!("{} bytes for a binary STL of {facets} facets", file_size(facets));
        return Err(Fault::expected(expected, size).into());
    }
    let records = bytes.get(HEADER..).unwrap_or_default().chunks_exact(RECORD);
    let mut welder = Welder::new(u64::from(facets), bytes.len(), RECORD);
    for (i, record) in records.enumerate() {
        let mut values = record.chunks_exact(4).map(|c| f32::from_le_bytes([c[0], c[1], c[2], c[3]])).skip(3);
        let mut corner = || -> Result<[f64; 3], Fault> {
            let mut point = [0.0; 3];
            for x in &mut point {
                // 12 values a record, by its size.
                *x = f64::from(values.next().unwrap_or(f32::NAN));
                if !x.is_finite() {
                    return Err(Fault::NotFinite(x.to_string()));
                }
            }
            Ok(point)
        };
        let located = |fault: Fault| fault.at("facet", i);
        let points = [corner().map_err(located)?, corner().map_err(located)?, corner().map_err(located)?];
        welder.facet(points).map_err(located)?;
    }
    Ok(welder.finish()?)
}

/// Parses a text file; several `solid` blocks make one mesh.
pub(super) fn parse_ascii(bytes: &[u8]) -> Result<(TriMesh, Vec<String>), Located> {
    let mut lines = Lines::new(bytes).filter(|(_, line)| !line.trim_ascii().is_empty());
    let mut welder = Welder::new(0, 0, 1);
    let mut solids = 0;
    while let Some((number, line)) = lines.next() {
        expect(line, &["solid"]).map_err(|f| f.at_line(number))?;
        solids += 1;
        loop {
            let (number, line) = lines.next().ok_or_else(unfinished)?;
            if starts_with(line, "endsolid") {
                break;
            }
            expect(line, &["facet", "normal"]).map_err(|f| f.at_line(number))?;
            facet(&mut lines, &mut welder)?;
        }
    }
    if solids > 1 {
        welder.notes.push(format!("STL: {solids} solids read as one mesh"));
    }
    Ok(welder.finish()?)
}

/// The rest of a facet after its first line.
fn facet<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a [u8])>,
    welder: &mut Welder,
) -> Result<(), Located> {
    let mut next = |words: &[&str]| -> Result<(usize, &'a [u8]), Located> {
        let (number, line) = lines.next().ok_or_else(unfinished)?;
        expect(line, words).map_err(|f| f.at_line(number))?;
        Ok((number, line))
    };
    let mut points = [[0.0; 3]; 3];
    let (first, _) = next(&["outer", "loop"])?;
    for point in &mut points {
        let (number, line) = next(&["vertex"])?;
        let mut columns = tokens(line).skip(1);
        *point = coordinates(&mut columns).map_err(|f| f.at_line(number))?;
        if let Some(more) = columns.next() {
            return Err(Fault::expected("3 coordinates", quote(more)).at_line(number));
        }
    }
    next(&["endloop"])?;
    next(&["endfacet"])?;
    welder.facet(points).map_err(|f| f.at_line(first))
}

fn unfinished() -> Located {
    Fault::expected("endsolid", "the end of the file").into()
}

/// Checks the first words of a line, without regard to case.
fn expect(line: &[u8], words: &[&str]) -> Result<(), Fault> {
    let mut found = tokens(line);
    for word in words {
        let token = found.next();
        if !token.is_some_and(|t| t.eq_ignore_ascii_case(word.as_bytes())) {
            return Err(Fault::expected(format!("\"{}\"", words.join(" ")), quote_or_end(token)));
        }
    }
    Ok(())
}

fn starts_with(line: &[u8], word: &str) -> bool {
    expect(line, &[word]).is_ok()
}

/// Gives equal corners one vertex. The table is only looked up, never walked, so its order does not matter.
struct Welder {
    mesh: TriMesh,
    known: HashMap<[u64; 3], u32>,
    notes: Vec<String>,
}

impl Welder {
    fn new(facets: u64, bytes: usize, bytes_each: usize) -> Self {
        let mesh = TriMesh { vertices: Vec::new(), faces: with_room(facets, bytes, bytes_each) };
        Self { mesh, known: HashMap::new(), notes: Vec::new() }
    }

    fn facet(&mut self, points: [[f64; 3]; 3]) -> Result<(), Fault> {
        let mut face = [0; 3];
        for (corner, point) in face.iter_mut().zip(points) {
            // Adding +0 turns -0 into +0 and changes nothing else.
            let key = point.map(|x| (x + 0.0).to_bits());
            let fresh = u32::try_from(self.mesh.vertices.len())
                .map_err(|_| Fault::TooMany { what: "vertices".to_owned(), count: 1 << 32 })?;
            *corner = *self.known.entry(key).or_insert(fresh);
            if *corner == fresh {
                self.mesh.vertices.push(point);
            }
        }
        self.mesh.faces.push(face);
        Ok(())
    }

    fn finish(mut self) -> Result<(TriMesh, Vec<String>), Fault> {
        let vertices = self.mesh.vertices.len();
        if vertices == 0 {
            return Err(Fault::NoVertices);
        }
        let corners = 3 * self.mesh.faces.len();
        self.notes.insert(0, format!("STL: welded {corners} corners to {vertices} vertices"));
        Ok((self.mesh, self.notes))
    }
}
