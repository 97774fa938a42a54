"""The newer specifications of this repository, by hand, as in specs.py."""

import numpy as np

import ghv
from problem import Block, Bounded, ErrorBound, Exosystem, Network, Noise, NoiseBound, Problem
from real import cos, exp, inverse, pi_like, sin, solve, tan, tanh

DEG = np.pi / 180
GENTLE = 10.0


def funnel(start, end, decay=1.0):
    """k(t) = start exp(-decay t) + end, and k'(t)."""
    return (lambda t: start * exp(-decay * t) + end), (lambda t: -decay * start * exp(-decay * t))


def gentle(path, path_dot):
    """A path from standstill: times 1 - exp(-t^3/10); with its rate."""
    start = lambda t: 1 - exp(-(t**3) / GENTLE)
    start_dot = lambda t: 3 * t**2 / GENTLE * exp(-(t**3) / GENTLE)
    return (lambda t: path(t) * start(t)), (lambda t: path_dot(t) * start(t) + path(t) * start_dot(t))


def ghv_unstable(x_cg=2.85):
    """Winged cone with its centre of mass at full weight."""
    bounded = Bounded(lambda t: 0.02 * exp(-t / 10) * np.array([sin(2 * t), sin(t), sin(2 * t)]))
    damped = ([[-0.3, 3], [-3, -0.3]], [[0.05, 0], [0, 0.05]])
    attitude = Block(
        "attitude", np.array([0.5, 0.5, 0.0]) * DEG, lambda x, p: ghv.attitude_drift(x, p, x_cg), ghv.attitude_gain,
        K=np.full(3, 1.5), kbar=2.0, C=20 * np.eye(3), filter=np.full(3, 0.05), eta_1=1.0, eta_2=1.0, eta_3=1.0,
        disturbance=bounded, observer=10 * np.eye(3), constraint=funnel(3 * DEG, 0.5 * DEG),
        network=Network(3, lambda x: x[0], 3, np.full(3, 0.1), 1.0, 0.1),
    )
    rates = Block(
        "rates", np.zeros(3), lambda x, p: ghv.rates_drift(x, p, x_cg),
        lambda x, p: np.diag([1 / ghv.IXX, 1 / ghv.IYY, 1 / ghv.IZZ]) + 0 * x[0][0],
        K=np.full(3, 2.0), kbar=2.0, C=50 * np.eye(3), eta_1=0.1, eta_noise=0.1,
        disturbance=Exosystem.of_channels([(*damped, row, [0, 0]) for row in ([0, 2], [2, 0], [1, 1])]),
        noise=Noise(lambda x, p: ghv.noise_effectiveness(x, p, x_cg), np.array([0.05] * 3)),
        observer=np.array([[-1.5, 0, 0], [1.5, 0, 0], [0, 1.5, 0], [0, 1, 0], [0, 0, -2], [0, 0, 4]]),
        constraint=funnel(3.0, 0.5),
        network=Network(3, lambda x: x[1], 3, np.full(3, 0.1), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.full(3, 2.0)), noise_bound=NoiseBound(1.0, 0.1, 1.0, 10.0, 2.0, 0.01),
    )

    def reference(t):
        pi = pi_like(t)
        return np.array([1.5 - 2 * cos(pi * t / 4), sin(3 * pi * t / 10) / 2, -2 * sin(t) + cos(t / 2) / 2]) * DEG

    def reference_dot(t):
        pi = pi_like(t)
        return np.array([pi / 2 * sin(pi * t / 4), 3 * pi / 20 * cos(3 * pi * t / 10), -2 * cos(t) - sin(t / 2) / 4]) * DEG

    scales = [f"{c}_scale" for c in ("CL", "CD", "CY", "Cl", "Cm", "Cn")]
    return Problem(
        "ghv_unstable", 3, [attitude, rates], (reference, reference_dot), np.array([2e6, 2e7, 2e7]),
        {name: 1.0 for name in scales}, {name: (0.8, 1.2) for name in scales}, 20.0, 0.002, 4.5, wiener=True,
    )  # fmt: skip


