//! What a subject says about a case.

use std::fmt;

use crate::predicate::Sign;

/// The answer to one case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A sign, or a truth value (`Positive` for yes, `Zero` for no).
    Sign(Sign),
    /// The implementation computed something that has no sign.
    Nan,
    /// The subject does not judge this predicate or case.
    Unsupported,
    /// An answer that is none; the first characters of it.
    Bad(Box<str>),
    /// The subject ended, or panicked.
    Crash,
    /// The subject did not answer in time.
    Hang,
}

impl Answer {
    /// The sign of a number; [`Answer::Nan`] for NaN. Infinities have a sign.
    #[must_use]
    pub fn of_value(value: f64) -> Self {
        match value.partial_cmp(&0.0) {
            Some(order) => Self::Sign(order.into()),
            None => Self::Nan,
        }
    }

    /// `Positive` for true, `Zero` for false.
    #[must_use]
    pub const fn of_truth(holds: bool) -> Self {
        Self::Sign(if holds { Sign::Positive } else { Sign::Zero })
    }

    /// Signs negated, all else as it is.
    #[must_use]
    pub fn flipped(self) -> Self {
        match self {
            Self::Sign(sign) => Self::Sign(-sign),
            other => other,
        }
    }
}

impl From<Sign> for Answer {
    fn from(sign: Sign) -> Self {
        Self::Sign(sign)
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sign(sign) => write!(f, "{}", sign.as_i8()),
            Self::Nan => f.write_str("nan"),
            Self::Unsupported => f.write_str("unsupported"),
            Self::Bad(text) => write!(f, "{text:?}"),
            Self::Crash => f.write_str("crash"),
            Self::Hang => f.write_str("hang"),
        }
    }
}

/// How an answer is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Class {
    /// 1 for -1 or -1 for 1.
    WrongSign,
    /// 0 for a value that is not zero.
    FalseZero,
    /// A sign for a value that is zero.
    FalseNonZero,
    /// No sign at all.
    Nan,
    /// Not an answer in the protocol.
    BadAnswer,
    /// The subject ended or panicked.
    Crash,
    /// The subject did not answer in time.
    Hang,
    /// Two orders of the same points got answers that contradict each other, whatever the truth is.
    Inconsistent,
}

impl Class {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::WrongSign,
        Self::FalseZero,
        Self::FalseNonZero,
        Self::Nan,
        Self::BadAnswer,
        Self::Crash,
        Self::Hang,
        Self::Inconsistent,
    ];

    /// Its name in tables and corpus files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::WrongSign => "wrong-sign",
            Self::FalseZero => "false-zero",
            Self::FalseNonZero => "false-non-zero",
            Self::Nan => "nan",
            Self::BadAnswer => "bad-answer",
            Self::Crash => "crash",
            Self::Hang => "hang",
            Self::Inconsistent => "inconsistent",
        }
    }

    /// The class of `answer` where `expected` is right; `None` if the answer is right or withheld.
    #[must_use]
    pub fn of(answer: &Answer, expected: Sign) -> Option<Self> {
        match answer {
            Answer::Unsupported => None,
            Answer::Nan => Some(Self::Nan),
            Answer::Bad(_) => Some(Self::BadAnswer),
            Answer::Crash => Some(Self::Crash),
            Answer::Hang => Some(Self::Hang),
            Answer::Sign(sign) if *sign == expected => None,
            Answer::Sign(Sign::Zero) => Some(Self::FalseZero),
            Answer::Sign(_) if expected.is_zero() => Some(Self::FalseNonZero),
            Answer::Sign(_) => Some(Self::WrongSign),
        }
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
