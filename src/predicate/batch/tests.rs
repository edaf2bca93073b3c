use super::kernel::{Least, ZERO, common_error, cross};
use super::*;
use crate::predicate::{dot_sign_exact, orient3d_exact};
use crate::testing::Random;

/// Points in every position that the stages tell apart: random, on a small grid, one ulp beside it, and with any exponents.
fn points(random: &mut Random, count: usize) -> Vec<[f64; 3]> {
    let mut out: Vec<[f64; 3]> = Vec::with_capacity(count);
    for i in 0..count {
        let coordinate = |random: &mut Random| match i / 40 % 4 {
            0 => random.real(),
            1 => f64::from(u32::try_from(random.below(4)).unwrap()),
            2 => [1.0, 1.0f64.next_up(), 2.0, 2.0f64.next_down(), 0.5][random.below(5)],
            _ => {
                let x = f64::from_bits(random.next());
                if x.is_finite() { x } else { f64::MAX }
            }
        };
        out.push([coordinate(random), coordinate(random), coordinate(random)]);
    }
    out
}

/// Inputs of points that lie near each other in the list, hence mostly of one kind.
fn inputs<const N: usize>(random: &mut Random, vertices: usize, count: usize) -> Vec<[u32; N]> {
    let one = |random: &mut Random| {
        let start = random.below(vertices - 40);
        [0; N].map(|_: u32| u32::try_from(start + random.below(40)).unwrap())
    };
    (0..count).map(|_| one(random)).collect()
}

fn columns<const N: usize>(vertices: &[[f64; 3]], inputs: &[[u32; N]]) -> [[Vec<f64>; 3]; N] {
    std::array::from_fn(|point| {
        std::array::from_fn(|axis| inputs.iter().map(|ids| vertices[ids[point] as usize][axis]).collect())
    })
}

fn levels() -> Vec<Level> {
    let (here, absent): (Vec<Level>, Vec<Level>) = Level::ALL.into_iter().partition(|l| l.is_available());
    if !absent.is_empty() {
        eprintln!("SKIPPED: this processor lacks {absent:?}");
    }
    here
}

#[test]
fn signs_are_exact_at_every_level_and_length() {
    let mut random = Random(21);
    let vertices = points(&mut random, 2000);
    for count in [0, 1, LANES - 1, LANES, LANES + 1, 5 * LANES + 3, 4000] {
        let quads = inputs::<4>(&mut random, vertices.len(), count);
        let at = |ids: &[u32; 4]| ids.map(|v| &vertices[v as usize]);
        let exact: Vec<Sign> = quads.iter().map(at).map(|[a, b, c, d]| orient3d_exact(a, b, c, d)).collect();
        let mut stages = StageCounts::default();
        quads.iter().map(at).for_each(|[a, b, c, d]| {
            stages.note(orient3d_staged(a, b, c, d));
        });
        let columns = columns(&vertices, &quads);
        let streams = [0, 1, 2, 3].map(|k| Points([0, 1, 2].map(|axis| columns[k][axis].as_slice())));
        for level in levels() {
            let mut signs = vec![Sign::Zero; count];
            assert_eq!(orient3d_indexed_at(level, &vertices, &quads, &mut signs), Ok(stages));
            assert_eq!(signs, exact, "{level:?} {count}");
            signs.fill(Sign::Zero);
            assert_eq!(orient3d_at(level, streams, &mut signs), Ok(stages));
            assert_eq!(signs, exact, "{level:?} {count}");
        }
        if count == 4000 {
            let zeros = exact.iter().filter(|s| s.is_zero()).count();
            assert!(
                stages.filter > 500 && stages.fixed > 500 && stages.big > 100 && zeros > 300,
                "{stages:?} {zeros}"
            );
        }
    }
}

#[test]
fn dots_are_exact_at_every_level() {
    let mut random = Random(22);
    let vertices = points(&mut random, 2000);
    let five = inputs::<5>(&mut random, vertices.len(), 3000 + 7);
    let at = |ids: &[u32; 5]| ids.map(|v| &vertices[v as usize]);
    let exact: Vec<Sign> = five.iter().map(at).map(|[a, b, c, s, t]| dot_sign_exact(a, b, c, s, t)).collect();
    let columns = columns(&vertices, &five);
    let streams = [0, 1, 2, 3, 4].map(|k| Points([0, 1, 2].map(|axis| columns[k][axis].as_slice())));
    for level in levels() {
        let mut signs = vec![Sign::Zero; five.len()];
        let counts = dot_sign_indexed_at(level, &vertices, &five, &mut signs).unwrap();
        assert_eq!((&signs, counts.total()), (&exact, five.len() as u64), "{level:?}");
        signs.fill(Sign::Zero);
        assert_eq!(dot_sign_at(level, streams, &mut signs), Ok(counts));
        assert_eq!(signs, exact, "{level:?}");
    }
}

