//! Functions of the barrier that are smooth at 0 although their usual form is 0/0 there.
//!
//! With `S(z) = sin z / z`, `sin E cos E / E = S(2 E)`, so all derivatives come from those of `S`:
//! `S' = (cos z - S) / z`, `S'' = -(S + 2 S' / z)`, `S''' = -(S' + 2 (S'' - S' / z) / z)` (differentiate `z S = sin z`). These lose digits
//! where `z` is small, so below `|z| = 2`, that is `|E| < 1`, the derivatives are summed from their Taylor series, whose first term left
//! out is below 2e-18. Both arms are always evaluated and one is selected: the recursion's NaN at 0 never escapes.
//!
//! Error bounds on `|E| <= pi/2 - 1e-6`, against 60-digit values: 2 ulp for [`sin_cos_over`] and [`tan_over`], a relative 6e-16 for the first and
//! third derivative, an absolute 6e-16 for the second, which has a zero at `E = 1.041`. Beyond that range everything stays correct to about
//! as many absolute digits.

use crate::real::Real;

/// `z` from which the recursion is used instead of the series.
const SERIES_LIMIT: f64 = 2.0;

/// `S'(z) / z = P(z^2)`, coefficients `(-1)^n 2n / (2n + 1)!` for n = 1..=12.
const FIRST: [f64; 12] = [
    -0.3333333333333333,
    0.03333333333333333,
    -0.0011904761904761906,
    2.2045855379188714e-5,
    -2.505210838544172e-7,
    1.9270852604185937e-9,
    -1.0706029224547743e-11,
    4.498331606952833e-14,
    -1.4797143443923793e-16,
    3.9145882126782523e-19,
    -8.509974375387505e-22,
    1.5472680682522736e-24,
];

/// `S''(z) = P(z^2)`, coefficients `(-1)^n 2n (2n - 1) / (2n + 1)!` for n = 1..=12.
const SECOND: [f64; 12] = [
    -0.3333333333333333,
    0.1,
    -0.005952380952380952,
    0.00015432098765432098,
    -2.2546897546897547e-6,
    2.1197937864604532e-8,
    -1.3917837991912066e-10,
    6.74749741042925e-13,
    -2.515514385467045e-15,
    7.437717604088679e-18,
    -1.787094618831376e-20,
    3.5587165569802293e-23,
];

/// `S'''(z) / z = P(z^2)`, coefficients `(-1)^n 2n (2n - 1) (2n - 2) / (2n + 1)!` for n = 2..=13.
const THIRD: [f64; 12] = [
    0.2,
    -0.023809523809523808,
    0.000925925925925926,
    -1.8037518037518038e-5,
    2.119793786460453e-7,
    -1.6701405590294479e-9,
    9.44649637460095e-12,
    -4.024823016747272e-14,
    1.3387891687359624e-16,
    -3.574189237662752e-19,
    7.829176425356505e-22,
    -1.4326556187521052e-24,
];

/// `sin E cos E / E`, 1 at 0: `sin z / z` with `z = E + E`, which is accurate at every `z` but 0.
#[inline(always)]
pub fn sin_cos_over<T: Real>(e: T) -> T {
    let z = e + e;
    T::select(z.eq(T::zero()), T::one(), z.sin() / z)
}

/// First derivative of [`sin_cos_over`]: `S'(z) + S'(z)` with `z = E + E`, and `S'(z) = z P(z z)` by Horner's scheme for `|z| < 2`, else
/// `(cos z - sin z / z) / z`.
#[inline(always)]
pub fn sin_cos_over_d1<T: Real>(e: T) -> T {
    let z = e + e;
    let [s1, _, _] = recursion(z);
    let first = below_limit(z, z * horner(&FIRST, z * z), s1);
    first + first
}

/// Second derivative of [`sin_cos_over`]: `4 S''(z)` with `z = E + E`, and `S''(z) = P(z z)` for `|z| < 2`, else
/// `-(s0 + (s1 + s1) / z)` with `s0 = sin z / z`, `s1 = (cos z - s0) / z`.
#[inline(always)]
pub fn sin_cos_over_d2<T: Real>(e: T) -> T {
    let z = e + e;
    let [_, s2, _] = recursion(z);
    below_limit(z, horner(&SECOND, z * z), s2) * T::from_f64(4.0)
}

/// Third derivative of [`sin_cos_over`]: `8 S'''(z)` with `z = E + E`, and `S'''(z) = z P(z z)` for `|z| < 2`, else
/// `-(s1 + (g + g) / z)` with `g = s2 - s1 / z` and s1, s2 as in [`sin_cos_over_d2`].
#[inline(always)]
pub fn sin_cos_over_d3<T: Real>(e: T) -> T {
    let z = e + e;
    let [_, _, s3] = recursion(z);
    below_limit(z, z * horner(&THIRD, z * z), s3) * T::from_f64(8.0)
}

/// `tan E / E`, 1 at 0.
#[inline(always)]
pub fn tan_over<T: Real>(e: T) -> T {
    T::select(e.eq(T::zero()), T::one(), e.tan() / e)
}

/// The first three derivatives of `sin z / z` by recursion; NaN at 0. What the caller drops is not computed once inlined.
#[inline(always)]
fn recursion<T: Real>(z: T) -> [T; 3] {
    let s0 = z.sin() / z;
    let s1 = (z.cos() - s0) / z;
    let s2 = -(s0 + (s1 + s1) / z);
    let g = s2 - s1 / z;
    let s3 = -(s1 + (g + g) / z);
    [s1, s2, s3]
}

/// The series where `|z|` is below the limit, else the recursion.
#[inline(always)]
fn below_limit<T: Real>(z: T, series: T, recursion: T) -> T {
    T::select(z.abs().lt(T::from_f64(SERIES_LIMIT)), series, recursion)
}

/// `c_0 + x (c_1 + x (c_2 + ...))`, from the last coefficient: `r = r x + c`.
#[inline(always)]
fn horner<T: Real>(coefficients: &[f64; 12], x: T) -> T {
    let mut r = T::from_f64(coefficients[11]);
    for n in (0..11).rev() {
        r = r * x + T::from_f64(coefficients[n]);
    }
    r
}

#[cfg(test)]
mod tests {
    use super::{sin_cos_over, sin_cos_over_d1, sin_cos_over_d2, sin_cos_over_d3, tan_over};

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
    fn series_and_recursion_meet() {
        // Consecutive floats on both sides of |E| = 1: a step there would show in a controller's telemetry.
        let (below, above) = (1.0_f64.next_down(), 1.0_f64);
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
