"""The smooth step of the language, s^2 (3 - 2 s) with s = (x - a)/(b - a) held between 0 and 1, and paths made of such steps."""


def smooth_step(x, a, b):
    """From 0 at a to 1 at b."""
    s = min(max((x - a) / (b - a), 0), 1)
    return s * s * (3 - 2 * s)


def smooth_step_slope(x, a, b):
    """Its derivative by x."""
    s = min(max((x - a) / (b - a), 0), 1)
    return 6 * s * (1 - s) / (b - a)


def path(start, *steps):
    """start + size smooth_step(t, a, b) + .. for each (size, a, b), and its rate, as functions of time."""
    return (
        lambda t: start + sum(size * smooth_step(t, a, b) for size, a, b in steps),
        lambda t: 0 * t + sum(size * smooth_step_slope(t, a, b) for size, a, b in steps),
    )
