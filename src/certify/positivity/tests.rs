use super::*;
use crate::certify::Silent;
use crate::construct::icosphere;
use crate::predicate::orient3d_exact;
use crate::shell::Name;
use crate::testing::Random;

/// A shell of 1280 prisms around a sphere, some of them damaged: blocks with and without bad tets, pinched vertices, and
/// points that move by one ulp.
fn damaged(random: &mut Random, damages: usize) -> Shell {
    let sphere = icosphere(3);
    let scaled = |f: f64| sphere.vertices.iter().map(|p| p.map(|x| x * f)).collect::<Vec<_>>();
    let (bottom, middle, top) = (scaled(0.75), scaled(1.0), scaled(1.25));
    let mut shell = Shell { bottom, middle, top, faces: sphere.faces.clone() };
    for _ in 0..damages {
        let v = random.below(shell.middle.len());
        match random.below(4) {
            0 => {
                shell.bottom[v] = shell.middle[v];
                shell.top[v] = shell.middle[v];
            }
            1 => shell.top[v] = shell.middle[v].map(f64::next_up),
            2 => shell.bottom[v] = shell.top[v],
            _ => shell.middle[v] = shell.middle[v].map(|x| x + random.real()),
        }
    }
    shell
}

#[test]
fn blocks_of_prisms_have_the_verdicts_of_their_tets() {
    let mut random = Random(31);
    let (mut found, mut clean) = (0, 0);
    for round in 0..12 {
        let shell = damaged(&mut random, 3 * round);
        let exact = |tet: &Tet| {
            let [a, b, c, d] = tet.names.map(|n| shell.position(n));
            !orient3d_exact(a, b, c, d).is_positive()
        };
        let tets = (0..1280).flat_map(|p| shell.prism_tets_unique(p).collect::<Vec<_>>());
        let wanted: Vec<_> = tets.filter(exact).map(|t| (t.prism, t.sorted_names())).collect();
        let out = decide(&shell, &Silent).unwrap();
        let bad: Vec<_> = out.bad.iter().map(|b| (b.prism, b.names)).collect();
        assert_eq!(bad, wanted);
        let slab = |names: &[Name; 4]| {
            if names.iter().any(|n| n.layer == Layer::Top) { Slab::Top } else { Slab::Bottom }
        };
        let mut slabs: Vec<_> = wanted.iter().map(|(p, names)| (*p, slab(names))).collect();
        slabs.sort_unstable();
        slabs.dedup();
        assert_eq!(bad_slabs(&shell, &Silent).unwrap(), slabs);
        let all: usize = (0..1280).map(|p| shell.prism_tets_unique(p).count()).sum();
        assert_eq!(out.stages.total(), all as u64);
        found += bad.len();
        clean += usize::from(bad.is_empty());
    }
    assert!(found > 1000 && clean >= 1, "{found} bad tets, {clean} clean shells");
}

/// Shells with such coordinates are refused before; the filter does not rest on that.
#[test]
fn no_block_with_a_coordinate_that_is_no_number_is_clear() {
    let good = damaged(&mut Random(1), 0);
    let block: &[[u32; 3]; LANES] = good.faces.first_chunk().unwrap();
    assert_eq!(all_positive(&good, block), [true; LANES]);
    for (lane, face) in block.iter().enumerate() {
        for (corner, &v) in face.iter().enumerate() {
            for (layer, axis) in (0..9).map(|i| (i / 3, i % 3)) {
                for value in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
                    let mut shell = good.clone();
                    let layers = [&mut shell.bottom, &mut shell.middle, &mut shell.top];
                    layers.into_iter().nth(layer).unwrap()[v as usize][axis] = value;
                    assert!(!all_positive(&shell, block)[lane], "{lane} {corner} {layer} {axis} {value}");
                }
            }
        }
    }
}
