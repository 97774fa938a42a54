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
    ($($function:ident: $single:ident $double:ident,)*) => {$(
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
    )*};
}

one_argument! {
    sin: sinf sin,
    cos: cosf cos,
    tan: tanf tan,
    exp: expf exp,
    ln: logf log,
    sinh: sinhf sinh,
    cosh: coshf cosh,
    tanh: tanhf tanh,
    asin: asinf asin,
    acos: acosf acos,
    atan: atanf atan,
}

macro_rules! two_arguments {
    ($($function:ident: $single:ident $double:ident,)*) => {$(
        #[test]
        fn $function() {
            let (mut single, mut double) = (Worst::new(), Worst::new());
            for [x, y] in Arguments::of(0..SAMPLES).pairs(stringify!($function) == "pow") {
                double.double([x, y], [Real::$function(x, y), core_math::$double(x, y)]);
                let (a, b) = (x as f32, y as f32);
                let results = [Real::$function(a, b), core_math::$single(a, b)];
                single.single([a.into(), b.into()], results, || core_math::$double(a.into(), b.into()));
            }
            check("single precision", &single);
            check("double precision", &double);
        }
    )*};
}

two_arguments! {
    atan2: atan2f atan2,
    pow: powf pow,
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
