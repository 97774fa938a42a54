"""V (52) and its Ito generator LV (2) along the nominal closed loop, in mpmath numbers.

V = sum_i [ V_i(e_i, k_i) + 1/2 tr(W_i^T Gamma_i^-1 W_i) + 1/2 |theta~_i|^2 + 1/2 |zeta_i|^2 + eps_i^2/(2 iota_i0)
            + (|Sigma_i|_F^2 - sigma_i)^2/(2 taubar_i) + phi_i^2/2 ] + sum_{i<n} 1/2 |h_i - alpha_i|^2
with W* = 0, unknown error bounds 0, theta~ = d_i(t) - D_hat_i (bounded) or w_i - w_hat_i (exosystem).

The nominal plant is the design model with its disturbances: dF = 0. LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j needs V only along
lines: the derivative along (1, f) and the second derivatives along the noise columns g_j, here by central differences at 120
digits. make_points checks that steps a hundred times shorter change LV by less than 1e-18 of itself.
"""

from mpmath import mpf

from law import barrier, evaluate
from problem import Bounded, Exosystem

STEP_1 = mpf(10) ** -27  # for the first derivative: truncation 1e-54, rounding 1e-93
STEP_2 = mpf(10) ** -19  # for the second: truncation 1e-38, rounding 1e-82


def value(problem, state):
    """V."""
    out = evaluate(problem, state)
    total = mpf(0)
    for i, block in enumerate(problem.blocks, 1):
        e, zeta = out[f"e{i}"], state[f"zeta{i}"]
        s = e @ e
        tan_over = barrier(e, out.get(f"k{i}"), problem.barrier_margin)[2]
        total += s**2 / 4 * tan_over + (zeta @ zeta) / 2  # k^4/(2 pi) tan E = s^2/4 tan(E)/E
        if block.network:
            total += (state[f"W{i}"] ** 2).sum() / (2 * block.network.gamma)
        if block.disturbance is not None:
            exo = isinstance(block.disturbance, Exosystem)
            error = state[f"w{i}"] - out[f"w_hat{i}"] if exo else block.disturbance.value(state["t"]) - out[f"D_hat{i}"]
            total += (error @ error) / 2
        if i < len(problem.blocks) and not problem.exact:  # exact: h_i = alpha_i
            chi = state[f"h{i}"] - out[f"alpha{i}"]
            total += (chi @ chi) / 2
        if block.error_bound:
            total += state[f"eps{i}"] ** 2 / (2 * block.error_bound.rate)
        if block.noise:
            bound = float((block.noise.intensity**2).sum())
            total += (bound - state[f"sigma{i}"]) ** 2 / (2 * block.noise_bound.tau) + state[f"phi{i}"] ** 2 / 2
    return total


def plant_rates(problem, state, u_sat, params=None):
    """Drift of x<i> and w<i> of the design model, as a dict."""
    params = params or problem.parameters
    n, rates = len(problem.blocks), {}
    x = [state[f"x{i}"] for i in range(1, n + 1)]
    for i, block in enumerate(problem.blocks, 1):
        y = x[:i]
        rates[f"x{i}"] = block.drift(y, params) + block.gain(y, params) @ (u_sat if i == n else x[i])
    return _disturbed(problem, state, rates)


def flown_rates(problem, state, u_sat, params):
    """Drift of x<i>, further states and w<i> of what is flown, as a dict."""
    rates = plant_rates(problem, state, u_sat, params)
    if problem.truth:
        x = [state[f"x{i}"] for i in range(1, len(problem.blocks) + 1)]
        rates |= _disturbed(problem, state, problem.truth.rates(state["t"], x, state["truth"], u_sat, params))
    return rates


def _disturbed(problem, state, rates):
    """Rates with d_i added, and those of w<i>."""
    rates = dict(rates)
    for i, block in enumerate(problem.blocks, 1):
        if f"x{i}" in rates and isinstance(block.disturbance, Bounded):
            rates[f"x{i}"] = rates[f"x{i}"] + block.disturbance.value(state["t"])
        if f"x{i}" in rates and isinstance(block.disturbance, Exosystem):
            rates[f"x{i}"] = rates[f"x{i}"] + block.disturbance.L @ state[f"w{i}"]
            rates[f"w{i}"] = block.disturbance.M @ state[f"w{i}"]
    return rates


def noise_columns(problem, state, params=None):
    """One dict of directions per Wiener process: columns of H_i Sigma_i for x<i>, of N_i for w<i>."""
    columns = []
    x = [state[f"x{i}"] for i in range(1, len(problem.blocks) + 1)]
    for i, block in enumerate(problem.blocks, 1):
        if block.noise:
            matrix = block.noise.effectiveness(x[:i], params or problem.parameters) * block.noise.intensity
            columns += [{f"x{i}": column} for column in matrix.T]
        if isinstance(block.disturbance, Exosystem):
            columns += [{f"w{i}": column} for column in block.disturbance.N.T]
    return columns


def _moved(state, direction, step):
    return state | {name: state[name] + step * rate for name, rate in direction.items()}


def generator(problem, state, finer=1):
    """LV, with steps divided by `finer`."""
    first, second = STEP_1 / finer, STEP_2 / finer
    out = evaluate(problem, state)
    flow = {"t": mpf(1)} | plant_rates(problem, state, out["u_sat"])
    flow |= {name: out[f"{name}_dot"] for name in state if f"{name}_dot" in out}
    along = lambda direction, by: value(problem, _moved(state, direction, by))
    total = (along(flow, first) - along(flow, -first)) / (2 * first)
    here = value(problem, state)
    for column in noise_columns(problem, state):
        total += (along(column, second) - 2 * here + along(column, -second)) / (2 * second**2)
    return total
