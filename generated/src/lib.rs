// SHA-256 of the text below: 4106b374fe90c7de5b336d95f4a4ff2d0c1bf6e8c5aa6e4ff60a7b816971933c
//! Committed output of the nsv compiler, one module per specification under `specs/`.
#![no_std]
#![forbid(unsafe_code)]

/// Active suspension on a rough road
#[rustfmt::skip]
pub mod active_suspension;

/// Chaotic system of Genesio and Tesi following a sine
#[rustfmt::skip]
pub mod chaotic_jerk;

/// Robot link with an elastic joint
#[rustfmt::skip]
pub mod flexible_joint;

/// Statically unstable hypersonic vehicle
#[rustfmt::skip]
pub mod ghv_unstable;

/// Missile pitch autopilot with lookup tables at a falling Mach number
#[rustfmt::skip]
pub mod missile_pitch;

/// Arm driven by a DC motor with current dynamics
#[rustfmt::skip]
pub mod motor_arm;

/// Attitude control of a near space vehicle with multi-source disturbances
#[rustfmt::skip]
pub mod nsv_attitude;

/// The attitude controller on a near space vehicle that climbs and accelerates
#[rustfmt::skip]
pub mod nsv_six_dof;

/// Single-link arm in a gusty wind
#[rustfmt::skip]
pub mod pendulum;

/// Quadrotor attitude in gusts
#[rustfmt::skip]
pub mod quadrotor;

/// Six-joint arm with an unknown load
#[rustfmt::skip]
pub mod six_joint_arm;

/// Surface vessel in waves and a current
#[rustfmt::skip]
pub mod surface_vessel;

/// Two-link arm with an unknown load
#[rustfmt::skip]
pub mod two_link_arm;

/// Underwater vehicle in waves and a current
#[rustfmt::skip]
pub mod underwater_vehicle;
