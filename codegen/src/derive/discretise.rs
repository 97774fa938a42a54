//! The controller as a sampled system: each state one sample later.
//!
//! A state with z' = -A z + r(t), A constant, advances by z+ = z + g(A) z', g(A) = A^-1 (I - exp(-A dt)): exact for held r, so no
//! sample time makes the leak unstable. Explicit Euler is the same line with g = dt. phi (68) advances by the exponential of its
//! own decay and is held at its floor (E10, E11).

use nsv_spec::model::{Disturbance, Integration, Matrix, Network, NoiseBound, PhiFloor};

use super::law::Law;
use super::observer::{assemble, closed_observer, compound_rate, rate_equation};
use super::symbol::{Symbol, diagonal_of, name, number, vector};
use crate::ir::Function;

impl Law<'_> {
    /// `<state>_next` of every controller state.
    pub(super) fn define_next_states(&mut self) {
        for (i, block) in (1..).zip(&self.model.blocks) {
            self.group(format!("states of block {i}, one sample later"));
            self.advance(format!("zeta{i}"), &block.c, &format!("C_{i}"), "(13)");
            if let (Some(filter), true) = (&block.filter, self.contains(&format!("h{i}_dot"))) {
                let leak: Vec<f64> = filter.iter().map(|constant| 1.0 / constant).collect();
                self.advance(
                    format!("h{i}"),
                    &diagonal_matrix(&leak),
                    &format!("1/Fl_{i}"),
                    "(33)",
                );
            }
            if let Some(s) = &block.observer {
                let (leak, symbol) = match &block.disturbance {
                    Disturbance::Exosystem(channels) => (
                        negate(&closed_observer(s, &assemble(channels))),
                        format!("S_{i} L_{i} - M_{i}"),
                    ),
                    _ => (s.clone(), format!("S_{i}")),
                };
                // The rate of a compound observer is taken together with its step.
                let law = match block.disturbance {
                    Disturbance::Exosystem(_) => rate_equation(block).to_owned(),
                    _ => format!(
                        "{}: {}",
                        rate_equation(block),
                        compound_rate(i, i == self.order())
                    ),
                };
                self.advance(format!("th{i}"), &leak, &symbol, &law);
            }
            if let Some(network) = &block.network {
                self.advance_weights(i, network);
            }
            if let Some(bound) = &block.error_bound {
                self.advance_scalar(format!("eps{i}"), bound.rate, &format!("iota_{i}0"), "(66)");
            }
            if let Some(bound) = &block.noise_bound {
                let symbol = format!("taubar_{i} lambda_sigma");
                self.advance_scalar(
                    format!("sigma{i}"),
                    bound.tau * bound.lambda,
                    &symbol,
                    "(67)",
                );
                self.advance_compensation(i, bound);
            }
        }
    }

    /// z+ = z + g(A) z' with a matrix leak A.
    fn advance(&mut self, state: String, leak: &Matrix, symbol: &str, equation: &str) {
        let dt = self.model.controller.sample_time;
        let step = match self.model.controller.integration {
            Integration::Euler => diagonal_matrix(&vec![dt; leak.rows]),
            Integration::Exponential => exponential_step(leak, dt),
        };
        let rate = name(format!("{state}_dot"));
        let text = format!("g({symbol})");
        let mut increment = self.gain(format!("{state}_weight"), &text, &step, rate);
        // A matrix becomes many numbers, far from the line of its state: they have a name and their equation.
        if diagonal_of(&step).is_none() {
            let text = format!("g {state}', {}  {equation}", self.weight(symbol));
            increment = self.define(format!("{state}_step"), text, increment);
        }
        self.define_next(&state, increment, symbol, equation);
    }

    /// z+ = z + g(a) z' with a scalar leak a.
    fn advance_scalar(&mut self, state: String, leak: f64, symbol: &str, equation: &str) {
        let increment = number(self.scalar_step(leak)) * name(format!("{state}_dot"));
        self.define_next(&state, increment, symbol, equation);
    }

    /// W+ = W + g W', with the leak taken together: a product, a product and a sum for each weight.
    fn advance_weights(&mut self, i: usize, network: &Network) {
        let leak = network.gamma * network.lambda;
        let step = self.scalar_step(leak);
        let drive: Vec<f64> = network
            .iota
            .iter()
            .map(|iota| step * network.gamma * iota)
            .collect();
        let (p, c, w) = (
            name(format!("P{i}")),
            name(format!("c{i}")),
            name(format!("W{i}")),
        );
        let next = number(1.0 - step * leak) * w + p.outer(vector(&drive) * c);
        let text = format!(
            "W_{i}(t + dt) = (1 - g Gamma_{i} lambda_{i}) W_{i} + g Gamma_{i} P_{i} c_{i} I_{i}, {}  {}: W_{i}' = Gamma_{i} (P_{i} c_{i} I_{i} - lambda_{i} W_{i})",
            self.weight(&format!("Gamma_{i} lambda_{i}")),
            if i < self.order() { "(32)" } else { "(65)" }
        );
        self.define(format!("W{i}_next"), text, next);
    }

    /// g of a scalar leak.
    fn scalar_step(&self, leak: f64) -> f64 {
        let dt = self.model.controller.sample_time;
        match self.model.controller.integration {
            Integration::Euler => dt,
            Integration::Exponential => exponential_step(&diagonal_matrix(&[leak]), dt).data[0],
        }
    }

    fn define_next(&mut self, state: &str, increment: Symbol, leak: &str, equation: &str) {
        let weight = self.weight(leak);
        self.define(
            format!("{state}_next"),
            format!("{state}(t + dt) = {state} + g {state}', {weight}  {equation}"),
            name(state) + increment,
        );
    }

    /// What g is, in words and symbols.
    fn weight(&self, leak: &str) -> String {
        match self.model.controller.integration {
            Integration::Euler => "g = dt".to_string(),
            Integration::Exponential => {
                format!("g = (1 - exp(-a dt))/a, a = {leak}")
            }
        }
    }

    /// phi+ = max(phi exp(-dt (Psi/(phi^2 + s^2) + kappa)), phi_min) while ||e|| >= iota_phi.
    fn advance_compensation(&mut self, i: usize, bound: &NoiseBound) {
        let dt = self.model.controller.sample_time;
        let phi = name(format!("phi{i}"));
        let decayed =
            phi.clone() * (-(number(dt) * name(format!("phi{i}_decay")))).apply(Function::Exp);
        let next = self.phi_active(i, bound.phi_threshold).select(decayed, phi);
        let (floor, text) = match bound.phi_min {
            PhiFloor::Auto => {
                let floor = (name(format!("Psi{i}")) * number(dt / 0.1)).apply(Function::Sqrt);
                (
                    floor,
                    format!("phi_min = sqrt(Psi_{i} dt / 0.1), erratum 11"),
                )
            }
            PhiFloor::Value(value) => (number(value), "phi_min, declared, erratum 11".to_string()),
        };
        let floor = self.define(format!("phi{i}_min"), text, floor);
        let text = format!(
            "phi_{i}(t + dt) = phi_{i} exp(-dt (Psi_{i}/(phi_{i}^2 + s_{i}^2) + kappa_phi)) if ||e_{i}|| >= iota_phi, else phi_{i}; at least phi_min  (68), erratum 11"
        );
        self.define(format!("phi{i}_next"), text, next.max(floor));
    }
}

