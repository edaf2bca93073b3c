//! The initial shell: gate, directions, pinching, beveling, thickness.

use super::bevel::{Input, bevel};
use super::boundary::Pillars;
use super::direction::{Direction, directions, float_cross, float_dot, float_normal};
use super::draft::Draft;
use super::gate::{self, BuildError};
use super::optimise::tree::Tree;
use super::scale::Scale;
use super::thickness::{self, Against, Shrunk};
use crate::certify::Observer;
use crate::mesh::{Connectivity, TriMesh};
use crate::shell::Shell;

/// Largest thickness of each half of a shell. A wish that steers: whatever it is, what is built is judged exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness {
    /// A share of the longest edge of the mesh's bounding box.
    Share(f64),
    /// A length in the mesh's units.
    Absolute(f64),
}

impl Thickness {
    /// The length for a mesh.
    #[must_use]
    pub fn length(self, mesh: &TriMesh) -> f64 {
        match self {
            Self::Share(share) => share * longest_box_edge(mesh),
            Self::Absolute(length) => length,
        }
    }

    /// The wish for the mesh scaled.
    pub(crate) fn scaled(self, scale: Scale) -> Self {
        match self {
            Self::Share(_) => self,
            Self::Absolute(length) => Self::Absolute(scale.length(length)),
        }
    }
}

impl Default for Thickness {
    fn default() -> Self {
        Self::Share(0.1)
    }
}

/// How to build.
#[derive(Clone, Copy, Debug, Default)]
pub struct InitialOptions {
    /// Largest thickness of each half.
    pub thickness: Thickness,
    /// Build around a mesh that intersects itself, too: then prisms are kept clear of the triangles around their own one
    /// only (*Shell* section 6), and no claim about all pairs in space holds (C3+, C6).
    pub allow_self_intersections: bool,
    /// Shrink until the shell does not overlap itself (claim `disjoint-prisms`).
    pub no_overlap: bool,
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
    let connectivity = gate::check(mesh, options.allow_self_intersections, observer)?;
    let scale = Scale::of(mesh);
    let scaled = InitialOptions { thickness: options.thickness.scaled(scale), ..*options };
    let mut out = at_size_one(&scale.mesh(mesh)?, &connectivity, &scaled, observer)?;
    out.shell = scale.inverse().shell(&out.shell)?;
    Ok(out)
}

fn at_size_one(
    mesh: &TriMesh,
    connectivity: &Connectivity,
    options: &InitialOptions,
    observer: &dyn Observer,
) -> Result<Initial, BuildError> {
    observer.stage("directions", None);
    let directions = directions(mesh, connectivity);
    let mut direction: Vec<[f64; 3]> = directions
        .iter()
        .map(|d| match d {
            Direction::Proved(d) => *d,
            _ => [0.0; 3],
        })
        .collect();
    let mut pinched: Vec<bool> =
        directions.iter().map(|d| matches!(d, Direction::Singular(_) | Direction::Undecided)).collect();
    let most = options.thickness.length(mesh);
    let tree = Tree::new(mesh);
    Pillars { mesh, connectivity, direction: &mut direction, pinched: &mut pinched }.settle();
    loop {
        let input = Input { mesh, connectivity, direction: &direction, pinched: &pinched };
        observer.stage("beveling", None);
        let marks = input.to_bevel();
        let mut draft = bevel(&input, &marks);
        no_two_pinched(&draft)?;
        observer.stage("thickness", None);
        let against = Against { mesh, connectivity, tree: &tree, all: !options.allow_self_intersections };
        thickness::first_guess(&mut draft, &against, most);
        match thickness::shrink(&mut draft, &against, options.no_overlap, observer)? {
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
                    new |= pinch_worst(&input_of(mesh, connectivity, &direction), triangle, &mut pinched);
                }
                if let (false, Some(&(vertex, triangle))) = (new, places.first()) {
                    return Err(no_thickness(mesh, connectivity, (vertex, triangle), reason));
                }
            }
        }
    }
}

/// Triangles need to be so many spacings of doubles high, or rounding may be what is in the way: a square root of the
/// precision. It chooses the words of the error only.
const ROOM: f64 = (1u64 << 26) as f64;

/// Why there is no thickness: the triangle or one around it is hardly larger than the spacing of doubles, or another
/// reason.
fn no_thickness(
    mesh: &TriMesh,
    connectivity: &Connectivity,
    (vertex, triangle): (u32, u32),
    reason: &'static str,
) -> BuildError {
    let face = mesh.faces[triangle as usize];
    let largest = face.iter().flat_map(|&v| mesh.vertices[v as usize]).fold(0.0f64, |m, x| m.max(x.abs()));
    let spacing = largest * f64::EPSILON;
    let around = face.into_iter().flat_map(|v| connectivity.star(v)).map(|c| c.face());
    let least = around.map(|f| height(mesh, f)).fold(f64::INFINITY, f64::min);
    if least < ROOM * spacing {
        return BuildError::Coarse { vertex, triangle, spacing, reason };
    }
    BuildError::NoThickness { vertex, triangle, reason }
}

/// The smallest height of a triangle, about.
fn height(mesh: &TriMesh, f: u32) -> f64 {
    let [a, b, c] = mesh.faces[f as usize].map(|v| mesh.vertices[v as usize]);
    let edge = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| q[i] - p[i]) };
    let (x, y, z) = (edge(&a, &b), edge(&a, &c), edge(&b, &c));
    let length = |v: &[f64; 3]| float_dot(v, v).sqrt();
    length(&float_cross(&x, &y)) / length(&x).max(length(&y)).max(length(&z))
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

/// Half the longest edge of the bounding box: the whole could overflow. Vertices that no triangle uses don't count.
pub(crate) fn half_box_edge(mesh: &TriMesh) -> f64 {
    box_edge_times(mesh, 0.5)
}

/// The longest edge of the bounding box times a factor, which the coordinates are multiplied by first.
pub(crate) fn box_edge_times(mesh: &TriMesh, factor: f64) -> f64 {
    (0..3)
        .map(|i| {
            let x = || mesh.faces.iter().flatten().map(|&v| factor * mesh.vertices[v as usize][i]);
            x().fold(f64::NEG_INFINITY, f64::max) - x().fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

/// The longest edge of the bounding box.
pub(crate) fn longest_box_edge(mesh: &TriMesh) -> f64 {
    2.0 * half_box_edge(mesh)
}
