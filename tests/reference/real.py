"""Elementary functions for arrays of floats and for arrays of mpmath numbers (dtype object).

The law is written once over both: floats simulate, mpmath numbers give expected values correct to the last digit.
"""

import mpmath
import numpy as np

mpmath.mp.dps = 120


def exact(x):
    """The same numbers as mpmath numbers."""
    return np.frompyfunc(mpmath.mpf, 1, 1)(np.asarray(x, dtype=object))


def is_exact(x):
    """Whether x holds mpmath numbers."""
    return np.asarray(x).dtype == object


def _both(on_float, on_mpf):
    array = np.frompyfunc(on_mpf, 1, 1)
    return lambda x: array(x) if is_exact(x) else on_float(x)


sin = _both(np.sin, mpmath.sin)
cos = _both(np.cos, mpmath.cos)
tan = _both(np.tan, mpmath.tan)
tanh = _both(np.tanh, mpmath.tanh)
exp = _both(np.exp, mpmath.exp)
log = _both(np.log, mpmath.log)
atan = _both(np.arctan, mpmath.atan)
sqrt = _both(np.sqrt, mpmath.sqrt)


def pi_like(x):
    """pi in the arithmetic of x."""
    return +mpmath.mp.pi if is_exact(x) else np.pi


def solve(a, b):
    """a^-1 b."""
    if not is_exact(a) and not is_exact(b):
        return np.linalg.solve(a, b)
    return np.array(list(mpmath.lu_solve(mpmath.matrix(a.tolist()), mpmath.matrix(b.tolist()))), dtype=object)


def inverse(a):
    """a^-1."""
    if not is_exact(a):
        return np.linalg.inv(a)
    return np.array((mpmath.matrix(a.tolist()) ** -1).tolist(), dtype=object)


def frobenius(a):
    """Root of the sum of squares; of a vector, its length."""
    a = np.asarray(a)
    return sqrt((a * a).sum())


def spectral(a):
    """Largest singular value; of a vector, its length."""
    a = np.asarray(a)
    if a.ndim < 2:
        return frobenius(a)
    if not is_exact(a):
        return np.linalg.norm(a, 2)
    gram = a.T @ a
    return mpmath.sqrt(max(mpmath.eigsy(mpmath.matrix(gram.tolist()), eigvals_only=True)))
