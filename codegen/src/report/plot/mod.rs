//! Line plots over time as deterministic SVG text.

mod range;
mod simplify;
mod svg;
mod ticks;

pub(crate) use svg::svg;

/// Width of a picture; letters have one size in both when two wide or three narrow ones share a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    /// Half a row.
    Wide,
    /// A third of a row.
    Narrow,
}

impl Size {
    /// Width in the units of the picture.
    fn width(self) -> f64 {
        match self {
            Size::Wide => 480.0,
            Size::Narrow => 316.0,
        }
    }
}

/// One picture: marks over a shared time axis.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    /// Heading.
    pub title: String,
    /// Unit of the ordinate, as written in the specification.
    pub unit: String,
    /// Whether the ordinate is logarithmic; values that are not positive are then gaps.
    pub log: bool,
    /// Abscissa of every mark, s.
    pub t: Vec<f64>,
    /// What is drawn, back to front.
    pub marks: Vec<Mark>,
}

/// Something drawn in a plot, in the ordinate's unit.
#[derive(Clone, Debug)]
pub(crate) enum Mark {
    /// A curve.
    Line {
        /// Entry in the legend; empty for none.
        label: String,
        /// Colour and stroke.
        ink: Ink,
        /// Ordinates.
        y: Vec<f64>,
    },
    /// The area between two curves.
    Band {
        /// Entry in the legend; empty for none.
        label: String,
        /// Colour.
        ink: Ink,
        /// Lower edge.
        low: Vec<f64>,
        /// Upper edge.
        high: Vec<f64>,
    },
}

/// Roles of a mark; the style sheet gives each a colour for light, dark and paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// The quantity itself.
    Actual,
    /// What it should be, or a second view of it.
    Reference,
    /// What the controller believes.
    Estimate,
    /// The difference of two quantities.
    Difference,
    /// A bound.
    Limit,
    /// The wide band of a campaign.
    Outer,
    /// The narrow band of a campaign.
    Inner,
    /// One of several channels.
    Channel(usize),
}

impl Ink {
    /// Class name in the style sheet.
    fn class(self) -> String {
        match self {
            Ink::Actual => "actual".to_owned(),
            Ink::Reference => "reference".to_owned(),
            Ink::Estimate => "estimate".to_owned(),
            Ink::Difference => "difference".to_owned(),
            Ink::Limit => "limit".to_owned(),
            Ink::Outer => "outer".to_owned(),
            Ink::Inner => "inner".to_owned(),
            Ink::Channel(index) => format!("channel{}", index % 6),
        }
    }
}

impl Mark {
    fn label(&self) -> &str {
        match self {
            Mark::Line { label, .. } | Mark::Band { label, .. } => label,
        }
    }

    fn ink(&self) -> Ink {
        match self {
            Mark::Line { ink, .. } | Mark::Band { ink, .. } => *ink,
        }
    }

    /// Every ordinate.
    fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let (first, second): (&[f64], &[f64]) = match self {
            Mark::Line { y, .. } => (y, &[]),
            Mark::Band { low, high, .. } => (low, high),
        };
        first.iter().chain(second).copied()
    }
}
