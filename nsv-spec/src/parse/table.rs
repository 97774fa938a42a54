//! Reads lookup tables.

use super::fields::Reader;
use crate::diagnostic::Rule;
use crate::interpolation::{Degree, Extrapolation};
use crate::spec::{Axis, Grid, Read, Table, Unreadable};
use crate::vocabulary::{AXIS, TABLE};
use crate::yaml::{Kind, Node};

impl Reader {
    pub(super) fn table(&mut self, node: &Node) -> Table {
        let fields = self.fields(node, &TABLE);
        let values = fields.entry("values").map(|entry| self.grid(&entry.value));
        let file = self.text(&fields, "file");
        let column = self.text(&fields, "column");
        let given = fields.entry("file").is_some();
        if given == values.is_some() && (given || fields.complete) {
            let help = "write `values: [..]`, or `file: data/table.csv`";
            let message = "table must have one of `values` and `file`";
            self.fault(Rule::E0106, fields.span, message, help);
        }
        if let (Some(Ok(column)), None) = (&column, &file) {
            let message = "`column` is given without `file`";
            self.fault(Rule::E0106, column.span, message, "remove `column`");
        }
        Table {
            axes: self.map(&fields, "axes", Self::axis),
            values,
            file,
            column,
            unit: self.text(&fields, "unit"),
            interpolation: self.choice(&fields, "interpolation", &[Degree::Linear, Degree::Cubic]),
            extrapolation: self.choice(
                &fields,
                "extrapolation",
                &[Extrapolation::Clamp, Extrapolation::Error],
            ),
            source: self.note(&fields, "source"),
        }
    }

    fn axis(&mut self, node: &Node) -> Axis {
        match &node.kind {
            Kind::Seq(_) => Axis {
                values: Some(self.grid(node)),
                unit: None,
            },
            Kind::Map(_) => {
                let fields = self.fields(node, &AXIS);
                Axis {
                    values: fields.entry("values").map(|entry| self.grid(&entry.value)),
                    unit: self.text(&fields, "unit"),
                }
            }
            Kind::Scalar(_) => Axis {
                values: None,
                unit: Some(self.word(node)),
            },
            Kind::Null => {
                let help = "write `[1, 2, 3]`, or its unit where a file has the values: `m`, or `\"1\"` for a pure number";
                self.kind(node, "an axis: values or a unit", help);
                Axis {
                    values: Some(Err(Unreadable)),
                    unit: Some(Err(Unreadable)),
                }
            }
        }
    }

    /// Numbers are read when their unit is known.
    fn grid(&mut self, node: &Node) -> Read<Grid> {
        let Kind::Seq(items) = &node.kind else {
            return self.word(node).map(Grid::Number);
        };
        let items: Vec<Read<Grid>> = items.iter().map(|item| self.grid(item)).collect();
        let items: Read<Vec<Grid>> = items.into_iter().collect();
        items.map(|items| Grid::List(items, node.span))
    }
}
