//! Cross-crate tests of nsv live in `tests/`. This library is empty but for the README, whose Rust is compiled and run as a doc test.
#![doc = include_str!("../README.md")]
