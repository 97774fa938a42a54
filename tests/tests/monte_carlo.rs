//! Campaigns are pure functions of (seed, run): nothing else, threads least of all, changes a bit.

use nsv_generated::nsv_attitude;
use nsv_runtime::closed_loop::{Options, Runs};
use nsv_runtime::ensemble::{Campaign, Summary};
use nsv_runtime::lanes::Width;
use nsv_tests::flights::{ALL, Flight, NSV_ATTITUDE, PENDULUM};

const CAMPAIGN: Campaign = Campaign {
    seed: 5,
    first_run: 0,
    runs: 11,
    horizon: 0.4,
    settle: 0.2,
    noise: true,
    dispersion: true,
    width: None,
    threads: 1,
    band: true,
};

/// The bits of all telemetry of a run.
fn trajectory(flight: &Flight, options: &Options, samples: usize) -> Vec<u64> {
    let rows = (flight.telemetry)(options, samples);
    rows.into_iter().flatten().map(f64::to_bits).collect()
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

fn check_threads_and_lanes(flight: &Flight) {
    let with = |threads, width| {
        result(&(flight.campaign)(&Campaign {
            threads,
            width,
            ..CAMPAIGN
        }))
    };
    let one = with(1, Some(Width::Scalar));
    for threads in [1, 2, 3] {
        assert_eq!(with(threads, None), one, "{}, {threads}", flight.name);
    }
    for width in Width::ALL.into_iter().filter(|width| width.is_available()) {
        assert_eq!(with(1, Some(width)), one, "{}, {width:?}", flight.name);
    }
}

/// The largest ratio of each run alone, of run k of a campaign, and of its trajectory are one number.
fn check_alone(flight: &Flight) {
    let ratio = |first_run, runs| {
        let campaign = Campaign {
            first_run,
            runs,
            ..CAMPAIGN
        };
        (flight.campaign)(&campaign)
            .ratio
            .map(|ratio| ratio.max.to_bits())
    };
    let alone: Vec<Option<u64>> = (0..CAMPAIGN.runs).map(|k| ratio(k, 1)).collect();
    assert_eq!(
        ratio(0, CAMPAIGN.runs),
        alone.iter().max().copied().unwrap(),
        "{}",
        flight.name
    );
    assert_eq!(
        ratio(2, 3),
        alone[2..5].iter().max().copied().unwrap(),
        "{}",
        flight.name
    );
    let distinct = |run| {
        trajectory(
            flight,
            &Options {
                seed: 5,
                run,
                noise: true,
                dispersion: true,
            },
            20,
        )
    };
    assert_eq!(distinct(3), distinct(3), "{}", flight.name);
    assert_ne!(distinct(3), distinct(4), "{}", flight.name);
}

#[test]
fn a_run_depends_on_seed_and_number_alone() {
    for flight in ALL {
        check_threads_and_lanes(flight);
        check_alone(flight);
    }
}

/// Without noise and dispersion the seed does not count; with noise it does.
#[test]
fn noise_and_dispersion_are_choices() {
    let of = |seed, noise, dispersion| {
        trajectory(
            &NSV_ATTITUDE,
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
        trajectory(
            &PENDULUM,
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
        let closed_loop = nsv_attitude::Simulator::<f64>::new(&Options {
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
    let nominal = nsv_attitude::Simulator::<f64>::new(&Options {
        seed: 9,
        run: 3,
        noise: true,
        dispersion: false,
    });
    assert_eq!(nominal.params(), &nsv_attitude::Params::plant());
}
