//! The JSON form of a shell that was built; its schema is `schema/build.schema.json`.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{CertifyReport, ClaimReport, MeshReport, ShellReport};
use crate::certify::{Claim, Outcome, VertexOrder, mesh_hash, shell_hash};
use crate::construct::Thickness;
use crate::construct::measure::{self, Distance, Distribution};
use crate::mesh::{MeshInfo, TriMesh};
use crate::number::Rational;
use crate::shell::{Shell, Slab};

/// A shell that was built, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct BuildReport {
    /// Number of prisms.
    pub prisms: usize,
    /// Wall-clock seconds of building alone.
    pub seconds: f64,
    /// These seconds by stage, in the order in which the stages began.
    pub stages: Vec<StageSeconds>,
    /// Wall-clock seconds of everything that was done.
    pub parts: Parts,
    /// The mesh.
    pub mesh: InputReport,
    /// The shell.
    pub shell: OutputReport,
    /// Vertices of the mesh that have no direction, which is proved.
    pub singular: Vertices,
    /// Vertices of the mesh for which neither a direction nor a proof that there is none was found.
    pub undecided: Vertices,
    /// Vertices of the mesh without thickness: the two kinds above, and those where every thickness collides.
    pub pinched: Vertices,
    /// Vertices of the mesh on its boundary.
    pub boundary: Vertices,
    /// Vertices of the mesh that stay where they are: pinched or on the boundary.
    pub frozen: Vertices,
    /// Number of prisms before optimisation.
    pub initial_prisms: usize,
    /// How many triangles were beveled.
    pub beveled: usize,
    /// How thick the shell is.
    pub thickness: ThicknessReport,
    /// MIPS energies of the middle triangles; 2 is an equilateral one.
    pub energy: Option<Distribution>,
    /// Operations of the optimisation by name; `null` without optimisation.
    pub operations: Option<BTreeMap<&'static str, u64>>,
    /// Did Ctrl-C or the time limit end the optimisation early?
    pub stopped: bool,
    /// The options.
    pub options: OptionsReport,
    /// The claims of [`Claim::STANDARD`], in this order, then `disjoint-prisms` with `--no-overlap`.
    pub claims: Vec<ClaimReport>,
    /// The certificate file; `null` if none was written.
    pub certificate: Option<String>,
    /// What the independent checker answered about the files as written; `null` if it was not asked.
    pub checked: Option<&'static str>,
    /// The largest distance from middle surface to mesh; `null` if it was not asked for.
    pub distance: Option<DistanceReport>,
    /// The largest resident memory of the whole run, in MiB; `null` where the system does not say.
    pub peak_mib: Option<f64>,
    /// Remarks of the readers.
    pub notes: Vec<String>,
}

/// Seconds of one stage.
#[derive(Clone, Debug, Serialize)]
pub struct StageSeconds {
    /// Its name.
    pub stage: &'static str,
    /// Wall-clock seconds, of all its turns.
    pub seconds: f64,
}

/// Wall-clock seconds; `null` for what was not done.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Parts {
    /// Reading the mesh.
    pub read: f64,
    /// Building.
    pub build: f64,
    /// Certifying.
    pub certify: Option<f64>,
    /// Checking the certificate.
    pub check: Option<f64>,
    /// Enclosing the distance.
    pub distance: Option<f64>,
}

/// Some vertices of the mesh.
#[derive(Clone, Debug, Serialize)]
pub struct Vertices {
    /// How many.
    pub count: usize,
    /// Their ids, ascending.
    pub ids: Vec<u32>,
}

/// The mesh that was built around.
#[derive(Clone, Debug, Serialize)]
pub struct InputReport {
    /// File and size.
    #[serde(flatten)]
    pub mesh: MeshReport,
    /// Sets of triangles joined across edges.
    pub components: usize,
    /// Number of boundary loops.
    pub boundary_loops: usize,
    /// Total genus.
    pub genus: Option<u64>,
    /// The unit of shares.
    pub longest_box_edge: f64,
    /// As in certificates.
    pub sha256: String,
}

/// The shell that was built.
#[derive(Clone, Debug, Serialize)]
pub struct OutputReport {
    /// File and size.
    #[serde(flatten)]
    pub shell: ShellReport,
    /// As in certificates.
    pub sha256: String,
}

/// How thick the halves are, pinched vertices (which have no thickness) left out; `null` where all are pinched.
#[derive(Clone, Debug, Serialize)]
pub struct ThicknessReport {
    /// Pinched vertices of the shell.
    pub excluded_pinched: usize,
    /// From bottom to middle, in the mesh's units.
    pub bottom: Option<Distribution>,
    /// From middle to top, in the mesh's units.
    pub top: Option<Distribution>,
    /// `bottom` as shares of the longest edge of the mesh's bounding box.
    pub bottom_share: Option<Distribution>,
    /// `top` as shares of the longest edge of the mesh's bounding box.
    pub top_share: Option<Distribution>,
}

