"""specs/missile_pitch.yaml, by hand: coefficients from the same files, splines of tables.py."""

from pathlib import Path

import numpy as np

from library import DEG, funnel
from problem import Block, Bounded, Network, Problem, Truth
from real import cos, sin
from steps import path
from tables import Cubic, Table, grid

DATA = Path(__file__).parents[2] / "specs/data"
PRESSURE, AREA, DIAMETER, MASS, INERTIA, SOUND, MACH = 46601.5, 0.0408773, 0.2286, 204.023, 247.437, 315.895, 3.0
FIN_FORCE, FIN_MOMENT, AXIAL = -0.034, -0.206, -0.3  # per degree of the fin; axial force coefficient
# 0.7 p M^2 is the dynamic pressure: accelerations over M^2 are the force over m V and the moment over the inertia.
TURN = 0.7 * PRESSURE * AREA / (MASS * SOUND)
SPIN = 0.7 * PRESSURE * AREA * DIAMETER / INERTIA


def _table(file, column):
    """Of incidence in radians and Mach number."""
    (incidences, machs), values = grid(DATA / file, ("alpha", "mach"), column)
    return Table(Cubic, [[a * DEG for a in incidences], machs], values)


NORMAL = _table("missile_normal_force.csv", "CN")
MOMENT = _table("missile_moment.csv", "CM")


def truth(t, x, z, u, p):
    """With the lift of the fin, at the Mach number of the moment: the speed of sound does not change with it, so M' is V' over it."""
    (alpha,), (q,), (mach,), (fin,) = x[0], x[1], z, u
    fin = p["fin_scale"] * fin / DEG
    force = p["CN_scale"] * NORMAL(alpha, mach) + FIN_FORCE * fin
    moment = p["CM_scale"] * MOMENT(alpha, mach) + FIN_MOMENT * fin
    return {
        "x1": np.array([q + TURN * mach * force * cos(alpha)]),
        "x2": np.array([SPIN * mach**2 * moment]),
        "truth": np.array([TURN * mach**2 * (AXIAL * cos(alpha) - abs(force * sin(alpha)))]),
    }


def missile_pitch():
    """The controller does without the lift of the fin, at Mach 3."""
    incidence = Block(
        "incidence", np.array([0.0]), lambda x, p: np.array([TURN * MACH * p["CN_scale"] * NORMAL(x[0][0], MACH) * cos(x[0][0])]),
        lambda x, p: np.array([[1.0]]),
        K=np.array([8.0]), kbar=8.0, C=20 * np.eye(1), filter=np.array([0.02]), eta_1=1.0, eta_2=1.0, eta_3=1.0,
        disturbance=Bounded(lambda t: np.array([0.02 * sin(3 * t)])), observer=10 * np.eye(1), constraint=funnel(4 * DEG, 2 * DEG, 3.0),
    )
    rate = Block(
        "rate", np.array([0.0]), lambda x, p: np.array([SPIN * MACH**2 * p["CM_scale"] * MOMENT(x[0][0], MACH)]),
        lambda x, p: np.array([[SPIN * MACH**2 * p["fin_scale"] * FIN_MOMENT / DEG]]),
        K=np.array([20.0]), kbar=20.0, C=50 * np.eye(1), eta_1=1.0,
        disturbance=Bounded(lambda t: np.array([sin(5 * t)])), observer=30 * np.eye(1),
        network=Network(2, lambda x: np.concatenate(x), 2, np.array([1.0]), 1.0, 0.1),
    )
    degrees, degrees_dot = path(0.0, (12, 0.2, 0.7), (-18, 1.5, 2.1), (14, 3.0, 3.6))
    reference = (lambda t: np.array([degrees(t)]) * DEG), (lambda t: np.array([degrees_dot(t)]) * DEG)
    scales = {"CN_scale": (0.75, 1.25), "CM_scale": (0.75, 1.25), "fin_scale": (0.85, 1.15)}
    return Problem(
        "missile_pitch", 1, [incidence, rate], reference, np.array([25 * DEG]), {name: 1.0 for name in scales}, scales, 5.0, 0.001, 1.0,
        substeps=2, truth=Truth(np.array([3.0]), truth), actuator=(4.76e-3, 600 * DEG),
    )  # fmt: skip
