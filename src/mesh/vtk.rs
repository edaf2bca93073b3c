//! VTK legacy files, versions 1 to 5.1, text and binary (which is big endian): unstructured grids and polygonal data.
//! What comes after the cells (attributes) is not read.

use super::error::{Fault, Located};
use super::parts::{Parts, countable, vertex};
use super::scan::{Kind, Mode, Scan};
use super::text::{Lines, quote, tokens, with_room};

mod cells;

use cells::Lists;

const MAGIC: &[u8] = b"# vtk DataFile Version";

/// Whether a file begins as VTK legacy files do.
pub(super) fn is_magic(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// Parses a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Parts, Located> {
    let mut lines = Lines::new(bytes);
    let first = lines.next().map_or(&[][..], |(_, line)| line);
    if !is_magic(first) {
        return Err(Fault::expected("# vtk DataFile Version", quote(first)).at_line(1));
    }
    let mut reader = Reader::new(bytes)?;
    while let Some(word) = reader.keyword() {
        if matches!(word, b"POINT_DATA" | b"CELL_DATA") {
            break;
        }
        reader.section(word)?;
    }
    reader.finish()
}

struct Reader<'a> {
    scan: Scan<'a>,
    /// How the numbers of this file are stored; keywords are text in any case.
    numbers: Mode,
    parts: Parts,
    points: bool,
    lists: Option<Lists>,
    types: Option<Vec<i128>>,
}

/// The number type that a file names.
fn kind(word: &[u8]) -> Option<Kind> {
    Some(match word {
        b"float" => Kind::F32,
        b"double" => Kind::F64,
        b"char" | b"vtktypeint8" => Kind::Signed(1),
        b"unsigned_char" | b"vtktypeuint8" => Kind::Unsigned(1),
        b"short" | b"vtktypeint16" => Kind::Signed(2),
        b"unsigned_short" | b"vtktypeuint16" => Kind::Unsigned(2),
        b"int" | b"vtktypeint32" => Kind::Signed(4),
        b"unsigned_int" | b"vtktypeuint32" => Kind::Unsigned(4),
        b"long" | b"vtktypeint64" | b"vtkIdType" | b"vtkidtype" => Kind::Signed(8),
        b"unsigned_long" | b"vtktypeuint64" => Kind::Unsigned(8),
        _ => return None,
    })
}

impl<'a> Reader<'a> {
    /// Reads the three lines before the data set, and its kind.
    fn new(bytes: &'a [u8]) -> Result<Self, Located> {
        let mut scan = Scan::new(bytes);
        scan.line();
        // The title may be anything.
        scan.line();
        let encoding = scan.word();
        let numbers = match encoding {
            Some(b"ASCII") => Mode::Text,
            Some(b"BINARY") => Mode::Big,
            other => return Err(scan.wanted("ASCII or BINARY", other)),
        };
        match scan.word() {
            Some(b"DATASET") => {}
            other => return Err(scan.wanted("DATASET", other)),
        }
        match scan.word() {
            Some(b"UNSTRUCTURED_GRID" | b"POLYDATA") => {}
            Some(other) => {
                let what = format!("the data set {}", quote(other));
                return Err(scan.fault(Fault::Unsupported(what)));
            }
            None => return Err(scan.wanted("a data set", None)),
        }
        Ok(Self { scan, numbers, parts: Parts::default(), points: false, lists: None, types: None })
    }

