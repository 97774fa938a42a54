//! `fast SPEC POINTS SEED`: what `--math fast` changes.

use std::env;
use std::process::ExitCode;

use nsv_identity::emitted::{flexible_joint, motor_arm, nsv_attitude, pendulum, two_link_arm, underwater_vehicle};
use nsv_identity::fast;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let number = |at: usize| arguments.get(at).and_then(|text| text.parse::<u64>().ok());
    let compare = match arguments.first().map(String::as_str) {
        Some("flexible_joint") => fast::<flexible_joint::Emitted>,
        Some("motor_arm") => fast::<motor_arm::Emitted>,
        Some("nsv_attitude") => fast::<nsv_attitude::Emitted>,
        Some("pendulum") => fast::<pendulum::Emitted>,
        Some("two_link_arm") => fast::<two_link_arm::Emitted>,
        Some("underwater_vehicle") => fast::<underwater_vehicle::Emitted>,
        _ => return ExitCode::FAILURE,
    };
    let (Some(count), Some(seed)) = (number(1), number(2)) else { return ExitCode::FAILURE };
    compare(count, seed);
    ExitCode::SUCCESS
}
