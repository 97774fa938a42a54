//! Cross-crate tests of nsv live in `tests/`; this library is empty.
