//! How many decisions each stage of the predicates took in a certificate, and what they cost.

use std::hint::black_box;
use std::time::Instant;

use homeo::certify::{Claim, ClaimResult};
use homeo::predicate::{Stage, orient3d_exact, orient3d_staged};
use homeo_benches::generate::{initial, simplified};
use homeo_benches::quads::{Kind, Quad, quads};
use homeo_benches::run::{on_one_thread, whole};
use homeo_benches::table::{Table, median};
use serde_json::json;

use crate::error::Res;
use crate::plan::Plan;
use crate::report::{Report, duration};

/// The counts of a claim, in the order of [`Stage`].
const KEYS: [&str; 3] = ["decided_by_filter", "decided_by_fixed_width", "decided_by_big_integer"];

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let costs = costs(plan);
    let mut table =
        Table::new(&["input", "claim", "s", "share of certify", "filter", "fixed width", "big integers"]);
    let inputs = [
        ("before simplification", initial(plan.options.size(80, 20))),
        ("after simplification", simplified(plan.options.size(20, 6), 2)),
    ];
    let mut data = Vec::new();
    for (name, input) in &inputs {
        let (outcome, seconds) = on_one_thread(|| whole(input))??;
        let name = format!("{name}, {} triangles", input.mesh.faces.len());
        let mut rest = seconds;
        for claim in outcome.claims.iter().filter(|c| c.claim != Claim::Bijection) {
            rest -= claim.seconds;
            let counts = counts(claim);
            let share = format!("{:.0} %", 100.0 * claim.seconds / seconds);
            let cells = [name.clone(), claim.claim.name().to_owned(), format!("{:.3}", claim.seconds), share];
            let stages = (0..3).map(|k| match counts {
                Some(counts) => {
                    let part = counts[k] as f64 * costs[k] / claim.seconds;
                    format!("{} ({:.0} %)", counts[k], 100.0 * part.min(1.0))
                }
                None => "-".to_owned(),
            });
            table.row(cells.into_iter().chain(stages).collect());
            data.push(json!({ "input": name, "claim": claim.claim.name(), "seconds": claim.seconds, "decisions": counts }));
        }
        let share = format!("{:.0} %", 100.0 * rest / seconds);
        table.row(vec![
            name,
            "input conditions, connectivity, writing".to_owned(),
            format!("{rest:.3}"),
            share,
        ]);
    }
    let [filter, fixed, big] = costs.map(duration);
    let text = format!(
        "Decisions by stage, and in brackets their share of the claim's time if each costs what one call of orient3d does that \
         ends in this stage: {filter} in the filter (random points), {fixed} in fixed width (exactly coplanar), {big} in big \
         integers. Blocks of vector instructions cost less than that, so that a share in brackets is an upper estimate. Of \
         `i2` the dots are counted, not the planes that separate. What two threads decide twice counts once."
    );
    report.detail("Cost by stage", &text, &table);
    report.data("stages", json!({ "seconds_a_call": costs, "claims": data }));
    Ok(())
}

fn counts(claim: &ClaimResult) -> Option<[u64; 3]> {
    let of = |key: &str| claim.counts.iter().find(|c| c.what == key).map(|c| c.count);
    let [filter, fixed, big] = KEYS.map(of);
    Some([filter?, fixed?, big?])
}

/// Seconds of one call of orient3d that ends in each stage.
fn costs(plan: &Plan) -> [f64; 3] {
    let count = plan.options.size(50_000, 2_000);
    let timed = |inputs: &[Quad], call: &dyn Fn(&Quad)| {
        let round = || {
            let start = Instant::now();
            inputs.iter().for_each(|q| call(black_box(q)));
            start.elapsed().as_secs_f64() / inputs.len().max(1) as f64
        };
        median(&(0..plan.options.rounds).map(|_| round()).collect::<Vec<_>>())
    };
    let staged = |stage: Stage, kind: Kind| {
        let ends = |q: &Quad| orient3d_staged(&q[0], &q[1], &q[2], &q[3]).1 == stage;
        let inputs: Vec<Quad> = quads(kind, count).into_iter().filter(ends).collect();
        timed(&inputs, &|q| {
            black_box(orient3d_staged(&q[0], &q[1], &q[2], &q[3]));
        })
    };
    let big = timed(&quads(Kind::Coplanar, count), &|q| {
        black_box(orient3d_exact(&q[0], &q[1], &q[2], &q[3]));
    });
    [staged(Stage::Filter, Kind::Random), staged(Stage::Fixed, Kind::Coplanar), big]
}
