"""States of the closed loop at which the law is asked: of errors of a chosen length, and hard cases."""

import numpy as np

from law import evaluate, initial_state, upto
from problem import Exosystem

# Typical size of h<i>, zeta<i>, of far-away states and of the way of further states from where they begin, per spec.
SIZES = {
    "nsv_attitude": {"h1": 0.2, "zeta1": 0.02, "zeta2": 0.1, "x1": 0.15, "x2": 0.3},
    "pendulum": {"h1": 3.0, "zeta1": 0.3, "zeta2": 1.0, "x1": 2.0, "x2": 5.0},
    "two_link_arm": {"h1": 2.0, "zeta1": 0.2, "zeta2": 0.5, "x1": 2.0, "x2": 4.0},
    "motor_arm": {"h1": 2.0, "h2": 4.0, "zeta1": 0.1, "zeta2": 0.5, "zeta3": 1.0, "x1": 2.0, "x2": 5.0, "x3": 5.0},
    "flexible_joint": {
        "h1": 2.0, "h2": 2.0, "h3": 4.0, "zeta1": 0.1, "zeta2": 0.5, "zeta3": 0.1, "zeta4": 0.5,
        "x1": 2.0, "x2": 4.0, "x3": 2.0, "x4": 4.0,
    },  # fmt: skip
    "underwater_vehicle": {"h1": 0.5, "zeta1": 0.05, "zeta2": 0.2, "x1": 1.2, "x2": 1.0},
    "ghv_unstable": {"h1": 0.2, "zeta1": 0.02, "zeta2": 0.1, "x1": 0.15, "x2": 0.3},
    "quadrotor": {"h1": 2.0, "zeta1": 0.1, "zeta2": 0.5, "x1": 1.2, "x2": 3.0},
    "surface_vessel": {"h1": 0.2, "zeta1": 0.05, "zeta2": 0.1, "x1": 2.0, "x2": 0.3},
    "active_suspension": {"h1": 0.2, "h2": 1.0, "zeta1": 0.01, "zeta2": 0.05, "zeta3": 0.2, "x1": 0.1, "x2": 0.5, "x3": 2.0},
    "chaotic_jerk": {"zeta1": 0.2, "zeta2": 0.2, "zeta3": 0.2, "x1": 2.0, "x2": 2.0, "x3": 2.0},
    "six_joint_arm": {"h1": 2.0, "zeta1": 0.1, "zeta2": 0.5, "x1": 1.5, "x2": 2.0},
    "missile_pitch": {"h1": 1.0, "zeta1": 0.02, "zeta2": 0.2, "x1": 0.6, "x2": 4.0, "truth": 1.4},
    "nsv_six_dof": {
        "h1": 0.2, "zeta1": 0.02, "zeta2": 0.1, "x1": 0.15, "x2": 0.3, "truth": np.array([300.0, 0.3, 3.0, 21e3, 1e5, 1e5]),
    },  # fmt: skip
    "every_term": {"h1": 1.0, "h2": 1.0, "zeta1": 0.2, "zeta2": 0.2, "zeta3": 0.2, "x1": 2.0, "x2": 2.0, "x3": 2.0},
    "lookup": {"h1": 1.0, "zeta1": 0.2, "zeta2": 0.2, "x1": 2.0, "x2": 2.0},
    "link_chain": {"h1": 1.0, "h2": 2.0, "zeta1": 0.1, "zeta2": 0.5, "zeta3": 0.5, "x1": 1.5, "x2": 2.0, "x3": 2.0},
    "single_block": {"zeta1": 0.2, "x1": 2.0},
    "exact_chain": {"zeta1": 0.2, "zeta2": 0.2, "zeta3": 0.2, "x1": 2.0, "x2": 2.0, "x3": 2.0},
}


def target(problem, state, i):
    """h_{i-1}, what block i follows."""
    if i == 1:
        return problem.reference[0](state["t"])
    return upto(problem, i - 1, state)[f"alpha{i - 1}"] if problem.exact else state[f"h{i - 1}"]


