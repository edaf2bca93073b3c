//! Attributes from files.

use std::path::Path;

use rustc_hash::FxHashMap;
use serde_json::{Map, Value};

use super::{Attribute, AttributeError, Domain, Values};
use crate::mesh::{self, Column, ColumnKind, TriMesh};

/// Reads attributes of a mesh from a file: PLY (properties), OBJ (`vt`), CSV or JSON, by its extension.
///
/// # Errors
/// [`AttributeError`], with file and place.
pub fn read(path: &Path, mesh: &TriMesh) -> Result<Vec<Attribute>, AttributeError> {
    let file = path.display().to_string();
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    let text = || -> Result<Vec<u8>, AttributeError> {
        let fail = |reason: String| AttributeError::File { file: file.clone(), reason };
        match std::fs::metadata(path) {
            Ok(there) if !there.is_file() => Err(fail("is not a regular file".to_owned())),
            Ok(_) => std::fs::read(path).map_err(|e| fail(e.to_string())),
            Err(e) => Err(fail(e.to_string())),
        }
    };
    match extension.as_str() {
        "csv" => from_csv(&text()?, &file, mesh),
        "json" => from_json(&text()?, &file, mesh),
        _ => Ok(from_columns(mesh::columns(path)?)),
    }
}

/// Columns of a mesh file. `u` and `v` of corners become `uv`; integers at vertices are labels, bytes called
/// `red`, `green`, `blue`, `alpha` are colours; on triangles all numbers are copied.
#[must_use]
pub fn from_columns(columns: Vec<Column>) -> Vec<Attribute> {
    let mut out: Vec<Attribute> = Vec::new();
    for column in columns {
        let Column { name, domain, kind, values } = column;
        if domain == Domain::Corner
            && name == "v"
            && let Some(Attribute { name: first, values: Values::Numbers { width, data, .. }, .. }) =
                out.last_mut()
            && first == "u"
            && data.len() == values.len()
        {
            *data = data.iter().zip(&values).flat_map(|(u, v)| [*u, *v]).collect();
            (*first, *width) = ("uv".to_owned(), 2);
            continue;
        }
        let colour = matches!(name.as_str(), "red" | "green" | "blue" | "alpha");
        let values = match kind {
            ColumnKind::Byte if colour => Values::Numbers { width: 1, data: values, bytes: true },
            ColumnKind::Byte | ColumnKind::Integer => labels(values.iter().map(f64::to_string)),
            ColumnKind::Real => Values::Numbers { width: 1, data: values, bytes: false },
        };
        out.push(Attribute { name, domain, values });
    }
    out
}

/// Labels numbered by first use.
fn labels(texts: impl Iterator<Item = String>) -> Values {
    let (mut names, mut index) = (Vec::new(), FxHashMap::default());
    let of = texts
        .map(|text| {
            *index.entry(text).or_insert_with_key(|text: &String| {
                names.push(text.clone());
                // There are no more labels than bytes in a file, and no more elements than 32 bits count.
                u32::try_from(names.len() - 1).unwrap_or(u32::MAX)
            })
        })
        .collect();
    Values::Labels { of, names }
}

/// A table: the first column is headed `vertex` or `face` and holds every id once, in any order. A column is
/// of numbers if all its entries are, and of labels otherwise or where its name ends in `:label`. Fields are
/// separated by commas, without quotes.
///
/// # Errors
/// [`AttributeError::Line`].
pub fn from_csv(bytes: &[u8], file: &str, mesh: &TriMesh) -> Result<Vec<Attribute>, AttributeError> {
    let fail = |line: usize, reason: String| AttributeError::Line { file: file.to_owned(), line, reason };
    let text = std::str::from_utf8(bytes).map_err(|e| AttributeError::File {
        file: file.to_owned(),
        reason: format!("byte {} is not UTF-8", e.valid_up_to()),
    })?;
    let mut lines = (1_usize..).zip(text.lines()).filter(|(_, l)| !l.trim().is_empty());
    let (number, header) = lines.next().ok_or_else(|| fail(1, "the table is empty".to_owned()))?;
    let mut heads = header.split(',').map(str::trim);
    let (domain, count) = match heads.next() {
        Some("vertex") => (Domain::Vertex, mesh.vertices.len()),
        Some("face") => (Domain::Face, mesh.faces.len()),
        _ => return Err(fail(number, "the first column must be `vertex` or `face`".to_owned())),
    };
    let heads: Vec<&str> = heads.collect();
    if heads.is_empty() || heads.iter().any(|h| h.is_empty()) {
        return Err(fail(number, "a column without a name, or none".to_owned()));
    }
    let mut rows: Vec<Option<Vec<&str>>> = vec![None; count];
    for (number, line) in lines {
        let mut fields = line.split(',').map(str::trim);
        let id = fields.next().and_then(|id| id.parse::<usize>().ok());
        let slot = id.and_then(|id| rows.get_mut(id));
        let slot = slot.ok_or_else(|| fail(number, format!("no id below {count} in the first column")))?;
        let fields: Vec<&str> = fields.collect();
        if fields.len() != heads.len() || line.contains('"') {
            return Err(fail(number, format!("not {} plain fields after the id", heads.len())));
        }
        if slot.replace(fields).is_some() {
            return Err(fail(number, "an id for the second time".to_owned()));
        }
    }
    if let Some(id) = rows.iter().position(Option::is_none) {
        return Err(AttributeError::File { file: file.to_owned(), reason: format!("no row for id {id}") });
    }
    let rows: Vec<Vec<&str>> = rows.into_iter().flatten().collect();
    Ok(heads.iter().enumerate().map(|(k, head)| csv_column(head, domain, &rows, k)).collect())
}

