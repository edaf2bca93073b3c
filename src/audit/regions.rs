//! Groups of violations that hang together.

use std::collections::{BTreeMap, BTreeSet};

use super::report::{Region, Violation, ViolationKind};
use crate::mesh::Connectivity;
use crate::mesh::connectivity::Sets;

/// Connected sets of violations of one kind: by common vertices of their triangles, or, where nothing covers, by common
/// walls of their prisms. Ordered by kind, then by first violation. O(n log n).
pub(crate) fn regions(violations: &[Violation], mesh: &Connectivity, middle: &Connectivity) -> Vec<Region> {
    let mut joined = Sets::new(violations.len());
    for kind in ViolationKind::ALL {
        let mut at: BTreeMap<Place, u32> = BTreeMap::new();
        for (i, violation) in (0u32..).zip(violations).filter(|(_, v)| v.kind == kind) {
            for place in places(violation, mesh, middle) {
                match at.get(&place) {
                    Some(&other) => joined.join(i, other),
                    None => {
                        at.insert(place, i);
                    }
                }
            }
        }
    }
    let mut sets: BTreeMap<(ViolationKind, u32), Vec<usize>> = BTreeMap::new();
    for (i, violation) in (0u32..).zip(violations) {
        sets.entry((violation.kind, joined.find(i))).or_default().push(i as usize);
    }
    sets.into_iter().map(|((kind, _), members)| region(kind, members, violations)).collect()
}

/// What two violations of a region have in common.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Vertex(u32),
    Wall([u32; 2]),
}

fn places(violation: &Violation, mesh: &Connectivity, middle: &Connectivity) -> Vec<Place> {
    use crate::mesh::connectivity::Side;
    match (violation.triangle, violation.prism) {
        (Some(triangle), _) => {
            let others = violation.other.as_ref().map(|(f, _)| *f);
            let faces = std::iter::once(triangle).chain(others);
            faces
                .flat_map(|f| (0..3).map(move |i| Side::new(f, i)))
                .map(|c| Place::Vertex(mesh.vertex(c)))
                .collect()
        }
        (None, Some(prism)) => (0..3)
            .map(|i| {
                let [u, w] = middle.ends(Side::new(prism, i));
                Place::Wall([u.min(w), u.max(w)])
            })
            .collect(),
        (None, None) => Vec::new(),
    }
}

fn region(kind: ViolationKind, members: Vec<usize>, violations: &[Violation]) -> Region {
    let of = |i: &usize| &violations[*i];
    let triangles: BTreeSet<u32> = members
        .iter()
        .map(of)
        .flat_map(|v| v.triangle.into_iter().chain(v.other.as_ref().map(|(f, _)| *f)))
        .collect();
    let prisms: BTreeSet<u32> = members.iter().filter_map(|i| of(i).prism).collect();
    Region {
        kind,
        triangles: triangles.into_iter().collect(),
        prisms: prisms.into_iter().collect(),
        violations: members,
    }
}
