//! Recipes: small numbers that stand for a shell, a mesh and a vertex order; proptest and quickcheck make and shrink
//! them.

use homeo::certify::VertexOrder;
use homeo::mesh::TriMesh;
use homeo::shell::Shell;
use proptest::prelude::*;
use quickcheck::{Arbitrary, Gen};

use crate::oracle::World;
use crate::shapes::{SHAPES, shape};
use crate::sheets::{EDITS, Edit, edit};

/// One point of the shell, moved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Move {
    /// Which point.
    pub at: u8,
    /// Steps along the axes: halves.
    pub by: [i8; 3],
}

/// A case, as numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// The shape.
    pub shape: u32,
    /// Vertices to pinch.
    pub pinched: Vec<u8>,
    /// Moves of single points.
    pub moves: Vec<Move>,
    /// A move that is stopped at the last floating-point number for which the shell is positive (or the first for
    /// which it is not): makes barely valid and barely invalid shells.
    pub edge: Option<(Move, bool)>,
    /// Edits of the mesh, which starts as the middle surface.
    pub edits: Vec<Edit>,
    /// The vertex order: by id when 0, else shuffled.
    pub order: u16,
}

/// A shell, a mesh, an order.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The shell.
    pub shell: Shell,
    /// The mesh.
    pub mesh: TriMesh,
    /// The vertices, smallest first.
    pub order: Vec<u32>,
}

impl Case {
    /// The order as the certifier takes it.
    ///
    /// # Panics
    /// If `order` is not a permutation.
    #[must_use]
    pub fn vertex_order(&self) -> VertexOrder {
        VertexOrder::from_list(self.order.clone(), self.shell.middle.len()).unwrap()
    }

    /// `rank[v]`: the place of vertex `v` in the order.
    #[must_use]
    pub fn rank(&self) -> Vec<usize> {
        let mut rank = vec![0; self.order.len()];
        self.order.iter().enumerate().for_each(|(place, &v)| rank[v as usize] = place);
        rank
    }
}

fn point(shell: &mut Shell, at: u8) -> &mut [f64; 3] {
    let n = shell.middle.len();
    let k = usize::from(at) % (3 * n);
    match k % 3 {
        0 => &mut shell.bottom[k / 3],
        1 => &mut shell.middle[k / 3],
        _ => &mut shell.top[k / 3],
    }
}

fn pushed(shell: &Shell, m: &Move, scale: f64) -> Shell {
    let mut out = shell.clone();
    let p = point(&mut out, m.at);
    for (x, by) in p.iter_mut().zip(m.by) {
        *x += scale * f64::from(by);
    }
    out
}

fn is_positive(shell: &Shell) -> bool {
    World::new(shell, &TriMesh { vertices: Vec::new(), faces: Vec::new() }).positivity()
}

fn to_the_edge(shell: &Shell, m: &Move, stay: bool) -> Shell {
    let (mut good, mut bad) = (0f64, 16f64);
    if !is_positive(shell) || is_positive(&pushed(shell, m, bad)) {
        return shell.clone();
    }
    loop {
        let middle = f64::midpoint(good, bad);
        if middle <= good || middle >= bad {
            return pushed(shell, m, if stay { good } else { bad });
        }
        if is_positive(&pushed(shell, m, middle)) { good = middle } else { bad = middle }
    }
}

pub(crate) fn shuffled(n: usize, seed: u16) -> Vec<u32> {
    let mut out: Vec<u32> = (0..u32::try_from(n).unwrap()).collect();
    let mut state = u64::from(seed);
    for i in (1..if seed == 0 { 0 } else { n }).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let j = (state >> 33) % (i as u64 + 1);
        out.swap(i, usize::try_from(j).unwrap());
    }
    out
}

