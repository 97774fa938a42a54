"""Closed loop of a problem: the sampled controller of section 4 against the plant, in floats.

Linear parts of the controller's states are integrated by their exponential over one sample with the rest held; phi decays by
exp(-dt (Psi/(phi^2 + s^2) + kappa)) and is held at sqrt(Psi dt/0.1) (E11).
"""

from dataclasses import dataclass

import numpy as np

from law import evaluate, initial_state
from problem import Bounded, Exosystem


def expm(a):
    """Matrix exponential by scaling, a Taylor polynomial of degree 18 and squaring."""
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(a).sum(), 1e-300)))) + 4)
    term = total = np.eye(len(a))
    for order in range(1, 19):
        term = term @ (a / 2**halvings) / order
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total


def hold(a, dt):
    """(exp(a dt), its integral over dt): x(dt) = first x(0) + second b solves x' = a x + b."""
    m = len(a)
    both = expm(np.block([[a * dt, np.eye(m) * dt], [np.zeros((m, 2 * m))]]))
    return both[:m, :m], both[:m, m:]


class Integrator:
    """One sample of the controller's states."""

    def __init__(self, problem):
        self.problem, self.dt = problem, problem.sample_time
        self.linear = {}
        for i, block in enumerate(problem.blocks, 1):
            self.linear[f"zeta{i}"] = -np.asarray(block.C)
            if isinstance(block.disturbance, Bounded):
                self.linear[f"th{i}"] = -block.observer
            if isinstance(block.disturbance, Exosystem):
                self.linear[f"th{i}"] = block.disturbance.M - block.observer @ block.disturbance.L
        self.held = {name: hold(a, self.dt) for name, a in self.linear.items()}

    def step(self, state, out):
        """States at the next sample."""
        new = dict(state)
        for name, (_, integral) in self.held.items():
            new[name] = state[name] + integral @ out[f"{name}_dot"]  # exp - I = integral a
        for i, block in enumerate(self.problem.blocks, 1):
            if f"h{i}" in state:
                new[f"h{i}"] = self._decay(state[f"h{i}"], out[f"h{i}_dot"], 1 / block.filter)
            if block.network:
                net = block.network
                new[f"W{i}"] = self._decay(state[f"W{i}"], out[f"W{i}_dot"], net.gamma * net.lam)
            if block.error_bound:
                new[f"eps{i}"] = self._decay(state[f"eps{i}"], out[f"eps{i}_dot"], block.error_bound.rate)
            if block.noise:
                law = block.noise_bound
                new[f"sigma{i}"] = self._decay(state[f"sigma{i}"], out[f"sigma{i}_dot"], law.tau * law.lam)
                new[f"phi{i}"] = self._phi(state[f"phi{i}"], out, i, law)
        return new

    def _decay(self, x, x_dot, rate):
        return x + -np.expm1(-rate * self.dt) / rate * x_dot

    def _phi(self, phi, out, i, law):
        e, Psi = out[f"e{i}"], out[f"Psi{i}"]
        s = e @ e
        if np.sqrt(s) >= law.phi_threshold:
            phi = phi * np.exp(-self.dt * (Psi / (phi**2 + s**2) + law.phi_kappa))
        return max(phi, np.sqrt(Psi * self.dt / 0.1))


@dataclass
class Plant:
    """The true system: block states, then further states of what is flown, and exosystem states, with held or Wiener noise."""

    problem: object
    params: dict

    def __post_init__(self):
        blocks = self.problem.blocks
        self.x = [np.array(b.initial, dtype=float) for b in blocks]
        if self.problem.truth:
            self.x.append(self.problem.truth.initial)
        self.felt = np.zeros(self.problem.width)  # position of the actuators
        self.w = [np.array(b.disturbance.initial, dtype=float) if isinstance(b.disturbance, Exosystem) else None for b in blocks]

    def disturbance(self, i, t, w):
        """d_i."""
        d = self.problem.blocks[i].disturbance
        if isinstance(d, Bounded):
            return d.value(t)
        return d.L @ w[i] if isinstance(d, Exosystem) else np.zeros(self.problem.width)

    def rates(self, t, x, w, u, xi, eta):
        """(x', w') with the noise xi, eta as held values (zeros for Wiener noise, which `advance` adds)."""
        n = len(self.problem.blocks)
        flown = self.problem.truth.rates(t, x[:n], x[n], u, self.params) if self.problem.truth else {}
        dx, dw = [], []
        for i, block in enumerate(self.problem.blocks):
            y = x[: i + 1]
            v = flown.get(f"x{i + 1}")
            if v is None:
                v = block.drift(y, self.params) + block.gain(y, self.params) @ (u if i == n - 1 else x[i + 1])
            v = v + self.disturbance(i, t, w)
            if block.noise and xi[i] is not None:
                v = v + block.noise.effectiveness(y, self.params) @ (block.noise.intensity * xi[i])
            dx.append(v)
            exo = block.disturbance if w[i] is not None else None
            dw.append(None if exo is None else exo.M @ w[i] + (0 if eta[i] is None else exo.N @ eta[i]))
        if flown:
            dx.append(flown["truth"])
        return dx, dw

    def actuated(self, u, h):
        """What the plant feels of a command over a step: a lag with a limited rate, or the command itself."""
        if self.problem.actuator is None:
            return u
        lag, rate = self.problem.actuator
        self.felt = self.felt + np.clip(-np.expm1(-h / lag) * (u - self.felt), -h * rate, h * rate)
        return self.felt

    def advance(self, t, u, dt, substeps, rng, wiener, scheme):
        """Over one sample."""
        blocks, h = self.problem.blocks, dt / substeps
        none = [None] * len(blocks)
        draw = lambda: self._draw(rng)
        xi, eta = (none, none) if rng is None or wiener else draw()
        command = u
        for _ in range(substeps):
            x, w, u = self.x, self.w, self.actuated(command, h)
            if wiener and rng is not None:
                kicks, exo_kicks = draw()
                k, l = self.rates(t, x, w, u, none, none)
                self.x, self.w = _add(x, w, h, (k, l))
                for i, block in enumerate(blocks):
                    if block.noise:
                        H = block.noise.effectiveness(x[: i + 1], self.params)
                        self.x[i] = self.x[i] + np.sqrt(h) * H @ (block.noise.intensity * kicks[i])
                    if w[i] is not None:
                        self.w[i] = self.w[i] + np.sqrt(h) * block.disturbance.N @ exo_kicks[i]
            elif scheme == "euler":
                self.x, self.w = _add(x, w, h, self.rates(t, x, w, u, xi, eta))
            else:
                f = lambda time, z: self.rates(time, *z, u, xi, eta)
                k1 = f(t, (x, w))
                k2 = f(t + h / 2, _add(x, w, h / 2, k1))
                k3 = f(t + h / 2, _add(x, w, h / 2, k2))
                k4 = f(t + h, _add(x, w, h, k3))
                for k, weight in ((k1, 1), (k2, 2), (k3, 2), (k4, 1)):
                    x, w = _add(x, w, h * weight / 6, k)
                self.x, self.w = x, w
            t += h

    def _draw(self, rng):
        blocks = self.problem.blocks
        xi = [rng.standard_normal(len(b.noise.intensity)) if b.noise else None for b in blocks]
        exo = [b.disturbance if isinstance(b.disturbance, Exosystem) else None for b in blocks]
        return xi, [rng.standard_normal(e.N.shape[1]) if e else None for e in exo]


