//! libFuzzer entry of [`homeo_fuzz::checkers`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::checkers(data));
