//! Witnesses that there is no lift.

use std::collections::{BTreeMap, BTreeSet};

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::overlay::support;
use super::places::Places;
use super::text::{names, number, weights};
use super::{Flaw, Judge, Judged, Ordered, holds};
use crate::oracle::exact::{Weights, dot, minus, positive};
use crate::oracle::tets::Code;
use crate::oracle::{boundary, components};

pub(super) fn judge(judge: &Judge<'_>, ordered: &Ordered, lines: &[Vec<&str>]) -> Judged {
    match lines {
        [line] if line[0] == "topology" => topology(judge, line),
        [line] if line[0] == "tet" => judge.bad_tet(line, &ordered.selected),
        _ => roots(&Here { judge, ordered }, lines),
    }
}

fn topology(judge: &Judge<'_>, line: &[&str]) -> Judged {
    let [_, kind, a, b] = line else { return Err(Flaw::Unreadable) };
    let of = |faces: &[[u32; 3]]| -> Result<i64, Flaw> {
        if *kind == "components" {
            return Ok(i64::try_from(components(faces).into_iter().collect::<BTreeSet<_>>().len()).unwrap());
        }
        let vertices: BTreeSet<u32> = faces.iter().flatten().copied().collect();
        let edges = (3 * faces.len() + boundary(faces).len()) / 2;
        let [v, e, f] = [vertices.len(), edges, faces.len()].map(|n| i64::try_from(n).unwrap());
        if *kind == "euler" { Ok(v - e + f) } else { Err(Flaw::Unreadable) }
    };
    let truth = [of(&judge.case.mesh.faces)?, of(&judge.case.shell.faces)?];
    let stated: [i64; 2] = [number(a)?, number(b)?];
    holds(stated == truth, "another number")?;
    holds(truth[0] != truth[1], "equal numbers")
}

struct Here<'j, 'a> {
    judge: &'j Judge<'a>,
    ordered: &'j Ordered,
}

/// A point of the mesh in a tet.
#[derive(Clone)]
struct Station {
    face: usize,
    weights: Weights,
    tet: usize,
    /// Names with positive coordinates, and these.
    carrier: (Vec<Code>, Weights),
}

impl Station {
    /// The point of the mesh.
    fn mesh(&self, here: &Here<'_, '_>) -> BTreeMap<u32, RBig> {
        let (ids, weights) = support(&here.judge.case.mesh.faces[self.face], &self.weights);
        normalised(ids.into_iter().zip(weights))
    }

    /// Its projection.
    fn image(&self) -> BTreeMap<u32, RBig> {
        let (codes, coordinates) = self.carrier.clone();
        normalised(codes.into_iter().map(|c| c / 3).zip(coordinates))
    }
}

fn normalised(weights: impl Iterator<Item = (u32, IBig)> + Clone) -> BTreeMap<u32, RBig> {
    let total = RBig::from(weights.clone().map(|x| x.1).sum::<IBig>());
    let mut out = BTreeMap::new();
    weights.for_each(|(v, w)| *out.entry(v).or_insert(RBig::ZERO) += RBig::from(w) / &total);
    out
}

impl Here<'_, '_> {
    /// The carrier of a point of a mesh triangle in a closed tet, if the tet is positive and holds it.
    fn carrier(&self, face: usize, weights: &Weights, tet: usize) -> Option<(Vec<Code>, Weights)> {
        let world = &self.judge.world;
        let codes = world.tets.all[tet].names;
        let inside = Places::mixed(&world.triangle(face), weights).in_tet(codes.map(|c| world.at(c)));
        let holds = positive(&world.determinants[tet]) && inside.iter().all(|x| *x >= IBig::ZERO);
        holds.then(|| support(&codes, &inside))
    }

    fn station(&self, face: usize, weights: Weights, tet: &str) -> Result<Station, Flaw> {
        let tet = self.judge.tet(tet, &self.ordered.selected, None)?;
        let carrier = self.carrier(face, &weights, tet).ok_or(Flaw::False("a point outside of its tet"))?;
        Ok(Station { face, weights, tet, carrier })
    }

    fn face(&self, word: &str) -> Result<usize, Flaw> {
        let face = number(word)?;
        if face < self.judge.case.mesh.faces.len() { Ok(face) } else { Err(Flaw::Unreadable) }
    }
}

