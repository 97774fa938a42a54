//! Every fault with its place, its message and its remedy.

use super::*;

/// The faults of each expression in `texts`, one expression a line.
fn faults(texts: &str) -> String {
    let one = |text: &str| {
        let found = meaning(text).err().unwrap_or_else(|| "accepted".to_owned());
        format!("{text}\n    {}\n", found.replace('\n', "\n    "))
    };
    texts
        .lines()
        .map(str::trim)
        .filter(|text| !text.is_empty())
        .map(one)
        .collect()
}

#[test]
fn characters_and_numbers() {
    insta::assert_snapshot!(faults(
        r"
        a # b ? c
        a ** b
        a && b
        a = b
        a; b
        1_000
        1.2.3
        5.
        1e400
        1e-400
        1e308 km
        "
    ));
    let degrees = meaning("3 \u{b0}").err();
    assert_eq!(
        degrees.as_deref(),
        Some("E0201 2..4 unexpected `\u{b0}` | write `deg`")
    );
}

#[test]
fn grammar() {
    insta::assert_snapshot!(faults(
        r"
        1 +
        +1
        )
        ()
        []
        sin()
        a, b
        (1, 2)
        sin(x
        [1, 2
        [1, 2)
        2 (x)
        2  m
        alpha x
        a not b
        (a)(b)
        1 < n < 3
        v[0]
        v[n]
        v[1.5]
        v[1, 2
        partial(CL.alpha)
        partial(2, x)
        partial(CL.alpha, mach)
        partial(CL.alpha, 2 m, x)
        "
    ));
    assert!(
        meaning("").is_err_and(
            |fault| fault.starts_with("E0203 0..0 found the end, expected an expression")
        )
    );
}

#[test]
fn names() {
    insta::assert_snapshot!(faults(
        r"
        alpah + 1
        zork
        ms
        2*x/ms
        sni(alpha)
        zork(alpha)
        cl.alpha(1, 2)
        alpha(1)
        t(1)
        sin
        partial
        CL.alpha
        later + 1
        later(1)
        sin(1, 2)
        max(1, 2, 3)
        if(1, 2)
        CL.alpha(1)
        partial(CL.alpha, mahc, 1, 2)
        partial(CL.alpha, zork, 1)
        partial(sin, alpha, 1)
        "
    ));
}

#[test]
fn units() {
    insta::assert_snapshot!(faults(
        r"
        3 furlong
        2 alpha
        5 Nm
        2 m/s + 3 sec
        x + v
        x + 1
        1 + x
        x - 2 s
        x < v
        x == 1
        if(n > 0, x, v)
        min(x, v)
        atan2(x, v)
        sin(x)
        exp(-t)
        sin(omega)
        CL.alpha(x, omega)
        x^0.5
        x^n
        2^x
        x^100
        sqrt(sqrt(x))
        x/0
        0^-1
        1/[1, 0]
        norm(mixed)
        dot(mixed, mixed)
        [[1, 0], [0, 1]]*mixed + pair
        [[1, 1], [0, 1]]*mixed
        inverse([[1 kg, 1 kg*m], [1 kg, 1 kg*m^2]])
        inverse([[1 kg, 0, 1 kg], [0, 1 kg, 1 kg*m], [1 kg*m, 1 kg*m, 1 kg*m^2]])
        inverse([[1 kg, 1 kg, 1 kg*m], [1 kg, 1 kg, 1 kg*m], [1 kg*m, 1 kg*m, 1 kg*m]])
        inverse([[1 kg, 1 kg, 1 kg], [1 kg, 1 kg, 1 kg*m], [1 kg, 1 kg*m, 1 kg*m^2]])
        inverse([[1 kg, 1 m, 1 s], [1 kg, 1 kg, 1 kg*m], [1 kg, 1 kg*m, 1 kg*m^2]])
        solve(pair, [[1, 0], [0, 1]])
        solve([[1 kg, 1 kg*m], [1 kg*m, 1 kg*m^2]], [1 N, 2 N])
        solve([[1 m, 0], [0, 1 s]], [1, 2])/[1 1/s, 1 1/s]
        inverse(inertia) + inertia
        x + t*2 m*g
        "
    ));
}

#[test]
fn shapes() {
    insta::assert_snapshot!(faults(
        r"
        omega + pair
        omega*pair
        omega*inertia
        inertia*pair
        inertia + omega
        omega < 1
        omega^2
        inertia^-1
        2^omega
        omega[4]
        inertia[1]
        inertia[1, 4]
        omega[1, 2]
        x[1]
        [1, omega]
        [omega, pair]
        [inertia, inertia]
        dot(omega, pair)
        cross(pair, pair)
        norm(x)
        norm(inertia)
        transpose(x)
        inverse(x)
        inverse([[1, 2, 3], [4, 5, 6]])
        solve(inertia, pair)
        solve(inertia, 1)
        solve(omega, omega)
        inverse(each(i, 1, 17, each(j, 1, 17, i + j)))
        solve(inertia)
        solve(inertia, 1, 2, 3)
        inverse(inertia, omega)
        omega/inertia
        1/[[1, 0], [0, 1]]
        if(n > 0, omega, pair)
        if(n, 1, 2)
        n and n > 0
        not n
        -(n > 0)
        (n > 0) + 1
        [n > 0, 1]
        if(n > 0, n > 1, n > 2)
        sin(n > 0)
        "
    ));
}

#[test]
fn independent_faults_are_reported_together_and_once() {
    insta::assert_snapshot!(faults(
        r"
        zork + sin(x) + omega[9] + x^n
        sqrt(zork)*sin(zork) + [zork, 1][1]
        broken + 1
        broken + zork
        broken(1)
        if(n, x + 1, v + 1)
        CL.alpha(x + v, zork)
        "
    ));
}

#[test]
fn a_wrong_kind_of_value_is_refused_at_its_place() {
    let check = |text: &str, shape, units: &[&str]| {
        let (arena, id) = meaning(text).unwrap();
        let dimensions: Vec<_> = units.iter().map(|unit| dimension(unit)).collect();
        let expected = Expected {
            what: "drift of block `rates`",
            shape,
            dimensions: &dimensions,
            reasons: &[],
            columns: &[],
        };
        match expect(&arena, id, base(text).span, &[], &expected) {
            Ok(()) => "accepted".to_owned(),
            Err(faults) => shown(&faults),
        }
    };
    let found = [
        check("omega", THREE, &["1/s"]),
        check("[0, 1 rad/s, 0]", THREE, &["1/s"]),
        check("0", Shape::Scalar, &["kg"]),
        check("mixed", Shape::Vector(2), &["m", "s"]),
        check("mixed", Shape::Vector(2), &["s", "m"]),
        check("1", Shape::Scalar, &["m"]),
        check("x", Shape::Scalar, &["1"]),
        check("pair", THREE, &["m"]),
        check("x", Shape::Matrix(2, 2), &["m"]),
        check("pair", Shape::Scalar, &["m"]),
        check("x > 0", Shape::Scalar, &["m"]),
    ];
    insta::assert_snapshot!(found.join("\n"));
}

#[test]
fn functions_of_the_language() {
    insta::assert_snapshot!(faults(
        r"
        clamp(x, 0, 1 s)
        clamp(x, 0)
        smooth_step(t, 1 m, 2 m)
        skew(2)
        skew([1, 2])
        rot_x(x)
        sum(2)
        sum([1 m, 1 s])
        largest(2)
        diag(2)
        atmosphere.density(2 s)
        atmosphere.density([1 m, 2 m])
        atmosphere.densty(2 m)
        atmosphere.density
        g0 + 1
        earth.mus
        norm_1(2)
        "
    ));
}

#[test]
fn loops() {
    insta::assert_snapshot!(faults(
        r"
        each(i, 1, 3)
        each(1, 1, 3, 2)
        each(i, 0, 3, 2)
        each(i, n, 3, 2)
        each(i, 3, 1, 2)
        each(i, 1, 65, 2)
        each(n, 1, 3, 2)
        each(sin, 1, 3, 2)
        each(i, 1, 4, omega[i])
        each(i, 1, 2, omega[i - 1])
        each(i, 1, 2, mass + x)
        each(i, 1, 2, nn)
        each(i, 1, 2, i > 1)
        each(i, 1, 2, [[i]])
        each(i, 1, 2, sin(x)) + each(i, 1, 2, i)[i]
        omega[i]
        i
        "
    ));
}
