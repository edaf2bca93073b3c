//! Lists of point indices in the old layout (length, then indices) and in the one of version 5 (two arrays).

use super::Reader;
use crate::mesh::error::{Fault, Located};
use crate::mesh::scan::Kind;
use crate::mesh::text::with_room;

/// Lists, one after another.
#[derive(Debug)]
pub(super) struct Lists {
    /// Where each list begins; one more entry for the end.
    starts: Vec<usize>,
    items: Vec<i128>,
}

impl Lists {
    pub(super) fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    pub(super) fn get(&self, i: usize) -> &[i128] {
        match self.starts.get(i..i.saturating_add(2)) {
            Some(&[from, to]) => self.items.get(from..to).unwrap_or_default(),
            _ => &[],
        }
    }
}

impl Reader<'_> {
    /// The two numbers after the keyword, and the lists.
    pub(super) fn lists(&mut self, what: &'static str) -> Result<Lists, Located> {
        let first = self.scan.count("the number of cells")?;
        let second = self.scan.count("the number of indices")?;
        // In the old binary layout these bytes would be a length above 10^9.
        if self.scan.peek() == Some(b"OFFSETS") {
            self.two_arrays(first, second, what)
        } else {
            self.old_layout(first, second, what)
        }
    }

    fn array(&mut self, name: &[u8], count: u64, what: &'static str) -> Result<Vec<i128>, Located> {
        let found = self.keyword();
        if found != Some(name) {
            return Err(self.scan.wanted(&String::from_utf8_lossy(name), found));
        }
        let kind = self.kind()?;
        self.begin_numbers();
        let mut out = with_room(count, self.scan.rest().len(), kind.fewest_bytes(self.numbers));
        for i in 0..count {
            self.scan.at(what, i);
            out.push(self.scan.integer(kind, "an index")?);
        }
        self.end_numbers();
        Ok(out)
    }

    fn two_arrays(&mut self, offsets: u64, indices: u64, what: &'static str) -> Result<Lists, Located> {
        let offsets = self.array(b"OFFSETS", offsets, "offset")?;
        let items = self.array(b"CONNECTIVITY", indices, what)?;
        let mut starts: Vec<usize> = Vec::with_capacity(offsets.len());
        for (i, offset) in offsets.into_iter().enumerate() {
            let least = starts.last().copied().unwrap_or(0);
            let start = usize::try_from(offset).ok().filter(|s| (least..=items.len()).contains(s));
            let right = start.filter(|&s| i > 0 || s == 0);
            let wrong = || Fault::expected("ascending offsets from 0", offset.to_string()).at("offset", i);
            starts.push(right.ok_or_else(wrong)?);
        }
        if starts.last().is_some_and(|&end| end != items.len()) {
            let what = format!("the last offset is not the number of indices, {}", items.len());
            return Err(Fault::BadHeader(what).into());
        }
        Ok(Lists { starts, items })
    }

    fn old_layout(&mut self, count: u64, size: u64, what: &'static str) -> Result<Lists, Located> {
        self.begin_numbers();
        let each = Kind::I32.fewest_bytes(self.numbers);
        let mut starts = with_room(count.saturating_add(1), self.scan.rest().len(), each);
        let mut items = with_room(size, self.scan.rest().len(), each);
        starts.push(0);
        for i in 0..count {
            self.scan.at(what, i);
            let length = self.scan.unsigned(Kind::I32, "the number of corners")?;
            for _ in 0..length {
                items.push(self.scan.integer(Kind::I32, "an index")?);
            }
            starts.push(items.len());
        }
        self.end_numbers();
        if (items.len() as u64).checked_add(count) != Some(size) {
            let what = format!("{size} numbers of cells are announced, {} found", items.len() as u64 + count);
            return Err(self.scan.fault(Fault::BadHeader(what)));
        }
        Ok(Lists { starts, items })
    }
}
