use std::collections::BTreeSet;

use crate::fuzz::bits::{exponent, magnitude};
use crate::fuzz::generate::{Batch, Generator, Pool, Source};
use crate::fuzz::{Predicate, judge};
use crate::predicate::Sign;
use crate::testing::{data, torus};

fn batch(predicate: Predicate, generator: Generator, pool: &Pool, count: usize) -> Batch {
    Source::new(predicate, &[generator], 11, pool).batch(count)
}

#[test]
fn degenerate_cases_are_degenerate_exactly() {
    for predicate in Predicate::ALL {
        let cases = batch(predicate, Generator::Degenerate, &Pool::default(), 500);
        let cases = cases.coordinates.chunks_exact(predicate.arity());
        let signs: Vec<Sign> = cases.map(|case| judge(predicate, case).unwrap()).collect();
        let count = |sign| signs.iter().filter(|s| **s == sign).count();
        match predicate {
            // A touching pair meets; a coplanar pair may be disjoint; both are made.
            Predicate::TriangleTriangle | Predicate::SegmentTriangle | Predicate::RayTriangle => {
                assert!(count(Sign::Positive) > 250, "{predicate}: {}", count(Sign::Positive));
            }
            // Some tet is flat, but another one may be negative.
            Predicate::PrismPositivity => {
                assert_eq!(count(Sign::Positive), 0);
                assert!(count(Sign::Zero) > 50, "{}", count(Sign::Zero));
            }
            _ => assert_eq!(count(Sign::Zero), 500, "{predicate}"),
        }
    }
}

#[test]
fn every_predicate_has_every_sign_from_the_mix() {
    let generators: Vec<Generator> = Generator::ALL.into_iter().filter(|g| *g != Generator::Real).collect();
    let pool = Pool::default();
    for predicate in Predicate::ALL {
        let cases = Source::new(predicate, &generators, 1, &pool).batch(1000);
        assert_eq!(cases.coordinates.len(), 1000 * predicate.arity());
        assert!(cases.coordinates.chunks_exact(predicate.arity()).all(|case| predicate.accepts(case)));
        let signs: BTreeSet<_> = cases
            .coordinates
            .chunks_exact(predicate.arity())
            .map(|case| judge(predicate, case).unwrap())
            .collect();
        let meets = matches!(
            predicate,
            Predicate::TriangleTriangle | Predicate::SegmentTriangle | Predicate::RayTriangle
        );
        assert_eq!(signs.len(), if meets { 2 } else { 3 }, "{predicate}");
        let seen: BTreeSet<_> = cases.origins.iter().map(|origin| origin.generator).collect();
        assert_eq!(seen.into_iter().collect::<Vec<_>>(), generators);
    }
}

#[test]
fn generators_keep_their_promises() {
    let pool = Pool::default();
    let all = |generator, count| batch(Predicate::Orient3d, generator, &pool, count);
    assert!(all(Generator::Uniform, 300).coordinates.iter().all(|x| (-1.0..1.0).contains(x)));
    assert!(all(Generator::Grid, 300).coordinates.iter().all(|x| x.fract() == 0.0 && x.abs() <= 4.0));
    let tiny = |case: &[f64]| case.iter().any(|x| exponent(*x).is_none_or(|e| e < -1022));
    assert!(all(Generator::Subnormal, 300).coordinates.chunks_exact(12).all(tiny));
    assert!(all(Generator::Overflow, 300).coordinates.chunks_exact(12).all(|c| magnitude(c) > Some(990)));
    let equal = |case: &[f64]| {
        (0..4).any(|i| {
            (0..i).any(|j| (0..3).any(|k| Sign::of_difference(case[3 * i + k], case[3 * j + k]).is_zero()))
        })
    };
    assert!(all(Generator::Shared, 300).coordinates.chunks_exact(12).filter(|c| equal(c)).count() > 200);
    let wide = all(Generator::Spread, 300);
    let spreads = wide.coordinates.chunks_exact(12).filter(|c| crate::fuzz::bits::spread(c) >= 400);
    assert!(spreads.count() > 200);
    // Every power of two comes once in so many turns of each of the three bases.
    let swept = all(Generator::Sweep, 3 * 2098);
    let powers: BTreeSet<_> = swept.coordinates.chunks_exact(12).filter_map(magnitude).collect();
    assert!(
        powers.len() > 2090 && powers.first() < Some(&-1072) && powers.contains(&1023),
        "{}",
        powers.len()
    );
    let permuted = all(Generator::Permutations, 100);
    assert_eq!((permuted.images.len(), permuted.origins.len()), (75, 100));
}

#[test]
fn cases_of_meshes_are_made_of_their_points() {
    let mesh = torus(8);
    let known: BTreeSet<[u64; 3]> = mesh.vertices.iter().map(|p| p.map(f64::to_bits)).collect();
    let mut broken = torus(4);
    broken.faces[3] = [0, 1, 1_000_000];
    let pool = Pool::new(vec![mesh, broken]);
    let cases = batch(Predicate::SectionDot, Generator::Real, &pool, 200);
    for p in cases.coordinates.chunks_exact(3) {
        assert!(known.contains(&[0, 1, 2].map(|k| p[k].to_bits())));
    }
    assert!(!pool.is_empty() && Pool::new(Vec::new()).is_empty());
}

#[test]
fn real_meshes_give_cases() {
    let Some(directory) = data("surface") else { return };
    let files = std::fs::read_dir(directory).unwrap().map(|file| file.unwrap().path());
    let mesh = files.filter_map(|path| crate::mesh::read(&path).ok()).map(|file| file.mesh).next();
    let pool = Pool::new(mesh.into_iter().collect());
    assert!(!pool.is_empty(), "no mesh in surface/ could be read");
    for predicate in Predicate::ALL {
        let cases = batch(predicate, Generator::Real, &pool, 100);
        assert!(cases.origins.iter().filter(|origin| origin.base == Generator::Real).count() > 50);
    }
}

#[test]
fn a_seed_tells_all() {
    let pool = Pool::default();
    let take = |seed| Source::new(Predicate::Insphere, &Generator::ALL, seed, &pool).batch(300).coordinates;
    assert_eq!(take(4), take(4));
    assert_ne!(take(4), take(5));
}
