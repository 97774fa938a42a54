"""PUMA 560 by hand: mass matrix and gravity after Armstrong, Khatib and Burdick (1986) with a point load, C(q, q') q' of Lagrange's
equations from derivatives of the mass matrix.

`python tests/reference/six_joint_arm.py` compares mass matrix and gravity with Newton and Euler's recursion over the links' own masses,
centres and inertias of the same paper, at random angles.
"""

import numpy as np

from problem import Block, Bounded, Problem
from real import cos, inverse, sin, solve, tanh
from library import DEG, funnel, gentle

GRAVITY, UPPER_ARM, FOREARM, SHOULDER = 9.81, 0.4318, 0.4331, 0.1501
BREAK_AWAY = np.array([6.3, 5.5, 2.6, 1.3, 1.0, 1.2])


def entries(q):
    """Of the arm's mass matrix without load: M_11, M_12, M_13, M_22, M_23, M_33."""
    s_2, c_2, s_23, c_23, s_3 = sin(q[1]), cos(q[1]), sin(q[1] + q[2]), cos(q[1] + q[2]), sin(q[2])
    return (
        2.57 + 1.38 * c_2**2 + 0.3 * s_23**2 + 0.744 * c_2 * s_23, 0.69 * s_2 + 0.0238 * c_2 - 0.134 * c_23, -0.134 * c_23,
        6.79 + 0.744 * s_3, 0.333 + 0.372 * s_3, 1.16 + 0 * s_3,
    )  # fmt: skip


def slopes(q):
    """Of those entries by q2, and by q3."""
    s_2, c_2, s_23, c_23, c_3 = sin(q[1]), cos(q[1]), sin(q[1] + q[2]), cos(q[1] + q[2]), cos(q[2])
    both = 0.6 * s_23 * c_23
    zero = 0 * s_2
    by_2 = (
        -2.76 * c_2 * s_2 + both + 0.744 * (c_2 * c_23 - s_2 * s_23), 0.69 * c_2 - 0.0238 * s_2 + 0.134 * s_23, 0.134 * s_23,
        zero, zero, zero,
    )  # fmt: skip
    return by_2, (both + 0.744 * c_2 * c_23, 0.134 * s_23, 0.134 * s_23, 0.744 * c_3, 0.372 * c_3, zero)


def symmetric(six):
    """The matrix of these entries."""
    a, b, c, d, e, f = six
    return np.array([[a, b, c], [b, d, e], [c, e, f]])


def load_jacobian(q):
    """Of the load's place about the first axis: rows are directions across, outward and up; and its slopes by q2 and by q3."""
    s_2, c_2, s_23, c_23 = sin(q[1]), cos(q[1]), sin(q[1] + q[2]), cos(q[1] + q[2])
    zero = 0 * s_2
    across = UPPER_ARM * c_2 + FOREARM * s_23
    out_2, out_3 = -UPPER_ARM * s_2 + FOREARM * c_23, FOREARM * c_23
    up_2, up_3 = -UPPER_ARM * c_2 - FOREARM * s_23, -FOREARM * s_23
    J = np.array([[across, zero, zero], [-SHOULDER + zero, out_2, out_3], [zero, up_2, up_3]])
    by_2 = np.array([[out_2, zero, zero], [zero, up_2, up_3], [zero, -out_2, -out_3]])
    by_3 = np.array([[out_3, zero, zero], [zero, up_3, up_3], [zero, -out_3, -out_3]])
    return J, by_2, by_3


def arm(q, load):
    """Mass matrix of the first three joints and its slopes by q2 and by q3."""
    J, by_2, by_3 = load_jacobian(q)
    M = symmetric(entries(q)) + load * (J.T @ J)
    return M, *(symmetric(s) + load * (d.T @ J + J.T @ d) for s, d in zip(slopes(q), (by_2, by_3)))


def mass_matrix(q, p):
    """M(q) with the wrist, which is of itself."""
    M = np.diag([0.0, 0, 0, 0.2, 0.18, 0.19]) + 0 * q[0]
    M[:3, :3] = arm(q, p["load"])[0]
    return M


def gravity(q, load):
    """g(q)."""
    s_23, c_23 = sin(q[1] + q[2]), cos(q[1] + q[2])
    _, pull_2, pull_3 = load * GRAVITY * load_jacobian(q)[0][2]
    return np.array(
        [
            0 * s_23, -37.2 * cos(q[1]) - 8.4 * s_23 + 1.02 * sin(q[1]) + pull_2, -8.4 * s_23 + 0.25 * c_23 + pull_3,
            0.028 * s_23 * sin(q[3]) * sin(q[4]), -0.028 * (c_23 * sin(q[4]) + s_23 * cos(q[3]) * cos(q[4])), 0 * s_23,
        ]
    )  # fmt: skip


def drift(x, p):
    """-M^-1 (C(q, q') q' + g(q) + friction)."""
    q, v = x
    _, by_2, by_3 = arm(q, p["load"])
    w = v[:3]
    energy = np.array([0 * v[0], w @ by_2 @ w, w @ by_3 @ w]) / 2
    coriolis = (by_2 * v[1] + by_3 * v[2]) @ w - energy
    torque = gravity(q, p["load"]) + p["dry_scale"] * BREAK_AWAY * tanh(v / 0.1)
    return -solve(mass_matrix(q, p), torque + np.concatenate([coriolis, 0 * w]))


