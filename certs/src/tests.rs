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
