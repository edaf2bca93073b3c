//! The classic HDF5 subset of FORMAT section 6. Every read is bounds-checked, every walk has a budget.

use crate::Set;
use crate::input::{Bits, Mesh, Shell, validate};
use std::collections::VecDeque;

type Read<T> = Result<T, String>;

/// As many nodes below the tree's first one as are read, and as many names.
const BUDGET: usize = 4096;

struct File<'a>(&'a [u8]);

/// A message of an object header.
struct Message {
    kind: u64,
    /// The address of its content, and the bytes that this has.
    body: u64,
    size: u64,
}

/// Where the first message of a kind has its content, if that is long enough.
fn body(messages: &[Message], kind: u64, least: u64) -> Option<u64> {
    messages.iter().find(|m| m.kind == kind).filter(|m| m.size >= least).map(|m| m.body)
}

/// An object header's data: address, rows.
struct Dataset<'a> {
    rows: usize,
    class: u8,
    data: &'a [u8],
}

/// The shell in an HDF5 file, and its mesh if asked for.
pub(crate) fn shell(bytes: &[u8], with_mesh: bool) -> Read<(Shell, Option<Mesh>)> {
    let file = File(bytes);
    let names = file.root_names()?;
    let layer = |name: &str| file.dataset(&names, name).and_then(|d| d.points());
    let layers = [layer("mbase")?, layer("mV")?, layer("mtop")?];
    if layers.iter().any(|l| l.len() != layers[0].len()) {
        return Err("mbase, mV and mtop differ in length".into());
    }
    let prisms = file.dataset(&names, "mF")?.triangles()?;
    for points in &layers {
        validate(points, &prisms)?;
    }
    let mesh = if with_mesh {
        let mesh = Mesh { points: layer("ref.V")?, triangles: file.dataset(&names, "ref.F")?.triangles()? };
        validate(&mesh.points, &mesh.triangles).map_err(|why| format!("ref: {why}"))?;
        Some(mesh)
    } else {
        None
    };
    Ok((Shell { layers, prisms }, mesh))
}

