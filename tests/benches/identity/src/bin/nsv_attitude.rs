//! `specs/nsv_attitude.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::nsv_attitude::Emitted>()
}
