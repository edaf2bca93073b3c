//! Meshes near a shell: its middle surface, edited.

use homeo::mesh::TriMesh;
use homeo::shell::Shell;

/// One edit of a mesh; numbers that are too large wrap around.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The kind.
    pub kind: u8,
    /// The triangle or vertex.
    pub at: u8,
    /// Chooses a point or a direction.
    pub pick: [u8; 3],
}

/// How many kinds of edits there are.
pub const EDITS: u8 = 16;

fn step(pick: u8) -> f64 {
    [0., 1., -1., 0.5, -0.5, 2., -2., 0.][usize::from(pick % 8)]
}

/// A point in special position: a mean of two to four points of the prisms near shell vertex `v`.
fn special(shell: &Shell, prism: usize, pick: [u8; 3]) -> [f64; 3] {
    let corners = shell.faces[prism % shell.faces.len()];
    let point = |k: u8| {
        let v = corners[usize::from(k / 3 % 3)] as usize;
        [shell.bottom[v], shell.middle[v], shell.top[v]][usize::from(k % 3)]
    };
    let mean = |weights: &[(f64, u8)]| {
        let total: f64 = weights.iter().map(|w| w.0).sum();
        [0, 1, 2].map(|i| weights.iter().map(|(w, k)| w * point(*k)[i]).sum::<f64>() / total)
    };
    let [a, b, c] = pick;
    match c / 9 % 5 {
        0 => point(a),
        1 => mean(&[(1., a), (1., b)]),
        2 => mean(&[(3., a), (1., b)]),
        3 => mean(&[(2., a), (1., b), (1., c)]),
        _ => mean(&[(1., a), (1., b), (1., c), (1., a / 16)]),
    }
}

fn moved(p: [f64; 3], pick: [u8; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| p[i] + step(pick[i]))
}

fn mean(points: &[[f64; 3]]) -> [f64; 3] {
    // Weights that are powers of two keep the points exact.
    match points {
        [a, b] => [0, 1, 2].map(|i| (a[i] + b[i]) / 2.),
        [a, b, c] => [0, 1, 2].map(|i| (2. * a[i] + b[i] + c[i]) / 4.),
        _ => points[0],
    }
}

fn id(n: usize) -> u32 {
    u32::try_from(n).unwrap()
}

/// Applies an edit.
pub fn edit(mesh: &mut TriMesh, shell: &Shell, e: &Edit) {
    let f = usize::from(e.at) % mesh.faces.len();
    let v = usize::from(e.at) % mesh.vertices.len();
    let [a, b, c] = mesh.faces[f];
    let corners = [a, b, c].map(|v| mesh.vertices[v as usize]);
    match e.kind % EDITS {
        0 | 1 => mesh.vertices[v] = moved(mesh.vertices[v], e.pick),
        2 | 3 => split_face(mesh, f, moved(mean(&corners), e.pick)),
        4 => split_face(mesh, f, special(shell, f, e.pick)),
        5 | 6 => split_edge(mesh, f, moved(mean(&corners[..2]), e.pick)),
        7 => split_edge(mesh, f, special(shell, f, e.pick)),
        8 | 9 => flip(mesh, f),
        10 => {
            let near = shell.faces.iter().position(|f| f.contains(&id(v))).unwrap_or(0);
            mesh.vertices[v] = special(shell, near, e.pick);
        }
        11 | 12 => slide(mesh, shell, v, e.pick[0]),
        13 => {
            let all: Vec<u32> = (0..id(mesh.vertices.len())).collect();
            all.iter().for_each(|&v| slide(mesh, shell, v as usize, e.pick[0]));
        }
        14 => match e.pick[0] % 8 {
            0 => mesh.faces.iter_mut().for_each(|f| f.swap(0, 1)),
            1 => mesh.vertices.iter_mut().for_each(|p| *p = moved(*p, [e.pick[1], e.pick[2], e.pick[0] / 8])),
            2 => second_sheet(mesh, moved([0.; 3], [e.pick[1], e.pick[2], e.pick[0] / 8])),
            3 if mesh.faces.len() > 1 => drop(mesh.faces.remove(f)),
            _ => mesh.faces[f].rotate_left(1),
        },
        _ => split_face(mesh, f, mean(&corners)),
    }
}

fn slide(mesh: &mut TriMesh, shell: &Shell, v: usize, pick: u8) {
    if v >= shell.middle.len() {
        return;
    }
    let end = if pick & 1 == 0 { shell.bottom[v] } else { shell.top[v] };
    let part = f64::from(pick / 2 % 9) / 8.;
    mesh.vertices[v] = [0, 1, 2].map(|i| shell.middle[v][i] + part * (end[i] - shell.middle[v][i]));
}

fn split_face(mesh: &mut TriMesh, f: usize, p: [f64; 3]) {
    let [a, b, c] = mesh.faces[f];
    let n = id(mesh.vertices.len());
    mesh.vertices.push(p);
    mesh.faces[f] = [a, b, n];
    mesh.faces.extend([[b, c, n], [c, a, n]]);
}

/// The triangle across the side from corner 0 to corner 1, turned so that this is its last side.
fn across(mesh: &TriMesh, f: usize) -> Option<(usize, u32)> {
    let [a, b, _] = mesh.faces[f];
    mesh.faces.iter().enumerate().find_map(|(g, t)| {
        let i = (0..3).find(|&i| t[i] == b && t[(i + 1) % 3] == a)?;
        Some((g, t[(i + 2) % 3]))
    })
}

fn split_edge(mesh: &mut TriMesh, f: usize, p: [f64; 3]) {
    let [a, b, c] = mesh.faces[f];
    let n = id(mesh.vertices.len());
    let other = across(mesh, f);
    mesh.vertices.push(p);
    mesh.faces[f] = [a, n, c];
    mesh.faces.push([n, b, c]);
    if let Some((g, d)) = other {
        mesh.faces[g] = [b, n, d];
        mesh.faces.push([n, a, d]);
    }
}

fn flip(mesh: &mut TriMesh, f: usize) {
    let [a, b, c] = mesh.faces[f];
    let Some((g, d)) = across(mesh, f) else { return };
    if c == d || mesh.faces.iter().any(|t| t.contains(&c) && t.contains(&d)) {
        return;
    }
    mesh.faces[f] = [a, d, c];
    mesh.faces[g] = [d, b, c];
}

fn second_sheet(mesh: &mut TriMesh, shift: [f64; 3]) {
    let n = id(mesh.vertices.len());
    let copy: Vec<[f64; 3]> = mesh.vertices.iter().map(|p| [0, 1, 2].map(|i| p[i] + shift[i])).collect();
    mesh.vertices.extend(copy);
    let faces: Vec<[u32; 3]> = mesh.faces.iter().map(|f| f.map(|v| v + n)).collect();
    mesh.faces.extend(faces);
}
