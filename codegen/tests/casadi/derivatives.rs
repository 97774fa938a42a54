//! Derivatives against differences of what is differentiated.

use std::collections::BTreeMap;

use nsv_codegen::casadi::Job;
use nsv_codegen::ir::build::size;
use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::{Program, Values};

use super::{formula, hessian, jacobian, partials, rates};

/// Every elementary function, at arguments inside its domain for inputs in (0.2, 0.9).
const FUNCTIONS: &str = "
    program functions
    input x: vec3
    input k: real
    %0: vec3 = input x
    %1: real = input k
    %2: real = element %0, 0, 0
    %3: real = element %0, 1, 0
    %4: real = element %0, 2, 0
    %5: vec3 = sin %0
    %6: vec3 = cos %5
    %7: vec3 = exp %6
    %8: vec3 = ln %7
    %9: vec3 = tan %8
    %10: vec3 = atan %9
    %11: real = asin %2
    %12: real = acos %3
    %13: real = sinh %11
    %14: real = cosh %12
    %15: real = tanh %4
    %16: real = sqrt %13
    %17: real = div %16, %14
    %18: real = atan2 %15, %17
    %19: real = pow %18, %1
    %20: real = neg %19
    %21: real = abs %20
    %22: real = sign %20
    %23: real = mul %21, %22
    %24: real = powi %23, 5
    %25: real = sub %24, %15
    %26: vec3 = mul %25, %10
    output q = %26
    output r = %24
";

/// Products of arrays: q = M v + (u u^T)^T v, with s = |v|^2 u.v.
const ARRAYS: &str = "
    program arrays
    input M: mat2x2
    input v: vec2
    input u: vec2
    %0: mat2x2 = input M
    %1: vec2 = input v
    %2: vec2 = input u
    %3: vec2 = matmul %0, %1
    %4: mat2x2 = outer %2, %2
    %5: mat2x2 = matmul %4, %0
    %6: mat2x2 = transpose %5
    %7: vec2 = matmul %6, %1
    %8: vec2 = add %3, %7
    %9: real = sum_squares %1
    %10: real = dot %2, %1
    %11: real = mul %9, %10
    %12: vec2 = const [1.0, -1.0]
    %13: vec2 = mul %11, %12
    %14: real = element %8, 0, 0
    %15: vec2 = array %11, %14
    %16: vec2 = add %15, %13
    output q = %8
    output s = %11
    output w = %16
";

/// Polynomial data inside polynomial data.
const POLYNOMIALS: &str = "
    program lift
    input alpha: real
    input mach: real
    polynomial cl(alpha, mach) = -0.0819 [0, 0], 0.047 [0, 1], 0.0325 [1, 0], -1.5 [2, 3]
    polynomial trim(lift) = 2.0 [1], 0.5 [2]
    %0: real = input alpha
    %1: real = input mach
    %2: real = polynomial cl, %0, %1
    %3: real = mul %2, %1
    %4: real = polynomial trim, %3
    %5: real = polynomial trim, %2
    %6: real = mul %4, %5
    output q = %6
";

/// Barrier Lyapunov function V = s^2 tan(E)/E and the gain s S(E) of its control, with E = c s^2/(1 + k)^4 below pi/2.
const BARRIER: &str = "
    program barrier
    input e: vec2
    input k: real
    input c: real
    %0: vec2 = input e
    %1: real = input k
    %2: real = input c
    %3: real = const 1.0
    %4: real = add %1, %3
    %5: real = sum_squares %0
    %6: real = powi %5, 2
    %7: real = powi %4, 4
    %8: real = div %6, %7
    %9: real = mul %8, %2
    %10: real = tan_over %9
    %11: real = mul %10, %6
    %12: real = sin_cos_over %9
    %13: real = mul %12, %5
    output V = %11
    output g = %13
";

/// Choices between smooth pieces; the arm that is not taken has no value.
const PIECES: &str = "
    program pieces
    input x: real
    input y: real
    %0: real = input x
    %1: real = input y
    %2: real = sqrt %0
    %3: real = ln %0
    %4: real = mul %2, %3
    %5: real = powi %2, 3
    %6: real = add %4, %5
    %7: real = const 0.0
    %8: bool = gt %0, %7
    %9: bool = ge %1, %7
    %10: bool = not %9
    %11: bool = or %8, %10
    %12: bool = and %8, %11
    %13: bool = ne %0, %1
    %14: bool = and %12, %13
    %15: real = sin %0
    %16: real = mul %15, %1
    %17: real = select %14, %6, %16
    %18: real = mul %17, %1
    %19: real = min %18, %1
    %20: real = max %0, %18
    %21: real = abs %16
    %22: real = select %8, %2, %7
    output q = %18
    output low = %19
    output high = %20
    output size = %21
    output half = %22
