//! Gmsh `.msh`, versions 2.x and 4.1, text and binary: `$Nodes` with any tags, `$Elements`. Other sections are skipped.

use std::collections::BTreeMap;

use super::error::{Fault, Located};
use super::parts::{Parts, countable};
use super::scan::{Kind, Mode, Scan};
use super::text::{quote, with_room};

/// Whether the first word of a file says that it is of this format.
pub(super) fn is_magic(word: &[u8]) -> bool {
    word == b"$MeshFormat"
}

/// The layouts that are read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    Two,
    FourOne,
}

struct Reader<'a> {
    scan: Scan<'a>,
    numbers: Mode,
    version: Version,
    parts: Parts,
    tags: BTreeMap<u64, u32>,
}

/// Parses a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Parts, Located> {
    let mut reader = header(bytes)?;
    while let Some(word) = reader.scan.word() {
        match word {
            b"$Nodes" => reader.section(Reader::nodes)?,
            b"$Elements" => reader.section(Reader::elements)?,
            other => {
                let name = other.strip_prefix(b"$").filter(|n| !n.is_empty() && !n.starts_with(b"End"));
                let name = name.ok_or_else(|| reader.scan.wanted("a section", Some(other)))?;
                reader.skip_section(name)?;
                continue;
            }
        }
        reader.end(word)?;
    }
    Ok(reader.parts)
}

fn header(bytes: &[u8]) -> Result<Reader<'_>, Located> {
    let mut scan = Scan::new(bytes);
    let first = scan.word();
    if first != Some(b"$MeshFormat") {
        return Err(scan.wanted("$MeshFormat", first));
    }
    let word = scan.word().unwrap_or_default();
    let version = match word {
        b"4.1" => Version::FourOne,
        w if w == b"2" || w.starts_with(b"2.") => Version::Two,
        other => {
            return Err(scan.fault(Fault::Unsupported(format!("Gmsh format version {}", quote(other)))));
        }
    };
    let binary = scan.count("0 (text) or 1 (binary)")?;
    let size = scan.count("a data size")?;
    if size != 8 || binary > 1 {
        return Err(scan.fault(Fault::Unsupported(format!("file type {binary} with data size {size}"))));
    }
    scan.line();
    let mut numbers = Mode::Text;
    if binary == 1 {
        let one = scan.take(4, "the number one")?;
        numbers = match one {
            [1, 0, 0, 0] => Mode::Little,
            [0, 0, 0, 1] => Mode::Big,
            other => return Err(scan.wanted("the number one in 4 bytes", Some(other))),
        };
    }
    let mut reader = Reader { scan, numbers, version, parts: Parts::default(), tags: BTreeMap::new() };
    reader.end(b"$MeshFormat")?;
    Ok(reader)
}

