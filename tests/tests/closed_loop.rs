//! Closed loops of the committed code: the figures that the reference implementation gives, held constraints, and total steps.

use nsv_generated::{motor_arm, nsv_attitude, pendulum, two_link_arm};
use nsv_runtime::closed_loop::{ClosedLoop, Options};
use nsv_runtime::ensemble::{Campaign, Summary, run};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// One run without noise and dispersion.
const NOMINAL: Campaign =
    Campaign { seed: 1, first_run: 0, runs: 1, horizon: 10.0, settle: 3.0, noise: false, dispersion: false, threads: 2, band: false };

/// The spread that a specification declares, over a few runs.
const DISPERSED: Campaign = Campaign { runs: 4, noise: true, dispersion: true, ..NOMINAL };

/// What a campaign must give.
struct Expected {
    /// Median over the runs of the largest `||e_1|| / k_1`, and how far from it.
    ratio: (f64, f64),
    /// Bound of the root mean square error after settling, SI, for each output.
    rms: &'static [f64],
    /// Bound of the fraction of samples at which an input is at its limit.
    saturated: f64,
}

fn check<L: ClosedLoop>(campaign: &Campaign, expected: &Expected) -> Summary {
    let summary = run::<L>(campaign, |_| {});
    assert_eq!(summary.nonfinite, 0, "{}", L::NAME);
    let ratio = summary.ratio.unwrap_or_else(|| panic!("{} has a constraint", L::NAME)).median;
    let (middle, width) = expected.ratio;
    assert!((ratio - middle).abs() <= width, "{}: ratio {ratio}, expected {middle} +- {width}", L::NAME);
    for ((channel, rms), bound) in summary.rms_tracking.iter().zip(expected.rms) {
        assert!(rms <= bound, "{}: rms of {channel} is {rms}, at most {bound} expected", L::NAME);
    }
    for (input, fraction) in &summary.saturated_fraction {
        assert!(*fraction <= expected.saturated, "{}: {input} is at its limit for {fraction} of the time", L::NAME);
    }
    summary
}

/// The signal of this name in the present sample.
fn signal<L: ClosedLoop>(closed_loop: &L, name: &str) -> f64 {
    let mut row = vec![0.0; L::SIGNALS.len()];
    closed_loop.telemetry(&mut row);
    row[L::SIGNALS.iter().position(|signal| *signal == name).unwrap_or_else(|| panic!("{name} is a signal"))]
}

/// Section 5 of the paper: the largest error relative to its bound is at the start, and some hundredths of a degree remain.
#[test]
fn the_paper_is_reproduced_without_noise() {
    let campaign = Campaign { horizon: 20.0, settle: 4.5, ..NOMINAL };
    let expected = Expected { ratio: (0.477, 0.002), rms: &[0.05 * DEGREE; 3], saturated: 0.02 };
    let summary = check::<nsv_attitude::Simulator>(&campaign, &expected);
    assert_eq!(summary.violated, Some(0.0));
    assert_eq!(summary.samples, 10_001);
}

#[test]
fn the_paper_is_reproduced_with_noise() {
    let expected = Expected { ratio: (0.477, 0.002), rms: &[0.1 * DEGREE; 3], saturated: 0.05 };
    let start = Campaign { runs: 200, horizon: 0.5, settle: 0.5, noise: true, ..NOMINAL };
    let at_start = Expected { rms: &[f64::INFINITY; 3], saturated: 1.0, ..expected };
    assert_eq!(check::<nsv_attitude::Simulator>(&start, &at_start).violated, Some(0.0));
    check::<nsv_attitude::Simulator>(&Campaign { runs: 3, horizon: 20.0, settle: 4.5, noise: true, ..NOMINAL }, &expected);
}

/// Disturbance estimates follow the true disturbances of the flagship.
#[test]
fn observers_converge() {
    let mut closed_loop = nsv_attitude::Simulator::new(&Options { seed: 1, run: 0, noise: true, dispersion: false });
    let errors = [("1.alpha", 0.004), ("1.beta", 0.004), ("1.mu", 0.004), ("2.p", 0.1), ("2.q", 0.12), ("2.r", 0.1)];
    let mut squares = [0.0; 6];
    let (samples, settle) = (5000, 2250);
    for sample in 0..samples {
        closed_loop.control();
        for ((channel, _), square) in errors.iter().zip(&mut squares).filter(|_| sample >= settle) {
            let error = signal(&closed_loop, &format!("D_hat{channel}")) - signal(&closed_loop, &format!("d{channel}"));
            *square += error * error;
        }
        closed_loop.advance();
    }
    for ((channel, bound), square) in errors.iter().zip(squares) {
        let rms = (square / f64::from(samples - settle)).sqrt();
        assert!(rms < *bound, "error of D_hat{channel} is {rms}");
    }
}

#[test]
fn the_single_link_arm_tracks_in_the_wind() {
    check::<pendulum::Simulator>(&NOMINAL, &Expected { ratio: (0.25, 0.25), rms: &[0.01], saturated: 0.02 });
    check::<pendulum::Simulator>(&DISPERSED, &Expected { ratio: (0.25, 0.25), rms: &[0.01], saturated: 0.02 });
}

#[test]
fn the_two_link_arm_carries_its_load() {
    check::<two_link_arm::Simulator>(&NOMINAL, &Expected { ratio: (0.25, 0.25), rms: &[0.01; 2], saturated: 0.02 });
    check::<two_link_arm::Simulator>(&DISPERSED, &Expected { ratio: (0.25, 0.25), rms: &[0.01; 2], saturated: 0.02 });
}

#[test]
fn the_motor_turns_its_arm() {
    check::<motor_arm::Simulator>(&NOMINAL, &Expected { ratio: (0.25, 0.25), rms: &[0.01], saturated: 0.02 });
    check::<motor_arm::Simulator>(&DISPERSED, &Expected { ratio: (0.25, 0.25), rms: &[0.01], saturated: 0.02 });
}
