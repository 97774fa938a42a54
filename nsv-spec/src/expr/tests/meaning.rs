//! What elaboration makes of syntax: nodes, shapes and dimensions.

use super::*;

fn check(text: &str, nodes: &str, ty: &str) {
    let (arena, id) = meaning(text).unwrap_or_else(|faults| panic!("{text}: {faults}"));
    assert_eq!(
        (node(&arena, id).as_str(), kind(&arena, id).as_str()),
        (nodes, ty),
        "{text}"
    );
}

#[test]
fn names_have_the_type_they_were_declared_with() {
    check("g", "c0", "a scalar in m/s^2");
    check("mass", "p0", "a scalar in kg");
    check("v", "x1.0", "a scalar in m/s");
    check("t", "t", "a scalar in s");
    check("pi", "3.141592653589793", "a scalar in 1");
    check("omega", "d0", "a vector of 3 in 1/s, 1/s, 1/s");
}

#[test]
fn dimensions_follow_the_operators() {
    check("mass*g + 3 N", "Add(Mul(p0 c0) 3)", "a scalar in kg*m/s^2");
    check("x/(2 s) - v", "Sub(Div(x0.1 2) x1.0)", "a scalar in m/s");
    check("t/(1 s)", "Div(t 1)", "a scalar in 1");
    check(
        "alpha / (1 deg)",
        "Div(x0.0 0.017453292519943295)",
        "a scalar in 1",
    );
    check("-x", "Neg(x0.1)", "a scalar in m");
    check("-3 m", "-3", "a scalar in m");
    check("-0", "0", "a scalar in any");
    check("sqrt(x)", "Sqrt(x0.1)", "a scalar in sqrt(m)");
    check(
        "sqrt(x)*sqrt(x) + x",
        "Add(Mul(Sqrt(x0.1) Sqrt(x0.1)) x0.1)",
        "a scalar in m",
    );
    check("abs(x)", "Abs(x0.1)", "a scalar in m");
    check("sign(x)", "Sign(x0.1)", "a scalar in 1");
    check("max(x, 0)", "Max(x0.1 0)", "a scalar in m");
    check("atan2(x, 2 m)", "Atan2(x0.1 2)", "a scalar in 1");
    check("x < 2 km", "Lt(x0.1 2000)", "truth");
    check(
        "if(x > 0 and not n == 1, x, 0)",
        "If(And(Gt(x0.1 0) Not(Eq(p1 1))) x0.1 0)",
        "a scalar in m",
    );
    check("tanh(n)^n", "Pow(Tanh(p1) p1)", "a scalar in 1");
}

#[test]
fn whole_powers_are_products() {
    check("x^3", "PowInt3(x0.1)", "a scalar in m^3");
    check("x^1", "x0.1", "a scalar in m");
    check("x^0", "1", "a scalar in 1");
    check("x^-1", "Div(1 x0.1)", "a scalar in 1/m");
    check("x^(-2)", "Div(1 PowInt2(x0.1))", "a scalar in 1/m^2");
    check("pow(x, 2)", "PowInt2(x0.1)", "a scalar in m^2");
    check("0.5*n^0.5", "Mul(0.5 Pow(p1 0.5))", "a scalar in 1");
}

#[test]
fn arrays_have_a_dimension_per_entry() {
    check(
        "[x, v, 0]",
        "Array(x0.1 x1.0 0)",
        "a vector of 3 in m, m/s, any",
    );
    check(
        "[[1, 2], [3, 4]]",
        "Array(1 2 3 4)",
        "a 2 x 2 matrix in 1, 1, 1, 1",
    );
    check("[[1, 2, 3]]", "Array(1 2 3)", "a 1 x 3 matrix in 1, 1, 1");
    check("[omega, omega][2, 1]", "Element0,0(d0)", "a scalar in 1/s");
    check("omega[2]", "Element1,0(d0)", "a scalar in 1/s");
    check("inertia[1, 3]", "Element0,2(c1)", "a scalar in kg*m^2");
    check("[x, v][2]", "x1.0", "a scalar in m/s");
    check("2 m*omega", "Mul(2 d0)", "a vector of 3 in m/s, m/s, m/s");
    check("pair + 1 m", "Add(d1 1)", "a vector of 2 in m, m");
    check("pair*mixed", "Mul(d1 c2)", "a vector of 2 in m^2, m*s");
    check(
        "cos([alpha, n])",
        "Cos(Array(x0.0 p1))",
        "a vector of 2 in 1, 1",
    );
}

