//! What editors show of a key beside its meaning: its unit, what holds where it is not given, and an example.

/// Section, key, unit of the value or nothing, default or nothing, and an example in YAML or nothing where the value is a section.
type Row = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
);

/// What is known of one key.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Details {
    /// Unit of the value, in words.
    pub(crate) unit: &'static str,
    /// What holds if the key is not given; a test proves that the checks agree.
    pub(crate) default: &'static str,
    /// An example in YAML.
    pub(crate) example: &'static str,
}

/// The details of a key of the section with that noun.
pub(crate) fn details(noun: &str, key: &str) -> Details {
    let found = ROWS.iter().find(|row| row.0 == noun && row.1 == key);
    found.map_or_else(Details::default, |&(_, _, unit, default, example)| {
        Details {
            unit,
            default,
            example,
        }
    })
}

#[rustfmt::skip]
pub(crate) const ROWS: &[Row] = &[
    ("a specification", "nsv", "", "", "1"),
    ("a specification", "name", "", "", "arm"),
    ("a specification", "title", "", "", "Single-link arm in a gusty wind"),
    ("a specification", "include", "", "", "[models/plant.yaml, {file: models/motor.yaml, with: {inertia: 0.02 kg*m^2}}]"),
    ("a specification", "extends", "", "", "base.yaml"),
    ("a specification", "constants", "", "", "{length: 0.5 m, gravity: {value: 9.81, unit: m/s^2}}"),
    ("a specification", "parameters", "", "", "{mass: {value: 1 kg, dispersion: {uniform: [0.8 kg, 1.2 kg]}}}"),
    ("a specification", "correlations", "", "", "[{parameters: [a, b], covariance: [[1, 0.5], [0.5, 1]]}]"),
    ("a specification", "polynomials", "", "", "{drag: {arguments: [speed], parts: {cubic: [[0.01, 3], [0.02, 1]]}}}"),
    ("a specification", "tables", "", "", "{lift: {axes: {angle: [0, 0.1, 0.2]}, values: [0, 0.6, 1], interpolation: cubic, extrapolation: clamp}}"),
    ("a specification", "functions", "", "", "{square: {arguments: [x], value: x^2}}"),
    ("a specification", "definitions", "", "", "{inertia: mass*length^2}"),
    ("a specification", "reference", "one of each output's unit", "", "{theta: 90 deg * sin(t/(1 s))}"),
    ("an include", "file", "", "", "models/motor.yaml"),
    ("an include", "with", "", "", "{inertia: 0.02 kg*m^2}"),
    ("a plant", "inputs", "", "", "{torque: 8 N*m}"),
    ("a truth", "states", "", "", "{wear: 0}"),
    ("a truth", "rates", "each state's unit per second", "", "{wear: 0.01 1/s}"),
    ("a plant block", "states", "", "", "{theta: 5 deg}"),
    ("a plant block", "drift", "each state's unit per second", "", "[-(gravity/length)*sin(theta)]"),
    ("a plant block", "gain", "the state's unit per second and unit of what drives it", "", "[[1/inertia]]"),
    ("a state", "initial", "the state's", "", "5 deg"),
    ("a state", "unit", "", "", "deg"),
    ("a disturbance", "bounded", "each state's unit per second", "", "[1 rad/s^2 * sin(3*t/(1 s))]"),
    ("a disturbance", "exosystem", "", "", "[{M: [[0, 3], [-3, 0]], L: [0, 2]}]"),
    ("an exosystem", "M", "1/s", "", "[[0, 3], [-3, 0]]"),
    ("an exosystem", "N", "", "", "[[1, 0], [0, 1]]"),
    ("an exosystem", "L", "the state's unit per second", "", "[0, 2]"),
    ("an exosystem", "initial", "", "0", "[0, 0]"),
    ("a noise", "effectiveness", "", "", "[[1/(1 s^2)]]"),
    ("a noise", "intensity", "", "", "[0.05]"),
    ("an input", "limit", "the input's", "", "8 N*m"),
    ("an input", "safe", "the input's", "0", "0 N*m"),
    ("an actuator", "delay", "s", "", "4 ms"),
    ("an actuator", "quantum", "the input's", "", "0.01 N*m"),
    ("an actuator", "lag", "s", "", "20 ms"),
    ("an actuator", "rate_limit", "the input's per second", "", "50 N*m/s"),
    ("an actuator", "faults", "", "", "[{at: 5 s, effectiveness: 0.5}]"),
    ("a fault", "at", "s", "", "5 s"),
    ("a fault", "effectiveness", "1", "", "0.5"),
    ("a fault", "stuck", "the input's", "", "here"),
    ("a sensor", "bias", "the state's", "", "{uniform: [-0.1 deg, 0.1 deg]}"),
    ("a sensor", "noise", "the state's", "", "0.05 deg"),
    ("a sensor", "quantum", "the state's", "", "0.01 deg"),
    ("a sensor", "dropout", "1", "", "0.001"),
    ("a controller", "sample_time", "s", "", "2 ms"),
    ("a controller", "virtual_derivative", "", "filter", "exact"),
    ("a controller", "norm", "", "frobenius", "spectral"),
    ("a controller", "integration", "", "exponential", "euler"),
    ("a controller", "barrier_margin", "rad", "1e-3", "1e-3"),
    ("a controller", "parameters", "each parameter's", "", "{mass: 1.1 kg}"),
    ("a controller block", "K", "1/s", "", "4"),
    ("a controller block", "kbar", "1/s", "", "auto"),
    ("a controller block", "C", "1/s", "", "20"),
    ("a controller block", "filter", "s", "", "20 ms"),
    ("a controller block", "eta_1", "1", "", "1"),
    ("a controller block", "eta_2", "1", "", "1"),
    ("a controller block", "eta_3", "1", "", "1"),
    ("a controller block", "eta_noise", "1", "", "0.1"),
    ("a controller block", "observer", "1/s", "", "10"),
    ("a controller block", "constraint", "the states'", "", "(30*exp(-2*t/(1 s)) + 6)*1 deg"),
    ("a controller block", "network", "", "", "{order: 2, inputs: [sin(theta), omega], iota: 1, Gamma: 1, lambda: 0.1}"),
    ("a controller block", "error_bound", "", "", "{iota: 0.1, b: 2}"),
    ("a controller block", "noise_bound", "", "", "{tau: 1, lambda: 0.1, varsigma: 1, phi: {initial: 10, kappa: 2, threshold: 0.01}}"),
    ("a network", "order", "", "", "2"),
    ("a network", "basis", "", "pairwise", "complete"),
    ("a network", "inputs", "", "", "[sin(theta), omega]"),
    ("a network", "scale", "each input's", "1", "[1, 2 rad/s]"),
    ("a network", "iota", "SI", "", "0.1"),
    ("a network", "Gamma", "SI", "", "1"),
    ("a network", "lambda", "SI", "", "0.1"),
    ("an error bound", "iota", "SI", "", "0.1"),
    ("an error bound", "b", "SI", "", "2"),
    ("a noise bound", "tau", "SI", "", "1"),
    ("a noise bound", "lambda", "SI", "", "0.1"),
    ("a noise bound", "varsigma", "SI", "", "1"),
    ("a noise bound", "phi", "", "", "{initial: 10, kappa: 2, threshold: 0.01}"),
    ("a phi", "initial", "SI", "", "10"),
    ("a phi", "kappa", "1/s", "", "2"),
    ("a phi", "threshold", "SI", "", "0.01"),
    ("a phi", "min", "SI", "auto", "auto"),
    ("a scenario", "horizon", "s", "", "20 s"),
    ("a scenario", "substeps", "", "4", "4"),
    ("a scenario", "scheme", "", "rk4", "platen"),
    ("a scenario", "noise", "", "sampled", "wiener"),
    ("a scenario", "seed", "", "1", "7"),
    ("a scenario", "runs", "", "1", "100"),
    ("a scenario", "settle", "s", "0 s", "4.5 s"),
    ("a scenario", "sweep", "", "", "{controller.blocks.position.K: [2, 4, 8]}"),
    ("a constant", "value", "", "", "0.5 m"),
    ("a constant", "unit", "", "", "m"),
    ("a constant", "source", "", "", "data sheet of 2019, page 3"),
    ("a parameter", "value", "", "", "1 kg"),
    ("a parameter", "unit", "", "", "kg"),
    ("a parameter", "dispersion", "", "", "{uniform: [0.8 kg, 1.2 kg]}"),
    ("a parameter", "source", "", "", "weighed"),
    ("a dispersion", "uniform", "the quantity's", "", "[0.8 kg, 1.2 kg]"),
    ("a dispersion", "normal", "the quantity's", "", "[1 kg, 0.1 kg]"),
    ("a dispersion", "truncated_normal", "the quantity's", "", "[1 kg, 0.1 kg, 0.8 kg, 1.2 kg]"),
    ("a dispersion", "lognormal", "the quantity's and 1", "", "[1 kg, 0.2]"),
    ("a dispersion", "discrete", "the quantity's and 1", "", "[[1 kg, 0.7], [2 kg, 0.3]]"),
    ("a correlation", "parameters", "", "", "[mass, length]"),
    ("a correlation", "covariance", "products of the parameters' units", "", "[[0.01 kg^2, 0 kg*m], [0 kg*m, 1e-4 m^2]]"),
    ("a function", "arguments", "", "", "[value, limit]"),
    ("a function", "value", "", "", "limit*tanh(value/limit)"),
    ("a function", "source", "", "", "chosen"),
    ("a table", "axes", "", "", "{mach: [0.4, 0.8, 1.2], alpha: {values: [0, 5, 10], unit: deg}}"),
    ("a table", "values", "that under `unit`", "", "[[0, 0.4, 0.8], [0, 0.5, 0.9], [0, 0.3, 0.7]]"),
    ("a table", "file", "", "", "data/aero.csv"),
    ("a table", "column", "", "", "CL"),
    ("a table", "unit", "", "", "N*m"),
    ("a table", "interpolation", "", "", "cubic"),
    ("a table", "extrapolation", "", "", "clamp"),
    ("a table", "source", "", "", "wind tunnel test 12"),
    ("an axis", "values", "that under `unit`", "", "[0, 5, 10]"),
    ("an axis", "unit", "", "", "deg"),
    ("a polynomial group", "arguments", "", "", "[speed]"),
    ("a polynomial group", "source", "", "", "NASA TM-102610"),
    ("a polynomial group", "parts", "", "", "{cubic: [[0.01, 3], [0.02, 1]]}"),
];

