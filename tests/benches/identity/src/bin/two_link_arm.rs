//! `specs/two_link_arm.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::run::<nsv_identity::emitted::two_link_arm::Emitted>()
}
