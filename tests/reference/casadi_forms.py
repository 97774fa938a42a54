"""Operations of the compiler's programs that CasADi does not have, in forms of its own operations."""

import re
from functools import cache

import casadi as ca
import numpy as np


def product(factors):
    """Of symbols to powers."""
    result = ca.SX(1)
    for symbol, exponent in factors:
        result *= symbol**exponent if exponent else 1
    return result


@cache
def spline(text, orders):
    """A lookup table, differentiated so many times by each argument, as a function of arguments and coefficients; and its coefficients."""
    *axes, coefficients = [part.split(", ") for part in re.findall(r"\[([^]]*)\]", text)]
    degree, outside = re.search(r"(\w+) (\w+) \[[^]]*\]$", text).groups()
    assert outside == "clamp", "elsewhere a table is no number"
    assert degree == "cubic" or not any(orders), "CasADi's slope of straight lines is 0 at a break"
    degree, axes = {"linear": 1, "cubic": 3}[degree], [[float(word) for word in axis] for axis in axes]
    knots = [axis[:1] * degree + axis + axis[-1:] * degree for axis in axes]
    z, c = ca.MX.sym("z", len(axes)), ca.MX.sym("c", len(coefficients))
    value = ca.Function("spline", [z, c], [ca.bspline(z, c, knots, [degree] * len(axes), 1)], {"never_inline": True})
    z, c = ca.SX.sym("z", len(axes)), ca.SX.sym("c", len(coefficients))
    held = ca.vertcat(*[ca.fmax(axis[0], ca.fmin(axis[-1], x)) for axis, x in zip(axes, ca.vertsplit(z))])
    value = value(z, c)
    for at in [at for at, order in enumerate(orders) for _ in range(order)]:
        value = ca.jacobian(value, z)[at]
    value = ca.substitute(value, z, held)
    for at in [at for at, order in enumerate(orders) if order]:
        value = ca.if_else(z[at] == held[at], value, 0)
    sizes = [len(along) - degree - 1 for along in knots]
    return ca.Function("table", [z, c], [value]), np.reshape(coefficients, sizes).ravel(order="F")  # CasADi's first axis changes fastest


@cache
def kernel(order):
    """sin(E) cos(E)/E or a derivative, by CasADi from the quotient, and near 0 from its Taylor series."""
    e = ca.SX.sym("e")
    terms, term = [], ca.SX(1)
    for j in range(1, 20):
        terms.append(term)
        term = -term * (2 * e) ** 2 / ((2 * j) * (2 * j + 1))
    arms = [sum(reversed(terms)), ca.sin(e) * ca.cos(e) / e]
    for _ in range(order):
        arms = [ca.gradient(arm, e) for arm in arms]
    return ca.Function("kernel", [e], [ca.if_else(ca.fabs(e) < 1, *arms)])


def singular_vector(a):
    """Of the largest singular value of a matrix of two columns or two rows; its entry of largest magnitude is not negative."""
    assert 2 in a.shape, "the closed form is that of an angle"
    s = ca.mtimes(a.T, a) if a.shape[1] == 2 else ca.mtimes(a, a.T)
    angle = ca.atan2(2 * s[0, 1], s[0, 0] - s[1, 1]) / 2
    vector = ca.vertcat(ca.cos(angle), ca.sin(angle))
    if a.shape[1] != 2:
        vector = ca.mtimes(a.T, vector)
        vector /= ca.norm_2(vector)
    lead = ca.SX(0)
    for entry in ca.vertsplit(vector):
        lead = ca.if_else(ca.fabs(entry) > ca.fabs(lead), entry, lead)
    return ca.if_else(lead < 0, -vector, vector)
