//! `specs/missile_pitch.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::missile_pitch::Emitted>()
}
