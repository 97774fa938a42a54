// SHA-256 of the text below: 383d52882dbbe9c4a677ff59aa4d766f940520ed21803aae2c089e1491c3c1fe
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

/// Arm driven by a DC motor with current dynamics
#[rustfmt::skip]
pub mod motor_arm;

/// Attitude control of a near space vehicle with multi-source disturbances
#[rustfmt::skip]
pub mod nsv_attitude;

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
