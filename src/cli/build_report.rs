//! What `homeo build` says: its JSON, and the words made from that.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use super::CliError;
use super::build::{Args, Built};
use super::output::one_line;
use crate::certify::Outcome;
use crate::construct::direction::Direction;
use crate::construct::measure::{self, Distance, Distribution};
use crate::construct::optimise::Counts;
use crate::mesh::{self, Connectivity, TriMesh};
use crate::report::{
    BuildReport, DistanceReport, InputReport, OptionsReport, OutputReport, Parts, StageSeconds,
    ThicknessReport, Vertices, claims,
};

/// All that was found out.
pub(super) struct Facts<'a> {
    pub(super) args: &'a Args,
    /// The mesh file.
    pub(super) file: String,
    pub(super) notes: Vec<String>,
    pub(super) mesh: Option<&'a TriMesh>,
    pub(super) built: &'a Built,
    pub(super) outcome: Option<&'a Outcome>,
    pub(super) distance: Option<&'a Distance>,
    pub(super) certificate: &'a Path,
    pub(super) stages: Vec<(&'static str, f64)>,
    pub(super) parts: Parts,
}

/// The report.
pub(super) fn report(facts: &Facts<'_>) -> Result<BuildReport, CliError> {
    let none = TriMesh::default();
    let mesh = facts.mesh.unwrap_or(&none);
    let (built, first) = (facts.built, &facts.built.first);
    let boundary = on_boundary(mesh)?;
    let frozen = first.pinched.iter().zip(&boundary).map(|(p, b)| *p || *b);
    let input = InputReport::new(mesh, &mesh::mesh_info(mesh)?, facts.file.clone());
    let output = OutputReport::new(&built.shell, facts.args.output.display().to_string());
    let unit = input.longest_box_edge;
    let is = |wanted: fn(&Direction) -> bool| Vertices::flagged(first.directions.iter().map(wanted));
    Ok(BuildReport {
        prisms: built.shell.faces.len(),
        seconds: facts.parts.build,
        stages: facts.stages.iter().map(|&(stage, seconds)| StageSeconds { stage, seconds }).collect(),
        parts: facts.parts,
        mesh: input,
        singular: is(|d| matches!(d, Direction::Singular(_))),
        undecided: is(|d| matches!(d, Direction::Undecided)),
        pinched: Vertices::flagged(first.pinched.iter().copied()),
        frozen: Vertices::flagged(frozen),
        boundary: Vertices::flagged(boundary.iter().copied()),
        initial_prisms: first.shell.faces.len(),
        beveled: first.beveled,
        thickness: ThicknessReport::new(&built.shell, unit),
        energy: measure::energy(&built.shell),
        operations: built.counts.as_ref().map(operations),
        stopped: built.stopped,
        options: options(facts.args, mesh)?,
        claims: claims(facts.outcome, output.shell.clone()),
        shell: output,
        certificate: facts.outcome.map(|_| facts.certificate.display().to_string()),
        checked: facts.outcome.map(|_| "valid"),
        distance: facts.distance.map(|d| DistanceReport::new(d, unit)),
        peak_mib: peak_memory(),
        notes: facts.notes.clone(),
    })
}

fn on_boundary(mesh: &TriMesh) -> Result<Vec<bool>, CliError> {
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces)?;
    let mut out = vec![false; mesh.vertices.len()];
    for v in connectivity.boundary().flat_map(|side| connectivity.ends(side)) {
        out[v as usize] = true;
    }
    Ok(out)
}

fn operations(counts: &Counts) -> BTreeMap<&'static str, u64> {
    [
        ("collapses", counts.collapses),
        ("flips", counts.flips),
        ("splits", counts.splits),
        ("moves", counts.moves),
        ("rounds", counts.rounds),
    ]
    .into()
}

fn options(args: &Args, mesh: &TriMesh) -> Result<OptionsReport, CliError> {
    let used = args.options()?;
    let mut out = OptionsReport {
        thickness: None,
        thickness_absolute: 0.0,
        angle: used.max_angle_degrees,
        energy: used.max_energy,
        polish: used.polish,
        time_limit: args.time_limit,
        initial: args.initial,
    };
    out.set_thickness(used.thickness, mesh);
    Ok(out)
}

/// The largest resident memory of this process so far, in MiB, where the system says it.
fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok().map(|kib| kib / 1024.0)
}

/// The report in words.
pub(super) fn words(report: &BuildReport) -> String {
    let mut out = String::new();
    for note in &report.notes {
        let _ = writeln!(out, "note: {}", one_line(note));
    }
    let early = if report.stopped { "; stopped early: the optimisation was not finished" } else { "" };
    let _ = writeln!(
        out,
        "{} prisms around {} triangles in {:.1} s; initial shell of {} prisms, {} triangles beveled, {} vertices \
         pinched{early}",
        report.prisms,
        report.mesh.mesh.triangles,
        report.seconds,
        report.initial_prisms,
        report.beveled,
        report.pinched.count
    );
    thickness(report, &mut out);
    if let Some(energy) = &report.energy {
        let _ = writeln!(
            out,
            "Energy:      mean {:.2}, largest {:.2} (2 is equilateral)",
            energy.mean, energy.max
        );
    }
    if let Some(distance) = &report.distance {
        let [x, y, z] = distance.point;
        let _ = writeln!(
            out,
            "Distance:    from middle surface to mesh at least {} and at most {} (share {:.3e}); prism {} near ({x}, {y}, {z})",
            distance.at_least, distance.at_most, distance.at_most_share, distance.prism
        );
    }
    files(report, &mut out);
    out
}

fn thickness(report: &BuildReport, out: &mut String) {
    let shares = [("below", &report.thickness.bottom_share), ("above", &report.thickness.top_share)];
    for (k, (side, share)) in shares.into_iter().enumerate() {
        let Some(Distribution { min, mean, max, .. }) = share else { continue };
        let head = if k == 0 { "Thickness:" } else { "" };
        let _ = writeln!(
            out,
            "{head:12} {side} least {min:.2e}, mean {mean:.4}, most {max:.4} of the longest box edge"
        );
    }
}

fn files(report: &BuildReport, out: &mut String) {
    let shell: Vec<String> = report.shell.shell.files.iter().map(|f| one_line(f)).collect();
    let shell = shell.join(" ");
    let _ = writeln!(out, "Shell:       {shell}");
    if let Some(certificate) = &report.certificate {
        let certificate = one_line(certificate);
        let certified: Vec<&str> =
            report.claims.iter().filter(|c| c.verdict == "certified").map(|c| c.claim).collect();
        let _ = writeln!(
            out,
            "Certified:   {}\nChecked:     {}\nCertificate: {certificate}\nCheck it:    homeo-check {certificate} {shell}",
            certified.join(", "),
            report.checked.unwrap_or("no")
        );
    }
}
