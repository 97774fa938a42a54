//! Fuzzes [`nsv_fuzz::entry::expression`].
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| nsv_fuzz::entry::expression(bytes));
