//! The middle complex is an oriented manifold, perhaps with boundary.

use super::ShellError;

/// A side of a prism: its vertices in ascending order, whether the prism runs along it in that
/// direction, and the corners (`3 * prism + k`) at the two vertices.
#[derive(Clone, Copy)]
struct Side {
    edge: [u32; 2],
    ascending: bool,
    prism: u32,
    corners: [u32; 2],
}

/// Checks the complex and counts its boundary sides. The faces have three different corners below
/// `vertices`.
pub(super) fn manifold(vertices: usize, faces: &[[u32; 3]]) -> Result<usize, ShellError> {
    different_corners(faces)?;
    let sides = sorted_sides(faces);
    let mut fans = Fans::new(faces.len());
    let mut boundary = 0;
    for group in sides.chunk_by(|a, b| a.edge == b.edge) {
        match *group {
            [_] => boundary += 1,
            [a, b] if a.ascending == b.ascending => {
                return Err(ShellError::Orientation { edge: a.edge, first: a.prism, second: b.prism });
            }
            [a, b] => {
                fans.join(a.corners[0], b.corners[0]);
                fans.join(a.corners[1], b.corners[1]);
            }
            _ => {
                let prisms = group.iter().map(|side| side.prism).collect();
                return Err(ShellError::NonManifoldEdge { edge: group[0].edge, prisms });
            }
        }
    }
    one_fan_each(vertices, faces, &mut fans)?;
    Ok(boundary)
}

fn different_corners(faces: &[[u32; 3]]) -> Result<(), ShellError> {
    let sorted = |mut face: [u32; 3]| {
        face.sort_unstable();
        face
    };
    let mut keyed: Vec<([u32; 3], u32)> = faces.iter().map(|&face| sorted(face)).zip(0..).collect();
    keyed.sort_unstable();
    match keyed.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => {
            Err(ShellError::SameCorners { first: pair[0].1, second: pair[1].1, corners: pair[0].0 })
        }
        None => Ok(()),
    }
}

/// All sides, by edge, then by prism.
fn sorted_sides(faces: &[[u32; 3]]) -> Vec<Side> {
    let mut sides = Vec::with_capacity(faces.len().saturating_mul(3));
    for (prism, face) in (0_u32..).zip(faces) {
        for (k, next) in [(0, 1), (1, 2), (2, 0)] {
            let ascending = face[k] < face[next];
            let (low, high) = if ascending { (k, next) } else { (next, k) };
            let corners = [low, high].map(|corner| corner_id(prism, corner));
            sides.push(Side { edge: [face[low], face[high]], ascending, prism, corners });
        }
    }
    sides.sort_unstable_by_key(|side| (side.edge, side.prism));
    sides
}

/// The number of prisms is limited so that this does not overflow (`validate::lengths`).
#[allow(clippy::cast_possible_truncation)]
fn corner_id(prism: u32, corner: usize) -> u32 {
    prism.saturating_mul(3).saturating_add(corner as u32)
}

fn one_fan_each(vertices: usize, faces: &[[u32; 3]], fans: &mut Fans) -> Result<(), ShellError> {
    let mut first_corner = vec![None; vertices];
    for (prism, face) in (0_u32..).zip(faces) {
        for (k, &vertex) in face.iter().enumerate() {
            let corner = corner_id(prism, k);
            let Some(slot) = first_corner.get_mut(vertex as usize) else { continue };
            let first = *slot.get_or_insert(corner);
            if fans.root(first) != fans.root(corner) {
                return Err(ShellError::NonManifoldVertex { vertex, first: first / 3, second: prism });
            }
        }
    }
    Ok(())
}

/// Corners joined across the sides at their common vertex (union-find with path halving).
struct Fans(Vec<u32>);

impl Fans {
    fn new(prisms: usize) -> Self {
        Self((0..u32::try_from(prisms.saturating_mul(3)).unwrap_or(u32::MAX)).collect())
    }

    fn root(&mut self, mut corner: u32) -> u32 {
        while self.0[corner as usize] != corner {
            let above = self.0[self.0[corner as usize] as usize];
            self.0[corner as usize] = above;
            corner = above;
        }
        corner
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
