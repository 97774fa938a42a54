//! An emitted function at many points, in numbers of each type.

use std::fmt::{self, Display, Formatter};
use std::marker::PhantomData;

use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::real::Real;

use crate::emitted::{Function, Point, Sink};
use crate::layout::Layout;

/// Numbers that an emitted function is evaluated in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// Of a width of the processor.
    Lanes(Width),
    /// In pairs without vector instructions.
    Portable,
}

impl Numbers {
    /// Scalars, which the others are compared with.
    pub const SCALAR: Numbers = Numbers::Lanes(Width::Scalar);

    /// The lanes that this processor has.
    pub fn in_lanes() -> Vec<Numbers> {
        let widths = [Width::Bits128, Width::Bits256, Width::Bits512].into_iter().filter(|width| width.is_available());
        widths.map(Numbers::Lanes).chain([Numbers::Portable]).collect()
    }

    /// Results of a function at points that stand one after another, in the same way.
    pub fn evaluate<F: Function>(self, layout: &Layout, points: &[f64], results: &mut [f64]) {
        let kernel = At { layout, points, results, function: PhantomData::<F> };
        match self {
            Numbers::Lanes(width) => lanes::run(width, kernel).expect("the processor has this width"),
            Numbers::Portable => lanes::run_portable(kernel),
        }
    }
}

/// Results of a function at points, in scalars alone: the compiler has less to do.
pub fn scalar<F: Function>(layout: &Layout, points: &[f64], results: &mut [f64]) {
    At { layout, points, results, function: PhantomData::<F> }.run::<f64>();
}

impl Display for Numbers {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Numbers::Lanes(Width::Scalar) => f.write_str("scalar"),
            Numbers::Lanes(width) => write!(f, "{} lanes", width.lanes()),
            Numbers::Portable => f.write_str("portable"),
        }
    }
}

/// A function at points.
struct At<'a, F> {
    layout: &'a Layout,
    points: &'a [f64],
    results: &'a mut [f64],
    function: PhantomData<F>,
}

impl<F: Function> Kernel for At<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<T: Real>(self) {
        let size = self.layout.size();
        let count = self.points.len() / size;
        let width = self.results.len() / count;
        let mut point = vec![T::zero(); size];
        let mut results = vec![T::zero(); width];
        for base in (0..count).step_by(T::LANES) {
            // The last lanes repeat the last point where there are not enough.
            for (k, entry) in point.iter_mut().enumerate() {
                *entry = T::from_lanes(|lane| self.points[(base + lane).min(count - 1) * size + k]);
            }
            let mut sink = Sink { entries: &mut results, written: 0 };
            F::evaluate(self.layout.split(&point), &mut sink);
            assert_eq!(sink.written, width);
            for lane in 0..T::LANES.min(count - base) {
                for (k, result) in results.iter().enumerate() {
                    self.results[(base + lane) * width + k] = result.lane(lane);
                }
            }
        }
    }
}

impl Layout {
    /// A point's inputs.
    #[inline(always)]
    fn split<'a, T: Copy>(&self, point: &'a [T]) -> Point<'a, T> {
        let part = |range: &std::ops::Range<usize>| &point[range.clone()];
        Point {
            t: point[0],
            x: part(&self.x),
            exosystems: part(&self.exosystems),
            state: part(&self.state),
            params: part(&self.params),
            plant: part(&self.plant),
            u_sat: part(&self.u_sat),
        }
    }
}
