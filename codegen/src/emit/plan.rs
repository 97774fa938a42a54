//! Which values of a program become statements, and in what order: every named value and output does, an unnamed value does when it is
//! used twice or when the formula around it would grow too long, and the rest are written in place.

use std::collections::{BTreeMap, BTreeSet};

use crate::ir::{Op, Operator, Program, Shape, Type, ValueId};
use crate::opt::dead_code::live;

/// Largest number of operations and operands in one formula; a longer one is cut by a temporary.
const WEIGHT: usize = 18;

/// The statements of a function.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// Statements in an order in which each uses only earlier ones.
    pub(crate) steps: Vec<Step>,
    /// Names of the values that have one: of the signal, or of the first output that is the value.
    pub(crate) labels: BTreeMap<ValueId, String>,
    /// Whether an output depends on the value.
    pub(crate) live: Vec<bool>,
}

/// A named value with the temporaries that it is the first to need.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    /// Values that get a `let t1`, `let t2`, ...
    pub(crate) temporaries: Vec<ValueId>,
    /// The value that gets a `let` of its name.
    pub(crate) value: ValueId,
}

impl Plan {
    /// The plan of a program. What no output needs is left out.
    pub(crate) fn new(program: &Program) -> Plan {
        let live = live(program);
        let labels = labels(program, &live);
        let bound = bound(program, &live, &labels);
        let steps = Order {
            program,
            live: &live,
            bound: &bound,
            labels: &labels,
        }
        .steps();
        Plan {
            steps,
            labels,
            live,
        }
    }
}

/// Names of live values; inputs have theirs already.
fn labels(program: &Program, live: &[bool]) -> BTreeMap<ValueId, String> {
    let mut labels = BTreeMap::new();
    let is_input = |id: ValueId| matches!(program.instruction(id).op, Op::Input(_));
    for (id, instruction) in ids(program) {
        if let Some(name) = &instruction.name
            && live[id.0 as usize]
            && !is_input(id)
        {
            labels.insert(id, name.clone());
        }
    }
    for (name, id) in &program.outputs {
        if !is_input(*id) {
            labels.entry(*id).or_insert_with(|| name.clone());
        }
    }
    labels
}

fn ids(program: &Program) -> impl Iterator<Item = (ValueId, &crate::ir::Instruction)> {
    (0u32..).map(ValueId).zip(&program.instructions)
}

fn bound(program: &Program, live: &[bool], labels: &BTreeMap<ValueId, String>) -> Vec<bool> {
    let mut uses = vec![0usize; live.len()];
    let mut repeated = vec![false; live.len()];
    for (id, instruction) in ids(program).filter(|(id, _)| live[id.0 as usize]) {
        for operand in instruction.op.operands() {
            uses[operand.0 as usize] += 1;
        }
        if let Some(operand) = evaluated_repeatedly(program, id) {
            repeated[operand.0 as usize] = true;
        }
        // Values of a function on an array are named after its arguments.
        if let Op::Apply(_, array) = instruction.op
            && let Op::Array(arguments) = &program.instruction(array).op
        {
            for argument in arguments {
                repeated[argument.0 as usize] = true;
            }
        }
    }
    let mut bound = vec![false; live.len()];
    let mut weights = vec![1usize; live.len()];
    for (id, instruction) in ids(program).filter(|(id, _)| live[id.0 as usize]) {
        let index = id.0 as usize;
        bound[index] = labels.contains_key(&id);
        if is_atom(program, id) {
            continue;
        }
        weights[index] = weigh(&instruction.op, &mut weights, &mut bound);
        // The values of a family have names, which are taken from a variable.
        bound[index] |= uses[index] > 1 || repeated[index] || instruction.op.is_family();
        if bound[index] {
            weights[index] = 1;
        }
    }
    bound
}

