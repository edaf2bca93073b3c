//! Images not in lowest terms against those of rational arithmetic, and the integers behind them.

use super::generate::{in_tet, scaled, shell, spiral, times};
use crate::projection::exact::{Homogeneous, TetWeights, rational_point};
use crate::projection::integers::{Integers, coordinates};
use crate::projection::{ExactImage, Projection, Rat, ShellPoint};
use crate::shell::VertexOrder;
use crate::testing::Random;
use dashu_base::{Signed, UnsignedAbs};

fn points(images: &[ExactImage]) -> Vec<ShellPoint> {
    images.iter().map(ExactImage::to_point).collect()
}

/// All images in a prism by the field and the height, from rational arithmetic alone.
fn in_prism(projection: &Projection<'_>, prism: u32, p: &[Rat; 3]) -> Vec<ShellPoint> {
    let mut out: Vec<ShellPoint> = Vec::new();
    for tet in projection.tets_of(prism) {
        let Some(weights) = TetWeights::new(projection.points(tet), &Homogeneous::new(p)) else { continue };
        if !weights.is_inside() {
            continue;
        }
        let on = |v: u32| weights.combine(tet.names.map(|n| i8::from(n.vertex == v)));
        let height = weights.combine(tet.names.map(|n| n.layer.height()));
        let point = ShellPoint { prism, weights: projection.shell().faces[prism as usize].map(on), height };
        if !out.contains(&point) {
            out.push(point);
        }
    }
    out
}

fn check(projection: &Projection<'_>, p: &[f64; 3]) -> usize {
    let exact = rational_point(p);
    let expected = projection.project_all(&exact);
    let images = projection.images(p);
    assert_eq!(points(&images), expected);
    assert_eq!(projection.image(p), images.first().cloned());
    assert_eq!(projection.project_exactly(p), expected.first().cloned());
    for image in &images {
        let [a, b, c] = image.weight_numerators();
        assert!(![&a, &b, &c].into_iter().any(Signed::is_negative));
        assert_eq!((a + b + c).unsigned_abs(), image.denominator());
        let height = Rat::from_parts(image.height_numerator(), image.denominator());
        assert_eq!(height, ShellPoint::from(image).height);
        for other in &images {
            assert_eq!(image == other, image.to_point() == other.to_point());
        }
    }
    for location in projection.locate(&exact) {
        let prism = projection.tets()[location.tet as usize].prism;
        assert_eq!(points(&projection.images_in(prism, p)), in_prism(projection, prism, &exact));
    }
    images.len()
}

#[test]
fn images_are_those_of_rational_arithmetic() {
    let mut random = Random(21);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..60 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        for i in 0..60 {
            let tet = random.below(projection.tets().len());
            let p = in_tet(&projection, tet, &random.weights()).map(|x| x.to_f64().value());
            let p = match i % 6 {
                0 => shell.middle[random.below(shell.vertex_count())],
                1 => p.map(|x| x + random.double(true)),
                _ => p,
            };
            *if check(&projection, &p) > 0 { &mut inside } else { &mut outside } += 1;
        }
    }
    assert!(inside > 1500 && outside > 100, "{inside} {outside}");
}

#[test]
fn a_shell_that_overlaps_itself_gives_every_image() {
    let shell = spiral(20);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let mut random = Random(22);
    let mut counts = [0; 4];
    for i in 0..800 {
        let p =
            in_tet(&projection, i % projection.tets().len(), &random.weights()).map(|x| x.to_f64().value());
        counts[check(&projection, &p).min(3)] += 1;
    }
    // Half of the strip's 20 quads lie on two others, the rest on one.
    assert!(counts[1] == 0 && counts[2] > 100 && counts[3] > 100, "{counts:?}");
}

/// Powers of two on each axis change no image, as long as no bit is lost.
#[test]
fn images_at_the_far_ends_of_the_range() {
    let mut random = Random(24);
    for exponents in [[-1071; 3], [1020; 3], [-1071, 0, 1020], [1020, -1071, -300], [-40, 30, 500]] {
        let scale = |p: &[f64; 3]| times(p, exponents);
        let plain = spiral(12);
        let shell = scaled(&plain, exponents);
        let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
        let before = Projection::new(&plain, &VertexOrder::Id).unwrap();
        let (mut inside, mut outside) = (0, 0);
        for i in 0..200 {
            // Multiples of 1/8, the unit of -1071 and of what overflows at 1020 least.
            let mut p = [0.0; 3].map(|_: f64| f64::from(random.integer(-31, 31)) / 8.0);
            p[2] /= 4.0;
            p[2] = (p[2] * 8.0).round() / 8.0;
            if i % 5 == 0 {
                p = plain.top[random.below(plain.vertex_count())];
            }
            let count = check(&projection, &scale(&p));
            assert_eq!(points(&projection.images(&scale(&p))), points(&before.images(&p)));
            *if count > 0 { &mut inside } else { &mut outside } += 1;
        }
        assert!(inside > 60 && outside > 30, "{inside} {outside}");
    }
}

