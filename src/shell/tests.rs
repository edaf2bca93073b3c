//! The tet table derived again, and the 20 real shells against the facts found by independent
//! programs.

use super::decomposition::{LocalVertex, ORDERS, TETS, decomposition, order_index};
use super::{Layer, Name, Shell, Slab, hdf5};
use crate::testing::shell_directory;
use dashu_int::IBig;
use std::collections::{BTreeMap, BTreeSet};

/// File, mesh triangles, prisms, tets, tets that are not positive.
pub(super) const FACTS: [(&str, usize, usize, usize, usize); 20] = [
    ("cube.obj.h5", 12, 66, 1584, 0),
    ("cube.obj.h5.init", 12, 156, 3744, 0),
    ("cube.obj.thick50.h5", 12, 58, 1392, 0),
    ("sphere.obj.h5", 760, 760, 18240, 0),
    ("sphere.obj.h5.init", 760, 760, 18240, 0),
    ("bumpy.off.h5", 2496, 162, 3888, 0),
    ("bumpy.off.h5.init", 2496, 2496, 59904, 0),
    ("c_spot.obj.h5", 5856, 238, 5712, 0),
    ("bunny.off.h5", 6966, 254, 6096, 0),
    ("bunny.off.h5.init", 6966, 13954, 334_896, 0),
    ("c_homer.obj.h5", 12000, 512, 12288, 0),
    ("c_homer.obj.h5.init", 12000, 16628, 399_072, 0),
    ("decimated-knight.off.h5", 1000, 620, 14880, 0),
    ("decimated-knight.off.h5.init", 1000, 11416, 273_984, 0),
    ("fandisk.off.h5", 14454, 146, 3504, 0),
    ("tennis.off.h5", 94, 104, 2384, 0),
    ("tennis.off.h5.init", 94, 1318, 30480, 0),
    ("decimated-knight.off.h5.extract.h5", 1000, 720, 17280, 16),
    ("bunny.off.h5.extract.h5", 6966, 260, 6240, 2),
    ("bunny.off.allowint.h5", 6966, 104, 2496, 0),
];

/// The position of a local vertex in the straight unit prism.
fn unit((corner, is_hi): LocalVertex) -> [i64; 3] {
    let [x, y] = [[0, 0], [1, 0], [0, 1]][usize::from(corner)];
    [x, y, i64::from(is_hi)]
}

fn determinant(points: [[i64; 3]; 4]) -> i64 {
    let d = |k: usize, axis: usize| points[k][axis] - points[0][axis];
    let minor = |i: usize, j: usize| d(2, i) * d(3, j) - d(2, j) * d(3, i);
    d(1, 0) * minor(1, 2) - d(1, 1) * minor(0, 2) + d(1, 2) * minor(0, 1)
}

/// The three tets of an order as vertex sets with the carried corner, straight from the definition.
fn definition([u, v, w]: [u8; 3]) -> [(BTreeSet<LocalVertex>, u8); 3] {
    let (lo, hi) = (false, true);
    [
        (BTreeSet::from([(u, lo), (v, lo), (w, lo), (w, hi)]), w),
        (BTreeSet::from([(u, lo), (v, lo), (v, hi), (w, hi)]), v),
        (BTreeSet::from([(u, lo), (u, hi), (v, hi), (w, hi)]), u),
    ]
}

#[test]
fn table_follows_from_the_six_orders() {
    let mut derived: BTreeMap<(BTreeSet<LocalVertex>, u8), u8> = BTreeMap::new();
    for (index, &order) in ORDERS.iter().enumerate() {
        for tet in definition(order) {
            *derived.entry(tet).or_default() |= 1 << index;
        }
        let listed =
            decomposition(order).map(|local| (BTreeSet::from(TETS[local].vertices), TETS[local].pillar));
        assert_eq!(listed, definition(order), "order {order:?}");
    }
    let table: BTreeMap<_, _> =
        TETS.iter().map(|tet| ((BTreeSet::from(tet.vertices), tet.pillar), tet.orders)).collect();
    assert_eq!(table.len(), 12);
    assert_eq!(table, derived);
    assert_eq!(BTreeSet::from(ORDERS).len(), 6);
    assert_eq!(order_index([0, 1, 1]), None);
}

#[test]
fn every_tet_has_volume_one_sixth_in_the_unit_prism() {
    for tet in TETS {
        assert_eq!(determinant(tet.vertices.map(unit)), 1, "{tet:?}");
    }
}

