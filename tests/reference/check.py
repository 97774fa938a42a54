"""Checks the reference evaluation itself: errata of the paper, plant data, and closed loops against their published behaviour.

Run: python tests/reference/check.py (about three minutes). Prints one line per fact, fails on the first that does not hold.
"""

import numpy as np
from mpmath import mpf

import ghv
from closed_loop import simulate, summary
from law import barrier, evaluate, saturate, ybar_norm
from lyapunov import plant_rates
from problem import Exosystem
from real import cos, exact, frobenius, pi_like, sin, spectral, tan
from sampling import Sampler
from specs import DEG, SPECS, nsv_attitude


def say(fact, holds):
    """One line per fact."""
    assert holds, fact
    print("ok ", fact)


def errata_1():
    """E1: with zeta_n' = -C zeta_n + G_n (sat(u) - u) the error obeys (44), de_n = F + G u + d - h' + C zeta."""
    problem, rng = nsv_attitude(), np.random.default_rng(1)
    state = {k: exact(v) for k, v in Sampler("nsv_attitude", problem, rng).state(lambda: 0.5).items()}
    out = evaluate(problem, state)
    excess = out["u_sat"] - out["u"]
    x_dot = plant_rates(problem, state, out["u_sat"])["x2"]
    d = problem.blocks[1].disturbance.L @ state["w2"]
    right = out["F2"] + out["G2"] @ out["u"] + d - out["h1_dot"] + problem.blocks[1].C @ state["zeta2"]
    e_dot = x_dot - out["h1_dot"] - out["zeta2_dot"]
    paper = e_dot + 2 * out["G2"] @ excess
    say("E1: (13) with + G (sat(u) - u) gives (44)", np.max(np.abs(e_dot - right)) < 1e-60 and np.max(np.abs(excess)) > 0)
    say("E1: the paper's sign does not", np.max(np.abs(paper - right)) > 1e-3)


def errata_3():
    """E3: Hessian of V_T = k^4/(2 pi) tan E against Y, and Ybar >= Y/s in norm."""
    k, e = exact(0.9), exact([0.45, -0.35, 0.5])
    pi, h = pi_like(k), mpf(10) ** -20
    V = lambda v: k**4 / (2 * pi) * tan(pi * (v @ v) ** 2 / (2 * k**4))
    unit = exact(np.eye(3)) * h
    hessian = np.array([[(V(e + a + b) - V(e + a - b) - V(e - a + b) + V(e - a - b)) / (4 * h**2) for a in unit] for b in unit])
    s, E = e @ e, pi * (e @ e) ** 2 / (2 * k**4)
    second = (2 * np.outer(e, e) + s * np.eye(3)) / cos(E) ** 2
    Y = lambda factor: factor * sin(E) / cos(E) ** 3 * s**2 * np.outer(e, e) + second
    say("E3: Hessian of V_T is Y with 4 pi/k^4", np.max(np.abs(hessian - Y(4 * pi / k**4))) < 1e-30)
    off = np.max(np.abs(hessian - Y(8 * pi**2 / k**8)))
    say(f"E3: the paper's 8 pi^2/k^8 is off by {float(off):.2g}", off > 1)
    full = 4 * pi / k**4 * sin(E) / cos(E) ** 3 * s * np.outer(e, e) + 3 / cos(E) ** 2 * exact(np.eye(3))
    for name, norm in (("frobenius", frobenius), ("spectral", spectral)):
        say(f"E3: closed form of the {name} norm of Ybar", abs(ybar_norm(name, e, E, k, s) - norm(full)) < 1e-60)
        say(f"E3: ||Y|| <= ||Ybar|| s ({name})", norm(hessian) <= norm(full) * s * (1 + mpf(10) ** -25))
    gradient = np.array([(V(e + a) - V(e - a)) / (2 * h) for a in unit])
    say("c is the gradient of V_T", np.max(np.abs(gradient - s * e / cos(E) ** 2)) < 1e-30)


def errata_5():
    """E5: x y <= 3/4 eta^(4/3) x^(4/3) + y^4/(4 eta^4) with equality reached; eta^(3/4) fails."""
    eta, y = np.meshgrid(np.geomspace(0.05, 20, 400), np.geomspace(0.05, 20, 400))
    margin = 0.75 * eta ** (4 / 3) + y**4 / (4 * eta**4) - y
    tight = 0.75 * (y ** (3 / 4)) ** (4 / 3) + 1 / 4 * y - y  # eta = y^(3/4)
    say("E5: Young's inequality holds with eta^(4/3), tightly", margin.min() > -1e-12 and np.abs(tight).max() < 1e-12)
    say("E5: it fails with eta^(3/4)", (0.75 * eta**0.75 + y**4 / (4 * eta**4) - y).min() < -0.1)


