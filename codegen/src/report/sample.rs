//! A made-up simulation for the tests of the report: two blocks of two channels, every kind of signal.

use super::plant::{Block, Channel, Input, Plant};
use super::{Outcome, Quantiles, Report, Table, WorstRun};

pub(crate) struct Sample {
    pub(crate) plant: Plant,
    pub(crate) outcome: Outcome,
    pub(crate) trajectory: Table,
    pub(crate) band: Option<Table>,
}

const DEG: f64 = std::f64::consts::PI / 180.0;

impl Sample {
    /// Disturbances, constraints and a campaign.
    pub(crate) fn full() -> Sample {
        let t: Vec<f64> = (0..=10_000).map(|i| f64::from(i) * 2e-3).collect();
        let over = |f: &dyn Fn(f64) -> f64| t.iter().map(|&t| f(t)).collect::<Vec<f64>>();
        let jitter = |t: f64| (977.0 * t).sin() * (613.0 * t).cos();
        let mut columns = vec![("t".to_owned(), t.clone())];
        for (i, channel) in ["alpha", "beta"].into_iter().enumerate() {
            let phase = i as f64;
            let error = move |t: f64| {
                DEG * (1.3 * (-2.0 * t).exp() * (3.0 * t + phase).cos() + 0.03 * jitter(t))
            };
            let reference = move |t: f64| DEG * 3.0 * (0.7 * t + phase).sin();
            let d = move |t: f64| 0.02 * (2.0 * t + phase).sin() * (-0.1 * t).exp();
            columns.push((format!("x1.{channel}"), over(&|t| reference(t) + error(t))));
            columns.push((format!("y_r.{channel}"), over(&reference)));
            columns.push((format!("error.{channel}"), over(&error)));
            columns.push((format!("d1.{channel}"), over(&d)));
            columns.push((
                format!("D_hat1.{channel}"),
                over(&|t| d(t) * (1.0 - (-5.0 * t).exp()) + 2e-4 * jitter(t)),
            ));
        }
        for (i, channel) in ["p", "q"].into_iter().enumerate() {
            let d = move |t: f64| 0.3 * (3.0 * t + i as f64).sin();
            columns.push((format!("d2.{channel}"), over(&d)));
            columns.push((
                format!("D_hat2.{channel}"),
                over(&|t| d(t - 0.1) * (1.0 - (-2.0 * t).exp())),
            ));
        }
        columns.push(("k1".into(), over(&|t| DEG * (3.0 * (-t).exp() + 0.5))));
        columns.push((
            "u_sat.M_x".into(),
            over(&|t| (4e6 * (-t).exp() * (9.0 * t).cos()).clamp(-2e6, 2e6) + 3e4 * jitter(t)),
        ));
        columns.push(("u_sat.M_y".into(), over(&|t| 9e6 * (0.7 * t).sin())));
        columns.push(("V".into(), over(&|t| 1e-2 * (-1.5 * t).exp() + 1e-7)));
        columns.push((
            "LV".into(),
            over(&|t| -1.5e-2 * (-1.5 * t).exp() + 1e-4 * jitter(t)),
        ));
        Sample {
            plant: plant(),
            outcome: outcome(),
            trajectory: Table::new(columns),
            band: Some(band()),
        }
    }

    /// One run without disturbance, constraint or Lyapunov function.
    pub(crate) fn plain() -> Sample {
        let full = Sample::full();
        let kept = full.trajectory.columns().iter().filter(|(name, _)| {
            ["t", "x1.", "y_r.", "u_sat."]
                .iter()
                .any(|p| name.starts_with(p))
        });
        let outcome = Outcome {
            runs: 1,
            violations: None,
            violated: None,
            violated_interval95: None,
            ratio: None,
            settled_ratio: None,
            worst: Vec::new(),
            ..full.outcome
        };
        Sample {
            trajectory: Table::new(kept.cloned().collect()),
            outcome,
            band: None,
            plant: full.plant,
        }
    }

