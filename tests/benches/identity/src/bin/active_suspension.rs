//! `specs/active_suspension.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::active_suspension::Emitted>()
}
