"""The specifications of this repository, by hand: plants in numpy, gains retyped from the YAML files."""

import numpy as np

import ghv
from problem import Block, Bounded, ErrorBound, Exosystem, Network, Noise, NoiseBound, Problem
from real import cos, exp, pi_like, sin

DEG = np.pi / 180


def funnel(start, end, decay=1.0):
    """k(t) = start exp(-decay t) + end, and k'(t)."""
    return (lambda t: start * exp(-decay * t) + end), (lambda t: -decay * start * exp(-decay * t))


def nsv_attitude(x_cg=0.0):
    """Flagship: the paper's scenario."""
    bounded = Bounded(lambda t: 0.02 * exp(-t / 10) * np.array([sin(2 * t), sin(t), sin(2 * t)]))
    excited = ([[0, 3], [-3, 0]], [[1, 0], [0, 1]])
    exosystem = Exosystem.of_channels([(*excited, row, [0, 0]) for row in ([0, 2], [3, 0], [1, 1])])
    noise = Noise(lambda x, p: ghv.noise_effectiveness(x, p, x_cg), np.array([0.05] * 3))
    attitude = Block(
        "attitude",
        np.array([0.5, 0.5, 0.0]) * DEG,
        lambda x, p: ghv.attitude_drift(x, p, x_cg),
        ghv.attitude_gain,
        K=np.full(3, 1.5), kbar=2.0, C=20 * np.eye(3), filter=np.full(3, 0.1), eta_1=1.0, eta_2=1.0, eta_3=1.0,
        disturbance=bounded, observer=10 * np.eye(3), constraint=funnel(3 * DEG, 0.5 * DEG),
        network=Network(3, lambda x: x[0], 3, np.full(3, 0.1), 1.0, 0.1),
    )
    rates = Block(
        "rates",
        np.zeros(3),
        lambda x, p: ghv.rates_drift(x, p, x_cg),
        lambda x, p: np.diag([1 / ghv.IXX, 1 / ghv.IYY, 1 / ghv.IZZ]) + 0 * x[0][0],
        K=np.full(3, 2.0), kbar=2.0, C=50 * np.eye(3), eta_1=0.1, eta_noise=0.1,
        disturbance=exosystem, noise=noise,
        observer=np.array([[-1.5, 0, 0], [1.5, 0, 0], [0, 1.5, 0], [0, 1, 0], [0, 0, -2], [0, 0, 4]]),
        constraint=funnel(3.0, 0.5),
        network=Network(3, lambda x: x[1], 3, np.full(3, 0.1), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.full(3, 2.0)),
        noise_bound=NoiseBound(1.0, 0.1, 1.0, 10.0, 2.0, 0.01),
    )
    scales = [f"{c}_scale" for c in ("CL", "CD", "CY", "Cl", "Cm", "Cn")]
    return Problem(
        "nsv_attitude", 3, [attitude, rates], (_nsv_reference, _nsv_reference_dot), np.array([2e6, 2e7, 2e7]),
        {name: 1.0 for name in scales}, {name: (0.8, 1.2) for name in scales}, 20.0, 0.002, 4.5,
    )


def _nsv_reference(t):
    """y_r (83)."""
    pi = pi_like(t)
    alpha = 2.5 * sin(pi * t / 4 - pi / 2) + 1.5 if t <= 4 else 4 + 0 * t
    return np.array([alpha, sin(3 * pi * t / 10) / 2, -2 * sin(t) + cos(t / 2) / 2]) * DEG


def _nsv_reference_dot(t):
    """y_r'."""
    pi = pi_like(t)
    alpha = 2.5 * pi / 4 * cos(pi * t / 4 - pi / 2) if t <= 4 else 0 * t
    return np.array([alpha, 3 * pi / 20 * cos(3 * pi * t / 10), -2 * cos(t) - sin(t / 2) / 4]) * DEG
