//! `specs/quadrotor.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::quadrotor::Emitted>()
}
