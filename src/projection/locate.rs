//! The map `P` and the search for the tets that hold a point.

use std::ops::Range;

use super::boxes::BoxTree;
use super::exact::{Homogeneous, TetWeights, outer_box};
use super::point::Stars;
use super::{ProjectionError, Rat, ShellPoint};
use crate::predicate::{Sign, orient3d};
use crate::shell::VertexOrder;
use crate::shell::{Name, Shell, Tet, validate};

/// The projection of a shell under one vertex order, ready to answer for any number of points.
///
/// Needs positive tets of that order (`positivity` restricted to `S_<`), nothing else: the shell may
/// overlap itself. Construction takes `O(n log n)` time and linear memory; a query visits the tets
/// whose boxes hold the point.
#[derive(Debug)]
pub struct Projection<'s> {
    pub(super) shell: &'s Shell,
    tets: Vec<Tet>,
    /// Prism `p` has the tets `starts[p]..starts[p + 1]`.
    starts: Vec<u32>,
    tree: BoxTree,
    pub(super) stars: Stars,
}

/// A tet that holds a point, and the smallest simplex of the shell there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The tet: an index into [`Projection::tets`].
    pub tet: u32,
    /// Its vertices with positive barycentric coordinates, ascending: the point's carrier.
    pub carrier: Vec<Name>,
}

impl<'s> Projection<'s> {
    /// Checks the shell and builds the search structure.
    ///
    /// # Errors
    /// [`ProjectionError`]: the shell breaks an input condition, a tet of this order is not
    /// positive, or the order is no permutation.
    pub fn new(shell: &'s Shell, order: &VertexOrder) -> Result<Self, ProjectionError> {
        validate::validate(shell)?;
        let vertices = shell.vertex_count();
        let ranks = ranks(order, vertices)?;
        let prisms = shell.prism_count();
        // Six tets a prism, and two nodes of the tree a tet.
        let count = u32::try_from(prisms).ok().filter(|n| n.checked_mul(12).is_some());
        let count = count.ok_or(ProjectionError::TooMany { prisms })?;
        let mut tets = Vec::with_capacity(6 * prisms);
        let mut starts = vec![0];
        for prism in 0..count {
            for tet in shell.tets_of_order(prism, |v| ranks[v as usize]) {
                let [a, b, c, d] = tet.names.map(|n| shell.position(n));
                if !orient3d(a, b, c, d).is_positive() {
                    return Err(ProjectionError::NotPositive { prism, names: tet.names });
                }
                tets.push(tet);
            }
            // At most 6 a prism, which was seen to fit.
            starts.push(u32::try_from(tets.len()).unwrap_or(u32::MAX));
        }
        let tree = BoxTree::new(tets.iter().map(|t| t.names.map(|n| shell.position(n))));
        let stars = Stars::new(vertices, &shell.faces);
        Ok(Self { shell, tets, starts, tree, stars })
    }

