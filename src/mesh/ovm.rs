//! OpenVolumeMesh text files: vertices, edges, faces by half-edges, polyhedra by half-faces, and properties.
//!
//! Half-edge `2 e` runs along edge `e`, `2 e + 1` against it; half-face `2 f` is face `f` as written, `2 f + 1` reversed.
//! The half-faces of a polyhedron look into it. So a tet is the three corners of its first half-face, then the fourth:
//! positive where the mesh is not inverted.

use super::error::{Fault, Located};
use super::parts::{Parts, countable, vertex};
use super::rational;
use super::scan::Scan;
use super::text::{coordinates, integer, quote, tokens, with_room};

/// Whether the first word of a file says that it is of this format.
pub(super) fn is_magic(word: &[u8]) -> bool {
    word.eq_ignore_ascii_case(b"OVM")
}

/// Parses a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Parts, Located> {
    let mut scan = Scan::new(bytes);
    let first = scan.word();
    if !first.is_some_and(is_magic) {
        return Err(scan.wanted("OVM", first));
    }
    let encoding = scan.word();
    if !encoding.is_some_and(|w| w.eq_ignore_ascii_case(b"ASCII")) {
        return Err(scan.wanted("ASCII", encoding));
    }
    scan.line();
    let mut reader = Reader { scan, parts: Parts::default(), edges: Vec::new(), faces: Vec::new(), cells: 0 };
    while let Some(word) = reader.scan.word() {
        reader.section(&word.to_ascii_lowercase())?;
    }
    Ok(reader.parts)
}

struct Reader<'a> {
    scan: Scan<'a>,
    parts: Parts,
    edges: Vec<[u32; 2]>,
    /// The corners of each face; of no face more than three, as only tets are read.
    faces: Vec<[u32; 3]>,
    cells: u64,
}

impl<'a> Reader<'a> {
    fn section(&mut self, word: &[u8]) -> Result<(), Located> {
        match word {
            b"vertices" => self.vertices(),
            b"edges" => self.read_edges(),
            b"faces" => self.read_faces(),
            b"polyhedra" => self.polyhedra(),
            b"vprop" => self.vertex_property(),
            b"eprop" => self.skip_property(self.edges.len() as u64),
            b"heprop" => self.skip_property(2 * self.edges.len() as u64),
            b"fprop" => self.skip_property(self.faces.len() as u64),
            b"hfprop" => self.skip_property(2 * self.faces.len() as u64),
            b"cprop" => self.skip_property(self.cells),
            b"mprop" => self.skip_property(1),
            other => Err(self.scan.wanted("an OVM section", Some(other))),
        }
    }

