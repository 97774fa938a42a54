"""tests/specs/lookup.yaml, by hand."""

from pathlib import Path

import numpy as np

from atmosphere import density
from problem import Block, Bounded, Noise, NoiseBound, Problem
from real import cos, log, sin, sqrt, tanh
from specs import DEG, funnel
from steps import smooth_step
from tables import Cubic, Line, Table, grid

FILE = Path(__file__).parents[1] / "specs" / "data" / "lookup.csv"


BOWL = Table(Cubic, *grid(FILE, ("u", "v"), "bowl"))
HINGE = Table(Line, *grid(FILE, ("u", "v"), "flat"))  # mm
SPRING = Table(Cubic, [[a * DEG for a in (-150, -70, -20, 0, 35, 80, 150)]], [-2.1, -1.4, -0.3, 0, 0.5, 1.2, 1.9])
CUBE = Table(
    Line,
    [[-1, 0.125, 1], [-1, 1], [-1, -0.25, 1]],
    [[[0.1, 0.4, 0.2], [0.3, -0.2, 0.5]], [[0.6, 0.1, -0.3], [0.2, 0.3, 0.1]], [[-0.2, 0.4, 0.7], [0.1, 0.2, -0.4]]],
)
PROFILE = Table(Cubic, [[-1, 0.9, 2.1, 3.2, 4.3, 6]], [0, 0.3, 0.5, 0.1, -0.3, 0.2])


def bowl_slope(u, v):
    """Derivative of BOWL by v: of the spline in v through the splines in u."""
    axis_u, axis_v = BOWL.axes
    values = [axis_u.at(u, list(BOWL.values[:, j])) for j in range(len(axis_v.points))]
    if not axis_v.points[0] <= v <= axis_v.points[-1]:
        return 0 * v
    i = axis_v.interval(v)
    second = [sum(axis_v.bend[j, k] * w for k, w in enumerate(values)) for j in (i, i + 1)]
    h = axis_v.points[i + 1] - axis_v.points[i]
    a, b = (axis_v.points[i + 1] - v) / h, (v - axis_v.points[i]) / h
    slope = (values[i + 1] - values[i]) / h + ((3 * b**2 - 1) * second[1] - (3 * a**2 - 1) * second[0]) * h / 6
    return float(slope) if isinstance(v, float) else slope


def lookup():
    """Two blocks with tables and functions."""

    def outer_drift(x, p):
        a1, a2 = x[0]
        first = -p["drag"] * a1 + 0.2 * BOWL(a1, a2) + density(20000 + a2 * 5000)
        second = 0.3 * SPRING(a1) - 0.8 * tanh(a2 / 0.8) + 0.1 * bowl_slope(a1, a2) + 0.2 * HINGE(a2, a1)
        return np.array([first, second])

    def outer_gain(x, p):
        return np.array([[2 + 0.2 * smooth_step(x[0][0], -1, 1), 0.0], [0.0, 1.5]])

    def outer_noise(x, p):
        a1, a2 = x[0]
        return np.array([[0.1 * BOWL(a2, a1)], [0.05 * log(a1 + sqrt(a1**2 + 1))]])

    def inner_drift(x, p):
        (a1, _), (b1, b2) = x
        turned = [cos(a1) * b1 - sin(a1) * b2, sin(a1) * b1 + cos(a1) * b2, 0.0]
        first = -min(max(b1, -1), 1) + CUBE(tanh(a1), tanh(b2), tanh(b1))
        return np.array([first, 0.3 * turned[1] - 0.2 * turned[2] - 0.1 * (abs(b1) + abs(b2))])

    outer = Block(
        "outer", np.array([0.2, -0.1]), outer_drift, outer_gain,
        K=np.full(2, 2.0), kbar=2.0, C=10 * np.eye(2), filter=np.full(2, 0.05), eta_2=0.8, eta_3=1.2,
        noise=Noise(outer_noise, np.array([0.5])),
        noise_bound=NoiseBound(0.5, 0.2, 0.7, 5.0, 1.0, 0.05),
    )
    inner = Block(
        "inner", np.array([0.1, 0.0]), inner_drift, lambda x, p: np.array([[3.0, 0.2], [0.2, 3.0]]),
        K=np.full(2, 5.0), kbar=4.0, C=30 * np.eye(2), eta_1=0.9,
        disturbance=Bounded(lambda t: np.array([0.2 * smooth_step(t, 1, 2), 0.1 * SPRING(t)])), observer=10 * np.eye(2),
        constraint=funnel(1.5, 0.5),
    )

    def slope(t):
        step = 1e-30 if not isinstance(t, float) else 1e-6
        return (PROFILE(t + step) - PROFILE(t - step)) / (2 * step)

    reference = (lambda t: np.array([PROFILE(t), 0.3 * sin(t)]), lambda t: np.array([slope(t), 0.3 * cos(t)]))
    return Problem(
        "lookup", 2, [outer, inner], reference, np.array([5.0, 4.0]), {"drag": 0.5}, {"drag": (0.4, 0.6)}, 5.0, 0.002, 1.0,
        substeps=2,
    )
