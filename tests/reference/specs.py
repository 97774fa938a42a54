"""The specifications of this repository, by hand: plants in numpy, gains retyped from the YAML files."""

import numpy as np

import ghv
import underwater
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


def pendulum():
    """Single-link arm."""
    length, damping, gravity = 0.5, 0.1, 9.81
    inertia = lambda p: p["mass"] * length**2
    position = Block(
        "position", np.array([5 * DEG]), lambda x, p: 0 * x[0], lambda x, p: np.array([[1.0]]),
        K=np.array([4.0]), kbar=4.0, C=20 * np.eye(1), filter=np.array([0.02]), eta_2=1.0, eta_3=1.0,
        constraint=funnel(30 * DEG, 6 * DEG, 2.0),
    )
    speed = Block(
        "speed", np.array([0.0]),
        lambda x, p: np.array([-gravity / length * sin(x[0][0]) - damping * x[1][0] / inertia(p)]),
        lambda x, p: np.array([[1 / inertia(p)]]),
        K=np.array([10.0]), kbar=10.0, C=50 * np.eye(1), eta_1=1.0,
        disturbance=Bounded(lambda t: np.array([1 + 2 * sin(3 * t)])), observer=20 * np.eye(1),
        network=Network(2, lambda x: np.array([sin(x[0][0]), x[1][0]]), 2, np.array([1.0]), 1.0, 0.1),
    )
    reference = (lambda t: np.array([90 * DEG * sin(t)]), lambda t: np.array([90 * DEG * cos(t)]))
    return Problem(
        "pendulum", 1, [position, speed], reference, np.array([8.0]), {"mass": 1.0}, {"mass": (0.8, 1.2)}, 10.0, 0.002, 3.0
    )


def two_link_arm():
    """Two-link arm of Slotine and Li."""
    m_1, l_1, l_c1, I_1, I_e, l_ce, delta_e = 1.0, 1.0, 0.5, 0.12, 0.25, 0.6, 30 * DEG

    def mass_matrix(x, p):
        m_e, c, s = p["m_e"], cos(x[0][1]), sin(x[0][1])
        a_1 = I_1 + m_1 * l_c1**2 + I_e + m_e * l_ce**2 + m_e * l_1**2
        a_2 = I_e + m_e * l_ce**2
        a_3, a_4 = m_e * l_1 * l_ce * np.cos(delta_e), m_e * l_1 * l_ce * np.sin(delta_e)
        return a_1 + 2 * a_3 * c + 2 * a_4 * s, a_2 + a_3 * c + a_4 * s, a_2, a_3 * s - a_4 * c

    def inverse(x, p):
        m_11, m_12, m_22, _ = mass_matrix(x, p)
        return np.array([[m_22, -m_12], [-m_12, m_11]]) / (m_11 * m_22 - m_12**2)

    def drift(x, p):
        h = mass_matrix(x, p)[3]
        v_1, v_2 = x[1]
        return -inverse(x, p) @ np.array([-h * v_2 * v_1 - h * (v_1 + v_2) * v_2, h * v_1 * v_1])

    ramp = ([[0, 1], [0, 0]], np.zeros((2, 0)), [1, 0], [0.5, -0.2])
    biased_sine = ([[0, 0, 0], [0, 0, 3], [0, -3, 0]], np.zeros((3, 0)), [1, 1, 0], [1, 0, 2])
    joints = Block(
        "joints", np.array([0.1, -0.1]), lambda x, p: 0 * x[0], lambda x, p: np.eye(2),
        K=np.full(2, 4.0), kbar=4.0, C=20 * np.eye(2), filter=np.full(2, 0.02), eta_2=1.0, eta_3=1.0,
        constraint=funnel(0.3, 0.05, 2.0),
    )
    rates = Block(
        "rates", np.zeros(2), drift, inverse,
        K=np.full(2, 8.0), kbar=8.0, C=50 * np.eye(2), eta_1=1.0,
        disturbance=Exosystem.of_channels([ramp, biased_sine]),
        observer=np.array([[12.0, 0], [36, 0], [0, 8], [0, 2], [0, 11]]),
        constraint=funnel(4.0, 1.0, 2.0),
        network=Network(3, lambda x: np.array([x[1][0], x[1][1], x[0][1]]), 3, np.full(2, 1.0), 1.0, 0.1, "complete"),
        error_bound=ErrorBound(0.1, np.full(2, 1.0)),
    )
    size = np.array([30 * DEG, 45 * DEG])
    reference = (lambda t: size * (1 - cos(2 * t)), lambda t: 2 * size * sin(2 * t))
    return Problem(
        "two_link_arm", 2, [joints, rates], reference, np.array([60.0, 30.0]), {"m_e": 2.0}, {"m_e": (1.5, 2.5)},
        10.0, 0.002, 3.0, norm="spectral",
    )


