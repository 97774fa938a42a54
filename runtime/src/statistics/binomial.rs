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
    let log_front =
        libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * x.ln() + b * (-x).ln_1p();
    let front = log_front.exp();
    if x < (a + 1.0) / (a + b + 2.0) {
        front * beta_fraction(a, b, x) / a
    } else {
        1.0 - front * beta_fraction(b, a, 1.0 - x) / b
    }
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
