//! Matrices with zeros in all places, against the evaluator.

use super::{cost, simplify};
use crate::ir::{Function, Input, Op, Operator, Program, Shape, ValueId, Values, eval};

/// Draws for patterns and numbers.
struct Draws(u64);

impl Draws {
    fn below(&mut self, count: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % count
    }

    fn number(&mut self) -> f64 {
        self.below(4000) as f64 / 1000.0 - 2.0
    }
}

fn with_inputs(inputs: &[(&str, Shape)]) -> (Program, Vec<ValueId>) {
    let mut program = Program {
        name: "structured".into(),
        ..Program::default()
    };
    let mut values = Vec::new();
    for (index, (name, shape)) in inputs.iter().enumerate() {
        program.inputs.push(Input {
            name: (*name).into(),
            shape: *shape,
        });
        values.push(program.push(Op::Input(index)));
    }
    (program, values)
}

/// A matrix of entries of the vector `source`, of zeros, and now and then of ones; the entries of a random permutation come from the source.
fn matrix(
    program: &mut Program,
    source: ValueId,
    shape: (usize, usize),
    full: u64,
    draws: &mut Draws,
) -> ValueId {
    let (rows, columns) = shape;
    let mut places: Vec<usize> = (0..columns).collect();
    for i in (1..columns).rev() {
        places.swap(i, usize::try_from(draws.below(i as u64 + 1)).unwrap());
    }
    let mut items = Vec::new();
    for at in 0..rows * columns {
        let chosen = places[at / columns % columns] == at % columns;
        items.push(if chosen || draws.below(100) < full {
            program.push(Op::Element(source, at, 0))
        } else {
            let one = f64::from(u8::from(draws.below(12) == 0));
            program.scalar(one)
        });
    }
    program.array(Shape::Matrix(rows, columns), items)
}

/// Asserts that lowering keeps the outputs up to `tolerance` of the largest entry; gives the lowered program.
fn assert_close(program: &Program, inputs: &Values, tolerance: f64, context: &str) -> Program {
    program.assert_sound();
    let simple = simplify(program.clone());
    simple.assert_sound();
    let expected = eval::eval(program, inputs).unwrap();
    let found = eval::eval(&simple, inputs).unwrap();
    for (name, expected) in &expected {
        let scale = expected
            .iter()
            .fold(0.0, |scale: f64, x| scale.max(x.abs()));
        for (a, b) in expected.iter().zip(&found[name]) {
            assert!(
                (a - b).abs() <= tolerance * scale,
                "{context}, {name}: {b}, expected {a}\n{program}\n{simple}"
            );
        }
    }
    simple
}

fn numbers(count: usize, draws: &mut Draws) -> Vec<f64> {
    (0..count).map(|_| draws.number()).collect()
}

#[test]
fn products_with_zeros_keep_their_sums() {
    let mut draws = Draws(1);
    for case in 0..200 {
        let [rows, inner, columns] = [0; 3].map(|_| 1 + usize::try_from(draws.below(7)).unwrap());
        let (mut program, values) = with_inputs(&[
            ("a", Shape::Vector(rows * inner)),
            ("b", Shape::Vector(inner * columns)),
            ("v", Shape::Vector(inner)),
            ("s", Shape::Scalar),
        ]);
        let full = draws.below(60);
        let a = matrix(&mut program, values[0], (rows, inner), full, &mut draws);
        let b = matrix(&mut program, values[1], (inner, columns), full, &mut draws);
        let (scaled, negative) = (
            program.binary(Operator::Mul, a, values[3]),
            program.push(Op::Apply(Function::Neg, a)),
        );
        let turned = program.push(Op::Transpose(negative));
        for (name, op) in [
            ("ab", Op::MatMul(scaled, b)),
            ("av", Op::MatMul(a, values[2])),
            ("squares", Op::SumSquares(a)),
            ("gram", Op::MatMul(turned, scaled)),
        ] {
            let value = program.push(op);
            program.outputs.push((name.into(), value));
        }
        let inputs = program.inputs.clone();
        let inputs = inputs.iter().map(|input| {
            let count = crate::ir::build::size(input.shape);
            (input.name.clone(), numbers(count, &mut draws))
        });
        let inputs = inputs.collect();
        let simple = assert_close(&program, &inputs, 1e-15, &format!("case {case}"));
        let (before, after) = (cost::count(&program), cost::count(&simple));
        assert!(after.flops() <= before.flops(), "case {case}: {after}");
    }
}

