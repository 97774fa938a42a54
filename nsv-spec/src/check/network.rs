//! Guarantees that a network is small enough to run, and sees only the states that its block may depend on.

use super::Context;
use super::scope::Place;
use crate::diagnostic::{Rule, Span, counted};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Node, Shape};
use crate::model::{Basis, Network};
use crate::spec::{self, Formula, Located};
use crate::unit::Dimension;

/// Most basis functions of a network.
pub(super) const MAX_NODES: u128 = 2000;
/// Number of nodes from which on a message does not tell it.
const COUNTABLE: u128 = 1_000_000;

/// Number of basis functions; saturates, so that no order and no number of inputs is too large to ask.
fn node_count(basis: Basis, inputs: usize, order: u64) -> u128 {
    let (inputs, order) = (inputs as u128, u128::from(order));
    match basis {
        // 1, powers of each input, and products z_i^a z_j^b with a, b >= 1 and a + b <= order
        Basis::Pairwise => {
            let pairs = inputs * inputs.saturating_sub(1) / 2;
            let products = order.saturating_mul(order.saturating_sub(1)) / 2;
            pairs
                .saturating_mul(products)
                .saturating_add(inputs.saturating_mul(order))
                .saturating_add(1)
        }
        // C(inputs + order, inputs), one factor at a time; each partial product is a binomial coefficient itself
        Basis::Complete => {
            let mut factors = 1..=inputs;
            let grown = factors.try_fold(1_u128, |count, factor| {
                let product = count.checked_mul(order.checked_add(factor)?)?;
                Some(product / factor)
            });
            grown.unwrap_or(u128::MAX)
        }
    }
}

/// The largest order whose network is small enough; 0 if none is.
fn largest_order(basis: Basis, inputs: usize) -> u64 {
    let fits = |order: &u64| node_count(basis, inputs, *order) <= MAX_NODES;
    // With one input an order has one node more than the one before.
    (1..=MAX_NODES as u64).take_while(fits).last().unwrap_or(0)
}

