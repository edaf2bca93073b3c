//! `section-all-orders` certified (FORMAT section 3.3).

use crate::number::{Vec3, cross, dot, sgn};
use crate::overlay::Overlay;
use crate::shard::Cell;
use crate::world::World;
use crate::{Res, complex, tets};
use num_bigint::BigInt;

/// An overlay that was checked with the cells' part of this claim.
pub(crate) fn check(world: &World, overlay: Overlay<'_>) -> Res {
    for (line, ids, names) in &overlay.boundary {
        let middle = names.iter().all(|n| n % 3 == 1);
        let flat = |slab: usize| {
            let &[u, w] = ids.as_slice() else { return false };
            let wall @ [a, b, c, d] = wall(world, u, w, slab);
            names.iter().all(|n| wall.contains(n)) && world.side([a, b, c], d) == 0
        };
        ensure!(middle || flat(0) || flat(1), "all-orders-boundary", "line {line}");
    }
    overlay.against.map_or(Ok(()), Err)
}

/// The rule for one cell, whose fan triangles in coordinates of `f` are made when they are needed.
pub(crate) fn check_cell(world: &World, cell: &Cell, fans: impl Fn() -> Vec<[Vec3; 3]>) -> Res {
    let [f, home] = cell.home;
    let sides = complex::sides(world.shell.of(home)).map(Some);
    for side in std::iter::once(None).chain(sides) {
        let prism = side.map_or(Some(home), |(u, w)| world.shell.across(u, w));
        let steep = prism.map(|q| {
            let mut tets = tets::steep(world, f, q);
            tets.retain(|tet| crosses(world, f, tet.names));
            tets
        });
        if steep.as_ref().is_some_and(Vec::is_empty) {
            continue;
        }
        let mut pieces: Vec<Vec<Vec3>> = fans().into_iter().map(Vec::from).collect();
        if let Some((u, w)) = side {
            let walls = [0, 1].map(|slab| wall(world, u, w, slab));
            pieces = walls.iter().flat_map(|wall| pieces.iter().map(|p| clip(world, f, *wall, p))).collect();
        }
        let bad = |piece: &Vec<Vec3>| match &steep {
            // Behind a boundary side no prism takes over what the flipped wall gives away.
            None => has_area(piece),
            Some(tets) => tets.iter().any(|t| has_area(&clip(world, f, t.names, piece))),
        };
        ensure!(!pieces.iter().any(bad), "all-orders", "line {}: prism {home}, side {side:?}", cell.line);
    }
    Ok(())
}

/// The names `lo_u lo_w hi_w hi_u` of a slab's wall; flat (two are equal) if `u` or `w` is pinched.
fn wall(world: &World, u: usize, w: usize, slab: usize) -> [usize; 4] {
    [world.name(u, slab), world.name(w, slab), world.name(w, slab + 1), world.name(u, slab + 1)]
}

/// Whether a tet may meet the plane of `f` in a set of positive area: it has points on both sides, or a face in it.
fn crosses(world: &World, f: usize, tet: [usize; 4]) -> bool {
    let sides = tet.map(|x| world.side(world.corners(f), x));
    sides.contains(&1) && sides.contains(&-1) || sides.iter().filter(|s| **s == 0).count() == 3
}

/// A convex piece of triangle `f` (homogeneous coordinates in `f`) cut with a closed tet; nothing if the tet is flat, or
/// if all of `f` is on the closed outer side of a face (where no area remains).
fn clip(world: &World, f: usize, tet: [usize; 4], piece: &[Vec3]) -> Vec<Vec3> {
    let orientation = world.side([tet[0], tet[1], tet[2]], tet[3]);
    let mut piece = piece.to_vec();
    for face in 0..4 {
        let at = world.corners(f).map(|x| world.replaced(tet, face, x));
        let sides = at.map(|rows| world.sign(rows) * orientation);
        let outside = sides.contains(&-1) && !sides.contains(&1);
        if orientation == 0 || outside || piece.is_empty() {
            return Vec::new();
        }
        if sides.contains(&-1) {
            piece = cut(&piece, &at.map(|rows| world.det(rows) * orientation));
        }
    }
    piece
}

/// The part of a convex polygon where the linear function with these corner values is not negative.
fn cut(piece: &[Vec3], plane: &Vec3) -> Vec<Vec3> {
    let height = |x: &Vec3| -> BigInt { x.iter().zip(plane).map(|(a, b)| a * b).sum() };
    let mut out = Vec::new();
    for (x, y) in piece.iter().zip(piece.iter().cycle().skip(1)) {
        let (hx, hy) = (height(x), height(y));
        if sgn(&hx) >= 0 {
            out.push(x.clone());
        }
        if sgn(&hx) * sgn(&hy) < 0 {
            // x hy - y hx is where the function vanishes; its sign must be that of a positive combination.
            out.push(std::array::from_fn(|i| (&x[i] * &hy - &y[i] * &hx) * sgn(&hy)));
        }
    }
    out
}

fn has_area(piece: &[Vec3]) -> bool {
    (2..piece.len()).any(|i| sgn(&dot(&cross(&piece[0], &piece[i - 1]), &piece[i])) != 0)
}

#[cfg(test)]
mod tests;