def motor_arm():
    """Arm driven by a DC motor, of Dawson, Carroll and Schneider."""
    J, m, l, r, B, L, R, K_tau, K_b, g = 1.625e-3, 0.506, 0.305, 0.023, 16.25e-3, 25e-3, 5.0, 0.9, 0.9, 9.81
    inertia = lambda p: J + m * l**2 / 3 + p["load_mass"] * l**2 + 2 * p["load_mass"] * r**2 / 5
    weight = lambda p: (m / 2 + p["load_mass"]) * l * g
    position = Block(
        "position", np.array([0.1]), lambda x, p: 0 * x[0], lambda x, p: np.array([[1.0]]),
        K=np.array([6.0]), kbar=1.72, C=20 * np.eye(1), filter=np.array([0.02]),
        eta_2=1.0, eta_3=1.0, constraint=funnel(0.3, 0.05, 2.0),
    )
    speed = Block(
        "speed", np.array([0.0]),
        lambda x, p: np.array([-(B * x[1][0] + weight(p) * sin(x[0][0])) / inertia(p)]),
        lambda x, p: np.array([[K_tau / inertia(p)]]),
        K=np.array([20.0]), kbar=20.0, C=50 * np.eye(1), filter=np.array([0.005]),
        eta_1=1.0, eta_2=0.1, eta_3=2.0, eta_noise=0.1,
        disturbance=Exosystem.of_channels([([[-2]], [[0.5]], [1], [0])]), observer=np.array([[10.0]]),
        noise=Noise(lambda x, p: np.array([[0.01 / inertia(p)]]), np.array([1.0])),
        network=Network(2, lambda x: np.array([sin(x[0][0]), x[1][0]]), 2, np.array([1.0]), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.array([1.0])),
        noise_bound=NoiseBound(1.0, 0.1, 1.0, 10.0, 0.5, 0.2),
    )
    current = Block(
        "current", np.array([0.0]),
        lambda x, p: np.array([-(R * x[2][0] + K_b * x[1][0]) / L]), lambda x, p: np.array([[1 / L]]),
        K=np.array([100.0]), kbar=100.0, C=100 * np.eye(1), eta_1=1.0,
        disturbance=Bounded(lambda t: np.array([0.5 * sin(20 * t) / L])), observer=np.array([[50.0]]),
    )
    start = lambda t: 1 - exp(-t**3 / 10)
    reference = (
        lambda t: np.array([90 * DEG * sin(t) * start(t)]),
        lambda t: np.array([90 * DEG * (cos(t) * start(t) + sin(t) * 3 * t**2 / 10 * exp(-t**3 / 10))]),
    )
    return Problem(
        "motor_arm", 1, [position, speed, current], reference, np.array([40.0]), {"load_mass": 0.434},
        {"load_mass": (0.35, 0.52)}, 10.0, 0.001, 3.0, wiener=True,
    )


def flexible_joint():
    """Robot link with an elastic joint, of Spong; numbers of Ghorbel, Hung and Spong."""
    I, J, B = 0.031, 0.004, 0.007
    link_angle = Block(
        "link_angle", np.array([0.1]), lambda x, p: 0 * x[0], lambda x, p: np.array([[1.0]]),
        K=np.array([4.0]), kbar=4.0, C=20 * np.eye(1), filter=np.array([0.01]), eta_2=1.0, eta_3=1.0,
        constraint=funnel(0.3, 0.05, 2.0),
    )
    link_rate = Block(
        "link_rate", np.array([0.0]),
        lambda x, p: np.array([-(p["weight"] * sin(x[0][0]) + p["stiffness"] * x[0][0]) / I]),
        lambda x, p: np.array([[p["stiffness"] / I]]) + 0 * x[0][0],
        K=np.array([10.0]), kbar=16.0, C=50 * np.eye(1), filter=np.array([0.002]), eta_1=1.0, eta_2=1e-4, eta_3=100.0,
        disturbance=Bounded(lambda t: np.array([0.1 * (1 + sin(3 * t)) / I])), observer=40 * np.eye(1),
        network=Network(2, lambda x: np.array([sin(x[0][0]), x[1][0]]), 2, np.array([1.0]), 1.0, 0.1),
    )
    motor_angle = Block(
        "motor_angle", np.array([0.1]), lambda x, p: 0 * x[2], lambda x, p: np.array([[1.0]]),
        K=np.array([40.0]), kbar=45.0, C=100 * np.eye(1), filter=np.array([0.001]), eta_2=1.0, eta_3=1.0,
    )
    ripple = ([[0, 0, 0], [0, 0, 20], [0, -20, 0]], np.zeros((3, 0)), [1, 1, 0], [10, 0, 20])
    motor_rate = Block(
        "motor_rate", np.array([0.0]),
        lambda x, p: np.array([-(B * x[3][0] + p["stiffness"] * (x[2][0] - x[0][0])) / J]), lambda x, p: np.array([[1 / J]]),
        K=np.array([100.0]), kbar=120.0, C=200 * np.eye(1), eta_1=1.0,
        disturbance=Exosystem.of_channels([ripple]), observer=np.array([[40.0], [20.0], [60.0]]),
    )
    start, rate = _gentle(10.0)
    reference = (
        lambda t: np.array([60 * DEG * sin(t) * start(t)]),
        lambda t: np.array([60 * DEG * (cos(t) * start(t) + sin(t) * rate(t))]),
    )
    return Problem(
        "flexible_joint", 1, [link_angle, link_rate, motor_angle, motor_rate], reference, np.array([3.0]),
        {"weight": 0.8, "stiffness": 31.0}, {"weight": (0.6, 1.0), "stiffness": (28.0, 34.0)}, 10.0, 0.0005, 3.0,
    )


