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
fn a_plant_whose_clock_has_dispersed_parameters_takes_the_time_itself() {
    check_campaign("dispersed_clock", &[]);
}
