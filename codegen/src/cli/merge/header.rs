//! Which campaign, and which part of it, a checkpoint is of.

use std::fs::File;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};

use crate::cli::failure::{Exit, Failure};
use crate::cli::runner::{Campaign, Part};

/// First line of a checkpoint in the format that this program knows.
const MAGIC: &str = "nsv campaign state 2";

/// More bytes than any header has.
const LONGEST: u64 = 1 << 16;

/// What the lines at the head of a checkpoint say.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Header {
    /// The file.
    pub path: PathBuf,
    /// Where the specification was.
    pub specification: PathBuf,
    /// Key of the simulator.
    pub simulator: String,
    /// The campaign, of which this is a part.
    pub campaign: Campaign,
    /// Whether it keeps the signals' spread over time.
    pub band: bool,
    /// The part.
    pub part: Part,
    /// What all parts of a campaign have in common, by name.
    common: Vec<(String, String)>,
}

/// Fields in which the parts of a campaign may differ.
const OWN: [&str; 3] = ["specification", "run_table", "shard"];

impl Header {
    /// Reads the head of a file.
    pub(super) fn read(path: &Path) -> Result<Header, Failure> {
        let file = File::open(path).map_err(|error| Failure::io("read", path, &error))?;
        let mut lines = BufReader::new(file.take(LONGEST)).lines();
        // What is no text is no header.
        let mut next = move || lines.next().and_then(Result::ok).unwrap_or_default();
        if next() != MAGIC {
            return Err(refusal(path, "is not a checkpoint that this nsv reads"));
        }
        let lines = std::iter::from_fn(|| Some(next()).filter(|line| !line.is_empty()));
        let fields = lines.filter_map(|line| {
            let (name, value) = line.split_once(' ')?;
            Some((name.to_owned(), value.to_owned()))
        });
        Header::of(path, &fields.collect::<Vec<_>>())
            .ok_or_else(|| refusal(path, "has a damaged header"))
    }

    fn of(path: &Path, fields: &[(String, String)]) -> Option<Header> {
        let field = |name: &str| {
            let (_, value) = fields.iter().find(|(other, _)| other == name)?;
            Some(value.as_str())
        };
        let specification: String = serde_json::from_str(field("specification")?).ok()?;
        let campaign = Campaign {
            seed: field("seed")?.parse().ok()?,
            first_run: field("first_run")?.parse().ok()?,
            runs: field("runs")?.parse().ok()?,
            horizon_s: field("horizon")?.parse().ok()?,
            settle_s: field("settle")?.parse().ok()?,
            threads: 0,
            noise: field("noise")?.parse().ok()?,
            dispersion: field("dispersion")?.parse().ok()?,
        };
        let common = fields.iter().filter(|(name, _)| !OWN.contains(&&**name));
        Some(Header {
            path: path.to_owned(),
            specification: specification.into(),
            simulator: field("simulator")?.to_owned(),
            campaign,
            band: field("band")?.parse().ok()?,
            part: Part::parse(field("shard")?)?,
            common: common.cloned().collect(),
        })
    }
}

/// The headers must be those of all parts of one campaign, each once.
pub(super) fn expect_whole(headers: &[Header]) -> Result<(), Failure> {
    let Some((first, others)) = headers.split_first() else {
        return Ok(());
    };
    for other in others {
        let pairs = other.common.iter().zip(&first.common);
        let differences = pairs.filter(|(found, expected)| found != expected);
        let differences: Vec<String> = differences
            .map(|((name, found), (_, expected))| format!("{name} is {found}, not {expected}"))
            .collect();
        if !differences.is_empty() || other.common.len() != first.common.len() {
            let what = format!(
                "is of another campaign than `{}`: {}",
                first.path.display(),
                differences.join(", ")
            );
            return Err(refusal(&other.path, &what));
        }
        if other.part.of != first.part.of {
            let what = format!(
                "is one of {} parts, `{}` one of {}",
                other.part.of,
                first.path.display(),
                first.part.of
            );
            return Err(refusal(&other.path, &what));
        }
    }
    expect_once_each(headers, first.part.of)
}