def limits():
    """Remark 4 and k -> infinity: the kernels of the barrier."""
    e = exact([1e-9, -2e-9])
    E, sin_cos_over, tan_over = barrier(e, exact(0.5), 1e-3)
    say("Remark 4: kernels are 1 at zero error", abs(sin_cos_over - 1) < 1e-30 and abs(tan_over - 1) < 1e-30)
    e = exact([0.3, -0.2])
    far, none = barrier(e, exact(1e9), 1e-3), barrier(e, None, 1e-3)
    say("k -> infinity gives the unconstrained kernels", all(abs(a - b) < 1e-30 for a, b in zip(far, none)))
    say("E is clamped below pi/2", abs(barrier(e, exact(0.1), 1e-3)[0] - (pi_like(e) / 2 - 1e-3)) < 1e-60)
    say("sat limits each component", list(saturate(np.array([3.0, -3.0, 0.5]), np.ones(3))) == [1.0, -1.0, 0.5])


def vehicle():
    """Check values of the vehicle at x_cg = 2.85 m, alpha = 2 deg."""
    p, x = nsv_attitude().parameters, [np.array([2 * DEG, 0, 0]), np.zeros(3)]
    lift, drag, side, *moments = ghv.loads(x, p, 2.85)
    say("lift and drag", abs(lift / 1.86174e6 - 1) < 1e-5 and abs(drag / 5.42709e5 - 1) < 1e-5 and abs(side) < 1e-6)
    say("drift moments", abs(moments[0]) < 1e-6 and abs(moments[1] / 7.738e6 - 1) < 1e-4 and abs(moments[2]) < 1e-6)
    G_delta = ghv.moment_effectiveness(x, p, 2.85)
    want = np.array([[-2.08920e5, 2.08920e5, 1.31928e5], [4.76361e5, 4.76361e5, -1.59e1], [2.62283e4, -2.62283e4, -5.32016e5]])
    say("moments per degree of deflection", np.max(np.abs(G_delta - want)) < 0.6)
    bent = lambda a, b: ghv.loads([np.array([2 * DEG + a, b, 0]), np.zeros(3)], p, 2.85)
    h = 1e-6
    pitch = (bent(h, 0)[4] - bent(-h, 0)[4]) / (2 * h * ghv.IYY)
    yaw = (bent(0, h)[5] - bent(0, -h)[5]) / (2 * h * ghv.IZZ)
    say("statically unstable in pitch and yaw", abs(pitch - 11.69) < 5e-3 and abs(yaw + 12.48) < 5e-3)
    G = ghv.attitude_gain([np.array([0.1, 0.2, 0.3])], p)
    say("det G_1 = -1/cos(beta)", abs(np.linalg.det(G) + 1 / np.cos(0.2)) < 1e-12)


def observers():
    """M - S L of every exosystem observer is stable."""
    for name, make in SPECS.items():
        for block in make().blocks:
            if isinstance(block.disturbance, Exosystem):
                poles = np.linalg.eigvals(block.disturbance.M - block.observer @ block.disturbance.L)
                say(f"{name}: observer of {block.name}, slowest pole {poles.real.max():.3g}", poles.real.max() < -0.5)


def loops():
    """Closed loops, explicit plant with 4 substeps, over the horizon of each."""
    problem = nsv_attitude()
    calm = summary(problem, simulate(problem))
    say(f"flagship without noise: ratio {calm['ratio1']:.3f} (0.477)", abs(calm["ratio1"] - 0.477) < 1e-3)
    say(f"flagship without noise: rms {calm['rms'] / DEG} deg", np.all(calm["rms"] / DEG < 0.045))
    noisy = summary(problem, simulate(problem, seed=1))
    say(f"flagship with noise: ratio {noisy['ratio1']:.3f}, rms {noisy['rms'] / DEG} deg", np.all(noisy["rms"] / DEG < 0.07))
    say(f"flagship with noise: observer errors {noisy['observer1']}, {noisy['observer2']}", np.all(noisy["observer2"] < 0.08))
    allowed = {"pendulum": 0.01, "two_link_arm": 0.01, "motor_arm": 0.01, "flexible_joint": 0.01, "underwater_vehicle": 0.02}
    for name, largest in allowed.items():
        problem = SPECS[name]()
        parameter, ends = next(iter(problem.dispersion.items()))
        for seed, v in ((None, problem.parameters[parameter]), (1, ends[0]), (2, ends[1])):
            run = simulate(problem, seed, problem.parameters | {parameter: v})
            got = summary(problem, run)
            line = f"{name}, {parameter} = {v}, seed {seed}: ratio {got['ratio1']:.3f}, rms {got['rms']}"
            say(line, got["ratio1"] < 0.5 and np.all(got["rms"] < largest) and np.all(got["saturated"] < 0.02))


if __name__ == "__main__":
    for check in (errata_1, errata_3, errata_5, limits, vehicle, observers, loops):
        check()
