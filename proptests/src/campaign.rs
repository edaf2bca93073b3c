//! Runs random cases against the clock, and compares the certifier's verdicts with the oracle's.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use std::{env, thread};

use homeo::certify::{CertifyError, Claim, Options, Outcome, Silent, Verdict, certify};
use proptest::test_runner::{Config, TestCaseError, TestError, TestRunner};

use crate::oracle::World;
use crate::oracle::lift::{Section, failing_order, section};
use crate::recipe::{Case, Recipe, recipes};

/// What happened how often.
pub type Tally = BTreeMap<String, u64>;

/// Cases between two looks at the clock.
const BATCH: u64 = 64;

/// Runs a property on random recipes: on `HOMEO_CASES` many when that is set, by all cores and with a line every now and
/// then, else for `seconds` on one core (other tests run beside it). Ends at the first failure.
///
/// # Panics
/// With the smallest recipe found that fails, and its case; if nearly all cases are noted as refused.
pub fn run(seconds: u64, property: impl Fn(&Recipe, &Case) -> Result<Vec<String>, String> + Sync) {
    let wanted: Option<u64> =
        env::var("HOMEO_CASES").ok().map(|n| n.parse().expect("HOMEO_CASES is a number"));
    let deadline = wanted.is_none().then(|| Instant::now() + Duration::from_secs(seconds));
    let workers = wanted.map_or(1, |_| thread::available_parallelism().map_or(1, NonZero::get));
    let (begun, failed) = (AtomicU64::new(0), AtomicBool::new(false));
    let all = Mutex::new((0, Tally::new(), Vec::new()));
    let over = || failed.load(Ordering::Relaxed) || deadline.is_some_and(|d| Instant::now() > d);
    let work = || {
        while !over() && begun.fetch_add(BATCH, Ordering::Relaxed) < wanted.unwrap_or(u64::MAX) {
            let (counted, tally, failure) = batch(&property, &over);
            failed.fetch_or(failure.is_some(), Ordering::Relaxed);
            let mut all = all.lock().expect("nothing panics with the lock");
            all.0 += counted;
            tally.into_iter().for_each(|(note, n)| *all.1.entry(note).or_default() += n);
            all.2.extend(failure);
            if wanted.is_some() && all.0 % 16_384 < counted {
                eprintln!("{} cases", all.0);
            }
        }
    };
    thread::scope(|scope| (0..workers).for_each(|_| drop(scope.spawn(work))));
    let (counted, tally, failures) = all.into_inner().expect("nothing panics with the lock");
    eprintln!("{counted} cases: {tally:?}");
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    assert!(is_telling(counted, &tally), "nearly all cases were refused: {counted} cases, {tally:?}");
}

/// A few cases, what happened to them, and the smallest that fails if one does. A runner counts its successes over all its
/// runs: a new one for each batch.
fn batch(
    property: &impl Fn(&Recipe, &Case) -> Result<Vec<String>, String>,
    over: &impl Fn() -> bool,
) -> (u64, Tally, Option<String>) {
    let cases = u32::try_from(BATCH).expect("a small number");
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
    let done = std::cell::RefCell::new((0, Tally::new()));
    let result = TestRunner::new(config).run(&recipes(), |recipe| {
        if over() {
            return Ok(());
        }
        done.borrow_mut().0 += 1;
        let notes = property(&recipe, &recipe.build()).map_err(TestCaseError::fail)?;
        let tally = &mut done.borrow_mut().1;
        notes.into_iter().for_each(|n| *tally.entry(n).or_default() += 1);
        Ok(())
    });
    let failure = result.err().map(|error| match error {
        TestError::Fail(reason, recipe) => format!("{reason}\n{recipe:?}\n{:#?}", recipe.build()),
        TestError::Abort(reason) => reason.to_string(),
    });
    let (counted, tally) = done.into_inner();
    (counted, tally, failure)
}

/// Was the property asked about more than a few of the cases? All inputs refused would satisfy any.
fn is_telling(counted: u64, tally: &Tally) -> bool {
    let refused: u64 = ["refused", "branched"].iter().filter_map(|note| tally.get(*note)).sum();
    counted < 100 || refused < counted - counted / 10
}

/// Certifies all claims; `Ok(None)` where the input is refused.
///
/// # Errors
/// An internal contradiction, or a branched lift although C1 holds.
pub fn certified(case: &Case, positive: bool) -> Result<Option<Outcome>, String> {
    let options = Options { claims: Claim::STANDARD.to_vec(), order: case.vertex_order() };
    match certify(&case.shell, Some(&case.mesh), &options, &Silent) {
        Ok(outcome) => Ok(Some(outcome)),
        Err(CertifyError::Shell(_) | CertifyError::Mesh(_)) => Ok(None),
        Err(CertifyError::Branched { .. } | CertifyError::FlatAtPinch { .. }) if !positive => Ok(None),
        // Shells that overlap themselves: no verdict, by name.
        Err(CertifyError::SeveralLifts { .. }) => Ok(None),
        Err(e) => Err(format!("no verdict: {e}")),
    }
}

