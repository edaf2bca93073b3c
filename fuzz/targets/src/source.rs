//! Values from bytes: any bytes give values, and bytes that end give zeros.

use homeo_proptests::Recipe;
use homeo_proptests::recipe::Move;
use homeo_proptests::shapes::SHAPES;
use homeo_proptests::sheets::{EDITS, Edit};

/// Bytes that are used up from the front.
pub(crate) struct Source<'a>(pub(crate) &'a [u8]);

impl Source<'_> {
    pub(crate) fn byte(&mut self) -> u8 {
        let (first, rest) = self.0.split_first().map_or((0, self.0), |(b, rest)| (*b, rest));
        self.0 = rest;
        first
    }

    pub(crate) fn bytes<const N: usize>(&mut self) -> [u8; N] {
        [0; N].map(|_| self.byte())
    }

    /// -3 to 3.
    fn step(&mut self) -> i8 {
        i8::try_from(self.byte() % 7).map_or(0, |x| x - 3)
    }

    fn a_move(&mut self) -> Move {
        Move { at: self.byte(), by: [0; 3].map(|_| self.step()) }
    }

    /// A small shell, a mesh and an order.
    pub(crate) fn recipe(&mut self) -> Recipe {
        // The octahedron and the tori (7 to 9) are slow: the others stand for them.
        let shape = match u32::from(self.byte()) % SHAPES {
            slow @ 7..10 => slow - 7,
            other => other,
        };
        let [pinched, moves, edits] = self.bytes::<3>();
        Recipe {
            shape,
            pinched: (0..(pinched % 8).saturating_sub(5)).map(|_| self.byte()).collect(),
            moves: (0..moves % 4).map(|_| self.a_move()).collect(),
            edge: (moves >> 4 == 3).then(|| (self.a_move(), self.byte() & 1 == 1)),
            edits: (0..edits % 4)
                .map(|_| Edit { kind: self.byte() % EDITS, at: self.byte(), pick: self.bytes() })
                .collect(),
            order: u16::from_le_bytes(self.bytes()),
        }
    }
}
