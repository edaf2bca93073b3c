//! C2 `section` and C4 `bijection`: a lift that is a section, or a witness against every lift.

use dashu_int::IBig;

use super::CertifyError;
use super::complex::MeshView;
use super::exact::to_integers;
use super::lift::{Lift, Lifting, Stop};
use super::observer::Observer;
use super::path::{Chart, first_centroid, point_of, preimage};
use super::point::{CarrierMap, MeshPoint};
use super::positivity::bad_tet;
use super::witness::{Branch, Ending, Leg, NoLift, Root};
use crate::predicate::StageCounts;
use crate::shell::Name;

/// The answer to C2 and C4.
#[derive(Debug)]
pub(crate) enum Section {
    /// One lift for each component of the mesh, in the order of components.
    Certified(Vec<Lift>),
    /// A witness.
    Refuted(NoLift),
}

/// One way to lift a component, tried.
enum Attempt {
    /// A section onto this component of the middle complex.
    Landed { branch: Branch, lift: Box<Lift>, middle: u32 },
    /// Refuted.
    Failed(Branch),
}

/// All ways to lift a component.
struct Component {
    root: MeshPoint,
    attempts: Vec<Attempt>,
}

/// Decides C2 and C4 for the complex's order; `stages`: the decisions on the way, all lifts that were tried included, as one core
/// makes them.
///
/// # Errors
/// [`CertifyError::Branched`] where positive tets wind more than once around an edge (possible only when C1 fails);
/// [`CertifyError::Cancelled`].
pub(crate) fn decide(
    cx: Lifting<'_>,
    observer: &dyn Observer,
    stages: &mut StageCounts,
) -> Result<Section, CertifyError> {
    if let Some(topology) = topology(&cx) {
        return Ok(Section::Refuted(topology));
    }
    if let Some(tet) = cx.complex.first_not_positive(stages) {
        return Ok(Section::Refuted(NoLift::Tet(bad_tet(cx.complex.shell, &cx.complex.tets[tet as usize]))));
    }
    let mut components = Vec::new();
    for face in first_faces(cx.mesh) {
        match lift_component(&cx, face, observer, stages)? {
            Ok(component) => components.push(component),
            Err(root) => return Ok(Section::Refuted(NoLift::Roots(vec![root]))),
        }
    }
    Ok(assign(components))
}

fn topology(cx: &Lifting<'_>) -> Option<NoLift> {
    let (t, m) = (cx.mesh.connectivity, cx.complex.middle);
    let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    if t.component_count() != m.component_count() {
        return Some(NoLift::Components {
            mesh: count(t.component_count()),
            middle: count(m.component_count()),
        });
    }
    let (mesh, middle) = (t.euler_characteristic(), m.euler_characteristic());
    (mesh != middle).then_some(NoLift::Euler { mesh, middle })
}

/// The smallest triangle of each component.
fn first_faces(mesh: &MeshView<'_>) -> Vec<u32> {
    let mut out = Vec::new();
    for f in 0..mesh.faces.len() as u32 {
        if mesh.connectivity.component(f) as usize == out.len() {
            out.push(f);
        }
    }
    out
}

/// A point inside the triangle none of whose carriers is an edge or a vertex, so that its lifts are unique.
fn generic_root(cx: &Lifting<'_>, face: u32) -> Result<(MeshPoint, CarrierMap), CertifyError> {
    // All but finitely many lines and points of the triangle will do; the sequence visits ever new directions.
    for k in 0..1000u32 {
        let weights = [1 + k % 11, 1 + (k * k) % 13, 1 + (3 * k) % 17].map(IBig::from);
        let Some(point) = point_of(face, &weights) else { continue };
        let carriers = cx.carriers_of(&point);
        if carriers.keys().all(|c| c.len() >= 3) {
            return Ok((point, carriers));
        }
    }
    Err(CertifyError::Internal { what: "no root point in general position" })
}

/// Lifts a component in every way. The inner error is a witness at one point that needs no path.
fn lift_component(
    cx: &Lifting<'_>,
    face: u32,
    observer: &dyn Observer,
    stages: &mut StageCounts,
) -> Result<Result<Component, Root>, CertifyError> {
    let (root, carriers) = generic_root(cx, face)?;
    let mut attempts = Vec::with_capacity(carriers.len());
    for (carrier, tets) in &carriers {
        match lift_from(cx, &root, (carrier, tets), observer, stages)? {
            Ok(attempt) => attempts.push(attempt),
            Err(simple) => return Ok(Err(simple)),
        }
    }
    if attempts.iter().any(|a| matches!(a, Attempt::Landed { .. })) {
        return Ok(Ok(Component { root, attempts }));
    }
    let branches = attempts.into_iter().map(branch_of).collect();
    Ok(Err(Root { face, weights: to_integers(&root.weights), branches }))
}

fn branch_of(attempt: Attempt) -> Branch {
    match attempt {
        Attempt::Landed { branch, .. } | Attempt::Failed(branch) => branch,
    }
}

