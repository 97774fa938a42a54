use super::*;

fn check(text: &str, dimension: &str, scale: f64) {
    let unit = parse_unit(text).unwrap();
    assert_eq!(
        (unit.dimension.to_string().as_str(), unit.scale),
        (dimension, scale),
        "{text}"
    );
    assert_eq!(unit.text, text.trim());
}

#[test]
fn units_have_their_dimension_and_size() {
    check("1", "1", 1.0);
    check("kg", "kg", 1.0);
    check("g", "kg", 1e-3);
    check("t", "kg", 1e3);
    check(" kN*m ", "kg*m^2/s^2", 1e3);
    check("m/s", "m/s", 1.0);
    check("km/h", "m/s", 1.0 / 3.6);
    check("kg/m/s^2", "kg/(m*s^2)", 1.0);
    check("kg/(m*s^2)", "kg/(m*s^2)", 1.0);
    check("1/s", "1/s", 1.0);
    check("s^-1", "1/s", 1.0);
    check("(1/s)", "1/s", 1.0);
    check("1/s^2", "1/s^2", 1.0);
    check("deg", "1", std::f64::consts::PI / 180.0);
    check("rad", "1", 1.0);
    check("rpm", "1/s", 0.10471975511965978);
    check("rev/min", "1/s", 0.10471975511965978);
    check("Hz", "1/s", 1.0);
    check("min", "s", 60.0);
    check("ft", "m", 0.3048);
    check("in", "m", 0.0254);
    check("lb", "kg", 0.45359237);
    check("lbf", "kg*m/s^2", 4.4482216152605);
    check("slug", "kg", 14.593902937206364);
    check("slug*ft^2", "kg*m^2", 1.3558179483314004);
    check("psi", "kg/(m*s^2)", 6894.757293168362);
    check("kn", "m/s", 1852.0 / 3600.0);
    check("mV", "kg*m^2/(s^3*A)", 1e-3);
    check("uF", "s^4*A^2/(kg*m^2)", 1e-6);
    check("kohm", "kg*m^2/(s^3*A^2)", 1e3);
    check("mH", "kg*m^2/(s^2*A^2)", 1e-3);
    check("hPa", "kg/(m*s^2)", 100.0);
    check("dam", "m", 10.0);
    check("rad/sqrt(s)", "1/sqrt(s)", 1.0);
    check(
        "deg/sqrt(h)",
        "1/sqrt(s)",
        std::f64::consts::PI / 180.0 / 60.0,
    );
    check("m/s^2/sqrt(Hz)", "m/sqrt(s^3)", 1.0);
}

#[test]
fn literals_are_rounded_once() {
    let si = |digits: &str, unit: &str| parse_unit(unit).unwrap().si(digits).unwrap();
    assert_eq!(si("2.54", "cm"), 0.0254);
    assert_eq!(si("3.3", "mm"), 0.0033);
    assert_eq!(si("1.1", "ft"), 0.33528);
    assert_eq!(si("20000", "kN*m"), 2e7);
    assert_eq!(si("180", "deg"), std::f64::consts::PI);
    assert_eq!(
        si("12345678901234567890123", "m"),
        12345678901234567890123.0
    );
    assert_eq!(parse_unit("km").unwrap().si("1e308"), None);
    for thousandths in 0..100_000 {
        let digits = format!("{}.{:03}", thousandths / 1000, thousandths % 1000);
        let metres: f64 = format!("{digits}e-3").parse().unwrap();
        assert_eq!(si(&digits, "mm"), metres);
    }
}

#[test]
fn every_dimension_that_prints_is_read_back() {
    for name in table::names() {
        let unit = parse_unit(name).unwrap();
        assert_eq!(
            parse_unit(&unit.dimension.to_string()).unwrap().dimension,
            unit.dimension,
            "{name}"
        );
        let root = parse_unit(&format!("sqrt({name})^3")).unwrap();
        assert_eq!(
            parse_unit(&root.dimension.to_string()).unwrap().dimension,
            root.dimension,
            "{name}"
        );
    }
}

