//! What a runner is asked to do, and how that is said in arguments.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::build::Program;

/// What to simulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Campaign {
    /// Seed of all noise and dispersion.
    pub seed: u64,
    /// Number of the first run.
    pub first_run: u64,
    /// Number of runs.
    pub runs: u64,
    /// Length of a run, s.
    pub horizon_s: f64,
    /// Start of the rms window, s.
    pub settle_s: f64,
    /// Worker threads; 0 for one per core.
    pub threads: usize,
    /// Whether noise acts.
    pub noise: bool,
    /// Whether parameters, initial states and biases of sensors are drawn for each run.
    pub dispersion: bool,
}

/// A part of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Part {
    /// Which part, from 1.
    pub part: u64,
    /// Number of parts.
    pub of: u64,
}

impl Part {
    /// Reads `K/N`.
    pub(crate) fn parse(text: &str) -> Option<Part> {
        let (part, of) = text.split_once('/')?;
        let (part, of) = (part.parse().ok()?, of.parse().ok()?);
        (1..=of).contains(&part).then_some(Part { part, of })
    }
}

/// How the runs come about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Work<'a> {
    /// They are simulated.
    Fly {
        /// All of them, or a part.
        part: Option<Part>,
        /// File of the state, to go on from and to keep.
        checkpoint: Option<&'a Path>,
    },
    /// They were simulated in parts, whose states are in these files.
    Merge(&'a [PathBuf]),
}

/// What to record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Recordings<'a> {
    /// The run whose signals are recorded.
    pub trajectory_run: Option<u64>,
    /// Whether statistics over the runs are recorded.
    pub band: bool,
    /// Whether the state keeps what `band` needs.
    pub keep_band: bool,
    /// File for a row of each run.
    pub run_table: Option<&'a Path>,
}

/// A runner and what it is to do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Job<'a> {
    /// The program.
    pub program: &'a Program,
    /// Where its specification is.
    pub specification: &'a Path,
    /// The campaign.
    pub campaign: &'a Campaign,
    /// Its runs.
    pub work: Work<'a>,
    /// Files to write.
    pub recordings: Recordings<'a>,
}

impl Job<'_> {
    /// The runner's arguments, but for those of its scratch files.
    pub(super) fn arguments(&self) -> Vec<OsString> {
        let campaign = arguments(self.campaign).into_iter().map(OsString::from);
        campaign.chain(state(self)).collect()
    }
}

fn arguments(campaign: &Campaign) -> Vec<String> {
    let Campaign {
        seed,
        first_run,
        runs,
        horizon_s,
        settle_s,
        threads,
        noise,
        dispersion,
    } = *campaign;
    let threads = match threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    let pairs = [
        ("--seed", seed.to_string()),
        ("--runs", runs.to_string()),
        ("--first-run", first_run.to_string()),
        ("--horizon", format!("{horizon_s:?}")),
        ("--settle", format!("{settle_s:?}")),
        ("--threads", threads.to_string()),
    ];
    let switches = [("--no-noise", !noise), ("--no-dispersion", !dispersion)];
    let switches = switches
        .into_iter()
        .filter(|(_, given)| *given)
        .map(|(name, _)| name.to_owned());
    pairs
        .into_iter()
        .flat_map(|(name, value)| [name.to_owned(), value])
        .chain(switches)
        .collect()
}

/// The arguments that say where states are read from and kept, and what they are of.
fn state(job: &Job<'_>) -> Vec<OsString> {
    let mut arguments: Vec<OsString> = Vec::new();
    let mut add = |name: &str, value: &OsStr| arguments.extend([name.into(), value.to_owned()]);
    match job.work {
        Work::Fly { part, checkpoint } => {
            if let Some(Part { part, of }) = part {
                add("--shard", OsStr::new(&format!("{part}/{of}")));
            }
            if let Some(path) = checkpoint {
                add("--checkpoint", path.as_os_str());
            }
        }
        Work::Merge(files) => {
            for path in files {
                add("--merge", path.as_os_str());
            }
        }
    }
    if let Some(path) = job.recordings.run_table {
        add("--run-table", path.as_os_str());
    }
    add("--key", OsStr::new(&job.program.key));
    let specification = std::path::absolute(job.specification);
    let specification = specification.as_deref().unwrap_or(job.specification);
    add("--specification", specification.as_os_str());
    if job.recordings.keep_band {
        arguments.push("--keep-band".into());
    }
    arguments
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(in super::super) const CAMPAIGN: Campaign = Campaign {
        seed: 7,
        first_run: 3,
        runs: 2,
        horizon_s: 20.0,
        settle_s: 4.5,
        threads: 2,
        noise: false,
        dispersion: true,
    };

    #[test]
    fn arguments_are_those_of_the_protocol() {
        let arguments = arguments(&CAMPAIGN).join(" ");
        assert_eq!(
            arguments,
            "--seed 7 --runs 2 --first-run 3 --horizon 20.0 --settle 4.5 --threads 2 --no-noise"
        );
    }

    #[test]
    fn states_have_arguments_of_their_own() {
        let program = Program {
            path: "/simulator".into(),
            key: "k".into(),
        };
        let of = |work, run_table| {
            let job = Job {
                program: &program,
                specification: Path::new("/spec.yaml"),
                campaign: &CAMPAIGN,
                work,
                recordings: Recordings {
                    run_table,
                    keep_band: true,
                    ..Recordings::default()
                },
            };
            state(&job).join(OsStr::new(" ")).into_string().unwrap()
        };
        let end = "--key k --specification /spec.yaml --keep-band";
        let flown = Work::Fly {
            part: Part::parse("2/3"),
            checkpoint: Some(Path::new("c")),
        };
        assert_eq!(
            of(flown, Some(Path::new("r"))),
            format!("--shard 2/3 --checkpoint c --run-table r {end}")
        );
        let parts = ["a".into(), "b".into()];
        assert_eq!(
            of(Work::Merge(&parts), None),
            format!("--merge a --merge b {end}")
        );
    }

    #[test]
    fn parts_are_counted_from_one() {
        assert_eq!(Part::parse("3/3"), Some(Part { part: 3, of: 3 }));
        for wrong in ["0/3", "4/3", "1", "1/0", "a/b", "1/2/3", "-1/2"] {
            assert_eq!(Part::parse(wrong), None, "{wrong}");
        }
    }
}
