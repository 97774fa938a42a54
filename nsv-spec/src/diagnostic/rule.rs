//! The rules of the language, each with the stable code of the diagnostics for breaking it. A code never changes its meaning,
//! and one that is given up is not used again.

use std::fmt;

use super::Severity;
use crate::suggest::nearest;

/// Makes the enum, its list and its names of one table, so that they cannot drift.
macro_rules! codes {
    ($($code:ident $title:literal,)*) => {
        /// What a diagnostic is about. Its code starts with `E` for errors, `W` for warnings.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Rule {
            $(#[doc = $title] $code,)*
        }

        impl Rule {
            /// Every code, in order.
            pub const ALL: &[Rule] = &[$(Rule::$code,)*];

            /// The code as text, such as `E0403`.
            pub fn name(self) -> &'static str {
                match self {
                    $(Rule::$code => stringify!($code),)*
                }
            }

            /// What it stands for, in a few words.
            pub fn title(self) -> &'static str {
                match self {
                    $(Rule::$code => $title,)*
                }
            }
        }
    };
}

codes! {
    // Files and YAML
    E0001 "file too large",
    E0002 "not UTF-8",
    E0003 "byte order mark",
    E0004 "not valid YAML",
    E0005 "nested too deep",
    E0006 "aliases expand to too much data",
    E0007 "YAML tag",
    E0008 "second YAML document",
    E0009 "YAML alias or merge key that cannot be used",
    E0010 "key that is not text",
    E0011 "specification cannot be read",
    // Included files
    E0020 "include path not allowed",
    E0021 "included file cannot be read",
    E0022 "file included twice or by itself",
    E0023 "too many files, or nested too deep",
    E0024 "section that an included file must not have",
    E0025 "key given in two files",
    // Composition
    E0030 "path that leads nowhere",
    E0031 "argument that an included file does not declare",
    E0032 "removed key that is not there",
    E0033 "sweep of nothing or of too much",
    // Keys and values
    E0101 "unknown key",
    E0102 "key given twice",
    E0103 "value of the wrong kind",
    E0104 "missing key",
    E0105 "unknown language version",
    E0106 "one of two keys expected",
    E0107 "malformed polynomial data",
    // Names and what belongs together
    E0110 "not a good name",
    E0111 "reserved word as a name",
    E0112 "name of a quantity of the control law",
    E0113 "name declared twice",
    E0114 "blocks of plant and controller differ",
    E0115 "references and outputs differ",
    E0116 "unknown parameter",
    E0117 "circular declarations",
    E0118 "feature needs a key that is missing",
    E0119 "key without use",
    // Syntax of expressions
    E0201 "unexpected character",
    E0202 "malformed number",
    E0203 "unexpected part of an expression",
    E0204 "bracket not closed",
    E0205 "chained comparison",
    E0206 "expression nested too deep",
    E0207 "expression too long",
    E0208 "missing operator",
    E0209 "malformed index",
    E0210 "counter that does not count upwards",
    E0211 "expression too large once functions and loops are written out",
    // Names in expressions
    E0301 "unknown name",
    E0302 "unknown function",
    E0303 "name that cannot be used here",
    E0304 "value, function and polynomial data confused",
    E0305 "wrong number of arguments",
    E0306 "no argument of the data",
    E0307 "counter with the name of something else",
    // Lookup tables
    E0320 "axis not increasing",
    E0321 "table of the wrong shape",
    E0322 "not a number in a table",
    E0323 "column of a file",
    E0324 "table too large",
    // Units
    E0401 "unknown unit",
    E0402 "malformed unit",
    E0403 "operands of different units",
    E0404 "argument of the wrong unit",
    E0405 "real power of a quantity",
    E0406 "exponent of a unit out of range",
    E0407 "value of the wrong unit",
    E0408 "division by zero",
    // Shapes
    E0501 "shapes that do not fit",
    E0502 "truth value and number confused",
    E0503 "wrong number of entries, or index outside",
    E0504 "value of the wrong shape",
    E0505 "ragged array",
    // Values
    E0601 "value must be positive",
    E0602 "value outside its range",
    E0603 "value not finite",
    E0604 "number of the wrong unit",
    E0605 "number of the wrong shape",
    E0606 "units of data in conflict",
    E0607 "impossible dispersion",
    E0608 "matrix not positive definite",
    E0609 "network of impossible size",
    E0610 "scheme does not fit the noise",
    E0611 "parameter dispersed twice",
    E0612 "impossible covariance",
    E0613 "delay not a number of plant steps",
    // What the theory requires
    E0701 "dependence on inner states",
    E0702 "time in the plant",
    E0703 "dependence on states",
    E0704 "singular gain",
    E0705 "initial error violates its constraint",
    E0706 "not finite where it is evaluated",
    E0707 "observer does not converge",
    E0708 "constraint not positive",
    E0710 "design depends on the flown plant",
    E0711 "rate of what is no state",
    E0712 "state without a rate",
    E0713 "sensor of a state that is not measured",
    // Warnings
    W0001 "gain below its bound",
    W0002 "declaration without use",
    W0003 "argument without use",
    W0010 "angle in degrees where a function takes radians",
    W0011 "number without a unit for a state in degrees",
    W0012 "quotient by a matrix",
}

impl Rule {
    /// Error or warning, as its letter says.
    pub fn severity(self) -> Severity {
        match self.name().starts_with('E') {
            true => Severity::Error,
            false => Severity::Warning,
        }
    }

    /// Its letter with the first two digits: what kind of thing is at fault, such as `E04` for units.
    pub fn family(self) -> &'static str {
        &self.name()[..3]
    }

    /// The rule whose code is nearest to a mistyped one.
    pub fn nearest(name: &str) -> Option<Self> {
        let meant = nearest(name, Rule::ALL.iter().map(|rule| rule.name()))?;
        Rule::find(&meant.name)
    }

    /// The rule of a code in either case; `None` if there is none.
    pub fn find(name: &str) -> Option<Self> {
        let known = |code: &&Rule| code.name().eq_ignore_ascii_case(name);
        Rule::ALL.iter().find(known).copied()
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
