//! `nsv new`: a specification to start from.

use std::path::PathBuf;

use nsv_codegen::whole;
use nsv_spec::load_str;

use super::compile::show;
use super::failure::{Exit, Failure};
use super::output::note;

/// The name that stands in the templates.
const PLACE: &str = "\nname: template\n";

/// Write a specification to start from, which checks clean
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Name of the specification and of its module: a word in snake case. The file is NAME.yaml
    #[arg(value_name = "NAME")]
    name: String,
    /// What it describes
    #[arg(long, value_enum, default_value_t)]
    template: Template,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Template {
    /// An arm in the wind: two blocks of width 1, with a constraint, an observer and a network
    #[default]
    Arm,
    /// A mass on a spring with a motor: three blocks of width 1
    Chain,
    /// A rigid body: two blocks of width 3
    Attitude,
}

impl Template {
    fn text(self) -> &'static str {
        match self {
            Template::Arm => include_str!("arm.yaml"),
            Template::Chain => include_str!("chain.yaml"),
            Template::Attitude => include_str!("attitude.yaml"),
        }
    }

    /// The specification of that name.
    fn named(self, name: &str) -> String {
        self.text().replacen(PLACE, &format!("\nname: {name}\n"), 1)
    }
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if args.name.is_empty() || !args.name.chars().all(plain) {
        let message = format!("`{}` is not a word in snake case", args.name.escape_debug());
        return Err(Failure::new(Exit::Usage, message)
            .with_help("use lower-case letters, digits and `_`, such as `my_robot`"));
    }
    let path = PathBuf::from(format!("{}.yaml", args.name));
    let text = args.template.named(&args.name);
    // A word may be none that a module can have.
    if let Err(faults) = load_str(&path.display().to_string(), &text) {
        show(&faults);
        return Err(Failure::Reported(Exit::Usage));
    }
    whole::create(&path, text.as_bytes()).map_err(|error| match error.kind() {
        std::io::ErrorKind::AlreadyExists => {
            let message = format!("`{}` is there already", path.display());
            Failure::new(Exit::Usage, message).with_help("choose another name")
        }
        _ => Failure::io("write", &path, &error),
    })?;
    note(format_args!(
        "wrote `{0}`: `nsv check {0}`, then `nsv simulate {0} --report report.html`, which takes derivatives with CasADi \
         (needs Python, and about 110 MB from PyPI the first time)",
        path.display()
    ));
    Ok(())
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;
    use nsv_spec::yaml::format;

    use super::*;

    #[test]
    fn every_template_checks_clean_and_is_laid_out_as_fmt_does() {
        for template in Template::value_variants() {
            let text = template.named("my_plant");
            let (model, warnings) = load_str("my_plant.yaml", &text)
                .unwrap_or_else(|faults| panic!("{template:?}: {}", faults.short()));
            assert_eq!((model.name.as_str(), warnings.len()), ("my_plant", 0));
            assert_eq!(format(&text).expect("YAML"), text, "{template:?}");
        }
    }
}
