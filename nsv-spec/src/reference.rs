//! The reference page of the expression language, written from the tables that the parser and the elaborator use.

use std::fmt::Write;

use crate::check::{MAX_AXES, MAX_POINTS, MAX_VALUES};
use crate::expr::{
    CONSTANTS, Entry, MAX_DEPTH, MAX_INSERTED, MAX_NODES, MAX_ROUNDS, MAX_TEXT, MAX_UNKNOWNS,
    binding, entries,
};

use crate::yaml::MAX_BYTES;

/// The specification that the examples belong to.
pub const WORLD: &str = include_str!("../tests/good/language.yaml");

const INTRODUCTION: &str = "\
# The expression language

Wherever a specification takes an expression, it takes this language: numbers with units, names, operators, functions,
vectors and matrices. Every expression has a shape and a physical dimension for each entry, and both are checked when the
specification is read. Expressions are parsed by nsv itself and never reach Python or a shell.

This page is written by `NSV_UPDATE_DOCS=1 cargo test -p nsv-spec --test reference` from the tables that the compiler itself
uses. The same test compiles every example; they belong to the specification at the end of the page.
";

const GRAMMAR: &str = r#"
## Grammar

```ebnf
expression = operand { operator operand } ;          (* how strongly operators bind is listed below *)
operand    = { "-" | "not" } primary { index } ;
primary    = number [ unit ]                         (* the unit touches the number or follows after one blank *)
           | name
           | name "(" expression { "," expression } ")"
           | "partial" "(" name "," name "," expression { "," expression } ")"
           | "each" "(" name "," digits "," digits "," expression ")"
           | "[" expression { "," expression } "]"
           | "(" expression ")" ;
index      = "[" place [ "," place ] "]" ;
place      = digits | name [ ( "+" | "-" ) digits ] ; (* counted from 1; the name is the counter of an "each" *)
operator   = "or" | "and" | "<" | "<=" | ">" | ">=" | "==" | "!=" | "+" | "-" | "*" | "/" | "^" ;
name       = identifier { "." identifier } ;
identifier = ( letter | "_" ) { letter | digit | "_" } ;
number     = digits [ "." digits ] [ ( "e" | "E" ) [ "+" | "-" ] digits ] ;
unit       = factor { ( "*" | "/" ) factor } ;        (* no blanks; from the left: kg/m/s^2 is kg/(m*s^2) *)
factor     = ( symbol | "1" | "(" unit ")" | "sqrt" "(" unit ")" ) [ "^" [ "-" ] digits ] ;
```

A unit ends where what follows cannot be one: `2 m/s*exp(-x)` is `(2 m/s)*exp(-x)`. Where a name could be read as a unit, put blanks
around the operator: `2 m * g`. In YAML an array may also be written as a list of expressions; text that YAML would misread stands in quotes.
"#;

const RULES: &str = "
`+`, `-`, `*` and `/` work entry by entry, and a scalar joins every entry of an array; `*` of a matrix and a matrix or vector
is their product. Sums, differences and comparisons need one unit on both sides. Comparisons take scalars and give truth
values, which `and`, `or`, `not` and `if` take. `x^n` with a whole number `n` is a product and takes any unit; another power
takes pure numbers. Vectors are columns. A literal 0 fits every unit.
";

const OWN: &str = "
## Functions of your own

`functions` declares expressions with arguments. A call stands for the body with the values in place of the arguments, of any
shape and unit that the body allows; a fault in the body is shown there, with the call beside it. A body may use whatever the
place of the call may use; functions may call each other but not themselves. Arguments must not have the name of anything else.

## Loops

`each(i, 1, 3, body)` is the array of what `body` is with `i` = 1, 2, 3: a vector if `body` is a scalar, a matrix of rows if it
is a vector. In the body `i` is a number, and may be an index with or without a number added: `v[i + 1]`.
";

const EQUATIONS: &str = "
## Linear equations

A plant `M v' = c + B u` has `drift: solve(M, c)` and `gain: inverse(M)*B`, and nothing more is to be done by hand, no adjugate and no
determinant:

```yaml
definitions:
  M: \"[[m_x, 0, arm], [0, m_y, 0], [arm, 0, I]]\"     # kg, kg*m and kg*m^2
  c: \"[f_x, f_y, torque] - damping\"                # N, N and N*m
plant:
  blocks:
    velocity: {states: {u: 0 m/s, v: 0 m/s, r: 0 rad/s}, drift: \"solve(M, c)\", gain: inverse(M)}
```

An entry of the matrix is in the unit of its equation over that of its unknown, here `kg*m` where N*m stand over m/s^2; a literal 0 fits
everywhere. The compiler solves for a product with an inverse, adds right sides of one matrix before it solves, takes matrices apart that
fall into blocks, and multiplies by `M` where the control inverts the gain.

