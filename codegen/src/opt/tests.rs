use std::collections::BTreeSet;

use super::*;
use crate::ir::{Input, Op, Operator, Shape, Type, ValueId, Values, build, chain, eval, random};

fn pass(name: &str) -> &'static Pass {
    PASSES
        .iter()
        .chain(&LAST)
        .find(|pass| pass.name == name)
        .expect("a pass of that name")
}

/// Snapshots a program given by its statements before and after a pass, without what the pass left unused, under the name of the pass.
/// Both must agree at ordinary inputs, to a few roundings even if the pass reassociates.
fn check(name: &str, text: &str) {
    check_as(name, name, text);
}

/// As [`check`], with a name for the snapshot.
fn check_as(name: &str, snapshot: &str, text: &str) {
    let before: Program = format!("program small\n{text}").parse().unwrap();
    before.assert_sound();
    let after = (pass("dead_code").run)((pass(name).run)(before.clone()));
    after.assert_sound();
    insta::assert_snapshot!(
        snapshot,
        format!("-- before --\n{before}-- after {name} --\n{after}")
    );

    let ordinary = |shape| {
        (0..build::size(shape))
            .map(|i| 0.7 + 1.3 * i as f64)
            .collect::<Vec<f64>>()
    };
    let inputs: Values = before
        .inputs
        .iter()
        .map(|input| (input.name.clone(), ordinary(input.shape)))
        .collect();
    let (expected, found) = (
        eval::eval(&before, &inputs).unwrap(),
        eval::eval(&after, &inputs).unwrap(),
    );
    for ((name, expected), (_, found)) in expected.iter().zip(&found) {
        let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= 2.0 * f64::EPSILON * a.abs();
        assert!(
            expected.iter().zip(found).all(close),
            "{name}: {found:?}, expected {expected:?}"
        );
    }
}

/// Outputs and named values, NaN made one.
fn bits(values: Values) -> Vec<(String, Vec<u64>)> {
    let one_nan = |value: f64| {
        if value.is_nan() {
            f64::NAN.to_bits()
        } else {
            value.to_bits()
        }
    };
    values
        .into_iter()
        .map(|(name, values)| (name, values.into_iter().map(one_nan).collect()))
        .collect()
}

/// Asserts that `after` has the outputs of `before` and no other names, with the same bits for many inputs.
pub(super) fn assert_same_bits(before: &Program, after: &Program, context: &str) {
    after.assert_sound();
    let names = |program: &Program| {
        program
            .outputs
            .iter()
            .map(|(name, _)| name.clone())
            .collect::<Vec<String>>()
    };
    assert_eq!(names(before), names(after), "{context}");
    for seed in 0..12 {
        let inputs = random::inputs(before, seed);
        let mut expected = bits(eval::eval_named(before, &inputs).unwrap());
        let found = bits(eval::eval_named(after, &inputs).unwrap());
        expected.retain(|(name, _)| found.iter().any(|(kept, _)| kept == name));
        assert_eq!(
            found, expected,
            "{context}, inputs {seed}:\n{before}\n{after}"
        );
    }
}

#[test]
fn exact_passes_keep_every_bit() {
    for seed in 0..150 {
        let program = random::program(seed, 40 + 2 * usize::try_from(seed).unwrap());
        let passes = PASSES.iter().chain(&LAST);
        for pass in passes.filter(|pass| pass.kind == Kind::Exact) {
            let after = (pass.run)(program.clone());
            assert_same_bits(
                &program,
                &after,
                &format!("{} on program {seed}", pass.name),
            );
        }
        assert_same_bits(
            &program,
            &optimise(program.clone()),
            &format!("all on program {seed}"),
        );
    }
}

#[test]
fn every_pass_changes_some_random_program() {
    for pass in PASSES.iter().chain(&LAST) {
        let changes = (0..1000).any(|seed| {
            let program = random::program(seed, 200);
            (pass.run)(program.clone()) != program
        });
        assert!(changes, "{}", pass.name);
    }
}

