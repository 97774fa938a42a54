//! Numbers of about 106 bits as an unevaluated sum of two `f64`, so that `2.54 cm` is the double nearest to 0.0254 m
//! although neither a centimetre nor pi/180 is a double.

/// `high + low` with `high` the double nearest to the sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Double {
    pub(super) high: f64,
    pub(super) low: f64,
}

impl Double {
    pub(super) const ONE: Self = Self {
        high: 1.0,
        low: 0.0,
    };
    /// pi to 107 bits.
    pub(super) const PI: Self = Self {
        high: std::f64::consts::PI,
        low: 1.2246467991473532e-16,
    };

    /// An integer, exactly.
    pub(super) fn integer(value: u64) -> Self {
        let high = value as f64;
        let low = (i128::from(value) - high as i128) as f64;
        Self { high, low }
    }

    /// 10^exponent; exact from 0 to 45.
    pub(super) fn ten(exponent: i32) -> Self {
        Self::integer(10).powi(exponent)
    }

    pub(super) fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let rest = libm::fma(self.high, other.high, -product);
        Self::renormalised(
            product,
            rest + (self.high * other.low + self.low * other.high),
        )
    }

    pub(super) fn div(self, other: Self) -> Self {
        // Long division with three digits of 53 bits each; the last one only rounds.
        let first = self.high / other.high;
        let rest = self.sub(other.scale(first));
        let second = rest.high / other.high;
        let rest = rest.sub(other.scale(second));
        let third = rest.high / other.high;
        let sum = Self::renormalised(first, second);
        Self::renormalised(sum.high, sum.low + third)
    }

    /// Square root of a positive number: one Newton step from the root of the leading part.
    pub(super) fn sqrt(self) -> Self {
        let root = libm::sqrt(self.high);
        let square = Self {
            high: root,
            low: 0.0,
        }
        .scale(root);
        Self::renormalised(root, self.sub(square).high / (2.0 * root))
    }

    pub(super) fn powi(self, exponent: i32) -> Self {
        let mut power = Self::ONE;
        for bit in (0..32).rev() {
            power = power.mul(power);
            if exponent.unsigned_abs() >> bit & 1 == 1 {
                power = power.mul(self);
            }
        }
        if exponent < 0 {
            Self::ONE.div(power)
        } else {
            power
        }
    }

    fn scale(self, factor: f64) -> Self {
        self.mul(Self {
            high: factor,
            low: 0.0,
        })
    }

    fn sub(self, other: Self) -> Self {
        let sum = self.high - other.high;
        let part = sum - self.high;
        let rest = (self.high - (sum - part)) - (other.high + part);
        Self::renormalised(sum, rest + (self.low - other.low))
    }

    /// The same sum for `low` smaller than `high`.
    fn renormalised(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_power_of_ten_is_the_nearest_double() {
        for exponent in -40..=45 {
            let written: f64 = format!("1e{exponent}").parse().unwrap();
            assert_eq!(Double::ten(exponent).high, written, "10^{exponent}");
        }
    }

    #[test]
    fn quotients_and_roots_round_to_the_nearest_double() {
        for numerator in 1..200_u64 {
            for denominator in 1..200_u64 {
                let quotient = Double::integer(numerator).div(Double::integer(denominator));
                assert_eq!(quotient.high, numerator as f64 / denominator as f64);
                let back = quotient.mul(Double::integer(denominator));
                assert_eq!(
                    (back.high, back.low.abs() < 1e-27),
                    (numerator as f64, true)
                );
            }
            let root = Double::integer(numerator).sqrt();
            assert_eq!(root.high, libm::sqrt(numerator as f64));
            assert!((root.mul(root).sub(Double::integer(numerator)).high).abs() < 1e-28);
        }
    }
}
