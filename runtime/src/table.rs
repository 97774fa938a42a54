//! Lookup tables: piecewise polynomials of degree 1 or 3 along the last axis, whose coefficients are splines of the other axes.
//!
//! On interval i of an axis only the B-splines i to i + degree are not zero, polynomials of `s = x - break_i`. The value is the sum of the
//! curves along the last axis under the products of the other axes' splines, summed along the later axes first, each sum from the left.

use crate::real::{MOST_LANES, Mask, Real};

/// One axis, for polynomials of `P` coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Axis<const P: usize> {
    /// Where the polynomials change, increasing; at least two.
    pub breaks: &'static [f64],
    /// For each interval its splines, each by powers of s from the lowest; none on the last axis.
    pub splines: &'static [[[f64; P]; P]],
}

/// A function of `D` arguments, 1 to 3.
#[derive(Clone, Copy, Debug)]
pub struct Table<const D: usize, const P: usize> {
    /// The axes.
    pub axes: [Axis<P>; D],
    /// Polynomials along the last axis by powers of s: for each spline of the first axis, there are `P - 1` more than intervals, for each of
    /// the second, and so on, one for each interval of the last axis.
    pub curves: &'static [[f64; P]],
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

    /// How many intervals it has.
    #[inline(always)]
    fn intervals(&self) -> usize {
        self.breaks.len().saturating_sub(1)
    }

    /// In each lane as many inner breaks as are not above x: the search halves what is left without a branch on the data.
    #[inline(always)]
    fn interval<T: Real>(&self, x: T) -> OfLanes<usize> {
        let mut interval = [0; MOST_LANES];
        let mut left = self.breaks.len().saturating_sub(2);
        while left > 0 {
            let half = left - left / 2;
            interval = of_lanes::<T, _>(0, |lane| {
                let middle = self.breaks.get(interval[lane] + half).copied();
                let is_above = middle.unwrap_or(f64::NAN) <= x.lane(lane);
                interval[lane] + if is_above { half } else { 0 }
            });
            left /= 2;
        }
        interval
    }

    /// Where an argument lies, on every axis of the same breaks.
    #[inline(always)]
    pub fn place<T: Real>(&self, x: T) -> Place<T> {
        let [low, high] = self.ends().map(T::from_f64);
        let (below, above) = (x.lt(low), x.gt(high));
        let interval = self.interval(x);
        let start = |lane: usize| self.breaks.get(interval[lane]).copied();
        let start = T::from_lanes(|lane| start(lane).unwrap_or(f64::NAN));
        Place {
            interval,
            s: T::select(below, low, T::select(above, high, x)) - start,
            inside: x.ge(low).and(x.le(high)),
            outside: below.or(above),
        }
    }

    /// Values there of the splines that are not zero, or of their derivatives of an order less than `P`.
    #[inline(always)]
    pub fn weights<T: Real>(&self, place: &Place<T>, order: usize) -> [T; P] {
        let none = &const { [[f64::NAN; P]; P] };
        let splines = of_lanes::<T, _>(none, |lane| {
            self.splines.get(place.interval[lane]).unwrap_or(none)
        });
        let mut weights = [T::zero(); P];
        let mut k = 0;
        while k < P {
            let powers = of_lanes::<T, _>(&none[0], |lane| &splines[lane][k]);
            weights[k] = place.value(&powers, order);
            k += 1;
        }
        weights
    }
}

impl<const D: usize, const P: usize> Table<D, P> {
    /// The derivative `orders[j]` times by argument j, each order less than `P`; any number as argument, NaN gives NaN where the value depends on it.
    #[inline(always)]
    pub fn value<T: Real>(&self, orders: [usize; D], arguments: [T; D]) -> T {
        let mut places = [self.axes[D - 1].place(arguments[D - 1]); D];
        let mut weights = [[T::zero(); P]; D];
        let mut j = 0;
        while j + 1 < D {
            places[j] = self.axes[j].place(arguments[j]);
            weights[j] = self.axes[j].weights(&places[j], orders[j]);
            j += 1;
        }
        self.at(&places, &weights, orders[j])
    }

    /// The value at places on its axes, under the weights of all axes but the last: a derivative of the `order` by the last argument, and by each
    /// other one of the order that its weights have. Tables with the same axes share places and weights.
    #[inline(always)]
    pub fn at<T: Real>(&self, places: &[Place<T>; D], weights: &[[T; P]], order: usize) -> T {
        let mut first = [0; MOST_LANES];
        let mut inside = T::Mask::splat(true);
        let mut j = 0;
        while j < D {
            let more = if j + 1 < D { P - 1 } else { 0 };
            first = places[j].after(&first, self.axes[j].intervals() + more);
            inside = inside.and(places[j].inside);
            j += 1;
        }
        let value = self.sum(&first, &places[D - 1], weights, order);
        if self.held {
            return value;
        }
        T::select(inside, value, T::from_f64(f64::NAN))
    }

    /// The sum of the curves that share an interval of the last axis, from the first one on, under the products of the weights.
    #[inline(always)]
    fn sum<T: Real>(
        &self,
        first: &OfLanes<usize>,
        place: &Place<T>,
        weights: &[[T; P]],
        order: usize,
    ) -> T {
        let none = &const { [f64::NAN; P] };
        let mut sums = [T::zero(); D];
        let mut number = 0;
        while number < P.pow(D as u32 - 1) {
            let offset = self.offset(number);
            let powers = of_lanes::<T, _>(none, |lane| {
                self.curves.get(first[lane] + offset).unwrap_or(none)
            });
            sums[D - 1] = place.value(&powers, order);
            add(&mut sums, weights, number);
            number += 1;
        }
        sums[0]
    }

