//! Texts made to exhaust the stack, the memory or the patience of the reader.

use super::*;

fn code(text: &str) -> String {
    let found = meaning(text).err().unwrap_or_else(|| "accepted".to_owned());
    found.split(' ').next().unwrap().to_owned()
}

#[test]
fn nesting_stops_at_the_cap() {
    let brackets = |depth: usize| format!("{}n{}", "(".repeat(depth), ")".repeat(depth));
    assert_eq!(code(&brackets(MAX_DEPTH - 1)), "accepted");
    assert_eq!(code(&brackets(MAX_DEPTH)), "E0206");
    let signs = |depth: usize| format!("{}n", "-".repeat(depth));
    assert_eq!(code(&signs(MAX_DEPTH - 1)), "accepted");
    assert_eq!(code(&signs(MAX_DEPTH)), "E0206");
    assert_eq!(
        code(&format!("{}n", "n^".repeat(MAX_DEPTH - 1))),
        "accepted"
    );
    assert_eq!(code(&format!("{}n", "n^".repeat(MAX_DEPTH))), "E0206");
}

#[test]
fn nothing_overflows_the_stack() {
    for opening in [
        "(",
        "[",
        "-",
        "not ",
        "sin(",
        "n^",
        "1+(",
        "[[",
        "if(n > 0, ",
        "CL.alpha(",
        "partial(CL.alpha, mach, ",
        "each(i, 1, 2, ",
    ] {
        let longest = opening.repeat(MAX_TEXT / opening.len());
        assert_eq!(code(&longest), "E0206", "{opening}");
        assert_eq!(code(&opening.repeat(100_000)), "E0207", "{opening}");
    }
    assert_eq!(code(&"(".repeat(1 << 24)), "E0207");
}

#[test]
fn long_chains_are_read_typed_and_dropped() {
    for (operand, operator) in [("n", "+"), ("n", "*"), ("n", "/"), ("1", "-")] {
        let terms = MAX_NODES / 2;
        let text = vec![operand; terms].join(operator);
        assert_eq!(code(&text), "accepted");
        assert_eq!(code(&format!("{text}{operator}{operand}")), "E0207");
    }
    let comparisons = vec!["n<1"; MAX_NODES / 4].join(" or ");
    assert_eq!(code(&comparisons), "accepted");
    let indices = format!("omega{}", "[1]".repeat(MAX_NODES - 1));
    assert_eq!(code(&indices), "E0501");
}

#[test]
fn long_faulty_texts_are_reported_in_short_messages() {
    let long = "x".repeat(MAX_TEXT);
    let sums = format!("[{}1]", "x+1,".repeat(4000));
    for text in [
        sums,
        long.clone(),
        format!("2 {}", &long[2..]),
        "1".repeat(MAX_TEXT),
        "#".repeat(1000),
        "2 (".repeat(1000),
    ] {
        let found = meaning(&text).unwrap_err();
        assert!(found.len() < 10_000, "{} bytes", found.len());
    }
    let commas = "1,".repeat(10_000);
    assert_eq!(code(&format!("sin({commas}1)")), "E0305");
    assert_eq!(code(&format!("[{commas}1]")), "accepted");
}

/// Every text over a small alphabet, and random longer ones, gets an answer whose places lie in the text.
#[test]
fn every_text_has_an_answer() {
    const PIECES: [&str; 24] = [
        "n", "x", "2", " ", "(", ")", "[", "]", ",", "+", "-", "*", "/", "^", "<", "sin(", "m",
        "s", ".", "1", "not ", "omega", "e", "\u{b0}",
    ];
    let mut state = 1_u64;
    let mut random = |bound: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % bound
    };
    for _ in 0..50_000 {
        let text: String = (0..random(14))
            .map(|_| PIECES[random(PIECES.len())])
            .collect();
        match parse(&text, base(&text)) {
            Ok(expr) => {
                let mut arena = Arena::default();
                let _ = elaborate(&expr, &mut World::default(), &mut arena)
                    .map_err(|faults| assert_inside(&text, &faults));
            }
            Err(faults) => assert_inside(&text, &faults),
        }
    }
}

fn assert_inside(text: &str, faults: &[Diagnostic]) {
    assert!(!faults.is_empty(), "{text}");
    for fault in faults {
        let span = fault.span.unwrap();
        let range = span.start as usize - 1000..span.end as usize - 1000;
        assert!(text.get(range).is_some(), "{text}: {fault:?}");
        assert!(
            fault.help.is_some()
                && fault
                    .message
                    .chars()
                    .next()
                    .is_some_and(|c| !c.is_uppercase()),
            "{text}: {fault:?}"
        );
    }
}

#[test]
fn nested_loops_stop_at_a_size() {
    let loops = |depth: usize| {
        let open: String = (0..depth)
            .map(|at| format!("sum(each(i{at}, 1, 64, "))
            .collect();
        format!("{open}n{}", "))".repeat(depth))
    };
    assert_eq!(code(&loops(2)), "accepted");
    assert_eq!(code(&loops(3)), "E0211");
    assert_eq!(code(&loops(30)), "E0211");
}
