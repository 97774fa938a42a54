"""The specifications in tests/specs, by hand."""

import numpy as np

from problem import Block, Bounded, ErrorBound, Exosystem, Network, Noise, NoiseBound, Problem
from real import atan, cos, exp, log, sin, sqrt, tanh
from specs import funnel


def every_term():
    """Three blocks with the terms that the plants in specs/ lack."""

    def outer_drift(x, p):
        a1, a2 = x[0]
        lift = 0.3 * a1 - 0.2 * a2**2 + 0.05 * a1**2 * a2 + 0.01
        slope = -0.4 * a2 + 0.05 * a1**2
        return np.array([-p["stiffness"] * a1 + 0.3 * sin(a2) + lift, 0.2 * a1 * a2 - p["offset"] + 0.1 * slope])

    def middle_drift(x, p):
        (a1, a2), (b1, b2) = x[:2]
        length = sqrt(b1**2 + b2**2)
        first = 0.2 * a1 - 0.1 * b1 + 0.1 * max(a1, b2) - 0.2 * b1 * length
        return np.array([first, 0.05 * a1 + 0.3 * b1 + 0.1 * min(a2, b1) ** 2 - 0.2 * b2 * length])

    def inner_drift(x, p):
        a1, (b1, b2), (c1, c2) = x[0][0], x[1], x[2]
        return np.array([-c1 * sqrt(1 + c2**2) + 0.1 * (b1**2 + b2**2), exp(-(a1**2)) * c1 - log(2 + abs(c2))])

    def disturbance(t):
        held = 0.3 + 0 * t if t < 2 else 0.3 * cos(t - 2)
        return np.array([held, 0.1 * atan(1 / (1 + t**2))])

    outer = Block(
        "outer", np.array([0.2, -0.1]), outer_drift,
        lambda x, p: np.array([[2 + 0.5 * sin(x[0][0]), 0.3], [-0.2, 1.5]]),
        K=np.array([2.0, 3.0]), kbar=1e-3, C=np.diag([10.0, 20.0]), filter=np.array([0.05, 0.04]),
        eta_1=0.5, eta_2=0.8, eta_3=1.2, eta_noise=0.2,
        disturbance=Exosystem.of_channels(
            [([[0]], np.zeros((1, 0)), [1], [0.3]), ([[0, 1], [-4, -0.4]], [[0], [0.3]], [1, 0.5], [0, 0])]
        ),
        noise=Noise(lambda x, p: np.array([[0.1, 0.02 * x[0][0]], [0.0, 0.1]]), np.array([0.5, 1.0])),
        observer=np.array([[3, 0.5], [0.2, 3], [0, 6]]),
        network=Network(2, lambda x: np.array([x[0][0] / 2, x[0][1]]), 2, np.array([0.5, 1.0]), 2.0, 0.1, "complete"),
        error_bound=ErrorBound(0.2, np.array([1.0, 2.0])),
        noise_bound=NoiseBound(0.5, 0.2, 0.7, 5.0, 1.0, 0.05),
    )
    middle = Block(
        "middle", np.array([0.0, 0.1]), middle_drift,
        lambda x, p: np.array([[1.5, 0.0], [0.4 * tanh(x[1][0]), 2 + cos(x[0][0])]]),
        K=np.full(2, 5.0), kbar=4.0, C=np.array([[30.0, 5.0], [-4.0, 40.0]]), filter=np.full(2, 0.01),
        eta_1=0.9, eta_2=0.4, eta_3=0.7, eta_noise=0.3,
        disturbance=Bounded(disturbance),
        noise=Noise(lambda x, p: np.array([[0.1], [0.2 * cos(x[0][0])]]), np.array([0.3])),
        observer=np.array([[15.0, 1.0], [2.0, 12.0]]), constraint=funnel(1.5, 0.5),
        noise_bound=NoiseBound(1.0, 0.1, 1.1, 4.0, 2.0, 0.02),
    )
    inner = Block(
        "inner", np.array([0.1, 0.0]), inner_drift, lambda x, p: np.array([[3.0, 0.5], [0.0, 4.0]]),
        K=np.full(2, 20.0), kbar=20.0, C=80 * np.eye(2),
        noise=Noise(lambda x, p: np.array([[0.05, 0.1, 0.02 * x[1][0]], [0.1, 0.0, 0.05]]), np.array([1.0, 0.5, 0.2])),
        constraint=((lambda t: 2 + 0.3 * sin(t)), (lambda t: 0.3 * cos(t))),
        network=Network(
            3, lambda x: np.array([x[0][0], x[1][0] / 2, x[2][0] * x[2][1] / 0.5]), 3, np.full(2, 0.3), 0.5, 0.2
        ),
        error_bound=ErrorBound(0.3, np.full(2, 0.5)),
        noise_bound=NoiseBound(0.8, 0.3, 0.9, 3.0, 0.5, 0.01),
    )
    reference = (
        lambda t: np.array([sin(t) / 2, 0.3 * cos(2 * t)]),
        lambda t: np.array([cos(t) / 2, -0.6 * sin(2 * t)]),
    )
    return Problem(
        "every_term", 2, [outer, middle, inner], reference, np.array([5.0, 4.0]), {"stiffness": 0.6, "offset": 0.1},
        {"stiffness": (0.4, 0.6), "offset": (0.05, 0.15)}, 5.0, 0.002, 1.0, norm="spectral", barrier_margin=0.002, substeps=2,
    )


