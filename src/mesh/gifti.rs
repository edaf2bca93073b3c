//! GIFTI surfaces: XML with arrays as text, base64, or compressed base64. No entity or external file is followed.

use std::io::Read as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::error::{Fault, Located};
use super::parts::{Parts, vertex};
use super::scan::{Kind, Mode, Scan};
use super::text::{quote, with_room};

/// Whether a file holds what GIFTI files begin with, after comments and the like.
pub(super) fn is_magic(bytes: &[u8]) -> bool {
    let start = bytes.get(..2000).unwrap_or(bytes);
    start.trim_ascii_start().starts_with(b"<") && start.windows(6).any(|w| w == b"<GIFTI")
}

/// One array, as announced.
struct Array {
    index: usize,
    intent: String,
    kind: Kind,
    mode: Mode,
    encoding: Encoding,
    rows: u64,
    columns: u64,
    by_columns: bool,
    data: Vec<u8>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Encoding {
    Text,
    Base64,
    Compressed,
}

/// Parses a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Parts, Located> {
    let mut xml = Reader::from_reader(bytes);
    let mut found = Found::default();
    let mut array: Option<Array> = None;
    let mut in_data = false;
    loop {
        let event = xml.read_event().map_err(|e| broken(&e.to_string(), bytes, xml.error_position()))?;
        match event {
            Event::Start(tag) => match (tag.name().as_ref(), &array) {
                ("DataArray", None) => array = Some(Array::new(&tag, found.arrays)?),
                ("Data", Some(_)) => in_data = true,
                _ => {}
            },
            Event::Text(text) if in_data => {
                array.iter_mut().for_each(|a| a.data.extend_from_slice(text.as_bytes()));
            }
            Event::CData(text) if in_data => {
                array.iter_mut().for_each(|a| a.data.extend_from_slice(text.as_bytes()));
            }
            Event::End(tag) if tag.name().as_ref() == "Data" => in_data = false,
            Event::End(tag) if tag.name().as_ref() == "DataArray" => {
                if let Some(array) = array.take() {
                    found.take(&array)?;
                }
            }
            Event::Eof if array.is_some() => {
                return Err(Fault::expected("</DataArray>", "the end of the file").into());
            }
            Event::Eof => break,
            _ => {}
        }
    }
    found.finish()
}

/// The fault with the line of a byte.
fn broken(reason: &str, bytes: &[u8], position: u64) -> Located {
    let before = bytes.get(..usize::try_from(position).unwrap_or(usize::MAX)).unwrap_or(bytes);
    let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
    let reason: String = reason.chars().map(|c| if c.is_control() { ' ' } else { c }).take(120).collect();
    Fault::BadHeader(format!("XML: {reason}")).at_line(line)
}

fn attribute(tag: &BytesStart<'_>, name: &str) -> Result<Option<String>, Fault> {
    let found = tag.try_get_attribute(name).map_err(|e| Fault::BadHeader(format!("XML: {e}")))?;
    Ok(found.map(|a| a.value.into_owned()))
}

impl Array {
    fn new(tag: &BytesStart<'_>, index: usize) -> Result<Self, Located> {
        let attribute = |name: &str| attribute(tag, name).map_err(|f| f.at("array", index));
        let wanted = |name: &str| {
            let missing = || Fault::BadHeader(format!("the attribute {name} is missing")).at("array", index);
            attribute(name)?.ok_or_else(missing)
        };
        let unsupported = |what: &str, value: &str| {
            Fault::Unsupported(format!("{what} {}", quote(value.as_bytes()))).at("array", index)
        };
        let size = |name: &str| {
            let value = wanted(name)?;
            value.trim().parse::<u64>().map_err(|_| {
                Fault::expected(format!("a number for {name}"), quote(value.as_bytes())).at("array", index)
            })
        };
        let kind = match wanted("DataType")?.as_str() {
            "NIFTI_TYPE_FLOAT32" => Kind::F32,
            "NIFTI_TYPE_FLOAT64" => Kind::F64,
            "NIFTI_TYPE_UINT8" => Kind::Unsigned(1),
            "NIFTI_TYPE_INT32" => Kind::Signed(4),
            "NIFTI_TYPE_UINT32" => Kind::Unsigned(4),
            "NIFTI_TYPE_INT64" => Kind::Signed(8),
            "NIFTI_TYPE_UINT64" => Kind::Unsigned(8),
            other => return Err(unsupported("DataType", other)),
        };
        let encoding = match wanted("Encoding")?.as_str() {
            "ASCII" => Encoding::Text,
            "Base64Binary" => Encoding::Base64,
            "GZipBase64Binary" => Encoding::Compressed,
            other => return Err(unsupported("Encoding", other)),
        };
        let mode = match (encoding, attribute("Endian")?.as_deref()) {
            (Encoding::Text, _) => Mode::Text,
            (_, Some("BigEndian")) => Mode::Big,
            (_, Some("LittleEndian")) => Mode::Little,
            (_, other) => return Err(unsupported("Endian", other.unwrap_or("(none)"))),
        };
        let by_columns = match attribute("ArrayIndexingOrder")?.as_deref() {
            Some("ColumnMajorOrder") => true,
            None | Some("RowMajorOrder") => false,
            Some(other) => return Err(unsupported("ArrayIndexingOrder", other)),
        };
        let dimensions = size("Dimensionality")?;
        Ok(Self {
            index,
            intent: wanted("Intent")?,
            kind,
            mode,
            encoding,
            rows: size("Dim0")?,
            columns: if dimensions > 1 { size("Dim1")? } else { 1 },
            by_columns,
            data: Vec::new(),
        })
    }