/// In each decomposition every face lies in two tets, in opposite orientations, or is part of the
/// prism's surface: the two lids whole, and two triangles a wall whose diagonal runs from the `lo`
/// of the smaller corner to the `hi` of the larger.
#[test]
fn decompositions_close_up() {
    for order in ORDERS {
        let mut faces: BTreeMap<[LocalVertex; 3], i32> = BTreeMap::new();
        for local in decomposition(order) {
            let [a, b, c, d] = TETS[local].vertices;
            for mut face in [[b, c, d], [a, d, c], [a, b, d], [a, c, b]] {
                let mut sign = 1;
                for (i, j) in [(0, 1), (1, 2), (0, 1)] {
                    if face[i] > face[j] {
                        face.swap(i, j);
                        sign = -sign;
                    }
                }
                *faces.entry(face).or_default() += sign;
            }
        }
        faces.retain(|_, sum| *sum != 0);
        let [u, v, w] = order;
        let mut expected = BTreeSet::from([[0, 1, 2].map(|k| (k, false)), [0, 1, 2].map(|k| (k, true))]);
        for (small, large) in [(u, v), (u, w), (v, w)] {
            for third in [(small, true), (large, false)] {
                let mut face = [(small, false), (large, true), third];
                face.sort_unstable();
                expected.insert(face);
            }
        }
        assert_eq!(faces.keys().copied().collect::<BTreeSet<_>>(), expected, "order {order:?}");
    }
}

#[test]
fn names_print_and_sort_by_vertex_then_layer() {
    let name = |vertex, layer| Name { vertex, layer };
    let mut names =
        [name(12, Layer::Top), name(12, Layer::Bottom), name(3, Layer::Top), name(12, Layer::Middle)];
    names.sort_unstable();
    assert_eq!(names.map(|n| n.to_string()), ["t3", "b12", "m12", "t12"]);
}

/// One prism with chosen pinched corners; the others are straight and vertical.
fn one_prism(pinched: [bool; 3]) -> Shell {
    let middle = vec![[0.0, 0.0, 0.0], [1.0, 0.0, -0.0], [0.0, 1.0, 0.0]];
    let moved = |z: f64| {
        let lift =
            |(p, &pinched): (&[f64; 3], &bool)| if pinched { [p[0], p[1], 0.0] } else { [p[0], p[1], z] };
        middle.iter().zip(&pinched).map(lift).collect()
    };
    Shell { bottom: moved(-1.0), top: moved(1.0), middle: middle.clone(), faces: vec![[0, 1, 2]] }
}

#[test]
fn pinched_corners_remove_tets() {
    for (pinched, listed, unique, ordered) in [
        ([false, false, false], 24, 24, 6),
        ([false, true, false], 16, 8, 4),
        ([true, true, false], 8, 2, 2),
        ([true, true, true], 0, 0, 0),
    ] {
        let shell = one_prism(pinched);
        assert_eq!(shell.prism_tets(0).count(), listed);
        assert_eq!(shell.tet_count(), listed);
        let different: BTreeSet<_> =
            shell.prism_tets(0).map(|tet| (tet.sorted_names(), tet.pillar)).collect();
        assert_eq!(different.len(), unique, "equal tets carry the same pillar");
        assert_eq!(shell.prism_tets_unique(0).count(), unique);
        for order in ORDERS {
            let rank = |v: u32| order.iter().position(|&k| u32::from(k) == v).unwrap() as u32;
            let tets: Vec<_> = shell.tets_of_order(0, rank).collect();
            assert_eq!(tets.len(), ordered);
            assert!(tets.iter().all(|tet| different.contains(&(tet.sorted_names(), tet.pillar))));
            for tet in &tets {
                assert!(sign(&shell, &tet.names) > 0);
                assert_eq!(tet.field().map(|n| n.layer), [tet.slab.lo(), tet.slab.hi()]);
                assert!(tet.field().iter().all(|end| tet.names.contains(end)));
            }
        }
    }
    assert_eq!(one_prism([false; 3]).prism_tets(1).count(), 0, "no such prism");
}

/// `tets_of_order` on the definition, with slabs and vertex names that are no local numbers.
#[test]
fn order_of_vertices_decides_the_diagonals() {
    let shell = Shell {
        bottom: vec![[0.0; 3]; 8],
        middle: vec![[1.0; 3]; 8],
        top: vec![[2.0; 3]; 8],
        faces: vec![[7, 2, 5]],
    };
    let names = |rank: fn(u32) -> u32| -> Vec<String> {
        let text = |names: [Name; 4]| names.map(|n| n.to_string()).join(" ");
        shell
            .tets_of_order(0, rank)
            .map(|tet| format!("{} {}", text(tet.sorted_names()), tet.pillar))
            .collect()
    };
    let by_id = [
        "b2 b5 b7 m7 7",
        "b2 b5 m5 m7 5",
        "b2 m2 m5 m7 2",
        "m2 m5 m7 t7 7",
        "m2 m5 t5 t7 5",
        "m2 t2 t5 t7 2",
    ];
    assert_eq!(names(|v| v), by_id);
    let backwards = [
        "b2 m2 b5 b7 2",
        "m2 b5 m5 b7 5",
        "m2 m5 b7 m7 7",
        "m2 t2 m5 m7 2",
        "t2 m5 t5 m7 5",
        "t2 t5 m7 t7 7",
    ];
    assert_eq!(names(|v| 100 - v), backwards);
    assert!(shell.prism_tets(0).all(|tet| tet.prism == 0));
    assert_eq!(shell.prism_tets(0).filter(|tet| tet.slab == Slab::Top).count(), 12);
}

