//! Rational points.

use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::oracle::exact::{Point, Weights, orient};

/// A point as sums of weighted corners, and the sum of the weights.
#[derive(Clone, Debug)]
pub(super) struct Places {
    scaled: Point,
    total: IBig,
}

impl Places {
    /// The weighted mean of the points.
    pub(super) fn mixed(points: &[&Point], weights: &[IBig]) -> Self {
        let coordinate = |k: usize| points.iter().zip(weights).map(|(p, w)| &p[k] * w).sum::<IBig>();
        Self { scaled: [coordinate(0), coordinate(1), coordinate(2)], total: weights.iter().sum() }
    }

    /// Its coordinates in a tet, times one number that has the determinant's sign.
    pub(super) fn in_tet(&self, tet: [&Point; 4]) -> Weights {
        let grown = tet.map(|p| [0, 1, 2].map(|k| &p[k] * &self.total));
        (0..4)
            .map(|k| {
                let mut with = grown.each_ref();
                with[k] = &self.scaled;
                orient(with[0], with[1], with[2], with[3])
            })
            .collect()
    }

    fn exact(&self) -> [RBig; 3] {
        self.scaled.each_ref().map(|x| RBig::from(x.clone()) / RBig::from(self.total.clone()))
    }
}

impl PartialEq for Places {
    fn eq(&self, other: &Self) -> bool {
        self.exact() == other.exact()
    }
}
