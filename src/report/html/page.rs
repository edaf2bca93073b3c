//! The file: the template with its parts put in.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest as _, Sha256};

use super::escape;
use super::scene::Scene;

const TEMPLATE: &str = include_str!("assets/page.html");
const STYLE: &str = include_str!("assets/style.css");
/// One script in the order of its parts.
const SCRIPT: &str = concat!(
    "(() => {\n\"use strict\";\n",
    include_str!("assets/data.js"),
    include_str!("assets/camera.js"),
    include_str!("assets/shaders.js"),
    include_str!("assets/renderer.js"),
    include_str!("assets/gestures.js"),
    include_str!("assets/panel.js"),
    include_str!("assets/viewer.js"),
    include_str!("assets/main.js"),
    "})();\n"
);

/// The page; `title` and `summary` are HTML.
pub(super) fn fill(title: &str, summary: &str, scene: &Scene<'_>) -> String {
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; base-uri 'none'; form-action 'none'",
        digest(SCRIPT),
        digest(STYLE)
    );
    let mut out = String::new();
    let mut parts = TEMPLATE.split("{{");
    out += parts.next().unwrap_or_default();
    // One pass: what is put in is never searched for marks.
    for part in parts {
        let (mark, rest) = part.split_once("}}").unwrap_or((part, ""));
        match mark {
            "policy" => out += &policy,
            "title" => out += title,
            "style" => out += STYLE,
            "summary" => out += summary,
            "scene" => out += &escape::json(scene),
            "script" => out += SCRIPT,
            other => out += other,
        }
        out += rest;
    }
    out
}

fn digest(text: &str) -> String {
    STANDARD.encode(Sha256::digest(text.as_bytes()))
}
