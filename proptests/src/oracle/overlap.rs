//! C10 from its definition: every two tets of an order, all their common points.

use super::World;
use super::exact::{Weights, clip, orient, positive, simplex};
use super::tets::Code;

impl World<'_> {
    /// Are the tets that an order selects positive, and do two of them share only their common face?
    ///
    /// What two tets share is convex, and its corners lie on faces of one or the other.
    #[must_use]
    pub fn injective(&self, rank: &[usize]) -> bool {
        let tets = self.selected(rank);
        let apart = |(i, &s): (usize, &usize)| {
            tets[..i].iter().all(|&t| self.faces_stay_off(s, t) && self.faces_stay_off(t, s))
        };
        tets.iter().all(|&t| positive(&self.determinants[t])) && tets.iter().enumerate().all(apart)
    }

    /// Are all corners of what the faces of tet `s` share with tet `t` common corners of both?
    fn faces_stay_off(&self, s: usize, t: usize) -> bool {
        let (ours, theirs) = (self.tets.all[s].names, self.tets.all[t].names);
        let beyond = |k: usize| {
            let [mine, other] = [ours, theirs].map(|names| names.map(|n| self.at(n)[k].clone()));
            mine.iter().max() < other.iter().min() || mine.iter().min() > other.iter().max()
        };
        (0..3).any(beyond)
            || (0..4).all(|skip| {
                let face: Vec<Code> = (0..4).filter(|&i| i != skip).map(|i| ours[i]).collect();
                self.common(&face, theirs).iter().all(|point| {
                    let used: Vec<usize> = (0..3).filter(|&i| positive(&point[i])).collect();
                    used.len() == 1 && theirs.contains(&face[used[0]])
                })
            })
    }

    /// The corners of a triangle's part in a positive tet, as weights on the triangle.
    fn common(&self, face: &[Code], tet: [Code; 4]) -> Vec<Weights> {
        (0..4).fold(simplex(3), |polygon, k| {
            let form = face.iter().map(|&n| {
                let with: Vec<_> = (0..4).map(|i| self.at(if i == k { n } else { tet[i] })).collect();
                orient(with[0], with[1], with[2], with[3])
            });
            clip(&polygon, &form.collect::<Weights>())
        })
    }
}
