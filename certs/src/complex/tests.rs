//! The conditions and the questions against their definitions, on lists of few triangles.

use super::{Complex, distinct, sides};

/// FORMAT section 3: all triangles at each vertex connected through edges, no directed edge twice, no vertex set twice.
fn is_manifold(triangles: &[[usize; 3]], vertices: usize) -> bool {
    let set = |t: &[usize; 3]| distinct(*t);
    let edges: Vec<_> = triangles.iter().flat_map(|t| sides(*t)).collect();
    let once = (0..edges.len()).all(|i| (0..i).all(|j| edges[i] != edges[j]));
    let proper = triangles.iter().all(|t| set(t).len() == 3);
    let different = (0..triangles.len()).all(|i| (0..i).all(|j| set(&triangles[i]) != set(&triangles[j])));
    let connected = |v: usize| {
        let at: Vec<_> = triangles.iter().filter(|t| t.contains(&v)).collect();
        let mut reached = vec![false; at.len()];
        reached.iter_mut().take(1).for_each(|r| *r = true);
        for _ in 0..at.len() {
            for i in (0..at.len()).filter(|&i| reached[i]).collect::<Vec<_>>() {
                for j in 0..at.len() {
                    let common = at[i].iter().filter(|x| at[j].contains(x)).count();
                    reached[j] |= common == 2;
                }
            }
        }
        !reached.contains(&false)
    };
    once && proper && different && (0..vertices).all(connected)
}

fn short(triangles: &[[usize; 3]]) -> Vec<[u32; 3]> {
    triangles.iter().map(|t| t.map(|v| u32::try_from(v).expect("small"))).collect()
}

#[test]
fn conditions_and_answers_are_those_of_the_definitions() {
    let mut state = 3u64;
    let mut next = move |range: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        usize::try_from(state >> 33).expect("31 bits") % range
    };
    // Pieces of an octahedron, now and then with another triangle.
    let octahedron = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let (mut good, mut bad) = (0, 0);
    for round in 0..4000 {
        let mut triangles: Vec<[usize; 3]> = octahedron.into_iter().filter(|_| next(4) > 0).collect();
        if round % 3 == 0 {
            triangles.push([next(7), next(7), next(7)]);
        }
        if round % 5 == 0 && !triangles.is_empty() {
            let t = triangles[next(triangles.len())];
            triangles.push(if round % 2 == 0 { [t[1], t[2], t[0]] } else { [t[0], t[2], t[1]] });
        }
        let Ok(complex) = Complex::new(short(&triangles), 7, "") else {
            assert!(!is_manifold(&triangles, 7), "{triangles:?}");
            bad += 1;
            continue;
        };
        assert!(is_manifold(&triangles, 7), "{triangles:?}");
        good += 1;
        let edges: Vec<_> = triangles.iter().flat_map(|t| sides(*t)).collect();
        let open = |a, b| edges.contains(&(a, b)) != edges.contains(&(b, a));
        for a in 0..7 {
            assert_eq!(complex.on_boundary([a]), (0..7).any(|b| open(a, b)));
            let star = (0..triangles.len()).filter(|&i| triangles[i].contains(&a));
            assert_eq!(distinct(complex.holding(&[a, a])), star.collect::<Vec<_>>());
            for b in (0..7).filter(|&b| b != a) {
                assert_eq!(complex.on_boundary([a, b]), open(a, b));
                let expected = triangles.iter().position(|t| sides(*t).contains(&(b, a)));
                assert_eq!(complex.across(a, b), expected);
                let holding =
                    (0..triangles.len()).filter(|&i| [a, b].iter().all(|v| triangles[i].contains(v)));
                assert_eq!(distinct(complex.holding(&[a, b, a])), holding.collect::<Vec<_>>());
            }
        }
        for (i, t) in triangles.iter().enumerate() {
            assert_eq!(complex.with_corners(&distinct(*t)), Some(i));
        }
        let used = distinct(triangles.iter().flatten().copied()).len();
        let undirected = edges.iter().filter(|(a, b)| a < b || !edges.contains(&(*b, *a))).count();
        assert_eq!(complex.euler(), used as i128 - undirected as i128 + triangles.len() as i128);
        // Each triangle has the component of its neighbours; components are numbered by their first triangles.
        let mut seen = 0;
        for (i, t) in triangles.iter().enumerate() {
            assert!(complex.part(i) <= seen);
            seen = seen.max(complex.part(i) + 1);
            for (j, other) in triangles.iter().enumerate() {
                let common = t.iter().filter(|x| other.contains(x)).count();
                assert!(common < 2 || complex.part(i) == complex.part(j));
            }
        }
        assert_eq!(complex.parts(), seen);
    }
    assert!(good > 500 && bad > 500, "{good} {bad}");
}

#[test]
fn two_parts_are_two() {
    let apart = Complex::new(vec![[3, 4, 5], [0, 1, 2], [4, 3, 6]], 7, "");
    let apart = apart.unwrap_or_else(|fail| panic!("{}", fail.message));
    assert_eq!(([0, 1, 2].map(|i| apart.part(i)), apart.parts()), ([0, 1, 0], 2));
    assert!(Complex::new(vec![[0, 1, 2], [0, 3, 4]], 5, "").is_err(), "they share a vertex only");
}
