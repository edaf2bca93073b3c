//! Thickness of an initial shell: a first guess by casting pillars as rays, then shrinking until the exact claims hold
//! (*Shell* section 3.3).

use rayon::prelude::*;

use self::conditions::{Known, wrong};
use super::direction::{float_cross, float_dot, float_normal};
use super::draft::Draft;
use super::gate::BuildError;
use super::optimise::tree::{Box3, Tree};
use super::overlap;
use crate::certify::Observer;
use crate::certify::complex::{Boundary, MeshView};
use crate::mesh::{Connectivity, TriMesh};
use crate::shell::Slab;

mod conditions;
#[cfg(test)]
mod tests;

/// What is left of a free ray: bottom and top keep a distance from what the ray hits.
const CLEARANCE: f64 = 0.4;
/// What is left of a thickness after one shrinking: more of it at first, and less when it happens again and again.
const SHRINK: [(u32, f64); 3] = [(8, 0.7), (14, 0.5), (u32::MAX, 0.25)];
/// A thickness below this share of the shortest edge at its vertex will not do: whatever is in the way does not get out
/// of it by shrinking (*Shell* Figure 14). Not a tolerance: what is built is judged exactly, this only ends the attempt.
const LEAST: f64 = 1e-13;

const NOT_POSITIVE: &str = "the prism is not positive";

/// What the shell must be clear of.
pub(crate) struct Against<'a> {
    pub(crate) mesh: &'a TriMesh,
    pub(crate) connectivity: &'a Connectivity,
    /// The mesh's triangles by box.
    pub(crate) tree: &'a Tree,
    /// All triangles, or only those that share a vertex with a prism's own one?
    pub(crate) all: bool,
}

impl Against<'_> {
    /// Does the triangle count for prisms and rays on these ones?
    fn counts(&self, f: u32, own: &[u32]) -> bool {
        self.all || own.iter().any(|&o| self.touch(f, o))
    }

    fn touch(&self, f: u32, g: u32) -> bool {
        let [f, g] = [f, g].map(|f| self.mesh.faces[f as usize]);
        f.iter().any(|v| g.contains(v))
    }
}

/// Sets every vertex's thickness to `most`, or to a share of the free way along its pillar, if that is less.
pub(crate) fn first_guess(draft: &mut Draft, against: &Against<'_>, most: f64) {
    // The triangles that each vertex lies in: a ray does not come back to them, but rounding may have put its start
    // beside them.
    let mut own: Vec<Vec<u32>> = vec![Vec::new(); draft.middle.len()];
    for (face, &origin) in draft.faces.iter().zip(&draft.origin) {
        for &v in face {
            if !own[v as usize].contains(&origin) {
                own[v as usize].push(origin);
            }
        }
    }
    let free: Vec<[f64; 2]> = (0..draft.middle.len())
        .into_par_iter()
        .map(|v| {
            let ray = Ray { against, from: draft.middle[v], own: &own[v] };
            [1.0, -1.0].map(|sign| ray.free_way(&draft.direction[v].map(|x| x * sign), most))
        })
        .collect();
    for (v, [up, down]) in free.into_iter().enumerate() {
        draft.up[v] = most.min(CLEARANCE * up);
        draft.down[v] = most.min(CLEARANCE * down);
    }
}

/// A ray from a vertex.
struct Ray<'a> {
    against: &'a Against<'a>,
    from: [f64; 3],
    /// Triangles that it starts in.
    own: &'a [u32],
}

impl Ray<'_> {
    /// How far it goes, up to a little more than `most`, before it hits a triangle.
    fn free_way(&self, direction: &[f64; 3], most: f64) -> f64 {
        let reach = most / CLEARANCE;
        // Nested boxes: most rays end soon, and a long thin box would hold much of the mesh.
        let mut length = reach / 64.0;
        loop {
            length = (length * 4.0).min(reach);
            let to: [f64; 3] = std::array::from_fn(|i| self.from[i] + length * direction[i]);
            let mut hit = f64::INFINITY;
            self.against.tree.all(&Box3::of([&self.from, &to]), |f| {
                if !self.own.contains(&f) && self.against.counts(f, self.own) {
                    hit = hit.min(self.hit(f, direction).unwrap_or(f64::INFINITY));
                }
                true
            });
            if hit <= length || length >= reach {
                return hit.min(reach);
            }
        }
    }

    /// The ray's parameter at a triangle. A guess in floats.
    fn hit(&self, f: u32, direction: &[f64; 3]) -> Option<f64> {
        let [a, b, c] = self.against.mesh.faces[f as usize].map(|v| self.against.mesh.vertices[v as usize]);
        let minus = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| p[i] - q[i]) };
        let (e1, e2) = (minus(&b, &a), minus(&c, &a));
        let p = float_cross(direction, &e2);
        let volume = float_dot(&e1, &p);
        let s = minus(&self.from, &a);
        let q = float_cross(&s, &e1);
        let (u, v, t) =
            (float_dot(&s, &p) / volume, float_dot(direction, &q) / volume, float_dot(&e2, &q) / volume);
        (u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9 && t > 0.0).then_some(t)
    }
}