impl Context<'_> {
    /// Checks the network of a block.
    pub(super) fn network(
        &mut self,
        at: usize,
        written: &Located<spec::Network>,
    ) -> Option<Network> {
        let block = &self.spec.blocks[at].name.value;
        let Located {
            value: network,
            span,
        } = written;
        let what = |key: &str| format!("`network.{key}` of block `{block}`");
        let basis = network
            .basis
            .ok()?
            .map(|basis| basis.value)
            .unwrap_or_else(|| {
                self.default(
                    format!("controller.blocks.{block}.network.basis"),
                    "pairwise",
                    "the paper's",
                );
                Basis::Pairwise
            });
        let order = self.order(network, basis, *span);
        let inputs = self.network_inputs(at, network);
        let scale = inputs
            .as_ref()
            .and_then(|inputs| self.scale(network.scale.as_ref(), inputs, block));
        let iota = self.channel_gains(&network.iota, &what("iota"), Dimension::ONE);
        let gamma = self.positive_gain(&network.gamma, &what("Gamma"), Dimension::ONE);
        let lambda = self.positive_gain(&network.lambda, &what("lambda"), Dimension::ONE);
        let inputs: Vec<ExprId> = inputs?.into_iter().map(|(id, _)| id).collect();
        let input_names = self.input_names(&inputs);
        Some(Network {
            order: order?,
            basis,
            inputs,
            input_names,
            scale: scale?,
            iota: iota?,
            gamma: gamma?,
            lambda: lambda?,
        })
    }

    fn order(&mut self, network: &spec::Network, basis: Basis, span: Span) -> Option<u32> {
        let (order, inputs) = (network.order.ok()?, network.inputs.as_ref().ok()?.len());
        if inputs == 0 {
            self.fault(
                Rule::E0609,
                span,
                "network has no inputs, expected at least one",
                "list states of this and outer blocks",
            );
            return None;
        }
        if order.value == 0 {
            self.fault(
                Rule::E0609,
                order.span,
                "order of the network is 0, expected at least 1",
                "a network of order 0 knows a constant only, which the observer estimates",
            );
            return None;
        }
        let nodes = node_count(basis, inputs, order.value);
        if nodes > MAX_NODES {
            let most = largest_order(basis, inputs);
            let inputs = counted(inputs, "input");
            let nodes = match nodes {
                ..COUNTABLE => nodes.to_string(),
                _ => format!("more than {COUNTABLE}"),
            };
            let message = format!(
                "network of order {} with {inputs} has {nodes} nodes, expected at most {MAX_NODES}",
                order.value
            );
            let help = match most {
                0 => "drop inputs: so many are too many for any order".to_owned(),
                _ => format!("with {inputs} the order may be {most} at most; 2 to 4 is usual"),
            };
            self.fault(Rule::E0609, order.span, message, help);
            return None;
        }
        u32::try_from(order.value).ok()
    }

    fn network_inputs(
        &mut self,
        at: usize,
        network: &spec::Network,
    ) -> Option<Vec<(ExprId, Dimension)>> {
        let inputs = network.inputs.as_ref().ok()?.iter();
        let inputs: Vec<_> = inputs.map(|input| self.network_input(at, input)).collect();
        inputs.into_iter().collect()
    }

    fn network_input(&mut self, at: usize, formula: &Formula) -> Option<(ExprId, Dimension)> {
        let parsed = self.parse_formula(formula)?;
        let id = self.elaborate(&parsed, Place::Model)?;
        self.check_feedback(&parsed, "network input", at);
        let dimension = self.arena.ty(id).dimension().unwrap_or(Dimension::ONE);
        let what = format!(
            "network input of block `{}`",
            self.spec.blocks[at].name.value
        );
        let id = self.expect(
            id,
            &parsed,
            &Expected {
                what: &what,
                shape: Shape::Scalar,
                dimensions: &[dimension],
                reasons: &[],
                columns: &[],
            },
        )?;
        Some((id, dimension))
    }

    /// Divisors of the inputs, in the inputs' units or bare in SI.
    fn scale(
        &mut self,
        written: Option<&Formula>,
        inputs: &[(ExprId, Dimension)],
        block: &str,
    ) -> Option<Vec<f64>> {
        let Some(formula) = written else {
            self.default(
                format!("controller.blocks.{block}.network.scale"),
                "1",
                "inputs in SI",
            );
            return Some(vec![1.0; inputs.len()]);
        };
        let what = format!("`network.scale` of block `{block}`");
        let numbers = self.numbers_for(formula, &what)?;
        let (values, dimensions) = match numbers.shape {
            Shape::Scalar => (
                vec![numbers.values[0]; inputs.len()],
                vec![numbers.dimensions[0]; inputs.len()],
            ),
            Shape::Vector(rows) if rows == inputs.len() => (numbers.values, numbers.dimensions),
            shape => {
                let expected = match inputs.len() {
                    1 => "one number, as there is one input".to_owned(),
                    count => format!("a scalar or a vector of {count}"),
                };
                let message = format!("{what} is {shape}, expected {expected}");
                self.fault(
                    Rule::E0605,
                    numbers.span,
                    message,
                    "write one number for each input",
                );
                return None;
            }
        };
        for (at, (&value, (_, dimension))) in values.iter().zip(inputs).enumerate() {
            let place = numbers.places.get(at).copied().unwrap_or(numbers.span);
            self.check_gain_unit(dimensions[at], place, &what, *dimension)?;
            self.positive(value, place, &what)?;
        }
        Some(values)
    }

    /// A state is known by its name, anything else by its number.
    fn input_names(&self, inputs: &[ExprId]) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for (at, &id) in inputs.iter().enumerate() {
            let name = match *self.arena.node(id) {
                Node::State { block, channel } => Some(
                    self.spec.blocks[block].value.states[channel]
                        .name
                        .value
                        .clone(),
                ),
                Node::Definition(definition) => {
                    Some(self.definitions[definition.0 as usize].name.clone())
                }
                _ => None,
            };
            let fresh = name.filter(|name| !names.contains(name));
            names.push(fresh.unwrap_or_else(|| format!("z{}", at + 1)));
        }
        names
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_counted_as_in_the_paper() {
        assert_eq!(node_count(Basis::Pairwise, 3, 3), 19);
        assert_eq!(node_count(Basis::Complete, 3, 3), 20);
        assert_eq!(node_count(Basis::Pairwise, 1, 5), 6);
        assert_eq!(node_count(Basis::Complete, 1, 5), 6);
        assert_eq!(node_count(Basis::Pairwise, 12, 30), 1 + 12 * 30 + 66 * 435);
    }

    #[test]
    fn the_largest_order_is_the_last_that_fits() {
        assert_eq!(largest_order(Basis::Pairwise, 1), 1999);
        assert_eq!(largest_order(Basis::Pairwise, 2), 61);
        assert_eq!(largest_order(Basis::Complete, 2), 61);
        assert_eq!(largest_order(Basis::Pairwise, 4000), 0);
    }

    #[test]
    fn no_network_is_too_large_to_count() {
        for basis in [Basis::Pairwise, Basis::Complete] {
            assert!(node_count(basis, usize::MAX, u64::MAX) > MAX_NODES);
            assert!(node_count(basis, 12, 30) > MAX_NODES);
        }
    }
}
