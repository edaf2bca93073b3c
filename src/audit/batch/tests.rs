//! Journals, manifests, merging.

use std::io::Write as _;
use std::path::Path;

use super::*;

fn line(key: &str, verdict: &str) -> ResultLine {
    ResultLine {
        key: key.to_owned(),
        kind: Kind::Pair,
        name: format!("pair <{key}> | \"x\"\n"),
        files: vec!["a".to_owned(), "b".to_owned()],
        verdict: verdict.to_owned(),
        summary: "words".to_owned(),
        directory: None,
        document_bytes: 7,
        seconds: 0.5,
    }
}

#[test]
fn a_line_cut_anywhere_is_recorded_again_and_no_other_is_lost() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("results.jsonl");
    let mut journal = Journal::open(&path, false).unwrap();
    assert!(journal.record(line("one", "bijective")).unwrap());
    assert!(journal.record(line("two", "nested")).unwrap());
    assert!(!journal.record(line("one", "bijective")).unwrap());
    drop(journal);
    let whole = std::fs::read(&path).unwrap();
    let first = whole.iter().position(|&b| b == b'\n').unwrap() + 1;
    for cut in first..whole.len() {
        std::fs::write(&path, &whole[..cut]).unwrap();
        let mut journal = Journal::open(&path, true).unwrap();
        assert_eq!((journal.has("one"), journal.has("two")), (true, false), "cut at {cut}");
        assert!(journal.record(line("two", "nested")).unwrap());
        drop(journal);
        assert_eq!(std::fs::read(&path).unwrap(), whole, "cut at {cut}");
    }
}

#[test]
fn results_are_not_overwritten_nor_shared_nor_guessed_at() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("results.jsonl");
    let mut journal = Journal::open(&path, false).unwrap();
    journal.record(line("one", "bijective")).unwrap();
    assert!(matches!(Journal::open(&path, true), Err(JournalError::Locked(_))));
    drop(journal);
    assert!(matches!(Journal::open(&path, false), Err(JournalError::Exists(_))));
    let mut file = std::fs::OpenOptions::new().append(true).open(&path).unwrap();
    file.write_all(b"{\"key\": 3}\n").unwrap();
    assert!(matches!(Journal::open(&path, true), Err(JournalError::Line { line: 2, .. })));
}

#[test]
fn manifests_name_every_file_and_refuse_what_they_do_not_know() {
    let text = "[[pair]]\na = 'x.off'\nb = '/y.off'\n[[cage]]\nname = 'c'\nmesh = 'm.off'\ncage = 'k.off'\n";
    let manifest = Manifest::parse(text, Path::new("/data")).unwrap();
    assert_eq!(manifest.items.len(), 2);
    assert_eq!(manifest.items[0].name, "x.off y.off");
    assert_eq!(manifest.items[0].files, ["/data/x.off", "/y.off"].map(std::path::PathBuf::from));
    assert_eq!((manifest.items[1].kind, manifest.items[1].name.as_str()), (Kind::Cage, "c"));
    for wrong in [
        "[[pair]]\na = 'x'\n",
        "[[pair]]\na = 'x'\nb = 'y'\nshel = 'z'\n",
        "pair = 3",
        "[[pear]]\n",
        "",
        "# none",
    ] {
        assert!(Manifest::parse(wrong, Path::new("")).is_err(), "{wrong}");
    }
}

#[test]
fn shards_are_a_partition() {
    let entry = |i: u32| format!("[[pair]]\nname = '{i}'\na = 'x'\nb = 'y'\n");
    let text: String = (0..10).map(entry).collect();
    let manifest = Manifest::parse(&text, Path::new("")).unwrap();
    let mut names: Vec<String> = ["1/3", "2/3", "3/3"]
        .iter()
        .flat_map(|s| manifest.of_shard(s.parse().unwrap()).map(|i| i.name.clone()).collect::<Vec<_>>())
        .collect();
    names.sort_unstable();
    assert_eq!(names, (0..10).map(|i| i.to_string()).collect::<Vec<_>>());
    for wrong in ["", "1", "0/3", "4/3", "a/b", "1/0", "-1/2"] {
        assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
    }
}

#[test]
fn merging_keeps_each_result_once_and_refuses_contradictions() {
    let lines = [
        line("b", "nested"),
        line("a", "error"),
        line("a", "bijective"),
        line("b", "nested"),
        line("a", "error"),
    ];
    let merged = merge(lines).unwrap();
    assert_eq!(merged.iter().map(|l| l.verdict.as_str()).collect::<Vec<_>>(), ["bijective", "nested"]);
    assert!(merge([line("a", "bijective"), line("a", "not certified")]).is_err());
}

#[test]
fn a_result_takes_the_place_of_the_error_of_a_file_that_was_missing() {
    let named = |key: &str, verdict: &str| ResultLine { name: "p".to_owned(), ..line(key, verdict) };
    let other = ResultLine { files: vec!["c".to_owned(), "b".to_owned()], ..named("k3", "error") };
    let merged = merge([named("k1", "error"), named("k2", "bijective"), other]).unwrap();
    assert_eq!(merged.iter().map(|l| l.key.as_str()).collect::<Vec<_>>(), ["k2", "k3"]);
}

#[test]
fn pairs_with_equal_content_and_other_names_have_other_keys() {
    let key = |name: &str| {
        let text = format!("[[pair]]\nname = '{name}'\na = 'x'\nb = 'y'\n");
        let manifest = Manifest::parse(&text, Path::new("")).unwrap();
        manifest.items[0].key(&[b"x".to_vec(), b"y".to_vec()], &crate::audit::AuditOptions::default())
    };
    assert_eq!(key("one"), key("one"));
    assert_ne!(key("one"), key("two"));
}

#[test]
fn summaries_link_to_nothing_but_directories_of_results() {
    let to = |d: &str| html(&[ResultLine { directory: Some(d.to_owned()), ..line("a", "bijective") }]);
    assert!(to("00ff").contains("<a href=\"00ff/audit.json\">"));
    for hostile in ["javascript:alert(1)//", "../x", "//host"] {
        assert!(!to(hostile).contains("<a "), "{hostile}");
    }
}

#[test]
fn summaries_escape_names() {
    let lines = [line("a", "bijective")];
    assert!(markdown(&lines).contains("pair <a> \\| \"x\" "));
    assert!(html(&lines).contains("pair &lt;a&gt; | &quot;x&quot;"));
}
