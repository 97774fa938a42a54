//! Reads the plant.

use super::fields::{Fields, Reader};
use crate::spec::{
    Declared, Disturbance, Exosystem, Input, Located, Noise, PlantBlock, Read, State, Truth,
    Unreadable,
};
use crate::vocabulary::{EXOSYSTEM, INPUT, NOISE, PLANT_BLOCK, STATE, TRUTH};
use crate::yaml::{Kind, Node};

impl Reader {
    /// Blocks of the plant.
    pub(super) fn blocks(&mut self, plant: &Fields<'_>) -> Declared<PlantBlock> {
        self.map(plant, "blocks", Self::plant_block)
    }

    /// Control inputs.
    pub(super) fn inputs(&mut self, plant: &Fields<'_>) -> Declared<Input> {
        self.map(plant, "inputs", Self::input)
    }

    /// What is flown beyond the blocks.
    pub(super) fn flown(&mut self, plant: &Fields<'_>) -> Option<Located<Truth>> {
        self.nested(plant, "truth", Self::truth)
    }

    fn truth(&mut self, node: &Node) -> Truth {
        let fields = self.fields(node, &TRUTH);
        Truth {
            states: self.map(&fields, "states", Self::state),
            rates: self.map(&fields, "rates", Self::formula_of),
        }
    }

    fn plant_block(&mut self, node: &Node) -> PlantBlock {
        let fields = self.fields(node, &PLANT_BLOCK);
        PlantBlock {
            keys: fields.keys(),
            complete: fields.maps_complete,
            states: self.map(&fields, "states", Self::state),
            drift: self.formula(&fields, "drift"),
            gain: self.formula(&fields, "gain"),
            disturbance: self.disturbance(&fields),
            noise: self.nested(&fields, "noise", Self::noise),
        }
    }

    fn state(&mut self, node: &Node) -> State {
        if !matches!(node.kind, Kind::Map(_)) {
            return State {
                initial: self.code_of(node),
                unit: None,
                dispersion: None,
                sensor: None,
            };
        }
        let fields = self.fields(node, &STATE);
        State {
            initial: self.code(&fields, "initial"),
            unit: self.text(&fields, "unit"),
            dispersion: self.dispersion(&fields),
            sensor: (fields.entry("sensor")).map(|entry| self.sensor(&entry.value)),
        }
    }

    fn disturbance(&mut self, block: &Fields<'_>) -> Option<Located<Read<Disturbance>>> {
        let span = block.entry("disturbance")?.key.span;
        let fields = self.section(block, "disturbance");
        let value = match (fields.entry("bounded"), fields.entry("exosystem")) {
            (Some(entry), None) => Ok(Disturbance::Bounded(self.formula_of(&entry.value))),
            (None, Some(_)) => self.exosystems(&fields),
            (None, None) if !fields.complete => Err(Unreadable),
            _ => self.one_of(span, "disturbance", ["bounded", "exosystem"]),
        };
        Some(Located { value, span })
    }

    fn exosystems(&mut self, disturbance: &Fields<'_>) -> Read<Disturbance> {
        let expected = "a list with one exosystem for each channel";
        let items = self.items(disturbance, "exosystem", expected)?.iter();
        let channels = items.map(|item| self.exosystem(item)).collect();
        Ok(Disturbance::Exosystem(channels))
    }

    fn exosystem(&mut self, node: &Node) -> Exosystem {
        let fields = self.fields(node, &EXOSYSTEM);
        Exosystem {
            m: self.formula(&fields, "M"),
            n: self.optional_formula(&fields, "N"),
            l: self.formula(&fields, "L"),
            initial: self.optional_formula(&fields, "initial"),
            span: node.span,
        }
    }

    fn noise(&mut self, node: &Node) -> Noise {
        let fields = self.fields(node, &NOISE);
        Noise {
            effectiveness: self.formula(&fields, "effectiveness"),
            intensity: self.formula(&fields, "intensity"),
        }
    }

    fn input(&mut self, node: &Node) -> Input {
        if !matches!(node.kind, Kind::Map(_)) {
            return Input {
                limit: self.code_of(node),
                safe: None,
                actuator: None,
            };
        }
        let fields = self.fields(node, &INPUT);
        Input {
            limit: self.code(&fields, "limit"),
            safe: self.optional_code(&fields, "safe"),
            actuator: (fields.entry("actuator")).map(|entry| self.actuator(&entry.value)),
        }
    }
}
