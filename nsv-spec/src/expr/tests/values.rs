//! Numbers from expressions.

use nsv_math::real::Real;

use super::*;
use crate::diagnostic::Span;
use crate::model::Polynomial;

/// Values of the [`World`]: `omega` is (1, 2, 3), `pair` is `mixed`, which is (5, 7).
struct Given {
    arena: Arena,
    omega: ExprId,
    polynomial: Polynomial,
}

impl Environment for Given {
    fn constant(&self, id: ConstantId) -> Option<Vec<f64>> {
        match id.0 {
            0 => Some(vec![9.80665]),
            1 => Some((1..=9).map(f64::from).collect()),
            _ => Some(vec![5.0, 7.0]),
        }
    }

    fn parameter(&self, id: ParameterId) -> Option<f64> {
        (id.0 == 1).then_some(-3.0)
    }

    fn state(&self, block: usize, channel: usize) -> Option<f64> {
        Some(10.0 * block as f64 + channel as f64 + 0.5)
    }

    fn time(&self) -> Option<f64> {
        Some(4.0)
    }

    fn definition(&self, id: DefinitionId) -> Option<ExprId> {
        (id.0 == 0).then_some(self.omega)
    }

    fn polynomial(&self, _id: PolynomialId) -> Option<&Polynomial> {
        Some(&self.polynomial)
    }
}

fn given(text: &str) -> (Given, ExprId) {
    let mut arena = Arena::default();
    let mut add = |text: &str| {
        elaborate(
            &parse(text, base(text)).unwrap(),
            &mut World::default(),
            &mut arena,
        )
        .unwrap()
    };
    let (id, omega) = (add(text), add("[1, 2, 3]*1 rad/s"));
    let polynomial = Polynomial {
        name: "CL.alpha".into(),
        arguments: vec!["alpha_deg".into(), "mach".into()],
        terms: vec![(0.5, vec![0, 0]), (-2.0, vec![1, 0]), (3.0, vec![2, 1])],
        doc: String::new(),
        span: Span {
            file: FileId(0),
            start: 0,
            end: 0,
        },
    };
    (
        Given {
            arena,
            omega,
            polynomial,
        },
        id,
    )
}

fn check(text: &str, expected: &[f64]) {
    let (given, id) = given(text);
    assert_eq!(
        evaluate(&given.arena, id, &given).unwrap(),
        expected,
        "{text}"
    );
}

#[test]
fn every_operation_has_its_value() {
    check("n + 2*3 - 8/4", &[1.0]);
    check("-n", &[3.0]);
    check("abs(n) + sign(n) + sign(0) + sign(2)", &[3.0]);
    check("sqrt(16)", &[4.0]);
    check("exp(1)", &[Real::exp(1.0)]);
    check("ln(2)", &[Real::ln(2.0)]);
    check(
        "[sin(2), cos(2), tan(2)]",
        &[Real::sin(2.0), Real::cos(2.0), Real::tan(2.0)],
    );
    check(
        "[asin(0.5), acos(0.5), atan(2)]",
        &[Real::asin(0.5), Real::acos(0.5), Real::atan(2.0)],
    );
    check(
        "[sinh(2), cosh(2), tanh(2)]",
        &[Real::sinh(2.0), Real::cosh(2.0), Real::tanh(2.0)],
    );
    check(
        "[min(1, 2), max(1, 2), atan2(1, -1)]",
        &[1.0, 2.0, Real::atan2(1.0, -1.0)],
    );
    check(
        "[n^2, n^3, n^-2, n^0, n^1]",
        &[9.0, -27.0, 1.0 / 9.0, 1.0, -3.0],
    );
    check("2^0.5", &[Real::pow(2.0, 0.5)]);
    let cube = 1.1 * 1.1 * 1.1_f64;
    check("1.1^13", &[(cube * cube) * (cube * cube) * 1.1]);
    check("[x, v] + [0, 0]", &[1.5, 10.5]);
    check("t", &[4.0]);
    check("g", &[9.80665]);
    check("n < 0 and not n == 1 or n > 7", &[1.0]);
    check("n >= 0 or n <= -4 or n != -3", &[0.0]);
    check("if(n < 0, 1/0.5, 1/(n + 3))", &[2.0]);
    check("1/(n + 3)", &[f64::INFINITY]);
}

