use std::cell::Cell;
use std::convert::Infallible;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::yield_now;
use std::vec::Vec;

use super::record::Record;
use super::tally::Tally;
use super::{Campaign, Flight, Shard, State, Summary, fly, run};
use crate::closed_loop::{Options, Runs};
use crate::lanes::Width;
use crate::mock::MockLoop;
use crate::noise::Noise;

pub(super) fn campaign() -> Campaign {
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

/// Largest constraint ratio of a run simulated by hand, from a sample on; infinite if it diverges.
fn largest_ratio(run: u64, from: u64) -> f64 {
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
        plant.control();
        if !plant.is_finite() {
            return f64::INFINITY;
        }
        if sample >= from {
            largest = largest.max(plant.constraint_ratio());
        }
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
    let by_hand = |from| -> Vec<f64> { (0..60).map(|run| largest_ratio(run, from)).collect() };
    assert_eq!(ratios, by_hand(0));
    let mut settled = by_hand(30);
    settled.sort_by(f64::total_cmp);
    let found = all.settled_ratio.expect("the loop is constrained");
    assert_eq!(
        [found.median, found.p90, found.max],
        [settled[29], settled[53], settled[59]]
    );
    assert!(found.median < all.ratio.map_or(0.0, |ratio| ratio.median));
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
    let mut run = MockLoop::<true, f64>::new(&options);
    let mut sum = 0.0;
    for sample in 0..=100 {
        if sample > 0 {
            run.advance();
        }
        run.control();
        let mut error = [0.0];
        run.tracking_error(&mut error);
        if sample >= 30 {
            sum += error[0] * error[0];
        }
    }
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
    // 2.5 s are 251 samples, fewer than the grid may have; 12 s are 1201, thinned by 3.
    for (horizon, rows, step) in [(2.5, 251, 0.01), (12.0, 401, 0.03)] {
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
    let endless = Campaign {
        runs: u64::MAX,
        threads: 2,
        ..campaign()
    };
    let start = State::new::<MockLoop<true>>(&endless);
    let calls = Cell::new(0);
    let stop_at_third = |_: &Flight<'_>| {
        calls.set(calls.get() + 1);
        if calls.get() == 3 {
            Err("enough")
        } else {
            Ok(())
        }
    };
    let ended = fly::<MockLoop<true>, _>(
        &endless,
        Shard::WHOLE,
        start.clone(),
        |_, _| Ok(()),
        stop_at_third,
    );
    assert_eq!((ended, calls.get()), (Err("enough"), 3));
    let ended = fly::<MockLoop<true>, _>(
        &endless,
        Shard::WHOLE,
        start,
        |_, _| Err("full"),
        |_| Ok(()),
    );
    assert_eq!(ended, Err("full"));
}

#[test]
fn progress_ends_with_all_runs() {
    let last = Cell::new(0);
    let four = Campaign {
        threads: 4,
        ..campaign()
    };
    run::<MockLoop<true>>(&four, |done| {
        assert!((last.get()..=60).contains(&done));
        last.set(done);
    });
    assert_eq!(last.get(), 60);
}

/// What a part of a campaign comes to.
fn part(shard: Shard) -> State {
    let many = many();
    let start = State::new::<MockLoop<true>>(&many);
    fly_on(&many, shard, start)
}

fn fly_on(campaign: &Campaign, shard: Shard, start: State) -> State {
    let flown =
        fly::<MockLoop<true>, Infallible>(campaign, shard, start, |_, _| Ok(()), |_| Ok(()));
    match flown {
        Ok(state) => state,
        Err(never) => match never {},
    }
}

fn many() -> Campaign {
    Campaign {
        runs: 500,
        threads: 2,
        ..campaign()
    }
}

/// The records of a campaign's runs.
fn records(campaign: &Campaign) -> Vec<Record> {
    let one = |run| Record::of_batch::<MockLoop<true>>(campaign, Width::Scalar, run, 1);
    (0..campaign.runs).flat_map(one).collect()
}

fn statistics(state: State) -> Summary {
    Summary {
        wall_s: 0.0,
        ..state.summary::<MockLoop<true>>()
    }
}

#[test]
fn parts_merge_to_the_whole_in_any_order() {
    let whole = outcome(&many());
    for of in [2, 3, 100] {
        let mut merged = State::new::<MockLoop<true>>(&many());
        for index in (0..of).rev() {
            merged.merge(part(Shard { index, of }));
        }
        assert_eq!(statistics(merged), whole, "{of} parts");
    }
}

#[test]
fn random_splits_of_the_records_merge_to_the_whole() {
    let campaign = many();
    let records = records(&campaign);
    let empty = || Tally::new::<MockLoop<true>>(&campaign);
    let mut whole = empty();
    whole.add(0, &records);
    let whole = whole.summary::<MockLoop<true>>(0.0);
    for split in 0..20 {
        let noise = Noise::<f64>::process(split, 0);
        let mut order: Vec<usize> = (0..500).collect();
        order.sort_by(|&a, &b| {
            noise
                .uniform(a as u64, 0)
                .total_cmp(&noise.uniform(b as u64, 0))
        });
        let mut parts: Vec<Tally> = (0..=split).map(|_| empty()).collect();
        for run in order {
            let part = (noise.uniform(run as u64, 1) * parts.len() as f64) as usize;
            parts[part].add(run as u64, &records[run..=run]);
        }
        while parts.len() > 1 {
            let last = parts.pop().expect("there are several");
            let into = (noise.uniform(500 + parts.len() as u64, 0) * parts.len() as f64) as usize;
            parts[into].merge(last);
        }
        let merged = parts.pop().expect("there is one");
        assert_eq!(
            merged.summary::<MockLoop<true>>(0.0),
            whole,
            "split {split}"
        );
    }
}

#[test]
fn what_is_done_is_not_done_again() {
    let (campaign, whole) = (many(), outcome(&many()));
    // Broken off by a failure after some blocks, as by a full disk, when somebody has looked.
    let (begun, looked) = (AtomicU64::new(0), AtomicBool::new(false));
    let kept = Mutex::new(None);
    let start = State::new::<MockLoop<true>>(&campaign);
    let alone = Campaign {
        threads: 1,
        ..many()
    };
    let broken = fly::<MockLoop<true>, _>(
        &alone,
        Shard::WHOLE,
        start,
        |_, _| {
            if begun.fetch_add(1, Ordering::Relaxed) < 40 {
                return Ok(());
            }
            while !looked.load(Ordering::Relaxed) {
                yield_now();
            }
            Err(())
        },
        |flight| {
            if begun.load(Ordering::Relaxed) > 40 {
                *kept.lock().unwrap() = Some(flight.snapshot());
                looked.store(true, Ordering::Relaxed);
            }
            Ok(())
        },
    );
    assert_eq!(broken, Err(()));
    let mut kept = kept.into_inner().unwrap().expect("it was looked at");
    assert!((1..500).contains(&kept.runs()), "{} runs", kept.runs());
    let bytes = kept.encode();
    let read =
        State::decode::<MockLoop<true>>(&campaign, Shard::WHOLE, &bytes).expect("as written");
    assert_eq!(read, kept);
    let done = AtomicU64::new(0);
    let all = fly::<MockLoop<true>, ()>(
        &campaign,
        Shard::WHOLE,
        read,
        |_, runs| {
            done.fetch_add(runs.records.len() as u64, Ordering::Relaxed);
            Ok(())
        },
        |_| Ok(()),
    );
    assert_eq!(done.into_inner(), 500 - kept.runs());
    let all = all.expect("nothing fails");
    assert_eq!(statistics(all.clone()), whole);
    assert_eq!(statistics(fly_on(&campaign, Shard::WHOLE, all)), whole);
}

#[test]
fn damaged_bytes_are_refused_or_change_the_state() {
    let mut state = part(Shard::WHOLE);
    let bytes = state.encode();
    let read = |bytes: &[u8]| State::decode::<MockLoop<true>>(&many(), Shard::WHOLE, bytes);
    for cut in (0..bytes.len()).step_by(4999) {
        assert!(read(&bytes[..cut]).is_err());
    }
    for place in (0..bytes.len()).step_by(4001) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x10;
        assert_ne!(read(&damaged), Ok(state.clone()), "byte {place}");
    }
}