fn fault(text: &str) -> String {
    let error = parse_unit(text).unwrap_err();
    let base = crate::diagnostic::Base::exact(crate::diagnostic::FileId(0), 0, text.len());
    let diagnostic = error.diagnostic(&base);
    let span = diagnostic.span.unwrap();
    format!(
        "{} {}..{} {}; {}",
        diagnostic.rule,
        span.start,
        span.end,
        diagnostic.message,
        diagnostic.help.unwrap()
    )
}

#[test]
fn faulty_units_are_explained() {
    let generic = "units are SI symbols with their prefixes, joined by `*`, `/` and `^`";
    let shape = "write units like `kN*m`, `rad/s`, `1/s` or `m/s^2`";
    assert_eq!(
        fault("kg*furlong"),
        format!("E0401 3..10 unknown unit `furlong`; {generic}")
    );
    assert_eq!(
        fault("Nm"),
        "E0401 0..2 unknown unit `Nm`; did you mean `N*m`?"
    );
    assert_eq!(
        fault("m2"),
        "E0401 0..2 unknown unit `m2`; did you mean `m^2`?"
    );
    assert_eq!(
        fault("degrees/s"),
        "E0401 0..7 unknown unit `degrees`; did you mean `deg`?"
    );
    assert_eq!(
        fault("KG"),
        "E0401 0..2 unknown unit `KG`; did you mean `kg`?"
    );
    assert_eq!(
        fault(""),
        format!("E0402 0..0 malformed unit: found the end, expected a unit; {shape}")
    );
    assert_eq!(fault(" \t "), fault(""));
    assert_eq!(
        fault("m s"),
        format!("E0402 1..2 malformed unit: found ` `, expected `*`, `/` or `^`; {shape}")
    );
    assert_eq!(
        fault("(m"),
        format!("E0402 2..2 malformed unit: found the end, expected `)`; {shape}")
    );
    assert_eq!(
        fault("m^0.5"),
        format!(
            "E0402 3..4 malformed unit: found `.`, expected a whole exponent (and `sqrt(..)` for halves); {shape}"
        )
    );
    assert!(fault("m^64").starts_with("E0402 0..4 unit with a factor or an exponent out of range"));
    assert!(fault("m^99999999999").starts_with("E0402"));
    assert!(fault("Ym^60").starts_with("E0402"));
    assert!(fault("sqrt(sqrt(m))").starts_with("E0402"));
    assert!(fault(&"(".repeat(100_000)).starts_with("E0402"));
    assert!(fault(&"x".repeat(100_000)).starts_with("E0401"));
}

/// Checks how much of the text after a number is its unit.
fn scanned(text: &str) -> &str {
    let length = scan(text).unwrap().map_or(0, |(_, length)| length);
    &text[..length]
}

#[test]
fn the_unit_of_a_literal_ends_where_the_expression_goes_on() {
    assert_eq!(scanned("m/s, 4 deg"), "m/s");
    assert_eq!(scanned("m * g"), "m");
    assert_eq!(scanned("m*g"), "m*g");
    assert_eq!(scanned("rad/s*exp(-t/(1 s))"), "rad/s");
    assert_eq!(scanned("m/s*t"), "m/s");
    assert_eq!(scanned("t"), "t");
    assert_eq!(scanned("m/(1 s)"), "m");
    assert_eq!(scanned("kg/(m*s)"), "kg/(m*s)");
    assert_eq!(scanned("kg/(m*t)"), "kg");
    assert_eq!(scanned("s*min(a, b)"), "s");
    assert_eq!(scanned("m*g[1]"), "m");
    assert_eq!(scanned("m^2*x"), "m^2");
    assert_eq!(scanned("m^x"), "m");
    assert_eq!(scanned("m*2"), "m");
    assert_eq!(scanned("1/s*x"), "1/s");
    assert_eq!(scanned("1/x"), "");
    assert_eq!(scanned("sin(x)"), "");
    assert_eq!(scanned("sqrt(Hz)"), "sqrt(Hz)");
    assert_eq!(scanned("sqrt(x)"), "");
    assert_eq!(scanned("m/sqrt(s)"), "m/sqrt(s)");
    assert_eq!(scanned("CL.alpha(x)"), "");
    assert!(scan("furlong").is_err());
}