    /// How far a curve is from the first one: the splines of a later axis count faster.
    #[inline(always)]
    fn offset(&self, number: usize) -> usize {
        let (mut rest, mut offset, mut stride) = (number, 0, self.axes[D - 1].intervals());
        let mut j = D - 1;
        while j > 0 {
            j -= 1;
            offset += rest % P * stride;
            stride *= self.axes[j].intervals() + P - 1;
            rest /= P;
        }
        offset
    }
}

/// Where an argument lies on an axis.
#[derive(Clone, Copy, Debug)]
pub struct Place<T: Real> {
    interval: OfLanes<usize>,
    /// From the start of the interval.
    s: T,
    /// Between the ends, so that the table is defined.
    inside: T::Mask,
    /// Beyond an end, where derivatives are 0.
    outside: T::Mask,
}

impl<T: Real> Place<T> {
    /// The interval's number among those of this axis for each of a number `before` of the axes before, this axis faster.
    #[inline(always)]
    fn after(&self, before: &OfLanes<usize>, count: usize) -> OfLanes<usize> {
        of_lanes::<T, _>(0, |lane| before[lane] * count + self.interval[lane])
    }

    /// The value there of a polynomial, or of its derivative of an order, by Horner's scheme; `powers` are those of each lane.
    #[inline(always)]
    fn value<const P: usize>(&self, powers: &OfLanes<&[f64; P]>, order: usize) -> T {
        let mut sum = T::zero();
        let mut m = P;
        while m > order {
            m -= 1;
            let (mut factor, mut k) = (1.0, m + 1 - order);
            while k <= m {
                factor *= k as f64;
                k += 1;
            }
            let power = T::from_lanes(|lane| powers[lane][m] * factor);
            sum = if m == P - 1 {
                power
            } else {
                sum * self.s + power
            };
        }
        if order == 0 {
            return sum;
        }
        T::select(self.outside, T::zero(), sum)
    }
}

/// Adds the curve of a number, which stands in the last place, to the sum over the splines of the axis before, and that sum, if it is
/// complete, to the one before it, and so on. One by one, the curves need not all be kept.
#[inline(always)]
fn add<T: Real, const D: usize, const P: usize>(
    sums: &mut [T; D],
    weights: &[[T; P]],
    number: usize,
) {
    let (mut rest, mut is_complete, mut j) = (number, true, D - 1);
    while j > 0 && is_complete {
        j -= 1;
        let spline = rest % P;
        let term = weights[j][spline] * sums[j + 1];
        sums[j] = if spline == 0 { term } else { sums[j] + term };
        is_complete = spline == P - 1;
        rest /= P;
    }
}

/// What each lane has, in the first places.
type OfLanes<R> = [R; MOST_LANES];

/// What each lane has; the places beyond are filled up.
#[inline(always)]
fn of_lanes<T: Real, R: Copy>(beyond: R, of: impl Fn(usize) -> R) -> OfLanes<R> {
    const { assert!(T::LANES <= MOST_LANES) };
    let mut all = [beyond; MOST_LANES];
    let mut lane = 0;
    while lane < T::LANES {
        all[lane] = of(lane);
        lane += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: Axis<2> = Axis {
        breaks: &[0.0, 1.0, 3.0],
        splines: &[[[1.0, -1.0], [0.0, 1.0]], [[1.0, -0.5], [0.0, 0.5]]],
    };
    const LAST: Axis<2> = Axis {
        splines: &[],
        ..LINE
    };
    const PLANE: Table<2, 2> = Table {
        axes: [LINE, LAST],
        curves: &[
            [0.0, 1.0],
            [1.0, 1.0],
            [10.0, 1.0],
            [11.0, 1.0],
            [30.0, 1.0],
            [31.0, 1.0],
        ],
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
    fn at_one_place_tables_have_the_values_that_they_have_alone() {
        let strict = Table {
            curves: &[
                [0.5, 3.0],
                [2.0, -1.0],
                [0.0, 0.25],
                [7.0, 1.5],
                [-4.0, 0.0],
                [1.0, 2.0],
            ],
            held: false,
            ..PLANE
        };
        for (x, y) in [(0.25, 2.0), (1.0, 1.0), (3.5, 0.5), (2.0, f64::NAN)] {
            let places = [LINE.place(x), LAST.place(y)];
            for (of_x, of_y) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let weights = [LINE.weights(&places[0], of_x)];
                for table in [PLANE, strict] {
                    let alone = table.value([of_x, of_y], [x, y]);
                    let together = table.at(&places, &weights, of_y);
                    assert_eq!(together.to_bits(), alone.to_bits(), "{x} {y}");
                }
            }
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
                splines: &[],
            };
            for twice in -2..2 * count as i32 + 2 {
                let x = f64::from(twice) / 2.0;
                let inner = (1..count - 1).filter(|&at| f64::from(at) <= x).count();
                assert_eq!(axis.interval(x)[0], inner, "{x} of {count}");
            }
            assert_eq!(axis.interval(f64::NAN)[0], 0);
        }
    }
}
