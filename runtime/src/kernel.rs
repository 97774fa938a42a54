//! Functions of the barrier that are smooth at 0 although their usual form is 0/0 there.
//!
//! `f(E) = sin E cos E / E = S(2 E)` with `S(z) = sin z / z`, and its derivatives. The barrier keeps `|E| < pi/2`; there the derivatives are
//! polynomials in E^2. Beyond, where no controller works, they come from `z S(z) = sin z` by differentiation:
//! `S' = (cos z - S) / z`, `S'' = -(S + 2 S' / z)`, `S''' = -(S' + 2 (S'' - S' / z) / z)`.
//!
//! Error bounds on `|E| <= pi/2 - 1e-6`, against 60-digit values: a relative 4.4e-16 for [`sin_cos_over`] and [`tan_over`], a relative 6e-16 for the
//! first and third derivative, an absolute 6e-16 for the second, which has a zero at `E = 1.041`. Beyond that range everything stays correct to about
//! as many absolute digits.

use nsv_math::rare::replaced;

use crate::real::Real;

/// Largest |E| of the polynomials, rad: a little more than pi/2.
const LIMIT: f64 = 1.571;

/// `f'(E) = E P(E^2 - 5/2)`, relative error 1.3e-17 (math/coefficients/barrier.sollya).
const FIRST: [f64; 11] = [
    -0.3972981463641549,
    0.24361145339364426,
    -0.042346097423987726,
    0.0035207485716311484,
    -0.0001728002764066365,
    5.61715022099797e-6,
    -1.3009471791040576e-7,
    2.25822048969255e-9,
    -3.0495103330421104e-11,
    3.287070442428272e-13,
    -3.1569745725704106e-15,
];

/// `f''(E) = P(E^2 - 5/4)`, absolute error 1.1e-17 (math/coefficients/barrier.sollya).
const SECOND: [f64; 11] = [
    0.14320882342978897,
    0.8157860142157198,
    -0.2528341616146013,
    0.029233423515949323,
    -0.0018166664737930638,
    7.110571368895169e-5,
    -1.9209780925772513e-6,
    3.80477235726973e-8,
    -5.767709294757579e-10,
    6.913962051050824e-12,
    -6.714499386240045e-14,
];

/// `f'''(E) = E P(E^2 - 5/2)`, relative error 1.3e-17 (math/coefficients/barrier.sollya).
const THIRD: [f64; 11] = [
    0.6147467718820442,
    -0.6356770341826482,
    0.12713540683652755,
    -0.01131818986361654,
    0.0005788581017905622,
    -1.9346327179404064e-5,
    4.5714889431588463e-7,
    -8.057022137311558e-9,
    1.1012833668371847e-10,
    -1.1956984027087386e-12,
    1.18134534028678e-14,
];

/// `sin E cos E / E`, 1 at 0. It shares the sine and cosine with whoever else needs them.
#[inline(always)]
pub fn sin_cos_over<T: Real>(e: T) -> T {
    T::select(e.eq(T::zero()), T::one(), e.sin() * e.cos() / e)
}

/// First derivative of [`sin_cos_over`]: `E P(t)`, t = E^2 - 5/2; beyond pi/2, `s1 + s1` of the recursion.
#[inline(always)]
pub fn sin_cos_over_d1<T: Real>(e: T) -> T {
    within_limit(e, e * about(2.5, &FIRST, e), |[e]| 2.0 * recursion(e)[0])
}

/// Second derivative of [`sin_cos_over`]: `P(t)`, t = E^2 - 5/4; beyond pi/2, `4 s2` of the recursion.
#[inline(always)]
pub fn sin_cos_over_d2<T: Real>(e: T) -> T {
    within_limit(e, about(1.25, &SECOND, e), |[e]| 4.0 * recursion(e)[1])
}

/// Third derivative of [`sin_cos_over`]: `E P(t)`, t = E^2 - 5/2; beyond pi/2, `8 s3` of the recursion.
#[inline(always)]
pub fn sin_cos_over_d3<T: Real>(e: T) -> T {
    within_limit(e, e * about(2.5, &THIRD, e), |[e]| 8.0 * recursion(e)[2])
}

