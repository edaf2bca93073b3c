//! The initial shell: gate, directions, pinching, beveling, thickness.

use super::bevel::{Input, bevel};
use super::boundary::Pillars;
use super::direction::{Direction, directions, float_dot, float_normal};
use super::draft::Draft;
use super::gate::{self, BuildError};
use super::thickness::{self, Shrunk};
use crate::certify::Observer;
use crate::mesh::{Connectivity, TriMesh};
use crate::shell::Shell;

/// How to build.
#[derive(Clone, Copy, Debug)]
pub struct InitialOptions {
    /// Largest thickness of each half, as a share of the longest edge of the mesh's bounding box.
    pub thickness: f64,
    /// Shrink until the shell does not overlap itself (claim `disjoint-prisms`).
    pub no_overlap: bool,
}

impl Default for InitialOptions {
    fn default() -> Self {
        Self { thickness: 0.1, no_overlap: false }
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
    /// Per mesh vertex: is it pinched? Singular ones are, and those where every thickness collides.
    pub pinched: Vec<bool>,
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
pub fn initial(
    mesh: &TriMesh,
    options: &InitialOptions,
    observer: &dyn Observer,
) -> Result<Initial, BuildError> {
    observer.stage("input", None);
    let connectivity = gate::check(mesh, observer)?;
    observer.stage("directions", None);
    let directions = directions(mesh, &connectivity);
    let mut direction: Vec<[f64; 3]> = directions
        .iter()
        .map(|d| match d {
            Direction::Proved(d) => *d,
            _ => [0.0; 3],
        })
        .collect();
    let mut pinched: Vec<bool> =
        directions.iter().map(|d| matches!(d, Direction::Singular(_) | Direction::Undecided)).collect();
    let most = options.thickness * longest_box_edge(mesh);
    Pillars { mesh, connectivity: &connectivity, direction: &mut direction, pinched: &mut pinched }.settle();
    loop {
        let input = Input { mesh, connectivity: &connectivity, direction: &direction, pinched: &pinched };
        observer.stage("beveling", None);
        let marks = input.to_bevel();
        let mut draft = bevel(&input, &marks);
        no_two_pinched(&draft)?;
        observer.stage("thickness", None);
        thickness::first_guess(&mut draft, mesh, most);
        match thickness::shrink(&mut draft, mesh, &connectivity, options.no_overlap, observer)? {
            Shrunk::Fits(rounds) => {
                let beveled = marks.iter().filter(|b| **b).count();
                let shell = draft.shell();
                return Ok(Initial { shell, origin: draft.origin, directions, pinched, beveled, rounds });
            }
            // At a boundary a pillar can collide with its own one-ring however short it is (Shell Figure 14): the
            // vertex is pinched like a singular one, and everything is built again.
            Shrunk::Stuck { places, reason } => {
                let mut new = false;
                for &(_, triangle) in &places {
                    new |= pinch_worst(&input_of(mesh, &connectivity, &direction), triangle, &mut pinched);
                }
                if let (false, Some(&(vertex, triangle))) = (new, places.first()) {
                    return Err(BuildError::NoThickness { vertex, triangle, reason });
                }
            }
        }
    }
}

/// What choosing a vertex to pinch needs.
struct Corners<'a> {
    mesh: &'a TriMesh,
    connectivity: &'a Connectivity,
    direction: &'a [[f64; 3]],
}

fn input_of<'a>(mesh: &'a TriMesh, connectivity: &'a Connectivity, direction: &'a [[f64; 3]]) -> Corners<'a> {
    Corners { mesh, connectivity, direction }
}

/// Pinches, of a triangle's corners, the one on the boundary whose direction leans most over one of its triangles;
/// where it has no boundary corner, the one that leans most. Never both ends of a boundary edge, which can't be split.
/// Whether a vertex was pinched or already is.
fn pinch_worst(at: &Corners<'_>, triangle: u32, pinched: &mut [bool]) -> bool {
    let lean = |v: u32| {
        let star = at.connectivity.star(v).iter();
        let normals = star
            .map(|c| float_normal(at.mesh.faces[c.face() as usize].map(|u| &at.mesh.vertices[u as usize])));
        normals.map(|n| float_dot(&n, &at.direction[v as usize])).fold(f64::INFINITY, f64::min)
    };
    let face = at.mesh.faces[triangle as usize];
    let next_on_boundary = |v: u32| -> Vec<u32> {
        let star = at.connectivity.star(v).iter();
        let sides =
            star.flat_map(|c| [c.next(), c.previous()]).filter(|s| at.connectivity.mate(*s).is_none());
        sides.flat_map(|s| at.connectivity.ends(s)).filter(|u| *u != v).collect()
    };
    let mut corners = face.to_vec();
    corners.sort_by(|a, b| lean(*a).total_cmp(&lean(*b)));
    corners.sort_by_key(|v| next_on_boundary(*v).is_empty());
    let free = |v: &u32| !pinched[*v as usize] && next_on_boundary(*v).iter().all(|u| !pinched[*u as usize]);
    match corners.iter().copied().find(free) {
        Some(v) => {
            pinched[v as usize] = true;
            true
        }
        None => false,
    }
}

fn no_two_pinched(draft: &Draft) -> Result<(), BuildError> {
    for face in &draft.faces {
        let two: Vec<u32> = face.iter().copied().filter(|&v| draft.pinched[v as usize]).collect();
        if let [u, w, ..] = two[..] {
            return Err(BuildError::TwoPinched { vertices: [u, w] });
        }
    }
    Ok(())
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
