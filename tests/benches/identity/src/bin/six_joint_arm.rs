//! `specs/six_joint_arm.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::six_joint_arm::Emitted>()
}
