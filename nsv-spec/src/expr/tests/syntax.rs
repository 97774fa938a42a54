//! What the grammar makes of a text.

use super::super::syntax::{Expr, Index, Kind, NodeId};
use super::*;

/// The tree in prefix form.
fn tree(expr: &Expr, id: usize) -> String {
    let operands = |ids: &[NodeId]| {
        let trees: Vec<_> = ids.iter().map(|id| tree(expr, id.0 as usize)).collect();
        trees.join(" ")
    };
    match &expr.nodes()[id].kind {
        Kind::Number(literal) => match &literal.unit {
            Some(unit) => format!("{}{{{}}}", literal.value, unit.text),
            None => literal.value.to_string(),
        },
        Kind::Name(name) => name.clone(),
        Kind::Negate(a) => format!("(neg {})", operands(&[*a])),
        Kind::Not(a) => format!("(not {})", operands(&[*a])),
        Kind::Infix(infix, a, b) => format!("({infix:?} {})", operands(&[*a, *b])),
        Kind::Call(name, arguments) => format!("({} {})", name.text, operands(arguments)),
        Kind::Partial {
            polynomial,
            argument,
            at,
        } => {
            format!(
                "(partial {} {} {})",
                polynomial.text,
                argument.text,
                operands(at)
            )
        }
        Kind::Array(items) => format!("[{}]", operands(items)),
        Kind::Index(a, indices) => {
            let index = |index: &Index| match &index.counter {
                Some(counter) => format!("{}{:+}", counter.text, index.offset),
                None => index.offset.to_string(),
            };
            let indices: Vec<String> = indices.iter().map(index).collect();
            format!("(at {} [{}])", operands(&[*a]), indices.join(", "))
        }
        Kind::Each {
            counter,
            range: (first, last),
            body,
        } => {
            let body = tree(body, body.nodes().len() - 1);
            format!("(each {} {first}..{last} {body})", counter.text)
        }
    }
}

fn check(text: &str, expected: &str) {
    let expr =
        parse(text, base(text)).unwrap_or_else(|faults| panic!("{text}: {}", shown(&faults)));
    assert_eq!(tree(&expr, expr.nodes().len() - 1), expected, "{text}");
    let span = expr.span();
    assert!(span.end as usize - 1000 <= text.len(), "{text}");
}

#[test]
fn operators_bind_as_in_the_table() {
    check("a + b*c", "(Add a (Mul b c))");
    check("a*b + c", "(Add (Mul a b) c)");
    check("a - b - c", "(Sub (Sub a b) c)");
    check("a/b/c*d", "(Mul (Div (Div a b) c) d)");
    check("a^b^c", "(Pow a (Pow b c))");
    check("-a^2", "(neg (Pow a 2))");
    check("-a*b", "(Mul (neg a) b)");
    check("a*-b", "(Mul a (neg b))");
    check("a^-b*c", "(Mul (Pow a (neg b)) c)");
    check("--a", "(neg (neg a))");
    check("a - -b", "(Sub a (neg b))");
    check("(a + b)*c", "(Mul (Add a b) c)");
    check("a < b + 1", "(Compare(Lt) a (Add b 1))");
    check(
        "a < b and c > d or e == f",
        "(Or (And (Compare(Lt) a b) (Compare(Gt) c d)) (Compare(Eq) e f))",
    );
    check(
        "not a < b and c != d",
        "(And (not (Compare(Lt) a b)) (Compare(Ne) c d))",
    );
    check("a or b and c", "(Or a (And b c))");
    check(
        "a <= b or not not c >= d",
        "(Or (Compare(Le) a b) (not (not (Compare(Ge) c d))))",
    );
}

