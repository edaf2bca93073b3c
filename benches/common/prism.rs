//! A projection in the words of `reference/cgal/projection.cpp`: a prism's corners in ascending vertex order, and rationals as
//! text.

use std::collections::BTreeSet;

use homeo::projection::{Rat, ShellPoint};
use homeo::shell::{Layer, Shell};

/// The corners of a prism in vertex order.
#[must_use]
pub fn corners(shell: &Shell, ranks: &[u32], prism: u32) -> [u32; 3] {
    let mut corners = shell.faces[prism as usize];
    corners.sort_by_key(|&v| ranks[v as usize]);
    corners
}

/// A case: the nine points of a prism, and a point.
#[must_use]
pub fn numbers(shell: &Shell, corners: [u32; 3], p: &[f64; 3]) -> Vec<f64> {
    let layers = [Layer::Bottom, Layer::Middle, Layer::Top].into_iter();
    let points = layers.flat_map(|layer| corners.map(|v| shell.layer(layer)[v as usize]));
    points.chain([*p]).flatten().collect()
}

/// The image with weights on these corners, if all its weight is there.
#[must_use]
pub fn written(shell: &Shell, image: &ShellPoint, corners: [u32; 3]) -> Option<String> {
    let own = shell.faces[image.prism as usize];
    let inside = own.iter().zip(&image.weights).all(|(v, w)| corners.contains(v) || *w == Rat::ZERO);
    let weight = |v: u32| own.iter().position(|&o| o == v).map_or(Rat::ZERO, |k| image.weights[k].clone());
    let [a, b, c] = corners.map(weight);
    inside.then(|| format!("{a} {b} {c} {}", image.height))
}

/// An answer: the mask of the prism's tets that hold the point, then four numbers an image. `None` for anything else.
#[must_use]
pub fn parse(text: &str) -> Option<(u8, BTreeSet<String>)> {
    let mut words = text.split(' ');
    let mask = words.next()?.parse().ok()?;
    let rest: Vec<&str> = words.collect();
    let images = rest.chunks(4).map(|four| (four.len() == 4).then(|| four.join(" ")));
    Some((mask, images.collect::<Option<_>>()?))
}