Up to three unknowns are solved for by the adjugate, more by elimination with pivoting, and in half of that by factors L D L^T where `M` is
symmetric by its form, as mass matrices are: entry (i, j) is computed as entry (j, i), up to the order of terms and factors and the direction
of a difference under `cos`; or `M` is a sum or multiple of such matrices, or a product that reads the same from both sides, such as
`transpose(J)*diag(m)*J`. Where such a matrix is not positive definite it is solved with pivoting after all. The emitted code shows which:
`M.ldlt()`, `M.solve(..)`.

A matrix without an inverse gives no number: the controller refuses the sample and gives its safe output, and a simulated run ends as not
finite. One that is singular but for roundings gives large numbers, as a division by a small one does.
";

const TABLES: &str = "
## Polynomial data and lookup tables

`polynomials` and `tables` declare functions by their data; a call names them with a value for each argument, and
`partial(data, argument, ..)` is the derivative by the argument of that name. Both are exact functions with exact derivatives to
the compiler: CasADi sees neither coefficients nor tables, so that changing a number in them asks it for nothing.

A table has one to three axes and a value at every combination of their points. It is written in lists within lists, the first axis
outermost, or stands in a CSV file: a line of column names, then a line for each combination with the last axis changing fastest.
Several tables may take their columns from one file; lines that start with `#` are comments.

```yaml
tables:
  lift: {axes: {mach: \"1\", alpha: deg}, file: data/aero.csv, interpolation: cubic, extrapolation: clamp}
```

`interpolation: linear` is straight between the points: the slope is that of the interval, at a point that of the interval above it,
and further derivatives are 0. `interpolation: cubic` is the product of cubic splines without a knot at the second and the last but one
point of each axis, with two continuous derivatives: a table of a cubic polynomial gives that polynomial back, at the ends too.
`extrapolation: clamp` holds the value at the nearer end of the axis, and its derivatives by that axis are 0. `extrapolation: error`
gives no number: the controller refuses the sample and gives its safe output, and a simulated run ends as not finite.
";

/// The page in Markdown.
pub fn language_reference() -> String {
    let mut page = INTRODUCTION.to_owned();
    page.push_str(GRAMMAR);
    page.push_str("\n## Operators\n\nThe first row binds most strongly.\n\n| operator | groups |\n|---|---|\n");
    for (operators, groups) in binding() {
        _ = writeln!(page, "| {operators} | {groups} |");
    }
    page.push_str(RULES);
    page.push_str("\n## Functions\n\n");
    functions(&mut page, |entry| !entry.name.contains('.'));
    page.push_str("\n## Standard atmosphere\n\nU.S. Standard Atmosphere 1976 up to 86 km; outside -5 km to 86 km the air is that at the nearer end.\n`h` is the geometric height, `z` the geopotential one. Where a layer begins the derivatives jump.\n\n");
    functions(&mut page, |entry| entry.name.contains('.'));
    page.push_str("\n## Constants\n\n| name | value | meaning |\n|---|---|---|\n| `t` | | time since the start, s |\n");
    for constant in CONSTANTS {
        let value = constant.value;
        let digits = if (1e-3..1e9).contains(&value) {
            format!("{value}")
        } else {
            format!("{value:e}")
        };
        _ = writeln!(
            page,
            "| `{}` | {} | {} |",
            constant.name,
            [&digits, constant.unit].join(" ").trim(),
            constant.meaning
        );
    }
    page.push_str(EQUATIONS);
    page.push_str(TABLES);
    page.push_str(OWN);
    page.push_str("\n## Functions that are defined in the language itself\n\n");
    for entry in entries() {
        if let Some(definition) = entry.definition() {
            _ = writeln!(page, "- `{}` is `{definition}`", entry.signature());
        }
    }
    limits(&mut page);
    _ = write!(
        page,
        "\n## The specification of the examples\n\n```yaml\n{WORLD}```\n"
    );
    page
}

/// Every example of the page.
pub fn examples() -> impl Iterator<Item = &'static str> {
    entries().map(|entry| entry.example)
}

fn functions(page: &mut String, which: impl Fn(&Entry) -> bool) {
    page.push_str("| function | meaning | shapes and units | example |\n|---|---|---|---|\n");
    for entry in entries().filter(|entry| which(entry)) {
        let Entry {
            meaning,
            rule,
            example,
            ..
        } = entry;
        _ = writeln!(
            page,
            "| `{}` | {meaning} | {rule} | `{example}` |",
            entry.signature()
        );
    }
}

fn limits(page: &mut String) {
    _ = write!(
        page,
        "\n## Limits\n\nAn expression has at most {MAX_TEXT} bytes, {MAX_NODES} operations and a depth of {MAX_DEPTH}; an `each` at most\n{MAX_ROUNDS} rounds. Calls of functions that stand for an expression and rounds of `each` insert at most {MAX_INSERTED} operations into\none specification. `solve` and `inverse` take at most {MAX_UNKNOWNS} unknowns. A table has at most {MAX_AXES} axes of\n{MAX_POINTS} points and {MAX_VALUES} values, its file {MAX_BYTES} bytes.\n"
    );
}
