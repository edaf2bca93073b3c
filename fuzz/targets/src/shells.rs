//! Small shells: verdicts against the definitions, certificates against the checker, the projection against itself.

use homeo::certify::VertexOrder;
use homeo::number::{Rat, Rational};
use homeo::projection::Projection;
use homeo_proptests::campaign::{certified, compare};
use homeo_proptests::judged::inputs;

use crate::source::Source;

/// A random small shell and mesh: all verdicts are the oracle's, and the checker accepts the certificate.
///
/// # Panics
/// Where they differ.
pub fn verdict(data: &[u8]) {
    let recipe = Source(data).recipe();
    let case = recipe.build();
    compare(&case).unwrap_or_else(|difference| panic!("{difference}\n{recipe:?}\n{case:#?}"));
    if let Ok(Some(outcome)) = certified(&case, false) {
        let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(&case));
        assert_eq!(answer.exit, 0, "{} {}: {recipe:?}\n{}", answer.code, answer.message, outcome.certificate);
    }
}

/// A point of a tet of a random shell: found in that tet, its images come back to it exactly, and the field followed
/// from it ends below one of them.
///
/// # Panics
/// Where that is not so.
pub fn projection(data: &[u8]) {
    let mut source = Source(data);
    let case = source.recipe().build();
    let shell = &case.shell;
    let Ok(order) = VertexOrder::from_list(case.order.clone(), shell.middle.len()) else { return };
    let Ok(projection) = Projection::new(shell, &order) else { return };
    if projection.tets().is_empty() {
        return;
    }
    let tet = usize::from(source.byte()) % projection.tets().len();
    let weights = source.bytes::<4>();
    let total: i64 = weights.iter().map(|w| i64::from(*w)).sum();
    let corners = projection.tets()[tet].names.map(|name| shell.position(name));
    let mut point = [Rat::zero(), Rat::zero(), Rat::zero()];
    for (corner, weight) in corners.into_iter().zip(if total == 0 { [1, 0, 0, 0] } else { weights }) {
        let share =
            Rat::from_i64(i64::from(weight)).over(&Rat::from_i64(total.max(1))).expect("a positive sum");
        for (x, c) in point.iter_mut().zip(corner) {
            *x = x.plus(&share.times(&Rat::from_f64(*c).unwrap()));
        }
    }
    let located = projection.locate(&point);
    assert!(located.iter().any(|l| l.tet as usize == tet), "{point:?} of tet {tet}: {located:?}");
    let images = projection.project_all(&point);
    assert!(!images.is_empty());
    for image in &images {
        assert_eq!(projection.unproject(image).unwrap(), point);
        assert_eq!(projection.canonical(image).unwrap(), *image);
    }
    for location in &located {
        let end = projection.trace(&point, location.tet).expect("the tet holds the point");
        assert!(images.iter().any(|image| image.middle() == end), "{end:?} is below none of {images:?}");
    }
}