fn expect_once_each(headers: &[Header], of: u64) -> Result<(), Failure> {
    let mut by_part: Vec<&Header> = headers.iter().collect();
    by_part.sort_by_key(|header| header.part.part);
    if let Some(pair) = by_part.windows(2).find(|pair| pair[0].part == pair[1].part) {
        let what = format!(
            "and `{}` are both part {} of {of}",
            pair[1].path.display(),
            pair[1].part.part
        );
        return Err(refusal(&pair[0].path, &what));
    }
    let there = |part: &u64| by_part.iter().any(|header| header.part.part == *part);
    let mut missing = (1..=of).filter(|part| !there(part));
    let named: Vec<String> = missing.by_ref().take(10).map(|k| k.to_string()).collect();
    match (&named[..], missing.next()) {
        ([], _) => Ok(()),
        ([part], _) => Err(Failure::new(
            Exit::Usage,
            format_args!("part {part} of {of} is missing"),
        )),
        (_, more) => Err(Failure::new(
            Exit::Usage,
            format_args!(
                "parts {}{} of {of} are missing",
                named.join(", "),
                if more.is_some() { " and more" } else { "" }
            ),
        )),
    }
}

fn refusal(path: &Path, what: &str) -> Failure {
    Failure::new(Exit::Usage, format_args!("`{}` {what}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The header of a file with that text.
    fn header(folder: &Path, name: &str, part: &str, seed: u64) -> Header {
        let path = folder.join(name);
        let text = format!(
            "{MAGIC}\nspecification \"/a b.yaml\"\nname pendulum\nsimulator 12ab\nseed {seed}\nfirst_run 0\nruns 900\n\
             horizon 20.0\nsettle 0.5\nnoise true\ndispersion false\nband true\nrun_table {}\nshard {part}\n\nbytes",
            seed == 1
        );
        std::fs::write(&path, text).unwrap();
        Header::read(&path).unwrap()
    }

    fn message(outcome: Result<(), Failure>) -> String {
        match outcome {
            Err(Failure::Message {
                exit: Exit::Usage,
                message,
                ..
            }) => message,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_head_says_which_campaign_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let header = header(folder.path(), "a", "2/3", 7);
        assert_eq!(header.specification, Path::new("/a b.yaml"));
        assert_eq!(
            (header.part.part, header.part.of, header.band),
            (2, 3, true)
        );
        let campaign = header.campaign;
        assert_eq!((campaign.seed, campaign.runs), (7, 900));
        assert!(campaign.noise && !campaign.dispersion);
        for (text, said) in [
            ("", "is not a checkpoint"),
            ("nsv campaign state 1\n", "is not a checkpoint"),
            ("nsv campaign state 2\nseed 1\n\n", "has a damaged header"),
        ] {
            let path = folder.path().join("wrong");
            std::fs::write(&path, text).unwrap();
            assert!(message(Header::read(&path).map(drop)).contains(said));
        }
    }

    #[test]
    fn every_part_is_needed_once() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let of = |name, part| header(folder, name, part, 1);
        let whole = |headers: &[Header]| expect_whole(headers);
        assert!(whole(&[of("a", "2/2"), of("b", "1/2")]).is_ok());
        assert!(whole(&[of("a", "1/1")]).is_ok());
        assert_eq!(
            message(whole(&[of("a", "1/3"), of("b", "3/3")])),
            "part 2 of 3 is missing"
        );
        assert_eq!(
            message(whole(&[of("a", "2/14")])),
            "parts 1, 3, 4, 5, 6, 7, 8, 9, 10, 11 and more of 14 are missing"
        );
        let twice = message(whole(&[of("a", "1/2"), of("b", "2/2"), of("c", "1/2")]));
        assert!(
            twice.contains("/a` and `") && twice.ends_with("/c` are both part 1 of 2"),
            "{twice}"
        );
        assert!(message(whole(&[of("a", "1/2"), of("b", "2/3")])).contains("is one of 3 parts, `"));
        let mixed = message(whole(&[of("a", "1/2"), header(folder, "b", "2/2", 5)]));
        assert!(mixed.ends_with("/a`: seed is 5, not 1"), "{mixed}");
    }
}
