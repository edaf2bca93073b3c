use super::brute::{self, I3};
use super::oracle::P;
use crate::predicate::{
    Meeting, ZeroMask, orient3d, point_in_tet, point_in_triangle, point_on_segment, same_point,
    segment_segment, segment_triangle, triangle_tet, triangle_touches_tet, triangle_triangle,
};
use crate::testing::Random;

/// Scaling each axis by a positive power of two changes no position: grids reach every exponent this way.
struct Case<const N: usize> {
    grid: [I3; N],
    points: [P; N],
}

fn case<const N: usize>(random: &mut Random) -> Case<N> {
    let width = random.integer(1, 4);
    let thickness = [width, width, if random.below(4) == 0 { 0 } else { width }];
    let turn = random.below(3);
    let grid = [(); N].map(|()| {
        let mut p = thickness.map(|w| i64::from(random.integer(0, w)));
        p.rotate_left(turn);
        p
    });
    let scale = [(); 3].map(|()| match random.below(4) {
        0 | 1 => 1.0,
        2 => 2.0_f64.powi(random.integer(-1000, 1020)),
        _ => f64::from_bits(1 << random.below(50)),
    });
    let points = grid.map(|p| [0, 1, 2].map(|k| p[k] as f64 * scale[k]));
    Case { grid, points }
}

fn meeting(a: &[I3], b: &[I3]) -> Meeting {
    match brute::dimension(a, b) {
        -1 => Meeting::Disjoint,
        0 => Meeting::Point,
        1 => Meeting::Segment,
        2 => Meeting::Area,
        more => panic!("dimension {more}"),
    }
}

/// What a run saw; a test of nothing but disjoint pairs would show little.
fn tally(seen: &mut [usize; 4], meeting: Meeting) {
    seen[meeting as usize] += 1;
}

#[test]
fn brute_force_knows_simple_cases() {
    let unit = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]];
    assert_eq!(brute::dimension(&unit, &unit[..3]), 2);
    assert_eq!(brute::dimension(&unit, &[[1, 1, 0], [3, 3, 0]]), 0);
    assert_eq!(brute::dimension(&unit, &[[2, 1, 0], [3, 3, 0]]), -1);
    assert_eq!(brute::dimension(&unit[..2], &[[1, 0, 0], [3, 0, 0], [3, 3, 3]]), 1);
    assert_eq!(brute::dimension(&unit, &unit), 3);
}

#[test]
fn points() {
    let mut random = Random(21);
    let mut inside = [0_usize; 3];
    for _ in 0..20_000 {
        let Case { grid: [g, a, b, c, d], points: [p, pa, pb, pc, pd] } = case::<5>(&mut random);
        let on = |simplex: &[I3]| brute::dimension(&[g], simplex) == 0;
        let mask = |faces: &[&[I3]]| {
            ZeroMask(faces.iter().rev().fold(0, |mask, face| mask << 1 | u8::from(on(face))))
        };
        assert_eq!(same_point(&p, &pa), g == a);
        let expected = on(&[a, b]);
        assert_eq!(point_on_segment(&p, [&pa, &pb]), expected, "{g:?} {a:?} {b:?}");
        inside[0] += usize::from(expected);
        let expected = on(&[a, b, c]).then(|| mask(&[&[b, c], &[a, c], &[a, b]]));
        assert_eq!(point_in_triangle(&p, [&pa, &pb, &pc]), expected, "{g:?} {a:?} {b:?} {c:?}");
        inside[1] += usize::from(expected.is_some());
        let faces: [&[I3]; 4] = [&[b, c, d], &[a, c, d], &[a, b, d], &[a, b, c]];
        let expected = on(&[a, b, c, d]).then(|| mask(&faces));
        assert_eq!(point_in_tet(&p, [&pa, &pb, &pc, &pd]), expected, "{g:?} {a:?} {b:?} {c:?} {d:?}");
        inside[2] += usize::from(expected.is_some());
        if let Some(mask) = expected {
            assert_eq!(mask.is_interior(), (0..4).all(|i| !mask.on_face(i)));
        }
    }
    assert!(inside.iter().all(|&n| n > 500), "{inside:?}");
}