    pub(crate) fn report(&self) -> Report<'_> {
        Report {
            plant: &self.plant,
            command: "nsv simulate specs/sample.yaml --runs 500 --report \"a & b.html\"",
            seed: 1,
            horizon_s: 20.0,
            settle_s: 4.5,
            trajectory_run: 0,
            outcome: &self.outcome,
            trajectory: &self.trajectory,
            band: self.band.as_ref(),
        }
    }
}

fn plant() -> Plant {
    let channel = |name: &str, unit: &str, factor: f64| Channel {
        name: name.into(),
        unit: unit.into(),
        factor,
    };
    let attitude = vec![channel("alpha", "deg", DEG), channel("beta", "deg", DEG)];
    let rates = vec![channel("p", "deg/s", DEG), channel("q", "deg/s", DEG)];
    Plant {
        further: Vec::new(),
        name: "sample".into(),
        title: "Attitude & rates of a sample vehicle".into(),
        hash: "0123456789abcdef".repeat(4),
        blocks: vec![
            Block {
                name: "attitude".into(),
                channels: attitude,
                exosystem: false,
            },
            Block {
                name: "rates".into(),
                channels: rates,
                exosystem: true,
            },
        ],
        inputs: vec![
            Input {
                channel: channel("M_x", "kN*m", 1e3),
                limit: 2e6,
            },
            Input {
                channel: channel("M_y", "kN*m", 1e3),
                limit: 2e7,
            },
        ],
    }
}

fn outcome() -> Outcome {
    Outcome {
        runs: 500,
        samples: 5_000_000,
        violations: Some(16),
        violated: Some(0.032),
        violated_interval95: Some([0.0184, 0.0514]),
        ratio: Some(Quantiles {
            median: Some(0.4771),
            p90: Some(0.52),
            p99: Some(1.31),
            max: Some(2.04),
            accuracy: Some(0.0),
        }),
        settled_ratio: Some(Quantiles {
            median: Some(0.21),
            p90: Some(0.26),
            p99: Some(0.4),
            max: Some(0.71),
            accuracy: Some(0.0),
        }),
        worst: [(77, Some(2.04)), (12, Some(1.9)), (401, Some(1.31))]
            .map(|(run, ratio)| WorstRun {
                run,
                ratio,
                diverged: false,
            })
            .into(),
        rms_tracking: [
            ("alpha".into(), Some(0.04 * DEG)),
            ("beta".into(), Some(0.025 * DEG)),
        ]
        .into(),
        saturated_fraction: [("M_x".into(), Some(0.0125)), ("M_y".into(), Some(0.0))].into(),
        nonfinite: 0,
        wall_s: 1.25,
        steps_per_s: 4e6,
    }
}

fn band() -> Table {
    let t: Vec<f64> = (0..=1000).map(|i| f64::from(i) * 0.02).collect();
    let mut columns = vec![("t".to_owned(), t.clone())];
    let mut add = |name: &str, middle: &dyn Fn(f64) -> f64, width: &dyn Fn(f64) -> f64| {
        for (statistic, scale) in [
            ("min", -2.0),
            ("p05", -1.0),
            ("p50", 0.0),
            ("p95", 1.0),
            ("max", 2.0),
            ("mean", 0.0),
        ] {
            columns.push((
                format!("{name}:{statistic}"),
                t.iter().map(|&t| middle(t) + scale * width(t)).collect(),
            ));
        }
    };
    add("ratio1", &|t| 0.4 * (-t).exp() + 0.1, &|t| 0.02 + 0.004 * t);
    for (i, channel) in ["alpha", "beta"].into_iter().enumerate() {
        let phase = i as f64;
        add(
            &format!("error.{channel}"),
            &move |t| DEG * 1.3 * (-2.0 * t).exp() * (3.0 * t + phase).cos(),
            &|t| DEG * (0.03 + 0.002 * t),
        );
    }
    for channel in ["p", "q"] {
        add(&format!("d2.{channel}"), &|_| 0.0, &|t| 0.05 * t.sqrt());
    }
    add(
        "u_sat.M_x",
        &|t| 2e6 * (-t).exp() * (9.0 * t).cos(),
        &|_| 1e5,
    );
    Table::new(columns)
}
