//! `specs/two_link_arm.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::two_link_arm::Emitted>()
}
