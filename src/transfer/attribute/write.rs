//! Attributes to files.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use super::{Attribute, AttributeError, Domain, Values};
use crate::mesh::TriMesh;

/// A mesh with the attributes as properties (PLY, text), and a comment unless it is empty. Labels that are all integers are written as such,
/// others as numbers that the header's comments explain. White space in names becomes `_`.
#[must_use]
pub fn to_ply(mesh: &TriMesh, attributes: &[Attribute], comment: &str) -> Vec<u8> {
    let of = |domain: Domain, taken: &[&str]| -> Vec<Property> {
        let mut names: Vec<String> = taken.iter().map(|t| (*t).to_owned()).collect();
        attributes.iter().filter(|a| a.domain == domain).flat_map(|a| properties(a, &mut names)).collect()
    };
    let vertex = of(Domain::Vertex, &["x", "y", "z"]);
    let face = of(Domain::Face, &["vertex_indices"]);
    let mut out = "ply\nformat ascii 1.0\n".to_owned();
    for line in comment.lines() {
        let _ = writeln!(out, "comment {line}");
    }
    for comment in vertex.iter().chain(&face).flat_map(|p| &p.comments) {
        let _ = writeln!(out, "comment {comment}");
    }
    let _ = writeln!(out, "element vertex {}", mesh.vertices.len());
    out += "property double x\nproperty double y\nproperty double z\n";
    for p in &vertex {
        let _ = writeln!(out, "property {} {}", p.ty, p.name);
    }
    let _ = writeln!(out, "element face {}\nproperty list uchar uint vertex_indices", mesh.faces.len());
    for p in &face {
        let _ = writeln!(out, "property {} {}", p.ty, p.name);
    }
    out += "end_header\n";
    let rest = |out: &mut String, properties: &[Property], row: usize| {
        for p in properties {
            let _ = write!(out, " {}", p.texts.get(row).map_or("0", String::as_str));
        }
        out.push('\n');
    };
    for (row, [x, y, z]) in mesh.vertices.iter().enumerate() {
        let _ = write!(out, "{x:?} {y:?} {z:?}");
        rest(&mut out, &vertex, row);
    }
    for (row, [a, b, c]) in mesh.faces.iter().enumerate() {
        let _ = write!(out, "3 {a} {b} {c}");
        rest(&mut out, &face, row);
    }
    out.into_bytes()
}

struct Property {
    name: String,
    ty: &'static str,
    texts: Vec<String>,
    comments: Vec<String>,
}

fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}

fn properties(attribute: &Attribute, taken: &mut Vec<String>) -> Vec<Property> {
    let mut new = |name: &str, ty, texts| {
        let stem = plain(name);
        let mut name = stem.clone();
        let mut n = 2;
        while name.is_empty() || taken.contains(&name) {
            name = format!("{stem}_{n}");
            n += 1;
        }
        taken.push(name.clone());
        Property { name, ty, texts, comments: Vec::new() }
    };
    match &attribute.values {
        Values::Numbers { width, data, bytes } => (0..*width)
            .map(|c| {
                let name =
                    if *width == 1 { attribute.name.clone() } else { format!("{}_{c}", attribute.name) };
                let column = data.iter().skip(c).step_by(*width);
                let byte = |x: &f64| format!("{}", x.round_ties_even().clamp(0.0, 255.0));
                let texts = if *bytes {
                    column.map(byte).collect()
                } else {
                    column.map(|x| format!("{x:?}")).collect()
                };
                new(&name, if *bytes { "uchar" } else { "double" }, texts)
            })
            .collect(),
        Values::Labels { of, names } => {
            let integers = names.iter().all(|n| n.parse::<i32>().is_ok());
            let text = |l: &u32| if integers { label(names, *l).to_owned() } else { l.to_string() };
            let mut p = new(&attribute.name, "int", of.iter().map(text).collect());
            if !integers {
                p.comments = names
                    .iter()
                    .enumerate()
                    .map(|(i, n)| format!("label {} {i} {}", p.name, plain(n)))
                    .collect();
            }
            vec![p]
        }
        Values::Set(members) => {
            vec![new(&attribute.name, "uchar", members.iter().map(|m| u8::from(*m).to_string()).collect())]
        }
    }
}

