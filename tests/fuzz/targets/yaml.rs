//! Fuzzes [`nsv_fuzz::entry::yaml`].
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| nsv_fuzz::entry::yaml(bytes));