fn roots(here: &Here<'_, '_>, lines: &[Vec<&str>]) -> Judged {
    let mut rest = lines;
    let (mut of_roots, mut landed) = (Vec::new(), BTreeSet::new());
    let middle = components(&here.judge.case.shell.faces);
    while let Some((line, after)) = rest.split_first() {
        let ["root", face, a, b, c] = line[..] else { return Err(Flaw::Unreadable) };
        let (face, at) = (here.face(face)?, weights(&[a, b, c])?);
        of_roots.push(components(&here.judge.case.mesh.faces)[face]);
        rest = after;
        let mut found = Vec::new();
        while rest.first().is_some_and(|l| l[0] == "branch") {
            let n = 1 + rest[1..].iter().take_while(|l| l[0] != "branch" && l[0] != "root").count();
            let (names, reason, last) = branch(here, face, &at, &rest[..n])?;
            found.push(names);
            if reason == "lands" {
                landed.insert(middle[here.judge.world.tets.all[last.tet].prism]);
            }
            rest = &rest[n..];
        }
        let all = here.ordered.selected.iter().filter_map(|&t| here.carrier(face, &at, t));
        let all: BTreeSet<Vec<Code>> = all.map(|c| c.0).collect();
        holds(all.into_iter().eq(found), "other branches")?;
    }
    let distinct: BTreeSet<usize> = of_roots.iter().copied().collect();
    holds(!of_roots.is_empty() && distinct.len() == of_roots.len(), "roots in one component")?;
    holds(landed.len() < of_roots.len(), "a lift is left")
}

/// A branch: its names, its reason, and where its last leg ends.
fn branch<'t>(
    here: &Here<'_, '_>,
    face: usize,
    at: &Weights,
    lines: &'t [Vec<&'t str>],
) -> Result<(Vec<Code>, &'t str, Station), Flaw> {
    let ["branch", stated] = lines[0][..] else { return Err(Flaw::Unreadable) };
    let stated = names(stated)?;
    let mut legs: Vec<Station> = Vec::new();
    let (reason, walk) = lines[1..].split_last().ok_or(Flaw::Unreadable)?;
    for line in walk {
        match line[..] {
            ["start", tet] => {
                let first = here.station(face, at.clone(), tet)?;
                let codes = here.judge.world.tets.all[first.tet].names;
                holds(stated.iter().all(|n| codes.contains(n)), "a start elsewhere")?;
                legs.push(first);
            }
            ["step", next, a, b, c, tet] => {
                let before = legs.pop().ok_or(Flaw::Unreadable)?;
                legs.push(step(here, &before, here.face(next)?, weights(&[a, b, c])?, tet)?);
            }
            _ => return Err(Flaw::Unreadable),
        }
    }
    let [reason] = reason[..] else { return Err(Flaw::Unreadable) };
    ends(here, reason, &legs)?;
    let last = legs.pop().ok_or(Flaw::Unreadable)?;
    Ok((stated, reason, last))
}

fn step(here: &Here<'_, '_>, before: &Station, face: usize, at: Weights, tet: &str) -> Result<Station, Flaw> {
    let next = here.station(face, at, tet)?;
    let corners = here.judge.case.mesh.faces[before.face];
    let (ids, of) = support(&here.judge.case.mesh.faces[face], &next.weights);
    holds(ids.iter().all(|v| corners.contains(v)), "a step off the triangle")?;
    // The point on the triangle before, and so in the tet before.
    let there = corners.map(|v| ids.iter().position(|u| *u == v).map_or(IBig::ZERO, |k| of[k].clone()));
    let carrier = here.carrier(before.face, &there.to_vec(), before.tet);
    let carrier = carrier.ok_or(Flaw::False("a step out of the tet"))?;
    holds(carrier.0 == next.carrier.0, "a step past a face")?;
    holds(before.carrier.0.len() > 1, "a step from a vertex")?;
    Ok(next)
}

fn ends(here: &Here<'_, '_>, reason: &str, legs: &[Station]) -> Judged {
    let judge = here.judge;
    if let [one, other] = legs {
        let (same_point, same_image) = (one.mesh(here) == other.mesh(here), one.image() == other.image());
        return match reason {
            "twice" => holds(!same_point && same_image, "not one image of two points"),
            "monodromy" => holds(same_point && one.carrier.0 != other.carrier.0, "not two lifts of a point"),
            _ => Err(Flaw::Unreadable),
        };
    }
    let [last] = legs else { return Err(Flaw::Unreadable) };
    let (ids, _) = support(&judge.case.mesh.faces[last.face], &last.weights);
    let shell: Vec<u32> = last.carrier.0.iter().map(|c| c / 3).collect();
    let rim = [judge.on_boundary(0, &ids), judge.on_boundary(1, &shell)];
    match reason {
        "cap" => holds(judge.cap(&last.carrier.0), "no cap"),
        "wall" => holds(rim == [false, true], "no wall"),
        "boundary" => holds(rim == [true, false], "no boundary"),
        "fold" => holds(ids.len() == 3 && folds(judge, last), "no fold"),
        "lands" => Ok(()),
        _ => Err(Flaw::Unreadable),
    }
}

/// Does the triangle not face up in the tet, with a piece of it there?
fn folds(judge: &Judge<'_>, last: &Station) -> bool {
    let world = &judge.world;
    let [a, b, c] = world.triangle(last.face);
    let normal = crate::oracle::exact::cross(&minus(b, a), &minus(c, a));
    let carrier = &last.carrier.0;
    let flat =
        carrier.len() == 3 && carrier.iter().all(|&n| dot(&normal, &minus(world.at(n), a)) == IBig::ZERO);
    !positive(&world.slope(last.face, last.tet)) && (carrier.len() == 4 || flat)
}
