//! The header of a PLY file.

use crate::mesh::error::{Fault, Located};
use crate::mesh::format::Format;
use crate::mesh::text::{Lines, integer, quote, quote_or_end, tokens};

/// More elements or properties than any file needs: a bound on what a hostile header can ask for.
const MOST: usize = 1000;

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Type {
    fn parse(token: Option<&[u8]>) -> Result<Self, Fault> {
        match token.unwrap_or_default() {
            b"char" | b"int8" => Ok(Self::I8),
            b"uchar" | b"uint8" => Ok(Self::U8),
            b"short" | b"int16" => Ok(Self::I16),
            b"ushort" | b"uint16" => Ok(Self::U16),
            b"int" | b"int32" => Ok(Self::I32),
            b"uint" | b"uint32" => Ok(Self::U32),
            b"float" | b"float32" => Ok(Self::F32),
            b"double" | b"float64" => Ok(Self::F64),
            _ => Err(Fault::expected("a PLY number type", quote_or_end(token))),
        }
    }

    /// Bytes in a binary file.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Whether values are whole numbers.
    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// What a property holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Type),
    List { count: Type, item: Type },
}

/// A property of an element.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

/// A kind of element, as declared.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// Fewest bytes of one element in a binary file: with empty lists.
    pub(super) fn least_size(&self) -> usize {
        let least = |p: &Property| match p.kind {
            Kind::Scalar(ty) | Kind::List { count: ty, .. } => ty.size(),
        };
        self.properties.iter().map(least).sum()
    }
}

/// A whole header.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) format: Format,
    pub(super) elements: Vec<Element>,
}

impl Header {
    pub(super) fn element(&self, name: &str) -> Option<&Element> {
        self.elements.iter().find(|e| e.name == name)
    }
}

/// Whether the first line is `ply`.
pub(super) fn has_magic(bytes: &[u8]) -> bool {
    bytes.strip_prefix(b"ply").is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace))
}

/// Parses the header; the lines returned begin after it.
pub(super) fn parse(bytes: &[u8]) -> Result<(Header, Lines<'_>), Located> {
    let mut lines = Lines::new(bytes);
    let (_, first) = lines.next().ok_or(Fault::Empty)?;
    if first.trim_ascii() != b"ply" {
        return Err(Fault::expected("\"ply\"", quote(first)).at_line(1));
    }
    let mut format = None;
    let mut elements = Vec::new();
    loop {
        let Some((number, line)) = lines.next() else {
            return Err(Fault::expected("end_header", "the end of the file").into());
        };
        if line.trim_ascii() == b"end_header" {
            let format =
                format.ok_or_else(|| Fault::BadHeader("no format line".to_owned()).at_line(number))?;
            return Ok((Header { format, elements }, lines));
        }
        statement(line, &mut format, &mut elements).map_err(|f| f.at_line(number))?;
    }
}

fn statement(line: &[u8], format: &mut Option<Format>, elements: &mut Vec<Element>) -> Result<(), Fault> {
    let mut words = tokens(line);
    let full =
        |n: usize| if n < MOST { Ok(()) } else { Err(Fault::BadHeader(format!("more than {MOST} entries"))) };
    match words.next() {
        None | Some(b"comment" | b"obj_info") => return Ok(()),
        Some(b"format") => {
            let word = words.next();
            *format = Some(match word {
                Some(b"ascii") => Format::PlyAscii,
                Some(b"binary_little_endian") => Format::PlyBinaryLe,
                Some(b"binary_big_endian") => Format::PlyBinaryBe,
                _ => return Err(Fault::expected("a PLY format", quote_or_end(word))),
            });
            let version = words.next();
            if version != Some(b"1.0") {
                return Err(Fault::expected("version 1.0", quote_or_end(version)));
            }
        }
        Some(b"element") => {
            full(elements.len())?;
            let name = name(words.next())?;
            if elements.iter().any(|e| e.name == name) {
                return Err(Fault::BadHeader(format!(
                    "element {} is declared twice",
                    quote(name.as_bytes())
                )));
            }
            let count = integer(words.next(), "the number of elements")?;
            elements.push(Element { name, count, properties: Vec::new() });
        }
        Some(b"property") => {
            let element = elements
                .last_mut()
                .ok_or_else(|| Fault::BadHeader("a property before the first element".to_owned()))?;
            full(element.properties.len())?;
            let property = property(&mut words)?;
            if element.properties.iter().any(|p| p.name == property.name) {
                let name = quote(property.name.as_bytes());
                return Err(Fault::BadHeader(format!("property {name} is declared twice")));
            }
            element.properties.push(property);
        }
        Some(other) => return Err(Fault::expected("a PLY header line", quote(other))),
    }
    match words.next() {
        Some(more) => Err(Fault::expected("the end of the line", quote(more))),
        None => Ok(()),
    }
}

fn property(words: &mut dyn Iterator<Item = &[u8]>) -> Result<Property, Fault> {
    let first = words.next();
    let kind = if first == Some(b"list") {
        let (count, item) = (Type::parse(words.next())?, Type::parse(words.next())?);
        if !count.is_integer() {
            return Err(Fault::BadHeader("the length of a list is not an integer type".to_owned()));
        }
        Kind::List { count, item }
    } else {
        Kind::Scalar(Type::parse(first)?)
    };
    Ok(Property { name: name(words.next())?, kind })
}

fn name(token: Option<&[u8]>) -> Result<String, Fault> {
    token
        .and_then(|t| std::str::from_utf8(t).ok())
        .map(ToOwned::to_owned)
        .ok_or_else(|| Fault::expected("a name", quote_or_end(token)))
}
