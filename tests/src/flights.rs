//! The committed simulators, compiled once for all tests: the smallest in every width of lanes, the others in scalars and pairs, since each
//! width takes the compiler a while.

use nsv_generated::{
    flexible_joint, missile_pitch, motor_arm, nsv_attitude, nsv_six_dof, pendulum, two_link_arm,
    underwater_vehicle,
};
use nsv_runtime::closed_loop::{ClosedLoop, InLanes, Options, Runs};
use nsv_runtime::ensemble::{Campaign, Summary, run};

/// A simulator without its type.
pub struct Flight {
    /// Name of the specification.
    pub name: &'static str,
    /// Telemetry columns.
    pub signals: &'static [&'static str],
    /// Simulates a campaign.
    pub campaign: fn(&Campaign) -> Summary,
    /// The telemetry of a run's first samples.
    pub telemetry: fn(&Options, usize) -> Vec<Vec<f64>>,
}

/// `specs/flexible_joint.yaml`.
pub static FLEXIBLE_JOINT: Flight = flight::<InPairs<flexible_joint::Simulator>>();
/// `specs/missile_pitch.yaml`.
pub static MISSILE_PITCH: Flight = flight::<InPairs<missile_pitch::Simulator>>();
/// `specs/motor_arm.yaml`.
pub static MOTOR_ARM: Flight = flight::<InPairs<motor_arm::Simulator>>();
/// `specs/nsv_attitude.yaml`.
pub static NSV_ATTITUDE: Flight = flight::<InPairs<nsv_attitude::Simulator>>();
/// `specs/nsv_six_dof.yaml`.
pub static NSV_SIX_DOF: Flight = flight::<InPairs<nsv_six_dof::Simulator>>();
/// `specs/pendulum.yaml`.
pub static PENDULUM: Flight = flight::<pendulum::Simulator>();
/// `specs/two_link_arm.yaml`.
pub static TWO_LINK_ARM: Flight = flight::<InPairs<two_link_arm::Simulator>>();
/// `specs/underwater_vehicle.yaml`.
pub static UNDERWATER_VEHICLE: Flight = flight::<InPairs<underwater_vehicle::Simulator>>();

/// All of them.
pub static ALL: [&Flight; 8] = [
    &FLEXIBLE_JOINT,
    &MISSILE_PITCH,
    &MOTOR_ARM,
    &NSV_ATTITUDE,
    &NSV_SIX_DOF,
    &PENDULUM,
    &TWO_LINK_ARM,
    &UNDERWATER_VEHICLE,
];

impl Flight {
    /// The column of a signal.
    pub fn column(&self, signal: &str) -> usize {
        let found = self.signals.iter().position(|known| *known == signal);
        found.unwrap_or_else(|| panic!("{signal} is a signal of {}", self.name))
    }
}

/// A simulator whose campaigns run in scalars or in lanes of two, which every processor has.
type InPairs<L> = InLanes<L, 2>;

const fn flight<L: ClosedLoop>() -> Flight {
    Flight {
        name: L::NAME,
        signals: L::SIGNALS,
        campaign: |campaign| run::<L>(campaign, |_| {}),
        telemetry: telemetry::<L>,
    }
}

fn telemetry<L: ClosedLoop>(options: &Options, samples: usize) -> Vec<Vec<f64>> {
    let mut runs = L::Runs::<f64>::new(options);
    let rows = (0..samples).map(|_| {
        let mut row = vec![0.0; L::SIGNALS.len()];
        runs.observe();
        runs.control();
        runs.telemetry(&mut row);
        runs.advance();
        row
    });
    rows.collect()
}
