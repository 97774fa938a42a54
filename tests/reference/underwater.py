"""Rigid body in water by hand, in the matrix form of Fossen (2011): M, C(nu) from M by his theorem 3.2, D(nu), g(eta), J(eta).

Numbers of BlueROV2 Heavy after Wu (2018); `p` scales added mass, drag and its torque.
"""

import numpy as np

from real import cos, inverse, sin, solve

MASS, GRAVITY, BUOYANCY, Z_G = 11.5, 9.81, 114.8, 0.02
INERTIA, ADDED = 0.16, np.array([5.5, 12.7, 14.57, 0.12, 0.12, 0.12])
LINEAR, SQUARE = np.array([4.03, 6.22, 5.18, 0.07, 0.07, 0.07]), np.array([18.18, 21.66, 36.99, 1.55, 1.55, 1.55])
SHAKING = np.diag([0.1, 0.1, 0.1, 0.01, 0.01, 0.01])


def skew(a):
    """S(a) b = a x b."""
    x, y, z = a
    return np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]])


def turn(axis, angle):
    """Rotation about a coordinate axis."""
    c, s, one = cos(angle), sin(angle), 1 + 0 * angle
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.array([[0 * one] * 3] * 3)
    R[axis, axis], R[i, i], R[j, j], R[i, j], R[j, i] = one, c, c, -s, s
    return R


def rotation(x):
    """From the body to the Earth."""
    phi, theta, psi = x[0][3:]
    return turn(2, psi) @ turn(1, theta) @ turn(0, phi)


def kinematics(x, p):
    """J(eta): the rates of the Euler angles are what the body rates are made of."""
    phi, theta = x[0][3:5]
    one = 1 + 0 * phi
    made_of = np.array(
        [[one, 0 * one, -sin(theta)], [0 * one, cos(phi), cos(theta) * sin(phi)], [0 * one, -sin(phi), cos(theta) * cos(phi)]]
    )
    zero = np.array([[0 * one] * 3] * 3)
    return np.block([[rotation(x), zero], [zero, inverse(made_of)]])


def mass_matrix(x, p):
    """M = M_RB + M_A about the origin of the body frame."""
    zero = 0 * x[0][0]
    arm = MASS * skew(np.array([zero, zero, Z_G + zero]))
    rigid = np.block([[MASS * np.eye(3) + zero, -arm], [arm, INERTIA * np.eye(3) + zero]])
    return rigid + p["added_scale"] * np.diag(ADDED)


def velocity_gain(x, p):
    """M^-1."""
    return inverse(mass_matrix(x, p))


def noise_effectiveness(x, p):
    """Of white forces and moments."""
    return velocity_gain(x, p) @ SHAKING


def velocity_drift(x, p):
    """-M^-1 (C(nu) nu + D(nu) nu + g(eta))."""
    M, nu = mass_matrix(x, p), x[1]
    momentum = M @ nu
    C = np.block([[0 * M[:3, :3], -skew(momentum[:3])], [-skew(momentum[:3]), -skew(momentum[3:])]])
    scale = np.concatenate([[p["drag_scale"]] * 3, [p["torque_scale"]] * 3])
    drag = scale * (LINEAR + SQUARE * np.abs(nu)) * nu
    phi, theta = x[0][3:5]
    excess, righting = MASS * GRAVITY - BUOYANCY, Z_G * MASS * GRAVITY
    g = np.array(
        [
            excess * sin(theta), -excess * cos(theta) * sin(phi), -excess * cos(theta) * cos(phi),
            righting * cos(theta) * sin(phi), righting * sin(theta), 0 * phi,
        ]
    )  # fmt: skip
    return -solve(M, C @ nu + drag + g)