#[test]
fn products_of_matrices_add_up_terms_of_one_dimension() {
    let momentum = "a vector of 3 in kg*m^2/s, kg*m^2/s, kg*m^2/s";
    check("inertia*omega", "MatMul(c1 d0)", momentum);
    check(
        "cross(omega, inertia*omega)[1]",
        "Element0,0(Cross(d0 MatMul(c1 d0)))",
        "a scalar in kg*m^2/s^2",
    );
    check(
        "dot(omega, inertia*omega)/2",
        "Div(Dot(d0 MatMul(c1 d0)) 2)",
        "a scalar in kg*m^2/s^2",
    );
    check(
        "[[1, 0], [0, 1]]*mixed",
        "MatMul(Array(1 0 0 1) c2)",
        "a vector of 2 in m, s",
    );
    check(
        "[[0, 1 m/s], [1 s/m, 0]]*mixed",
        "MatMul(Array(0 1 1 0) c2)",
        "a vector of 2 in m, s",
    );
    check(
        "transpose(mixed)",
        "Transpose(c2)",
        "a 1 x 2 matrix in m, s",
    );
    check(
        "transpose(pair)*pair",
        "MatMul(Transpose(d1) d1)",
        "a vector of one entry in m^2",
    );
    check(
        "transpose([[1 m, 2 s], [3 kg, 4 A]])",
        "Transpose(Array(1 2 3 4))",
        "a 2 x 2 matrix in m, kg, s, A",
    );
    check("norm(pair)", "Sqrt(Dot(d1 d1))", "a scalar in m");
    check(
        "[[0, 0], [0, 0]]*pair",
        "MatMul(Array(0 0 0 0) d1)",
        "a vector of 2 in any, any",
    );
}

#[test]
fn polynomial_data_and_its_derivatives() {
    check(
        "CL.alpha(alpha/(1 deg), 0)",
        "Poly0(Div(x0.0 0.017453292519943295) 0)",
        "a scalar in 1",
    );
    check(
        "partial(CL.alpha, mach, n, 2)",
        "Poly101(p1 2)",
        "a scalar in 1",
    );
    let text = "partial(CL.alpha, alpha_deg, n, 2)";
    let mut world = World::default();
    elaborate(
        &parse(text, base(text)).unwrap(),
        &mut world,
        &mut Arena::default(),
    )
    .unwrap();
    assert_eq!(world.derivatives, [(PolynomialId(0), 0)]);
}

#[test]
fn equal_expressions_are_stored_once_unless_their_types_differ() {
    let (arena, _) = meaning("sin(n) + sin(n) + sin(n)").unwrap();
    assert_eq!(arena.len(), 4);
    let (arena, _) = meaning("[[1, 2]]*[1, 2] + [1, 2][1] + 0*0 + (0 m)/(1 m)").unwrap();
    let zeros =
        (0..arena.len()).filter(|&id| *arena.node(ExprId(id as u32)) == Node::Number(Bits(0)));
    assert_eq!(zeros.count(), 2);
}

#[test]
fn operands_come_first() {
    let (arena, _) =
        meaning("if(n > 0, cross(omega, inertia*omega)[1]^2, 0)/(1 J)^2 + CL.alpha(n, 1)").unwrap();
    for id in (0..arena.len()).map(|id| ExprId(id as u32)) {
        assert!(
            arena
                .node(id)
                .operands()
                .iter()
                .all(|operand| *operand < id)
        );
    }
}

#[test]
fn the_idioms_of_specifications_have_their_units() {
    let check = |text: &str, ty: &str| {
        let (arena, id) = meaning(text).unwrap_or_else(|faults| panic!("{text}: {faults}"));
        assert_eq!(kind(&arena, id), ty, "{text}");
    };
    check(
        "if(t <= 4 s, (2.5*sin(0.25*pi*t/(1 s) - 0.5*pi) + 1.5)*1 deg, 4 deg)",
        "a scalar in 1",
    );
    check(
        "0.02 rad/s*sin(2*t/(1 s))*exp(-0.1*t/(1 s))",
        "a scalar in 1/s",
    );
    check("3 deg*exp(-t/(1 s)) + 0.5 deg", "a scalar in 1");
    check("3 rad/s*exp(-t/(1 s)) + 0.5 rad/s", "a scalar in 1/s");
    check("0.5*(1.2 kg/m^3)*v^2", "a scalar in kg/(m*s^2)");
    check(
        "[1355818 kg*m^2, 13558180 kg*m^2, 0]",
        "a vector of 3 in kg*m^2, kg*m^2, any",
    );
    check("2 m/s*t + x", "a scalar in m");
    check("0.05 rad/sqrt(s)", "a scalar in 1/sqrt(s)");
    check(
        "[[-tan(alpha)*cos(alpha), 1, 0]]",
        "a 1 x 3 matrix in 1, 1, any",
    );
}