#[test]
fn segments_and_segments() {
    let (mut random, mut seen) = (Random(22), [0; 4]);
    for _ in 0..20_000 {
        let Case { grid, points: [a, b, c, d] } = case::<4>(&mut random);
        let expected = meeting(&grid[..2], &grid[2..]);
        assert_eq!(segment_segment([&a, &b], [&c, &d]), expected, "{grid:?}");
        tally(&mut seen, expected);
    }
    assert!(seen[..3].iter().all(|&n| n > 300), "{seen:?}");
}

#[test]
fn segments_and_triangles() {
    let (mut random, mut seen) = (Random(23), [0; 4]);
    for _ in 0..20_000 {
        let Case { grid, points: [s, t, a, b, c] } = case::<5>(&mut random);
        let expected = meeting(&grid[..2], &grid[2..]);
        assert_eq!(segment_triangle([&s, &t], [&a, &b, &c]), expected, "{grid:?}");
        tally(&mut seen, expected);
    }
    assert!(seen[..3].iter().all(|&n| n > 300), "{seen:?}");
}

#[test]
fn triangles_and_triangles() {
    let (mut random, mut seen) = (Random(24), [0; 4]);
    for _ in 0..40_000 {
        let Case { grid, points: [a, b, c, d, e, f] } = case::<6>(&mut random);
        let expected = meeting(&grid[..3], &grid[3..]);
        assert_eq!(triangle_triangle([&a, &b, &c], [&d, &e, &f]), expected, "{grid:?}");
        assert_eq!(triangle_triangle([&e, &d, &f], [&c, &b, &a]), expected, "swapped {grid:?}");
        assert_eq!(expected.meets(), expected != Meeting::Disjoint);
        tally(&mut seen, expected);
    }
    assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
}

#[test]
fn triangles_and_tets() {
    let (mut random, mut seen) = (Random(25), [0; 4]);
    for _ in 0..30_000 {
        let Case { grid, points: [a, b, c, d, e, f, g] } = case::<7>(&mut random);
        let expected = meeting(&grid[..3], &grid[3..]);
        assert_eq!(triangle_tet([&a, &b, &c], [&d, &e, &f, &g]), expected, "{grid:?}");
        tally(&mut seen, expected);
    }
    assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
}

#[test]
fn triangles_touch_tets_when_they_share_a_point() {
    let (mut random, mut seen, mut apart_by_edges) = (Random(26), [0; 4], 0);
    for _ in 0..40_000 {
        let Case { mut grid, mut points } = case::<7>(&mut random);
        let sign = orient3d(&points[3], &points[4], &points[5], &points[6]);
        if sign.is_zero() {
            continue;
        }
        if sign.is_negative() {
            grid.swap(3, 4);
            points.swap(3, 4);
        }
        let expected = meeting(&grid[..3], &grid[3..]);
        let [a, b, c, d, e, f, g] = &points;
        assert_eq!(triangle_touches_tet([a, b, c], [d, e, f, g]), expected.meets(), "{grid:?}");
        tally(&mut seen, expected);
        // Apart, but by no plane of the triangle or of a face.
        let splits = |[p, q, r]: [&P; 3], near: &[&P], far: &[&P]| {
            let side = |x: &&P| orient3d(p, q, r, x).as_i8();
            near.iter().map(side).chain(far.iter().map(|x| -side(x))).all(|s| s <= 0)
                && far.iter().all(|x| side(x) != 0)
        };
        let own = [[d, e, f], [d, g, e], [d, f, g], [e, g, f]];
        let by_faces = own.into_iter().any(|[p, q, r]| splits([p, r, q], &[d, e, f, g], &[a, b, c]));
        let by_triangle = splits([a, b, c], &[], &[d, e, f, g]) || splits([a, c, b], &[], &[d, e, f, g]);
        apart_by_edges += usize::from(!expected.meets() && !by_faces && !by_triangle);
    }
    assert!(seen.iter().all(|&n| n > 500) && apart_by_edges > 100, "{seen:?} {apart_by_edges}");
}