def _gentle(scale):
    """1 - exp(-t^3/scale), and its rate."""
    return (lambda t: 1 - exp(-(t**3) / scale)), (lambda t: 3 * t**2 / scale * exp(-(t**3) / scale))


def underwater_vehicle():
    """BlueROV2 Heavy in waves and a current."""
    current = lambda t: np.array(
        [0.2 + 0.1 * sin(0.2 * t), -0.1 + 0.1 * cos(0.2 * t), 0.05 * sin(0.1 * t), 0 * t, 0 * t, 0 * t]
    )
    waves = [([[0, 1], [-1, -0.2]], [[0], [n]], [0, 1], [0, 0]) for n in (0.1, 0.1, 0.1, 0.2, 0.2, 0.2)]
    pose = Block(
        "pose", np.array([0.1, -0.1, 0.1, 3 * DEG, -3 * DEG, 5 * DEG]), lambda x, p: 0 * x[0], underwater.kinematics,
        K=np.full(6, 2.0), kbar=0.5, C=5 * np.eye(6), filter=np.full(6, 0.1), eta_1=1.0, eta_2=1.0, eta_3=1.0,
        disturbance=Bounded(current), observer=np.eye(6), constraint=funnel(0.4, 0.1, 0.3),
    )
    velocity = Block(
        "velocity", np.zeros(6), underwater.velocity_drift, underwater.velocity_gain,
        K=np.full(6, 5.0), kbar=2.0, C=10 * np.eye(6), eta_1=1.0, eta_noise=0.1,
        disturbance=Exosystem.of_channels(waves), observer=np.kron(np.eye(6), np.array([[-8.0], [5.8]])),
        noise=Noise(underwater.noise_effectiveness, np.ones(6)),
        network=Network(2, lambda x: x[1], 6, np.full(6, 1.0), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.full(6, 1.0)),
        noise_bound=NoiseBound(1.0, 0.1, 1.0, 10.0, 0.5, 0.2),
    )
    start, rate = _gentle(50.0)
    reference = (lambda t: _figure(t) * start(t)), (lambda t: _figure_dot(t) * start(t) + _figure(t) * rate(t))
    scales = {"added_scale": (0.8, 1.2), "drag_scale": (0.7, 1.3), "torque_scale": (0.7, 1.3)}
    return Problem(
        "underwater_vehicle", 6, [pose, velocity], reference, np.array([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]),
        {name: 1.0 for name in scales}, scales, 40.0, 0.01, 10.0, wiener=True,
    )


def _figure(t):
    """The vehicle's path before its gentle start."""
    position = [2 * sin(0.3 * t), 2 * (1 - cos(0.3 * t)), 1 - cos(0.2 * t)]
    return np.array([*position, 15 * DEG * sin(0.4 * t), 25 * DEG * sin(0.3 * t), 60 * DEG * sin(0.2 * t)])


def _figure_dot(t):
    """Its rate."""
    velocity = [0.6 * cos(0.3 * t), 0.6 * sin(0.3 * t), 0.2 * sin(0.2 * t)]
    return np.array([*velocity, 6 * DEG * cos(0.4 * t), 7.5 * DEG * cos(0.3 * t), 12 * DEG * cos(0.2 * t)])


SPECS = {make.__name__: make for make in (nsv_attitude, pendulum, two_link_arm, motor_arm, flexible_joint, underwater_vehicle)}