def single_block():
    """n = 1, width 1."""
    only = Block(
        "only", np.array([0.2]), lambda x, p: -(x[0] ** 3), lambda x, p: np.array([[1.5 + sin(x[0][0])]]),
        K=np.array([3.0]), kbar=3.0, C=10 * np.eye(1), eta_1=1.0, eta_noise=0.1,
        disturbance=Bounded(lambda t: np.array([0.4 * sin(2 * t)])),
        noise=Noise(lambda x, p: np.array([[0.2]]), np.array([0.5])), observer=8 * np.eye(1), constraint=funnel(1.0, 0.3),
        network=Network(3, lambda x: x[0], 1, np.array([0.5]), 1.0, 0.1),
        noise_bound=NoiseBound(1.0, 0.1, 1.0, 5.0, 1.0, 0.02),
    )
    reference = (lambda t: np.array([sin(t)]), lambda t: np.array([cos(t)]))
    return Problem("single_block", 1, [only], reference, np.array([3.0]), {}, {}, 5.0, 0.005, 1.0)


def exact_chain():
    """n = 3, width 1, commands differentiated exactly."""
    first = Block(
        "first", np.array([0.1]), lambda x, p: -0.5 * sin(x[0]), lambda x, p: np.array([[2 + cos(x[0][0])]]),
        K=np.array([2.0]), kbar=2.0, C=10 * np.eye(1), eta_1=1.0, eta_2=1.0, eta_3=1.0,
        disturbance=Bounded(lambda t: np.array([0.2 * sin(t)])), observer=6 * np.eye(1), constraint=funnel(1.0, 0.3),
    )
    second = Block(
        "second", np.array([0.0]), lambda x, p: x[0] * x[1] - 0.2 * x[1],
        lambda x, p: np.array([[1.5 + 0.5 * tanh(x[0][0])]]),
        K=np.array([4.0]), kbar=4.0, C=20 * np.eye(1), eta_1=1.0, eta_2=0.5, eta_3=1.0, eta_noise=0.1,
        disturbance=Exosystem.of_channels([([[0, 2], [-2, 0]], [[0.1, 0], [0, 0.1]], [1, 0], [0.3, 0])]),
        noise=Noise(lambda x, p: np.array([[0.1 * (1 + x[0][0] ** 2)]]), np.array([0.4])),
        observer=np.array([[8.0], [3.0]]),
        network=Network(2, lambda x: np.array([x[0][0], x[1][0]]), 2, np.array([0.2]), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.array([1.0])), noise_bound=NoiseBound(1.0, 0.1, 1.0, 5.0, 1.0, 0.02),
    )
    third = Block(
        "third", np.array([0.0]), lambda x, p: -x[2] + x[0] * x[1], lambda x, p: np.array([[3.0]]),
        K=np.array([20.0]), kbar=20.0, C=50 * np.eye(1),
    )
    reference = (
        lambda t: np.array([0.5 * sin(t) + 0.1 * cos(2 * t)]),
        lambda t: np.array([0.5 * cos(t) - 0.2 * sin(2 * t)]),
    )
    return Problem(
        "exact_chain", 1, [first, second, third], reference, np.array([20.0]), {}, {}, 5.0, 0.001, 1.0, exact=True
    )
