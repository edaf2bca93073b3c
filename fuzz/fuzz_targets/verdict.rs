//! libFuzzer entry of [`homeo_fuzz::verdict`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::verdict(data));
