//! `specs/motor_arm.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::motor_arm::Emitted>()
}
