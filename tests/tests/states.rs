//! The derivation makes no state that the control does not depend on: nothing is stored, and advanced in every sample, for nobody.

use std::collections::BTreeSet;

use nsv_codegen::ir::{Op, Program, ValueId};
use nsv_codegen::opt::optimise;
use nsv_tests::specification::{compiled, specifications};

/// The states, as `state.NAME`, that values depend on within a sample.
fn states_behind(program: &Program, values: &[ValueId]) -> BTreeSet<String> {
    let mut needed = vec![false; program.instructions.len()];
    for value in values {
        needed[value.0 as usize] = true;
    }
    let mut states = BTreeSet::new();
    for index in (0..needed.len()).rev().collect::<Vec<_>>() {
        match &program.instructions[index].op {
            _ if !needed[index] => {}
            Op::Input(at) => {
                let name = &program.inputs[*at].name;
                states.extend(name.starts_with("state.").then(|| name.clone()));
            }
            op => op
                .operands()
                .iter()
                .for_each(|operand| needed[operand.0 as usize] = true),
        }
    }
    states
}

/// The states that the control depends on in this sample or in a later one.
fn states_that_matter(program: &Program) -> BTreeSet<String> {
    let of_names = |wanted: &dyn Fn(&str) -> bool| -> Vec<ValueId> {
        let outputs = program.outputs.iter();
        outputs
            .filter(|(name, _)| wanted(name))
            .map(|(_, id)| *id)
            .collect()
    };
    let mut states = states_behind(program, &of_names(&|name| name == "u_sat"));
    loop {
        let advanced = of_names(&|name| {
            name.strip_prefix("next.")
                .is_some_and(|state| states.contains(&format!("state.{state}")))
        });
        let more = states_behind(program, &advanced);
        if more.is_subset(&states) {
            return states;
        }
        states.extend(more);
    }
}

#[test]
fn every_state_of_a_controller_reaches_its_control() {
    for path in ["specs", "tests/specs"]
        .into_iter()
        .flat_map(specifications)
    {
        let program = optimise(compiled(&path).1.control);
        let states = program
            .inputs
            .iter()
            .map(|input| input.name.clone())
            .filter(|name| name.starts_with("state."));
        let states: BTreeSet<String> = states.collect();
        assert!(!states.is_empty(), "{}", path.display());
        assert_eq!(states_that_matter(&program), states, "{}", path.display());
    }
}