class Sampler:
    """Draws states whose errors have a chosen length."""

    def __init__(self, name, problem, rng):
        self.name, self.problem, self.rng = name, problem, rng
        self.size = SIZES[name]

    def vector(self, length, size):
        """Uniform in a cube."""
        return self.rng.uniform(-1, 1, length) * size

    def direction(self):
        """Uniform on the unit sphere."""
        v = self.rng.standard_normal(self.problem.width)
        return v / np.linalg.norm(v)

    def state(self, ratio, t=None, weights=1.0, calm=False):
        """A state with |e_i| = ratio() k_i, or ratio() where there is no constraint; `calm`: as in a loop that has settled."""
        problem, rng = self.problem, self.rng
        quiet = 0.02 if calm else 1.0
        state = {"t": rng.uniform(0, problem.horizon) if t is None else t}
        for i, block in enumerate(problem.blocks, 1):
            zeta = state[f"zeta{i}"] = self.vector(problem.width, quiet * self.size[f"zeta{i}"])
            k = block.constraint[0](state["t"]) if block.constraint else 1.0
            h = target(problem, state, i)
            state[f"x{i}"] = h + zeta + self.direction() * k * ratio()
            if block.network:
                state[f"W{i}"] = rng.standard_normal((len(block.network.exponents), problem.width)) * weights * quiet
            if block.error_bound:
                state[f"eps{i}"] = rng.uniform(0, 0.5)
            if block.noise:
                state[f"sigma{i}"], state[f"phi{i}"] = rng.uniform(0, 0.5), rng.uniform(2, 10)
            if isinstance(block.disturbance, Exosystem):
                state[f"w{i}"] = rng.standard_normal(len(block.disturbance.M))
            if block.observer is not None:
                exo = isinstance(block.disturbance, Exosystem)
                measured = state[f"x{i}"] - h - zeta if exo else state[f"x{i}"]
                state[f"th{i}"] = self.vector(len(block.observer), quiet) - block.observer @ measured
            if i < len(problem.blocks) and not problem.exact:
                near = upto(problem, i, state)[f"alpha{i}"] if calm else 0
                state[f"h{i}"] = near + self.vector(problem.width, quiet * self.size[f"h{i}"])
        if problem.truth:
            state["truth"] = problem.truth.initial + self.vector(len(problem.truth.initial), self.size["truth"])
        return state


def adversarial(sampler):
    """(label, state) of the hard cases."""
    problem, rng = sampler.problem, sampler.rng
    uniform = lambda: rng.uniform(0.1, 0.6)
    n = len(problem.blocks)

    state = initial_state(problem)
    for i, block in enumerate(problem.blocks, 1):
        if isinstance(block.disturbance, Exosystem):
            state[f"w{i}"] = block.disturbance.initial
    if problem.truth:
        state["truth"] = problem.truth.initial
    yield "initial state of the scenario", state

    state = sampler.state(lambda: 0.0, t=0.0)
    for i in range(1, n + 1):
        state[f"zeta{i}"] = np.zeros(problem.width)
        state[f"x{i}"] = target(problem, state, i)
    yield "zero error", state
    yield "error of 1e-9 of the constraint", sampler.state(lambda: 1e-9)
    yield "error of 1e-3 of the constraint", sampler.state(lambda: 1e-3)
    for near in (0.8, 0.9) if problem.exact else (0.98, 0.9995):  # derivatives of tan(E) multiply along the chain
        yield f"error at {near} of the constraint", sampler.state(lambda: near)
    if not problem.exact:
        yield "constraint violated", sampler.state(lambda: 1.2)
    if not any(block.constraint for block in problem.blocks):  # nothing bounds the errors
        yield "large errors", sampler.state(lambda: 5.0)
    yield "saturated", _saturated(sampler)

    state = sampler.state(uniform)  # far from the reference; zeta keeps the errors small
    for i in range(1, n + 1):
        far = sampler.vector(problem.width, sampler.size[f"x{i}"])
        state[f"zeta{i}"] = state[f"zeta{i}"] + far - state[f"x{i}"]
        state[f"x{i}"] = far
    yield "large states", state
    yield "end of the horizon", sampler.state(uniform, t=problem.horizon)

    noisy = [i for i, block in enumerate(problem.blocks, 1) if block.noise]
    if noisy:
        state = sampler.state(uniform)
        Psi = evaluate(problem, state)
        for i in noisy:
            state[f"phi{i}"] = 1.001 * np.sqrt(Psi[f"Psi{i}"] * problem.sample_time / 0.1)
        yield "phi at its floor", state
        state = sampler.state(uniform)
        for i in noisy:
            small = problem.blocks[i - 1].noise_bound.phi_threshold / 2
            state[f"x{i}"] = target(problem, state, i) + state[f"zeta{i}"] + small * sampler.direction()
        yield "error below the threshold of phi", state


def _saturated(sampler):
    """Doubles the last block's filtered command error until every input saturates."""
    state = sampler.state(lambda: 0.5, weights=4.0)
    last = len(sampler.problem.blocks)
    name = f"zeta{last}"
    shift = np.ones(sampler.problem.width)
    for _ in range(60):
        out = evaluate(sampler.problem, state)
        if (np.abs(out["u"]) > sampler.problem.limits).all():
            return state
        state[name], state[f"x{last}"] = state[name] + shift, state[f"x{last}"] + shift
        shift = 2 * shift
    raise AssertionError("invariant: large zeta saturates")
