"""specs/nsv_six_dof.yaml, by hand: the law of nsv_attitude, and the flown vehicle by Newton's and Euler's equations in vectors.

Axes: horizontal (north, east, down), of the flight path (turned by heading and climb), of the wind (turned on by the bank mu) and of the
body (turned on by -beta and alpha). The rates of the angles are not written out as in the specification but solved for.
"""

from dataclasses import replace

import numpy as np

import ghv
from atmosphere import density, speed_of_sound
from problem import Exosystem, Truth
from real import cos, sin, solve
from specs import DEG, nsv_attitude
from steps import path, smooth_step

EARTH, FREE_FALL, LARGEST_PUSH, LAG = 6378137.0, 9.80665, 1.5e6, 4.0


def about_x(a):
    """Components in axes turned by a about x."""
    one, c, s = 1 + 0 * a, cos(a), sin(a)
    return np.array([[one, 0 * a, 0 * a], [0 * a, c, s], [0 * a, -s, c]])


def about_y(a):
    """Components in axes turned by a about y."""
    one, c, s = 1 + 0 * a, cos(a), sin(a)
    return np.array([[c, 0 * a, -s], [0 * a, one, 0 * a], [s, 0 * a, c]])


def about_z(a):
    """Components in axes turned by a about z."""
    one, c, s = 1 + 0 * a, cos(a), sin(a)
    return np.array([[c, s, 0 * a], [-s, c, 0 * a], [0 * a, 0 * a, one]])


def truth(t, x, z, u, p):
    """Flat Earth, thrust along the body's axis that holds a speed schedule, aerodynamics at the air and Mach number of the moment."""
    (alpha, beta, mu), (airspeed, climb, heading, height) = x[0], z[:4]
    zero = 0 * airspeed
    unit = np.array([[1 + zero, zero, zero], [zero, 1 + zero, zero], [zero, zero, 1 + zero]])
    path_of, wind_of = about_y(climb) @ about_z(heading), about_x(mu)  # from horizontal axes, from those of the path
    body_of = about_y(alpha) @ about_z(-beta)  # from those of the wind
    lift, drag, side, *moments = ghv.loads(x, p, 0.0, ghv.Aerodynamics(airspeed / speed_of_sound(height)), airspeed, density(height))

    aim = 3000.0 + 150.0 * smooth_step(t, 5.0, 45.0)
    push = min(max(drag + ghv.MASS * (aim - airspeed) / LAG, 0.0), LARGEST_PUSH)
    weight = ghv.MASS * FREE_FALL * (EARTH / (EARTH + height)) ** 2
    force = np.array([-drag, side, -lift]) + body_of.T @ (push * unit[0])  # along the wind axes
    along, aside, below = (wind_of.T @ force + path_of @ (weight * unit[2])) / ghv.MASS
    heading_dot, climb_dot = aside / (airspeed * cos(climb)), -below / airspeed

    # omega = that of the path + mu' about x of the wind - beta' about z and alpha' about y of the body, all along the body's axes.
    turning = body_of @ wind_of @ (about_y(climb) @ (heading_dot * unit[2]) + climb_dot * unit[1])
    axes = np.array([unit[1], -(about_y(alpha) @ unit[2]), body_of @ unit[0]]).T
    north, east, down = path_of.T @ (airspeed * unit[0])
    inertia, omega = np.array([ghv.IXX, ghv.IYY, ghv.IZZ]), x[1]
    return {
        "x1": solve(axes, omega - turning),
        "x2": (np.array(moments) + u - np.cross(omega, inertia * omega)) / inertia,
        "truth": np.array([along, climb_dot, heading_dot, -down, north, east]),
    }


def nsv_six_dof():
    """Half the excitation of the disturbance of the rates, another reference, a minute."""
    problem = nsv_attitude()
    rates = problem.blocks[1]
    excited = ([[0, 3], [-3, 0]], [[0.5, 0], [0, 0.5]])
    rates.disturbance = Exosystem.of_channels([(*excited, row, [0, 0]) for row in ([0, 2], [3, 0], [1, 1])])
    alpha, alpha_dot = path(1.5, (1.5, 2.0, 7.0), (-1.5, 11.0, 16.0), (0.3, 38.0, 46.0))
    mu, mu_dot = path(0.0, (20.0, 18.0, 24.0), (-20.0, 38.0, 44.0))
    reference = (lambda t: np.array([alpha(t), 0 * t, mu(t)]) * DEG), (lambda t: np.array([alpha_dot(t), 0 * t, mu_dot(t)]) * DEG)
    return replace(
        problem, name="nsv_six_dof", reference=reference, horizon=60.0,
        truth=Truth(np.array([3000.0, 0.0, 0.0, 22e3, 0.0, 0.0]), truth),
    )  # fmt: skip
