//! `--set`: values that take the place of what a specification says.

use nsv_spec::compose::split;

/// Values set on the command line.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct Settings {
    /// Set a value of the specification, such as `controller.blocks.speed.K=2`; `~` takes the key away, `@FILE` gives it the value
    /// that it has in another specification
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = setting)]
    pub values: Vec<String>,
}

fn setting(text: &str) -> Result<String, String> {
    match split(text) {
        Some(_) => Ok(text.to_owned()),
        None => Err("expected PATH=VALUE, such as `controller.sample_time=1 ms`".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_has_a_path_and_a_value() {
        assert!(setting("a.b=c=d").is_ok() && setting("a=~").is_ok());
        for text in ["a", "a=", "=1", "a= "] {
            assert!(setting(text).is_err(), "{text}");
        }
    }
}
