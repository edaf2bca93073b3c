//! Thickness of an initial shell: a first guess by casting pillars as rays, then shrinking until the exact claims hold
//! (*Shell* section 3.3).

use rayon::prelude::*;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::direction::{float_cross, float_dot};
use super::draft::Draft;
use super::gate::BuildError;
use super::overlap;
use crate::certify::complex::{Boundary, MeshView};
use crate::certify::disjoint::{self, About};
use crate::certify::{Observer, i2, positivity};
use crate::mesh::{Connectivity, TriMesh};
use crate::shell::{Layer, Name, Slab};

/// What is left of a free ray: bottom and top keep a distance from what the ray hits.
const CLEARANCE: f64 = 0.4;
/// What is left of a thickness after one shrinking.
const SHRINK: f64 = 0.7;
/// A thickness below this share of its first guess will not do: whatever is in the way does not get out of it by
/// shrinking (*Shell* Figure 14). Not a tolerance: what is built is judged exactly, this only ends the attempt.
const LEAST: f64 = 1e-6;

/// Sets every vertex's thickness to `most`, or to a share of the free way along its pillar, if that is less.
pub(crate) fn first_guess(draft: &mut Draft, mesh: &TriMesh, most: f64) {
    let corners = |f: &[u32; 3]| f.map(|v| mesh.vertices[v as usize]);
    let leaf = |(id, f): (usize, &[u32; 3])| {
        let p = corners(f);
        let low = std::array::from_fn(|i| p[0][i].min(p[1][i]).min(p[2][i]));
        let high = std::array::from_fn(|i| p[0][i].max(p[1][i]).max(p[2][i]));
        GeomWithData::new(Rectangle::from_corners(low, high), u32::try_from(id).unwrap_or(u32::MAX))
    };
    let tree = RTree::bulk_load(mesh.faces.iter().enumerate().map(leaf).collect());
    let free: Vec<[f64; 2]> = (0..draft.middle.len())
        .into_par_iter()
        .map(|v| {
            let (m, d) = (draft.middle[v], draft.direction[v]);
            [1.0, -1.0].map(|sign| free_way(mesh, &tree, m, d.map(|x| x * sign), most))
        })
        .collect();
    for (v, [up, down]) in free.into_iter().enumerate() {
        draft.up[v] = most.min(CLEARANCE * up);
        draft.down[v] = most.min(CLEARANCE * down);
    }
}

/// How far a ray goes, up to a little more than `most`, before it hits a triangle that it does not start in.
fn free_way(
    mesh: &TriMesh,
    tree: &RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>,
    from: [f64; 3],
    direction: [f64; 3],
    most: f64,
) -> f64 {
    let reach = most / CLEARANCE;
    // Nested boxes: most rays end soon, and a long thin box would hold much of the mesh.
    let mut length = reach / 64.0;
    loop {
        length = (length * 4.0).min(reach);
        let to: [f64; 3] = std::array::from_fn(|i| from[i] + length * direction[i]);
        let hit = tree
            .locate_in_envelope_intersecting(&AABB::from_corners(from, to))
            .filter_map(|g| hit(mesh, g.data, &from, &direction))
            .fold(f64::INFINITY, f64::min);
        if hit <= length || length >= reach {
            return hit.min(reach);
        }
    }
}

/// The ray's parameter at a triangle; hits at the very start are the ray's own triangles. A guess in floats.
fn hit(mesh: &TriMesh, f: u32, from: &[f64; 3], direction: &[f64; 3]) -> Option<f64> {
    let [a, b, c] = mesh.faces[f as usize].map(|v| mesh.vertices[v as usize]);
    let minus = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| p[i] - q[i]) };
    let (e1, e2) = (minus(&b, &a), minus(&c, &a));
    let p = float_cross(direction, &e2);
    let volume = float_dot(&e1, &p);
    let s = minus(from, &a);
    let q = float_cross(&s, &e1);
    let (u, v, t) =
        (float_dot(&s, &p) / volume, float_dot(direction, &q) / volume, float_dot(&e2, &q) / volume);
    let size = e1.iter().chain(&e2).fold(0.0f64, |m, x| m.max(x.abs()));
    (u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9 && t > 1e-7 * size).then_some(t)
}

