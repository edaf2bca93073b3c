//! A shell around a torus whose middle is the mesh: the claims of the overlay, in every number width.
mod common;
use common::{ALL, Case, P, one_prism};

/// `n x n` quads, so `2 n^2` prisms; `scale` widens the exponents.
fn torus(n: u32, scale: f64) -> Case {
    let angle = |i: u32| f64::from(i) * std::f64::consts::TAU / f64::from(n);
    let layer = |r: f64| -> Vec<P> {
        let point = |i: u32, j: u32| {
            let ring = 3.0 + r * angle(j).cos();
            [ring * angle(i).cos() * scale, ring * angle(i).sin(), r * angle(j).sin()]
        };
        (0..n).flat_map(|i| (0..n).map(move |j| point(i, j))).collect()
    };
    let id = |i: u32, j: u32| (i % n) * n + j % n;
    let quad =
        |i, j| [[id(i, j), id(i + 1, j), id(i + 1, j + 1)], [id(i, j), id(i + 1, j + 1), id(i, j + 1)]];
    let prisms: Vec<_> = (0..n).flat_map(|i| (0..n).flat_map(move |j| quad(i, j))).collect();
    let mut overlay: String = (0..n * n).map(|v| format!("v {v} m{v}\n")).collect();
    prisms.iter().for_each(|t| overlay += &format!("c {} {} {}\n", t[0], t[1], t[2]));
    overlay += "d mesh 0 0\nd middle 0 0";
    let mut case = one_prism();
    case.layers = [layer(0.75), layer(1.0), layer(1.25)];
    case.points = case.layers[1].clone();
    (case.prisms, case.triangles) = (prisms.clone(), prisms);
    case.set("overlay", &overlay);
    case
}

/// Whether a claim set is accepted, or its code.
fn verdict(case: &Case, keep: usize) -> &'static str {
    let mut case = case.clone();
    case.claims = ALL[..keep].iter().map(|name| (*name, true)).collect();
    case.blocks.truncate(match keep {
        1 => 0,
        3 | 4 => 1,
        n => n - 3,
    });
    case.check().code
}

#[test]
fn widths_agree() {
    for scale in [1.0, 2f64.powi(-40), 2f64.powi(-200)] {
        let case = torus(24, scale);
        assert_eq!([1, 3, 4].map(|keep| verdict(&case, keep)), [""; 3]);
        // Where the torus is a saddle, triangles at a vertex need more than their own planes.
        assert_eq!(verdict(&case, 5), "missing-separation");
        let mut bad = case.clone();
        bad.layers[2][7] = bad.layers[0][7];
        assert_eq!([1, 3].map(|keep| verdict(&bad, keep)), ["not-positive"; 2]);
    }
}

#[test]
fn large() {
    let case = torus(60, 1.0);
    assert_eq!(verdict(&case, 4), "");
}