impl Reader<'_> {
    /// Reads what stands between the lines with the section's name.
    fn section(&mut self, read: fn(&mut Self) -> Result<(), Located>) -> Result<(), Located> {
        self.scan.line();
        if self.version == Version::FourOne {
            self.scan.set_mode(self.numbers);
        }
        read(self)?;
        self.scan.set_mode(Mode::Text);
        Ok(())
    }

    fn end(&mut self, begun: &[u8]) -> Result<(), Located> {
        let name = String::from_utf8_lossy(begun.get(1..).unwrap_or_default()).into_owned();
        let found = self.scan.word();
        if found == Some(format!("$End{name}").as_bytes()) {
            return Ok(());
        }
        Err(self.scan.wanted(&format!("$End{name}"), found))
    }

    /// Steps over a section; its content may be binary.
    fn skip_section(&mut self, name: &[u8]) -> Result<(), Located> {
        let end = [b"$End", name].concat();
        let there = self.scan.rest().windows(end.len()).position(|w| w == end);
        let what = String::from_utf8_lossy(&end).into_owned();
        let length = there.ok_or_else(|| self.scan.wanted(&what, None))? + end.len();
        self.scan.take(length, &what).map(|_| ())
    }

    fn nodes(&mut self) -> Result<(), Located> {
        if !self.tags.is_empty() {
            return Err(self.scan.fault(Fault::BadHeader("there are two sections $Nodes".to_owned())));
        }
        match self.version {
            Version::Two => self.nodes_two(),
            Version::FourOne => self.nodes_four(),
        }
    }

    fn node(&mut self, tag: u64) -> Result<(), Located> {
        let mut point = [0.0; 3];
        for x in &mut point {
            *x = self.scan.coordinate(Kind::F64)?;
        }
        // The number of nodes has been checked to be below 2^32.
        let index = u32::try_from(self.parts.builder.mesh.vertices.len()).unwrap_or(u32::MAX);
        if self.tags.insert(tag, index).is_some() {
            return Err(self.scan.fault(Fault::BadHeader(format!("two nodes have the tag {tag}"))));
        }
        self.parts.builder.mesh.vertices.push(point);
        Ok(())
    }

    fn nodes_two(&mut self) -> Result<(), Located> {
        let count = self.scan.count("the number of nodes")?;
        countable("nodes", count).map_err(|f| self.scan.fault(f))?;
        self.scan.line();
        self.scan.set_mode(self.numbers);
        self.parts.builder.mesh.vertices = with_room(count, self.scan.rest().len(), 8);
        for i in 0..count {
            self.scan.at("node", i);
            let tag = self.scan.unsigned(Kind::I32, "a node tag")?;
            self.node(tag)?;
        }
        Ok(())
    }

    /// `blocks count` and the least and greatest tag, of nodes or elements.
    fn blocks(&mut self) -> Result<[u64; 2], Located> {
        let mut numbers = [0; 4];
        for n in &mut numbers {
            *n = self.scan.unsigned(Kind::U64, "a count")?;
        }
        let [blocks, count, ..] = numbers;
        countable("nodes or elements", count).map_err(|f| self.scan.fault(f))?;
        Ok([blocks, count])
    }

    fn nodes_four(&mut self) -> Result<(), Located> {
        let [blocks, count] = self.blocks()?;
        let mut found = 0;
        for block in 0..blocks {
            self.scan.at("node block", block);
            let dimension = self.scan.unsigned(Kind::I32, "a dimension")?;
            self.scan.integer(Kind::I32, "an entity tag")?;
            let parametric = self.scan.unsigned(Kind::I32, "0 or 1")?;
            let size = self.scan.unsigned(Kind::U64, "the number of nodes")?;
            if size > count - found {
                return Err(self.scan.fault(Fault::BadHeader(format!("more than {count} nodes in blocks"))));
            }
            let mut tags: Vec<u64> = with_room(size, self.scan.rest().len(), 2);
            for _ in 0..size {
                tags.push(self.scan.unsigned(Kind::U64, "a node tag")?);
            }
            for tag in tags {
                self.scan.at("node", found);
                self.node(tag)?;
                let parameters = if parametric == 0 { 0 } else { dimension.min(3) };
                self.scan.skip(Kind::F64, parameters, "a parameter")?;
                found += 1;
            }
        }
        if found < count {
            return Err(self.scan.fault(Fault::Truncated {
                what: "nodes".to_owned(),
                expected: count,
                found,
            }));
        }
        Ok(())
    }

    fn elements(&mut self) -> Result<(), Located> {
        match (self.version, self.numbers) {
            (Version::Two, Mode::Text) => self.elements_two_text(),
            (Version::Two, _) => self.elements_two_binary(),
            (Version::FourOne, _) => self.elements_four(),
        }
    }

    /// `tag type number-of-tags tags nodes` a line.
    fn elements_two_text(&mut self) -> Result<(), Located> {
        for _ in 0..self.scan.count("the number of elements")? {
            self.scan.integer(Kind::I32, "an element tag")?;
            let ty = self.scan.integer(Kind::I32, "an element type")?;
            let nodes = self.corners_of(ty)?;
            let tags = self.scan.unsigned(Kind::I32, "the number of tags")?;
            self.scan.skip(Kind::I32, tags, "a tag")?;
            self.element(ty, nodes, Kind::I32)?;
        }
        Ok(())
    }

    /// Blocks of one type: `type count number-of-tags`, then `tag tags nodes` an element.
    fn elements_two_binary(&mut self) -> Result<(), Located> {
        let count = self.scan.count("the number of elements")?;
        self.scan.line();
        self.scan.set_mode(self.numbers);
        let mut found = 0;
        while found < count {
            self.scan.at("element", found);
            let ty = self.scan.integer(Kind::I32, "an element type")?;
            let nodes = self.corners_of(ty)?;
            let size = self.scan.unsigned(Kind::I32, "the number of elements")?;
            let tags = self.scan.unsigned(Kind::I32, "the number of tags")?;
            if size == 0 || size > count - found {
                let what = format!("a block of {size} elements, with {} to come", count - found);
                return Err(self.scan.fault(Fault::BadHeader(what)));
            }
            for _ in 0..size {
                self.scan.at("element", found);
                self.scan.skip(Kind::I32, tags.saturating_add(1), "a tag")?;
                self.element(ty, nodes, Kind::I32)?;
                found += 1;
            }
        }
        Ok(())
    }

    fn elements_four(&mut self) -> Result<(), Located> {
        let [blocks, count] = self.blocks()?;
        let mut found: u64 = 0;
        for block in 0..blocks {
            self.scan.at("element block", block);
            self.scan.integer(Kind::I32, "a dimension")?;
            self.scan.integer(Kind::I32, "an entity tag")?;
            let ty = self.scan.integer(Kind::I32, "an element type")?;
            let nodes = self.corners_of(ty)?;
            let size = self.scan.unsigned(Kind::U64, "the number of elements")?;
            for _ in 0..size {
                self.scan.at("element", found);
                self.scan.unsigned(Kind::U64, "an element tag")?;
                self.element(ty, nodes, Kind::U64)?;
                found = found.saturating_add(1);
            }
        }
        if found != count {
            let what = format!("{count} elements are announced, {found} found");
            return Err(self.scan.fault(Fault::BadHeader(what)));
        }
        Ok(())
    }

    /// Nodes of an element of this type.
    fn corners_of(&self, ty: i128) -> Result<usize, Located> {
        match ty {
            15 => Ok(1),
            1 => Ok(2),
            2 | 8 => Ok(3),
            3 | 4 => Ok(4),
            _ => Err(self.scan.fault(Fault::Unsupported(format!("Gmsh element type {ty}")))),
        }
    }

    fn element(&mut self, ty: i128, nodes: usize, kind: Kind) -> Result<(), Located> {
        let mut corners = [0; 4];
        let corners = corners.get_mut(..nodes).unwrap_or_default();
        for corner in corners.iter_mut() {
            let tag = self.scan.unsigned(kind, "a node tag")?;
            let vertices = self.tags.len() as u64;
            let unknown = || Fault::IndexOutOfRange { index: tag.to_string(), vertices };
            *corner = *self.tags.get(&tag).ok_or_else(|| self.scan.fault(unknown()))?;
        }
        match ty {
            4 => self.parts.tet(corners),
            2 | 3 => self.parts.builder.polygon(corners),
            _ => {
                self.parts.lower += 1;
                Ok(())
            }
        }
        .map_err(|f| self.scan.fault(f))
    }
}