#[test]
fn solutions_in_blocks_solve_the_equations() {
    let mut draws = Draws(2);
    let (mut compared, mut fewer) = (0, 0);
    for case in 0..600 {
        let n = 1 + usize::try_from(draws.below(7)).unwrap();
        // Of states, or of parameters alone.
        let source = ["a", "params.a"][case % 2];
        let (mut program, values) =
            with_inputs(&[(source, Shape::Vector(n * n)), ("b", Shape::Vector(n))]);
        let full = draws.below(50);
        let a = matrix(&mut program, values[0], (n, n), full, &mut draws);
        let x = program.push(Op::Solve(a, values[1]));
        let residual = program.push(Op::MatMul(a, x));
        program.outputs.push(("x".into(), x));
        program.outputs.push(("residual".into(), residual));
        let inputs: Values = [
            (source.to_string(), numbers(n * n, &mut draws)),
            ("b".to_string(), numbers(n, &mut draws)),
        ]
        .into();
        // Well conditioned ones, by the size of the solution.
        let size = |data: &[f64]| data.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let x = &eval::eval(&program, &inputs).unwrap()["x"];
        if !x.iter().all(|x| x.is_finite()) || size(x) > 30.0 * size(&inputs["b"]) {
            continue;
        }
        compared += 1;
        let simple = assert_close(&program, &inputs, 1e-11, &format!("case {case}"));
        let work = |program: &Program| {
            let cost = cost::count(program);
            cost.flops() + 10 * cost.divisions
        };
        fewer += usize::from(work(&simple) < work(&program));
    }
    assert!(compared > 250 && fewer > 200, "{compared}, {fewer}");
}

/// The operations of `Solve` left in a program.
fn solves(program: &Program) -> usize {
    let all = program.instructions.iter();
    all.filter(|instruction| matches!(instruction.op, Op::Solve(..)))
        .count()
}

#[test]
fn a_matrix_of_parameters_is_inverted_before_the_run() {
    for n in 2..=6 {
        let (mut program, values) =
            with_inputs(&[("params.a", Shape::Matrix(n, n)), ("b", Shape::Vector(n))]);
        let x = program.push(Op::Solve(values[0], values[1]));
        program.outputs.push(("x".into(), x));
        let mut draws = Draws(n as u64);
        let inputs: Values = [
            ("params.a".to_string(), numbers(n * n, &mut draws)),
            ("b".to_string(), numbers(n, &mut draws)),
        ]
        .into();
        let simple = assert_close(&program, &inputs, 1e-12, &format!("{n} rows"));
        let pieces = super::hoist::hoist(&super::optimise(simple));
        assert_eq!(solves(&pieces.rest), 0, "{n} rows");
        let square = (n * n) as u64;
        assert_eq!(cost::count(&pieces.rest).multiplications, square);
        assert_eq!(cost::count(&pieces.rest).divisions, 0);
    }
}

#[test]
fn a_literal_is_inverted_if_it_is_well_conditioned() {
    let left = |data: Vec<f64>| {
        let (mut program, values) = with_inputs(&[("b", Shape::Vector(4))]);
        let a = program.constant(Shape::Matrix(4, 4), data);
        let x = program.push(Op::Solve(a, values[0]));
        program.outputs.push(("x".into(), x));
        let inputs: Values = [("b".to_string(), vec![1.0, -2.0, 0.5, 3.0])].into();
        solves(&assert_close(&program, &inputs, 1e-12, "a literal"))
    };
    let hilbert = |i: usize| 1.0 / (1 + i / 4 + i % 4) as f64;
    assert_eq!(left((0..16).map(hilbert).collect()), 1);
    let dominant = |i: usize| hilbert(i) + f64::from(u8::from(i.is_multiple_of(5)));
    assert_eq!(left((0..16).map(dominant).collect()), 0);
}

/// A sum of multiples of two vectors and of a third term, in random order and with random signs.
#[test]
fn multiples_of_one_array_are_added_as_scalars() {
    let mut draws = Draws(3);
    for case in 0..200 {
        let (mut program, values) = with_inputs(&[
            ("x", Shape::Vector(3)),
            ("y", Shape::Vector(3)),
            ("s", Shape::Vector(4)),
        ]);
        let scalars = [0, 1, 2, 3].map(|at| program.push(Op::Element(values[2], at, 0)));
        let mut sum = program.push(Op::Apply(Function::Tanh, values[0]));
        let terms = 1 + draws.below(9);
        for _ in 0..terms {
            let mut term = values[usize::try_from(draws.below(2)).unwrap()];
            for _ in 0..draws.below(3) {
                let factor = scalars[usize::try_from(draws.below(4)).unwrap()];
                term = program.binary(Operator::Mul, term, factor);
            }
            let operator = [Operator::Add, Operator::Sub][usize::from(draws.below(2) == 0)];
            sum = program.binary(operator, sum, term);
        }
        program.outputs.push(("sum".into(), sum));
        let inputs: Values = [("x", 3), ("y", 3), ("s", 4)]
            .map(|(name, count)| (name.to_string(), numbers(count, &mut draws)))
            .into();
        let expected = eval::eval(&program, &inputs).unwrap()["sum"].clone();
        let simple = simplify(program.clone());
        let found = &eval::eval(&simple, &inputs).unwrap()["sum"];
        // Terms are below 8, and each of the sums rounds.
        let bound = 8.0 * (terms + 1) as f64 * (terms + 2) as f64 * f64::EPSILON;
        for (a, b) in expected.iter().zip(found) {
            assert!((a - b).abs() <= bound, "case {case}\n{program}\n{simple}");
        }
        let (before, after) = (cost::count(&program), cost::count(&simple));
        assert!(
            after.flops() <= before.flops(),
            "case {case}\n{program}\n{simple}"
        );
    }
}