/// How shrinking ended.
pub(crate) enum Shrunk {
    /// All conditions hold, after so many rounds.
    Fits(usize),
    /// These vertices have no thickness left, in prisms over these triangles, for this reason.
    Stuck { places: Vec<(u32, u32)>, reason: &'static str },
}

/// Shrinks until all 24 tets of every prism are positive, no mesh triangle meets bottom or top, and no triangle touches
/// a tet in the wrong direction (C1 and the extra conditions of C3+).
pub(crate) fn shrink(
    draft: &mut Draft,
    against: &Against<'_>,
    no_overlap: bool,
    observer: &dyn Observer,
) -> Result<Shrunk, BuildError> {
    let (mesh, connectivity) = (against.mesh, against.connectivity);
    let boundary = Boundary::new(connectivity);
    let view = MeshView { vertices: &mesh.vertices, faces: &mesh.faces, connectivity, boundary: &boundary };
    let mut patience = Patience::new(draft);
    let mut known = Known::nothing(draft.faces.len());
    for round in 0.. {
        let (mut wrong, mut reason) = wrong(draft, against, &view, &mut known, observer)?;
        if no_overlap && wrong.is_empty() {
            (wrong, reason) = (overlap::slabs(&draft.shell(), observer)?, "the prism overlaps another one");
        }
        wrong.sort_unstable();
        wrong.dedup();
        let Some(&(first, _)) = wrong.first() else { return Ok(Shrunk::Fits(round)) };
        let stuck = reduce(draft, mesh, (&wrong, reason), &mut patience, &mut known);
        if !stuck.is_empty() {
            let over = |v: u32| wrong.iter().map(|w| w.0).find(|&p| draft.faces[p as usize].contains(&v));
            let places =
                stuck.iter().map(|&v| (v, draft.origin[over(v).unwrap_or(first) as usize])).collect();
            return Ok(Shrunk::Stuck { places, reason });
        }
    }
    Ok(Shrunk::Fits(0))
}

/// How far shrinking may go.
struct Patience {
    /// The least thickness that is tried, by vertex.
    least: Vec<f64>,
    /// How often each vertex was shrunk, by slab.
    times: [Vec<u32>; 2],
}

impl Patience {
    fn new(draft: &Draft) -> Self {
        let n = draft.middle.len();
        let mut least = vec![f64::INFINITY; n];
        for face in &draft.faces {
            for [u, w] in [[0, 1], [1, 2], [2, 0]].map(|[i, j]| [face[i] as usize, face[j] as usize]) {
                let d: [f64; 3] = std::array::from_fn(|i| draft.middle[u][i] - draft.middle[w][i]);
                let length = float_dot(&d, &d).sqrt();
                least[u] = least[u].min(LEAST * length);
                least[w] = least[w].min(LEAST * length);
            }
        }
        // Below the spacing of doubles there are no other points.
        for (least, m) in least.iter_mut().zip(&draft.middle) {
            *least = least.max(m.iter().fold(0.0, |s, x| x.abs().max(s)) * f64::EPSILON);
        }
        Self { least, times: [vec![0; n], vec![0; n]] }
    }
}

/// The corners of a prism that are to blame: those of half the largest thickness or more. A thin corner beside a thick
/// one gains nothing by becoming thinner. For a prism that is not positive it is the height over the triangle that
/// counts: a long pillar that leans is low.
fn to_blame(
    draft: &Draft,
    mesh: &TriMesh,
    (prism, slab): (u32, Slab),
    by_height: bool,
) -> impl Iterator<Item = (u32, Slab)> {
    let origin = mesh.faces[draft.origin[prism as usize] as usize];
    let normal = float_normal(origin.map(|v| &mesh.vertices[v as usize]));
    let size = |v: u32| {
        let k = v as usize;
        let thickness = if slab == Slab::Bottom { draft.down[k] } else { draft.up[k] };
        let share = if by_height { float_dot(&draft.direction[k], &normal) } else { 1.0 };
        if draft.pinched[k] { 0.0 } else { thickness * share }
    };
    let face = draft.faces[prism as usize];
    let most = face.map(size).into_iter().fold(0.0, f64::max);
    let large = face.map(|v| (v, size(v) >= 0.5 * most));
    large.into_iter().filter(|(_, large)| *large).map(move |(v, _)| (v, slab))
}

/// Shrinks the thick corners of each prism in the slab, each vertex once, and forgets what was known of the prisms there; the
/// vertices that fall below the least thickness.
fn reduce(
    draft: &mut Draft,
    mesh: &TriMesh,
    (wrong, reason): (&[(u32, Slab)], &str),
    patience: &mut Patience,
    known: &mut Known,
) -> Vec<u32> {
    let by_height = reason == NOT_POSITIVE;
    let mut corners: Vec<(u32, Slab)> =
        wrong.iter().flat_map(|&w| to_blame(draft, mesh, w, by_height)).collect();
    corners.sort_unstable();
    corners.dedup();
    let mut stuck = Vec::new();
    let mut moved = vec![false; draft.middle.len()];
    for (v, slab) in corners.into_iter().filter(|(v, _)| !draft.pinched[*v as usize]) {
        let k = v as usize;
        let (thickness, times) = match slab {
            Slab::Bottom => (&mut draft.down[k], &mut patience.times[0][k]),
            Slab::Top => (&mut draft.up[k], &mut patience.times[1][k]),
        };
        let share = SHRINK.iter().find(|(until, _)| *times < *until).map_or(0.25, |(_, share)| *share);
        *times = times.saturating_add(1);
        *thickness *= share;
        moved[k] = true;
        if *thickness < patience.least[k] {
            stuck.push(v);
        }
    }
    known.forget(&draft.faces, &moved);
    stuck
}
