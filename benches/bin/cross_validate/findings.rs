//! Disagreements: counted, and the first ones printed in full.

use std::fmt::Write as _;

/// So many are printed.
const SHOWN: u64 = 20;

/// What was found so far.
#[derive(Debug, Default)]
pub(crate) struct Findings(u64);

impl Findings {
    /// One more disagreement.
    pub(crate) fn add(&mut self, text: &str) {
        self.0 += 1;
        if self.0 <= SHOWN {
            eprintln!("DISAGREEMENT {}: {text}", self.0);
        }
    }

    /// How many.
    pub(crate) fn count(&self) -> u64 {
        self.0
    }
}

/// A finite double as C's `%a` prints it.
pub(crate) fn hex(x: f64) -> String {
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    let sign = if x.is_sign_negative() { "-" } else { "" };
    if biased == 0 && fraction == 0 {
        return format!("{sign}0x0p+0");
    }
    // Subnormal numbers have the exponent of the smallest normal ones.
    let (lead, exponent) = if biased == 0 { (0, -1022) } else { (1, biased.cast_signed() - 1023) };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}")
}

/// A case as a line of text mode.
pub(crate) fn line(name: &str, numbers: &[f64]) -> String {
    numbers.iter().fold(name.to_owned(), |mut out, x| {
        let _ = write!(out, " {}", hex(*x));
        out
    })
}

#[cfg(test)]
mod tests {
    use super::hex;

    #[test]
    fn as_c_prints() {
        let known = [
            (1.0, "0x1p+0"),
            (-0.0, "-0x0p+0"),
            (0.1, "0x1.999999999999ap-4"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (-f64::MIN_POSITIVE, "-0x1p-1022"),
            (f64::from_bits(1), "0x0.0000000000001p-1022"),
            (f64::MIN_POSITIVE / 2.0, "0x0.8p-1022"),
        ];
        for (x, text) in known {
            assert_eq!(hex(x), text);
        }
    }
}
