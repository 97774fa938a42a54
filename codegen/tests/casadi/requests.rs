//! What a request holds, and what it leaves out.

use nsv_codegen::casadi::Question;
use nsv_codegen::ir::Program;

use super::{formula, rates};

const FORMULA: &str = "
    program lift
    input alpha: real
    input q: real
    polynomial cl(alpha) = 0.5 [1], 2.0 [3]
    %0: real = input alpha
    %1: real = input q
    %2 lift: real = polynomial cl, %0
    %3: real = mul %2, %1
    output L = %3
";

fn key(formula: &Program) -> String {
    Question::new(formula, &rates(1, &["alpha"]))
        .key()
        .to_string()
}

#[test]
fn a_request_is_canonical() {
    let program = formula(FORMULA);
    let question = Question::new(&program, &rates(1, &["alpha"]));
    insta::assert_snapshot!(serde_json::to_string(&question.request).unwrap(), @r#"{"inputs":[["alpha",[]],["q",[]]],"nodes":[["input",[],[0]],["polynomial",[0],[0]],["input",[],[1]],["mul",[1,2],[]]],"outputs":[["L",3]],"job":{"rates":{"order":1,"varying":["alpha"]}}}"#);
    insta::assert_snapshot!(question.key(), @"47706a56997f4ae01fe144a482479e834e3917aea980593f8a371bb6b111ee84");
}

/// A new coefficient, a new name, a dead value or a value written twice asks nothing new.
#[test]
fn only_the_mathematics_counts() {
    let known = key(&formula(FORMULA));
    let same = [
        FORMULA
            .replace("0.5 [1]", "0.7 [1], 3.0 [2]")
            .replace("cl(", "cm(")
            .replace("polynomial cl,", "polynomial cm,"),
        FORMULA
            .replace("program lift", "program moment")
            .replace("%2 lift", "%2 moment"),
        FORMULA.replace("output L = %3", "%4: real = sin %3\n output L = %3"),
        FORMULA
            .replace(
                "%3: real = mul %2, %1",
                "%3: real = input q\n %4: real = mul %2, %3",
            )
            .replace("L = %3", "L = %4"),
    ];
    for text in same {
        assert_eq!(key(&formula(&text)), known, "{text}");
    }
    let other = [
        FORMULA.replace("%3: real = mul", "%3: real = add"),
        FORMULA.replace("input alpha: real", "input beta: real\n input alpha: real"),
        FORMULA.replace("output L", "output D"),
    ];
    for text in other {
        assert_ne!(key(&formula(&text)), known, "{text}");
    }
}

#[test]
#[should_panic(expected = "invariant: a formula has no literals but -1, 0 and 1")]
fn a_number_is_not_sent() {
    let text = "program f\n input x: real\n %0: real = input x\n %1: real = const 2.5\n %2: real = mul %0, %1\n output q = %2";
    key(&formula(&text.replace("input x", "input alpha")));
}