#[cfg(test)]
mod tests {
    use super::super::{Kind, SPECIFICATION, Section};
    use super::*;
    use crate::diagnostic::FileId;
    use crate::yaml::{Kind as Found, Node, read};

    /// Every section that can be reached.
    fn sections() -> Vec<&'static Section> {
        fn below(kind: &'static Kind, all: &mut Vec<&'static Section>) {
            match kind {
                Kind::Section(section) if all.iter().all(|known| known.noun != section.noun) => {
                    all.push(section);
                    section.keys.iter().for_each(|key| below(&key.kind, all));
                }
                Kind::Named(inner) | Kind::ByName(inner) | Kind::List(inner) => below(inner, all),
                Kind::Either(kinds) => kinds.iter().for_each(|kind| below(kind, all)),
                _ => {}
            }
        }
        let mut all = vec![&SPECIFICATION];
        SPECIFICATION
            .keys
            .iter()
            .for_each(|key| below(&key.kind, &mut all));
        all
    }

    /// Whether a value is of a kind, as far as its form goes.
    fn fits(node: &Node, kind: &'static Kind) -> bool {
        match (kind, &node.kind) {
            (Kind::Text | Kind::Quantity | Kind::Expression, Found::Scalar(_)) => true,
            (Kind::Count, Found::Scalar(scalar)) => scalar.text.parse::<u64>().is_ok(),
            (Kind::Choice(words), Found::Scalar(scalar)) => words.contains(&&*scalar.text),
            (Kind::Formula | Kind::Grid, Found::Scalar(_)) => true,
            (Kind::Formula | Kind::Grid, Found::Seq(items)) => {
                items.iter().all(|item| fits(item, kind))
            }
            (Kind::List(inner), Found::Seq(items)) => items.iter().all(|item| fits(item, inner)),
            (Kind::Sweep, Found::Map(entries)) => entries
                .iter()
                .all(|entry| matches!(entry.value.kind, Found::Seq(_))),
            (Kind::Named(inner) | Kind::ByName(inner), Found::Map(entries)) => {
                entries.iter().all(|entry| fits(&entry.value, inner))
            }
            (Kind::Section(section), Found::Map(entries)) => entries.iter().all(|entry| {
                let key = section.keys.iter().find(|key| key.name == entry.key.text);
                key.is_some_and(|key| fits(&entry.value, &key.kind))
            }),
            (Kind::Either(kinds), _) => kinds.iter().any(|kind| fits(node, kind)),
            _ => false,
        }
    }

    #[test]
    fn every_key_that_is_no_section_has_an_example_that_fits() {
        for section in sections() {
            for key in section.keys {
                let nested = matches!(key.kind, Kind::Section(_) | Kind::Named(Kind::Section(_)));
                let Details {
                    default, example, ..
                } = details(section.noun, key.name);
                assert!(
                    nested || !example.is_empty(),
                    "{}: {}",
                    section.noun,
                    key.name
                );
                for text in [default, example]
                    .into_iter()
                    .filter(|text| !text.is_empty())
                {
                    let node = read(text, FileId(0)).unwrap();
                    assert!(
                        fits(&node, &key.kind),
                        "{}: {}: {text}",
                        section.noun,
                        key.name
                    );
                }
            }
        }
    }

    #[test]
    fn every_row_is_of_a_key() {
        let sections = sections();
        for (noun, key, ..) in ROWS {
            let section = sections.iter().find(|section| section.noun == *noun);
            let known =
                section.is_some_and(|section| section.keys.iter().any(|known| known.name == *key));
            assert!(known, "{noun}: {key}");
        }
    }

    #[test]
    fn a_key_with_a_default_says_so_in_its_description_alike() {
        for (noun, key, _, default, _) in ROWS.iter().filter(|row| !row.3.is_empty()) {
            let section = sections()
                .into_iter()
                .find(|section| section.noun == *noun)
                .unwrap();
            let doc = section
                .keys
                .iter()
                .find(|known| known.name == *key)
                .unwrap()
                .doc;
            let zero = *default == "0" && doc.contains("default: zero");
            assert!(
                zero || doc.contains(&format!("default: {default}")),
                "{noun}: {key}: {doc}"
            );
        }
    }
}
