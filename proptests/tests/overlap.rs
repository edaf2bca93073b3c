//! `disjoint-prisms` against its definition, on random shells and on pairs of them pushed into each other; and what
//! both verdicts are written in is accepted by the independent checker, and not for the opposite verdict.
#![allow(clippy::unwrap_used)]

use homeo::certify::{Claim, Options, Silent, Verdict, certify};
use homeo::shell::Shell;
use homeo_proptests::campaign::run;
use homeo_proptests::judged::inputs;
use homeo_proptests::oracle::World;
use homeo_proptests::{Case, Recipe};

/// A second copy of the shell beside, in or across the first, as the recipe's numbers have it.
fn doubled(case: &Case, recipe: &Recipe) -> Case {
    let scale = [1.0, 0.5, 0.125, 1.0][usize::from(recipe.order % 4)];
    let by = [3, 5, 7].map(|k| f64::from((recipe.order / k) % 9) - 4.0);
    let n = u32::try_from(case.shell.middle.len()).unwrap();
    let mut out = case.clone();
    let moved = |p: &[f64; 3]| [0, 1, 2].map(|i| scale * p[i] + 0.5 * by[i]);
    let Shell { bottom, middle, top, faces } = &case.shell;
    out.shell.bottom.extend(bottom.iter().map(moved));
    out.shell.middle.extend(middle.iter().map(moved));
    out.shell.top.extend(top.iter().map(moved));
    out.shell.faces.extend(faces.iter().map(|f| f.map(|v| v + n)));
    out.order.extend(case.order.iter().map(|v| v + n));
    out
}

fn agrees(case: &Case) -> Result<String, String> {
    let options = Options { claims: vec![Claim::DisjointPrisms], order: case.vertex_order() };
    let Ok(outcome) = certify(&case.shell, None, &options, &Silent) else { return Ok("refused".into()) };
    let holds = outcome.claims[0].verdict == Verdict::Certified;
    let truth = World::new(&case.shell, &case.mesh).injective(&case.rank());
    if holds != truth {
        return Err(format!("certified: {holds}, by definition: {truth}\n{}", outcome.certificate));
    }
    let files = inputs(case);
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &files[..3]);
    if answer.exit != 0 || answer.claims != [("disjoint-prisms".to_owned(), holds)] {
        return Err(format!("{answer:?}\n{}", outcome.certificate));
    }
    let (from, to) = if holds { ("certified", "refuted") } else { ("refuted", "certified") };
    let other = outcome.certificate.replacen(from, to, 1);
    if homeo_certs::check(other.as_bytes(), &files[..3]).exit == 0 {
        return Err(format!("both verdicts are accepted\n{}", outcome.certificate));
    }
    let kind = if holds {
        "certified"
    } else if outcome.certificate.contains("\ntet ") {
        "flat"
    } else {
        "overlap"
    };
    Ok(kind.to_owned())
}

/// A certificate that claims the opposite with an empty block: refused by what the checker finds itself.
fn not_for_nothing(case: &Case) -> Result<(), String> {
    let options = Options { claims: vec![Claim::DisjointPrisms], order: case.vertex_order() };
    let Ok(outcome) = certify(&case.shell, None, &options, &Silent) else { return Ok(()) };
    if outcome.claims[0].verdict == Verdict::Certified {
        return Ok(());
    }
    let lines = outcome.certificate.lines().map(|l| l.replacen("prisms refuted", "prisms certified", 1));
    let mut text: Vec<String> =
        lines.filter(|l| !l.starts_with("overlap ") && !l.starts_with("tet ")).collect();
    let n = text.len();
    "counts 0".clone_into(&mut text[n - 2]);
    let answer = homeo_certs::check((text.join("\n") + "\n").as_bytes(), &inputs(case)[..3]);
    let known = ["missing-separation", "not-positive", "overlap"].contains(&answer.code);
    if known { Ok(()) } else { Err(format!("{answer:?}")) }
}

#[test]
fn verdicts_follow_the_definition() {
    run(20, |recipe, case| {
        let pair = doubled(case, recipe);
        not_for_nothing(case)?;
        not_for_nothing(&pair)?;
        Ok(vec![format!("one {}", agrees(case)?), format!("two {}", agrees(&pair)?)])
    });
}
