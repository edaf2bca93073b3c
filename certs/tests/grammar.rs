//! The malformed and limit codes of a certificate file.
mod common;
use common::{one_prism, tetrahedron};
use homeo_certs::check;

fn code(from: &str, to: &str) -> (u8, &'static str) {
    let case = tetrahedron();
    let text = case.text();
    assert!(text.contains(from), "{from}");
    let got = check(text.replacen(from, to, 1).as_bytes(), &case.inputs());
    (got.exit, got.code)
}

#[test]
fn control() {
    tetrahedron().accept();
    one_prism().accept();
}

#[test]
fn file_level() {
    assert_eq!(code("claim", "cl\0im"), (2, "bytes"));
    assert_eq!(code("\n", "\r\n"), (2, "bytes"));
    assert_eq!(code("\nend\n", "\nend"), (2, "truncated"));
    assert_eq!(code("\nend\n", "\n"), (2, "truncated"));
    assert_eq!(code("homeo-certificate 1", "homeo-certificate 2"), (2, "magic"));
    for (bytes, expected) in
        [(&b""[..], "truncated"), (b"end\n", "magic"), (b"\xff", "bytes"), (b"bend\n", "truncated")]
    {
        assert_eq!(check(bytes, &[]).code, expected);
    }
}

#[test]
fn syntax() {
    for (from, to) in [
        ("claim positivity certified", "claim positivity certified "),
        ("claim positivity", "claim  positivity"),
        ("claim section certified", "claim positivity certified"),
        ("order id", "order list 0 1 2 3"),
        ("order id", "order list 0 1 3"),
        ("order id", "order list 0 1 3 3"),
        ("v 0 m0", "v 0 n0"),
        ("v 0 m0", "v 00 m0"),
        ("v 0 m0", "v 1,0 m0"),
        ("v 0 m0", "v 0 m1,m0"),
        ("v 0 m0", "v 0 t0,m0"),
        ("c 0 1 2", "c 0 1 0"),
        ("c 0 1 2", "c 0 1"),
        ("d middle 0 0\n", ""),
        ("d mesh 0 0\n", ""),
        ("1 0 0 1 0 0 0 -3*2^6", "0 0 0 1 0 0 0 -3*2^6"),
        ("-3*2^6", "-6*2^5"),
        ("-3*2^6", "-3*2^0"),
        ("-3*2^6", "-3*2^-06"),
        ("-3*2^6", "-0"),
        ("-3*2^6", "+3"),
        ("m0,m1,m3,t3", "m0,m1,m3"),
        ("\nend\n", "\nend\nend\n"),
        ("begin i2", "begin i3"),
    ] {
        assert_eq!(code(from, to), (2, "syntax"), "{from} -> {to}");
    }
}

#[test]
fn digits_range_duplicate_claims_counts() {
    let long = "1".repeat(4001);
    assert_eq!(code("-3*2^6", &format!("-{long}*2^6")), (3, "digits"));
    assert_eq!(code("-3*2^6", &format!("-{}*2^6", "1".repeat(4000))), (1, "wrong-value"));
    assert_eq!(code("contact 0 1 m0,m1,m3,t3 1", &format!("contact 9 1 m0,m1,m3,t3 {long}")), (3, "digits"));
    for (from, to) in [
        ("contact 0", "contact 4"),
        ("contact 0 1", "contact 0 4"),
        ("v 3 m3", "v 4 m3"),
        ("v 3 m3", "v 3 m4"),
        ("v 3 m3", "v 3 m4,m9999999999"),
        ("c 0 1 2", "c 0 1 4"),
        ("d mesh 0 0", "d mesh 4 0"),
        ("d mesh 0 0", "d mesh 0 1"),
        ("order id", "order list 0 1 2 4"),
        ("pinched 0", "pinched 0 4"),
    ] {
        assert_eq!(code(from, to), (2, "range"), "{from} -> {to}");
    }
    assert_eq!(code("v 3 m3", "v 2 m2"), (2, "duplicate"));
    for from in
        ["claim positivity certified\n", "claim bijection certified\n", "claim disjoint-top certified\n"]
    {
        assert_eq!(code(from, ""), (2, "claims"));
    }
    assert_eq!(code("claim disjoint-top certified", "claim disjoint-top refuted"), (2, "syntax"));
    assert_eq!(code("bijection certified", "bijection refuted"), (2, "claims"));
    assert_eq!(code("counts 10", "counts 11"), (2, "counts"));
    assert_eq!(code("counts 10", "counts 0 10"), (2, "counts"));
}
