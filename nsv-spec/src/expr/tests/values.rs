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