#[test]
fn identities_that_fail_for_zeros_or_infinities_are_not_applied() {
    let text =
        "input x: real\n%0: real = input x\n%1: real = const 0.0\n%2: real = const -0.0\n%3: real = add %0, %1\n%4: real = sub %0, %2
%5: real = mul %0, %1\n%6: real = sub %0, %0\n%7: real = div %0, %0\n%8: real = div %1, %0\n%9: real = sub %1, %0
output a = %3\noutput b = %4\noutput c = %5\noutput d = %6\noutput e = %7\noutput f = %8\noutput g = %9";
    let program: Program = text.parse().unwrap();
    assert_eq!(optimise(program.clone()), program);
}

#[test]
fn optimising_again_changes_nothing() {
    for seed in 0..30 {
        let once = optimise(random::program(seed, 150));
        assert_eq!(optimise(once.clone()), once, "program {seed}");
    }
}

/// Calls of functions on arrays whose value nothing reads: they fill up a register beside others.
fn unread_calls(program: &Program) -> u64 {
    let mut read = BTreeSet::new();
    let mut whole: BTreeSet<ValueId> = program.outputs.iter().map(|(_, id)| *id).collect();
    for instruction in &program.instructions {
        match instruction.op {
            Op::Element(array, row, _) => drop(read.insert((array, row))),
            ref op => whole.extend(op.operands()),
        }
    }
    let calls = (0..).map(ValueId).zip(&program.instructions);
    let calls = calls.filter(|(id, _)| !whole.contains(id));
    let unread = calls.map(
        |(id, instruction)| match (&instruction.op, instruction.ty) {
            (Op::Apply(function, _), Type::Real(Shape::Vector(n))) => {
                let unread = (0..n).filter(|&row| !read.contains(&(id, row))).count() as u64;
                unread * cost::elementary(*function).elementary
            }
            _ => 0,
        },
    );
    unread.sum()
}

#[test]
fn optimising_never_adds_operations() {
    for seed in 0..60 {
        let program = (pass("dead_code").run)(random::program(seed, 150));
        let before = cost::count(&program);
        let optimised = optimise(program);
        let mut after = cost::count(&optimised);
        after.elementary -= unread_calls(&optimised);
        assert!(
            after.flops() + after.divisions <= before.flops() + before.divisions,
            "program {seed}: {before}; {after}"
        );
        assert!(
            after.elementary <= before.elementary && after.divisions <= before.divisions,
            "program {seed}: {before}; {after}"
        );
    }
}

#[test]
fn large_programs_are_optimised() {
    let program = random::program(7, 100_000);
    let optimised = optimise(program);
    assert!(optimised.instructions.len() > 10_000);
}

#[test]
fn long_chains_are_optimised() {
    let mut program = Program {
        name: "chain".into(),
        inputs: vec![Input {
            name: "x".into(),
            shape: Shape::Scalar,
        }],
        ..Program::default()
    };
    let x = program.push(Op::Input(0));
    let mut last = x;
    for step in 0..100_000 {
        last = program.binary(
            if step % 2 == 0 {
                Operator::Add
            } else {
                Operator::Mul
            },
            last,
            x,
        );
    }
    program.outputs.push(("y".into(), last));
    assert_eq!(optimise(program.clone()), program);
}

/// An instruction of a chain of 1500 arms may take five times as long as one of a chain of 100, for want of cache; with quadratic passes it
/// would take fifteen times as long.
#[test]
fn the_time_for_an_instruction_does_not_grow_with_the_program() {
    let time = |arms: usize| {
        let program = chain::arms(arms);
        let start = std::time::Instant::now();
        let optimised = optimise(program.clone());
        assert_eq!(optimised.families.len(), 1);
        start.elapsed().as_secs_f64() / program.instructions.len() as f64
    };
    let least = |arms| (0..3).map(|_| time(arms)).fold(f64::INFINITY, f64::min);
    let (small, large) = (least(100), least(1500));
    assert!(large < 5.0 * small, "{small:e} s, {large:e} s");
}

#[test]
fn fold() {
    let text = "%0: real = const 2.0\n%1: vec2 = const [1.0, 3.0]\n%2 gain: vec2 = mul %0, %1\n%3: real = dot %2, %1\n%4: real = sqrt %3
%5: real = const 0.0\n%6: real = div %0, %5\noutput gain = %2\noutput root = %4\noutput infinite = %6";
    check("fold", text);
}