/// What the fuzzer does with texts, for bytes that carry a checksum: whatever is read can be merged and told.
#[test]
fn damaged_bytes_that_are_read_do_no_harm() {
    let few = Campaign {
        runs: 20,
        horizon: 0.2,
        settle: 0.1,
        ..campaign()
    };
    let start = || State::new::<MockLoop<true>>(&few);
    let bytes = fly_on(&few, Shard::WHOLE, start()).encode();
    let noise = Noise::<f64>::process(11, 0);
    let draw =
        |trial, channel, count: usize| (noise.uniform(trial, channel) * count as f64) as usize;
    let mut read = 0;
    for trial in 0..5000 {
        let mut damaged = bytes.clone();
        for change in 0..=draw(trial, 0, 3) as u32 {
            // Half of the changes are in the counts at the head.
            let length = [64, damaged.len()][draw(trial, 4 * change + 1, 2)];
            let place = draw(trial, 4 * change + 2, length);
            damaged[place] = match draw(trial, 4 * change + 3, 4) {
                0 => damaged[place] ^ 0x80,
                1 => damaged[place].wrapping_add(1),
                2 => 0xff,
                _ => draw(trial, 4 * change + 4, 256) as u8,
            };
        }
        if let Ok(state) = State::decode::<MockLoop<true>>(&few, Shard::WHOLE, &damaged) {
            let mut merged = start();
            merged.merge(state.clone());
            merged.merge(state);
            let summary = statistics(merged);
            let band = summary.band.expect("it is kept");
            (0..band.rows()).for_each(|row| drop(band.row(row)));
            read += 1;
        }
    }
    assert!((100..4900).contains(&read), "{read} were read");
}

#[test]
fn memory_does_not_grow_with_the_runs() {
    let campaign = many();
    let records = records(&campaign);
    let mut state = State::new::<MockLoop<true>>(&campaign);
    let mut size_after = |runs: u64| {
        for run in state.runs()..runs {
            let place = run as usize % 500;
            state.tally.add(run, &records[place..=place]);
        }
        state.encode().len()
    };
    let (few, many) = (size_after(500), size_after(10_000));
    // The same bins; only the counts in them take more digits.
    assert!(many < 2 * few, "{few} bytes, then {many}");
    let bins = 101 * 4 * 256 + 4096;
    assert!(many < bins * 16, "{many} bytes");
}

#[test]
fn the_worst_runs_are_listed() {
    let worst = outcome(&campaign()).worst;
    let mut expected: Vec<(f64, u64)> = (0..60).map(|run| (largest_ratio(run, 0), run)).collect();
    expected.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let found: Vec<(f64, u64)> = worst.iter().map(|worst| (worst.ratio, worst.run)).collect();
    assert_eq!(found, expected[..10]);
    assert!(
        worst
            .iter()
            .all(|worst| worst.diverged == worst.ratio.is_infinite())
    );
}
