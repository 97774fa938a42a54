// SHA-256 of the text below: 268a01cd2f42411d328a51b6e7a50e3989fdbb63b644c85d9362f432f21aaf67
//! Committed output of the nsv compiler, one module per specification under `specs/`.
#![no_std]
#![forbid(unsafe_code)]

/// Arm driven by a DC motor with current dynamics
#[rustfmt::skip]
pub mod motor_arm;

/// Attitude control of a near space vehicle with multi-source disturbances
#[rustfmt::skip]
pub mod nsv_attitude;

/// Single-link arm in a gusty wind
#[rustfmt::skip]
pub mod pendulum;

/// Two-link arm with an unknown load
#[rustfmt::skip]
pub mod two_link_arm;