#[test]
fn there_is_no_image_of_what_is_no_point_or_no_prism() {
    let shell = spiral(3);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(projection.images(&[bad, 0.0, 0.0]), []);
        assert_eq!(projection.image(&[3.0, bad, 0.0]), None);
        assert_eq!(projection.images_in(0, &[0.0, 0.0, bad]), []);
    }
    assert_eq!(projection.images_in(6, &[1.5, 0.5, 0.0]), []);
    assert_eq!(projection.images_in(u32::MAX, &[1.5, 0.5, 0.0]), []);
}

/// Numbers of about `bits` bits below one, of either sign.
fn number(random: &mut Random, bits: i32) -> f64 {
    random.double(false) * 2_f64.powi(-((random.next() % bits.unsigned_abs() as u64) as i32))
}

/// The ratios of the integers, of whichever kind, are the barycentric coordinates of rational arithmetic.
#[test]
fn every_width_gives_the_same_coordinates() {
    let mut random = Random(23);
    let mut kinds = [0; 3];
    for i in 0..3000 {
        let spread = [1, 8, 60, 400][i % 4];
        let mut tet = [[0.0; 3]; 4].map(|x: [f64; 3]| x.map(|_| number(&mut random, spread)));
        let p = [0.0; 3].map(|_: f64| number(&mut random, spread));
        let exact = Homogeneous::new(&rational_point(&p));
        let Some(mut expected) = TetWeights::new(tet.each_ref(), &exact) else { continue };
        if crate::predicate::orient3d(&tet[0], &tet[1], &tet[2], &tet[3]).is_negative() {
            tet.swap(0, 1);
            expected = TetWeights::new(tet.each_ref(), &exact).unwrap();
        }
        let found = coordinates(tet.each_ref(), &p);
        kinds[kind(&found)] += 1;
        let found = found.combined([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]).to_big();
        let sum = found.iter().sum::<dashu_int::IBig>();
        assert!(sum.is_positive());
        for k in 0..4 {
            let mut only = [0; 4];
            only[k] = 1;
            let ratio = Rat::from_parts(found[k].clone(), (&sum).unsigned_abs());
            assert_eq!(ratio, expected.combine(only), "{tet:?} {p:?}");
        }
    }
    assert!(kinds.iter().all(|&n| n > 200), "{kinds:?}");
}

fn kind<const N: usize>(found: &Integers<N>) -> usize {
    match found {
        Integers::Narrow(_) => 0,
        Integers::Wide(_) => 1,
        Integers::Big(_) => 2,
    }
}

/// The largest integers of each kind, and the smallest of the next one: a corner at `±x`, the others far on the other side.
#[test]
fn the_ends_of_every_width() {
    let one = 2_f64.powi(-60);
    let mut kinds = [0; 3];
    for exponent in 0..200 {
        let far = one * 2_f64.powi(exponent);
        for low in [far, far.next_down(), far.next_up()] {
            // Around the origin and one unit beside it, so that the unit of each axis is `one` or finer.
            for p in [[0.0; 3], [one, -one, one]] {
                let tet = [[-low, -low, -low], [low, 0.0, 0.0], [0.0, low, one], [one, 0.0, low]];
                let exact = Homogeneous::new(&rational_point(&p));
                let expected = TetWeights::new(tet.each_ref(), &exact).unwrap();
                let found = coordinates(tet.each_ref(), &p);
                kinds[kind(&found)] += 1;
                let found = found.to_big();
                let sum = found.iter().sum::<dashu_int::IBig>();
                let inverted = sum.is_negative();
                for k in 0..4 {
                    let mut only = [0; 4];
                    only[k] = 1;
                    let numerator = if inverted { -found[k].clone() } else { found[k].clone() };
                    assert_eq!(Rat::from_parts(numerator, (&sum).unsigned_abs()), expected.combine(only));
                }
            }
        }
    }
    assert!(kinds.iter().all(|&n| n > 100), "{kinds:?}");
}