def quadrotor():
    """AscTec Hummingbird: W is the inverse of what the rates of the Euler angles make of body rates, J is diagonal."""

    def euler_rates(x, p):
        phi, theta = x[0][:2]
        one = 1 + 0 * phi
        made_of = [[one, 0 * one, -sin(theta)], [0 * one, cos(phi), cos(theta) * sin(phi)], [0 * one, -sin(phi), cos(theta) * cos(phi)]]
        return inverse(np.array(made_of))

    inertia = lambda p: np.array([3.65e-3 * p["roll_scale"], 3.68e-3 * p["pitch_scale"], 7.03e-3 * p["yaw_scale"]])
    beat = [[-0.2, 12, 0], [-12, -0.2, 0], [0, 0, -1]]
    channels = [(beat, [[1, 0], [0, 0], [0, 2]], [1, 0, 1], w) for w in ([2, 0, 0], [0, 2, 0])]
    channels.append(([[0, 0], [0, -3]], [[0], [0.5]], [1, 1], [0.5, 0]))
    S = np.zeros((8, 3))
    S[:3, 0] = S[3:6, 1] = 14.6, 23, 14
    S[6:, 2] = 8, -1
    attitude = Block(
        "attitude", np.array([10, -10, 5]) * DEG, lambda x, p: 0 * x[0], euler_rates,
        K=np.full(3, 6.0), kbar=2.0, C=20 * np.eye(3), filter=np.full(3, 0.01), eta_2=1.0, eta_3=1.0, constraint=funnel(0.3, 0.04, 2.0),
    )
    rates = Block(
        "rates", np.zeros(3), lambda x, p: -np.cross(x[1], inertia(p) * x[1]) / inertia(p), lambda x, p: np.diag(1 / inertia(p)),
        K=np.full(3, 20.0), kbar=10.0, C=50 * np.eye(3), eta_1=1.0, eta_noise=0.01,
        disturbance=Exosystem.of_channels(channels), observer=S,
        noise=Noise(lambda x, p: 1e-4 * np.diag(1 / inertia(p)), np.ones(3)),
        network=Network(3, lambda x: x[1], 3, np.full(3, 1.0), 1.0, 0.1, "complete"),
        error_bound=ErrorBound(0.1, np.full(3, 1.0)), noise_bound=NoiseBound(1.0, 0.1, 1.0, 10.0, 0.5, 0.2),
    )
    reference = gentle(
        lambda t: np.array([35 * sin(2 * t), 25 * sin(3 * t), 90 * sin(t / 2)]) * DEG,
        lambda t: np.array([70 * cos(2 * t), 75 * cos(3 * t), 45 * cos(t / 2)]) * DEG,
    )
    scales = ["roll_scale", "pitch_scale", "yaw_scale"]
    return Problem(
        "quadrotor", 3, [attitude, rates], reference, np.array([0.2, 0.2, 0.05]), {name: 1.0 for name in scales},
        {name: (0.8, 1.3) for name in scales}, 15.0, 0.002, 5.0, wiener=True, substeps=2,
    )  # fmt: skip


def surface_vessel():
    """CyberShip II in the matrix form of Skjetne, Smogeli and Fossen: C(nu) from M, D(nu) of their table."""

    def mass_matrix(x, p):
        a = p["added_scale"]
        m, x_g, zero = 23.8, 0.046, 0 * x[0][0]
        return np.array([[m + 2 * a, zero, zero], [zero, m + 10 * a, m * x_g + zero], [zero, m * x_g + zero, 1.76 + a]])

    def drift(x, p):
        M, nu = mass_matrix(x, p), x[1]
        p_x, p_y, _ = M @ nu
        u, v, r = nu
        zero = 0 * u
        C = np.array([[zero, zero, -p_y], [zero, zero, p_x], [p_y, -p_x, zero]])
        D = np.array(
            [
                [0.72253 + 1.32742 * abs(u) + 5.86643 * u**2, zero, zero],
                [zero, 0.88965 + 36.47287 * abs(v) + 0.805 * abs(r), 7.25 + 0.845 * abs(v) + 3.45 * abs(r)],
                [zero, -0.0313 - 3.95645 * abs(v) - 0.13 * abs(r), 1.9 - 0.08 * abs(v) + 0.75 * abs(r)],
            ]
        )
        return -solve(M, C @ nu + p["damping_scale"] * (D @ nu))

    def rotation(x, p):
        c, s = cos(x[0][2]), sin(x[0][2])
        return np.array([[c, -s, 0 * c], [s, c, 0 * c], [0 * c, 0 * c, 1 + 0 * c]])

    current = lambda t: np.array([0.03 + 0.01 * sin(0.1 * t), -0.02 + 0.01 * cos(0.1 * t), 0 * t])
    waves = [([[0, 1], [-36, -1.2]], [[0], [n]], [0, 1], [0, 0]) for n in (0.04, 0.04, 0.08)]
    pose = Block(
        "pose", np.array([0.1, -0.1, 5 * DEG]), lambda x, p: 0 * x[0], rotation,
        K=np.array([1.2, 1.2, 2.0]), kbar=0.25, C=np.diag([2.0, 2, 4]), filter=np.array([0.2, 0.2, 0.1]),
        eta_1=1.0, eta_2=1.0, eta_3=1.0, disturbance=Bounded(current), observer=np.diag([0.5, 0.5, 1.0]), constraint=funnel(0.25, 0.02, 0.1),
    )
    velocity = Block(
        "velocity", np.zeros(3), drift, lambda x, p: inverse(mass_matrix(x, p)),
        K=np.full(3, 6.0), kbar=1.0, C=10 * np.eye(3), eta_1=1.0, eta_noise=0.1,
        disturbance=Exosystem.of_channels(waves), observer=np.kron(np.eye(3), np.array([[-3.0], [22.8]])),
        noise=Noise(lambda x, p: inverse(mass_matrix(x, p)) @ np.diag([0.02, 0.02, 0.005]), np.ones(3)),
        network=Network(2, lambda x: x[1] / np.array([0.2, 0.1, 0.1]), 3, np.array([0.02, 0.02, 0.1]), 10.0, 0.1),
        error_bound=ErrorBound(0.1, np.full(3, 0.1)), noise_bound=NoiseBound(1.0, 0.1, 0.1, 2.0, 0.5, 0.02),
    )
    turn = lambda t: 0.05 * (t - 10 * (1 - exp(-0.1 * t)))
    turn_dot = lambda t: 0.05 * (1 - exp(-0.1 * t))
    reference = (
        lambda t: np.array([4 * sin(turn(t)), 4 * (1 - cos(turn(t))), turn(t)]),
        lambda t: turn_dot(t) * np.array([4 * cos(turn(t)), 4 * sin(turn(t)), 1 + 0 * t]),
    )
    return Problem(
        "surface_vessel", 3, [pose, velocity], reference, np.array([2.0, 2.0, 1.5]), {"added_scale": 1.0, "damping_scale": 1.0},
        {"added_scale": (0.8, 1.2), "damping_scale": (0.7, 1.3)}, 140.0, 0.02, 30.0, wiener=True, substeps=2,
    )  # fmt: skip


