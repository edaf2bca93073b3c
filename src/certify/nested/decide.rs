//! The verdict on C7.

use super::super::claim::Verdict;
use super::super::observer::Observer;
use super::super::pl::{self, Input, PlError, Side, Witness};
use super::super::separate::{PlaneName, PointName};
use super::super::write::joined;
use super::between::{self, Between, Meeting};
use super::document::Document;
use super::ray::{self, Ray, Whose};
use super::topology::roots;
use crate::mesh::{Complex, Connectivity, TriMesh};

/// Why a mesh is not nested in a cage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// One of the surfaces is no embedded oriented manifold.
    Defect(Input, Witness),
    /// A directed edge of one of the surfaces that no triangle has the other way round.
    Open(Input, [u32; 2]),
    /// A common point.
    Meeting(Meeting),
    /// A vertex about which the other surface does not wind as it should.
    Winding(Ray),
}

/// The verdict with its proof.
#[derive(Debug)]
pub struct NestedOutcome {
    /// Certified or refuted.
    pub verdict: Verdict,
    /// Reasons against it, of the first kind found.
    pub reasons: Vec<Reason>,
    /// One ray for each component of the mesh, then of the cage; those with the wrong number are reasons.
    pub rays: Vec<Ray>,
    /// Pairs of triangles of mesh and cage whose boxes meet.
    pub pairs: u64,
    /// The document.
    pub certificate: String,
}

/// Reasons listed in a document.
const LINES: usize = 100;

/// Decides C7: is mesh `a` nested in the cage `b`? O((n + k) log n) for k pairs of boxes that meet, and one pass over the
/// other surface for each component.
///
/// # Errors
/// [`PlError`] if there is nothing to look at, or the work was interrupted.
pub fn nested(a: &TriMesh, b: &TriMesh, observer: &dyn Observer) -> Result<NestedOutcome, PlError> {
    let complexes = [Complex::from(a.clone()), Complex::from(b.clone())];
    let sides = [pl::side_facts(&complexes[0], observer)?, pl::side_facts(&complexes[1], observer)?];
    let mut out = Found { sides, between: Between::default(), rays: Vec::new(), reasons: Vec::new() };
    out.defects();
    if out.reasons.is_empty() {
        out.open([a, b])?;
    }
    if out.reasons.is_empty() {
        out.between = between::decide(a, b, observer)?;
        out.reasons.extend(out.between.meetings.iter().cloned().map(Reason::Meeting));
    }
    if out.reasons.is_empty() {
        observer.stage("rays", None);
        out.wind(a, b)?;
    }
    let certificate = out.document(&complexes);
    let verdict = Verdict::of(out.reasons.is_empty());
    Ok(NestedOutcome { verdict, reasons: out.reasons, rays: out.rays, pairs: out.between.pairs, certificate })
}

struct Found {
    sides: [Side; 2],
    between: Between,
    rays: Vec<Ray>,
    reasons: Vec<Reason>,
}

impl Found {
    fn defects(&mut self) {
        for (name, side) in [Input::A, Input::B].into_iter().zip(&self.sides) {
            self.reasons.extend(side.witnesses.iter().map(|w| Reason::Defect(name, w.clone())));
        }
    }

    fn open(&mut self, meshes: [&TriMesh; 2]) -> Result<(), PlError> {
        for (name, mesh) in [Input::A, Input::B].into_iter().zip(meshes) {
            let connectivity = connectivity(mesh)?;
            let edges = connectivity.boundary().map(|s| Reason::Open(name, connectivity.ends(s)));
            self.reasons.extend(edges);
        }
        Ok(())
    }

    fn wind(&mut self, a: &TriMesh, b: &TriMesh) -> Result<(), PlError> {
        for (whose, mesh, other, wanted) in [(Whose::A, a, b, 1), (Whose::B, b, a, 0)] {
            for vertex in roots(mesh, &connectivity(mesh)?)? {
                let ray = ray::cast(whose, vertex, mesh, other)?;
                if ray.number != wanted {
                    self.reasons.push(Reason::Winding(ray.clone()));
                }
                self.rays.push(ray);
            }
        }
        Ok(())
    }

    fn document(&self, complexes: &[Complex; 2]) -> String {
        let mut out = Document::new("nested", Verdict::of(self.reasons.is_empty()));
        out.input(Input::A, &complexes[0]);
        out.input(Input::B, &complexes[1]);
        if !self.reasons.is_empty() {
            out.block("witness", self.reasons.iter().take(LINES).map(line).collect());
            return out.text();
        }
        for (name, side) in [Input::A, Input::B].into_iter().zip(&self.sides) {
            let sep = |(i, j, planes): &(u32, u32, Vec<PlaneName>)| {
                format!("sep {i} {j} {}", joined(planes.iter().map(|p| pl::write::plane(name, p)), " "))
            };
            out.block(&name.to_string(), side.separations.iter().map(sep).collect());
        }
        let sep = |(i, j, planes): &(u32, u32, Vec<PlaneName>)| {
            format!("sep {i} {j} {}", joined(planes.iter().map(plane), " "))
        };
        out.block("between", self.between.separations.iter().map(sep).collect());
        out.block("rays", self.rays.iter().map(|r| ray_line("ray", r)).collect());
        out.text()
    }
}

fn connectivity(mesh: &TriMesh) -> Result<Connectivity, PlError> {
    // `side_facts` has checked the indices; other errors are of size.
    Connectivity::new(mesh.vertices.len(), &mesh.faces).map_err(|_| PlError::TooMany(mesh.faces.len()))
}

/// A plane through points of both surfaces.
fn plane(plane: &PlaneName) -> String {
    plane.text(|point| match point {
        PointName::Mesh(v) => format!("a{v}"),
        PointName::Shell(name) => format!("b{}", name.vertex),
    })
}

fn ray_line(word: &str, ray: &Ray) -> String {
    let whose = if ray.whose == Whose::A { "a" } else { "b" };
    let triangles: String = ray.triangles.iter().map(|t| format!(" {t}")).collect();
    format!("{word} {whose} {} {}{triangles}", ray.vertex, joined(ray.direction, " "))
}

fn line(reason: &Reason) -> String {
    match reason {
        Reason::Defect(input, witness) => witness.line(*input),
        Reason::Open(input, [u, w]) => format!("open {input} {u} {w}"),
        Reason::Meeting(Meeting { triangles: [i, j], weights: [x, y] }) => {
            format!("cross ab {i} {j} {} {}", joined(x, " "), joined(y, " "))
        }
        Reason::Winding(ray) => ray_line("winding", ray),
    }
}

impl Reason {
    /// The line of the document.
    #[must_use]
    pub fn line(&self) -> String {
        line(self)
    }

    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let name = |input: &Input| if *input == Input::A { "the mesh" } else { "the cage" };
        match self {
            Self::Defect(input, witness) => format!("{}: {}", name(input), witness.sentence()),
            Self::Open(input, [u, w]) => format!("{} is not closed: boundary edge {u} {w}", name(input)),
            Self::Meeting(Meeting { triangles: [i, j], .. }) => {
                format!("triangle {i} of the mesh and triangle {j} of the cage meet")
            }
            Self::Winding(ray) if ray.whose == Whose::A => format!(
                "the cage winds {} times around the component of the mesh with vertex {}, not once",
                ray.number, ray.vertex
            ),
            Self::Winding(ray) => format!(
                "the mesh winds {} times around the component of the cage with vertex {}: it is not inside",
                ray.number, ray.vertex
            ),
        }
    }
}