#[test]
fn brackets_calls_and_indices() {
    check("sin(a)", "(sin a)");
    check("if(t <= 4 s, a, b)", "(if (Compare(Le) t 4{s}) a b)");
    check(
        "CL.alpha(alpha_deg, mach, 0)",
        "(CL.alpha alpha_deg mach 0)",
    );
    check(
        "partial(CL.RE, deflection_deg, a, 0)",
        "(partial CL.RE deflection_deg a 0)",
    );
    check("[a, b]", "[a b]");
    check(
        "[[1, -tan(b)*cos(a)], [0, 1]]",
        "[[1 (Mul (neg (tan b)) (cos a))] [0 1]]",
    );
    check("v[1] + M[1, 2]", "(Add (at v [1]) (at M [1, 2]))");
    check("transpose(M)[2, 1]^2", "(Pow (at (transpose M) [2, 1]) 2)");
    check("[a, b][2]", "(at [a b] [2])");
    check(
        "each(i, 1, 3, v[i]*i)",
        "(each i 1..3 (Mul (at v [i+0]) i))",
    );
    check(
        "each(i, 2, 3, each(j, 1, 2, M[i, j - 1] + v[i+1]))",
        "(each i 2..3 (each j 1..2 (Add (at M [i+0, j-1]) (at v [i+1]))))",
    );
    check(" ( a )\n+\t b ", "(Add a b)");
}

#[test]
fn numbers_take_their_units_along() {
    check("3000 m/s", "3000{m/s}");
    check(
        "0.5deg",
        &format!("{}{{deg}}", std::f64::consts::PI / 360.0),
    );
    check("2000 kN*m", "2000000{kN*m}");
    check("1.5e-3 s", "0.0015{s}");
    check(".5", "0.5");
    check("1e3", "1000");
    check("2 m * g", "(Mul 2{m} g)");
    check("2 m *g", "(Mul 2{m} g)");
    check("2 m*g", "0.002{m*g}");
    check("t/(1 s)", "(Div t 1{s})");
    check("2*t/(1 s)", "(Div (Mul 2 t) 1{s})");
    check(
        "3 rad/s*exp(-t/(1 s)) + 0.5 rad/s",
        "(Add (Mul 3{rad/s} (exp (Div (neg t) 1{s}))) 0.5{rad/s})",
    );
    check("3 m/s*t", "(Mul 3{m/s} t)");
    check("5 t", "5000{t}");
    check("5 1/s", "5{1/s}");
    check("2 m^2", "2{m^2}");
    check("2 m^-2", "2{m^-2}");
    check("(2 m)^2", "(Pow 2{m} 2)");
    check("-2 m", "(neg 2{m})");
    check("0.1 rad/sqrt(s)*x", "(Mul 0.1{rad/sqrt(s)} x)");
    check("2 and 3", "(And 2 3)");
    check("[1 m,2 s]", "[1{m} 2{s}]");
    check("2 m/x", "(Div 2{m} x)");
}

#[test]
fn single_literals_show_their_unit() {
    let literal = |text: &str| {
        let expr = parse(text, base(text)).unwrap();
        expr.as_literal()
            .map(|(value, unit)| (value, unit.map(|unit| unit.text.clone())))
    };
    assert_eq!(literal("-2 kN*m"), Some((-2000.0, Some("kN*m".to_owned()))));
    assert_eq!(literal("7"), Some((7.0, None)));
    assert_eq!(literal("7 + 1"), None);
}

#[test]
fn free_names_are_the_values() {
    let text = "CL.alpha(a, 1 m/x) + sin(b)*partial(CL.RE, mach, c) + a";
    let expr = parse(text, base(text)).unwrap();
    let names: Vec<_> = expr
        .free_names()
        .into_iter()
        .map(|(name, _)| name)
        .collect();
    assert_eq!(names, ["a", "x", "b", "c", "a"]);
    let called: Vec<_> = expr
        .called_names()
        .into_iter()
        .map(|(name, _)| name)
        .collect();
    assert_eq!(called, ["CL.alpha", "sin", "CL.RE"]);
    let text = "each(i, 1, 3, i*a + each(j, 1, 2, i*j))[k]";
    let expr = parse(text, base(text)).unwrap();
    let names: Vec<_> = expr
        .free_names()
        .into_iter()
        .map(|(name, _)| name)
        .collect();
    assert_eq!(names, ["a"]);
}

#[test]
fn encoded_texts_are_placed_as_a_whole() {
    let whole = base("\"a +\"").span;
    let faults = parse("a +", Base::whole(whole)).unwrap_err();
    assert_eq!(faults[0].span, Some(whole));
}
