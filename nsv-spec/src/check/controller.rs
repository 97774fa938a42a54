//! Guarantees that every plant block has its part of the controller, and joins the two.

use super::Context;
use super::pairing::{Pairing, pair};
use super::plant::{PlantBlock, SECOND};
use crate::diagnostic::{Diagnostic, Rule};
use crate::model::{Block, Controller, Integration, Norm, VirtualDerivative};
use crate::spec::{Code, ControllerBlock, Named, Word};
use crate::suggest::{Meant, nearest};
use crate::unit::Dimension;

const PER_SECOND: Dimension = Dimension::new(0, 0, -1, 0);
/// Default and largest margin of the barrier, rad.
const MARGIN: f64 = 1e-3;
const LARGEST_MARGIN: f64 = 0.5;

impl Context<'_> {
    /// Choices for the controller as a whole.
    pub(super) fn controller(&mut self, sample_time: Option<f64>) -> Option<Controller> {
        let written = &self.spec.controller;
        let norm = written
            .norm
            .ok()?
            .map(|norm| norm.value)
            .unwrap_or_else(|| {
                self.default("controller.norm".into(), "frobenius", "the paper's");
                Norm::Frobenius
            });
        let virtual_derivative = written
            .virtual_derivative
            .ok()?
            .map(|choice| choice.value)
            .unwrap_or_else(|| {
                self.default(
                    "controller.virtual_derivative".into(),
                    "filter",
                    "the paper's",
                );
                VirtualDerivative::Filter
            });
        let integration = written
            .integration
            .ok()?
            .map(|choice| choice.value)
            .unwrap_or_else(|| {
                self.default(
                    "controller.integration".into(),
                    "exponential",
                    "stable for every step size",
                );
                Integration::Exponential
            });
        let barrier_margin = match &written.barrier_margin {
            Some(code) => self.barrier_margin(code),
            None => {
                self.default(
                    "controller.barrier_margin".into(),
                    "1e-3",
                    "E is clamped at pi/2 - 1e-3",
                );
                Some(MARGIN)
            }
        };
        Some(Controller {
            sample_time: sample_time?,
            norm,
            virtual_derivative,
            integration,
            barrier_margin: barrier_margin?,
        })
    }

    fn barrier_margin(&mut self, code: &Code) -> Option<f64> {
        let margin = self.gain(code, "barrier margin", Dimension::ONE)?;
        if margin > 0.0 && margin <= LARGEST_MARGIN {
            return Some(margin);
        }
        let message = format!(
            "barrier margin is {margin} rad, expected more than 0 and at most {LARGEST_MARGIN} rad"
        );
        self.fault(
            Rule::E0602,
            code.base.span,
            message,
            "write a small angle, such as `1e-3` or `2 deg`",
        );
        None
    }

    /// The gains of each plant block, in the plant's order.
    pub(super) fn match_blocks(&mut self) -> Vec<Option<usize>> {
        let (plant, gains) = (&self.spec.blocks, &self.spec.controller.blocks);
        let wanted: Vec<&str> = texts(plant);
        let Pairing { matched, strangers } = pair(&wanted, &texts(gains));
        for (at, meant) in strangers.into_iter().filter(|_| plant.complete) {
            let own = &gains[at].name;
            if !matched.contains(&Some(at)) {
                self.supersede(own.span);
            }
            let message = format!("controller block `{}` is no block of the plant", own.value);
            let fault = Diagnostic::error(Rule::E0114, own.span, message);
            // One that another file gives can be meant too.
            let elsewhere = |at: usize| gains[at].name.span.file != own.span.file;
            let given = wanted.iter().zip(&matched);
            let given = given.filter(|(_, at)| at.is_some_and(elsewhere));
            let meant = meant.or_else(|| nearest(&own.value, given.map(|(name, _)| *name)));
            // Either of the two names may be the misspelt one.
            let meant = meant.map(|meant| Meant {
                sure: false,
                ..meant
            });
            let otherwise = || format!("the plant's blocks are `{}`", wanted.join("`, `"));
            self.faults
                .push(fault.did_you_mean(own.span, &own.value, meant, otherwise));
        }
        for (block, matched) in plant.iter().zip(&matched) {
            if matched.is_none() && gains.complete {
                self.report_missing_gains(&block.name);
            }
        }
        matched
    }

    fn report_missing_gains(&mut self, block: &Word) {
        let message = format!("controller has no gains for block `{}`", block.value);
        let fault = Diagnostic::error(Rule::E0114, self.spec.controller.blocks.span, message)
            .with_related(block.span, "the block is declared here");
        let help = format!(
            "add `{}:` with its gains under `controller.blocks`",
            block.value
        );
        self.faults.push(fault.with_help(help));
    }

    /// Checks the gains of a block and joins them with its plant.
    pub(super) fn block(
        &mut self,
        at: usize,
        gains: &Named<ControllerBlock>,
        plant: PlantBlock,
        horizon: Option<f64>,
    ) -> Option<Block> {
        self.check_features(at, gains);
        let name = &self.spec.blocks[at].name;
        let what = |key: &str| format!("`{key}` of block `{}`", name.value);
        let own = &gains.value;
        let constraint = own
            .constraint
            .as_ref()
            .map(|formula| (self.constraint(at, formula), formula.span()));
        let positive = match (constraint, horizon) {
            (Some((Some(id), span)), Some(horizon)) => {
                self.check_constraint(id, span, &name.value, horizon)
            }
            _ => Some(()),
        };
        let constraint = match constraint {
            Some((id, _)) => id.map(Some),
            None => Some(None),
        };
        let k = self.channel_gains(&own.k, &what("K"), PER_SECOND);
        let c = self.anti_windup(&own.c, &name.value);
        let kbar = match (constraint, positive) {
            (Some(constraint), Some(())) => self.kbar(&own.kbar, constraint, &name.value, horizon),
            _ => None,
        };
        let filter = own
            .filter
            .as_ref()
            .map(|formula| self.channel_gains(formula, &what("filter"), SECOND));
        let etas = [&own.eta_1, &own.eta_2, &own.eta_3, &own.eta_noise];
        let keys = ["eta_1", "eta_2", "eta_3", "eta_noise"];
        let mut eta = |i: usize| match etas[i] {
            Some(code) => self.positive_gain(code, &what(keys[i]), Dimension::ONE),
            // Absent only where nothing reads it; 1 is harmless in every formula.
            None => Some(1.0),
        };
        let (eta_1, eta_2, eta_3, eta_noise) = (eta(0), eta(1), eta(2), eta(3));
        let network = own
            .network
            .as_ref()
            .map(|network| self.network(at, network));
        let error_bound = own
            .error_bound
            .as_ref()
            .map(|bound| self.error_bound(at, &bound.value));
        let noise_bound = own
            .noise_bound
            .as_ref()
            .map(|bound| self.noise_bound(at, &bound.value));
        let observer = own
            .observer
            .as_ref()
            .map(|formula| self.observer(formula, at, plant.disturbance.as_ref()));
        Some(Block {
            name: name.value.clone(),
            states: self.states[at].clone()?,
            drift: plant.drift?,
            gain: plant.gain?,
            disturbance: plant.disturbance?,
            noise: plant.noise?,
            k: k?,
            kbar: kbar?,
            c: c?,
            filter: given(filter)?,
            eta_1: eta_1?,
            eta_2: eta_2?,
            eta_3: eta_3?,
            eta_noise: eta_noise?,
            observer: given(observer)?,
            constraint: constraint?,
            network: given(network)?,
            error_bound: given(error_bound)?,
            noise_bound: given(noise_bound)?,
            span: name.span,
            keys: (self.spec.blocks[at].value.keys.iter().chain(&own.keys))
                .map(|(key, span)| (*key, *span))
                .collect(),
        })
    }
}

/// Turns "written, but perhaps faulty" inside out: `None` for a fault, `Some(None)` for something not written.
fn given<T>(written: Option<Option<T>>) -> Option<Option<T>> {
    match written {
        Some(value) => value.map(Some),
        None => Some(None),
    }
}

fn texts<T>(all: &[Named<T>]) -> Vec<&str> {
    all.iter().map(|one| one.name.value.as_str()).collect()
}
