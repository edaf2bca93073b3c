//! Every small damage of a valid certificate: no panic, and no other claims accepted.
mod common;
use common::tetrahedron;
use homeo_certs::check;

#[test]
fn bytes_and_lines() {
    let case = tetrahedron();
    let (text, inputs) = (case.text().into_bytes(), case.inputs());
    let good = check(&text, &inputs);
    assert_eq!(good.exit, 0);
    let mut accepted = Vec::new();
    let mut try_one = |bytes: &[u8]| {
        let got = check(bytes, &inputs);
        if got.exit == 0 {
            assert_eq!(got.claims, good.claims);
            accepted.push(String::from_utf8_lossy(bytes).into_owned());
        }
    };
    for i in 0..text.len() {
        let mut cut = text.clone();
        cut.remove(i);
        try_one(&cut);
        for byte in b"0129 ,\nbmtgx-*^\xff\0".iter().filter(|b| **b != text[i]) {
            let mut other = text.clone();
            other[i] = *byte;
            try_one(&other);
        }
    }
    let lines: Vec<&[u8]> = text.split_inclusive(|b| *b == b'\n').collect();
    for i in 0..lines.len() {
        for j in 0..i {
            let mut other = lines.clone();
            other.swap(i, j);
            try_one(&other.concat());
        }
        let mut other = lines.clone();
        other.remove(i);
        try_one(&other.concat());
    }
    // What stays true: weights scaled, another named fan triangle or contact, lines in another order.
    let facts: Vec<&[u8]> = lines[12..].to_vec();
    for text in accepted {
        assert!(text.as_bytes().starts_with(&lines[..12].concat()), "{text}");
        assert_ne!(text.as_bytes(), [&lines[..12], &facts].concat().concat());
    }
}

#[test]
fn damaged_inputs_never_panic() {
    let case = tetrahedron();
    let (text, inputs) = (case.text(), case.inputs());
    for file in 0..4 {
        for i in 0..inputs[file].len() {
            for byte in [b'9', b'-', b'#', b'\n', 0, 0xff] {
                let mut other = inputs.clone();
                other[file][i] = byte;
                let got = check(text.as_bytes(), &other);
                let same = got.exit == 0 && got.claims.len() == 8;
                assert!(same || got.code == "hash" || got.code == "input", "{got:?}");
            }
        }
    }
}
