//! Summary pages of results.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::journal::ResultLine;

fn counts(lines: &[ResultLine]) -> BTreeMap<&str, usize> {
    lines.iter().fold(BTreeMap::new(), |mut out, l| {
        *out.entry(l.verdict.as_str()).or_default() += 1;
        out
    })
}

/// A page in Markdown: how many of each verdict, then one row a result.
#[must_use]
pub fn markdown(lines: &[ResultLine]) -> String {
    let mut out = format!("# Audits\n\n{} results\n\n", lines.len());
    for (verdict, n) in counts(lines) {
        let _ = writeln!(out, "- {verdict}: {n}");
    }
    out += "\n| audit | verdict | seconds | proof bytes | in words |\n|---|---|---|---|---|\n";
    let cell = |text: &str| text.replace('|', "\\|").replace(['\n', '\r'], " ");
    for l in lines {
        let (name, verdict, words) = (cell(&l.name), cell(&l.verdict), cell(&l.summary));
        let _ = writeln!(out, "| {name} | {verdict} | {:.1} | {} | {words} |", l.seconds, l.document_bytes);
    }
    out
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Directories are named by keys. Results to be merged come from anywhere, and a link may be a script.
fn is_key(directory: &str) -> bool {
    directory.bytes().all(|b| b.is_ascii_hexdigit())
}

/// The same page in HTML.
#[must_use]
pub fn html(lines: &[ResultLine]) -> String {
    let mut out = "<!doctype html>\n<meta charset=\"utf-8\">\n<title>Audits</title>\n<style>body{font-family:sans-serif}\
                   td,th{padding:.2em .6em;text-align:left;border-bottom:1px solid #ccc}</style>\n<h1>Audits</h1>\n<ul>\n"
        .to_owned();
    for (verdict, n) in counts(lines) {
        let _ = writeln!(out, "<li>{}: {n}", escaped(verdict));
    }
    out += "</ul>\n<table>\n<tr><th>audit<th>verdict<th>seconds<th>proof bytes<th>in words\n";
    for l in lines {
        let (name, verdict, words) = (escaped(&l.name), escaped(&l.verdict), escaped(&l.summary));
        let name = match &l.directory {
            Some(d) if is_key(d) => format!("<a href=\"{d}/audit.json\">{name}</a>"),
            _ => name,
        };
        let _ = writeln!(
            out,
            "<tr><td>{name}<td>{verdict}<td>{:.1}<td>{}<td>{words}",
            l.seconds, l.document_bytes
        );
    }
    out + "</table>\n"
}
