//! Flat lists of coordinates as points.

/// The first `N` points of dimension `D`; `None` if there are not exactly `N`.
pub(super) fn points<const N: usize, const D: usize>(case: &[f64]) -> Option<[[f64; D]; N]> {
    if case.len() != N * D {
        return None;
    }
    let mut out = [[0.0; D]; N];
    for (out, x) in out.as_flattened_mut().iter_mut().zip(case) {
        *out = *x;
    }
    Some(out)
}