impl<'a> File<'a> {
    fn bytes(&self, at: u64, len: u64) -> Read<&'a [u8]> {
        let end = at.checked_add(len).ok_or("an address overflows")?;
        let range = usize::try_from(at).ok().zip(usize::try_from(end).ok());
        range
            .and_then(|(a, b)| self.0.get(a..b))
            .ok_or_else(|| format!("{len} bytes at {at} are outside the file"))
    }

    /// A little-endian number of `len <= 8` bytes.
    fn number(&self, at: u64, len: u64) -> Read<u64> {
        Ok(self.bytes(at, len)?.iter().rev().fold(0, |value, &byte| value << 8 | u64::from(byte)))
    }

    fn expect(&self, at: u64, what: &[u8]) -> Read<()> {
        let found = self.bytes(at, what.len() as u64)?;
        if found == what { Ok(()) } else { Err(format!("expected {what:?} at {at}")) }
    }

    /// Names in the root group with the addresses of their object headers.
    fn root_names(&self) -> Read<Vec<(&'a [u8], u64)>> {
        self.expect(0, b"\x89HDF\r\n\x1a\n\0")?;
        self.expect(13, &[8, 8])?;
        self.expect(24, &[0; 8])?;
        let header = self.messages(self.number(64, 8)?)?;
        let body = body(&header, 0x11, 16).ok_or("the root is no symbol table")?;
        let (tree, heap) = (self.number(body, 8)?, self.number(body.saturating_add(8), 8)?);
        self.expect(heap, b"HEAP\0")?;
        let (size, data) =
            (self.number(heap.saturating_add(8), 8)?, self.number(heap.saturating_add(24), 8)?);
        let heap = self.bytes(data, size)?;
        let (mut nodes, mut names, mut seen) = (vec![(tree, 256)], Vec::new(), Set::default());
        // Names do not overlap, so they are together no longer than the heap.
        let (mut room, mut below_first) = (heap.len(), 0);
        while let Some((at, below)) = nodes.pop() {
            if !seen.insert(at) {
                return Err("a node is reached twice".into());
            }
            if below == 0 {
                self.symbols(at, heap, &mut room, &mut names)?;
                continue;
            }
            self.expect(at, b"TREE\0")?;
            let (level, used) =
                (self.number(at.saturating_add(5), 1)?, self.number(at.saturating_add(6), 2)?);
            if level >= below {
                return Err("the levels of the tree do not descend".into());
            }
            below_first += used;
            if below_first > BUDGET as u64 {
                return Err("the root group has too many nodes".into());
            }
            for i in 0..used {
                nodes.push((self.number(at.saturating_add(32 + 16 * i), 8)?, level));
            }
        }
        let different: Set<&[u8]> = names.iter().map(|n| n.0).collect();
        if different.len() < names.len() {
            return Err("a name is used twice".into());
        }
        Ok(names)
    }

    fn symbols(
        &self,
        at: u64,
        heap: &'a [u8],
        room: &mut usize,
        names: &mut Vec<(&'a [u8], u64)>,
    ) -> Read<()> {
        self.expect(at, b"SNOD\x01")?;
        for i in 0..self.number(at.saturating_add(6), 2)? {
            let entry = at.saturating_add(8 + 40 * i);
            let offset = usize::try_from(self.number(entry, 8)?).unwrap_or(usize::MAX);
            let text = heap.get(offset..).ok_or("a name is outside the heap")?;
            let end = text.iter().take(*room).position(|&b| b == 0).ok_or("a name has no end of its own")?;
            *room -= end + 1;
            names.push((&text[..end], self.number(entry.saturating_add(8), 8)?));
            if names.len() > BUDGET {
                return Err("the root group has too many names".into());
            }
        }
        Ok(())
    }

    /// The messages of a version-1 object header, in the order of its blocks.
    fn messages(&self, at: u64) -> Read<Vec<Message>> {
        self.expect(at, &[1])?;
        let total = self.number(at.saturating_add(2), 2)?;
        let mut blocks = VecDeque::from([(at.saturating_add(16), self.number(at.saturating_add(8), 4)?)]);
        let mut found = Vec::new();
        let mut seen = Set::default();
        while let Some((mut here, mut left)) = blocks.pop_front() {
            if !seen.insert(here) {
                return Err("a block is reached twice".into());
            }
            self.bytes(here, left)?;
            while left >= 8 && (found.len() as u64) < total {
                let (kind, size) = (self.number(here, 2)?, self.number(here + 2, 2)?);
                let Some(rest) = left.checked_sub(8 + size) else { return Err("a message is cut".into()) };
                if matches!(kind, 1 | 3 | 8 | 0x10 | 0x11) && self.number(here + 4, 1)? & 2 != 0 {
                    return Err("shared messages are not read".into());
                }
                if kind == 0x10 && size < 16 {
                    return Err("a continuation is cut".into());
                }
                if kind == 0x10 {
                    blocks.push_back((self.number(here + 8, 8)?, self.number(here + 16, 8)?));
                }
                found.push(Message { kind, body: here + 8, size });
                (here, left) = (here + 8 + size, rest);
            }
        }
        Ok(found)
    }

    fn dataset(&self, names: &[(&[u8], u64)], name: &str) -> Read<Dataset<'a>> {
        let fail = |why: &str| format!("dataset {name}: {why}");
        let &(_, at) = names.iter().find(|n| n.0 == name.as_bytes()).ok_or_else(|| fail("missing"))?;
        let messages = self.messages(at)?;
        let body = |kind, least| body(&messages, kind, least).ok_or_else(|| fail("no message, or a cut one"));
        let (space, kind, layout) = (body(1, 24)?, body(3, 12)?, body(8, 18)?);
        if messages.iter().any(|m| matches!(m.kind, 7 | 0x0b)) {
            return Err(fail("filters and external files are not read"));
        }
        self.expect(space, &[1, 2]).map_err(|_| fail("not of rank 2"))?;
        self.expect(layout, &[3, 1]).map_err(|_| fail("not contiguous"))?;
        let (rows, columns) = (self.number(space + 8, 8)?, self.number(space + 16, 8)?);
        let (class, order, width) =
            (self.number(kind, 1)? as u8 & 15, self.number(kind + 1, 1)?, self.number(kind + 4, 4)?);
        let plain = match class {
            // No bit offset, a precision of 32.
            0 => width == 4 && order & 1 == 0 && self.expect(kind + 8, &[0, 0, 32, 0]).is_ok(),
            // The IEEE double, byte for byte: bit field, then the properties behind the size.
            1 => {
                body(3, 20)?;
                width == 8 && self.expect(kind, &IEEE[..4]).and(self.expect(kind + 8, &IEEE[4..])).is_ok()
            }
            _ => false,
        };
        if columns != 3 || !plain {
            return Err(fail("not n x 3 little-endian doubles or 4-byte integers"));
        }
        let size = rows.checked_mul(3 * width).ok_or_else(|| fail("too large"))?;
        if self.number(layout + 10, 8)? != size {
            return Err(fail("the size of the data is not that of the dataspace"));
        }
        let data = self.bytes(self.number(layout + 2, 8)?, size)?;
        Ok(Dataset { rows: usize::try_from(rows).unwrap_or(0), class, data })
    }
}

/// Class and bit field, then bit offset, precision, exponent and mantissa places and bias, of a little-endian double.
const IEEE: [u8; 16] = [0x11, 0x20, 0x3f, 0, 0, 0, 64, 0, 52, 11, 0, 52, 0xff, 3, 0, 0];

impl Dataset<'_> {
    fn points(&self) -> Read<Vec<Bits>> {
        let (words, []) = self.data.as_chunks::<8>() else { return Err("not doubles".into()) };
        let (rows, []) = words.as_chunks::<3>() else { return Err("not three columns".into()) };
        if self.class != 1 || rows.len() != self.rows {
            return Err("coordinates are not doubles".into());
        }
        Ok(rows.iter().map(|r| r.map(u64::from_le_bytes)).collect())
    }

    fn triangles(&self) -> Read<Vec<[u32; 3]>> {
        let (words, []) = self.data.as_chunks::<4>() else { return Err("not integers".into()) };
        let (rows, []) = words.as_chunks::<3>() else { return Err("not three columns".into()) };
        if self.class != 0 || rows.len() != self.rows {
            return Err("triangles are not 4-byte integers".into());
        }
        Ok(rows.iter().map(|r| r.map(u32::from_le_bytes)).collect())
    }
}
