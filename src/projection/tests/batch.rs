//! Many points at once against single calls and against the exact map; the tree against all its boxes.

use super::generate::{in_tet, scaled, shell, spiral};
use crate::projection::boxes::{BoxTree, Walk};
use crate::projection::{FloatPoint, Projection, Rat};
use crate::shell::{Shell, VertexOrder};
use crate::testing::Random;
use dashu_base::Abs;

/// Equal numbers may differ in the sign of zero.
fn bits(answer: Option<FloatPoint>) -> Option<(u32, [u64; 5])> {
    answer.map(|q| {
        let [a, b, c] = q.weights;
        (q.prism, [a, b, c, q.height, q.error].map(f64::to_bits))
    })
}

/// Points inside, at vertices, around the shell, and what is no point.
fn points(projection: &Projection<'_>, random: &mut Random, count: usize) -> Vec<[f64; 3]> {
    let shell = projection.shell();
    let point = |i: usize| {
        let tet = random.below(projection.tets().len());
        let p = in_tet(projection, tet, &random.weights()).map(|x| x.to_f64().value());
        match i % 8 {
            0 => shell.middle[random.below(shell.vertex_count())],
            1 => p.map(|x| x + random.double(true)),
            2 if i % 16 == 2 => {
                [p[0], [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX][i / 16 % 4], p[2]]
            }
            _ => p,
        }
    };
    (0..count).map(point).collect()
}

fn check(shell: &Shell, order: &VertexOrder, random: &mut Random, count: usize) -> usize {
    let projection = Projection::new(shell, order).unwrap();
    let points = points(&projection, random, count);
    let single: Vec<_> = points.iter().map(|p| bits(projection.project_f64(p))).collect();
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let batch = pool.install(|| projection.project_batch_f64(&points));
        assert_eq!(batch.into_iter().map(bits).collect::<Vec<_>>(), single);
    }
    // Other points, fewer or in another order, change no answer.
    let some: Vec<_> = points.iter().rev().step_by(3).copied().collect();
    let answers = projection.project_batch_f64(&some).into_iter().map(bits);
    assert!(answers.eq(single.iter().rev().step_by(3).copied()));
    single.iter().flatten().count()
}

#[test]
fn batches_are_single_calls() {
    let mut random = Random(31);
    let mut inside = 0;
    for _ in 0..12 {
        let (shell, order) = shell(&mut random);
        inside += check(&shell, &order, &mut random, 300);
    }
    // Several groups, and several images for most points.
    inside += check(&spiral(20), &VertexOrder::Id, &mut random, 3000);
    assert!(inside > 3000, "{inside}");
    let shell = spiral(1);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    assert_eq!(projection.project_batch_f64(&[]), []);
    assert_eq!(projection.project_batch_f64(&[[f64::NAN; 3]; 3]), [None; 3]);
}

#[test]
fn batches_keep_their_bounds() {
    let mut random = Random(32);
    let mut inside = 0;
    for _ in 0..20 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        let points = points(&projection, &mut random, 100);
        for (p, answer) in points.iter().zip(projection.project_batch_f64(&points)) {
            // Rational arithmetic from end to end, with the first of all images.
            let exact = p.iter().all(|x| x.is_finite()).then(|| p.map(|x| Rat::try_from(x).unwrap()));
            let exact = exact.and_then(|p| projection.project(&p));
            assert_eq!(exact.is_some(), answer.is_some());
            let (Some(exact), Some(answer)) = (exact, answer) else { continue };
            assert_eq!(exact.prism, answer.prism);
            let bound = Rat::try_from(answer.error).unwrap();
            let pairs = exact.weights.iter().zip(answer.weights).chain([(&exact.height, answer.height)]);
            for (exact, rounded) in pairs {
                assert!((Rat::try_from(rounded).unwrap() - exact).abs() <= bound);
            }
            inside += 1;
        }
    }
    assert!(inside > 1000, "{inside}");
}

#[test]
fn far_ends_of_the_range() {
    for exponent in [-1071, 1020] {
        let shell = scaled(&spiral(9), [exponent; 3]);
        assert!(check(&shell, &VertexOrder::Id, &mut Random(33), 400) > 200);
    }
}

