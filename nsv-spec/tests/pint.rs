//! Units and conversions against pint, an independent library: `tests/reference/units.py` writes what pint computes with exact fractions, each
//! figure the double nearest to it, and every bit must be the same here.

use nsv_spec::unit::parse_unit;
use serde::Deserialize;

/// Unit, twice the exponents of kg, m, s, A, K, mol, cd, SI value of one of it, a number in decimal digits, its SI value in the unit.
#[derive(Deserialize)]
struct Entry(String, [i8; 7], f64, String, f64);

#[test]
fn every_conversion_is_the_nearest_double_to_what_pint_computes_exactly() {
    let entries: Vec<Entry> =
        serde_json::from_str(include_str!("../../tests/reference/units.json")).unwrap();
    assert!(entries.len() >= 3000);
    for Entry(text, halves, scale, digits, value) in entries {
        let unit = parse_unit(&text).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        assert_eq!(
            (unit.dimension.halves, unit.scale),
            (halves, scale),
            "{text}"
        );
        assert_eq!(unit.si(&digits), Some(value), "{digits} {text}");
    }
}