#[test]
fn select() {
    let text = "input x: real\n%0: real = input x\n%1: real = const 1.0\n%2: real = const 2.0\n%3: bool = lt %2, %1\n%4: bool = lt %0, %1
%5: bool = or %3, %4\n%6: bool = not %5\n%7 y: real = select %6, %1, %0\n%8: real = select %3, %0, %2\noutput y = %7\noutput z = %8";
    check("select", text);
}

#[test]
fn identities() {
    let text = "input x: vec2\ninput s: real\n%0: vec2 = input x\n%1: real = input s\n%2: real = const 1.0\n%3: vec2 = mul %0, %2
%4: vec2 = neg %3\n%5: vec2 = add %4, %0\n%6: real = const 4.0\n%7: vec2 = div %5, %6\n%8: vec2 = const [1.0, 1.0]\n%9: vec2 = mul %1, %8
%10: vec2 = neg %0\n%11: real = sum_squares %10\n%12: real = dot %0, %0\noutput half = %7\noutput spread = %9\noutput a = %11\noutput b = %12";
    check("identities", text);
}

#[test]
fn structural_zeros() {
    let text = "input w: vec2\n%0: vec2 = input w\n%1: mat2x2 = const [0.0, 0.0, 0.0, 0.0]\n%2: vec2 = matmul %1, %0
%3: mat2x2 = const [2.0, 0.0, 0.0, 3.0]\n%4: vec2 = matmul %3, %0\n%5: vec2 = add %4, %2\n%6: mat2x2 = const [1.0, 0.0, 0.0, 1.0]
%7: vec2 = matmul %6, %5\n%8: mat2x2 = const [0.0, 3.0, -3.0, 0.0]\n%9: vec2 = matmul %8, %0\noutput a = %7\noutput b = %9";
    check("structural_zeros", text);
}

#[test]
fn sparse_matrices() {
    let text = "input x: vec3\ninput M: mat3x2\ninput p: real\n%0: vec3 = input x\n%1: mat3x2 = input M\n%2: real = input p\n\
                %3: mat2x3 = const [0.0, 2.0, 0.0, 3.0, 0.0, -1.0]\n%4: vec2 = matmul %3, %0\n%5: mat2x2 = matmul %3, %1\n\
                %6: real = const 1.0\n%7: real = const 0.0\n%8: mat3x3 = array %2, %6, %2, %2, %7, %6, %6, %7, %2\n\
                %9: vec3 = solve %8, %0\n%10: mat2x2 = array %2, %7, %7, %2\n%11: vec2 = solve %10, %4\n\
                output a = %4\noutput b = %5\noutput c = %9\noutput d = %11";
    check_as("structural_zeros", "sparse_matrices", text);
}

/// Whether every value of a run is a number.
fn is_tame(program: &Program, inputs: &Values) -> bool {
    let mut every = program.clone();
    let count = u32::try_from(program.instructions.len()).unwrap();
    every.outputs = (0..count)
        .map(|id| (format!("o{id}"), ValueId(id)))
        .collect();
    let values = eval::eval(&every, inputs).unwrap();
    values.values().flatten().all(|value| value.is_finite())
}

#[test]
fn zeros_are_removed_without_changing_finite_results() {
    let passes = [
        "fold",
        "identities",
        "structural_zeros",
        "arrays",
        "dead_code",
    ];
    let mut compared = 0;
    for seed in 0..400 {
        let program = (pass("dead_code").run)(random::program(seed, 40));
        // Solutions in blocks have other roundings (structure_tests).
        let mut operations = program.instructions.iter();
        if operations.any(|instruction| matches!(instruction.op, Op::Solve(..))) {
            continue;
        }
        let rounds = passes.iter().cycle().take(ROUNDS * passes.len());
        let simple = rounds.fold(program.clone(), |program, name| (pass(name).run)(program));
        simple.assert_sound();
        for draw in 0..8 {
            let inputs = random::inputs(&program, draw);
            if is_tame(&program, &inputs) && is_tame(&simple, &inputs) {
                compared += 1;
                let (expected, found) =
                    (eval::eval(&program, &inputs), eval::eval(&simple, &inputs));
                assert_eq!(found, expected, "program {seed}:\n{program}\n{simple}");
            }
        }
    }
    assert!(compared > 150, "{compared}");
}

