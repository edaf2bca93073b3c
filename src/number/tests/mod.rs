mod dyadic;
mod fixed;
mod quick;
mod rational;

/// Invokes the macro `$suite` with the name and the type of every backend but the default.
macro_rules! other_backends {
    ($suite:ident) => {
        #[cfg(feature = "rug")]
        $suite!(rug, ::rug::Rational);
        #[cfg(feature = "malachite")]
        $suite!(malachite, ::malachite::rational::Rational);
        #[cfg(feature = "num-rational")]
        $suite!(num_rational, ::num_rational::Ratio<::num_bigint::BigInt>);
    };
}

/// Invokes the macro `$suite` with the name and the type of every backend that is compiled in.
macro_rules! backends {
    ($suite:ident) => {
        $suite!(dashu, crate::number::Rat);
        crate::number::tests::other_backends!($suite);
    };
}

use {backends, other_backends};

/// How many random cases a property gets: `HOMEO_CASES`, for long runs, or else this many.
fn cases(usual: u32) -> u32 {
    match std::env::var("HOMEO_CASES") {
        Ok(count) => count.parse().expect("HOMEO_CASES is a number"),
        Err(_) => usual,
    }
}
