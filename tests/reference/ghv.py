"""Attitude plant of the Generic Hypersonic Vehicle, by hand: aerodynamic coefficient data in, F, G and H out."""

from pathlib import Path

import numpy as np
import yaml

from real import cos, exact, is_exact, sin, tan

DATA = Path(__file__).parents[2] / "specs/models/ghv_aerodynamics.yaml"
PARTS = {group: data["parts"] for group, data in yaml.safe_load(DATA.read_text())["polynomials"].items()}
DEG = np.pi / 180
MASS, S_REF, C_BAR, B_REF = 136820.0, 334.73, 24.384, 18.288
IXX, IYY, IZZ = 1355818.0, 13558180.0, 13558180.0
SPEED, GAMMA, THRUST, RHO, SOUND, GRAVITY = 3000.0, 0.0, 0.0, 0.0645098327, 296.3769947, 9.739121
SURFACES = ("LE", "RE", "RUD")


class Aerodynamics:
    """The polynomials at a Mach number, that of the flight condition if none is given, and zero deflection: one list of coefficients
    of alpha each."""

    def __init__(self, mach=None):
        self.mach = mach
        self.reduced = {}

    def value(self, group, part, alpha_deg):
        """The polynomial at zero deflection."""
        return self._at(group, part, 0, alpha_deg)

    def slope(self, group, part, alpha_deg):
        """Its slope per degree of deflection, at zero deflection."""
        return self._at(group, part, 1, alpha_deg)

    def _at(self, group, part, deflection_power, alpha_deg):
        if part not in PARTS[group]:
            return 0 * alpha_deg
        key = group, part, deflection_power, is_exact(alpha_deg)
        if key not in self.reduced:
            self.reduced[key] = self._reduce(*key)
        total = 0 * alpha_deg
        for coefficient in reversed(self.reduced[key]):
            total = total * alpha_deg + coefficient
        return total

    def _reduce(self, group, part, deflection_power, in_mp):
        number = exact if in_mp else float
        mach = number(SPEED) / number(SOUND) if self.mach is None else self.mach
        coefficients = [number(0)] * 8
        for c, a, b, d in PARTS[group][part]:
            if d == deflection_power:
                coefficients[a] += number(c) * mach**b
        return coefficients


AERO = Aerodynamics()


def loads(x, p, x_cg, aero=AERO, speed=SPEED, rho=RHO):
    """Lift, drag, side force and the moments about the centre of mass, control surfaces at zero."""
    alpha, beta = x[0][0], x[0][1]
    rate_p, rate_q, rate_r = x[1] if len(x) > 1 else (0.0, 0.0, 0.0)
    deg = alpha / DEG
    qS = rho * speed**2 / 2 * S_REF
    part = lambda group, name: aero.value(group, name, deg)
    increments = lambda group: part(group, "LE") + part(group, "RE") + part(group, "RUD")
    p_hat, q_hat, r_hat = (rate * ref / (2 * speed) for rate, ref in ((rate_p, B_REF), (rate_q, C_BAR), (rate_r, B_REF)))
    lift = qS * p["CL_scale"] * (part("CL", "alpha") + increments("CL"))
    drag = qS * p["CD_scale"] * (part("CD", "alpha") + increments("CD"))
    side = qS * p["CY_scale"] * (part("CY", "beta") * beta + increments("CY"))
    roll = part("Cl", "beta") * beta + increments("Cl") + part("Cl", "p") * p_hat + part("Cl", "r") * r_hat
    pitch = part("Cm", "alpha") + increments("Cm") + part("Cm", "q") * q_hat
    yaw = part("Cn", "beta") * beta + increments("Cn") + part("Cn", "p") * p_hat + part("Cn", "r") * r_hat
    l0 = qS * B_REF * p["Cl_scale"] * roll
    m0 = qS * C_BAR * p["Cm_scale"] * pitch + x_cg * (drag * sin(alpha) + lift * cos(alpha))
    n0 = qS * B_REF * p["Cn_scale"] * yaw + x_cg * side
    return lift, drag, side, l0, m0, n0


def attitude_drift(x, p, x_cg):
    """F_1."""
    alpha, beta, mu = x[0]
    lift, _, side, *_ = loads(x[:1], p, x_cg)
    mV, weight = MASS * SPEED, MASS * GRAVITY * np.cos(GAMMA)
    tan_gamma = np.tan(GAMMA)
    f_alpha = (-lift - THRUST * sin(alpha) + weight * cos(mu)) / (mV * cos(beta))
    f_beta = (side - THRUST * cos(alpha) * sin(beta) + weight * sin(mu)) / mV
    f_mu = lift * (tan(beta) + tan_gamma * sin(mu)) + side * tan_gamma * cos(mu) - weight * cos(mu) * tan(beta)
    f_mu = f_mu + THRUST * (sin(alpha) * (tan(beta) + tan_gamma * sin(mu)) - cos(alpha) * sin(beta) * tan_gamma * cos(mu))
    return np.array([f_alpha, f_beta, f_mu / mV])


def attitude_gain(x, p):
    """G_1."""
    alpha, beta, _ = x[0]
    ca, sa, cb, tb = cos(alpha), sin(alpha), cos(beta), tan(beta)
    return np.array([[-tb * ca, 1 + 0 * ca, -tb * sa], [sa, 0 * ca, -ca], [ca / cb, 0 * ca, sa / cb]])


def rates_drift(x, p, x_cg):
    """F_2."""
    rate_p, rate_q, rate_r = x[1]
    *_, l0, m0, n0 = loads(x, p, x_cg)
    return np.array(
        [
            ((IYY - IZZ) * rate_q * rate_r + l0) / IXX,
            ((IZZ - IXX) * rate_p * rate_r + m0) / IYY,
            ((IXX - IYY) * rate_p * rate_q + n0) / IZZ,
        ]
    )


def moment_effectiveness(x, p, x_cg):
    """G_delta: moments per degree of left elevon, right elevon and rudder."""
    alpha = x[0][0]
    deg = alpha / DEG
    qS = RHO * SPEED**2 / 2 * S_REF
    columns = []
    for surface in SURFACES:
        d = {group: p[f"{group}_scale"] * AERO.slope(group, surface, deg) for group in ("CL", "CD", "CY", "Cl", "Cm", "Cn")}
        pitch = C_BAR * d["Cm"] + x_cg * (d["CD"] * sin(alpha) + d["CL"] * cos(alpha))
        columns.append([qS * B_REF * d["Cl"], qS * pitch, qS * (B_REF * d["Cn"] + x_cg * d["CY"])])
    return np.array(columns).T


def noise_effectiveness(x, p, x_cg):
    """H = J^-1 G_delta."""
    return moment_effectiveness(x, p, x_cg) / np.array([[IXX], [IYY], [IZZ]])