    fn keyword(&mut self) -> Option<&'a [u8]> {
        self.scan.set_mode(Mode::Text);
        self.scan.word()
    }

    /// The numbers of a section begin: after the line break in binary files.
    fn begin_numbers(&mut self) {
        self.scan.line();
        self.scan.set_mode(self.numbers);
    }

    fn end_numbers(&mut self) {
        self.scan.set_mode(Mode::Text);
    }

    fn kind(&mut self) -> Result<Kind, Located> {
        let word = self.scan.word();
        word.and_then(|w| kind(&w.to_ascii_lowercase()).or_else(|| kind(w)))
            .ok_or_else(|| self.scan.wanted("a number type", word))
    }

    fn section(&mut self, word: &[u8]) -> Result<(), Located> {
        match word {
            b"POINTS" => self.read_points(),
            b"CELLS" => {
                self.once(self.lists.is_some(), "CELLS")?;
                self.lists = Some(self.lists("cell")?);
                Ok(())
            }
            b"CELL_TYPES" => self.read_types(),
            b"POLYGONS" => {
                let lists = self.lists("polygon")?;
                self.polygons(&lists)
            }
            b"VERTICES" | b"LINES" => {
                let lists = self.lists("cell")?;
                self.parts.lower = self.parts.lower.saturating_add(lists.len() as u64);
                Ok(())
            }
            b"METADATA" => {
                self.scan.line();
                while self.scan.line().is_some_and(|line| tokens(line).next().is_some()) {}
                Ok(())
            }
            b"FIELD" => self.skip_field(),
            b"TRIANGLE_STRIPS" => {
                Err(self.scan.fault(Fault::Unsupported("the section TRIANGLE_STRIPS".to_owned())))
            }
            other => Err(self.scan.wanted("a VTK keyword", Some(other))),
        }
    }

    /// A second section of the name would take the place of the first.
    fn once(&self, known: bool, name: &str) -> Result<(), Located> {
        if known {
            return Err(self.scan.fault(Fault::BadHeader(format!("there are two sections {name}"))));
        }
        Ok(())
    }

    fn read_points(&mut self) -> Result<(), Located> {
        let count = self.scan.count("the number of points")?;
        countable("points", count).map_err(|f| self.scan.fault(f))?;
        self.once(self.points, "POINTS")?;
        self.points = true;
        let kind = self.kind()?;
        self.begin_numbers();
        let each = 3 * kind.fewest_bytes(self.numbers);
        let mut points = with_room(count, self.scan.rest().len(), each);
        for i in 0..count {
            self.scan.at("point", i);
            let mut point = [0.0; 3];
            for x in &mut point {
                *x = self.scan.coordinate(kind)?;
            }
            points.push(point);
        }
        self.end_numbers();
        self.parts.builder.mesh.vertices = points;
        Ok(())
    }

    fn read_types(&mut self) -> Result<(), Located> {
        let count = self.scan.count("the number of cell types")?;
        self.once(self.types.is_some(), "CELL_TYPES")?;
        self.begin_numbers();
        let mut types = with_room(count, self.scan.rest().len(), Kind::I32.fewest_bytes(self.numbers));
        for i in 0..count {
            self.scan.at("cell type", i);
            types.push(self.scan.integer(Kind::I32, "a cell type")?);
        }
        self.end_numbers();
        self.types = Some(types);
        Ok(())
    }

    /// `FIELD name n`, then n arrays: `name components tuples type` and the numbers.
    fn skip_field(&mut self) -> Result<(), Located> {
        self.scan.word();
        for _ in 0..self.scan.count("the number of arrays")? {
            while self.scan.peek() == Some(b"METADATA") {
                self.keyword();
                self.section(b"METADATA")?;
            }
            if self.scan.word().is_none() {
                return Err(self.scan.wanted("an array", None));
            }
            let components = self.scan.count("the number of components")?;
            let tuples = self.scan.count("the number of tuples")?;
            let kind = self.kind()?;
            self.begin_numbers();
            self.scan.at("array", 0);
            self.scan.skip(kind, components.saturating_mul(tuples), "a number")?;
            self.end_numbers();
        }
        Ok(())
    }

    fn corner(&self, index: i128) -> Result<u32, Fault> {
        vertex(index, self.parts.builder.mesh.vertices.len())
    }

    fn corners(&self, list: &[i128]) -> Result<Vec<u32>, Fault> {
        list.iter().map(|&i| self.corner(i)).collect()
    }

    fn polygons(&mut self, lists: &Lists) -> Result<(), Located> {
        for i in 0..lists.len() {
            let corners = self.corners(lists.get(i)).map_err(|f| f.at("polygon", i))?;
            self.parts.builder.polygon(&corners).map_err(|f| f.at("polygon", i))?;
        }
        Ok(())
    }

    /// Sorts cells by their types, which come after them.
    fn finish(mut self) -> Result<Parts, Located> {
        let Some(lists) = self.lists.take() else { return Ok(self.parts) };
        let types = self.types.take().unwrap_or_default();
        if types.len() != lists.len() {
            let what = format!("{} cells, but {} cell types", lists.len(), types.len());
            return Err(Fault::BadHeader(what).into());
        }
        for (i, ty) in types.into_iter().enumerate() {
            let corners = self.corners(lists.get(i)).map_err(|f| f.at("cell", i))?;
            let done = match (ty, corners.len()) {
                (1..=4, _) => {
                    self.parts.lower += 1;
                    Ok(())
                }
                (5, 3) | (7, _) | (9, 4) => self.parts.builder.polygon(&corners),
                (10, _) => self.parts.tet(&corners),
                (5 | 9, n) => {
                    Err(Fault::expected(format!("the corners of a cell of type {ty}"), n.to_string()))
                }
                _ => Err(Fault::Unsupported(format!("VTK cell type {ty}"))),
            };
            done.map_err(|f| f.at("cell", i))?;
        }
        Ok(self.parts)
    }
}