fn diagonal_matrix(values: &[f64]) -> Matrix {
    let rows = values.len();
    let mut data = vec![0.0; rows * rows];
    for (at, value) in values.iter().enumerate() {
        data[at * rows + at] = *value;
    }
    Matrix {
        rows,
        cols: rows,
        data,
    }
}

fn negate(a: &Matrix) -> Matrix {
    Matrix {
        data: a.data.iter().map(|value| -value).collect(),
        ..a.clone()
    }
}

/// g(A) = integral over dt of exp(-A s) ds. On an interval short enough that ||A|| h <= 1/2 it is the power series
/// h (I - A h/2! + (A h)^2/3! - ..); doubling the interval uses g(2h) = g(h) (2 I - A g(h)).
/// Products and sums only, so that every machine gets the same bits; 18 terms leave less than 2^-70.
fn exponential_step(a: &Matrix, dt: f64) -> Matrix {
    let n = a.rows;
    let norm = (0..n)
        .map(|row| {
            a.data[row * n..(row + 1) * n]
                .iter()
                .map(|value| value.abs())
                .sum::<f64>()
        })
        .fold(0.0, f64::max);
    let mut doublings = 0;
    let mut h = dt;
    while norm * h > 0.5 {
        h /= 2.0;
        doublings += 1;
    }
    let multiply = |a: &[f64], b: &[f64]| -> Vec<f64> {
        let entry = |at: usize| (0..n).map(|k| a[at / n * n + k] * b[k * n + at % n]).sum();
        (0..n * n).map(entry).collect()
    };
    let identity = diagonal_matrix(&vec![1.0; n]).data;
    // Horner from the last term: I - A h/2 (I - A h/3 (I - ...)).
    let mut sum = identity.clone();
    for term in (2..=18).rev() {
        let factor: Vec<f64> = a
            .data
            .iter()
            .map(|value| value * h / f64::from(term))
            .collect();
        let inner = multiply(&factor, &sum);
        sum = identity
            .iter()
            .zip(&inner)
            .map(|(one, inner)| one - inner)
            .collect();
    }
    let mut gamma: Vec<f64> = sum.iter().map(|value| value * h).collect();
    for _ in 0..doublings {
        let decay = multiply(&a.data, &gamma);
        let twice: Vec<f64> = identity
            .iter()
            .zip(&decay)
            .map(|(one, decay)| 2.0 * one - decay)
            .collect();
        gamma = multiply(&gamma, &twice);
    }
    Matrix {
        rows: n,
        cols: n,
        data: gamma,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gamma of a scalar leak is (1 - exp(-a dt))/a.
    #[test]
    fn scalar_step_is_the_closed_form() {
        for (a, dt) in [
            (20.0, 0.002),
            (1e-9, 0.1),
            (0.0, 0.5),
            (5000.0, 0.01),
            (-3.0, 0.1),
        ] {
            let gamma = exponential_step(&diagonal_matrix(&[a]), dt).data[0];
            let exact = if a == 0.0 {
                dt
            } else {
                -f64::exp_m1(-a * dt) / a
            };
            assert!(
                (gamma - exact).abs() <= 1e-14 * exact.abs(),
                "{a} {dt}: {gamma} {exact}"
            );
        }
    }

    /// For a rotation generator [[0, w], [-w, 0]] the integral of exp(-A s) is [[sin, -(1-cos)], [1-cos, sin]]/w.
    #[test]
    fn rotation_step_is_the_closed_form() {
        let (w, dt) = (3.0, 0.7);
        let a = Matrix {
            rows: 2,
            cols: 2,
            data: vec![0.0, w, -w, 0.0],
        };
        let gamma = exponential_step(&a, dt).data;
        let (sin, cos) = (w * dt).sin_cos();
        let exact = [sin / w, -(1.0 - cos) / w, (1.0 - cos) / w, sin / w];
        for (gamma, exact) in gamma.iter().zip(exact) {
            assert!((gamma - exact).abs() < 1e-14, "{gamma} {exact}");
        }
    }
}