#[test]
fn arrays() {
    let text = "input x: vec2\ninput M: mat2x3\n%0: vec2 = input x\n%1: real = element %0, 0, 0\n%2: real = element %0, 1, 0
%3 copy: vec2 = array %1, %2\n%4: vec2 = array %2, %1\n%5: real = element %4, 0, 0\n%6: mat2x3 = input M\n%7: mat3x2 = transpose %6
%8: real = element %7, 2, 1\noutput copy = %3\noutput second = %5\noutput corner = %8";
    check("arrays", text);
}

#[test]
fn transposes() {
    let text = "input A: mat2x3\ninput B: mat3x2\n%0: mat2x3 = input A\n%1: mat3x2 = input B\n%2: mat3x2 = transpose %0
%3: mat2x3 = transpose %1\n%4: mat3x3 = matmul %2, %3\n%5: mat3x3 = transpose %4\n%6: mat3x3 = neg %5\noutput BA = %6";
    check("transposes", text);
}

#[test]
fn powers() {
    let text = "input x: real\n%0: real = input x\n%1: real = powi %0, 3\n%2: real = powi %0, 6\n%3: real = powi %0, 17
output cube = %1\noutput sixth = %2\noutput large = %3";
    check("powers", text);
}

#[test]
fn value_numbering() {
    let text = "input x: real\ninput y: real\norigin \"group\" \"p = x y\"\n%0: real = input x\n%1: real = input y\n%2: real = mul %0, %1
%3 p: real = mul %1, %0 @0   ; p = x y\n%4 q: real = mul %0, %1\n%5: real = min %0, %1\n%6: real = min %1, %0\n%7: real = sub %5, %6
%8 limit: real = const 1.0\n%9 unit: real = const 1.0\n%10: real = add %8, %9\n%11: real = add %2, %10\n%12: real = add %7, %11
output p = %3\noutput q = %4\noutput r = %12";
    check("value_numbering", text);
}

#[test]
fn polynomials() {
    let text = "input a: real\ninput b: real\npolynomial f(a, m) = 2.0 [2, 0], 3.0 [1, 1], -1.0 [0, 1], 5.0 [0, 0]\npolynomial g(a) = 0.5 [1]\n\
                polynomial h(m, a) = 1.0 [1, 1], 4.0 [0, 0]\n%0: real = input a\n%1: real = input b\n%2: real = const 3.0\n%3: real = const 0.0\n\
                %4: real = polynomial f, %0, %2\n%5: real = polynomial f, %0, %3\n%6: real = polynomial g, %0\n%7: real = polynomial h, %2, %0\n\
                %8: real = polynomial g, %1\n%9: real = polynomial f, %2, %2\n%10: real = polynomial f, %0, %1\noutput p = %4\noutput q = %5\n\
                output r = %6\noutput s = %7\noutput t = %8\noutput u = %9\noutput v = %10";
    check("polynomials", text);
}

#[test]
fn combine() {
    let text = "input a: real\ninput b: real\nfamily at_a(a) = p [1.0, 2.0, 3.0], q [-1.0, -0.0, 4.0], r [5.0, 6.0], s [7.0]\n%0: real = input a\n\
                %1: real = input b\n%2: vec4 = family at_a, %0\n%3: real = element %2, 0, 0\n%4: real = element %2, 1, 0\n\
                %5: real = element %2, 2, 0\n%6: real = const 0.5\n%7: real = mul %6, %5\n%8: real = add %3, %4\n%9: real = sub %8, %1\n\
                %10: real = add %9, %7\n%11: real = element %2, 3, 0\n%12: real = mul %1, %11\n%13: real = mul %12, %6\noutput y = %10\n\
                output z = %13";
    check("combine", text);
}

