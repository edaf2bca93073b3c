//! The corpus again, where pages, shards and passes are as small as they can be (in unit tests they are), with the
//! certificate in memory and left in its file.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests may fail like tests

#[path = "../tests/table/mod.rs"]
mod table;

use crate::{Outcome, check, check_files_keeping};
use std::fs;
use table::{corpus, names_in, rows};

/// A corpus, its table, and what its inputs are called.
const CORPORA: [(&str, &str, &[&str]); 2] = [
    ("corpus", "mutants.tsv", &["bottom.off", "middle.off", "top.off", "mesh.off"]),
    ("corpus-meshes", "table.tsv", &[]),
];

/// The answer, which must be the same in all ways.
fn answer(folder: &std::path::Path, cert: &str, inputs: &[String]) -> Outcome {
    let inputs: Vec<_> = inputs.iter().map(|name| folder.join(name)).collect();
    let cert = folder.join(cert);
    let outcome = check_files_keeping(0, &cert, &inputs);
    assert_eq!(check_files_keeping(u64::MAX, &cert, &inputs), outcome, "{}", cert.display());
    // Some tables name a file that is not there.
    let contents: Option<Vec<_>> = inputs.iter().map(|path| fs::read(path).ok()).collect();
    if let Some(contents) = contents {
        assert_eq!(check(&fs::read(&cert).unwrap(), &contents), outcome, "{}", cert.display());
    }
    outcome
}

#[test]
fn small_pages_and_shards_change_no_answer() {
    let mut count = 0;
    for (name, table, inputs) in CORPORA {
        for row in rows(&corpus(name).join(table), inputs) {
            let outcome = answer(&corpus(name).join(&row.control), &row.file(), &row.inputs);
            assert!(row.difference(&outcome).is_none(), "{:?}", row.difference(&outcome));
            count += 1;
        }
    }
    for control in names_in(&corpus("corpus")).into_iter().filter(|name| !name.contains('.')) {
        let folder = corpus("corpus").join(control);
        let inputs: Vec<String> = CORPORA[0].2.iter().map(|name| (*name).to_owned()).collect();
        let outcome = answer(&folder, "control.cert", &inputs);
        assert_eq!(outcome.status, "valid", "{}: {}", folder.display(), outcome.message);
        count += 1;
    }
    assert!(count > 150, "{count} certificates");
}

/// The errors of FORMAT section 3.2 in their order.
const ORDER: [&str; 6] = ["cap", "area-mesh", "edge-twice", "boundary", "isolated", "degree-component"];

/// The certificate of two components with those errors. They are in rows far from each other, later ones often first.
fn with_errors(control: &str, has: [bool; 6]) -> String {
    let rows: Vec<&str> = control.lines().collect();
    let start = rows.iter().position(|row| *row == "begin overlay").unwrap() + 1;
    let (mut corners, cells) = (rows[start..start + 18].to_vec(), &rows[start + 18..start + 30]);
    let (mut one, mut two) = (cells[..6].to_vec(), cells[6..].to_vec());
    // A point that no cell has.
    corners.extend(has[0].then_some("v 0 b0"));
    if has[1] {
        assert_eq!(one[5], "c 8 5 2");
        one[5] = "c 8 2 5";
    }
    if has[2] {
        assert_eq!(one[3], "c 3 7 4");
        one.insert(0, "c 7 4 3");
    }
    if has[3] {
        one.retain(|row| *row != "c 8 2 4");
    }
    if has[4] {
        two.clear();
    }
    let second = if has[4] || has[5] { 0 } else { one.len() };
    let degree: Vec<String> =
        ["mesh", "middle"].iter().flat_map(|d| [0, second].map(|cell| format!("d {d} {cell} 0"))).collect();
    let mut block = [corners, one, two].concat();
    block.extend(degree.iter().map(String::as_str));
    let counts = format!("counts {} 2 0 0 0", block.len());
    let mut text = [&rows[..start], &block, &rows[start + 34..]].concat();
    let at = text.len() - 2;
    text[at] = &counts;
    text.join("\n") + "\n"
}

#[test]
fn the_first_error_in_the_order_of_the_format_is_named() {
    let folder = corpus("corpus").join("two-components");
    let control = fs::read_to_string(folder.join("control.cert")).unwrap();
    let inputs: Vec<_> = CORPORA[0].2.iter().map(|name| folder.join(name)).collect();
    let file = tempfile::NamedTempFile::new().unwrap();
    for which in 0..64 {
        let has = std::array::from_fn(|i| which >> i & 1 == 1);
        fs::write(file.path(), with_errors(&control, has)).unwrap();
        let expected = ORDER.iter().zip(has).find(|x| x.1).map_or("", |x| x.0);
        for resident in [0, u64::MAX] {
            let outcome = check_files_keeping(resident, file.path(), &inputs);
            assert_eq!(outcome.code, expected, "{has:?}: {}", outcome.message);
            assert_eq!(outcome.exit, u8::from(!expected.is_empty()));
        }
    }
}
