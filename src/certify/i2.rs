//! C3+ `i2`: *I2* of *Shell* to the letter, on top of C3 and of C6 against bottom and top.

use std::sync::atomic::{AtomicBool, Ordering};

use dashu_int::IBig;
use rayon::prelude::*;

use super::CertifyError;
use super::complex::MeshView;
use super::exact::{ExactPiece, centre, cross, dot, minus, to_integers, whole};
use super::observer::Observer;
use super::pairs::BoxTree;
use super::point::{bounds, boxes_meet};
use super::positivity::dyadic;
use super::separate::{Few, Named, Pair, PlaneName, PointName};
use crate::number::dyadic::scale_points;
use crate::predicate::{Sign, StageCounts, dot_sign_staged};
use crate::shell::{Layer, Name, Shell, Slab, Tet};

/// A triangle that touches a tet whose field it does not face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contact {
    /// The mesh triangle.
    pub face: u32,
    /// The prism.
    pub prism: u32,
    /// The tet's names, ascending.
    pub names: [Name; 4],
    /// A common point: integer weights on the triangle's corners.
    pub in_face: [IBig; 3],
    /// Integer weights on the tet's names.
    pub in_tet: [IBig; 4],
    /// `normal . V`, not positive: `mantissa * 2^exponent`.
    pub value: (IBig, i32),
}

/// The planes between a triangle and a tet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ContactSeparation {
    /// The mesh triangle.
    pub face: u32,
    /// The prism.
    pub prism: u32,
    /// The tet's names, ascending.
    pub names: [Name; 4],
    /// The planes.
    pub planes: Vec<PlaneName>,
}

/// The answer to the contact part of C3+.
#[derive(Debug, Default)]
pub(crate) struct Contacts {
    /// Pairs of triangle and prism whose boxes meet.
    pub(crate) pairs: u64,
    /// Those whose six dots all are positive.
    pub(crate) all_positive: u64,
    /// Pairs of triangle and tet with a dot that is not positive and boxes that meet.
    pub(crate) tet_pairs: u64,
    /// How the signs of dots and of planes between triangles and tets were decided. Those for the hull condition do not count: it
    /// is asked until it fails once, which depends on the threads.
    pub(crate) stages: StageCounts,
    /// Planes where no plane of the triangle or of a face of the tet does, ascending.
    pub(crate) separations: Vec<ContactSeparation>,
    /// Contacts, ascending.
    pub(crate) contacts: Vec<Contact>,
    /// Does every triangle that touches a prism's convex hull have six positive dots?
    pub(crate) hull_condition: bool,
}

struct Job<'a> {
    mesh: &'a MeshView<'a>,
    shell: &'a Shell,
    hull_fails: AtomicBool,
}

/// Decides the contact part of C3+. All tets must be positive (C1).
pub(crate) fn decide(
    mesh: &MeshView<'_>,
    shell: &Shell,
    observer: &dyn Observer,
) -> Result<Contacts, CertifyError> {
    let job = Job { mesh, shell, hull_fails: AtomicBool::new(false) };
    let tree = BoxTree::new((0..shell.faces.len() as u32).map(|p| job.prism_points(p)));
    let parts: Vec<Result<Contacts, CertifyError>> = (0..mesh.faces.len() as u32)
        .into_par_iter()
        .map(|f| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            let mut out = Contacts::default();
            for prism in tree.meeting(&mesh.points(f)) {
                job.pair(f, prism, &mut out)?;
            }
            Ok(out)
        })
        .collect();
    let mut out = Contacts { hull_condition: !job.hull_fails.load(Ordering::Relaxed), ..Contacts::default() };
    for part in parts {
        let part = part?;
        out.pairs += part.pairs;
        out.all_positive += part.all_positive;
        out.tet_pairs += part.tet_pairs;
        out.stages += part.stages;
        out.separations.extend(part.separations);
        out.contacts.extend(part.contacts);
    }
    Ok(out)
}

