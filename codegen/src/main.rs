//! The `nsv` command.
fn main() {}
