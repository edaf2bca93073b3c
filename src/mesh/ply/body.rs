//! The numbers after a PLY header, as text and as binary.

use super::header::{Element, Kind, Type};
use crate::mesh::error::{Fault, Located, Place};
use crate::mesh::text::{Lines, coordinate, integer, quote, tokens};

/// A number and where it stands. All types are exact in `f64`.
pub(super) struct Number {
    pub(super) value: f64,
    /// The value, where the type is an integer.
    pub(super) integer: Option<i64>,
    place: Place,
}

impl Number {
    /// The value as errors show it.
    pub(super) fn text(&self) -> String {
        self.integer.map_or_else(|| self.value.to_string(), |i| i.to_string())
    }

    pub(super) fn fault(&self, fault: Fault) -> Located {
        Located { place: self.place.clone(), fault }
    }
}

/// A stream of elements.
pub(super) trait Source {
    /// Called before the elements of one kind.
    fn begin(&mut self, element: &Element) -> Result<(), Located>;
    /// Called before each element.
    fn begin_row(&mut self, element: &Element, row: u64) -> Result<(), Located>;
    /// The next number.
    fn number(&mut self, ty: Type) -> Result<Number, Located>;
    /// The length of a list, when that many items can follow.
    fn length(&mut self, count: Type, item: Type) -> Result<usize, Located>;
    /// Steps over a property.
    fn skip(&mut self, kind: Kind) -> Result<(), Located>;
    /// Called after each element.
    fn end_row(&mut self) -> Result<(), Located>;
    /// Called after the last element.
    fn finish(&mut self) -> Result<(), Located>;
    /// Bytes that have not been read.
    fn remaining(&self) -> usize;
    /// A fault in the present element.
    fn locate(&self, fault: Fault) -> Located;
}

fn truncated(element: &Element, found: u64) -> Fault {
    Fault::Truncated { what: format!("{} elements", element.name), expected: element.count, found }
}

/// A list's length as a number of items, refused when it is negative or exceeds what is left.
fn checked_length(number: &Number, most: usize) -> Result<usize, Located> {
    number.integer.and_then(|n| usize::try_from(n).ok()).filter(|&n| n <= most).ok_or_else(|| {
        number
            .fault(Fault::expected("a list that fits into its element", format!("length {}", number.text())))
    })
}

/// Text, one element a line.
pub(super) struct Ascii<'a> {
    lines: Lines<'a>,
    row: &'a [u8],
}

impl<'a> Ascii<'a> {
    pub(super) fn new(lines: Lines<'a>) -> Self {
        Self { lines, row: b"" }
    }

    fn token(&mut self) -> Option<&'a [u8]> {
        let start = self.row.trim_ascii_start();
        let token = tokens(start).next()?;
        self.row = start.get(token.len()..).unwrap_or_default();
        Some(token)
    }
}

impl Source for Ascii<'_> {
    fn begin(&mut self, _: &Element) -> Result<(), Located> {
        Ok(())
    }

    fn begin_row(&mut self, element: &Element, row: u64) -> Result<(), Located> {
        for (_, line) in self.lines.by_ref() {
            if !line.trim_ascii().is_empty() {
                self.row = line;
                return Ok(());
            }
        }
        Err(truncated(element, row).into())
    }

    fn number(&mut self, ty: Type) -> Result<Number, Located> {
        let place = Place::Line(self.lines.number());
        let token = self.token();
        if ty.is_integer() {
            let i: i64 = integer(token, "an integer").map_err(|f| self.locate(f))?;
            return Ok(Number { value: i as f64, integer: Some(i), place });
        }
        let value = match token {
            Some(t) => coordinate(t, "a number"),
            None => integer::<i64>(None, "a number").map(|i| i as f64),
        };
        Ok(Number { value: value.map_err(|f| self.locate(f))?, integer: None, place })
    }

    fn length(&mut self, count: Type, _: Type) -> Result<usize, Located> {
        let number = self.number(count)?;
        checked_length(&number, self.row.len())
    }

    fn skip(&mut self, kind: Kind) -> Result<(), Located> {
        let count = match kind {
            Kind::Scalar(_) => 1,
            Kind::List { count, item } => self.length(count, item)?,
        };
        for _ in 0..count {
            if self.token().is_none() {
                return Err(self.locate(Fault::expected("a number", "the end of the line")));
            }
        }
        Ok(())
    }

    fn end_row(&mut self) -> Result<(), Located> {
        match self.token() {
            Some(more) => Err(self.locate(Fault::expected("the end of the line", quote(more)))),
            None => Ok(()),
        }
    }

    fn finish(&mut self) -> Result<(), Located> {
        match self.lines.find(|(_, line)| !line.trim_ascii().is_empty()) {
            Some((number, _)) => Err(Fault::TrailingData("element".to_owned()).at_line(number)),
            None => Ok(()),
        }
    }

    fn remaining(&self) -> usize {
        self.lines.rest().len()
    }

    fn locate(&self, fault: Fault) -> Located {
        fault.at_line(self.lines.number())
    }
}

