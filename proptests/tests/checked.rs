//! Every certificate and witness of random cases is accepted by the independent checker, and no certificate is accepted
//! for the opposite verdict.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use homeo::certify::{Claim, Options, Outcome, Silent, certify};
use homeo_proptests::Case;
use homeo_proptests::campaign::{certified, run};
use homeo_proptests::judged::{inputs, verdicts};

fn accepted(outcome: &Outcome, case: &Case) -> Result<BTreeMap<String, bool>, String> {
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(case));
    if answer.exit != 0 {
        return Err(format!(
            "rejected: {} {} : {}\n{}",
            answer.status, answer.code, answer.message, outcome.certificate
        ));
    }
    let read: BTreeMap<String, bool> = answer.claims.into_iter().collect();
    if read != verdicts(outcome) {
        return Err(format!("other verdicts: {read:?}"));
    }
    Ok(read)
}

/// The certificate with some verdict lines turned round.
fn turned(certificate: &str, which: usize) -> String {
    let mut out = String::new();
    let mut k = 0;
    for line in certificate.lines() {
        let mut line = line.to_owned();
        if line.starts_with("claim ") {
            if which >> k & 1 == 1 {
                line = match line.strip_suffix("certified") {
                    Some(start) => format!("{start}refuted"),
                    None => line.replace("refuted", "certified"),
                };
            }
            k += 1;
        }
        out += &line;
        out.push('\n');
    }
    out
}

#[test]
fn the_checker_accepts_and_never_the_opposite() {
    run(20, |recipe, case| {
        let Some(outcome) = certified(case, false)? else { return Ok(vec!["refused".into()]) };
        let truth = accepted(&outcome, case)?;
        let files = inputs(case);
        let lines = truth.len();
        // Each line alone, all of them, and the pairs that belong together.
        let mut masks: Vec<usize> = (0..lines).map(|k| 1 << k).collect();
        masks.extend([(1 << lines) - 1, 0b110, usize::from(recipe.order) % (1 << lines)]);
        for mask in masks.into_iter().filter(|m| *m != 0) {
            let forged = turned(&outcome.certificate, mask);
            let answer = homeo_certs::check(forged.as_bytes(), &files);
            if answer.exit == 0 {
                return Err(format!("accepted with other verdicts:\n{forged}"));
            }
        }
        Ok(truth.iter().map(|(k, v)| format!("{k} {v}")).collect())
    });
}

#[test]
fn each_claim_alone_is_checked() {
    run(8, |recipe, case| {
        let claim = Claim::ALL[usize::from(recipe.order) % 6];
        let options = Options { claims: vec![claim], order: case.vertex_order() };
        let Ok(outcome) = certify(&case.shell, Some(&case.mesh), &options, &Silent) else {
            return Ok(vec!["refused".into()]);
        };
        accepted(&outcome, case)?;
        Ok(vec![claim.to_string()])
    });
}
