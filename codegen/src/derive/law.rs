//! The law: a table of named equations over leaves (time, states, controller states), each with its number in the paper.

use std::collections::BTreeMap;

use nsv_spec::model::{Matrix, Model};

use super::symbol::{Symbol, TapeId, diagonal, diagonal_of, matrix, name};
use crate::ir::{MonomialBasis, Origin, Program, Shape};

/// One equation: `name = rhs`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Name of the quantity, as in equations.md with the block number: `e1`, `Lam2`.
    pub name: String,
    /// Where it stands in the paper, for comments.
    pub origin: Origin,
    /// Its right-hand side.
    pub rhs: Symbol,
    /// Its shape; `None` for a truth value.
    pub shape: Option<Shape>,
}

/// A program of partials imported from CasADi, with what its inputs stand for.
#[derive(Clone, Debug)]
pub struct Tape {
    /// Scalar program as exported.
    pub program: Program,
    /// Input name and the symbol that it stands for.
    pub bindings: BTreeMap<String, Symbol>,
}

/// A state of the controller: a leaf of the law with its own differential equation.
#[derive(Clone, Debug)]
pub struct ControllerState {
    /// Name, such as `th1`.
    pub name: String,
    /// Shape.
    pub shape: Shape,
    /// What it is, for docs.
    pub doc: String,
    /// Its value at the first sample, from quantities there.
    pub initial: Symbol,
}

/// The control law of a model, with simulation truth and Lyapunov function.
#[derive(Clone, Debug)]
pub struct Law<'m> {
    /// The model it was derived from.
    pub model: &'m Model,
    /// Leaves other than controller states: `t`, `x1`, .., `w2`, ..
    pub leaves: BTreeMap<String, Shape>,
    /// Controller states, in order of the emitted struct.
    pub states: Vec<ControllerState>,
    /// Monomial bases of the networks, by block number (from 1).
    pub bases: BTreeMap<usize, MonomialBasis>,
    /// Imported partials.
    pub tapes: Vec<Tape>,
    equations: Vec<Equation>,
    index: BTreeMap<String, usize>,
    group: String,
}

impl<'m> Law<'m> {
    /// An empty law of a model.
    pub fn new(model: &'m Model) -> Self {
        Self {
            model,
            leaves: BTreeMap::new(),
            states: Vec::new(),
            bases: BTreeMap::new(),
            tapes: Vec::new(),
            equations: Vec::new(),
            index: BTreeMap::new(),
            group: String::new(),
        }
    }

    /// Number of blocks n.
    pub fn order(&self) -> usize {
        self.model.blocks.len()
    }

    /// Channels of each block, m.
    pub fn width(&self) -> usize {
        self.model.inputs.len()
    }

    /// Sets the heading under which the next equations stand.
    pub fn group(&mut self, heading: impl Into<String>) {
        self.group = heading.into();
    }

    /// Adds an equation and returns a reference to its quantity. `equation` is its form in the paper's symbols.
    pub fn define(
        &mut self,
        quantity: impl Into<String>,
        equation: impl Into<String>,
        rhs: Symbol,
    ) -> Symbol {
        let quantity = quantity.into();
        let shape = self.shape_of(&rhs);
        let previous = self.index.insert(quantity.clone(), self.equations.len());
        assert!(
            previous.is_none(),
            "invariant: `{quantity}` is defined once"
        );
        let origin = Origin {
            group: self.group.clone(),
            equation: equation.into(),
        };
        self.equations.push(Equation {
            name: quantity.clone(),
            origin,
            rhs,
            shape,
        });
        name(quantity)
    }

    /// A constant matrix times a vector: the scalar or elementwise product where the matrix is diagonal, else the product with the
    /// matrix under its name.
    pub fn gain(&mut self, quantity: String, text: &str, value: &Matrix, of: Symbol) -> Symbol {
        match diagonal_of(value) {
            Some(values) => diagonal(&values) * of,
            None => self.constant(quantity, text, value).times(of),
        }
    }

    /// A constant matrix under its name.
    pub fn constant(&mut self, quantity: String, text: &str, value: &Matrix) -> Symbol {
        if self.contains(&quantity) {
            name(quantity)
        } else {
            self.define(quantity, text, matrix(value))
        }
    }

    /// Adds a controller state.
    pub fn state(
        &mut self,
        state: impl Into<String>,
        shape: Shape,
        doc: impl Into<String>,
        initial: Symbol,
    ) -> Symbol {
        let state = state.into();
        self.states.push(ControllerState {
            name: state.clone(),
            shape,
            doc: doc.into(),
            initial,
        });
        name(state)
    }

    /// The equation of a quantity; `None` for leaves and states.
    pub fn equation(&self, quantity: &str) -> Option<&Equation> {
        self.index.get(quantity).map(|&at| &self.equations[at])
    }

    /// Whether a quantity exists, as an equation, a leaf or a state.
    pub fn contains(&self, quantity: &str) -> bool {
        self.index.contains_key(quantity) || self.leaf_shape(quantity).is_some()
    }

    /// All equations in order of definition.
    pub fn equations(&self) -> &[Equation] {
        &self.equations
    }

    /// Shape of a leaf or controller state.
    pub fn leaf_shape(&self, leaf: &str) -> Option<Shape> {
        let state = || {
            self.states
                .iter()
                .find(|state| state.name == leaf)
                .map(|state| state.shape)
        };
        self.leaves.get(leaf).copied().or_else(state)
    }

    /// Shape of any quantity.
    pub fn shape(&self, quantity: &str) -> Option<Shape> {
        match self.equation(quantity) {
            Some(equation) => equation.shape,
            None => Some(
                self.leaf_shape(quantity)
                    .unwrap_or_else(|| panic!("invariant: `{quantity}` is known")),
            ),
        }
    }

    /// Registers imported partials.
    pub fn import(&mut self, program: Program, bindings: BTreeMap<String, Symbol>) -> TapeId {
        self.tapes.push(Tape { program, bindings });
        TapeId(self.tapes.len() - 1)
    }
}