/// `tan E / E`, 1 at 0.
#[inline(always)]
pub fn tan_over<T: Real>(e: T) -> T {
    T::select(e.eq(T::zero()), T::one(), e.tan() / e)
}

/// `inside`, or where `|E|` is above the limit `beyond`.
#[inline(always)]
fn within_limit<T: Real>(e: T, inside: T, beyond: fn([f64; 1]) -> f64) -> T {
    replaced(e.abs().gt(T::from_f64(LIMIT)), inside, [e], beyond)
}

/// `P(t)` with `t = E E - middle`: `(c_0 + w (c_2 + w (c_4 + ..))) + t (c_1 + w (c_3 + ..))` with `w = t t`, each sum from its last coefficient.
#[inline(always)]
fn about<T: Real>(middle: f64, coefficients: &[f64; 11], e: T) -> T {
    let t = e * e - T::from_f64(middle);
    let w = t * t;
    let mut even = T::from_f64(coefficients[10]);
    let mut odd = T::from_f64(coefficients[9]);
    for n in (0..9).rev() {
        let c = T::from_f64(coefficients[n]);
        if n % 2 == 0 {
            even = even * w + c;
        } else {
            odd = odd * w + c;
        }
    }
    even + t * odd
}

/// The first three derivatives of `sin z / z` at `z = E + E`: with `s0 = sin z / z`, `s1 = (cos z - s0) / z`, `s2 = -(s0 + (s1 + s1) / z)`,
/// `g = s2 - s1 / z`, `s3 = -(s1 + (g + g) / z)`.
fn recursion(e: f64) -> [f64; 3] {
    let z = e + e;
    let s0 = Real::sin(z) / z;
    let s1 = (Real::cos(z) - s0) / z;
    let s2 = -(s0 + (s1 + s1) / z);
    let g = s2 - s1 / z;
    let s3 = -(s1 + (g + g) / z);
    [s1, s2, s3]
}

#[cfg(test)]
mod tests {
    use super::{LIMIT, sin_cos_over, sin_cos_over_d1, sin_cos_over_d2, sin_cos_over_d3, tan_over};

    /// `[E, f, f', f'', f''', tan E / E]` with `f = sin E cos E / E`, to 60 digits by mpmath, rounded to nearest.
    #[rustfmt::skip]
    const REFERENCE: [[f64; 6]; 25] = [
        [0.0, 1.0, 0.0, -1.3333333333333333, 0.0, 1.0],
        [1e-300, 1.0, -1.3333333333333334e-300, -1.3333333333333333, 3.2e-300, 1.0],
        [1e-160, 1.0, -1.3333333333333334e-160, -1.3333333333333333, 3.2e-160, 1.0],
        [1e-09, 1.0, -1.3333333333333335e-09, -1.3333333333333333, 3.2e-09, 1.0],
        [1e-05, 0.9999999999333333, -1.33333333328e-05, -1.3333333331733332, 3.199999999847619e-05, 1.0000000000333333],
        [0.001, 0.9999993333334667, -0.0013333328000000762, -1.3333317333337142, 0.0031999984761907135, 1.0000003333334666],
        [0.03, 0.9994001079907433, -0.03998560185130515, -1.3318936418759635, 0.09595886290245322, 1.0003001080393572],
        [0.1, 0.9933466539753061, -0.13280076134064447, -1.3173713890883352, 0.318478559000387, 1.0033467208545055],
        [0.25, 0.958851077208406, -0.3250740612721331, -1.2348118186565589, 0.7764208336327434, 1.021367684884145],
        [0.5, 0.8414709848078965, -0.6023373578795136, -0.9565345077135318, 1.4167885993360725, 1.092604979687581],
        [0.7, 0.7038926642774715, -0.7627507448246151, -0.636282814753843, 1.7556855323722356, 1.2032691149472563],
        [0.9, 0.5410264615989973, -0.8535872847689826, -0.2672452135760278, 1.9006044661115908, 1.4001757972781546],
        [0.999999, 0.45464958420835233, -0.8707954729552817, -0.07700564933015837, 1.8955989153952162, 1.5574058565472728],
        [0.9999999999999999, 0.45464871341284097, -0.8707955499599832, -0.07700375373139713, 1.8955986073827604, 1.557407724654902],
        [1.0, 0.45464871341284085, -0.8707955499599832, -0.07700375373139692, 1.8955986073827602, 1.5574077246549023],
        [1.05, 0.41105207935660654, -0.8722839847204419, 0.017284986802987023, 1.873837579038542, 1.6603002952220671],
        [1.1, 0.36749836537254094, -0.8690904387526243, 0.11017097260551668, 1.8395377738225756, 1.7861451429533202],
        [1.2, 0.28144299189631294, -0.8490305895312986, 0.28927901496691283, 1.7347815143868694, 2.1434596851052654],
        [1.3, 0.19826975839287084, -0.811660393662937, 0.45562926437149665, 1.5851286310471533, 2.770848036898445],
        [1.4, 0.11963862505568039, -0.7584721183745275, 0.6049770974551749, 1.3956843359350768, 4.141345511059205],
        [1.5, 0.04704000268662241, -0.6913549995247119, 0.7336466552864596, 1.172686680361602, 9.400946631447813],
        [1.55, 0.013413116913964674, -0.6532569465724155, 0.7892597214698388, 1.0508138301184526, 31.018375793044562],
        [1.57, 0.0005072143046136395, -0.6372649337784415, 0.8097736061935727, 1.0004293683627006, 799.8506952234328],
        [1.5697963267948967, 0.0006370248905952968, -0.6374298422103525, 0.8095697928419326, 1.0009468073383803, 637.0251029370318],
        [1.5707953267948966, 6.366201776387587e-07, -0.6366205829365512, 0.8105684707319943, 0.9984079790942706, 636620.1776657526],
    ];

