//! An audit as one HTML file: tables, and both meshes in a 3D view with all violations. It needs no network.
//!
//! The tables are text made here; the view is WebGL 2 in plain JavaScript (`assets/`), which reads positions as base64
//! arrays and exact numbers as the texts that they are. Every text from outside, file names above all, is escaped, and a
//! content security policy lets only the script and the style of this file run. Nothing here decides anything, and
//! positions in the view are rounded.

mod carried;
mod escape;
mod findings;
mod frame;
mod page;
mod scene;
mod summary;
#[cfg(test)]
mod tests;

use crate::audit::AuditReport;
use crate::mesh::TriMesh;
use crate::shell::Shell;
use scene::Scene;

/// The page of an audit of `meshes` (A and B, as they were audited).
///
/// `shells` are those of the tries, by the name in [`AttemptReport::shell`](crate::audit::report::AttemptReport::shell);
/// a try whose shell is not among them is shown without. The size is about 33 bytes a mesh vertex and 17 a triangle;
/// exact texts of violations are kept up to some megabytes (the page says how many are left out; the JSON has all).
#[must_use]
pub fn html(report: &AuditReport, meshes: [&TriMesh; 2], shells: &[(String, Shell)]) -> String {
    let scene = Scene::new(report, meshes, shells);
    page::fill(&summary::title(report), &summary::summary(report), &scene)
}
