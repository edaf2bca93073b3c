//! Lines that are read again, where a page has two of them.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests may fail like tests

use super::{Lines, PAGE, Text};
use crate::line::Bounds;
use crate::parse::parse;
use foldhash::fast::RandomState;
use std::fs::File;
use std::hash::BuildHasher;
use std::io::Write;
use std::sync::Mutex;

const LINES: [&str; 5] = ["v 0 m0", "v 0,1 b1,m2", "v 2 t2", "v 0,1,2 m0,m1,m2", "v 1 m1"];

/// The lines behind some text, and the text.
fn lines<'a>(text: Text<'a>, which: &[&str]) -> Lines<'a> {
    let bounds = Bounds { shell: 3, prisms: 1, mesh: 3, triangles: 1, corners: 0 };
    let mut end = 4;
    let mut lines = Lines::new(text, bounds, 2, end);
    for line in which {
        end += line.len() + 1;
        lines.push(line, end);
    }
    lines.close();
    lines
}

fn text() -> String {
    format!("abc\n{}\nmore\n", LINES.join("\n"))
}

fn stored(text: &str) -> (tempfile::NamedTempFile, Mutex<File>) {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(text.as_bytes()).unwrap();
    let again = Mutex::new(file.reopen().unwrap());
    (file, again)
}

#[test]
fn any_of_the_lines_are_found() {
    assert_eq!(PAGE, 2);
    let text = text();
    let (_kept, file) = stored(&text);
    for source in [Text::Memory(text.as_bytes()), Text::File(&file, text.len())] {
        let lines = lines(source, &LINES);
        assert_eq!((lines.len(), lines.number(4)), (5, 6));
        for wanted in 0..32usize {
            let wanted: Vec<usize> = (0..5).filter(|i| wanted >> i & 1 == 1).collect();
            let Ok([ids, names]) = lines.carriers(&wanted) else { panic!("lines {wanted:?}") };
            assert_eq!((ids.len(), names.len()), (wanted.len(), wanted.len()));
            for (at, &i) in wanted.iter().enumerate() {
                let expected: [(&[usize], &[usize]); 5] =
                    [(&[0], &[1]), (&[0, 1], &[3, 7]), (&[2], &[8]), (&[0, 1, 2], &[1, 4, 7]), (&[1], &[4])];
                assert_eq!((ids.of(at), names.of(at)), expected[i]);
            }
        }
    }
}

#[test]
fn a_file_that_changes_is_refused() {
    let text = text();
    let start = text.find("v 2 t2").unwrap();
    // A line of the second page, with another that fits the grammar; the file's end lost.
    for change in [Some("v 1"), None] {
        let (kept, file) = stored(&text);
        let lines = lines(Text::File(&file, text.len()), &LINES);
        let changed = change.map_or(text[..start + 3].to_owned(), |new| text.replacen("v 2", new, 1));
        std::fs::write(kept.path(), changed).unwrap();
        assert!(lines.carriers(&[0, 1]).is_ok(), "the first page is as it was");
        for wanted in [&[2][..], &[3], &[0, 3], &[4, 2][1..]] {
            let fail = lines.carriers(wanted).err();
            assert_eq!(fail.map(|fail| (fail.exit, fail.code)), Some((2, "usage")), "{change:?} {wanted:?}");
        }
    }
}

#[test]
fn a_line_that_is_not_there_is_not_passed_over() {
    let text = text();
    let end = text.find("v 1 m1").unwrap();
    let lines = lines(Text::Memory(&text.as_bytes()[..end]), &LINES);
    assert!(lines.carriers(&[1, 3]).is_ok());
    for wanted in [&[4][..], &[0, 4]] {
        let fail = lines.carriers(wanted).err();
        assert_eq!(fail.map(|fail| (fail.exit, fail.code)), Some((2, "usage")), "{wanted:?}");
    }
}

#[test]
fn the_first_repetition_is_named() {
    let hasher = RandomState::default();
    let exact = |line: &str| hasher.hash_one(line);
    // With the others, lines that differ have the same hash.
    let hashes: [&dyn Fn(&str) -> u64; 3] = [&exact, &|line| line.len() as u64, &|_| 7];
    let repeated = |which: &[&str], hash: &dyn Fn(&str) -> u64| {
        let text = format!("abc\n{}\n", which.join("\n"));
        let (_kept, file) = stored(&text);
        let [found, again] = [Text::Memory(text.as_bytes()), Text::File(&file, text.len())].map(|text| {
            let hashes = which.iter().map(|line| hash(line)).collect();
            let fail = lines(text, which).different(hash, hashes).err();
            fail.map(|fail| (fail.code, fail.message))
        });
        assert_eq!(found, again);
        found
    };
    for hash in hashes {
        assert_eq!(repeated(&LINES, hash), None);
        let found = |line: usize| Some(("duplicate", format!("line {line} repeats an earlier one")));
        let again = ["v 0 m0", "v 1 m1", "v 2 m2", "v 1 m1", "v 0 m0"];
        assert_eq!(repeated(&again, hash), found(5));
        assert_eq!(repeated(&["v 0 m0", "v 0 m0"], hash), found(3));
        let third = ["v 1 m1", "v 0 m0", "v 2 m2", "v 2 m2", "v 1 m1"];
        assert_eq!(repeated(&third, hash), found(5));
        // More lines than are read together, the last one like the first one.
        let mut many: Vec<String> = (0..300).map(|i| format!("v {i} m{i}")).collect();
        many.push(many[0].clone());
        let many: Vec<&str> = many.iter().map(String::as_str).collect();
        assert_eq!(repeated(&many[..300], hash), None);
        assert_eq!(repeated(&many, hash), found(302));
    }
}

#[test]
fn windows_may_end_anywhere() {
    // Windows have seven bytes here, so that every line but the last crosses their ends.
    let sha = "0".repeat(64);
    let text = format!(
        "homeo-certificate 1\nclaim positivity certified\nshell {sha} 3 1\norder id\npinched 0\ncounts\nend\n"
    );
    let (_kept, file) = stored(&text);
    let cert = parse(Text::File(&file, text.len()));
    let Ok(cert) = cert else { panic!("{}", cert.err().map_or(String::new(), |fail| fail.message)) };
    assert_eq!((cert.shell.vertices, cert.shell.faces), (3, 1));
    for cut in 1..text.len() {
        let codes = [Text::Memory(&text.as_bytes()[..cut]), Text::File(&file, cut)].map(|text| {
            let fail = parse(text).err();
            fail.map(|fail| (fail.code, fail.message))
        });
        assert!(codes[0].is_some() && codes[0] == codes[1], "{cut}: {codes:?}");
    }
}
