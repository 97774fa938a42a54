//! The conditions that every pass and every back end may rely on.

use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};

use super::build::size;
use super::print::is_word;
use super::{FamilyMember, Instruction, Op, Program, Shape, Type, ValueId};

/// A broken condition; instructions are meant by their value.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(
    missing_docs,
    reason = "fields are the value, its operand, or the name that is meant"
)]
pub enum Violation {
    /// An operand is not an earlier instruction.
    OperandNotEarlier { value: ValueId, operand: ValueId },
    /// The operands, inputs or tables do not fit the operation.
    IllTyped { value: ValueId },
    /// The declared type is not the one that follows from the operands.
    WrongType {
        value: ValueId,
        declared: Type,
        inferred: Type,
    },
    /// A literal is infinite or not a number; it could not be written in Rust.
    NonFiniteLiteral { value: ValueId },
    /// An origin out of range.
    NoSuchOrigin { value: ValueId },
    /// A name that is not made of letters, digits, `_`, `.` and `/`.
    NotAWord { name: String },
    /// A name given twice among the inputs, among the values, among the outputs, among polynomials and bases, or among tables and their families.
    DuplicateName { name: String },
    /// A value named like an input that it is not.
    ShadowsInput { value: ValueId, name: String },
    /// An output of no instruction.
    NoSuchOutput { name: String, value: ValueId },
    /// An output that is the factors of a matrix.
    FactorsAsOutput { name: String },
    /// A vector or matrix type with no entries.
    EmptyShape { name: String },
    /// A lookup table whose breaks or coefficients do not fit its arguments.
    BadTable { name: String },
    /// A family of tables that is empty, or has members that are equal, that do not exist or whose axes differ.
    BadTableFamily { name: String },
    /// Polynomial data with a non-finite coefficient or a wrong number of exponents.
    BadPolynomial { name: String },
    /// A polynomial family that is empty, or has a member without a name of its own or with coefficients that are missing or not finite.
    BadFamily { name: String },
    /// A basis whose monomials lack an earlier one to be made from, or with a wrong number of exponents.
    BadBasis { name: String },
}

impl Display for Violation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Violation::OperandNotEarlier { value, operand } => {
                write!(f, "{value} uses {operand}, which is not earlier")
            }
            Violation::IllTyped { value } => {
                write!(f, "{value} has operands that do not fit its operation")
            }
            Violation::WrongType {
                value,
                declared,
                inferred,
            } => write!(f, "{value} is declared {declared}, but is {inferred}"),
            Violation::NonFiniteLiteral { value } => {
                write!(f, "{value} is a literal that is not finite")
            }
            Violation::NoSuchOrigin { value } => {
                write!(f, "{value} has an origin that does not exist")
            }
            Violation::NotAWord { name } => write!(f, "`{name}` is not a word"),
            Violation::DuplicateName { name } => write!(f, "`{name}` is named twice"),
            Violation::ShadowsInput { value, name } => {
                write!(f, "{value} has the name of the input `{name}`")
            }
            Violation::NoSuchOutput { name, value } => {
                write!(f, "output `{name}` is {value}, which does not exist")
            }
            Violation::FactorsAsOutput { name } => {
                write!(f, "output `{name}` is the factors of a matrix")
            }
            Violation::EmptyShape { name } => write!(f, "`{name}` has no entries"),
            Violation::BadTable { name } => write!(f, "table `{name}` is malformed"),
            Violation::BadTableFamily { name } => {
                write!(f, "family of tables `{name}` is malformed")
            }
            Violation::BadPolynomial { name } => write!(f, "polynomial `{name}` is malformed"),
            Violation::BadFamily { name } => write!(f, "polynomial family `{name}` is malformed"),
            Violation::BadBasis { name } => write!(f, "basis `{name}` is malformed"),
        }
    }
}

