//! Guarantees that the plant's functions have the shapes and units of the chain: F_i and d_i a state per second, G_i a state per
//! second for each unit of the next state or input, H_i Sigma_i a state per second (sampled) or per root second (Wiener).

use super::Context;
use super::formula::Parsed;
use super::scope::Dependence;
use crate::diagnostic::Span;
use crate::expr::arena::{ExprId, Shape};
use crate::expr::{Expected, Symbol};
use crate::model::{self, Disturbance, Exosystem, Matrix, Noise};
use crate::spec::{self, Formula, Located, Named, Word};
use crate::unit::Dimension;

/// Most blocks, and most channels of a block.
const MAX_BLOCKS: usize = 16;
const MAX_WIDTH: usize = 32;
/// Most states of one exosystem, and most noise channels of a block.
const MAX_EXOSYSTEM: usize = 16;

const SECOND: Dimension = Dimension::new(0, 0, 1, 0);

/// The plant's side of a block.
pub(super) struct PlantBlock {
    pub(super) drift: ExprId,
    pub(super) gain: ExprId,
    pub(super) disturbance: Disturbance,
    pub(super) noise: Option<Noise>,
}

impl Context<'_> {
    /// Width of the blocks: that of the first.
    pub(super) fn width(&self) -> usize {
        self.spec.blocks.first().map_or(0, |block| block.value.states.len())
    }

    /// Checks the numbers of blocks, states and inputs. Nothing else can be checked if they are wrong.
    pub(super) fn check_counts(&mut self) -> bool {
        let spec = self.spec;
        let before = self.faults.len();
        let Some(first) = spec.blocks.first() else {
            self.fault("E0602", spec.reference.span, "plant has no blocks, expected at least one", "declare the output's block under `plant.blocks`");
            return false;
        };
        if spec.blocks.len() > MAX_BLOCKS {
            let message = format!("plant has {} blocks, expected at most {MAX_BLOCKS}", spec.blocks.len());
            self.fault("E0602", spec.blocks[MAX_BLOCKS].name.span, message, "control the inner dynamics separately");
        }
        let width = self.width();
        if width == 0 || width > MAX_WIDTH {
            let message = format!("block `{}` has {width} states, expected 1 to {MAX_WIDTH}", first.name.value);
            self.fault("E0602", first.name.span, message, "declare its states under `states`");
        }
        for block in spec.blocks.iter().filter(|block| block.value.states.len() != width) {
            let message = format!("block `{}` has {} states, expected {width} as in block `{}`", block.name.value, block.value.states.len(), first.name.value);
            self.fault("E0503", block.name.span, message, "all blocks of the chain have the same number of states");
        }
        if spec.inputs.len() != width {
            let span = spec.inputs.first().map_or(first.name.span, |input| input.name.span);
            let message = format!("plant has {} inputs, expected {width}, one for each state of a block", spec.inputs.len());
            self.fault("E0503", span, message, "G of the last block must be square");
        }
        self.faults.len() == before
    }

    /// Computes initial values and display units of all states and gives their names a meaning.
    pub(super) fn check_states(&mut self) {
        let spec = self.spec;
        for (at, block) in spec.blocks.iter().enumerate() {
            let mut states = Vec::new();
            for (channel, Named { name, value }) in block.value.states.iter().enumerate() {
                let state = self.state(name, value);
                match &state {
                    Some(state) => {
                        let symbol = Symbol::State { block: at, channel, dimension: state.dimension };
                        self.names.define(&name.value, symbol, Dependence { time: false, block: Some(at) });
                    }
                    None => self.names.refuse(&name.value),
                }
                states.push(state);
            }
            self.states.push(states.into_iter().collect());
        }
    }

    fn state(&mut self, name: &Word, written: &spec::State) -> Option<model::State> {
        let what = format!("initial value of `{}`", name.value);
        let unit = match &written.unit {
            Some(unit) => Some(self.unit(unit)?),
            None => None,
        };
        let (initial, dimension) = self.value_in(&written.initial, unit.as_ref(), &what)?;
        let display = match unit {
            Some(unit) => (unit.text, unit.scale),
            None => self.display(&written.initial, dimension),
        };
        Some(model::State { name: name.value.clone(), initial, dimension, display })
    }

    /// The unit in which a quantity is written, or SI.
    fn display(&mut self, code: &spec::Code, dimension: Dimension) -> (String, f64) {
        let parsed = crate::expr::parse(&code.text, code.base).ok();
        let unit = parsed.as_ref().and_then(|expr| expr.as_literal()).and_then(|(_, unit)| unit);
        unit.map_or_else(|| (dimension.to_string(), 1.0), |unit| (unit.text.clone(), unit.scale))
    }

    /// Checks limits and safe values of the inputs.
    pub(super) fn check_inputs(&mut self) -> Option<Vec<model::Input>> {
        let spec = self.spec;
        let inputs: Vec<Option<model::Input>> = spec.inputs.iter().map(|input| self.input(&input.name, &input.value)).collect();
        inputs.into_iter().collect()
    }

    fn input(&mut self, name: &Word, written: &spec::Input) -> Option<model::Input> {
        let what = format!("limit of input `{}`", name.value);
        let (limit, dimension) = self.scalar(&written.limit, &what)?;
        let span = written.limit.base.span;
        self.positive(limit, span, &what)?;
        let safe = match &written.safe {
            Some(code) => self.quantity(code, &format!("safe value of input `{}`", name.value), dimension)?,
            None => {
                self.default(format!("plant.inputs.{}.safe", name.value), "0", "output when a measurement is not finite");
                0.0
            }
        };
        if safe.abs() > limit {
            let message = format!("safe value of input `{}` is {safe}, beyond its limit {limit}", name.value);
            self.fault("E0602", written.safe.as_ref().map_or(span, |code| code.base.span), message, "choose a value within the limit");
            return None;
        }
        Some(model::Input { name: name.value.clone(), limit, safe, dimension, display: self.display(&written.limit, dimension) })
    }

    /// Dimensions of the states of a block, or of the inputs for the index after the last.
    fn channel_dimensions(&self, block: usize, inputs: Option<&[model::Input]>) -> Option<Vec<Dimension>> {
        match self.states.get(block) {
            Some(states) => Some(states.as_ref()?.iter().map(|state| state.dimension).collect()),
            None => Some(inputs?.iter().map(|input| input.dimension).collect()),
        }
    }

    /// Checks F, G, d and H of a block.
    pub(super) fn check_plant_block(&mut self, at: usize, inputs: Option<&[model::Input]>) -> Option<PlantBlock> {
        let spec = self.spec;
        let Named { name, value: written } = &spec.blocks[at];
        let width = self.width();
        let own = self.channel_dimensions(at, inputs)?;
        let next = self.channel_dimensions(at + 1, inputs);
        let rates = self.ratios(&own, &[SECOND], name.span)?;
        let vector = Shape::Vector(width);
        let what = |term: &str| format!("{term} of block `{}`", name.value);
        let drift = self.term(&written.drift, &Expected { what: &what("drift"), shape: vector, dimensions: &rates });
        if let Some((_, parsed)) = &drift {
            self.check_feedback(parsed, "drift", at);
        }
        let gains = next.and_then(|next| self.ratios(&rates, &next, name.span));
        let gain = gains.and_then(|gains| {
            self.term(&written.gain, &Expected { what: &what("gain"), shape: Shape::Matrix(width, width), dimensions: &gains })
        });
        if let Some((_, parsed)) = &gain {
            self.check_feedback(parsed, "gain", at);
        }
        let disturbance = self.disturbance(written.disturbance.as_ref(), &rates, &what("disturbance"));
        let noise = match &written.noise {
            Some(noise) => self.noise(at, noise, &own).map(Some),
            None => Some(None),
        };
        Some(PlantBlock { drift: drift?.0, gain: gain?.0, disturbance: disturbance?, noise: noise? })
    }

    fn term(&mut self, formula: &Formula, expected: &Expected<'_>) -> Option<(ExprId, Parsed)> {
        self.formula(formula, expected)
    }

    /// Every quotient of an entry of `above` by one of `below`, row by row.
    fn ratios(&mut self, above: &[Dimension], below: &[Dimension], span: Span) -> Option<Vec<Dimension>> {
        let ratios: Option<Vec<Dimension>> = above.iter().flat_map(|a| below.iter().map(|b| a.checked_div(*b))).collect();
        if ratios.is_none() {
            self.fault("E0606", span, "unit of a state has an exponent out of range", "choose simpler units");
        }
        ratios
    }

    fn disturbance(&mut self, written: Option<&Located<spec::Disturbance>>, rates: &[Dimension], what: &str) -> Option<Disturbance> {
        match written.map(|written| (&written.value, written.span)) {
            None => Some(Disturbance::None),
            Some((spec::Disturbance::Bounded(formula), _)) => {
                let expected = Expected { what, shape: Shape::Vector(rates.len()), dimensions: rates };
                let (id, parsed) = self.formula(formula, &expected)?;
                self.check_signal(&parsed, what);
                Some(Disturbance::Bounded(id))
            }
            Some((spec::Disturbance::Exosystem(channels), span)) => {
                if channels.len() != rates.len() {
                    let message = format!("{what} has {} exosystems, expected {}, one for each channel", channels.len(), rates.len());
                    self.fault("E0503", span, message, "write `{M: [[0]], L: [1]}` for a channel with a constant disturbance");
                    return None;
                }
                let channels: Vec<Option<Exosystem>> = channels.iter().map(|channel| self.exosystem(channel)).collect();
                channels.into_iter().collect::<Option<_>>().map(Disturbance::Exosystem)
            }
        }
    }

    fn exosystem(&mut self, written: &spec::Exosystem) -> Option<Exosystem> {
        let m = self.bare_matrix(&written.m, "M");
        let l = self.bare_matrix(&written.l, "L");
        let n = written.n.as_ref().map(|formula| self.bare_matrix(formula, "N"));
        let initial = written.initial.as_ref().map(|formula| self.bare_matrix(formula, "initial"));
        let (m, l) = (m?, l?);
        let states = m.rows;
        let mut check = |found: &Matrix, (rows, cols): (usize, usize), what: &str, formula: &Formula| {
            let fits = (found.rows, found.cols) == (rows, cols);
            if !fits {
                let message = format!("`{what}` of an exosystem is {} x {}, expected {rows} x {cols}", found.rows, found.cols);
                self.fault("E0503", formula.span(), message, "M is square, N has as many rows, L one row of as many entries");
            }
            fits
        };
        // A list of numbers is a column; for L it stands for a row.
        let l = if l.cols == 1 && l.rows == states { Matrix { rows: 1, cols: states, data: l.data } } else { l };
        let mut fits = check(&m, (states.min(MAX_EXOSYSTEM), states.min(MAX_EXOSYSTEM)), "M", &written.m);
        fits &= check(&l, (1, states), "L", &written.l);
        let n = match (n, &written.n) {
            (Some(n), Some(formula)) => {
                let n = n?;
                fits &= check(&n, (states, n.cols.min(MAX_EXOSYSTEM)), "N", formula);
                n
            }
            _ => Matrix { rows: states, cols: 0, data: Vec::new() },
        };
        let initial = match (initial, &written.initial) {
            (Some(initial), Some(formula)) => {
                let initial = initial?;
                fits &= check(&initial, (states, 1), "initial", formula);
                initial.data
            }
            _ => vec![0.0; states],
        };
        fits.then_some(Exosystem { m, n, l, initial })
    }

    /// A matrix of bare numbers in SI.
    fn bare_matrix(&mut self, formula: &Formula, what: &str) -> Option<Matrix> {
        let numbers = self.numbers(formula)?;
        if let Some(found) = numbers.dimensions.iter().find(|&&found| found != Dimension::ONE) {
            self.fault("E0604", numbers.span, format!("unit mismatch: `{what}` has an entry in {found}, expected bare numbers in SI"), "remove the unit");
            return None;
        }
        Some(numbers.matrix())
    }

    fn noise(&mut self, at: usize, written: &Located<spec::Noise>, own: &[Dimension]) -> Option<Noise> {
        let spec::Noise { effectiveness, intensity } = &written.value;
        let block = &self.spec.blocks[at].name;
        let what = format!("noise effectiveness of block `{}`", block.value);
        let sigma = self.numbers(intensity);
        let parsed = self.parse_formula(effectiveness)?;
        let id = self.elaborate(&parsed, super::scope::Place::Model)?;
        self.check_feedback(&parsed, "noise effectiveness", at);
        let sigma = sigma?;
        let channels = sigma.values.len();
        if let Some(value) = sigma.values.iter().find(|value| **value < 0.0) {
            self.fault("E0601", sigma.span, format!("noise intensity of block `{}` is {value}, expected at least 0", block.value), "write the standard deviation");
            return None;
        }
        let shape = Shape::Matrix(own.len(), channels);
        let rates = self.ratios(own, &[SECOND], block.span)?;
        let densities = self.ratios(own, &[SECOND.checked_sqrt()?], block.span)?;
        // One scaling fits all entries: the noise is either a rate, or a density of white noise.
        let sampled = self.ratios(&rates, &sigma.dimensions, block.span)?;
        let white = self.ratios(&densities, &sigma.dimensions, block.span)?;
        let is_white = crate::expr::expect(&self.arena, id, parsed.span(), &Expected { what: &what, shape, dimensions: &white }).is_ok();
        let dimensions = if is_white { &white } else { &sampled };
        let effectiveness = self.expect(id, parsed.span(), &Expected { what: &what, shape, dimensions })?;
        Some(Noise { effectiveness, intensity: sigma.values })
    }

    /// Checks the reference: one function of time for each output.
    pub(super) fn check_reference(&mut self) -> Option<ExprId> {
        let spec = self.spec;
        let Named { name: block, value: output } = &spec.blocks[0];
        let mut entries: Vec<Option<ExprId>> = Vec::new();
        for (channel, state) in output.states.iter().enumerate() {
            let name = &state.name.value;
            let Some(signal) = spec.reference.value.iter().find(|signal| signal.name.value == *name) else {
                let message = format!("reference of output `{name}` is missing");
                self.fault("E0115", spec.reference.span, message, format!("add `{name}: ..`, a function of `t`"));
                entries.push(None);
                continue;
            };
            let dimension = self.states[0].as_ref().map(|states| states[channel].dimension);
            entries.push(dimension.and_then(|dimension| self.reference_of(name, &signal.value, dimension)));
        }
        for signal in &spec.reference.value {
            if !output.states.iter().any(|state| state.name.value == signal.name.value) {
                let names: Vec<&str> = output.states.iter().map(|state| state.name.value.as_str()).collect();
                let message = format!("reference of `{}`, which is no state of the output block `{}`", signal.name.value, block.value);
                self.fault("E0115", signal.name.span, message, format!("the outputs are `{}`", names.join("`, `")));
            }
        }
        let entries: Option<Vec<ExprId>> = entries.into_iter().collect();
        entries.map(|entries| self.array(entries, Shape::Vector(output.states.len())))
    }

    fn reference_of(&mut self, name: &str, formula: &Formula, dimension: Dimension) -> Option<ExprId> {
        let what = format!("reference of `{name}`");
        let (id, parsed) = self.formula(formula, &Expected { what: &what, shape: Shape::Scalar, dimensions: &[dimension] })?;
        self.check_signal(&parsed, &what);
        Some(id)
    }
}