";

/// Equations in a matrix of four rows that depends on x, with a right side and with several: x' = M(x)^-1 (u - c) and the inverse itself.
const EQUATIONS: &str = "
    program equations
    input x: vec2
    input u: vec4
    %0: vec2 = input x
    %1: vec4 = input u
    %2: real = element %0, 0, 0
    %3: real = element %0, 1, 0
    %4: real = const 1.0
    %5: real = add %4, %4
    %6: real = cos %2
    %7: real = add %5, %6
    %8: real = mul %2, %3
    %9: real = const 0.0
    %10: mat4x4 = array %7, %8, %9, %6, %8, %5, %3, %9, %4, %3, %7, %2, %9, %6, %2, %5
    %11: vec4 = solve %10, %1
    %12: mat4x4 = const [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    %13: mat4x4 = solve %10, %12
    %14: real = element %13, 1, 2
    %15: real = mul %14, %2
    %16: vec4 = mul %15, %11
    %17: real = sum_squares %11
    output x_dot = %16
    output energy = %17
    output inverse = %13
";

/// Inputs in (0.2, 0.9), the same on every run.
fn point(program: &Program, seed: u64) -> Values {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        0.2 + 0.7 * ((state >> 11) as f64 / (1u64 << 53) as f64)
    };
    program
        .inputs
        .iter()
        .map(|input| {
            (
                input.name.clone(),
                (0..size(input.shape)).map(|_| next()).collect(),
            )
        })
        .collect()
}

/// d/ds at s = 0 of a value along a line, by central differences of order eight: error of about 1e-11 here.
fn difference(value: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 2e-3;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let sum = weights
        .iter()
        .zip(1..)
        .map(|(w, n)| w * (value(f64::from(n) * STEP) - value(f64::from(-n) * STEP)));
    sum.sum::<f64>() / STEP
}

fn assert_close(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() <= 1e-8 * (1.0 + expected.abs()),
        "{what}: {found}, by differences {expected}"
    );
}

fn value(program: &Program, inputs: &Values, name: &str, entry: usize) -> f64 {
    eval(program, inputs).unwrap()[name][entry]
}

/// Every rate is the derivative of the rate before, along jets x(t) = x + x.rate1 t + x.rate2 t^2/2 + ..
fn check_rates(text: &str, order: usize, varying: &[&str]) {
    let formula = formula(text);
    let program = partials(&formula, &rates(order, varying));
    let inputs = point(&program, 7);
    let at = |t: f64| {
        let mut moved = inputs.clone();
        for name in varying {
            let jet: Vec<&Vec<f64>> = (0..=order)
                .map(|k| {
                    &inputs[&if k == 0 {
                        (*name).to_owned()
                    } else {
                        format!("{name}.rate{k}")
                    }]
                })
                .collect();
            for k in 0..=order {
                let taylor = |entry: usize| {
                    let terms = (k..=order)
                        .map(|j| jet[j][entry] * t.powi((j - k) as i32) / factorial(j - k));
                    terms.sum::<f64>()
                };
                let key = if k == 0 {
                    (*name).to_owned()
                } else {
                    format!("{name}.rate{k}")
                };
                moved.insert(key, (0..jet[0].len()).map(taylor).collect());
            }
        }
        moved
    };
    for (q, id) in &formula.outputs {
        for entry in 0..size(formula.shape(*id)) {
            for k in 1..=order {
                let (below, name) = if k == 1 {
                    (&formula, q.clone())
                } else {
                    (&program, format!("{q}.rate{}", k - 1))
                };
                let expected = difference(|t| value(below, &at(t), &name, entry));
                let rate = format!("{q}.rate{k}");
                assert_close(
                    value(&program, &inputs, &rate, entry),
                    expected,
                    &format!("{rate}[{entry}]"),
                );
            }
        }
    }
}

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