def active_suspension():
    """Quarter of a car; the wheel is an exosystem."""
    height = Block(
        "height", np.array([0.02]), lambda x, p: 0 * x[0], lambda x, p: np.array([[1.0]]),
        K=np.array([8.0]), kbar=4.0, C=20 * np.eye(1), filter=np.array([0.005]), eta_2=1.0, eta_3=1.0, constraint=funnel(0.03, 0.002, 2.0),
    )
    wheel = ([[-0.5, 0, 0], [0, 0, 1], [0, -3167, -5.6]], [[0.02, 0], [0, 0], [0, 0.4]], [53.3, 53.3, 3.33], [0, 0, 0])
    speed = Block(
        "speed", np.array([0.0]),
        lambda x, p: -(16000 * x[0] + 400000 * x[0] ** 3 + 1000 * x[1]) / p["body_mass"],
        lambda x, p: np.array([[1000 / p["body_mass"]]]) + 0 * x[0][0],
        K=np.array([40.0]), kbar=10.0, C=50 * np.eye(1), filter=np.array([0.001]), eta_1=1.0, eta_2=0.1, eta_3=1.0,
        disturbance=Exosystem.of_channels([wheel]), observer=np.array([[2.0], [-0.18], [14.0]]),
        network=Network(3, lambda x: np.array([x[0][0] / 0.05, x[1][0] / 0.2]), 2, np.array([1.0]), 1.0, 0.1),
        error_bound=ErrorBound(0.1, np.array([0.1])),
    )
    actuator = Block(
        "actuator", np.array([0.0]), lambda x, p: -60 * x[2], lambda x, p: np.array([[60.0]]),
        K=np.array([200.0]), kbar=50.0, C=100 * np.eye(1),
        noise=Noise(lambda x, p: np.array([[0.02 * 60]]), np.array([1.0])), noise_bound=NoiseBound(1.0, 0.1, 0.1, 2.0, 0.5, 0.02),
    )
    swing = lambda t: tanh(3 * sin(0.8 * t))
    reference = (
        lambda t: np.array([0.05 * swing(t)]),
        lambda t: np.array([0.05 * (1 - swing(t) ** 2) * 2.4 * cos(0.8 * t)]),
    )
    return Problem(
        "active_suspension", 1, [height, speed, actuator], reference, np.array([2.0]), {"body_mass": 320.0},
        {"body_mass": (270.0, 380.0)}, 20.0, 0.001, 5.0, wiener=True, substeps=2,
    )  # fmt: skip


def chaotic_jerk():
    """Genesio and Tesi's system."""
    gains = dict(K=np.array([4.0]), kbar=1.0, eta_2=1.0, eta_3=1.0)
    one = lambda x, p: np.array([[1.0]]) + 0 * x[0][0]
    position = Block("position", np.array([0.1]), lambda x, p: 0 * x[0], one, C=10 * np.eye(1), **gains)
    velocity = Block("velocity", np.array([0.1]), lambda x, p: 0 * x[1], one, C=10 * np.eye(1), **gains)
    acceleration = Block(
        "acceleration", np.array([0.1]), lambda x, p: -p["c"] * x[0] - p["b"] * x[1] - p["a"] * x[2] + x[0] ** 2, one,
        K=np.array([4.0]), kbar=1.0, C=20 * np.eye(1), eta_1=1.0,
        disturbance=Bounded(lambda t: np.array([0.2 * sin(t)])), observer=10 * np.eye(1),
        network=Network(2, lambda x: np.concatenate(x), 3, np.array([1.0]), 1.0, 0.1),
    )
    reference = gentle(lambda t: np.array([2 * sin(t)]), lambda t: np.array([2 * cos(t)]))
    return Problem(
        "chaotic_jerk", 1, [position, velocity, acceleration], reference, np.array([20.0]), {"a": 0.44, "b": 1.1, "c": 1.0},
        {"a": (0.4, 0.48), "b": (1.0, 1.2), "c": (0.9, 1.1)}, 30.0, 0.005, 10.0, exact=True, substeps=2,
    )  # fmt: skip


LIBRARY = (ghv_unstable, quadrotor, surface_vessel, active_suspension, chaotic_jerk)
