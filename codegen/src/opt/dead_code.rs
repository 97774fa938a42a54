//! Dead code elimination: only what an output needs is computed, and only the tables that it needs are kept. Names do not keep a value
//! alive; inputs of the program stay, as they are its interface.

use crate::ir::{
    BasisId, FamilyId, Instruction, Op, PolynomialId, Program, TableFamilyId, TableId, ValueId,
};

/// Removes unused instructions, polynomials, bases and origins.
pub(crate) fn run(program: Program) -> Program {
    let needed = live(&program);
    keep_needed(program, &needed)
}

/// As [`run`], but keeps what a name needs too.
pub(super) fn run_for_names(program: Program) -> Program {
    let needed = needed(&program, |instruction| instruction.name.is_some());
    keep_needed(program, &needed)
}

fn keep_needed(mut program: Program, needed: &[bool]) -> Program {
    let source = std::mem::take(&mut program.instructions);
    let mut moved = vec![ValueId(0); source.len()];
    for (index, mut instruction) in source
        .into_iter()
        .enumerate()
        .filter(|&(index, _)| needed[index])
    {
        instruction.op = instruction
            .op
            .map_operands(|operand| moved[operand.0 as usize]);
        moved[index] = ValueId(
            u32::try_from(program.instructions.len())
                .expect("invariant: fewer than 2^32 instructions"),
        );
        program.instructions.push(instruction);
    }
    for (_, value) in &mut program.outputs {
        *value = moved[value.0 as usize];
    }
    drop_tables(&mut program);
    program
}

/// Which instructions an output depends on.
pub(crate) fn live(program: &Program) -> Vec<bool> {
    needed(program, |_| false)
}

/// Which instructions an output or an instruction of interest depends on.
fn needed(program: &Program, of_interest: impl Fn(&Instruction) -> bool) -> Vec<bool> {
    let mut needed: Vec<bool> = program.instructions.iter().map(of_interest).collect();
    for (_, value) in &program.outputs {
        needed[value.0 as usize] = true;
    }
    for (index, instruction) in program.instructions.iter().enumerate().rev() {
        if needed[index] {
            for operand in instruction.op.operands() {
                needed[operand.0 as usize] = true;
            }
        }
    }
    needed
}

fn drop_tables(program: &mut Program) {
    let mut polynomials = vec![false; program.polynomials.len()];
    let mut tables = vec![false; program.tables.len()];
    let mut table_families = vec![false; program.table_families.len()];
    let mut families = vec![false; program.families.len()];
    let mut bases = vec![false; program.bases.len()];
    let mut origins = vec![false; program.origins.len()];
    for instruction in &program.instructions {
        match instruction.op {
            Op::Polynomial(id, _) => polynomials[id.0 as usize] = true,
            Op::Table(id, ..) => tables[id.0 as usize] = true,
            Op::TableFamily(id, _) => {
                table_families[id.0 as usize] = true;
                for member in &program.table_families[id.0 as usize].members {
                    tables[member.table.0 as usize] = true;
                }
            }
            Op::Family(id, _) => families[id.0 as usize] = true,
            Op::Basis(id, _) | Op::BasisRate(id, ..) | Op::BasisRate2(id, ..) => {
                bases[id.0 as usize] = true
            }
            _ => {}
        }
        if let Some(origin) = instruction.origin {
            origins[origin] = true;
        }
    }
    let (polynomials, bases) = (
        keep(&mut program.polynomials, &polynomials),
        keep(&mut program.bases, &bases),
    );
    let tables = keep(&mut program.tables, &tables);
    let table_families = keep(&mut program.table_families, &table_families);
    let members = program.table_families.iter_mut();
    for TableId(id) in members.flat_map(|family| family.members.iter_mut().map(|m| &mut m.table)) {
        *id = tables[*id as usize];
    }
    let families = keep(&mut program.families, &families);
    let origins = keep(&mut program.origins, &origins);
    for instruction in &mut program.instructions {
        match &mut instruction.op {
            Op::Polynomial(PolynomialId(id), _) => *id = polynomials[*id as usize],
            Op::Table(TableId(id), ..) => *id = tables[*id as usize],
            Op::TableFamily(TableFamilyId(id), _) => *id = table_families[*id as usize],
            Op::Family(FamilyId(id), _) => *id = families[*id as usize],
            Op::Basis(BasisId(id), _)
            | Op::BasisRate(BasisId(id), ..)
            | Op::BasisRate2(BasisId(id), ..) => *id = bases[*id as usize],
            _ => {}
        }
        if let Some(origin) = &mut instruction.origin {
            *origin = origins[*origin] as usize;
        }
    }
}

/// Keeps the marked entries and gives the new position of each.
fn keep<T>(table: &mut Vec<T>, marked: &[bool]) -> Vec<u32> {
    let mut marks = marked.iter();
    table.retain(|_| *marks.next().expect("invariant: a mark for each entry"));
    let positions = marked.iter().scan(0, |next, &mark| {
        let position = *next;
        *next += u32::from(mark);
        Some(position)
    });
    positions.collect()
}
