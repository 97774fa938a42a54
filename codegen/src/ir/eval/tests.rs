use super::*;
use crate::ir::Shape;

/// Evaluates one operation on literal operands, given as lines of the textual form from %0 on; the last is the result.
fn check(lines: &str, expected: &[f64]) {
    let mut text: String = lines
        .lines()
        .enumerate()
        .map(|(i, line)| format!("%{i}: {}\n", line.trim()))
        .collect();
    text += &format!("output result = %{}", lines.lines().count() - 1);
    let program: Program = text.parse().expect("a readable program");
    program.assert_sound();
    let result = &eval(&program, &Values::new()).expect("no inputs")["result"];
    let bits = |values: &[f64]| {
        values
            .iter()
            .map(|value| value.to_bits())
            .collect::<Vec<u64>>()
    };
    assert_eq!(bits(result), bits(expected), "{lines}: {result:?}");
}

#[test]
fn scalars_broadcast_over_arrays() {
    check(
        "vec2 = const [1.0, 2.0]\nreal = const 8.0\nvec2 = div %1, %0",
        &[8.0, 4.0],
    );
    check(
        "vec2 = const [1.0, 2.0]\nreal = const 8.0\nvec2 = sub %0, %1",
        &[-7.0, -6.0],
    );
}

#[test]
fn sign_keeps_zeros() {
    check(
        "vec4 = const [-0.0, 0.0, -5e-324, 7.0]\nvec4 = sign %0",
        &[-0.0, 0.0, -1.0, 1.0],
    );
}

#[test]
fn minimum_gives_the_second_operand_unless_the_first_is_smaller() {
    check(
        "vec2 = const [0.0, -0.0]\nvec2 = const [-0.0, 0.0]\nvec2 = min %0, %1",
        &[-0.0, 0.0],
    );
}

#[test]
fn integer_power_is_left_to_right_binary_powering() {
    let x: f64 = 1.1;
    let cube = x * x * x;
    check("real = const 1.1\nreal = powi %0, 7", &[cube * cube * x]);
    check("real = const 1.1\nreal = powi %0, 6", &[cube * cube]);
    check("real = const 1.1\nreal = powi %0, 4", &[(x * x) * (x * x)]);
}

#[test]
fn reductions_run_left_to_right() {
    let (a, b) = (1e16, 1.0);
    check(
        "vec3 = const [1e16, 1.0, -1e16]\nvec3 = const [1.0, 1.0, 1.0]\nreal = dot %0, %1",
        &[a + b - a],
    );
    check(
        "vec1 = const [-0.0]\nvec1 = const [1.0]\nreal = dot %0, %1",
        &[-0.0],
    );
    check(
        "mat2x2 = const [1.0, 2.0, 3.0, 4.0]\nreal = sum_squares %0",
        &[30.0],
    );
}

#[test]
fn matrices_are_row_major() {
    let matrix = "mat2x3 = const [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]";
    check(&format!("{matrix}\nreal = element %0, 1, 0"), &[4.0]);
    check(
        &format!("{matrix}\nmat3x2 = transpose %0"),
        &[1.0, 4.0, 2.0, 5.0, 3.0, 6.0],
    );
    check(
        &format!("{matrix}\nvec3 = const [1.0, 10.0, 100.0]\nvec2 = matmul %0, %1"),
        &[321.0, 654.0],
    );
    check(
        &format!("{matrix}\nmat3x2 = transpose %0\nmat2x2 = matmul %0, %1"),
        &[14.0, 32.0, 32.0, 77.0],
    );
    check(
        "vec2 = const [1.0, 2.0]\nvec3 = const [1.0, 10.0, 100.0]\nmat2x3 = outer %0, %1",
        &[1.0, 10.0, 100.0, 2.0, 20.0, 200.0],
    );
}

