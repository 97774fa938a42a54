//! Values that depend on time alone, computed for as many steps at once as there are lanes.
//!
//! All lanes of a campaign are at the same time, so that its functions need not be computed in each of them. In lanes of time instead of
//! runs they cost a step what one lane costs.

use crate::real::Real;
use crate::sde::stages;

/// Values that depend on time alone. Both functions are `#[inline(always)]` in every implementation, as all that computes in lanes.
pub trait OfTime<T: Real>: Copy {
    /// The values at the time of each lane, s.
    fn at(t: T) -> Self;
    /// Those of one lane in every lane.
    fn of_lane(&self, lane: usize) -> Self;
}

/// The values at the times of [`Real::LANES`] steps, one step in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Ahead<V> {
    first: u64,
    values: V,
}

impl<V> Ahead<V> {
    /// From step 0 on; `time` gives the time of a step, s.
    #[inline(always)]
    pub fn new<T: Real>(time: impl Fn(u64) -> f64) -> Self
    where
        V: OfTime<T>,
    {
        Self::from_step(0, time)
    }

    #[inline(always)]
    fn from_step<T: Real>(first: u64, time: impl Fn(u64) -> f64) -> Self
    where
        V: OfTime<T>,
    {
        let values = V::at(T::from_lanes(|lane| time(first.wrapping_add(lane as u64))));
        Self { first, values }
    }

    /// The values at a step, in every lane.
    #[inline(always)]
    pub fn at<T: Real>(&mut self, step: u64, time: impl Fn(u64) -> f64) -> V
    where
        V: OfTime<T>,
    {
        if T::IS_SCALAR {
            return V::at(T::from_f64(time(step)));
        }
        if step.wrapping_sub(self.first) >= T::LANES as u64 {
            *self = Self::from_step(step, time);
        }
        self.values.of_lane(step.wrapping_sub(self.first) as usize)
    }
}

/// The values at the [`stages`] of as many steps.
#[derive(Clone, Copy, Debug)]
pub struct Stages<V>([Ahead<V>; 3]);

impl<V> Stages<V> {
    /// From step 0 on; `time` gives the start of a step of length `dt`, s.
    #[inline(always)]
    pub fn new<T: Real>(time: impl Fn(u64) -> f64, dt: f64) -> Self
    where
        V: OfTime<T>,
    {
        Self([
            Ahead::new(|step| stages(time(step), dt)[0]),
            Ahead::new(|step| stages(time(step), dt)[1]),
            Ahead::new(|step| stages(time(step), dt)[2]),
        ])
    }

    /// The values at the stages of a step, in every lane.
    #[inline(always)]
    pub fn at<T: Real>(&mut self, step: u64, time: impl Fn(u64) -> f64, dt: f64) -> [V; 3]
    where
        V: OfTime<T>,
    {
        let [start, middle, end] = &mut self.0;
        [
            start.at(step, |step| stages(time(step), dt)[0]),
            middle.at(step, |step| stages(time(step), dt)[1]),
            end.at(step, |step| stages(time(step), dt)[2]),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{Ahead, OfTime, Stages};
    use crate::lanes::{Kernel, Width, run};
    use crate::real::Real;
    use crate::sde::stages;
    use std::vec::Vec;

    #[derive(Clone, Copy)]
    struct Sine<T>(T);

    impl<T: Real> OfTime<T> for Sine<T> {
        #[inline(always)]
        fn at(t: T) -> Self {
            Self(t.sin())
        }

        #[inline(always)]
        fn of_lane(&self, lane: usize) -> Self {
            Self(self.0.in_every_lane(lane))
        }
    }

    /// The sines of steps in any order, one of each lane.
    struct Steps<'a>(&'a [u64]);

    impl Kernel for Steps<'_> {
        type Output = Vec<Vec<u64>>;

        #[inline(always)]
        fn run<T: Real>(self) -> Vec<Vec<u64>> {
            let time = |step: u64| 0.3 * step as f64;
            let mut ahead = Ahead::<Sine<T>>::new(time);
            let steps = self.0.iter();
            steps
                .map(|&step| {
                    let sine = ahead.at(step, time).0;
                    (0..T::LANES).map(|i| sine.lane(i).to_bits()).collect()
                })
                .collect()
        }
    }

    #[test]
    fn every_lane_has_the_value_of_the_step_in_any_order_of_steps() {
        let steps = [0, 1, 2, 7, 8, 9, 40, 3, 4, 41, u64::MAX, 0];
        for width in Width::ALL {
            let Some(found) = run(width, Steps(&steps)) else {
                continue;
            };
            for (step, lanes) in steps.into_iter().zip(found) {
                let expected = Real::sin(0.3 * step as f64).to_bits();
                assert!(lanes.iter().all(|&lane| lane == expected), "{step}");
            }
        }
    }

    /// The sines of the stages of steps, of the last lane.
    struct StagesOf<'a>(&'a [u64]);

    const DT: f64 = 0.07;

    fn start(step: u64) -> f64 {
        (step / 3) as f64 * 0.25 + (step % 3) as f64 * DT
    }

    impl Kernel for StagesOf<'_> {
        type Output = Vec<[u64; 3]>;

        #[inline(always)]
        fn run<T: Real>(self) -> Vec<[u64; 3]> {
            let mut clock = Stages::<Sine<T>>::new(start, DT);
            let steps = self.0.iter();
            steps
                .map(|&step| {
                    let at = clock.at(step, start, DT);
                    at.map(|sine| sine.0.lane(T::LANES - 1).to_bits())
                })
                .collect()
        }
    }

    #[test]
    fn stages_are_those_of_the_step_in_every_width() {
        let steps: Vec<u64> = (0..20).chain([5, 23]).collect();
        let expected = steps.iter().map(|&step| {
            let at = stages(start(step), DT);
            at.map(|t| Real::sin(t).to_bits())
        });
        let expected: Vec<_> = expected.collect();
        for width in Width::ALL {
            let found = run(width, StagesOf(&steps));
            assert!(
                found.is_none() || found.as_ref() == Some(&expected),
                "{width:?}"
            );
        }
    }
}
