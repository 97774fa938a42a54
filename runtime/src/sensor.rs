//! What happens to a state on its way to the controller: bias, noise, rounding, lost samples.

use crate::noise::Noise;
use crate::quantum::to_multiple;
use crate::real::Real;

/// A sensor; what it lacks is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// Standard deviation of the normal error of a sample.
    pub noise: f64,
    /// Measurements are multiples of it.
    pub quantum: f64,
    /// Probability that a sample is lost.
    pub dropout: f64,
}

/// The draws of a sensor at a sample.
#[derive(Clone, Copy, Debug)]
pub struct Draws<T> {
    /// Standard normal.
    pub normal: T,
    /// Uniform between 0 and 1.
    pub uniform: T,
}

impl<T: Real> Draws<T> {
    /// Those of a sensor without errors.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            normal: T::zero(),
            uniform: T::one(),
        }
    }

    /// Those of all sensors, none without errors: for sensor i channel i of the noise.
    #[inline(always)]
    pub fn of_all<const N: usize>(errors: &Option<Noise<T>>, sample: u64) -> [Self; N] {
        let mut draws = [Self::none(); N];
        if let Some(errors) = errors {
            let normals = errors.normals::<N>(sample);
            let mut i = 0;
            while i < N {
                draws[i] = Self {
                    normal: normals[i],
                    uniform: errors.uniform(sample, i as u32),
                };
                i += 1;
            }
        }
        draws
    }
}

impl Sensor {
    /// The measurement of a value; the last one again if the sample is lost.
    #[inline(always)]
    pub fn measure<T: Real>(&self, value: T, bias: T, draws: Draws<T>, last: T) -> T {
        let mut measured = value + bias;
        if self.noise > 0.0 {
            measured = measured + draws.normal * T::from_f64(self.noise);
        }
        if self.quantum > 0.0 {
            measured = to_multiple(measured, self.quantum);
        }
        if self.dropout > 0.0 {
            let lost = draws.uniform.lt(T::from_f64(self.dropout));
            measured = T::select(lost, last, measured);
        }
        measured
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_measurement_has_bias_and_noise_and_is_a_multiple() {
        let sensor = Sensor {
            noise: 0.1,
            quantum: 0.25,
            dropout: 0.0,
        };
        let draws = Draws {
            normal: 2.0,
            uniform: 0.0,
        };
        // 1 + 0.5 + 0.1 * 2 = 1.7
        assert_eq!(sensor.measure(1.0, 0.5, draws, 9.0), 1.75);
    }

    #[test]
    fn a_lost_sample_gives_the_last_one_again() {
        let sensor = Sensor {
            noise: 0.0,
            quantum: 0.0,
            dropout: 0.25,
        };
        let at = |uniform| Draws {
            normal: 0.0,
            uniform,
        };
        assert_eq!(sensor.measure(1.0, 0.0, at(0.2), 9.0), 9.0);
        assert_eq!(sensor.measure(1.0, 0.0, at(0.3), 9.0), 1.0);
        assert_eq!(sensor.measure(1.0, 0.0, Draws::none(), 9.0), 1.0);
    }

    #[test]
    fn each_sensor_draws_from_its_channel() {
        let noise = Noise::<f64>::sensor(3, 7);
        let draws = Draws::of_all::<3>(&Some(noise), 11);
        for (channel, draws) in (0..).zip(draws) {
            assert_eq!(draws.normal, noise.normal(11, channel));
            assert_eq!(draws.uniform, noise.uniform(11, channel));
        }
        let [draws] = Draws::<f64>::of_all(&None, 11);
        assert_eq!((draws.normal, draws.uniform), (0.0, 1.0));
    }
}
