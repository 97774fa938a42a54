//! What optimisation does to the number of operations: pass by pass, and equation by equation.

use std::collections::{BTreeMap, BTreeSet};

use super::cost::{self, Cost};
use super::{Arithmetic, optimise_watched};
use crate::ir::{Op, Program, Shape, Type, ValueId};

/// The operations of a program on its way through the optimiser.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// Name of the program.
    pub program: String,
    /// Operations of the program before all passes.
    pub lowered: Cost,
    /// Each pass that changed the program, in order.
    pub passes: Vec<PassCost>,
    /// Each quantity with an equation, in the order of the program.
    pub equations: Vec<EquationCost>,
}

/// What a pass left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PassCost {
    /// Name of the pass.
    pub name: &'static str,
    /// Round, from 1.
    pub round: usize,
    /// Instructions after it.
    pub instructions: usize,
    /// Operations after it.
    pub cost: Cost,
}

/// The operations that a quantity needs and no earlier quantity does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EquationCost {
    /// Name of the quantity.
    pub quantity: String,
    /// Group heading, such as `virtual control of block 1 (31)`.
    pub group: String,
    /// The equation.
    pub equation: String,
    /// Operations before all passes.
    pub before: Cost,
    /// Operations after all passes: none where the quantity was found to equal another one.
    pub after: Cost,
}

impl Explanation {
    /// Operations after all passes.
    pub fn optimised(&self) -> Cost {
        self.passes.last().map_or(self.lowered, |pass| pass.cost)
    }
}

/// Optimises a program and counts on the way.
pub fn explain(program: &Program, arithmetic: Arithmetic) -> Explanation {
    let mut passes = Vec::new();
    let mut last = program.clone();
    optimise_watched(program.clone(), arithmetic, |pass, round, next| {
        if *next != last {
            passes.push(PassCost {
                name: pass.name,
                round,
                instructions: next.instructions.len(),
                cost: cost::count(next),
            });
            last = next.clone();
        }
    });
    Explanation {
        program: program.name.clone(),
        lowered: cost::count(program),
        passes,
        equations: equations(program, &last),
    }
}

fn equations(before: &Program, after: &Program) -> Vec<EquationCost> {
    let mut left = by_quantity(after);
    let mut equations: Vec<EquationCost> = Vec::new();
    let entry = |program: &Program, value: Option<ValueId>, cost| {
        let instruction = value.map(|value| program.instruction(value));
        let origin = instruction.and_then(|instruction| program.origins.get(instruction.origin?));
        EquationCost {
            quantity: instruction
                .and_then(|instruction| instruction.name.clone())
                .unwrap_or_default(),
            group: origin.map_or_else(String::new, |origin| origin.group.clone()),
            equation: origin.map_or_else(String::new, |origin| origin.equation.clone()),
            before: cost,
            after: Cost::default(),
        }
    };
    for (_, (value, cost)) in order(by_quantity(before)) {
        let mut equation = entry(before, value, cost);
        if let Some((_, cost)) = left.remove(&equation.quantity) {
            equation.after = cost;
        }
        equations.push(equation);
    }
    // Names of outputs that a pass gave to values without one.
    for (_, (value, cost)) in order(left) {
        let mut equation = entry(after, value, Cost::default());
        equation.after = cost;
        equations.push(equation);
    }
    equations
}

type Quantities = BTreeMap<String, (Option<ValueId>, Cost)>;

/// In the order of the program; what no quantity needs comes last.
fn order(quantities: Quantities) -> Vec<(String, (Option<ValueId>, Cost))> {
    let mut ordered: Vec<_> = quantities.into_iter().collect();
    ordered.sort_by_key(|(_, (value, _))| (value.is_none(), *value));
    ordered
}

/// The operations of each named value: its own and those of the unnamed values that it is the first to need.
fn by_quantity(program: &Program) -> Quantities {
    let mut quantities = Quantities::new();
    let mut counter = Counter::new(program);
    for (value, instruction) in (0..).map(ValueId).zip(&program.instructions) {
        if let Some(name) = &instruction.name {
            quantities.insert(name.clone(), (Some(value), counter.count(value)));
        }
    }
    let rest = (0..).map(ValueId).zip(&program.instructions);
    let rest: Cost = rest.map(|(value, _)| counter.count(value)).sum();
    let rest = rest + counter.unused_entries();
    if rest != Cost::default() {
        quantities.insert(String::new(), (None, rest));
    }
    quantities
}

/// Counts every operation once.
struct Counter<'p> {
    program: &'p Program,
    counted: Vec<bool>,
    /// Whether single entries are all that is used of a value.
    apart: Vec<bool>,
    /// Entries of families and of functions of arrays that were counted where they are used.
    entries: BTreeSet<(ValueId, usize)>,
}

