//! The certificate's text, in memory or left in its file, and the lines of it that are read again whenever they are
//! needed: what is kept of them is where they are. A checker's memory is thus bounded by its inputs, not by the certificate.

use crate::line::{Bounds, Line};
use crate::parse::{Separation, separation};
use crate::{Map, Res, malformed};
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// A certificate's bytes.
#[derive(Clone, Copy)]
pub(crate) enum Text<'a> {
    Memory(&'a [u8]),
    /// A file of so many bytes.
    File(&'a Mutex<File>, usize),
}

impl<'a> Text<'a> {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Memory(bytes) => bytes.len(),
            Self::File(_, len) => *len,
        }
    }

    /// The bytes of a range that lies in the text.
    pub(crate) fn read(&self, range: Range<usize>) -> Res<Cow<'a, [u8]>> {
        let file = match *self {
            Self::Memory(bytes) => return Ok(Cow::Borrowed(bytes.get(range).unwrap_or(&[]))),
            Self::File(file, _) => file,
        };
        let mut bytes = vec![0; range.len()];
        let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
        let read = file.seek(SeekFrom::Start(range.start as u64)).and_then(|_| file.read_exact(&mut bytes));
        read.map_or_else(|error| malformed("usage", error.to_string()), |()| Ok(Cow::Owned(bytes)))
    }

    fn is_file(&self) -> bool {
        matches!(self, Self::File(..))
    }
}

const CHANGED: &str = "the certificate has changed while it was read";

/// So many lines are found by counting from the first of them.
const PAGE: usize = if cfg!(test) { 2 } else { 16 };

/// Lines of one kind that follow each other.
pub(crate) struct Lines<'a> {
    text: Text<'a>,
    bounds: Bounds,
    /// The number of the first line.
    first: usize,
    len: usize,
    /// Where each page of lines begins, and where the last one ends.
    starts: Vec<usize>,
    /// Of a file, what each page has to hash to when it is read again.
    hashes: Vec<[u8; 16]>,
    /// Of the page that is not complete.
    hash: Sha256,
}

impl<'a> Lines<'a> {
    /// None yet; they will begin at this place, with this number.
    pub(crate) fn new(text: Text<'a>, bounds: Bounds, first: usize, start: usize) -> Self {
        Self { text, bounds, first, len: 0, starts: vec![start], hashes: vec![], hash: Sha256::new() }
    }

    /// Adds the next line; the line behind it begins at `end`.
    pub(crate) fn push(&mut self, line: &str, end: usize) {
        if self.text.is_file() {
            self.hash.update(line);
            self.hash.update("\n");
        }
        match self.len % PAGE {
            0 => self.starts.push(end),
            _ => self.starts.last_mut().into_iter().for_each(|last| *last = end),
        }
        self.len += 1;
        if self.len.is_multiple_of(PAGE) {
            self.close();
        }
    }

