//! `nsv explain`: what a code means, with an example and its mend.

mod page;

use std::path::{Path, PathBuf};

use nsv_spec::diagnostic::Rule;
use nsv_spec::diagnostic::explain::Example;
use serde_json::{Value, json};

use super::failure::{Exit, Failure};
use super::{files, output};

/// Explain the code of a diagnostic, or list all codes
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Code such as E0403; all are listed without it
    #[arg(value_name = "CODE")]
    code: Option<String>,
    /// How to print it
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Print the whole specification of the example, broken or mended
    #[arg(long, value_enum, value_name = "SIDE", requires = "code")]
    example: Option<Side>,
    /// Write a page for each code into this folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["code", "format"])]
    pages: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// For people
    Text,
    /// One JSON document
    Json,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Side {
    /// As it breaks the rule
    Broken,
    /// As it should be
    Mended,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if let Some(directory) = &args.pages {
        return write_pages(directory);
    }
    let Some(code) = &args.code else {
        return list(args.format);
    };
    let rule = Rule::find(code).ok_or_else(|| unknown(code))?;
    let example = &rule.explanation().example;
    if args.example.is_some() && args.format == Format::Json {
        let failure = Failure::new(
            Exit::Usage,
            "`--example` prints a specification, which is no JSON",
        );
        return Err(
            failure.with_help("`--format json` without `--example` has both sides of the example")
        );
    }
    match args.example {
        Some(Side::Broken) => output::data(&String::from_utf8_lossy(
            &example.broken().unwrap_or_default(),
        )),
        Some(Side::Mended) => output::data(&example.mended()),
        None => match args.format {
            Format::Text => output::data(&page::text(rule)?),
            Format::Json => output::json(&document(rule)),
        },
    }
}

fn unknown(code: &str) -> Failure {
    let failure = Failure::new(Exit::Usage, format_args!("no code `{code}`"));
    match Rule::nearest(code) {
        Some(rule) => failure.with_help(format_args!("did you mean `{rule}`?")),
        None => failure.with_help("`nsv explain` lists all codes"),
    }
}

fn list(format: Format) -> Result<(), Failure> {
    match format {
        Format::Json => {
            let all: Vec<Value> = Rule::ALL.iter().map(|rule| document(*rule)).collect();
            output::json(&json!({ "codes": all }))
        }
        Format::Text => {
            let lines = Rule::ALL
                .iter()
                .map(|rule| format!("{rule}  {}\n", rule.title()));
            output::data(&lines.collect::<String>())
        }
    }
}

fn document(rule: Rule) -> Value {
    let explanation = rule.explanation();
    let Example { files, .. } = explanation.example;
    let files = |side: fn(&(&'static str, &'static str, &'static str)) -> &'static str| -> Value {
        files
            .iter()
            .map(|file| (file.0.to_owned(), json!(side(file))))
            .collect::<serde_json::Map<_, _>>()
            .into()
    };
    json!({
        "code": rule.name(),
        "severity": rule.severity().to_string(),
        "title": rule.title(),
        "explanation": explanation.why,
        "broken": explanation.example.broken().map(|text| String::from_utf8_lossy(&text).into_owned()),
        "broken_files": files(|file| file.1),
        "mended": explanation.example.mended(),
        "mended_files": files(|file| file.2),
    })
}

fn write_pages(directory: &Path) -> Result<(), Failure> {
    let pages = page::all()?;
    let texts: Vec<(PathBuf, &str)> = pages
        .iter()
        .map(|(name, text)| (directory.join(name), text.as_str()))
        .collect();
    files::replace(&texts, &[])
}
