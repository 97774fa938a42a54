//! Simulated runs of the test specifications, compiled by the program as a user has it.

mod clocks;
mod imperfect;
mod platen;
mod program;
