//! What depends on time alone in laws and plants that have it or not, in lanes, which compute it for several steps at once, and alone.

use super::program::check_campaign;

const NAME: &str = "single_block";
const CONSTANT_REFERENCE: [&str; 2] = ["--set", "reference.level=0.3"];
const CONSTANT_BOUND: [&str; 2] = ["--set", "controller.blocks.only.constraint=0.8"];

#[test]
fn a_law_without_functions_of_time_flies_a_plant_with_some() {
    check_campaign(NAME, &[CONSTANT_REFERENCE, CONSTANT_BOUND].concat());
}

#[test]
fn a_plant_takes_the_time_itself() {
    let drifting = "plant.blocks.only.disturbance.bounded=[t/(1 s)/(1 s)]";
    check_campaign(NAME, &["--set", drifting]);
}

#[test]
fn a_clock_of_dispersed_parameters_differs_from_run_to_run() {
    let settings = [
        "parameters={rate: {value: 2, dispersion: {uniform: [1, 3]}}}",
        "plant.blocks.only.disturbance.bounded=[0.4*sin(rate*t/(1 s))/(1 s)]",
        "controller.blocks.only.constraint=exp(-rate*t/(1 s)) + 0.3",
    ];
    check_campaign(NAME, &settings.map(|setting| ["--set", setting]).concat());
}
