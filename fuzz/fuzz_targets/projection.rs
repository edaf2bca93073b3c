//! libFuzzer entry of [`homeo_fuzz::projection`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::projection(data));
