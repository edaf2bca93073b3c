//! Random lies about random small shells, told to checkers.

use std::collections::BTreeMap;

use homeo::certify::{Claim, Options, Silent, certify};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use super::change::{change, facts};
use super::{Flaw, Judge, Text};
use crate::campaign::{Tally, compare};
use crate::judged::{inputs, verdicts};
use crate::meshes::Random;
use crate::recipe::{Case, recipes};

/// Changes that are tried on one certificate.
const CHANGES: usize = 60;

/// What a checker said: `None` where it rejects, else the claims.
pub type Answer = Option<Vec<(String, bool)>>;

/// Asks every checker about a certificate and its input files.
pub type Checkers<'c> = &'c mut dyn FnMut(&str, &[Vec<u8>]) -> Vec<Answer>;

/// Verdicts by the names of certificates, and the certificate.
type Honest = (BTreeMap<String, bool>, String);

/// Tells lies until `wanted` of them have been shown to be false, and asks all checkers about each; they get the
/// certificate and its input files. Returns how often what happened.
///
/// # Errors
/// A lie that is accepted, an honest certificate that is rejected or called false, checkers that disagree; a changed
/// certificate that is accepted although it reads as nothing.
///
/// # Panics
/// As the oracle.
pub fn run(wanted: u64, seed: u64, checkers: Checkers<'_>) -> Result<Tally, String> {
    let bytes: Vec<u8> = seed.to_le_bytes().repeat(4);
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let mut random = Random(seed);
    let (mut tally, mut foreign) = (Tally::new(), Vec::new());
    while tally.get("lies").copied().unwrap_or(0) < wanted {
        let recipe = recipes().new_tree(&mut runner).map_err(|e| e.to_string())?.current();
        // The octahedron and the tori are slow.
        if (7..10).contains(&recipe.shape) {
            continue;
        }
        let case = recipe.build();
        let Some((claims, honest)) = honest(&case, recipe.order)? else { continue };
        let told = tell(&case, &claims, &honest, &foreign, &mut random, checkers, &mut tally);
        told.map_err(|e| format!("{e}\nabout {case:#?}\nthe honest one is\n{honest}"))?;
        *tally.entry("certificates".into()).or_default() += 1;
        foreign.extend(facts(&honest));
        let excess = foreign.len().saturating_sub(500);
        foreign.drain(..excess);
    }
    Ok(tally)
}

/// The certificate of a case, and its verdicts, confirmed by the oracle; `None` where there is none.
fn honest(case: &Case, choice: u16) -> Result<Option<Honest>, String> {
    let notes = compare(case)?;
    if ["refused", "branched", "ambiguous"].iter().any(|w| notes.iter().any(|n| n == w)) {
        return Ok(None);
    }
    let claims = match choice % 8 {
        0 => vec![Claim::DisjointPrisms],
        1 => vec![Claim::Bijection],
        2 => vec![Claim::Positivity],
        3 => vec![Claim::Disjoint],
        _ => Claim::STANDARD.to_vec(),
    };
    let alone = claims == [Claim::DisjointPrisms];
    let options = Options { claims, order: case.vertex_order() };
    let outcome = certify(&case.shell, Some(&case.mesh), &options, &Silent).map_err(|e| e.to_string())?;
    let claims = verdicts(&outcome);
    if alone {
        let world = crate::oracle::World::new(&case.shell, &case.mesh);
        let truth = world.injective(&case.rank());
        if claims["disjoint-prisms"] != truth {
            return Err(format!("disjoint-prisms: the oracle says {truth}\n{}", outcome.certificate));
        }
    }
    Ok(Some((claims, outcome.certificate)))
}

fn tell(
    case: &Case,
    claims: &BTreeMap<String, bool>,
    honest: &str,
    foreign: &[String],
    random: &mut Random,
    checkers: Checkers<'_>,
    tally: &mut Tally,
) -> Result<(), String> {
    let files = inputs(case);
    let mut judge = Judge::new(case, claims.clone());
    let parts = Text::read(honest).map_err(|e| format!("{e:?}"))?;
    judge.judge(&parts, None).map_err(|e| format!("an honest certificate is called {e:?}"))?;
    let wanted: Vec<(String, bool)> = parts.claims.iter().map(|c| (c.0.into(), c.1 == "certified")).collect();
    if checkers(honest, &files).iter().any(|a| a.as_ref() != Some(&wanted)) {
        return Err("an honest certificate is rejected".into());
    }
    let mut count = |what: String| *tally.entry(what).or_default() += 1;
    for _ in 0..CHANGES {
        let Some((kind, text)) = change(honest, foreign, random) else { continue };
        let read = Text::read(&text);
        let judged = read.and_then(|t| judge.judge(&t, Some(&parts)));
        let answers = checkers(&text, &files);
        let accepted = answers.iter().filter(|a| a.is_some()).count();
        if accepted != 0 && accepted != answers.len() {
            return Err(format!("checkers disagree: {answers:?}, {judged:?}\n{text}"));
        }
        match judged {
            Err(Flaw::False(why)) if accepted == 0 => {
                count("lies".into());
                count(format!("false: {why}"));
                count(format!("by {kind}"));
            }
            Err(flaw) if accepted > 0 => return Err(format!("accepted, but {flaw:?}\n{text}")),
            Err(_) => count("no certificate".into()),
            Ok(()) if accepted > 0 => count("true, accepted".into()),
            Ok(()) => count("not disproved, rejected".into()),
        }
    }
    Ok(())
}
