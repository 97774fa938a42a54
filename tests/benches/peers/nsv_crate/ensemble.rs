//! Many runs of the closed loop in the runtime's lanes with its noise; the controller is the sampled one, with all its guards.

use std::slice;

use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::linear::Vector;
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Part, Real};

use crate::{CHANNELS, Controller, DT, Params, PlantPrepared, STATES, advance, plant, prepare_plant, rate, sample};

/// Runs from one seed; the final states of the plant are written run after run.
struct Ensemble<'a> {
    seed: u64,
    steps: u64,
    scale: f64,
    finals: &'a mut [[f64; STATES]],
}

/// One step of every lane's run.
struct Sample<'a, T: Real> {
    controller: &'a mut Controller<T>,
    truth: &'a Params<T>,
    prepared: &'a PlantPrepared<T>,
    t: f64,
    x: Vector<T, STATES>,
    dw: Vector<T, CHANNELS>,
}

impl<T: Real> Part for Sample<'_, T> {
    type Output = Vector<T, STATES>;

    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        let u_sat = sample(self.controller, self.t, &self.x);
        advance(self.x, rate(self.t, self.x, u_sat, self.truth, self.prepared), self.dw)
    }
}

impl Kernel for Ensemble<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Real>(self) {
        let truth = Params::<T>::plant();
        let prepared = prepare_plant(&truth);
        for (group, finals) in self.finals.chunks_mut(T::LANES).enumerate() {
            let noise = Noise::<T>::process(self.seed, (group * T::LANES) as u64);
            let mut controller = Controller::new(Params::<T>::design());
            let mut x = Vector::<T, STATES>::from_f64(plant::INITIAL_STATE);
            for k in 0..self.steps {
                let t = k as f64 * DT;
                let dw = noise.normals::<CHANNELS>(k) * T::from_f64(self.scale);
                x = T::outlined(Sample { controller: &mut controller, truth: &truth, prepared: &prepared, t, x, dw });
            }
            for (lane, last) in finals.iter_mut().enumerate() {
                *last = x.0.map(|entry| entry.lane(lane));
            }
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn ensemble(seed: u64, runs: usize, steps: u64, scale: f64, lanes: usize, finals: *mut [f64; STATES]) -> bool {
    let finals = unsafe { slice::from_raw_parts_mut(finals, runs) };
    let width = Width::ALL.into_iter().find(|width| width.lanes() == lanes);
    width.is_some_and(|width| lanes::run(width, Ensemble { seed, steps, scale, finals }).is_some())
}
