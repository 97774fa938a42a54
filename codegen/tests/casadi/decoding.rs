//! Tapes: the programs they decode to, and the errors of tapes that do not fit.

use nsv_codegen::casadi::document::Tape;
use nsv_codegen::casadi::{Question, TapeError, decode};
use nsv_codegen::ir::Program;

use super::{formula, hessian, jacobian, partials, rates};

const SPRING: &str = "
    program spring
    input x: vec2
    input k: real
    %0: vec2 = input x
    %1: real = input k
    %2: real = element %0, 0, 0
    %3: real = powi %2, 4
    %4: real = mul %3, %1
    output U = %4
";

#[test]
fn powers_stay_powers_and_zeros_are_literals() {
    let program = partials(&formula(SPRING), &hessian(&["x"]));
    insta::assert_snapshot!(program, @r"
    program spring_hessian
    input x: vec2
    input k: real
    %0: real = input k
    %1: real = const 4.0
    %2: vec2 = input x
    %3: real = element %2, 0, 0
    %4: real = powi %3, 3
    %5: real = mul %1, %4
    %6: real = mul %0, %5
    %7: real = mul %1, %0
    %8: real = const 3.0
    %9: real = powi %3, 2
    %10: real = mul %8, %9
    %11: real = mul %7, %10
    %12: real = const 0.0
    %13: vec2 = array %6, %12
    %14: mat2x2 = array %11, %12, %12, %12
    output U/x = %13
    output U/x/x = %14
    ");
}

#[test]
fn derivatives_of_polynomial_data_are_new_data() {
    let text = "
        program lift
        input alpha: real
        polynomial cl(alpha) = 0.25 [0], 0.5 [1], 2.0 [2]
        %0: real = input alpha
        %1: real = polynomial cl, %0
        output cl = %1
    ";
    insta::assert_snapshot!(partials(&formula(text), &rates(3, &["alpha"])), @r"
    program lift_rates
    input alpha: real
    input alpha.rate1: real
    input alpha.rate2: real
    input alpha.rate3: real
    polynomial cl_d1(alpha) = 0.5 [0], 4.0 [1]
    polynomial cl_d1_d1(alpha) = 4.0 [0]
    %0: real = input alpha
    %1: real = polynomial cl_d1, %0
    %2: real = input alpha.rate1
    %3: real = mul %1, %2
    %4: real = polynomial cl_d1_d1, %0
    %5: real = mul %4, %2
    %6: real = mul %2, %5
    %7: real = input alpha.rate2
    %8: real = mul %1, %7
    %9: real = add %6, %8
    %10: real = mul %5, %7
    %11: real = mul %4, %7
    %12: real = mul %2, %11
    %13: real = add %10, %12
    %14: real = mul %7, %5
    %15: real = input alpha.rate3
    %16: real = mul %1, %15
    %17: real = add %14, %16
    %18: real = add %13, %17
    output cl.rate1 = %3
    output cl.rate2 = %9
    output cl.rate3 = %18
    ");
}

#[test]
fn a_choice_is_one_select() {
    let text = "
        program choice
        input x: real
        input limit: real
        %0: real = input x
        %1: real = input limit
        %2: bool = lt %0, %1
        %3: real = sqrt %0
        %4: real = neg %0
        %5: real = select %2, %3, %4
        output q = %5
    ";
    insta::assert_snapshot!(partials(&formula(text), &jacobian(&["x"])), @r"
    program choice_jacobian
    input x: real
    input limit: real
    %0: real = input x
    %1: real = input limit
    %2: bool = lt %0, %1
    %3: real = sqrt %0
    %4: real = add %3, %3
    %5: real = const 1.0
    %6: real = div %5, %4
    %7: real = const -1.0
    %8: real = select %2, %6, %7
    %9: mat1x1 = array %8
    output q/x = %9
    ");
}

/// `q` = x of the formula with inputs x and a polynomial p, asked for its Jacobian: one output `q/x` of one entry.
fn decoded(constants: &str, nodes: &str, outputs: &str) -> Result<Program, TapeError> {
    let formula = formula(
        "
        program f
        input x: real
        input v: vec2
        polynomial p(a, b) = 1.0 [1, 1]
        %0: real = input x
        %1: real = polynomial p, %0, %0
        output q = %1
        ",
    );
    let text =
        format!(r#"{{"constants": [{constants}], "nodes": [{nodes}], "outputs": [{outputs}]}}"#);
    let tape: Tape = serde_json::from_str(&text).unwrap();
    decode(&Question::new(&formula, &jacobian(&["x"])), &tape)
}

/// The program of instructions after `x` and `c = 3`; the last one is the output.
fn arithmetic(nodes: &str) -> String {
    let count = nodes.matches("[\"").count() + 1;
    let nodes = format!(r#"["input", [], [0, 0]], ["const", [], [0]], {nodes}"#);
    let program = decoded(r#""0x1.8p+1""#, &nodes, &format!(r#"["q/x", [{count}]]"#)).unwrap();
    program.assert_sound();
    let lines = program.to_string();
    lines
        .lines()
        .filter(|line| line.starts_with('%'))
        .map(|line| line.to_owned() + "\n")
        .collect()
}

#[test]
fn each_operation_of_casadi_has_a_meaning() {
    let operations = [
        r#"["SQ", [0], []]"#,
        r#"["TWICE", [0], []]"#,
        r#"["INV", [0], []]"#,
        r#"["CONSTPOW", [0, 1], []]"#,
        r#"["POW", [1, 0], []]"#,
        r#"["NEG", [1], []], ["POW", [0, 2], []]"#,
        r#"["HYPOT", [0, 1], []]"#,
        r#"["FMIN", [0, 1], []]"#,
        r#"["FABS", [0], []]"#,
        r#"["LE", [0, 1], []], ["NOT", [2], []], ["OR", [2, 3], []], ["MUL", [4, 0], []]"#,
        r#"["EQ", [0, 1], []], ["IF_ELSE_ZERO", [2, 0], []]"#,
        r#"["NE", [0, 1], []], ["NOT", [2], []], ["IF_ELSE_ZERO", [3, 0], []], ["IF_ELSE_ZERO", [2, 1], []], ["ADD", [4, 5], []]"#,
        r#"["NOT", [0], []], ["IF_ELSE_ZERO", [2, 0], []]"#,
    ];
    let shown: Vec<String> = operations
        .iter()
        .map(|nodes| format!("{nodes}\n{}", arithmetic(nodes)))
        .collect();
    insta::assert_snapshot!(shown.join("\n"));
}

#[test]
fn a_structural_zero_spreads() {
    // p has no second derivative by its first argument: 0 * x + x is x.
    let zero = r#"["input", [], [0, 0]], ["polynomial", [0, 0], [0, 2, 0]], ["MUL", [1, 0], []], ["ADD", [2, 0], []]"#;
    let program = decoded("", zero, r#"["q/x", [3]]"#).unwrap();
    insta::assert_snapshot!(program, @r"
    program f_jacobian
    input x: real
    input v: vec2
    %0: real = input x
    %1: mat1x1 = array %0
    output q/x = %1
    ");
}

#[test]
fn a_tape_that_does_not_fit_is_refused() {
    let output = r#"["q/x", [0]]"#;
    let x = r#"["input", [], [0, 0]]"#;
    let cases: &[(&str, &str, &str)] = &[
        (r#""nan""#, r#"["const", [], [0]]"#, output),
        (r#""0x1.8p+1""#, r#"["const", [], [1]]"#, output),
        ("", r#"["input", [], [2, 0]]"#, output),
        ("", r#"["input", [], [1, 2]]"#, output),
        ("", r#"["input", [], [-1, 0]]"#, output),
        ("", r#"["SIN", [0], []]"#, output),
        ("", &format!(r#"{x}, ["SIN", [0, 0], []]"#), output),
        ("", &format!(r#"{x}, ["ADD", [0], []]"#), output),
        ("", &format!(r#"{x}, ["LOG1P", [0], []]"#), output),
        ("", &format!(r#"{x}, ["__import__", [], []]"#), output),
        ("", &format!(r#"{x}, ["powi", [0], [1]]"#), output),
        ("", &format!(r#"{x}, ["powi", [0], [99999999999]]"#), output),
        ("", &format!(r#"{x}, ["sin_cos_over", [0], [4]]"#), output),
        (
            "",
            &format!(r#"{x}, ["polynomial", [0, 0], [1, 0, 0]]"#),
            output,
        ),
        ("", &format!(r#"{x}, ["polynomial", [0], [0, 1]]"#), output),
        (
            "",
            &format!(r#"{x}, ["polynomial", [0, 0], [0, 1000000, 0]]"#),
            output,
        ),
        ("", x, r#"["q/x", [1]]"#),
        ("", x, r#"["q/x", [0, 0]]"#),
        ("", x, r#"["q/v", [0]]"#),
        ("", x, ""),
        ("", x, r#"["q/x", [0]], ["q/y", [0]]"#),
    ];
    let errors: Vec<String> = cases
        .iter()
        .map(|(constants, nodes, outputs)| {
            decoded(constants, nodes, outputs).unwrap_err().to_string()
        })
        .collect();
    insta::assert_snapshot!(errors.join("\n"));
}
