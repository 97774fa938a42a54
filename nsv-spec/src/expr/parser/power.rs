//! How strongly each operator binds; the only place that says so.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::expr::lexer::operators;
use crate::expr::syntax::Infix;
pub(super) const NONE: u8 = 0;
pub(super) const NOT: u8 = 5;
pub(super) const NEGATE: u8 = 12;

/// Left and right binding power. The left one is smaller in operators that group to the left, larger in `^`.
pub(super) fn of(operator: Infix) -> (u8, u8) {
    match operator {
        Infix::Or => (1, 2),
        Infix::And => (3, 4),
        // NOT = 5
        Infix::Compare(_) => (6, 7),
        Infix::Add | Infix::Sub => (8, 9),
        Infix::Mul | Infix::Div => (10, 11),
        // NEGATE = 12: -x^2 = -(x^2), and x^-2 since a prefix may start any operand.
        Infix::Pow => (14, 13),
    }
}

/// Operators and how those of one strength group, the strongest first.
pub(crate) fn binding() -> Vec<(String, &'static str)> {
    let mut rows: BTreeMap<Reverse<u8>, (Vec<String>, &str)> = BTreeMap::new();
    let mut add = |power: u8, symbol: &str, groups| {
        let row = rows.entry(Reverse(power)).or_insert((Vec::new(), groups));
        row.0.push(format!("`{symbol}`"));
    };
    add(NEGATE, "-x", "in front of an operand");
    add(NOT, "not c", "in front of an operand");
    for (symbol, operator) in operators() {
        let (left, right) = of(operator);
        let groups = match operator {
            Infix::Compare(_) => "no two in a row",
            _ if left < right => "to the left",
            _ => "to the right",
        };
        add(left.max(right), symbol, groups);
    }
    let rows = rows.into_values();
    rows.map(|(symbols, groups)| (symbols.join(" "), groups))
        .collect()
}
