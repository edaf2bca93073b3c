//! Object File Format (Geomview), text. One vertex and one face a line.

use super::TriMesh;
use super::error::{Fault, Located};
use super::text::{Builder, Lines, coordinates, index, integer, quote, tokens, with_room};

/// Fewest bytes of a vertex line (`0 0 0`) and of a face line (`3 0 0 0`), with their ends.
const VERTEX_BYTES: usize = 6;
const FACE_BYTES: usize = 8;

/// Whether a token is the first word of an OFF file, supported or not.
pub(super) fn is_magic(token: &[u8]) -> bool {
    variant(token).is_some()
}

/// The letters before `OFF`: any of `ST`, `C`, `N`, `4`, `n` in this order.
fn variant(token: &[u8]) -> Option<&[u8]> {
    let prefix = token.strip_suffix(b"OFF")?;
    let mut rest = prefix;
    for part in [b"ST".as_slice(), b"C", b"N", b"4", b"n"] {
        rest = rest.strip_prefix(part).unwrap_or(rest);
    }
    rest.is_empty().then_some(prefix)
}

/// Parses a file; columns after the coordinates (normals, colours, texture) are ignored and noted.
pub(super) fn parse(bytes: &[u8]) -> Result<(TriMesh, Vec<String>), Located> {
    let mut lines = Lines::new(bytes);
    let mut builder = Builder::default();
    let [vertices, faces] = counts(&mut lines, &mut builder)?;

    builder.mesh.vertices = with_room(vertices, lines.rest().len(), VERTEX_BYTES);
    for found in 0..vertices {
        let (number, line) = lines.next_content().ok_or_else(|| truncated("vertices", vertices, found))?;
        let mut columns = tokens(line);
        let point = coordinates(&mut columns).map_err(|f| f.at_line(number))?;
        builder.mesh.vertices.push(point);
        if columns.next().is_some() {
            builder.extra_column();
        }
    }
    builder.mesh.faces = with_room(faces, lines.rest().len(), FACE_BYTES);
    let mut corners = Vec::new();
    for found in 0..faces {
        let (number, line) = lines.next_content().ok_or_else(|| truncated("faces", faces, found))?;
        face(line, vertices, &mut corners, &mut builder).map_err(|f| f.at_line(number))?;
    }
    if let Some((number, _)) = lines.next_content() {
        return Err(Fault::TrailingData("face".to_owned()).at_line(number));
    }
    Ok(builder.finish("OFF")?)
}

/// Reads the header: the magic word, which may be missing, and the numbers of vertices and faces.
fn counts(lines: &mut Lines<'_>, builder: &mut Builder) -> Result<[u64; 2], Located> {
    let (mut number, mut line) = lines.next_content().ok_or(Fault::Empty)?;
    let mut columns = tokens(line).peekable();
    let first = columns.peek().copied().unwrap_or_default();
    if let Some(prefix) = variant(first) {
        if prefix.contains(&b'4') || prefix.contains(&b'n') {
            let what = format!("{} (coordinates that are not three)", quote(first));
            return Err(Fault::Unsupported(what).at_line(number));
        }
        columns.next();
        match columns.peek() {
            Some(&b"BINARY") => return Err(Fault::Unsupported("binary OFF".to_owned()).at_line(number)),
            Some(_) => {}
            None => {
                (number, line) = lines.next_content().ok_or_else(|| truncated("header lines", 2, 1))?;
                columns = tokens(line).peekable();
            }
        }
    } else {
        integer::<u64>(Some(first), "the word OFF").map_err(|f| f.at_line(number))?;
        builder.notes.push("OFF: the word OFF is missing".to_owned());
    }
    let mut counts = [0; 2];
    for (count, what) in counts.iter_mut().zip(["vertices", "faces"]) {
        *count = integer(columns.next(), &format!("the number of {what}")).map_err(|f| f.at_line(number))?;
        if *count > u64::from(u32::MAX) {
            return Err(Fault::TooMany { what: what.to_owned(), count: *count }.at_line(number));
        }
    }
    // The number of edges is optional and often wrong.
    if let Some(edges) = columns.next() {
        integer::<i128>(Some(edges), "the number of edges").map_err(|f| f.at_line(number))?;
    }
    if let Some(more) = columns.next() {
        return Err(Fault::expected("2 or 3 counts", quote(more)).at_line(number));
    }
    Ok(counts)
}

/// Reads `n i_1 ... i_n`; what follows is colour.
fn face(line: &[u8], vertices: u64, corners: &mut Vec<u32>, builder: &mut Builder) -> Result<(), Fault> {
    let mut columns = tokens(line);
    let size: u64 = integer(columns.next(), "the number of corners")?;
    corners.clear();
    for found in 0..size {
        let token = columns.next();
        if token.is_none() {
            return Err(Fault::expected(format!("{size} vertex indices"), found.to_string()));
        }
        corners.push(index(token, vertices)?);
    }
    builder.polygon(corners)
}

fn truncated(what: &str, expected: u64, found: u64) -> Located {
    Fault::Truncated { what: what.to_owned(), expected, found }.into()
}
