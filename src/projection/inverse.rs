//! The inverse of `P`, and the fibres over the middle surface.

use dashu_base::{Abs, Signed};

use super::exact::{along, rational_point, sub, weighted};
use super::point::barycentric;
use super::{PointError, Projection, Rat, ShellPoint};
use crate::shell::{Layer, Slab, Tet};

/// A straight piece of a fibre: inside one tet, parallel to its field.
#[derive(Clone, Debug, PartialEq)]
pub struct FibrePiece {
    /// The lower end's height and position.
    pub low: (Rat, [Rat; 3]),
    /// The upper end's height and position.
    pub high: (Rat, [Rat; 3]),
    /// The tet, one of [`Projection::tets_of`] the prism.
    pub tet: Tet,
}

impl Projection<'_> {
    /// The smallest prism in which a point can be written, and the point there.
    ///
    /// # Errors
    /// [`PointError`]: no such prism, weights that are not barycentric, a height out of range.
    pub fn canonical(&self, q: &ShellPoint) -> Result<ShellPoint, PointError> {
        self.check(q)?;
        Ok(self.canonical_of(q))
    }

    pub(super) fn check_weights(&self, prism: u32, weights: &[Rat; 3]) -> Result<[u32; 3], PointError> {
        let prisms = self.shell.prism_count();
        let corners =
            *self.shell.faces.get(prism as usize).ok_or(PointError::NoSuchPrism { prism, prisms })?;
        if barycentric(weights) {
            Ok(corners)
        } else {
            Err(PointError::Weights { prism, weights: Box::new(weights.clone()) })
        }
    }

    /// The largest height over a middle point: the weight on corners that are not pinched.
    ///
    /// # Errors
    /// [`PointError`]: no such prism, weights that are not barycentric.
    pub fn thickness(&self, prism: u32, weights: &[Rat; 3]) -> Result<Rat, PointError> {
        Ok(self.limit(self.check_weights(prism, weights)?, weights))
    }

    fn limit(&self, corners: [u32; 3], weights: &[Rat; 3]) -> Rat {
        let thick = (0..3).filter(|&k| !self.shell.is_pinched(corners[k]));
        thick.fold(Rat::ZERO, |sum, k| sum + &weights[k])
    }

    fn check(&self, q: &ShellPoint) -> Result<(), PointError> {
        let corners = self.check_weights(q.prism, &q.weights)?;
        let limit = self.limit(corners, &q.weights);
        if q.height.clone().abs() <= limit {
            return Ok(());
        }
        let height = Box::new(q.height.clone());
        Err(PointError::Height { prism: q.prism, height, limit: Box::new(limit) })
    }

    /// The point of space that `P` maps to `q`: the exact inverse of `P` on the abstract shell.
    ///
    /// In the slab that the height's sign selects, each of the (at most three) tets has one unknown,
    /// the coordinate on the upper or lower end of its pillar half; the tet in which no coordinate is
    /// negative holds the point. On a common face both tets give the same point.
    ///
    /// # Errors
    /// As [`canonical`](Self::canonical). The point need not be canonical.
    pub fn unproject(&self, q: &ShellPoint) -> Result<[Rat; 3], PointError> {
        self.check(q)?;
        let corners = self.shell.faces[q.prism as usize];
        let slab = if q.height.is_negative() { Slab::Bottom } else { Slab::Top };
        let found = self.tets_of(q.prism).iter().filter(|t| t.slab == slab).find_map(|tet| {
            let weights = reference_weights(tet, corners, q)?;
            Some(weighted(self.points(tet).into_iter().zip(weights)))
        });
        // The tets fill the slab up to the height that was checked, so there is always one.
        found.ok_or_else(|| PointError::Height {
            prism: q.prism,
            height: Box::new(q.height.clone()),
            limit: Box::new(self.limit(corners, &q.weights)),
        })
    }

    /// The fibre of `P` over a middle point, from bottom to top: at most six straight pieces of
    /// positive length, each ending where the next one begins. Empty over a pinched vertex or edge.
    ///
    /// # Errors
    /// [`PointError`]: no such prism, weights that are not barycentric.
    pub fn fibre(&self, prism: u32, weights: &[Rat; 3]) -> Result<Vec<FibrePiece>, PointError> {
        let corners = self.check_weights(prism, weights)?;
        let bottom = corners.map(|v| self.shell.position(self.shell.name(v, Layer::Bottom)));
        let mut position = weighted(bottom.into_iter().zip(weights.clone()));
        let mut height = -self.limit(corners, weights);
        let mut pieces = Vec::with_capacity(6);
        for &tet in self.tets_of(prism) {
            // Within a tet a fibre moves the pillar's weight from the lower to the upper end.
            let weight = weight_on(corners, weights, tet.pillar);
            if weight == Rat::ZERO {
                continue;
            }
            let [lo, hi] = tet.field().map(|n| rational_point(self.shell.position(n)));
            let next = along(&position, &weight, &sub(&hi, &lo));
            let above = &height + &weight;
            pieces.push(FibrePiece { low: (height, position), high: (above.clone(), next.clone()), tet });
            (height, position) = (above, next);
        }
        Ok(pieces)
    }
}

fn weight_on(corners: [u32; 3], weights: &[Rat; 3], vertex: u32) -> Rat {
    corners.iter().position(|&v| v == vertex).map_or(Rat::ZERO, |k| weights[k].clone())
}

/// The coordinates in the tet of the point with this image, if none is negative.
fn reference_weights(tet: &Tet, corners: [u32; 3], q: &ShellPoint) -> Option<[Rat; 4]> {
    // The pillar's end away from the middle surface carries what the other vertices lack in height.
    let (outer, distance) = match tet.slab {
        Slab::Bottom => (Layer::Bottom, -q.height.clone()),
        Slab::Top => (Layer::Top, q.height.clone()),
    };
    let others = tet.names.iter().filter(|n| n.vertex != tet.pillar && n.layer == outer);
    let outside = others.fold(distance, |left, n| left - weight_on(corners, &q.weights, n.vertex));
    let inside = weight_on(corners, &q.weights, tet.pillar) - &outside;
    if outside.is_negative() || inside.is_negative() {
        return None;
    }
    Some(tet.names.map(|n| match (n.vertex == tet.pillar, n.layer == outer) {
        (true, true) => outside.clone(),
        (true, false) => inside.clone(),
        (false, _) => weight_on(corners, &q.weights, n.vertex),
    }))
}
