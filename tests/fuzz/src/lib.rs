//! What is fuzzed: one function for each reader of text that nobody vouches for.

pub mod entry;
