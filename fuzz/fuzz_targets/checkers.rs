//! libFuzzer entry of [`homeo_fuzz_targets::checkers`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz_targets::checkers(data));
