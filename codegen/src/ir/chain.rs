//! A program of any size with the structure of a control law: a chain of coupled two-link arms, each with its polynomials, kinematics,
//! mass matrix and one step of its states.

use super::{
    Function, Input, Op, Operator, Origin, PolynomialData, PolynomialId, Program, Shape, ValueId,
};

/// The chain of `count` arms.
pub fn arms(count: usize) -> Program {
    let mut program = Program {
        name: "chain".into(),
        polynomials: vec![PolynomialData {
            name: "friction".into(),
            arguments: vec!["rate".into(), "load".into()],
            terms: vec![(0.1, vec![1, 0]), (0.02, vec![3, 0]), (0.3, vec![1, 1])],
        }],
        ..Program::default()
    };
    for arm in 0..count {
        for name in ["q", "v"] {
            program.inputs.push(Input {
                name: format!("{name}{arm}"),
                shape: Shape::Vector(2),
            });
        }
    }
    let mut pull = None;
    for arm in 0..count {
        pull = Some(append(&mut program, arm, pull));
    }
    program
}

/// Appends an arm that the one before pulls; what it pulls the next one with.
fn append(program: &mut Program, arm: usize, pull: Option<ValueId>) -> ValueId {
    let q = program.push(Op::Input(2 * arm));
    let v = program.push(Op::Input(2 * arm + 1));
    let elbow = program.push(Op::Element(q, 1, 0));
    let (sine, cosine) = (
        program.push(Op::Apply(Function::Sin, elbow)),
        program.push(Op::Apply(Function::Cos, elbow)),
    );
    let inertia = mass_matrix(program, cosine);
    let rate = program.push(Op::Element(v, 0, 0));
    let load = program.scalar(0.5);
    let friction = program.push(Op::Polynomial(PolynomialId(0), vec![rate, load]));
    let spin = program.binary(Operator::Mul, rate, rate);
    let coriolis = program.binary(Operator::Mul, sine, spin);
    let entries = vec![friction, coriolis];
    let mut torque = program.array(Shape::Vector(2), entries);
    if let Some(pull) = pull {
        torque = program.binary(Operator::Add, torque, pull);
    }
    let acceleration = program.push(Op::Solve(inertia, torque));
    let dt = program.scalar(0.002);
    for (state, rate, name) in [(q, v, "q"), (v, acceleration, "v")] {
        let change = program.binary(Operator::Mul, rate, dt);
        let next = program.binary(Operator::Add, state, change);
        program.origins.push(Origin {
            group: format!("arm {arm}"),
            equation: format!("{name}_{arm}(t + dt)"),
        });
        let origin = program.origins.len() - 1;
        let instruction = &mut program.instructions[next.0 as usize];
        instruction.name = Some(format!("{name}{arm}_next"));
        instruction.origin = Some(origin);
        program.outputs.push((format!("{name}{arm}_next"), next));
    }
    acceleration
}

/// `[[a + 2 b c, b c + d], [b c + d, d]]` with the cosine c of the elbow.
fn mass_matrix(program: &mut Program, cosine: ValueId) -> ValueId {
    let [a, b, d] = [3.0, 0.75, 0.5].map(|entry| program.scalar(entry));
    let coupling = program.binary(Operator::Mul, b, cosine);
    let twice = program.binary(Operator::Add, coupling, coupling);
    let shoulder = program.binary(Operator::Add, a, twice);
    let cross = program.binary(Operator::Add, coupling, d);
    program.array(Shape::Matrix(2, 2), vec![shoulder, cross, cross, d])
}
