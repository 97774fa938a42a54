//! Polynomials at literal arguments lose those, and polynomials of one argument are evaluated together.

use std::collections::BTreeMap;

use crate::ir::horner::Horner;
use crate::ir::{FamilyMember, Op, Program, ValueId};

use super::families::{Polynomials, tell_apart};
use super::rewrite::{literal, rewrite};

/// What becomes of an instruction.
#[derive(Clone, Copy)]
enum Site {
    /// Nothing.
    Kept,
    /// A number.
    Number(f64),
    /// A member of the gathering at an argument, and where that stands among the operands of a polynomial.
    Member {
        argument: ValueId,
        operand: usize,
        member: usize,
    },
}

/// Folds literal arguments into coefficients and gathers the polynomials of each remaining argument in one family.
pub(super) fn run(program: Program) -> Program {
    // A family of a fused program is fused, a polynomial is not.
    if program.fused {
        return program;
    }
    let (sites, mut gatherings) = gather(&program);
    gatherings.retain(|_, gathering| gathering.folded || gathering.places > 1);
    let mut known = Polynomials::of(&program);
    let mut next = sites.into_iter();
    rewrite(program, |program, instruction| {
        match next.next().expect("invariant: one site per instruction") {
            Site::Kept => None,
            Site::Number(value) => Some(program.scalar(value)),
            // f(z, m) == f_m(z), with coefficients from m by the nested schemes of f (exact: the same operations, some done now)
            Site::Member {
                argument,
                operand,
                member,
            } => {
                let gathering = gatherings.get_mut(&argument)?;
                let argument = match instruction.op {
                    Op::Element(family, ..) => program.instruction(family).op.operands()[0],
                    _ => instruction.op.operands()[operand],
                };
                let values = gathering.values(program, &mut known, argument);
                Some(program.push(Op::Element(values, gathering.positions[member], 0)))
            }
        }
    })
}

/// The polynomials at one argument.
#[derive(Default)]
struct Gathering {
    /// Name of the argument.
    argument: String,
    members: Vec<FamilyMember>,
    /// Index of each member by its name and the bits of its coefficients: under another name, people look for another quantity.
    known: BTreeMap<(String, Vec<u64>), usize>,
    /// Whether a literal argument was folded or a family has a member that nothing needs.
    folded: bool,
    /// Polynomials and families that the members come from.
    places: usize,
    /// Position in the family of each member.
    positions: Vec<usize>,
    /// The values, once they are computed.
    values: Option<ValueId>,
}

impl Gathering {
    /// The index of a member.
    fn add(&mut self, name: &str, coefficients: &[f64]) -> usize {
        let bits = coefficients.iter().map(|c| c.to_bits()).collect();
        let next = self.members.len();
        let index = *self.known.entry((name.to_owned(), bits)).or_insert(next);
        if index == next {
            self.members.push(FamilyMember {
                name: name.to_owned(),
                coefficients: coefficients.to_vec(),
            });
        }
        index
    }

    /// The values of the family, computed where they are needed first.
    fn values(
        &mut self,
        program: &mut Program,
        known: &mut Polynomials,
        argument: ValueId,
    ) -> ValueId {
        if let Some(values) = self.values {
            return values;
        }
        let mut order: Vec<usize> = (0..self.members.len()).collect();
        order.sort_by_key(|&member| std::cmp::Reverse(self.members[member].coefficients.len()));
        self.positions = vec![0; order.len()];
        for (position, &member) in order.iter().enumerate() {
            self.positions[member] = position;
        }
        let mut members: Vec<FamilyMember> = order
            .iter()
            .map(|&member| self.members[member].clone())
            .collect();
        tell_apart(members.iter_mut().map(|member| &mut member.name));
        let id = known.add_family(program, &self.argument, members);
        let values = program.push(Op::Family(id, argument));
        self.values = Some(values);
        values
    }
}

