//! The certifier's verdicts against the oracle's, on random shells and meshes in degenerate position.
// quickcheck wants values.
#![allow(clippy::needless_pass_by_value)]

use homeo_proptests::campaign::{compare, run};
use homeo_proptests::recipe::Recipe;

#[test]
fn verdicts_agree_with_the_definitions() {
    run(20, |_, case| compare(case));
}

#[test]
fn verdicts_agree_with_the_definitions_quickcheck() {
    fn property(recipe: Recipe) -> Result<(), String> {
        compare(&recipe.build()).map(drop)
    }
    let tests = std::env::var("HOMEO_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(500);
    // Without `max_tests` quickcheck ends after 10000 cases, and says nothing.
    let mut runner = quickcheck::QuickCheck::new().tests(tests).max_tests(tests).min_tests_passed(tests);
    runner.quickcheck(property as fn(Recipe) -> Result<(), String>);
}
