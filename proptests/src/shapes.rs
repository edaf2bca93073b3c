//! A pool of small shells on integer grids: flat and closed, with and without boundary, also self-overlapping ones.

use homeo::shell::Shell;

type Point = [f64; 3];

/// How many shapes [`shape`] knows.
pub const SHAPES: u32 = 16;

fn upright(middle: Vec<Point>, faces: Vec<[u32; 3]>, height: f64) -> Shell {
    let lift = |h: f64| middle.iter().map(|p| [p[0], p[1], p[2] + h]).collect();
    Shell { bottom: lift(-height), top: lift(height), middle, faces }
}

fn radial(middle: Vec<Point>, faces: Vec<[u32; 3]>) -> Shell {
    let scale = |s: f64| middle.iter().map(|p| p.map(|x| x * s)).collect();
    Shell { bottom: scale(0.5), top: scale(1.5), middle, faces }
}

fn join(mut a: Shell, b: Shell) -> Shell {
    let shift = u32::try_from(a.middle.len()).unwrap();
    a.bottom.extend(b.bottom);
    a.middle.extend(b.middle);
    a.top.extend(b.top);
    a.faces.extend(b.faces.iter().map(|f| f.map(|v| v + shift)));
    a
}

/// Triangles around vertex 0, whose rim is given; closed when `closed`.
fn fan(centre: Point, rim: &[Point], closed: bool) -> Shell {
    let n = u32::try_from(rim.len()).unwrap();
    let mut points = vec![centre];
    points.extend(rim);
    let last = if closed { n } else { n - 1 };
    let faces = (0..last).map(|i| [0, 1 + i, 1 + (i + 1) % n]).collect();
    upright(points, faces, 4.0)
}

fn square(shift: Point) -> Shell {
    let at = |x: f64, y: f64| [x + shift[0], y + shift[1], shift[2]];
    upright(vec![at(0., 0.), at(4., 0.), at(4., 4.), at(0., 4.)], vec![[0, 1, 2], [0, 2, 3]], 4.0)
}

fn annulus() -> Shell {
    let points =
        vec![[8., 0., 0.], [-4., 8., 0.], [-4., -8., 0.], [4., 0., 0.], [-2., 4., 0.], [-2., -4., 0.]];
    let faces = (0..3u32).flat_map(|i| {
        let j = (i + 1) % 3;
        [[i, j, 3 + j], [i, 3 + j, 3 + i]]
    });
    upright(points, faces.collect(), 4.0)
}

fn tetrahedron() -> Shell {
    let points = vec![[4., 4., 4.], [4., -4., -4.], [-4., 4., -4.], [-4., -4., 4.]];
    radial(points, vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
}

fn octahedron() -> Shell {
    let mut points = Vec::new();
    for k in 0..3 {
        for s in [4., -4.] {
            let mut p = [0.; 3];
            p[k] = s;
            points.push(p);
        }
    }
    let mut faces = Vec::new();
    for signs in 0..8u32 {
        let [x, y, z] = [signs & 1, 2 + (signs >> 1 & 1), 4 + (signs >> 2 & 1)];
        let flipped = signs.count_ones() % 2 == 1;
        faces.push(if flipped { [x, z, y] } else { [x, y, z] });
    }
    radial(points, faces)
}

/// Three by three vertices, round a ring with triangular section.
fn torus() -> Shell {
    let ring = [[1., 0.], [-0.5, 1.], [-0.5, -1.]];
    let section = |s: f64| {
        let around = [[s, 0.], [-s / 2., s], [-s / 2., -s]];
        ring.iter()
            .flat_map(|d| around.map(|[r, z]| [d[0] * (16. + r), d[1] * (16. + r), z]))
            .collect::<Vec<Point>>()
    };
    let mut faces = Vec::new();
    for i in 0..3u32 {
        for j in 0..3u32 {
            let at = |a: u32, b: u32| 3 * ((i + a) % 3) + (j + b) % 3;
            faces.push([at(0, 0), at(1, 0), at(1, 1)]);
            faces.push([at(0, 0), at(1, 1), at(0, 1)]);
        }
    }
    Shell { bottom: section(2.), middle: section(4.), top: section(6.), faces }
}

/// Seven vertices, all joined: Möbius's torus as realised by Császár.
fn seven() -> Shell {
    let points: Vec<Point> = vec![
        [3., -3., 0.],
        [-3., 3., 0.],
        [-3., -3., 1.],
        [3., 3., 1.],
        [-1., -2., 3.],
        [1., 2., 3.],
        [0., 0., 15.],
    ]
    .into_iter()
    .map(|p: Point| p.map(|x| 8. * x))
    .collect();
    let faces =
        (0..7u32).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
    upright(points, faces, 1.0)
}

/// A strip of triangles that turns around the origin by `turns` quarter turns, over itself when that is many.
fn strip(turns: usize) -> Shell {
    let ring = [[1., 0.], [0., 1.], [-1., 0.], [0., -1.]];
    let mut points = Vec::new();
    for k in 0..=turns {
        let [x, y] = ring[k % 4];
        points.push([4. * x, 4. * y, 0.]);
        points.push([8. * x, 8. * y, 0.]);
    }
    let n = u32::try_from(turns).unwrap();
    let faces = (0..n).flat_map(|k| [[2 * k, 2 * k + 1, 2 * k + 3], [2 * k, 2 * k + 3, 2 * k + 2]]);
    upright(points, faces.collect(), 4.0)
}

/// Shape number `k` (modulo [`SHAPES`]).
#[must_use]
pub fn shape(k: u32) -> Shell {
    let triangle = [[0., 0., 0.], [8., 0., 0.], [0., 8., 0.]];
    let rim4 = [[4., 0., 0.], [0., 4., 0.], [-4., 0., 0.], [0., -4., 0.]];
    let rim3 = [[6., 0., 0.], [-2., 4., 0.], [-2., -4., 0.]];
    match k % SHAPES {
        0 => upright(triangle.to_vec(), vec![[0, 1, 2]], 4.0),
        1 => square([0.; 3]),
        2 => fan([0.; 3], &rim3, true),
        3 => fan([0.; 3], &rim4, true),
        4 => fan([0.; 3], &rim4, false),
        5 => annulus(),
        6 => tetrahedron(),
        7 => octahedron(),
        8 => torus(),
        9 => seven(),
        10 => join(square([0.; 3]), square([2., 1., 2.])),
        11 => strip(5),
        // The pillar in the middle is wound around twice.
        12 => fan([0.; 3], &[rim3, rim3].concat(), true),
        13 => join(upright(triangle.to_vec(), vec![[0, 1, 2]], 4.0), square([16., 0., 0.])),
        14 => {
            // Two steep faces over one edge.
            let points = vec![[0., 0., 0.], [8., 0., 0.], [4., 4., -8.], [4., -4., -8.]];
            upright(points, vec![[0, 1, 2], [1, 0, 3]], 4.0)
        }
        _ => join(tetrahedron(), square([-2., -2., 5.])),
    }
}
