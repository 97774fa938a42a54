//! The simple units: their names, dimensions and exact factors to SI.

use super::dimension::Dimension;
use super::double::Double;
use crate::suggest::{Meant, nearest};

/// A simple unit of size `numerator / denominator` SI units, times pi for angles.
struct Entry {
    name: &'static str,
    prefixed: bool,
    dimension: Dimension,
    numerator: u64,
    denominator: u64,
    pi: bool,
}

/// A coherent SI unit, which takes prefixes.
const fn si(name: &'static str, dimension: Dimension) -> Entry {
    prefixed(name, dimension, 1, 1)
}

/// A unit of `numerator / denominator` SI units, which takes prefixes.
const fn prefixed(
    name: &'static str,
    dimension: Dimension,
    numerator: u64,
    denominator: u64,
) -> Entry {
    Entry {
        name,
        prefixed: true,
        dimension,
        numerator,
        denominator,
        pi: false,
    }
}

/// A unit of `numerator / denominator` SI units, which takes no prefix.
const fn of(name: &'static str, dimension: Dimension, numerator: u64, denominator: u64) -> Entry {
    Entry {
        name,
        prefixed: false,
        dimension,
        numerator,
        denominator,
        pi: false,
    }
}

/// An angle or a rate of turn of `numerator / denominator` pi.
const fn turn(name: &'static str, dimension: Dimension, numerator: u64, denominator: u64) -> Entry {
    Entry {
        name,
        prefixed: false,
        dimension,
        numerator,
        denominator,
        pi: true,
    }
}

const ONE: Dimension = Dimension::ONE;
const MASS: Dimension = Dimension::new(1, 0, 0, 0);
const LENGTH: Dimension = Dimension::new(0, 1, 0, 0);
const TIME: Dimension = Dimension::new(0, 0, 1, 0);
const RATE: Dimension = Dimension::new(0, 0, -1, 0);
const SPEED: Dimension = Dimension::new(0, 1, -1, 0);
const FORCE: Dimension = Dimension::new(1, 1, -2, 0);
const PRESSURE: Dimension = Dimension::new(1, -1, -2, 0);
const ENERGY: Dimension = Dimension::new(1, 2, -2, 0);

/// lb = 0.45359237 kg and standard gravity 9.80665 m/s^2: lbf = POUND_FORCE / 10^13 N.
const POUND: u64 = 45_359_237;
const POUND_FORCE: u64 = POUND * 980_665;

const TABLE: &[Entry] = &[
    // SI base units; the kilogram comes without its prefix.
    of("kg", MASS, 1, 1),
    prefixed("g", MASS, 1, 1000),
    si("m", LENGTH),
    si("s", TIME),
    si("A", Dimension::new(0, 0, 0, 1)),
    si("K", Dimension::base(4)),
    si("mol", Dimension::base(5)),
    si("cd", Dimension::base(6)),
    // SI derived units
    si("rad", ONE),
    of("sr", ONE, 1, 1),
    si("Hz", RATE),
    si("N", FORCE),
    si("Pa", PRESSURE),
    si("J", ENERGY),
    si("W", Dimension::new(1, 2, -3, 0)),
    si("C", Dimension::new(0, 0, 1, 1)),
    si("V", Dimension::new(1, 2, -3, -1)),
    si("F", Dimension::new(-1, -2, 4, 2)),
    si("ohm", Dimension::new(1, 2, -3, -2)),
    si("S", Dimension::new(-1, -2, 3, 2)),
    si("Wb", Dimension::new(1, 2, -2, -1)),
    si("T", Dimension::new(1, 0, -2, -1)),
    si("H", Dimension::new(1, 2, -2, -2)),
    // Angles and rates of turn
    turn("deg", ONE, 1, 180),
    turn("arcmin", ONE, 1, 10_800),
    turn("arcsec", ONE, 1, 648_000),
    turn("rev", ONE, 2, 1),
    turn("rpm", RATE, 2, 60),
    // Accepted beside SI
    of("min", TIME, 60, 1),
    of("h", TIME, 3600, 1),
    of("day", TIME, 86_400, 1),
    of("t", MASS, 1000, 1),
    prefixed("L", Dimension::new(0, 3, 0, 0), 1, 1000),
    prefixed("bar", PRESSURE, 100_000, 1),
    of("atm", PRESSURE, 101_325, 1),
    // Imperial and US units, and those of navigation
    of("in", LENGTH, 254, 10_000),
    of("ft", LENGTH, 3048, 10_000),
    of("mi", LENGTH, 1_609_344, 1000),
    of("nmi", LENGTH, 1852, 1),
    of("kn", SPEED, 1852, 3600),
    of("lb", MASS, POUND, 100_000_000),
    of("slug", MASS, POUND_FORCE * 10_000, 30_480_000_000_000_000),
    of("lbf", FORCE, POUND_FORCE, 10_000_000_000_000),
    of("psi", PRESSURE, POUND_FORCE, 100_000 * 64_516),
];

impl Entry {
    fn size(&self) -> Double {
        let ratio = Double::integer(self.numerator).div(Double::integer(self.denominator));
        if self.pi {
            ratio.mul(Double::PI)
        } else {
            ratio
        }
    }
}

/// Decimal prefixes; no unit name is ambiguous, since whole names are looked up first.
const PREFIXES: &[(&str, i32)] = &[
    ("da", 1),
    ("Y", 24),
    ("Z", 21),
    ("E", 18),
    ("P", 15),
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
    ("a", -18),
    ("z", -21),
    ("y", -24),
];