    /// The shell.
    #[must_use]
    pub fn shell(&self) -> &'s Shell {
        self.shell
    }

    /// The tets of `S_<`: prism after prism, bottom slab first, from the lowest tet to the highest.
    #[must_use]
    pub fn tets(&self) -> &[Tet] {
        &self.tets
    }

    /// The tets of one prism, in the same order; empty where there is no such prism.
    #[must_use]
    pub fn tets_of(&self, prism: u32) -> &[Tet] {
        &self.tets[self.range_of(prism)]
    }

    /// Where the tets of a prism are in the list of all.
    pub(super) fn range_of(&self, prism: u32) -> Range<usize> {
        let p = prism as usize;
        match (self.starts.get(p), self.starts.get(p.saturating_add(1))) {
            (Some(&from), Some(&to)) => from as usize..to as usize,
            _ => 0..0,
        }
    }

    pub(super) fn tree(&self) -> &BoxTree {
        &self.tree
    }

    /// The tets whose closed boxes meet a closed box, ascending.
    pub(crate) fn tets_near(&self, bounds: [[f64; 3]; 2]) -> Vec<u32> {
        self.tree.meeting(bounds)
    }

    pub(crate) fn points(&self, tet: &Tet) -> [&'s [f64; 3]; 4] {
        tet.names.map(|n| self.shell.position(n))
    }

    /// The tets that hold the point, each with its barycentric coordinates there.
    pub(super) fn weights_at(&self, p: &[Rat; 3]) -> Vec<(u32, TetWeights)> {
        let point = Homogeneous::new(p);
        let near = self.tree.meeting(outer_box(p)).into_iter();
        near.filter_map(|id| {
            let weights = TetWeights::new(self.points(&self.tets[id as usize]), &point)?;
            weights.is_inside().then_some((id, weights))
        })
        .collect()
    }

    /// All closed tets of `S_<` that hold the point, ascending. Exact.
    #[must_use]
    pub fn locate(&self, p: &[Rat; 3]) -> Vec<Location> {
        let found = self.weights_at(p).into_iter();
        found
            .map(|(tet, weights)| {
                let positive = weights.numerators.each_ref().map(|n| *n != dashu_int::IBig::ZERO);
                self.location(tet, positive)
            })
            .collect()
    }

    /// [`locate`](Self::locate) for a point with `f64` coordinates, taken exactly; by orientation
    /// predicates, so much faster. No location for coordinates that are not finite.
    #[must_use]
    pub fn locate_f64(&self, p: &[f64; 3]) -> Vec<Location> {
        let mut found = Vec::new();
        self.each_holder(p, |(tet, signs)| found.push(self.location(tet, signs.map(Sign::is_positive))));
        found.sort_unstable_by_key(|location| location.tet);
        found
    }

    fn location(&self, tet: u32, positive: [bool; 4]) -> Location {
        let names = self.tets[tet as usize].names;
        let mut carrier: Vec<Name> = (0..4).filter(|&k| positive[k]).map(|k| names[k]).collect();
        carrier.sort_unstable();
        Location { tet, carrier }
    }

    /// Does the closed shell hold the point? Exact.
    #[must_use]
    pub fn is_inside(&self, p: &[Rat; 3]) -> bool {
        !self.weights_at(p).is_empty()
    }

    /// [`is_inside`](Self::is_inside) for `f64` coordinates; `false` where one is not finite.
    #[must_use]
    pub fn is_inside_f64(&self, p: &[f64; 3]) -> bool {
        let mut inside = false;
        self.each_holder(p, |_| inside = true);
        inside
    }

    /// The image of a point under `P`, exactly; `None` outside of the shell.
    ///
    /// Where the shell overlaps itself a point of space has several images: the answer is then the
    /// first of [`project_all`](Self::project_all), and only a lift can tell which one is meant.
    #[must_use]
    pub fn project(&self, p: &[Rat; 3]) -> Option<ShellPoint> {
        self.project_all(p).into_iter().next()
    }

    /// All images of a point, canonical, different, in ascending order of prisms: none outside, one
    /// where the shell does not overlap itself.
    #[must_use]
    pub fn project_all(&self, p: &[Rat; 3]) -> Vec<ShellPoint> {
        let mut images: Vec<ShellPoint> = Vec::new();
        for (tet, weights) in self.weights_at(p) {
            let image = self.canonical_of(&self.image_of(tet, &weights));
            if !images.contains(&image) {
                images.push(image);
            }
        }
        images.sort_by_key(|image| image.prism);
        images
    }

    /// The image by barycentric sums (THEORY section 1, reference map).
    fn image_of(&self, tet: u32, weights: &TetWeights) -> ShellPoint {
        let tet = &self.tets[tet as usize];
        let corners = self.shell.faces[tet.prism as usize];
        let on = |v: u32| weights.combine(tet.names.map(|n| i8::from(n.vertex == v)));
        let height = weights.combine(tet.names.map(|n| n.layer.height()));
        ShellPoint { prism: tet.prism, weights: corners.map(on), height }
    }

    /// The canonical form of a point whose prism and weights are known to be good.
    pub(super) fn canonical_of(&self, q: &ShellPoint) -> ShellPoint {
        let (prism, weights) = self.stars.canonical(&self.shell.faces, q.prism, &q.weights);
        ShellPoint { prism, weights, height: q.height.clone() }
    }
}

/// `ranks[v]` for a list that is a permutation.
fn ranks(order: &VertexOrder, vertices: usize) -> Result<Vec<u32>, ProjectionError> {
    if let VertexOrder::List(list) = order {
        let bad = || ProjectionError::Order { entries: list.len(), vertices };
        VertexOrder::from_list(list.clone(), vertices).map_err(|_| bad())?;
    }
    Ok(order.ranks(vertices))
}
