use super::*;
use crate::certify::Silent;
use crate::construct::icosphere;

#[test]
fn coordinates_that_are_no_numbers_are_an_invalid_input() {
    let mut broken = icosphere(1);
    broken.vertices[4][2] = f64::INFINITY;
    let sound = icosphere(1);
    let subject = |name, mesh| Subject { name, file: format!("{name}.off"), mesh };
    let subjects = [subject("A", &sound), subject("B", &broken)];
    let found = audit(&subjects, None, &AuditOptions::default(), &Silent).unwrap().report;
    assert_eq!(found.verdict, AuditVerdict::InvalidInput);
    assert_eq!(found.inputs[1].defects[0].kind, "not-finite");
    // No document can be about such a mesh: formats hold finite numbers only.
    assert!(found.documents.is_empty());
}