/// What people write for units that have another symbol here.
const SPOKEN: &[(&str, &str)] = &[
    ("degree", "deg"),
    ("degrees", "deg"),
    ("degs", "deg/s"),
    ("dps", "deg/s"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("rads", "rad/s"),
    ("sec", "s"),
    ("secs", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("minute", "min"),
    ("minutes", "min"),
    ("hr", "h"),
    ("hour", "h"),
    ("hours", "h"),
    ("meter", "m"),
    ("meters", "m"),
    ("metre", "m"),
    ("metres", "m"),
    ("kilogram", "kg"),
    ("newton", "N"),
    ("volt", "V"),
    ("volts", "V"),
    ("amp", "A"),
    ("amps", "A"),
    ("henry", "H"),
    ("farad", "F"),
    ("Ohm", "ohm"),
    ("Ohms", "ohm"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("knot", "kn"),
    ("knots", "kn"),
    ("kt", "kn"),
    ("kph", "km/h"),
    ("kmh", "km/h"),
    ("mph", "mi/h"),
    ("mps", "m/s"),
    ("tonne", "t"),
    ("ton", "t"),
];

/// Dimension and size of a simple unit.
pub(super) fn find(name: &str) -> Option<(Dimension, Double)> {
    if let Some(entry) = TABLE.iter().find(|entry| entry.name == name) {
        return Some((entry.dimension, entry.size()));
    }
    let with_prefix = |(prefix, exponent): &(&str, i32)| {
        let unit = name.strip_prefix(prefix)?;
        let entry = TABLE
            .iter()
            .find(|entry| entry.prefixed && entry.name == unit)?;
        Some((entry.dimension, entry.size().mul(Double::ten(*exponent))))
    };
    PREFIXES.iter().find_map(with_prefix)
}

/// What was probably meant by a name that is no unit.
pub(super) fn suggest(name: &str) -> Option<Meant> {
    let meant = |name: String, sure| Some(Meant { name, sure });
    if let Some((_, symbol)) = SPOKEN.iter().find(|(spoken, _)| *spoken == name) {
        // Degrees in the plural, or degrees per second?
        let plural = name.ends_with('s') && symbol.ends_with("/s");
        return meant((*symbol).to_owned(), !plural);
    }
    let is_whole = |part: &str| TABLE.iter().any(|entry| entry.name == part);
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() < name.len() && find(letters).is_some() {
        // `m2` is m^2, but `ms2` may be m/s^2.
        let power = format!("{letters}^{}", &name[letters.len()..]);
        return meant(power, is_whole(letters));
    }
    // Nobody means kelvin times newton.
    let kilo = name.strip_prefix('K').map(|unit| format!("k{unit}"));
    if let Some(kilo) = kilo.filter(|kilo| find(kilo).is_some()) {
        return meant(kilo, true);
    }
    // `Nm` before `nm`: a product without its `*` is likelier than a slip. Only `N*m` can be meant by it, but `Nms` has three parts,
    // and an `s` at the end may be a plural or stand under a stroke.
    let halves: Vec<(&str, &str)> = (1..name.len())
        .filter_map(|middle| name.split_at_checked(middle))
        .filter(|(left, right)| find(left).is_some() && find(right).is_some())
        .collect();
    if let Some((left, right)) = halves.first() {
        return meant(
            format!("{left}*{right}"),
            halves.len() == 1 && is_whole(right) && *right != "s",
        );
    }
    if let [only] = in_other_case(name).as_slice() {
        return meant(only.clone(), true);
    }
    if let Some(slip) = nearest(name, SPOKEN.iter().map(|(spoken, _)| *spoken)) {
        let symbol = SPOKEN.iter().find(|(spoken, _)| *spoken == slip.name);
        return symbol.and_then(|(_, symbol)| meant((*symbol).to_owned(), false));
    }
    let likely = nearest(name, TABLE.iter().map(|entry| entry.name).chain(COMMON))?;
    meant(likely.name, false)
}

/// Units with a prefix that people do write.
const COMMON: [&str; 18] = [
    "ms", "us", "mm", "cm", "km", "mrad", "urad", "kHz", "MHz", "kN", "MN", "kPa", "MPa", "kW",
    "MW", "mA", "mV", "kJ",
];

/// The units that differ from a name in capital letters only.
fn in_other_case(name: &str) -> Vec<String> {
    let plain = TABLE.iter().map(|entry| entry.name.to_owned());
    let prefixed = PREFIXES.iter().flat_map(|(prefix, _)| {
        let entries = TABLE.iter().filter(|entry| entry.prefixed);
        entries.map(move |entry| format!("{prefix}{}", entry.name))
    });
    plain
        .chain(prefixed)
        .filter(|unit| unit.eq_ignore_ascii_case(name))
        .collect()
}

/// Prefixes with their powers of ten, the largest first.
pub(super) fn prefixes() -> Vec<(&'static str, i32)> {
    let mut prefixes = PREFIXES.to_vec();
    prefixes.sort_by_key(|(_, exponent)| -exponent);
    prefixes
}

/// Every unit in order: name, whether it takes prefixes, dimension, SI value of one.
pub(super) fn units() -> impl Iterator<Item = (&'static str, bool, Dimension, f64)> {
    TABLE.iter().map(|entry| {
        (
            entry.name,
            entry.prefixed,
            entry.dimension,
            entry.size().high,
        )
    })
}

/// Every name in the table, for tests.
#[cfg(test)]
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|entry| entry.name)
}