#[test]
fn arrays_are_row_major() {
    check("inertia*omega", &[14.0, 32.0, 50.0]);
    check("transpose(inertia)*omega", &[30.0, 36.0, 42.0]);
    check("inertia[2, 3]", &[6.0]);
    check(
        "[[1, 2], [3, 4]]*[[5, 6], [7, 8]]",
        &[19.0, 22.0, 43.0, 50.0],
    );
    check(
        "transpose([[1, 2, 3], [4, 5, 6]])",
        &[1.0, 4.0, 2.0, 5.0, 3.0, 6.0],
    );
    check("cross(omega, [0, 0, 1])", &[2.0, -1.0, 0.0]);
    check("dot(omega, omega)", &[14.0]);
    check("norm([3, 4])", &[5.0]);
    check("omega[3]*[1, 2]", &[3.0, 6.0]);
    check("sum(omega) + sum([[1, 2], [3, 4]])*1 rad/s", &[16.0]);
    check("[smallest(omega), largest(omega)]", &[1.0, 3.0]);
    check("norm_1([-1, 2, -3]) + norm_inf([-1, 2, -3])", &[9.0]);
    check("diag([5, 7])", &[5.0, 0.0, 0.0, 7.0]);
    check("skew(omega)*[0, 0, 1] - cross(omega, [0, 0, 1])", &[0.0; 3]);
    check("solve([[2, 0], [0, 4]], [1, 2])", &[0.5, 0.5]);
    check(
        "solve([[1, 2], [3, 4]], [[5, 6], [7, 8]])",
        &[-3.0, -4.0, 4.0, 5.0],
    );
    check("inverse([[1, 2], [3, 4]])", &[-2.0, 1.0, 1.5, -0.5]);
    // Units of a mass matrix: force and torque to acceleration and angular acceleration.
    check(
        "inverse([[2 kg, 1 kg*m], [1 kg*m, 1 kg*m^2]])*[1 N, 2 N*m] - [-1 m/s^2, 3 rad/s^2]",
        &[0.0, 0.0],
    );
    check(
        "solve(diag([2 kg, 4 kg*m^2]), [1 N, 0])/[1 m/s^2, 1 rad/s^2]",
        &[0.5, 0.0],
    );
    check(
        "solve([[0, 2, 0, 0], [4, 2, 0, 0], [0, 0, 1, 2], [0, 0, 2, 0]], [4, 8, 11, 6])",
        &[1.0, 2.0, 3.0, 4.0],
    );
    check(
        "inertia/(1 kg*m^2) - 1",
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
    );
}

#[test]
fn polynomials_are_sums_of_products() {
    check("CL.alpha(2, 5)", &[0.5 - 4.0 + 60.0]);
    check("CL.alpha(0, 0)", &[0.5]);
}

/// Values to a relative accuracy of 1e-15 times `units`.
fn near(text: &str, expected: &[f64], units: f64) {
    let (given, id) = given(text);
    let found = evaluate(&given.arena, id, &given).unwrap();
    assert_eq!(found.len(), expected.len(), "{text}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        let bound = units * 1e-15 * expected.abs().max(1e-3);
        assert!(error <= bound, "{text}: {found}, expected {expected}");
    }
}

#[test]
fn functions_that_the_language_defines_in_itself() {
    check("clamp([-5, 0.25, 5], -1, 1)", &[-1.0, 0.25, 1.0]);
    check(
        "smooth_step([0, 1, 2, 3, 4]*1 m, 1 m, 3 m)",
        &[0.0, 0.0, 0.5, 1.0, 1.0],
    );
    near("asinh(-2)", &[(-2.0_f64).asinh()], 2.0);
    near("asinh(0.3)", &[0.3_f64.asinh()], 2.0);
    near("acosh(3)", &[3.0_f64.acosh()], 2.0);
    near("atanh(-0.4)", &[(-0.4_f64).atanh()], 2.0);
    check("rot_x(90 deg)*[0, 0, 1] - [0, -1, cos(90 deg)]", &[0.0; 3]);
    check("rot_y(90 deg)*[0, 0, 1] - [1, 0, cos(90 deg)]", &[0.0; 3]);
    check("rot_z(90 deg)*[1, 0, 0] - [cos(90 deg), 1, 0]", &[0.0; 3]);
    near(
        "rot_z(0.7)*transpose(rot_z(0.7))",
        &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        1.0,
    );
}

#[test]
fn constants_of_the_language() {
    check("g0", &[9.80665]);
    check(
        "earth.mu/earth.radius^2",
        &[3.986004418e14 / (6378137.0 * 6378137.0)],
    );
}

#[test]
fn loops_count_from_first_to_last() {
    check("each(i, 2, 4, i^2)", &[4.0, 9.0, 16.0]);
    check("each(i, 1, 2, omega[i+1] - omega[i])", &[1.0, 1.0]);
    check(
        "each(i, 1, 2, each(j, 1, 3, 10*i + j))",
        &[11.0, 12.0, 13.0, 21.0, 22.0, 23.0],
    );
    check("sum(each(i, 1, 3, inertia[i, i]))", &[15.0]);
}

