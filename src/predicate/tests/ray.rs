use super::brute::{self, I3};
use crate::predicate::ray_triangle;
use crate::testing::Random;

/// On a grid of width 4 a ray has left the grid after ten times the way to its second point: brute force may
/// take a segment of that length. Scaling the axes by powers of two changes no position.
#[test]
fn rays_agree_with_long_segments() {
    let mut random = Random(7);
    let mut counts = [0; 2];
    for _ in 0..6000 {
        let width = random.integer(1, 4);
        let mut thickness = [width, width, if random.below(3) == 0 { 0 } else { width }];
        thickness.rotate_left(random.below(3));
        let grid = [(); 5].map(|()| thickness.map(|w| i64::from(random.integer(0, w))));
        let [o, p, a, b, c]: [I3; 5] = grid;
        let far = [0, 1, 2].map(|k| o[k] + 10 * (p[k] - o[k]));
        let expected = brute::dimension(&[o, far], &[a, b, c]) >= 0;
        let scale =
            [(); 3].map(|()| 2.0_f64.powi(random.integer(-1000, 1000) * i32::from(random.below(2) == 0)));
        let [o, p, a, b, c] = grid.map(|q| [0, 1, 2].map(|k| q[k] as f64 * scale[k]));
        assert_eq!(ray_triangle([&o, &p], [&a, &b, &c]), expected, "{grid:?} {scale:?}");
        counts[usize::from(expected)] += 1;
    }
    assert!(counts.iter().all(|n| *n > 500), "{counts:?}");
}