/// Every broken condition of a program, in its order; empty for a sound program.
pub fn verify(program: &Program) -> Vec<Violation> {
    let mut violations = Vec::new();
    check_inputs(program, &mut violations);
    check_tables(program, &mut violations);
    check_instructions(program, &mut violations);
    check_outputs(program, &mut violations);
    violations
}

impl Program {
    /// Panics with the list of violations, which are compiler bugs, if there are any.
    pub fn assert_sound(&self) {
        let violations = verify(self);
        let list: Vec<String> = violations.iter().map(Violation::to_string).collect();
        assert!(
            violations.is_empty(),
            "invariant: program `{}` is sound, found: {}",
            self.name,
            list.join("; ")
        );
    }
}

fn check_inputs(program: &Program, violations: &mut Vec<Violation>) {
    check_names(program.inputs.iter().map(|input| &input.name), violations);
    for input in program.inputs.iter().filter(|input| size(input.shape) == 0) {
        violations.push(Violation::EmptyShape {
            name: input.name.clone(),
        });
    }
}

fn check_tables(program: &Program, violations: &mut Vec<Violation>) {
    let polynomials = program.polynomials.iter().map(|data| &data.name);
    check_names(
        polynomials
            .chain(program.families.iter().map(|family| &family.name))
            .chain(program.bases.iter().map(|basis| &basis.name)),
        violations,
    );
    for data in &program.polynomials {
        if data
            .terms
            .iter()
            .any(|(c, exponents)| !c.is_finite() || exponents.len() != data.arguments.len())
        {
            violations.push(Violation::BadPolynomial {
                name: data.name.clone(),
            });
        }
    }
    let tables = program.tables.iter().map(|table| &table.name);
    let table_families = program.table_families.iter().map(|family| &family.name);
    check_names(tables.chain(table_families), violations);
    for table in program.tables.iter().filter(|table| !table.is_sound()) {
        violations.push(Violation::BadTable {
            name: table.name.clone(),
        });
    }
    let families = program.table_families.iter();
    for family in families.filter(|family| !family.is_sound(&program.tables)) {
        violations.push(Violation::BadTableFamily {
            name: family.name.clone(),
        });
    }
    for family in &program.families {
        let names: BTreeSet<&String> = family.members.iter().map(|member| &member.name).collect();
        let sound = |member: &FamilyMember| {
            is_word(&member.name)
                && !member.coefficients.is_empty()
                && member.coefficients.iter().all(|c| c.is_finite())
        };
        let distinct = names.len() == family.members.len() && !names.is_empty();
        if !distinct || !family.members.iter().all(sound) {
            violations.push(Violation::BadFamily {
                name: family.name.clone(),
            });
        }
    }
    for basis in &program.bases {
        let lengths = basis
            .exponents
            .iter()
            .all(|exponents| exponents.len() == basis.inputs.len());
        if !lengths || basis.exponents.is_empty() || basis.recipe().is_none() {
            violations.push(Violation::BadBasis {
                name: basis.name.clone(),
            });
        }
    }
}

fn check_instructions(program: &Program, violations: &mut Vec<Violation>) {
    check_names(
        program
            .instructions
            .iter()
            .filter_map(|instruction| instruction.name.as_ref()),
        violations,
    );
    let inputs: BTreeSet<&String> = program.inputs.iter().map(|input| &input.name).collect();
    for (value, instruction) in (0..).map(ValueId).zip(&program.instructions) {
        if instruction
            .origin
            .is_some_and(|origin| origin >= program.origins.len())
        {
            violations.push(Violation::NoSuchOrigin { value });
        }
        if let Some(name) = instruction
            .name
            .as_ref()
            .filter(|name| inputs.contains(name))
        {
            let is_it = matches!(instruction.op, Op::Input(index) if program.inputs.get(index).is_some_and(|input| input.name == *name));
            if !is_it {
                violations.push(Violation::ShadowsInput {
                    value,
                    name: name.clone(),
                });
            }
        }
        check_operation(program, value, instruction, violations);
    }
}

