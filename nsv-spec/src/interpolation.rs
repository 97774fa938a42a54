//! Interpolation of tables: a tensor product of B-splines of degree 1 or 3.
//!
//! On each axis the knots are the breaks, those at the ends repeated, so that on interval i only the splines i to i + degree are not
//! zero, and there they are polynomials of s = x - break_i ([`weights`]). A value is the sum of the coefficients under their splines'
//! products; along the last axis they are summed first, into one polynomial for each interval ([`Interpolant::curves`]). Linear tables
//! break at every point and their coefficients are the values. Cubic ones do not break at the second and the last but one point of an
//! axis (not-a-knot): they have two continuous derivatives, and a table of a cubic polynomial gives it back, at the ends too, where a
//! natural spline would bend it straight.

use std::array::from_fn;

/// What a table is between its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Degree {
    /// Straight lines.
    Linear,
    /// Cubic splines.
    Cubic,
}

impl Degree {
    /// Degree of the polynomials.
    pub fn number(self) -> usize {
        match self {
            Degree::Linear => 1,
            Degree::Cubic => 3,
        }
    }

    /// Fewest points of an axis.
    pub fn fewest_points(self) -> usize {
        self.number() + 1
    }
}

/// What a table is outside its axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Extrapolation {
    /// The value at the nearer end of the axis; derivatives by that axis are 0.
    Clamp,
    /// Not a number.
    Error,
}

/// A function of one to three arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Interpolant {
    /// Degree on every axis.
    pub degree: Degree,
    /// Outside.
    pub extrapolation: Extrapolation,
    /// Breaks of each axis, increasing, at least two.
    pub breaks: Vec<Vec<f64>>,
    /// Coefficients of the products of splines, the last axis fastest: on each axis as many as intervals and the degree together.
    pub coefficients: Vec<f64>,
}

/// Powers of s, from the lowest, of the splines that are not zero on an interval; only the first degree + 1 of each are used.
pub type Weights = [[f64; 4]; 4];

impl Interpolant {
    /// The interpolant through `values` at every combination of the points of the axes, the last axis fastest. Each axis has points enough
    /// for the degree, increasing; coefficients may overflow.
    pub fn new(
        degree: Degree,
        extrapolation: Extrapolation,
        axes: &[Vec<f64>],
        values: Vec<f64>,
    ) -> Self {
        let mut interpolant = Self {
            degree,
            extrapolation,
            breaks: axes.iter().map(|points| breaks(degree, points)).collect(),
            coefficients: values,
        };
        if degree == Degree::Cubic {
            let mut stride = interpolant.coefficients.len();
            for (points, breaks) in axes.iter().zip(&interpolant.breaks) {
                stride /= points.len();
                fit(points, breaks, stride, &mut interpolant.coefficients);
            }
        }
        interpolant
    }

    /// Value of the derivative `orders[j]` times by argument j, each order at most the degree. Outside an axis the value is that at its end and
    /// a derivative 0, or the whole is NaN.
    pub fn value(&self, arguments: &[f64], orders: &[u32]) -> f64 {
        let mut inside = true;
        let mut places = Vec::new();
        for ((breaks, &x), &order) in self.breaks.iter().zip(arguments).zip(orders) {
            let (low, high) = (breaks[0], breaks[breaks.len() - 1]);
            let outside = x < low || x > high;
            inside &= x >= low && x <= high;
            let interval = interval(breaks, x);
            let held = if x < low {
                low
            } else if x > high {
                high
            } else {
                x
            };
            places.push(Place {
                interval,
                s: held - breaks[interval],
                order: order as usize,
                flat: outside && order > 0,
            });
        }
        if !inside && self.extrapolation == Extrapolation::Error {
            return f64::NAN;
        }
        self.sum(&places, 0, 0)
    }

