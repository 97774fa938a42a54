//! `nsv schema`: the JSON Schema of the specification language.

use super::failure::Failure;
use super::output;

/// Print the JSON Schema of the specification language, for editors
#[derive(clap::Args)]
pub(crate) struct Args {}

/// Runs the verb.
pub(crate) fn run(_args: &Args) -> Result<(), Failure> {
    output::json(&nsv_spec::json_schema())
}