fn check_operation(
    program: &Program,
    value: ValueId,
    instruction: &Instruction,
    violations: &mut Vec<Violation>,
) {
    let declared = instruction.ty;
    let operands = instruction.op.operands();
    let late: Vec<ValueId> = operands
        .into_iter()
        .filter(|&operand| operand >= value)
        .collect();
    if !late.is_empty() {
        violations.extend(
            late.into_iter()
                .map(|operand| Violation::OperandNotEarlier { value, operand }),
        );
        return;
    }
    let fills =
        |count: usize| matches!(declared, Type::Real(shape) if count == size(shape) && count > 0);
    match &instruction.op {
        Op::Const(data) if fills(data.len()) => {
            if data.iter().any(|entry| !entry.is_finite()) {
                violations.push(Violation::NonFiniteLiteral { value });
            }
        }
        Op::Array(items)
            if fills(items.len())
                && items
                    .iter()
                    .all(|&item| program.ty(item) == Type::Real(Shape::Scalar)) => {}
        op => match program.type_of(op) {
            None => violations.push(Violation::IllTyped { value }),
            Some(inferred) if inferred != declared => violations.push(Violation::WrongType {
                value,
                declared,
                inferred,
            }),
            Some(_) => {}
        },
    }
}

fn check_outputs(program: &Program, violations: &mut Vec<Violation>) {
    check_names(program.outputs.iter().map(|(name, _)| name), violations);
    for (name, value) in &program.outputs {
        match program.instructions.get(value.0 as usize) {
            None => violations.push(Violation::NoSuchOutput {
                name: name.clone(),
                value: *value,
            }),
            Some(instruction) if matches!(instruction.ty, Type::Ldlt(_)) => {
                violations.push(Violation::FactorsAsOutput { name: name.clone() });
            }
            Some(_) => {}
        }
    }
}

