//! Reads actuators and sensors.

use super::fields::Reader;
use crate::spec::{Actuator, Bias, Effect, Fault, Read, Sensor};
use crate::vocabulary::{ACTUATOR, FAULT, SENSOR};
use crate::yaml::{Kind, Node};

impl Reader {
    /// How a command reaches the plant.
    pub(super) fn actuator(&mut self, node: &Node) -> Actuator {
        let fields = self.fields(node, &ACTUATOR);
        let faults = self.items(&fields, "faults", "a list of faults");
        let faults = faults.unwrap_or_default().iter();
        Actuator {
            delay: self.optional_code(&fields, "delay"),
            quantum: self.optional_code(&fields, "quantum"),
            lag: self.optional_code(&fields, "lag"),
            rate_limit: self.optional_code(&fields, "rate_limit"),
            faults: (faults.filter_map(|fault| self.actuator_fault(fault).ok())).collect(),
        }
    }

    fn actuator_fault(&mut self, node: &Node) -> Read<Fault> {
        let fields = self.fields(node, &FAULT);
        let at = self.code(&fields, "at");
        let effect = match (fields.entry("effectiveness"), fields.entry("stuck")) {
            (Some(entry), None) => Effect::Effectiveness(self.code_of(&entry.value)),
            (None, Some(entry)) => Effect::Stuck(match &entry.value.kind {
                Kind::Scalar(scalar) if scalar.text == "here" => None,
                _ => Some(self.code_of(&entry.value)),
            }),
            _ => return self.one_of(fields.span, "a fault", ["effectiveness", "stuck"]),
        };
        Ok(Fault { at, effect })
    }

    /// How a state is measured.
    pub(super) fn sensor(&mut self, node: &Node) -> Sensor {
        let fields = self.fields(node, &SENSOR);
        let bias = fields.entry("bias").map(|entry| &entry.value);
        Sensor {
            bias: bias.map(|node| match node.kind {
                Kind::Map(_) => self.distribution(node).map(Bias::Drawn),
                _ => Ok(Bias::Fixed(self.code_of(node))),
            }),
            noise: self.optional_code(&fields, "noise"),
            quantum: self.optional_code(&fields, "quantum"),
            dropout: self.optional_code(&fields, "dropout"),
        }
    }
}
