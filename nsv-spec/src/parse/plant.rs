//! Reads the plant.

use super::fields::{Fields, Reader};
use crate::diagnostic::Rule;
use crate::spec::{Disturbance, Exosystem, Input, Located, Named, Noise, PlantBlock, State};
use crate::vocabulary::{EXOSYSTEM, INPUT, NOISE, PLANT_BLOCK, STATE};
use crate::yaml::{Kind, Node};

impl Reader {
    /// Blocks and inputs.
    pub(super) fn plant(
        &mut self,
        specification: &Fields<'_>,
    ) -> (Vec<Named<PlantBlock>>, Vec<Named<Input>>) {
        let fields = self.section(specification, "plant");
        (
            self.map(&fields, "blocks", Self::plant_block),
            self.map(&fields, "inputs", Self::input),
        )
    }

    fn plant_block(&mut self, node: &Node) -> PlantBlock {
        let fields = self.fields(node, &PLANT_BLOCK);
        PlantBlock {
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
            };
        }
        let fields = self.fields(node, &STATE);
        State {
            initial: self.code(&fields, "initial"),
            unit: self.text(&fields, "unit"),
        }
    }

    fn disturbance(&mut self, block: &Fields<'_>) -> Option<Located<Disturbance>> {
        let span = block.entry("disturbance")?.key.span;
        let fields = self.section(block, "disturbance");
        let value = match (fields.entry("bounded"), fields.entry("exosystem")) {
            (Some(entry), None) => Disturbance::Bounded(self.formula_of(&entry.value)),
            (None, Some(_)) => {
                let items = self.items(
                    &fields,
                    "exosystem",
                    "a list with one exosystem for each channel",
                );
                Disturbance::Exosystem(items.iter().map(|item| self.exosystem(item)).collect())
            }
            _ => {
                let help = "leave `disturbance` out where there is none";
                self.fault(
                    Rule::E0106,
                    span,
                    "disturbance must have one of `bounded` and `exosystem`",
                    help,
                );
                return None;
            }
        };
        Some(Located { value, span })
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
            };
        }
        let fields = self.fields(node, &INPUT);
        Input {
            limit: self.code(&fields, "limit"),
            safe: self.optional_code(&fields, "safe"),
        }
    }
}
