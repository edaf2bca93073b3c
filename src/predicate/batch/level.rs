//! Which vector instructions are used, chosen at run time.

/// The widths that the filters are compiled for. Answers do not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Level {
    /// What every processor of the architecture has; SSE2 on x86-64.
    Baseline,
    /// AVX2, four doubles at once.
    Avx2,
    /// AVX-512, eight doubles at once.
    Avx512,
}

impl Level {
    /// All levels, narrowest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The widest one that this processor has.
    #[must_use]
    pub fn widest() -> Self {
        Self::ALL.into_iter().rev().find(|level| level.is_available()).unwrap_or(Self::Baseline)
    }

    /// Does this processor have it?
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => pulp::x86::V3::try_new().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => pulp::x86::V4::try_new().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// Calls a function compiled for this level, or for what every processor has where this one has it not. What it
    /// calls must be inlined into it.
    #[inline(always)]
    pub(crate) fn run<R>(self, work: impl FnOnce() -> R) -> R {
        #[cfg(target_arch = "x86_64")]
        match self {
            Self::Avx512 => {
                if let Some(instructions) = pulp::x86::V4::try_new() {
                    return instructions.vectorize(work);
                }
            }
            Self::Avx2 => {
                if let Some(instructions) = pulp::x86::V3::try_new() {
                    return instructions.vectorize(work);
                }
            }
            Self::Baseline => {}
        }
        work()
    }
}
