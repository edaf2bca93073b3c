//! The lift as one core finds it that looks across one side after another, against the lift that is looked ahead of.

use std::collections::HashMap;

use super::{lifting, sphere};
use crate::certify::Silent;
use crate::certify::clip::{Mask, SIDES};
use crate::certify::lift::{Carriers, Lifting, Reason, Stop, Violation};
use crate::predicate::StageCounts;
use crate::shell::Name;
use crate::testing::Random;

type Corners = Vec<(Mask, Carriers)>;

/// The lift of one core.
struct Sequential<'a> {
    cx: Lifting<'a>,
    /// Triangle, tet, and where each piece was entered from.
    pieces: Vec<(u32, u32, u32, u8)>,
    corners: Vec<Corners>,
    index: HashMap<(u32, u32), usize>,
    stages: StageCounts,
}

fn has_side(corners: &Corners, ends: [Carriers; 2]) -> bool {
    (0..corners.len()).any(|i| [corners[i].1, corners[(i + 1) % corners.len()].1] == ends)
}

impl Sequential<'_> {
    /// The corners of a piece, and whether it is a fold.
    fn piece(&mut self, face: u32, tet: u32) -> Option<(Corners, bool)> {
        let polygon = self.cx.piece(face, tet, &mut self.stages)?;
        let fold = !self.cx.dot(face, tet, &mut self.stages).is_positive();
        let corners = polygon.corners().iter().map(|c| (c.mask, self.cx.carriers(face, tet, c.mask)));
        Some((corners.collect(), fold))
    }

    fn flood(&mut self, face: u32, tet: u32) -> Result<(), Stop> {
        let Some(root) = self.piece(face, tet) else { return Ok(()) };
        self.add((face, tet), root, (0, 0))?;
        let mut next = 0;
        while next < self.pieces.len() {
            for side in 0..self.corners[next].len() {
                self.cross(next, side)?;
            }
            next += 1;
        }
        Ok(())
    }

    fn add(
        &mut self,
        (face, tet): (u32, u32),
        (corners, fold): (Corners, bool),
        from: (u32, u8),
    ) -> Result<(), Stop> {
        let piece = self.pieces.len() as u32;
        let cap = corners.iter().position(|(_, c)| self.cx.complex.in_cap(c.shell()));
        self.pieces.push((face, tet, from.0, from.1));
        self.corners.push(corners);
        self.index.insert((face, tet), piece as usize);
        if fold {
            return Err(Stop::Violation(Violation { piece, reason: Reason::Fold }));
        }
        cap.map_or(Ok(()), |corner| {
            Err(Stop::Violation(Violation { piece, reason: Reason::Cap { corner: corner as u8 } }))
        })
    }

    fn cross(&mut self, id: usize, k: usize) -> Result<(), Stop> {
        let (face, tet, ..) = self.pieces[id];
        let corners = &self.corners[id];
        let ((mask_a, a), (mask_b, b)) = (corners[k], corners[(k + 1) % corners.len()]);
        let along = self.cx.carriers(face, tet, mask_a & mask_b);
        let side = k as u8;
        let violation = |reason| Err(Stop::Violation(Violation { piece: id as u32, reason }));
        if self.cx.complex.in_cap(along.shell()) {
            return violation(Reason::CapSide { side });
        }
        let on_wall = self.cx.complex.in_boundary_wall(along.shell());
        let of_mesh = mask_a & mask_b & SIDES;
        let next =
            if of_mesh == 0 { Some(face) } else { self.cx.mesh.across(face, of_mesh.trailing_zeros()) };
        match (next, on_wall) {
            (None, true) => Ok(()),
            (None, false) => violation(Reason::Boundary { side }),
            (Some(_), true) => violation(Reason::Wall { side }),
            (Some(next), false) => self.enter((id as u32, side), next, [b, a], along.shell()),
        }
    }

    fn enter(&mut self, from: (u32, u8), face: u32, ends: [Carriers; 2], names: &[Name]) -> Result<(), Stop> {
        let mut found = None;
        let star: Vec<u32> = self.cx.complex.star(names).collect();
        for tet in star {
            if let Some(&known) = self.index.get(&(face, tet)) {
                if has_side(&self.corners[known], ends) {
                    return Ok(());
                }
                continue;
            }
            let Some(piece) = self.piece(face, tet).filter(|(c, _)| has_side(c, ends)) else { continue };
            if piece.1 {
                return self.add((face, tet), piece, from);
            }
            if found.is_some() {
                return Err(Stop::Branched(names.to_vec()));
            }
            found = Some((tet, piece));
        }
        match found {
            Some((tet, piece)) => self.add((face, tet), piece, from),
            None => Err(Stop::Branched(names.to_vec())),
        }
    }
}