#[test]
fn combined_data() {
    let text = "input a: real\ninput b: real\npolynomial f(a, m, d) = 2.0 [2, 0, 0], 3.0 [1, 1, 0], -1.0 [0, 1, 1], 5.0 [0, 0, 2]\n\
                polynomial g(a, m) = 0.5 [1, 2], -3.0 [1, 1]\npolynomial h(m, a, d) = 1.0 [1, 1, 1], 4.0 [0, 0, 1]\n%0: real = input a\n\
                %1: real = input b\n%2: real = const 2.0\n%3: real = const 0.5\n%4: real = polynomial f, %0, %1, %2\n\
                %5: real = polynomial g, %0, %1\n%6: real = add %4, %5\n%7: real = polynomial f, %0, %1, %3\n%8: real = mul %7, %1\n\
                %9: real = mul %8, %2\n%10: real = polynomial h, %1, %0, %2\n%11: real = polynomial g, %1, %1\n%12: real = sub %11, %10\n\
                %13: real = polynomial f, %0, %0, %2\noutput p = %6\noutput q = %9\noutput r = %12\noutput s = %13";
    check_as("combine", "combined_data", text);
}

#[test]
fn contract() {
    let text = "input a: real\ninput b: real\ninput v: vec2\ninput w: vec2\n%0: real = input a\n%1: real = input b\n%2: vec2 = input v\n\
                %3: vec2 = input w\n%4: real = mul %0, %1\n%5: real = add %0, %4\n%6: vec2 = mul %2, %0\n%7: vec2 = sub %3, %6\n\
                %8: vec2 = mul %2, %3\n%9: vec2 = sub %8, %2\n%10: real = dot %2, %3\n%11: real = mul %1, %1\n%12: real = add %11, %0\n\
                %13: real = min %0, %11\n%14: real = mul %0, %0\n%15: real = sub %13, %14\noutput p = %5\noutput q = %7\noutput r = %9\n\
                output s = %10\noutput t = %12\noutput u = %15";
    check("contract", text);
}

