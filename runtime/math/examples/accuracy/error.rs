//! Errors in units of the last place.

/// The largest error found.
pub struct Worst<const N: usize> {
    /// In units of the last place.
    pub error: f64,
    /// Results that are not the nearest number.
    pub missed: u64,
    /// Where it was found.
    pub arguments: [f64; N],
}

impl<const N: usize> Worst<N> {
    /// None yet.
    pub fn new() -> Self {
        Self {
            error: 0.0,
            missed: 0,
            arguments: [0.0; N],
        }
    }

    /// The arguments, shortest digits that name them.
    pub fn place(&self) -> String {
        let digits = self.arguments.map(|x| format!("{x:e}"));
        digits.join(", ")
    }

    fn add(&mut self, arguments: [f64; N], error: f64) {
        self.missed += 1;
        if error > self.error {
            (self.error, self.arguments) = (error, arguments);
        }
    }

    /// A result in single precision. The exact value is asked for only where the nearest number is missed.
    pub fn single(
        &mut self,
        arguments: [f64; N],
        [ours, nearest]: [f32; 2],
        exact: impl Fn() -> f64,
    ) {
        if same(ours.into(), nearest.into()) {
            return;
        }
        let exact = exact();
        // Infinity stands for the number after the largest.
        let finite = |value: f64| value.clamp(-(2_f64.powi(128)), 2_f64.powi(128));
        let exponent = (exact.abs().to_bits() >> 52) as i32 - 1023;
        let place = 2_f64.powi(exponent.clamp(-126, 127) - 23);
        let error = (finite(ours.into()) - finite(exact)).abs() / place;
        self.add(
            arguments,
            if error.is_nan() { f64::INFINITY } else { error },
        );
    }

    /// A result in double precision, ours and the nearest number.
    pub fn double(&mut self, arguments: [f64; N], [ours, nearest]: [f64; 2]) {
        if same(ours, nearest) {
            return;
        }
        let unknown = ours.is_nan() || nearest.is_nan() || nearest == 0.0 && ours == 0.0;
        let places = ordinal(ours).abs_diff(ordinal(nearest)) as f64;
        self.add(arguments, if unknown { f64::INFINITY } else { places });
    }
}

/// Equal, signs of zeros too; any NaN is any other.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Numbers in their order, as consecutive integers.
fn ordinal(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    if bits < 0 { i64::MIN - bits } else { bits }
}