    /// All curves: for each combination of splines of the other axes, the later axis fastest, one for each interval of the last.
    pub fn curves(&self) -> impl Iterator<Item = [f64; 4]> + '_ {
        let intervals = self.breaks[self.breaks.len() - 1].len() - 1;
        let leading = self.coefficients.len() / (intervals + self.degree.number());
        (0..leading * intervals).map(move |at| self.curve(at / intervals, at % intervals))
    }

    /// Whether all numbers are finite that values are computed from: curves and, with axes before the last, their splines.
    pub fn is_finite(&self) -> bool {
        let leading = &self.breaks[..self.breaks.len() - 1];
        let splines = leading
            .iter()
            .flat_map(|breaks| (0..breaks.len() - 1).flat_map(|i| weights(breaks, self.degree, i)));
        self.curves().chain(splines).flatten().all(f64::is_finite)
    }

    /// The polynomial along the last axis on one of its intervals, by powers of s from the lowest, for a combination of splines of the other
    /// axes; only the first degree + 1 powers are used.
    fn curve(&self, leading: usize, interval: usize) -> [f64; 4] {
        let (breaks, degree) = (&self.breaks[self.breaks.len() - 1], self.degree.number());
        let first = leading * (breaks.len() - 1 + degree) + interval;
        let splines = weights(breaks, self.degree, interval);
        from_fn(|m| {
            let term = |k: usize| splines[k][m] * self.coefficients[first + k];
            (1..=degree).fold(term(0), |sum, k| sum + term(k))
        })
    }

    /// Sum over the splines of an axis and those behind it, from the first spline to the last, or the curve along the last axis; `leading`
    /// is the combination of splines of the axes before.
    fn sum(&self, places: &[Place], axis: usize, leading: usize) -> f64 {
        let (degree, place) = (self.degree.number(), &places[axis]);
        let along = |powers: &[f64; 4]| match place.flat {
            true => 0.0,
            false => derivative(powers, degree, place.order, place.s),
        };
        if axis + 1 == places.len() {
            return along(&self.curve(leading, place.interval));
        }
        let splines = weights(&self.breaks[axis], self.degree, place.interval);
        let first = leading * (self.breaks[axis].len() - 1 + degree) + place.interval;
        let term = |k: usize| along(&splines[k]) * self.sum(places, axis + 1, first + k);
        (1..=degree).fold(term(0), |sum, k| sum + term(k))
    }
}

/// Where an argument lies on its axis.
struct Place {
    interval: usize,
    /// From the start of the interval.
    s: f64,
    /// How often to differentiate.
    order: usize,
    /// Whether derivatives are 0 there.
    flat: bool,
}

/// The interval of x: as many inner breaks as are not above it.
fn interval(breaks: &[f64], x: f64) -> usize {
    let inner = &breaks[1..breaks.len() - 1];
    inner.iter().filter(|&&at| at <= x).count()
}

/// Derivative of the sum of `powers[m] s^m`, by Horner's scheme.
fn derivative(powers: &[f64; 4], degree: usize, order: usize, s: f64) -> f64 {
    let factor = |m: usize| (m + 1 - order..=m).map(|k| k as f64).product::<f64>();
    let leading = powers[degree] * factor(degree);
    let lower = (order..degree).rev();
    lower.fold(leading, |sum, m| sum * s + powers[m] * factor(m))
}

fn breaks(degree: Degree, points: &[f64]) -> Vec<f64> {
    let (last, skipped) = (points.len() - 1, [1, points.len() - 2]);
    let breaks = points.iter().enumerate();
    let kept = breaks.filter(|(at, _)| {
        degree == Degree::Linear || !skipped.contains(at) || [0, last].contains(at)
    });
    kept.map(|(_, &point)| point).collect()
}

/// The splines that are not zero on interval `i`, as polynomials of s = x - break_i: the recursion of de Boor,
/// N_j = (x - t_j)/(t_{j+k} - t_j) N_j + (t_{j+k+1} - x)/(t_{j+k+1} - t_{j+1}) N_{j+1}, degree k from 1 up.
pub fn weights(breaks: &[f64], degree: Degree, i: usize) -> Weights {
    let degree = degree.number();
    let last = breaks.len() - 1;
    let knot = |j: usize| breaks[j.saturating_sub(degree).min(last)];
    let origin = breaks[i];
    let mut splines = [[0.0; 4]; 4];
    splines[degree][0] = 1.0;
    for k in 1..=degree {
        for j in degree - k..=degree {
            // Spline j of this interval is spline i + j of the axis.
            let (left, right) = (knot(i + j), knot(i + j + k + 1));
            let mut spline = [0.0; 4];
            if j > degree - k {
                let width = knot(i + j + k) - left;
                add_product(
                    &mut spline,
                    splines[j],
                    (origin - left) / width,
                    1.0 / width,
                );
            }
            if j < degree {
                let width = right - knot(i + j + 1);
                add_product(
                    &mut spline,
                    splines[j + 1],
                    (right - origin) / width,
                    -1.0 / width,
                );
            }
            splines[j] = spline;
        }
    }
    splines
}