/// What was asked for.
#[derive(Clone, Debug, Serialize)]
pub struct OptionsReport {
    /// `--thickness`; `null` with `--thickness-absolute`.
    pub thickness: Option<f64>,
    /// The largest thickness of a half in the mesh's units, however it was given.
    pub thickness_absolute: f64,
    /// `--angle`, in degrees.
    pub angle: f64,
    /// `--energy`.
    pub energy: f64,
    /// `--polish`.
    pub polish: usize,
    /// `--time-limit`, in seconds.
    pub time_limit: Option<u64>,
    /// `--initial`.
    pub initial: bool,
}

/// An enclosure of the largest distance from a point of the middle surface to the mesh.
#[derive(Clone, Debug, Serialize)]
pub struct DistanceReport {
    /// A lower bound, attained at the witness (rounded down).
    pub at_least: f64,
    /// An upper bound (rounded up).
    pub at_most: f64,
    /// The upper bound as a share of the longest edge of the mesh's bounding box (rounded).
    pub at_most_share: f64,
    /// The exact square of the witness's distance, a fraction.
    pub squared_at_least: String,
    /// The exact square of the upper bound, a fraction.
    pub squared_at_most: String,
    /// The witness's prism.
    pub prism: u32,
    /// The witness's weights on the prism's middle triangle, fractions.
    pub weights: [String; 3],
    /// The witness, rounded; the weights give it exactly.
    pub point: [f64; 3],
    /// A triangle of the mesh at that distance.
    pub triangle: u32,
}

impl Vertices {
    /// Those for which the flag is set.
    #[must_use]
    pub fn flagged(flags: impl IntoIterator<Item = bool>) -> Self {
        let ids: Vec<u32> = (0u32..).zip(flags).filter(|(_, flag)| *flag).map(|(v, _)| v).collect();
        Self { count: ids.len(), ids }
    }
}

impl InputReport {
    /// The report about a mesh read from this file.
    #[must_use]
    pub fn new(mesh: &TriMesh, info: &MeshInfo, file: String) -> Self {
        Self {
            mesh: MeshReport::new(mesh, file),
            components: info.components,
            boundary_loops: info.boundary_loops,
            genus: info.genus,
            longest_box_edge: measure::longest_box_edge(mesh),
            sha256: mesh_hash(mesh),
        }
    }
}

impl OutputReport {
    /// The report about a shell written to this file.
    #[must_use]
    pub fn new(shell: &Shell, file: String) -> Self {
        Self { shell: ShellReport::new(shell, vec![file]), sha256: shell_hash(shell) }
    }
}

impl ThicknessReport {
    /// Of a shell; `unit` is the longest edge of the mesh's bounding box.
    #[must_use]
    pub fn new(shell: &Shell, unit: f64) -> Self {
        let [bottom, top] = Slab::BOTH.map(|slab| measure::thickness(shell, slab));
        // A division, not a factor: the inverse of a small unit may overflow.
        let share = |d: &Option<Distribution>| d.as_ref().map(|d| d.map(|x| x / unit));
        Self {
            excluded_pinched: shell.pinched_vertices().len(),
            bottom_share: share(&bottom),
            top_share: share(&top),
            bottom,
            top,
        }
    }

    /// The least and the mean share of all halves.
    #[must_use]
    pub fn least_and_mean_share(&self) -> Option<[f64; 2]> {
        let (b, t) = (self.bottom_share.as_ref()?, self.top_share.as_ref()?);
        let [n, m] = [b, t].map(|d| d.count as f64);
        Some([b.min.min(t.min), (b.mean * n + t.mean * m) / (n + m)])
    }
}

impl OptionsReport {
    /// Sets both forms of the thickness for a mesh.
    pub fn set_thickness(&mut self, thickness: Thickness, mesh: &TriMesh) {
        self.thickness = match thickness {
            Thickness::Share(share) => Some(share),
            Thickness::Absolute(_) => None,
        };
        self.thickness_absolute = thickness.length(mesh);
    }
}

impl DistanceReport {
    /// The report; `unit` is the longest edge of the mesh's bounding box.
    #[must_use]
    pub fn new(distance: &Distance, unit: f64) -> Self {
        let witness = &distance.witness;
        Self {
            at_least: distance.at_least,
            at_most: distance.at_most,
            at_most_share: distance.at_most / unit,
            squared_at_least: distance.squared_at_least.to_text(),
            squared_at_most: distance.squared_at_most.to_text(),
            prism: witness.prism,
            weights: [0, 1, 2].map(|i| witness.weights[i].to_text()),
            point: [0, 1, 2].map(|i| Rational::to_f64(&witness.point[i])),
            triangle: witness.triangle,
        }
    }
}

/// The claims of an outcome; all `not-run` without one.
#[must_use]
pub fn claims(outcome: Option<&Outcome>, shell: ShellReport) -> Vec<ClaimReport> {
    let results = outcome.map_or(&[][..], |outcome| &outcome.claims);
    CertifyReport::new(results, &Claim::ALL, &VertexOrder::Id, shell, None).claims
}
