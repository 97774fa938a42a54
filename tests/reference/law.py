"""The control law of sections 2 to 4 of the design equations, evaluated literally at one point.

Written from the equations, for floats or mpmath numbers. Numbers in parentheses are equations of the paper; E1.. are its errata.
The state is a dict: t, x<i>, th<i>, h<i>, zeta<i>, W<i>, eps<i>, sigma<i>, phi<i>; results are a dict under the names of the
compiler (e<i>, E<i>, c<i>, Lam<i>, alpha<i>, u, th<i>_dot, ...).
"""

import numpy as np
from mpmath import mpf

from problem import Bounded, Exosystem
from real import cos, exact, frobenius, is_exact, pi_like, sin, solve, spectral, sqrt, tan, tanh


def basis(network, z):
    """P(z) (4), in the canonical order of its monomials."""
    one = exact(1) if is_exact(z) else 1.0
    monomials = []
    for powers in network.exponents:
        value = one
        for base, n in zip(z, powers):
            value = value * base**n
        monomials.append(value)
    return np.array(monomials)


def barrier(e, k, margin):
    """E = pi s^2/(2 k^4) clamped below pi/2, and its limits at 0 (Remark 4): sin(E)cos(E) over the free E, tan(E)/E."""
    s = e @ e
    zero = s - s
    if k is None:
        return zero, zero + 1, zero + 1
    pi = pi_like(s)
    clamp = pi / 2 - margin
    free = pi * s**2 / (2 * k**4)
    if free == 0:
        return zero, zero + 1, zero + 1
    E = min(free, clamp)
    return E, sin(E) * cos(E) / free, tan(E) / E


def saturate(u, limits):
    """sat(u) (8)."""
    return np.array([min(max(v, -l), l) for v, l in zip(u, limits)])


def ybar_norm(norm, e, E, k, s):
    """Norm of Ybar = a e e^T + b I (58, E3), a = (4 pi/k^4) (sin E/cos^3 E) s, b = 3/cos^2 E."""
    m = len(e)
    b = 3 / cos(E) ** 2
    a = 0 if k is None else 4 * pi_like(s) / k**4 * sin(E) / cos(E) ** 3 * s
    if norm == "spectral":
        return a * s + b
    return sqrt(a**2 * s**2 + 2 * a * b * s + m * b**2)


def evaluate(problem, state, params=None):
    """All quantities of the law at `state`."""
    out = {}
    params = params or problem.parameters
    t = state["t"]
    n, m = len(problem.blocks), problem.width
    x = [state[f"x{i}"] for i in range(1, n + 1)]
    out["y_r"], out["y_r_dot"] = problem.reference[0](t), problem.reference[1](t)
    for i in range(1, n + 1):
        _block(problem, i, state, params, x[:i], out)
    out["u"] = out.pop(f"alpha{n}")
    out["u_sat"] = saturate(out["u"], problem.limits)
    for i in range(1, n + 1):
        _rates(problem, i, state, x, out)
        out.pop(f"h{i}", None)
    return out