/// After the last vertex there is no number to read: in every place of an input, in any input of a block.
#[test]
fn the_last_vertex_is_like_the_others() {
    let mut random = Random(24);
    let all = points(&mut random, 160);
    for round in 0..200 {
        let count = 1 + random.below(6);
        let start = 40 * (round % 4) + random.below(30);
        let vertices = &all[start..start + count];
        let inputs = [LANES, 2 * LANES, 3 * LANES - 1][round % 3];
        // In half of the rounds one place alone has the last vertex.
        let lone = (random.below(inputs), random.below(4));
        let id = |random: &mut Random, place: (usize, usize)| {
            let below = if round % 2 == 0 { count } else { count.max(2) - 1 };
            if round % 2 == 1 && place == lone {
                count as u32 - 1
            } else {
                random.below(below) as u32 % count as u32
            }
        };
        let quads: Vec<[u32; 4]> =
            (0..inputs).map(|i| [0, 1, 2, 3].map(|k| id(&mut random, (i, k)))).collect();
        let fives: Vec<[u32; 5]> =
            (0..inputs).map(|i| [4, 3, 2, 1, 0].map(|k| id(&mut random, (i, k)))).collect();
        let at = |v: u32| &vertices[v as usize];
        let (mut tets, mut dots) = (StageCounts::default(), StageCounts::default());
        let of_tet = |q: &[u32; 4]| tets.note(orient3d_staged(at(q[0]), at(q[1]), at(q[2]), at(q[3])));
        let expected: Vec<Sign> = quads.iter().map(of_tet).collect();
        let of_dot =
            |q: &[u32; 5]| dots.note(dot_sign_staged(at(q[0]), at(q[1]), at(q[2]), at(q[3]), at(q[4])));
        let expected_dots: Vec<Sign> = fives.iter().map(of_dot).collect();
        for level in levels() {
            let mut signs = vec![Sign::Zero; inputs];
            assert_eq!(orient3d_indexed_at(level, vertices, &quads, &mut signs), Ok(tets));
            assert_eq!(signs, expected, "{level:?}");
            assert_eq!(dot_sign_indexed_at(level, vertices, &fives, &mut signs), Ok(dots));
            assert_eq!(signs, expected_dots, "{level:?}");
        }
    }
}

#[test]
fn what_does_not_fit_is_named() {
    let vertices = [[0.0; 3]; 3];
    let mut signs = [Sign::Zero; 2];
    let short = orient3d_indexed(&vertices, &[[0; 4]], &mut signs).unwrap_err();
    assert_eq!(short.to_string(), "1 inputs for 2 signs");
    let beyond = dot_sign_indexed(&vertices, &[[0; 5], [0, 1, 3, 2, 9]], &mut signs).unwrap_err();
    assert_eq!(beyond.to_string(), "input 1 has the index 3, but there are 3 vertices");
    let (two, one) = ([0.0; 2], [0.0; 1]);
    let whole = Points([&two; 3]);
    let uneven = orient3d([whole, whole, Points([&two, &one, &two]), whole], &mut signs).unwrap_err();
    assert_eq!(uneven.to_string(), "point 2, axis 1: 1 coordinates for 2 signs");
    assert_eq!(orient3d_indexed(&[], &[], &mut []), Ok(StageCounts::default()));
}

/// Six points a lane: a lane that is kept has a positive determinant, and plain ones are kept.
#[test]
fn one_bound_for_six_points_is_a_bound() {
    let mut random = Random(23);
    let (mut kept_count, mut plain) = (0, 0);
    for round in 0..3000 {
        let vertices = points(&mut random, 160);
        let start = 40 * (round % 4);
        let lanes: Vec<[[f64; 3]; 6]> =
            (0..LANES).map(|_| [0; 6].map(|_: u8| vertices[start + random.below(40)])).collect();
        let mut rows = [ZERO; 6];
        for (l, six) in lanes.iter().enumerate() {
            for (row, point) in rows.iter_mut().zip(six) {
                (0..3).for_each(|axis| row[axis][l] = point[axis]);
            }
        }
        let error = common_error(&std::array::from_fn(|i| &rows[i]));
        // The normal of three of the points, and the vector to the fourth from any of the three.
        let normal = cross(&minus(&rows[2], &rows[1]), &minus(&rows[3], &rows[1]));
        let mut least = Least::new();
        least.add(&minus(&rows[1 + round % 3], &rows[0]), &normal);
        let kept = least.above(&error);
        for (six, kept) in lanes.iter().zip(kept) {
            let sign = orient3d_exact(&six[0], &six[1], &six[2], &six[3]);
            assert!(!kept || sign.is_positive(), "{six:?}");
            kept_count += usize::from(kept);
            plain += usize::from(start == 0 && sign.is_positive() && !kept);
        }
    }
    assert!(kept_count > 8000 && plain < 20, "{kept_count} kept, {plain} plain ones left open");
}
