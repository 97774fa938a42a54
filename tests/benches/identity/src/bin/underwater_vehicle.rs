//! `specs/underwater_vehicle.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::underwater_vehicle::Emitted>()
}