/// Binary, either byte order.
pub(super) struct Binary<'a> {
    rest: &'a [u8],
    big_endian: bool,
    element: String,
    row: u64,
}

impl<'a> Binary<'a> {
    pub(super) fn new(rest: &'a [u8], big_endian: bool) -> Self {
        Self { rest, big_endian, element: String::new(), row: 0 }
    }

    fn place(&self) -> Place {
        Place::Element { kind: self.element.clone(), index: self.row }
    }

    fn take(&mut self, n: usize) -> Result<&'a [u8], Located> {
        let Some((taken, rest)) = self.rest.split_at_checked(n) else {
            return Err(self.locate(Fault::expected(format!("{n} more bytes"), self.rest.len().to_string())));
        };
        self.rest = rest;
        Ok(taken)
    }

    /// The next `N` bytes, least significant first.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], Located> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.take(N)?);
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Source for Binary<'_> {
    fn begin(&mut self, element: &Element) -> Result<(), Located> {
        self.element.clone_from(&element.name);
        self.row = 0;
        let size = u64::try_from(element.least_size()).unwrap_or(u64::MAX);
        let left = u64::try_from(self.rest.len()).unwrap_or(u64::MAX);
        match left.checked_div(size) {
            Some(fit) if fit < element.count => Err(truncated(element, fit).into()),
            _ => Ok(()),
        }
    }

    fn begin_row(&mut self, _: &Element, row: u64) -> Result<(), Located> {
        self.row = row;
        Ok(())
    }

    fn number(&mut self, ty: Type) -> Result<Number, Located> {
        let integer = match ty {
            Type::I8 => Some(i64::from(i8::from_le_bytes(self.bytes()?))),
            Type::U8 => Some(i64::from(u8::from_le_bytes(self.bytes()?))),
            Type::I16 => Some(i64::from(i16::from_le_bytes(self.bytes()?))),
            Type::U16 => Some(i64::from(u16::from_le_bytes(self.bytes()?))),
            Type::I32 => Some(i64::from(i32::from_le_bytes(self.bytes()?))),
            Type::U32 => Some(i64::from(u32::from_le_bytes(self.bytes()?))),
            Type::F32 | Type::F64 => None,
        };
        let value = match (ty, integer) {
            (_, Some(i)) => i as f64,
            (Type::F32, None) => f64::from(f32::from_le_bytes(self.bytes()?)),
            (_, None) => f64::from_le_bytes(self.bytes()?),
        };
        Ok(Number { value, integer, place: self.place() })
    }

    fn length(&mut self, count: Type, item: Type) -> Result<usize, Located> {
        let number = self.number(count)?;
        checked_length(&number, self.rest.len() / item.size())
    }

    fn skip(&mut self, kind: Kind) -> Result<(), Located> {
        let bytes = match kind {
            Kind::Scalar(ty) => ty.size(),
            // No overflow: `length` has compared this product with what is left.
            Kind::List { count, item } => self.length(count, item)? * item.size(),
        };
        self.take(bytes).map(drop)
    }

    fn end_row(&mut self) -> Result<(), Located> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), Located> {
        if self.rest.is_empty() { Ok(()) } else { Err(Fault::TrailingData("element".to_owned()).into()) }
    }

    fn remaining(&self) -> usize {
        self.rest.len()
    }

    fn locate(&self, fault: Fault) -> Located {
        Located { place: self.place(), fault }
    }
}
