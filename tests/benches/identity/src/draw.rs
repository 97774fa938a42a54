//! Random numbers one after another.

use nsv_runtime::noise::Noise;

/// The draws of one point or run.
pub struct Draw {
    noise: Noise<f64>,
    step: u64,
}

impl Draw {
    /// Draws that depend on seed and index alone.
    pub fn new(seed: u64, index: u64) -> Self {
        Draw { noise: Noise::process(seed, index), step: 0 }
    }

    /// Uniform between 0 and 1.
    pub fn uniform(&mut self) -> f64 {
        self.step += 1;
        self.noise.uniform(self.step, 0)
    }

    /// Standard normal.
    pub fn normal(&mut self) -> f64 {
        self.step += 1;
        self.noise.normal(self.step, 0)
    }

    /// True as often as this.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }

    /// Less than `n`.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.uniform() * n as f64) as usize).min(n - 1)
    }

    /// One of several.
    pub fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// -1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { -1.0 } else { 1.0 }
    }
}
