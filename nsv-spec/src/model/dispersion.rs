//! What differs from run to run.

/// Distribution of a quantity that differs from run to run; numbers in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Dispersion {
    /// Uniform between two values.
    Uniform(f64, f64),
    /// Normal with mean and standard deviation.
    Normal(f64, f64),
    /// Normal within an interval.
    TruncatedNormal(Truncated),
    /// Its logarithm is normal.
    Lognormal {
        /// Median, positive.
        median: f64,
        /// Standard deviation of the logarithm.
        sigma: f64,
    },
    /// Values with their probabilities, which add up to 1.
    Discrete(Vec<(f64, f64)>),
    /// Normal together with other parameters: the mean plus the sum of factors times a standard normal draw of each parameter.
    Correlated {
        /// Mean.
        mean: f64,
        /// Index into `Model::parameters` and factor: a row of the covariance's Cholesky factor.
        factors: Vec<(usize, f64)>,
    },
}

/// A normal distribution cut off at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truncated {
    /// Mean before truncation.
    pub mean: f64,
    /// Standard deviation before truncation, positive.
    pub deviation: f64,
    /// Least value.
    pub least: f64,
    /// Largest value.
    pub largest: f64,
    /// Probabilities of less than `least` and of less than `largest` before truncation.
    pub quantiles: (f64, f64),
}

impl Dispersion {
    /// The value where nothing is dispersed: the middle of the distribution, of a discrete one the most probable value.
    pub fn nominal(&self) -> f64 {
        match self {
            Dispersion::Uniform(least, largest) => 0.5 * (least + largest),
            Dispersion::Normal(mean, _) | Dispersion::Correlated { mean, .. } => *mean,
            Dispersion::TruncatedNormal(cut) => cut.mean.clamp(cut.least, cut.largest),
            Dispersion::Lognormal { median, .. } => *median,
            Dispersion::Discrete(values) => {
                let first = values[0];
                let likelier = |best: (f64, f64), &one: &(f64, f64)| {
                    if one.1 > best.1 { one } else { best }
                };
                values.iter().fold(first, likelier).0
            }
        }
    }
}