/// Names are words and differ.
fn check_names<'a>(names: impl Iterator<Item = &'a String>, violations: &mut Vec<Violation>) {
    let mut seen = BTreeSet::new();
    for name in names {
        if !is_word(name) {
            violations.push(Violation::NotAWord { name: name.clone() });
        }
        if !seen.insert(name) {
            violations.push(Violation::DuplicateName { name: name.clone() });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOUND: &str = "program p
input x: vec2
polynomial f(a) = 2.0 [1]
table k(a) = breaks [0.0, 1.0], linear clamp [2.0, 3.0]
tables m(a) = k [0], k [1]
family h(a) = p [1.0, -0.0], q [2.0]
basis b(a, c) = [0, 0], [1, 0]
origin \"group\" \"y = 2 x\"
%0: vec2 = input x
%1: real = const 2.0
%2 y: vec2 = mul %0, %1 @0   ; y = 2 x
%3: real = element %0, 1, 0
%4: real = polynomial f, %3
%5: vec2 = basis b, %0
%6: vec2 = family h, %3
%7: real = table k 1, %3
%8: vec2 = tables m, %3
output y = %2
";

    /// Replaces a piece of the sound program and expects these violations.
    fn check(found: &str, planted: &str, expected: &[&str]) {
        assert!(SOUND.contains(found), "{found}");
        let program: Program = SOUND
            .replacen(found, planted, 1)
            .parse()
            .expect("a readable program");
        let violations: Vec<String> = verify(&program).iter().map(Violation::to_string).collect();
        assert_eq!(violations, expected, "{planted}");
    }

    #[test]
    fn sound_program_has_no_violation() {
        check("y", "y", &[]);
    }

    #[test]
    fn planted_faults_are_found() {
        check("[2.0, 3.0]", "[2.0, 3.0, 4.0]", &["table `k` is malformed"]);
        check(
            "breaks [0.0, 1.0]",
            "breaks [0.0, 0.0]",
            &["table `k` is malformed"],
        );
        check(
            "table k 1, %3",
            "table k 2, %3",
            &["%7 has operands that do not fit its operation"],
        );
        for family in [
            "k [0], k [0]",
            "k [0], k [2]",
            "k [0], k [0, 1]",
            "k [0], #1 [0]",
            "",
        ] {
            let expected: &[&str] = match family {
                "" => &[
                    "family of tables `m` is malformed",
                    "%8 is declared vec2, but is vec0",
                ],
                _ => &["family of tables `m` is malformed"],
            };
            check("k [0], k [1]", family, expected);
        }
        check(
            "tables m, %3",
            "tables m, %3, %3",
            &["%8 has operands that do not fit its operation"],
        );
        check(
            "mul %0, %1",
            "mul %0, %2",
            &["%2 uses %2, which is not earlier"],
        );
        check(
            "mul %0, %1",
            "mul %9, %3",
            &[
                "%2 uses %9, which is not earlier",
                "%2 uses %3, which is not earlier",
            ],
        );
        check(
            "mul %0, %1",
            "dot %0, %1",
            &["%2 has operands that do not fit its operation"],
        );
        check(
            "mul %0, %1",
            "powi %0, 1",
            &["%2 has operands that do not fit its operation"],
        );
        check(
            "mul %0, %1",
            "not %0",
            &["%2 has operands that do not fit its operation"],
        );
        check(
            "mul %0, %1",
            "dot %0, %0",
            &["%2 is declared vec2, but is real"],
        );
        check(
            "element %0, 1, 0",
            "element %0, 2, 0",
            &["%3 has operands that do not fit its operation"],
        );
        check(
            "element %0, 1, 0",
            "array %0",
            &["%3 has operands that do not fit its operation"],
        );
        check(
            "input x\n%1",
            "input #1\n%1",
            &["%0 has operands that do not fit its operation"],
        );
        check(
            "polynomial f, %3",
            "polynomial f, %3, %3",
            &["%4 has operands that do not fit its operation"],
        );
        check(
            "polynomial f, %3",
            "polynomial #7, %3",
            &["%4 has operands that do not fit its operation"],
        );
        check(
            "basis b, %0",
            "basis_rate b, %0, %3",
            &["%5 has operands that do not fit its operation"],
        );
        check(
            "const 2.0",
            "const inf",
            &["%1 is a literal that is not finite"],
        );
        check(
            "const 2.0",
            "const [1.0, 2.0]",
            &["%1 has operands that do not fit its operation"],
        );
        check("@0", "@1", &["%2 has an origin that does not exist"]);
        check("%3: real", "%3 y: real", &["`y` is named twice"]);
        check("%3: real", "%3 y#: real", &["`y#` is not a word"]);
        check(
            "%3: real",
            "%3 x: real",
            &["%3 has the name of the input `x`"],
        );
        check(
            "output y = %2",
            "output y = %2\noutput y = %3",
            &["`y` is named twice"],
        );
        check(
            "output y = %2",
            "output y = %9",
            &["output `y` is %9, which does not exist"],
        );
        check("2.0 [1]", "2.0 [1, 1]", &["polynomial `f` is malformed"]);
        check("2.0 [1]", "NaN [1]", &["polynomial `f` is malformed"]);
        check("p [1.0", "p [inf", &["polynomial family `h` is malformed"]);
        check("q [2.0]", "q []", &["polynomial family `h` is malformed"]);
        check(
            "q [2.0]",
            "p [2.0]",
            &["polynomial family `h` is malformed"],
        );
        check(
            "family h, %3",
            "family h, %0",
            &["%6 has operands that do not fit its operation"],
        );
        check(
            "[0, 0], [1, 0]",
            "[0, 0], [2, 0]",
            &["basis `b` is malformed"],
        );
        check(
            "input x: vec2",
            "input x: vec2\ninput z: vec0",
            &["`z` has no entries"],
        );
        check(
            "input x: vec2",
            "input x: vec2\ninput x: vec2",
            &["`x` is named twice"],
        );
    }
}
