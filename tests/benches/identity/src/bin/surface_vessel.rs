//! `specs/surface_vessel.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::surface_vessel::Emitted>()
}
