//! Fuzzes [`nsv_fuzz::entry::program`].
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| nsv_fuzz::entry::program(bytes));
