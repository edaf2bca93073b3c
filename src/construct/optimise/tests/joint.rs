//! Joint shells: valid around their mesh whatever the partner.

use super::*;
use crate::construct::Thickness;
use crate::construct::optimise::optimise_joint;
use crate::construct::optimise::partner::Partner;

/// The mesh turned about two axes: other triangles near the same sphere.
fn turned(mesh: &TriMesh, angle: f64) -> TriMesh {
    let (s, c) = angle.sin_cos();
    let turn = |p: &[f64; 3]| {
        let [x, y, z] = [c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]];
        [x, c * y - s * z, s * y + c * z]
    };
    TriMesh { vertices: mesh.vertices.iter().map(turn).collect(), faces: mesh.faces.clone() }
}

/// The partner's violation by a whole shell.
fn violation(shell: &Shell, partner: &TriMesh) -> f64 {
    let state = State::new(shell, &connectivity(shell));
    let prisms: Vec<Prism> = state.faces.iter().map(|f| state.prism(*f, None)).collect();
    Partner::new(partner.clone()).violation(&prisms)
}

#[test]
fn the_mesh_stays_a_section_and_the_partner_becomes_one() {
    for seed in [41, 42] {
        let mesh = bumpy(2, &mut Random(seed));
        let partner = turned(&bumpy(2, &mut Random(seed + 10)), 0.5);
        // Too thin for the partner, which the optimisation may change.
        let thin = InitialOptions { thickness: Thickness::Share(0.005), ..InitialOptions::default() };
        let first = initial(&mesh, &thin, &Silent).unwrap().shell;
        let before = violation(&first, &partner);
        assert!(before > 0.0, "seed {seed}: nothing to repair");
        let options = OptimiseOptions { polish: 1, ..OptimiseOptions::default() };
        let done = optimise_joint(&mesh, &partner, &first, &options, &Silent).unwrap();
        assert_eq!(refuted(&done.shell, &mesh), Vec::<String>::new(), "seed {seed}");
        assert_eq!(refuted(&done.shell, &partner), Vec::<String>::new(), "seed {seed}");
    }
}

#[test]
fn a_partner_far_away_does_no_harm() {
    let mesh = bumpy(1, &mut Random(43));
    let mut far = bumpy(1, &mut Random(44));
    far.vertices.iter_mut().for_each(|p| p[0] += 10.0);
    let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap().shell;
    let options = OptimiseOptions { polish: 1, ..OptimiseOptions::default() };
    let done = optimise_joint(&mesh, &far, &first, &options, &Silent).unwrap();
    assert_eq!(refuted(&done.shell, &mesh), Vec::<String>::new());
    assert!(refuted(&done.shell, &far).contains(&"section".to_owned()));
}
