//! `specs/nsv_six_dof.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::nsv_six_dof::Emitted>()
}
