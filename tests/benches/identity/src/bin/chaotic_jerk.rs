//! `specs/chaotic_jerk.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::chaotic_jerk::Emitted>()
}