/// sum += spline (constant + slope s)
fn add_product(sum: &mut [f64; 4], spline: [f64; 4], constant: f64, slope: f64) {
    for (m, power) in spline.into_iter().enumerate() {
        sum[m] += power * constant;
        if let Some(next) = sum.get_mut(m + 1) {
            *next += power * slope;
        }
    }
}

/// Half the width of the band of [`fit`]'s equations.
const BAND: usize = 3;

/// Coefficients along one axis, in place of the values at its points: elimination in a band, without pivots, which this totally positive matrix
/// does not need.
fn fit(points: &[f64], breaks: &[f64], stride: usize, values: &mut [f64]) {
    let count = points.len();
    let mut band = vec![[0.0; 2 * BAND + 1]; count];
    for (row, &x) in points.iter().enumerate() {
        let i = interval(breaks, x);
        for (j, powers) in weights(breaks, Degree::Cubic, i).iter().enumerate() {
            let value = derivative(powers, 3, 0, x - breaks[i]);
            if let Some(entry) = (i + j + BAND)
                .checked_sub(row)
                .and_then(|at| band[row].get_mut(at))
            {
                *entry = value;
            }
        }
    }
    for pivot in 0..count {
        for row in pivot + 1..count.min(pivot + BAND + 1) {
            let below = row - pivot;
            let factor = band[row][BAND - below] / band[pivot][BAND];
            band[row][BAND - below] = factor;
            for right in 1..=BAND {
                band[row][BAND + right - below] -= factor * band[pivot][BAND + right];
            }
        }
    }
    for first in (0..values.len()).filter(|at| (at / stride).is_multiple_of(count)) {
        let at = |row: usize| first + row * stride;
        for row in 1..count {
            for below in 1..=BAND.min(row) {
                values[at(row)] -= band[row][BAND - below] * values[at(row - below)];
            }
        }
        for row in (0..count).rev() {
            for right in 1..=BAND.min(count - 1 - row) {
                values[at(row)] -= band[row][BAND + right] * values[at(row + right)];
            }
            values[at(row)] /= band[row][BAND];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [f64; 7] = [-2.0, -1.5, -0.25, 0.0, 0.75, 2.0, 2.5];
    const COARSE: [f64; 4] = [0.0, 1.0, 1.5, 3.0];

    fn near(found: f64, expected: f64) {
        assert!(
            (found - expected).abs() <= 2e-13 * expected.abs().max(1.0),
            "{found}, expected {expected}"
        );
    }

    /// A table of a function of two arguments.
    fn table(
        degree: Degree,
        extrapolation: Extrapolation,
        f: impl Fn(f64, f64) -> f64,
    ) -> Interpolant {
        let values = POINTS.iter().flat_map(|&x| COARSE.map(|y| f(x, y)));
        let axes = [POINTS.to_vec(), COARSE.to_vec()];
        Interpolant::new(degree, extrapolation, &axes, values.collect())
    }

    #[test]
    fn values_at_the_points_are_those_of_the_table() {
        let f = |x: f64, y: f64| (3.0 * x).sin() * (1.0 + y).ln() + 2.0;
        for degree in [Degree::Linear, Degree::Cubic] {
            let table = table(degree, Extrapolation::Error, f);
            for (x, y) in POINTS.iter().flat_map(|&x| COARSE.map(|y| (x, y))) {
                near(table.value(&[x, y], &[0, 0]), f(x, y));
            }
        }
    }

    #[test]
    fn a_cubic_table_of_a_cubic_polynomial_is_the_polynomial_with_its_derivatives() {
        let f = |x: f64| {
            [
                0.5 - x + 2.0 * x * x - 0.75 * x * x * x,
                -1.0 + 4.0 * x - 2.25 * x * x,
                4.0 - 4.5 * x,
                -4.5,
            ]
        };
        let g = |y: f64| [1.0 + y * y * y, 3.0 * y * y, 6.0 * y, 6.0];
        let table = table(Degree::Cubic, Extrapolation::Clamp, |x, y| {
            f(x)[0] * g(y)[0]
        });
        for (x, y) in [
            (-2.0, 0.0),
            (-1.7, 0.3),
            (-0.1, 1.0),
            (0.0, 2.9),
            (1.9, 1.2),
            (2.5, 3.0),
        ] {
            for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
                let found = table.value(&[x, y], &[a, b]);
                let expected = f(x)[a as usize] * g(y)[b as usize];
                assert!(
                    (found - expected).abs() <= 1e-11 * expected.abs().max(10.0),
                    "{a} {b} at {x} {y}: {found}, expected {expected}"
                );
            }
        }
    }

    #[test]
    fn two_derivatives_of_a_cubic_table_are_continuous() {
        let table = table(Degree::Cubic, Extrapolation::Clamp, |x, y| {
            (2.0 * x + y).cos()
        });
        let jump = |x: f64, order: u32| {
            let at = |x: f64| table.value(&[x, 0.7], &[order, 0]);
            (at(x.next_down()) - at(x)).abs()
        };
        for x in &POINTS[1..6] {
            for order in 0..3 {
                assert!(jump(*x, order) < 1e-12, "derivative {order} at {x}");
            }
        }
        assert!(
            jump(-0.25, 3) > 1e-3 && jump(-1.5, 3) < 1e-9 && jump(2.0, 3) < 1e-9,
            "not-a-knot"
        );
    }

    #[test]
    fn linear_tables_have_slopes() {
        let table = Interpolant::new(
            Degree::Linear,
            Extrapolation::Clamp,
            &[vec![0.0, 1.0, 3.0]],
            vec![1.0, 2.0, 8.0],
        );
        for (x, value, slope) in [
            (0.0, 1.0, 1.0),
            (0.5, 1.5, 1.0),
            (1.0, 2.0, 3.0),
            (2.0, 5.0, 3.0),
            (3.0, 8.0, 3.0),
        ] {
            assert_eq!(
                (table.value(&[x], &[0]), table.value(&[x], &[1])),
                (value, slope)
            );
        }
    }

    #[test]
    fn outside_its_axes_a_table_is_held_or_no_number() {
        let f = |x: f64, y: f64| x * y;
        let held = table(Degree::Cubic, Extrapolation::Clamp, f);
        near(held.value(&[9.0, 1.0], &[0, 0]), 2.5);
        near(held.value(&[9.0, 1.0], &[0, 1]), 2.5);
        assert_eq!(held.value(&[9.0, 1.0], &[1, 0]), 0.0);
        near(held.value(&[-9.0, -9.0], &[0, 0]), 0.0);
        let strict = table(Degree::Linear, Extrapolation::Error, f);
        assert!(strict.value(&[9.0, 1.0], &[0, 0]).is_nan());
        assert!(strict.value(&[2.5, 3.1], &[1, 1]).is_nan());
        assert_eq!(strict.value(&[2.5, 3.0], &[0, 0]), 7.5);
        for table in [held, strict] {
            assert!(table.value(&[f64::NAN, 1.0], &[0, 0]).is_nan());
        }
    }

    #[test]
    fn a_table_of_three_arguments_is_a_product_of_splines() {
        let axes = [
            POINTS.to_vec(),
            COARSE.to_vec(),
            vec![1.0, 2.0, 4.0, 8.0, 9.0],
        ];
        let f = |x: f64, y: f64, z: f64| (1.0 + x * x * x) * (y - y * y) * (2.0 - z + z * z * z);
        let mut values = Vec::new();
        for (x, y) in POINTS.iter().flat_map(|&x| COARSE.map(|y| (x, y))) {
            values.extend(axes[2].iter().map(|&z| f(x, y, z)));
        }
        let table = Interpolant::new(Degree::Cubic, Extrapolation::Error, &axes, values);
        for (x, y, z) in [(-0.9, 0.2, 1.5), (0.3, 2.2, 8.5), (2.4, 1.1, 4.0)] {
            near(table.value(&[x, y, z], &[0, 0, 0]), f(x, y, z));
            let slope = (1.0 + x * x * x) * (y - y * y) * (3.0 * z * z - 1.0);
            near(table.value(&[x, y, z], &[0, 0, 1]) / slope, 1.0);
        }
    }

    #[test]
    fn a_spline_of_huge_slopes_is_not_finite() {
        let points = |step: f64| (0..4).map(|i| f64::from(i) * step).collect::<Vec<_>>();
        let table = |step: f64, other: f64, scale: f64| {
            let values = (0..16).map(|i| f64::from(i * i) * scale).collect();
            let axes = [points(other), points(step)];
            Interpolant::new(Degree::Cubic, Extrapolation::Clamp, &axes, values)
        };
        assert!(table(1.0, 1.0, 1e300).is_finite());
        assert!(!table(1e-3, 1.0, 1e300).is_finite());
        assert!(!table(1e-110, 1.0, 1.0).is_finite());
        assert!(!table(1.0, 1e-110, 1.0).is_finite());
    }
}
