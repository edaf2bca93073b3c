use crate::fuzz::generate::{Generator, Pool, Source};
use crate::fuzz::random::Random;
use crate::fuzz::{Predicate, judge, symmetry};
use crate::predicate::Sign;
use crate::predicate::tests::brute::{self, I3};
use crate::predicate::tests::oracle;

/// A grid case with both exact values and doubles, axes scaled by powers of two.
fn grid<const N: usize>(random: &mut Random) -> ([I3; N], Vec<f64>) {
    let width = 1 + random.below(7);
    let mut thickness = [width, width, if random.below(3) == 0 { 0 } else { width }];
    thickness.rotate_left(random.below(3));
    let grid = [(); N].map(|()| thickness.map(|w| i64::try_from(random.below(w + 1)).unwrap()));
    let exponents = [(); 3].map(|()| [0, 0, -1000, 1000][random.below(4)]);
    let flat = grid.iter().flat_map(|p| [0, 1, 2].map(|k| p[k] as f64 * 2.0_f64.powi(exponents[k])));
    (grid, flat.collect())
}

#[test]
fn meetings_agree_with_brute_force() {
    let mut random = Random(3);
    let mut counts = [[0; 3]; 4];
    for _ in 0..4000 {
        let (p, case) = grid::<6>(&mut random);
        if Predicate::TriangleTriangle.accepts(&case) {
            let expected = brute::dimension(&p[..3], &p[3..]) >= 0;
            assert_eq!(judge(Predicate::TriangleTriangle, &case), Some(truth(expected)), "{p:?}");
            counts[0][usize::from(expected)] += 1;
        }
        let (p, case) = grid::<5>(&mut random);
        if Predicate::SegmentTriangle.accepts(&case) {
            let expected = brute::dimension(&p[..2], &p[2..]) >= 0;
            assert_eq!(judge(Predicate::SegmentTriangle, &case), Some(truth(expected)), "{p:?}");
            counts[1][usize::from(expected)] += 1;
            // The ray has left the grid by then.
            let far = [0, 1, 2].map(|k| p[0][k] + 10 * (p[1][k] - p[0][k]));
            let expected = brute::dimension(&[p[0], far], &p[2..]) >= 0;
            assert_eq!(judge(Predicate::RayTriangle, &case), Some(truth(expected)), "{p:?}");
            counts[2][usize::from(expected)] += 1;
        }
        let expected = position(&p);
        assert_eq!(judge(Predicate::PointInTet, &case), Some(expected), "{p:?}");
        counts[3][usize::try_from(expected.as_i8() + 1).unwrap()] += 1;
    }
    assert!(counts[..3].iter().all(|c| c[0] > 100 && c[1] > 100), "{counts:?}");
    assert!(counts[3].iter().all(|n| *n > 5), "{counts:?}");
}

fn truth(holds: bool) -> Sign {
    if holds { Sign::Positive } else { Sign::Zero }
}

/// Of the last point in the tet of the other four, by the definition.
fn position(p: &[I3; 5]) -> Sign {
    let (tet, point) = (&p[..4], &p[4..]);
    let faces =
        (0..4).map(|i| tet.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, p)| *p).collect::<Vec<_>>());
    if faces.into_iter().any(|face| brute::dimension(point, &face) >= 0) {
        Sign::Zero
    } else if brute::dimension(point, tet) >= 0 {
        Sign::Positive
    } else {
        Sign::Negative
    }
}

/// The determinants of `docs/SUBJECTS.md`, in big integers of another library.
fn by_definition(predicate: Predicate, x: &[f64]) -> Option<Sign> {
    let p: Vec<[f64; 3]> = x.chunks_exact(3).map(|p| p.try_into().unwrap()).collect();
    let q: Vec<[f64; 2]> = x.chunks_exact(2).map(|p| p.try_into().unwrap()).collect();
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = [0, 1, 2].map(|i| [q[i][0], q[i][1], 0.0]);
            oracle::orient2d(&a, &b, &c, 2)
        }
        Predicate::Orient3d => oracle::orient3d(&p[0], &p[1], &p[2], &p[3]),
        Predicate::Incircle => oracle::lifted(&q),
        Predicate::Insphere => -oracle::lifted(&p),
        Predicate::DotSign => oracle::dot_sign(&p[0], &p[1], &p[2], &p[3], &p[4]),
        Predicate::PrismPositivity => {
            // The 12 tets as the page lists them: l0 l1 l2 are 0 1 2, h0 h1 h2 are 3 4 5.
            let tets = "0123 0124 0125 0345 1345 2345 0154 0254 1035 1235 2043 2143";
            let sign = |tet: &str| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| &p[usize::from(tet.as_bytes()[i] - b'0')]);
                oracle::orient3d(a, b, c, d)
            };
            tets.split(' ').map(sign).min()?
        }
        Predicate::SectionDot => {
            (0..3).map(|i| oracle::dot_sign(&p[0], &p[1], &p[2], &p[3 + i], &p[6 + i])).min()?
        }
        _ => return None,
    })
}

#[test]
fn determinants_agree_with_the_page() {
    let pool = Pool::default();
    let generators: Vec<Generator> = Generator::ALL.into_iter().filter(|g| *g != Generator::Real).collect();
    for predicate in Predicate::ALL {
        if by_definition(predicate, &predicate.example()).is_none() {
            continue;
        }
        let batch = Source::new(predicate, &generators, 5, &pool).batch(1500);
        let mut signs = [0; 3];
        for case in batch.coordinates.chunks_exact(predicate.arity()) {
            let expected = by_definition(predicate, case).unwrap();
            assert_eq!(judge(predicate, case), Some(expected), "{predicate} {case:?}");
            signs[usize::try_from(expected.as_i8() + 1).unwrap()] += 1;
        }
        assert!(signs.iter().all(|n| *n > 30), "{predicate}: {signs:?}");
    }
}

#[test]
fn symmetries_change_the_answer_as_they_say() {
    let pool = Pool::default();
    let generators = [Generator::Degenerate, Generator::Grid, Generator::Uniform, Generator::Near];
    for predicate in Predicate::ALL {
        let batch = Source::new(predicate, &generators, 6, &pool).batch(400);
        let mut random = Random(9);
        let mut moved = 0;
        for case in batch.coordinates.chunks_exact(predicate.arity()) {
            let symmetry = symmetry::random(predicate, &mut random);
            let image = symmetry.image(case, predicate.dimension());
            moved += usize::from(image != case);
            let sign = judge(predicate, case).unwrap();
            let expected = if symmetry.negates { -sign } else { sign };
            assert_eq!(judge(predicate, &image), Some(expected), "{predicate} {case:?} {symmetry}");
        }
        assert!(moved > 200, "{predicate}: {moved}");
    }
}

#[test]
fn what_is_no_case_has_no_answer() {
    for predicate in Predicate::ALL {
        let mut case = predicate.example();
        assert!(predicate.accepts(&case) && judge(predicate, &case).is_some(), "{predicate}");
        assert_eq!(judge(predicate, &case[1..]), None);
        case[0] = f64::INFINITY;
        assert!(!predicate.accepts(&case));
        assert_eq!(judge(predicate, &case), None);
    }
    // A triangle without area, a segment without length.
    let flat = [0.0; 18];
    assert!(!Predicate::TriangleTriangle.accepts(&flat) && !Predicate::RayTriangle.accepts(&flat[..15]));
    assert_eq!(judge(Predicate::TriangleTriangle, &flat), None);
}