fn csv_column(head: &str, domain: Domain, rows: &[Vec<&str>], k: usize) -> Attribute {
    let number = |row: &Vec<&str>| row[k].parse::<f64>().ok().filter(|x| x.is_finite());
    let numbers: Option<Vec<f64>> = rows.iter().map(number).collect();
    let values = match (head.strip_suffix(":label"), numbers) {
        (None, Some(data)) => Values::Numbers { width: 1, data, bytes: false },
        _ => labels(rows.iter().map(|row| row[k].to_owned())),
    };
    let name = head.strip_suffix(":label").unwrap_or(head).to_owned();
    Attribute { name, domain, values }
}

/// An object with any of `vertex`, `face`, `corner` (name to list of numbers, of lists of numbers, or of
/// texts) and `sets` (`vertex` or `face` to name to list of ids).
///
/// # Errors
/// [`AttributeError::File`].
pub fn from_json(bytes: &[u8], file: &str, mesh: &TriMesh) -> Result<Vec<Attribute>, AttributeError> {
    let fail = |reason: String| AttributeError::File { file: file.to_owned(), reason };
    let value: Value = serde_json::from_slice(bytes).map_err(|e| fail(e.to_string()))?;
    let object = |value: &Value, what: &str| -> Result<Map<String, Value>, AttributeError> {
        value.as_object().cloned().ok_or_else(|| fail(format!("{what}: an object is wanted")))
    };
    let mut out = Vec::new();
    for (key, value) in object(&value, "the file")? {
        let members = object(&value, &key)?;
        if key == "sets" {
            for (domain, sets) in members {
                let (domain, count) = match domain.as_str() {
                    "vertex" => (Domain::Vertex, mesh.vertices.len()),
                    "face" => (Domain::Face, mesh.faces.len()),
                    _ => return Err(fail(format!("sets: `{domain}` is neither `vertex` nor `face`"))),
                };
                for (name, ids) in object(&sets, "sets")? {
                    let set = json_set(&ids, count).map_err(|e| fail(format!("set {name}: {e}")))?;
                    out.push(Attribute { name, domain, values: set });
                }
            }
            continue;
        }
        let domain = match key.as_str() {
            "vertex" => Domain::Vertex,
            "face" => Domain::Face,
            "corner" => Domain::Corner,
            _ => return Err(fail(format!("`{key}` is none of vertex, face, corner, sets"))),
        };
        for (name, list) in members {
            let values = json_values(&list).ok_or_else(|| {
                fail(format!(
                    "{key} {name}: not a list of finite numbers, of lists of as many numbers, or of texts"
                ))
            })?;
            out.push(Attribute { name, domain, values });
        }
    }
    Ok(out)
}

fn json_set(ids: &Value, count: usize) -> Result<Values, String> {
    let mut members = vec![false; count];
    for id in ids.as_array().ok_or("a list of ids is wanted")? {
        let place = id.as_u64().and_then(|id| usize::try_from(id).ok()).and_then(|id| members.get_mut(id));
        *place.ok_or_else(|| format!("{id} is no id below {count}"))? = true;
    }
    Ok(Values::Set(members))
}

fn json_values(list: &Value) -> Option<Values> {
    let list = list.as_array()?;
    let finite = |x: &Value| x.as_f64().filter(|x| x.is_finite());
    match list.first() {
        Some(Value::String(_)) => {
            let texts: Option<Vec<String>> = list.iter().map(|x| x.as_str().map(str::to_owned)).collect();
            Some(labels(texts?.into_iter()))
        }
        Some(Value::Array(first)) if !first.is_empty() => {
            let mut data = Vec::new();
            for row in list {
                let row = row.as_array().filter(|row| row.len() == first.len())?;
                data.extend(row.iter().map(finite).collect::<Option<Vec<f64>>>()?);
            }
            Some(Values::Numbers { width: first.len(), data, bytes: false })
        }
        _ => {
            let data: Option<Vec<f64>> = list.iter().map(finite).collect();
            Some(Values::Numbers { width: 1, data: data?, bytes: false })
        }
    }
}
