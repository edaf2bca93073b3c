//! Texture coordinates of Wavefront OBJ: `vt`, and the second number of face corners.

use super::columns::{Column, ColumnKind, Domain};
use super::error::{Fault, Located};
use super::obj::next_logical;
use super::text::{Lines, before_comment, coordinate, integer, quote, quote_or_end, tokens};

/// A corner's texture coordinate: the number as written, and how many there were by then.
struct Reference {
    line: usize,
    written: i64,
    known: usize,
}

/// The corner columns `u` and `v`; none for a file without `vt`.
pub(super) fn columns(bytes: &[u8]) -> Result<Vec<Column>, Located> {
    let mut lines = Lines::new(bytes);
    let (mut texture, mut corners) = (Vec::new(), Vec::new());
    while let Some((number, line)) = next_logical(&mut lines) {
        let line = before_comment(&line);
        statement(line, number, &mut texture, &mut corners).map_err(|f| f.at_line(number))?;
    }
    if texture.is_empty() {
        return Ok(Vec::new());
    }
    let places = corners
        .iter()
        .map(|c| resolve(c, &texture).map_err(|f| f.at_line(c.line)))
        .collect::<Result<Vec<[f64; 2]>, Located>>()?;
    let column = |name: &str, k: usize| Column {
        name: name.to_owned(),
        domain: Domain::Corner,
        kind: ColumnKind::Real,
        values: places.iter().map(|p| p[k]).collect(),
    };
    Ok(vec![column("u", 0), column("v", 1)])
}

fn statement(
    line: &[u8],
    number: usize,
    texture: &mut Vec<[f64; 2]>,
    corners: &mut Vec<Reference>,
) -> Result<(), Fault> {
    let mut words = tokens(line);
    match words.next() {
        Some(b"vt") => {
            let first =
                words.next().ok_or_else(|| Fault::expected("texture coordinates", quote_or_end(None)))?;
            let u = coordinate(first, "texture coordinates")?;
            // A texture of one dimension has no v.
            let v = words.next().map_or(Ok(0.0), |word| coordinate(word, "texture coordinates"))?;
            texture.push([u, v]);
        }
        Some(b"f" | b"fo") => {
            let polygon = words
                .map(|word| {
                    let second = word.split(|&b| b == b'/').nth(1).filter(|part| !part.is_empty());
                    let written = second.map_or(Ok(0), |part| integer(Some(part), ""));
                    written.map_err(|_| Fault::expected("a face corner", quote(word)))
                })
                .collect::<Result<Vec<i64>, Fault>>()?;
            let reference = |written: i64| Reference { line: number, written, known: texture.len() };
            if let [first, rest @ ..] = polygon.as_slice() {
                for pair in rest.windows(2) {
                    corners.extend([*first, pair[0], pair[1]].map(reference));
                }
            }
        }
        _ => {}
    }
    Ok(())
}

fn resolve(corner: &Reference, texture: &[[f64; 2]]) -> Result<[f64; 2], Fault> {
    let size = usize::try_from(corner.written.unsigned_abs()).unwrap_or(usize::MAX);
    let index = match corner.written {
        0 => return Err(Fault::expected("a texture coordinate on every face corner", "one without")),
        1.. => size.checked_sub(1),
        _ => corner.known.checked_sub(size),
    };
    index.and_then(|i| texture.get(i)).copied().ok_or_else(|| {
        Fault::expected(
            format!("the number of one of {} texture coordinates", texture.len()),
            corner.written.to_string(),
        )
    })
}
