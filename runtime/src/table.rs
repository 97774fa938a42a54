//! Lookup tables: tensor products of B-splines of degree 1 or 3.
//!
//! On interval i of an axis only the splines i to i + degree are not zero, polynomials of `s = x - break_i`. The value is the sum of the
//! coefficients under the products of the axes' splines, summed along the last axis first, each sum from the left.

use crate::real::{Mask, Real};

/// More lanes than any type has.
const MOST_LANES: usize = 16;
/// Most sums along the last axis: 4 x 4 for cubic splines of three arguments.
const MOST_SUMS: usize = 16;

/// One axis, for splines of `P` coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Axis<const P: usize> {
    /// Where the polynomials change, increasing; at least two.
    pub breaks: &'static [f64],
    /// For each interval its splines, each by powers of s from the lowest.
    pub weights: &'static [[[f64; P]; P]],
}

/// A function of `D` arguments, 1 to 3.
#[derive(Clone, Copy, Debug)]
pub struct Table<const D: usize, const P: usize> {
    /// The axes.
    pub axes: [Axis<P>; D],
    /// Coefficients, the last axis fastest: as many on each axis as it has intervals, and `P - 1` more.
    pub coefficients: &'static [f64],
    /// Outside an axis: whether the value is that at the nearer end, and derivatives by that axis 0; or all is NaN.
    pub held: bool,
}

impl<const P: usize> Axis<P> {
    /// The first and last break.
    #[inline(always)]
    fn ends(&self) -> [f64; 2] {
        match self.breaks {
            [low, .., high] => [*low, *high],
            _ => [f64::NAN; 2],
        }
    }

    /// How many coefficients lie along the axis.
    #[inline(always)]
    fn count(&self) -> usize {
        self.breaks.len() + P - 2
    }

    /// In each lane as many inner breaks as are not above x: the search halves what is left without a branch on the data.
    #[inline(always)]
    fn intervals<T: Real>(&self, x: T) -> OfLanes<usize> {
        let mut intervals = [0; MOST_LANES];
        let mut left = self.breaks.len().saturating_sub(2);
        while left > 0 {
            let half = left - left / 2;
            intervals = of_lanes::<T, _>(0, |lane| {
                let middle = self.breaks.get(intervals[lane] + half).copied();
                let is_above = middle.unwrap_or(f64::NAN) <= x.lane(lane);
                intervals[lane] + if is_above { half } else { 0 }
            });
            left /= 2;
        }
        intervals
    }

    /// In each lane the start of the interval.
    #[inline(always)]
    fn starts<T: Real>(&self, intervals: &OfLanes<usize>) -> T {
        let start = |lane: usize| self.breaks.get(intervals[lane]).copied();
        T::from_lanes(|lane| start(lane).unwrap_or(f64::NAN))
    }

    /// The splines that are not zero on the interval, `order` times differentiated, at s from its start.
    #[inline(always)]
    fn values<T: Real>(&self, intervals: &OfLanes<usize>, s: T, order: usize) -> [T; P] {
        let none = &const { [[f64::NAN; P]; P] };
        let splines = of_lanes::<T, _>(none, |lane| {
            self.weights.get(intervals[lane]).unwrap_or(none)
        });
        let mut values = [T::zero(); P];
        let mut spline = 0;
        while spline < P {
            let power = |m: usize| {
                let factor = factor(m, order);
                T::from_lanes(|lane| splines[lane][spline][m] * factor)
            };
            let mut sum = power(P - 1);
            let mut m = P - 1;
            while m > order {
                m -= 1;
                sum = sum * s + power(m);
            }
            values[spline] = sum;
            spline += 1;
        }
        values
    }
}

/// What differentiating `order` times makes of s^m, before s^(m - order).
#[inline(always)]
fn factor(m: usize, order: usize) -> f64 {
    let mut product = 1.0;
    let mut k = m + 1 - order;
    while k <= m {
        product *= k as f64;
        k += 1;
    }
    product
}

impl<const D: usize, const P: usize> Table<D, P> {
    /// The derivative `orders[j]` times by argument j, each order less than `P`; any number as argument, NaN gives NaN where the value depends on it.
    #[inline(always)]
    pub fn value<T: Real>(&self, orders: [usize; D], arguments: [T; D]) -> T {
        let mut first = [0; MOST_LANES];
        let mut rows = [[T::zero(); P]; D];
        let mut inside = T::Mask::splat(true);
        let mut j = 0;
        while j < D {
            let (axis, x, order) = (&self.axes[j], arguments[j], orders[j]);
            let [low, high] = axis.ends().map(T::from_f64);
            let (below, above) = (x.lt(low), x.gt(high));
            inside = inside.and(x.ge(low)).and(x.le(high));
            let intervals = axis.intervals(x);
            first = of_lanes::<T, _>(0, |lane| first[lane] * axis.count() + intervals[lane]);
            let held = T::select(below, low, T::select(above, high, x));
            rows[j] = axis.values(&intervals, held - axis.starts(&intervals), order);
            if order > 0 {
                let mut spline = 0;
                while spline < P {
                    rows[j][spline] = T::select(below.or(above), T::zero(), rows[j][spline]);
                    spline += 1;
                }
            }
            j += 1;
        }
        let value = self.sum(&first, &rows);
        if self.held {
            value
        } else {
            T::select(inside, value, T::from_f64(f64::NAN))
        }
    }

