//! Fast predicates against the exact ones.

use homeo::predicate::{
    Axis, Sign, dot_sign, dot_sign_exact, incircle, incircle_exact, insphere, insphere_exact, orient2d,
    orient2d_exact, orient3d, orient3d_exact,
};

use crate::source::Source;

/// A finite double: any bits, a small integer times a power of two, or one ulp beside an earlier coordinate.
fn coordinate(source: &mut Source<'_>, known: &[f64]) -> f64 {
    let kind = source.byte();
    let pick = |at: u8| known.get(usize::from(at) % known.len().max(1)).copied().unwrap_or(1.0);
    let x = match kind % 6 {
        0 => f64::from_bits(u64::from_le_bytes(source.bytes())),
        1 => f64::from(i16::from_le_bytes(source.bytes())),
        2 => {
            f64::from(i16::from_le_bytes(source.bytes()))
                * f64::from(i32::from(source.byte()) * 8 - 1020).exp2()
        }
        3 => pick(source.byte()),
        4 => pick(source.byte()).next_up(),
        // On the way between two known ones: nearly collinear and coplanar points.
        _ => f64::midpoint(pick(source.byte()), pick(source.byte())),
    };
    if x.is_finite() { x } else { 0.0 }
}

/// Signs of determinants: the stages together say what big integers alone say.
///
/// # Panics
/// Where they do not.
pub fn signs(data: &[u8]) {
    let mut source = Source(data);
    let mut flat: Vec<f64> = Vec::with_capacity(15);
    while flat.len() < 15 {
        let x = coordinate(&mut source, &flat);
        flat.push(x);
    }
    let [a, b, c, d, e] = [0, 3, 6, 9, 12].map(|i| [flat[i], flat[i + 1], flat[i + 2]]);
    let volume = orient3d(&a, &b, &c, &d);
    assert_eq!(volume, orient3d_exact(&a, &b, &c, &d), "orient3d {flat:?}");
    assert_eq!(orient3d(&b, &a, &c, &d), volume * Sign::Negative, "orient3d, turned: {flat:?}");
    assert_eq!(dot_sign(&a, &b, &c, &d, &e), dot_sign_exact(&a, &b, &c, &d, &e), "dot_sign {flat:?}");
    let sphere = insphere(&a, &b, &c, &d, &e);
    assert_eq!(sphere, insphere_exact(&a, &b, &c, &d, &e), "insphere {flat:?}");
    assert_eq!(insphere(&b, &a, &c, &d, &e), sphere * Sign::Negative, "insphere, turned: {flat:?}");
    let [p, q, r, s] = [a, b, c, d].map(|[x, y, _]| [x, y]);
    assert_eq!(incircle(&p, &q, &r, &s), incircle_exact(&p, &q, &r, &s), "incircle {flat:?}");
    for axis in Axis::ALL {
        assert_eq!(
            orient2d(&a, &b, &c, axis),
            orient2d_exact(&a, &b, &c, axis),
            "orient2d {axis:?} {flat:?}"
        );
    }
}