def _add(x, w, h, k):
    return [a + h * b for a, b in zip(x, k[0])], [a if a is None else a + h * b for a, b in zip(w, k[1])]


def simulate(problem, seed=None, params=None, horizon=None, scheme="euler"):
    """Run the loop; returns a dict of arrays over the samples: t, x<i>, e<i>, y_r, d<i>, D_hat<i>, u, u_sat, ratio<i>, ..."""
    rng = None if seed is None else np.random.default_rng(seed)
    plant = Plant(problem, params or problem.parameters)
    state, integrator, log = initial_state(problem), Integrator(problem), {}
    dt = problem.sample_time
    for sample in range(round((horizon or problem.horizon) / dt)):
        t = sample * dt
        state["t"] = t
        for i in range(1, len(problem.blocks) + 1):
            state[f"x{i}"] = plant.x[i - 1]
        out = evaluate(problem, state)
        _record(log, problem, t, plant, state, out)
        if not np.isfinite(out["u"]).all():
            break
        state = integrator.step(state, out)
        plant.advance(t, out["u_sat"], dt, problem.substeps, rng, problem.wiener, scheme)
    return {name: np.array(values) for name, values in log.items()}


def _record(log, problem, t, plant, state, out):
    row = {"t": t, "y_r": out["y_r"], "u": out["u"], "u_sat": out["u_sat"]}
    for i, block in enumerate(problem.blocks, 1):
        row[f"x{i}"], row[f"e{i}"], row[f"zeta{i}"] = state[f"x{i}"], out[f"e{i}"], state[f"zeta{i}"]
        row[f"d{i}"] = plant.disturbance(i - 1, t, plant.w)
        row[f"Lam{i}"] = out[f"Lam{i}"]
        if f"D_hat{i}" in out:
            row[f"D_hat{i}"] = out[f"D_hat{i}"]
        if f"k{i}" in out:
            # The output's constraint is on the tracking error; e_1 lacks what the limits of the inputs keep it from.
            error = state["x1"] - out["y_r"] if i == 1 else out[f"e{i}"]
            row[f"ratio{i}"] = np.linalg.norm(error) / out[f"k{i}"]
        if block.noise:
            row[f"phi{i}"], row[f"sigma{i}"], row[f"Psi{i}"] = state[f"phi{i}"], state[f"sigma{i}"], out[f"Psi{i}"]
        if f"alpha{i}" in out:
            row[f"alpha{i}"] = out[f"alpha{i}"]
    for name, value in row.items():
        log.setdefault(name, []).append(value)


def summary(problem, run):
    """What the reference page reports: peak constraint ratio, rms errors after settling, saturation."""
    late = run["t"] >= problem.settle
    rms = lambda a: np.sqrt((a[late] ** 2).mean(axis=0))
    out = {"samples": len(run["t"]), "rms": rms(run["x1"] - run["y_r"]), "saturated": (run["u"] != run["u_sat"]).mean(axis=0)}
    for i in range(1, len(problem.blocks) + 1):
        if f"ratio{i}" in run:
            out[f"ratio{i}"] = run[f"ratio{i}"].max()
        if f"D_hat{i}" in run:
            out[f"observer{i}"] = rms(run[f"D_hat{i}"] - run[f"d{i}"])
            out[f"d{i}"] = rms(run[f"d{i}"])
    return out