def _block(problem, i, state, params, x, out):
    """Errors, barrier, Lam_i and alpha_i of block i (31)(64); needs the results of block i - 1."""
    block, n, m = problem.blocks[i - 1], len(problem.blocks), problem.width
    norm = spectral if problem.norm == "spectral" else frobenius
    if i > 1:
        _follow(problem, i - 1, state, params, out)
    h, h_dot = (out["y_r"], out["y_r_dot"]) if i == 1 else (out[f"h{i - 1}"], out[f"h{i - 1}_dot"])
    zeta = state[f"zeta{i}"]
    e = x[-1] - h - zeta  # (14)
    s = e @ e
    k = block.constraint[0](state["t"]) if block.constraint else None
    E, sin_cos_over, _ = barrier(e, k, problem.barrier_margin)
    c = s * e / cos(E) ** 2
    F, G = block.drift(x, params), block.gain(x, params)
    H = block.noise.effectiveness(x, params) if block.noise else None
    P = basis(block.network, block.network.inputs(x)) if block.network else None
    A_hat = block.network.iota * (state[f"W{i}"].T @ P) if block.network else 0 * e
    D_hat, w_hat = _estimate(block, state, i, x[-1], e)

    # With k^4/(2 pi) sin E cos E/s^2 = sin E cos E/(4 pi s^2/(2 k^4)) the limits k -> infinity and e -> 0 need no special case.
    lam = (4 * block.kbar + block.K) / 4 * sin_cos_over * e + block.kbar * e
    if isinstance(block.disturbance, Bounded):
        lam = lam + block.eta_1 / 2 * c
    if isinstance(block.disturbance, Exosystem):
        lam = lam + norm(block.disturbance.L) ** 2 / (2 * block.eta_1) * c
    if i < n:
        lam = lam + block.eta_2 / 2 * norm(G) ** 2 * c
    dominated = block.network is not None and not isinstance(block.disturbance, Bounded)
    if dominated:
        lam = lam + e / (2 * cos(E) ** 2)
        lam = lam + state[f"eps{i}"] * tanh(e / block.error_bound.b)
    if i > 1:
        outer = problem.blocks[i - 2]
        lam = lam + norm(out[f"G{i - 1}"]) ** 4 * frobenius(out[f"c{i - 1}"]) ** 4 * cos(E) ** 2 * e / (4 * outer.eta_3**4)
    if block.noise:
        bound = block.noise_bound
        Y = ybar_norm(problem.norm, e, E, k, s)
        Psi = norm(H) ** 4 * Y**2 * bound.varsigma**2 / 2  # (62)
        if isinstance(block.disturbance, Exosystem):
            Psi = Psi + 2 * norm(block.disturbance.N) ** 2
        if block.disturbance is not None:
            Psi = Psi + block.eta_noise * norm(block.observer @ H) ** 4
        lam = lam + norm(H) ** 2 * Y * state[f"sigma{i}"] * e / sqrt(s**2 + bound.varsigma**2)  # E4, E7
        lam = lam + e * Psi * cos(E) ** 2 / (state[f"phi{i}"] ** 2 + s**2)
        out[f"H{i}"], out[f"Ybar_norm{i}"], out[f"Psi{i}"] = H, Y, Psi

    alpha = -solve(G, F + A_hat - h_dot + block.C @ zeta + D_hat + lam)
    out |= {f"e{i}": e, f"E{i}": E, f"c{i}": c, f"F{i}": F, f"G{i}": G, f"Lam{i}": lam, f"alpha{i}": alpha, f"A_hat{i}": A_hat}
    if k is not None:
        out[f"k{i}"], out[f"k{i}_dot"] = k, block.constraint[1](state["t"])
    if block.network:
        out[f"P{i}"] = P
    if block.disturbance is not None:
        out[f"D_hat{i}"] = D_hat
    if w_hat is not None:
        out[f"w_hat{i}"] = w_hat


def _follow(problem, i, state, params, out):
    """h_i and h_i' of an inner command: of the filter (33), or alpha_i and its derivative along the known dynamics (34)."""
    if not problem.exact:
        out[f"h{i}"] = state[f"h{i}"]
        out[f"h{i}_dot"] = (out[f"alpha{i}"] - state[f"h{i}"]) / problem.blocks[i - 1].filter
        return
    x = [state[f"x{j}"] for j in range(1, i + 2)]
    flow = {"t": 1}
    for j in range(1, i + 1):
        flow[f"x{j}"] = out[f"F{j}"] + out[f"G{j}"] @ x[j] + out[f"A_hat{j}"] + out.get(f"D_hat{j}", 0)
        rates = dict(out)
        _rates(problem, j, state, x, rates)
        flow |= {name: rates[f"{name}_dot"] for name in state if name.endswith(str(j)) and f"{name}_dot" in rates}
    step = mpf(10) ** -27 if is_exact(state["t"]) else 1e-5
    along = lambda by: upto(problem, i, state | {name: state[name] + by * rate for name, rate in flow.items()}, params)
    out[f"h{i}"] = out[f"alpha{i}"]
    out[f"h{i}_dot"] = (along(step)[f"alpha{i}"] - along(-step)[f"alpha{i}"]) / (2 * step)


def _estimate(block, state, i, x, e):
    """D_hat (20), or L w_hat with w_hat (49)."""
    if isinstance(block.disturbance, Bounded):
        return state[f"th{i}"] + block.observer @ x, None
    if isinstance(block.disturbance, Exosystem):
        w_hat = state[f"th{i}"] + block.observer @ e
        return block.disturbance.L @ w_hat, w_hat
    return 0 * e, None