#[test]
fn clamped_kernels_are_one_quotient() {
    let text = "program small\ninput x: real\n%0: real = input x\n%1: real = const 1.5\n%2: real = min %0, %1\n%3: real = sin_cos_over %2\n\
                %4: real = const 1.0\n%5: real = div %1, %0\n%6: real = min %4, %5\n%7: real = mul %3, %6\noutput y = %7";
    let program: Program = text.parse().unwrap();
    let simplified = simplify(program.clone());
    assert_eq!(cost::count(&simplified).divisions, 1);
    for x in [
        0.0,
        1e-320,
        1e-300,
        1e-8,
        0.3,
        1.49,
        1.5,
        1.6,
        7.0,
        1e300,
        f64::INFINITY,
    ] {
        let inputs: Values = [("x".to_owned(), vec![x])].into();
        let value = |program: &Program| eval::eval(program, &inputs).unwrap()["y"][0];
        let (expected, found) = (value(&program), value(&simplified));
        assert!(
            (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
            "{x:e}: {found:e} {expected:e}"
        );
    }
}

#[test]
fn members_that_nothing_needs_leave_their_family() {
    let text = "input a: real\nfamily at_a(a) = p [1.0, 2.0], q [3.0, 4.0], r [5.0, 6.0]\n%0: real = input a\n%1: vec3 = family at_a, %0\n\
                %2: real = element %1, 0, 0\n%3: real = element %1, 2, 0\n%4: real = add %2, %3\noutput y = %4";
    let optimised = optimise(text.parse().unwrap());
    assert_eq!(optimised.families.len(), 1);
    assert_eq!(cost::count(&optimised).multiplications, 2);
}

#[test]
fn elementary() {
    let text = "input t: real\ninput x: vec2\n%0: real = input t\n%1: real = sin %0\n%2: vec2 = input x\n%3: real = element %2, 0, 0\n\
                %4: real = sin %3\n%5: real = add %4, %1\n%6: real = sin %5\n%7: real = element %2, 1, 0\n%8 s: real = sin %7\n\
                %9: real = cos %7\n%10: real = add %0, %0\n%11: real = cos %10\n%12: real = sin %10\n%13: real = cos %3\n\
                output a = %6\noutput b = %8\noutput c = %9\noutput d = %11\noutput e = %12\noutput f = %13";
    check("elementary", text);
}

#[test]
fn angles() {
    let text = "input x: real\ninput y: real\n%0: real = input x\n%1: real = input y\n%2: real = sin %0\n%3: real = tan %0\n%4: real = tan %1\n\
                output a = %2\noutput b = %3\noutput c = %4";
    check("angles", text);
}

#[test]
fn linear() {
    let text = "input w: vec3\ninput p: vec3\ninput s: real\n%0: vec3 = input w\n%1: vec3 = input p\n%2: real = input s\n%3: real = const 0.1\n\
                %4: real = const 0.002\n%5: vec3 = mul %0, %3\n%6: vec3 = sub %1, %5\n%7: vec3 = mul %6, %4\n%8: vec3 = add %0, %7\n\
                %9: mat3x3 = outer %0, %1\n%10: mat3x3 = mul %9, %4\n%11: vec3 = mul %1, %2\n%12: vec3 = mul %11, %3\n\
                %13: real = mul %2, %3\n%14: real = mul %13, %4\n%15: real = sub %14, %2\noutput a = %8\noutput b = %10\n\
                output c = %12\noutput d = %15";
    check("linear", text);
}

#[test]
fn factors() {
    let text = "input x: vec3\ninput A: mat2x3\ninput y: vec3\ninput s: real\ninput p: real\n%0: vec3 = input x\n%1: mat2x3 = input A\n\
                %2: vec3 = input y\n%3: real = input s\n%4: real = input p\n%5: vec3 = mul %0, %3\n%6: vec3 = mul %5, %4\n%7: vec3 = mul %4, %0\n\
                %8: vec3 = sub %2, %7\n%9: vec3 = add %8, %6\n%10: vec3 = sub %9, %0\n%11: vec2 = matmul %1, %0\n%12: vec2 = matmul %1, %2\n\
                %13: vec2 = sub %11, %12\n%14: vec3 = add %0, %0\n%15: vec3 = mul %2, %3\n%16: vec3 = mul %2, %4\n%17: vec3 = add %15, %16\n\
                output a = %10\noutput b = %13\noutput c = %14\noutput d = %15\noutput e = %16\noutput f = %17";
    check("factors", text);
}

#[test]
fn the_sign_of_a_product_goes_into_its_sum() {
    let text = "input x: real\ninput y: real\n%0: real = input x\n%1: real = input y\n%2: real = neg %0\n%3: real = mul %2, %1\n%4: real = add %1, %3\n\
                %5: real = mul %1, %2\n%6: real = sub %4, %5\n%7: real = mul %1, %2\n%8: real = add %7, %6\noutput a = %8";
    check_as("identities", "negative_terms", text);
}

#[test]
fn reciprocals() {
    let text = "input x: vec3\ninput d: real\n%0: vec3 = input x\n%1: real = input d\n%2: vec3 = div %0, %1\n%3: real = sum_squares %0
%4: real = div %1, %3\noutput a = %2\noutput b = %4";
    check("reciprocals", text);
}

#[test]
fn dead_code() {
    let text = "input x: real\ninput unused: real\npolynomial f(a) = 1.0 [1]\npolynomial g(a) = 2.0 [1]\norigin \"a\" \"b\"\norigin \"c\" \"d\"
%0: real = input x\n%1 telemetry: real = neg %0 @0   ; b\n%2: real = polynomial f, %0\n%3 y: real = polynomial g, %0 @1   ; d\noutput y = %3";
    check("dead_code", text);
}

#[test]
fn fast_arithmetic_removes_what_strict_arithmetic_keeps() {
    let text = "input x: real\n%0: real = input x\n%1: real = const 0.0\n%2: real = mul %0, %1\n%3: real = add %0, %2\noutput y = %3";
    let program: Program = text.parse().unwrap();
    assert_eq!(cost::count(&optimise(program.clone())).flops(), 2);
    assert_eq!(
        cost::count(&optimise_with(program, Arithmetic::Fast)).flops(),
        0
    );
}
