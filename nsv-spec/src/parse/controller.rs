//! Reads the controller.

use super::fields::{Fields, Reader};
use crate::model::{Basis, Integration, Norm, VirtualDerivative};
use crate::spec::{
    AutoCode, Code, Controller, ControllerBlock, ErrorBound, Network, NoiseBound, Unreadable,
};
use crate::vocabulary::{CONTROLLER_BLOCK, ERROR_BOUND, NETWORK, NOISE_BOUND};
use crate::yaml::Node;

impl Reader {
    pub(super) fn controller(&mut self, specification: &Fields<'_>) -> Controller {
        let fields = self.section(specification, "controller");
        let derivatives = [VirtualDerivative::Filter, VirtualDerivative::Exact];
        Controller {
            sample_time: self.code(&fields, "sample_time"),
            virtual_derivative: self.choice(&fields, "virtual_derivative", &derivatives),
            norm: self.choice(&fields, "norm", &[Norm::Frobenius, Norm::Spectral]),
            integration: self.choice(
                &fields,
                "integration",
                &[Integration::Exponential, Integration::Euler],
            ),
            barrier_margin: self.optional_code(&fields, "barrier_margin"),
            parameters: self.map(&fields, "parameters", Self::code_of),
            blocks: self.map(&fields, "blocks", Self::controller_block),
        }
    }

    fn controller_block(&mut self, node: &Node) -> ControllerBlock {
        let fields = self.fields(node, &CONTROLLER_BLOCK);
        ControllerBlock {
            keys: fields.keys(),
            complete: fields.maps_complete,
            k: self.formula(&fields, "K"),
            kbar: self
                .auto(&fields, "kbar")
                .unwrap_or_else(|| AutoCode::Code(Code::unreadable(fields.span))),
            c: self.formula(&fields, "C"),
            filter: self.optional_formula(&fields, "filter"),
            eta_1: self.optional_code(&fields, "eta_1"),
            eta_2: self.optional_code(&fields, "eta_2"),
            eta_3: self.optional_code(&fields, "eta_3"),
            eta_noise: self.optional_code(&fields, "eta_noise"),
            observer: self.optional_formula(&fields, "observer"),
            constraint: self.optional_formula(&fields, "constraint"),
            network: self.nested(&fields, "network", Self::network),
            error_bound: self.nested(&fields, "error_bound", Self::error_bound),
            noise_bound: self.nested(&fields, "noise_bound", Self::noise_bound),
        }
    }

    fn network(&mut self, node: &Node) -> Network {
        let fields = self.fields(node, &NETWORK);
        let inputs = self.items(&fields, "inputs", "a list of expressions");
        let formulas = |items: &[Node]| items.iter().map(|item| self.formula_of(item)).collect();
        let inputs = inputs.map(formulas);
        Network {
            order: self.count(&fields, "order").ok_or(Unreadable),
            basis: self.choice(&fields, "basis", &[Basis::Pairwise, Basis::Complete]),
            inputs,
            scale: self.optional_formula(&fields, "scale"),
            iota: self.formula(&fields, "iota"),
            gamma: self.code(&fields, "Gamma"),
            lambda: self.code(&fields, "lambda"),
        }
    }

    fn error_bound(&mut self, node: &Node) -> ErrorBound {
        let fields = self.fields(node, &ERROR_BOUND);
        ErrorBound {
            iota: self.code(&fields, "iota"),
            b: self.formula(&fields, "b"),
        }
    }

    fn noise_bound(&mut self, node: &Node) -> NoiseBound {
        let fields = self.fields(node, &NOISE_BOUND);
        let phi = self.section(&fields, "phi");
        NoiseBound {
            tau: self.code(&fields, "tau"),
            lambda: self.code(&fields, "lambda"),
            varsigma: self.code(&fields, "varsigma"),
            phi_initial: self.code(&phi, "initial"),
            phi_kappa: self.code(&phi, "kappa"),
            phi_threshold: self.code(&phi, "threshold"),
            phi_min: self.auto(&phi, "min"),
        }
    }
}
