//! Confidence in counts.

/// Two-sided Clopper-Pearson interval of a probability after `successes` in `trials`: it covers the true value with at least the given
/// confidence. (0, 1) without trials.
///
/// The lower end p solves `P(X >= successes) = (1 - confidence) / 2` for X binomial, a regularised incomplete beta function of p; the upper
/// end is the lower end for failures, mirrored.
pub fn clopper_pearson(successes: u64, trials: u64, confidence: f64) -> (f64, f64) {
    let tail = 0.5 * (1.0 - confidence);
    let failures = trials - successes.min(trials);
    (
        lower_end(successes, failures, tail),
        1.0 - lower_end(failures, successes, tail),
    )
}

/// The p with `I_p(successes, failures + 1) = tail`, by bisection down to neighbouring floats.
fn lower_end(successes: u64, failures: u64, tail: f64) -> f64 {
    if successes == 0 {
        return 0.0;
    }
    let (a, b) = (successes as f64, failures as f64 + 1.0);
    let (mut below, mut above) = (0.0, 1.0);
    loop {
        let middle = 0.5 * (below + above);
        if middle <= below || middle >= above {
            return middle;
        }
        if incomplete_beta(a, b, middle) < tail {
            below = middle;
        } else {
            above = middle;
        }
    }
}

/// Regularised incomplete beta function `I_x(a, b)` for a, b > 0 and 0 < x < 1, from the continued fraction on the side of the mean where
/// it converges fast.
fn incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    let front = log_front(a, b, x).exp();
    if x < (a + 1.0) / (a + b + 2.0) {
        front * beta_fraction(a, b, x) / a
    } else {
        1.0 - front * beta_fraction(b, a, 1.0 - x) / b
    }
}

/// `ln(x^a (1 - x)^b / B(a, b))`. Gamma functions of large numbers would cancel; here their leading terms have cancelled on paper (Loader,
/// *Fast and accurate computation of binomial probabilities*, 2000): with n = a + b and the mean a / n,
/// `a ln(n x / a) + b ln(n (1 - x) / b) + ln(a b / (2 pi n)) / 2 + s(n) - s(a) - s(b)`.
fn log_front(a: f64, b: f64, x: f64) -> f64 {
    let n = a + b;
    let above_mean = n * x - a;
    let deviance = a * (above_mean / a).ln_1p() + b * (-above_mean / b).ln_1p();
    let width = 0.5 * (a / (std::f64::consts::TAU * n) * b).ln();
    deviance + width + stirling_error(n) - stirling_error(a) - stirling_error(b)
}

/// What Stirling's formula leaves of the gamma function: `s(x) = ln gamma(x) - ((x - 1/2) ln x - x + ln(2 pi) / 2)`, to 1e-13; by its series
/// from 16 on, and below by `s(x) = s(x + 1) + (x + 1/2) ln(1 + 1/x) - 1`.
fn stirling_error(x: f64) -> f64 {
    let (mut x, mut error) = (x, 0.0);
    while x < 16.0 {
        error += (x + 0.5) * (1.0 / x).ln_1p() - 1.0;
        x += 1.0;
    }
    let square = x * x;
    let series = 1.0 / 12.0
        - (1.0 / 360.0 - (1.0 / 1260.0 - (1.0 / 1680.0 - 1.0 / 1188.0 / square) / square) / square)
            / square;
    error + series / x
}

/// Continued fraction `1 / (1 + d_1 / (1 + d_2 / (1 + ...)))` of the incomplete beta function by Lentz's method, with
/// `d_2m = m (b - m) x / ((a + 2m - 1) (a + 2m))`, `d_2m+1 = -(a + m) (a + b + m) x / ((a + 2m) (a + 2m + 1))`. It takes about
/// `sqrt(max(a, b))` terms.
fn beta_fraction(a: f64, b: f64, x: f64) -> f64 {
    const TERMS: u32 = 1_000_000;
    let away_from_zero = |value: f64| if value.abs() < 1e-300 { 1e-300 } else { value };
    let mut numerator = 1.0;
    let mut denominator = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
    let mut fraction = denominator;
    for m in (1..TERMS).map(f64::from) {
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let before = fraction;
        for term in [even, odd] {
            numerator = away_from_zero(1.0 + term / numerator);
            denominator = 1.0 / away_from_zero(1.0 + term * denominator);
            fraction *= numerator * denominator;
        }
        if (fraction - before).abs() <= f64::EPSILON * fraction.abs() {
            break;
        }
    }
    fraction
}

#[cfg(test)]
mod tests {
    use super::clopper_pearson;

    fn check(successes: u64, trials: u64, (low, high): (f64, f64), tolerance: f64) {
        let found = clopper_pearson(successes, trials, 0.95);
        let distance = (found.0 - low).abs().max((found.1 - high).abs());
        assert!(
            distance <= tolerance,
            "{successes} of {trials}: {found:?}, expected {:?}",
            (low, high)
        );
    }

    #[test]
    fn intervals_agree_with_published_ones() {
        // Mendel's 682 of 925, from the documentation of R's binom.test (Conover 1971, p. 97).
        check(682, 925, (0.7076683, 0.7654066), 5e-8);
        // Tables of exact binomial limits.
        check(1, 10, (0.0025, 0.4450), 5e-5);
        check(5, 10, (0.1871, 0.8129), 5e-5);
        check(10, 100, (0.0490, 0.1762), 5e-5);
    }

    #[test]
    fn intervals_without_failure_or_success_have_closed_forms() {
        for trials in [1, 10, 1000, 1_000_000] {
            let bound = 1.0 - 0.025_f64.powf(1.0 / trials as f64);
            check(0, trials, (0.0, bound), 1e-9 * bound);
            check(trials, trials, (1.0 - bound, 1.0), 1e-9 * bound);
        }
        assert_eq!(clopper_pearson(0, 0, 0.95), (0.0, 1.0));
    }

    /// Against bisection in 40 digits (mpmath): nothing is lost to cancellation.
    #[test]
    fn intervals_of_a_million_and_a_billion_trials_have_nine_digits() {
        let million = 1_000_000;
        let billion = 1_000_000_000;
        for (successes, trials, low, high) in [
            (3, million, 6.186725501906399e-7, 8.767247788145224e-6),
            (12345, million, 0.012129493825606121, 0.012563337660712827),
            (500_000, million, 0.4990195191953118, 0.5009804808046882),
            (7, billion, 2.814363056002635e-9, 1.442267530817496e-8),
            (
                million,
                billion,
                0.000998041960675846,
                0.0010019609288197938,
            ),
        ] {
            let found = clopper_pearson(successes, trials, 0.95);
            // The upper end is one minus a float, so its digits are those of 1.
            for (found, expected) in [(found.0, low), (found.1, high)] {
                let error = (found / expected - 1.0).abs();
                assert!(
                    error < 1e-9 || expected < 1e-7 && error < 1e-8,
                    "{successes} of {trials}: {error:e}"
                );
            }
        }
    }

    #[test]
    fn intervals_hold_for_large_campaigns() {
        check(
            3,
            100000,
            (6.186763958922033e-06, 8.7670202566362e-05),
            1e-10,
        );
        check(
            50000,
            1000000,
            (0.04957363954732641, 0.05042896936846393),
            1e-10,
        );
        check(999, 1000, (0.9944410757201734, 0.9999746825125088), 1e-10);
        check(7, 12, (0.2766696856821058, 0.8483477701915698), 1e-10);
    }
}
