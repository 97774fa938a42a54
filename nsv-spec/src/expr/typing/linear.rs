//! Types of the operations of linear algebra. Each entry of a product is a sum, whose terms must agree in their dimension.

use super::{Dimension, Fault, Real, Shape, in_entry, out_of_range, shown};
use crate::diagnostic::Rule;

/// Matrix times matrix or vector: entrywise, all terms of a sum have one dimension.
pub(in crate::expr) fn matrix_product(left: &Real, right: &Real) -> Result<Real, Fault> {
    let ((rows, inner), (height, cols)) = (left.shape.size(), right.shape.size());
    if inner != height {
        let message = format!(
            "shape mismatch: product of {} and {}",
            left.shape, right.shape
        );
        let help = format!(
            "the left factor has {inner} columns, the right one {height} rows; they must be equal"
        );
        return Err(Fault::new(Rule::E0501, message, help));
    }
    let shape = if matches!(right.shape, Shape::Vector(_)) {
        Shape::Vector(rows)
    } else {
        Shape::Matrix(rows, cols)
    };
    let entry = |entry: usize| {
        let (row, col) = (entry / cols, entry % cols);
        let terms = (0..inner).map(|k| {
            (
                left.dimensions[row * inner + k],
                right.dimensions[k * cols + col],
            )
        });
        sum_of_products(&in_entry(shape, entry), terms)
    };
    let dimensions = (0..rows * cols).map(entry).collect::<Result<_, _>>()?;
    Ok(Real { shape, dimensions })
}

/// Inner product of two vectors.
pub(in crate::expr) fn dot(left: &Real, right: &Real) -> Result<Real, Fault> {
    match (left.shape, right.shape) {
        (Shape::Vector(a), Shape::Vector(b)) if a == b => {
            let terms = left
                .dimensions
                .iter()
                .copied()
                .zip(right.dimensions.iter().copied());
            sum_of_products("", terms).map(Real::scalar)
        }
        (a, b) => {
            let message = format!("shape mismatch: `dot` of {a} and {b}");
            Err(Fault::new(
                Rule::E0501,
                message,
                "`dot` takes two vectors of one length",
            ))
        }
    }
}

/// Cross product of two vectors of three.
pub(in crate::expr) fn cross(left: &Real, right: &Real) -> Result<Real, Fault> {
    let three = Shape::Vector(3);
    if left.shape != three || right.shape != three {
        let message = format!(
            "shape mismatch: `cross` of {} and {}",
            left.shape, right.shape
        );
        return Err(Fault::new(
            Rule::E0501,
            message,
            "`cross` takes two vectors of 3",
        ));
    }
    let (a, b) = (&left.dimensions, &right.dimensions);
    let entry = |entry: usize| {
        let (next, last) = ((entry + 1) % 3, (entry + 2) % 3);
        sum_of_products(
            &in_entry(three, entry),
            [(a[next], b[last]), (a[last], b[next])].into_iter(),
        )
    };
    let dimensions = (0..3).map(entry).collect::<Result<_, _>>()?;
    Ok(Real {
        shape: three,
        dimensions,
    })
}

/// Rows and columns exchanged; a vector becomes a row.
pub(in crate::expr) fn transpose(argument: &Real) -> Result<Real, Fault> {
    if argument.shape == Shape::Scalar {
        return Err(Fault::new(
            Rule::E0501,
            "shape mismatch: `transpose` of a scalar",
            "`transpose` takes a matrix or a vector",
        ));
    }
    let (rows, cols) = argument.shape.size();
    let places = (0..cols).flat_map(|col| (0..rows).map(move |row| row * cols + col));
    let dimensions = places.map(|place| argument.dimensions[place]).collect();
    Ok(Real {
        shape: Shape::Matrix(cols, rows),
        dimensions,
    })
}

fn sum_of_products(
    at: &str,
    mut terms: impl Iterator<Item = (Dimension, Dimension)>,
) -> Result<Dimension, Fault> {
    terms.try_fold(Dimension::ANY, |sum, (a, b)| {
        let term = a.checked_mul(b).ok_or_else(out_of_range)?;
        sum.agree(term).ok_or_else(|| {
            let message = format!(
                "unit mismatch{at}: terms of the product are {} and {}",
                shown(sum),
                shown(term)
            );
            Fault::new(
                Rule::E0403,
                message,
                "all terms of a sum must have one unit",
            )
        })
    })
}
