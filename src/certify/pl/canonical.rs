//! The one text of a complex with its positions (`certs/MESHES.md` section 5).

use std::fmt::Write as _;

use super::super::write::joined;
use crate::mesh::{Complex, Positions, Space};
use crate::number::{Dyadic, Rat};

/// The complex file. Two complexes have the same file just when they are the same.
#[must_use]
pub fn complex_file(complex: &Complex) -> String {
    let mut out = String::new();
    let dimension = complex.space.dimension();
    let _ = write!(
        out,
        "homeo-complex 1\nspace {dimension}\ncorners {}\nvertices {}\n",
        complex.cells.corners(),
        complex.positions.len()
    );
    match &complex.positions {
        Positions::Float(points) => points.iter().for_each(|p| row(&mut out, complex.space, &p.map(float))),
        Positions::Exact(points) => {
            points.iter().for_each(|p| row(&mut out, complex.space, &p.each_ref().map(rational)));
        }
    }
    let _ = writeln!(out, "cells {}", complex.cells.len());
    for cell in complex.cells.flat().chunks(complex.cells.corners()) {
        let _ = writeln!(out, "{}", joined(cell, " "));
    }
    out.push_str("end\n");
    out
}

fn row(out: &mut String, space: Space, numbers: &[String; 3]) {
    let _ = writeln!(out, "{}", joined(numbers.iter().take(space.dimension()), " "));
}

fn dyadic(x: &Dyadic) -> String {
    if x.exponent() == 0 { x.mantissa().to_string() } else { x.to_string() }
}

fn float(x: f64) -> String {
    // `decide::facets` lets finite numbers pass only.
    Dyadic::from_f64(x).map_or_else(|| "0".to_owned(), |x| dyadic(&x))
}

fn rational(x: &Rat) -> String {
    Dyadic::from_rational(x).map_or_else(|| format!("{}/{}", x.numerator(), x.denominator()), |x| dyadic(&x))
}