    fn relative(found: f64, exact: f64, bound: f64, what: &str, e: f64) {
        assert!(
            (found - exact).abs() <= bound * exact.abs(),
            "{what}({e:e}) = {found:e}, exact {exact:e}"
        );
    }

    #[test]
    fn kernels_agree_with_high_precision() {
        for [e, f, d1, d2, d3, tan] in REFERENCE {
            relative(sin_cos_over(e), f, 2.0 * f64::EPSILON, "sin_cos_over", e);
            relative(tan_over(e), tan, 2.0 * f64::EPSILON, "tan_over", e);
            relative(sin_cos_over_d1(e), d1, 6e-16, "sin_cos_over_d1", e);
            relative(sin_cos_over_d3(e), d3, 6e-16, "sin_cos_over_d3", e);
            let found = sin_cos_over_d2(e);
            assert!(
                (found - d2).abs() <= 6e-16,
                "sin_cos_over_d2({e:e}) = {found:e}, exact {d2:e}"
            );
        }
    }

    #[test]
    fn kernels_are_even_or_odd() {
        for [e, ..] in REFERENCE {
            assert_eq!(sin_cos_over(-e), sin_cos_over(e));
            assert_eq!(sin_cos_over_d1(-e), -sin_cos_over_d1(e));
            assert_eq!(sin_cos_over_d2(-e), sin_cos_over_d2(e));
            assert_eq!(sin_cos_over_d3(-e), -sin_cos_over_d3(e));
            assert_eq!(tan_over(-e), tan_over(e));
        }
    }

    #[test]
    fn polynomials_and_recursion_meet() {
        let (below, above) = (LIMIT, LIMIT.next_up());
        for kernel in [sin_cos_over_d1, sin_cos_over_d2, sin_cos_over_d3] {
            assert!((kernel(below) - kernel(above)).abs() < 3e-15);
        }
    }

    #[test]
    fn kernels_stay_finite_for_any_finite_argument() {
        for e in [f64::MIN_POSITIVE, 5e-324, 3.0, 100.0, 1e10, 1e150, 8e307] {
            for kernel in [
                sin_cos_over,
                sin_cos_over_d1,
                sin_cos_over_d2,
                sin_cos_over_d3,
                tan_over,
            ] {
                assert!(kernel(e).is_finite(), "at {e:e}");
            }
        }
    }
}