    /// The next line with something on it, of the section named.
    fn row(&mut self, what: &str, expected: u64, found: u64) -> Result<&'a [u8], Located> {
        self.scan.skip_space();
        let truncated = || Fault::Truncated { what: what.to_owned(), expected, found }.into();
        self.scan.peek().ok_or_else(truncated)?;
        self.scan.line().ok_or_else(truncated)
    }

    /// A fault in the line that was read last.
    fn fault(&self, fault: Fault) -> Located {
        // The scanner stands at the line after.
        let mut located = self.scan.fault(fault);
        if let super::error::Place::Line(n) = &mut located.place {
            *n = n.saturating_sub(1).max(1);
        }
        located
    }

    fn count(&mut self, what: &str) -> Result<u64, Located> {
        let count = self.scan.count(&format!("the number of {what}"))?;
        // Half-edges and half-faces need the doubled index.
        countable(what, count.saturating_mul(2)).map_err(|f| self.scan.fault(f))?;
        self.scan.line();
        Ok(count)
    }

    fn vertices(&mut self) -> Result<(), Located> {
        let count = self.count("vertices")?;
        if !self.parts.builder.mesh.vertices.is_empty() {
            return Err(self.scan.fault(Fault::BadHeader("there are two sections of vertices".to_owned())));
        }
        let mut vertices = with_room(count, self.scan.rest().len(), 6);
        for found in 0..count {
            let line = self.row("vertices", count, found)?;
            vertices.push(coordinates(&mut tokens(line)).map_err(|f| self.fault(f))?);
        }
        self.parts.builder.mesh.vertices = vertices;
        Ok(())
    }

    fn read_edges(&mut self) -> Result<(), Located> {
        let count = self.count("edges")?;
        let vertices = self.parts.builder.mesh.vertices.len();
        for found in 0..count {
            let line = self.row("edges", count, found)?;
            let mut words = tokens(line);
            let mut end = || vertex(integer(words.next(), "a vertex index")?, vertices);
            let edge = end().and_then(|a| Ok([a, end()?]));
            self.edges.push(edge.map_err(|f| self.fault(f))?);
        }
        Ok(())
    }

    /// Where a half-edge begins and ends.
    fn half_edge(&self, word: Option<&[u8]>) -> Result<[u32; 2], Fault> {
        let half = half(word, self.edges.len(), "a half-edge")?;
        let [a, b] = self.edges.get(half / 2).copied().unwrap_or_default();
        Ok(if half % 2 == 0 { [a, b] } else { [b, a] })
    }

    fn face(&self, line: &[u8]) -> Result<[u32; 3], Fault> {
        let mut words = tokens(line);
        let size: u64 = integer(words.next(), "the number of half-edges")?;
        if size != 3 {
            return Err(Fault::Unsupported(format!("a face with {size} corners")));
        }
        let mut sides = [[0; 2]; 3];
        for side in &mut sides {
            *side = self.half_edge(words.next())?;
        }
        let [[a, b], [c, d], [e, f]] = sides;
        if b != c || d != e || f != a {
            return Err(Fault::BadHeader("the half-edges of a face do not follow each other".to_owned()));
        }
        Ok([a, c, e])
    }

    fn read_faces(&mut self) -> Result<(), Located> {
        let count = self.count("faces")?;
        for found in 0..count {
            let line = self.row("faces", count, found)?;
            let face = self.face(line).map_err(|f| self.fault(f))?;
            self.faces.push(face);
        }
        Ok(())
    }

    fn half_face(&self, word: Option<&[u8]>) -> Result<[u32; 3], Fault> {
        let half = half(word, self.faces.len(), "a half-face")?;
        let [a, b, c] = self.faces.get(half / 2).copied().unwrap_or_default();
        Ok(if half % 2 == 0 { [a, b, c] } else { [a, c, b] })
    }

    fn tet(&self, line: &[u8]) -> Result<[u32; 4], Fault> {
        let mut words = tokens(line);
        let size: u64 = integer(words.next(), "the number of half-faces")?;
        if size != 4 {
            return Err(Fault::Unsupported(format!("a polyhedron with {size} faces")));
        }
        let first = self.half_face(words.next())?;
        let mut all = vec![first];
        for _ in 0..3 {
            all.push(self.half_face(words.next())?);
        }
        let fourth = all.iter().flatten().copied().find(|v| !first.contains(v));
        let [a, b, c] = first;
        let no_tet = || Fault::BadHeader("the faces of a polyhedron are not those of a tet".to_owned());
        let d = fourth.ok_or_else(no_tet)?;
        // The four faces of the tet, as seen from inside, each once.
        let mut wanted = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]].map(rotated);
        let mut found: Vec<[u32; 3]> = all.into_iter().map(rotated).collect();
        wanted.sort_unstable();
        found.sort_unstable();
        if found != wanted { Err(no_tet()) } else { Ok([a, b, c, d]) }
    }

    fn polyhedra(&mut self) -> Result<(), Located> {
        let count = self.count("polyhedra")?;
        self.cells = count;
        for found in 0..count {
            let line = self.row("polyhedra", count, found)?;
            let tet = self.tet(line).map_err(|f| self.fault(f))?;
            self.parts.tets.push(tet);
        }
        if count == 0 {
            self.parts.builder.mesh.faces.clone_from(&self.faces);
        }
        Ok(())
    }

    /// Type and name, to the end of the line.
    fn property(&mut self) -> (&'a [u8], String) {
        let line = self.scan.line().unwrap_or_default().trim_ascii();
        let ty = tokens(line).next().unwrap_or_default();
        let name = line.get(ty.len()..).unwrap_or_default().trim_ascii();
        let name = name.strip_prefix(b"\"").and_then(|n| n.strip_suffix(b"\"")).unwrap_or(name);
        (ty, String::from_utf8_lossy(name).into_owned())
    }

    /// A string: `length:bytes`, or in old files the line.
    fn string(&mut self) -> Result<&'a [u8], Located> {
        let rest = self.scan.rest();
        let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let prefixed = digits > 0 && rest.get(digits) == Some(&b':');
        if !prefixed {
            return self.scan.line().ok_or_else(|| self.scan.wanted("a string", None));
        }
        let length: usize = integer(rest.get(..digits), "a length").map_err(|f| self.scan.fault(f))?;
        self.scan.take(digits + 1, "a string")?;
        let string = self.scan.take(length, "a string")?;
        self.scan.line();
        Ok(string)
    }

    fn skip_property(&mut self, count: u64) -> Result<(), Located> {
        let (ty, name) = self.property();
        for found in 0..count {
            if ty == b"string" {
                self.string()?;
            } else if self.scan.line().is_none() {
                return Err(short(&name, count, found));
            }
        }
        Ok(())
    }

    /// Strings that are all positions are kept; if the first is one, all must be.
    fn vertex_property(&mut self) -> Result<(), Located> {
        let count = self.parts.builder.mesh.vertices.len() as u64;
        let (ty, name) = self.property();
        let mut positions: Option<Vec<_>> = (ty == b"string").then(Vec::new);
        for found in 0..count {
            if ty != b"string" {
                self.scan.line().ok_or_else(|| short(&name, count, found))?;
                continue;
            }
            let string = self.string()?;
            let Some(list) = &mut positions else { continue };
            match rational::position(string.split(|&b| b == b';')) {
                Ok(point) => list.push(point),
                Err(_) if found == 0 => positions = None,
                Err(fault) => return Err(self.fault(fault)),
            }
        }
        if let Some(list) = positions.filter(|l| !l.is_empty()) {
            self.parts.exact.push((name, list));
        }
        Ok(())
    }
}

fn short(property: &str, expected: u64, found: u64) -> Located {
    let what = format!("values of the property {}", quote(property.as_bytes()));
    Fault::Truncated { what, expected, found }.into()
}

/// The index of one half of `wholes` things.
fn half(word: Option<&[u8]>, wholes: usize, what: &str) -> Result<usize, Fault> {
    let index: i128 = integer(word, what)?;
    let inside = usize::try_from(index).ok().filter(|i| i / 2 < wholes);
    inside.ok_or_else(|| Fault::expected(format!("{what} below {}", 2 * wholes as u64), index.to_string()))
}

/// The same cycle, smallest first.
fn rotated([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a <= b && a <= c {
        [a, b, c]
    } else if b <= a && b <= c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
