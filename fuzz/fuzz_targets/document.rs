//! libFuzzer entry of [`homeo_fuzz::document`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::document(data));
