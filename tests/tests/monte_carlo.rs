//! Campaigns are pure functions of (seed, run): nothing else, threads least of all, changes a bit.

use nsv_generated::{
    flexible_joint, motor_arm, nsv_attitude, pendulum, two_link_arm, underwater_vehicle,
};
use nsv_runtime::closed_loop::{ClosedLoop, Options};
use nsv_runtime::ensemble::{Campaign, Summary, run};

const CAMPAIGN: Campaign = Campaign {
    seed: 5,
    first_run: 0,
    runs: 5,
    horizon: 0.4,
    settle: 0.2,
    noise: true,
    dispersion: true,
    threads: 1,
    band: true,
};

/// The bits of all telemetry of a run.
fn trajectory<L: ClosedLoop>(options: &Options, samples: usize) -> Vec<u64> {
    let mut closed_loop = L::new(options);
    let mut bits = Vec::new();
    for _ in 0..samples {
        closed_loop.control();
        let mut row = vec![0.0; L::SIGNALS.len()];
        closed_loop.telemetry(&mut row);
        bits.extend(row.into_iter().map(f64::to_bits));
        closed_loop.advance();
    }
    bits
}

/// A summary without the time it took, to the last bit, since floats are printed exactly.
fn result(summary: &Summary) -> String {
    format!(
        "{:?}",
        Summary {
            wall_s: 0.0,
            ..summary.clone()
        }
    )
}

fn check_threads<L: ClosedLoop>() {
    let [one, two, three] = [1, 2, 3].map(|threads| {
        result(&run::<L>(
            &Campaign {
                threads,
                ..CAMPAIGN
            },
            |_| {},
        ))
    });
    assert_eq!(one, two, "{}", L::NAME);
    assert_eq!(one, three, "{}", L::NAME);
}

/// The largest ratio of each run alone, of run k of a campaign, and of its trajectory are one number.
fn check_alone<L: ClosedLoop>() {
    let ratio = |first_run, runs| {
        let campaign = Campaign {
            first_run,
            runs,
            ..CAMPAIGN
        };
        run::<L>(&campaign, |_| {})
            .ratio
            .map(|ratio| ratio.max.to_bits())
    };
    let alone: Vec<Option<u64>> = (0..CAMPAIGN.runs).map(|k| ratio(k, 1)).collect();
    assert_eq!(
        ratio(0, CAMPAIGN.runs),
        alone.iter().max().copied().unwrap(),
        "{}",
        L::NAME
    );
    assert_eq!(
        ratio(2, 3),
        alone[2..].iter().max().copied().unwrap(),
        "{}",
        L::NAME
    );
    let distinct = |run| {
        trajectory::<L>(
            &Options {
                seed: 5,
                run,
                noise: true,
                dispersion: true,
            },
            20,
        )
    };
    assert_eq!(distinct(3), distinct(3), "{}", L::NAME);
    assert_ne!(distinct(3), distinct(4), "{}", L::NAME);
}

fn check_all<L: ClosedLoop>() {
    check_threads::<L>();
    check_alone::<L>();
}

#[test]
fn a_run_depends_on_seed_and_number_alone() {
    check_all::<flexible_joint::Simulator>();
    check_all::<motor_arm::Simulator>();
    check_all::<nsv_attitude::Simulator>();
    check_all::<pendulum::Simulator>();
    check_all::<two_link_arm::Simulator>();
    check_all::<underwater_vehicle::Simulator>();
}

/// Without noise and dispersion the seed does not count; with noise it does.
#[test]
fn noise_and_dispersion_are_choices() {
    let of = |seed, noise, dispersion| {
        trajectory::<nsv_attitude::Simulator>(
            &Options {
                seed,
                run: 1,
                noise,
                dispersion,
            },
            50,
        )
    };
    assert_eq!(of(1, false, false), of(2, false, false));
    assert_ne!(of(1, true, false), of(1, false, false));
    assert_ne!(of(1, true, false), of(2, true, false));
    assert_ne!(of(1, false, true), of(1, false, false));
    // A plant without noise is the same with noise switched on.
    let of = |noise| {
        trajectory::<pendulum::Simulator>(
            &Options {
                seed: 1,
                run: 1,
                noise,
                dispersion: true,
            },
            50,
        )
    };
    assert_eq!(of(true), of(false));
}

/// Draws lie in their bounds, fill them, and have the mean and variance of a uniform distribution.
#[test]
fn dispersions_are_as_declared() {
    let runs = 2000;
    let (low, high) = (0.8, 1.2);
    let draw = |run| {
        let closed_loop = nsv_attitude::Simulator::new(&Options {
            seed: 9,
            run,
            noise: false,
            dispersion: true,
        });
        let params = closed_loop.params();
        [
            params.CL_scale,
            params.CD_scale,
            params.CY_scale,
            params.Cl_scale,
            params.Cm_scale,
            params.Cn_scale,
        ]
    };
    let draws: Vec<[f64; 6]> = (0..runs).map(draw).collect();
    for parameter in 0..6 {
        let values = || draws.iter().map(|draw| draw[parameter]);
        assert!(values().all(|value| (low..=high).contains(&value)));
        assert!(
            values().any(|value| value < low + 0.01) && values().any(|value| value > high - 0.01)
        );
        let mean = values().sum::<f64>() / runs as f64;
        let variance = values()
            .map(|value| (value - mean) * (value - mean))
            .sum::<f64>()
            / runs as f64;
        assert!((mean - 1.0).abs() < 0.012, "{mean}");
        assert!((variance - 0.16 / 12.0).abs() < 0.0015, "{variance}");
        for other in 0..parameter {
            let product = draws
                .iter()
                .map(|draw| (draw[parameter] - 1.0) * (draw[other] - 1.0))
                .sum::<f64>()
                / runs as f64;
            assert!(
                product.abs() < 0.001,
                "parameters {parameter} and {other} are independent: {product}"
            );
        }
    }
    let nominal = nsv_attitude::Simulator::new(&Options {
        seed: 9,
        run: 3,
        noise: true,
        dispersion: false,
    });
    assert_eq!(nominal.params(), &nsv_attitude::Params::plant());
}
