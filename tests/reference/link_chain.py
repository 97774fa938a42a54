"""tests/specs/link_chain.yaml, by hand."""

import numpy as np

from problem import Block, Bounded, Problem
from real import cos, inverse, sin, solve
from specs import DEG

COUNT = 4
SIZE = 50.0  # m l^2
SHARES = np.eye(COUNT) - np.eye(COUNT, k=1)
LAG = 0.02


def coupling(i, j):
    """Slender links beyond the joint, counted from 0; to three digits, as the specification has them."""
    links = COUNT - max(i, j) - 1
    return round(links + 1 / 3, 3) if i == j else links + 0.5


def entries(x, p, function):
    """a_ij f(theta_i - theta_j)."""
    entry = lambda i, j: SIZE * p["scale"] * coupling(i, j) * function(x[0][i] - x[0][j])
    return np.array([[entry(i, j) for j in range(COUNT)] for i in range(COUNT)])


def link_chain():
    """Four links in a plane, motors with a lag."""
    mass_matrix = lambda x, p: entries(x, p, cos)
    spin = lambda x, p: entries(x, p, sin) @ (x[1] * x[1])
    angle = Block(
        "angle", np.array([5.0, 0, -5, 5]) * DEG, lambda x, p: 0 * x[0], lambda x, p: np.eye(COUNT),
        K=np.full(COUNT, 4.0), kbar=2.0, C=10 * np.eye(COUNT), filter=np.full(COUNT, 0.02), eta_2=1.0, eta_3=1.0,
    )
    rate = Block(
        "rate", np.zeros(COUNT), lambda x, p: -solve(mass_matrix(x, p), spin(x, p)),
        lambda x, p: inverse(mass_matrix(x, p)) @ SHARES,
        K=np.full(COUNT, 16.0), kbar=8.0, C=20 * np.eye(COUNT), filter=np.full(COUNT, 0.005), eta_1=1.0, eta_2=1.0, eta_3=2.0,
        disturbance=Bounded(lambda t: 0.1 * np.array([sin(t), 0 * t, 1 + 0 * t, 0 * t])), observer=20 * np.eye(COUNT),
    )
    motor = Block(
        "motor", np.zeros(COUNT), lambda x, p: -x[2] / LAG, lambda x, p: np.eye(COUNT) / LAG,
        K=np.full(COUNT, 40.0), kbar=20.0, C=50 * np.eye(COUNT),
    )
    size = np.array([30.0, 40, 50, 60]) * DEG
    reference = (lambda t: size * sin(t), lambda t: size * cos(t))
    return Problem(
        "link_chain", COUNT, [angle, rate, motor], reference, np.full(COUNT, 2000.0), {"scale": 1.0}, {"scale": (0.9, 1.1)},
        5.0, 0.001, 2.0, substeps=2,
    )
