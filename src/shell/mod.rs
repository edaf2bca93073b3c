//! Prismatic shells (THEORY section 1): the data, its names, its tets, its files.
//!
//! [`Shell`] holds the points; [`Name`] names one of them; [`decomposition`] is the table of the
//! 12 tets a slab can be cut into; [`Tet`] is one of them in a concrete prism. [`hdf5`], [`three`]
//! and [`vtu`] read and write files, [`validate`] states the input conditions.

pub mod decomposition;
mod facts;
pub mod hdf5;
pub mod three;
pub mod validate;
pub mod vtu;

#[cfg(test)]
mod file_tests;
mod order;
mod pillar;
#[cfg(test)]
mod tests;
mod tets;

pub use facts::ShellFacts;
pub use order::{OrderError, VertexOrder};
pub use pillar::PillarCounts;
pub use tets::Tet;

use std::fmt;

/// A shell: one prism per triangle of `faces`, with bottom, middle and top points per vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shell {
    /// Bottom points `b_v`.
    pub bottom: Vec<[f64; 3]>,
    /// Middle points `m_v`.
    pub middle: Vec<[f64; 3]>,
    /// Top points `t_v`.
    pub top: Vec<[f64; 3]>,
    /// The middle complex: three vertex ids a prism, in orientation order.
    pub faces: Vec<[u32; 3]>,
}

/// One of the three points of a pillar; ordered from bottom to top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layer {
    /// `b_v`.
    Bottom,
    /// `m_v`; also the one layer of a pinched vertex.
    Middle,
    /// `t_v`.
    Top,
}

impl Layer {
    /// The letter used in names: `b`, `m` or `t`.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Bottom => 'b',
            Self::Middle => 'm',
            Self::Top => 't',
        }
    }

    /// The height of the layer in the reference prism `M x [-1, 1]`.
    #[must_use]
    pub const fn height(self) -> i8 {
        match self {
            Self::Bottom => -1,
            Self::Middle => 0,
            Self::Top => 1,
        }
    }
}

/// The name of a shell point, printed `b12`, `m12`, `t12`; ordered by vertex, then layer.
///
/// A pinched vertex is one point: its name always has layer [`Layer::Middle`] (see
/// [`Shell::name`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Name {
    /// The vertex of the middle complex.
    pub vertex: u32,
    /// Which point of its pillar.
    pub layer: Layer,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.layer.letter(), self.vertex)
    }
}

/// The half of a prism below or above the middle surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Slab {
    /// Between bottom and middle.
    Bottom,
    /// Between middle and top.
    Top,
}

impl Slab {
    /// Both slabs, from bottom to top.
    pub const BOTH: [Self; 2] = [Self::Bottom, Self::Top];

    /// The slab's lower layer.
    #[must_use]
    pub const fn lo(self) -> Layer {
        match self {
            Self::Bottom => Layer::Bottom,
            Self::Top => Layer::Middle,
        }
    }

    /// The slab's upper layer.
    #[must_use]
    pub const fn hi(self) -> Layer {
        match self {
            Self::Bottom => Layer::Middle,
            Self::Top => Layer::Top,
        }
    }
}

impl fmt::Display for Slab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Bottom => "bottom",
            Self::Top => "top",
        })
    }
}

impl Shell {
    /// The number of vertices of the middle complex (the length of `middle`).
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.middle.len()
    }

    /// The number of prisms.
    #[must_use]
    pub fn prism_count(&self) -> usize {
        self.faces.len()
    }

    /// The points of one layer.
    #[must_use]
    pub fn layer(&self, layer: Layer) -> &[[f64; 3]] {
        match layer {
            Layer::Bottom => &self.bottom,
            Layer::Middle => &self.middle,
            Layer::Top => &self.top,
        }
    }

    /// The point called `name`, or `None` where the shell has no such vertex.
    #[must_use]
    pub fn try_position(&self, name: Name) -> Option<&[f64; 3]> {
        self.layer(name.layer).get(name.vertex as usize)
    }

    /// The point called `name`.
    ///
    /// # Panics
    /// Where the shell has no such vertex: names must come from this shell, whose indices have
    /// passed [`validate::indices`] (every reader of this crate calls it). For a name that comes
    /// from outside use [`Shell::try_position`].
    #[must_use]
    pub fn position(&self, name: Name) -> &[f64; 3] {
        &self.layer(name.layer)[name.vertex as usize]
    }

    /// Whether `b = m = t` in all coordinates, as numbers (`-0.0` is `0.0`); `false` where the
    /// shell has no such vertex.
    #[must_use]
    // Equality of stored doubles is an exact statement about the rationals that they stand for.
    #[allow(clippy::float_cmp)]
    pub fn is_pinched(&self, vertex: u32) -> bool {
        let v = vertex as usize;
        match (self.bottom.get(v), self.middle.get(v), self.top.get(v)) {
            (Some(b), Some(m), Some(t)) => b == m && m == t,
            _ => false,
        }
    }

    /// The pinched vertices in ascending order. Linear in the number of vertices.
    #[must_use]
    pub fn pinched_vertices(&self) -> Vec<u32> {
        let count = u32::try_from(self.vertex_count()).unwrap_or(u32::MAX);
        (0..count).filter(|&v| self.is_pinched(v)).collect()
    }

    /// The name of the point of `vertex` in `layer`: layer `m` whenever the vertex is pinched.
    #[must_use]
    pub fn name(&self, vertex: u32, layer: Layer) -> Name {
        let layer = if self.is_pinched(vertex) { Layer::Middle } else { layer };
        Name { vertex, layer }
    }
}

/// Writes a file beside `path` and moves it there once `write` has succeeded, so that an existing
/// file is never left half overwritten.
fn replace_file(
    path: &std::path::Path,
    write: impl FnOnce(&mut std::io::BufWriter<&std::fs::File>) -> std::io::Result<()>,
) -> std::io::Result<()> {
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty());
    let mut builder = tempfile::Builder::new();
    // The umask applies, as to any other new file; the default would be private to the user.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let temporary = builder.tempfile_in(parent.unwrap_or(std::path::Path::new(".")))?;
    let mut out = std::io::BufWriter::new(temporary.as_file());
    write(&mut out)?;
    std::io::Write::flush(&mut out)?;
    drop(out);
    temporary.persist(path)?;
    Ok(())
}
