//! The properties that the mesh reader steps over.

use super::Format;
use super::body::{Ascii, Binary, Source};
use super::header::{self, Element, Header, Kind, Type};
use crate::mesh::columns::{Column, ColumnKind, Domain};
use crate::mesh::error::{Fault, Located};
use crate::mesh::text::with_room;

/// A polygon's values are repeated for each of its triangles: a bound on what that takes, a multiple of
/// the file's size.
const MOST_TRIANGLES: usize = 16;

/// All scalar properties of vertices (but `x y z`) and faces.
pub(in crate::mesh) fn columns(bytes: &[u8]) -> Result<Vec<Column>, Located> {
    let (header, lines) = header::parse(bytes)?;
    match header.format {
        Format::PlyAscii => read(&header, &mut Ascii::new(lines)),
        format => read(&header, &mut Binary::new(lines.rest(), format == Format::PlyBinaryBe)),
    }
}

fn read(header: &Header, source: &mut impl Source) -> Result<Vec<Column>, Located> {
    let mut out = Vec::new();
    for element in &header.elements {
        source.begin(element)?;
        match element.name.as_str() {
            "vertex" => rows(element, Domain::Vertex, source, &mut out)?,
            "face" => rows(element, Domain::Face, source, &mut out)?,
            // Without properties an element takes no bytes, so its count must not be believed.
            _ if element.properties.is_empty() => {}
            _ => {
                for row in 0..element.count {
                    source.begin_row(element, row)?;
                    for property in &element.properties {
                        source.skip(property.kind)?;
                    }
                    source.end_row()?;
                }
            }
        }
    }
    source.finish()?;
    Ok(out)
}

fn kind(ty: Type) -> ColumnKind {
    match ty {
        Type::U8 => ColumnKind::Byte,
        ty if ty.is_integer() => ColumnKind::Integer,
        _ => ColumnKind::Real,
    }
}

fn rows(
    element: &Element,
    domain: Domain,
    source: &mut impl Source,
    out: &mut Vec<Column>,
) -> Result<(), Located> {
    if element.properties.is_empty() {
        return Ok(());
    }
    let first = out.len();
    // The column of each property, if it has one.
    let mut column_of = Vec::with_capacity(element.properties.len());
    for p in &element.properties {
        let coordinate = domain == Domain::Vertex && matches!(p.name.as_str(), "x" | "y" | "z");
        column_of.push(match p.kind {
            Kind::Scalar(ty) if !coordinate => {
                let values = with_room(element.count, source.remaining(), element.least_size());
                out.push(Column { name: p.name.clone(), domain, kind: kind(ty), values });
                Some(out.len() - 1)
            }
            _ => None,
        });
    }
    for row in 0..element.count {
        source.begin_row(element, row)?;
        let mut triangles = 1;
        for (property, column) in element.properties.iter().zip(&column_of) {
            match (property.kind, column) {
                (Kind::Scalar(ty), Some(column)) => {
                    let number = source.number(ty)?;
                    if !number.value.is_finite() {
                        return Err(number.fault(Fault::NotFinite(number.text())));
                    }
                    if let Some(column) = out.get_mut(*column) {
                        column.values.push(number.value);
                    }
                }
                (Kind::List { count, item }, _) if is_corners(&property.name) => {
                    let corners = source.length(count, item)?;
                    for _ in 0..corners {
                        source.number(item)?;
                    }
                    triangles = corners.saturating_sub(2).max(1);
                    if triangles > MOST_TRIANGLES && out.len() > first {
                        let what = format!("values on a polygon of {corners} corners");
                        return Err(source.locate(Fault::Unsupported(what)));
                    }
                }
                (kind, _) => source.skip(kind)?,
            }
        }
        source.end_row()?;
        for column in out.iter_mut().skip(first).filter(|_| domain == Domain::Face) {
            if let Some(&value) = column.values.last() {
                column.values.extend(std::iter::repeat_n(value, triangles - 1));
            }
        }
    }
    Ok(())
}

fn is_corners(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}