/// The sign of a tet's determinant by integers: coordinates times 2^1074 are integers.
fn sign(shell: &Shell, names: &[Name; 4]) -> i32 {
    let exact = |x: f64| -> IBig {
        let bits = x.abs().to_bits();
        let (biased, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
        let magnitude = if biased == 0 {
            IBig::from(fraction)
        } else {
            IBig::from(fraction | 1 << 52) << (biased as usize - 1)
        };
        if x < 0.0 { -magnitude } else { magnitude }
    };
    let p = names.map(|name| shell.position(name).map(exact));
    let d = |k: usize, axis: usize| &p[k][axis] - &p[0][axis];
    let minor = |i: usize, j: usize| d(2, i) * d(3, j) - d(2, j) * d(3, i);
    let value = d(1, 0) * minor(1, 2) - d(1, 1) * minor(0, 2) + d(1, 2) * minor(0, 1);
    value.cmp(&IBig::ZERO) as i32
}

#[test]
fn real_shells_have_the_stated_counts() {
    let Some(directory) = shell_directory() else { return };
    for (name, triangles, prisms, tets, _) in FACTS {
        let file = hdf5::read(&directory.join(name)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(file.mesh.as_ref().map(|mesh| mesh.faces.len()), Some(triangles), "{name}");
        let shell = &file.shell;
        assert_eq!(shell.prism_count(), prisms, "{name}");
        let listed: usize = (0..prisms as u32).map(|prism| shell.prism_tets(prism).count()).sum();
        assert_eq!((listed, shell.tet_count()), (tets, tets), "{name}");
        assert_eq!(file.tracks.as_ref().map(hdf5::Tracks::prism_count), Some(prisms), "{name}");
        assert_eq!(file.notes, Vec::<String>::new(), "{name}");
        let pinched = usize::from(name.starts_with("tennis"));
        let counts = shell.pillar_counts();
        assert_eq!(counts.pinched, pinched, "{name}");
        assert_eq!(counts.straight + counts.bent + pinched, shell.vertex_count(), "{name}");
    }
}

#[test]
fn real_shells_have_the_stated_bad_tets() {
    let Some(directory) = shell_directory() else { return };
    let wanted =
        ["cube.obj.h5", "tennis.off.h5", "bunny.off.h5.extract.h5", "decimated-knight.off.h5.extract.h5"];
    for (name, _, prisms, _, bad) in FACTS.into_iter().filter(|fact| wanted.contains(&fact.0)) {
        let shell = hdf5::read(&directory.join(name)).unwrap_or_else(|error| panic!("{error}")).shell;
        let tets = (0..prisms as u32).flat_map(|prism| shell.prism_tets(prism));
        let found: Vec<_> = tets.filter(|tet| sign(&shell, &tet.names) <= 0).collect();
        assert_eq!(found.len(), bad, "{name}");
        let by_prism: BTreeSet<_> = found.iter().map(|tet| tet.prism).collect();
        assert_eq!(by_prism.len(), bad, "{name}: every such prism has exactly one bad tet");
    }
}

/// Straight, bent, pinched: counted by another program with rational numbers.
#[test]
fn real_shells_have_the_stated_pillars() {
    let Some(directory) = shell_directory() else { return };
    for (name, expected) in [
        ("cube.obj.h5", [15, 20, 0]),
        ("cube.obj.thick50.h5", [10, 21, 0]),
        ("tennis.off.h5", [32, 21, 1]),
        ("sphere.obj.h5.init", [336, 46, 0]),
        ("bunny.off.h5", [74, 55, 0]),
    ] {
        let file = hdf5::read(&directory.join(name)).unwrap_or_else(|error| panic!("{error}"));
        let counts = file.shell.pillar_counts();
        assert_eq!([counts.straight, counts.bent, counts.pinched], expected, "{name}");
    }
}

#[test]
fn straightness_is_exact() {
    let pillar = |m: [f64; 3], t: [f64; 3]| Shell {
        bottom: vec![[0.0; 3]],
        middle: vec![m],
        top: vec![t],
        faces: Vec::new(),
    };
    let tiny = f64::from_bits(1);
    assert!(pillar([0.5, 1.0, 1.5], [1.0, 2.0, 3.0]).is_straight(0));
    assert!(!pillar([0.5, 1.0, 1.5f64.next_up()], [1.0, 2.0, 3.0]).is_straight(0));
    assert!(!pillar([-0.5, -1.0, -1.5], [1.0, 2.0, 3.0]).is_straight(0), "on the line, off the segment");
    assert!(!pillar([0.5, tiny, 0.0], [1e308, 0.0, 0.0]).is_straight(0));
    assert!(pillar([tiny, tiny, 0.0], [1e308, 1e308, 0.0]).is_straight(0));
    assert!(pillar([0.0; 3], [-0.0; 3]).is_pinched(0));
    assert!(pillar([0.0; 3], [0.0; 3]).is_straight(0));
    assert!(!pillar([f64::NAN, 0.0, 0.0], [1.0; 3]).is_straight(0));
    assert!(!pillar([0.0; 3], [f64::INFINITY, 0.0, 0.0]).is_straight(0));
}
