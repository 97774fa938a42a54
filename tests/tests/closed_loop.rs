//! Closed loops of the committed code: the figures that the reference implementation (`tests/reference/closed_loop.py`) gives, and held
//! constraints.

use nsv_generated::{
    flexible_joint, motor_arm, nsv_attitude, pendulum, two_link_arm, underwater_vehicle,
};
use nsv_runtime::closed_loop::{ClosedLoop, Options};
use nsv_runtime::ensemble::{Campaign, Summary, run};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// One run without noise and dispersion.
const NOMINAL: Campaign = Campaign {
    seed: 1,
    first_run: 0,
    runs: 1,
    horizon: 10.0,
    settle: 3.0,
    noise: false,
    dispersion: false,
    threads: 2,
    band: false,
};

/// Figures of one output's tracking: the largest `||e_1|| / k_1`, and the root mean square error of each output after settling, SI.
struct Figures<'a> {
    ratio: f64,
    rms: &'a [f64],
}

/// No run diverges, the constraint is held, and inputs are seldom at their limits.
fn flown<L: ClosedLoop>(campaign: &Campaign) -> Summary {
    let summary = run::<L>(campaign, |_| {});
    assert_eq!(
        (summary.nonfinite, summary.violated),
        (0, Some(0.0)),
        "{}",
        L::NAME
    );
    for (input, fraction) in &summary.saturated_fraction {
        assert!(
            *fraction < 0.02,
            "{}: {input} is at its limit for {fraction} of the time",
            L::NAME
        );
    }
    summary
}

/// The median run has the ratio to 0.002, and the rms errors to two percent.
fn check<L: ClosedLoop>(campaign: &Campaign, expected: &Figures<'_>) {
    let summary = flown::<L>(campaign);
    let ratio = summary
        .ratio
        .unwrap_or_else(|| panic!("{} has a constraint", L::NAME))
        .median;
    assert!(
        (ratio - expected.ratio).abs() < 0.002,
        "{}: ratio {ratio}, expected {}",
        L::NAME,
        expected.ratio
    );
    assert_eq!(summary.rms_tracking.len(), expected.rms.len());
    for ((channel, rms), expected) in summary.rms_tracking.iter().zip(expected.rms) {
        assert!(
            (rms / expected - 1.0).abs() < 0.02,
            "{}: rms of {channel} is {rms}, expected {expected}",
            L::NAME
        );
    }
}

/// With noise and dispersion the constraint is held, and rms errors stay below a bound.
fn check_dispersed<L: ClosedLoop>(rms: f64) {
    let summary = flown::<L>(&Campaign {
        runs: 4,
        noise: true,
        dispersion: true,
        ..NOMINAL
    });
    assert!(
        summary.rms_tracking.iter().all(|(_, found)| *found < rms),
        "{}: {:?}",
        L::NAME,
        summary.rms_tracking
    );
}

/// The signal of this name in the present sample.
fn signal<L: ClosedLoop>(closed_loop: &L, name: &str) -> f64 {
    let mut row = vec![0.0; L::SIGNALS.len()];
    closed_loop.telemetry(&mut row);
    row[L::SIGNALS
        .iter()
        .position(|signal| *signal == name)
        .unwrap_or_else(|| panic!("{name} is a signal"))]
}

/// Section 5 of the paper: the largest error relative to its bound is at the start, and some hundredths of a degree remain.
#[test]
fn the_paper_is_reproduced_without_noise() {
    let figures = Figures {
        ratio: 0.4766,
        rms: &[0.02702 * DEGREE, 0.00945 * DEGREE, 0.03965 * DEGREE],
    };
    check::<nsv_attitude::Simulator>(
        &Campaign {
            horizon: 20.0,
            settle: 4.5,
            ..NOMINAL
        },
        &figures,
    );
}

/// Noise hardly moves the largest ratio, which is that of the start.
#[test]
fn the_paper_is_reproduced_with_noise() {
    let start = Campaign {
        runs: 200,
        horizon: 0.5,
        settle: 0.5,
        noise: true,
        ..NOMINAL
    };
    let ratio = run::<nsv_attitude::Simulator>(&start, |_| {})
        .ratio
        .unwrap();
    assert!(
        (ratio.median - 0.477).abs() < 0.002 && ratio.max < 0.5,
        "{ratio:?}"
    );
    let summary = flown::<nsv_attitude::Simulator>(&Campaign {
        runs: 3,
        horizon: 20.0,
        settle: 4.5,
        noise: true,
        ..NOMINAL
    });
    for ((channel, rms), about) in summary.rms_tracking.iter().zip([0.04, 0.025, 0.045]) {
        assert!(
            (0.5 * about..1.5 * about).contains(&(rms / DEGREE)),
            "rms of {channel} is {} deg",
            rms / DEGREE
        );
    }
}

/// Disturbance estimates follow the true disturbances of the flagship.
#[test]
fn observers_converge() {
    let mut closed_loop = nsv_attitude::Simulator::new(&Options {
        seed: 1,
        run: 0,
        noise: true,
        dispersion: false,
    });
    let errors = [
        ("1.alpha", 0.004),
        ("1.beta", 0.004),
        ("1.mu", 0.004),
        ("2.p", 0.1),
        ("2.q", 0.12),
        ("2.r", 0.1),
    ];
    let mut squares = [0.0; 6];
    let (samples, settle) = (5000, 2250);
    for sample in 0..samples {
        closed_loop.control();
        for ((channel, _), square) in errors.iter().zip(&mut squares).filter(|_| sample >= settle) {
            let error = signal(&closed_loop, &format!("D_hat{channel}"))
                - signal(&closed_loop, &format!("d{channel}"));
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
    check::<pendulum::Simulator>(
        &NOMINAL,
        &Figures {
            ratio: 0.1389,
            rms: &[0.002541],
        },
    );
    check_dispersed::<pendulum::Simulator>(0.01);
}

#[test]
fn the_two_link_arm_carries_its_load() {
    check::<two_link_arm::Simulator>(
        &NOMINAL,
        &Figures {
            ratio: 0.4076,
            rms: &[0.003551, 0.005195],
        },
    );
    check_dispersed::<two_link_arm::Simulator>(0.01);
}

#[test]
fn the_motor_turns_its_arm() {
    check::<motor_arm::Simulator>(
        &NOMINAL,
        &Figures {
            ratio: 0.2889,
            rms: &[0.004492],
        },
    );
    check_dispersed::<motor_arm::Simulator>(0.01);
}

#[test]
fn the_elastic_joint_moves_its_link() {
    check::<flexible_joint::Simulator>(
        &NOMINAL,
        &Figures {
            ratio: 0.2870,
            rms: &[0.002527],
        },
    );
    check_dispersed::<flexible_joint::Simulator>(0.01);
}

#[test]
fn the_vehicle_finds_its_way_in_a_current() {
    check::<underwater_vehicle::Simulator>(
        &Campaign {
            horizon: 40.0,
            settle: 10.0,
            ..NOMINAL
        },
        &Figures {
            ratio: 0.4287,
            rms: &[0.01654, 0.00769, 0.00660, 0.001923, 0.001746, 0.002254],
        },
    );
    check_dispersed::<underwater_vehicle::Simulator>(0.03);
}