/// The weight of a formula, after its heaviest operands became temporaries until it is light enough. The entries of an array stand in
/// lines of their own and stay.
fn weigh(op: &Op, weights: &mut [usize], bound: &mut [bool]) -> usize {
    let operands = op.operands();
    loop {
        let weight = 1
            + literal_size(op)
            + operands
                .iter()
                .map(|operand| weights[operand.0 as usize])
                .sum::<usize>();
        let heaviest = operands
            .iter()
            .map(|operand| operand.0 as usize)
            .max_by_key(|&operand| weights[operand]);
        match heaviest {
            Some(operand)
                if weight > WEIGHT && weights[operand] > 1 && !matches!(op, Op::Array(_)) =>
            {
                bound[operand] = true;
                weights[operand] = 1;
            }
            _ => return weight,
        }
    }
}

/// Whether a value is as short as a name wherever it stands: inputs, scalar literals, entries.
fn is_atom(program: &Program, id: ValueId) -> bool {
    let instruction = program.instruction(id);
    match instruction.op {
        Op::Input(_) | Op::Element(..) => true,
        Op::Const(_) => matches!(instruction.ty, Type::Bool | Type::Real(Shape::Scalar)),
        _ => false,
    }
}

fn literal_size(op: &Op) -> usize {
    if let Op::Const(data) = op {
        data.len()
    } else {
        0
    }
}

/// The operand that the emitted form of an operation evaluates more than once or takes an entry of.
fn evaluated_repeatedly(program: &Program, id: ValueId) -> Option<ValueId> {
    let scalar = |id: ValueId| program.ty(id) == Type::Real(Shape::Scalar);
    match program.instruction(id).op {
        Op::Element(array, ..) => Some(array),
        Op::Select(condition, ..) if program.ty(id) == Type::Bool => Some(condition),
        Op::Binary(Operator::Add | Operator::Sub | Operator::Mul, ..) => None,
        Op::Binary(_, a, b) if scalar(a) && !scalar(b) => Some(a),
        Op::Binary(_, a, b) if scalar(b) && !scalar(a) => Some(b),
        _ => None,
    }
}

/// Ordering of the statements.
struct Order<'a> {
    program: &'a Program,
    live: &'a [bool],
    bound: &'a [bool],
    labels: &'a BTreeMap<ValueId, String>,
}

impl Order<'_> {
    /// Labelled values in an order that keeps the statements of one group together where the dependencies allow it.
    fn steps(&self) -> Vec<Step> {
        let mut waiting = Waiting::new(self.program, self.live);
        let mut ready = Ready::default();
        let start = waiting.independent();
        self.release(start, &mut waiting, &mut ready);
        let mut steps = Vec::new();
        let mut placed = vec![false; self.bound.len()];
        let mut group = None;
        while let Some(id) = ready.take(group) {
            group = self.group(id);
            steps.push(Step {
                temporaries: self.temporaries(id, &mut placed),
                value: id,
            });
            let users = waiting.users_of(id);
            self.release(users, &mut waiting, &mut ready);
        }
        steps
    }

    /// Makes labelled values whose operands are known ready, and looks through unlabelled ones.
    fn release<'s>(&'s self, known: Vec<ValueId>, waiting: &mut Waiting, ready: &mut Ready<'s>) {
        let mut pending = known;
        while let Some(id) = pending.pop() {
            if self.labels.contains_key(&id) {
                ready.add(self.group(id), id);
            } else {
                pending.extend(waiting.users_of(id));
            }
        }
    }

    /// The group of a value's origin, if it has a name.
    fn group(&self, id: ValueId) -> Option<&str> {
        let origin = self.program.instruction(id).origin?;
        let group = self.program.origins.get(origin)?.group.as_str();
        Some(group).filter(|group| !group.is_empty())
    }

    /// The temporaries that `id` needs and that are not placed yet.
    fn temporaries(&self, id: ValueId, placed: &mut [bool]) -> Vec<ValueId> {
        let mut needed = BTreeSet::new();
        let mut pending = self.program.instruction(id).op.operands();
        placed[id.0 as usize] = true;
        while let Some(operand) = pending.pop() {
            let index = operand.0 as usize;
            if !std::mem::replace(&mut placed[index], true) {
                if self.bound[index] {
                    needed.insert(operand);
                }
                pending.extend(self.program.instruction(operand).op.operands());
            }
        }
        needed.into_iter().collect()
    }
}