def six_joint_arm():
    """Arm with a load and dry friction."""
    tool = lambda t: np.array(
        [0.2 * sin(4 * t), 0.2 * cos(4 * t), 0.5 * sin(5 * t), 3 * (1 + sin(6 * t)), 3 * sin(6 * t), 3 * cos(6 * t)]
    )
    joints = Block(
        "joints", np.array([5, -25, 5, 5, -5, 5]) * DEG, lambda x, p: 0 * x[0], lambda x, p: np.eye(6) + 0 * x[0][0],
        K=np.full(6, 6.0), kbar=2.0, C=20 * np.eye(6), filter=np.full(6, 0.005), eta_2=1.0, eta_3=1.0, constraint=funnel(0.3, 0.02, 2.0),
    )
    rates = Block(
        "rates", np.zeros(6), drift, lambda x, p: inverse(mass_matrix(x[0], p)),
        K=np.full(6, 40.0), kbar=20.0, C=50 * np.eye(6), eta_1=1.0, disturbance=Bounded(tool), observer=100 * np.eye(6),
    )
    size, pace = np.array([60, 40, 50, 60, 45, 60]) * DEG, np.array([1.5, 1, 1.5, 2, 2, 2])
    swing, swing_dot = gentle(lambda t: size * sin(pace * t), lambda t: size * pace * cos(pace * t))
    rest = np.array([0, -30, 0, 0, 0, 0]) * DEG
    return Problem(
        "six_joint_arm", 6, [joints, rates], (lambda t: rest + swing(t), swing_dot), np.array([97.6, 186.4, 89.4, 24.2, 20.1, 21.3]),
        {"load": 1.0, "dry_scale": 0.0}, {"load": (0.0, 2.0), "dry_scale": (0.5, 1.5)}, 10.0, 0.001, 4.0, substeps=2,
    )  # fmt: skip


# Links of the same paper: twist, length and offset (modified Denavit-Hartenberg), mass, centre, moments of inertia; rotors at the joints.
LINKS = [
    (0, 0, 0, 0, (0, 0, 0), (0, 0, 0.35)),
    (-np.pi / 2, 0, 0.2435, 17.4, (0.068, 0.006, -0.016), (0.13, 0.524, 0.539)),
    (0, 0.4318, -0.0934, 4.8, (0, -0.07, 0.014), (0.066, 0.0125, 0.066)),
    (np.pi / 2, -0.0203, 0.4331, 0.82, (0, 0, -0.019), (1.8e-3, 1.8e-3, 1.3e-3)),
    (-np.pi / 2, 0, 0, 0.34, (0, 0, 0), (0.3e-3, 0.3e-3, 0.4e-3)),
    (np.pi / 2, 0, 0, 0.09, (0, 0, 0.032), (0.15e-3, 0.15e-3, 0.04e-3)),
]
ROTORS = np.array([291e-6, 409e-6, 299e-6, 35e-6, 35e-6, 35e-6]) * np.array([62.6111, 107.815, 53.7063, 76.0364, 71.923, 76.686]) ** 2


def newton_euler(q, acceleration, gravity):
    """Torques at rest that give this acceleration of the joints, by recursion over the links."""
    spin, pull, axis = np.zeros(3), np.array([0, 0, gravity]), np.array([0, 0, 1.0])
    turns, places, forces, moments = [], [], [], []
    for angle, rate_dot, (twist, length, offset, mass, centre, inertia) in zip(q, acceleration, LINKS):
        c, s, ca, sa = np.cos(angle), np.sin(angle), np.cos(twist), np.sin(twist)
        R, place = np.array([[c, -s, 0], [s * ca, c * ca, -sa], [s * sa, c * sa, ca]]), np.array([length, -sa * offset, ca * offset])
        pull = R.T @ (np.cross(spin, place) + pull)
        spin = R.T @ spin + rate_dot * axis
        turns.append(R), places.append(place)
        forces.append(mass * (np.cross(spin, centre) + pull)), moments.append(np.array(inertia) * spin)
    torque, force, moment = np.zeros(6), np.zeros(3), np.zeros(3)
    for i in reversed(range(6)):
        if i < 5:
            force = turns[i + 1] @ force
            moment = turns[i + 1] @ moment + np.cross(places[i + 1], force)
        force, moment = force + forces[i], moment + moments[i] + np.cross(LINKS[i][4], forces[i])
        torque[i] = moment[2]
    return torque + ROTORS * acceleration


def main():
    """Prints the largest difference of each entry over random angles."""
    rng, difference, torque = np.random.default_rng(1), np.zeros((6, 6)), np.zeros(6)
    for q in rng.uniform(-np.pi, np.pi, (500, 6)):
        by_links = np.array([newton_euler(q, unit, 0) for unit in np.eye(6)]).T
        difference = np.maximum(difference, np.abs(by_links - mass_matrix(q, {"load": 0.0})))
        torque = np.maximum(torque, np.abs(newton_euler(q, np.zeros(6), GRAVITY) - gravity(q, 0.0)))
    np.set_printoptions(precision=3, suppress=True)
    print(f"mass matrix, kg m^2:\n{difference}\ngravity, N m:\n{torque}")


if __name__ == "__main__":
    main()
