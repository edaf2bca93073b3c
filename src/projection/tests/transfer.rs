//! The reference implementation's own floating projections, compared with the exact ones.
//!
//! Its files hold queries `mV`, target triangles `pV pF`, and answers: a triangle `fid` (-1: no tet
//! found, -2: no hit) with the weights `qUV` on its second and third corner.

use crate::mesh::TriMesh;
use crate::projection::{Projection, Rat, SectionMap};
use crate::shell::VertexOrder;
use crate::shell::hdf5;
use crate::testing::shell_directory;
use hdf5_pure::File;
use std::collections::BTreeMap;

struct Answers {
    queries: Vec<[f64; 3]>,
    target: Vec<[u32; 3]>,
    triangle: Vec<i64>,
    uv: Vec<[f64; 2]>,
}

fn read(path: &std::path::Path) -> Answers {
    let file = File::from_bytes(std::fs::read(path).unwrap()).unwrap();
    let reals = |name| file.dataset(name).unwrap().read_f64().unwrap();
    let integers = |name| file.dataset(name).unwrap().read_i64().unwrap();
    let faces: Vec<u32> = integers("pF").into_iter().map(|v| u32::try_from(v).unwrap()).collect();
    Answers {
        queries: reals("mV").as_chunks().0.to_vec(),
        target: faces.as_chunks().0.to_vec(),
        triangle: integers("fid"),
        uv: reals("qUV").as_chunks().0.to_vec(),
    }
}

/// A point of a triangle mesh as weights on vertices: the same for all triangles that share it.
fn on_vertices(face: [u32; 3], weights: [f64; 3]) -> BTreeMap<u32, f64> {
    face.into_iter().zip(weights).collect()
}

fn distance(a: &BTreeMap<u32, f64>, b: &BTreeMap<u32, f64>) -> f64 {
    let at = |m: &BTreeMap<u32, f64>, v: &u32| m.get(v).copied().unwrap_or(0.0);
    a.keys().chain(b.keys()).map(|v| (at(a, v) - at(b, v)).abs()).fold(0.0, f64::max)
}

/// What came out of a comparison.
#[derive(Debug, Default)]
struct Tally {
    agree: usize,
    worst: f64,
    differ: usize,
    no_tet: usize,
    no_hit: usize,
    /// The exact map has an answer where the reference has none, and the reverse.
    ours_only: usize,
    theirs_only: usize,
    several: usize,
}

impl Tally {
    fn add(&mut self, theirs: Option<BTreeMap<u32, f64>>, ours: &[BTreeMap<u32, f64>], code: i64) {
        self.no_tet += usize::from(code == -1);
        self.no_hit += usize::from(code == -2);
        self.several += usize::from(ours.len() > 1);
        match theirs {
            None => self.ours_only += usize::from(!ours.is_empty()),
            Some(_) if ours.is_empty() => self.theirs_only += 1,
            Some(theirs) => {
                let nearest = ours.iter().map(|o| distance(o, &theirs)).fold(f64::INFINITY, f64::min);
                if nearest <= 1e-6 {
                    self.agree += 1;
                    self.worst = self.worst.max(nearest);
                } else {
                    self.differ += 1;
                }
            }
        }
    }
}

fn compare(answers: &Answers, ours: impl Fn(&[f64; 3]) -> Vec<(u32, [Rat; 3])>) -> Tally {
    let mut tally = Tally::default();
    for (k, query) in answers.queries.iter().enumerate() {
        let code = answers.triangle[k];
        let theirs = usize::try_from(code).ok().map(|f| {
            let [u, v] = answers.uv[k];
            on_vertices(answers.target[f], [1.0 - u - v, u, v])
        });
        let rounded = |w: [Rat; 3]| w.map(|x| x.to_f64().value());
        let ours = ours(query).into_iter().map(|(f, w)| on_vertices(answers.target[f as usize], rounded(w)));
        tally.add(theirs, &ours.collect::<Vec<_>>(), code);
    }
    tally
}

#[test]
fn the_reference_projection_agrees() {
    let Some(directory) = shell_directory() else { return };
    for name in ["bunny.off.h5", "sphere.obj.h5", "tennis.off.h5"] {
        let file = hdf5::read(&directory.join(name)).unwrap();
        let mesh: TriMesh = file.mesh.unwrap();
        let projection = Projection::new(&file.shell, &VertexOrder::Id).unwrap();
        let map = SectionMap::new(&projection, &mesh).unwrap();
        let images = |p: &[f64; 3]| projection.project_all(&p.map(|x| Rat::try_from(x).unwrap()));

        let answers = read(&directory.join(format!("transfer/{name}.ref2mid.h5")));
        assert_eq!(answers.target, file.shell.faces);
        let down = compare(&answers, |p| images(p).into_iter().map(|q| (q.prism, q.weights)).collect());
        eprintln!("{name} mesh to middle, {} queries: {down:?}", answers.queries.len());

        let answers = read(&directory.join(format!("transfer/{name}.mid2ref.h5")));
        assert_eq!(answers.target, mesh.faces);
        let up = compare(&answers, |p| {
            let points = images(p).into_iter().flat_map(|q| map.preimages(q.prism, &q.weights).unwrap());
            points.map(|m| (m.face, m.weights)).collect()
        });
        eprintln!("{name} middle to mesh, {} queries: {up:?}", answers.queries.len());
        // Measured: every query agrees, the worst by 4e-12 (mesh triangles are small beside the
        // middle ones, which magnifies the rounding of the stored queries).
        for tally in [down, up] {
            assert_eq!(tally.agree, answers.queries.len(), "{name}: {tally:?}");
        }
    }
}