    /// No line follows.
    pub(crate) fn close(&mut self) {
        if self.text.is_file() && self.hashes.len() < self.len.div_ceil(PAGE) {
            self.hashes.push(short(std::mem::take(&mut self.hash)));
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// The number of a line in the file.
    pub(crate) fn number(&self, i: usize) -> usize {
        self.first + i
    }

    /// Reads the lines of a range.
    fn each(&self, range: Range<usize>, mut read: impl FnMut(usize, &str) -> Res) -> Res {
        if range.is_empty() {
            return Ok(());
        }
        let pages = range.start / PAGE..range.end.div_ceil(PAGE);
        let start = self.starts[pages.start];
        let bytes = self.text.read(start..self.starts[pages.end])?;
        let same = |page: usize| {
            let part = &bytes[self.starts[page] - start..self.starts[page + 1] - start];
            short(Sha256::new_with_prefix(part)) == self.hashes[page]
        };
        if self.text.is_file() && !pages.clone().all(same) {
            return malformed("usage", CHANGED);
        }
        let Ok(text) = std::str::from_utf8(&bytes) else { return malformed("bytes", "") };
        let lines = (pages.start * PAGE..).zip(text.split_terminator('\n'));
        lines.filter(|(i, _)| range.contains(i)).try_for_each(|(i, line)| read(i, line))
    }

    /// `malformed duplicate` at the first line that is equal to an earlier one. The hashes of all of them are given; what
    /// fits the grammar is written in one way only.
    pub(crate) fn different(&self, hash: impl Fn(&str) -> u64, mut hashes: Vec<u64>) -> Res {
        hashes.sort_unstable();
        let mut twice: Vec<u64> = hashes.windows(2).filter(|w| w[0] == w[1]).map(|w| w[0]).collect();
        drop(hashes);
        twice.dedup();
        // The first line with each of them, and the others, which are few: lines that differ seldom hash alike.
        let (mut first, mut more) = (vec![u32::MAX; twice.len()], Map::<usize, Vec<u32>>::default());
        let judge = |i: usize, text: &str| {
            let Ok(place) = twice.binary_search(&hash(text)) else { return Ok(()) };
            if first[place] == u32::MAX {
                first[place] = i as u32;
                return Ok(());
            }
            let others = more.entry(place).or_default();
            for &earlier in std::iter::once(&first[place]).chain(&*others) {
                self.each(earlier as usize..earlier as usize + 1, |_, line| match line == text {
                    true => malformed("duplicate", format!("line {} repeats an earlier one", self.number(i))),
                    false => Ok(()),
                })?;
            }
            others.push(i as u32);
            Ok(())
        };
        if twice.is_empty() { Ok(()) } else { self.every(judge) }
    }

    /// Reads all lines, some pages at a time.
    fn every(&self, mut read: impl FnMut(usize, &str) -> Res) -> Res {
        let some = 64 * PAGE;
        (0..self.len).step_by(some).try_for_each(|i| self.each(i..self.len.min(i + some), &mut read))
    }

    /// Reads these lines, ascending.
    fn pick(&self, wanted: &[usize], mut read: impl FnMut(&Line<'_>) -> Res) -> Res {
        let mut next = wanted.iter().peekable();
        // Those in pages side by side are read together.
        for near in wanted.chunk_by(|a, b| b / PAGE <= a / PAGE + 1) {
            self.each(near[0]..near[near.len() - 1] + 1, |i, text| {
                let wanted = next.next_if_eq(&&i).is_some();
                if wanted { read(&Line::new(text, self.first + i, self.bounds)) } else { Ok(()) }
            })?;
        }
        // A line that is not there is not passed over.
        if next.next().is_none() { Ok(()) } else { malformed("usage", CHANGED) }
    }

    /// The corners of these `c` lines, ascending.
    pub(crate) fn cells(&self, wanted: &[usize]) -> Res<Rows> {
        let mut rows = Rows::default();
        self.pick(wanted, |line| cell(line, &mut rows))?;
        Ok(rows)
    }

    /// The mesh vertices and the names of these `v` lines, ascending.
    pub(crate) fn carriers(&self, wanted: &[usize]) -> Res<[Rows; 2]> {
        let mut rows = <[Rows; 2]>::default();
        self.pick(wanted, |line| carrier(line, &mut rows))?;
        Ok(rows)
    }
}

/// Adds the mesh vertices and the names of a `v` line.
pub(crate) fn carrier(line: &Line<'_>, [ids, names]: &mut [Rows; 2]) -> Res {
    line.expect("v")?;
    ids.add(|list| line.mesh_ids(list))?;
    names.add(|list| line.add_names(list))?;
    line.finish()
}

/// Adds the corners of a `c` line.
pub(crate) fn cell(line: &Line<'_>, cells: &mut Rows) -> Res {
    line.expect("c")?;
    cells.add(|list| {
        let many = line.distinct_ids(line.bounds.corners, list)?;
        line.require(many >= 3)
    })?;
    line.finish()
}

fn short(hash: Sha256) -> [u8; 16] {
    let full = hash.finalize();
    std::array::from_fn(|i| full[i])
}

/// Lists of numbers.
#[derive(Default)]
pub(crate) struct Rows {
    items: Vec<usize>,
    /// Where each list ends.
    ends: Vec<usize>,
}

impl Rows {
    /// Adds a list that is read to the end of the items.
    fn add(&mut self, read: impl FnOnce(&mut Vec<usize>) -> Res) -> Res {
        read(&mut self.items)?;
        self.ends.push(self.items.len());
        Ok(())
    }

    pub(crate) fn clear(&mut self) {
        self.items.clear();
        self.ends.clear();
    }

    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// All numbers of all lists.
    pub(crate) fn items(&self) -> &[usize] {
        &self.items
    }

    /// The `i`-th list.
    pub(crate) fn of(&self, i: usize) -> &[usize] {
        let start = i.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.items[start..self.ends[i]]
    }
}

/// The `sep` or `contact-sep` lines of a block.
pub(crate) struct Separations<'a> {
    pub(crate) lines: Lines<'a>,
    /// The block's name.
    pub(crate) block: &'static str,
    /// The first number of each line, or the greatest that there is room for.
    pub(crate) firsts: Vec<u32>,
    /// The greatest second number.
    pub(crate) greatest: Option<usize>,
}

impl Separations<'_> {
    /// The lines with a first number in this range.
    pub(crate) fn of(&self, range: Range<usize>) -> Res<Vec<Separation>> {
        let place = |i: usize| self.firsts.partition_point(|&first| (first as usize) < i);
        let (mut found, lines) = (Vec::new(), place(range.start)..place(range.end));
        self.lines.pick(&lines.collect::<Vec<_>>(), |line| {
            found.push(separation(line, self.block, None)?);
            Ok(())
        })?;
        Ok(found)
    }
}

#[cfg(test)]
mod tests;