def _rates(problem, i, state, x, out):
    """Time derivatives of the controller's states of block i."""
    block, n = problem.blocks[i - 1], len(problem.blocks)
    e, E, c, F, G = (out[f"{q}{i}"] for q in ("e", "E", "c", "F", "G"))
    s, zeta, A_hat = e @ e, state[f"zeta{i}"], out[f"A_hat{i}"]
    S = block.observer

    beyond = out["u_sat"] - out["u"] if i == n else state[f"zeta{i + 1}"]
    out[f"zeta{i}_dot"] = -block.C @ zeta + G @ beyond  # (13), E1

    if isinstance(block.disturbance, Bounded):
        next_x = out["u_sat"] if i == n else x[i]
        out[f"th{i}_dot"] = -S @ (out[f"D_hat{i}"] + F + G @ next_x + A_hat)  # (21)
    if isinstance(block.disturbance, Exosystem):
        exo = block.disturbance
        v = out["u"] if i == n else x[i] - state[f"zeta{i + 1}"]
        h_dot = out["y_r_dot"] if i == 1 else out[f"h{i - 1}_dot"]
        known = F + G @ v - h_dot + block.C @ zeta + A_hat
        out[f"th{i}_dot"] = (exo.M - S @ exo.L) @ out[f"w_hat{i}"] - S @ known  # (50)
    if block.network:
        net = block.network
        out[f"W{i}_dot"] = net.gamma * (np.outer(out[f"P{i}"], c * net.iota) - net.lam * state[f"W{i}"])  # (32)(65)
    if block.error_bound:
        law = block.error_bound
        out[f"eps{i}_dot"] = law.rate * (s / cos(E) ** 2 * (e @ tanh(e / law.b)) - state[f"eps{i}"])  # (66)
    if block.noise:
        law, phi, norm = block.noise_bound, state[f"phi{i}"], spectral if problem.norm == "spectral" else frobenius
        H2 = norm(out[f"H{i}"]) ** 2
        drive = H2 * out[f"Ybar_norm{i}"] * s**2 / (cos(E) ** 2 * sqrt(s**2 + law.varsigma**2))
        out[f"sigma{i}_dot"] = law.tau * (drive - law.lam * state[f"sigma{i}"])  # (67)
        decay = -phi * out[f"Psi{i}"] / (phi**2 + s**2) - law.phi_kappa * phi
        out[f"phi{i}_dot"] = decay if sqrt(s) >= law.phi_threshold else 0 * phi  # (68)


def initial_state(problem, params=None):
    """The controller's state at t = 0: first estimates zero, h_i = alpha_i, all else 0, phi as declared."""
    n, m = len(problem.blocks), problem.width
    state = {"t": 0.0}
    for i, block in enumerate(problem.blocks, 1):
        state[f"x{i}"] = np.array(block.initial, dtype=float)
        state[f"zeta{i}"] = np.zeros(m)
        if isinstance(block.disturbance, Bounded):
            state[f"th{i}"] = -block.observer @ state[f"x{i}"]
        elif isinstance(block.disturbance, Exosystem):
            state[f"th{i}"] = np.zeros(len(block.disturbance.M))
        if block.network:
            state[f"W{i}"] = np.zeros((len(block.network.exponents), m))
        if block.error_bound:
            state[f"eps{i}"] = 0.0
        if block.noise:
            state[f"sigma{i}"], state[f"phi{i}"] = 0.0, block.noise_bound.phi_initial
    for i, block in enumerate(problem.blocks, 1):  # block i's errors need h_{i-1}, its alpha needs its own estimate
        out = upto(problem, i, state, params)
        if isinstance(block.disturbance, Exosystem):
            state[f"th{i}"] = -block.observer @ out[f"e{i}"]
            out = upto(problem, i, state, params)
        if i < n and not problem.exact:
            state[f"h{i}"] = out[f"alpha{i}"]
    return state


def upto(problem, last, state, params=None):
    """The quantities of blocks 1 to `last`."""
    t = state["t"]
    out = {"y_r": problem.reference[0](t), "y_r_dot": problem.reference[1](t)}
    x = [state[f"x{j}"] for j in range(1, last + 1)]
    for j in range(1, last + 1):
        _block(problem, j, state, params or problem.parameters, x[:j], out)
    return out
