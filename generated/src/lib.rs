//! Committed output of the nsv compiler, one module per specification under `specs/`.
#![no_std]

pub mod pendulum;
