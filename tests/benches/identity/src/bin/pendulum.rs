//! `specs/pendulum.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::run::<nsv_identity::emitted::pendulum::Emitted>()
}
