//! libFuzzer entry of [`homeo_fuzz::certificate`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::certificate(data));