    /// The sum of the coefficients from `first` on in each lane, under the products of the rows' weights.
    #[inline(always)]
    fn sum<T: Real>(&self, first: &OfLanes<usize>, rows: &[[T; P]; D]) -> T {
        let mut sums = [T::zero(); MOST_SUMS];
        let mut left = P.pow(D as u32 - 1);
        let mut number = 0;
        while number < left {
            let (mut rest, mut offset, mut stride) = (number, 0, self.axes[D - 1].count());
            for axis in self.axes[..D - 1].iter().rev() {
                offset += rest % P * stride;
                stride *= axis.count();
                rest /= P;
            }
            let none = &const { [f64::NAN; P] };
            let coefficients = of_lanes::<T, _>(none, |lane| {
                let rest = self.coefficients.get(first[lane] + offset..);
                rest.and_then(|rest| rest.first_chunk()).unwrap_or(none)
            });
            let coefficient = |k: usize| T::from_lanes(|lane| coefficients[lane][k]);
            sums[number] = combine(&rows[D - 1], coefficient);
            number += 1;
        }
        for row in rows[..D - 1].iter().rev() {
            left /= P;
            for number in 0..left {
                sums[number] = combine(row, |k| sums[number * P + k]);
            }
        }
        sums[0]
    }
}

/// What each lane has, in the first places.
type OfLanes<R> = [R; MOST_LANES];

/// What each lane has; the places beyond are filled up.
#[inline(always)]
fn of_lanes<T: Real, R: Copy>(beyond: R, of: impl Fn(usize) -> R) -> OfLanes<R> {
    let mut all = [beyond; MOST_LANES];
    let mut lane = 0;
    while lane < T::LANES {
        all[lane] = of(lane);
        lane += 1;
    }
    all
}

/// `weights[0] terms(0) + weights[1] terms(1) + ..`, from the left.
#[inline(always)]
fn combine<T: Real, const P: usize>(weights: &[T; P], terms: impl Fn(usize) -> T) -> T {
    let mut sum = weights[0] * terms(0);
    for (k, &weight) in weights.iter().enumerate().skip(1) {
        sum = sum + weight * terms(k);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: Axis<2> = Axis {
        breaks: &[0.0, 1.0, 3.0],
        weights: &[[[1.0, -1.0], [0.0, 1.0]], [[1.0, -0.5], [0.0, 0.5]]],
    };
    const PLANE: Table<2, 2> = Table {
        axes: [LINE, LINE],
        coefficients: &[0.0, 1.0, 3.0, 10.0, 11.0, 13.0, 30.0, 31.0, 33.0],
        held: true,
    };

    #[test]
    fn a_plane_is_a_plane() {
        for (x, y) in [(0.0, 0.0), (0.5, 2.0), (1.0, 1.0), (2.5, 0.25), (3.0, 3.0)] {
            assert_eq!(PLANE.value([0, 0], [x, y]), 10.0 * x + y);
            assert_eq!(PLANE.value([1, 0], [x, y]), 10.0);
            assert_eq!(PLANE.value([0, 1], [x, y]), 1.0);
            assert_eq!(PLANE.value([1, 1], [x, y]), 0.0);
        }
    }

    #[test]
    fn outside_it_is_held_or_no_number() {
        assert_eq!(PLANE.value([0, 0], [9.0, -9.0]), 30.0);
        assert_eq!(PLANE.value([1, 0], [9.0, -9.0]), 0.0);
        let strict = Table {
            held: false,
            ..PLANE
        };
        assert!(strict.value([0, 0], [9.0_f64, 1.0]).is_nan());
        assert!(PLANE.value([0, 0], [f64::NAN, 1.0]).is_nan());
        assert_eq!(strict.value([0, 0], [3.0, 0.0]), 30.0);
        assert_eq!(PLANE.value([0, 0], [f32::INFINITY, 0.0]), 30.0);
    }

    #[test]
    fn the_search_counts_the_breaks_that_are_not_above() {
        for count in 2..40_u32 {
            let breaks: std::vec::Vec<f64> = (0..count).map(f64::from).collect();
            let axis = Axis::<2> {
                breaks: breaks.leak(),
                weights: &[],
            };
            for twice in -2..2 * count as i32 + 2 {
                let x = f64::from(twice) / 2.0;
                let inner = (1..count - 1).filter(|&at| f64::from(at) <= x).count();
                assert_eq!(axis.intervals(x)[0], inner, "{x} of {count}");
            }
            assert_eq!(axis.intervals(f64::NAN)[0], 0);
        }
    }
}