impl<'p> Counter<'p> {
    fn new(program: &'p Program) -> Self {
        Counter {
            program,
            counted: vec![false; program.instructions.len()],
            apart: apart(program),
            entries: BTreeSet::new(),
        }
    }

    /// The operations of a value and of the unnamed values that it needs, without those counted before.
    fn count(&mut self, value: ValueId) -> Cost {
        let mut pending = vec![value];
        let mut sum = Cost::default();
        while let Some(value) = pending.pop() {
            if !std::mem::replace(&mut self.counted[value.0 as usize], true) {
                sum = sum + self.own(value);
                let operands = self.program.instruction(value).op.operands();
                let unnamed = |id: &ValueId| self.program.instruction(*id).name.is_none();
                pending.extend(operands.into_iter().filter(unnamed));
            }
        }
        sum
    }

    /// The operations of an instruction; an entry of a family or of a function of an array belongs to where it is used.
    fn own(&mut self, value: ValueId) -> Cost {
        let instruction = self.program.instruction(value);
        match instruction.op {
            Op::Element(values, row, _) => self.entry(values, row),
            Op::TableFamily(id, _) => {
                cost::places_of(self.program, &self.program.table_families[id.0 as usize])
            }
            _ if self.entries_of(value) > 0 => Cost::default(),
            _ => cost::of(self.program, instruction),
        }
    }

    /// Number of entries that are counted where they are used.
    fn entries_of(&self, value: ValueId) -> usize {
        let instruction = self.program.instruction(value);
        match (&instruction.op, instruction.ty) {
            (Op::Family(id, _), _) => self.program.families[id.0 as usize].members.len(),
            (Op::TableFamily(id, _), _) => self.program.table_families[id.0 as usize].members.len(),
            (Op::Apply(..), Type::Real(Shape::Vector(n))) if self.apart[value.0 as usize] => n,
            _ => 0,
        }
    }

    fn entry(&mut self, values: ValueId, row: usize) -> Cost {
        if self.entries_of(values) == 0 || !self.entries.insert((values, row)) {
            return Cost::default();
        }
        match self.program.instruction(values).op {
            Op::Family(id, _) => cost::member(&self.program.families[id.0 as usize].members[row]),
            Op::TableFamily(id, _) => {
                let family = &self.program.table_families[id.0 as usize];
                cost::table_member(self.program, &family.members[row])
            }
            Op::Apply(function, _) => cost::elementary(function),
            _ => Cost::default(),
        }
    }

    /// The entries that no instruction uses alone.
    fn unused_entries(&mut self) -> Cost {
        let mut sum = Cost::default();
        for value in (0..).map(ValueId).take(self.program.instructions.len()) {
            for row in 0..self.entries_of(value) {
                sum = sum + self.entry(value, row);
            }
        }
        sum
    }
}

/// Whether single entries are all that is used of each value.
fn apart(program: &Program) -> Vec<bool> {
    let mut apart = vec![true; program.instructions.len()];
    for (_, output) in &program.outputs {
        apart[output.0 as usize] = false;
    }
    let whole = program
        .instructions
        .iter()
        .filter(|instruction| !matches!(instruction.op, Op::Element(..)));
    for operand in whole.flat_map(|instruction| instruction.op.operands()) {
        apart[operand.0 as usize] = false;
    }
    apart
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::random;

    #[test]
    fn equations_add_up_to_the_program() {
        for seed in 0..40 {
            let program = random::program(seed, 150);
            for arithmetic in [Arithmetic::Strict, Arithmetic::Fast] {
                let explanation = explain(&program, arithmetic);
                let sum = |part: fn(&EquationCost) -> Cost| -> Cost {
                    explanation.equations.iter().map(part).sum()
                };
                assert_eq!(sum(|equation| equation.before), explanation.lowered);
                assert_eq!(sum(|equation| equation.after), explanation.optimised());
            }
        }
    }

    #[test]
    fn an_intermediate_value_counts_for_the_first_quantity_that_needs_it() {
        let text = "input x: real\n%0: real = input x\n%1: real = sin %0\n%2 a: real = mul %1, %1\n%3 b: real = add %1, %2\n\
                    %4 c: real = mul %1, %1\noutput b = %3\noutput c = %4";
        let explanation = explain(&text.parse().expect("a program"), Arithmetic::Strict);
        let counts = |equation: &EquationCost| {
            let cells = |cost: Cost| (cost.flops(), cost.elementary);
            (
                equation.quantity.clone(),
                cells(equation.before),
                cells(equation.after),
            )
        };
        let found: Vec<_> = explanation.equations.iter().map(counts).collect();
        let expected = [
            ("a", (1, 1), (1, 1)),
            ("b", (1, 0), (1, 0)),
            ("c", (1, 0), (0, 0)),
        ];
        assert_eq!(
            found,
            expected.map(|(name, before, after)| (name.to_owned(), before, after))
        );
    }
}
