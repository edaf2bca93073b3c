//! What an initial shell must satisfy: which slabs break it. The certifier answers the same questions with proofs and witnesses that
//! take longer than the answers. Here signs decide; where a pinched corner makes it a question what may be shared there, the
//! certifier is asked.

use rayon::prelude::*;

use super::{Against, NOT_POSITIVE};
use crate::certify::complex::MeshView;
use crate::certify::disjoint::{self, About};
use crate::certify::{CertifyError, Observer, i2, positivity};
use crate::construct::draft::Draft;
use crate::construct::gate::BuildError;
use crate::construct::optimise::prism::{Pillar, Prism};
use crate::construct::optimise::tree::Box3;
use crate::predicate::{dot_sign, triangle_touches_tet, triangle_triangle};
use crate::shell::{Layer, Name, Shell, Slab};

/// Slabs of prisms.
type Slabs = Vec<(u32, Slab)>;

/// Slabs and the condition that they break.
pub(super) type Wrong = (Slabs, &'static str);

/// What is asked of a slab.
#[derive(Clone, Copy)]
enum Condition {
    /// C1.
    Positive,
    /// C6 against bottom and top.
    Clear,
    /// The contact part of C3+, which wants positive tets.
    Contacts,
}

impl Condition {
    /// The cheapest first.
    const ALL: [Self; 3] = [Self::Positive, Self::Clear, Self::Contacts];

    /// That it does not hold, in words.
    fn broken(self) -> &'static str {
        match self {
            Self::Positive => NOT_POSITIVE,
            Self::Clear => "the mesh meets bottom or top",
            Self::Contacts => "a triangle touches the prism in the wrong direction",
        }
    }
}

/// Prisms by condition: whether it is known to hold. What a prism is found to be stays true until one of its corners moves, and a
/// round moves few of them: judging all prisms in every round took nine tenths of the time of meshes with many rounds.
pub(super) struct Known([Vec<bool>; 3]);

impl Known {
    pub(super) fn nothing(prisms: usize) -> Self {
        Self([vec![false; prisms], vec![false; prisms], vec![false; prisms]])
    }

    /// The prisms of which a condition is not known.
    fn rest(&self, condition: Condition) -> Vec<u32> {
        (0u32..).zip(&self.0[condition as usize]).filter(|(_, known)| !**known).map(|(p, _)| p).collect()
    }

    /// These prisms were judged; those with one of the slabs are wrong.
    fn judged(&mut self, condition: Condition, ids: &[u32], wrong: &[(u32, Slab)]) {
        ids.iter().for_each(|&p| self.0[condition as usize][p as usize] = true);
        wrong.iter().for_each(|&(p, _)| self.0[condition as usize][p as usize] = false);
    }

    /// Some vertices have moved.
    pub(super) fn forget(&mut self, faces: &[[u32; 3]], moved: &[bool]) {
        for (p, face) in faces.iter().enumerate() {
            if face.iter().any(|&v| moved[v as usize]) {
                self.0.iter_mut().for_each(|known| known[p] = false);
            }
        }
    }
}

/// The slabs that break a condition, the cheapest condition first, and which one it is.
pub(super) fn wrong(
    draft: &Draft,
    against: &Against<'_>,
    view: &MeshView<'_>,
    known: &mut Known,
    observer: &dyn Observer,
) -> Result<Wrong, BuildError> {
    let mut judge = Judge { draft, shell: draft.shell(), against, view, observer };
    for condition in Condition::ALL {
        let ids = known.rest(condition);
        let wrong = judge.decide(condition, &ids)?;
        known.judged(condition, &ids, &wrong);
        if !wrong.is_empty() {
            return Ok((wrong, condition.broken()));
        }
    }
    Ok((Vec::new(), ""))
}

/// Decides a condition about some prisms of a draft.
struct Judge<'a> {
    draft: &'a Draft,
    /// The draft's points; its prisms, or some of them.
    shell: Shell,
    against: &'a Against<'a>,
    view: &'a MeshView<'a>,
    observer: &'a dyn Observer,
}

