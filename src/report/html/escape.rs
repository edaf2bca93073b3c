//! Texts from outside, made harmless.

use serde::Serialize;

/// Text for HTML content and quoted attributes. Control characters, which no table needs, become visible.
pub(super) fn text(raw: &str) -> String {
    let mut out = String::with_capacity(raw.len());
    for c in raw.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            c if c.is_control() => out.push(char::REPLACEMENT_CHARACTER),
            c => out.push(c),
        }
    }
    out
}

/// JSON for a `script` element: within it only `<` can end the element or open a comment.
pub(super) fn json<T: Serialize>(value: &T) -> String {
    // Only maps with keys that are no texts and failing `Serialize` have no JSON; a scene has neither.
    serde_json::to_string(value).unwrap_or_else(|_| "null".to_owned()).replace('<', "\\u003c")
}
