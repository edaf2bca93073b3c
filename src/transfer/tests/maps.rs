use super::{exact, generated, points};
use crate::mesh::TriMesh;
use crate::projection::{MAX_ERROR, MeshPoint, Projection, SectionError, SectionMap};
use crate::shell::{Shell, VertexOrder};
use crate::transfer::{ExactPoint, FloatMeshPoint, Transfer};

fn same_as_the_slow_maps(shell: &Shell, order: &VertexOrder, a: &TriMesh, b: &TriMesh, count: usize) {
    let projection = Projection::new(shell, order).unwrap();
    let transfer = Transfer::new(&projection, a, b).unwrap();
    let (down, up) = (SectionMap::new(&projection, a).unwrap(), SectionMap::new(&projection, b).unwrap());
    for p in points(a, count, 5).into_iter().map(exact) {
        let middle = down.to_middle(&MeshPoint::from(&p)).unwrap();
        let expected = up.to_mesh(middle.prism, &middle.weights).unwrap();
        assert_eq!(MeshPoint::from(&transfer.forward(&p).unwrap()), expected);
    }
}

#[test]
fn agrees_with_the_slow_exact_maps() {
    let (shell, a, b) = generated();
    let middle = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
    let backwards = VertexOrder::List((0..shell.vertex_count() as u32).rev().collect());
    for order in [VertexOrder::Id, backwards] {
        same_as_the_slow_maps(&shell, &order, &a, &b, 60);
        same_as_the_slow_maps(&shell, &order, &b, &middle, 60);
        same_as_the_slow_maps(&shell, &order, &middle, &a, 60);
    }
}

#[test]
fn round_trips_are_equalities() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    for p in points(&a, 2000, 11).into_iter().map(exact) {
        let there = transfer.forward(&p).unwrap();
        let back = transfer.backward(&there).unwrap();
        assert!(back.is_same(&transfer.canonical(&p).unwrap()));
        // In lowest terms also the numbers are equal, and a reduced point goes the same way.
        assert_eq!(back.reduced().numerators(), transfer.canonical(&p).unwrap().reduced().numerators());
        assert!(
            transfer.backward(&there.clone().reduced()).unwrap().is_same(&transfer.canonical(&p).unwrap())
        );
    }
}

/// Coordinates with exponents from -60 to 0 do not fit into the narrow integers; tiny and large units do
/// not fit into doubles' products.
#[test]
fn wide_integers_and_far_units_change_nothing() {
    let (shell, a, b) = generated();
    let reference = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let reference = Transfer::new(&reference, &a, &b).unwrap();
    for scale in [2.0_f64.powi(-340), 2.0_f64.powi(300)] {
        let scaled = |x: &Vec<[f64; 3]>| x.iter().map(|p| p.map(|x| x * scale)).collect::<Vec<_>>();
        let far = Shell {
            bottom: scaled(&shell.bottom),
            middle: scaled(&shell.middle),
            top: scaled(&shell.top),
            faces: shell.faces.clone(),
        };
        let [a, b] = [&a, &b].map(|m| TriMesh { vertices: scaled(&m.vertices), faces: m.faces.clone() });
        let projection = Projection::new(&far, &VertexOrder::Id).unwrap();
        let transfer = Transfer::new(&projection, &a, &b).unwrap();
        for p in points(&a, 100, 3).into_iter().map(exact) {
            assert!(transfer.forward(&p).unwrap().is_same(&reference.forward(&p).unwrap()));
        }
    }
    // One coordinate of the order 2^-700 widens all integers that it meets.
    let mut wide = a.clone();
    for p in &mut wide.vertices {
        if p[0].abs() < 1e-9 {
            p[0] = 2.0_f64.powi(-700);
        }
    }
    assert!(wide != a);
    same_as_the_slow_maps(&shell, &VertexOrder::Id, &wide, &b, 100);
}

#[test]
fn rounded_answers_keep_their_bound() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let mut worst: f64 = 0.0;
    for (face, weights) in points(&a, 3000, 17) {
        let near = transfer.forward_f64(face, weights).unwrap();
        let q = transfer.forward(&exact((face, weights))).unwrap();
        assert_eq!(near.face, q.face);
        assert!(near.error <= MAX_ERROR);
        for (k, w) in q.rationals().iter().enumerate() {
            let off = (crate::number::Rat::try_from(near.weights[k]).unwrap() - w).to_f64().value().abs();
            assert!(off <= near.error, "{off} {near:?}");
            assert_eq!(near.weights[k] == 0.0, *w == crate::number::Rat::ZERO);
            worst = worst.max(off);
        }
    }
    assert!(worst < 1e-13, "{worst}");
}

/// Known by hand: one straight prism, two planes across it. The fibres are vertical lines.
#[test]
fn planes_across_a_prism() {
    let layer = |z: f64| vec![[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
    let shell = Shell { bottom: layer(-1.0), middle: layer(0.0), top: layer(1.0), faces: vec![[0, 1, 2]] };
    let a = TriMesh {
        vertices: vec![[0.0, 0.0, 0.5], [1.0, 0.0, -0.5], [0.0, 1.0, 0.25]],
        faces: vec![[1, 2, 0]],
    };
    let b = TriMesh {
        vertices: vec![[0.0, 0.0, -0.5], [0.5, 0.0, 0.5], [1.0, 0.0, 0.0], [0.0, 1.0, -0.25]],
        faces: vec![[0, 1, 3], [1, 2, 3]],
    };
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    // (1/4, 1/4) has the weights 1/4, 1/4, 1/2 on A's corners (1, 0), (0, 1), (0, 0).
    let q = transfer.forward(&ExactPoint::new(0, [1.into(), 1.into(), 2.into()]).unwrap()).unwrap();
    assert_eq!((q.face, q.texts()), (0, ["1/4", "1/2", "1/4"].map(str::to_owned)));
    // (1/2, 0) is B's vertex 1, in both triangles: the smaller one answers.
    let q = transfer.forward(&ExactPoint::new(0, [3.into(), 0.into(), 3.into()]).unwrap()).unwrap();
    assert_eq!((q.face, q.texts()), (0, ["0", "1", "0"].map(str::to_owned)));
    assert_eq!(transfer.forward_f64(0, [0.25, 0.25, 0.5]).unwrap().weights, [0.25, 0.5, 0.25]);
}

/// Equal numbers may differ in the sign of zero.
#[test]
fn batches_are_single_calls() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let bits = |answer: Result<FloatMeshPoint, SectionError>| {
        answer.map(|q| (q.face, q.weights.map(f64::to_bits), q.error.to_bits()))
    };
    for (mesh, forth) in [(&a, true), (&b, false)] {
        let mut list = points(mesh, 3000, 17);
        list.extend([(u32::MAX, [1.0; 3]), (0, [0.0; 3]), (1, [-1.0, 1.0, 1.0]), (2, [f64::NAN; 3])]);
        let one = |&(face, weights): &(u32, [f64; 3])| {
            if forth { transfer.forward_f64(face, weights) } else { transfer.backward_f64(face, weights) }
        };
        let single: Vec<_> = list.iter().map(|p| bits(one(p))).collect();
        assert_eq!(single.iter().filter(|found| found.is_err()).count(), 4);
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let batch = pool.install(|| {
                if forth { transfer.forward_batch_f64(&list) } else { transfer.backward_batch_f64(&list) }
            });
            assert_eq!(batch.into_iter().map(bits).collect::<Vec<_>>(), single);
        }
    }
}
