//! The initial shell: gate, directions, pinching, beveling, thickness.

use super::bevel::{Input, bevel};
use super::direction::{Direction, directions};
use super::gate::{self, BuildError};
use super::thickness;
use crate::certify::Observer;
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// How to build.
#[derive(Clone, Copy, Debug)]
pub struct InitialOptions {
    /// Largest thickness of each half, as a share of the longest edge of the mesh's bounding box.
    pub thickness: f64,
}

impl Default for InitialOptions {
    fn default() -> Self {
        Self { thickness: 0.1 }
    }
}

/// An initial shell.
#[derive(Clone, Debug)]
pub struct Initial {
    /// The shell.
    pub shell: Shell,
    /// Per prism the mesh triangle that its middle lies in.
    pub origin: Vec<u32>,
    /// Per mesh vertex its direction or the proof that it has none.
    pub directions: Vec<Direction>,
    /// How many triangles were beveled.
    pub beveled: usize,
    /// How many rounds of shrinking were needed.
    pub rounds: usize,
}

/// Builds the initial shell around a mesh. It satisfies C1 and the contact conditions of C3+ by exact tests; certify it
/// for all claims.
///
/// # Errors
/// See [`BuildError`].
pub fn initial(mesh: &TriMesh, options: &InitialOptions, observer: &dyn Observer) -> Result<Initial, BuildError> {
    observer.stage("input", None);
    let connectivity = gate::check(mesh, observer)?;
    observer.stage("directions", None);
    let directions = directions(mesh, &connectivity);
    let direction: Vec<[f64; 3]> = directions
        .iter()
        .map(|d| match d {
            Direction::Proved(d) => *d,
            _ => [0.0; 3],
        })
        .collect();
    let pinched: Vec<bool> =
        directions.iter().map(|d| matches!(d, Direction::Singular(_) | Direction::Undecided)).collect();
    let input = Input { mesh, connectivity: &connectivity, direction: &direction, pinched: &pinched };
    let marks = input.to_bevel();
    observer.stage("beveling", None);
    let mut draft = bevel(&input, &marks);
    for face in &draft.faces {
        let two: Vec<u32> = face.iter().copied().filter(|&v| draft.pinched[v as usize]).collect();
        if let [u, w, ..] = two[..] {
            return Err(BuildError::TwoPinched { vertices: [u, w] });
        }
    }
    observer.stage("thickness", None);
    let most = options.thickness * longest_box_edge(mesh);
    thickness::first_guess(&mut draft, mesh, most);
    let rounds = thickness::shrink(&mut draft, mesh, &connectivity, observer)?;
    let beveled = marks.iter().filter(|b| **b).count();
    Ok(Initial { shell: draft.shell(), origin: draft.origin, directions, beveled, rounds })
}

/// The longest edge of the bounding box.
pub(crate) fn longest_box_edge(mesh: &TriMesh) -> f64 {
    (0..3)
        .map(|i| {
            let x = || mesh.vertices.iter().map(|p| p[i]);
            x().fold(f64::NEG_INFINITY, f64::max) - x().fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}