impl Recipe {
    /// Follows the recipe.
    #[must_use]
    pub fn build(&self) -> Case {
        let mut shell = shape(self.shape);
        let n = shell.middle.len();
        for m in &self.moves {
            shell = pushed(&shell, m, 0.5);
        }
        for p in &self.pinched {
            let v = usize::from(*p) % n;
            shell.bottom[v] = shell.middle[v];
            shell.top[v] = shell.middle[v];
        }
        if let Some((m, stay)) = &self.edge {
            shell = to_the_edge(&shell, m, *stay);
        }
        let mut mesh = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
        for e in &self.edits {
            if mesh.faces.len() < 24 {
                edit(&mut mesh, &shell, e);
            }
        }
        let order = shuffled(n, self.order);
        Case { shell, mesh, order }
    }
}

fn moves() -> impl Strategy<Value = Move> {
    (any::<u8>(), [-3i8..4, -3i8..4, -3i8..4]).prop_map(|(at, by)| Move { at, by })
}

fn edits() -> impl Strategy<Value = Edit> {
    (0..EDITS, any::<u8>(), any::<[u8; 3]>()).prop_map(|(kind, at, pick)| Edit { kind, at, pick })
}

/// Recipes over all shapes, the small ones most of all.
pub fn recipes() -> impl Strategy<Value = Recipe> {
    // The octahedron and the tori (7 to 9) are slow.
    let shape = prop_oneof![20 => 0u32..7, 1 => 7u32..10, 12 => 10..SHAPES];
    let pinched = prop_oneof![3 => Just(Vec::new()), 1 => prop::collection::vec(any::<u8>(), 1..3)];
    let moves_of = prop_oneof![2 => Just(Vec::new()), 3 => prop::collection::vec(moves(), 1..4)];
    let edge = prop_oneof![5 => Just(None), 1 => (moves(), any::<bool>()).prop_map(Some)];
    let edit_list = prop::collection::vec(edits(), 0..4);
    let order = prop_oneof![1 => Just(0u16), 1 => any::<u16>()];
    (shape, pinched, moves_of, edge, edit_list, order).prop_map(
        |(shape, pinched, moves, edge, edits, order)| Recipe { shape, pinched, moves, edge, edits, order },
    )
}

impl Arbitrary for Recipe {
    fn arbitrary(g: &mut Gen) -> Self {
        let some_move = |g: &mut Gen| {
            let by = [0; 3].map(|_: i32| *g.choose(&[-2, -1, 0, 0, 1, 2]).unwrap());
            Move { at: u8::arbitrary(g), by }
        };
        let few = |g: &mut Gen, n: u32| u32::arbitrary(g) % n;
        let edits = (0..few(g, 4)).map(|_| {
            let pick = [u8::arbitrary(g), u8::arbitrary(g), u8::arbitrary(g)];
            Edit { kind: u8::arbitrary(g) % EDITS, at: u8::arbitrary(g), pick }
        });
        let edits = edits.collect();
        let moves = (0..few(g, 3)).map(|_| some_move(g)).collect();
        let pinched = (0..few(g, 5).saturating_sub(3)).map(|_| u8::arbitrary(g)).collect();
        let edge = (few(g, 6) == 0).then(|| (some_move(g), bool::arbitrary(g)));
        let shape = *g.choose(&[0, 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14]).unwrap();
        Self { shape, pinched, moves, edge, edits, order: u16::arbitrary(g) % 64 }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let mut out = Vec::new();
        let mut push = |change: &dyn Fn(&mut Self)| {
            let mut smaller = self.clone();
            change(&mut smaller);
            if smaller != *self {
                out.push(smaller);
            }
        };
        push(&|r| r.edge = None);
        push(&|r| r.order = 0);
        push(&|r| r.pinched.clear());
        (0..self.moves.len()).for_each(|i| push(&|r| r.moves.truncate(i)));
        (0..self.edits.len()).for_each(|i| push(&|r| r.edits.truncate(i)));
        Box::new(out.into_iter())
    }
}