/// All that a lift is: pieces, corners, the end; and the decisions that it took.
type Whole = (Vec<(u32, u32, u32, u8)>, Corners, String, StageCounts);

fn sequential(cx: Lifting<'_>, face: u32, tet: u32) -> Whole {
    let (pieces, corners, index) = (Vec::new(), Vec::new(), HashMap::new());
    let mut lift = Sequential { cx, pieces, corners, index, stages: StageCounts::default() };
    let stop = lift.flood(face, tet).err();
    (lift.pieces, lift.corners.concat(), format!("{stop:?}"), lift.stages)
}

fn ahead(cx: Lifting<'_>, face: u32, tet: u32) -> Whole {
    let (lift, stop) = cx.flood(face, tet, &Silent);
    let pieces = lift.pieces.iter().map(|p| (p.face, p.tet, p.parent, p.parent_side)).collect();
    (pieces, lift.corners, format!("{stop:?}"), lift.stages)
}

/// Complete lifts, every kind of violation, and ends where continuation is not unique: a few tops are pushed below the middle
/// surface, so that some tets are not positive, and a few middle points to the side.
#[test]
fn a_lift_is_that_of_one_core() {
    let pools = [1, 2, 5].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    let mut random = Random(8);
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for round in 0..90 {
        let (mut shell, mut mesh) = sphere(&mut random, [0, 200, 0][round % 3], round % 4);
        for _ in 0..[0, 0, 1, 3][round / 3 % 4] {
            let v = random.below(shell.middle.len());
            shell.top[v] = shell.middle[v].map(|x| 0.95 * x);
            let w = random.below(shell.middle.len());
            shell.middle[w] = shell.middle[w].map(|x| x + 0.2 * random.real());
        }
        if round % 5 == 4 {
            // Beside its neighbours: mostly a fold.
            let v = random.below(mesh.vertices.len());
            let [x, y, z] = mesh.vertices[v];
            mesh.vertices[v] = [y.mul_add(0.4, x), x.mul_add(-0.4, y), z].map(|x| 0.95 * x);
        }
        lifting(&shell, &mesh, |cx| {
            let face = random.below(mesh.faces.len()) as u32;
            let of_prism = |t: &u32| cx.complex.tets[*t as usize].prism == face;
            let mut tets = (0..cx.complex.tets.len() as u32).filter(of_prism);
            let Some(tet) = tets.find(|&t| cx.piece(face, t, &mut StageCounts::default()).is_some()) else {
                return;
            };
            let expected = sequential(cx, face, tet);
            for pool in &pools {
                let found = pool.install(|| ahead(cx, face, tet));
                let ends = [(&found.2, found.3), (&expected.2, expected.3)];
                assert!(found == expected, "round {round}: found and expected {ends:?}");
            }
            let kinds = ["None", "Branched", "Fold", "Cap {", "Wall", "Boundary"];
            for kind in kinds.into_iter().filter(|k| expected.2.contains(k) && expected.0.len() > 200) {
                *seen.entry(kind).or_default() += 1;
            }
        });
    }
    assert!(
        ["None", "Branched", "Fold", "Cap {"].iter().all(|k| seen.get(k).is_some_and(|n| *n > 2)),
        "{seen:?}"
    );
}
