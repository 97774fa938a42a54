//! Support library of nsv's generated code.
#![no_std]
#![forbid(unsafe_code)]