/// How shrinking ended.
pub(crate) enum Shrunk {
    /// All conditions hold, after so many rounds.
    Fits(usize),
    /// These vertices have no thickness left, in prisms over these triangles, for this reason.
    Stuck { places: Vec<(u32, u32)>, reason: &'static str },
}

/// Shrinks until all 24 tets of every prism are positive, no mesh triangle meets bottom or top, and no triangle touches
/// a tet in the wrong direction (C1 and the extra conditions of C3+); if wanted, until the shell does not overlap itself.
pub(crate) fn shrink(
    draft: &mut Draft,
    mesh: &TriMesh,
    connectivity: &Connectivity,
    no_overlap: bool,
    observer: &dyn Observer,
) -> Result<Shrunk, BuildError> {
    let boundary = Boundary::new(connectivity);
    let view = MeshView { vertices: &mesh.vertices, faces: &mesh.faces, connectivity, boundary: &boundary };
    let least = [&draft.down, &draft.up].map(|t| t.iter().map(|x| x * LEAST).collect::<Vec<f64>>());
    for round in 0.. {
        let (mut wrong, mut reason) = wrong(draft, &view, observer)?;
        if no_overlap && wrong.is_empty() {
            (wrong, reason) = (overlap::slabs(&draft.shell(), observer)?, "the prism overlaps another one");
        }
        wrong.sort_unstable();
        wrong.dedup();
        let Some(&(first, _)) = wrong.first() else { return Ok(Shrunk::Fits(round)) };
        let stuck = reduce(draft, &wrong, &least);
        if !stuck.is_empty() {
            let over = |v: u32| wrong.iter().map(|w| w.0).find(|&p| draft.faces[p as usize].contains(&v));
            let places =
                stuck.iter().map(|&v| (v, draft.origin[over(v).unwrap_or(first) as usize])).collect();
            return Ok(Shrunk::Stuck { places, reason });
        }
    }
    Ok(Shrunk::Fits(0))
}

/// Slabs of prisms and the condition that they break.
type Wrong = (Vec<(u32, Slab)>, &'static str);

/// The slabs that break a condition, the cheapest condition first, and which one it is.
fn wrong(draft: &Draft, view: &MeshView<'_>, observer: &dyn Observer) -> Result<Wrong, BuildError> {
    let shell = draft.shell();
    let slab = |names: &[Name]| {
        if names.iter().any(|n| n.layer == Layer::Top) { Slab::Top } else { Slab::Bottom }
    };
    let bad = positivity::decide(&shell, observer)?.bad;
    if !bad.is_empty() {
        return Ok((bad.iter().map(|b| (b.prism, slab(&b.names))).collect(), "the prism is not positive"));
    }
    let mut wrong = Vec::new();
    for (about, slab) in [(About::Bottom, Slab::Bottom), (About::Top, Slab::Top)] {
        let found = disjoint::decide(view, &shell, about, observer)?;
        wrong.extend(found.crossings.iter().map(|c| (c.second, slab)));
    }
    if !wrong.is_empty() {
        return Ok((wrong, "the mesh meets bottom or top"));
    }
    let found = i2::decide(view, &shell, observer)?;
    let wrong = found.contacts.iter().map(|c| (c.prism, slab(&c.names))).collect();
    Ok((wrong, "a triangle touches the prism in the wrong direction"))
}

/// Shrinks the corners of each prism in the slab, each vertex once; the vertices that fall below the least thickness.
fn reduce(draft: &mut Draft, wrong: &[(u32, Slab)], least: &[Vec<f64>; 2]) -> Vec<u32> {
    let mut corners: Vec<(u32, Slab)> =
        wrong.iter().flat_map(|&(p, slab)| draft.faces[p as usize].map(|v| (v, slab))).collect();
    corners.sort_unstable();
    corners.dedup();
    let mut stuck = Vec::new();
    for (v, slab) in corners.into_iter().filter(|(v, _)| !draft.pinched[*v as usize]) {
        let k = v as usize;
        let (thickness, least) = match slab {
            Slab::Bottom => (&mut draft.down[k], least[0][k]),
            Slab::Top => (&mut draft.up[k], least[1][k]),
        };
        *thickness *= SHRINK;
        if *thickness < least {
            stuck.push(v);
        }
    }
    stuck
}