impl<'a> Job<'a> {
    fn prism_points(&self, prism: u32) -> Few<&'a [f64; 3]> {
        let layers = [Layer::Bottom, Layer::Middle, Layer::Top];
        let face = self.shell.faces[prism as usize];
        layers.iter().flat_map(|&layer| face.map(|v| &self.shell.layer(layer)[v as usize])).collect()
    }

    fn pair(&self, f: u32, prism: u32, out: &mut Contacts) -> Result<(), CertifyError> {
        out.pairs += 1;
        let points = self.mesh.points(f);
        let dots = pillar_dots(points, self.shell, prism, &mut out.stages);
        if dots.all_positive() {
            out.all_positive += 1;
            return Ok(());
        }
        if !self.hull_fails.load(Ordering::Relaxed) && self.touches_hull(f, prism) {
            self.hull_fails.store(true, Ordering::Relaxed);
        }
        let near = bounds(points);
        let mut tets: Vec<([Name; 4], Tet)> = self
            .shell
            .prism_tets_unique(prism)
            .filter(|t| !dots.of(t).is_positive())
            .filter(|t| boxes_meet(&near, &bounds(t.names.map(|n| self.shell.position(n)))))
            .map(|t| (t.sorted_names(), t))
            .collect();
        tets.sort_unstable_by_key(|(names, _)| *names);
        for (names, tet) in tets {
            out.tet_pairs += 1;
            self.tet(f, names, &tet, out)?;
        }
        Ok(())
    }

    fn named(&self, f: u32, names: &[Name]) -> Few<Named<'a>> {
        let face = self.mesh.faces[f as usize];
        let mesh = face.map(|v| Named { name: PointName::Mesh(v), at: &self.mesh.vertices[v as usize] });
        let shell = names.iter().map(|&n| Named { name: PointName::Shell(n), at: self.shell.position(n) });
        mesh.into_iter().chain(shell).collect()
    }

    fn tet(&self, f: u32, names: [Name; 4], tet: &Tet, out: &mut Contacts) -> Result<(), CertifyError> {
        let points = self.named(f, &names);
        let pinches: Vec<&[f64; 3]> = names
            .iter()
            .filter(|n| self.shell.is_pinched(n.vertex))
            .map(|n| self.shell.position(*n))
            .collect();
        let common = points.iter().map(|p| pinches.contains(&p.at)).collect();
        let pair = Pair { points, split: 3, common, exact_common: false };
        let own = [[0, 1, 2], [4, 5, 6], [3, 5, 6], [3, 4, 6], [3, 4, 5]];
        if own.into_iter().any(|plane| pair.closed_by_staged(plane, &mut out.stages)) {
            return Ok(());
        }
        match pair.separation_staged(&mut out.stages) {
            Some(planes) => {
                out.separations.push(ContactSeparation { face: f, prism: tet.prism, names, planes });
            }
            None => out.contacts.push(self.contact(f, names, tet)?),
        }
        Ok(())
    }

    fn contact(&self, f: u32, names: [Name; 4], tet: &Tet) -> Result<Contact, CertifyError> {
        let broken =
            || CertifyError::Internal { what: "a triangle and a tet that neither meet nor can be separated" };
        let triangle = self.mesh.points(f);
        // Sorted names may be a mirrored tet: coordinates do not mind.
        let exact = ExactPiece::new(triangle, names.map(|n| self.shell.position(n)));
        let point = centre(&exact.cut_with_tet(&whole())).ok_or_else(broken)?;
        let in_tet = exact.in_tet(&point).ok_or_else(broken)?;
        let [lo, hi] = tet.field().map(|n| self.shell.position(n));
        let [a, b, c] = triangle;
        let (x, exponent) = scale_points(&[*a, *b, *c, *lo, *hi]);
        let normal = cross(&minus(&x[1], &x[0]), &minus(&x[2], &x[0]));
        let value = dyadic(dot(&normal, &minus(&x[4], &x[3])), 3 * exponent);
        let (in_face, in_tet) = (to_integers(&point), to_integers(&in_tet));
        Ok(Contact { face: f, prism: tet.prism, names, in_face, in_tet, value })
    }

    fn touches_hull(&self, f: u32, prism: u32) -> bool {
        let face = self.shell.faces[prism as usize];
        let layers = [Layer::Bottom, Layer::Middle, Layer::Top];
        let mut names: Vec<Name> =
            layers.iter().flat_map(|&layer| face.map(|v| self.shell.name(v, layer))).collect();
        names.sort_unstable();
        names.dedup();
        let points = self.named(f, &names);
        let common =
            points.iter().map(|p| matches!(p.name, PointName::Shell(n) if self.shell.is_pinched(n.vertex)));
        let common = common.collect();
        let pair = Pair { points, split: 3, common, exact_common: false };
        !pair.closed_by([0, 1, 2]) && pair.separation().is_none()
    }
}

/// Signs of a triangle's dots with the six pillar halves of a prism.
#[derive(Debug)]
pub(crate) struct PillarDots {
    /// Vertex, slab, sign; pinched pillars are left out.
    signs: [Option<(u32, Slab, Sign)>; 6],
}

impl PillarDots {
    pub(crate) fn all_positive(&self) -> bool {
        self.signs.iter().flatten().all(|(_, _, s)| s.is_positive())
    }

    /// The dot with a tet of the prism.
    pub(crate) fn of(&self, tet: &Tet) -> Sign {
        let found = self.signs.iter().flatten().find(|(v, slab, _)| *v == tet.pillar && *slab == tet.slab);
        found.map_or(Sign::Zero, |(_, _, s)| *s)
    }
}

/// The six dots of a triangle with a prism's pillar halves.
pub(crate) fn pillar_dots(
    triangle: [&[f64; 3]; 3],
    shell: &Shell,
    prism: u32,
    stages: &mut StageCounts,
) -> PillarDots {
    let [a, b, c] = triangle;
    let face = shell.faces[prism as usize];
    let mut signs = [None; 6];
    for (k, &v) in face.iter().enumerate() {
        if shell.is_pinched(v) {
            continue;
        }
        for (s, slab) in Slab::BOTH.into_iter().enumerate() {
            let [lo, hi] = [slab.lo(), slab.hi()].map(|layer| &shell.layer(layer)[v as usize]);
            signs[2 * k + s] = Some((v, slab, stages.note(dot_sign_staged(a, b, c, lo, hi))));
        }
    }
    PillarDots { signs }
}
