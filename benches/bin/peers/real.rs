//! Certify and check on real shells.

use homeo::certify::Claim;
use homeo::shell::hdf5;
use homeo_benches::generate::Generated;
use homeo_benches::real;
use homeo_benches::run::{checker_inputs, on_one_thread, whole};
use homeo_benches::table::{Table, median};

use crate::error::{PeersError, Res};
use crate::plan::Plan;
use crate::report::{Asked, Report, Row};
use crate::whole::checked;

/// Real files to certify and check: before simplification, and after it.
const REAL: [&str; 4] = ["bunny.off.h5.init", "c_homer.obj.h5.init", "bunny.off.h5", "fandisk.off.h5"];

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let paths: Vec<_> =
        real::shells().into_iter().filter(|p| REAL.contains(&real::name(p).as_str())).collect();
    if paths.is_empty() {
        let reason = format!("no shells in {}", real::data().display());
        eprintln!("SKIPPED: certify and check on real shells: {reason}");
        report.row(Row::absent(
            "check, real shells",
            "certify",
            Some(Asked::AtLeast(1.0)),
            "skipped: no data",
        ));
        return Ok(());
    }
    let columns =
        ["shell", "mesh triangles", "prisms", "certify s", "check s", "certificate MB", "parts of certify"];
    let mut table = Table::new(&columns);
    for path in paths {
        let file = hdf5::read(&path)?;
        let name = real::name(&path);
        let Some(mesh) = file.mesh else {
            let text = "a shell file without a mesh".to_owned();
            return Err(PeersError::Program { program: "hdf5", argument: name, text });
        };
        let input = Generated { shell: file.shell, mesh };
        let documents = checker_inputs(&input)?;
        let (mut certify, mut check, mut last) = (Vec::new(), Vec::new(), None);
        for _ in 0..plan.options.few_rounds() {
            let (outcome, seconds) = on_one_thread(|| whole(&input))??;
            certify.push(seconds);
            check.push(checked(1, &outcome, &documents)?);
            last = Some(outcome);
        }
        report.row(Row::ratio(
            &format!("check, {name}"),
            "certify",
            Some(Asked::AtLeast(1.0)),
            &certify,
            &check,
        ));
        let Some(outcome) = last else { continue };
        let parts = outcome.claims.iter().filter(|c| c.claim != Claim::Bijection);
        let parts: Vec<String> = parts.map(|c| format!("{} {:.2}", c.claim.name(), c.seconds)).collect();
        table.row(vec![
            name,
            input.mesh.faces.len().to_string(),
            input.shell.faces.len().to_string(),
            format!("{:.2}", median(&certify)),
            format!("{:.2}", median(&check)),
            format!("{:.1}", outcome.certificate.len() as f64 / 1e6),
            parts.join(", "),
        ]);
    }
    report.detail("Real shells", "One thread; medians, and the parts of the last round.", &table);
    Ok(())
}
