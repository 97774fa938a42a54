//! `specs/underwater_vehicle.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::run::<nsv_identity::emitted::underwater_vehicle::Emitted>()
}
