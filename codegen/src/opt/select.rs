//! Conditions that are known at compile time, and the selections they decide.

use crate::ir::eval::comparison;
use crate::ir::{Op, Program, ValueId};

use super::rewrite::{literal, rewrite};

/// Decides selections.
pub(super) fn run(program: Program) -> Program {
    let mut truths: Vec<Option<bool>> = Vec::new();
    rewrite(program, |program, instruction| {
        for index in truths.len()..program.instructions.len() {
            let truth = truth(program, &truths, &program.instructions[index].op);
            truths.push(truth);
        }
        let known = |id: ValueId| truths[id.0 as usize];
        match instruction.op {
            Op::Select(condition, a, b) => {
                match (known(condition), &program.instruction(condition).op) {
                    // true ? a : b == a, false ? a : b == b (exact)
                    (Some(holds), _) => Some(if holds { a } else { b }),
                    // c ? a : a == a (exact)
                    _ if a == b => Some(a),
                    // !c ? a : b == c ? b : a (exact)
                    (None, &Op::Not(c)) => Some(program.push(Op::Select(c, b, a))),
                    _ => None,
                }
            }
            Op::Not(c) => match program.instruction(c).op {
                // !!c == c (exact)
                Op::Not(inner) => Some(inner),
                _ => None,
            },
            // c & c == c, c & true == c, c & false == false (exact)
            Op::And(a, b) if a == b || known(b) == Some(true) || known(a) == Some(false) => Some(a),
            Op::And(a, b) if known(a) == Some(true) || known(b) == Some(false) => Some(b),
            // c | c == c, c | false == c, c | true == true (exact)
            Op::Or(a, b) if a == b || known(b) == Some(false) || known(a) == Some(true) => Some(a),
            Op::Or(a, b) if known(a) == Some(false) || known(b) == Some(true) => Some(b),
            _ => None,
        }
    })
}

/// The truth value of an operation, if literals decide it; `truths` are those of earlier values.
fn truth(program: &Program, truths: &[Option<bool>], op: &Op) -> Option<bool> {
    match *op {
        Op::Compare(relation, a, b) => Some(comparison(
            relation,
            literal(program, a)?[0],
            literal(program, b)?[0],
        )),
        Op::Not(c) => truths[c.0 as usize].map(|holds| !holds),
        Op::And(a, b) => Some(truths[a.0 as usize]? && truths[b.0 as usize]?),
        Op::Or(a, b) => Some(truths[a.0 as usize]? || truths[b.0 as usize]?),
        _ => None,
    }
}
