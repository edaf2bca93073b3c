//! The tree against all pairs.

use super::{Aabb, Tree};

#[test]
fn finds_exactly_the_boxes_that_meet() {
    let mut state = 7u64;
    let mut next = move |range: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        i64::try_from((state >> 33) % range).expect("small") - 5
    };
    for n in [0, 1, 2, 3, 7, 8, 9, 16, 17, 64, 200, 1000] {
        let mut keys: Vec<[i64; 3]> = (0..3 * n).map(|_| [next(12), next(30), next(90)]).collect();
        if let Some(first) = keys.first_mut() {
            *first = [i64::MIN + 1, i64::MAX, 0];
        }
        let all: Vec<Aabb> = (0..n).map(|i| Aabb::of(&keys, &[3 * i, 3 * i + 1, 3 * i + 2])).collect();
        let tree = Tree::new(n, |i| all[i]);
        for query in &all {
            let expected: Vec<usize> = (0..n).filter(|&i| all[i].meets(query)).collect();
            let mut found = tree.meeting(query);
            found.sort_unstable();
            assert_eq!(found, expected);
        }
        assert!(tree.meeting(&Aabb::of(&[[1000; 3]], &[0])).len() <= 1);
    }
}

#[test]
fn finds_them_among_more_than_are_kept() {
    let n = 2 * super::KEPT + 9;
    let keys: Vec<[i64; 3]> =
        (0i64..).take(n).map(|i| [i * 7919 % 1009, i * 104_729 % 997, i % 89]).collect();
    let tree = Tree::new(n, |i| Aabb::of(&keys, &[i]));
    for i in (0..n).step_by(977) {
        let low = keys[i];
        let query = Aabb::of(&[low, [low[0] + 30, low[1] + 30, low[2] + 9]], &[0, 1]);
        let inside = |&j: &usize| (0..3).all(|k| (low[k]..=low[k] + [30, 30, 9][k]).contains(&keys[j][k]));
        let mut found = tree.meeting(&query);
        found.sort_unstable();
        assert_eq!(found, (0..n).filter(inside).collect::<Vec<_>>());
    }
}
