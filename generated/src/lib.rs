//! Committed output of the nsv compiler, one module per specification under `specs/`.
#![no_std]

pub mod motor_arm;
pub mod nsv_attitude;
pub mod pendulum;
pub mod two_link_arm;
