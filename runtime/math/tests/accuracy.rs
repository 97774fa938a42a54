//! Elementary functions against the correctly rounded ones of CORE-MATH. `examples/accuracy` tries far more arguments.

#[path = "../examples/accuracy/arguments.rs"]
mod arguments;
#[path = "../examples/accuracy/error.rs"]
mod error;

use arguments::Arguments;
use error::Worst;
use nsv_math::real::Real;

const SAMPLES: u64 = 300_000;

/// Panics if a function is further than 2 places from the nearest number.
fn check<const N: usize>(name: &str, found: &Worst<N>) {
    let (error, place) = (found.error, found.place());
    assert!(error <= 2.0, "{name} is off by {error} at {place}");
}

macro_rules! one_argument {
    ($($function:ident $fused:ident: $single:ident $double:ident,)*) => {$(
        one_argument!($function, $single, $double);
        one_argument!($fused, $single, $double);
    )*};
    ($function:ident, $single:ident, $double:ident) => {
        #[test]
        fn $function() {
            let (mut single, mut double) = (Worst::new(), Worst::new());
            for x in Arguments::of(0..SAMPLES) {
                double.double([x], [Real::$function(x), core_math::$double(x)]);
                let narrow = x as f32;
                let results = [Real::$function(narrow), core_math::$single(narrow)];
                single.single([narrow.into()], results, || core_math::$double(narrow.into()));
            }
            check("single precision", &single);
            check("double precision", &double);
        }
    };
}

one_argument! {
    sin sin_fused: sinf sin,
    cos cos_fused: cosf cos,
    tan tan_fused: tanf tan,
    exp exp_fused: expf exp,
    ln ln_fused: logf log,
    sinh sinh_fused: sinhf sinh,
    cosh cosh_fused: coshf cosh,
    tanh tanh_fused: tanhf tanh,
    asin asin_fused: asinf asin,
    acos acos_fused: acosf acos,
    atan atan_fused: atanf atan,
}

macro_rules! two_arguments {
    ($($function:ident $fused:ident: $single:ident $double:ident,)*) => {$(
        two_arguments!($function, $single, $double);
        two_arguments!($fused, $single, $double);
    )*};
    ($function:ident, $single:ident, $double:ident) => {
        #[test]
        fn $function() {
            let (mut single, mut double) = (Worst::new(), Worst::new());
            for [x, y] in Arguments::of(0..SAMPLES).pairs(stringify!($double) == "pow") {
                double.double([x, y], [Real::$function(x, y), core_math::$double(x, y)]);
                let (a, b) = (x as f32, y as f32);
                let results = [Real::$function(a, b), core_math::$single(a, b)];
                single.single([a.into(), b.into()], results, || core_math::$double(a.into(), b.into()));
            }
            check("single precision", &single);
            check("double precision", &double);
        }
    };
}

two_arguments! {
    atan2 atan2_fused: atan2f atan2,
    pow pow_fused: powf pow,
}

#[test]
fn special_pairs_follow_ieee_754() {
    let special = [
        0.0,
        1.0,
        2.0,
        3.0,
        0.5,
        1e300,
        5e-324,
        1e-310,
        9007199254740993.0,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    let signed = || special.into_iter().flat_map(|x| [x, -x]);
    let (mut atan2, mut pow) = (Worst::new(), Worst::new());
    for (x, y) in signed().flat_map(|x| signed().map(move |y| (x, y))) {
        atan2.double([x, y], [Real::atan2(x, y), core_math::atan2(x, y)]);
        pow.double([x, y], [Real::pow(x, y), core_math::pow(x, y)]);
    }
    check("atan2", &atan2);
    check("pow", &pow);
}

/// f(-x) is f(x) or -f(x), to the bit: the compiler takes signs out of functions.
macro_rules! symmetric {
    ($($function:ident)*) => {
        #[test]
        fn even_and_odd_functions_are_so_to_the_bit() {
            for x in Arguments::of(0..SAMPLES) {
                $(
                    let (plus, minus): (f64, f64) = (Real::$function(x), Real::$function(-x));
                    let even = matches!(stringify!($function), "cos" | "cosh" | "cos_fused" | "cosh_fused");
                    let expected = if even { plus } else { -plus };
                    let same = expected.to_bits() == minus.to_bits() || plus.is_nan() && minus.is_nan();
                    assert!(same, "{} at {x:e}: {plus:e} and {minus:e}", stringify!($function));
                    let narrow = x as f32;
                    let (plus, minus): (f32, f32) = (Real::$function(narrow), Real::$function(-narrow));
                    let expected = if even { plus } else { -plus };
                    let same = expected.to_bits() == minus.to_bits() || plus.is_nan() && minus.is_nan();
                    assert!(same, "{} at {narrow:e}: {plus:e} and {minus:e}", stringify!($function));
                )*
            }
        }
    };
}

symmetric! {
    cos cos_fused cosh cosh_fused sin sin_fused tan tan_fused asin asin_fused atan atan_fused sinh sinh_fused tanh tanh_fused
}
