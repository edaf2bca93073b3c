//! Topology of surfaces: what each component is, and the documents about it.

use super::super::CertifyError;
use super::super::claim::Verdict;
use super::super::pl::{Input, PlError, Witness, decide, sound};
use super::document::Document;
use crate::mesh::connectivity::Sets;
use crate::mesh::{Complex, Connectivity, TriMesh};

/// What a component is up to homeomorphism, given that it is an oriented manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct ComponentFacts {
    /// Vertices - edges + triangles.
    pub euler_characteristic: i64,
    /// Boundary loops.
    pub boundary_loops: u64,
}

impl ComponentFacts {
    /// `2 - 2 genus - loops = euler`.
    #[must_use]
    pub fn genus(&self) -> i64 {
        (2 - self.euler_characteristic - i64::try_from(self.boundary_loops).unwrap_or(i64::MAX)) / 2
    }
}

/// The components of an oriented manifold, by smallest triangle. O(n log n).
#[must_use]
pub fn component_facts(mesh: &TriMesh, connectivity: &Connectivity) -> Vec<ComponentFacts> {
    let none = ComponentFacts { euler_characteristic: 0, boundary_loops: 0 };
    let mut out = vec![none; connectivity.component_count()];
    let mut owner: Vec<Option<u32>> = vec![None; mesh.vertices.len()];
    for (f, face) in mesh.faces.iter().enumerate() {
        let component = connectivity.component(f as u32);
        out[component as usize].euler_characteristic += 1;
        for &v in face {
            // All triangles at a manifold vertex are of one component.
            if owner[v as usize].replace(component).is_none() {
                out[component as usize].euler_characteristic += 1;
            }
        }
    }
    for edge in connectivity.edges() {
        let component = edge.sides.first().map_or(0, |s| connectivity.component(s.face()));
        out[component as usize].euler_characteristic -= 1;
    }
    let mut loops = Sets::new(mesh.vertices.len());
    let mut ends = Vec::new();
    for side in connectivity.boundary() {
        let [u, w] = connectivity.ends(side);
        loops.join(u, w);
        ends.push((u, connectivity.component(side.face())));
    }
    for (v, component) in ends {
        // Each boundary vertex of a manifold starts one boundary side, so each loop has one root among them.
        if loops.find(v) == v {
            out[component as usize].boundary_loops += 1;
        }
    }
    out
}

/// `manifold`: is the surface an oriented manifold without flat triangles?
///
/// # Errors
/// [`PlError`] if there is nothing to look at.
pub fn manifold(mesh: &TriMesh) -> Result<(Option<Witness>, String), PlError> {
    let complex = Complex::from(mesh.clone());
    let facets = decide::facets(&complex)?;
    let flat = || {
        let corners = |f: &[u32; 3]| f.map(|v| &mesh.vertices[v as usize]);
        let cell = mesh.faces.iter().position(|f| crate::mesh::is_zero_area(corners(f)))?;
        Some(Witness::Flat(u32::try_from(cell).ok()?))
    };
    let defect = sound::defect(&facets, mesh.vertices.len()).or_else(flat);
    let mut document = Document::new("manifold", Verdict::of(defect.is_none()));
    document.input(Input::A, &complex);
    if let Some(witness) = &defect {
        document.block("witness", vec![witness.line(Input::A)]);
    }
    Ok((defect, document.text()))
}

/// `same-topology` of two sound surfaces, whichever way it is decided: their components' facts are compared.
#[must_use]
pub fn same_topology(a: &TriMesh, b: &TriMesh, facts: [&[ComponentFacts]; 2]) -> (Verdict, String) {
    let [mut first, mut second] = facts.map(<[_]>::to_vec);
    first.sort_unstable();
    second.sort_unstable();
    let verdict = Verdict::of(first == second);
    let mut document = Document::new("same-topology", verdict);
    document.input(Input::A, &Complex::from(a.clone()));
    document.input(Input::B, &Complex::from(b.clone()));
    (verdict, document.text())
}

/// `nested-topology`, refuted where the cage has more handles than the mesh in it; `None` where that is not decided.
#[must_use]
pub fn nested_topology(a: &TriMesh, b: &TriMesh, facts: [&[ComponentFacts]; 2]) -> Option<String> {
    let [inner, outer] = facts.map(|f| f.iter().map(ComponentFacts::genus).sum::<i64>());
    if outer <= inner {
        return None;
    }
    let mut document = Document::new("nested-topology", Verdict::Refuted);
    document.input(Input::A, &Complex::from(a.clone()));
    document.input(Input::B, &Complex::from(b.clone()));
    Some(document.text())
}

/// One vertex of every component, by smallest triangle.
pub(super) fn roots(mesh: &TriMesh, connectivity: &Connectivity) -> Result<Vec<u32>, CertifyError> {
    let mut out: Vec<u32> = Vec::new();
    for (f, face) in mesh.faces.iter().enumerate() {
        if connectivity.component(f as u32) as usize == out.len() {
            out.push(face[0]);
        }
    }
    if out.len() == connectivity.component_count() {
        Ok(out)
    } else {
        Err(CertifyError::Internal { what: "components that are not numbered by first triangle" })
    }
}
