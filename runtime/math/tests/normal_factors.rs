//! The factors of Box and Muller's normal numbers, against the correctly rounded functions of CORE-MATH.

use nsv_math::real::Real;

/// Numbers in (0, 1), evenly spread, and their mirror images raised to powers, which crowd towards 0 and 1.
fn unit_interval() -> impl Iterator<Item = f64> {
    (0..400_000_u32).flat_map(|i| {
        let x = (f64::from(i) * 0.618_033_988_749_894_9 + 0.1).fract();
        [x, x.powi(30), 1.0 - x.powi(30)]
    })
}

/// Panics if an error is above its bound.
fn check(name: &str, x: f64, error: f64, bound: f64) {
    assert!(error.abs() <= bound, "{name} is off by {error:e} at {x:e}");
}

#[test]
fn rayleigh_is_within_two_epsilons() {
    for x in unit_interval().filter(|&x| x > 0.0 && x < 1.0) {
        // The root halves the relative error of the logarithm, so this is a quarter of a place off before it is rounded.
        let exact = (-2.0 * core_math::log(x)).sqrt();
        let bound = 2.0 * f64::EPSILON;
        check("double", x, x.rayleigh() / exact - 1.0, bound);
        check("fused", x, x.rayleigh_fused() / exact - 1.0, bound);
        let narrow = x as f32;
        if narrow < 1.0 && narrow > f32::MIN_POSITIVE {
            let exact = (-2.0 * core_math::log(narrow.into())).sqrt();
            let error = f64::from(narrow.rayleigh()) / exact - 1.0;
            check("single", x, error, 2.0 * f64::from(f32::EPSILON));
            let error = f64::from(narrow.rayleigh_fused()) / exact - 1.0;
            check("single, fused", x, error, 2.0 * f64::from(f32::EPSILON));
        }
    }
}

#[test]
fn rayleigh_of_the_number_below_one_is_not_nan() {
    let nearest = 1.0 - f64::EPSILON / 2.0;
    assert_eq!(nearest.rayleigh(), f64::EPSILON.sqrt());
    let nearest = 1.0 - f32::EPSILON / 2.0;
    assert_eq!(nearest.rayleigh(), Real::sqrt(f32::EPSILON));
}

#[test]
fn sine_and_cosine_of_half_turns_are_within_two_and_a_half_epsilons() {
    for x in unit_interval().map(|x| x - 0.5) {
        let (sine, cosine) = x.sin_cos_pi();
        let bound = 2.5 * f64::EPSILON;
        check("sine", x, sine - core_math::sinpi(x), bound);
        check("cosine", x, cosine - core_math::cospi(x), bound);
        let (sine, cosine) = x.sin_cos_pi_fused();
        check("fused sine", x, sine - core_math::sinpi(x), bound);
        check("fused cosine", x, cosine - core_math::cospi(x), bound);
        let (sine, cosine) = (x as f32).sin_cos_pi();
        let (wide, bound) = (f64::from(x as f32), 2.5 * f64::from(f32::EPSILON));
        check("sine", x, f64::from(sine) - core_math::sinpi(wide), bound);
        let error = f64::from(cosine) - core_math::cospi(wide);
        check("cosine", x, error, bound);
        let (sine, cosine) = (x as f32).sin_cos_pi_fused();
        check("fused", x, f64::from(sine) - core_math::sinpi(wide), bound);
        let error = f64::from(cosine) - core_math::cospi(wide);
        check("fused", x, error, bound);
    }
}
