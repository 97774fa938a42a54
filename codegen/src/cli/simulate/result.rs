//! What is made of a campaign that was flown, at once or in parts.

use std::path::Path;

use super::{origin, summary, trajectory};
use crate::cli::compile::Math;
use crate::cli::failure::Failure;
use crate::cli::runner::{Campaign, Part, Replay};
use crate::cli::{files, output};
use crate::report::{Plant, Report, page};

/// How statistics are written.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// A table
    Human,
    /// One JSON document
    Json,
}

/// A campaign and what came of it.
#[derive(Clone, Copy)]
pub(crate) struct Flown<'a> {
    /// The specification's file.
    pub specification: &'a Path,
    /// Values that were set in it.
    pub settings: &'a [String],
    /// Names and units.
    pub plant: &'a Plant,
    /// What was simulated.
    pub campaign: &'a Campaign,
    /// The part of it that was, if not all.
    pub part: Option<Part>,
    /// The arithmetic of the code.
    pub math: Math,
    /// The run whose signals were recorded.
    pub shown: u64,
    /// Statistics and recordings.
    pub replay: &'a Replay,
}

/// Files to write.
#[derive(Clone, Copy)]
pub(crate) struct Files<'a> {
    /// Signals of one run.
    pub out: Option<&'a Path>,
    /// Report.
    pub report: Option<&'a Path>,
}

impl Flown<'_> {
    /// Writes the files that were asked for.
    pub(crate) fn write(&self, to: Files<'_>) -> Result<(), Failure> {
        let Some(trajectory) = &self.replay.trajectory else {
            return Ok(());
        };
        if let Some(path) = to.out {
            let mut origin = origin(self.plant, self.campaign).to_vec();
            origin.push(("nsv.run", self.shown.to_string()));
            trajectory::write(path, trajectory, &origin)?;
        }
        if let Some(path) = to.report {
            let words = std::env::args_os().skip(1);
            let text = page(&Report {
                plant: self.plant,
                command: &command(words.map(|word| word.to_string_lossy().into_owned())),
                seed: self.campaign.seed,
                horizon_s: self.campaign.horizon_s,
                settle_s: self.campaign.settle_s,
                trajectory_run: self.shown,
                outcome: &self.replay.outcome,
                trajectory,
                band: self.replay.band.as_ref(),
            });
            files::replace(&[(path.to_owned(), &text)], &[])?;
        }
        Ok(())
    }

    /// Writes the statistics to standard output.
    pub(crate) fn tell(&self, format: Format) -> Result<(), Failure> {
        match format {
            Format::Human => output::data(&summary::table(self)),
            Format::Json => output::json(&summary::document(self)),
        }
    }

    /// The command that flies a run of the campaign again.
    pub(super) fn replay_command(&self, run: u64) -> String {
        let campaign = self.campaign;
        let mut words = vec![
            "simulate".to_owned(),
            self.specification.to_string_lossy().into_owned(),
        ];
        for setting in self.settings {
            words.extend(["--set".to_owned(), setting.clone()]);
        }
        words.extend(["--seed".to_owned(), campaign.seed.to_string()]);
        words.extend(["--horizon".to_owned(), format!("{}", campaign.horizon_s)]);
        let switches = [
            ("--no-noise", campaign.noise),
            ("--no-dispersion", campaign.dispersion),
        ];
        let given = switches.iter().filter(|(_, on)| !on);
        words.extend(given.map(|(name, _)| (*name).to_owned()));
        if self.math == Math::Fast {
            words.extend(["--math".to_owned(), "fast".to_owned()]);
        }
        words.extend(["--run".to_owned(), run.to_string()]);
        command(words.into_iter())
    }
}

/// The command as it would be typed into a shell.
fn command(words: impl Iterator<Item = String>) -> String {
    let plain = |word: &str| {
        !word.is_empty()
            && word
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || "-_./=+:,@%".contains(c))
    };
    let quoted = words.map(|word| {
        if plain(&word) {
            word
        } else {
            format!("'{}'", word.replace('\'', r"'\''"))
        }
    });
    std::iter::once("nsv".to_owned())
        .chain(quoted)
        .collect::<Vec<_>>()
        .join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_can_be_pasted() {
        let words = ["simulate", "a b.yaml", "--report", "it's.html", ""].map(str::to_owned);
        assert_eq!(
            command(words.into_iter()),
            r"nsv simulate 'a b.yaml' --report 'it'\''s.html' ''"
        );
    }
}
