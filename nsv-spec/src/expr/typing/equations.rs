//! Types of solutions of linear equations. Where `A x = b` makes sense, entry (i, j) of A is in r_i / c_j, b in r and x in c: the units r of
//! the equations and c of the unknowns follow from A up to one factor for each set of equations that A couples.

use super::{Dimension, Fault, Real, Shape, in_entry, out_of_range, shown};
use crate::diagnostic::Rule;

/// Most unknowns: the work to solve for them grows with their cube, and their derivatives are written out one by one.
pub(crate) const MAX_UNKNOWNS: usize = 16;

/// Most rows of a matrix whose units are shown.
const MOST_SHOWN: usize = 6;

/// Solution of `A x = b`, b a vector or a matrix of right sides.
pub(in crate::expr) fn solution(matrix: &Real, right: &Real) -> Result<Real, Fault> {
    let count = unknowns("solve", matrix).map_err(|fault| match unknowns("solve", right) {
        Ok(_) => Fault {
            help: "the matrix comes first: `solve(M, b)`".to_owned(),
            ..fault
        },
        Err(_) => fault,
    })?;
    let (rows, sides) = right.shape.size();
    if right.shape == Shape::Scalar || rows != count {
        let message = format!(
            "shape mismatch: `solve` of {} and {}",
            matrix.shape, right.shape
        );
        let help = format!(
            "the right side has as many rows as the matrix: a vector of {count}, or a matrix of {count} rows"
        );
        return Err(Fault::new(Rule::E0501, message, help));
    }
    let equations = consistent(matrix, count)?;
    let mut dimensions = vec![Dimension::ANY; count * sides];
    for side in 0..sides {
        let given: Vec<Dimension> = (0..rows)
            .map(|row| right.dimensions[row * sides + side])
            .collect();
        let factors = equations.factors(&given)?;
        for (unknown, place) in equations.unknowns.iter().enumerate() {
            if let Some((set, dimension)) = place {
                let scaled = dimension.checked_mul(factors[*set]);
                dimensions[unknown * sides + side] = scaled.ok_or_else(out_of_range)?;
            }
        }
    }
    let shape = right.shape;
    Ok(Real { shape, dimensions })
}

/// Inverse of a matrix: entry (j, i) is in c_j / r_i, and 0 where A does not couple them.
pub(in crate::expr) fn inverse(matrix: &Real) -> Result<Real, Fault> {
    let count = unknowns("inverse", matrix)?;
    let Equations { rows, unknowns } = consistent(matrix, count)?;
    let entry = |at: usize| match (unknowns[at / count], rows[at % count]) {
        (Some((set, of_unknown)), (of, row)) if set == of => {
            of_unknown.checked_div(row).ok_or_else(out_of_range)
        }
        _ => Ok(Dimension::ANY),
    };
    let dimensions = (0..count * count).map(entry).collect::<Result<_, _>>()?;
    let shape = matrix.shape;
    Ok(Real { shape, dimensions })
}

/// How many there are: the matrix is square, and not too large.
fn unknowns(name: &str, matrix: &Real) -> Result<usize, Fault> {
    let (rows, columns) = matrix.shape.size();
    let fault = |message: String, help: &str| Err(Fault::new(Rule::E0501, message, help));
    if matrix.shape == Shape::Scalar || rows != columns {
        let message = format!("shape mismatch: `{name}` of {}", matrix.shape);
        let help = match matrix.shape {
            Shape::Scalar if name == "inverse" => "write `1/x` for a scalar",
            Shape::Scalar => "write `b/a` where `a` is a scalar",
            _ => "the matrix is square: as many equations as unknowns",
        };
        return fault(message, help);
    }
    if rows > MAX_UNKNOWNS {
        let message =
            format!("`{name}` of a matrix of {rows} rows, more than the limit of {MAX_UNKNOWNS}");
        return fault(
            message,
            "solve for the parts that do not depend on each other separately",
        );
    }
    Ok(rows)
}

/// The equations of a matrix of which every entry fits. If not, the entry to blame is the one without which all others do, or else one of two
/// that mirror each other, since one definition often stands in both places.
fn consistent(matrix: &Real, count: usize) -> Result<Equations, Fault> {
    let equations = Equations::of(matrix, count)?;
    let Some(misfit) = equations.misfit(matrix)? else {
        return Ok(equations);
    };
    let mut culprits = Vec::new();
    for at in 0..count * count {
        let mirrored = at % count * count + at / count;
        for others in [vec![at], vec![at, mirrored]] {
            let mut rest = matrix.clone();
            for &other in &others {
                rest.dimensions[other] = Dimension::ANY;
            }
            let without = Equations::of(&rest, count);
            let fits = |without: &Equations| matches!(without.misfit(&rest), Ok(None));
            if let Ok(without) = without
                && fits(&without)
            {
                let expected = without.entry(at / count, at % count)?;
                culprits.push((others.len(), at, expected));
            }
        }
    }
    let fewest = culprits.iter().map(|(count, ..)| *count).min();
    culprits.retain(|(count, ..)| Some(*count) == fewest);
    // A pair is found from both sides.
    let alone = fewest.is_some_and(|fewest| culprits.len() == fewest);
    let (at, expected) = match culprits.first() {
        Some(&(_, at, expected)) if alone => (at, expected),
        _ => (misfit, None),
    };
    Err(misfitting(matrix, at, expected))
}

