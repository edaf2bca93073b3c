//! MEDIT `.mesh`, text: a keyword, a count, then that many rows of numbers. Indices count from 1.

use super::error::{Fault, Located};
use super::parts::{Parts, countable, vertex};
use super::scan::{Kind, Mode, Scan};
use super::text::with_room;

/// Keywords of rows that say nothing about where the cells are, with the numbers in a row (`None`: the dimension).
const ROWS: [(&str, Option<u64>); 10] = [
    ("Corners", Some(1)),
    ("Ridges", Some(1)),
    ("RequiredVertices", Some(1)),
    ("RequiredEdges", Some(1)),
    ("RequiredTriangles", Some(1)),
    ("Normals", None),
    ("Tangents", None),
    ("NormalAtVertices", Some(2)),
    ("TangentAtVertices", Some(2)),
    ("TangentAtEdges", Some(3)),
];

/// Whether the first word of a file says that it is of this format.
pub(super) fn is_magic(word: &[u8]) -> bool {
    word == b"MeshVersionFormatted"
}

/// Parses a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Parts, Located> {
    let mut reader = Reader { scan: Scan::new(bytes), parts: Parts::default(), dimension: 3 };
    while let Some(word) = reader.word() {
        if word == b"End" {
            break;
        }
        reader.section(word)?;
    }
    Ok(reader.parts)
}

struct Reader<'a> {
    scan: Scan<'a>,
    parts: Parts,
    dimension: u64,
}

impl<'a> Reader<'a> {
    /// The next word that is not in a comment.
    fn word(&mut self) -> Option<&'a [u8]> {
        while self.scan.peek()?.starts_with(b"#") {
            self.scan.skip_space();
            self.scan.line()?;
        }
        self.scan.word()
    }

    fn section(&mut self, word: &[u8]) -> Result<(), Located> {
        match word {
            b"MeshVersionFormatted" => self.scan.count("a version").map(|_| ()),
            b"Dimension" => {
                self.dimension = self.scan.count("a dimension")?;
                self.parts.planar = self.dimension == 2;
                let what = format!("dimension {}", self.dimension);
                if matches!(self.dimension, 2 | 3) {
                    Ok(())
                } else {
                    Err(self.scan.fault(Fault::Unsupported(what)))
                }
            }
            b"Vertices" => self.vertices(),
            b"Triangles" => self.cells(3),
            b"Quadrilaterals" => self.cells(4),
            b"Tetrahedra" => self.tets(),
            b"Edges" => {
                let count = self.scan.count("a count")?;
                self.parts.lower = self.parts.lower.saturating_add(count);
                self.skip(count, 3)
            }
            other => self.other(other),
        }
    }

    fn other(&mut self, word: &[u8]) -> Result<(), Located> {
        let row = ROWS.iter().find(|(name, _)| name.as_bytes() == word);
        let Some((_, width)) = row else {
            let solids: [&[u8]; 3] = [b"Hexahedra", b"Prisms", b"Pyramids"];
            if !solids.contains(&word) {
                return Err(self.scan.wanted("a MEDIT keyword", Some(word)));
            }
            let count = self.scan.count("a count")?;
            let what = format!("the section {}", String::from_utf8_lossy(word));
            return if count == 0 { Ok(()) } else { Err(self.scan.fault(Fault::Unsupported(what))) };
        };
        let count = self.scan.count("a count")?;
        self.skip(count, width.unwrap_or(self.dimension))
    }

    fn skip(&mut self, count: u64, width: u64) -> Result<(), Located> {
        self.scan.skip(Kind::F64, count.saturating_mul(width), "a number")
    }

    fn vertices(&mut self) -> Result<(), Located> {
        let count = self.scan.count("a count")?;
        countable("vertices", count).map_err(|f| self.scan.fault(f))?;
        if !self.parts.builder.mesh.vertices.is_empty() {
            return Err(self.scan.fault(Fault::BadHeader("there are two sections of vertices".to_owned())));
        }
        let mut vertices = with_room(count, self.scan.rest().len(), 6);
        for _ in 0..count {
            let mut point = [0.0; 3];
            for x in point.iter_mut().take(if self.dimension == 2 { 2 } else { 3 }) {
                *x = self.scan.coordinate(Kind::F64)?;
            }
            self.scan.integer(Kind::I32, "a reference")?;
            vertices.push(point);
        }
        self.parts.builder.mesh.vertices = vertices;
        Ok(())
    }

    /// A row of vertices counted from 1, and a reference.
    fn row(&mut self, corners: &mut [u32]) -> Result<(), Located> {
        debug_assert_eq!(self.scan.mode(), Mode::Text);
        for corner in corners {
            let written = self.scan.integer(Kind::I32, "a vertex index")?;
            let index = vertex(written.saturating_sub(1), self.parts.builder.mesh.vertices.len());
            *corner = index.map_err(|f| self.scan.fault(as_written(f, written)))?;
        }
        self.scan.integer(Kind::I32, "a reference").map(|_| ())
    }

    fn cells(&mut self, corners: usize) -> Result<(), Located> {
        let count = self.scan.count("a count")?;
        let mut row = vec![0; corners];
        for _ in 0..count {
            self.row(&mut row)?;
            self.parts.builder.polygon(&row).map_err(|f| self.scan.fault(f))?;
        }
        Ok(())
    }

    fn tets(&mut self) -> Result<(), Located> {
        let count = self.scan.count("a count")?;
        if self.parts.tets.is_empty() {
            self.parts.tets = with_room(count, self.scan.rest().len(), 10);
        }
        let mut row = [0; 4];
        for _ in 0..count {
            self.row(&mut row)?;
            self.parts.tets.push(row);
        }
        Ok(())
    }
}

/// The same fault with the index as the file has it.
fn as_written(fault: Fault, written: i128) -> Fault {
    match fault {
        Fault::IndexOutOfRange { vertices, .. } => {
            Fault::IndexOutOfRange { index: written.to_string(), vertices }
        }
        other => other,
    }
}
