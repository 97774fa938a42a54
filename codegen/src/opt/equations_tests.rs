//! Linear equations: inverses that cancel, symmetric matrices, solutions side by side; against the evaluator.

use super::{optimise, simplify};
use crate::ir::{Op, Program, Type, Values, eval};

const IDENTITY: &str =
    "const [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]";

/// A program with inputs q and b, a symmetric matrix %10 of q, its identity %11, then the given lines from %12 on.
fn program(lines: &str) -> Program {
    let text = format!(
        "program p
input q: vec4
input b: vec4
%0: vec4 = input q
%1: vec4 = input b
%2: real = element %0, 0, 0
%3: real = element %0, 1, 0
%4: real = element %0, 2, 0
%5: real = element %0, 3, 0
%6: real = const 4.0
%7: real = sub %2, %3
%8: real = cos %7
%9: real = mul %4, %5
%10: mat4x4 = array %6, %8, %9, %2, %8, %6, %3, %4, %9, %3, %6, %5, %2, %4, %5, %6
%11: mat4x4 = {IDENTITY}
{lines}"
    );
    let program: Program = text.parse().unwrap();
    program.assert_sound();
    program
}

fn inputs() -> Values {
    [
        ("q".to_string(), vec![0.3, -0.4, 0.9, 0.2]),
        ("b".to_string(), vec![1.0, -2.0, 0.5, 0.7]),
    ]
    .into()
}

/// The lowered program, whose outputs are those of the program within 1e-14.
fn lowered(lines: &str) -> Program {
    let program = program(lines);
    let simple = simplify(program.clone());
    simple.assert_sound();
    let [expected, found] =
        [&program, &simple].map(|program| eval::eval(program, &inputs()).unwrap());
    for (name, expected) in expected {
        for (expected, found) in expected.iter().zip(&found[&name]) {
            assert!((expected - found).abs() < 1e-14, "{name}\n{simple}");
        }
    }
    simple
}

fn count(program: &Program, of: impl Fn(&Op) -> bool) -> usize {
    let live = optimise(program.clone());
    live.instructions.iter().filter(|i| of(&i.op)).count()
}

fn solves(program: &Program) -> usize {
    count(program, |op| matches!(op, Op::Solve(..)))
}

fn factors(program: &Program) -> usize {
    count(program, |op| matches!(op, Op::Ldlt(_)))
}

#[test]
fn a_product_with_an_inverse_is_a_solution() {
    let simple =
        lowered("%12: mat4x4 = solve %10, %11\n%13: vec4 = matmul %12, %1\noutput x = %13");
    assert_eq!((solves(&simple), factors(&simple)), (1, 1), "{simple}");
    let vector =
        |op: &Op| matches!(*op, Op::Solve(_, b) if simple.ty(b) == simple.ty(simple.outputs[0].1));
    assert_eq!(count(&simple, vector), 1);
    // Not if the inverse is needed anyway.
    let simple = lowered(
        "%12: mat4x4 = solve %10, %11\n%13: vec4 = matmul %12, %1\n%14: real = sum_squares %12\noutput x = %13\noutput norm = %14",
    );
    assert_eq!(count(&simple, |op| matches!(op, Op::MatMul(..))), 1);
    assert_eq!(solves(&simple), 1);
}

/// Feedback linearisation of M x' + c = B u: u = -(M^-1 B)^-1 (-M^-1 c + b) is M b before B alone is solved for.
#[test]
fn a_controller_that_inverts_the_gain_multiplies_by_the_mass_matrix() {
    let simple = lowered(
        "%12: mat4x4 = solve %10, %11
%13: vec4 = matmul %12, %0
%14: vec4 = neg %13
%15: vec4 = add %1, %0
%16: vec4 = add %14, %15
%17: vec4 = solve %12, %16
output u = %17",
    );
    assert_eq!(solves(&simple), 0, "{simple}");
    let simple = lowered(
        "%12: mat4x4 = const [1.0, -1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 1.0]
%13: mat4x4 = solve %10, %11
%14: mat4x4 = matmul %13, %12
%15: vec4 = solve %10, %0
%16: vec4 = sub %1, %15
%17: vec4 = solve %14, %16
output u = %17",
    );
    assert_eq!(solves(&simple), 0, "{simple}");
}

#[test]
fn solutions_in_one_matrix_are_added_before_they_are_solved_for() {
    let simple = lowered(
        "%12: vec4 = solve %10, %1
%13: vec4 = solve %10, %0
%14: vec4 = sin %0
%15: vec4 = sub %14, %12
%16: vec4 = add %15, %13
output x = %16",
    );
    assert_eq!((solves(&simple), factors(&simple)), (1, 1), "{simple}");
}

#[test]
fn a_matrix_is_factorised_once_for_all_its_solutions() {
    let simple = lowered(
        "%12: vec4 = solve %10, %1\n%13: vec4 = sin %12\n%14: vec4 = solve %10, %13\noutput x = %12\noutput y = %14",
    );
    assert_eq!((solves(&simple), factors(&simple)), (2, 1), "{simple}");
}

