//! `section-all-orders` certified (FORMAT section 3.3).

use crate::number::Num;
use crate::overlay::{Overlay, Row};
use crate::world::World;
use crate::{Res, complex, ensure, tets};
use num_bigint::BigInt;

pub(crate) fn check<N: Num>(world: &World<N>, overlay: &Overlay<'_>) -> Res {
    for (line, ids, names) in overlay.boundary() {
        let middle = names.iter().all(|n| n % 3 == 1);
        let flat = |slab: usize| {
            let &[u, w] = ids.as_slice() else { return false };
            let wall = wall(world, u, w, slab);
            names.iter().all(|n| wall.contains(n)) && determinant(world, wall).sgn() == 0
        };
        ensure(middle || flat(0) || flat(1), "all-orders-boundary", || format!("line {line}"))?;
    }
    for cell in &overlay.cells {
        let f = cell.triangle;
        let home = world.shell.triangles[cell.prism];
        let across = complex::sides(home)
            .into_iter()
            .filter_map(|(u, w)| Some((world.shell.across(u, w)?, Some((u, w)))));
        for (prism, side) in std::iter::once((cell.prism, None)).chain(across) {
            if world.rises(f, prism) {
                continue;
            }
            let mut pieces: Vec<Vec<Row>> = overlay.pieces(world, cell).into_iter().map(Vec::from).collect();
            if let Some((u, w)) = side {
                let slabs = (0..2).filter(|_| !world.pinched[u] && !world.pinched[w]);
                pieces = slabs
                    .flat_map(|slab| pieces.iter().map(move |p| (slab, p)))
                    .map(|(slab, piece)| clip(world, f, wall(world, u, w, slab), piece))
                    .collect();
            }
            for tet in tets::all(&world.pinched, world.shell.triangles[prism]) {
                let bad = world.dot(f, &tet).sgn() <= 0
                    && pieces.iter().any(|piece| has_area(&clip(world, f, tet.names, piece)));
                ensure(!bad, "all-orders", || {
                    format!("line {}: prism {prism}, tet {}", cell.line, crate::show(&tet.names))
                })?;
            }
        }
    }
    Ok(())
}

/// The names `lo_u lo_w hi_w hi_u` of a slab's wall.
fn wall<N: Num>(world: &World<N>, u: usize, w: usize, slab: usize) -> [usize; 4] {
    let name = |v: usize, layer: usize| if world.pinched[v] { 3 * v + 1 } else { 3 * v + layer };
    [name(u, slab), name(w, slab), name(w, slab + 1), name(u, slab + 1)]
}

fn determinant<N: Num>(world: &World<N>, [a, b, c, d]: [usize; 4]) -> N {
    world.orient(a, b, c, d)
}

/// A convex piece of triangle `f` (homogeneous coordinates in `f`) cut with a closed tet; nothing if the tet is flat.
fn clip<N: Num>(world: &World<N>, f: usize, tet: [usize; 4], piece: &[Row]) -> Vec<Row> {
    let sign = determinant(world, tet).sgn();
    if sign == 0 {
        return Vec::new();
    }
    let at = world.corners(f).map(|x| world.coordinates(tet, x));
    let mut piece = piece.to_vec();
    for face in 0..4 {
        let plane = at.each_ref().map(|values| values[face].big() * sign);
        piece = cut(&piece, &plane);
    }
    piece
}

/// The part of a convex polygon where the linear function with these corner values is not negative.
fn cut(piece: &[Row], plane: &Row) -> Vec<Row> {
    let height = |x: &Row| -> BigInt { x.iter().zip(plane).map(|(a, b)| a * b).sum() };
    let mut out = Vec::new();
    for (x, y) in piece.iter().zip(piece.iter().cycle().skip(1)) {
        let (hx, hy) = (height(x), height(y));
        if hx.sgn() >= 0 {
            out.push(x.clone());
        }
        if hx.sgn() * hy.sgn() < 0 {
            // x hy - y hx is where the function vanishes; its sign must be that of a positive combination.
            let s = hy.sgn();
            out.push(std::array::from_fn(|i| (&x[i] * &hy - &y[i] * &hx) * s));
        }
    }
    out
}

fn has_area(piece: &[Row]) -> bool {
    piece.windows(2).skip(1).any(|w| crate::number::det(&piece[0], &w[0], &w[1]).sgn() != 0)
}

#[cfg(test)]
mod tests;
