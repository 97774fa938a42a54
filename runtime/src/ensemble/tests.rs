use std::cell::Cell;
use std::ops::ControlFlow;
use std::vec::Vec;

use super::{Campaign, Summary, run, run_while};
use crate::closed_loop::{Options, Runs};
use crate::lanes::Width;
use crate::mock::MockLoop;
use crate::simulation::simulate;

fn campaign() -> Campaign {
    Campaign {
        seed: 5,
        first_run: 0,
        runs: 60,
        horizon: 1.0,
        settle: 0.3,
        noise: true,
        dispersion: true,
        width: None,
        threads: 1,
        band: true,
    }
}

/// A summary without its duration.
fn outcome(campaign: &Campaign) -> Summary {
    let summary = run::<MockLoop<true>>(campaign, |_| {});
    Summary {
        wall_s: 0.0,
        ..summary
    }
}

/// Largest constraint ratio of a run simulated by hand; infinite if it diverges.
fn largest_ratio(run: u64) -> f64 {
    let mut plant = MockLoop::<true, f64>::new(&Options {
        seed: 5,
        run,
        noise: true,
        dispersion: true,
    });
    let mut largest = 0.0_f64;
    for sample in 0..=100 {
        if sample > 0 {
            plant.advance();
        }
        plant.control(false);
        if !plant.is_finite() {
            return f64::INFINITY;
        }
        largest = largest.max(plant.constraint_ratio());
    }
    largest
}

#[test]
fn threads_do_not_change_the_result() {
    let one = outcome(&campaign());
    for threads in [2, 3, 16] {
        assert_eq!(
            outcome(&Campaign {
                threads,
                ..campaign()
            }),
            one,
            "{threads} threads"
        );
    }
}

#[test]
fn lanes_do_not_change_the_result() {
    let scalar = outcome(&Campaign {
        width: Some(Width::Scalar),
        ..campaign()
    });
    for width in Width::ALL.into_iter().filter(|width| width.is_available()) {
        // 59 runs leave lanes of the last batch without one.
        for (runs, alike) in [(60, true), (59, false)] {
            let lanes = outcome(&Campaign {
                width: Some(width),
                runs,
                ..campaign()
            });
            assert_eq!(lanes == scalar, alike, "{width:?}");
        }
    }
}

#[test]
fn a_run_alone_is_the_run_among_others() {
    let all = outcome(&campaign());
    let alone: Vec<Summary> = (0..60)
        .map(|first_run| {
            outcome(&Campaign {
                first_run,
                runs: 1,
                ..campaign()
            })
        })
        .collect();
    assert_eq!(all.samples, alone.iter().map(|run| run.samples).sum());
    assert_eq!(all.nonfinite, alone.iter().map(|run| run.nonfinite).sum());
    let mut ratios: Vec<f64> = alone
        .iter()
        .filter_map(|run| run.ratio)
        .map(|ratio| ratio.max)
        .collect();
    let by_hand: Vec<f64> = (0..60).map(largest_ratio).collect();
    assert_eq!(ratios, by_hand);
    ratios.sort_by(f64::total_cmp);
    let ratio = all.ratio.expect("the loop is constrained");
    assert_eq!(
        [ratio.median, ratio.p90, ratio.p99, ratio.max],
        [ratios[29], ratios[53], ratios[59], ratios[59]]
    );
    let violations = ratios.iter().filter(|&&ratio| ratio >= 1.0).count();
    assert_eq!(all.violated, Some(violations as f64 / 60.0));
    // The test means little unless some runs hold, some violate and some diverge.
    assert!(all.nonfinite > 0 && (violations as u64) > all.nonfinite && violations < 60);
}

#[test]
fn diverged_runs_stop_and_count() {
    let stable = outcome(&Campaign {
        dispersion: false,
        ..campaign()
    });
    assert_eq!((stable.nonfinite, stable.samples), (0, 60 * 101));
    let dispersed = outcome(&campaign());
    assert!(dispersed.samples < 60 * 101);
    assert_eq!(dispersed.ratio.map(|ratio| ratio.max), Some(f64::INFINITY));
}

#[test]
fn tracking_error_counts_from_the_settling_time() {
    let quiet = Campaign {
        noise: false,
        dispersion: false,
        runs: 1,
        ..campaign()
    };
    let options = Options {
        seed: 5,
        run: 0,
        noise: false,
        dispersion: false,
    };
    let mut sum = 0.0;
    let never = |_| false;
    simulate::<f64, MockLoop<true>>(&options, 100, never, |sample, run, _| {
        let mut error = [0.0];
        run.tracking_error(&mut error);
        if sample >= 30 {
            sum += error[0] * error[0];
        }
    });
    assert_eq!(
        outcome(&quiet).rms_tracking,
        [("x", (sum / 71.0_f64).sqrt())]
    );
    let never = outcome(&Campaign {
        settle: 2.0,
        ..quiet
    });
    assert!(never.rms_tracking[0].1.is_nan());
}

#[test]
fn an_unconstrained_loop_has_no_violations() {
    let summary = run::<MockLoop<false>>(&campaign(), |_| {});
    assert_eq!(
        (summary.violated, summary.violated_interval95, summary.ratio),
        (None, None, None)
    );
    assert!(summary.nonfinite > 0);
}

#[test]
fn band_encloses_every_run_on_its_grid() {
    // 2.5 s are 251 samples, fewer than the grid may have; 30 s are 3001, thinned by 3.
    for (horizon, rows, step) in [(2.5, 251, 0.01), (30.0, 1001, 0.03)] {
        let summary = outcome(&Campaign {
            horizon,
            runs: 9,
            ..campaign()
        });
        let band = summary.band.expect("a band was asked for");
        assert_eq!((band.rows(), band.columns().len()), (rows, 1 + 4 * 6));
        assert_eq!(band.columns()[..3], ["t", "x1.x:min", "x1.x:p05"]);
        assert!((band.row(rows - 1)[0] - step * (rows as f64 - 1.0)).abs() < 1e-12);
        let row = band.row(10);
        for of in row[1..].chunks(6) {
            assert!(of[..5].is_sorted() && of[0] <= of[5] && of[5] <= of[4]);
        }
    }
}

#[test]
fn a_campaign_can_be_broken_off() {
    let calls = Cell::new(0);
    let stop_at_third = |done| {
        calls.set(done);
        if done == 3 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let endless = Campaign {
        runs: u64::MAX,
        threads: 2,
        ..campaign()
    };
    assert_eq!(run_while::<MockLoop<true>>(&endless, stop_at_third), None);
    assert_eq!(calls.get(), 3);
}

#[test]
fn progress_counts_every_run() {
    let last = Cell::new(0);
    run::<MockLoop<true>>(
        &Campaign {
            threads: 4,
            ..campaign()
        },
        |done| {
            assert_eq!(done, last.get() + 1);
            last.set(done);
        },
    );
    assert_eq!(last.get(), 60);
}