impl Judge<'_> {
    /// The slabs of these prisms that break the condition.
    fn decide(&mut self, condition: Condition, ids: &[u32]) -> Result<Slabs, CertifyError> {
        match condition {
            Condition::Positive => self.not_positive(ids),
            Condition::Clear => self.not_clear(ids),
            Condition::Contacts => self.in_contact(ids),
        }
    }

    fn not_positive(&mut self, ids: &[u32]) -> Result<Slabs, CertifyError> {
        let observer = self.observer;
        let bad = positivity::bad_slabs(self.part(ids), observer)?;
        Ok(bad.into_iter().map(|(p, slab)| (ids[p as usize], slab)).collect())
    }

    fn not_clear(&mut self, ids: &[u32]) -> Result<Slabs, CertifyError> {
        let (pinched, others) = self.pinched(ids);
        let mut wrong = self.slabs(&others, |prism, slab, triangle| {
            let outside = prism.outside(slab);
            Box3::of(outside).meets(&Box3::of(triangle)) && triangle_triangle(outside, triangle).meets()
        })?;
        if !pinched.is_empty() {
            let (view, observer) = (self.view, self.observer);
            for (about, slab) in [(About::Bottom, Slab::Bottom), (About::Top, Slab::Top)] {
                let found = disjoint::decide(view, self.part(&pinched), about, observer)?;
                let crossings = found.crossings.iter().map(|c| (c.first, pinched[c.second as usize]));
                wrong.extend(crossings.filter(|&(f, p)| self.counts(f, p)).map(|(_, p)| (p, slab)));
            }
        }
        Ok(wrong)
    }

    fn in_contact(&mut self, ids: &[u32]) -> Result<Slabs, CertifyError> {
        let (pinched, others) = self.pinched(ids);
        let mut wrong = self.slabs(&others, touches_wrongly)?;
        if !pinched.is_empty() {
            let slab = |names: &[Name]| {
                if names.iter().any(|n| n.layer == Layer::Top) { Slab::Top } else { Slab::Bottom }
            };
            let (view, observer) = (self.view, self.observer);
            let found = i2::decide(view, self.part(&pinched), observer)?;
            let contacts = found.contacts.iter().map(|c| (c.face, pinched[c.prism as usize], slab(&c.names)));
            wrong.extend(contacts.filter(|&(f, p, _)| self.counts(f, p)).map(|(_, p, slab)| (p, slab)));
        }
        Ok(wrong)
    }

    /// Does the triangle count for the prism?
    fn counts(&self, f: u32, prism: u32) -> bool {
        self.against.counts(f, &[self.draft.origin[prism as usize]])
    }

    /// Some prisms as a shell on the same vertices.
    fn part(&mut self, ids: &[u32]) -> &Shell {
        self.shell.faces = ids.iter().map(|&p| self.draft.faces[p as usize]).collect();
        &self.shell
    }

    /// The prisms with a pinched corner, and the others.
    fn pinched(&self, ids: &[u32]) -> (Vec<u32>, Vec<u32>) {
        let pinched = |p: &u32| self.draft.faces[*p as usize].iter().any(|&v| self.shell.is_pinched(v));
        ids.iter().partition(|p| pinched(p))
    }

    /// The slabs that some triangle near them, of those that count, makes wrong. No corner is pinched.
    fn slabs(
        &self,
        ids: &[u32],
        is_wrong: impl Fn(&Prism, Slab, [&[f64; 3]; 3]) -> bool + Sync,
    ) -> Result<Slabs, CertifyError> {
        let mesh = self.against.mesh;
        let of_prism = |&p: &u32| {
            let pillar = |v: u32| {
                let [bottom, middle, top] = [Layer::Bottom, Layer::Middle, Layer::Top]
                    .map(|layer| self.shell.layer(layer)[v as usize]);
                Pillar { bottom, middle, top }
            };
            let prism = Prism { pillars: self.draft.faces[p as usize].map(pillar), pinched: [false; 3] };
            self.observer.advance(1);
            let holds = |slab: Slab| {
                let bounds = Box3::of(prism.outside(slab).into_iter().chain(prism.middle()));
                self.against.tree.all(&bounds, |f| {
                    let triangle = mesh.faces[f as usize].map(|v| &mesh.vertices[v as usize]);
                    !(self.counts(f, p) && is_wrong(&prism, slab, triangle))
                })
            };
            let stop = self.observer.cancelled();
            Slab::BOTH.into_iter().filter(|&slab| !stop && !holds(slab)).map(|slab| (p, slab)).collect()
        };
        let found: Vec<Slabs> = ids.par_iter().map(of_prism).collect();
        if self.observer.cancelled() { Err(CertifyError::Cancelled) } else { Ok(found.concat()) }
    }
}

/// Does the triangle touch a tet of the slab whose field it does not face?
pub(super) fn touches_wrongly(prism: &Prism, slab: Slab, triangle: [&[f64; 3]; 3]) -> bool {
    let [a, b, c] = triangle;
    let faces = [0, 1, 2].map(|k| {
        let [lo, hi] = prism.pillars[k].half(slab);
        dot_sign(a, b, c, lo, hi).is_positive()
    });
    let bounds = Box3::of(triangle);
    faces != [true; 3]
        && prism.tets(slab).any(|(corner, tet)| {
            !faces[corner] && bounds.meets(&Box3::of(tet)) && triangle_touches_tet(triangle, tet)
        })
}
