//! Tables written in the specification.

use super::{Cell, Context, MAX_VALUES, Written};
use crate::diagnostic::{Rule, counted};
use crate::spec::{Grid, Table, Unreadable};

impl Context<'_> {
    /// The numbers of a table whose values are `values`.
    pub(super) fn inline_table<'t>(
        &mut self,
        declared: &'t Table,
        values: &'t Grid,
    ) -> Option<Written<'t>> {
        let mut points = Vec::new();
        for axis in &declared.axes {
            let cells = match &axis.value.values {
                Some(Err(Unreadable)) => return None,
                Some(Ok(Grid::List(items, _))) => items.iter().map(cell).collect(),
                _ => None,
            };
            let Some(cells) = cells else {
                let message = format!("axis `{}` has no list of values", axis.name.value);
                let help = "write `axis: [1, 2, 3]`, or `axis: {values: [1, 2, 3], unit: m}`";
                self.table_shape(axis.name.span, message, help);
                return None;
            };
            points.push(cells);
        }
        let mut cells = Vec::new();
        self.fill(declared, &points, values, 0, &mut cells)?;
        Some(Written {
            points,
            values: cells,
        })
    }

    /// Appends the values below one place; lists lie in each other as deep as there are axes.
    fn fill<'t>(
        &mut self,
        declared: &Table,
        points: &[Vec<Cell<'_>>],
        grid: &'t Grid,
        axis: usize,
        cells: &mut Vec<Cell<'t>>,
    ) -> Option<()> {
        let help = "write a list for each axis, the first outermost, with as many entries as the axis has values";
        let found = match (grid, points.get(axis)) {
            (Grid::Number(_), None) => {
                cells.extend(cell(grid));
                return Some(());
            }
            (Grid::List(items, _), Some(wanted)) if items.len() == wanted.len() => {
                if cells.len() > MAX_VALUES {
                    let message = format!("table has more than {MAX_VALUES} values");
                    self.fault(Rule::E0324, grid.span(), message, "leave out points");
                    return None;
                }
                for item in items {
                    self.fill(declared, points, item, axis + 1, cells)?;
                }
                return Some(());
            }
            (Grid::Number(_), _) => "a number".to_owned(),
            (Grid::List(items, _), _) => format!("a list of {}", counted(items.len(), "item")),
        };
        let expected = match (declared.axes.get(axis), points.get(axis)) {
            (Some(axis), Some(points)) => {
                format!(
                    "{} along `{}`",
                    counted(points.len(), "value"),
                    axis.name.value
                )
            }
            _ => "a number".to_owned(),
        };
        self.table_shape(
            grid.span(),
            format!("found {found}, expected {expected}"),
            help,
        );
        None
    }
}

fn cell(grid: &Grid) -> Option<Cell<'_>> {
    match grid {
        Grid::Number(word) => Some(Cell {
            text: &word.value,
            span: word.span,
        }),
        Grid::List(..) => None,
    }
}