fn misfitting(matrix: &Real, at: usize, expected: Option<Dimension>) -> Fault {
    let (place, found) = (in_entry(matrix.shape, at), matrix.dimensions[at].in_words());
    let message = match expected {
        Some(expected) => format!(
            "unit mismatch{place}: it is {found}, but the other entries ask for {}",
            shown(expected)
        ),
        None => format!(
            "unit mismatch{place}: it is {found}, which does not fit the other entries of its row and column"
        ),
    };
    let count = matrix.shape.size().0;
    let rows = matrix.dimensions.chunks(count).map(|row| {
        let units = row.iter().map(|unit| match *unit {
            Dimension::ANY => "0".to_owned(),
            unit => unit.to_string(),
        });
        units.collect::<Vec<_>>().join(", ")
    });
    let rows: Vec<String> = rows.collect();
    let mut help = "an entry is in the unit of its equation over that of its unknown".to_owned();
    if count <= MOST_SHOWN {
        help.push_str("; here the rows are in: ");
        help.push_str(&rows.join("; "));
    }
    Fault::new(Rule::E0403, message, help)
}

/// An equation or an unknown, and its unit.
#[derive(Clone, Copy)]
enum Place {
    Row(usize, Dimension),
    Unknown(usize, Dimension),
}

/// What a matrix says of the units.
struct Equations {
    /// For each equation its set and its unit r, where the first equation of a set is a pure number.
    rows: Vec<(usize, Dimension)>,
    /// For each unknown its set and its unit c; nothing if it is in no equation.
    unknowns: Vec<Option<(usize, Dimension)>>,
}

impl Equations {
    fn of(matrix: &Real, count: usize) -> Result<Equations, Fault> {
        let mut rows = vec![None; count];
        let mut unknowns = vec![None; count];
        for first in 0..count {
            if rows[first].is_some() {
                continue;
            }
            rows[first] = Some((first, Dimension::ONE));
            let mut pending = vec![Place::Row(first, Dimension::ONE)];
            while let Some(place) = pending.pop() {
                for other in 0..count {
                    let (entry, known) = match place {
                        Place::Row(row, _) => (row * count + other, &mut unknowns[other]),
                        Place::Unknown(unknown, _) => (other * count + unknown, &mut rows[other]),
                    };
                    let entry = matrix.dimensions[entry];
                    if entry == Dimension::ANY || known.is_some() {
                        continue;
                    }
                    let (dimension, place) = match place {
                        Place::Row(_, row) => {
                            let dimension = row.checked_div(entry).ok_or_else(out_of_range)?;
                            (dimension, Place::Unknown(other, dimension))
                        }
                        Place::Unknown(_, unknown) => {
                            let dimension = unknown.checked_mul(entry).ok_or_else(out_of_range)?;
                            (dimension, Place::Row(other, dimension))
                        }
                    };
                    *known = Some((first, dimension));
                    pending.push(place);
                }
            }
        }
        let rows = rows.into_iter().flatten().collect();
        Ok(Equations { rows, unknowns })
    }

    /// The unit that an entry has in these equations; `None` if they do not couple its row and column.
    fn entry(&self, row: usize, unknown: usize) -> Result<Option<Dimension>, Fault> {
        let ((set, of_row), Some((other, of_unknown))) = (self.rows[row], self.unknowns[unknown])
        else {
            return Ok(None);
        };
        let entry = of_row.checked_div(of_unknown).ok_or_else(out_of_range)?;
        Ok((set == other).then_some(entry))
    }

    /// The first entry, row-major, that is of another unit.
    fn misfit(&self, matrix: &Real) -> Result<Option<usize>, Fault> {
        let count = self.rows.len();
        for (at, &found) in matrix.dimensions.iter().enumerate() {
            let expected = self.entry(at / count, at % count)?;
            if expected.is_some_and(|expected| found.agree(expected).is_none()) {
                return Ok(Some(at));
            }
        }
        Ok(None)
    }

    /// For each set of equations what their units are multiplied by to be those of a right side; [`Dimension::ANY`] if that is 0.
    fn factors(&self, right: &[Dimension]) -> Result<Vec<Dimension>, Fault> {
        let mut factors = vec![Dimension::ANY; self.rows.len()];
        for (row, (&found, &(set, dimension))) in right.iter().zip(&self.rows).enumerate() {
            let expected = dimension
                .checked_mul(factors[set])
                .ok_or_else(out_of_range)?;
            if found.agree(expected).is_none() {
                let message = format!(
                    "unit mismatch: entry {} of the right side is {}, but the other equations ask for {}",
                    row + 1,
                    found.in_words(),
                    shown(expected)
                );
                let help = "the units of the right side are those of the matrix times the unknowns";
                return Err(Fault::new(Rule::E0403, message, help));
            }
            if factors[set] == Dimension::ANY {
                factors[set] = found.checked_div(dimension).ok_or_else(out_of_range)?;
            }
        }
        Ok(factors)
    }
}
