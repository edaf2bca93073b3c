//! The tets of a shell's prisms, by the table of [`decomposition`](super::decomposition).

use super::decomposition::{self, LocalTet, TETS};
use super::{Name, Shell, Slab};

/// A tet of a prism.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tet {
    /// Its vertices, ordered so that `det[p1-p0, p2-p0, p3-p0]` is positive in the straight unit
    /// prism.
    pub names: [Name; 4],
    /// The vertex whose pillar is an edge of the tet; never a pinched one.
    pub pillar: u32,
    /// The slab it lies in.
    pub slab: Slab,
    /// The prism: an index into [`Shell::faces`].
    pub prism: u32,
    /// The tet's index in [`TETS`].
    pub local: u8,
}

impl Tet {
    /// The two ends of the carried pillar half. The field in the tet is `V = hi - lo`.
    #[must_use]
    pub fn field(&self) -> [Name; 2] {
        let end = |layer| Name { vertex: self.pillar, layer };
        [end(self.slab.lo()), end(self.slab.hi())]
    }

    /// The names in ascending order: equal for two tets exactly when they are the same tet.
    #[must_use]
    pub fn sorted_names(&self) -> [Name; 4] {
        let mut names = self.names;
        names.sort_unstable();
        names
    }
}

/// A prism's three corners with what is needed to name its points.
#[derive(Clone, Copy)]
struct Corners {
    prism: u32,
    vertices: [u32; 3],
    pinched: [bool; 3],
}

impl Corners {
    /// The tet `TETS[local]` of the slab, unless it holds both ends of a pinched pillar.
    fn tet(&self, slab: Slab, local: usize) -> Option<Tet> {
        let LocalTet { vertices, pillar, .. } = TETS.get(local)?;
        // A tet holds both ends of exactly one pillar: the one that it carries.
        if self.pinched[usize::from(*pillar)] {
            return None;
        }
        let names = vertices.map(|(corner, is_hi)| {
            let k = usize::from(corner);
            let layer = match (self.pinched[k], is_hi) {
                (true, _) => super::Layer::Middle,
                (false, true) => slab.hi(),
                (false, false) => slab.lo(),
            };
            Name { vertex: self.vertices[k], layer }
        });
        let pillar = self.vertices[usize::from(*pillar)];
        // The table has 12 entries, so that the cast keeps the value.
        #[allow(clippy::cast_possible_truncation)]
        let local = local as u8;
        Some(Tet { names, pillar, slab, prism: self.prism, local })
    }
}

impl Shell {
    fn corners(&self, prism: u32) -> Option<Corners> {
        let vertices = *self.faces.get(prism as usize)?;
        Some(Corners { prism, vertices, pinched: vertices.map(|v| self.is_pinched(v)) })
    }

    /// All tets of a prism: 12 of the bottom slab, then 12 of the top slab, in table order.
    ///
    /// Tets that hold both ends of a pinched pillar vanish and are left out: 16 remain with one
    /// pinched corner, 8 with two, none with three. Some of the remaining ones are then the same
    /// tet under another table index; see [`Shell::prism_tets_unique`]. Empty where the shell has
    /// no such prism.
    pub fn prism_tets(&self, prism: u32) -> impl Iterator<Item = Tet> + use<> {
        self.corners(prism).into_iter().flat_map(|corners| {
            Slab::BOTH
                .into_iter()
                .flat_map(move |slab| (0..TETS.len()).filter_map(move |local| corners.tet(slab, local)))
        })
    }

    /// The different tets of a prism: 24, 8 with one pinched corner, 2 with two. Of equal tets the
    /// one that comes first in the table is kept; equal tets carry the same pillar.
    pub fn prism_tets_unique(&self, prism: u32) -> impl Iterator<Item = Tet> + use<> {
        let mut seen: Vec<[Name; 4]> = Vec::with_capacity(24);
        self.prism_tets(prism).filter(move |tet| {
            let key = tet.sorted_names();
            let new = !seen.contains(&key);
            if new {
                seen.push(key);
            }
            new
        })
    }

    /// The tets of a prism under one total order of all vertices: `rank(v)` is `v`'s place in the
    /// order, and must differ for different vertices. Three a slab, bottom slab first, from the
    /// lowest tet to the highest; those on a pinched pillar are left out. With `rank` the identity
    /// this is the default order, by vertex id.
    pub fn tets_of_order<R: Fn(u32) -> u32>(
        &self,
        prism: u32,
        rank: R,
    ) -> impl Iterator<Item = Tet> + use<R> {
        self.corners(prism).into_iter().flat_map(move |corners| {
            let order = decomposition::order_of_ranks(corners.vertices.map(&rank));
            let locals = decomposition::decomposition(order);
            Slab::BOTH
                .into_iter()
                .flat_map(move |slab| locals.into_iter().filter_map(move |local| corners.tet(slab, local)))
        })
    }

    /// The number of tets that [`Shell::prism_tets`] lists over all prisms. Linear time.
    #[must_use]
    pub fn tet_count(&self) -> usize {
        let of_face = |face: &[u32; 3]| 8 * face.iter().filter(|&&v| !self.is_pinched(v)).count();
        self.faces.iter().map(of_face).sum()
    }
}
