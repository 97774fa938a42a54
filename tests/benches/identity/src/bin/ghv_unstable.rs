//! `specs/ghv_unstable.yaml`

use std::process::ExitCode;

fn main() -> ExitCode {
    nsv_identity::strict::<nsv_identity::emitted::ghv_unstable::Emitted>()
}
