"""Random units and quantities as pint converts them, for nsv-spec/tests/pint.rs.

    pip install pint==0.24.4 && python3 tests/reference/units.py > tests/reference/units.json

pint computes with exact fractions here, pi to 50 digits; a square root is taken of the exact fraction to 60 digits. Each figure is
the double nearest to that, so nsv must agree in every bit.
"""
import json
import random
from decimal import Decimal, getcontext
from fractions import Fraction

import pint

COUNT = 3000
getcontext().prec = 60

# nsv's symbols by pint's names; those with True take prefixes.
UNITS = {
    "kg": ("kilogram", False), "g": ("gram", True), "m": ("meter", True), "s": ("second", True), "A": ("ampere", True),
    "K": ("kelvin", True), "mol": ("mole", True), "cd": ("candela", True), "rad": ("radian", True), "sr": ("steradian", False),
    "Hz": ("hertz", True), "N": ("newton", True), "Pa": ("pascal", True), "J": ("joule", True), "W": ("watt", True),
    "C": ("coulomb", True), "V": ("volt", True), "F": ("farad", True), "ohm": ("ohm", True), "S": ("siemens", True),
    "Wb": ("weber", True), "T": ("tesla", True), "H": ("henry", True), "deg": ("degree", False), "arcmin": ("arcminute", False),
    "arcsec": ("arcsecond", False), "rev": ("turn", False), "rpm": ("turn / minute", False), "min": ("minute", False),
    "h": ("hour", False), "day": ("day", False), "t": ("metric_ton", False), "L": ("liter", True), "bar": ("bar", True),
    "atm": ("standard_atmosphere", False), "in": ("inch", False), "ft": ("foot", False), "mi": ("mile", False),
    "nmi": ("nautical_mile", False), "kn": ("knot", False), "lb": ("pound", False), "slug": ("slug", False),
    "lbf": ("force_pound", False), "psi": ("force_pound / inch ** 2", False),
}
PREFIXES = {
    "da": "deca", "Y": "yotta", "Z": "zetta", "E": "exa", "P": "peta", "T": "tera", "G": "giga", "M": "mega", "k": "kilo",
    "h": "hecto", "d": "deci", "c": "centi", "m": "milli", "u": "micro", "n": "nano", "p": "pico", "f": "femto", "a": "atto",
    "z": "zepto", "y": "yocto",
}
BASE = ["kilogram", "meter", "second", "ampere", "kelvin", "mole", "candela"]
REGISTRY = pint.UnitRegistry(non_int_type=Fraction)


def simple(draw):
    """A symbol of nsv and pint's expression for it. Prefixed names that are units of their own (min, Pa, cd, ..) mean the unit."""
    while True:
        symbol = draw.choice(list(UNITS))
        name, prefixed = UNITS[symbol]
        if not prefixed or draw.random() < 0.5:
            return symbol, f"({name})"
        prefix = draw.choice(list(PREFIXES))
        if prefix + symbol not in UNITS and is_unique(prefix + symbol):
            return prefix + symbol, f"({PREFIXES[prefix]}{name})"


def is_unique(symbol):
    """Whether only one prefix and unit make the symbol."""
    ways = [p for p in PREFIXES if symbol.startswith(p) and UNITS.get(symbol[len(p):], ("", False))[1]]
    return len(ways) == 1


def compound(draw, factors):
    ours, theirs = "", ""
    for at in range(factors):
        symbol, name = simple(draw)
        exponent = draw.choice([1, 1, 1, 2, 3, -1, -2])
        operator = "" if at == 0 else draw.choice("*/")
        ours += operator + symbol + ("" if exponent == 1 else f"^{exponent}")
        theirs += operator + f"{name}**({exponent})"
    return ours, theirs


def convert(theirs):
    quantity = REGISTRY.Quantity(Fraction(1), REGISTRY.parse_expression(theirs).units).to_base_units()
    scale = Fraction(quantity.magnitude)
    powers = {name: Fraction(power) for name, power in quantity._units.items() if name != "radian"}
    assert set(powers) <= set(BASE), powers
    return scale, [powers.get(name, Fraction(0)) for name in BASE]


def entry(draw):
    ours, theirs = compound(draw, draw.randint(1, 4))
    scale, powers = convert(theirs)
    digits = f"{draw.choice(['', '0.', '12.', '7'])}{draw.randint(1, 10 ** draw.randint(1, 12))}"
    if draw.random() < 0.2:
        digits += f"e{draw.randint(-9, 9)}"
    value = Fraction(Decimal(digits))
    if draw.random() < 0.25:
        ours, powers = f"sqrt({ours})", [power / 2 for power in powers]
        root = (Decimal(scale.numerator) / Decimal(scale.denominator)).sqrt()
        scale = Fraction(root)
    if not 1e-200 < scale < 1e200 or any(abs(2 * power) > 126 for power in powers):
        return None
    return [ours, [int(2 * power) for power in powers], float(scale), digits, float(value * scale)]


def main():
    draw = random.Random(20261126)
    entries = []
    for symbol, (name, _) in UNITS.items():
        scale, powers = convert(f"({name})")
        entries.append([symbol, [int(2 * power) for power in powers], float(scale), "1", float(scale)])
    while len(entries) < COUNT:
        entries.extend(filter(None, [entry(draw)]))
    print("[" + ",\n".join(json.dumps(one, separators=(",", ":")) for one in entries) + "]")


if __name__ == "__main__":
    main()