/// A table of values of vertices or of triangles; it reads back with [`from_csv`](super::from_csv). Commas,
/// quotes and line breaks in names become `_`.
///
/// # Errors
/// [`AttributeError::BothDomains`].
pub fn to_csv(attributes: &[Attribute]) -> Result<Vec<u8>, AttributeError> {
    let domain = attributes.first().map_or(Domain::Vertex, |a| a.domain);
    if attributes.iter().any(|a| a.domain != domain) {
        return Err(AttributeError::BothDomains);
    }
    let safe = |text: &str| text.replace([',', '"', '\n', '\r'], "_");
    let mut head = if domain == Domain::Face { "face" } else { "vertex" }.to_owned();
    let mut columns: Vec<Box<dyn Fn(usize) -> String + '_>> = Vec::new();
    for a in attributes {
        match &a.values {
            Values::Numbers { width, data, .. } => {
                for c in 0..*width {
                    let name = if *width == 1 { a.name.clone() } else { format!("{}_{c}", a.name) };
                    let _ = write!(head, ",{}", safe(&name));
                    columns.push(Box::new(move |row| format!("{:?}", data[row * width + c])));
                }
            }
            Values::Labels { of, names } => {
                let _ = write!(head, ",{}:label", safe(&a.name));
                columns.push(Box::new(move |row| safe(label(names, of[row]))));
            }
            Values::Set(members) => {
                let _ = write!(head, ",{}:label", safe(&a.name));
                columns.push(Box::new(move |row| u8::from(members[row]).to_string()));
            }
        }
    }
    let mut out = head + "\n";
    for row in 0..attributes.iter().map(|a| a.values.len()).min().unwrap_or(0) {
        let fields: Vec<String> = columns.iter().map(|c| c(row)).collect();
        let _ = writeln!(out, "{row},{}", fields.join(","));
    }
    Ok(out.into_bytes())
}

/// The structure that [`from_json`](super::from_json) reads.
#[must_use]
pub fn to_json(attributes: &[Attribute]) -> Value {
    let (mut out, mut sets) = (Vec::new(), Vec::new());
    for domain in [Domain::Vertex, Domain::Face, Domain::Corner] {
        let (mut values, mut members) = (Map::new(), Map::new());
        for a in attributes.iter().filter(|a| a.domain == domain) {
            let into = if matches!(a.values, Values::Set(_)) { &mut members } else { &mut values };
            into.insert(a.name.clone(), json_values(&a.values));
        }
        let name = match domain {
            Domain::Vertex => "vertex",
            Domain::Face => "face",
            Domain::Corner => "corner",
        };
        out.push((name.to_owned(), values));
        sets.push((name.to_owned(), members));
    }
    let objects = |parts: Vec<(String, Map<String, Value>)>| -> Map<String, Value> {
        parts.into_iter().filter(|(_, m)| !m.is_empty()).map(|(name, m)| (name, Value::Object(m))).collect()
    };
    let (mut out, sets) = (objects(out), objects(sets));
    if !sets.is_empty() {
        out.insert("sets".to_owned(), Value::Object(sets));
    }
    Value::Object(out)
}

fn json_values(values: &Values) -> Value {
    match values {
        Values::Numbers { width: 0 | 1, data, .. } => json!(data),
        Values::Numbers { width, data, .. } => data.chunks(*width).map(|row| json!(row)).collect(),
        Values::Labels { of, names } => of.iter().map(|&l| json!(label(names, l))).collect(),
        Values::Set(members) => {
            members.iter().enumerate().filter(|(_, m)| **m).map(|(i, _)| json!(i)).collect()
        }
    }
}

fn label(names: &[String], index: u32) -> &str {
    names.get(index as usize).map_or("", String::as_str)
}
