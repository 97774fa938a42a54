"""Writes tests/points/<spec>.json: states of the closed loop and what the law must give there, to the last digit.

Run from anywhere: python tests/reference/make_points.py [SPEC ..]. The result depends on this folder and the data of the specifications alone.
A point has a label, `inputs` (names as in `nsv eval`), `expected`, and `plant`: with dispersed parameters, the drift of (x, w)
under u_sat and the covariance diffusion * diffusion^T; with further states of what is flown, `truth`, the drift is that of (x, truth, w)
and `tolerance` that of each of its entries. Matrices are lists of rows. `tolerance` is what float64 can be asked for,
per output: the largest change of any entry when the law is evaluated in float64 or its inputs move by one unit in the last place,
eight times, plus 1e-13 of the largest entry (1e-10 for LV), plus 1e-15. A point with "clamped": true violates a constraint: E is
held at pi/2 - margin wherever it stands, s and k stay as they are, and V and LV mean nothing.
"""

import json
import sys
from pathlib import Path

import numpy as np

from law import evaluate
from lyapunov import flown_rates, generator, noise_columns, value
from real import exact
from every_term import every_term, exact_chain, single_block
from library import LIBRARY
from link_chain import link_chain
from lookup import lookup
from missile import missile_pitch
from sampling import Sampler, adversarial
from six_dof import nsv_six_dof
from six_joint_arm import six_joint_arm
from specs import SPECS

POINTS = Path(__file__).parents[1] / "points"
RANDOM_POINTS = 20
FURTHER = (six_joint_arm, missile_pitch, nsv_six_dof, every_term, single_block, exact_chain, lookup, link_chain)
ALL = SPECS | {make.__name__: make for make in (*LIBRARY, *FURTHER)}

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
    rates = flown_rates(problem, state, u_sat, exact_params)
    order = [f"x{i}" for i in range(1, len(problem.blocks) + 1)] + ["truth"]
    order += [f"w{i}" for i in range(1, len(problem.blocks) + 1)]
    order = [name for name in order if name in rates]
    drift = np.concatenate([rates[name] for name in order])
    covariance = 0 * np.outer(drift, drift)
    for column in noise_columns(problem, state, exact_params):
        full = np.concatenate([column.get(name, 0 * rates[name]) for name in order])
        covariance = covariance + np.outer(full, full)
    found = {"params": params, "drift": drift, "covariance": covariance}
    if problem.truth:
        found["tolerance"] = np.concatenate([*drift_tolerance(problem, state, u_sat, params, rates, order, rng)])
    return found


def drift_tolerance(problem, state, u_sat, params, rates, order, rng):
    """`tolerance` of the drift, entry by entry: a block's states are judged together, a further state, with a unit of its own, alone."""
    moved = []
    for trial in range(4):
        shake = lambda v: np.asarray(v, dtype=float) * (1 + (trial > 0) * rng.choice([-1, 1], np.shape(v)) * 2.0**-52)
        at, p = {name: shake(v) for name, v in state.items()}, {name: shake(v) for name, v in params.items()}
        moved.append(flown_rates(problem, at, shake(u_sat), p))
    for name in order:
        together = (lambda v: v) if name == "truth" else (lambda v: np.full(len(v), max(v)))
        change = np.max([np.abs(found[name] - rates[name]) for found in moved], axis=0)
        allowed = 8 * together(change) + 1e-13 * together(np.abs(rates[name])) + 1e-15
        yield [float(f"{v:.3g}") for v in allowed.astype(float)]


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
