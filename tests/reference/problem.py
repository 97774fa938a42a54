"""Plain data of a control problem of the class: dx_i = (F_i + G_i x_{i+1} + dF_i + d_i) dt + H_i Sigma_i dw_i.

Functions take `x`, the list of block states so far (outermost first), and `p`, a dict of parameters. All numbers are SI.
"""

from dataclasses import dataclass, field
from itertools import product
from math import inf
from typing import Callable, Optional

import numpy as np


@dataclass
class Bounded:
    """d = value(t), unknown to the controller."""

    value: Callable


@dataclass
class Exosystem:
    """dw = M w dt + N dwbar, d = L w; block diagonal over the channels."""

    M: np.ndarray
    N: np.ndarray
    L: np.ndarray
    initial: np.ndarray

    @staticmethod
    def of_channels(channels):
        """From one (M, N, L, initial) per channel."""
        m, n, l, w = zip(*channels)
        return Exosystem(_diagonal(m), _diagonal(n), _diagonal([np.atleast_2d(row) for row in l]), np.concatenate(w))


def _diagonal(blocks):
    blocks = [np.asarray(b, dtype=float) for b in blocks]
    out = np.zeros((sum(b.shape[0] for b in blocks), sum(b.shape[1] for b in blocks)))
    row = col = 0
    for b in blocks:
        out[row : row + b.shape[0], col : col + b.shape[1]] = b
        row, col = row + b.shape[0], col + b.shape[1]
    return out


@dataclass
class Noise:
    """H(x, p) and the diagonal of Sigma."""

    effectiveness: Callable
    intensity: np.ndarray


@dataclass
class Network:
    """MTPN (4): inputs(x) are already divided by their scales."""

    order: int
    inputs: Callable
    count: int
    iota: np.ndarray
    gamma: float
    lam: float
    basis: str = "pairwise"
    exponents: list = field(init=False)

    def __post_init__(self):
        """Monomials: total degree ascending, then the exponent of z_1 descending, z_2, ..."""
        powers = [a for a in product(range(self.order + 1), repeat=self.count) if sum(a) <= self.order]
        if self.basis == "pairwise":
            powers = [a for a in powers if sum(1 for n in a if n > 0) <= 2]
        self.exponents = sorted(powers, key=lambda a: (sum(a), [-n for n in a]))


@dataclass
class ErrorBound:
    """eps_hat law (66)."""

    rate: float
    b: np.ndarray


@dataclass
class NoiseBound:
    """sigma_hat law (67) and phi law (68)."""

    tau: float
    lam: float
    varsigma: float
    phi_initial: float
    phi_kappa: float
    phi_threshold: float


@dataclass
class Block:
    """One block of the chain and its part of the controller. `constraint` is (k, k') as functions of time, or None."""

    name: str
    initial: np.ndarray
    drift: Callable
    gain: Callable
    K: np.ndarray
    kbar: float
    C: np.ndarray
    disturbance: object = None
    noise: Optional[Noise] = None
    filter: Optional[np.ndarray] = None
    eta_1: float = inf
    eta_2: float = inf
    eta_3: float = inf
    eta_noise: float = inf
    observer: Optional[np.ndarray] = None
    constraint: Optional[tuple] = None
    network: Optional[Network] = None
    error_bound: Optional[ErrorBound] = None
    noise_bound: Optional[NoiseBound] = None


@dataclass
class Truth:
    """What is flown in place of the blocks' F + G x, disturbances and noise of the blocks aside.

    `rates(t, x, z, u, p)` with the further states z gives their rates under "truth", and those of x<i> that it replaces.
    """

    initial: np.ndarray
    rates: Callable


@dataclass
class Problem:
    """The whole problem. `reference` is (y_r, y_r') as functions of time; `dispersion` maps a parameter to its uniform range."""

    name: str
    width: int
    blocks: list
    reference: tuple
    limits: np.ndarray
    parameters: dict
    dispersion: dict
    horizon: float
    sample_time: float
    settle: float
    norm: str = "frobenius"
    barrier_margin: float = 1e-3
    wiener: bool = False
    exact: bool = False  # virtual_derivative: exact
    substeps: int = 4
    truth: Optional[Truth] = None
    actuator: Optional[tuple] = None  # lag in s, and largest rate
