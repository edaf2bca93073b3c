//! The corpora of `certs/` as seeds, with what is true of their inputs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// A control of a corpus: inputs, its certificate, and the verdicts that this states.
pub struct Control {
    /// The name of its folder.
    pub name: String,
    /// The contents of its inputs, as the checker takes them.
    pub inputs: Vec<Vec<u8>>,
    /// The certificate.
    pub certificate: Vec<u8>,
    /// Claims that hold (or not) of these inputs: the certificate's, which corpus and both checkers agree on.
    pub truth: BTreeMap<String, bool>,
    /// The lines that choose a vertex order: verdicts about the decomposition depend on it.
    pub order: Vec<String>,
}

/// All controls of a corpus, by name.
pub struct Corpus(pub Vec<Control>);

/// Certificates about shells.
pub(crate) static SHELLS: LazyLock<Corpus> = LazyLock::new(|| Corpus::read("corpus", "mutants.tsv"));
/// Certificates about meshes.
pub(crate) static MESHES: LazyLock<Corpus> = LazyLock::new(|| Corpus::read("corpus-meshes", "table.tsv"));

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../certs").join(name)
}

/// The lines of a certificate that choose an order.
pub(crate) fn order_lines(certificate: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(certificate);
    text.lines().filter(|line| line.starts_with("order")).map(str::to_owned).collect()
}

impl Corpus {
    fn read(name: &str, table: &str) -> Self {
        let folder = folder(name);
        let rows = fs::read_to_string(folder.join(table)).expect("the table of a corpus");
        let mut names: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for row in rows.lines().skip(1) {
            let columns: Vec<&str> = row.split('\t').collect();
            let [control, mutant, inputs, ..] = columns[..] else { panic!("columns of {row}") };
            if inputs == "control" || mutant == "control" {
                let files = match inputs {
                    "control" => {
                        ["bottom.off", "middle.off", "top.off", "mesh.off"].map(str::to_owned).to_vec()
                    }
                    files => files.split(' ').map(str::to_owned).collect(),
                };
                names.entry(control.to_owned()).or_insert(files);
            }
        }
        let control = |(name, files): (String, Vec<String>)| {
            let read = |file: &str| fs::read(folder.join(&name).join(file));
            let inputs = files.iter().map(|file| read(file)).collect::<Result<Vec<_>, _>>().ok()?;
            let certificate = read("control.cert").ok()?;
            let answer = homeo_certs::check(&certificate, &inputs);
            assert_eq!(answer.exit, 0, "{name}: {} {}", answer.code, answer.message);
            let (truth, order) = (answer.claims.into_iter().collect(), order_lines(&certificate));
            Some(Control { name, inputs, certificate, truth, order })
        };
        Self(names.into_iter().filter_map(control).collect())
    }

    /// One seed a control: a byte that chooses it, then its certificate.
    #[must_use]
    pub fn seeds(&self) -> Vec<Vec<u8>> {
        let numbered = self.0.iter().zip(0u8..);
        numbered.map(|(control, i)| [&[i][..], &control.certificate].concat()).collect()
    }

    /// The control that the first byte chooses, and the certificate after it.
    pub(crate) fn chosen<'a>(&self, data: &'a [u8]) -> Option<(&Control, &'a [u8])> {
        let (first, certificate) = data.split_first()?;
        Some((self.0.get(usize::from(*first) % self.0.len().max(1))?, certificate))
    }
}