/// Lifts a component with the root point at one carrier.
fn lift_from(
    cx: &Lifting<'_>,
    root: &MeshPoint,
    (carrier, tets): (&[Name], &[u32]),
    observer: &dyn Observer,
    stages: &mut StageCounts,
) -> Result<Result<Attempt, Root>, CertifyError> {
    let branch = |legs, ending| Branch { carrier: carrier.to_vec(), legs, ending };
    if let Some((ending, tet)) = cx.local_failure(root, carrier, tets, stages) {
        let leg = Leg { start: cx.complex.sorted_names(tet), steps: Vec::new() };
        return Ok(Ok(Attempt::Failed(branch(vec![leg], ending))));
    }
    let starts = cx.starts(root.face, carrier, stages);
    let Some(&start) = starts.first() else {
        return Err(CertifyError::Internal { what: "a root point without a piece" });
    };
    let (lift, stop) = cx.flood(root.face, start, observer);
    *stages += lift.stages;
    match stop {
        Some(Stop::Cancelled) => return Err(CertifyError::Cancelled),
        Some(Stop::Branched(names)) => return Err(CertifyError::Branched { names }),
        Some(Stop::Violation(v)) => {
            let (point, ending) = cx.violation_point(&lift, &v)?;
            if let Some(simple) = cx.root_at(&point, stages) {
                return Ok(Err(simple));
            }
            let leg = cx.leg(&lift, v.piece, &point)?;
            return Ok(Ok(Attempt::Failed(branch(vec![leg], ending))));
        }
        None => {}
    }
    if let Some((legs, ending)) = covered_twice(cx, &lift)? {
        return Ok(Ok(Attempt::Failed(branch(legs, ending))));
    }
    let prism = cx.complex.tets[start as usize].prism;
    let leg = Leg { start: cx.complex.sorted_names(start), steps: Vec::new() };
    let middle = cx.complex.middle.component(prism);
    Ok(Ok(Attempt::Landed { branch: branch(vec![leg], Ending::Lands), lift: Box::new(lift), middle }))
}

/// A complete lift covers mesh and middle component evenly; whether more than once shows at one point of each.
fn covered_twice(cx: &Lifting<'_>, lift: &Lift) -> Result<Option<(Vec<Leg>, Ending)>, CertifyError> {
    let corners = cx.exact_corners(lift, 0)?;
    let first = lift.pieces[0];
    let prism = |tet: u32| cx.complex.tets[tet as usize].prism;
    for (chart, ending) in [(Chart::Mesh, Ending::Monodromy), (Chart::Middle, Ending::Twice)] {
        let Some(q) = first_centroid(&corners, chart) else { continue };
        let Some(here) = first_centroid(&corners, Chart::Mesh) else { continue };
        for id in 1..lift.pieces.len() as u32 {
            let piece = lift.pieces[id as usize];
            let same = match chart {
                Chart::Mesh => piece.face == first.face,
                Chart::Middle => prism(piece.tet) == prism(first.tet),
            };
            if !same {
                continue;
            }
            if let Some(weights) = preimage(&cx.exact_corners(lift, id)?, chart, &q) {
                let here = MeshPoint { face: first.face, weights: here };
                let there = MeshPoint { face: piece.face, weights };
                let legs = vec![cx.leg(lift, 0, &here)?, cx.leg(lift, id, &there)?];
                return Ok(Some((legs, ending)));
            }
        }
    }
    Ok(None)
}

/// Chooses lifts so that every component of the middle complex is hit by one component of the mesh: a perfect
/// matching, or, by Hall's theorem, components that together land on too few.
fn assign(mut components: Vec<Component>) -> Section {
    let n = components.len();
    let targets: Vec<Vec<u32>> = components.iter().map(landings).collect();
    let mut owner: Vec<Option<usize>> = vec![None; n];
    for c in 0..n {
        let mut seen = vec![false; n];
        if !augment(c, &targets, &mut owner, &mut seen) {
            let short: Vec<usize> = (0..n)
                .filter(|&d| d == c || owner.iter().zip(&seen).any(|(o, s)| *s && *o == Some(d)))
                .collect();
            let mut roots = Vec::new();
            for (i, component) in components.into_iter().enumerate() {
                if short.contains(&i) {
                    let weights = to_integers(&component.root.weights);
                    let branches = component.attempts.into_iter().map(branch_of).collect();
                    roots.push(Root { face: component.root.face, weights, branches });
                }
            }
            return Section::Refuted(NoLift::Roots(roots));
        }
    }
    let mut lifts = Vec::with_capacity(n);
    for (c, component) in components.drain(..).enumerate() {
        let wanted = owner.iter().position(|o| *o == Some(c));
        let chosen = component.attempts.into_iter().find_map(|a| match a {
            Attempt::Landed { lift, middle, .. } if Some(middle as usize) == wanted => Some(*lift),
            _ => None,
        });
        lifts.extend(chosen);
    }
    Section::Certified(lifts)
}

fn landings(component: &Component) -> Vec<u32> {
    let target = |a: &Attempt| match a {
        Attempt::Landed { middle, .. } => Some(*middle),
        Attempt::Failed(_) => None,
    };
    component.attempts.iter().filter_map(target).collect()
}

/// Kuhn's augmenting path, without recursion: breadth-first over components, then reassigned backwards.
fn augment(start: usize, targets: &[Vec<u32>], owner: &mut [Option<usize>], seen: &mut [bool]) -> bool {
    let mut queue = vec![start];
    let mut reached_from = vec![usize::MAX; owner.len()];
    let mut next = 0;
    while next < queue.len() {
        let c = queue[next];
        next += 1;
        for &t in &targets[c] {
            let t = t as usize;
            if seen[t] {
                continue;
            }
            seen[t] = true;
            reached_from[t] = c;
            match owner[t] {
                Some(other) => queue.push(other),
                None => {
                    let mut slot = t;
                    loop {
                        let c = reached_from[slot];
                        let before = owner.iter().position(|o| *o == Some(c));
                        owner[slot] = Some(c);
                        match before {
                            Some(previous) if c != start => slot = previous,
                            _ => return true,
                        }
                    }
                }
            }
        }
    }
    false
}
