"""U.S. Standard Atmosphere 1976 up to 86 km of geometric height, layer by layer from sea level."""

from real import exp, log, sqrt

EARTH = 6356766.0  # m, of the geopotential
GAS = 8314.32 / 28.9644  # J/(kg K)
WEIGHT = 9.80665 * 28.9644 / 8314.32  # K/m
SEA_LEVEL = 288.15, 101325.0  # K, Pa
# Top of each layer in m of geopotential height, and its gradient in K/m.
LAYERS = ((11e3, -0.0065), (20e3, 0.0), (32e3, 0.001), (47e3, 0.0028), (51e3, 0.0), (71e3, -0.0028), (85e3, -0.002))


def temperature_and_pressure(h):
    """K and Pa at the geometric height h in m, which is held between -5 and 86 km."""
    h = min(max(h, -5e3), 86e3)
    z = EARTH * h / (EARTH + h)
    (t, p), at = SEA_LEVEL, 0.0
    for top, slope in LAYERS:
        up = min(z, top) - at
        warmer = t + slope * up
        p = p * (exp(-WEIGHT * log(warmer / t) / slope) if slope else exp(-WEIGHT * up / t))
        t, at = warmer, top
        if z <= top:
            return t, p
    raise AssertionError("invariant: 86 km are below the last top")


def density(h):
    """kg/m^3."""
    t, p = temperature_and_pressure(h)
    return p / (GAS * t)


def speed_of_sound(h):
    """m/s."""
    t, _ = temperature_and_pressure(h)
    return sqrt(1.4 * GAS * t)
