//! orient3d in rational numbers: the determinant, exactly, without a filter.

use homeo::number::dyadic::decompose;
use homeo::number::{Rat, Rational};
use homeo::predicate::Sign;
use homeo_benches::quads::{Implementation, Quad};

/// The determinant by expansion; numbers are converted in every call, as their user has doubles.
fn orient<R: Rational>(quad: &Quad) -> i8 {
    let number = |x: f64| {
        let (mantissa, exponent) = decompose(x);
        R::from_scaled(mantissa, exponent)
    };
    let [a, b, c, d] = quad.map(|p| p.map(number));
    let minus = |p: &[R; 3]| [0, 1, 2].map(|k| p[k].minus(&a[k]));
    let [u, v, w] = [minus(&b), minus(&c), minus(&d)];
    let minor = |i: usize, j: usize| v[i].times(&w[j]).minus(&v[j].times(&w[i]));
    let [x, y, z] = [u[0].times(&minor(1, 2)), u[1].times(&minor(2, 0)), u[2].times(&minor(0, 1))];
    match x.plus(&y).plus(&z).sign() {
        Sign::Negative => -1,
        Sign::Zero => 0,
        Sign::Positive => 1,
    }
}

/// Rational numbers by the name of their crate; `None` where the feature of this name is off.
pub(crate) fn all() -> [(&'static str, Option<Implementation>); 4] {
    [
        ("dashu", Some(orient::<Rat>)),
        ("rug", rug()),
        ("malachite", malachite()),
        ("num-rational", num_rational()),
    ]
}

#[cfg(feature = "rug")]
fn rug() -> Option<Implementation> {
    Some(orient::<rug::Rational>)
}

#[cfg(not(feature = "rug"))]
fn rug() -> Option<Implementation> {
    None
}

#[cfg(feature = "malachite")]
fn malachite() -> Option<Implementation> {
    Some(orient::<malachite::rational::Rational>)
}

#[cfg(not(feature = "malachite"))]
fn malachite() -> Option<Implementation> {
    None
}

#[cfg(feature = "num-rational")]
fn num_rational() -> Option<Implementation> {
    Some(orient::<num_rational::Ratio<num_bigint::BigInt>>)
}

#[cfg(not(feature = "num-rational"))]
fn num_rational() -> Option<Implementation> {
    None
}
