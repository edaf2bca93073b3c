//! The small shells of the corpus get the verdicts that they were made for.

mod common;

use homeo::certify::{Claim, Silent, Verdict, certify};

#[test]
fn every_case_gets_its_verdicts() {
    let mut wrong = Vec::new();
    for case in common::cases() {
        let outcome = match certify(&case.shell, Some(&case.mesh), &case.options, &Silent) {
            Ok(outcome) => outcome,
            Err(error) => {
                wrong.push(format!("{}: {error}", case.name));
                continue;
            }
        };
        let refuted = outcome.claims.iter().filter(|c| c.verdict == Verdict::Refuted);
        let refuted: Vec<Claim> = refuted.map(|c| c.claim).collect();
        if refuted != case.refuted {
            wrong.push(format!("{}: refuted {refuted:?}, expected {:?}", case.name, case.refuted));
        }
        for shown in case.shows {
            if !outcome.certificate.lines().any(|line| line.starts_with(shown)) {
                wrong.push(format!("{}: no line begins {shown:?}", case.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
