//! What `--math fast` costs: results of the programs it gives against those of the strict ones, at every point of the reference.
//!
//! Roundings of the law are amplified where it is ill conditioned: a barrier near its bound, a control that is the small difference of
//! large terms. So fast results may differ from strict ones as much as strict ones do when every operation is off by a last bit more
//! (stochastic arithmetic; Vignes, "A stochastic arithmetic for reliable scientific computation", 1993).

use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::{Instruction, Op, Operator, Program, Type, ValueId, Values};
use nsv_codegen::opt::{Arithmetic, optimise, optimise_with};
use nsv_runtime::noise::Noise;
use nsv_tests::points::{names, points};
use nsv_tests::specification::{compiled, named};

/// How many times as much: the one and the other may be off.
const TIMES: f64 = 2.0;

/// Patterns in which operations are off.
const PATTERNS: u64 = 16;

/// The program with every input and the result of every operation multiplied by one last bit more or less than 1, by a pattern.
fn perturbed(program: &Program, pattern: u64) -> Program {
    let draw = Noise::<f64>::process(pattern, 0);
    let mut noisy = Program {
        instructions: Vec::new(),
        ..program.clone()
    };
    let mut moved: Vec<ValueId> = Vec::new();
    for instruction in &program.instructions {
        let op = instruction
            .op
            .map_operands(|operand| moved[operand.0 as usize]);
        let exact = matches!(op, Op::Const(_) | Op::Array(_) | Op::Element(..));
        let mut value = ValueId(u32::try_from(noisy.instructions.len()).unwrap());
        noisy.instructions.push(Instruction {
            op,
            ..instruction.clone()
        });
        if matches!(instruction.ty, Type::Real(_)) && !exact {
            let factor = noisy.scalar(if draw.uniform(u64::from(value.0), 0) < 0.5 {
                1.0 + f64::EPSILON
            } else {
                1.0 - f64::EPSILON
            });
            value = noisy.binary(Operator::Mul, value, factor);
        }
        moved.push(value);
    }
    for (_, value) in &mut noisy.outputs {
        *value = moved[value.0 as usize];
    }
    noisy
}

/// Largest difference of the entries; infinite where one has a number and the other has not.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| match (a - b).abs() {
        _ if a == b || a.is_nan() && b.is_nan() => 0.0,
        apart if apart.is_finite() => apart,
        _ => f64::INFINITY,
    });
    differences.fold(0.0, f64::max)
}

#[test]
fn a_number_is_far_from_none() {
    let (nan, infinite) = (f64::NAN, f64::INFINITY);
    for pair in [[nan, 1.0], [1.0, nan], [infinite, 1.0], [nan, infinite]] {
        assert_eq!(difference(&[0.0, pair[0]], &[0.0, pair[1]]), infinite);
    }
    assert_eq!(
        difference(&[nan, infinite, 3.0], &[nan, infinite, 1.0]),
        2.0
    );
}

/// The largest difference of an output of the two programs, as a fraction of what it may be, and that output.
fn judge(strict: &Program, fast: &Program, noisy: &[Program], values: &Values) -> (f64, String) {
    let results = |program: &Program| eval(program, values).unwrap();
    let (expected, found) = (results(strict), results(fast));
    let noisy: Vec<Values> = noisy.iter().map(results).collect();
    let mut worst = (0.0, String::new());
    for (name, expected) in &expected {
        let shifts = noisy.iter().map(|noisy| difference(&noisy[name], expected));
        let allowed = TIMES * shifts.fold(0.0, f64::max);
        let off = difference(&found[name], expected);
        if off > worst.0 * allowed {
            worst = (off / allowed.max(f64::MIN_POSITIVE), name.clone());
        }
    }
    worst
}

#[test]
fn fast_arithmetic_changes_no_more_than_roundings_do() {
    for spec in names() {
        let (model, programs) = compiled(&named(&spec));
        for program in [programs.initial, programs.control, programs.plant] {
            let name = program.name.clone();
            let strict = optimise(program.clone());
            let fast = optimise_with(program, Arithmetic::Fast);
            let noisy: Vec<Program> = (0..PATTERNS)
                .map(|pattern| perturbed(&strict, pattern))
                .collect();
            let mut worst = (0.0, String::new());
            for point in points(&spec) {
                let values = point.values(&model, &point.params);
                let found = judge(&strict, &fast, &noisy, &values);
                if found.0 > worst.0 {
                    worst = (found.0, format!("{} at {}", found.1, point.label));
                }
            }
            println!(
                "{spec} {name}: {:.3} of what it may be, {}",
                worst.0, worst.1
            );
            assert!(worst.0 <= 1.0, "{spec} {name}: {worst:?}");
        }
    }
}