    fn fault(&self, fault: Fault) -> Located {
        fault.at("array", self.index)
    }

    /// The bytes of the numbers. Memory grows only as data are found, and never beyond what the dimensions ask for.
    fn bytes(&self) -> Result<Vec<u8>, Located> {
        if self.encoding == Encoding::Text {
            return Ok(self.data.clone());
        }
        let compact: Vec<u8> = self.data.iter().copied().filter(|b| !b.is_ascii_whitespace()).collect();
        let raw = STANDARD
            .decode(&compact)
            .map_err(|e| self.fault(Fault::expected("base64", quote(e.to_string().as_bytes()))))?;
        let size = self.rows.checked_mul(self.columns).and_then(|n| n.checked_mul(self.kind.bytes() as u64));
        let size = size.unwrap_or(u64::MAX);
        let out = if self.encoding == Encoding::Compressed {
            let mut out = Vec::new();
            ZlibDecoder::new(raw.as_slice())
                .take(size.saturating_add(1))
                .read_to_end(&mut out)
                .map_err(|e| self.fault(Fault::expected("zlib data", quote(e.to_string().as_bytes()))))?;
            out
        } else {
            raw
        };
        if out.len() as u64 != size {
            let what = format!("{size} bytes of numbers");
            return Err(self.fault(Fault::expected(what, format!("{} or more", out.len()))));
        }
        Ok(out)
    }

    /// Three numbers a row, by a reader of single numbers.
    fn rows<T: Copy + Default>(
        &self,
        read: impl Fn(&mut Scan<'_>) -> Result<T, Located>,
    ) -> Result<Vec<[T; 3]>, Located> {
        if self.columns != 3 {
            return Err(self.fault(Fault::expected("3 columns", self.columns.to_string())));
        }
        let bytes = self.bytes()?;
        let mut scan = Scan::new(&bytes);
        scan.set_mode(self.mode);
        let each = 3 * self.kind.fewest_bytes(self.mode);
        let mut next = || read(&mut scan).map_err(|located| self.fault(located.fault));
        let mut flat: Vec<T> = with_room(self.rows.saturating_mul(3), bytes.len(), each / 3);
        for _ in 0..self.rows.saturating_mul(3) {
            flat.push(next()?);
        }
        if self.mode == Mode::Text
            && let Some(more) = scan.word()
        {
            return Err(self.fault(Fault::expected("no more numbers", quote(more))));
        }
        let n = flat.len() / 3;
        let at = |row: usize, column: usize| {
            let i = if self.by_columns { column * n + row } else { 3 * row + column };
            flat.get(i).copied().unwrap_or_default()
        };
        Ok((0..n).map(|row| [0, 1, 2].map(|column| at(row, column))).collect())
    }
}

#[derive(Default)]
struct Found {
    arrays: usize,
    points: Option<Vec<[f64; 3]>>,
    triangles: Option<Vec<[i128; 3]>>,
    others: usize,
}

impl Found {
    fn take(&mut self, array: &Array) -> Result<(), Located> {
        self.arrays += 1;
        let twice = || array.fault(Fault::BadHeader(format!("there are two arrays of {}", array.intent)));
        match array.intent.as_str() {
            "NIFTI_INTENT_POINTSET" if self.points.is_some() => Err(twice()),
            "NIFTI_INTENT_TRIANGLE" if self.triangles.is_some() => Err(twice()),
            "NIFTI_INTENT_POINTSET" => {
                self.points = Some(array.rows(|scan| scan.coordinate(array.kind))?);
                Ok(())
            }
            "NIFTI_INTENT_TRIANGLE" => {
                self.triangles = Some(array.rows(|scan| scan.integer(array.kind, "a vertex index"))?);
                Ok(())
            }
            _ => {
                self.others += 1;
                Ok(())
            }
        }
    }

    fn finish(self) -> Result<Parts, Located> {
        let missing = |what: &str| Fault::BadHeader(format!("there is no array of {what}"));
        let mut parts = Parts::default();
        let points = self.points.ok_or_else(|| missing("NIFTI_INTENT_POINTSET"))?;
        for (i, triangle) in
            self.triangles.ok_or_else(|| missing("NIFTI_INTENT_TRIANGLE"))?.iter().enumerate()
        {
            let mut corners = [0; 3];
            for (corner, &index) in corners.iter_mut().zip(triangle) {
                *corner = vertex(index, points.len()).map_err(|f| f.at("triangle", i))?;
            }
            parts.builder.mesh.faces.push(corners);
        }
        parts.builder.mesh.vertices = points;
        if self.others > 0 {
            parts.builder.notes.push(format!("GIFTI: ignored {} arrays", self.others));
        }
        Ok(parts)
    }
}