/// Table I of the U.S. Standard Atmosphere 1976, by geometric height: km, K, Pa, kg/m^3, with the digits that are printed, one unit of the last one off at most; at 86 km the
/// molecular-scale temperature of table 4 with density and pressure of the standard.
const STANDARD: [(f64, f64, f64, f64); 13] = [
    (-5.0, 320.676, 1.7776e5, 1.9311),
    (0.0, 288.150, 1.01325e5, 1.2250),
    (5.0, 255.676, 5.4048e4, 7.3643e-1),
    (11.0, 216.774, 2.2699e4, 3.6480e-1),
    (20.0, 216.650, 5.5293e3, 8.8910e-2),
    (22.0, 218.574, 4.0475e3, 6.4510e-2),
    (32.0, 228.490, 8.8906e2, 1.3555e-2),
    (47.0, 269.684, 1.1585e2, 1.4965e-3),
    (51.0, 270.650, 7.0458e1, 9.0690e-4),
    (60.0, 247.021, 2.1958e1, 3.0968e-4),
    (71.0, 216.846, 4.4795, 7.1966e-5),
    (80.0, 198.639, 1.0524, 1.8458e-5),
    (86.0, 186.946, 3.7338e-1, 6.958e-6),
];

#[test]
fn the_standard_atmosphere_is_the_published_one() {
    for (km, kelvin, pascal, density) in STANDARD {
        let printed = |function: &str, published: f64, last_digit: f64| {
            let text = format!("atmosphere.{function}({km} km)");
            let (given, id) = given(&text);
            let found = evaluate(&given.arena, id, &given).unwrap()[0];
            let error = (found - published).abs();
            assert!(
                error <= last_digit,
                "{text} is {found}, published {published}"
            );
        };
        // Five digits are printed of pressure and density, four of the density at 86 km.
        let digit = |value: f64, digits: f64| 10.0_f64.powf(value.log10().floor() + 1.0 - digits);
        printed("temperature", kelvin, 0.001);
        printed("pressure", pascal, digit(pascal, 5.0));
        printed(
            "density",
            density,
            digit(density, if km == 86.0 { 4.0 } else { 5.0 }),
        );
    }
    near("atmosphere.density(22 km)/(1 kg/m^3)", &[0.0645098327], 1e6);
    near(
        "atmosphere.speed_of_sound(22 km)/(1 m/s)",
        &[296.3769947],
        1e6,
    );
    near("atmosphere.gravity(22 km)/(1 m/s^2)", &[9.739121], 1e9);
    near("atmosphere.viscosity(0)/(1 Pa*s)", &[1.7894e-5], 1e12);
    near(
        "atmosphere.pressure(90 km) - atmosphere.pressure(86 km)",
        &[0.0],
        0.0,
    );
    near(
        "atmosphere.density(-7 km) - atmosphere.density(-5 km)",
        &[0.0],
        0.0,
    );
}

#[test]
fn layers_of_the_atmosphere_meet() {
    for km in [11, 20, 32, 47, 51, 71] {
        let at = |function: &str, metres: f64| {
            // Geometric height of a geopotential one.
            let z = f64::from(km) * 1e3 + metres;
            let text = format!(
                "atmosphere.{function}({} m)",
                6356766.0 * z / (6356766.0 - z)
            );
            let (given, id) = given(&text);
            evaluate(&given.arena, id, &given).unwrap()[0]
        };
        for function in ["temperature", "pressure", "density"] {
            let (below, above) = (at(function, -1e-4), at(function, 1e-4));
            let jump = (below - above).abs() / above;
            assert!(jump < 5e-8, "{function} at {km} km jumps by {jump:e}");
        }
    }
}

#[test]
fn a_leaf_without_a_value_is_named() {
    for (text, leaf) in [
        ("1 kg + mass", Node::Parameter(ParameterId(0))),
        ("pair*2", Node::Definition(DefinitionId(1))),
    ] {
        let (given, id) = given(text);
        assert_eq!(
            evaluate(&given.arena, id, &given).unwrap_err(),
            EvaluationError { leaf }
        );
    }
}

#[test]
fn deep_and_shared_expressions_are_evaluated_in_a_loop() {
    let chain = vec!["n"; 8000].join("+");
    check(&chain, &[-24_000.0]);
    // 2^60 additions if shared parts were computed more than once.
    let mut arena = Arena::default();
    let mut id = arena.intern(Node::Time, Type::scalar(dimension("s")));
    for _ in 0..60 {
        id = arena.intern(
            Node::Binary(Operator::Add, id, id),
            Type::scalar(dimension("s")),
        );
    }
    let (given, _) = given("1");
    assert_eq!(
        evaluate(&arena, id, &given).unwrap(),
        [4.0 * (1_u64 << 60) as f64]
    );
}
