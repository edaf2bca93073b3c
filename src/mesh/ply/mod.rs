//! PLY, text and binary. Coordinates are the properties `x y z` of the element `vertex`, of any
//! type; corners the list `vertex_indices` (or `vertex_index`) of the element `face`. Other
//! properties and elements are skipped and noted. In text, a coordinate is read as `f64` also where
//! the header declares `float`. One element a line in text.

mod body;
mod columns;
mod header;

use super::TriMesh;
use super::error::{Fault, Located};
use super::format::Format;
use super::text::{Builder, with_room};
pub(super) use columns::columns;

use body::{Ascii, Binary, Number, Source};
use header::{Element, Header, Kind};

/// The format that the header declares, if this is a PLY header that can be read that far.
pub(super) fn detect(bytes: &[u8]) -> Option<Format> {
    if !header::has_magic(bytes) {
        return None;
    }
    // A faulty header is a PLY file all the same: parsing it will say what is wrong.
    Some(header::parse(bytes).map_or(Format::PlyAscii, |(header, _)| header.format))
}

type Parsed = (Format, (TriMesh, Vec<String>));

/// Parses a file of any of the three encodings.
pub(super) fn parse(bytes: &[u8]) -> Result<Parsed, Located> {
    let (header, lines) = header::parse(bytes)?;
    let mesh = match header.format {
        Format::PlyAscii => read_body(&header, &mut Ascii::new(lines))?,
        format => read_body(&header, &mut Binary::new(lines.rest(), format == Format::PlyBinaryBe))?,
    };
    Ok((header.format, mesh))
}

fn read_body(header: &Header, source: &mut impl Source) -> Result<(TriMesh, Vec<String>), Located> {
    let vertices = header.element("vertex").ok_or_else(|| missing("element vertex"))?;
    if vertices.count > u64::from(u32::MAX) {
        return Err(Fault::TooMany { what: "vertices".to_owned(), count: vertices.count }.into());
    }
    if header.element("face").is_none() && header.element("tristrips").is_some() {
        return Err(Fault::Unsupported("the element tristrips".to_owned()).into());
    }
    let mut builder = Builder::default();
    for element in &header.elements {
        source.begin(element)?;
        match element.name.as_str() {
            "vertex" => read_vertices(element, source, &mut builder)?,
            "face" => read_faces(element, vertices.count, source, &mut builder)?,
            _ => skip(element, source, &mut builder)?,
        }
    }
    source.finish()?;
    Ok(builder.finish("PLY")?)
}

fn missing(what: &str) -> Located {
    Fault::BadHeader(format!("the header has no {what}")).into()
}

fn read_vertices(element: &Element, source: &mut impl Source, builder: &mut Builder) -> Result<(), Located> {
    let mut axis_of = vec![None; element.properties.len()];
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let found =
            element.properties.iter().position(|p| p.name == name && matches!(p.kind, Kind::Scalar(_)));
        let position = found.ok_or_else(|| missing(&format!("property {name} of vertex")))?;
        axis_of[position] = Some(axis);
    }
    note_ignored(element, 3, builder);
    builder.mesh.vertices = with_room(element.count, source.remaining(), 6);
    for row in 0..element.count {
        source.begin_row(element, row)?;
        let mut point = [0.0; 3];
        for (property, axis) in element.properties.iter().zip(&axis_of) {
            match (property.kind, axis) {
                (Kind::Scalar(ty), Some(axis)) => point[*axis] = source.number(ty)?.coordinate()?,
                (kind, _) => source.skip(kind)?,
            }
        }
        source.end_row()?;
        builder.mesh.vertices.push(point);
    }
    Ok(())
}

fn read_faces(
    element: &Element,
    vertices: u64,
    source: &mut impl Source,
    builder: &mut Builder,
) -> Result<(), Located> {
    let is_corners = |name: &str| matches!(name, "vertex_indices" | "vertex_index");
    let found =
        element.properties.iter().position(|p| is_corners(&p.name) && matches!(p.kind, Kind::List { .. }));
    let corners_at = found.ok_or_else(|| missing("list property vertex_indices of face"))?;
    if let Some(property) = element.properties.get(corners_at)
        && let Kind::List { item, .. } = property.kind
        && !item.is_integer()
    {
        return Err(Fault::BadHeader(format!(
            "property {} of face is not a list of integers",
            property.name
        ))
        .into());
    }
    note_ignored(element, 1, builder);
    builder.mesh.faces = with_room(element.count, source.remaining(), 4);
    let mut corners = Vec::new();
    for row in 0..element.count {
        source.begin_row(element, row)?;
        for (i, property) in element.properties.iter().enumerate() {
            match property.kind {
                Kind::List { count, item } if i == corners_at => {
                    corners.clear();
                    for _ in 0..source.length(count, item)? {
                        corners.push(source.number(item)?.index(vertices)?);
                    }
                }
                kind => source.skip(kind)?,
            }
        }
        source.end_row()?;
        builder.polygon(&corners).map_err(|fault| source.locate(fault))?;
    }
    Ok(())
}

/// Steps over an element. Without properties it takes no bytes, so its count must not be believed.
fn skip(element: &Element, source: &mut impl Source, builder: &mut Builder) -> Result<(), Located> {
    if element.properties.is_empty() {
        return Ok(());
    }
    builder.notes.push(format!("PLY: ignored element {}", super::text::quote(element.name.as_bytes())));
    for row in 0..element.count {
        source.begin_row(element, row)?;
        for property in &element.properties {
            source.skip(property.kind)?;
        }
        source.end_row()?;
    }
    Ok(())
}

fn note_ignored(element: &Element, used: usize, builder: &mut Builder) {
    let more = element.properties.len().saturating_sub(used);
    if more > 0 {
        builder.notes.push(format!("PLY: ignored {more} properties of element {}", element.name));
    }
}

impl Number {
    fn coordinate(self) -> Result<f64, Located> {
        if self.value.is_finite() { Ok(self.value) } else { Err(self.fault(Fault::NotFinite(self.text()))) }
    }

    fn index(self, vertices: u64) -> Result<u32, Located> {
        match self.integer.and_then(|i| u32::try_from(i).ok()).filter(|&i| u64::from(i) < vertices) {
            Some(index) => Ok(index),
            None => Err(self.fault(Fault::IndexOutOfRange { index: self.text(), vertices })),
        }
    }
}
