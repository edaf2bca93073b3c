//! Doubles as C's `%a` prints them.

use std::fmt::Write as _;

/// Appends `x` as `%a` prints it; finite values only (others are written as Rust does).
pub(super) fn write(out: &mut String, x: f64) {
    if !x.is_finite() {
        let _ = write!(out, "{x}");
        return;
    }
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    let sign = if bits >> 63 == 1 { "-" } else { "" };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    let (lead, exponent) = match (biased, fraction) {
        (0, 0) => (0, 0),
        (0, _) => (0, -1022),
        _ => (1, biased.cast_signed() - 1023),
    };
    let _ = write!(out, "{sign}0x{lead}{point}{digits}p{exponent:+}");
}

/// The value of a hexadecimal or decimal text; `None` if it is neither, or hexadecimal and no double exactly.
pub(super) fn parse(text: &str) -> Option<f64> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let Some(hex) = digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) else {
        return text.parse().ok().filter(|x: &f64| x.is_finite());
    };
    let (mantissa, exponent) = hex.split_once(['p', 'P'])?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.len() + fraction.len() > 16 || whole.is_empty() {
        return None;
    }
    let joined = format!("{whole}{fraction}");
    if !joined.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let value = u64::from_str_radix(&joined, 16).ok()?;
    let shift = i32::try_from(fraction.len()).ok()? * 4;
    let exponent = exponent.parse::<i16>().ok().map(i32::from)? - shift;
    let magnitude = exact(value, exponent)?;
    Some(if negative { -magnitude } else { magnitude })
}

/// `value * 2^exponent`, if that is a double.
fn exact(value: u64, exponent: i32) -> Option<f64> {
    if value == 0 {
        return Some(0.0);
    }
    let zeros = value.trailing_zeros();
    let (value, exponent) = (value >> zeros, exponent + zeros.cast_signed());
    let length = 64 - value.leading_zeros().cast_signed();
    let top = exponent + length - 1;
    if length > 53 || top > 1023 || exponent < -1074 {
        return None;
    }
    Some(if top < -1022 {
        f64::from_bits(value << (exponent + 1074))
    } else {
        let fraction = (value << (53 - length)) & ((1 << 52) - 1);
        f64::from_bits(u64::from((top + 1023).unsigned_abs()) << 52 | fraction)
    })
}
