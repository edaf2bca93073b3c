//! The checkers on any bytes.

use homeo_certs::Outcome;

use crate::corpus::{Control, Corpus, MESHES, SHELLS, order_lines};
use crate::python;

/// An accepted certificate states nothing that is false of its inputs.
fn agrees(control: &Control, certificate: &[u8], answer: &Outcome) {
    let same_order = order_lines(certificate) == control.order;
    for (name, certified) in &answer.claims {
        let depends = ["section", "bijection", "disjoint-prisms"].contains(&name.as_str());
        if let Some(truth) = control.truth.get(name).filter(|_| same_order || !depends) {
            assert_eq!(certified, truth, "{}: {name} was turned over", control.name);
        }
    }
}

fn judged(corpus: &Corpus, data: &[u8]) {
    let Some((control, certificate)) = corpus.chosen(data) else { return };
    let answer = homeo_certs::check(certificate, &control.inputs);
    assert!(answer.exit == 0 || answer.claims.is_empty(), "claims of a certificate that is not accepted");
    agrees(control, certificate, &answer);
}

/// The checker of certificates about shells: no panic on any bytes, and no verdict is turned over. The first byte chooses
/// the inputs, the rest is the certificate.
///
/// # Panics
/// If a false certificate is accepted.
pub fn certificate(data: &[u8]) {
    judged(&SHELLS, data);
}

/// [`certificate`], for certificates about meshes.
///
/// # Panics
/// If a false certificate is accepted.
pub fn document(data: &[u8]) {
    judged(&MESHES, data);
}

/// Both checkers on the same bytes: equal exit codes, error codes and claims. The first byte chooses corpus and inputs. Does
/// nothing without Python.
///
/// # Panics
/// If they differ.
pub fn checkers(data: &[u8]) {
    let Some((first, rest)) = data.split_first() else { return };
    let corpus = if first & 1 == 0 { &*SHELLS } else { &*MESHES };
    let Some((control, certificate)) = corpus.chosen(rest) else { return };
    // One program in Rust, two scripts in Python.
    let script = if certificate.starts_with(b"homeo-meshes") { "check_meshes" } else { "check" };
    let Some(theirs) = python::answer(script, certificate, &control.inputs) else { return };
    let ours = homeo_certs::check(certificate, &control.inputs);
    assert_eq!(python::line(&ours), theirs, "{}", control.name);
}
