//! What the formats for cells of several dimensions hold, while it is read.

use super::TriMesh;
use super::complex::{Cells, Complex, Positions, Space};
use super::error::{Fault, Located};
use super::text::Builder;
use crate::number::Rat;

/// Vertices, triangles and tets under construction.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) builder: Builder,
    pub(super) tets: Vec<[u32; 4]>,
    pub(super) exact: Vec<(String, Vec<[Rat; 3]>)>,
    /// Do the vertices have two coordinates?
    pub(super) planar: bool,
    /// Cells of dimension 0 and 1.
    pub(super) lower: u64,
}

/// A complex, exact positions by name, and notes.
pub(super) type Parsed = (Complex, Vec<(String, Vec<[Rat; 3]>)>, Vec<String>);

impl Parts {
    fn note_lower(&mut self, format: &str) {
        if self.lower > 0 {
            self.builder.notes.push(format!("{format}: ignored {} points and lines", self.lower));
        }
    }

    /// A tet from its corners.
    pub(super) fn tet(&mut self, corners: &[u32]) -> Result<(), Fault> {
        let tet = <[u32; 4]>::try_from(corners);
        let wrong = || Fault::expected("4 corners of a tet", corners.len().to_string());
        self.tets.push(tet.map_err(|_| wrong())?);
        Ok(())
    }

    /// As a surface; tets are not one.
    pub(super) fn surface(mut self, format: &str) -> Result<(TriMesh, Vec<String>), Located> {
        if !self.tets.is_empty() {
            let what = format!("a tet mesh ({} tets) where a surface is wanted", self.tets.len());
            return Err(Fault::Unsupported(what).into());
        }
        self.note_lower(format);
        Ok(self.builder.finish(format)?)
    }

    /// As a complex of the highest dimension that there is.
    pub(super) fn complex(mut self, format: &str) -> Result<Parsed, Located> {
        self.note_lower(format);
        let triangles = self.builder.mesh.faces.len();
        let (mesh, mut notes) = self.builder.finish(format)?;
        let cells = if self.tets.is_empty() {
            Cells::Triangles(mesh.faces)
        } else {
            if triangles > 0 {
                notes.push(format!("{format}: ignored {triangles} triangles beside the tets"));
            }
            Cells::Tets(self.tets)
        };
        let space = if self.planar && cells.corners() == 3 { Space::Plane } else { Space::Space };
        Ok((Complex { space, positions: Positions::Float(mesh.vertices), cells }, self.exact, notes))
    }
}

/// An index that counts from 0.
pub(super) fn vertex(index: i128, vertices: usize) -> Result<u32, Fault> {
    let vertices = u64::try_from(vertices).unwrap_or(u64::MAX);
    match u32::try_from(index) {
        Ok(i) if u64::from(i) < vertices => Ok(i),
        _ => Err(Fault::IndexOutOfRange { index: index.to_string(), vertices }),
    }
}

/// Refuses a count that indices cannot reach.
pub(super) fn countable(what: &str, count: u64) -> Result<(), Fault> {
    if count > u64::from(u32::MAX) {
        return Err(Fault::TooMany { what: what.to_owned(), count });
    }
    Ok(())
}