/// The verdict on a claim.
#[must_use]
pub fn holds(outcome: &Outcome, claim: Claim) -> bool {
    outcome.claims.iter().any(|c| c.claim == claim && c.verdict == Verdict::Certified)
}

/// The orders that the oracle tries for C3 at most: all of them with up to five vertices, some for the tori.
fn orders(case: &Case) -> usize {
    if case.shell.faces.len() <= 8 { 120 } else { 8 }
}

/// The order (ranks) of the block `no-order`, if the certificate has one.
fn first_vertices(outcome: &Outcome, case: &Case) -> Option<Vec<usize>> {
    let line = outcome.certificate.lines().find_map(|l| l.strip_prefix("first "))?;
    let mut order: Vec<u32> = line.split(' ').map(|v| v.parse().unwrap()).collect();
    let rest: Vec<u32> = case.order.iter().copied().filter(|v| !order.contains(v)).collect();
    order.extend(rest);
    Some(Case { order, ..case.clone() }.rank())
}

/// Compares all verdicts with the oracle's.
///
/// # Errors
/// What differs.
pub fn compare(case: &Case) -> Result<Vec<String>, String> {
    let mut notes = Vec::new();
    let valid =
        homeo::shell::validate::validate(&case.shell).is_ok() && homeo::mesh::check(&case.mesh).is_ok();
    if !valid {
        return Ok(vec!["refused".into()]);
    }
    let mut world = World::new(&case.shell, &case.mesh);
    let positive = world.positivity();
    let Some(outcome) = certified(case, positive)? else { return Ok(vec!["branched".into()]) };
    let mut same = |what: &str, claimed: bool, truth: bool| {
        notes.push(format!("{what} {}", if truth { "holds" } else { "fails" }));
        if claimed == truth {
            Ok(())
        } else {
            Err(format!("{what}: the certifier says {claimed}, the oracle {truth}"))
        }
    };
    same("C1", holds(&outcome, Claim::Positivity), positive)?;
    let embedded = world.mesh_embedded();
    let apart = [world.cap_disjoint(0), world.cap_disjoint(2)];
    let parts = outcome.claims.iter().find(|c| c.claim == Claim::Disjoint).map_or(&[][..], |c| &c.parts);
    for (part, (name, truth)) in
        parts.iter().zip([("mesh", embedded), ("bottom", apart[0]), ("top", apart[1])])
    {
        assert_eq!(part.about, name);
        same(&format!("C6 {name}"), part.verdict == Verdict::Certified, truth)?;
    }
    same("C6", holds(&outcome, Claim::Disjoint), embedded && apart == [true; 2])?;
    let here = section(&mut world, &case.rank());
    if here == Section::Ambiguous {
        if positive {
            return Err("tets overlap around an edge although C1 holds".into());
        }
        notes.push("ambiguous".into());
        return Ok(notes);
    }
    let exists = here == Section::Exists;
    same("C2", holds(&outcome, Claim::Section), exists)?;
    same("C4", holds(&outcome, Claim::Bijection), exists)?;
    let claimed = holds(&outcome, Claim::SectionAllOrders);
    let all_orders = positive && exists && {
        match first_vertices(&outcome, case) {
            // The witness names an order: that one must fail.
            Some(rank) => section(&mut world, &rank) == Section::Exists,
            None => failing_order(&mut world, orders(case)).is_none(),
        }
    };
    same("C3", claimed, all_orders)?;
    let i2 = all_orders && apart == [true; 2] && world.contacts_face_up();
    same("C3+", holds(&outcome, Claim::I2), i2)?;
    Ok(notes)
}

#[cfg(test)]
mod tests {
    use super::{Tally, is_telling, run};

    #[test]
    #[should_panic(expected = "a case that fails")]
    fn a_failure_ends_the_run() {
        run(600, |_, _| Err("a case that fails".into()));
    }

    #[test]
    fn a_run_that_refuses_all_tells_nothing() {
        let tally = |refused, holds| Tally::from([("refused".into(), refused), ("C1 holds".into(), holds)]);
        assert!(is_telling(1000, &tally(700, 300)));
        assert!(!is_telling(1000, &tally(1000, 0)));
        assert!(!is_telling(1000, &tally(950, 50)));
        // Too few to tell.
        assert!(is_telling(64, &tally(64, 0)));
    }
}
