//! `specs/flexible_joint.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::flexible_joint::Emitted>()
}
