//! libFuzzer entry of [`homeo_fuzz::mesh`].
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| homeo_fuzz::mesh(data));
