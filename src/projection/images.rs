//! Exact images of points with `f64` coordinates: tets by filtered predicates, then integers for the tets found.

use super::rounded::signs;
use super::{ExactImage, Projection, ShellPoint, integers};
use crate::predicate::Sign;
use crate::shell::Name;

/// A tet that holds a point, with the signs of the point's barycentric coordinates.
pub(super) type Holder = (u32, [Sign; 4]);

/// Most points have one: it needs no memory on the heap.
#[derive(Default)]
struct Holders {
    first: Option<Holder>,
    more: Vec<Holder>,
}

impl Holders {
    fn push(&mut self, holder: Holder) {
        if self.first.is_none() {
            self.first = Some(holder);
        } else {
            self.more.push(holder);
        }
    }
}

impl Projection<'_> {
    /// [`project`](Self::project) for a point with `f64` coordinates, taken exactly; the answer is
    /// exact, too. `None` where a coordinate is not finite.
    ///
    /// The tet is found by filtered predicates, its coordinates are integers of fixed width in ordinary shells; most of the
    /// time goes into lowest terms, which [`image`](Self::image) does without.
    #[must_use]
    pub fn project_exactly(&self, p: &[f64; 3]) -> Option<ShellPoint> {
        self.image(p).map(|image| image.to_point())
    }

    /// The image of a point with `f64` coordinates, exactly, not in lowest terms: the value and the prism of
    /// [`project_exactly`](Self::project_exactly).
    #[must_use]
    pub fn image(&self, p: &[f64; 3]) -> Option<ExactImage> {
        let (prism, tet, _) = self.first_holder(p)?;
        Some(self.image_on(prism, tet, p))
    }

    /// All images of a point with `f64` coordinates, exactly, not in lowest terms: the values, prisms and order of
    /// [`project_all`](Self::project_all). None where a coordinate is not finite.
    #[must_use]
    pub fn images(&self, p: &[f64; 3]) -> Vec<ExactImage> {
        let mut holders = Holders::default();
        self.each_holder(p, |holder| holders.push(holder));
        let image = |(tet, signs): Holder| self.image_on(self.prism_of(tet, &signs), tet, p);
        let mut images: Vec<ExactImage> = self.different(holders).map(image).collect();
        images.sort_by_key(|image| image.prism);
        images
    }

    /// All images of a point in one prism, exactly, written on this prism's corners and thus not always canonical: as for a
    /// caller who knows the prism, since nothing is searched. By the tets of the prism from below, without
    /// repetition; two where the prism overlaps itself. Empty where the prism does not hold the point, where there is no
    /// such prism, and where a coordinate is not finite.
    #[must_use]
    pub fn images_in(&self, prism: u32, p: &[f64; 3]) -> Vec<ExactImage> {
        if !p.iter().all(|x| x.is_finite()) {
            return Vec::new();
        }
        let mut holders = Holders::default();
        for tet in self.range_of(prism) {
            // At most 6 a prism, which was seen to fit.
            let id = u32::try_from(tet).unwrap_or(u32::MAX);
            if let Some(signs) = self.signs_in(id, p) {
                holders.push((id, signs));
            }
        }
        self.different(holders).map(|(tet, _)| self.image_on(prism, tet, p)).collect()
    }

    /// Visits the tets that hold the point, in no particular order.
    #[inline]
    pub(super) fn each_holder(&self, p: &[f64; 3], mut visit: impl FnMut(Holder)) {
        self.tree().holding(p, |tet| {
            if let Some(signs) = self.signs_in(tet, p) {
                visit((tet, signs));
            }
        });
    }

    /// The signs of the coordinates of a finite point in a tet; `None` outside.
    #[inline]
    pub(super) fn signs_in(&self, tet: u32, p: &[f64; 3]) -> Option<[Sign; 4]> {
        signs(self.points(&self.tets()[tet as usize]), p)
    }

    /// The smallest canonical prism of the point, of equal ones with the first tet, and the signs there.
    #[inline]
    pub(super) fn first_holder(&self, p: &[f64; 3]) -> Option<(u32, u32, [Sign; 4])> {
        let mut best = None;
        self.each_holder(p, |holder| self.keep_first(&mut best, holder));
        best
    }

    /// Whatever the order of the holders, the same one remains.
    #[inline]
    pub(super) fn keep_first(&self, best: &mut Option<(u32, u32, [Sign; 4])>, (tet, signs): Holder) {
        let prism = self.prism_of(tet, &signs);
        if best.is_none_or(|(p, t, _)| (prism, tet) < (p, t)) {
            *best = Some((prism, tet, signs));
        }
    }

    /// The canonical prism of a point in a tet with these signs of coordinates.
    #[inline]
    fn prism_of(&self, tet: u32, signs: &[Sign; 4]) -> u32 {
        let tet = &self.tets()[tet as usize];
        if signs.iter().all(|sign| sign.is_positive()) {
            return tet.prism;
        }
        let corners = self.shell.faces[tet.prism as usize];
        let carries = |v: u32| (0..4).any(|k| tet.names[k].vertex == v && signs[k].is_positive());
        self.stars.smallest(&self.shell.faces, tet.prism, corners.map(carries))
    }

    /// The first holder of each image, ascending. `P` is injective on the abstract shell, where a point has one smallest
    /// simplex and its coordinates there: two tets give one image exactly where the same vertices have positive coordinates.
    fn different(&self, mut holders: Holders) -> impl Iterator<Item = Holder> {
        if let Some(first) = holders.first.filter(|_| !holders.more.is_empty()) {
            let carrier = |(tet, signs): &Holder| {
                let names = self.tets()[*tet as usize].names;
                let mut carrier = [0, 1, 2, 3].map(|k| signs[k].is_positive().then_some(names[k]));
                carrier.sort_unstable();
                carrier
            };
            holders.more.push(first);
            holders.more.sort_unstable_by_key(|&(tet, _)| tet);
            let mut seen: Vec<[Option<Name>; 4]> = Vec::with_capacity(holders.more.len());
            holders.more.retain(|holder| {
                let carrier = carrier(holder);
                let new = !seen.contains(&carrier);
                if new {
                    seen.push(carrier);
                }
                new
            });
            holders.first = None;
        }
        holders.first.into_iter().chain(holders.more)
    }

    /// The image of a point of a tet, on the corners of a prism that has all those with weight.
    pub(super) fn image_on(&self, prism: u32, tet: u32, p: &[f64; 3]) -> ExactImage {
        let tet = &self.tets()[tet as usize];
        let corners = self.shell.faces[prism as usize];
        let [a, b, c] = corners.map(|v| tet.names.map(|n| i8::from(n.vertex == v)));
        let heights = tet.names.map(|n| n.layer.height());
        let numbers = integers::coordinates(self.points(tet), p).combined([a, b, c, heights, [1; 4]]);
        ExactImage::new(prism, numbers)
    }
}
