//! Expressions: text to tokens, tokens to a syntax tree with spans, syntax tree to typed nodes in a hash-consed arena.

pub mod arena;
