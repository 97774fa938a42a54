// SHA-256 of the text below: 6eea44aa550384bf3cccea982bcd25e6982d9b89ec73466d46ff2ce0d6bc0bbb
//! Committed output of the nsv compiler, one module per specification under `specs/`.
#![no_std]
#![forbid(unsafe_code)]

/// Robot link with an elastic joint
#[rustfmt::skip]
pub mod flexible_joint;

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

/// Underwater vehicle in waves and a current
#[rustfmt::skip]
pub mod underwater_vehicle;
