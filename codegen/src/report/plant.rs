//! What the report needs to know of a model: names and display units.

use nsv_spec::model::{Disturbance, Model};

/// Names and units of a control problem.
#[derive(Clone, Debug)]
pub(crate) struct Plant {
    /// Identifier.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// SHA-256 of the sources, hex.
    pub hash: String,
    /// Blocks, the output first.
    pub blocks: Vec<Block>,
    /// Further states of the flown plant.
    pub further: Vec<Channel>,
    /// Control inputs.
    pub inputs: Vec<Input>,
}

/// One block of the chain.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    /// Identifier.
    pub name: String,
    /// State channels.
    pub channels: Vec<Channel>,
    /// Whether the disturbance comes from an exosystem.
    pub exosystem: bool,
}

/// A signal with the unit it is shown in.
#[derive(Clone, Debug)]
pub(crate) struct Channel {
    /// Identifier.
    pub name: String,
    /// Display unit, as written in the specification.
    pub unit: String,
    /// Factor from the display unit to SI.
    pub factor: f64,
}

/// A control input.
#[derive(Clone, Debug)]
pub(crate) struct Input {
    /// Name and unit.
    pub channel: Channel,
    /// Largest magnitude, SI.
    pub limit: f64,
}

impl From<&Model> for Plant {
    fn from(model: &Model) -> Plant {
        let channel = |name: &String, (unit, factor): &(String, f64)| Channel {
            name: name.clone(),
            unit: unit.clone(),
            factor: *factor,
        };
        let blocks = model.blocks.iter().map(|block| Block {
            name: block.name.clone(),
            channels: block
                .states
                .iter()
                .map(|state| channel(&state.name, &state.display))
                .collect(),
            exosystem: matches!(block.disturbance, Disturbance::Exosystem(_)),
        });
        let inputs = model.inputs.iter();
        let further = model.truth.iter().flat_map(|truth| &truth.states);
        Plant {
            name: model.name.clone(),
            title: model.title.clone(),
            hash: model.hash.clone(),
            blocks: blocks.collect(),
            further: further
                .map(|state| channel(&state.name, &state.display))
                .collect(),
            inputs: inputs
                .map(|input| Input {
                    channel: channel(&input.name, &input.display),
                    limit: input.limit,
                })
                .collect(),
        }
    }
}

impl Channel {
    /// The channel's time derivative: `deg` becomes `deg/s`, `deg/s` becomes `deg/s^2`.
    pub(crate) fn rate(&self) -> Channel {
        let unit = match self.unit.rsplit_once("/s") {
            _ if self.unit.is_empty() || self.unit == "1" => "1/s".to_owned(),
            Some((stem, "")) => format!("{stem}/s^2"),
            Some((stem, power)) => match power
                .strip_prefix('^')
                .and_then(|digits| digits.parse::<u32>().ok())
            {
                Some(n) => format!("{stem}/s^{}", n + 1),
                None => format!("({})/s", self.unit),
            },
            None => format!("{}/s", self.unit),
        };
        Channel {
            name: self.name.clone(),
            unit,
            factor: self.factor,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_have_one_more_per_second() {
        for (unit, rate) in [
            ("deg", "deg/s"),
            ("deg/s", "deg/s^2"),
            ("m/s^2", "m/s^3"),
            ("", "1/s"),
            ("m/sr", "(m/sr)/s"),
        ] {
            let channel = Channel {
                name: "x".into(),
                unit: unit.into(),
                factor: 1.0,
            };
            assert_eq!(channel.rate().unit, rate);
        }
    }
}
