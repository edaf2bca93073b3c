//! Exact equalities on random points in random shells.

use super::generate::{in_tet, shell, shell_point};
use crate::projection::{Projection, Rat, ShellPoint};
use crate::testing::Random;

/// The different middle points below some images, by prism.
fn middles(images: &[ShellPoint]) -> Vec<ShellPoint> {
    let mut out: Vec<ShellPoint> = Vec::new();
    for middle in images.iter().map(ShellPoint::middle) {
        if !out.contains(&middle) {
            out.push(middle);
        }
    }
    out
}

/// All that must hold at a point of space that lies in the shell.
pub(super) fn check_point(projection: &Projection<'_>, p: &[Rat; 3]) {
    let locations = projection.locate(p);
    let images = projection.project_all(p);
    assert!(!locations.is_empty() && !images.is_empty(), "{p:?} is in the shell");
    // Whichever tet the field is followed from, it ends below one of the images.
    let mut ends: Vec<ShellPoint> = Vec::new();
    for location in &locations {
        let end = projection.trace(p, location.tet).expect("the tet holds the point");
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    ends.sort_by_key(|end| end.prism);
    assert_eq!(ends, middles(&images));
    for image in &images {
        assert_eq!(projection.unproject(image).unwrap(), *p);
        assert_eq!(projection.canonical(image).unwrap(), *image);
    }
}

#[test]
fn points_of_tets() {
    let mut random = Random(3);
    let (mut points, mut pinched, mut shared) = (0, 0, 0);
    for _ in 0..120 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        pinched += usize::from(!shell.pinched_vertices().is_empty());
        for _ in 0..180 {
            let tet = random.below(projection.tets().len());
            let weights = random.weights();
            let p = in_tet(&projection, tet, &weights);
            check_point(&projection, &p);
            let locations = projection.locate(&p);
            assert!(locations.iter().any(|l| l.tet as usize == tet));
            // The carrier: the vertices with positive weight.
            let names = projection.tets()[tet].names;
            let mut carrier: Vec<_> = (0..4).filter(|&k| weights[k] != Rat::ZERO).map(|k| names[k]).collect();
            carrier.sort_unstable();
            let same = locations.iter().filter(|l| l.carrier == carrier).count();
            assert_eq!(
                same,
                projection.tets().iter().filter(|t| carrier.iter().all(|n| t.names.contains(n))).count()
            );
            shared += usize::from(same > 1);
            if points % 20 == 0 {
                assert_eq!(projection.trace_all(&p), middles(&projection.project_all(&p)));
            }
            points += 1;
        }
    }
    assert!(points >= 20_000 && pinched > 30 && shared > 10_000, "{points} {pinched} {shared}");
}

#[test]
fn points_of_the_reference() {
    let mut random = Random(4);
    for _ in 0..60 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        for _ in 0..100 {
            let q = shell_point(&mut random, &shell);
            let p = projection.unproject(&q).unwrap();
            let canonical = projection.canonical(&q).unwrap();
            assert!(projection.project_all(&p).contains(&canonical), "{q:?}");
            assert_eq!(projection.unproject(&canonical).unwrap(), p);
            // Every prism at a wall names the same point and agrees on its place.
            let carried: Vec<_> = (0..3)
                .filter(|&k| q.weights[k] != Rat::ZERO)
                .map(|k| shell.faces[q.prism as usize][k])
                .collect();
            for (prism, face) in (0..).zip(&shell.faces) {
                if carried.iter().all(|v| face.contains(v)) {
                    let own = shell.faces[q.prism as usize];
                    let weights = face.map(|v| {
                        own.iter().position(|&o| o == v).map_or(Rat::ZERO, |k| q.weights[k].clone())
                    });
                    let other = ShellPoint { prism, weights, height: q.height.clone() };
                    assert!(prism >= canonical.prism);
                    assert_eq!(projection.unproject(&other).unwrap(), p);
                }
            }
            check_fibre(&projection, &q, &p);
        }
    }
}

/// The fibre runs from bottom to top without a gap, projects to one middle point, and holds `p`.
fn check_fibre(projection: &Projection<'_>, q: &ShellPoint, p: &[Rat; 3]) {
    let pieces = projection.fibre(q.prism, &q.weights).unwrap();
    let mut holds = pieces.is_empty() && q.height == Rat::ZERO;
    for piece in &pieces {
        for (height, position) in [&piece.low, &piece.high] {
            let end = ShellPoint { height: height.clone(), ..q.clone() };
            assert_eq!(projection.unproject(&end).unwrap(), *position);
        }
        let (low, high) = (&piece.low.0, &piece.high.0);
        assert!(low < high);
        if *low <= q.height && q.height <= *high {
            let s = (&q.height - low) / (high - low);
            assert_eq!([0, 1, 2].map(|i| &piece.low.1[i] + &s * (&piece.high.1[i] - &piece.low.1[i])), *p);
            holds = true;
        }
    }
    assert!(holds);
    assert!(pieces.windows(2).all(|w| w[0].high == w[1].low));
}

#[test]
fn location_is_what_testing_every_tet_gives() {
    let mut random = Random(5);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..40 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        for _ in 0..40 {
            let coarse = random.below(2) == 0;
            let anchor = shell.middle[random.below(shell.vertex_count())];
            let p = anchor.map(|x| x + 2.0 * random.double(coarse));
            let exact = p.map(|x| Rat::try_from(x).unwrap());
            let all = 0..u32::try_from(projection.tets().len()).unwrap();
            let brute: Vec<u32> = all.filter(|&t| projection.trace(&exact, t).is_some()).collect();
            let locations = projection.locate_f64(&p);
            assert_eq!(locations.iter().map(|l| l.tet).collect::<Vec<_>>(), brute);
            assert_eq!(locations, projection.locate(&exact));
            assert_eq!(projection.is_inside_f64(&p), !brute.is_empty());
            assert_eq!(projection.is_inside(&exact), !brute.is_empty());
            assert_eq!(projection.project_exactly(&p), projection.project(&exact));
            *if brute.is_empty() { &mut outside } else { &mut inside } += 1;
        }
    }
    assert!(inside > 300 && outside > 300, "{inside} {outside}");
}
