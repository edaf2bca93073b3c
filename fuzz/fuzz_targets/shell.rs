//! libFuzzer entry of [`homeo_fuzz::shell`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::shell(data));