/// Parts so far apart that floats of 32 bits do not tell the boxes of one from each other.
#[test]
fn parts_far_from_each_other() {
    let (mut shell, other) = (spiral(20), spiral(9));
    let first = shell.vertex_count() as u32;
    let far = |p: &[f64; 3]| [p[0] + 2_f64.powi(45), p[1] - 2_f64.powi(30), p[2] + 2_f64.powi(28)];
    shell.bottom.extend(other.bottom.iter().map(far));
    shell.middle.extend(other.middle.iter().map(far));
    shell.top.extend(other.top.iter().map(far));
    shell.faces.extend(other.faces.iter().map(|f| f.map(|v| v + first)));
    assert!(check(&shell, &VertexOrder::Id, &mut Random(35), 800) > 400);
}

/// The tree's answers are those of asking every box, where its floats hold the coordinates; else none is lost.
#[test]
fn the_tree_loses_no_box() {
    let mut random = Random(34);
    let (mut found, mut close, mut walk) = (0, 0, Walk::default());
    for (count, scale) in [0, 1, 2, 3, 7, 100].into_iter().flat_map(|n| [1.0, 1e-310, 1e308].map(|s| (n, s)))
    {
        let exactly = scale > 1e-9 && scale < 1e9;
        let mut some = |n: usize| -> Vec<[f64; 3]> {
            (0..n).map(|_| [0; 3].map(|_| random.double(exactly) * scale)).collect()
        };
        let (low, high, mut points) = (some(count), some(count), some(200));
        points.extend(&low);
        let tree = BoxTree::new(low.iter().zip(&high).map(|(a, b)| [a, b]));
        let meets = |k: usize, from: &[f64; 3], to: &[f64; 3]| {
            (0..3).all(|i| low[k][i].min(high[k][i]) <= to[i] && from[i] <= low[k][i].max(high[k][i]))
        };
        let mut check = |list: &[u32], from: &[f64; 3], to: &[f64; 3]| {
            let all: Vec<u32> = (0..).take(count).filter(|&k| meets(k as usize, from, to)).collect();
            found += all.len();
            close += list.len() - all.len();
            if exactly {
                assert_eq!(list, all);
            }
            assert!(all.iter().all(|k| list.contains(k)));
        };
        let mut together = vec![Vec::new(); points.len()];
        tree.pairs(&points, &mut walk, &mut |near, id| {
            near.iter().for_each(|&i| together[i as usize].push(id));
        });
        for (p, mut together) in points.iter().zip(together) {
            let mut holding = Vec::new();
            tree.holding(p, |id| holding.push(id));
            holding.sort_unstable();
            together.sort_unstable();
            assert_eq!(holding, together);
            check(&holding, p, p);
            let to = p.map(|x| x + 0.25 * scale);
            check(&tree.meeting([*p, to]), p, &to);
        }
    }
    assert!(found > 10_000 && close < found / 100, "{found} {close}");
}

/// Two crowds of small boxes, far apart along all axes: a search visits those that hold the point, not a whole crowd.
#[test]
fn boxes_of_far_parts_are_told_apart() {
    let mut random = Random(36);
    let side = 2_f64.powi(-8);
    for far in [0.0, 2_f64.powi(20), 2_f64.powi(40)] {
        let corner = |i: usize| {
            [0.0; 3].map(|_: f64| random.double(true) + if i.is_multiple_of(2) { 0.0 } else { far })
        };
        let low: Vec<[f64; 3]> = (0..2000).map(corner).collect();
        let high: Vec<[f64; 3]> = low.iter().map(|p| p.map(|x| x + side)).collect();
        let tree = BoxTree::new(low.iter().zip(&high).map(|(a, b)| [a, b]));
        let (mut visited, mut holding) = (0, 0);
        for p in &low {
            tree.holding(p, |id| {
                visited += 1;
                let (low, high) = (low[id as usize], high[id as usize]);
                holding += usize::from((0..3).all(|i| low[i] <= p[i] && p[i] <= high[i]));
            });
        }
        assert!(
            holding >= low.len() && visited <= holding + holding / 10,
            "{visited} visited, {holding} hold"
        );
    }
}
