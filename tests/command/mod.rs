//! Running the command, finding the data, checking JSON against a schema.
#![allow(dead_code)] // each test program uses a part of it

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

pub(crate) fn homeo<S: AsRef<OsStr>>(arguments: &[S]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_homeo")).args(arguments).stdin(Stdio::null()).output().unwrap()
}

pub(crate) fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or(-1)
}

pub(crate) fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The directory of real shells; `None`, and a loud word, where it is absent.
pub(crate) fn shells(test: &str) -> Option<PathBuf> {
    let root = std::env::var_os("HOMEO_DATA")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data"), PathBuf::from);
    let directory = root.join("thirdparty/shells");
    if directory.is_dir() {
        return Some(directory);
    }
    eprintln!("SKIPPED: {test}: there are no real shells at {}", directory.display());
    None
}

/// The sample of the demo, kept in `directory`: `demo.h5`, `demo.cert`, `damaged.h5`, `damaged.cert`.
pub(crate) fn demo(directory: &Path) {
    let done = homeo(&[OsStr::new("demo"), OsStr::new("--out"), directory.as_os_str()]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
}

pub(crate) fn path(directory: &Path, name: &str) -> String {
    directory.join(name).to_str().unwrap().to_owned()
}

/// The published schema of a command's JSON.
pub(crate) fn schema(name: &str) -> Value {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("schema").join(format!("{name}.schema.json"));
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

/// Validates by the part of JSON Schema that our schemas use; a keyword outside it is an error.
pub(crate) fn validate(value: &Value, schema: &Value, at: &str) -> Result<(), String> {
    let keywords = schema.as_object().ok_or("a schema is an object")?;
    for (keyword, rule) in keywords {
        match keyword.as_str() {
            "$schema" | "title" | "description" => {}
            "type" => has_type(value, rule, at)?,
            "enum" if rule.as_array().unwrap().contains(value) => {}
            "enum" => return Err(format!("{at}: {value} is not one of {rule}")),
            "minimum" if value.as_f64().is_none_or(|x| x >= rule.as_f64().unwrap()) => {}
            "minimum" => return Err(format!("{at}: {value} is less than {rule}")),
            "minItems" | "maxItems" => {
                let (n, bound) = (value.as_array().map(Vec::len), rule.as_u64().unwrap() as usize);
                if n.is_some_and(|n| if keyword == "minItems" { n < bound } else { n > bound }) {
                    return Err(format!("{at}: {n:?} items, {keyword} {bound}"));
                }
            }
            "items" => {
                for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                    validate(item, rule, &format!("{at}[{i}]"))?;
                }
            }
            "required" => {
                for key in rule.as_array().unwrap() {
                    if value.as_object().is_some_and(|o| !o.contains_key(key.as_str().unwrap())) {
                        return Err(format!("{at}: {key} is missing"));
                    }
                }
            }
            "properties" | "additionalProperties" => members(value, keywords, at)?,
            other => return Err(format!("{at}: the test does not know the keyword {other}")),
        }
    }
    Ok(())
}

fn members(value: &Value, keywords: &serde_json::Map<String, Value>, at: &str) -> Result<(), String> {
    let Some(object) = value.as_object() else { return Ok(()) };
    for (key, member) in object {
        let at = format!("{at}.{key}");
        let known = keywords.get("properties").and_then(|p| p.get(key));
        match (known, keywords.get("additionalProperties")) {
            (Some(schema), _) => validate(member, schema, &at)?,
            (None, Some(Value::Bool(false))) => return Err(format!("{at} is not in the schema")),
            (None, Some(schema)) if schema.is_object() => validate(member, schema, &at)?,
            _ => {}
        }
    }
    Ok(())
}

fn has_type(value: &Value, rule: &Value, at: &str) -> Result<(), String> {
    let is = |name: &str| match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        other => panic!("unknown type {other}"),
    };
    let good = match rule {
        Value::String(name) => is(name),
        Value::Array(names) => names.iter().any(|n| is(n.as_str().unwrap())),
        _ => false,
    };
    if good { Ok(()) } else { Err(format!("{at}: {value} is no {rule}")) }
}