/// Entries that are the same up to the order of factors and the direction of a difference, sums and products of symmetric matrices.
#[test]
fn symmetry_is_seen_in_how_a_matrix_is_computed() {
    let symmetric = |lines: &str, matrix: usize| {
        let text = format!(
            "{lines}\n%{}: vec4 = solve %{matrix}, %1\noutput x = %{}",
            matrix + 1,
            matrix + 1
        );
        factors(&lowered(&text)) == 1
    };
    // cos(q_1 - q_2) (q_3 q_4) above, (q_4 q_3) cos(q_2 - q_1) below.
    let entries = |below: &str| {
        format!(
            "%12: real = sub %3, %2
%13: real = {below} %12
%14: real = mul %5, %4
%15: real = mul %9, %8
%16: real = mul %13, %14
%17: mat4x4 = array %6, %15, %9, %2, %16, %6, %3, %4, %14, %3, %6, %5, %2, %4, %5, %6"
        )
    };
    assert!(symmetric(&entries("cos"), 17));
    assert!(!symmetric(&entries("sin"), 17));
    // (0.5 q_3) cos(..) + q_4 above, q_4 + (cos(..) q_3) 0.5 below.
    let terms = "%12: real = const 0.5
%13: real = mul %12, %4
%14: real = mul %13, %8
%15: real = add %14, %5
%16: real = mul %8, %4
%17: real = mul %16, %12
%18: real = add %5, %17
%19: mat4x4 = array %6, %15, %9, %2, %18, %6, %3, %4, %9, %3, %6, %5, %2, %4, %5, %6";
    assert!(symmetric(terms, 19));
    assert!(!symmetric(&terms.replace("mul %8, %4", "mul %8, %3"), 19));
    // A choice that the positions decide.
    let chosen = "%12: real = const 1.0
%13: bool = lt %12, %6
%14: real = select %13, %3, %2
%15: mat4x4 = array %6, %8, %9, %2, %8, %6, %14, %4, %9, %3, %6, %5, %2, %4, %5, %6";
    assert!(symmetric(chosen, 15));
    // Entries at one place of literals that differ in shape alone.
    let shaped = "%12: mat2x3 = const [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
%13: mat3x2 = const [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
%14: real = element %12, 1, 0
%15: real = element %13, 1, 0
%16: mat4x4 = array %6, %14, %9, %2, %15, %6, %3, %4, %9, %3, %6, %5, %2, %4, %5, %6";
    assert!(!symmetric(shaped, 16));
    let same = shaped.replace("mat3x2", "mat2x3");
    assert!(symmetric(&same, 16));
    // s J^T S J, (J^T s) J, and J^T diag(d) J.
    for congruence in [
        "%15: mat4x4 = mul %13, %2\n%16: mat4x4 = matmul %14, %10\n%17: mat4x4 = matmul %16, %15",
        "%15: mat4x4 = mul %14, %2\n%16: mat4x4 = mul %15, %3\n%17: mat4x4 = matmul %16, %13",
        "%15: mat4x4 = array %2, %0z, %0z, %0z, %0z, %3, %0z, %0z, %0z, %0z, %4, %0z, %0z, %0z, %0z, %5\n\
         %16: mat4x4 = matmul %14, %15\n%17: mat4x4 = matmul %16, %13",
    ] {
        let lines = format!("%12: real = const 0.0\n%13: mat4x4 = outer %0, %1\n%14: mat4x4 = transpose %13\n{congruence}")
            .replace("%0z", "%12");
        let sum = format!("{lines}\n%18: mat4x4 = add %17, %10");
        assert!(symmetric(&sum, 18), "{congruence}");
    }
    let form = "%12: mat4x4 = outer %0, %0
%13: mat4x4 = outer %0, %1
%14: mat4x4 = transpose %13
%15: mat4x4 = matmul %10, %13
%16: mat4x4 = matmul %14, %15
%17: mat4x4 = add %16, %12
%18: mat4x4 = mul %17, %2
%19: mat4x4 = sub %10, %18";
    assert!(symmetric(form, 19));
    assert!(!symmetric(
        &form.replace("outer %0, %0", "outer %1, %0"),
        19
    ));
}

#[test]
fn differences_in_both_directions_are_one() {
    let simple = lowered(
        "%12: real = sub %3, %2
%13: real = sin %12
%14: real = sin %7
%15: real = cos %12
%16: real = sub %2, %2
%17: real = cos %16
%18: vec4 = array %13, %14, %15, %17
%19: vec4 = add %18, %1
%20: real = mul %8, %13
output x = %19
output y = %20",
    );
    let elementary =
        |op: &Op| matches!(op, Op::Apply(function, _) if *function != crate::ir::Function::Neg);
    assert_eq!(count(&simple, elementary), 2, "{}", optimise(simple));
}

#[test]
fn right_sides_are_solved_for_as_each_alone() {
    for matrix in ["%10", "%12"] {
        let text =
            |right: &str| format!("%12: ldlt4 = ldlt %10\n%13: mat4x4 = outer %0, %1\n{right}");
        let columns = program(&text(&format!(
            "%14: mat4x4 = solve {matrix}, %13\noutput x = %14"
        )));
        let column = program(&text(&format!(
            "%14: real = element %1, 2, 0\n%15: vec4 = mul %0, %14\n%16: vec4 = solve {matrix}, %15\noutput x = %16"
        )));
        let [columns, column] =
            [columns, column].map(|program| eval::eval(&program, &inputs()).unwrap()["x"].clone());
        let third: Vec<f64> = columns.iter().skip(2).step_by(4).copied().collect();
        assert_eq!(third, column);
    }
    let ty = |program: &Program| program.ty(program.outputs[0].1);
    let program = program("%12: mat4x4 = solve %10, %11\noutput x = %12");
    assert_eq!(ty(&program), Type::Real(crate::ir::Shape::Matrix(4, 4)));
}
