//! C2 and C4 for one order, C3 for all: every way to lift the mesh is tried.
//!
//! A lift is a choice of pieces: its sheet can't change inside a piece, because no other point of the abstract shell is
//! near. So the chosen pieces tile every triangle, and across each side of a chosen piece lies a chosen piece with the same
//! side, as points of the mesh and of the abstract shell, reversed. Two pieces of one triangle with one directed side
//! overlap: there the tets wind more than once around an edge ("ambiguous"). Where this does not happen, a lift of a
//! component of the mesh is a connected component of the pieces. The definitions are then checked on it.

use std::collections::{HashMap, HashSet};

use dashu_ratio::RBig;

use super::exact::{Weights, overlap, positive};
use super::{Piece, World, components};

/// The answer for one order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// A lift with everything that C2 and C4 ask for.
    Exists,
    /// There is none.
    None,
    /// Tets overlap around an edge and the mesh runs along it.
    Ambiguous,
}

/// What a connected component of pieces turned out to be.
enum Lift {
    Onto(usize),
    Not,
    Ambiguous,
}

/// C2 and C4 under the order `rank`.
pub fn section(world: &mut World<'_>, rank: &[usize]) -> Section {
    let selected = world.selected(rank);
    if !selected.iter().all(|&t| positive(&world.determinants[t])) {
        return Section::None;
    }
    let pieces = all_pieces(world, &selected);
    let parts = connected(&pieces);
    let mesh_part = components(&world.mesh.faces);
    let middle_part = components(&world.shell.faces);
    let count = |of: &[usize]| of.iter().max().map_or(0, |m| m + 1);
    let mut targets: Vec<HashSet<usize>> = vec![HashSet::new(); count(&mesh_part)];
    let mut ambiguous = false;
    for part in parts {
        match judge(world, &pieces, &part, &mesh_part, &middle_part) {
            Lift::Onto(target) => {
                targets[mesh_part[pieces[part[0]].face]].insert(target);
            }
            Lift::Not => {}
            Lift::Ambiguous => ambiguous = true,
        }
    }
    if ambiguous {
        return Section::Ambiguous;
    }
    let exists = targets.len() == count(&middle_part) && matched(&targets, &mut HashSet::new());
    if exists { Section::Exists } else { Section::None }
}

/// Can every component of the mesh have a component of the middle complex of its own?
fn matched(targets: &[HashSet<usize>], taken: &mut HashSet<usize>) -> bool {
    let Some((first, rest)) = targets.split_first() else { return true };
    first.iter().any(|&t| {
        if !taken.insert(t) {
            return false;
        }
        let found = matched(rest, taken);
        taken.remove(&t);
        found
    })
}

/// The pieces that face up, each once.
fn all_pieces(world: &mut World<'_>, selected: &[usize]) -> Vec<Piece> {
    let mut known: HashMap<(usize, Vec<usize>), usize> = HashMap::new();
    let mut out: Vec<Piece> = Vec::new();
    for f in 0..world.mesh.faces.len() {
        for &t in selected {
            let Some(piece) = world.piece(f, t) else { continue };
            let mut key = piece.corners.clone();
            key.sort_unstable();
            if let Some(&same) = known.get(&(f, key.clone())) {
                // In the common face of two tets: it must face up in both.
                out[same].faces_up &= piece.faces_up;
            } else {
                known.insert((f, key), out.len());
                out.push(piece);
            }
        }
    }
    // A section has no other pieces. (Without them nothing runs along a pillar, around which tets may wind twice.)
    out.retain(|piece| piece.faces_up);
    out
}

/// Directed sides.
fn sides(piece: &Piece) -> impl Iterator<Item = (usize, usize)> + '_ {
    let n = piece.corners.len();
    (0..n).map(move |i| (piece.corners[i], piece.corners[(i + 1) % n]))
}

fn by_side(pieces: &[Piece]) -> HashMap<(usize, usize), Vec<usize>> {
    let mut out: HashMap<(usize, usize), Vec<usize>> = HashMap::new();
    for (id, piece) in pieces.iter().enumerate() {
        sides(piece).for_each(|side| out.entry(side).or_default().push(id));
    }
    out
}

