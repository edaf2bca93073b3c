//! Total orders of a shell's vertices.

/// Why a list is no order of a shell's vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OrderError {
    /// Not one entry a vertex.
    #[error("a vertex order of {entries} entries for {vertices} vertices")]
    Length {
        /// Entries of the list.
        entries: usize,
        /// Vertices of the shell.
        vertices: usize,
    },
    /// A vertex that does not exist.
    #[error("vertex order: vertex {vertex} does not exist (the shell has {vertices})")]
    OutOfRange {
        /// The entry.
        vertex: u32,
        /// Vertices of the shell.
        vertices: usize,
    },
    /// A vertex comes twice.
    #[error("vertex order: vertex {vertex} comes twice")]
    Twice {
        /// The vertex.
        vertex: u32,
    },
}

/// A total order of all vertices of a shell; it selects one decomposition of every prism.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum VertexOrder {
    /// By vertex id.
    #[default]
    Id,
    /// The vertices from smallest to largest: a permutation.
    List(Vec<u32>),
}

impl VertexOrder {
    /// The order that a list of vertices describes, smallest first.
    ///
    /// # Errors
    /// The list is not a permutation of `0..vertices`.
    pub fn from_list(list: Vec<u32>, vertices: usize) -> Result<Self, OrderError> {
        if list.len() != vertices {
            return Err(OrderError::Length { entries: list.len(), vertices });
        }
        let mut seen = vec![false; vertices];
        for &v in &list {
            match seen.get_mut(v as usize) {
                None => return Err(OrderError::OutOfRange { vertex: v, vertices }),
                Some(true) => return Err(OrderError::Twice { vertex: v }),
                Some(slot) => *slot = true,
            }
        }
        let identity = list.iter().enumerate().all(|(i, &v)| i == v as usize);
        Ok(if identity { Self::Id } else { Self::List(list) })
    }

    /// `ranks[v]` is the place of vertex `v`.
    #[must_use]
    pub fn ranks(&self, vertices: usize) -> Vec<u32> {
        let mut ranks: Vec<u32> = (0..vertices).map(|v| u32::try_from(v).unwrap_or(u32::MAX)).collect();
        if let Self::List(list) = self {
            for (place, &v) in list.iter().enumerate() {
                if let Some(slot) = ranks.get_mut(v as usize) {
                    *slot = u32::try_from(place).unwrap_or(u32::MAX);
                }
            }
        }
        ranks
    }

    /// The order in which `first` come first, as listed, and then the others as they are here.
    #[must_use]
    pub fn with_first(&self, first: &[u32], vertices: usize) -> Self {
        let ranks = self.ranks(vertices);
        let mut by_rank: Vec<u32> = (0..vertices).map(|v| u32::try_from(v).unwrap_or(u32::MAX)).collect();
        by_rank.sort_unstable_by_key(|&v| ranks.get(v as usize).copied());
        let mut list = first.to_vec();
        list.extend(by_rank.into_iter().filter(|v| !first.contains(v)));
        Self::List(list)
    }
}
