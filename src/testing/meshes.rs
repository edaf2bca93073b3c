use crate::mesh::TriMesh;

/// A torus of `n` by `n` squares, each cut in two.
pub(crate) fn torus(n: u32) -> TriMesh {
    let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
    let at = |i: u32, j: u32| (i % n) * n + j % n;
    let mut mesh = TriMesh::default();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let r = 3.0 + angle(j).cos();
        mesh.vertices.push([r * angle(i).cos(), r * angle(i).sin(), angle(j).sin()]);
        mesh.faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        mesh.faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    mesh
}

/// Both meshes as one, the first one's vertices and faces first.
pub(crate) fn joined(first: &TriMesh, second: &TriMesh) -> TriMesh {
    let shift = u32::try_from(first.vertices.len()).unwrap();
    let shifted = second.faces.iter().map(|f| f.map(|v| v + shift));
    TriMesh {
        vertices: [first.vertices.as_slice(), &second.vertices].concat(),
        faces: first.faces.iter().copied().chain(shifted).collect(),
    }
}