/// Entries of `name`, of `of` differentiated by every entry of every input.
fn check_gradient(below: &Program, of: &str, above: &Program, wrt: &[&str], inputs: &Values) {
    let rows = value_count(below, inputs, of);
    for x in wrt {
        let columns = inputs[*x].len();
        let name = format!("{of}/{x}");
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)))
        {
            let expected = difference(|s| {
                let mut moved = inputs.clone();
                moved
                    .entry((*x).to_owned())
                    .and_modify(|entries| entries[column] += s);
                value(below, &moved, of, row)
            });
            assert_close(
                value(above, inputs, &name, row * columns + column),
                expected,
                &format!("{name}[{row}, {column}]"),
            );
        }
    }
}

fn value_count(program: &Program, inputs: &Values, name: &str) -> usize {
    eval(program, inputs).unwrap()[name].len()
}

fn check_jacobian(text: &str, wrt: &[&str]) {
    let formula = formula(text);
    let program = partials(&formula, &jacobian(wrt));
    let inputs = point(&formula, 3);
    formula
        .outputs
        .iter()
        .for_each(|(q, _)| check_gradient(&formula, q, &program, wrt, &inputs));
}

fn check_hessian(text: &str, wrt: &[&str]) {
    let formula = formula(text);
    let program = partials(&formula, &hessian(wrt));
    let inputs = point(&formula, 5);
    for (q, _) in &formula.outputs {
        check_gradient(&formula, q, &program, wrt, &inputs);
        wrt.iter()
            .for_each(|x| check_gradient(&program, &format!("{q}/{x}"), &program, wrt, &inputs));
    }
}

#[test]
fn rates_of_elementary_functions() {
    check_rates(FUNCTIONS, 2, &["x", "k"]);
}

#[test]
fn jacobian_of_elementary_functions() {
    check_jacobian(FUNCTIONS, &["x"]);
}

#[test]
fn rates_of_array_products() {
    check_rates(ARRAYS, 3, &["v", "M"]);
}

#[test]
fn jacobian_of_array_products() {
    check_jacobian(ARRAYS, &["v", "M", "u"]);
}

#[test]
fn rates_of_polynomial_data() {
    check_rates(POLYNOMIALS, 3, &["alpha", "mach"]);
}

#[test]
fn hessian_of_polynomial_data() {
    check_hessian(POLYNOMIALS, &["alpha", "mach"]);
}

#[test]
fn rates_of_the_barrier() {
    check_rates(BARRIER, 2, &["e", "k"]);
}

#[test]
fn hessian_of_the_barrier() {
    check_hessian(BARRIER, &["e", "k"]);
}

#[test]
fn rates_of_solutions() {
    check_rates(EQUATIONS, 2, &["x", "u"]);
}

#[test]
fn jacobian_of_solutions() {
    check_jacobian(EQUATIONS, &["x", "u"]);
}

#[test]
fn hessian_of_solutions() {
    let scalars = EQUATIONS
        .lines()
        .filter(|line| !line.contains("output") || line.contains("energy"));
    check_hessian(&scalars.collect::<Vec<_>>().join("\n"), &["x", "u"]);
}

#[test]
fn rates_of_pieces() {
    check_rates(PIECES, 2, &["x", "y"]);
}

#[test]
fn jacobian_of_pieces() {
    check_jacobian(PIECES, &["x", "y"]);
}

/// At x < 0 the first arm, with sqrt and ln of x, is NaN, and so are its derivatives.
#[test]
fn an_arm_that_is_not_taken_may_be_nan() {
    let formula = formula(PIECES);
    let inputs = |program: &Program| -> Values {
        let mut values = point(program, 1);
        values.insert("x".to_owned(), vec![-0.5]);
        values
    };
    let wrt: Vec<String> = vec!["x".to_owned(), "y".to_owned()];
    for job in [rates(2, &["x", "y"]), Job::Jacobian { wrt }] {
        let program = partials(&formula, &job);
        let values: BTreeMap<_, _> = eval(&program, &inputs(&program)).unwrap();
        assert!(
            values.values().flatten().all(|value| value.is_finite()),
            "{values:?}"
        );
    }
    check_at(&formula, &inputs(&formula));
}

fn check_at(formula: &Program, inputs: &Values) {
    let program = partials(formula, &jacobian(&["x", "y"]));
    formula
        .outputs
        .iter()
        .for_each(|(q, _)| check_gradient(formula, q, &program, &["x", "y"], inputs));
}