/// Live values that wait for operands.
struct Waiting {
    /// Operands of each value that are not known yet.
    operands: Vec<usize>,
    users: Vec<Vec<ValueId>>,
}

impl Waiting {
    fn new(program: &Program, live: &[bool]) -> Waiting {
        let mut operands = vec![0; live.len()];
        let mut users = vec![Vec::new(); live.len()];
        for (id, instruction) in ids(program).filter(|(id, _)| live[id.0 as usize]) {
            for operand in instruction.op.operands() {
                operands[id.0 as usize] += 1;
                users[operand.0 as usize].push(id);
            }
        }
        for (operands, _) in operands.iter_mut().zip(live).filter(|(_, live)| !**live) {
            *operands = usize::MAX;
        }
        Waiting { operands, users }
    }

    /// Live values without operands.
    fn independent(&self) -> Vec<ValueId> {
        let ids = (0u32..).map(ValueId).zip(&self.operands);
        ids.filter(|(_, operands)| **operands == 0)
            .map(|(id, _)| id)
            .collect()
    }

    /// The users of a value, known from now on, that wait for nothing else.
    fn users_of(&mut self, id: ValueId) -> Vec<ValueId> {
        let mut users = std::mem::take(&mut self.users[id.0 as usize]);
        users.retain(|user| {
            let operands = &mut self.operands[user.0 as usize];
            *operands -= 1;
            *operands == 0
        });
        users
    }
}

/// Labelled values that can be placed.
#[derive(Default)]
struct Ready<'a> {
    by_group: BTreeSet<(Option<&'a str>, ValueId)>,
    /// Those of some group first.
    by_order: BTreeMap<(bool, ValueId), Option<&'a str>>,
}

impl<'a> Ready<'a> {
    fn add(&mut self, group: Option<&'a str>, id: ValueId) {
        self.by_group.insert((group, id));
        self.by_order.insert((group.is_none(), id), group);
    }

    /// Takes the first value of the group, or of any group, or of none.
    fn take(&mut self, group: Option<&'a str>) -> Option<ValueId> {
        let of_group = group.and_then(|group| {
            let range = (Some(group), ValueId(0))..=(Some(group), ValueId(u32::MAX));
            self.by_group.range(range).next().copied()
        });
        let (group, id) = match of_group {
            Some(found) => found,
            None => {
                let (&(_, id), &group) = self.by_order.first_key_value()?;
                (group, id)
            }
        };
        self.by_group.remove(&(group, id));
        self.by_order.remove(&(group.is_none(), id));
        Some(id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_of_a_group_stay_together() {
        let text = "input a: real\norigin \"one\" \"\"\norigin \"two\" \"\"\n%0: real = input a\n%1 p: real = sin %0 @0\n\
                    %2 q: real = cos %0 @1\n%3 r: real = neg %1 @0\n%4 s: real = add %2, %3 @1\noutput s = %4";
        let program: Program = text.parse().expect("a program");
        let order: Vec<u32> = Plan::new(&program)
            .steps
            .iter()
            .map(|step| step.value.0)
            .collect();
        assert_eq!(order, [1, 3, 2, 4]);
    }

    #[test]
    fn long_formulas_are_cut() {
        let mut program = Program {
            inputs: vec![crate::ir::Input {
                name: "a".into(),
                shape: Shape::Scalar,
            }],
            ..Program::default()
        };
        let a = program.push(Op::Input(0));
        let sum = (0..5000).fold(a, |sum, _| program.binary(Operator::Add, sum, a));
        program.outputs.push(("y".into(), sum));
        let plan = Plan::new(&program);
        assert_eq!(plan.steps.len(), 1);
        assert!((200..1000).contains(&plan.steps[0].temporaries.len()));
    }

    #[test]
    fn what_no_output_needs_is_left_out() {
        let text = "input a: real\n%0: real = input a\n%1 p: real = sin %0\n%2 q: real = cos %0\noutput q = %2";
        let plan = Plan::new(&text.parse().expect("a program"));
        assert_eq!(
            plan.steps
                .iter()
                .map(|step| step.value.0)
                .collect::<Vec<_>>(),
            [2]
        );
        assert_eq!(plan.live, [true, false, true]);
    }
}