#[test]
fn systems_of_every_size_are_solved() {
    let mut random = 1_u64;
    let mut next = || {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (random >> 40) as f64 / f64::from(1 << 24) - 0.5
    };
    for n in 1..=6 {
        let mut program = Program::default();
        let a: Vec<f64> = (0..n * n).map(|_| next()).collect();
        let x: Vec<f64> = (0..n).map(|_| next()).collect();
        let matrix = program.constant(Shape::Matrix(n, n), a);
        let vector = program.constant(Shape::Vector(n), x.clone());
        let right = program.push(Op::MatMul(matrix, vector));
        let result = program.push(Op::Solve(matrix, right));
        program.outputs.push(("x".into(), result));
        let found = &eval(&program, &Values::new()).expect("no inputs")["x"];
        for (found, expected) in found.iter().zip(&x) {
            assert!(
                (found - expected).abs() < 1e-12,
                "{n}: {found}, expected {expected}"
            );
        }
    }
}

#[test]
fn elimination_exchanges_rows() {
    let matrix = "mat4x4 = const [0.0, 2.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 8.0, 0.0, 0.0, 16.0, 0.0]";
    check(
        &format!("{matrix}\nvec4 = const [2.0, 8.0, 24.0, 64.0]\nvec4 = solve %0, %1"),
        &[2.0, 1.0, 4.0, 3.0],
    );
}

#[test]
fn singular_vector_is_that_of_the_largest_singular_value() {
    check(
        "mat2x2 = const [0.0, 0.0, 0.0, 0.0]\nvec2 = singular_vector %0",
        &[1.0, 0.0],
    );
    check(
        "mat2x2 = const [1.0, 0.0, 0.0, -2.0]\nvec2 = singular_vector %0",
        &[0.0, 1.0],
    );
    let program: Program =
        "%0: mat3x2 = const [3.0, 3.0, 1.0, 1.0, 1.0, -1.0]\n%1: vec2 = singular_vector %0\noutput v = %1".parse().unwrap();
    let v = &eval(&program, &Values::new()).unwrap()["v"];
    assert!(
        v.iter().all(|entry| (entry - 0.5_f64.sqrt()).abs() < 1e-15),
        "{v:?}"
    );
}

#[test]
fn rates_of_a_basis_are_its_derivatives_along_a_line() {
    let text = "input z: vec2\ninput z1: vec2\ninput z2: vec2
basis b(p, q) = [0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2], [3, 0], [2, 1]
%0: vec2 = input z\n%1: vec2 = input z1\n%2: vec2 = input z2
%3 m: vec8 = basis b, %0\n%4 m1: vec8 = basis_rate b, %0, %1\n%5 m2: vec8 = basis_rate2 b, %0, %1, %2";
    let program: Program = text.parse().unwrap();
    let given = [("z", [2.0, 3.0]), ("z1", [5.0, 7.0]), ("z2", [1.0, -1.0])];
    let inputs = given
        .iter()
        .map(|(name, value)| ((*name).to_owned(), value.to_vec()))
        .collect();
    let values = eval_named(&program, &inputs).unwrap();
    assert_eq!(values["m"], [1.0, 2.0, 3.0, 4.0, 6.0, 9.0, 8.0, 12.0]);
    assert_eq!(values["m1"], [0.0, 5.0, 7.0, 20.0, 29.0, 42.0, 60.0, 88.0]);
    // (p^2)'' = 2 p'^2 + 2 p p'', (pq)'' = p''q + 2p'q' + p q'', (p^2 q)'' = (p^2)'' q + 2 (p^2)' q' + p^2 q''
    assert_eq!(
        values["m2"],
        [
            0.0,
            1.0,
            -1.0,
            54.0,
            71.0,
            92.0,
            312.0,
            54.0 * 3.0 + 2.0 * 20.0 * 7.0 - 4.0
        ]
    );
}

#[test]
fn inputs_must_fit() {
    let program: Program = "input x: vec2\n%0: vec2 = input x".parse().unwrap();
    let given = |size: usize| Values::from([("x".to_owned(), vec![0.0; size])]);
    assert_eq!(
        eval(&program, &Values::new()),
        Err(EvalError::MissingInput { name: "x".into() })
    );
    assert_eq!(
        eval(&program, &given(3)),
        Err(EvalError::InputSize {
            name: "x".into(),
            expected: 2,
            found: 3
        })
    );
    assert_eq!(eval(&program, &given(2)), Ok(Values::new()));
}
