"""Writes tests/points/<spec>.json: states of the closed loop and what the law must give there, to the last digit.

Run from anywhere: python tests/reference/make_points.py [SPEC ..]. The result depends on this folder and the aerodynamic data alone.
A point has a label, `inputs` (names as in `nsv eval`), `expected`, and `plant`: with dispersed parameters, the drift of (x, w)
under u_sat and the covariance diffusion * diffusion^T. Matrices are lists of rows. `tolerance` is what float64 can be asked for,
per output: the largest change of any entry when the law is evaluated in float64 or its inputs move by one unit in the last place,
eight times, plus 1e-13 of the largest entry (1e-10 for LV), plus 1e-15. A point with "clamped": true violates a constraint: E is
held at pi/2 - margin wherever it stands, s and k stay as they are, and V and LV mean nothing.
"""

import json
import sys
from pathlib import Path

import numpy as np

from law import evaluate, initial_state, upto
from lyapunov import generator, noise_columns, plant_rates, value
from problem import Exosystem
from real import exact
from every_term import every_term, exact_chain, single_block
from library import LIBRARY
from lookup import lookup
from six_joint_arm import six_joint_arm
from specs import SPECS

POINTS = Path(__file__).parents[1] / "points"
RANDOM_POINTS = 20
ALL = SPECS | {make.__name__: make for make in (*LIBRARY, six_joint_arm, every_term, single_block, exact_chain, lookup)}

# Typical size of h<i>, zeta<i> and of far-away states, per spec.
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
    "every_term": {"h1": 1.0, "h2": 1.0, "zeta1": 0.2, "zeta2": 0.2, "zeta3": 0.2, "x1": 2.0, "x2": 2.0, "x3": 2.0},
    "lookup": {"h1": 1.0, "zeta1": 0.2, "zeta2": 0.2, "x1": 2.0, "x2": 2.0},
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


def expected(problem, state):
    """Values of every output at an exact state; `clamped` if a constraint is violated."""
    out = evaluate(problem, state)
    clamped = any(
        block.constraint and out[f"e{i}"] @ out[f"e{i}"] >= out[f"k{i}"] ** 2 for i, block in enumerate(problem.blocks, 1)
    )
    for i, block in enumerate(problem.blocks, 1):
        if block.constraint is None:
            del out[f"E{i}"]
        if block.network is None:
            del out[f"A_hat{i}"]
        out.pop(f"w_hat{i}", None)
    if not clamped:
        out["V"], out["LV"] = value(problem, state), generator(problem, state)
        check = generator(problem, state, finer=100)
        assert abs(check - out["LV"]) <= 1e-18 * (1 + abs(out["LV"])), f"LV not converged: {check} {out['LV']}"
    return out, clamped


def tolerance(problem, state, values, rng):
    """How far float64 arithmetic may be from `values`, per output."""
    allowed = {}
    for trial in range(4):
        moved = {name: v * (1 + (trial > 0) * rng.choice([-1, 1], np.shape(v)) * 2.0**-52) for name, v in state.items()}
        out = evaluate(problem, moved)
        if "V" in values:
            at = {name: exact(v) for name, v in moved.items()}
            out["V"], out["LV"] = value(problem, at), generator(problem, at)
        for name, want in values.items():
            change = float(np.max(np.abs(out[name] - want)))
            allowed[name] = max(allowed.get(name, 0.0), change)
    relative = lambda name: 1e-10 if name == "LV" else 1e-13
    return {name: 8 * d + relative(name) * float(np.max(np.abs(values[name]))) + 1e-15 for name, d in allowed.items()}


def plant(problem, state, u_sat, rng):
    """The plant with dispersed parameters at the same state."""
    params = {name: rng.uniform(*problem.dispersion[name]) for name in problem.parameters}
    exact_params = {name: exact(v) for name, v in params.items()}
    rates = plant_rates(problem, state, u_sat, exact_params)
    order = [f"x{i}" for i in range(1, len(problem.blocks) + 1)]
    order += [name for name in (f"w{i}" for i in range(1, len(problem.blocks) + 1)) if name in rates]
    drift = np.concatenate([rates[name] for name in order])
    covariance = 0 * np.outer(drift, drift)
    for column in noise_columns(problem, state, exact_params):
        full = np.concatenate([column.get(name, 0 * rates[name]) for name in order])
        covariance = covariance + np.outer(full, full)
    return {"params": params, "drift": drift, "covariance": covariance}


def plain(x):
    """Nested lists of the nearest floats; what only rounding keeps from 0 is 0."""
    if isinstance(x, dict):
        return {name: plain(v) for name, v in x.items()}
    number = lambda v: float(v) if abs(v) > 1e-60 else 0.0
    return np.frompyfunc(number, 1, 1)(np.asarray(x, dtype=object)).tolist() if np.ndim(x) else number(x)


def points(name):
    """All points of a spec."""
    problem = ALL[name]()
    rng = np.random.default_rng(2024)
    sampler = Sampler(name, problem, rng)
    design = problem.parameters.items()  # V and LV are those of the design model
    parameters = {f"{of}.{parameter}": v for of in ("params", "plant") for parameter, v in design}
    wild, calm = (lambda: rng.uniform(0.05, 0.9)), (lambda: rng.uniform(0, 0.3))
    cases = [
        (f"random {j + 1}", sampler.state(calm, calm=True) if j % 2 else sampler.state(wild)) for j in range(RANDOM_POINTS)
    ]
    for label, state in cases + list(adversarial(sampler)):
        at = {key: exact(v) for key, v in state.items()}
        values, clamped = expected(problem, at)
        yield {
            "label": label,
            **({"clamped": True} if clamped else {}),
            "inputs": plain(state | parameters),
            "expected": plain(values),
            "tolerance": {name: float(f"{v:.3g}") for name, v in tolerance(problem, state, values, rng).items()},
            "plant": plain(plant(problem, at, values["u_sat"], rng)),
        }


def main():
    """Writes one file per spec, one point per line; of the specs named on the command line, or of all."""
    POINTS.mkdir(exist_ok=True)
    for name in sys.argv[1:] or ALL:
        lines = ",\n".join(json.dumps(point) for point in points(name))
        (POINTS / f"{name}.json").write_text(f'{{"spec": "{name}", "points": [\n{lines}\n]}}\n')


if __name__ == "__main__":
    main()
