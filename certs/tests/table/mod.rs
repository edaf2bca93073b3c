//! The table of a corpus: which answer each certificate must get, as stated by hand.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use homeo_certs::Outcome;

pub(crate) struct Row {
    pub(crate) control: String,
    pub(crate) mutant: String,
    pub(crate) inputs: Vec<String>,
    pub(crate) exit: u8,
    pub(crate) code: String,
}

impl Row {
    pub(crate) fn place(&self) -> String {
        format!("{}/{}", self.control, self.mutant)
    }

    pub(crate) fn file(&self) -> String {
        format!("{}.cert", self.mutant)
    }

    /// What an answer has other than the table says.
    pub(crate) fn difference(&self, outcome: &Outcome) -> Option<String> {
        let code = if outcome.code.is_empty() { "-" } else { outcome.code };
        let same = (outcome.exit, code) == (self.exit, self.code.as_str());
        let words = || {
            let (place, exit, message) = (self.place(), outcome.exit, &outcome.message);
            format!("{place}: {exit} {code} ({message}), but the table says {} {}", self.exit, self.code)
        };
        (!same).then(words)
    }
}

/// A corpus of this crate.
pub(crate) fn corpus(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// The rows of a table; `of_control` are the inputs that `control` stands for.
pub(crate) fn rows(table: &Path, of_control: &[&str]) -> Vec<Row> {
    let text = fs::read_to_string(table).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("control\tmutant\tinputs\texit\tcode\twhat"));
    let row = |line: &str| {
        let columns: Vec<&str> = line.split('\t').collect();
        let [control, mutant, inputs, exit, code, what] = columns[..] else { panic!("columns of {line}") };
        assert!(!what.is_empty(), "{line}");
        let inputs = match inputs {
            "control" => of_control.to_vec(),
            "none" => vec![],
            names => names.split(' ').collect(),
        };
        let inputs = inputs.into_iter().map(str::to_owned).collect();
        Row {
            control: control.into(),
            mutant: mutant.into(),
            inputs,
            exit: exit.parse().unwrap(),
            code: code.into(),
        }
    };
    lines.map(row).collect()
}

/// The names of all that is in a directory.
pub(crate) fn names_in(directory: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(directory).unwrap();
    entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
}