/// The site of each instruction, and what is gathered at each argument.
fn gather(program: &Program) -> (Vec<Site>, BTreeMap<ValueId, Gathering>) {
    let apart = taken_apart(program);
    let mut gatherings: BTreeMap<ValueId, Gathering> = BTreeMap::new();
    let sites = program
        .instructions
        .iter()
        .map(|instruction| match &instruction.op {
            Op::Polynomial(id, arguments) => {
                let data = &program.polynomials[id.0 as usize];
                let numbers: Vec<Option<f64>> = arguments
                    .iter()
                    .map(|&argument| literal(program, argument).map(|data| data[0]))
                    .collect();
                match reduce(&Horner::new(data), &numbers) {
                    Some(Reduced::Number(value)) => Site::Number(value),
                    Some(Reduced::Univariate(operand, coefficients)) => {
                        let gathering = gatherings.entry(arguments[operand]).or_default();
                        gathering.argument.clone_from(&data.arguments[operand]);
                        gathering.folded |= data.arguments.len() > 1;
                        gathering.places += 1;
                        Site::Member {
                            argument: arguments[operand],
                            operand,
                            member: gathering.add(&data.name, &coefficients),
                        }
                    }
                    None => Site::Kept,
                }
            }
            Op::Element(values, row, _) if apart.contains_key(values) => {
                let Op::Family(id, argument) = program.instruction(*values).op else {
                    panic!("invariant: a family is taken apart")
                };
                let family = &program.families[id.0 as usize];
                let gathering = gatherings.entry(argument).or_default();
                gathering.argument.clone_from(&family.argument);
                gathering.folded |= apart[values].iter().any(|used| !used);
                if apart[values].iter().position(|&used| used) == Some(*row) {
                    gathering.places += 1;
                }
                let FamilyMember { name, coefficients } = &family.members[*row];
                Site::Member {
                    argument,
                    operand: 0,
                    member: gathering.add(name, coefficients),
                }
            }
            _ => Site::Kept,
        });
    (sites.collect(), gatherings)
}

/// The families of which only single values are used, with which those are.
fn taken_apart(program: &Program) -> BTreeMap<ValueId, Vec<bool>> {
    let mut apart: BTreeMap<ValueId, Vec<bool>> = BTreeMap::new();
    let mut whole: Vec<ValueId> = program.outputs.iter().map(|(_, value)| *value).collect();
    for (value, instruction) in (0..).map(ValueId).zip(&program.instructions) {
        match instruction.op {
            Op::Family(id, _) => {
                let members = program.families[id.0 as usize].members.len();
                apart.insert(value, vec![false; members]);
            }
            Op::Element(values, row, _) => {
                if let Some(used) = apart.get_mut(&values) {
                    used[row] = true;
                }
            }
            ref op => whole.extend(op.operands()),
        }
    }
    for value in whole {
        apart.remove(&value);
    }
    apart
}

/// A polynomial with literal arguments folded.
enum Reduced {
    Number(f64),
    /// The argument that is left, and the coefficients from the highest power down.
    Univariate(usize, Vec<f64>),
}

/// Evaluates what of a scheme depends on numbers; `None` if more than one argument is left, or a number outside the other schemes, or if a
/// coefficient overflows.
fn reduce(horner: &Horner, numbers: &[Option<f64>]) -> Option<Reduced> {
    let (argument, leading, steps) = match horner {
        Horner::Constant(c) => return Some(Reduced::Number(*c)),
        Horner::Scheme {
            argument,
            leading,
            steps,
        } => (*argument, leading, steps),
    };
    let number = |horner: &Horner| match reduce(horner, numbers)? {
        Reduced::Number(c) => Some(c),
        Reduced::Univariate(..) => None,
    };
    let mut coefficients = vec![number(leading)?];
    for step in steps {
        // r*z == r*z + -0 (exact)
        coefficients.push(step.as_ref().map_or(Some(-0.0), number)?);
    }
    match numbers[argument] {
        None => Some(Reduced::Univariate(argument, coefficients)),
        Some(z) => {
            let member = FamilyMember {
                name: String::new(),
                coefficients,
            };
            Some(member.eval(z, false))
                .filter(|value| value.is_finite())
                .map(Reduced::Number)
        }
    }
}
