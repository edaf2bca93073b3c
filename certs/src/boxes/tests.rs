//! The tree against all pairs.

use super::{Aabb, Tree};

#[test]
fn finds_exactly_the_boxes_that_meet() {
    let mut state = 7u64;
    let mut next = move |range: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        i64::try_from((state >> 33) % range).expect("small") - 5
    };
    for n in [0, 1, 2, 3, 7, 64, 200] {
        let mut keys: Vec<[i64; 3]> = (0..3 * n).map(|_| [next(12), next(30), next(90)]).collect();
        if let Some(first) = keys.first_mut() {
            *first = [i64::MIN + 1, i64::MAX, 0];
        }
        let all: Vec<Aabb> = (0..n).map(|i| Aabb::of(&keys, &[3 * i, 3 * i + 1, 3 * i + 2])).collect();
        let tree = Tree::new(all.clone());
        for query in &all {
            let expected: Vec<usize> = (0..n).filter(|&i| all[i].meets(query)).collect();
            assert_eq!(tree.meeting(query), expected);
        }
        assert!(tree.meeting(&Aabb::of(&[[1000; 3]], &[0])).len() <= 1);
    }
}
