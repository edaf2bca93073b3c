//! Surfaces with boundary.

use homeo::mesh::TriMesh;

use super::{Random, grid, id, joined, map, turned_inside_out};

/// A graph over the plane.
pub(super) fn landscape(size: u32, random: &mut Random) -> TriMesh {
    let h = [0.4, 1e-3, 0.0][random.below(3)];
    let n = 2 + size;
    let m = 1 + random.below(n as usize);
    let mesh = grid(n, id(m), random, |x, y| [x, y, 0.0]);
    map(mesh, |[x, y, _]| [x, y, h * random.real()])
}

/// A steep one.
pub(super) fn rough_landscape(size: u32, random: &mut Random) -> TriMesh {
    let h = random.between(0.5, 4.0);
    let mesh = grid(2 + size, 2 + size, random, |x, y| [x, y, 0.0]);
    map(mesh, |[x, y, _]| [x, y, h * random.real()])
}

/// Two sheets very near each other, back to back, face to face or alike.
pub(super) fn two_sheets(size: u32, random: &mut Random) -> TriMesh {
    let (h, n) = (random.tiny(2.0, 10.0), 1 + size);
    let first = grid(n, n, random, |x, y| [x, y, 0.0]);
    let second = grid(n, n, random, |x, y| [x, y, h]);
    match random.below(3) {
        0 => joined(first, &second),
        1 => joined(turned_inside_out(first), &second),
        _ => joined(first, &turned_inside_out(second)),
    }
}

/// A sheet rolled up, more than once around.
pub(super) fn rolled(size: u32, random: &mut Random) -> TriMesh {
    let (n, gap) = (8 + 8 * size, random.tiny(0.3, 3.0));
    let step = random.between(0.5, 0.8);
    grid(n, 1 + size, random, |i, j| {
        let (y, x) = (step * i).sin_cos();
        let r = 1.0 + gap * i * step / std::f64::consts::TAU;
        [r * x, r * y, j]
    })
}

/// One triangle wide, winding.
pub(super) fn strip(size: u32, random: &mut Random) -> TriMesh {
    let n = 2 + 3 * size as usize;
    let turn = random.between(-0.8, 0.8);
    let wide = random.tiny(-0.5, 3.0);
    let rise = random.between(0.2, 1.0) * wide.max(0.1);
    let vertices = (0..n + 2)
        .map(|k| {
            let (y, x) = (turn * k as f64 * 0.5).sin_cos();
            let r = if k % 2 == 0 { 1.0 } else { 1.0 + wide };
            [r * x, r * y, rise * k as f64]
        })
        .collect();
    let faces = (0..n).map(|k| {
        let (a, b, c) = (id(k), id(k + 1), id(k + 2));
        if k % 2 == 0 { [a, b, c] } else { [b, a, c] }
    });
    let faces = faces.collect();
    TriMesh { vertices, faces }
}

/// One triangle, sometimes very thin.
pub(super) fn triangle(_: u32, random: &mut Random) -> TriMesh {
    let thin = random.tiny(0.0, 14.0);
    let x = random.real();
    let vertices = vec![[0., 0., 0.], [1., 0., 0.], [x, thin, 0.1 * x]];
    TriMesh { vertices, faces: vec![[0, 1, 2]] }
}

/// Two triangles over an edge, sometimes nearly folded.
pub(super) fn two_triangles(_: u32, random: &mut Random) -> TriMesh {
    let h = random.tiny(-1.0, 9.0) * [1.0, -1.0][random.below(2)];
    let y = [-1.0, 0.0, 0.3, 1.0][random.below(4)];
    let vertices = vec![[0., 0., 0.], [1., 0., 0.], [random.real(), 1., 0.], [random.real(), y, h]];
    TriMesh { vertices, faces: vec![[0, 1, 2], [1, 0, 3]] }
}

/// Rings of points around a tip along the seam of a tennis ball, or along a wave: the tip may have no direction.
pub(super) fn seam(size: u32, random: &mut Random) -> TriMesh {
    let (n, rings) = (8 + 4 * size as usize, 1 + random.below(3));
    let wave = random.between(0.2, 1.0);
    let mut mesh = TriMesh { vertices: vec![[0.0; 3]], faces: Vec::new() };
    for ring in 1..=rings {
        for k in 0..n {
            let t = std::f64::consts::TAU * k as f64 / n as f64;
            let p = [
                3.0 * t.cos() + wave * (3.0 * t).cos(),
                3.0 * t.sin() - wave * (3.0 * t).sin(),
                2.0 * (3.0 * wave).sqrt() * (2.0 * t).sin(),
            ];
            mesh.vertices.push(p.map(|x| x * ring as f64));
        }
    }
    let at = |ring: usize, k: usize| id(if ring == 0 { 0 } else { 1 + (ring - 1) * n + k % n });
    for k in 0..n {
        mesh.faces.push([0, at(1, k), at(1, k + 1)]);
        for ring in 1..rings {
            let square = [at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)];
            mesh.faces.extend(super::split(square, random));
        }
    }
    mesh
}

/// An open fan, flat, steep or folded back.
pub(super) fn fan(size: u32, random: &mut Random) -> TriMesh {
    let n = 2 + 2 * size as usize;
    let h = [0.0, 0.5, 2.0][random.below(3)];
    let whole = random.between(1.0, 6.0);
    let mut vertices = vec![[0.0; 3]];
    for k in 0..=n {
        let (y, x) = (whole * k as f64 / n as f64).sin_cos();
        vertices.push([x, y, h * random.real()]);
    }
    let faces = (0..n).map(|k| [0, id(k + 1), id(k + 2)]);
    let faces = faces.collect();
    TriMesh { vertices, faces }
}