fn connected(pieces: &[Piece]) -> Vec<Vec<usize>> {
    let at = by_side(pieces);
    let mut seen = vec![false; pieces.len()];
    let mut out = Vec::new();
    for start in 0..pieces.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut part = vec![start];
        let mut next = 0;
        while next < part.len() {
            for (a, b) in sides(&pieces[part[next]]) {
                // Pieces with the same side, too: the ambiguous ones belong together.
                for &other in [(a, b), (b, a)].iter().filter_map(|s| at.get(s)).flatten() {
                    if !seen[other] {
                        seen[other] = true;
                        part.push(other);
                    }
                }
            }
            next += 1;
        }
        out.push(part);
    }
    out
}

fn judge(
    world: &World<'_>,
    pieces: &[Piece],
    part: &[usize],
    mesh_part: &[usize],
    middle_part: &[usize],
) -> Lift {
    let chosen: Vec<Piece> = part.iter().map(|&p| pieces[p].clone()).collect();
    let at = by_side(&chosen);
    if at.values().any(|list| list.len() > 1) {
        return Lift::Ambiguous;
    }
    let component = mesh_part[chosen[0].face];
    let of_face = |f: usize| chosen.iter().filter(|p| p.face == f).collect::<Vec<_>>();
    for f in (0..mesh_part.len()).filter(|&f| mesh_part[f] == component) {
        let chart = |p: &Piece| p.corners.iter().map(|&c| world.in_face(c, f)).collect();
        if !tiled(&of_face(f), |p| p.area.clone(), chart) {
            return Lift::Not;
        }
    }
    // Of all subsets of a cap that a piece can touch, only the edge between two pinched vertices shows at no corner.
    let touches = |(a, b): (usize, usize)| world.on_cap(&[a]) || world.on_cap(&[a, b]);
    if chosen.iter().flat_map(sides).any(touches) {
        return Lift::Not;
    }
    for (a, b) in chosen.iter().flat_map(sides).filter(|(a, b)| !at.contains_key(&(*b, *a))) {
        assert!(world.on_mesh_boundary(a, b), "a side of a tiling that ends inside the mesh");
        if !world.on_shell_boundary(a, b) {
            return Lift::Not;
        }
    }
    let target = middle_part[chosen[0].prism];
    for prism in (0..middle_part.len()).filter(|&p| middle_part[p] == target) {
        let inside: Vec<&Piece> = chosen.iter().filter(|p| p.prism == prism).collect();
        let chart = |p: &Piece| p.corners.iter().map(|&c| world.in_prism(c, prism)).collect();
        if !tiled(&inside, |p| p.projected.clone(), chart) {
            return Lift::Not;
        }
    }
    Lift::Onto(target)
}

/// Do the polygons cover a triangle once: areas that sum to one, and no two that overlap?
fn tiled(pieces: &[&Piece], area: impl Fn(&Piece) -> RBig, chart: impl Fn(&Piece) -> Vec<Weights>) -> bool {
    let total = pieces.iter().fold(RBig::ZERO, |sum, p| sum + area(p));
    if total != RBig::ONE || pieces.iter().any(|p| area(p) <= RBig::ZERO) {
        return false;
    }
    let polygons: Vec<Vec<Weights>> = pieces.iter().map(|p| chart(p)).collect();
    polygons.iter().enumerate().all(|(i, p)| polygons[..i].iter().all(|q| overlap(p, q).len() < 3))
}

/// C3 by all orders, or by the first `limit` different ones: the first order (ranks) without a section.
///
/// Orders that orient every edge of the middle complex alike select the same tets, and are tried once.
pub fn failing_order(world: &mut World<'_>, limit: usize) -> Option<Vec<usize>> {
    let n = world.shell.middle.len();
    let mut seen: HashSet<Vec<usize>> = HashSet::new();
    let mut order: Vec<usize> = (0..n).collect();
    loop {
        let mut rank = vec![0; n];
        order.iter().enumerate().for_each(|(place, &v)| rank[v] = place);
        if seen.insert(world.selected(&rank)) && section(world, &rank) != Section::Exists {
            return Some(rank);
        }
        if seen.len() >= limit || !next_permutation(&mut order) {
            return None;
        }
    }
}

fn next_permutation(order: &mut [usize]) -> bool {
    let Some(i) = (1..order.len()).rev().find(|&i| order[i - 1] < order[i]) else { return false };
    let j = (i..order.len()).rev().find(|&j| order[j] > order[i - 1]).unwrap();
    order.swap(i - 1, j);
    order[i..].reverse();
    true
}
